"""Policies that ignore the measurement: constant voltages, as floors of comparisons."""

from dataclasses import dataclass

import numpy as np

from heli_gym.baselines.control.protocol import MemorylessPolicy
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory


@dataclass(frozen=True)
class ConstantVoltage(MemorylessPolicy):
    """The same voltage in V at both fans at all times."""

    u: float

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        return np.full((2, *np.shape(measurement)[1:]), self.u)


@dataclass
class MiddleVoltage(MemorylessPolicy):
    """The middle of the amplifier's range at both fans, where an untrained agent starts."""

    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        return np.full((2, *np.shape(measurement)[1:]), 0.5 * sum(self.voltage_limits))


def zero(reference: Trajectory, control_period: float, rig: Rig) -> ConstantVoltage:
    """Motors off."""
    return ConstantVoltage(0.0)


def middle_voltage(reference: Trajectory, control_period: float, rig: Rig) -> MiddleVoltage:
    """The middle of the amplifier's range."""
    return MiddleVoltage(rig.voltage_limits)
