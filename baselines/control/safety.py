"""Predictive safety filter around any policy: minimal change of its voltages for a pitch within limits.

The policy "NAME+safe" is the policy NAME behind this filter.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.estimation import Actuator, nominal_actuator, predict, rotor_response
from heli_gym.baselines.control.protocol import Policy, StatefulPolicy, expand_batch_dims, step_index
from heli_gym.model import dynamics, fan_thrusts, virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

BRAKING = 0.8  # share of one fan's greatest pitch acceleration that the barrier assumes
CONVERGENCE = 10.0  # 1/s, rate of convergence to the barrier
MARGIN = 0.1  # rad, distance of the barrier from the limit, for errors of model and encoders
ROUNDING = 0.1  # rad/s, rounding of the barrier's corner at zero distance


class Memory(NamedTuple):
    """State of a `SafetyFilter` between control periods."""

    base: Any  # memory of the policy if it is a `StatefulPolicy`
    rotors: np.ndarray  # (2, ...) simulated rotor speeds, as voltages in V
    pending: tuple[np.ndarray, ...]  # (2, ...) each in V: commands still in the delay line, oldest first
    before: np.ndarray | None = None  # without a delay: rotor speeds (2, ...) before the last period


@dataclass(eq=False)
class SafetyFilter(StatefulPolicy):
    """Policy behind control barrier functions of the pitch, which limit its thrust difference.

    The barrier is the braking distance: at a distance d from a limit, the rate towards it is at most sqrt(2 A d), where
    A is an acceleration within the reach of one fan. The rate approaches this bound at most with the rate constant
    CONVERGENCE (Ames et al., "Control barrier functions: theory and applications", ECC 2019). Equation (3c) is affine
    in the thrust difference, which gives the quadratic program a closed-form solution: clip the thrust difference and
    change the thrust sum only as far as the fans require. Pitch and pitch rate are predicted over delay and lag.

    Args:
        base: policy to filter.
        x: reference states (6, K + 1) on the control grid; `fly` checks them.
        u: reference voltages (2, K + 1) in V: the first rotor speeds.
        pitch_limits: (min, max) in rad to enforce.
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
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the memory of the last flight, also the policy's."""
        super().reset(rng)
        self.base.reset(rng)

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Memory with the rotors at the reference's voltages."""
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        u = expand_batch_dims(self.u[:, k], measurement) + np.zeros(measurement.shape[1:])
        base = self.base.init(t, measurement) if isinstance(self.base, StatefulPolicy) else None
        return Memory(base, u, (u,) * self.actuator.delay, None if self.actuator.delay else u)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        if isinstance(self.base, StatefulPolicy):
            u, base = self.base.step(memory.base, t, measurement)
        else:
            u, base = self.base(t, measurement), None
        later, rotors = measurement, memory.rotors
        for applied in memory.pending:
            later, rotors = self.predict(later, rotors, applied)
        u = self.filter_voltages(later, rotors, np.clip(u, *self.voltage_limits))
        if base is not None and hasattr(self.base, "with_applied_input"):
            base = self.base.with_applied_input(base, u)
        pending = (*memory.pending, u)
        _, rotors = self.predict(measurement, memory.rotors, pending[0])
        return u, Memory(base, rotors, pending[1:], None if self.actuator.delay else memory.rotors)

    def with_applied_input(self, memory: Memory, u: np.ndarray) -> Memory:
        """Memory after a step in which the voltages u (2, ...) in V were applied instead of the filter's own."""
        applied, base = np.clip(u, *self.voltage_limits), memory.base
        if base is not None and hasattr(self.base, "with_applied_input"):
            base = self.base.with_applied_input(base, u)
        if self.actuator.delay:
            return memory._replace(base=base, pending=(*memory.pending[:-1], applied))
        rotors = rotor_response(memory.before, applied, self.actuator.lag, self.control_period)
        return memory._replace(base=base, rotors=rotors)

    def filter_voltages(self, x: np.ndarray, rotors: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Voltages (2, ...) in V within the barriers at states x (6, ...), closest to u in thrust difference."""
        p, lag = self.rig.parameters, self.actuator.lag
        v1, v2 = virtual_input(self.rig.thrust(u))
        at_zero, at_one, now = (
            dynamics(x, v, p)[5] for v in ((v1, 0.0), (v1, 1.0), virtual_input(self.rig.thrust(rotors)))
        )
        slope = at_one - at_zero
        pitch, rate = x[4] + lag * x[5], x[5] + lag * now
        low_voltage, high_voltage = self.voltage_limits
        weakest = float(self.rig.thrust(np.full(2, low_voltage)).max())
        strongest = float(self.rig.thrust(np.full(2, high_voltage)).min())
        braking = BRAKING * np.abs(slope) * strongest
        low, high = self.pitch_limits
        most = greatest_acceleration(high - MARGIN - pitch, rate, braking)
        least = -greatest_acceleration(pitch - low - MARGIN, -rate, braking)
        bounds = np.sort([(least - at_zero) / slope, (most - at_zero) / slope], axis=0)
        difference = np.clip(v2, bounds[0], bounds[1])
        size = np.abs(difference)
        total = np.maximum(np.minimum(v1, 2.0 * strongest - size), size + 2.0 * weakest)
        limited = np.clip(self.rig.voltage(fan_thrusts((total, difference))), *self.voltage_limits)
        return np.where(difference == v2, u, limited)

    def predict(self, x: Any, rotors: Any, u: Any) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and rotor speeds (2, ...) one control period later."""
        return predict(x, rotors, u, np.zeros(3), self.control_period, self.actuator.lag, self.rig)


def greatest_acceleration(distance: np.ndarray, rate: np.ndarray, braking: np.ndarray) -> np.ndarray:
    """Greatest acceleration in rad/s² towards a limit within the barrier, at a distance in rad and a rate in rad/s."""
    root = np.sqrt(2.0 * braking * np.maximum(distance, 0.0) + ROUNDING**2)
    allowed = root - ROUNDING + CONVERGENCE * np.minimum(distance, 0.0)
    return CONVERGENCE * (allowed - rate) - braking * rate / root


def safety_filter(base: Policy, reference: Trajectory, control_period: float, rig: Rig) -> SafetyFilter:
    """Safety filter around a policy, with the rig's pitch stops as limits."""
    x, u = control_grid(reference, control_period)
    limits = -rig.pitch_limit, rig.pitch_limit
    actuator = nominal_actuator(rig, control_period)
    return SafetyFilter(base, x, u, rig, actuator, limits, control_period, rig.voltage_limits)
