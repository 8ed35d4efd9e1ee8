"""Regulators on a model that runs along: `lqi`, `lag-lqr`, `lag-lqi` and `kalman-lqr`.

`ModelPolicy` puts three parts together: an `Observer` (or the measurement as it is), the predictor of `estimation`
over the actuator's delay, and a `Regulator` on the predicted state.
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
from heli_gym.baselines.control.weights import KALMAN_LQR, LAG_LQI, LAG_LQR, LQI, ObserverWeights
from heli_gym.model import fan_thrusts, virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig, assumed_rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

PREDICTIONS = 4  # Runge-Kutta steps over the delay, at most


class Memory(NamedTuple):
    """State of a `ModelPolicy` between control periods."""

    x: np.ndarray  # (6, ...) state, predicted; rad and rad/s
    disturbance: np.ndarray  # (3, ...) estimated; rad/s²
    rotors: np.ndarray  # (2, ...) simulated rotor speeds, as voltages; V
    pending: tuple[np.ndarray, ...]  # (2, ...) each, commanded and not yet in effect; V
    integral: np.ndarray  # (2, ...) of the errors of travel and elevation; rad s
    start: Any  # control period of the reference in which the flight began; (N,) where it differs


@dataclass(frozen=True, eq=False)
class Regulator:
    """Feedforward and linear feedback on state, rotor speeds and integrals.

    Arrays are on the control grid, K + 1 times: the reference's states x (6, K + 1) and voltages u (2, K + 1); command
    (2, K + 1), the voltages that the actuator turns into these; gains (2, n, K + 1) of `regulator_gains`.

    Args:
        lagging: whether the gains act on the rotor speeds too.
        integrating: whether the gains act on the integrals too.
        accommodates: whether pitch and thrusts of the reference make up for the estimated disturbance.
        pitch_limits: rad, of the accommodated reference.
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
        """Voltages (2, ...) for the k-th control period, before the amplifier limits them.

        The gain is that of the thrust of both rotors on the rig's.
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
    """Fig. 3 with a model that runs along: of the actuator and, where there is an observer, of disturbances.

    The feedback acts on the state that is predicted for the time when the voltages take effect.
    """

    regulator: Regulator
    observer: Observer | None
    actuator: Actuator
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)

    @property
    def rig(self) -> Rig:
        """Rig that the policy assumes, which `fly` checks."""
        return self.regulator.rig

    @property
    def x(self) -> np.ndarray:
        """States (6, K + 1) of the reference on the control grid."""
        return self.regulator.x

    @property
    def reference_states(self) -> np.ndarray:
        """States (6, K + 1) of the reference on the control grid, which `fly` checks."""
        return self.x

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """State of the reference, with which a filter begins, and rotors at the reference's voltages."""
        batch, now = measurement.shape[1:], self.index(t)
        x, u = (
            expand_batch_dims(start[:, now], measurement) + np.zeros(batch)
            for start in (self.regulator.x, self.regulator.u)
        )
        return Memory(x, np.zeros((3, *batch)), u, (u,) * self.actuator.delay, np.zeros((2, *batch)), now)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        now = self.index(t)
        x, disturbance = measurement, memory.disturbance
        if self.observer is not None:
            x, disturbance = self.observer(memory.x, disturbance, measurement, now, memory.start)
        later, rotors = x, memory.rotors
        for u, periods in stretches(memory.pending):
            later, rotors = self.predict(later, rotors, u, disturbance, periods)
        arrival = np.minimum(now + self.actuator.delay, self.x.shape[1] - 1)
        u = self.regulator(arrival, later, rotors, disturbance, memory.integral)

        applied = np.clip(u, *self.voltage_limits)
        pending = (*memory.pending, applied)
        error = (x - expand_batch_dims(self.x[:, now], x))[[0, 2]]
        # Anti-windup: nothing is integrated while the amplifier saturates.
        integral = memory.integral + self.control_period * error * (u == applied).all(axis=0)
        x, rotors = self.predict(x, memory.rotors, pending[0], disturbance)
        return u, Memory(x, disturbance, rotors, pending[1:], integral, memory.start)

    def with_applied_input(self, memory: Memory, u: np.ndarray) -> Memory:
        """Memory with the voltages (2, ...) of the last step replaced by those that were commanded instead.

        Raises ValueError if the last voltages have already been simulated, for lack of a delay.
        """
        if not memory.pending:
            if self.actuator.lag or self.observer is not None:
                raise ValueError("with_applied_input: without a delay, the last voltages have already been simulated")
            return memory
        return memory._replace(pending=(*memory.pending[:-1], np.clip(u, *self.voltage_limits)))

    def predict(self, x: Any, rotors: Any, u: Any, disturbance: Any, periods: int = 1) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and rotor speeds (2, ...) so many control periods later."""
        lag, rig = self.actuator.lag, self.regulator.rig
        return predict(x, rotors, u, disturbance, periods * self.control_period, lag, rig)

    def index(self, t: Any) -> Any:
        """Control period of the time t in s."""
        return step_index(t, self.control_period, self.x.shape[1] - 1)


def stretches(pending: tuple[np.ndarray, ...]) -> list[tuple[np.ndarray, int]]:
    """Voltages that are under way as at most PREDICTIONS stretches, and for how many control periods each lasts.

    A stretch of several periods has their mean voltage, for which one Runge-Kutta step is exact enough.
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
    """The feedforward and a regulator with these weights for a helicopter with this actuator.

    `IntegralWeights` give integral action, `ObserverWeights` a Kalman filter.
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
    return ModelPolicy(regulator, observer, actuator, control_period)


def make_regulator(reference: Trajectory, control_period: float, rig: Rig, weights: Weights, lag: float) -> Regulator:
    """Feedforward and gains on the control grid for rotors with this lag in s.

    Against the lag, the feedforward leads: a rotor turns at u(t) if its voltage is u + lag du/dt. With
    `ObserverWeights`, the reference makes up for disturbances.
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
        accommodates=isinstance(weights, ObserverWeights),
        pitch_limits=reference.limits.pitch,
        rig=rig,
    )


def lqi(reference: Trajectory, control_period: float, rig: Rig, weights: IntegralWeights = LQI) -> ModelPolicy:
    """Feedforward and time-varying regulator with integral action on travel and elevation; it assumes no lag."""
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
    """The regulator of `lag_lqr` on the estimates of a Kalman filter that uses the three angles alone.

    The filter also estimates the accelerations that (3) does not explain, and the reference makes up for them.
    """
    return model_policy(reference, control_period, rig, weights, actuator)
