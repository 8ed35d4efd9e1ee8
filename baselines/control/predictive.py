"""Controllers on the adaptive filter: `adaptive-mpc`, `nmpc` and `adaptive-lqr`.

`adaptive-mpc` runs the predictive controller of the module `nmpc` on the model that the filter of `adaptive_filter`
estimates. The policy `nmpc` holds the parameters at their prior means and estimates disturbances alone. `adaptive-lqr`
runs the regulator of `kalman-lqr` on the adaptive filter. All three know the nominal parameters, the delay and the
documented ranges of the plant `lab`, never a draw.
"""

from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.adaptive_filter import (
    DISTURBANCE,
    N_FLIGHT,
    ROTORS,
    UNADAPTED,
    AdaptiveFilter,
    Estimate,
    FilterNoise,
    unexplained,
    with_estimates,
)
from heli_gym.baselines.control.estimation import least_lift, nominal_actuator
from heli_gym.baselines.control.model_based import Regulator, make_regulator
from heli_gym.baselines.control.nmpc import N_INPUTS, Bounds, MpcSettings, compiled_mpc_step
from heli_gym.baselines.control.protocol import StatefulPolicy, assign_columns, select_columns, step_index
from heli_gym.baselines.control.weights import ADAPTIVE_MPC, KALMAN_LQR, NMPC, MpcWeights, ObserverWeights
from heli_gym.model import virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS, Limits
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

FIRST_ITERATIONS = 4  # iterations at the start of a flight, where the plan is the reference


class Plan(NamedTuple):
    """Plan of `nmpc.mpc_step` for N helicopters."""

    u: np.ndarray  # (nodes, 2, N) in V
    z: np.ndarray  # (nodes + 1, N_FLIGHT, N)
    gains: np.ndarray  # (nodes, 2, N_FLIGHT, N)
    first: np.ndarray  # (N,) whether it is the reference, at the start of a flight


class Memory(NamedTuple):
    """State of a policy on the adaptive filter between control periods."""

    estimate: Estimate  # prediction for the next measurement
    pending: tuple[np.ndarray, ...]  # (2, N) each in V: commands still in the delay line, oldest first
    plan: Plan | None  # None for laws without a plan
    before: Estimate | tuple[()] = ()  # without a delay: estimate before the last period

    @property
    def disturbance(self) -> np.ndarray:
        """Estimated disturbance accelerations (3, N) in rad/s²."""
        return self.estimate.s[DISTURBANCE:]

    @property
    def rotors(self) -> np.ndarray:
        """Estimated rotor speeds (2, N), as voltages in V."""
        return self.estimate.s[ROTORS : ROTORS + 2]


@dataclass(eq=False)
class FilteredPolicy(StatefulPolicy):
    """Base of control laws on the adaptive filter's estimate, predicted to the time when the voltages take effect.

    x (6, K + 1) and u (2, K + 1) are the reference on the control grid. A subclass defines `control`.
    """

    x: np.ndarray
    u: np.ndarray
    filter: AdaptiveFilter
    delay: int  # control periods
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)

    def first_plan(self, k: np.ndarray) -> Plan | None:
        """Plan at the start of flights whose first voltages take effect in the control periods k (N,)."""
        return None

    def control(self, plan: Any, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, Plan | None]:
        """Voltages (2, N) in V for filter states s (N_STATES, N) in control periods k (N,), and the next plan."""
        raise NotImplementedError

    @property
    def rig(self) -> Rig:
        """Rig that the policy assumes; `fly` checks it."""
        return self.filter.rig

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Memory with the prior estimate at the reference, rotors at its voltages and the first plan."""
        if self.filter.voltage_limits != self.voltage_limits:
            self.filter = replace(self.filter, voltage_limits=self.voltage_limits)
        now = np.broadcast_to(self.index(t), (measurement[0].size,))
        x, u = self.x[:, now], self.u[:, now]
        estimate = self.filter.init(x, u)
        plan = self.first_plan(self.arrival(now))
        return Memory(estimate, (u,) * self.delay, plan, () if self.delay else estimate)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        angles = measurement.reshape(6, -1)[0::2]
        now = np.broadcast_to(self.index(t), angles.shape[1:])
        estimate = self.filter.step(memory.estimate, angles, memory.pending[0] if self.delay else None)
        ahead = estimate
        for u in memory.pending[1:]:
            ahead = self.filter.step(ahead, None, u)
        u, plan = self.control(memory.plan, self.arrival(now), ahead.s)
        applied = np.clip(u, *self.voltage_limits)
        if self.delay:
            after = Memory(estimate, (*memory.pending[1:], applied), plan)
        else:
            after = Memory(self.filter.step(estimate, None, applied), (), plan, estimate)
        return u.reshape(2, *measurement.shape[1:]).copy(), after

    def with_applied_input(self, memory: Memory, u: np.ndarray) -> Memory:
        """Memory after a step in which the voltages u (2, ...) in V were applied instead of the policy's own."""
        applied = np.clip(u, *self.voltage_limits).reshape(2, -1)
        if self.delay:
            return memory._replace(pending=(*memory.pending[:-1], applied))
        assert isinstance(memory.before, Estimate)
        return memory._replace(estimate=self.filter.step(memory.before, None, applied))

    def arrival(self, now: np.ndarray) -> np.ndarray:
        """Control periods (N,) in which the voltages of the control periods `now` take effect."""
        return np.minimum(now + self.delay, self.x.shape[1] - 1)

    def index(self, t: Any) -> Any:
        """Index of the control period at the time t in s."""
        return step_index(t, self.control_period, self.x.shape[1] - 1)


