"""Searches for plans by splines: how many segments, from which guess, and of which duration.

The optimisation itself is in `spline`.
"""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from heli_gym.baselines.planning.path import path_limits
from heli_gym.baselines.planning.spline import (
    COLD,
    LUKEWARM,
    REST,
    WARM,
    Bounds,
    Spline,
    fastest,
    fastest_weights,
    guess,
    guess_from,
    optimise,
    refined,
    smoothest,
    solve_within_limits,
    tilted_acceleration,
    unlimited,
)
from heli_gym.trajectory import Maneuver, Trajectory

SEGMENTS = (30, 60)  # of the splines, tried in this order: fewer are faster and smoother
OPTIMUM_SEGMENTS = (90, *SEGMENTS)  # least effort and rates are within 1 to 2 % of those of collocation
SHORTEST_SEGMENTS = (36, 72, 144)  # the shortest durations take more segments
REPLAN_DENSITY, FEWEST, REPLAN_ITERATIONS = 2.5, 12, 30  # segments per s, fewest segments, and iterations in flight
LONGER, QUICK, QUICK_ITERATIONS = (2.0, 0.7), 1e-3, 80  # s beyond the requested duration, for the fastest in flight
LADDER = (0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.5)  # s beyond the requested duration, for short plans in flight
EASY = 2.0  # ratio of the search's initial duration to a rough bound for travel alone
STRETCHES = (1.0, 1.6, 0.7, 1.25, 2.5, 4.0)  # factors on that duration, tried until one gives a plan
# First and last factor on a duration, with few segments and with twice as many.
SHORTENINGS = ((0.8, 0.99), (0.98, 0.997))
LEAST_STRETCH = 0.05  # smallest step of lengthening, as a share of the interval of durations
DENSE_ITERATIONS = 300  # for the refinement of a fastest plan with a floor or a limit on the travel rate


def plan_smoothest(
    maneuver: Maneuver, optimum: Callable = smoothest, check: Callable[[], None] = unlimited
) -> Trajectory | None:
    """Plan for an objective in the maneuver's duration, from the initial guess, by the first number of segments.

    The smoothest plan takes the fewest segments that work.
    """
    for segments in SEGMENTS if optimum is smoothest else OPTIMUM_SEGMENTS:
        found = solve_within_limits(maneuver, optimum, guess(maneuver, maneuver.duration, segments), check=check)
        if found is not None:
            return found[1]
    return None


def replan(maneuver: Maneuver, near: Trajectory, is_fixed: bool) -> Trajectory | None:
    """Smoothest plan from a measured state, from a plan in flight, with its accelerations at the start if fixed."""
    segments = min(max(math.ceil(maneuver.duration * REPLAN_DENSITY), FEWEST), SEGMENTS[0])
    start = guess_from(maneuver, near, segments, is_fixed)
    found = solve_within_limits(maneuver, smoothest, start, WARM, REPLAN_ITERATIONS)
    return found and found[1]


def plan_few(maneuver: Maneuver) -> Trajectory | None:
    """Smoothest plan from the initial guess with the fewest segments."""
    start = guess(maneuver, maneuver.duration, FEWEST)
    found = solve_within_limits(maneuver, smoothest, start, COLD, REPLAN_ITERATIONS)
    return found and found[1]


def fastest_from(maneuver: Maneuver) -> Spline | None:
    """Fastest spline from a state in flight, regardless of the maneuver's duration, with few segments; or None."""
    for longer in (*LONGER, easy_duration(maneuver)):
        duration = maneuver.duration + longer
        found = optimise(
            maneuver,
            guess(maneuver, duration, FEWEST),
            Bounds(maneuver.rig.thrust_bounds(maneuver.limits.u), iterations=QUICK_ITERATIONS),
            duration,
            fastest_weights(maneuver),
            COLD,
            QUICK,
        )
        if found is not None:
            return found
    return None


def plan_near(maneuver: Maneuver, near: Trajectory, check: Callable[[], None] = unlimited) -> Trajectory | None:
    """Smoothest plan in the maneuver's duration, from a plan of a similar maneuver."""
    for segments in SEGMENTS:
        found = solve_within_limits(maneuver, smoothest, guess_from(maneuver, near, segments), WARM, check=check)
        if found is not None:
            return found[1]
    return None


