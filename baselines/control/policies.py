"""Every controller behind one protocol: policy(t, measurement) -> voltages.

They broadcast: a policy flies one helicopter or N of them, at one time or at N.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple, Protocol

import numpy as np

from heli_gym.baselines.control.discrete_lqr import IntegralWeights, Weights, regulator_gains
from heli_gym.baselines.control.estimation import (
    IDEAL,
    Actuator,
    disturbance_accommodated_reference,
    kalman_gains,
    predict,
    settling_gains,
    settling_periods,
)
from heli_gym.baselines.control.weights import (
    KALMAN_LQR,
    LAG_LQI,
    LAG_LQR,
    LQI,
    TVLQR,
    WEIGHTS,
    ObserverWeights,
    weights_of,
)
from heli_gym.baselines.paper.tvlqr import riccati_gains, stationary_gain
from heli_gym.model import fan_thrusts, hover_input, thrust, virtual_input, voltage
from heli_gym.parameters import AMPLIFIER_LIMITS, HelicopterParameters
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory


class Policy(Protocol):
    """A controller. What it remembers of a flight, `reset` clears."""

    def reset(self, rng: np.random.Generator) -> None:
        """Prepare for a new flight; what is random in it comes from rng."""

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        """Voltages (2, ...) in V to hold from the time t in s on, given measured states (6, ...) in rad and rad/s."""


def expand_batch_dims(column: np.ndarray, measurement: np.ndarray) -> np.ndarray:
    """The column (n,), or columns (n, N), in a shape that broadcasts with a measurement (6, ...)."""
    return column if column.ndim > 1 else column.reshape(-1, *(1,) * (measurement.ndim - 1))


def applied_to(gains: np.ndarray, values: np.ndarray) -> np.ndarray:
    """The gains (m, n), or (m, n, N) of N times, times the values (n, ...)."""
    return gains @ values if gains.ndim == 2 else np.einsum("ijk,jk->ik", gains, values)


def step_index(t: Any, control_period: float, last: int) -> Any:
    """In which control period, of those up to the last, the time t in s is; (N,) for N times."""
    if np.ndim(t):
        return np.minimum(np.round(np.asarray(t) / control_period).astype(int), last)
    return min(round(t / control_period), last)


@dataclass(frozen=True, eq=False)
class TrackingPolicy:
    """The two-degrees-of-freedom scheme of Fig. 3: a feedforward and a state feedback on the tracking error, (51).

    On the control grid, K + 1 times `control_period` s apart: x (6, K + 1), the feedforward's v (2, K + 1) in N and the
    gains (2, 6, K + 1), whose correction is in N too.
    """

    x: np.ndarray
    v: np.ndarray
    gains: np.ndarray
    parameters: HelicopterParameters
    control_period: float

    def reset(self, rng: np.random.Generator) -> None:
        """Nothing to do: this policy remembers nothing."""

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        error = measurement - expand_batch_dims(self.x[:, k], measurement)
        v = expand_batch_dims(self.v[:, k], measurement) - applied_to(self.gains[:, :, k], error)
        return voltage(fan_thrusts(v), self.parameters)


class Memory(NamedTuple):
    """What a `ModelPolicy` remembers from one control period to the next."""

    x: np.ndarray  # (6, ...) state, predicted; rad and rad/s
    disturbance: np.ndarray  # (3, ...) estimated; rad/s²
    rotors: np.ndarray  # (2, ...) simulated; V
    pending: tuple[np.ndarray, ...]  # (2, ...) each, asked for and not yet in effect; V
    integral: np.ndarray  # (2, ...) of the errors of travel and elevation; rad s
    start: Any  # in which control period of the reference the flight began; (N,) where it differs


@dataclass(eq=False)
class ModelPolicy:
    """Fig. 3 with a model that runs along: of the actuator and, where there is a filter, of disturbances.

    On the control grid, K + 1 times `control_period` s apart: x (6, K + 1) and u (2, K + 1), the reference's states and
    voltages; command (2, K + 1), the voltages that an actuator turns into these; regulator (2, n, K + 1), the gains of
    `regulator_gains`; and observer (9, 3, K + 1), those of `kalman_gains` for a flight from the reference's start.
    Without these, the measured state is used as it is. A flight that begins in some later period uses, while the filter
    settles, settling(period) (9, 3, J) instead. The feedback acts on the state that is predicted for the time when the
    voltages take effect.
    """

    x: np.ndarray
    u: np.ndarray
    command: np.ndarray
    regulator: np.ndarray
    observer: np.ndarray | None
    settling: Callable[[int], np.ndarray] | None
    integrating: bool
    actuator: Actuator
    pitch_limits: tuple[float, float]
    parameters: HelicopterParameters
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)
    known: dict[int, np.ndarray] = field(default_factory=dict, init=False, repr=False)

    def reset(self, rng: np.random.Generator) -> None:
        """Forget the last flight; nothing is random."""
        self.memory = None

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        measurement = np.asarray(measurement, dtype=float)
        last = self.x.shape[1] - 1
        now = step_index(t, self.control_period, last)
        memory = self.memory or self.init(now, measurement)

        x, disturbance = self.estimate(memory, now, measurement)
        later, rotors = x, memory.rotors
        for u in memory.pending:
            later, rotors = self.predict(later, rotors, u, disturbance)
        u = self.control(np.minimum(now + self.actuator.delay, last), later, rotors, disturbance, memory.integral)

        applied = np.clip(u, *self.voltage_limits)
        pending = (*memory.pending, applied)
        error = (x - expand_batch_dims(self.x[:, now], x))[[0, 2]]
        # Anti-windup: nothing is integrated while the amplifier saturates.
        integral = memory.integral + self.control_period * error * (u == applied).all(axis=0)
        x, rotors = self.predict(x, memory.rotors, pending[0], disturbance)
        self.memory = Memory(x, disturbance, rotors, pending[1:], integral, memory.start)
        return u

    def set_applied_input(self, u: np.ndarray) -> None:
        """Tells what voltages (2, ...) were asked for after all, in place of those that were given last."""
        if self.memory is None:
            raise ValueError("replace_last: comes after voltages that were given")
        if not self.memory.pending:
            if self.actuator.lag or self.observer is not None:
                raise ValueError("replace_last: without a delay, the voltages given last have already been simulated")
            return  # nothing is simulated with them
        pending = (*self.memory.pending[:-1], np.clip(u, *self.voltage_limits))
        self.memory = self.memory._replace(pending=pending)

    def init(self, now: Any, measurement: np.ndarray) -> Memory:
        """At the first call: the reference, which is what a filter begins with, the rotors turning at its voltages."""
        batch = measurement.shape[1:]
        x, u = (expand_batch_dims(start[:, now], measurement) + np.zeros(batch) for start in (self.x, self.u))
        return Memory(x, np.zeros((3, *batch)), u, (u,) * self.actuator.delay, np.zeros((2, *batch)), now)

    def estimate(self, memory: Memory, now: Any, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and disturbance (3, ...)."""
        if self.observer is None:
            return measurement, memory.disturbance
        correction = applied_to(self.observer_gains(now, memory.start), (measurement - memory.x)[0::2])
        return memory.x + correction[:6], memory.disturbance + correction[6:]

    def observer_gains(self, now: Any, start: Any) -> np.ndarray:
        """Gains (9, 3), or (9, 3, N) of N times, in this period of flights that began in others."""
        assert self.observer is not None
        settles = (start > 0) & (now - start < settling_periods(self.control_period))
        if np.ndim(now) == 0:
            return self.first_gains(start)[:, :, now - start] if settles else self.observer[:, :, now]
        gains = self.observer[:, :, now]
        for i in np.flatnonzero(settles):
            gains[:, :, i] = self.first_gains(int(start[i]))[:, :, now[i] - start[i]]
        return gains

    def first_gains(self, start: int) -> np.ndarray:
        """`settling`, computed once."""
        assert self.settling is not None
        if start not in self.known:
            self.known[start] = self.settling(start)
        return self.known[start]

    def predict(self, x: Any, rotors: Any, u: Any, disturbance: Any) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and rotor speeds (2, ...) a control period later."""
        return predict(x, rotors, u, disturbance, self.control_period, self.actuator.lag, self.parameters)

    def control(self, k: Any, x: Any, rotors: Any, disturbance: Any, integral: Any) -> np.ndarray:
        """Voltages (2, ...) for the k-th period, before the amplifier limits them."""
        p = self.parameters
        v, v_ref, v_command = (
            np.stack(virtual_input(thrust(voltages, p)))
            for voltages in (rotors, expand_batch_dims(self.u[:, k], x), expand_batch_dims(self.command[:, k], x))
        )
        x_ref, v_hold = expand_batch_dims(self.x[:, k], x), v_ref
        if self.observer is not None:
            x_ref, v_hold = disturbance_accommodated_reference(x_ref, v_ref, disturbance, self.pitch_limits, p)
        deviations = [x - x_ref]
        if self.actuator.lag:
            deviations.append(v - v_hold)
        if self.integrating:
            deviations.append(integral)
        v = v_command + (v_hold - v_ref) - applied_to(self.regulator[:, :, k], np.concatenate(deviations))
        return voltage(fan_thrusts(v), p)


@dataclass(frozen=True)
class ConstantVoltage:
    """The same voltage in V at both fans, whatever happens."""

    u: float

    def reset(self, rng: np.random.Generator) -> None:
        """Nothing to do: this policy remembers nothing."""

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        return np.full((2, *np.shape(measurement)[1:]), self.u)


def open_loop(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> TrackingPolicy:
    """The feedforward alone."""
    x, u = control_grid(reference, control_period)
    v = np.stack(virtual_input(thrust(u, parameters)))
    return TrackingPolicy(x, v, np.zeros((2, *x.shape)), parameters, control_period)


def feedforward_tvlqr(
    reference: Trajectory, control_period: float, parameters: HelicopterParameters, weights: Weights = TVLQR
) -> TrackingPolicy:
    """The paper's controller: the feedforward of Section III-D and the time-varying regulator of Section III-E."""
    feedforward = open_loop(reference, control_period, parameters)
    times = control_period * np.arange(feedforward.x.shape[1])
    gains = riccati_gains(reference, parameters, weights.Q, weights.R)(times)
    return TrackingPolicy(feedforward.x, feedforward.v, gains, parameters, control_period)


