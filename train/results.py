"""`heli-results`: learned and classical policies on common held-out helicopters, with intervals.

Every policy flies the same draws of a plant, which training and validation have not used. The table has the
interquartile mean of each metric over draws and training seeds (Agarwal et al., "Deep reinforcement learning at the
edge of the statistical precipice", 2021) with a 95 % interval from a bootstrap over draws and seeds. It also has,
paired by draw, the relative improvement over the paper's controller and its probability.
"""

import json
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from heli_gym import __version__
from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.weights import tuned_name
from heli_gym.baselines.evaluation.conditions import nominal_rig
from heli_gym.baselines.evaluation.digests import digest_of
from heli_gym.baselines.evaluation.engine import check_engine, open_engine, progress_bar
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly, fly_many
from heli_gym.baselines.evaluation.statistics import improvement, mean_with_interval, rank_crashes_last
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, check_folder, read_json_object
from heli_gym.train.oracle import NoOptimum, Oracle
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number
from heli_gym.vector_env import MOST_ENVS, Heli3DOFVectorEnv

START_SPREAD_DEG = 5.0
METRICS = ("travel", "elevation", "pitch", "cost", "return", "crashed", "success")
SHOWN = ("travel", "elevation", "cost")  # metrics of the comparison


@dataclass
class Args:
    """Compare policies on held-out draws of a plant."""

    plant: str = "lab"
    methods: tuple[Path, ...] = ()  # folders of heli-train, with one folder per seed
    policies: tuple[str, ...] = (
        "feedforward+tvlqr",
        "feedforward+tvlqr@PLANT",
        "lqi@PLANT",
        "lag-lqr@PLANT",
        "lag-lqi@PLANT",
        "kalman-lqr",
        "kalman-lqr@PLANT",
    )  # names; @PLANT: with weights tuned for the plant, if stored
    against: str = "feedforward+tvlqr@PLANT"  # policy to compare the others with
    reference: str = "travel-360"
    rig: str | None = None  # rig, a name or a .toml file; by default the plant's
    force: bool = False  # fly a plan even if it is for another rig
    episodes: int = 100  # number of draws
    seed: int = HELD_OUT_SEED  # seed of the first draw, then counting up
    oracle: int = 0  # number of draws for the oracle, too: 2 s each on lab, 15 s on rigid
    workers: int = 1  # processes for the oracle
    out: Path = Path("out/results")

    @property
    def flown_rig(self) -> str:
        """Name or file of the rig."""
        return nominal_rig(self.plant, self.rig)


def policies(args: Args) -> tuple[str, ...]:
    """Names of the classical policies."""
    rig = find_rig(args.flown_rig)
    return tuple(dict.fromkeys(tuned_name(name, args.plant, rig) for name in args.policies))


def against(args: Args) -> str:
    """Name of the policy to compare the others with."""
    return tuned_name(args.against, args.plant, find_rig(args.flown_rig))


def policy_metrics(envs: Heli3DOFVectorEnv, policy: Policy, seed: int) -> np.ndarray:
    """Metrics (len(METRICS), draws) of a policy, in degrees, s and shares."""
    reference = envs.reference_of(0)
    flights = fly_many(envs, policy, seed)
    return np.array([metrics_of(flight, reference, envs) for flight in flights]).T


def metrics_of(flight: Trajectory, reference: Trajectory, env: Heli3DOFEnv | Heli3DOFVectorEnv) -> tuple[float, ...]:
    """Values of METRICS for one flight."""
    m = flight_metrics(flight, reference, env.voltage_limits, env.pitch_limit)
    return *m.rms_error_deg, m.cost, m.episode_return, float(m.crashed), float(m.success)


class OracleFlight(NamedTuple):
    """Held-out flight of the oracle."""

    plant: str
    reference: str
    rig: str
    force: bool
    seed: int


