"""Section III-B with more free parameters: setup functions that are splines, and the limits as inequalities.

Elevation and pitch are uniform cubic B-splines over t/T. By the inversion (13) and the travel's dynamics (14a) their
coefficients determine everything else: the travel has to arrive, which is two equations, the thrusts have the bounds
(15), and a spline is where its coefficients are, so that those of the pitch get the limits (7). Of all that meets
this, an interior-point method finds the smoothest plan in a given time, or the fastest.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from heli_gym.baselines.paper.boundary_value import RISE, sample_times
from heli_gym.baselines.paper.normal_form import internal_dynamics, travel_damping
from heli_gym.trajectory import Maneuver, Trajectory

SEGMENTS = (30, 60)  # of the splines: few are faster and smoother, and for the shortest times there must be more
REST = 3  # coefficients at each end that its position determines, with no velocity and no acceleration
SMOOTH, SOONEST = 1e-3, 1e-6  # where the barrier ends: of the smoothest plan, which need not touch limits, the fastest
COLD, LUKEWARM, WARM = 0.1, 1e-2, 1e-3  # where it starts: from a guess, from a solution of another problem, of the same
ROUGHNESS = 1e-4  # weight of the smoothness, squared N/s over time, against the logarithm of the duration
TOLERANCE = 1e-7  # rad/s² and N
ITERATIONS = {"smoothest": 200, "fastest": 1000}
SWING = 0.8  # share of the pitch limit to which the guess swings
EASY = 2.0  # how much more time than travel alone takes, about, the search for the fastest plan starts from
STRETCHES = (1.0, 1.6, 0.7, 1.25, 2.5, 4.0)  # of that, from which it starts until one leads to a plan
LEAST_STRETCH = 0.05  # share of the way from one duration to another at which lengthening gives up
TIGHTENINGS = 5  # of the thrust bounds, where a plan exceeds them between the points at which they hold


class Spline(NamedTuple):
    """A transition, by the coefficients (M, 2) of elevation and pitch in rad, in a duration in s."""

    coefficients: np.ndarray
    duration: float
    # Sums over time of the multipliers of the bounds: thrusts low and high, per N, pitch low and high, per rad. For the
    # fastest plan, by how much the logarithm of its duration would change with each.
    multipliers: np.ndarray


def guess(maneuver: Maneuver, duration: float, segments: int) -> Spline:
    """The elevation as in Section III-B; the pitch one period of a sine, about as the travel needs it."""
    low, high = maneuver.limits.pitch
    share = np.clip(np.arange(-1, segments + 2) / segments, 0.0, 1.0)
    swing = 2.0 * math.pi * (maneuver.goal[0] - maneuver.start[0]) / duration**2 / tilted_acceleration(maneuver)
    elevation = maneuver.start[1] + (maneuver.goal[1] - maneuver.start[1]) * RISE(share)
    pitch = np.clip(swing * np.sin(2.0 * math.pi * share), SWING * low, SWING * high)
    return Spline(at_rest(np.stack((elevation, pitch), axis=1), maneuver), duration, np.zeros(4))


def tilted_acceleration(maneuver: Maneuver) -> float:
    """The travel's acceleration in rad/s² per tangent of the pitch, at the elevation of the end where it is smaller."""
    tilted = (
        internal_dynamics((0.0, 0.0, elevation, 0.0, 0.25 * math.pi, 0.0), 0.0, maneuver.parameters)
        for _, elevation in (maneuver.start, maneuver.goal)
    )
    return float(min(tilted, key=abs))


def guess_from(maneuver: Maneuver, near: Trajectory, segments: int) -> Spline:
    """The functions of a plan, about, between the points of the maneuver."""
    share = np.arange(-2, segments + 3) / segments
    x, _ = near(near.duration * share)
    y = x[[2, 4]].T
    coefficients = (8.0 * y[1:-1] - y[:-2] - y[2:]) / 6.0  # which reproduces cubic polynomials
    return Spline(at_rest(coefficients, maneuver), maneuver.duration, np.zeros(4))


