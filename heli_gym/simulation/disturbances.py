"""Disturbances in loops over the helicopters of a block: gusts, and the sum of all disturbances."""

import math
from typing import Any

from heli_gym.simulation.fast_math import standard_normal
from heli_gym.simulation.layout import (
    AFTER,
    DISTURBANCE,
    DISTURBANCES,
    EFFECT,
    GUST,
    KEY,
    ORNSTEIN_UHLENBECK,
    RAMP,
    ROW,
    STEP,
    TORQUES,
    H,
    Settings,
    eight,
    put_six,
)


def step_gusts(block: Any, n: int, s: Settings) -> None:
    """Advance all gusts by one control period: the exact discretisation of Ornstein-Uhlenbeck processes."""
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        for i in range(n):
            kind, _, strength, _, _, _, decay, gust = eight(block, first, i)
            if kind == ORNSTEIN_UHLENBECK:
                normal = standard_normal(block[KEY * ROW + i], block[STEP * ROW + i], 3 + d)
                block[(first + GUST) * ROW + i] = decay * gust + math.sqrt(1.0 - decay * decay) * strength * normal


def sum_disturbances(block: Any, n: int, s: Settings) -> None:
    """Sum the disturbances over the integration step H, AFTER the start of the control period.

    A push is weighted by the share of the step in which it acts, so that its impulse is exact for any duration.
    """
    for i in range(n):
        put_six(block, TORQUES, i, (0.0, 0.0, 0.0, 0.0, 1.0, 1.0))
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        for i in range(n):
            kind, channel, amount, begin, duration, _, _, gust = eight(block, first, i)
            after, h = block[AFTER * ROW + i], block[H * ROW + i]
            since = s.period * block[STEP * ROW + i] + after - begin
            on = min(max(since + h, 0.0), duration) - min(max(since, 0.0), duration)  # duration may be infinite
            if kind == ORNSTEIN_UHLENBECK:
                value = gust
            elif kind == RAMP:
                value = amount * min(max((since + 0.5 * h) / duration, 0.0), 1.0)
            else:
                value = amount * on / (h if h > 0.0 else 1.0)
            row = TORQUES + int(channel)
            if row < EFFECT:
                block[row * ROW + i] += value
            else:
                block[row * ROW + i] *= 1.0 - value
