"""Policies with constant voltages: lower bounds for comparisons."""

from dataclasses import dataclass

import numpy as np

from heli_gym.baselines.control.protocol import MemorylessPolicy
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory


@dataclass(frozen=True)
class ConstantVoltage(MemorylessPolicy):
    """Policy with the constant voltage u in V on both fans."""

    u: float

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        return np.full((2, *np.shape(measurement)[1:]), self.u)


@dataclass
class MiddleVoltage(MemorylessPolicy):
    """Policy with the middle of the amplifier's range on both fans, where an untrained agent starts."""

    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        return np.full((2, *np.shape(measurement)[1:]), 0.5 * sum(self.voltage_limits))


def zero(reference: Trajectory, control_period: float, rig: Rig) -> ConstantVoltage:
    """Policy with the motors off."""
    return ConstantVoltage(0.0)


def middle_voltage(reference: Trajectory, control_period: float, rig: Rig) -> MiddleVoltage:
    """Policy with the middle of the rig's voltage range."""
    return MiddleVoltage(rig.voltage_limits)
