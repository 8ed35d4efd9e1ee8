"""`heli-compare-planners`: success, speed and optimality of the planners; requires the extras `eval` and `ocp`.

Direct collocation from a straight line is the benchmark: it makes few assumptions, but its optimum is local, so that
its duration is only the best known bound. Scipy integrates (3) along every plan to check it.
"""

import importlib
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from heli_gym.baselines.evaluation import figure_style
from heli_gym.baselines.evaluation.engine import (
    Engine,
    EngineName,
    check_engine,
    in_order,
    open_engine,
    progress_bar,
    track_results,
)
from heli_gym.baselines.evaluation.planner_comparison import (
    constrained_maneuver,
    flights,
    random_maneuver,
    success_interval,
)
from heli_gym.baselines.evaluation.planner_trials import (
    LEISURE,
    available_solvers,
    fly_method,
    fly_plan,
    plan_constrained,
    plan_request,
    plan_shortest,
    plan_within,
    requests,
    scale_window,
    time_solver,
)
from heli_gym.baselines.planning.planner import FASTEST, plan, plan_fastest
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.on_rig import plant_on_rig
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, check_folder, to_csv
from heli_gym.trajectory import Maneuver

Part = Literal["robustness", "shortest", "trade-off", "methods", "reserve", "constraints", "objectives", "solvers"]

TO_SPARE = 1.1  # times collocation's shortest duration
WINDOWS = ((0.0, 12.0), (1.0, 11.0), (2.0, 10.5), (3.0, 10.0))  # V
PITCH_LIMITS_DEG = range(10, 81, 5)
RESERVES = 0.0, 0.1, 0.2, 0.3, 0.4, 0.45
MORE_TIME = 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35
CONSTRAINED_RIGS = "paper", "ntnu", "quanser"
OBJECTIVE_DURATIONS = 10.0, 12.0  # s
MOST = 10**6  # maneuvers, draws
PICTURE = "planning.png"  # of the trade-off


@dataclass
class Args:
    """Compare the planners with each other and with direct collocation."""

    parts: tuple[Part, ...] = ("robustness", "shortest", "trade-off", "methods", "reserve")
    maneuvers: int = 300  # number of random maneuvers with 10 % more time than collocation requires
    fastest: int = 20  # number of maneuvers for the comparison of shortest durations
    draws: int = 100  # number of helicopters of each plant
    rig: str = "paper"  # rig: a name, or a .toml file
    seed: int = 0
    engine: EngineName = "local"  # processes of this machine, or Ray
    address: str | None = None  # Ray cluster, HOST:PORT or auto; by default one is started on this machine
    workers: int = 1  # number of processes; several distort the computing times
    out: Path = Path("out/planners")


def constraints(args: Args, console: Console, engine: Engine) -> None:
    """Shortest durations of maneuvers with path constraints, ends in motion and lead, of three rigs."""
    rng, rows = np.random.default_rng(args.seed + 2), list[dict[str, Any]]()
    for k in track(range(args.fastest), "constraints", console=console):
        maneuver = constrained_maneuver(rng, find_rig(CONSTRAINED_RIGS[k % len(CONSTRAINED_RIGS)]))
        rows.append(plan_constrained(maneuver))
        write_csv(args.out / "constraints.csv", rows)
    ratios = np.array([row["ratio"] for row in rows])
    both = ratios[np.isfinite(ratios)]
    console.print(
        f"{len(rows)} maneuvers: {sum(math.isfinite(row['spline']) for row in rows)} planned by splines, "
        f"{sum(math.isfinite(row['collocation']) for row in rows)} by collocation; of {len(both)} by both, the splines "
        f"take {both.min() - 1.0:.1%} to {both.max() - 1.0:.1%} more time, median {np.median(both) - 1.0:.1%}"
    )


def objectives(args: Args, console: Console, engine: Engine) -> None:
    """Flights of the paper's controller along plans for each objective, on `lab` and, for its own rig, on `fleet`."""
    rows: list[dict[str, Any]] = []
    for duration in OBJECTIVE_DURATIONS:
        for objective in ("effort", "reserve", "smoothest"):
            for plant in ("lab", "fleet"):
                rig = find_rig(args.rig if plant == "lab" else plant)
                trajectory = plan(Maneuver(duration=duration, rig=rig), objective=objective)
                flown = flights(trajectory, plant, args.draws, seed=0)
                rows.append({"objective": objective, "duration (s)": duration, "plant": plant, **flown})
                write_csv(args.out / "objectives.csv", rows)
    console.print(as_table(rows))


