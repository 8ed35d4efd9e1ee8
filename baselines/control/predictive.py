"""Controllers on the adaptive filter: `adaptive-mpc`, `nmpc` and `adaptive-lqr`.

`adaptive-mpc` is the filter of `adaptive_filter` and the predictive controller of `nmpc` on the model that the filter
estimates. `nmpc` is the same on the model of the priors' means; it estimates disturbances alone. `adaptive-lqr` has the
regulator of `kalman-lqr` on the adaptive filter. All know the nominal parameters, the delay and the documented ranges
of the plant `lab`, never a draw.
"""

from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.adaptive_filter import (
    DISTURBANCE,
    N_FLIGHT,
    ROTORS,
    AdaptiveFilter,
    Estimate,
    FilterNoise,
    unexplained,
    with_estimates,
)
from heli_gym.baselines.control.estimation import least_lift, nominal_actuator
from heli_gym.baselines.control.model_based import Regulator, make_regulator
from heli_gym.baselines.control.nmpc import N_INPUTS, Bounds, MpcSettings, compiled_mpc_step
from heli_gym.baselines.control.protocol import StatefulPolicy, step_index
from heli_gym.baselines.control.weights import KALMAN_LQR, ObserverWeights
from heli_gym.model import virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS, Limits
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

FIRST_ITERATIONS = 4  # at the start of a flight, from the reference as the plan


# Of `nmpc`: disturbances have to follow all that is not estimated; of four settings on 24 training draws, the best.
UNADAPTED = FilterNoise(travel_disturbance=0.1, elevation_disturbance=0.05, pitch_disturbance=0.3, adaptive=False)


class Plan(NamedTuple):
    """Plan of `nmpc.mpc_step`, for N helicopters."""

    u: np.ndarray  # (nodes, 2, N) V
    z: np.ndarray  # (nodes + 1, N_FLIGHT, N)
    gains: np.ndarray  # (nodes, 2, N_FLIGHT, N)


class Memory(NamedTuple):
    """State of a policy on the adaptive filter between control periods."""

    estimate: Estimate  # predicted for the next measurement
    pending: tuple[np.ndarray, ...]  # (2, N) each, commanded and not yet in effect; V
    plan: Plan | None

    @property
    def disturbance(self) -> np.ndarray:
        """Estimated accelerations (3, N) in rad/s² that the model does not explain."""
        return self.estimate.s[DISTURBANCE:]

    @property
    def rotors(self) -> np.ndarray:
        """Estimated rotor speeds (2, N), as voltages in V."""
        return self.estimate.s[ROTORS : ROTORS + 2]


