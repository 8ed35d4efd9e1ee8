"""Section III-B with more free parameters: setup functions that are splines, and the limits as inequalities.

Elevation and pitch are uniform cubic B-splines over t/T. By the inversion (13) and the travel's dynamics (14a) their
coefficients determine everything else: the travel has to arrive, which is two equations, the thrusts have the bounds
(15), and a spline is where its coefficients are, so that those of the pitch get the limits (7). Of all that meets
this, an interior-point method finds the smoothest plan in a given time, or the fastest.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.paper.boundary_value import RISE, sample_times
from heli_gym.baselines.paper.normal_form import internal_dynamics, travel_damping
from heli_gym.baselines.planning.path import excesses, path_limits
from heli_gym.model import dynamics, hover_input, virtual_input
from heli_gym.trajectory import Maneuver, Trajectory

SEGMENTS = (30, 60)  # of the splines: few are faster and smoother
SHORTEST_SEGMENTS = (36, 72, 144)  # for the shortest times there must be more
REST = 3  # coefficients at each end that its position determines, with no velocity and no acceleration
SMOOTH, SOONEST = 1e-3, 1e-6  # where the barrier ends: of the smoothest plan, which need not touch limits, the fastest
COLD, LUKEWARM, WARM = 0.1, 1e-2, 1e-3  # where it starts: from a guess, from a solution of another problem, of the same
EXACT = 1e-4  # where the barrier ends for the very smoothest plan, as a share of its roughness
EFFORT, EFFORT_ROUGHNESS = 10.0, 1e-4  # weights of the squared distance from the thrusts of hover, and of smoothness
STEEPEST = 0.5 * math.pi  # rad, of any elevation
ROUGHNESS = 1e-4  # weight of the smoothness, squared N/s over time, against the logarithm of the duration
TOLERANCE = 1e-7  # rad/s² and N
ITERATIONS = {"fixed": 200, "fastest": 1000}
SWING = 0.8  # share of the pitch limit to which the guess swings
EASY = 2.0  # how much more time than travel alone takes, about, the search for the fastest plan starts from
STRETCHES = (1.0, 1.6, 0.7, 1.25, 2.5, 4.0)  # of that, from which it starts until one leads to a plan
LEAST_STRETCH = 0.05  # share of the way from one duration to another at which lengthening gives up
APPROACH = (0.8, 0.6, 0.4, 0.2, 0.0)  # shares of what a start exceeds a constraint by
TIGHTENINGS = 5  # of the thrust bounds, where a plan exceeds them between the points at which they hold


class Spline(NamedTuple):
    """A transition, by the coefficients (M, 2) of elevation and pitch in rad, in a duration in s."""

    coefficients: np.ndarray
    duration: float
    # Sums over time of the multipliers of the bounds: thrusts low and high, per N, pitch low and high, per rad. For the
    # fastest plan, by how much the logarithm of its duration would change with each.
    multipliers: np.ndarray
    by_path: tuple[tuple[str, float], ...] = ()  # the same of the constraints on the way, per rad, rad/s or N/s


class Bounds(NamedTuple):
    """What the optimisation keeps: bounds of the thrusts in N, and how much tighter the way is than requested."""

    thrusts: tuple[float, float]
    on_the_way: bool = False
    tighter: Mapping[str, float] = MappingProxyType({})
    slopes: np.ndarray | None = None  # (2, N) of the thrust maps in N/V along the plan before, for the slew


def guess(maneuver: Maneuver, duration: float, segments: int) -> Spline:
    """The elevation as in Section III-B; the pitch one period of a sine, about as the travel needs it."""
    low, high = maneuver.limits.pitch
    share = np.clip(np.arange(-1, segments + 2) / segments, 0.0, 1.0)
    (angle, rate, lift, *_), (new_angle, new_rate, new_lift, *_) = maneuver.ends
    by_pitch = tilted_acceleration(maneuver)
    swing = 2.0 * math.pi * (new_angle - angle - 0.5 * duration * (rate + new_rate)) / duration**2 / by_pitch
    steady = (new_rate - rate) / duration / by_pitch
    elevation = lift + (new_lift - lift) * RISE(share)
    pitch = swing * np.sin(2.0 * math.pi * share) + 2.0 * steady * np.sin(math.pi * share) ** 2
    pitch = np.clip(pitch, SWING * low, SWING * high)
    return Spline(with_ends(np.stack((elevation, pitch), axis=1), maneuver, duration), duration, np.zeros(4))


def tilted_acceleration(maneuver: Maneuver) -> float:
    """The travel's acceleration in rad/s² per tangent of the pitch, at the elevation of the end where it is smaller."""
    tilted = (
        internal_dynamics((0.0, 0.0, elevation, 0.0, 0.25 * math.pi, 0.0), 0.0, maneuver.parameters)
        for _, elevation in (maneuver.start, maneuver.goal)
    )
    return float(min(tilted, key=abs))


