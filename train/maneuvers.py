"""`python -m heli_gym.train.maneuvers`: learned and classical policies on many maneuvers, with intervals.

Every policy flies the packaged maneuvers, and drawn ones that no training has used, with held-out draws of a plant.
The table has interquartile means over the draws; `out`/maneuvers.json has their 95 % bootstrap intervals too.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.evaluation.statistics import mean_with_interval
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import REFERENCES, find_reference
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.storage import atomic_write, check_folder
from heli_gym.train.results import METRICS, START_SPREAD_DEG, policy_metrics, rank_values
from heli_gym.train.train import drawn_references
from heli_gym.trajectory import Trajectory
from heli_gym.validation import require
from heli_gym.vector_env import MOST_ENVS, Heli3DOFVectorEnv

SHOWN = ("travel", "elevation", "cost")


@dataclass
class Args:
    """Compare policies on many maneuvers."""

    policies: tuple[str, ...] = ("feedforward+tvlqr@lab", "kalman-lqr@lab", "adaptive-mpc", "residual", "residual-any")
    plant: str = "lab"
    episodes: int = 40  # number of draws of each maneuver
    drawn: int = 8  # number of drawn maneuvers
    seed: int = HELD_OUT_SEED  # of the first draw and of the first drawn maneuver
    out: Path = Path("out/results")


def maneuvers(args: Args) -> dict[str, Trajectory]:
    """Maneuvers by name: the packaged ones, then drawn ones."""
    packaged = {name: find_reference(name) for name in sorted(path.stem for path in REFERENCES.glob("*.npz"))}
    return packaged | {
        f"drawn {k + 1}": plan for k, plan in enumerate(drawn_references("paper", args.seed, args.drawn))
    }


def compare(args: Args, console: Console) -> dict[str, dict[str, np.ndarray]]:
    """Metrics (len(METRICS), 1, draws) of each maneuver and policy."""
    found: dict[str, dict[str, np.ndarray]] = {}
    for name, reference in track(maneuvers(args).items(), "flying", console=console):
        envs = Heli3DOFVectorEnv(args.episodes, args.plant, reference, start_spread_deg=START_SPREAD_DEG)
        policies = {policy: make_policy(policy, reference) for policy in args.policies}
        found[name] = {label: policy_metrics(envs, one, args.seed)[:, None] for label, one in policies.items()}
    return found


def rows_of(found: dict[str, dict[str, np.ndarray]]) -> dict[str, dict[str, dict]]:
    """Interquartile means with intervals, and share of crashes, by maneuver and policy.

    "all" pools the maneuvers, which fly the same draws.
    """
    policies = next(iter(found.values()))
    pooled = {label: np.concatenate([group[label] for group in found.values()], axis=1) for label in policies}
    rows: dict[str, dict[str, dict]] = {}
    for name, group in {**found, "all": pooled}.items():
        rows[name] = {}
        for label, values in group.items():
            row: dict = {
                metric: mean_with_interval(rank_values(values, metric), resample_rows=False) for metric in SHOWN
            }
            rows[name][label] = {**row, "crashes": float(values[METRICS.index("crashed")].mean())}
    return rows


def table_of(args: Args, rows: dict[str, dict[str, dict]]) -> Table:
    """Table for the terminal: travel, elevation and crashes of each policy."""
    table = Table(title=f"{args.episodes} held-out draws of {args.plant}: travel / elevation (deg), crashes")
    table.add_column("maneuver")
    for label in args.policies:
        table.add_column(label, justify="right")
    for name, group in rows.items():
        cells = [
            f"{row['travel']['iqm']:.2f} / {row['elevation']['iqm']:.2f}, {100 * row['crashes']:.0f} %"
            for row in group.values()
        ]
        table.add_row(name, *cells)
    return table


def run(args: Args) -> None:
    """Fly, write and print the table."""
    console = Console()
    for name, least, most in (("episodes", 1, MOST_ENVS), ("drawn", 0, 1000), ("seed", 0, 4 * HELD_OUT_SEED)):
        require(name, getattr(args, name), least <= getattr(args, name) <= most, f"{least} to {most}")
    check_folder("out", args.out)
    path = args.out / "maneuvers.json"
    announce_replaced("heli_gym.train.maneuvers", path)
    rows = rows_of(compare(args, console))
    with atomic_write(path) as file:
        file.write((json.dumps(rows, indent=2) + "\n").encode())
    console.print(table_of(args, rows))


def main() -> None:
    """Run the module as a command."""
    with command("heli_gym.train.maneuvers"):
        run(parse(Args, "heli_gym.train.maneuvers", __doc__))


if __name__ == "__main__":
    main()
