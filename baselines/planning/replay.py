"""Replay of a plan's voltages through equation (3) by a compiled adaptive integrator.

The integrator is the Dormand-Prince pair of orders 5 and 4, on the unmodified `heli_gym.model.dynamics`. Plans have
thrusts linear between their samples, and flights voltages: samples are added where a curved thrust map makes a
difference.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np

from heli_gym.compilation import jit_cached
from heli_gym.model import dynamics, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory

TOLERANCE = 1e-8  # of a step, in rad and rad/s, absolute and relative
LONGEST = 0.05  # s, largest step, since voltages have corners
IMPULSE = 1e-9  # s, of the thrust range: difference between linear voltages and linear thrusts in a sampling interval
REPLAYED = 0.1  # share of IMPULSE in the replay
STEEP = 3e-3  # share of the voltage range below which a change between two samples makes no difference
MOST_PIECES = 64  # of a sampling interval
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


def split_times(t: np.ndarray, u: np.ndarray, rig: Rig, impulse: float) -> np.ndarray:
    """Times t (K,) with more between them, so that thrusts of linear voltages u (2, K) are linear within an impulse.

    The impulse is in s, relative to the thrust range.
    """
    change = np.abs(np.diff(u)).max(axis=0)
    low, high = rig.voltage_limits
    steep = np.flatnonzero(change > STEEP * (high - low))
    if len(steep) == 0:
        return t
    ends = rig.thrust(np.concatenate((u[:, steep], u[:, steep + 1], 0.5 * (u[:, steep] + u[:, steep + 1])), axis=1))
    first, last, middle = np.split(ends, 3, axis=1)
    least, most = rig.thrust_bounds(rig.voltage_limits)
    missed = np.abs(middle - 0.5 * (first + last)).max(axis=0) / (most - least) * (t[steep + 1] - t[steep])
    pieces = np.minimum(np.ceil(np.sqrt(missed / impulse)), MOST_PIECES).astype(int)  # the error is quadratic
    between = [
        np.linspace(t[k], t[k + 1], count + 1)[1:-1] for k, count in zip(steep.tolist(), pieces.tolist()) if count > 1
    ]
    return np.sort(np.concatenate((t, *between)))


def with_linear_thrusts(trajectory: Trajectory) -> Trajectory:
    """Trajectory with more samples where its thrusts, linear between the samples, are no longer so in flight."""
    rig, t = trajectory.rig, split_times(trajectory.t, trajectory.u, trajectory.rig, IMPULSE)
    if len(t) == len(trajectory.t):
        return trajectory
    f = np.stack([np.interp(t, trajectory.t, row) for row in rig.thrust(trajectory.u)])
    u = np.clip(rig.voltage(f), trajectory.u.min(axis=1)[:, None], trajectory.u.max(axis=1)[:, None])
    x, _ = trajectory(t)
    given = np.searchsorted(t, trajectory.t)
    x[:, given], u[:, given] = trajectory.x, trajectory.u
    return replace(trajectory, t=t, x=x, u=u)


def rotor_inputs(t: np.ndarray, w: np.ndarray, rig: Rig) -> tuple[np.ndarray, np.ndarray]:
    """Times (N,) and virtual inputs (2, N) in N of rotor voltages w (2, K), linear between the times t (K,)."""
    times = split_times(t, w, rig, REPLAYED * IMPULSE)
    if len(times) > len(t):
        w = np.stack([np.interp(times, t, row) for row in w])
    return times, np.stack(virtual_input(rig.thrust(w)))