@lru_cache(maxsize=1)
def oracle_on(plant: str, reference: str, rig: str, force: bool) -> tuple[Heli3DOFEnv, Oracle]:
    """Environment and oracle of a plant. Raises ValueError for a plant that the oracle does not cover."""
    env = Heli3DOFEnv(plant, reference_for(reference, rig, force), start_spread_deg=START_SPREAD_DEG, rig=rig)
    return env, Oracle(env.plant, env.reference, env.control_period, env.voltage_limits, env.pitch_limit)


def fly_oracle(flight: OracleFlight) -> list[float] | str:
    """Values of METRICS for the oracle's flight, or why there is none."""
    env, oracle = oracle_on(*flight[:-1])
    _, info = env.reset(seed=flight.seed)
    try:
        policy = oracle.policy(env.drawn_plant, info["state"], env.reference.u[:, 0], env.control_period)
    except NoOptimum as error:
        return str(error)
    return list(metrics_of(fly(env, policy, seed=flight.seed), env.reference, env))


def stored_flights(path: Path, settings: dict[str, str]) -> dict[str, list[float] | str]:
    """Flights of the oracle by seed that an earlier run with the same settings stored; damaged ones are left out."""
    earlier = read_json_object(path) if path.exists() else {}
    flights = earlier.get("flights")
    if earlier.get("settings") != settings or not isinstance(flights, dict):
        announce_replaced("heli-results", path)
        return {}
    whole = {
        seed: flight
        for seed, flight in flights.items()
        if isinstance(flight, str)
        or (isinstance(flight, list) and len(flight) == len(METRICS) and all(map(is_number, flight)))
    }
    print(f"heli-results: {len(whole)} flights of the oracle are those in {path}", file=sys.stderr)
    return whole


def oracle_metrics(args: Args, reference: Trajectory, console: Console) -> np.ndarray:
    """Metrics (len(METRICS), args.oracle) of the oracle on the first draws; NaN where the solver fails.

    Every flight is stored in PLANT-oracle.json. Flights that the same version stored for the same plant, reference and
    rig are taken from there.
    """
    path = args.out / f"{args.plant}-oracle.json"
    settings = {
        "version": __version__,
        "plant": args.plant,
        "reference_sha256": digest_of(*(array.tobytes() for array in (reference.t, reference.x, reference.u))),
        "rig_sha256": digest_of(find_rig(args.flown_rig).to_toml().encode()),
    }
    flights = stored_flights(path, settings)
    seeds = range(args.seed, args.seed + args.oracle)
    task = args.plant, args.reference, args.flown_rig, args.force
    missing = [OracleFlight(*task, seed) for seed in seeds if str(seed) not in flights]
    with open_engine(workers=args.workers) as engine, progress_bar(console) as progress:
        bar = progress.add_task("the oracle", total=len(missing))
        for index, outcome in engine.results(fly_oracle, missing):
            flights[str(missing[index].seed)] = outcome
            with atomic_write(path) as file:
                file.write((json.dumps({"settings": settings, "flights": flights}, indent=2) + "\n").encode())
            progress.update(bar, advance=1)
    found = np.full((len(METRICS), args.oracle), np.nan)
    for k, seed in enumerate(seeds):
        outcome = flights[str(seed)]
        if isinstance(outcome, str):
            console.print(f"seed {seed}, left out of the oracle's row: {outcome}")
        else:
            found[:, k] = outcome
    return found


