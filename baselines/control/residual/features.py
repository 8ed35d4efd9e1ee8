"""Signals that the network of a learned correction receives, and their scales."""

import math
from typing import Any

import numpy as np

AHEAD = (0.0, 0.2, 0.4, 0.8)  # s, previews of the reference
BEFORE = (0.1, 0.2, 0.4)  # s, ages of past errors and corrections
FEATURE_GROUPS = {
    "error": "of all six states, in tolerances",
    "integral": "of the errors of travel and elevation",
    "voltages": "of the base policy, nominal, and the last correction",
    "estimate": "of the disturbances and the rotor speeds, by the base policy, where it is a `ModelPolicy`",
    "preview": "of the reference, now and ahead",
    "past": "errors of the angles, and corrections",
}
STATE_SCALE = np.array([math.pi, 1.0, 0.2, 0.5, 1.0, 2.0])  # rad and rad/s, scales of the previewed reference
DISTURBANCE_SCALE, INTEGRAL_SCALE, FEATURE_CLIP = 0.2, 0.1, 5.0  # rad/s², rad s, bound of all features


def normalise_voltage(u: Any, voltage_limits: tuple[float, float]) -> Any:
    """Map voltages u in V to [-1, 1] over the amplifier's range."""
    low, high = voltage_limits
    return (u - 0.5 * (low + high)) / (0.5 * (high - low))
