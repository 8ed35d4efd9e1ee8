"""Table of the manual: policies x plants, from the flights of `heli-leaderboard`.

    python benchmarks/field.py --run out/field        # fly FIELD by heli-leaderboard; continues after a kill
    python benchmarks/field.py out/field/*            # results/leaderboard.csv, one row per policy, plant and maneuver
    python benchmarks/field.py --docs                 # from it, the tables of the manual

Folders may hold different policies and numbers of draws; rows of the same flight count once, and those of the last
folder stay. Studies in results/studies, of `heli-tune --study`, give the seconds of a search.
"""

import argparse
import csv
import json
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.baselines.evaluation.leaderboard import (
    Condition,
    Settings,
    env_settings,
    microseconds_per_step,
    pilot_for,
    standings,
)
from heli_gym.baselines.evaluation.statistics import (
    bootstrapped_means,
    interquartile_mean,
    interval,
    probability_of_improvement,
    rank_crashes_last,
)
from heli_gym.env import Heli3DOFEnv
from heli_gym.parameters import Limits
from heli_gym.storage import atomic_write, to_csv

ROOT = Path(__file__).parents[1]
TABLE, STUDIES = ROOT / "results" / "leaderboard.csv", ROOT / "results" / "studies"
PAGE, CONTROLLERS = ROOT / "docs" / "evaluation.md", ROOT / "docs" / "controllers.md"
BEGIN, END = "<!-- tables of benchmarks/field.py -->", "<!-- end of the tables -->"
STUDIES_BEGIN, STUDIES_END = "<!-- studies of benchmarks/field.py -->", "<!-- end of the studies -->"
PAPERS, KALMAN = "feedforward+tvlqr", "kalman-lqr"
MANEUVER = "travel-360"
RANKED = 100  # least number of draws for a rank, where any policy has more
SETTINGS = Settings(0, 1, 1, 0.02, 0.0)
ANGLES = ("rms_travel_deg", "rms_elevation_deg", "rms_error_deg")


class Part(NamedTuple):
    """Flights of the table that one call of `heli-leaderboard` flies into one folder."""

    draws: int
    plants: tuple[str, ...]
    policies: tuple[str, ...]
    references: tuple[str, ...] = (MANEUVER,)


DESIGNED = (
    "open-loop",
    *(
        f"{name}@PLANT"
        for name in (PAPERS, "lqi", "lag-lqr", "lag-lqi", KALMAN, "l1-adaptive", "gain-scheduled", "flatness")
    ),
    "pd-cascade@PLANT",
    "hover-lqr",
)
UNTUNED = tuple(name.removesuffix("@PLANT") for name in DESIGNED)
LAB, RIGID, FLEET, NOMINAL = ((plant, f"{plant}+outside") for plant in ("lab", "rigid", "fleet", "nominal"))
FIELD = {
    "learned-lab": Part(1000, LAB, ("residual", "residual-any")),
    "learned-rigid": Part(1000, RIGID, ("residual-rigid",)),
    "learned-fleet": Part(300, FLEET, ("residual",)),
    "lab": Part(1000, ("lab",), (*DESIGNED, "adaptive-mpc")),
    "rigid": Part(1000, ("rigid",), (*DESIGNED, "adaptive-mpc")),
    "fleet": Part(300, FLEET, UNTUNED),
    "predictive-fleet": Part(100, FLEET, ("adaptive-mpc",)),
    "lab+outside": Part(1000, ("lab+outside",), DESIGNED),
    "rigid+outside": Part(1000, ("rigid+outside",), DESIGNED),
    "predictive-outside": Part(600, (LAB[1], RIGID[1]), ("adaptive-mpc",)),
    "nominal": Part(20, NOMINAL, (*UNTUNED, "adaptive-mpc", "nmpc", "adaptive-lqr")),
    "predictive": Part(200, (*LAB, *RIGID), ("nmpc", "adaptive-lqr")),
    "tuned-nmpc": Part(100, (*LAB, *RIGID), ("nmpc@PLANT",)),
    "safe": Part(200, ("lab", "rigid"), ("feedforward+tvlqr@PLANT+safe", "kalman-lqr@PLANT+safe")),
    "linear": Part(10, ("lab", "rigid"), ("linear-mpc", "linear-mpc@PLANT")),
    "maneuvers": Part(
        100,
        ("lab",),
        ("adaptive-mpc", *(f"{name}@PLANT" for name in (PAPERS, KALMAN, "gain-scheduled", "l1-adaptive"))),
        ("back-60-descend", "return-180", "travel-180", "travel-90-climb"),
    ),
}


