"""`heli-results`: learned and classical policies on the same held-out helicopters, with intervals.

Every policy flies the same draws of a plant, which neither training nor validation has used. Of each metric the table
gives the interquartile mean over draws and training seeds (Agarwal et al., "Deep reinforcement learning at the edge of
the statistical precipice", 2021) and its 95 % interval, by a bootstrap that resamples draws and seeds; then, paired by
draw, how much smaller it is than that of the paper's controller, and how probably it is smaller.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.weights import weights_file
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly, fly_many
from heli_gym.baselines.evaluation.statistics import improvement, mean_with_interval, rank_crashes_last
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, check_folder
from heli_gym.train.oracle import NoOptimum, Oracle
from heli_gym.trajectory import Trajectory
from heli_gym.vector_env import Heli3DOFVectorEnv

START_SPREAD_DEG = 5.0
METRICS = ("travel", "elevation", "pitch", "cost", "return", "crashed", "success")
SHOWN = ("travel", "elevation", "cost")  # those that are compared


@dataclass
class Args:
    """Compare policies on held-out draws of a plant."""

    plant: str = "lab"
    methods: tuple[Path, ...] = ()  # folders of what heli-train left, with a folder for each seed in them
    policies: tuple[str, ...] = (
        "feedforward+tvlqr",
        "feedforward+tvlqr@PLANT",
        "lqi@PLANT",
        "lag-lqr@PLANT",
        "lag-lqi@PLANT",
        "kalman-lqr",
        "kalman-lqr@PLANT",
    )  # @PLANT: with the weights that are tuned on the plant, if there are any
    against: str = "feedforward+tvlqr@PLANT"  # which of them the others are compared with
    reference: str = "travel-360"
    rig: str = "paper"  # a name, or a .toml file
    force: bool = False  # whether to fly a plan that is for another rig
    episodes: int = 100  # draws
    seed: int = HELD_OUT_SEED  # of the first; the others count on
    oracle: int = 0  # of these draws, the first so many, for which the floor is found too: 3 s each on lab, 40 on rigid
    out: Path = Path("out/results")


def policies(args: Args) -> tuple[str, ...]:
    """The names of the classical policies."""
    return tuple(dict.fromkeys(tuned_for(args.plant, name, args.rig) for name in args.policies))


def against(args: Args) -> str:
    """The name of the one that the others are compared with."""
    return tuned_for(args.plant, args.against, args.rig)


def tuned_for(plant: str, name: str, rig: str = "paper") -> str:
    """The name with the plant in it, or without, where no weights are stored for that plant."""
    return name.replace("@PLANT", f"@{plant}" if weights_file(plant, find_rig(rig)).is_file() else "")


def policy_metrics(envs: Heli3DOFVectorEnv, policy: Policy, seed: int) -> np.ndarray:
    """The metrics (len(METRICS), draws) of a policy, in degrees, s and shares."""
    reference = envs.reference_of(0)
    flights = fly_many(envs, policy, seed)
    return np.array([metrics_of(flight, reference, envs) for flight in flights]).T


def metrics_of(flight: Trajectory, reference: Trajectory, env: Heli3DOFEnv | Heli3DOFVectorEnv) -> tuple[float, ...]:
    """METRICS of one flight."""
    m = flight_metrics(flight, reference, env.voltage_limits, env.pitch_limit)
    return *m.rms_error_deg, m.cost, m.episode_return, float(m.crashed), float(m.success)


def oracle_metrics(env: Heli3DOFEnv, oracle: Oracle, args: Args, console: Console) -> np.ndarray:
    """The metrics (len(METRICS), args.oracle) of the oracle on the first draws; NaN where it finds no optimum."""
    found = np.full((len(METRICS), args.oracle), np.nan)
    for k in track(range(args.oracle), "the floor", console=console):
        _, info = env.reset(seed=args.seed + k)
        try:
            policy = oracle.policy(env.drawn_plant, info["state"], env.reference.u[:, 0], env.control_period)
        except NoOptimum as error:
            console.print(f"seed {args.seed + k}, left out of the oracle's row: {error}")
            continue
        found[:, k] = metrics_of(fly(env, policy, seed=args.seed + k), env.reference, env)
    return found


def compare(args: Args, console: Console) -> dict[str, np.ndarray]:
    """The metrics (len(METRICS), seeds, draws) of each policy; NaN on draws for which the oracle finds no optimum.

    Raises ValueError for settings that make no sense, and ImportError if the oracle is asked for and CasADi is missing,
    both before anything is flown.
    """
    check_folder("out", args.out)
    if args.seed < 0:
        raise ValueError(f"seed = {args.seed}: must be at least 0")
    if args.episodes < 2:
        raise ValueError(f"episodes = {args.episodes}: must be at least 2")
    if not 0 <= args.oracle <= args.episodes:
        raise ValueError(f"oracle = {args.oracle}: must be 0 to episodes = {args.episodes}")
    if against(args) not in policies(args):
        raise ValueError(f"against = {args.against!r}: must be one of policies = {policies(args)}")
    reference = reference_for(args.reference, args.rig, args.force)
    envs = Heli3DOFVectorEnv(args.episodes, args.plant, reference, start_spread_deg=START_SPREAD_DEG, rig=args.rig)
    names = {name: [name] for name in policies(args)}
    for method in args.methods:
        found = sorted(method.glob("*/best.json"), key=lambda path: path.parent.name)
        if not found:
            raise ValueError(f"methods: {str(method)!r} has no folders with a best.json in them")
        if method.name in names:
            raise ValueError(f"methods: two are called {method.name!r}")
        names[method.name] = [str(path) for path in found]
    # All that can be refused is made before the first flight.
    reference = envs.reference_of(0)
    jobs = [
        (label, make_policy(name, reference, envs.control_period)) for label, group in names.items() for name in group
    ]
    if args.oracle:
        single = Heli3DOFEnv(args.plant, reference, start_spread_deg=START_SPREAD_DEG, rig=args.rig)
        oracle = Oracle(single.plant, reference, single.control_period, single.voltage_limits, single.pitch_limit)
    results: dict[str, list[np.ndarray]] = {label: [] for label in names}
    for label, policy in track(jobs, "flying", console=console):
        results[label].append(policy_metrics(envs, policy, args.seed))
    if args.oracle:
        least = oracle_metrics(single, oracle, args, console)
        if np.isfinite(least).any():
            results["oracle"] = [least]
    return {label: np.stack(group, axis=1) for label, group in results.items()}


def flown(values: np.ndarray) -> np.ndarray:
    """The draws (n,), of those of the metrics (len(METRICS), seeds, draws), that were flown."""
    return np.flatnonzero(np.isfinite(values).all(axis=(0, 1)))


def ranked(values: np.ndarray, name: str) -> np.ndarray:
    """One of the metrics (len(METRICS), seeds, draws), crashed flights behind all others: (seeds, draws)."""
    return rank_crashes_last(values[METRICS.index(name)], values[METRICS.index("crashed")])


def table_of(args: Args, results: dict[str, np.ndarray]) -> tuple[Table, dict[str, dict]]:
    """The table, and the same as plain values."""
    table = Table(title=f"{args.reference} on {args.episodes} held-out draws of {args.plant}: interquartile means")
    table.add_column("policy (seeds x draws)")
    for name in ("RMS travel (deg)", "RMS elevation (deg)", "cost (s)"):
        table.add_column(name, justify="right")
    for name in SHOWN[:2]:
        table.add_column(f"{name}: less than {against(args)}", justify="right")
    table.add_column("crashes", justify="right")
    table.add_column("success", justify="right")
    rows: dict[str, dict] = {}
    for label, all_values in results.items():
        draws = flown(all_values)
        values = all_values[:, :, draws]
        others = results[against(args)][:, :, draws]
        row: dict = {name: mean_with_interval(ranked(values, name)) for name in SHOWN}
        for name in SHOWN[:2]:
            crashes = values[METRICS.index("crashed")], others[METRICS.index("crashed")]
            row[f"{name} improvement"] = improvement(ranked(values, name), ranked(others, name), *crashes)
        row["crashes"], row["success"] = (float(values[METRICS.index(name)].mean()) for name in ("crashed", "success"))
        row["seeds"], row["draws"] = values.shape[1:]
        rows[label] = row
        means = [
            f"{row[name]['iqm']:.3g} [{row[name]['interval'][0]:.3g}, {row[name]['interval'][1]:.3g}]" for name in SHOWN
        ]
        gains = [
            f"{100 * gain['share']:.0f} % [{100 * gain['interval'][0]:.0f}, {100 * gain['interval'][1]:.0f}], "
            f"p {gain['probability']:.2f}"
            for gain in (row[f"{name} improvement"] for name in SHOWN[:2])
        ]
        table.add_row(
            f"{label} ({values.shape[1]} x {values.shape[2]})",
            *means,
            *gains,
            f"{100 * row['crashes']:.1f} %",
            f"{100 * row['success']:.0f} %",
        )
    return table, rows


def draw_profiles(path: Path, args: Args, results: dict[str, np.ndarray]) -> None:
    """Which share of the flights has at most which error."""
    figure, axes = plt.subplots(1, 2, figsize=(10.5, 3.8), layout="constrained", sharey=True)
    colours = plt.get_cmap("turbo")(np.linspace(0.0, 0.95, len(results)))
    for axis, name in zip(axes, SHOWN[:2]):
        for colour, (label, values) in zip(colours, results.items()):
            errors = np.sort(values[METRICS.index(name)][:, flown(values)].ravel())
            style = {"lw": 2.5} if label == "residual" else {"lw": 1.2}
            shares = np.arange(1, len(errors) + 1) / len(errors)
            axis.step(errors, shares, where="post", label=label, color=colour, **style)
        axis.set_xlabel(f"RMS error of {name} (deg)")
        axis.set_xscale("log")
        axis.grid(alpha=0.3, which="both")
    axes[0].set_ylabel("share of flights below")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside right center", fontsize=8)
    figure.suptitle(f"{args.episodes} held-out draws of {args.plant}")
    with atomic_write(path) as file:
        figure.savefig(file, format="png", dpi=130)
    plt.close(figure)


def main() -> None:
    """The command `heli-results`."""
    with command("heli-results"):
        run(parse(Args, "heli-results", __doc__))


def run(args: Args) -> None:
    """Fly, leave the table in the folder, print it, draw the profiles."""
    console = Console()
    path = args.out / f"{args.plant}.json"
    announce_replaced("heli-results", path)
    results = compare(args, console)
    table, rows = table_of(args, results)
    with atomic_write(path) as file:
        file.write((json.dumps(rows, indent=2) + "\n").encode())
    console.print(table)
    draw_profiles(args.out / f"{args.plant}-profiles.png", args, results)
    console.print(f"written to {args.out}")


if __name__ == "__main__":
    main()