def solvers(args: Args, console: Console, engine: Engine) -> None:
    """Least effort and the paper's (38) by other solvers: time, effort, reserve, and largest violation in between."""
    maneuver = Maneuver(duration=LEISURE, rig=find_rig(args.rig))
    rows = []
    for name, solve in available_solvers().items():
        row = time_solver(name, solve, maneuver)
        if row is None:
            console.print(f"{name}: no solution")
        else:
            rows.append(row)
    write_csv(args.out / "solvers.csv", rows)
    console.print(as_table(rows))


def robustness(args: Args, console: Console, engine: Engine) -> None:
    """Success rate and computing time of the planners on random maneuvers with time to spare."""
    rows: list[dict[str, Any]] = []
    spare = 0
    with progress_bar(console) as progress:
        bar = progress.add_task("robustness", total=args.maneuvers)
        for row in in_order(engine.results(plan_request, requests(args.seed, find_rig(args.rig)))):
            if row is None:
                continue
            rows.append(row)
            spare += row["duration / shortest known"] >= TO_SPARE
            progress.update(bar, completed=spare)
            if spare == args.maneuvers:
                break
    write_csv(args.out / "robustness.csv", rows)
    table = Table("maneuvers", "number", "planned", "95 % interval", "limits kept", "median time", "99th percentile")
    for name, low, high in (
        ("with 10 % to spare", TO_SPARE, math.inf),
        ("with less", 1.0, TO_SPARE),
        ("below the shortest known", 0.0, 1.0),
    ):
        group = [row for row in rows if low <= row["duration / shortest known"] < high]
        if group:
            planned = sum(row["planned"] for row in group)
            least, most = success_interval(planned, len(group))
            times = [row["seconds"] for row in group]
            table.add_row(
                name,
                str(len(group)),
                f"{planned / len(group):.1%}",
                f"{least:.1%} to {most:.1%}",
                f"{sum(row['limits kept'] for row in group)} of {planned}",
                f"{1e3 * np.median(times):.1f} ms",
                f"{1e3 * np.percentile(times, 99.0):.0f} ms",
            )
    console.print(table)


def shortest(args: Args, console: Console, engine: Engine) -> None:
    """Shortest durations of random maneuvers and of the paper's."""
    rng, rig = np.random.default_rng(args.seed + 1), find_rig(args.rig)
    drawn = [Maneuver(duration=20.0, rig=rig), *(random_maneuver(rng, rig) for _ in range(args.fastest))]
    rows = list(track_results(engine, plan_shortest, drawn, "shortest", console))
    write_csv(args.out / "shortest.csv", rows)
    kept = f"limits kept by {sum(row['limits kept'] for row in rows)} of {len(rows)}"
    for known, ratio in (("collocation", "ratio"), ("collocation, smooth", "ratio, smooth")):
        ratios, first = np.array([row[ratio] for row in rows[1:]]), rows[0]
        console.print(
            f"{known}: the paper's maneuver {first['spline']:.3f} s, {first[ratio] - 1.0:.1%} above {first[known]:.3f} "
            f"s; {len(ratios)} others {ratios.min() - 1.0:.1%} to {ratios.max() - 1.0:.1%} above, median "
            f"{np.median(ratios) - 1.0:.1%}, {sum(ratios <= 1.01)} within 1 %; {kept}"
        )


def trade_off(args: Args, console: Console, engine: Engine) -> None:
    """Shortest duration of the paper's rotation for each pitch limit and voltage window."""
    rig = find_rig(args.rig)
    limits = [degrees for degrees in PITCH_LIMITS_DEG if math.radians(degrees) <= rig.pitch_limit + 1e-9]
    tasks = [(rig, scale_window(rig, window), degrees) for window in WINDOWS for degrees in limits]
    rows = list(track_results(engine, plan_within, tasks, "trade-off", console))
    write_csv(args.out / "trade-off.csv", rows)
    picture = args.out / PICTURE
    figure_style.save(draw_trade_off(rows), picture)
    excess = [row["spline"] / row["collocation"] - 1.0 for row in rows]
    console.print(f"{picture}: splines are {min(excess):.1%} to {max(excess):.1%} above collocation")


