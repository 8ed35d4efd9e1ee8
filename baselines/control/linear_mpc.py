"""Offset-free linear MPC: OSQP solves a quadratic program in the deviations from the reference every period.

Pannocchia and Rawlings, "Disturbance models for offset-free model-predictive control", AIChE Journal 49(2), 2003;
Stellato et al., "OSQP: an operator splitting solver for quadratic programs", Math. Prog. Comp. 12, 2020.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy import sparse

from heli_gym.baselines.control.adaptive_filter import (
    GAIN,
    ROTORS,
    UNADAPTED,
    AdaptiveFilter,
    unexplained,
    with_estimates,
)
from heli_gym.baselines.control.discrete_lqr import augmented
from heli_gym.baselines.control.estimation import (
    discretise,
    disturbance_accommodated_reference,
    nominal_actuator,
)
from heli_gym.baselines.control.predictive import FilteredPolicy
from heli_gym.baselines.control.weights import LINEAR_MPC, LinearMpcWeights
from heli_gym.model import fan_thrusts, linearise, virtual_input
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

NODES = 40
NODE = 0.04  # s, between nodes
PER_DEGREE = 3283.0  # 1/rad², 1 per degree²
TERMINAL_RATE = 3283.0  # per (rad/s)², travel and elevation at the last node
LEAST_LAG = 1e-3  # s, least rotor lag in the prediction


@dataclass(eq=False)
class LinearMpcPolicy(FilteredPolicy):
    """Linear MPC without offset: the disturbances of the non-adaptive filter shift its target.

    The states of the program are the deviations (8,) of (44), thrust sum and thrust difference from the target. Its
    inputs are the fans' thrusts, within the amplifier's limits. The prediction is (3), linearised along the reference.
    """

    pitch_limits: tuple[float, float] = (-1.0, 1.0)
    weights: LinearMpcWeights = LINEAR_MPC

    def __post_init__(self) -> None:
        rig = self.filter.rig
        self.stride = max(1, round(NODE / self.control_period))
        self.v = np.stack(virtual_input(rig.thrust(self.u)))
        A, B = (np.moveaxis(part, -1, 0) for part in linearise(self.x, self.v, rig.parameters))
        A, B = augmented(A, B, max(rig.lag, LEAST_LAG), False)
        self.A, B = discretise(A, B, self.stride * self.control_period)
        self.B = B @ np.array([[1.0, 1.0], [1.0, -1.0]])  # input: the fans' thrusts
        w = self.weights
        self.stage = np.array([PER_DEGREE, 0.0, PER_DEGREE, 0.0, w.pitch, w.pitch_rate, 0.0, 0.0])
        self.terminal = w.terminal * self.stage + TERMINAL_RATE * np.isin(np.arange(8), (1, 3))

    def condensed(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        """Hessian (2 NODES, 2 NODES) and gradient per deviation (2 NODES, 8) of the condensed program in period k."""
        last = self.x.shape[1] - 1
        free, forced = np.eye(8), np.zeros((8, 2 * NODES))
        H, g = self.weights.effort * np.eye(2 * NODES), np.zeros((2 * NODES, 8))
        for j in range(NODES):
            at = min(k + j * self.stride, last)
            free, forced = self.A[at] @ free, self.A[at] @ forced
            forced[:, 2 * j : 2 * j + 2] += self.B[at]
            weighted = forced.T * (self.stage if j < NODES - 1 else self.terminal)
            H += weighted @ forced
            g += weighted @ free
        return H, g

    def control(self, plan: Any, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, None]:
        return np.stack([self.solve(int(k[i]), s[:, i]) for i in range(len(k))], axis=1), None

    def solve(self, k: int, s: np.ndarray) -> np.ndarray:
        """Voltages (2,) in V for the filter's state s (N_STATES,) in the control period k."""
        osqp, rig = import_osqp(), self.filter.rig
        nodes = np.minimum(k + self.stride * np.arange(NODES), self.x.shape[1] - 1)
        x, v = self.x[:, nodes], self.v[:, nodes]
        model = with_estimates(s[:, None], rig.parameters, self.filter.fans)
        lost = np.stack(unexplained(x, v, model, rig.parameters))
        target, hold = disturbance_accommodated_reference(x, v, lost, self.pitch_limits, rig.parameters)
        now = np.stack(virtual_input(s[GAIN] * rig.thrust(s[ROTORS : ROTORS + 2])))
        deviation = np.concatenate((s[:6] - target[:, 0], now - hold[:, 0]))
        thrusts = np.stack(fan_thrusts(hold))
        least, most = s[GAIN] * rig.thrust(np.array(self.voltage_limits) * np.ones((2, 1))).T
        H, g = self.condensed(k)
        solver = osqp.OSQP()
        solver.setup(
            sparse.csc_matrix(np.triu(H)),
            g @ deviation,
            sparse.eye(2 * NODES, format="csc"),
            (least[:, None] - thrusts).T.ravel(),
            (most[:, None] - thrusts).T.ravel(),
            verbose=False,
            eps_abs=1e-4,
            eps_rel=1e-4,
            max_iter=2000,
        )
        change = solver.solve(raise_error=False).x[:2]
        change = np.where(np.isfinite(change), change, 0.0)
        return np.clip(rig.voltage((thrusts[:, 0] + change) / s[GAIN]), *self.voltage_limits)


def import_osqp() -> Any:
    """Import OSQP, of the extra `ocp`. Raises ImportError without it."""
    try:
        import osqp
    except ImportError as error:
        raise ImportError("linear-mpc takes OSQP: pip install 'heli-gym[ocp]'") from error
    return osqp


def linear_mpc(
    reference: Trajectory, control_period: float, rig: Rig, weights: LinearMpcWeights = LINEAR_MPC
) -> LinearMpcPolicy:
    """Offset-free linear MPC with the disturbance estimates of `nmpc`. Raises ImportError without OSQP."""
    import_osqp()
    noise = UNADAPTED._replace(
        travel_disturbance=weights.travel_disturbance,
        elevation_disturbance=weights.elevation_disturbance,
        pitch_disturbance=weights.pitch_disturbance,
    )
    x, u = control_grid(reference, control_period)
    return LinearMpcPolicy(
        x=x,
        u=u,
        filter=AdaptiveFilter(rig, control_period, noise),
        delay=nominal_actuator(rig, control_period).delay,
        control_period=control_period,
        voltage_limits=rig.voltage_limits,
        pitch_limits=reference.limits.pitch,
        weights=weights,
    )
