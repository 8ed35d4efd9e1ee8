"""What a learned correction gains from knowing the plant's draw: a bound for what any estimate of the draw can give.

    python benchmarks/known_draw.py --steps 3840000 --cell 64 --seeds 3

Trains the same networks from the same weights on the same flights twice: with hidden states that begin at zero, and
with hidden states that begin at a learned linear function of the draw. Both fly the same validation flights.
"""

import argparse

import numpy as np
import torch
from rich.console import Console
from rich.progress import track
from rich.table import Table
from threadpoolctl import threadpool_limits

from heli_gym.baselines.evaluation.statistics import mean_with_interval, rank_crashes_last
from heli_gym.train.apg import APG, batch_of, weights_of
from heli_gym.train.flight_gradient import LANES, Outcome
from heli_gym.train.train import VALIDATION_SEED, Args, chunks_of, learn, make_agent, make_helicopters, with_defaults
from heli_gym.train.vec_env import DRAWN, plant_features
from heli_gym.vector_env import Heli3DOFVectorEnv

BATCHES = 16  # of `LANES` validation flights


class FromDraw(torch.nn.Module):
    """First hidden states (H, N) as a linear function of the draws of N helicopters."""

    def __init__(self, hidden: int) -> None:
        super().__init__()
        self.weight = torch.nn.Parameter(torch.zeros(hidden, len(DRAWN)))

    def forward(self, envs: Heli3DOFVectorEnv) -> torch.Tensor:
        return self.weight @ torch.from_numpy(plant_features(envs).astype(np.float32))


def train(args: Args, given: bool) -> APG:
    """Agent after all chunks of its training, without files."""
    complete = with_defaults(args)
    torch.set_num_threads(1)
    helicopters = make_helicopters(complete)
    agent = make_agent(complete, helicopters, FromDraw(args.cell) if given else None)
    assert isinstance(agent, APG)
    chunks = chunks_of(complete)
    for number in range(chunks):
        learn(complete, agent, helicopters, number, chunks)
    return agent


def validate(agent: APG) -> Outcome:
    """Results (BATCHES * LANES,) of validation flights, crashed ones to the end of the maneuver; without the start."""
    agent.rollout.task = agent.tasks[0]._replace(after_crash=True)
    outcomes = []
    with torch.no_grad(), threadpool_limits(1):  # more threads slow down small matrices
        weights = weights_of(agent.policy.parameters())
        for k in range(BATCHES):
            batch = batch_of(agent.envs, VALIDATION_SEED + k * LANES)
            if agent.first:
                batch = batch._replace(hidden=agent.first(agent.envs).numpy())
            outcomes.append(agent.rollout.forward(weights, batch))
    return Outcome(*map(np.concatenate, zip(*outcomes)))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plant", choices=("lab", "rigid"), default="lab")
    parser.add_argument("--steps", type=int, default=3_840_000, help="control periods of each training")
    parser.add_argument("--cell", type=int, default=64, help="hidden states")
    parser.add_argument("--seeds", type=int, default=3)
    args = parser.parse_args()
    table = Table("the network", "travel (deg)", "elevation (deg)", "cost (s)", "crashes", title=args.plant)
    for name, given in (("does not know the draw", False), ("knows the draw", True)):
        results = [
            validate(train(Args(plant=args.plant, cell=args.cell, steps=args.steps, seed=seed), given))
            for seed in track(range(args.seeds), name)
        ]
        cells = []
        crashed = np.array([r.crashed for r in results])
        for field in ("travel_deg", "elevation_deg", "cost"):
            values = np.array([getattr(r, field) for r in results])
            mean = mean_with_interval(rank_crashes_last(values, crashed))
            cells.append("{:.3f} [{:.3f}, {:.3f}]".format(mean["iqm"], *mean["interval"]))
        crashes = int(crashed.sum())
        table.add_row(name, *cells, f"{crashes} of {args.seeds * BATCHES * LANES}")
    Console().print(table)


if __name__ == "__main__":
    main()
