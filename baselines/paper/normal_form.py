"""Sections III-A and III-C: Byrnes-Isidori normal form (10)-(14) and the input constraints (15)-(23).

The outputs are y1 = q2 (elevation) and y2 = q3 (pitch); eta = q1 (travel) is the internal dynamics.
All functions broadcast; angles in rad, accelerations in rad/s², thrusts and virtual inputs in N.
"""

from typing import Any

import numpy as np

from heli_gym.model import thrust
from heli_gym.parameters import HelicopterParameters, Limits


def alpha1(y1: Any, y2: Any, v1: Any, p: HelicopterParameters) -> Any:
    """Equation (11a): second derivative of the elevation."""
    return p.a1 * np.sin(y1) + p.a2 * np.cos(y1) + p.b2 * np.cos(y2) * v1


def alpha2(y1: Any, y2: Any, v2: Any, p: HelicopterParameters) -> Any:
    """Equation (11b): second derivative of the pitch."""
    return p.a3 * np.cos(y1) * np.sin(y2) + p.b3 * v2


def feedforward(y1: Any, y2: Any, ddy1: Any, ddy2: Any, p: HelicopterParameters) -> tuple[Any, Any]:
    """Equation (13): the virtual inputs (v1, v2) that give the outputs these second derivatives."""
    v1 = (ddy1 - p.a1 * np.sin(y1) - p.a2 * np.cos(y1)) / (p.b2 * np.cos(y2))
    v2 = (ddy2 - p.a3 * np.cos(y1) * np.sin(y2)) / p.b3
    return v1, v2


def internal_dynamics(y1: Any, y2: Any, ddy1: Any, p: HelicopterParameters) -> Any:
    """Equation (14a): second derivative of the travel, v1 eliminated from (11c) by (13a)."""
    return p.b1 / p.b2 * np.tan(y2) * (ddy1 - p.a1 * np.sin(y1) - p.a2 * np.cos(y1)) * np.cos(y1)


def thrust_bounds(limits: Limits, p: HelicopterParameters) -> tuple[float, float]:
    """Equations (15), (16): what one fan thrusts at its lowest and at its highest voltage."""
    return float(thrust(limits.u_min, p)), float(thrust(limits.u_max, p))


def v2_bounds(f: tuple[float, float]) -> tuple[float, float]:
    """Equation (18): fixed bounds of the thrust difference, for fans with the thrust bounds f."""
    f_min, f_max = f
    return f_min - f_max, f_max - f_min


def v1_bounds(v2: Any, f: tuple[float, float]) -> tuple[Any, Any]:
    """Equation (20): bounds of the thrust sum at the thrust difference v2."""
    f_min, f_max = f
    return np.maximum(2.0 * f_min - v2, 2.0 * f_min + v2), np.minimum(2.0 * f_max - v2, 2.0 * f_max + v2)


def ddy1_bounds(y1: Any, y2: Any, v2: Any, f: tuple[float, float], p: HelicopterParameters) -> tuple[Any, Any]:
    """Equation (22): bounds of the elevation's second derivative.

    b2 is negative, so the lower bound comes from the upper bound of v1 (misprinted in the paper).
    """
    v1_min, v1_max = v1_bounds(v2, f)
    return alpha1(y1, y2, v1_max, p), alpha1(y1, y2, v1_min, p)


def ddy2_bounds(y1: Any, y2: Any, f: tuple[float, float], p: HelicopterParameters) -> tuple[Any, Any]:
    """Equation (23): bounds of the pitch's second derivative."""
    v2_min, v2_max = v2_bounds(f)
    return alpha2(y1, y2, v2_min, p), alpha2(y1, y2, v2_max, p)
