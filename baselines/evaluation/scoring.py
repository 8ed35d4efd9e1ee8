"""Scores of policies: many episodes on common draws, one row per flight."""

import os
from collections.abc import Iterable, Sequence
from typing import Any, overload

import numpy as np

from heli_gym.baselines.evaluation.agents import FunctionPolicy, make_pilot
from heli_gym.baselines.evaluation.conditions import find_condition, nominal_rig
from heli_gym.baselines.evaluation.metrics import Metrics, flight_metrics
from heli_gym.baselines.evaluation.rollout import fly, fly_many
from heli_gym.baselines.evaluation.statistics import mean_with_interval, rank_crashes_last
from heli_gym.env import Heli3DOFEnv, find_reference, reference_for
from heli_gym.plant import HELD_OUT_SEED, Plant
from heli_gym.rig import Rig
from heli_gym.storage import atomic_write, to_csv
from heli_gym.trajectory import Trajectory
from heli_gym.validation import shown
from heli_gym.vector_env import Heli3DOFVectorEnv

AXES = ("travel", "elevation", "pitch")
MOST_EPISODES = 10**7
TOGETHER = 100  # episodes flown at once


def metrics_row(metrics: Metrics) -> dict[str, Any]:
    """Metrics of a flight as columns of a table, angles in degrees."""
    row: dict[str, Any] = {f"rms_{axis}_deg": value for axis, value in zip(AXES, metrics.rms_error_deg)}
    row["rms_error_deg"] = float(np.hypot(*metrics.rms_error_deg[:2]))  # travel and elevation together
    row |= {f"final_{axis}_deg": value for axis, value in zip(AXES, metrics.terminal_error_deg)}
    rest = metrics._asdict()
    del rest["rms_error_deg"], rest["terminal_error_deg"]
    return row | rest


class FlightTable(Sequence[dict[str, Any]]):
    """Table with one row per flight; pandas reads it: `pandas.DataFrame(table)` or `table.to_pandas()`."""

    def __init__(self, rows: Iterable[dict[str, Any]]) -> None:
        self.rows = list(rows)

    def __len__(self) -> int:
        return len(self.rows)

    @overload
    def __getitem__(self, index: int) -> dict[str, Any]: ...
    @overload
    def __getitem__(self, index: slice) -> list[dict[str, Any]]: ...
    def __getitem__(self, index: int | slice) -> dict[str, Any] | list[dict[str, Any]]:
        return self.rows[index]

    def column(self, name: str) -> np.ndarray:
        """Values (N,) of a column, one per flight."""
        return np.array([row[name] for row in self.rows])

    def summary(self) -> dict[str, Any]:
        """Interquartile means of errors and cost with 95 % intervals (a crash counts as the worst), and shares."""
        crashed = self.column("crashed").astype(bool)[None]
        result: dict[str, Any] = {"episodes": len(self)}
        for name in ("rms_travel_deg", "rms_elevation_deg", "rms_error_deg", "cost"):
            result[name] = mean_with_interval(rank_crashes_last(self.column(name)[None].astype(float), crashed))
        return result | {name: float(self.column(name).mean()) for name in ("success", "crashed", "episode_return")}

    def to_pandas(self) -> Any:
        """Rows as a pandas.DataFrame. Raises ImportError without pandas."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("pandas must be installed: `pip install pandas`") from error
        return pandas.DataFrame(self.rows)

    def to_csv(self, path: str | os.PathLike) -> None:
        """Write the rows as CSV, atomically."""
        with atomic_write(path) as file:
            file.write(to_csv(self.rows))

    def __repr__(self) -> str:
        if not self.rows:
            return "FlightTable of no flights"
        found = self.summary()
        means = ", ".join(
            f"{name} {found[key]['iqm']:.3g} [{found[key]['interval'][0]:.3g}, {found[key]['interval'][1]:.3g}]"
            for name, key in (("RMS travel", "rms_travel_deg"), ("elevation", "rms_elevation_deg"))
        )
        return (
            f"FlightTable of {len(self)} flights: {means} deg (interquartile means and 95 % intervals), "
            f"success {100 * found['success']:.0f} %, crashed {100 * found['crashed']:.1f} %"
        )


def evaluate(
    policy: Any,
    plant: str | Plant = "nominal",
    episodes: int = 100,
    reference: str | Trajectory = "travel-360",
    seed: int = HELD_OUT_SEED,
    start_spread_deg: float = 5.0,
    control_period: float = 0.02,
    rig: str | Rig | None = None,
) -> FlightTable:
    """Fly a policy in many episodes and score each flight.

    Args:
        policy: argument of `make_pilot`: a name, a file, a policy, a function or a Stable-Baselines3 model.
        plant: plant to fly; each episode draws its ranges anew.
        episodes: number of episodes.
        reference: name of a packaged reference, an .npz file, or a trajectory.
        seed: of the first episode, then counting up. Training and tuning never use the draws of the default.
        start_spread_deg: greatest deviation of each angle at the start.
        control_period: s.
        rig: nominal rig, as `find_rig` takes it; by default that of the trajectory, or of the plant.

    Raises:
        ValueError: for invalid arguments, and policies or trajectories that do not fit them.
    """
    if type(episodes) is not int or not 1 <= episodes <= MOST_EPISODES:
        raise ValueError(f"episodes = {shown(episodes)}: must be a whole number, 1 to {MOST_EPISODES}")
    if type(seed) is not int or seed < 0:
        raise ValueError(f"seed = {shown(seed)}: must be a whole number, at least 0")
    if rig is None:
        rig = nominal_rig(plant) if isinstance(reference, str) else find_reference(reference).rig
    settings: dict[str, Any] = {
        "plant": find_condition(plant),
        "reference": reference_for(reference, rig),
        "rig": rig,
        "control_period": control_period,
        "start_spread_deg": start_spread_deg,
    }
    single = Heli3DOFEnv(**settings)
    pilot = make_pilot(policy, single.reference, control_period, single.voltage_limits)
    rows: list[dict[str, Any]] = []
    for first in range(0, episodes, TOGETHER):
        count = min(TOGETHER, episodes - first)
        rows += score_episodes(pilot, settings, seed + first, count)
    return FlightTable(rows)


def score_episodes(pilot: Any, settings: dict[str, Any], seed: int, episodes: int) -> list[dict[str, Any]]:
    """Fly episodes with the seeds from `seed` on, in environments with given settings, and return their rows."""
    single = Heli3DOFEnv(**settings)
    if flies_together(pilot, single.reference):
        flights = fly_many(Heli3DOFVectorEnv(episodes, **settings), pilot, seed)
    else:
        flights = [fly(single, pilot, seed=seed + k) for k in range(episodes)]
    limits = single.voltage_limits, single.pitch_limit
    return [
        {"seed": seed + k, **metrics_row(flight_metrics(flight, single.reference, *limits))}
        for k, flight in enumerate(flights)
    ]


def flies_together(pilot: Any, reference: Trajectory) -> bool:
    """Whether a pilot flies several helicopters at once, as agents and batched policies do."""
    if hasattr(pilot, "act"):
        return True
    if isinstance(pilot, FunctionPolicy):
        return pilot.batched
    measurement = np.repeat(reference.x[:, :1], 3, axis=1)
    try:
        pilot.reset(np.random.default_rng(0))
        return np.shape(pilot(0.0, measurement)) == (2, 3)
    except (ValueError, TypeError, IndexError, RuntimeError):
        return False
