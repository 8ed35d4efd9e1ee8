"""`heli-evaluate`: fly policies, print one table, write results.json and the paper's figures."""

import json
import sys
import time
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from heli_gym.baselines.control.policies import is_learned, make_policy
from heli_gym.baselines.evaluation import figure_style, figures
from heli_gym.baselines.evaluation.agents import make_pilot
from heli_gym.baselines.evaluation.conditions import describe_draw, find_condition, nominal_rig
from heli_gym.baselines.evaluation.metrics import Metrics, flight_metrics
from heli_gym.baselines.evaluation.paper_figures import paper_figures, paper_numbers
from heli_gym.baselines.evaluation.report import Shown, check_page, write_report
from heli_gym.baselines.evaluation.rollout import fly, fly_many
from heli_gym.baselines.evaluation.scoring import flies_together
from heli_gym.baselines.evaluation.statistics import with_interval
from heli_gym.baselines.planning.planner import plan, plan_unconstrained
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.rig import PAPER, find_rig, same_dynamics
from heli_gym.storage import atomic_write, check_folder
from heli_gym.task import TOLERANCE
from heli_gym.trajectory import Maneuver, Trajectory
from heli_gym.vector_env import MOST_ENVS, Heli3DOFVectorEnv

RESULTS = "results.json"
PAPERS_REFERENCE = "travel-360"
PAPER_PERIOD = 1e-3  # s, the sampling time of Section IV
FIGURE_START_DEG = (-5.0, 5.0)  # start of Figs. 10 and 11: travel and elevation relative to the reference
FLIGHTS_ON_A_PAGE = 60
# By default one policy of each kind; the leaderboard flies all.
COMPARED = ("open-loop", "feedforward+tvlqr", "lqi", "kalman-lqr", "adaptive-mpc", "hover-lqr")
COLUMNS = (
    "start",
    "policy",
    "RMS travel\n(deg)",
    "RMS elevation\n(deg)",
    "RMS pitch\n(deg)",
    "at the end\n(deg)",
    "peak pitch\n(deg)",
    "saturated\n(%)",
    "cost\n(s)",
    "return\n(s)",
    "flown\n(s)",
    "success\n(%)",
    "wall time\n(s)",
)
TOLERANCES = " / ".join(f"{degrees:.3g}" for degrees in np.degrees(TOLERANCE))
CAPTION = (
    "means; ± half the 95 % bootstrap interval; RMS errors to the end of the maneuver, of a crashed flight at its last "
    "error; at the end: the largest of the three; "
    "saturated: time with a voltage at a limit of the amplifier; cost: excess over the planned limits, in their widths "
    "times s; return: seconds flown on the reference; success: flown to the end of the maneuver, every error within "
    f"its tolerance there ({TOLERANCES} degrees and degrees/s, in the order of the state: "
    "travel, elevation and pitch, each with its rate)"
)


@dataclass
class Args:
    """Fly policies along a reference: once from its start at the paper's sampling time of 1 ms (unless the plant is
    random), and in many episodes from perturbed starts. Every policy flies the same episodes."""

    policies: tuple[str, ...] = COMPARED
    """policies: names, files (.json, .zip of Stable-Baselines3, .onnx), module:function"""
    reference: str = "travel-360"  # a packaged reference, or an .npz file of heli-plan
    rig: str | None = None  # nominal rig of controllers and plants, a name or a .toml file; by default the plant's
    force: bool = False  # fly a plan even if it is for another rig
    plant: str = "nominal"  # plant to fly: nominal, lab, rigid, NAME+outside; each episode draws its ranges anew
    episodes: int = 10  # number of episodes from perturbed starts
    seed: int = HELD_OUT_SEED  # seed of the first episode, then counting up; tuning and training stay below the default
    control_period: float = 0.02  # s, in the episodes
    start_spread_deg: float = 5.0  # greatest deviation of each angle at the start
    out: Path = Path("out")  # folder for results.json and the figures
    figures: bool = True  # draw the paper's figures
    format: Literal["png", "pdf", "svg"] = "png"  # format of the figures
    columns: Literal[0, 1, 2] = 0  # width of the figures in columns of a journal; 0 for the screen
    report: Path | None = None  # .html page to write: table, interactive plots and a 3D replay of the flights

    @property
    def flown_rig(self) -> str:
        """Name or file of the rig."""
        return nominal_rig(self.plant, self.rig)