def compare(args: Args, console: Console) -> dict[str, np.ndarray]:
    """Metrics (len(METRICS), seeds, draws) of each policy; NaN where the oracle's solver fails.

    Raises ValueError for invalid settings and ImportError for an oracle without CasADi, before the first flight.
    """
    check_folder("out", args.out)
    if args.seed < 0:
        raise ValueError(f"seed = {args.seed}: must be at least 0")
    if not 2 <= args.episodes <= MOST_ENVS:
        raise ValueError(f"episodes = {args.episodes}: must be at least 2 and at most {MOST_ENVS}")
    if not 0 <= args.oracle <= args.episodes:
        raise ValueError(f"oracle = {args.oracle}: must be 0 to episodes = {args.episodes}")
    check_engine("local", args.workers)
    if against(args) not in policies(args):
        raise ValueError(f"against = {args.against!r}: must be one of policies = {policies(args)}")
    reference = reference_for(args.reference, args.flown_rig, args.force)
    envs = Heli3DOFVectorEnv(
        args.episodes, args.plant, reference, start_spread_deg=START_SPREAD_DEG, rig=args.flown_rig
    )
    names = {name: [name] for name in policies(args)}
    for method in args.methods:
        found = sorted(method.glob("*/best.json"), key=lambda path: path.parent.name)
        if not found:
            raise ValueError(f"methods: {str(method)!r} has no folders with a best.json in them")
        if method.name in names:
            raise ValueError(f"methods: two are called {method.name!r}")
        names[method.name] = [str(path) for path in found]
    # Make all policies and environments first, so that errors appear before the first flight.
    reference = envs.reference_of(0)
    jobs = [
        (label, make_policy(name, reference, envs.control_period)) for label, group in names.items() for name in group
    ]
    if args.oracle:
        oracle_on(args.plant, args.reference, args.flown_rig, args.force)
    results: dict[str, list[np.ndarray]] = {label: [] for label in names}
    for label, policy in track(jobs, "flying", console=console):
        results[label].append(policy_metrics(envs, policy, args.seed))
    if args.oracle:
        least = oracle_metrics(args, reference, console)
        if np.isfinite(least).any():
            results["oracle"] = [least]
    return {label: np.stack(group, axis=1) for label, group in results.items()}


def valid_draws(values: np.ndarray) -> np.ndarray:
    """Indices (n,) of the draws with finite metrics (len(METRICS), seeds, draws)."""
    return np.flatnonzero(np.isfinite(values).all(axis=(0, 1)))


def rank_values(values: np.ndarray, name: str) -> np.ndarray:
    """Values (seeds, draws) of a metric in (len(METRICS), seeds, draws), with crashed flights behind all others."""
    return rank_crashes_last(values[METRICS.index(name)], values[METRICS.index("crashed")])


def table_of(args: Args, results: dict[str, np.ndarray]) -> tuple[Table, dict[str, dict]]:
    """Table for the terminal, and its values by policy."""
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
        draws = valid_draws(all_values)
        values = all_values[:, :, draws]
        others = results[against(args)][:, :, draws]
        row: dict = {name: mean_with_interval(rank_values(values, name)) for name in SHOWN}
        for name in SHOWN[:2]:
            crashes = values[METRICS.index("crashed")], others[METRICS.index("crashed")]
            row[f"{name} improvement"] = improvement(rank_values(values, name), rank_values(others, name), *crashes)
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
    """Draw performance profiles: the share of flights with an error below each value."""
    figure, axes = plt.subplots(1, 2, figsize=(10.5, 3.8), layout="constrained", sharey=True)
    colours = plt.get_cmap("turbo")(np.linspace(0.0, 0.95, len(results)))
    for axis, name in zip(axes, SHOWN[:2]):
        for colour, (label, values) in zip(colours, results.items()):
            errors = np.sort(values[METRICS.index(name)][:, valid_draws(values)].ravel())
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
    """Run the command `heli-results`."""
    with command("heli-results"):
        run(parse(Args, "heli-results", __doc__))


def run(args: Args) -> None:
    """Fly, write and print the table, draw the profiles."""
    console = Console()
    path, picture = args.out / f"{args.plant}.json", args.out / f"{args.plant}-profiles.png"
    announce_replaced("heli-results", path, picture)
    results = compare(args, console)
    table, rows = table_of(args, results)
    with atomic_write(path) as file:
        file.write((json.dumps(rows, indent=2) + "\n").encode())
    console.print(table)
    draw_profiles(picture, args, results)
    console.print(f"written to {args.out}")


if __name__ == "__main__":
    main()
