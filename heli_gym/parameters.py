"""Table I and the limits (9) of the paper: immutable values, each number once."""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias

import numpy as np

Scalar: TypeAlias = Any  # a float, or (N,) values that describe N helicopters


class HelicopterParameters(NamedTuple):
    """Table I: the coefficients of the thrust map (2) and of the equations of motion (3), and viscous friction.

    A NamedTuple, because compiled kernels accept it. `_replace` makes a variant.
    """

    k_plus: Scalar = 4.855e-3  # N/V², thrust of a fan that turns forwards
    k_minus: Scalar = -1.503e-3  # N/V², thrust of a fan that turns backwards
    a1: Scalar = -1.1713  # rad/s², weight on elevation, proportional to sin q2
    a2: Scalar = 0.3946  # rad/s², weight on elevation, proportional to cos q2
    a3: Scalar = -0.5326  # rad/s², weight on pitch
    b1: Scalar = -0.6354  # rad/s² per N, thrust sum on travel
    b2: Scalar = -0.6523  # rad/s² per N, thrust sum on elevation
    b3: Scalar = 4.6276  # rad/s² per N, thrust difference on pitch
    c1: Scalar = 0.0  # 1/s, viscous friction of travel; the paper has none, real rigs 0.07 to 0.17
    c2: Scalar = 0.0  # 1/s, viscous friction of elevation
    c3: Scalar = 0.0  # 1/s, viscous friction of pitch


@dataclass(frozen=True)
class Limits:
    """What a planned flight may use: voltages in V and pitch in rad. The defaults are (9).

    Raises ValueError if a limit is not finite, or if the limits contradict each other.
    """

    u_min: float = 1.0
    u_max: float = 11.0
    pitch_min: float = -math.radians(50.0)
    pitch_max: float = math.radians(50.0)

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not math.isfinite(value):
                raise ValueError(f"{name} = {value!r}: must be a finite number")
        if not self.u_min < self.u_max:
            raise ValueError(f"u_min = {self.u_min:g} V and u_max = {self.u_max:g} V: u_min must be less than u_max")
        if not -math.pi / 2 < self.pitch_min < 0.0 < self.pitch_max < math.pi / 2:
            raise ValueError(
                f"pitch_min = {self.pitch_min:g} rad and pitch_max = {self.pitch_max:g} rad: "
                "must be -pi/2 < pitch_min < 0 < pitch_max < pi/2"
            )

    def __str__(self) -> str:
        low, high = np.degrees(self.pitch)
        return f"{self.u_min:g} to {self.u_max:g} V and {low:g} to {high:g} deg of pitch"

    @property
    def u(self) -> tuple[float, float]:
        """The voltage window in V."""
        return self.u_min, self.u_max

    @property
    def pitch(self) -> tuple[float, float]:
        """The pitch window in rad."""
        return self.pitch_min, self.pitch_max


AMPLIFIER_LIMITS = (0.0, 12.0)  # V, what the amplifiers can do; the paper plans within (9) to leave a reserve
PITCH_STOP = math.radians(80.0)  # rad, the widest pitch the paper considers (below (9)): the flight ends there
