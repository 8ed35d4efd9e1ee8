"""Replay of a plan's voltages through equation (3) by a compiled adaptive integrator.

The integrator is the Dormand-Prince pair of orders 5 and 4, on the unmodified `heli_gym.model.dynamics`.
"""

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from heli_gym.compilation import jit_cached
from heli_gym.model import dynamics
from heli_gym.parameters import HelicopterParameters

TOLERANCE = 1e-8  # of a step, in rad and rad/s, absolute and relative
LONGEST = 0.05  # s, largest step, since voltages have corners
NODES = (0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0)
STAGES = (
    (0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    (0.2, 0.0, 0.0, 0.0, 0.0, 0.0),
    (3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0),
    (44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0),
    (19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0),
    (9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0),
    (35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0),
)
ERROR = (71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0)


@cache
def replay_kernel() -> Callable:
    """Compile `replay` at its first call, cached on disk until (3) changes."""

    def replay(x, v, times, parameters):
        x, new, rates = x.copy(), np.empty(6), np.empty((7, 6))
        last = v.shape[1] - 1
        duration = times[last]
        t, h, low, high, k = 0.0, 0.2 * LONGEST, x[4], x[4], 0
        while duration - t > 1e-12 * duration:
            h = min(h, LONGEST, duration - t)
            for stage in range(7):
                for i in range(6):
                    new[i] = x[i]
                    for j in range(stage):
                        new[i] += h * STAGES[stage][j] * rates[j, i]
                now = min(t + NODES[stage] * h, duration)
                while k > 0 and times[k] > now:
                    k -= 1
                while k < last - 1 and times[k + 1] < now:
                    k += 1
                s = (now - times[k]) / (times[k + 1] - times[k])
                v1, v2 = v[0, k] + s * (v[0, k + 1] - v[0, k]), v[1, k] + s * (v[1, k + 1] - v[1, k])
                state = (new[0], new[1], new[2], new[3], new[4], new[5])
                derivative = dynamics(state, (v1, v2), parameters, math.sin, math.cos)
                for i in range(6):
                    rates[stage, i] = derivative[i]
            error = 0.0
            for i in range(6):
                miss = 0.0
                for stage in range(7):
                    miss += h * ERROR[stage] * rates[stage, i]
                error = max(error, abs(miss) / (TOLERANCE * (1.0 + abs(x[i]))))
            if error <= 1.0:
                t += h
                for i in range(6):
                    x[i] = new[i]
                low, high = min(low, x[4]), max(high, x[4])
            if not error < 1e12:
                return x, low, high
            h *= min(5.0, max(0.2, 0.9 * max(error, 1e-12) ** -0.2))
        return x, low, high

    return jit_cached(replay)


def replay(x: np.ndarray, v: np.ndarray, t: np.ndarray, parameters: HelicopterParameters) -> tuple:
    """Final state (6,), and lowest and highest pitch, of a flight from the state x (6,).

    v (2, K) in N are the virtual inputs at the times t (K,) in s, linear between them.
    """
    return replay_kernel()(x, v, t, parameters)
