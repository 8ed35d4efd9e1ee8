"""Table of the manual: policies x plants, from the flights of `heli-leaderboard`.

    heli-leaderboard --out out/lab --plants lab --policies adaptive-mpc feedforward+tvlqr@PLANT ...
    python benchmarks/field.py out/*                  # results/leaderboard.csv, one row per policy, plant and maneuver
    python benchmarks/field.py --docs                 # from it, the tables of the manual

Folders may hold different policies and numbers of draws; rows of the same flight count once. Studies in
results/studies, of `heli-tune --study`, give the seconds of a search.
"""

import argparse
import csv
import io
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.baselines.evaluation.leaderboard import Condition, Settings, microseconds_per_step
from heli_gym.baselines.evaluation.statistics import (
    bootstrapped_means,
    interquartile_mean,
    interval,
    probability_of_improvement,
    rank_crashes_last,
)
from heli_gym.parameters import Limits
from heli_gym.storage import atomic_write

ROOT = Path(__file__).parents[1]
TABLE, STUDIES = ROOT / "results" / "leaderboard.csv", ROOT / "results" / "studies"
PAGE, CONTROLLERS = ROOT / "docs" / "evaluation.md", ROOT / "docs" / "controllers.md"
BEGIN, END = "<!-- tables of benchmarks/field.py -->", "<!-- end of the tables -->"
STUDIES_BEGIN, STUDIES_END = "<!-- studies of benchmarks/field.py -->", "<!-- end of the studies -->"
PAPERS = "feedforward+tvlqr"
MANEUVER = "travel-360"
ANGLES = ("rms_travel_deg", "rms_elevation_deg", "rms_error_deg")


def flights(folders: Iterable[Path]) -> dict[tuple[str, str, str], dict[int, dict[str, Any]]]:
    """Rows of all flights in the folders, by (reference, plant, policy) and seed."""
    found: dict[tuple[str, str, str], dict[int, dict[str, Any]]] = {}
    for folder in folders:
        for path in sorted((folder / "flights").glob("*.jsonl")):
            for line in path.read_text(encoding="utf-8").splitlines():
                row = json.loads(line)
                found.setdefault((row["reference"], row["plant"], row["policy"]), {})[row["seed"]] = row
    return found


def aggregate(found: dict[tuple[str, str, str], dict[int, dict[str, Any]]]) -> list[dict[str, Any]]:
    """One row per policy, plant and maneuver."""
    limit = np.degrees(Limits().pitch_max)
    table = []
    for (reference, plant, policy), flown in sorted(found.items()):
        papers = [
            rows
            for (r, p, name), rows in found.items()
            if (r, p) == (reference, plant) and name.split("@")[0] == PAPERS
        ]
        common = sorted(set(flown) & set(papers[0])) if papers else []
        crashed = np.array([row["crashed"] for row in flown.values()])

        def column(name: str, flown: dict[int, dict[str, Any]] = flown) -> np.ndarray:
            return np.array([row[name] for row in flown.values()], float)

        row: dict[str, Any] = {"reference": reference, "plant": plant, "policy": policy, "draws": len(flown)}
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
        row["better_than_papers"] = (
            probability_of_improvement(
                *(np.array([[rows[s]["rms_error_deg"] for s in common]]) for rows in (flown, papers[0])),
                *(np.array([[rows[s]["crashed"] for s in common]]) for rows in (flown, papers[0])),
            )
            if common
            else float("nan")
        )
        settings = Settings(0, 1, 1, 0.02, 0.0)
        row["microseconds"] = microseconds_per_step(policy, Condition(plant, reference), settings)
        table.append(row)
    return table


def write_csv(path: Path, rows: Sequence[dict[str, Any]]) -> None:
    """Write rows as CSV with four digits."""
    text = io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows)
    with atomic_write(path) as file:
        file.write(text.getvalue().encode())


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
        "| policy | draws | travel (deg) | elevation (deg) | cost (s) | crashes | success | within (6) "
        "| within (6), (7) | largest pitch (deg) | saturated | better than the paper's |",
        "|---|" + "---|" * 11,
    ]
    for row in rows:
        travel, elevation = (
            f"{float(row[name]):.2f} [{float(row[name + '_low']):.2f}, {float(row[name + '_high']):.2f}]"
            for name in ANGLES[:2]
        )
        shares = [f"{100 * float(row[name]):.0f} %" for name in ("success", "within_pitch", "within_limits")]
        compared = row["policy"].split("@")[0] != PAPERS and row["better_than_papers"] != "nan"
        better = f"{100 * float(row['better_than_papers']):.0f} %" if compared else ""
        cells = (
            f"`{row['policy']}`",
            row["draws"],
            travel,
            elevation,
            f"{float(row['cost']):.2f}",
            row["crashes"],
            *shares,
            f"{float(row['peak_pitch_deg']):.0f}, worst {float(row['worst_pitch_deg']):.0f}",
            f"{100 * float(row['saturated']):.0f} %",
            better,
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
        tuned = "600 candidates of differential evolution" if "@" in policy else "default weights"
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
    with open(TABLE, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
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
    parser.add_argument("--docs", action="store_true", help="write the tables of docs/evaluation.md")
    args = parser.parse_args()
    if args.folders:
        write_csv(TABLE, aggregate(flights(args.folders)))
    if args.docs:
        write_docs()


if __name__ == "__main__":
    main()