def fly_field(out: Path, parts: Iterable[str], workers: int) -> None:
    """Fly parts of FIELD, or what is missing of them, into folders in out; each keeps the commits it was flown from."""
    commit = commit_of_packages()
    for name in parts:
        part, folder = FIELD[name], out / name
        folder.mkdir(parents=True, exist_ok=True)
        earlier, rows = commits_of(folder), stored_rows(folder)
        write_commits(folder, earlier | {commit})  # before the flights: a kill leaves none without its commit
        order = f"-m heli_gym.baselines.commands.leaderboard --resume --no-outside --no-pages --episodes {part.draws}"
        try:
            subprocess.run(
                (
                    *(sys.executable, *order.split(), "--workers", str(workers), "--out", str(folder)),
                    *("--plants", *part.plants, "--policies", *part.policies, "--references", *part.references),
                ),
                check=True,
            )
        finally:
            if stored_rows(folder) == rows:
                write_commits(folder, earlier)


def commit_of_packages() -> str:
    """Last commit that touched the packages; with "-dirty" if their files differ from it."""
    packages = ("--", "heli_gym", "baselines")
    last = subprocess.run(
        ["git", "log", "-1", "--abbrev=7", "--format=%h", *packages],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    changed = subprocess.run(["git", "diff", "--quiet", "HEAD", *packages], cwd=ROOT, check=False).returncode
    return last.stdout.strip() + ("-dirty" if changed else "")


def commits_of(folder: Path) -> set[str]:
    """Commits that a folder was flown from."""
    path = folder / "commits"
    return set(path.read_text().split()) if path.is_file() else set()


def write_commits(folder: Path, commits: Iterable[str]) -> None:
    """Write the commits that a folder was flown from."""
    with atomic_write(folder / "commits") as file:
        file.write("\n".join(sorted(commits)).encode())


def stored_rows(folder: Path) -> int:
    """Number of flights in a folder."""
    return sum(path.read_bytes().count(b"\n") for path in (folder / "flights").glob("*.jsonl"))


def flights(folders: Iterable[Path]) -> dict[tuple[str, str, str], dict[int, dict[str, Any]]]:
    """Rows of all flights in the folders, by (reference, plant, policy) and seed."""
    found: dict[tuple[str, str, str], dict[int, dict[str, Any]]] = {}
    for folder in folders:
        for path in sorted((folder / "flights").glob("*.jsonl")):
            for line in path.read_text(encoding="utf-8").splitlines():
                row = json.loads(line)
                row["commits"] = commits_of(folder)
                found.setdefault((row["reference"], row["plant"], row["policy"]), {})[row["seed"]] = row
    return found


def ranks_of(found: dict[tuple[str, str, str], dict[int, dict[str, Any]]]) -> dict[tuple[str, str, str], str]:
    """Rank of each policy of a plant and maneuver, with its interval, on the draws common to all that have RANKED."""
    ranked = {}
    for condition in dict.fromkeys(key[:2] for key in found):
        own = {key: rows for key, rows in found.items() if key[:2] == condition}
        most = max(map(len, own.values()))
        entries = standings(
            [row for rows in own.values() if len(rows) >= min(RANKED, most) for row in rows.values()], ""
        )
        for entry in entries:
            low, high = entry["rank"]["interval"]
            ranked[*condition, entry["policy"]] = f"{entry['rank']['value']:g} [{low:.0f}, {high:.0f}]"
    return ranked


def aggregate(found: dict[tuple[str, str, str], dict[int, dict[str, Any]]]) -> list[dict[str, Any]]:
    """One row per policy, plant and maneuver."""
    limit = np.degrees(Limits().pitch_max)
    table = []
    ranked = ranks_of(found)
    for (reference, plant, policy), flown in sorted(found.items()):
        others = {
            kind: next(
                (
                    rows
                    for (*c, p), rows in found.items()
                    if (*c, p.split("+safe")[0].split("@")[0]) == (reference, plant, kind) and "+safe" not in p
                ),
                {},
            )
            for kind in (PAPERS, KALMAN)
        }
        crashed = np.array([row["crashed"] for row in flown.values()])

        def column(name: str, flown: dict[int, dict[str, Any]] = flown) -> np.ndarray:
            return np.array([row[name] for row in flown.values()], float)

        row: dict[str, Any] = {"reference": reference, "plant": plant, "policy": policy, "draws": len(flown)}
        row["rank"] = ranked.get((reference, plant, policy), "")
        for name in ANGLES:
            values = rank_crashes_last(column(name), crashed)
            row[name] = interquartile_mean(values)
            row[f"{name}_low"], row[f"{name}_high"] = interval(bootstrapped_means(values[None]))
        row["cost"] = interquartile_mean(rank_crashes_last(column("cost"), crashed))
        row["crashes"] = int(crashed.sum())
        row["success"] = column("success").mean()
        row["within_pitch"] = (column("peak_pitch_deg") <= limit).mean()  # (6), with the numbers of (9)
        row["within_limits"] = column("within_limits").mean()  # (6) and (7)
        row["peak_pitch_deg"] = interquartile_mean(column("peak_pitch_deg"))
        row["worst_pitch_deg"] = column("peak_pitch_deg")[~crashed].max() if not crashed.all() else float("nan")
        row["saturated"] = interquartile_mean(column("saturated"))
        row["better_than_papers"] = improvement_over(flown, others[PAPERS])
        row["better_than_kalman"] = improvement_over(flown, others[KALMAN])
        timed = (reference, plant) == (MANEUVER, "lab")
        row["microseconds"] = microseconds_per_step(policy, Condition(plant, reference), SETTINGS) if timed else ""
        row["commits"] = " ".join(sorted(set().union(*(row["commits"] for row in flown.values()))))
        table.append(row)
    return table


def improvement_over(flown: dict[int, dict[str, Any]], others: dict[int, dict[str, Any]]) -> float:
    """Probability of a smaller error than the others' on the draws that both flew; nan if there is none."""
    common = sorted(set(flown) & set(others))
    if not common:
        return float("nan")
    return probability_of_improvement(
        *(np.array([[rows[s]["rms_error_deg"] for s in common]]) for rows in (flown, others)),
        *(np.array([[rows[s]["crashed"] for s in common]]) for rows in (flown, others)),
    )


def print_step_times(policy: str, flights: int = 10) -> None:
    """Print median, 99th percentile and worst processor time of a policy's control step, first flights not counted."""
    env = Heli3DOFEnv(**env_settings(Condition("lab", MANEUVER), SETTINGS))
    pilot = pilot_for(policy, Condition("lab", MANEUVER), SETTINGS.control_period, SETTINGS.rig)
    steps, firsts = [], []
    for flight in range(-1, flights):
        _, info = env.reset(seed=1 + flight)
        pilot.reset(np.random.default_rng(0))
        over, own = False, []
        while not over:
            began = time.process_time()
            u = pilot(info["time"], info["measurement"])
            own.append(1e3 * (time.process_time() - began))
            _, _, terminated, truncated, info = env.step(env.to_action(u))
            over = terminated or truncated
        if flight >= 0:
            firsts.append(own[0])
            steps += own[1:]
    median, high = np.quantile(steps, [0.5, 0.99])
    print(f"{policy}: {len(steps)} steps of {flights} flights, processor time: median {median:.2f}, 99 % {high:.2f},")
    print(
        f"worst {max(steps):.2f} ms; first of a flight: median {np.median(firsts):.2f} ms, worst {max(firsts):.2f} ms"
    )


def update_table(rows: Sequence[dict[str, Any]]) -> None:
    """Put rows into the table, in place of all rows of their maneuvers and plants."""
    flown = {(row["reference"], row["plant"]) for row in rows}
    others = [row for row in read_table() if (row["reference"], row["plant"]) not in flown] if TABLE.is_file() else []
    write_csv(TABLE, sorted([*others, *rows], key=lambda row: (row["reference"], row["plant"], row["policy"])))


def read_table() -> list[dict[str, str]]:
    """Rows of the table."""
    with open(TABLE, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write_csv(path: Path, rows: Sequence[dict[str, Any]]) -> None:
    """Write rows as CSV with four digits."""
    with atomic_write(path) as file:
        file.write(to_csv([{k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows]))


def tables(rows: Sequence[dict[str, str]]) -> str:
    """Markdown of all tables."""
    parts = []
    conditions = list(dict.fromkeys((row["reference"], row["plant"]) for row in rows))
    order = ("nominal", "nominal+outside", "lab", "lab+outside", "rigid", "rigid+outside", "fleet", "fleet+outside")
    main = sorted((c for c in conditions if c[0] == MANEUVER), key=lambda c: order.index(c[1]))
    for condition in main:
        own = [row for row in rows if (row["reference"], row["plant"]) == condition]
        parts += [
            "",
            f"### `{condition[1]}`",
            "",
            *main_table(sorted(own, key=lambda row: float(row["rms_error_deg"]))),
        ]
    others = [row for row in rows if row["reference"] != MANEUVER]
    if others:
        parts += ["", "### Other maneuvers", "", *maneuver_table(others)]
    return "\n".join(parts).strip() + "\n"


def main_table(rows: Sequence[dict[str, str]]) -> list[str]:
    """Lines of the table of one plant, sorted by rows."""
    lines = [
        "| policy | draws | rank | travel (deg) | elevation (deg) | cost (s) | crashes | success | within (6) "
        "| within (6), (7) | largest pitch (deg) | saturated | better than the paper's | than `kalman-lqr` |",
        "|---|" + "---|" * 13,
    ]
    for row in rows:
        travel, elevation = (
            f"{float(row[name]):.2f} [{float(row[name + '_low']):.2f}, {float(row[name + '_high']):.2f}]"
            for name in ANGLES[:2]
        )
        shares = [f"{100 * float(row[name]):.0f} %" for name in ("success", "within_pitch", "within_limits")]
        better = [
            f"{100 * float(row[name]):.0f} %" if row["policy"].split("@")[0] != kind and row[name] != "nan" else ""
            for name, kind in (("better_than_papers", PAPERS), ("better_than_kalman", KALMAN))
        ]
        cells = (
            f"`{row['policy']}`",
            row["draws"],
            row["rank"],
            travel,
            elevation,
            f"{float(row['cost']):.2f}",
            row["crashes"],
            *shares,
            f"{float(row['peak_pitch_deg']):.0f}, worst {float(row['worst_pitch_deg']):.0f}",
            f"{100 * float(row['saturated']):.0f} %",
            *better,
        )
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def maneuver_table(rows: Sequence[dict[str, str]]) -> list[str]:
    """Lines of the table of travel and elevation errors on other maneuvers."""
    names = list(dict.fromkeys((row["reference"], row["plant"]) for row in rows))
    lines = [
        f"| policy | {' | '.join(f'{reference} on `{plant}`' for reference, plant in names)} |",
        "|---|" + "---|" * len(names),
    ]
    kinds = list(dict.fromkeys(row["policy"].partition("@")[0] for row in rows))
    for kind in kinds:
        cells = []
        for name in names:
            own = [r for r in rows if (r["reference"], r["plant"]) == name and r["policy"].partition("@")[0] == kind]
            crashes = f", {own[0]['crashes']} crashes" if own and own[0]["crashes"] != "0" else ""
            cells.append(
                f"{float(own[0]['rms_travel_deg']):.2f} / {float(own[0]['rms_elevation_deg']):.2f}{crashes}"
                if own
                else ""
            )
        lines.append(f"| `{kind}` | {' | '.join(cells)} |")
    return lines


def costs_table(rows: Sequence[dict[str, str]]) -> list[str]:
    """Lines of the table of what a policy takes: time per step, knowledge, tuning."""
    own = {
        row["policy"]: row
        for row in rows
        if (row["reference"], row["plant"]) == (MANEUVER, "lab") and row["microseconds"]
    }
    lines = ["| policy | µs per step | must know | weights for `lab` |", "|---|---|---|---|"]
    for policy, row in sorted(own.items(), key=lambda item: float(item[1]["microseconds"])):
        path = STUDIES / f"{policy}.json"
        tuned = "differential evolution, by `heli-tune`" if "@" in policy else "default weights"
        tuned = "training" if policy.startswith("residual") else tuned
        if path.is_file():
            study = json.loads(path.read_text(encoding="utf-8"))
            tuned = f"{len(study['candidates'])} candidates of TPE on {study['draws']} draws, {study['seconds']:.0f} s"
        lines.append(f"| `{policy}` | {float(row['microseconds']):.0f} | {label_of(policy).needs} | {tuned} |")
    return lines


def studies_table() -> list[str]:
    """Lines of the table of studies."""
    lines = [
        "| policy | candidates x draws | seconds | return on the draws tuned on: default, tuned | on others |",
        "|---|---|---|---|---|",
    ]
    for path in sorted(STUDIES.glob("*.json")):
        study = json.loads(path.read_text(encoding="utf-8"))
        scores = study["return_tuned_on_and_on_others"]
        own, others = (f"{scores['in use'][k]:.2f}, {scores['tuned'][k]:.2f}" for k in (0, 1))
        counts = f"{len(study['candidates'])} x {study['draws']}"
        lines.append(f"| `{path.stem}` | {counts} | {study['seconds']:.0f} | {own} | {others} |")
    return lines


def write_docs() -> None:
    """Put the tables into the pages."""
    rows = read_table()
    replace_between(PAGE, BEGIN, END, f"{tables(rows)}\n### What each takes\n\n" + "\n".join(costs_table(rows)))
    replace_between(CONTROLLERS, STUDIES_BEGIN, STUDIES_END, "\n".join(studies_table()))


def replace_between(path: Path, begin: str, end: str, text: str) -> None:
    """Replace the text between two marks of a page."""
    before, _, rest = path.read_text(encoding="utf-8").partition(begin)
    _, _, after = rest.partition(end)
    with atomic_write(path) as file:
        file.write(f"{before}{begin}\n\n{text}\n\n{end}{after}".encode())


def main() -> None:
    """Aggregate folders, or write the manual's tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--run", type=Path, metavar="OUT", help="fly what is missing of the field into folders in OUT")
    parser.add_argument("--parts", nargs="+", choices=FIELD, default=list(FIELD), help="parts of the field to fly")
    parser.add_argument("--workers", type=int, default=2, help="number of processes that fly")
    parser.add_argument("--docs", action="store_true", help="write the tables of docs/evaluation.md")
    parser.add_argument("--step", metavar="POLICY", help="print the times of a control step")
    args = parser.parse_args()
    if args.step:
        print_step_times(args.step)
    if args.run:
        fly_field(args.run, args.parts, args.workers)
    if args.folders:
        update_table(aggregate(flights(args.folders)))
    if args.docs:
        write_docs()


if __name__ == "__main__":
    main()
