"""Thrust of a rotor over its voltage: power laws, including (2), and measured points.

Each curve has `thrust`, its exact inverse `voltage`, and `slope`, all for arrays. Curves rise monotonically. The power
law itself is `heli_gym.model.power_thrust`, shared with the compiled kernels.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from heli_gym.model import power_thrust
from heli_gym.parameters import Scalar
from heli_gym.validation import is_number, require, shown

EXPONENTS = (0.5, 2.0)  # identified rigs have 1.72 to 2; (2) has 2, a linear map 1
# Bounds of curves, beyond any laboratory rig.
MOST_VOLTS, MOST_NEWTONS, MOST_POINTS, LEAST_STEP = 1000.0, 1e4, 10_000, 1e-3
MOST_PER_VOLT = 1e4  # N/V^exponent
ITERATIONS = 80  # at most, of bisection when a cubic is inverted; Newton's method takes about six


class PowerCurve(NamedTuple):
    """f = k_plus (u - dead_zone)^exponent forwards, k_minus (-u - dead_zone)^exponent backwards, zero in between.

    Exponent 2 without a dead zone is (2), exponent 1 a linear map.
    """

    k_plus: Scalar  # N/V^exponent, of a fan that turns forwards
    k_minus: Scalar = 0.0  # N/V^exponent, backwards: negative, or zero for a fan that cannot
    exponent: Scalar = 2.0
    dead_zone: Scalar = 0.0  # V

    def thrust(self, u: Any) -> Any:
        """Thrust in N at the voltage u in V."""
        return power_thrust(u, *self)

    def voltage(self, f: Any) -> Any:
        """Voltage in V for the thrust f in N; 0 V for a negative thrust if k_minus = 0."""
        f = np.asarray(f, dtype=float)
        k = np.where(f >= 0.0, self.k_plus, self.k_minus)
        ratio = np.divide(f, k, out=np.zeros(np.broadcast(f, k).shape), where=k != 0.0)
        beyond = (
            np.sqrt(ratio) if np.ndim(self.exponent) == 0 and self.exponent == 2.0 else ratio ** (1 / self.exponent)
        )
        return np.sign(f) * (beyond + np.where(ratio > 0.0, self.dead_zone, 0.0))

    def slope(self, u: Any) -> Any:
        """df/du in N/V at the voltage u in V."""
        u = np.asarray(u, dtype=float)
        beyond = np.maximum(np.abs(u) - self.dead_zone, 0.0)
        k = np.where(u >= 0.0, self.k_plus, -np.asarray(self.k_minus))
        with np.errstate(divide="ignore"):  # below exponent 1, the slope at the end of the dead zone is infinite
            steepness = self.exponent * k * beyond ** (self.exponent - 1.0)
        return np.where((beyond > 0.0) | (self.dead_zone == 0.0), steepness, 0.0)

    def check(self, name: str) -> None:
        """Raise ValueError unless the coefficients give a rising curve, within the bounds of curves."""
        low, high = EXPONENTS
        bounds = {
            "k_plus": (math.ulp(0.0), MOST_PER_VOLT, f"a positive number, at most {MOST_PER_VOLT:g}"),
            "k_minus": (
                -MOST_PER_VOLT,
                0.0,
                f"a negative number, at least {-MOST_PER_VOLT:g}, or 0 without backward thrust",
            ),
            "exponent": (low, high, f"{low:g} to {high:g}"),
            "dead_zone": (0.0, MOST_VOLTS, f"a number of volts, at least 0 and at most {MOST_VOLTS:g}"),
        }
        for field, (least, most, what) in bounds.items():
            value = getattr(self, field)
            require(f"{name}.{field}", value, is_number(value) and least <= value <= most, what)


@dataclass(frozen=True)
class TableCurve:
    """Measured points, interpolated by monotone cubics (PCHIP; Fritsch and Butland, 1984).

    Beyond its ends the curve is extrapolated linearly, with the slope between the last two points.

    Args:
        voltages: (K,) in V, increasing.
        thrusts: (K,) in N, nondecreasing, and increasing at both ends.
    """

    voltages: tuple[float, ...]
    thrusts: tuple[float, ...]

    def __post_init__(self) -> None:
        for name in ("voltages", "thrusts"):
            values = getattr(self, name)
            object.__setattr__(self, name, tuple(values) if isinstance(values, list | np.ndarray) else values)

    @cached_property
    def cubics(self) -> Any:
        """Interpolator between the ends of the curve."""
        from scipy.interpolate import PchipInterpolator  # slow import

        return PchipInterpolator(self.voltages, self.thrusts)

    @cached_property
    def end_slopes(self) -> tuple[float, float]:
        """Slopes in N/V below the first and above the last point."""
        u, f = self.voltages, self.thrusts
        return (f[1] - f[0]) / (u[1] - u[0]), (f[-1] - f[-2]) / (u[-1] - u[-2])

    def thrust(self, u: Any) -> Any:
        """Thrust in N at the voltage u in V."""
        u = np.asarray(u, dtype=float)
        low, high = self.end_slopes
        inside = np.clip(u, self.voltages[0], self.voltages[-1])
        return self.cubics(inside) + low * np.minimum(u - inside, 0.0) + high * np.maximum(u - inside, 0.0)

    def voltage(self, f: Any) -> Any:
        """Voltage in V for the thrust f in N, on the cubics by Newton's method safeguarded by bisection.

        On a level part of the curve, returns 0 V if it belongs to that part, otherwise the lowest voltage.
        """
        f = np.asarray(f, dtype=float)
        us, fs = np.array(self.voltages), np.array(self.thrusts)
        k = np.clip(np.searchsorted(fs, f, side="left") - 1, 0, len(us) - 2)
        c3, c2, c1, c0 = self.cubics.c[:, k]
        target = np.clip(f, fs[0], fs[-1]) - c0
        low, high = np.zeros_like(f), us[k + 1] - us[k]
        rise = fs[k + 1] - fs[k]
        s = high * np.clip(np.divide(target, rise, out=np.zeros_like(f), where=rise > 0.0), 0.0, 1.0)
        for _ in range(ITERATIONS):
            miss = ((c3 * s + c2) * s + c1) * s - target
            low, high = np.where(miss <= 0.0, s, low), np.where(miss >= 0.0, s, high)
            slope = (3.0 * c3 * s + 2.0 * c2) * s + c1
            step = np.divide(miss, slope, out=np.full_like(f, np.inf), where=slope > 0.0)
            new = s - step
            new = np.where((low <= new) & (new <= high), new, 0.5 * (low + high))
            if (np.abs(new - s) <= 4e-16 * (1.0 + np.abs(us[k]))).all():
                break
            s = new
        below, above = self.end_slopes
        u = us[k] + s + np.minimum(f - fs[0], 0.0) / below + np.maximum(f - fs[-1], 0.0) / above
        return np.where(f == self.thrust(0.0), 0.0, u)

    def slope(self, u: Any) -> Any:
        """df/du in N/V at the voltage u in V."""
        u = np.asarray(u, dtype=float)
        low, high = self.end_slopes
        inside = self.cubics(np.clip(u, self.voltages[0], self.voltages[-1]), 1)
        return np.where(u < self.voltages[0], low, np.where(u > self.voltages[-1], high, inside))

    def check(self, name: str) -> None:
        """Raise ValueError unless the points give a rising curve."""
        for field, most in (("voltages", MOST_VOLTS), ("thrusts", MOST_NEWTONS)):
            values = getattr(self, field)
            if not isinstance(values, tuple) or not 2 <= len(values) <= MOST_POINTS:
                raise ValueError(
                    f"{name}.{field} = {shown(values)}: must be as many numbers as voltages, 2 to {MOST_POINTS}"
                )
            for value in values:
                require(f"{name}.{field}", value, is_number(value) and abs(value) <= most, f"within +-{most:g}")
        u, f = np.array(self.voltages, float), np.array(self.thrusts, float)
        if u.shape != f.shape:
            raise ValueError(f"{name}.thrusts = {shown(self.thrusts)}: must be as many numbers as voltages, {len(u)}")
        if not (np.diff(u) >= LEAST_STEP).all():
            raise ValueError(
                f"{name}.voltages = {shown(self.voltages)}: must rise by at least {LEAST_STEP:g} V from point to point"
            )
        if not ((np.diff(f) >= 0.0).all() and min(self.end_slopes) > 0.0):
            raise ValueError(f"{name}.thrusts = {shown(self.thrusts)}: must not fall, and must rise at both ends")


ThrustCurve: TypeAlias = PowerCurve | TableCurve


@dataclass(frozen=True)
class ThrustMap:
    """Thrust curves of the front and the back rotor."""

    front: ThrustCurve
    back: ThrustCurve

    @cached_property
    def is_quadratic(self) -> bool:
        """Whether the map is (2), with the same two coefficients for both rotors."""
        same = self.front == self.back and isinstance(self.front, PowerCurve)
        return same and (self.front.exponent, self.front.dead_zone) == (2.0, 0.0)  # type: ignore[union-attr]

    def check(self, name: str) -> None:
        """Raise ValueError unless both fields are rising curves."""
        for rotor in ("front", "back"):
            curve = getattr(self, rotor)
            if not isinstance(curve, PowerCurve | TableCurve):
                raise ValueError(f"{name}.{rotor} = {curve!r}: must be a PowerCurve or a TableCurve")
            curve.check(f"{name}.{rotor}")
