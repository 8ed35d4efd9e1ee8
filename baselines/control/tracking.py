"""Feedforward and static state feedback: open loop, the paper's time-varying regulator, a hover regulator."""

from dataclasses import dataclass

import numpy as np

from heli_gym.baselines.control.discrete_lqr import Weights
from heli_gym.baselines.control.protocol import MemorylessPolicy, apply_gains, expand_batch_dims, step_index
from heli_gym.baselines.control.weights import TVLQR
from heli_gym.baselines.paper.tvlqr import riccati_gains, stationary_gain
from heli_gym.model import fan_thrusts, hover_input, virtual_input
from heli_gym.rig import Rig, assumed_rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory


@dataclass(frozen=True, eq=False)
class TrackingPolicy(MemorylessPolicy):
    """Two-degrees-of-freedom scheme of Fig. 3: feedforward and state feedback on the tracking error, (51).

    Arrays are on the control grid: states x (6, K + 1), feedforward v (2, K + 1) in N, and gains (2, 6, K + 1) from
    state errors to v.
    """

    x: np.ndarray
    v: np.ndarray
    gains: np.ndarray
    rig: Rig
    control_period: float

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        error = measurement - expand_batch_dims(self.x[:, k], measurement)
        v = expand_batch_dims(self.v[:, k], measurement) - apply_gains(self.gains[:, :, k], error)
        return self.rig.voltage(fan_thrusts(v))


def open_loop(reference: Trajectory, control_period: float, rig: Rig) -> TrackingPolicy:
    """Feedforward without feedback."""
    rig = assumed_rig(reference, rig)
    x, u = control_grid(reference, control_period)
    v = np.stack(virtual_input(rig.thrust(u)))
    return TrackingPolicy(x, v, np.zeros((2, *x.shape)), rig, control_period)


def feedforward_tvlqr(
    reference: Trajectory, control_period: float, rig: Rig, weights: Weights = TVLQR
) -> TrackingPolicy:
    """Paper's controller: feedforward of Section III-D and time-varying regulator of Section III-E."""
    feedforward = open_loop(reference, control_period, rig)
    times = control_period * np.arange(feedforward.x.shape[1])
    gains = riccati_gains(reference, rig, weights.Q, weights.R)(times)
    return TrackingPolicy(feedforward.x, feedforward.v, gains, feedforward.rig, control_period)


def hover_lqr(reference: Trajectory, control_period: float, rig: Rig) -> TrackingPolicy:
    """Stationary regulator for hover at the goal; it tracks the reference's states without feedforward."""
    rig = assumed_rig(reference, rig)
    x, _ = control_grid(reference, control_period)
    elevation = float(reference.x[2, -1])
    v = np.repeat(hover_input(elevation, rig.parameters)[:, None], x.shape[1], axis=1)
    gains = np.repeat(stationary_gain(elevation, rig.parameters)[:, :, None], x.shape[1], axis=2)
    return TrackingPolicy(x, v, gains, rig, control_period)