def guess_from(maneuver: Maneuver, near: Trajectory, segments: int) -> Spline:
    """The functions of a plan, about, between the ends of the maneuver; from a state in flight, its last part."""
    share = np.arange(-2, segments + 3) / segments
    begin = 0.0 if maneuver.start_state is None else max(0.0, near.duration - maneuver.duration)
    x, u = near(begin + (near.duration - begin) * share)
    y = x[[2, 4]].T
    coefficients = (8.0 * y[1:-1] - y[:-2] - y[2:]) / 6.0  # which reproduces cubic polynomials
    accelerations = None
    if maneuver.start_state is not None:
        at_start = dynamics(x[:, 2], virtual_input(near.rig.thrust(u[:, 2])), maneuver.parameters)
        accelerations = at_start[3], at_start[5]
    return Spline(with_ends(coefficients, maneuver, maneuver.duration, accelerations), maneuver.duration, np.zeros(4))


def with_ends(
    coefficients: np.ndarray, maneuver: Maneuver, duration: float, accelerations: tuple[float, float] | None = None
) -> np.ndarray:
    """The same (M, 2), but from start to goal; without acceleration but at the start, where there may be one."""
    h = duration / (len(coefficients) - REST)
    places = (slice(0, REST), slice(-REST, None))
    for place, x, acceleration in zip(places, maneuver.ends, (accelerations, None)):
        bend = np.zeros(2) if acceleration is None else 0.5 * h**2 * np.array(acceleration)
        middle = x[[2, 4]] - bend / 3.0
        coefficients[place] = middle + bend - h * x[[3, 5]], middle, middle + bend + h * x[[3, 5]]
    return coefficients


def refined(spline: Spline) -> Spline:
    """The same functions on twice as many segments."""
    c = spline.coefficients
    fine = np.empty((2 * len(c) - 3, 2))
    fine[0::2] = 0.5 * (c[:-1] + c[1:])
    fine[1::2] = 0.125 * (c[:-2] + 6.0 * c[1:-1] + c[2:])
    return spline._replace(coefficients=fine)


