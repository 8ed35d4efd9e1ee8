"""Section III-D: saturation functions (25)-(37) that include the constraints in the dynamics."""

from typing import Any, NamedTuple

import numpy as np


class Saturation(NamedTuple):
    """Smooth saturation psi1 of (27) at a point xi, with its derivatives."""

    value: Any
    slope: Any  # d psi1 / d xi
    curvature: Any  # d² psi1 / d xi²
    third: Any  # d³ psi1 / d xi³


def psi1(xi: Any, bounds: tuple[float, float]) -> Saturation:
    """Equation (27): smooth, strictly increasing, within its bounds (in rad), with slope 1 at xi = 0.

    The equivalent form psi1 = psi1⁻ + (psi1⁺ - psi1⁻) sigma with sigma = 1 / (1 + exp(-m xi)) does not overflow, and
    its derivatives are polynomials in sigma.
    """
    low, high = bounds
    m = 4.0 / (high - low)
    sigma = 0.5 * (1.0 + np.tanh(0.5 * m * xi))
    slope = 4.0 * sigma * (1.0 - sigma)
    return Saturation(
        value=low + (high - low) * sigma,
        slope=slope,
        curvature=m * slope * (1.0 - 2.0 * sigma),
        third=m**2 * slope * (1.0 - 6.0 * sigma * (1.0 - sigma)),
    )


def psi1_inverse(y: Any, bounds: tuple[float, float]) -> Any:
    """Equation (35): xi with psi1(xi) = y, for y strictly between the bounds."""
    low, high = bounds
    return (high - low) / 4.0 * np.log((y - low) / (high - y))


def ramp(v: Any, bounds: tuple[Any, Any]) -> Any:
    """Equations (34) and (37): psi2 and psi3, the identity between the bounds."""
    low, high = bounds
    return np.minimum(np.maximum(v, low), high)


def psi2_bounds(ddy2_bounds: tuple[Any, Any], saturation: Saturation, xi2: Any) -> tuple[Any, Any]:
    """Equation (33): bounds of d xi2/dt that limit the pitch's second derivative to (23).

    For large |xi| the slope underflows and the bounds are infinite: numpy then warns of a division by zero.
    """
    ddy2_min, ddy2_max = ddy2_bounds
    bend = saturation.curvature * xi2**2
    return (ddy2_min - bend) / saturation.slope, (ddy2_max - bend) / saturation.slope


def ddy2(saturation: Saturation, xi2: Any, dxi2: Any) -> Any:
    """Equation (30): second derivative of y2 = psi1(xi1)."""
    return saturation.curvature * xi2**2 + saturation.slope * dxi2