def at_rest(coefficients: np.ndarray, maneuver: Maneuver) -> np.ndarray:
    """The same (M, 2), but from start to goal."""
    for end, (_, elevation) in ((slice(0, REST), maneuver.start), (slice(-REST, None), maneuver.goal)):
        coefficients[end] = elevation, 0.0
    return coefficients


def refined(spline: Spline) -> Spline:
    """The same functions on twice as many segments."""
    c = spline.coefficients
    fine = np.empty((2 * len(c) - 3, 2))
    fine[0::2] = 0.5 * (c[:-1] + c[1:])
    fine[1::2] = 0.125 * (c[:-2] + 6.0 * c[1:-1] + c[2:])
    return spline._replace(coefficients=fine)


def smoothest(maneuver: Maneuver, start: Spline, thrusts: tuple[float, float], barrier: float = COLD) -> Spline | None:
    """The smoothest transition in the maneuver's duration from a guess; None if that leads to none."""
    return optimise(
        maneuver, start, thrusts, float(maneuver.duration), 1.0, 0.0, barrier, SMOOTH, ITERATIONS["smoothest"]
    )


def fastest(maneuver: Maneuver, start: Spline, thrusts: tuple[float, float], barrier: float = COLD) -> Spline | None:
    """The fastest transition from a guess; None if that leads to none."""
    return optimise(maneuver, start, thrusts, start.duration, ROUGHNESS, 1.0, barrier, SOONEST, ITERATIONS["fastest"])


def optimise(
    maneuver, start, thrusts, duration, roughness, time_weight, barrier, last_barrier, iterations
) -> Spline | None:
    """One run of the interior-point method, within bounds of the thrusts in N; None if it does not converge."""
    from heli_gym.baselines.planning.spline_kernel import compiled, run  # compiles, or loads what was compiled before

    p, segments = maneuver.parameters, len(start.coefficients) - REST
    # the integral of the squared rates of v1 and v2 that accelerate the outputs, by differences
    rates = roughness * np.array([p.b2, p.b3]) ** -2.0 * duration / segments * (segments / duration) ** 6
    points, free = 2 * (3 * segments + 1), segments - REST
    low, high = (
        np.concatenate((np.full(points, thrust), np.full(free, pitch)))
        for thrust, pitch in zip(thrusts, maneuver.limits.pitch)
    )
    converged, _, coefficients, s, multipliers = compiled(run)(
        start.coefficients,
        duration**-2.0,
        (0.0, 0.0, 0.0, maneuver.goal[0] - maneuver.start[0], travel_damping(p)),
        low,
        high,
        np.zeros((0, 2), np.int64),
        np.zeros((2, 0)),
        p,
        ((rates[0], rates[1]), time_weight, 0.0, 0.0),
        time_weight > 0.0,
        barrier,
        last_barrier,
        TOLERANCE,
        iterations,
    )
    sums = [part.sum() for row in multipliers for part in (row[:points], row[points:])]
    multipliers = np.array([sums[0], sums[2], sums[1], sums[3]])
    return Spline(coefficients, s**-0.5 if time_weight else duration, multipliers) if converged else None


def planned(maneuver: Maneuver, optimum, start: Spline, barrier: float = COLD) -> tuple[Spline, Trajectory] | None:
    """What `smoothest` or `fastest` finds, and its samples, which keep the limits; None if there is none such."""
    limits = low, high = maneuver.rig.thrust_bounds(maneuver.limits.u)
    for _ in range(TIGHTENINGS):
        spline = optimum(maneuver, start, (low, high), barrier)
        if spline is None:
            return None
        t, x, f = sampled(maneuver, spline)
        below, above = limits[0] - f.min(), f.max() - limits[1]
        if max(below, above) <= 0.0:
            return spline, Trajectory(t, x, maneuver.rig.voltage(f), maneuver.limits, maneuver.rig)
        low, high = low + 1.2 * max(below, 0.0), high - 1.2 * max(above, 0.0)
        start, barrier = spline, WARM
    return None


