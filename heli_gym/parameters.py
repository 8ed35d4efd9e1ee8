"""Table I and the limits (9) of the paper: immutable values, each number once."""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from heli_gym.validation import is_number, shown

Scalar: TypeAlias = Any  # a float, or (N,) values that describe N helicopters


class HelicopterParameters(NamedTuple):
    """Coefficients of the thrust map (2), of the equations of motion (3), as in Table I, and of viscous friction.

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
    c1: Scalar = 0.0  # 1/s, viscous friction of travel; the paper has none, identified rigs 0.05 to 0.13
    c2: Scalar = 0.0  # 1/s, viscous friction of elevation
    c3: Scalar = 0.0  # 1/s, viscous friction of pitch


class Coupling(NamedTuple):
    """Moments that (3) neglects and measured flights show; see `plant.with_coupling`. By default there are none."""

    centrifugal: Scalar = 0.0  # share of the arm's centrifugal and Coriolis moments; 1 if all mass is along the arm
    centre: Scalar = 0.0  # rad, elevation at which the centrifugal moment vanishes
    spin: Scalar = 0.0  # share of the body's centrifugal moment on pitch; 1 if all its mass is at the rotors
    gyro: Scalar = 0.0  # 1/s, gyroscopic moment on pitch of rotors with one sense of rotation
    airflow: Scalar = 0.0  # 1/rad, pitch acceleration per signed square of the travel rate


NO_COUPLING = Coupling()

PATH_LIMITS = {  # the optional fields of Limits, and their units in words
    "elevation_min": "deg",
    "elevation_max": "deg",
    "travel_rate": "deg/s",
    "elevation_rate": "deg/s",
    "slew": "",
}


LEAST_PITCH = 1e-4  # rad, of the pitch window at either side
LEAST_WINDOW = 1e-3  # V, of the voltage window


@dataclass(frozen=True)
class Limits:
    """Limits of a planned flight: voltages and pitch, (9) by default, and optional further limits.

    Args:
        u_min: least voltage in V.
        u_max: greatest voltage in V.
        pitch_min: least pitch in rad.
        pitch_max: greatest pitch in rad.
        elevation_min: least elevation in rad, positive down: the highest position.
        elevation_max: greatest elevation in rad, positive down: the lowest position.
        travel_rate: greatest travel rate in rad/s, in both directions.
        elevation_rate: greatest elevation rate in rad/s, in both directions.
        slew: greatest rate of change of a voltage in V/s.

    Raises ValueError if a limit is not finite, or if the limits contradict each other.
    """

    u_min: float = 1.0
    u_max: float = 11.0
    pitch_min: float = -math.radians(50.0)
    pitch_max: float = math.radians(50.0)
    elevation_min: float | None = None
    elevation_max: float | None = None
    travel_rate: float | None = None
    elevation_rate: float | None = None
    slew: float | None = None

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            required = name in ("u_min", "u_max", "pitch_min", "pitch_max")
            if not (is_number(value) or (value is None and not required)):
                raise ValueError(f"{name} = {shown(value)}: must be a finite number")
        for name in ("travel_rate", "elevation_rate", "slew"):
            value = getattr(self, name)
            if value is not None and not value > 0.0:
                raise ValueError(f"{name} = {value!r}: must be positive")
        low, high = self.elevation_min, self.elevation_max
        if low is not None and high is not None and not low < high:
            raise ValueError(
                f"elevation_min = {low:g} rad and elevation_max = {high:g} rad: elevation_min must be less than "
                "elevation_max"
            )
        if not self.u_max - self.u_min >= LEAST_WINDOW:
            raise ValueError(
                f"u_min = {self.u_min:g} V and u_max = {self.u_max:g} V: u_min must be less than u_max, by at least "
                f"{LEAST_WINDOW:g} V"
            )
        if not (-math.pi / 2 < self.pitch_min <= -LEAST_PITCH and LEAST_PITCH <= self.pitch_max < math.pi / 2):
            raise ValueError(
                f"pitch_min = {self.pitch_min:g} rad and pitch_max = {self.pitch_max:g} rad: "
                f"must be -pi/2 < pitch_min < 0 < pitch_max < pi/2, both at least {LEAST_PITCH:g} rad from zero"
            )

    def __str__(self) -> str:
        low, high = np.degrees(self.pitch)
        more = [
            f"{name.replace('_', ' ')} {math.degrees(value) if unit else value:g} {unit or 'V/s'}"
            for name, unit in PATH_LIMITS.items()
            if (value := getattr(self, name)) is not None
        ]
        return ", ".join([f"{self.u_min:g} to {self.u_max:g} V and {low:g} to {high:g} deg of pitch", *more])

    @property
    def u(self) -> tuple[float, float]:
        """The voltage window in V."""
        return self.u_min, self.u_max

    @property
    def pitch(self) -> tuple[float, float]:
        """The pitch window in rad."""
        return self.pitch_min, self.pitch_max


AMPLIFIER_LIMITS = (0.0, 12.0)  # V, output range of the amplifiers; the paper plans within (9) to leave a reserve
PITCH_STOP = math.radians(80.0)  # rad, the largest pitch that the paper considers (below (9)): the flight ends there
