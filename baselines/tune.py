"""Whether the weights of (49) could be better: `python -m baselines.tune` tells, in about a quarter of an hour.

The paper gives no weights. Half of the helicopters that they are tuned on are nominal, the others are draws of the
plant `lab`; all start up to 5 degrees off. What is maximised is what a learner would maximise: the environment's mean
return, over fixed draws, at its default control period. The best is then judged on other draws. (Without the nominal
ones, or without the delay that `lab` has, the gains that come out chatter.)
"""

from dataclasses import dataclass

import numpy as np
import tyro
from rich.console import Console
from rich.progress import Progress
from scipy.optimize import differential_evolution

from baselines import tvlqr
from baselines.flight import fly
from baselines.metrics import flight_metrics
from baselines.policies import feedforward_tvlqr
from heli_gym.env import Heli3DOFEnv
from heli_gym.parameters import HelicopterParameters

PLANTS = ("nominal", "lab")
START_SPREAD_DEG = 5.0
DECADES = [(-1.0, 4.0)] * 6 + [(-2.0, 1.0)]  # that are searched: the diagonal of Q, then the weight on v2 in R


@dataclass
class Args:
    """Tune the weights of the time-varying regulator."""

    draws: int = 6  # helicopters of each plant that a candidate flies
    generations: int = 14  # of differential evolution
    population: int = 5  # candidates per weight
    seed: int = 0  # of the draws and of the search; the judgement's draws follow


def weights(decades: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Q and R from the decimal logarithms of their diagonals. Only ratios matter, so the weight on v1 is 1."""
    return np.diag(10.0 ** decades[:6]), np.diag([1.0, 10.0 ** decades[6]])


def mean_return(Q: np.ndarray, R: np.ndarray, seeds: range) -> float:
    """Of the regulator with these weights, over both plants."""
    returns = []
    for plant in PLANTS:
        env = Heli3DOFEnv(plant, start_spread_deg=START_SPREAD_DEG)
        policy = feedforward_tvlqr(env.reference, env.control_period, HelicopterParameters(), Q, R)
        for seed in seeds:
            metrics = flight_metrics(fly(env, policy, seed=seed), env.reference, env.voltage_limits)
            returns.append(metrics.episode_return)
    return float(np.mean(returns))


def main(args: Args) -> None:
    """Search, then print the weights and what they are worth."""
    console = Console()
    seeds = range(args.seed, args.seed + args.draws)
    others = range(seeds.stop, seeds.stop + args.draws)
    with Progress(console=console) as progress:
        task = progress.add_task("tuning", total=args.generations + 1)
        result = differential_evolution(
            lambda decades: -mean_return(*weights(decades), seeds),
            DECADES,
            maxiter=args.generations,
            popsize=args.population,
            rng=args.seed,
            polish=False,
            callback=lambda intermediate_result: progress.update(
                task, advance=1, description=f"tuning, best return {-intermediate_result.fun:.3f}"
            ),
        )
    Q, R = weights(result.x)
    console.print(f"Q = np.diag({np.diag(Q).round(3).tolist()})\nR = np.diag({np.diag(R).round(3).tolist()})")
    for name, pair in (("in use", (tvlqr.Q, tvlqr.R)), ("tuned", (Q, R))):
        tuned_on, held_out = (mean_return(*pair, group) for group in (seeds, others))
        console.print(f"{name}: mean return {tuned_on:.3f} on the draws tuned on, {held_out:.3f} on others")


if __name__ == "__main__":
    main(tyro.cli(Args, description=__doc__))