@dataclass(eq=False)
class FilteredPolicy(StatefulPolicy):
    """A control law on the adaptive filter's estimate, predicted for the time when the voltages take effect.

    x (6, K + 1) and u (2, K + 1) are the reference on the control grid. A subclass defines `control`.
    """

    x: np.ndarray
    u: np.ndarray
    filter: AdaptiveFilter
    delay: int  # control periods
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)

    def control(self, plan: Plan | None, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, Plan | None]:
        """Voltages (2, N) at the filter's states s (N_STATES, N) in control periods k (N,), and the next plan."""
        raise NotImplementedError

    @property
    def reference_states(self) -> np.ndarray:
        """States (6, K + 1) of the reference on the control grid, which `fly` checks."""
        return self.x

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Prior about the reference, rotors at its voltages, no plan."""
        if self.filter.voltage_limits != self.voltage_limits:
            self.filter = replace(self.filter, voltage_limits=self.voltage_limits)
        now = np.broadcast_to(self.index(t), (measurement[0].size,))
        x, u = self.x[:, now], self.u[:, now]
        return Memory(self.filter.init(x, u), (u,) * self.delay, None)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        angles = measurement.reshape(6, -1)[0::2]
        now = np.broadcast_to(self.index(t), angles.shape[1:])
        estimate = self.filter.step(memory.estimate, angles, memory.pending[0] if self.delay else None)
        ahead = estimate
        for u in memory.pending[1:]:
            ahead = self.filter.step(ahead, None, u)
        u, plan = self.control(memory.plan, np.minimum(now + self.delay, self.x.shape[1] - 1), ahead.s)
        applied = np.clip(u, *self.voltage_limits)
        pending = (*memory.pending, applied)[1:] if self.delay else ()
        if not self.delay:
            estimate = self.filter.step(estimate, None, applied)
        return u.reshape(2, *measurement.shape[1:]).copy(), Memory(estimate, pending, plan)

    def with_applied_input(self, memory: Memory, u: np.ndarray) -> Memory:
        """Memory with the voltages (2, ...) of the last step replaced by those that were commanded instead.

        Raises ValueError if the last voltages have already been simulated, for lack of a delay.
        """
        if not self.delay:
            raise ValueError("with_applied_input: without a delay, the last voltages have already been simulated")
        applied = np.clip(u, *self.voltage_limits).reshape(2, -1)
        return memory._replace(pending=(*memory.pending[:-1], applied))

    def index(self, t: Any) -> Any:
        """Control period of the time t in s."""
        return step_index(t, self.control_period, self.x.shape[1] - 1)


@dataclass(eq=False)
class PredictivePolicy(FilteredPolicy):
    """Nonlinear MPC; soft limits of pitch and voltages are those that the reference was planned within."""

    limits: Limits = field(default_factory=Limits)
    settings: MpcSettings = field(default_factory=MpcSettings)

    def __post_init__(self) -> None:
        self.v = np.stack(virtual_input(self.filter.rig.thrust(self.u)))
        self.stride = max(1, round(self.settings.step / self.control_period))
        self.settings = self.settings._replace(step=self.stride * self.control_period)

    def control(self, plan: Plan | None, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, Plan]:
        c, iterations, shift = self.settings, 1, 1.0 / self.stride
        if plan is None:
            iterations, shift = FIRST_ITERATIONS, 0.0
            plan = self.first_plan(k)
        plan = Plan(*(part.copy() for part in plan))
        bounds = Bounds(*map(float, (*self.voltage_limits, *self.limits.u, *self.limits.pitch)))
        compiled_mpc_step()(
            s,
            self.x,
            self.v,
            np.ascontiguousarray(k),
            self.stride,
            *plan,
            iterations,
            shift,
            self.filter.rig.parameters,
            self.filter.fans,
            least_lift(self.filter.rig.parameters),
            c,
            bounds,
        )
        return plan.u[0], plan

    def first_plan(self, k: np.ndarray) -> Plan:
        """The reference as a plan, without feedback, from control periods k (N,) on."""
        nodes = np.minimum(k + self.stride * np.arange(self.settings.nodes + 1)[:, None], self.x.shape[1] - 1)
        z = np.concatenate((self.x[:, nodes], self.u[:, nodes])).transpose(1, 0, 2)
        u = np.clip(self.u[:, nodes[:-1]].transpose(1, 0, 2), *self.voltage_limits)
        return Plan(u, z, np.zeros((self.settings.nodes, N_INPUTS, N_FLIGHT, len(k))))


@dataclass(eq=False)
class AdaptiveRegulator(FilteredPolicy):
    """The regulator of `kalman-lqr`, its reference and its fans those of the estimated model."""

    regulator: Regulator | None = None

    def control(self, plan: Plan | None, k: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, None]:
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
    """MPC on a filter with this tuning."""
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


def adaptive_mpc(reference: Trajectory, control_period: float, rig: Rig) -> PredictivePolicy:
    """MPC on the model that the filter estimates."""
    return predictive_policy(reference, control_period, rig)


def nmpc(reference: Trajectory, control_period: float, rig: Rig) -> PredictivePolicy:
    """MPC on the nominal model with estimated disturbances."""
    return predictive_policy(reference, control_period, rig, UNADAPTED)


def adaptive_lqr(
    reference: Trajectory, control_period: float, rig: Rig, weights: ObserverWeights = KALMAN_LQR
) -> AdaptiveRegulator:
    """The regulator of `kalman-lqr` on the adaptive filter."""
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