class Flight(NamedTuple):
    """Flight with its metrics."""

    policy: str
    start: str
    control_period: float
    seed: int
    wall_time: float  # s, share of the time of the flights flown together
    metrics: Metrics
    trajectory: Trajectory


def evaluate(args: Args, console: Console, flights: list[Flight] | None = None) -> list[Flight]:
    """Fly every policy, first from the exact start, then in the episodes; append each flight to `flights`."""
    flights = [] if flights is None else flights
    check_folder("out", args.out)
    if args.report is not None:
        check_page("report", args.report)
    if not args.policies or len(set(args.policies)) < len(args.policies):
        raise ValueError(f"policies = {args.policies}: must name at least one, and none twice")
    if not 1 <= args.episodes <= MOST_ENVS:
        raise ValueError(f"episodes = {args.episodes}: must be at least 1 and at most {MOST_ENVS}")
    if args.seed < 0:
        raise ValueError(f"seed = {args.seed}: must be at least 0")
    rig = find_rig(args.flown_rig)
    exact = Heli3DOFEnv(
        find_condition(args.plant), reference_for(args.reference, rig, args.force), PAPER_PERIOD, rig=rig
    )
    reference = exact.reference
    off: dict[str, Any] = {"rig": rig, "control_period": args.control_period, "start_spread_deg": args.start_spread_deg}
    single = Heli3DOFEnv(exact.plant, reference, **off)
    perturbed = Heli3DOFVectorEnv(args.episodes, exact.plant, reference, **off)
    # Make all policies and environments first, so that errors appear before the first flight.
    policies = {name: make_pilot(name, reference, args.control_period) for name in args.policies}
    # a learned policy requires the control period of its training
    jobs = (
        []
        if exact.plant.is_random
        else [("exact", name) for name in args.policies if not is_learned(name) and not hasattr(policies[name], "act")]
    )
    jobs += [("perturbed", name) for name in args.policies]
    announce_replaced("heli-evaluate", args.out / RESULTS, *([args.report] if args.report else []))
    for start, name in track(jobs, "flying", console=console):
        env = exact if start == "exact" else perturbed
        policy = make_pilot(name, reference, PAPER_PERIOD) if env is exact else policies[name]
        began = time.perf_counter()
        if env is exact:
            group = [fly(exact, policy, seed=args.seed)]
        elif flies_together(policy, reference):
            group = fly_many(perturbed, policy, args.seed)
        else:
            group = [fly(single, policy, seed=args.seed + k) for k in range(args.episodes)]
        wall_time = (time.perf_counter() - began) / len(group)
        for k, flight in enumerate(group):
            metrics = flight_metrics(flight, reference, env.voltage_limits, env.pitch_limit)
            flights.append(Flight(name, start, env.control_period, args.seed + k, wall_time, metrics, flight))
    return flights


def flight_row(flight: Flight) -> dict[str, Any]:
    """Entry of a flight in results.json, without its trajectory."""
    row = {**flight._asdict(), "metrics": flight.metrics._asdict()}
    del row["trajectory"]
    return row


def summarise(flights: Sequence[Flight]) -> list[dict[str, Any]]:
    """Entries per start and policy: mean of every metric with its bootstrap confidence interval."""
    groups = dict.fromkeys((flight.start, flight.policy) for flight in flights)
    rows = []
    for start, policy in groups:
        group = [flight for flight in flights if (flight.start, flight.policy) == (start, policy)]
        row: dict[str, Any] = {"start": start, "policy": policy, "episodes": len(group)}
        for name in (*Metrics._fields, "wall_time"):
            values = [flight.wall_time if name == "wall_time" else getattr(flight.metrics, name) for flight in group]
            row[name] = with_interval(np.array(values, dtype=float))
        rows.append(row)
    return rows


def subject(args: Args) -> str:
    """Text that names plant and rig."""
    rig = "" if args.flown_rig == PAPER.name else f" of the rig {find_rig(args.flown_rig).name}"
    return f"{Path(args.reference).name} on the plant {args.plant}{rig}"


