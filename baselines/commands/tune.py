"""`heli-tune`: search for better weights of a policy, by differential evolution or by Optuna.

Every policy has the same budget: the same helicopters, number of candidates and information. The search maximises the
objective of a learner over fixed draws at the default control period: the environment's mean return, or the objective
of `heli-train`. The best candidate is then evaluated on other draws. By default, half of the helicopters are nominal
and half are draws of the plant `lab`; all start up to 5 degrees off. (Without nominal ones, or without the delay of
`lab`, the resulting gains may chatter.)

With --store, the weights are stored for the policy `NAME@PLANT`: `--policy kalman-lqr --plants lab --objective tracking
--store` makes `kalman-lqr@lab`, with the objective of `heli-train --plant lab`. With --study FILE, all candidates and
their returns, and the seconds of the search, are written as JSON.
"""

import json
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, astuple, dataclass, fields, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from rich.console import Console
from rich.progress import Progress
from scipy.optimize import differential_evolution
from scipy.stats.qmc import LatinHypercube, scale

from heli_gym.baselines.control.discrete_lqr import Weights
from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.weights import WEIGHTS, store_weights, stored
from heli_gym.baselines.evaluation.conditions import nominal_rig
from heli_gym.baselines.evaluation.engine import EngineName, check_engine, in_order, open_engine
from heli_gym.baselines.evaluation.metrics import crash_cost, tracking_reward
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import reference_for
from heli_gym.plant import HELD_OUT_SEED, PLANTS
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, check_folder
from heli_gym.task import control_grid, control_steps, to_action
from heli_gym.vector_env import MOST_ENVS, Heli3DOFVectorEnv

NEAR = 0.3  # decades; half of the first candidates are this far (standard deviation) from the weights in use
START_SPREAD_DEG = 5.0
BATCH = 8  # candidates that tpe proposes together for several workers
HALF_WIDTH = 1.0  # decades, of the range about a number in use that DECADES does not list

# Search ranges of decimal logarithms. Only ratios matter, so the weight of the thrust sum is fixed.
DECADES: dict[str, tuple[float, float]] = {
    "travel": (-1.0, 4.0),
    "travel_rate": (-1.0, 4.0),
    "elevation": (-1.0, 4.0),
    "elevation_rate": (-1.0, 4.0),
    "pitch": (-2.0, 3.0),
    "pitch_rate": (-2.0, 3.0),
    "thrust_difference": (-2.0, 1.0),
    "travel_integral": (-2.0, 3.0),
    "elevation_integral": (-2.0, 3.0),
    "travel_disturbance": (-3.0, 1.0),
    "elevation_disturbance": (-3.0, 1.0),
    "pitch_disturbance": (-3.0, 1.0),
    "acceleration": (-3.0, 1.0),
}

Score = Callable[[Sequence[np.ndarray]], list[float]]


@dataclass
class Args:
    """Search for better weights of a policy."""

    policy: Literal[
        "feedforward+tvlqr",
        "lqi",
        "lag-lqr",
        "lag-lqi",
        "kalman-lqr",
        "gain-scheduled",
        "l1-adaptive",
        "pd-cascade",
        "flatness",
        "linear-mpc",
        "nmpc",
        "adaptive-mpc",
    ] = "feedforward+tvlqr"
    plants: tuple[str, ...] = ("nominal", "lab")  # plants that candidates fly
    objective: Literal["environment", "tracking"] = "environment"
    """the environment's reward, or tracking of travel and elevation, and cost"""
    method: Literal["evolution", "tpe"] = "evolution"  # differential evolution, or Optuna's sampler (extra sweep)
    study: Path | None = None  # file for all candidates and their returns
    store: bool = False  # store the weights for the (single) plant
    reference: str = "travel-360"  # a packaged reference, or an .npz file of heli-plan
    rig: str | None = None  # rig of plants and weights, a name or a .toml file; by default the plants'
    force: bool = False  # fly a plan even if it is for another rig
    draws: int = 32  # helicopters of each plant per candidate
    candidates: int = 600  # number of candidates, for any number of weights; evolution flies whole populations of them
    population: int = 40  # candidates in each generation of differential evolution; random ones at first for tpe
    seed: int = 0  # seed of the draws and of the search; the evaluation's draws follow
    engine: EngineName = "local"  # processes of this machine, or Ray
    address: str | None = None  # Ray cluster, HOST:PORT or auto; by default one is started on this machine
    workers: int = 1  # number of processes; one learns from every candidate at once, several from batches of them

    @property
    def in_batches(self) -> bool:
        """Whether candidates are proposed in batches, so that any number of workers finds the same weights."""
        return self.engine != "local" or self.workers > 1


