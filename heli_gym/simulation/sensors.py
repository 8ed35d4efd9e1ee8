"""Encoders in loops over the helicopters of a block; see `plant.Sensors`."""

from typing import Any

from numpy import floor

from heli_gym.plant import quantise
from heli_gym.simulation.fast_math import standard_normal
from heli_gym.simulation.layout import (
    COUNTS,
    KEY,
    MEASURED,
    NOISE,
    ON_ANGLES,
    RATE_DECAY,
    ROW,
    STEP,
    ZEROS,
    Settings,
    X,
)


def make_noise(block: Any, n: int, step: int) -> None:
    """Draw the noise of the three angles, `step` control periods after the current one."""
    for axis in range(3):
        for i in range(n):
            normal = standard_normal(block[KEY * ROW + i], block[STEP * ROW + i] + step, axis)
            block[(ON_ANGLES + axis) * ROW + i] = block[NOISE * ROW + i] * normal


def measure(block: Any, n: int, s: Settings) -> None:
    """Measure the angles, and update the rate estimates from them."""
    for axis in range(3):
        for i in range(n):
            true_angle, zero = block[(X + 2 * axis) * ROW + i], block[(ZEROS + axis) * ROW + i]
            counts = block[(COUNTS + axis) * ROW + i]
            angle = quantise(true_angle - zero + block[(ON_ANGLES + axis) * ROW + i], max(counts, 1.0), floor)
            last, rate = block[(MEASURED + 2 * axis) * ROW + i], block[(MEASURED + 2 * axis + 1) * ROW + i]
            decay = block[RATE_DECAY * ROW + i]
            estimate = decay * rate + (1.0 - decay) * (angle - last) / s.period
            true_rate = block[(X + 2 * axis + 1) * ROW + i]
            block[(MEASURED + 2 * axis) * ROW + i] = true_angle if counts == 0.0 else angle
            block[(MEASURED + 2 * axis + 1) * ROW + i] = true_rate if counts == 0.0 else estimate