def sampled(maneuver: Maneuver, spline: Spline) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times (K,), states (6, K) and thrusts (2, K) of a spline."""
    from heli_gym.baselines.planning.spline_kernel import compiled, interpolate, thrusts_along

    T = spline.duration
    t = sample_times(replace(maneuver, duration=T))
    y, dy, ddy = compiled(interpolate)(spline.coefficients, T, len(t))
    (dy1, dy2), damping = dy, travel_damping(maneuver.parameters)
    f, acceleration = compiled(thrusts_along)(y, dy, ddy, maneuver.parameters)
    h = t[1]
    # what the travel would do but for its damping is linear in between, which at this period is exact to 1e-7
    growth = np.exp(damping * t)
    acceleration = growth * acceleration
    deta, eta = np.zeros(len(t)), np.full(len(t), maneuver.start[0])
    np.cumsum(0.5 * h * (acceleration[:-1] + acceleration[1:]), out=deta[1:])
    if damping:
        deta /= growth
        slope = acceleration / growth - damping * deta
        eta[1:] += np.cumsum(0.5 * h * (deta[:-1] + deta[1:]) + h**2 / 12.0 * (slope[:-1] - slope[1:]))
    else:
        eta[1:] += np.cumsum(h * deta[:-1] + h**2 / 6.0 * (2.0 * acceleration[:-1] + acceleration[1:]))
    x = np.stack((eta, deta, y[0], dy1, y[1], dy2))
    for k, (travel, elevation) in ((0, maneuver.start), (-1, maneuver.goal)):
        x[:, k] = travel, 0.0, elevation, 0.0, 0.0, 0.0
    return t, x, f


def plan_smoothest(maneuver: Maneuver) -> Trajectory | None:
    """The smoothest plan in the maneuver's duration, straight from the guess, with as few segments as suffice."""
    for segments in SEGMENTS:
        found = planned(maneuver, smoothest, guess(maneuver, maneuver.duration, segments))
        if found is not None:
            return found[1]
    return None


def plan_near(maneuver: Maneuver, near: Trajectory) -> Trajectory | None:
    """The smoothest plan in the maneuver's duration, from a plan of a similar maneuver."""
    for segments in SEGMENTS:
        found = planned(maneuver, smoothest, guess_from(maneuver, near, segments), WARM)
        if found is not None:
            return found[1]
    return None


def easy_duration(maneuver: Maneuver) -> float:
    """A duration in s in which there should be a plan, if there is one in any."""
    # flight at the pitch limit accelerates the travel half of the way
    acceleration = abs(tilted_acceleration(maneuver)) * math.tan(min(np.abs(maneuver.limits.pitch)))
    return EASY * (1.0 + 2.0 * math.sqrt(abs(maneuver.goal[0] - maneuver.start[0]) / acceleration))


def plan_fastest(maneuver: Maneuver, check: Callable[[], None]) -> tuple[Spline, Trajectory] | None:
    """The fastest plan, whatever the maneuver's duration; `check` may end the search by what it raises.

    With few segments first, from a duration that is easy, or one that is easier; what that leads to is where more start
    from.
    """
    for stretch in STRETCHES:
        start, barrier, found = guess(maneuver, stretch * easy_duration(maneuver), SEGMENTS[0]), COLD, None
        for segments in SEGMENTS:
            check()
            if len(start.coefficients) - REST < segments:
                start = refined(start)
            found = planned(maneuver, fastest, start, barrier) or found
            if found is not None:
                start, barrier = found[0], WARM
        if found is not None:
            return found
    return None


def plan_lengthened(maneuver: Maneuver, start: Spline, check: Callable[[], None]) -> Trajectory | None:
    """The smoothest plan in the maneuver's duration, from a faster one, lengthened in steps that succeed."""
    share = 1.0
    while share > LEAST_STRETCH:
        check()
        duration = start.duration ** (1.0 - share) * maneuver.duration**share
        found = planned(replace(maneuver, duration=duration), smoothest, start, LUKEWARM)
        if found is None:
            share *= 0.5
        elif share == 1.0:
            return found[1]
        else:
            start, share = found[0], 1.0
    return None