class Setting(NamedTuple):
    """What a candidate flies."""

    policy: str
    plants: tuple[str, ...]
    objective: str
    reference: str
    rig: str
    force: bool
    draws: int


@lru_cache(maxsize=2)
def helicopters(plants: tuple[str, ...], reference: str, rig: str, force: bool, draws: int) -> list[Heli3DOFVectorEnv]:
    """Helicopters of each plant, made once in each process."""
    own = find_rig(rig)
    plan = reference_for(reference, own, force)
    return [Heli3DOFVectorEnv(draws, plant, plan, start_spread_deg=START_SPREAD_DEG, rig=own) for plant in plants]


def mean_return(task: tuple[Setting, Any, int]) -> float:
    """Mean return of a policy with weights, over draws with seeds from `seed` on."""
    setting, weights, seed = task
    envs = helicopters(setting.plants, setting.reference, setting.rig, setting.force, setting.draws)
    policy = make_policy(setting.policy, envs[0].reference_of(0), envs[0].control_period, weights=weights)
    return float(np.mean([returns(env, policy, seed, setting.objective) for env in envs]))


def search_names(weights: Any) -> list[str]:
    """Names of the weights to search: all but that on the thrust sum."""
    return [field.name for field in fields(weights) if field.name != "thrust_sum"]


def search_range(weights: Any, name: str) -> tuple[float, float]:
    """Range of a weight's decimal logarithm: in DECADES for a regulator, otherwise about the weight in use."""
    if isinstance(weights, Weights) and name in DECADES:
        return DECADES[name]
    middle = float(np.log10(getattr(weights, name)))
    return middle - HALF_WIDTH, middle + HALF_WIDTH


def with_decades(weights: Any, decades: np.ndarray) -> Any:
    """Weights with the searched ones replaced, given their decimal logarithms."""
    return replace(weights, **dict(zip(search_names(weights), (10.0**decades).tolist())))


def returns(envs: Heli3DOFVectorEnv, policy: Policy, seed: int, objective: str = "environment") -> np.ndarray:
    """Returns (N,) of one episode of each helicopter, with seeds from `seed` on; a crash never pays."""
    reference, period = envs.reference_of(0), envs.control_period
    x_ref, _ = control_grid(reference, period)
    _, info = envs.reset(seed=seed)
    policy.reset(np.random.default_rng(seed))
    total, flying = np.zeros(envs.num_envs), np.ones(envs.num_envs, bool)
    steps = control_steps(reference.duration, period)
    for k in range(steps):
        u = policy(k * period, info["measurement"].T)
        _, rewards, terminated, truncated, info = envs.step(to_action(u, envs.voltage_limits, envs.hover_voltage).T)
        if objective == "tracking":
            error = info["state"].T - x_ref[:, [k + 1]]
            rewards = period * tracking_reward(error[0:3:2], info["cost"] / period, rewards / period)
        total += np.where(flying, rewards, 0.0)
        if objective == "tracking":
            for i in np.flatnonzero(flying & terminated):
                charge = crash_cost(info["state"][i, 4], envs.voltage_limits, reference.limits)
                total[i] -= (steps - k - 1) * period * charge
        flying &= ~(terminated | truncated)  # the next flight of a helicopter does not count
    return total


def main(args: Args | None = None) -> None:
    """Run the command `heli-tune`."""
    with command("heli-tune"):
        run(args or parse(Args, "heli-tune", __doc__))


