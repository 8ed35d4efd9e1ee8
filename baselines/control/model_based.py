"""Regulators with an internal model: `lqi`, `lag-lqr`, `lag-lqi` and `kalman-lqr`.

`ModelPolicy` combines an `Observer` (or the measurement itself), a predictor over the actuator's delay and a
`Regulator` on the predicted state.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.discrete_lqr import IntegralWeights, Weights, regulator_gains
from heli_gym.baselines.control.estimation import (
    IDEAL,
    Actuator,
    Observer,
    disturbance_accommodated_reference,
    encoder_noise,
    kalman_gains,
    nominal_actuator,
    predict,
    settling_gains,
)
from heli_gym.baselines.control.protocol import StatefulPolicy, apply_gains, expand_batch_dims, step_index
from heli_gym.baselines.control.weights import KALMAN_LQR, LAG_LQI, LAG_LQR, LQI, L1Weights, ObserverWeights
from heli_gym.model import fan_thrusts, virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig, assumed_rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

PREDICTIONS = 4  # greatest number of Runge-Kutta steps over the delay


class Memory(NamedTuple):
    """State of a `ModelPolicy` between control periods."""

    x: np.ndarray  # (6, ...) predicted state in rad and rad/s
    disturbance: np.ndarray  # (3, ...) estimated accelerations in rad/s²
    rotors: np.ndarray  # (2, ...) simulated rotor speeds, as voltages in V
    pending: tuple[np.ndarray, ...]  # (2, ...) each in V: commands still in the delay line, oldest first
    integral: np.ndarray  # (2, ...) integrals of the travel and elevation errors in rad s
    start: Any  # control period of the reference at the flight's start; (N,) if flights differ
    before: tuple[np.ndarray, ...] = ()  # without a delay: state and rotor speeds before the last period


@dataclass(frozen=True, eq=False)
class Regulator:
    """Feedforward and linear feedback on state, rotor speeds and integrals.

    Arrays are on the control grid: the reference's states x (6, K + 1) and voltages u (2, K + 1), the command
    (2, K + 1) in V for which the lagging rotors follow u, and the gains (2, n, K + 1) of `regulator_gains`.

    Args:
        lagging: whether the gains act on the rotor speeds too.
        integrating: whether the gains act on the integrals too.
        accommodates: whether pitch and thrusts of the reference balance the estimated disturbance.
        pitch_limits: (min, max) in rad of the reference that balances the estimated disturbance.
    """

    x: np.ndarray
    u: np.ndarray
    command: np.ndarray
    gains: np.ndarray
    lagging: bool
    integrating: bool
    accommodates: bool
    pitch_limits: tuple[float, float]
    rig: Rig

    def __call__(self, k: Any, x: Any, rotors: Any, disturbance: Any, integral: Any, gain: Any = 1.0) -> np.ndarray:
        """Voltages (2, ...) in V for the control period k, before the amplifier's saturation.

        `gain` is the ratio of the rotors' actual thrust to the thrust of the rig's map.
        """
        rig = self.rig
        v, v_ref, v_command = (
            np.stack(virtual_input(rig.thrust(voltages)))
            for voltages in (rotors, expand_batch_dims(self.u[:, k], x), expand_batch_dims(self.command[:, k], x))
        )
        v = gain * v
        x_ref, v_hold = expand_batch_dims(self.x[:, k], x), v_ref
        if self.accommodates:
            x_ref, v_hold = disturbance_accommodated_reference(
                x_ref, v_ref, disturbance, self.pitch_limits, rig.parameters
            )
        deviations = [x - x_ref]
        if self.lagging:
            deviations.append(v - v_hold)
        if self.integrating:
            deviations.append(integral)
        v = v_command + (v_hold - v_ref) - apply_gains(self.gains[:, :, k], np.concatenate(deviations))
        return rig.voltage(fan_thrusts(v / gain))


@dataclass(eq=False)
class ModelPolicy(StatefulPolicy):
    """Two-degrees-of-freedom scheme of Fig. 3 with an internal model of the actuator and, optionally, disturbances.

    The feedback acts on the predicted state at the time when the voltages take effect.
    """

    regulator: Regulator
    observer: Observer | None
    actuator: Actuator
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)

    @property
    def rig(self) -> Rig:
        """Rig that the policy assumes; `fly` checks it."""
        return self.regulator.rig

    @property
    def x(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid."""
        return self.regulator.x

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Memory at the reference's state, with the rotors at the reference's voltages."""
        batch, now = measurement.shape[1:], self.index(t)
        x, u = (
            expand_batch_dims(start[:, now], measurement) + np.zeros(batch)
            for start in (self.regulator.x, self.regulator.u)
        )
        before = () if self.actuator.delay else (x, u)
        return Memory(x, np.zeros((3, *batch)), u, (u,) * self.actuator.delay, np.zeros((2, *batch)), now, before)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        now = self.index(t)
        x, disturbance = measurement, memory.disturbance
        if self.observer is not None:
            x, disturbance = self.observer(memory.x, disturbance, measurement, now, memory.start)
        later, rotors = x, memory.rotors
        for u, periods in group_pending(memory.pending):
            later, rotors = self.predict(later, rotors, u, disturbance, periods)
        arrival = np.minimum(now + self.actuator.delay, self.x.shape[1] - 1)
        u = self.regulator(arrival, later, rotors, disturbance, memory.integral)

        applied = np.clip(u, *self.voltage_limits)
        pending = (*memory.pending, applied)
        error = (x - expand_batch_dims(self.x[:, now], x))[[0, 2]]
        # Anti-windup: stop the integrals while the amplifier saturates.
        integral = memory.integral + self.control_period * error * (u == applied).all(axis=0)
        before = () if self.actuator.delay else (x, memory.rotors)
        x, rotors = self.predict(x, memory.rotors, pending[0], disturbance)
        return u, Memory(x, disturbance, rotors, pending[1:], integral, memory.start, before)

    def with_applied_input(self, memory: Memory, u: np.ndarray) -> Memory:
        """Memory after a step in which the voltages u (2, ...) in V were applied instead of the policy's own."""
        applied = np.clip(u, *self.voltage_limits)
        if self.actuator.delay:
            return memory._replace(pending=(*memory.pending[:-1], applied))
        before, rotors = memory.before
        x, rotors = self.predict(before, rotors, applied, memory.disturbance)
        return memory._replace(x=x, rotors=rotors)

    def predict(self, x: Any, rotors: Any, u: Any, disturbance: Any, periods: int = 1) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and rotor speeds (2, ...) after a number of control periods at the voltages u (2, ...)."""
        lag, rig = self.actuator.lag, self.regulator.rig
        return predict(x, rotors, u, disturbance, periods * self.control_period, lag, rig)

    def index(self, t: Any) -> Any:
        """Index of the control period at the time t in s."""
        return step_index(t, self.control_period, self.x.shape[1] - 1)


def group_pending(pending: tuple[np.ndarray, ...]) -> list[tuple[np.ndarray, int]]:
    """Pending voltages as at most PREDICTIONS pairs of a voltage (2, ...) and a number of control periods.

    A pair for several periods holds their mean voltage; one Runge-Kutta step is accurate enough for it.
    """
    size = -(-len(pending) // PREDICTIONS)
    if size <= 1:
        return [(u, 1) for u in pending]
    groups = [pending[k : k + size] for k in range(0, len(pending), size)]
    return [(sum(group) / len(group), len(group)) for group in groups]  # type: ignore[misc]


def model_policy(
    reference: Trajectory,
    control_period: float,
    rig: Rig,
    weights: Weights,
    actuator: Actuator | None,
) -> ModelPolicy:
    """Policy of feedforward and regulator for weights and an actuator, the rig's nominal one by default.

    `IntegralWeights` add integral action, `ObserverWeights` a Kalman filter.
    """
    rig = assumed_rig(reference, rig)
    actuator = actuator or nominal_actuator(rig, control_period)
    regulator = make_regulator(reference, control_period, rig, weights, actuator.lag)
    observer = None
    if isinstance(weights, ObserverWeights):
        x, v = regulator.x, np.stack(virtual_input(rig.thrust(regulator.u)))
        along = rig.parameters, weights.noise
        gains = kalman_gains(x, v, control_period, *along, encoder_noise(rig))
        settling = partial(settling_gains, x, v, control_period, *along, angle_noise=encoder_noise(rig))
        observer = Observer(gains, settling, control_period)
    return ModelPolicy(regulator, observer, actuator, control_period, rig.voltage_limits)


def make_regulator(reference: Trajectory, control_period: float, rig: Rig, weights: Weights, lag: float) -> Regulator:
    """Regulator with feedforward and gains on the control grid for rotors with a lag in s.

    The feedforward leads the lag: a rotor turns at u(t) if its voltage is u + lag du/dt. With `ObserverWeights`, the
    reference balances the estimated disturbances.
    """
    x, middle = control_grid(reference, control_period)
    times = control_period * np.arange(x.shape[1] + 1)
    _, u = reference(times)
    command = middle + lag * np.diff(u, axis=1) / control_period
    u = u[:, :-1]
    v = np.stack(virtual_input(rig.thrust(u)))
    return Regulator(
        x=x,
        u=u,
        command=command,
        gains=regulator_gains(x, v, control_period, rig.parameters, weights, lag),
        lagging=lag > 0.0,
        integrating=isinstance(weights, IntegralWeights),
        accommodates=isinstance(weights, ObserverWeights | L1Weights),
        pitch_limits=reference.limits.pitch,
        rig=rig,
    )


def lqi(reference: Trajectory, control_period: float, rig: Rig, weights: IntegralWeights = LQI) -> ModelPolicy:
    """Feedforward and time-varying regulator with integral action on travel and elevation, without a lag model."""
    return model_policy(reference, control_period, rig, weights, IDEAL)


def lag_lqr(
    reference: Trajectory,
    control_period: float,
    rig: Rig,
    weights: Weights = LAG_LQR,
    actuator: Actuator | None = None,
) -> ModelPolicy:
    """Feedforward and time-varying regulator for rotors with a nominal lag and delay."""
    return model_policy(reference, control_period, rig, weights, actuator)


def lag_lqi(
    reference: Trajectory,
    control_period: float,
    rig: Rig,
    weights: IntegralWeights = LAG_LQI,
    actuator: Actuator | None = None,
) -> ModelPolicy:
    """`lag_lqr` with integral action on travel and elevation."""
    return model_policy(reference, control_period, rig, weights, actuator)


def kalman_lqr(
    reference: Trajectory,
    control_period: float,
    rig: Rig,
    weights: ObserverWeights = KALMAN_LQR,
    actuator: Actuator | None = None,
) -> ModelPolicy:
    """Regulator of `lag_lqr` on the estimates of a Kalman filter from the three angles alone.

    The filter also estimates disturbance accelerations beyond (3), and the reference balances them.
    """
    return model_policy(reference, control_period, rig, weights, actuator)
