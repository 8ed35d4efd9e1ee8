"""Predictive safety filter around any policy: the least change of its voltages that keeps the pitch within limits.

A policy named "NAME+safe" is the policy NAME behind this filter.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.estimation import Actuator, nominal_actuator, predict
from heli_gym.baselines.control.protocol import Policy, StatefulPolicy, expand_batch_dims, step_index
from heli_gym.model import dynamics, fan_thrusts, virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

BRAKING = 0.8  # share of the greatest pitch acceleration of one fan that the barrier counts on
CONVERGENCE = 10.0  # 1/s, at which a rate may approach the barrier
MARGIN = 0.1  # rad, of the barrier from the limit, for model errors and encoders
ROUNDING = 0.1  # rad/s, by which the barrier is rounded where the margin is used up


class Memory(NamedTuple):
    """State of a `SafetyFilter` between control periods."""

    base: Any  # memory of the policy, where it is a `StatefulPolicy`
    rotors: np.ndarray  # (2, ...) simulated rotor speeds, as voltages; V
    pending: tuple[np.ndarray, ...]  # (2, ...) each, commanded and not yet in effect; V


@dataclass(eq=False)
class SafetyFilter(StatefulPolicy):
    """A policy whose thrust difference is limited by control barrier functions of the pitch.

    The barrier is the braking distance: a rate towards a limit at the distance d is at most sqrt(2 A d), with an
    acceleration A that one fan can surely give, and approaches that no faster than at the rate CONVERGENCE (Ames et
    al., "Control barrier functions: theory and applications", ECC 2019). (3c) is affine in the thrust difference, so
    that the quadratic program has a closed solution: clip the thrust difference, and change the thrust sum no more than
    the fans make necessary. Delay and lag are led: the pitch and its rate are those when the voltages have become
    thrust.

    Args:
        base: policy that is filtered.
        x: states (6, K + 1) of the reference on the control grid, for the first rotor speeds and for `fly`.
        u: voltages (2, K + 1) of the reference.
        pitch_limits: rad, that are kept.
    """

    base: Policy
    x: np.ndarray
    u: np.ndarray
    rig: Rig
    actuator: Actuator
    pitch_limits: tuple[float, float]
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)

    @property
    def reference_states(self) -> np.ndarray:
        """States (6, K + 1) of the reference on the control grid, which `fly` checks."""
        return self.x

    def reset(self, rng: np.random.Generator) -> None:
        """Forget the last flight."""
        super().reset(rng)
        self.base.reset(rng)

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Rotors at the reference's voltages."""
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        u = expand_batch_dims(self.u[:, k], measurement) + np.zeros(measurement.shape[1:])
        base = self.base.init(t, measurement) if isinstance(self.base, StatefulPolicy) else None
        return Memory(base, u, (u,) * self.actuator.delay)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        if isinstance(self.base, StatefulPolicy):
            u, base = self.base.step(memory.base, t, measurement)
        else:
            u, base = self.base(t, measurement), None
        later, rotors = measurement, memory.rotors
        for applied in memory.pending:
            later, rotors = self.predict(later, rotors, applied)
        u = self.filtered(later, rotors, np.clip(u, *self.voltage_limits))
        if base is not None and hasattr(self.base, "with_applied_input"):
            base = self.base.with_applied_input(base, u)
        pending = (*memory.pending, u)
        _, rotors = self.predict(measurement, memory.rotors, pending[0])
        return u, Memory(base, rotors, pending[1:])

    def filtered(self, x: np.ndarray, rotors: np.ndarray, u: np.ndarray) -> np.ndarray:
        """The voltages closest to u (2, ...), by the thrust difference, that keep the barriers at states x (6, ...)."""
        p, lag = self.rig.parameters, self.actuator.lag
        v1, v2 = virtual_input(self.rig.thrust(u))
        at_zero, at_one, now = (
            dynamics(x, v, p)[5] for v in ((v1, 0.0), (v1, 1.0), virtual_input(self.rig.thrust(rotors)))
        )
        slope = at_one - at_zero
        pitch, rate = x[4] + lag * x[5], x[5] + lag * now
        strongest = float(self.rig.thrust(np.full(2, self.voltage_limits[1])).min())
        braking = BRAKING * np.abs(slope) * strongest
        low, high = self.pitch_limits
        most = greatest_acceleration(high - MARGIN - pitch, rate, braking)
        least = -greatest_acceleration(pitch - low - MARGIN, -rate, braking)
        bounds = np.sort([(least - at_zero) / slope, (most - at_zero) / slope], axis=0)
        kept = np.clip(v2, bounds[0], bounds[1])
        total = np.maximum(np.minimum(v1, 2.0 * strongest - np.abs(kept)), np.abs(kept))
        limited = np.clip(self.rig.voltage(fan_thrusts((total, kept))), *self.voltage_limits)
        return np.where(kept == v2, u, limited)

    def predict(self, x: Any, rotors: Any, u: Any) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and rotor speeds (2, ...) a control period later."""
        return predict(x, rotors, u, np.zeros(3), self.control_period, self.actuator.lag, self.rig)


def greatest_acceleration(distance: np.ndarray, rate: np.ndarray, braking: np.ndarray) -> np.ndarray:
    """Acceleration towards a limit, at this distance in rad and rate in rad/s, that keeps the barrier, in rad/s²."""
    root = np.sqrt(2.0 * braking * np.maximum(distance, 0.0) + ROUNDING**2)
    allowed = root - ROUNDING + CONVERGENCE * np.minimum(distance, 0.0)
    return CONVERGENCE * (allowed - rate) - braking * rate / root


def safety_filter(base: Policy, reference: Trajectory, control_period: float, rig: Rig) -> SafetyFilter:
    """A filter around a policy that keeps the pitch away from where the flight ends, `rig.pitch_limit`."""
    x, u = control_grid(reference, control_period)
    limits = -rig.pitch_limit, rig.pitch_limit
    actuator = nominal_actuator(rig, control_period)
    return SafetyFilter(base, x, u, rig, actuator, limits, control_period, rig.voltage_limits)