def check(args: Args) -> None:
    """Raise ValueError for invalid settings, OSError if weights cannot be stored."""
    if args.store and len(args.plants) != 1:
        raise ValueError(f"plants = {args.plants}: must be a single one with store")
    if not args.plants:
        raise ValueError("plants = (): must name at least one")
    if args.rig is None and len(set(map(nominal_rig, args.plants))) > 1:
        raise ValueError(f"plants = {args.plants}: must fly one rig, or rig must name it")
    if args.store and args.plants[0] not in PLANTS:
        raise ValueError(f"plant = {args.plants[0]!r}: must be one of {', '.join(map(repr, PLANTS))}")
    for name, least in (("draws", 1), ("population", 5), ("candidates", args.population)):
        if not least <= getattr(args, name) <= MOST_ENVS:
            raise ValueError(f"{name} = {getattr(args, name)}: must be at least {least} and at most {MOST_ENVS}")
    most = HELD_OUT_SEED - 2 * args.draws  # the draws tuned on and the others are not those of evaluations
    if not 0 <= args.seed <= most:
        raise ValueError(f"seed = {args.seed}: must be at least 0 and, with draws = {args.draws}, at most {most}")
    check_engine(args.engine, args.workers, args.address)
    if args.method == "tpe":
        import_optuna()
    if args.store:
        check_folder("the folder of stored weights", stored.TUNED)
    if args.study is not None:
        if args.study.is_dir():
            raise ValueError(f"study = {str(args.study)!r}: must be a file, not a folder")
        check_folder("study", args.study.parent)


def print_weights(weights: Any, console: Console) -> None:
    """Print the weights, one per line."""
    for name, value in zip((field.name for field in fields(weights)), astuple(weights)):
        console.print(f"{name} = {value:.3g}")


def run(args: Args) -> None:
    """Search, then store and print the best weights and their returns; an interrupt prints the best so far."""
    check(args)
    console = Console()
    name = nominal_rig(args.plants[0], args.rig)
    rig = find_rig(name)
    setting = Setting(args.policy, tuple(args.plants), args.objective, args.reference, name, args.force, args.draws)
    helicopters(setting.plants, setting.reference, setting.rig, setting.force, setting.draws)  # errors appear here
    announce_replaced("heli-tune", *([args.study] if args.study else []))
    in_use = WEIGHTS[args.policy]
    candidates: list[list[float]] = []  # return and decimal logarithms of each

    def score(batch: Sequence[np.ndarray]) -> list[float]:
        tasks = [(setting, with_decades(in_use, decades), args.seed) for decades in batch]
        results = []
        for decades, result in zip(batch, in_order(engine.results(mean_return, tasks))):
            results.append(result)
            candidates.append([result, *map(float, decades)])
            progress.update(task, advance=1, description=f"tuning, best return {best_of(candidates)[0]:.3f}")
        return results

    began = time.perf_counter()
    try:
        with open_engine(args.engine, args.workers, args.address) as engine, Progress(console=console) as progress:
            task = progress.add_task("tuning", total=args.candidates)
            (by_evolution if args.method == "evolution" else by_tpe)(score, in_use, args)
        seconds = time.perf_counter() - began
        tuned = with_decades(in_use, np.array(best_of(candidates)[1:]))
        both = {"in use": in_use, "tuned": tuned}
        scores = {
            label: [mean_return((setting, weights, seed)) for seed in (args.seed, args.seed + args.draws)]
            for label, weights in both.items()
        }
    except KeyboardInterrupt:
        if candidates:
            print_weights(with_decades(in_use, np.array(best_of(candidates)[1:])), console)
        raise KeyboardInterrupt("the best weights so far are printed, none stored") from None
    try:
        if args.store:
            store_weights(args.policy, args.plants[0], tuned, rig)
        if args.study is not None:
            write_study(args.study, args, in_use, candidates, scores, seconds)
    finally:  # the search took long: its weights are printed even if a disk is full
        print_weights(tuned, console)
    for label, (tuned_on, held_out) in scores.items():
        console.print(f"{label}: mean return {tuned_on:.3f} on the draws tuned on, {held_out:.3f} on others")
    console.print(f"{len(candidates)} candidates in {seconds:.0f} s")
    if args.store:
        console.print(f"stored for {args.policy}@{args.plants[0]}")


