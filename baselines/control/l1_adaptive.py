"""L1 adaptive augmentation of the lag-aware regulator: fast disturbance estimates behind a low-pass filter."""

import math
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.estimation import Actuator, nominal_actuator, predict
from heli_gym.baselines.control.model_based import Regulator, make_regulator
from heli_gym.baselines.control.protocol import StatefulPolicy, expand_batch_dims, step_index
from heli_gym.baselines.control.weights import L1, L1Weights
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory


class Memory(NamedTuple):
    """State of an `L1Policy` between control periods."""

    rates: np.ndarray  # (3, ...) predicted; rad/s
    filtered: np.ndarray  # (3, ...) estimated accelerations after the low-pass filter; rad/s²
    rotors: np.ndarray  # (2, ...) simulated rotor speeds, as voltages; V
    pending: tuple[np.ndarray, ...]  # (2, ...) each in V: commands still in the delay line, oldest first
    before: tuple[
        np.ndarray, ...
    ] = ()  # without a delay, before the last period: state, rotors, disturbance, rate errors


@dataclass(eq=False)
class L1Policy(StatefulPolicy):
    """Regulator of `kalman-lqr` on the measured state, with disturbances from the piecewise-constant adaptive law.

    The estimate would cancel the predictor's error within one control period; a low-pass filter removes its high
    frequencies from the control (Xargay, Hovakimyan and Cao, "L1 adaptive controller for multi-input multi-output
    systems in the presence of nonlinear unmatched uncertainties", ACC 2010).
    """

    regulator: Regulator
    actuator: Actuator
    weights: L1Weights
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: Memory | None = field(default=None, init=False, repr=False)

    @property
    def rig(self) -> Rig:
        """Rig that the policy assumes; `fly` checks it."""
        return self.regulator.rig

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.regulator.x

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Memory without a disturbance, with the rotors at the reference's voltages."""
        u = expand_batch_dims(self.regulator.u[:, self.index(t)], measurement) + np.zeros(measurement.shape[1:])
        zero = np.zeros_like(measurement[1::2])
        before = () if self.actuator.delay else (measurement, u, zero, zero)
        return Memory(measurement[1::2], zero, u, (u,) * self.actuator.delay, before)

    def step(self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Memory]:
        dt, c = self.control_period, self.weights
        decay = math.exp(-c.predictor * dt)
        off = memory.rates - measurement[1::2]
        sigma = np.clip(-c.predictor * decay / (1.0 - decay) * off, -c.largest, c.largest)
        filtered = sigma + math.exp(-c.bandwidth * dt) * (memory.filtered - sigma)

        later, rotors = measurement, memory.rotors
        for u in memory.pending:
            later, rotors = self.predict(later, rotors, u, filtered)
        k = np.minimum(self.index(t) + self.actuator.delay, self.reference_states.shape[1] - 1)
        u = self.regulator(k, later, rotors, filtered, None)
        pending = (*memory.pending, np.clip(u, *self.voltage_limits))
        before = () if self.actuator.delay else (measurement, memory.rotors, sigma, decay * off)
        x, rotors = self.predict(measurement, memory.rotors, pending[0], sigma)
        return u, Memory(x[1::2] + decay * off, filtered, rotors, pending[1:], before)

    def with_applied_input(self, memory: Memory, u: np.ndarray) -> Memory:
        """Memory after a step in which the voltages u (2, ...) in V were applied instead of the policy's own."""
        applied = np.clip(u, *self.voltage_limits)
        if self.actuator.delay:
            return memory._replace(pending=(*memory.pending[:-1], applied))
        x, rotors, disturbance, error = memory.before
        x, rotors = self.predict(x, rotors, applied, disturbance)
        return memory._replace(rates=x[1::2] + error, rotors=rotors)

    def predict(self, x: Any, rotors: Any, u: Any, disturbance: Any) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and rotor speeds (2, ...) one control period later."""
        return predict(x, rotors, u, disturbance, self.control_period, self.actuator.lag, self.regulator.rig)

    def index(self, t: Any) -> Any:
        """Index of the control period at the time t in s."""
        return step_index(t, self.control_period, self.reference_states.shape[1] - 1)


def l1_adaptive(reference: Trajectory, control_period: float, rig: Rig, weights: L1Weights = L1) -> L1Policy:
    """Regulator of `kalman-lqr` with L1 estimates of the disturbances."""
    actuator = nominal_actuator(rig, control_period)
    regulator = make_regulator(reference, control_period, rig, weights, actuator.lag)
    return L1Policy(regulator, actuator, weights, control_period, rig.voltage_limits)