def hover_lqr(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> TrackingPolicy:
    """A stationary regulator about hover at the goal that follows the reference's states without any feedforward."""
    x, _ = control_grid(reference, control_period)
    elevation = float(reference.x[2, -1])
    v = np.repeat(hover_input(elevation, parameters)[:, None], x.shape[1], axis=1)
    gains = np.repeat(stationary_gain(elevation, parameters)[:, :, None], x.shape[1], axis=2)
    return TrackingPolicy(x, v, gains, parameters, control_period)


def model_policy(
    reference: Trajectory,
    control_period: float,
    parameters: HelicopterParameters,
    weights: Weights,
    actuator: Actuator,
) -> ModelPolicy:
    """The feedforward and a regulator with these weights for a helicopter with this actuator.

    Against the lag, the feedforward leads: a rotor turns at u(t) if its voltage is u + lag du/dt. `IntegralWeights`
    give integral action, `ObserverWeights` a Kalman filter.
    """
    x, middle = control_grid(reference, control_period)
    times = control_period * np.arange(x.shape[1] + 1)
    _, u = reference(times)
    command = middle + actuator.lag * np.diff(u, axis=1) / control_period
    u = u[:, :-1]
    v = np.stack(virtual_input(thrust(u, parameters)))
    regulator = regulator_gains(x, v, control_period, parameters, weights, actuator.lag)
    observer = settling = None
    if isinstance(weights, ObserverWeights):
        observer = kalman_gains(x, v, control_period, parameters, weights.noise)
        settling = partial(settling_gains, x, v, control_period, parameters, weights.noise)
    return ModelPolicy(
        x=x,
        u=u,
        command=command,
        regulator=regulator,
        observer=observer,
        settling=settling,
        integrating=isinstance(weights, IntegralWeights),
        actuator=actuator,
        pitch_limits=reference.limits.pitch,
        parameters=parameters,
        control_period=control_period,
    )


def lqi(
    reference: Trajectory, control_period: float, parameters: HelicopterParameters, weights: IntegralWeights = LQI
) -> ModelPolicy:
    """Feedforward and time-varying regulator with integral action on travel and elevation; it knows of no lag."""
    return model_policy(reference, control_period, parameters, weights, IDEAL)


def lag_lqr(
    reference: Trajectory,
    control_period: float,
    parameters: HelicopterParameters,
    weights: Weights = LAG_LQR,
    actuator: Actuator = Actuator(),
) -> ModelPolicy:
    """The regulator for the helicopter with a rotor lag and a delay, both nominal."""
    return model_policy(reference, control_period, parameters, weights, actuator)


def lag_lqi(
    reference: Trajectory,
    control_period: float,
    parameters: HelicopterParameters,
    weights: IntegralWeights = LAG_LQI,
    actuator: Actuator = Actuator(),
) -> ModelPolicy:
    """The same with integral action on travel and elevation."""
    return model_policy(reference, control_period, parameters, weights, actuator)


def kalman_lqr(
    reference: Trajectory,
    control_period: float,
    parameters: HelicopterParameters,
    weights: ObserverWeights = KALMAN_LQR,
    actuator: Actuator = Actuator(),
) -> ModelPolicy:
    """The same regulator as `lag_lqr` on the estimates of a Kalman filter, which sees the angles alone.

    The filter also estimates the accelerations that (3) does not explain, and the reference makes up for them.
    """
    return model_policy(reference, control_period, parameters, weights, actuator)


def zero(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> ConstantVoltage:
    """Motors off."""
    return ConstantVoltage(0.0)


def middle_voltage(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> ConstantVoltage:
    """What an agent that flies alone starts from: the middle of the amplifier's range."""
    return ConstantVoltage(0.5 * sum(AMPLIFIER_LIMITS))


def residual(
    reference: Trajectory, control_period: float, parameters: HelicopterParameters, name: str = "lab"
) -> Policy:
    """The learned correction that comes with the package, trained on the plant of this name."""
    from heli_gym.baselines.control.residual import LEARNED, learned_policy

    return learned_policy(LEARNED / name, reference, control_period, parameters)


POLICIES: dict[str, Callable[..., Policy]] = {
    "open-loop": open_loop,
    "feedforward+tvlqr": feedforward_tvlqr,
    "lqi": lqi,
    "lag-lqr": lag_lqr,
    "lag-lqi": lag_lqi,
    "kalman-lqr": kalman_lqr,
    "residual": residual,
    "residual-rigid": partial(residual, name="rigid"),
    "hover-lqr": hover_lqr,
    "middle-voltage": middle_voltage,
    "zero": zero,
}


def is_learned(name: str) -> bool:
    """Whether the policy of this name was learned, and so flies at the control period of its training only."""
    return name.startswith("residual") or name.endswith(".json")


def make_policy(
    name: str,
    reference: Trajectory,
    control_period: float = 0.02,
    parameters: HelicopterParameters = HelicopterParameters(),
    weights: Weights | None = None,
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS,
) -> Policy:
    """A policy by its name, for a reference, a control period in s, and the parameters and V that it is to believe in.

    A name that ends in .json is the path of a learned policy; see the module `residual`. The weights are those in
    `WEIGHTS`, unless others of the same type are given; "lqi@lab", say, has those that `heli-tune --store` stored for
    the plant lab.

    Raises ValueError for an unknown name, or for weights that the policy does not have.
    """
    if str(name).endswith(".json") and weights is None:
        from heli_gym.baselines.control.residual import learned_policy

        policy: Policy = learned_policy(name, reference, control_period, parameters)
    else:
        kind, _, plant = str(name).partition("@")
        if kind not in POLICIES or (plant and kind not in WEIGHTS):
            known = ", ".join(map(repr, POLICIES))
            raise ValueError(f"name = {name!r}: must be one of {known}, or the path of a learned policy, .json")
        if weights is None and plant:
            weights = weights_of(name)
        if weights is not None and type(weights) is not type(WEIGHTS.get(kind)):
            needed = type(WEIGHTS[kind]).__name__ if kind in WEIGHTS else "nothing, for it has no weights,"
            raise ValueError(f"weights = {weights!r}: must be {needed} for {name!r}")
        policy = POLICIES[kind](reference, control_period, parameters, *([] if weights is None else [weights]))
    parts: tuple[Any, ...] = policy, getattr(policy, "base", None)
    for part in parts:
        if hasattr(part, "voltage_limits"):
            part.voltage_limits = voltage_limits
    return policy