def best_of(candidates: list[list[float]]) -> list[float]:
    """The first candidate with the greatest return; the weights in use are the very first."""
    return max(candidates, key=lambda row: row[0])


def by_evolution(score: Score, in_use: Any, args: Args) -> None:
    """Score candidates by differential evolution, from the weights in use, others near them and random ones."""
    names = search_names(in_use)
    low, high = np.array([search_range(in_use, name) for name in names]).T
    population = scale(LatinHypercube(len(names), rng=args.seed).random(args.population), low, high)
    population[0] = [np.log10(getattr(in_use, name)) for name in names]
    near, rng = slice(1, args.population // 2), np.random.default_rng(args.seed)
    population[near] = np.clip(population[0] + NEAR * rng.standard_normal(population[near].shape), low, high)
    differential_evolution(
        lambda decades: -score([decades])[0],
        list(zip(low, high)),
        init=population,
        maxiter=args.candidates // args.population - 1,  # after the first population
        tol=0.0,  # use the whole budget
        rng=args.seed,
        polish=False,
        updating="deferred" if args.in_batches else "immediate",
        workers=(lambda _, batch: [-value for value in score(list(batch))]) if args.in_batches else 1,
    )


def by_tpe(score: Score, in_use: Any, args: Args) -> None:
    """Score candidates by Optuna's tree-structured Parzen estimator, from the weights in use on.

    Source: Bergstra et al., "Algorithms for hyper-parameter optimization", NeurIPS 2011.
    """
    optuna = import_optuna()
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    names = search_names(in_use)
    sampler = optuna.samplers.TPESampler(seed=args.seed, multivariate=True, n_startup_trials=args.population)
    study = optuna.create_study(direction="maximize", sampler=sampler)
    study.enqueue_trial({name: float(np.log10(getattr(in_use, name))) for name in names})
    for first in range(0, args.candidates, BATCH if args.in_batches else 1):
        last = min(first + (BATCH if args.in_batches else 1), args.candidates)
        trials = [study.ask() for _ in range(first, last)]
        batch = [
            np.array([trial.suggest_float(name, *search_range(in_use, name)) for name in names]) for trial in trials
        ]
        for trial, value in zip(trials, score(batch)):
            study.tell(trial, value)


def import_optuna() -> Any:
    """Import Optuna, of the extra `sweep`. Raises ValueError without it."""
    try:
        import optuna
    except ImportError as error:
        raise ValueError("method = 'tpe': takes Optuna: pip install 'heli-gym[sweep]'") from error
    return optuna


def write_study(
    path: Path, args: Args, in_use: Any, candidates: list[list[float]], scores: dict[str, list[float]], seconds: float
) -> None:
    """Write a study as JSON: its settings, the seconds, and the return and weights of each candidate."""
    names = search_names(in_use)
    study = {
        "policy": args.policy,
        "plants": args.plants,
        "reference": args.reference,
        "rig": nominal_rig(args.plants[0], args.rig),
        "objective": args.objective,
        "method": args.method,
        "seed": args.seed,
        "draws": args.draws,
        "seconds": round(seconds, 1),
        "return_tuned_on_and_on_others": scores,
        "in_use": asdict(in_use),
        "columns": ["return", *names],
        "candidates": [[float(f"{v:.5g}") for v in (row[0], *(10.0 ** np.array(row[1:])))] for row in candidates],
    }
    text = json.dumps(study, indent=1)
    with atomic_write(path) as file:
        file.write((text.replace(",\n   ", ", ").replace("[\n   ", "[").replace("\n  ]", "]") + "\n").encode())


if __name__ == "__main__":
    main()