def table_title(args: Args, rows: Iterable[dict[str, Any]]) -> str:
    """Title of the table with given rows."""
    off, period = f"{args.start_spread_deg:g}°", f"{args.control_period * 1e3:g} ms"
    starts = {
        "exact": f"exact start at {PAPER_PERIOD * 1e3:g} ms",
        "perturbed": f"perturbed: {args.episodes} starts up to {off} off at {period}",
    }
    shown = dict.fromkeys(row["start"] for row in rows)
    return f"{subject(args)}: {'; '.join(starts[start] for start in shown)}"


def table_cells(row: dict[str, Any]) -> list[str]:
    """Cells of a row under COLUMNS: means, and for RMS errors half the width of the interval."""
    mean = {name: value["mean"] for name, value in row.items() if isinstance(value, dict)}
    interval = row["rms_error_deg"]["interval"]
    rms = [f"{value:.4f}" if interval is None else f"{value:.2f}" for value in mean["rms_error_deg"]]
    if interval is not None:
        rms = [f"{value} ± {(high - low) / 2:.2f}" for value, low, high in zip(rms, *interval)]
    return [
        row["start"],
        row["policy"],
        *rms,
        f"{max(mean['terminal_error_deg']):.3f}",
        f"{mean['peak_pitch_deg']:.1f}",
        f"{100 * mean['saturated']:.1f}",
        f"{mean['cost']:.4f}",
        f"{mean['episode_return']:.2f}",
        f"{mean['flown']:.2f}",
        f"{100 * mean['success']:.0f}",
        f"{mean['wall_time']:.2f}",
    ]


def results_table(rows: Sequence[dict[str, Any]], args: Args) -> Table:
    """Table of the summary, as printed."""
    table = Table(title=table_title(args, rows), caption=CAPTION)
    for name in COLUMNS:
        table.add_column(name, justify="left" if name in ("start", "policy") else "right")
    previous = None
    for row in rows:
        if previous not in (None, row["start"]):
            table.add_section()
        previous = row["start"]
        table.add_row(*table_cells(row))
    return table