@dataclass(eq=False)
class PredictivePolicy(FilteredPolicy):
    """Nonlinear MPC with the reference's planning limits as soft limits of pitch and voltages."""

    limits: Limits = field(default_factory=Limits)
    settings: MpcSettings = field(default_factory=MpcSettings)

    def __post_init__(self) -> None:
        self.v = np.stack(virtual_input(self.filter.rig.thrust(self.u)))
        self.stride = max(1, round(self.settings.step / self.control_period))
        self.settings = self.settings._replace(step=self.stride * self.control_period)

    def control(self, plan: Plan, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, Plan]:
        if plan.first.all() or not plan.first.any():
            plan = self.improve(plan, k, s)
        else:
            for columns in (np.flatnonzero(plan.first), np.flatnonzero(~plan.first)):
                plan = assign_columns(
                    plan, self.improve(select_columns(plan, columns), k[columns], s[:, columns]), columns
                )
        return plan.u[0], plan

    def improve(self, plan: Plan, k: np.ndarray, s: np.ndarray) -> Plan:
        """Plan after the iterations of one control period; the flights either all start or all go on."""
        iterations, shift = (FIRST_ITERATIONS, 0.0) if plan.first.all() else (1, 1.0 / self.stride)
        u, z, gains = (np.array(part, order="C") for part in plan[:3])
        bounds = Bounds(*map(float, (*self.voltage_limits, *self.limits.u, *self.limits.pitch)))
        compiled_mpc_step()(
            np.ascontiguousarray(s),
            self.x,
            self.v,
            np.ascontiguousarray(k),
            self.stride,
            u,
            z,
            gains,
            iterations,
            shift,
            self.filter.rig.parameters,
            self.filter.fans,
            least_lift(self.filter.rig.parameters),
            self.settings,
            bounds,
        )
        return Plan(u, z, gains, np.zeros_like(plan.first))

    def first_plan(self, k: np.ndarray) -> Plan:
        """Plan along the reference, without feedback."""
        nodes = np.minimum(k + self.stride * np.arange(self.settings.nodes + 1)[:, None], self.x.shape[1] - 1)
        z = np.concatenate((self.x[:, nodes], self.u[:, nodes])).transpose(1, 0, 2)
        u = np.clip(self.u[:, nodes[:-1]].transpose(1, 0, 2), *self.voltage_limits)
        return Plan(u, z, np.zeros((self.settings.nodes, N_INPUTS, N_FLIGHT, len(k))), np.ones(len(k), bool))


@dataclass(eq=False)
class AdaptiveRegulator(FilteredPolicy):
    """Regulator of `kalman-lqr` with reference and thrust gain of the estimated model."""

    regulator: Regulator | None = None

    def control(self, plan: Any, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, None]:
        assert self.regulator is not None
        rig = self.filter.rig
        x, v = self.x[:, k], np.stack(virtual_input(rig.thrust(self.u[:, k])))
        model = with_estimates(s, rig.parameters, self.filter.fans)
        lost = np.stack(unexplained(x, v, model, rig.parameters))
        return self.regulator(k, s[:6], s[ROTORS : ROTORS + 2], lost, None, model.gain), None


def predictive_policy(
    reference: Trajectory,
    control_period: float,
    rig: Rig,
    noise: FilterNoise = FilterNoise(),
    settings: MpcSettings = MpcSettings(),
) -> PredictivePolicy:
    """Nonlinear MPC on an adaptive filter with given noise and MPC settings."""
    x, u = control_grid(reference, control_period)
    return PredictivePolicy(
        x=x,
        u=u,
        filter=AdaptiveFilter(rig, control_period, noise),
        delay=nominal_actuator(rig, control_period).delay,
        control_period=control_period,
        voltage_limits=rig.voltage_limits,
        limits=reference.limits,
        settings=settings,
    )


def adaptive_mpc(
    reference: Trajectory, control_period: float, rig: Rig, weights: MpcWeights = ADAPTIVE_MPC
) -> PredictivePolicy:
    """Nonlinear MPC on the model that the adaptive filter estimates."""
    return predictive_policy(reference, control_period, rig, weights.noise(FilterNoise()), weights.settings)


def nmpc(reference: Trajectory, control_period: float, rig: Rig, weights: MpcWeights = NMPC) -> PredictivePolicy:
    """Nonlinear MPC on the nominal model with estimated disturbances."""
    return predictive_policy(reference, control_period, rig, weights.noise(UNADAPTED), weights.settings)


def adaptive_lqr(
    reference: Trajectory, control_period: float, rig: Rig, weights: ObserverWeights = KALMAN_LQR
) -> AdaptiveRegulator:
    """Regulator of `kalman-lqr` on the adaptive filter."""
    actuator = nominal_actuator(rig, control_period)
    regulator = make_regulator(reference, control_period, rig, weights, actuator.lag)
    return AdaptiveRegulator(
        x=regulator.x,
        u=regulator.u,
        filter=AdaptiveFilter(rig, control_period, FilterNoise()),
        delay=actuator.delay,
        control_period=control_period,
        voltage_limits=rig.voltage_limits,
        regulator=regulator,
    )