def smoothest(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """The smoothest transition in the maneuver's duration from a guess; None if that leads to none."""
    return optimise(maneuver, start, bounds, float(maneuver.duration), (1.0, 0.0, 0.0), barrier, SMOOTH)


def exactly_smoothest(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """The same, whatever the distance to the limits: the barrier ends where it no longer counts."""
    found = smoothest(maneuver, start, bounds, barrier)
    if found is None:
        return None
    third = np.diff(found.coefficients, 3, axis=0)
    roughness = 0.5 * float((smoothness_weights(maneuver, found.duration, len(third)) * third**2).sum())
    last = max(EXACT * min(roughness, 1.0), 1e-9)
    return optimise(maneuver, found, bounds, float(maneuver.duration), (1.0, 0.0, 0.0), WARM, last)


def least_effort(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """The transition whose thrusts are closest to those of hover at the goal, in the mean square."""
    return optimise(
        maneuver, start, bounds, float(maneuver.duration), (EFFORT_ROUGHNESS, 0.0, EFFORT), barrier, SOONEST
    )


def fastest(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """The fastest transition from a guess; None if that leads to none."""
    return optimise(maneuver, start, bounds, start.duration, (ROUGHNESS, 1.0, 0.0), barrier, SOONEST)


def smoothness_weights(maneuver: Maneuver, duration: float, segments: int) -> np.ndarray:
    """Weights (2,) of squared third differences that make their sum the integral of the squared rates of v1 and v2.

    Of those rates, as far as they accelerate the outputs.
    """
    p = maneuver.parameters
    return np.array([p.b2, p.b3]) ** -2.0 * duration / segments * (segments / duration) ** 6


def optimise(
    maneuver: Maneuver,
    start: Spline,
    bounds: Bounds,
    duration: float,
    weights: tuple[float, float, float],
    barrier: float,
    last_barrier: float,
) -> Spline | None:
    """One run of the interior-point method; None if it does not converge.

    The weights are those of the smoothness, of the logarithm of the duration, which is free if this counts, and of the
    effort.
    """
    from heli_gym.baselines.planning.spline_kernel import compiled, run  # compiles, or loads what was compiled before

    p, segments = maneuver.parameters, len(start.coefficients) - REST
    roughness, time_weight, effort = weights
    rates = roughness * smoothness_weights(maneuver, duration, segments)
    points, free = 2 * (3 * segments + 1), segments - REST
    names, rows, row_low, row_high = constraint_rows(maneuver, segments, bounds)
    low, high = (
        np.concatenate((np.full(points, thrust), np.full(free, pitch), on_the_way))
        for thrust, pitch, on_the_way in zip(bounds.thrusts, maneuver.limits.pitch, (row_low, row_high))
    )
    (_, rate, *_), (_, new_rate, *_) = maneuver.ends
    floor = np.zeros((2, 2)) if maneuver.floor is None else np.array(maneuver.floor) - [[maneuver.start[0]], [0.0]]
    converged, _, coefficients, s, multipliers = compiled(run)(
        start.coefficients,
        duration**-2.0,
        (float(rate), 0.0, float(new_rate), maneuver.goal[0] - maneuver.start[0], travel_damping(p)),
        low,
        high,
        rows,
        floor,
        p,
        ((rates[0], rates[1]), time_weight, effort, 0.5 * float(hover_input(maneuver.goal[1], p)[0])),
        time_weight > 0.0,
        barrier,
        last_barrier,
        TOLERANCE,
        ITERATIONS["fastest" if time_weight else "fixed"],
    )
    if not converged:
        return None
    sums = [part.sum() for row in multipliers for part in (row[:points], row[points : points + free])]
    of_rows = multipliers[:, points + free :].sum(axis=0)
    by_path = tuple((name, float(of_rows[names == name].sum())) for name in dict.fromkeys(names.tolist()))
    return Spline(
        coefficients, s**-0.5 if time_weight else duration, np.array([sums[0], sums[2], sums[1], sums[3]]), by_path
    )


def constraint_rows(maneuver: Maneuver, segments: int, bounds: Bounds) -> tuple[np.ndarray, ...]:
    """The constraints on the way for the interior-point method: names (R,), kinds and indices (R, 2), bounds (R,)."""
    from heli_gym.baselines.planning import spline_kernel as kernel

    path = path_limits(maneuver)
    blocks: list[tuple[str, int, np.ndarray, Any, Any]] = []
    knots, coefficients = np.arange(1, segments), np.arange(REST, segments)

    def within(name: str) -> float:
        return getattr(path, name) - bounds.tighter.get(name, 0.0)

    if bounds.on_the_way:
        if path.elevation_min is not None or path.elevation_max is not None:
            lowest = -STEEPEST if path.elevation_min is None else path.elevation_min
            highest = STEEPEST if path.elevation_max is None else path.elevation_max
            blocks.append(("elevation", kernel.ELEVATION, coefficients, lowest, highest))
        if path.elevation_rate is not None:
            rate = within("elevation_rate")
            blocks.append(("elevation_rate", kernel.ELEVATION_RATE, np.arange(REST - 1, segments), -rate, rate))
        if path.travel_rate is not None:
            rate = within("travel_rate")
            blocks.append(("travel_rate", kernel.TRAVEL_RATE, knots, -rate, rate))
        if path.floor is not None:
            blocks.append(("floor", kernel.FLOOR, knots, -2.0 * STEEPEST, -bounds.tighter.get("floor", 0.0)))
        if path.slew is not None:
            index = np.arange(2 * 3 * segments)
            share = np.arange(3 * segments + 1) / (3 * segments)
            slopes = np.full((2, len(share)), maneuver.rig.thrust_slope(maneuver.rig.hover_voltage())[0])
            if bounds.slopes is not None:
                given = np.linspace(0.0, 1.0, bounds.slopes.shape[1])
                slopes = np.stack([np.interp(share, given, row) for row in bounds.slopes])
            most = within("slew") * np.minimum(slopes[:, 1:], slopes[:, :-1]).T.ravel()
            blocks.append(("slew", kernel.SLEW, index, -most, most))
    sizes = [len(index) for _, _, index, _, _ in blocks]
    names = np.repeat([name for name, *_ in blocks], sizes) if blocks else np.empty(0, dtype=str)
    if not blocks:
        return names, np.empty((0, 2), np.int64), np.empty(0), np.empty(0)
    rows = np.concatenate([np.stack((np.full(len(index), kind), index), axis=1) for _, kind, index, _, _ in blocks])
    low, high = (
        np.concatenate([np.broadcast_to(np.asarray(block[k], dtype=float), len(block[2])) for block in blocks])
        for k in (3, 4)
    )
    return names, rows, low, high


def planned(maneuver: Maneuver, optimum, start: Spline, barrier: float = COLD) -> tuple[Spline, Trajectory] | None:
    """What `smoothest` or another objective finds, and its samples, which keep the limits; None if there is none such.

    Constraints on the way count from when a plan exceeds them on; so does what a plan exceeds between the points at
    which bounds hold.
    """
    limits = low, high = maneuver.rig.thrust_bounds(maneuver.limits.u)
    tighter: dict[str, float] = {}
    over: dict[str, float] = {}
    on_the_way, slopes = False, None
    for _ in range(TIGHTENINGS):
        spline = optimum(maneuver, start, Bounds((low, high), on_the_way, tighter, slopes), barrier)
        if spline is None and over:
            spline = approached(maneuver, optimum, start, Bounds((low, high), on_the_way, over, slopes))
        if spline is None:
            return None
        t, x, f = sampled(maneuver, spline)
        below, above = limits[0] - f.min(), f.max() - limits[1]
        u = maneuver.rig.voltage(np.clip(f, *limits))
        over = {name: excess for name, excess in excesses(maneuver, t, x, u).items() if excess > 0.0}
        if max(below, above) <= 0.0 and not over:
            return spline, Trajectory(t, x, u, maneuver.limits, maneuver.rig)
        low, high = low + 1.2 * max(below, 0.0), high - 1.2 * max(above, 0.0)
        if on_the_way:
            tighter = {**tighter, **{name: tighter.get(name, 0.0) + 1.2 * excess for name, excess in over.items()}}
        on_the_way = on_the_way or bool(over)
        slopes = maneuver.rig.thrust_slope(u)
        start, barrier = spline, LUKEWARM if over else WARM
    return None


def approached(maneuver: Maneuver, optimum, start: Spline, bounds: Bounds) -> Spline | None:
    """The optimum from a start that exceeds the constraints on the way, by shares of its excess that become smaller."""
    for share in APPROACH:
        looser = {name: -share * excess for name, excess in bounds.tighter.items()}
        found = optimum(maneuver, start, bounds._replace(tighter=looser), LUKEWARM)
        if found is None:
            return None
        start = found
    return start


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
    ends = maneuver.ends
    deta, eta = np.full(len(t), ends[0, 1]), np.full(len(t), ends[0, 0])
    deta[1:] += np.cumsum(0.5 * h * (acceleration[:-1] + acceleration[1:]))
    if damping:
        deta /= growth
        slope = acceleration / growth - damping * deta
        eta[1:] += np.cumsum(0.5 * h * (deta[:-1] + deta[1:]) + h**2 / 12.0 * (slope[:-1] - slope[1:]))
    else:
        eta[1:] += np.cumsum(h * deta[:-1] + h**2 / 6.0 * (2.0 * acceleration[:-1] + acceleration[1:]))
    x = np.stack((eta, deta, y[0], dy1, y[1], dy2))
    x[:, [0, -1]] = ends.T
    return t, x, f


def plan_smoothest(maneuver: Maneuver, optimum: Callable = smoothest) -> Trajectory | None:
    """The plan of an objective in the maneuver's duration, straight from the guess, with as few segments as suffice."""
    for segments in SEGMENTS:
        found = planned(maneuver, optimum, guess(maneuver, maneuver.duration, segments))
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
        duration = stretch * easy_duration(maneuver)
        is_dense = maneuver.floor is not None or maneuver.limits.travel_rate is not None
        start, barrier, found = guess(maneuver, duration, SHORTEST_SEGMENTS[0]), COLD, None
        for segments in SHORTEST_SEGMENTS[: 2 if is_dense else 3]:
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