def easy_duration(maneuver: Maneuver) -> float:
    """Duration in s, long enough for a plan in most cases: EASY times a rough lower bound."""
    # flight at the pitch limit accelerates the travel half of the way
    acceleration = abs(tilted_acceleration(maneuver)) * math.tan(min(np.abs(maneuver.limits.pitch)))
    travel = [maneuver.start[0], *(point[1] for point in maneuver.via), maneuver.goal[0]]
    turns = float(np.abs(maneuver.ends[:, 1]).sum()) / acceleration  # to slow down from and speed up to moving ends
    ways = sum(math.sqrt(abs(rise) / acceleration) for rise in np.diff(travel))
    return EASY * (1.0 + 2.0 * ways + turns)


def plan_fastest(maneuver: Maneuver, check: Callable[[], None]) -> tuple[Spline, Trajectory] | None:
    """Fastest plan, regardless of the maneuver's duration; an exception from `check` ends the search.

    It starts with few segments from an easy duration; each result is the initial guess for more segments. A plan to any
    elevation starts from one to the elevation of the start, and is this one if that fails.
    """
    if maneuver.elevation_free:
        level = plan_fastest(replace(maneuver, elevation_free=False), check)
        if level is not None:
            found = solve_within_limits(maneuver, fastest, level[0], LUKEWARM, check=check)
            return level if found is None or found[0].duration > level[0].duration else found
    path = path_limits(maneuver)
    # a slow guess meets limits on rates, which a fast plan exceeds by far
    warm = LUKEWARM if maneuver.lead else WARM
    is_fast_limited = not (path.travel_rate is path.elevation_rate is path.slew is path.lead is None)
    for stretch in STRETCHES:
        duration = stretch * easy_duration(maneuver)
        is_dense = maneuver.floor is not None or maneuver.limits.travel_rate is not None
        start, barrier, found = guess(maneuver, duration, SHORTEST_SEGMENTS[0]), COLD, None
        for segments in SHORTEST_SEGMENTS[: 2 if is_dense else 3]:
            iterations: int | None = DENSE_ITERATIONS if is_dense and found is not None else None
            while len(start.coefficients) - REST < segments:  # twice where the number before gave no plan
                start = refined(start)
            if found is None and is_fast_limited:
                found = solve_within_limits(maneuver, fastest, start, barrier, iterations, True, check)
                if found is not None:
                    start, barrier = found[0], warm
                    continue
            found = solve_within_limits(maneuver, fastest, start, barrier, iterations, check=check) or found
            if found is not None:
                start, barrier = found[0], warm
        if found is None:
            found = plan_shortened(maneuver, duration, check)
        elif len(found[0].coefficients) - REST == SHORTEST_SEGMENTS[0]:  # more segments gave no plan
            found = shortened(maneuver, found, SHORTEST_SEGMENTS[1], SHORTENINGS[1], check)
        if found is not None:
            return found
    return None


def plan_shortened(maneuver: Maneuver, duration: float, check: Callable[[], None]) -> tuple[Spline, Trajectory] | None:
    """Plan as fast as the smoothest plans remain when they are shortened step by step from a duration in s."""
    start = guess(maneuver, duration, SHORTEST_SEGMENTS[0])
    longer = replace(maneuver, duration=duration)
    best = solve_within_limits(longer, smoothest, start, on_the_way=True, check=check)
    for segments, ratios in zip(SHORTEST_SEGMENTS, SHORTENINGS):
        best = best and shortened(maneuver, best, segments, ratios, check)
    return best


def shortened(
    maneuver: Maneuver,
    best: tuple[Spline, Trajectory],
    segments: int,
    ratios: tuple[float, float],
    check: Callable[[], None],
) -> tuple[Spline, Trajectory]:
    """Smoothest plan of the shortest duration: it is shortened by the first ratio, and by others up to the last one."""
    start, (ratio, last) = best[0], ratios
    while len(start.coefficients) - REST < segments:
        start = refined(start)
    while ratio < last:
        shorter = replace(maneuver, duration=ratio * best[0].duration)
        found = solve_within_limits(shorter, smoothest, start, LUKEWARM, on_the_way=True, check=check)
        if found is None:
            ratio = math.sqrt(ratio)
        else:
            best, start = found, found[0]
    return best


def plan_lengthened(maneuver: Maneuver, start: Spline, check: Callable[[], None]) -> Trajectory | None:
    """Smoothest plan in the maneuver's duration, from a faster one that is lengthened step by step."""
    share = 1.0
    while share > LEAST_STRETCH:
        duration = start.duration ** (1.0 - share) * maneuver.duration**share
        found = solve_within_limits(replace(maneuver, duration=duration), smoothest, start, LUKEWARM, check=check)
        if found is None:
            share *= 0.5
        elif share == 1.0:
            return found[1]
        else:
            start, share = found[0], 1.0
    return None