def report_flights(args: Args, flights: Sequence[Flight]) -> list[Shown]:
    """Flights of the report: the hardest draw, the median draw, more draws, and the exact start."""
    perturbed = [flight for flight in flights if flight.start == "perturbed"]
    seeds = hardest_first(perturbed)
    names = dict.fromkeys(seeds[:: max(len(seeds) // 2, 1)][:2], "")
    order = [*names, *(seed for seed in sorted(seeds) if seed not in names)]
    reference = reference_for(args.reference, args.flown_rig, args.force)
    envs = Heli3DOFVectorEnv(
        len(seeds), find_condition(args.plant), reference, control_period=args.control_period, rig=args.flown_rig
    )
    plant = envs.plants[0]
    envs.reset(seed=args.seed)
    shown = []
    for seed in order[: max(2, FLIGHTS_ON_A_PAGE // len(args.policies))]:
        group = {flight.policy: flight for flight in perturbed if flight.seed == seed}
        kind = "hardest draw" if seed == seeds[0] else "median draw" if seed in names else "draw"
        shown.append(
            Shown(
                f"{kind}, seed {seed}, perturbed start, {args.control_period * 1e3:g} ms",
                {name: flight.trajectory for name, flight in group.items()},
                describe_draw(plant, envs.plant_of(seed - args.seed)),
                {name: error_deg(flight) for name, flight in group.items()},
            )
        )
    exact = {flight.policy: flight.trajectory for flight in flights if flight.start == "exact"}
    if exact:
        shown.append(Shown(f"exact start, {PAPER_PERIOD * 1e3:g} ms", exact))
    return shown


def error_deg(flight: Flight) -> float:
    """RMS distance in degrees from the reference in travel and elevation."""
    return float(np.hypot(*flight.metrics.rms_error_deg[:2]))


def hardest_first(flights: Sequence[Flight]) -> list[int]:
    """Seeds by the mean rank of their flights over all policies, the hardest first; crashes rank last."""
    seeds = sorted({flight.seed for flight in flights})
    total = dict.fromkeys(seeds, 0.0)
    for policy in {flight.policy for flight in flights}:
        own = sorted(
            (flight for flight in flights if flight.policy == policy),
            key=lambda flight: (flight.metrics.crashed, error_deg(flight)),
        )
        for rank, flight in enumerate(own):
            total[flight.seed] += rank
    return sorted(seeds, key=lambda seed: -total[seed])


def draw_figures(args: Args, unconstrained: Trajectory, constrained: Trajectory, console: Console) -> None:
    """Draw the paper's figures except photographs and schematics; Figs. 10 and 11 show the flights of this run."""
    rig = find_rig(args.flown_rig)
    env = Heli3DOFEnv(find_condition(args.plant), reference_for(args.reference, rig, args.force), PAPER_PERIOD, rig=rig)
    reference, title = env.reference, f"{subject(args)} at {PAPER_PERIOD * 1e3:g} ms"
    start = reference.x[:, 0].copy()
    start[[0, 2]] += np.radians(FIGURE_START_DEG)
    flights = {
        name: fly(env, make_policy(name, reference, PAPER_PERIOD), seed=args.seed, options={"state": start})
        for name in ("open-loop", "feedforward+tvlqr")
    }
    of_paper = paper_figures(unconstrained, constrained) if same_dynamics(rig, PAPER) else {}
    drawings = {
        **of_paper,
        "fig10-angles": figures.angles(reference, flights, title),
        "fig11-voltages": figures.voltages(reference, flights, title),
        "overview": figures.overview(reference, {"feedforward+tvlqr": flights["feedforward+tvlqr"]}, title),
    }
    paths = [args.out / f"{name}.{args.format}" for name in drawings]
    announce_replaced("heli-evaluate", *paths)
    for figure, path in track(list(zip(drawings.values(), paths)), "drawing", console=console):
        figure_style.save(figure, path, args.columns)


def main(args: Args | None = None) -> None:
    """Run the command `heli-evaluate`."""
    with command("heli-evaluate"):
        run(args or parse(Args, "heli-evaluate"))


def run(args: Args) -> None:
    """Fly, write the results, then print and draw them; an interrupt writes the flights so far."""
    console = Console(width=None if sys.stdout.isatty() else 180)
    path = args.out / RESULTS
    flights: list[Flight] = []
    try:
        evaluate(args, console, flights)
    except KeyboardInterrupt:
        if not flights:
            raise
        write_results(path, args, flights, [], "interrupted")
        raise KeyboardInterrupt(f"the {len(flights)} flights so far are in {path}") from None
    is_papers = args.reference == PAPERS_REFERENCE and same_dynamics(find_rig(args.flown_rig), PAPER)
    unconstrained, constrained = plan_unconstrained(Maneuver()), plan(Maneuver())
    numbers = paper_numbers(unconstrained, constrained, Maneuver()) if is_papers else []
    rows = write_results(path, args, flights, numbers)
    console.print(results_table(rows, args))
    if numbers:
        table = Table(title="The paper's numbers")
        for name in ("what", "paper", "here"):
            table.add_column(name)
        for number in numbers:
            table.add_row(*number.values())
        console.print(table)
    if args.report is not None:
        write_report(
            args.report,
            title=subject(args),
            table={
                "title": table_title(args, rows),
                "caption": CAPTION,
                "columns": COLUMNS,
                "rows": [*map(table_cells, rows)],
            },
            reference=reference_for(args.reference, args.flown_rig, args.force),
            shown=report_flights(args, flights),
            errors={
                name: [error_deg(flight) for flight in flights if (flight.policy, flight.start) == (name, "perturbed")]
                for name in args.policies
            },
        )
        console.print(f"report: {args.report}")
    if args.figures:
        draw_figures(args, unconstrained, constrained, console)
    console.print(f"written to {args.out}")


def write_results(
    path: Path, args: Args, flights: Sequence[Flight], numbers: list[dict[str, Any]], state: str = "complete"
) -> list[dict[str, Any]]:
    """Write results.json, and return the rows of its summary."""
    rows = summarise(flights)
    settings = {name: str(value) if isinstance(value, Path) else value for name, value in asdict(args).items()}
    results = {
        "version": version("heli-gym"),
        "state": state,
        "settings": settings,
        "paper": numbers,
        "summary": rows,
        "flights": [flight_row(flight) for flight in flights],
    }
    with atomic_write(path) as file:
        file.write(json.dumps(results, indent=1).encode())
    return rows


if __name__ == "__main__":
    main()
