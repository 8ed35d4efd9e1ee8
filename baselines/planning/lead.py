"""Lead compensation of rotors with lag and dead time: voltage commands for a plan, and the rotors' response."""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from heli_gym.baselines.paper.boundary_value import SAMPLE_PERIOD
from heli_gym.trajectory import Maneuver, Trajectory

LARGEST_JUMP = 0.02  # V, of commands, that is spread over the intervals around it
JUMP = 1e-6  # s, in which a plan's voltages jump
UNIFORM = 1e-9  # s, difference of sampling periods up to which they are one
MANY = 100  # pieces of uniform sampling from which a loop is faster
RESOLUTION = 10  # decimals of a sampling time in s, fine enough for jumps


def rotor_voltages(t: np.ndarray, u: np.ndarray, lag: float, delay: float, before: np.ndarray) -> np.ndarray:
    """Voltages (2, K) in V at which rotors with a first-order lag and a dead time turn, exact for commands u (2, K).

    The commands are linear between the times t (K,), and `before` (2,) until the first one.
    """
    from scipy.signal import lfilter  # takes half a second to import

    w = np.stack([np.interp(t - delay, t, row, left=first) for row, first in zip(u, before)])
    if lag == 0.0:
        return w
    begin = int(np.searchsorted(t, delay - UNIFORM))  # the first command may differ from that before it: a jump
    response, periods = np.empty_like(w), np.diff(t)
    response[:, : begin + 1] = before[:, None]
    breaks = [begin, *(begin + 1 + np.flatnonzero(np.abs(np.diff(periods[begin:])) > UNIFORM)), len(periods)]
    keeps, ramps = np.exp(-periods / lag), 1.0 + lag / periods * np.expm1(-periods / lag)
    inputs = (1.0 - keeps - ramps) * w[:, :-1] + ramps * w[:, 1:]
    if len(breaks) > MANY:
        for row, out in zip(inputs.tolist(), response):
            value = float(out[begin])
            for k in range(begin, len(periods)):
                value = out[k + 1] = keeps[k] * value + row[k]
        return response
    for start, end in pairwise(breaks):
        last = response[:, start : start + 1]
        response[:, start + 1 : end + 1], _ = lfilter(
            [1.0], [1.0, -keeps[start]], inputs[:, start:end], axis=1, zi=keeps[start] * last
        )
    return response


def leading_commands(t: np.ndarray, w: np.ndarray, lag: float) -> tuple[np.ndarray, np.ndarray]:
    """Times (N,) and commands (2, N) in V at which rotors with a lag turn at the voltages w (2, K), linear in between.

    The commands w + lag dw/dt jump where the slope of w does. A small jump is spread over both intervals of t, in which
    its effect cancels; a larger one takes the time JUMP, with one more sample.
    """
    slopes = lag * np.diff(w) / np.diff(t)
    before = w + np.concatenate((slopes[:, :1], slopes), axis=1)
    after = w + np.concatenate((slopes, slopes[:, -1:]), axis=1)
    jumps = np.flatnonzero(np.abs(after - before).max(axis=0) > LARGEST_JUMP)
    u = 0.5 * (before + after)
    u[:, jumps] = before[:, jumps]
    return np.insert(t, jumps + 1, t[jumps] + JUMP), np.insert(u, jumps + 1, after[:, jumps], axis=1)


def leading_trajectory(maneuver: Maneuver, t: np.ndarray, x: np.ndarray, w: np.ndarray, lag: float) -> Trajectory:
    """Trajectory of the states x (6, K) with commands at which rotors with a lag turn at the voltages w (2, K)."""
    times, u = leading_commands(t, w, lag)
    states, _ = Trajectory(t, x, w, maneuver.limits, maneuver.rig)(times)
    states[:, np.searchsorted(times, t)] = x
    return Trajectory(times, states, u, maneuver.limits, maneuver.rig)


def without_dead_time(maneuver: Maneuver) -> Maneuver:
    """The maneuver after the rig's dead time, in which the helicopter rests at the start.

    Raises ValueError if the dead time takes all of the duration.
    """
    delay = maneuver.rig.delay
    if not maneuver.duration > delay:
        raise ValueError(f"duration = {maneuver.duration:g}: must be longer than the rig's dead time, {delay:g} s")
    via = tuple((None if time is None else time - delay, travel, lift) for time, travel, lift in maneuver.via)
    return replace(maneuver, duration=maneuver.duration - delay, via=via)


def with_dead_time(plan: Trajectory, delay: float) -> Trajectory:
    """A plan whose flight begins after a dead time in s, while its commands begin at once."""
    if delay == 0.0:
        return plan
    early = np.linspace(0.0, delay, 1 + max(1, round(delay / SAMPLE_PERIOD)))
    # samples at the corners of commands and flight, so that both stay exact
    t = np.unique(np.round(np.concatenate((early, plan.t, delay + plan.t)), RESOLUTION))
    t[-1] = plan.duration + delay
    x, _ = plan(t - delay)
    x[:, t <= delay] = plan.x[:, :1]
    u = np.stack([np.interp(t, plan.t, row) for row in plan.u])
    return replace(plan, t=t, x=x, u=u)


def lead_voltages(plan: Trajectory, lag: float | None = None, delay: float | None = None) -> Trajectory:
    """The plan with its voltages replaced by open-loop commands for rotors with a first-order lag and a dead time.

    The rotors should turn at the plan's voltages w, so the command is w + lag dw/dt, a dead time earlier, within the
    amplifier's limits. Commands before the start are missing, a small error for a plan with a smooth start. A feedback
    still takes the original plan as its reference.

    Args:
        plan: as `plan` returns it.
        lag: time constant in s; the rig's nominal one by default.
        delay: dead time in s; the rig's nominal one by default.

    Raises:
        ValueError: if lag or delay is negative or not finite.
    """
    lag, delay = plan.rig.lag if lag is None else lag, plan.rig.delay if delay is None else delay
    for name, value in (("lag", lag), ("delay", delay)):
        if not (np.isfinite(value) and value >= 0.0):
            raise ValueError(f"{name} = {value!r}: must be at least 0 s and finite")
    rates = np.gradient(plan.u, plan.t, axis=1)
    commands = [
        np.interp(plan.t + delay, plan.t, w) + lag * np.interp(plan.t + delay, plan.t, dw, right=0.0)
        for w, dw in zip(plan.u, rates)
    ]
    return Trajectory(plan.t, plan.x, np.clip(commands, *plan.rig.voltage_limits), plan.limits, plan.rig)
