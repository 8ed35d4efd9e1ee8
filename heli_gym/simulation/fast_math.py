"""Sine, cosine, power and random numbers for the compiled loops, without calls and branches, so that LLVM vectorises.

A call to the C library's sine would prevent that.
"""

import math
from typing import Any

import numpy as np
from numpy import float64, floor, int64

NORMALS_PER_STEP = 256  # largest number per helicopter: three for the sensors, then one per disturbance

TWO_OVER_PI = 2.0 / math.pi
# pi/2 in three parts (Cody and Waite, 1980; values of Moshier's Cephes); k times the first two is exact
HALF_PI_1, HALF_PI_2, HALF_PI_3 = 1.57079625129699707031, 7.54978941586159635335e-8, 5.39030285815811905290e-15
# The minimax polynomials of Cephes (S. Moshier), for |r| up to pi/4.
S1, S2, S3 = -1.66666666666666307295e-1, 8.33333333332211858878e-3, -1.98412698295895385996e-4
S4, S5, S6 = 2.75573136213857245213e-6, -2.50507477628578072866e-8, 1.58962301576546568060e-10
C1, C2, C3 = 4.16666666666665929218e-2, -1.38888888888730564116e-3, 2.48015872888517045348e-5
C4, C5, C6 = -2.75573141792967388112e-7, 2.08757008419747316778e-9, -1.13585365213876817300e-11

MANTISSA, ONE = 2**52 - 1, 1023 << 52  # bits of a float64: its mantissa, and the exponent of 1
LN_2, LOG2_E = math.log(2.0), 1.0 / math.log(2.0)


def sine(x: Any) -> Any:
    """sin x for |x| up to 1e5, exact to two units in the last place."""
    k = floor(x * TWO_OVER_PI + 0.5)
    r = ((x - k * HALF_PI_1) - k * HALF_PI_2) - k * HALF_PI_3
    quadrant = k - 4.0 * floor(0.25 * k)
    is_odd = k - 2.0 * floor(0.5 * k) == 1.0
    value = cosine_polynomial(r) if is_odd else sine_polynomial(r)
    return -value if quadrant >= 2.0 else value


def cosine(x: Any) -> Any:
    """cos x for |x| up to 1e5, exact to two units in the last place."""
    k = floor(x * TWO_OVER_PI + 0.5)
    r = ((x - k * HALF_PI_1) - k * HALF_PI_2) - k * HALF_PI_3
    quadrant = k - 4.0 * floor(0.25 * k)
    is_odd = k - 2.0 * floor(0.5 * k) == 1.0
    value = sine_polynomial(r) if is_odd else cosine_polynomial(r)
    return -value if abs(quadrant - 1.5) < 1.0 else value  # 1 or 2


def sine_polynomial(r: Any) -> Any:
    """sin r for |r| up to pi/4."""
    y = r * r
    return r + r * y * (((((S6 * y + S5) * y + S4) * y + S3) * y + S2) * y + S1)


def cosine_polynomial(r: Any) -> Any:
    """cos r for |r| up to pi/4."""
    y = r * r
    return 1.0 + (y * y * (((((C6 * y + C5) * y + C4) * y + C3) * y + C2) * y + C1) - 0.5 * y)


def power(x: Any, exponent: Any) -> Any:
    """x**exponent for x >= 0 and exponents from 0.1 to 10, exact to 1e-13 relative; 0 for x = 0."""
    bits = float64(x).view(int64)
    m = int64((bits & MANTISSA) | ONE).view(float64)  # x = 2**e m, and m in [1, 2)
    e = float64((bits >> 52) - 1023)
    is_high = m > math.sqrt(2.0)
    m, e = (0.5 * m if is_high else m), (e + 1.0 if is_high else e)
    s = (m - 1.0) / (m + 1.0)  # ln m = 2 artanh s, by its series
    y = s * s
    series = 1.0 + y * (1 / 3 + y * (1 / 5 + y * (1 / 7 + y * (1 / 9 + y * (1 / 11 + y * (1 / 13 + y * (1 / 15)))))))
    high = exponent * e
    k = floor(high + exponent * (2.0 * s * series) * LOG2_E + 0.5)
    r = (high - k) * LN_2 + exponent * (2.0 * s * series)
    tail = 1 / 720 + r * (1 / 5040 + r * (1 / 40320 + r * (1 / 362880 + r * (1 / 3628800 + r * (1 / 39916800)))))
    value = 1.0 + r * (1.0 + r * (1 / 2 + r * (1 / 6 + r * (1 / 24 + r * (1 / 120 + r * tail)))))
    scale = int64((int64(k) + 1023) << 52).view(float64)
    return value * scale if x > 0.0 else 0.0


def standard_normal(key: Any, step: Any, channel: int) -> Any:
    """Standard normal random number, a function of key, step and channel only.

    SplitMix64 (Steele, Lea, Flood, 2014) of a counter gives two uniform numbers, the Box-Muller transform a normal one.
    """
    counter = np.uint64(key * 2.0**53) + np.uint64(0x9E3779B97F4A7C15) * np.uint64(step * NORMALS_PER_STEP + channel)
    z = splitmix64(counter)
    u1 = (np.float64(z >> np.uint64(32)) + 0.5) * 2.0**-32
    u2 = np.float64(z & np.uint64(0xFFFFFFFF)) * 2.0**-32
    return math.sqrt(-2.0 * math.log(u1)) * math.cos(2.0 * math.pi * u2)


def splitmix64(z: Any) -> Any:
    """Output function of SplitMix64 for a 64-bit integer."""
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))