@figure_style.styled
def draw_trade_off(rows: list[dict[str, Any]]) -> Any:
    """Figure of `trade_off`."""
    figure, axes = figure_style.single_panel("pitch limit (deg)", "shortest duration (s)")
    windows = dict.fromkeys((row["u_min"], row["u_max"]) for row in rows)
    for (u_min, u_max), color in zip(windows, figure_style.FLOWN):
        window = [row for row in rows if (row["u_min"], row["u_max"]) == (u_min, u_max)]
        pitch = [row["pitch limit"] for row in window]
        axes.plot(pitch, [row["spline"] for row in window], color=color, label=f"{u_min:g} to {u_max:g} V")
        axes.plot(pitch, [row["collocation"] for row in window], color=color, linestyle=":")
    axes.plot([], [], color=figure_style.NOTE, label="plan_fastest")
    axes.plot([], [], color=figure_style.NOTE, linestyle=":", label="direct collocation")
    axes.set_title("The 360° rotation from rest to rest: how fast the limits permit")
    axes.legend()
    return figure


def methods(args: Args, console: Console, engine: Engine) -> None:
    """Every method on the paper's maneuver: with ample time, and as fast as possible."""
    names = [name for name in FASTEST if name != "auto"]
    tasks = [(find_rig(args.rig), name, kind, args.draws) for name in names for kind in ("in", "fastest")]
    rows = list(track_results(engine, fly_method, tasks, "methods", console))
    write_csv(args.out / "methods.csv", rows)
    console.print(as_table(rows))


def reserve(args: Args, console: Console, engine: Engine) -> None:
    """Flights of the paper's controller on `lab` and `rigid`, along fast plans with reserves of limits or of time."""
    requested = Maneuver(duration=2.0 * LEISURE, rig=find_rig(args.rig))
    shortest = plan_fastest(requested).duration
    plans = [(f"{share:.0%} of the windows", plan_fastest(requested, reserve=share)) for share in RESERVES]
    plans += [
        (f"{share:.0%} more time", plan(replace(requested, duration=(1.0 + share) * shortest), "spline"))
        for share in MORE_TIME
    ]
    plants = ["lab", "rigid"]
    try:
        plant_on_rig("rigid", requested.rig)
    except ValueError as error:
        plants.remove("rigid")
        console.print(str(error))
    tasks = [(*named, plant, args.draws) for named in plans for plant in plants]
    rows = list(track_results(engine, fly_plan, tasks, "reserve", console))
    write_csv(args.out / "reserve.csv", rows)
    console.print(as_table(rows))


def as_table(rows: list[dict[str, Any]]) -> Table:
    """Table with the rows."""
    table = Table(*rows[0])
    for row in rows:
        table.add_row(*(f"{value:.3g}" if isinstance(value, float) else str(value) for value in row.values()))
    return table


def write_csv(path: Path, rows: Sequence[dict[str, Any]]) -> None:
    """Write rows as CSV."""
    with atomic_write(path) as file:
        file.write(to_csv(rows))


PARTS: dict[str, Callable[[Args, Console, Engine], None]] = {
    "robustness": robustness,
    "shortest": shortest,
    "trade-off": trade_off,
    "methods": methods,
    "reserve": reserve,
    "constraints": constraints,
    "objectives": objectives,
    "solvers": solvers,
}


def main(args: Args | None = None) -> None:
    """Run the command `heli-compare-planners`."""
    with command("heli-compare-planners"):
        run(args or parse(Args, "heli-compare-planners", __doc__))


def run(args: Args) -> None:
    """Run the parts of the comparison; each writes its table before the next one starts."""
    if not args.parts:
        raise ValueError("parts = (): must name at least one")
    for name in ("maneuvers", "fastest", "draws"):
        if not 1 <= getattr(args, name) <= MOST:
            raise ValueError(f"{name} = {getattr(args, name)}: must be at least 1 and at most {MOST}")
    if args.seed < 0:
        raise ValueError(f"seed = {args.seed}: must be at least 0")
    find_rig(args.rig)
    check_engine(args.engine, args.workers, args.address)
    check_folder("out", args.out)
    importlib.import_module("casadi")  # all parts require it, some only after minutes
    pictures = [args.out / PICTURE] if "trade-off" in args.parts else []
    announce_replaced("heli-compare-planners", *(args.out / f"{part}.csv" for part in args.parts), *pictures)
    console = Console()
    with open_engine(args.engine, args.workers, args.address) as engine:
        for part in args.parts:
            console.rule(part)
            PARTS[part](args, console, engine)


if __name__ == "__main__":
    main()
