"""Gain-scheduled regulator: stationary gains at fixed operating points, interpolated over the measured pitch."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_discrete_are

from heli_gym.baselines.control.discrete_lqr import Weights, sampled_problem
from heli_gym.baselines.control.protocol import MemorylessPolicy, expand_batch_dims, step_index
from heli_gym.baselines.control.weights import TVLQR
from heli_gym.model import fan_thrusts, inverse_dynamics, virtual_input
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

PITCHES = np.radians(np.linspace(-60.0, 60.0, 13))  # rad, operating points


@dataclass(frozen=True, eq=False)
class ScheduledPolicy(MemorylessPolicy):
    """Feedforward and feedback on the tracking error, with gains (2, 6, 13) scheduled over the measured pitch.

    x (6, K + 1) and v (2, K + 1) are the reference on the control grid. Source: Rugh and Shamma, "Research on gain
    scheduling", Automatica 36(10), 2000.
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
        at = np.clip((measurement[4] - PITCHES[0]) / (PITCHES[1] - PITCHES[0]), 0.0, len(PITCHES) - 1.0)
        lower = np.minimum(at.astype(int), len(PITCHES) - 2)
        gains = self.gains[:, :, lower] + (at - lower) * (self.gains[:, :, lower + 1] - self.gains[:, :, lower])
        v = expand_batch_dims(self.v[:, k], measurement) - np.einsum("ij...,j...->i...", gains, error)
        return self.rig.voltage(fan_thrusts(v))


def gain_scheduled(reference: Trajectory, control_period: float, rig: Rig, weights: Weights = TVLQR) -> ScheduledPolicy:
    """Paper's feedforward with one stationary regulator per pitch, at which the lift balances the weight."""
    x, u = control_grid(reference, control_period)
    points = np.zeros((6, len(PITCHES)))
    points[2], points[4] = reference.x[2, -1], PITCHES
    trim = np.stack(inverse_dynamics(points, 0.0, 0.0, rig.parameters))
    A, B, Q, R = sampled_problem(points, trim, control_period, rig.parameters, weights, 0.0)
    gains = []
    for a, b in zip(A, B):
        P = solve_discrete_are(a, b, Q, R)
        gains.append(np.linalg.solve(R + b.T @ P @ b, b.T @ P @ a))
    v = np.stack(virtual_input(rig.thrust(u)))
    return ScheduledPolicy(x, v, np.stack(gains, axis=-1), rig, control_period)
