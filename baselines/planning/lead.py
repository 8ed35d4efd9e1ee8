"""Lead compensation of rotors with lag and dead time: voltage commands for a plan, and the rotors' response."""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from heli_gym.baselines.paper.boundary_value import SAMPLE_PERIOD
from heli_gym.trajectory import Maneuver, Trajectory

REFINEMENTS = 4  # of commands, by the error of their response
UNIFORM = 1e-9  # s, difference of sampling periods up to which they are one
MANY = 100  # pieces of uniform sampling from which a loop is faster
RESOLUTION = 8  # decimals of a sampling time in s


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


def leading_commands(
    t: np.ndarray, w: np.ndarray, lag: float, delay: float, before: np.ndarray, window: tuple[float, float]
) -> np.ndarray:
    """Commands (2, K) in V within a window at which rotors with lag and dead time turn at the voltages w (2, K).

    The commands w + lag dw/dt are corrected by the error of their response, because samples miss corners of w.
    """
    u, missed = np.zeros_like(w), w
    for _ in range(REFINEMENTS):
        lead = missed + lag * np.gradient(missed, t, axis=1)
        u = np.clip(u + np.stack([np.interp(t + delay, t, row) for row in lead]), *window)
        missed = w - rotor_voltages(t, u, lag, delay, before)
    return u


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
