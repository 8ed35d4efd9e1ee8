"""Section III-B with more free parameters: splines as setup functions, and the limits as inequalities.

Elevation and pitch are uniform cubic B-splines over t/T. By the inversion (13) and the travel's dynamics (14a), their
coefficients determine the plan. The arrival of the travel gives two equations; the thrusts have the bounds (15); the
limits (7) bound the pitch coefficients, since a spline lies in their convex hull. An interior-point method finds the
smoothest plan for a given duration, or the fastest plan.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator

from heli_gym.baselines.paper.boundary_value import RISE, sample_times
from heli_gym.baselines.paper.normal_form import internal_dynamics, travel_damping
from heli_gym.baselines.planning.lead import leading_commands, leading_trajectory
from heli_gym.baselines.planning.path import PATH_TOLERANCE, RECOVERY, excesses, passages, path_limits, pitch_window
from heli_gym.model import dynamics, virtual_input
from heli_gym.rig import Rig
from heli_gym.trajectory import Maneuver, Trajectory, hover_thrust_sum

REST = 3  # coefficients at each end, fixed by its position with zero velocity and acceleration
SMOOTH, SOONEST = 1e-3, 1e-6  # final barrier parameter: smoothest plan, which seldom touches limits; fastest plan
COLD, LUKEWARM, WARM = 0.1, 1e-2, 1e-3  # initial one: from a guess, from a solution of another or of the same problem
OVER_FLOOR = 1e-6  # likewise of the smoothest plan with a floor, which a larger one would repel
RATES_ROUGHNESS = 1e-3  # weight of smoothness next to that of the squared thrust rates
EFFORT, EFFORT_ROUGHNESS = 10.0, 1e-4  # weights of the squared distance from hover thrusts, and of smoothness
STEEPEST = 0.5 * math.pi  # rad, of any elevation
ROUNDED = 0.5 * PATH_TOLERANCE  # excess over a path constraint that is none
LEAD_MARGIN = 0.02  # V, for leading commands between the points of the optimisation
SLOPE_STEP, LEAST_SLOPE = 0.01, 0.1  # V, for differences of slopes; share of a slope that counts as zero
END_MARGIN = 0.02  # rad, of pitch coefficients next to an end in motion
ROUGHNESS = 3.4e-5  # s, weight of smoothness (integral of squared rates, in thrust ranges per s) next to log duration
TOLERANCE = 1e-7  # rad/s² and N
ITERATIONS = {"fixed": 200, "fastest": 1000}
LEAD_ROUGHNESS = 1e-4  # s/N², likewise for voltages that lead
SWING = 0.8  # pitch amplitude of the guess, as a share of the pitch limit
APPROACH = (0.8, 0.6, 0.4, 0.2, 0.0)  # decreasing shares of the initial excess over a constraint
TIGHTENINGS = 8  # largest number of times that thrust bounds are tightened for an excess between collocation points
LINEARISED, LINEARISATIONS = ("slew", "lead"), 3  # constraints linear about the last plan; plans until tightening
LEAST_SHARE = 0.3  # of a limit on a rate, left by tightening
FEWEST_SAMPLES, MANY_SAMPLES = 20, 100  # of a segment: at least; from which corners between them make no difference
VIA_ACCURACY = 1e-4  # rad, largest miss of a via point; the integral of the travel to it is approximate


class Spline(NamedTuple):
    """Transition given by the coefficients (M, 2) of elevation and pitch in rad, and a duration in s."""

    coefficients: np.ndarray
    duration: float
    # Multipliers of the bounds, summed over time: thrusts low and high, per N, pitch low and high, per rad. For the
    # fastest plan, they are the sensitivities of the logarithm of its duration to the bounds.
    multipliers: np.ndarray
    by_path: tuple[tuple[str, float], ...] = ()  # likewise of the path constraints, per rad, rad/s, V/s or V
    rate: float = 0.0  # rad/s, travel rate at the start
    is_fixed: bool = False  # whether the accelerations at a moving start are fixed


class Bounds(NamedTuple):
    """Bounds in the optimisation: thrusts in N, and amounts by which path constraints are tightened."""

    thrusts: tuple[float, float]
    on_the_way: bool = False
    tighter: Mapping[str, float] = MappingProxyType({})
    voltages: np.ndarray | None = None  # (2, N) of the rotors along the previous plan, for slew rate and lead
    vias: np.ndarray | None = None  # (V, 2) shifts of the via points in rad, by their miss in the previous plan
    iterations: int | None = None  # largest number
    above_floor: np.ndarray | None = None  # (S + 1,) in rad, by which a floor is raised at the knots
    bent: bool = True  # whether the thrust maps are curved about the previous plan's voltages, for lead


def unlimited() -> None:
    """Check no time limit."""


def guess(maneuver: Maneuver, duration: float, segments: int) -> Spline:
    """Initial guess: elevation as in Section III-B, and one period of a sine as pitch, scaled to the travel.

    With via points: the elevation monotone between them, and the pitch of a smooth travel through them.
    """
    low, high = maneuver.limits.pitch
    share = np.clip(np.arange(-1, segments + 2) / segments, 0.0, 1.0)
    (angle, rate, lift, *_), (new_angle, new_rate, new_lift, *_) = maneuver.ends
    by_pitch = tilted_acceleration(maneuver)
    if maneuver.via:
        shares, travel, elevation = via_estimates(maneuver, duration)
        ends = "periodic" if maneuver.periodic else ((1, duration * rate), (1, duration * new_rate))
        advance = (travel[-1] - travel[0]) * shares if maneuver.periodic else 0.0 * shares
        rounded = np.append((travel - advance)[:-1], (travel - advance)[0 if maneuver.periodic else -1])
        pitch = np.arctan(CubicSpline(shares, rounded, bc_type=ends)(share, 2) / duration**2 / by_pitch)
        rate = (travel[-1] - travel[0]) / duration if maneuver.periodic else rate
        elevation = PchipInterpolator(shares, elevation)(share)
    else:
        swing = 2.0 * math.pi * (new_angle - angle - 0.5 * duration * (rate + new_rate)) / duration**2 / by_pitch
        steady = (new_rate - rate) / duration / by_pitch
        elevation = lift + (new_lift - lift) * RISE(share)
        pitch = swing * np.sin(2.0 * math.pi * share) + 2.0 * steady * np.sin(math.pi * share) ** 2
        if maneuver.periodic:
            rate, pitch = (new_angle - angle) / duration, 0.0 * pitch
    pitch = np.clip(pitch, SWING * low, SWING * high)
    coefficients = np.stack((elevation, pitch), axis=1)
    if not maneuver.periodic:
        coefficients = with_ends(coefficients, maneuver, duration)
    return Spline(coefficients, duration, np.zeros(4), rate=float(rate))


def via_estimates(maneuver: Maneuver, duration: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Estimated times as shares of the duration, travel and elevation of start, via points and goal (V + 2,) each.

    A free time follows from the travel's distance between its neighbours, with equal parts for the points' number.
    """
    points = [(0.0, *maneuver.start), *maneuver.via, (duration, *maneuver.goal)]
    travel = np.array([point[1] for point in points])
    known = [k for k, point in enumerate(points) if point[2] is not None]
    elevation = np.interp(range(len(points)), known, [float(points[k][2] or 0.0) for k in known])
    way = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(travel)) + 0.3)))
    timed = [k for k, point in enumerate(points) if point[0] is not None]
    times = np.interp(way, way[timed], [float(points[k][0] or 0.0) for k in timed])
    return times / duration, travel, elevation


def tilted_acceleration(maneuver: Maneuver) -> float:
    """Travel acceleration in rad/s² per tangent of the pitch: the smaller one of hover at start and goal."""
    tilted = (
        internal_dynamics((0.0, 0.0, elevation, 0.0, 0.25 * math.pi, 0.0), 0.0, maneuver.parameters)
        for _, elevation in (maneuver.start, maneuver.goal)
    )
    return float(min(tilted, key=abs))


def guess_from(maneuver: Maneuver, near: Trajectory, segments: int, is_fixed: bool = True) -> Spline:
    """Spline that approximates a plan between the maneuver's ends; from a state in flight, the plan's last part."""
    share = np.arange(-2, segments + 3) / segments
    begin = 0.0 if maneuver.start_state is None else max(0.0, near.duration - maneuver.duration)
    x, u = near(begin + (near.duration - begin) * share)
    y = x[[2, 4]].T
    coefficients = (8.0 * y[1:-1] - y[:-2] - y[2:]) / 6.0  # quasi-interpolant, exact for cubic polynomials
    accelerations = None
    if maneuver.start_state is not None and is_fixed:
        at_start = dynamics(x[:, 2], virtual_input(near.rig.thrust(u[:, 2])), maneuver.parameters)
        accelerations = at_start[3], at_start[5]
    coefficients = with_ends(coefficients, maneuver, maneuver.duration, accelerations)
    return Spline(
        coefficients,
        maneuver.duration,
        np.zeros(4),
        rate=float(x[1, 2] if maneuver.periodic else maneuver.ends[0, 1]),
        is_fixed=accelerations is not None,
    )


def with_ends(
    coefficients: np.ndarray, maneuver: Maneuver, duration: float, accelerations: tuple[float, float] | None = None
) -> np.ndarray:
    """Coefficients (M, 2) with the maneuver's start and goal, at zero acceleration unless given for the start."""
    if maneuver.periodic:
        return coefficients
    h = duration / (len(coefficients) - REST)
    places = (slice(0, REST), slice(-REST, None))
    for place, x, acceleration in zip(places, maneuver.ends, (accelerations, None)):
        bend = np.zeros(2) if acceleration is None else 0.5 * h**2 * np.array(acceleration)
        middle = x[[2, 4]] - bend / 3.0
        coefficients[place] = middle + bend - h * x[[3, 5]], middle, middle + bend + h * x[[3, 5]]
    return coefficients


def fixed_ends(maneuver: Maneuver, start: Spline) -> tuple[int, int]:
    """Numbers of fixed coefficients at the start and at the goal; `end_rows` determines the others."""
    at_start = not maneuver.periodic and (maneuver.start_state is None or start.is_fixed)
    at_goal = not maneuver.periodic and maneuver.goal_state is None and not maneuver.elevation_free
    return (REST if at_start else 0), (REST if at_goal else 0)


def end_rows(maneuver: Maneuver, held: tuple[int, int]) -> tuple[list[int], list[float]]:
    """Equations of ends that are not fixed, for rows of the kind END: indices and targets."""
    from heli_gym.baselines.planning import spline_kernel as kernel

    if maneuver.periodic:
        return [kernel.START, *(kernel.LOOP + k for k in range(6))], [maneuver.start[1]] + 6 * [0.0]
    rows: dict[int, float] = {}
    for place, x, fixed in zip((kernel.START, kernel.GOAL), maneuver.ends, held):
        if not fixed:
            rows |= {place: x[2], place + 1: x[3], place + 3: x[4], place + 4: x[5]}
    if maneuver.elevation_free:  # at rest in hover
        rows |= {kernel.GOAL + order: 0.0 for order in (2, 5)}
        del rows[kernel.GOAL]
    return list(rows), [float(value) for value in rows.values()]


def pitch_bounds(
    maneuver: Maneuver, held: tuple[int, int], count: int, interval: float
) -> tuple[np.ndarray, np.ndarray]:
    """Bounds (N,) in rad of the free pitch coefficients: the limits, but wider where an end in motion requires it."""
    low, high = (np.full(count, limit) for limit in maneuver.limits.pitch)
    window = pitch_window(maneuver)
    if window != maneuver.limits.pitch:
        early = slice(0, max(0, math.floor(RECOVERY / interval) - held[0] - 1))  # their splines end within RECOVERY
        low[early], high[early] = window
    for fixed, order, x in zip(held, (1, -1), maneuver.ends):
        if not fixed and not maneuver.periodic and (x[4] or x[5]):
            low[::order][0], high[::order][0] = -STEEPEST, STEEPEST
            for k in (1, 2):
                low[::order][k] = min(low[::order][k], x[4] - END_MARGIN)
                high[::order][k] = max(high[::order][k], x[4] + END_MARGIN)
    return low, high


def refined(spline: Spline) -> Spline:
    """Represent the same functions on twice as many segments."""
    c = spline.coefficients
    fine = np.empty((2 * len(c) - 3, 2))
    fine[0::2] = 0.5 * (c[:-1] + c[1:])
    fine[1::2] = 0.125 * (c[:-2] + 6.0 * c[1:-1] + c[2:])
    return spline._replace(coefficients=fine)


def smoothest(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """Smoothest transition in the maneuver's duration, from a guess; None without convergence."""
    for last in (SMOOTH,) if maneuver.floor is None else (OVER_FLOOR, SMOOTH):
        found = optimise(maneuver, start, bounds, float(maneuver.duration), (1.0, 0.0, 0.0, 0.0), barrier, last)
        if found is not None:
            return found
    return None


def least_rates(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """Transition with the least integral of squared thrust rates, regardless of the distance to the limits."""
    found = smoothest(maneuver, start, bounds, barrier)
    if found is None:
        return None
    t, _, f = sample(maneuver, found)
    scale = float((np.diff(f) ** 2 / np.diff(t)).sum())  # the objective is of order one at its start
    weights = RATES_ROUGHNESS / scale, 0.0, 0.0, 1.0 / scale
    return optimise(maneuver, found, bounds, float(maneuver.duration), weights, LUKEWARM, SOONEST)


def least_effort(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """Transition with the least mean squared distance of the thrusts from those of hover at the goal."""
    return optimise(
        maneuver, start, bounds, float(maneuver.duration), (EFFORT_ROUGHNESS, 0.0, EFFORT, 0.0), barrier, SOONEST
    )


def fastest(maneuver: Maneuver, start: Spline, bounds: Bounds, barrier: float = COLD) -> Spline | None:
    """Fastest transition, from a guess; None without convergence."""
    return optimise(maneuver, start, bounds, start.duration, fastest_weights(maneuver), barrier, SOONEST)


def fastest_weights(maneuver: Maneuver) -> tuple[float, float, float, float]:
    """Weights of the fastest plan; that of smoothness is relative to the thrust range, which differs between rigs."""
    if maneuver.lead:  # rates of thrusts are part of the voltages
        return LEAD_ROUGHNESS, 1.0, 0.0, 0.0
    low, high = maneuver.rig.thrust_bounds(maneuver.limits.u)
    return ROUGHNESS / (high - low) ** 2, 1.0, 0.0, 0.0


def smoothness_weights(maneuver: Maneuver, duration: float, segments: int) -> np.ndarray:
    """Weights (2,) of squared third differences: their sum is then the integral of the squared rates of v1 and v2.

    Only the part of v1 and v2 that accelerates elevation and pitch counts.
    """
    p = maneuver.parameters
    return np.array([p.b2, p.b3]) ** -2.0 * duration / segments * (segments / duration) ** 6


def optimise(
    maneuver: Maneuver,
    start: Spline,
    bounds: Bounds,
    duration: float,
    weights: tuple[float, float, float, float],
    barrier: float,
    last_barrier: float,
) -> Spline | None:
    """Run the interior-point method once; None if it does not converge.

    The weights are those of smoothness, logarithm of the duration, effort, and squared thrust rates; the duration is
    free if its weight is positive, which that of the rates must not be then.
    """
    from heli_gym.baselines.planning.spline_kernel import compiled, run  # compiles, or loads from the cache

    p, segments = maneuver.parameters, len(start.coefficients) - REST
    roughness, time_weight, effort, thrust_rate = weights
    rates = roughness * smoothness_weights(maneuver, duration, segments)
    held = fixed_ends(maneuver, start)
    points, free = 2 * (3 * segments + 1), segments + REST - sum(held)
    names, rows, row_low, row_high, lags = constraint_rows(maneuver, segments, duration, bounds)
    low, high = (
        np.concatenate((np.full(points, thrust), pitch, on_the_way))
        for thrust, pitch, on_the_way in zip(
            bounds.thrusts, pitch_bounds(maneuver, held, free, duration / segments), (row_low, row_high), strict=True
        )
    )
    rows, targets, vias = with_equations(maneuver, rows, lags, held, duration, bounds)
    (_, rate, *_), (_, new_rate, *_) = maneuver.ends
    floor = np.zeros((2, 2)) if maneuver.floor is None else np.array(maneuver.floor) - [[maneuver.start[0]], [0.0]]
    turn = maneuver.goal[0] - maneuver.start[0]
    converged, _, coefficients, s, rate, multipliers = compiled(run)(
        start.coefficients,
        duration**-2.0,
        float(start.rate if maneuver.periodic else rate),
        held,
        (float(new_rate), turn, travel_damping(p), float(maneuver.periodic)),
        low,
        high,
        rows,
        targets,
        vias,
        floor,
        p,
        ((rates[0], rates[1]), time_weight, effort, 0.5 * hover_thrust_sum(maneuver.goal[1], p), thrust_rate),
        (time_weight > 0.0, maneuver.periodic),
        barrier,
        last_barrier,
        TOLERANCE,
        bounds.iterations or ITERATIONS["fastest" if time_weight else "fixed"],
    )
    if not converged:
        return None
    sums = [part.sum() for row in multipliers for part in (row[:points], row[points : points + free])]
    of_rows = multipliers[:, points + free :].sum(axis=0)
    # per volt where the rows are bounds in newtons that a limit in volts gives
    per_limit = {name: (row_high - row_low) / width for name, width in voltage_widths(maneuver, bounds).items()}
    by_path = tuple(
        (name, float((of_rows * per_limit.get(name, 1.0))[names == name].sum()))
        for name in dict.fromkeys(names.tolist())
    )
    return Spline(
        coefficients,
        s**-0.5 if time_weight else duration,
        np.array([sums[0], sums[2], sums[1], sums[3]]),
        by_path,
        rate,
        start.is_fixed,
    )


def with_equations(
    maneuver: Maneuver, rows: np.ndarray, lags: np.ndarray, held: tuple[int, int], duration: float, bounds: Bounds
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rows with bounds, followed by the equations of ends and via points; their targets; and the via points (V, 3)."""
    from heli_gym.baselines.planning import spline_kernel as kernel

    indices, values = end_rows(maneuver, held)
    equations = [(kernel.END, index) for index in indices]
    vias = np.zeros((0, 3))
    if maneuver.via:
        shares = via_estimates(maneuver, duration)[0][1:-1]
        vias = np.array(
            [
                (-1.0 - share if time is None else time / duration, travel, lift or 0.0)
                for share, (time, travel, lift) in zip(shares, maneuver.via)
            ]
        )
        vias[:, 1] -= maneuver.start[0]
        if bounds.vias is not None:
            vias[:, 1:] += bounds.vias
        for k, (time, _, lift) in enumerate(maneuver.via):
            if time is None:
                equations.append((kernel.CROSSING, k))
            else:
                equations.append((kernel.VIA_TRAVEL, k))
                equations += [] if lift is None else [(kernel.VIA_ELEVATION, k)]
    targets = np.zeros(len(rows) + len(equations))
    targets[len(rows) : len(rows) + len(values)] = values
    targets[: len(rows)] = lags
    return np.concatenate((rows, np.array(equations, np.int64).reshape(-1, 2))), targets, vias


def constraint_rows(maneuver: Maneuver, segments: int, duration: float, bounds: Bounds) -> tuple[np.ndarray, ...]:
    """Path constraints for the interior-point method: names (R,), kinds and indices (R, 2), bounds (R,), lags (R,)."""
    from heli_gym.baselines.planning import spline_kernel as kernel

    path = path_limits(maneuver)
    blocks: list[tuple[str, int, np.ndarray, Any, Any]] = []
    leads = [np.empty(0)]
    knots, coefficients = np.arange(1, segments), np.arange(REST, segments)
    if maneuver.periodic:
        knots = np.arange(segments + 1)

    def within(name: str) -> float:
        return tightened(getattr(path, name), bounds.tighter.get(name, 0.0))

    share = np.append((np.arange(segments)[:, None] + kernel.POINTS).ravel() / segments, 1.0)
    voltages = maneuver.rig.hover_voltage(maneuver.start[1])[:, None] * np.ones(len(share))
    if bounds.voltages is not None:
        given = np.linspace(0.0, 1.0, bounds.voltages.shape[1])
        voltages = np.stack([np.interp(share, given, row) for row in bounds.voltages])
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
            above = np.zeros(segments + 1) if bounds.above_floor is None else bounds.above_floor
            blocks.append(
                ("floor", kernel.FLOOR, knots, -2.0 * STEEPEST, -bounds.tighter.get("floor", 0.0) - above[knots])
            )
        if path.slew is not None:
            slopes = maneuver.rig.thrust_slope(voltages)
            most = within("slew") * np.minimum(slopes[:, 1:], slopes[:, :-1]).T.ravel()
            blocks.append(("slew", kernel.SLEW, np.arange(2 * 3 * segments), -most, most))
        if path.lead is not None:
            window = leading_window(maneuver, bounds)
            steps = duration * np.diff(share)
            for at_end in (False, True):
                low, high, lags = lead_bounds(maneuver.rig, voltages, steps, path.lead, window, at_end, bounds.bent)
                blocks.append(("lead", kernel.LEAD, np.arange(low.size), low.T.ravel(), high.T.ravel()))
                leads.append((lags if at_end else lags - steps).T.ravel())
    sizes = [len(index) for _, _, index, _, _ in blocks]
    names = np.repeat([name for name, *_ in blocks], sizes) if blocks else np.empty(0, dtype=str)
    if not blocks:
        return names, np.empty((0, 2), np.int64), np.empty(0), np.empty(0), np.empty(0)
    rows = np.concatenate([np.stack((np.full(len(index), kind), index), axis=1) for _, kind, index, _, _ in blocks])
    low, high = (
        np.concatenate([np.broadcast_to(np.asarray(block[k], dtype=float), len(block[2])) for block in blocks])
        for k in (3, 4)
    )
    lags = np.concatenate(leads)
    return names, rows, low, high, np.concatenate((np.zeros(len(rows) - len(lags)), lags))


def tightened(limit: float, by: float) -> float:
    """The limit less an amount, but not less than LEAST_SHARE of it."""
    return max(limit - by, LEAST_SHARE * limit)


def leading_window(maneuver: Maneuver, bounds: Bounds) -> tuple[float, float]:
    """Window in V of leading commands in the optimisation."""
    less = LEAD_MARGIN + bounds.tighter.get("lead", 0.0)
    return maneuver.limits.u_min + less, maneuver.limits.u_max - less


def voltage_widths(maneuver: Maneuver, bounds: Bounds) -> dict[str, float]:
    """Widths in V/s of the window of slew rates, and in V of that of leading commands, by name of the constraint."""
    low, high = leading_window(maneuver, bounds)
    slew = maneuver.limits.slew
    return {"lead": high - low} | (
        {} if slew is None else {"slew": 2.0 * tightened(slew, bounds.tighter.get("slew", 0.0))}
    )


def lead_bounds(
    rig: Rig,
    voltages: np.ndarray,
    steps: np.ndarray,
    lag: float,
    window: tuple[float, float],
    at_end: bool,
    bent: bool,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Bounds (2, K) in N of f + lag' df/dt at the ends, or the starts, of the intervals `steps` (K,), and lag' (2, K).

    They hold the commands w + lag dw/dt within a window in V, to first order about voltages w (2, K + 1). Where a
    thrust map is curved, a change of the thrust f changes the slope by which dw/dt follows from df/dt; not if not bent.
    """
    rates = np.diff(rig.thrust(voltages)) / steps
    w = voltages[:, 1:] if at_end else voltages[:, :-1]
    f, slopes = rig.thrust(w), rig.thrust_slope(w)
    bend = (rig.thrust_slope(w + SLOPE_STEP) - rig.thrust_slope(w - SLOPE_STEP)) / (2.0 * SLOPE_STEP)
    ahead = np.clip(lag * rates / slopes, window[0] - w, window[1] - w) if bent else 0.0
    share = 1.0 - ahead * bend / slopes
    share = np.where(share < 0.0, -1.0, 1.0) * np.maximum(np.abs(share), LEAST_SLOPE)
    limits = [f + slopes * (limit - w) / share for limit in window]
    return np.minimum(*limits), np.maximum(*limits), lag / share


def solve_within_limits(
    maneuver: Maneuver,
    optimum,
    start: Spline,
    barrier: float = COLD,
    iterations: int | None = None,
    on_the_way: bool = False,
    check: Callable[[], None] = unlimited,
) -> tuple[Spline, Trajectory] | None:
    """Optimal spline and its trajectory within the limits; None if there is none. `optimum` is `smoothest` or another.

    Path constraints are added when a plan first violates them, or from the beginning with `on_the_way`, and bounds are
    tightened by the excess of a plan between the collocation points. `check` is called before each solution.
    """
    limits = low, high = maneuver.rig.thrust_bounds(maneuver.limits.u)
    tighter: dict[str, float] = {}
    over: dict[str, float] = {}
    on_the_way, voltages, vias = on_the_way or bool(start.by_path), None, np.zeros((len(maneuver.via), 2))
    if start.by_path:
        voltages = maneuver.rig.voltage(np.clip(sample(maneuver, start)[2], *limits))
    lag, linearised = path_limits(maneuver).lead, 0
    above_floor = np.zeros(len(start.coefficients) - REST + 1)
    for _ in range(TIGHTENINGS):
        check()
        bounds = Bounds((low, high), on_the_way, tighter, voltages, vias, iterations, above_floor)
        spline = optimum(maneuver, start, bounds, barrier)
        if spline is None and lag is not None and voltages is not None:  # curvature misleads far from the last plan
            spline = optimum(maneuver, start, bounds._replace(bent=False), barrier)
        if spline is None and over:
            spline = solve_by_homotopy(maneuver, optimum, start, bounds._replace(tighter=over), check)
        if spline is None:
            return None
        t, x, f = sample(maneuver, spline)
        below, above = limits[0] - f.min(), f.max() - limits[1]
        u = maneuver.rig.voltage(np.clip(f, *limits))
        voltages = u if voltages is None or lag is not None else between(voltages, u)
        if lag is not None:
            _, u = leading_commands(t, voltages, lag)
        over = {name: excess for name, excess in excesses(maneuver, t, x, u).items() if excess > ROUNDED}
        missed = passages(maneuver, t, x)
        if max(below, above) <= 0.0 and not over and np.abs(missed).max(initial=0.0) <= VIA_ACCURACY:
            if lag is not None:
                return spline, leading_trajectory(maneuver, t, x, voltages, lag)
            return spline, Trajectory(t, x, u, maneuver.limits, maneuver.rig)
        low, high = low + 1.2 * max(below, 0.0), high - 1.2 * max(above, 0.0)
        linearised += on_the_way
        if on_the_way:
            tighter = tighter | {
                name: tighter.get(name, 0.0) + 1.2 * excess
                for name, excess in over.items()
                if name != "floor" and (name not in LINEARISED or linearised > LINEARISATIONS)
            }
            if "floor" in over:
                above_floor = above_floor + 1.2 * floor_excess(maneuver, x, len(above_floor))
        on_the_way = on_the_way or bool(over)
        vias = vias - missed
        start, barrier = spline, LUKEWARM if over else WARM
    return None


def between(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Mean of the voltages of two plans (2, K) at the same shares of their durations: successive plans swing less."""
    share = np.linspace(0.0, 1.0, after.shape[1])
    return 0.5 * (after + np.stack([np.interp(share, np.linspace(0.0, 1.0, before.shape[1]), row) for row in before]))


def floor_excess(maneuver: Maneuver, x: np.ndarray, knots: int) -> np.ndarray:
    """Largest excess (knots,) in rad over the floor around each knot, at least zero, of states x (6, K)."""
    excess = np.maximum(x[2] - np.interp(x[0], *np.array(maneuver.floor)), 0.0)
    segment = np.minimum(np.arange(len(excess)) * (knots - 1) // (len(excess) - 1), knots - 2)
    most = np.zeros(knots - 1)
    np.maximum.at(most, segment, excess)
    return np.maximum(np.append(most, 0.0), np.append(0.0, most))


def solve_by_homotopy(
    maneuver: Maneuver, optimum, start: Spline, bounds: Bounds, check: Callable[[], None]
) -> Spline | None:
    """Optimum from a start that violates path constraints, by homotopy: their excess is reduced in steps."""
    for share in APPROACH:
        check()
        looser = {name: -share * excess for name, excess in bounds.tighter.items()}
        found = optimum(maneuver, start, bounds._replace(tighter=looser), LUKEWARM)
        if found is None:
            return None
        start = found
    return start


def sample(maneuver: Maneuver, spline: Spline) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times (K,), states (6, K) and thrusts (2, K) of a spline."""
    from heli_gym.baselines.planning.spline_kernel import compiled, interpolate, thrusts_along

    T, segments = spline.duration, len(spline.coefficients) - REST
    t = sample_times(replace(maneuver, duration=T))
    if len(t) - 1 < MANY_SAMPLES * segments:  # thrusts have corners at the knots, which must be samples of quick plans
        each = max(math.ceil((len(t) - 1) / segments), FEWEST_SAMPLES)
        t = np.linspace(0.0, T, each * segments + 1)
    y, dy, ddy = compiled(interpolate)(spline.coefficients, T, len(t))
    (dy1, dy2), damping = dy, travel_damping(maneuver.parameters)
    f, acceleration = compiled(thrusts_along)(y, dy, ddy, maneuver.parameters)
    h = t[1]
    # the undamped part of the travel rate is linear between samples, exact to 1e-7 at this period
    growth = np.exp(damping * t)
    acceleration = growth * acceleration
    ends = maneuver.ends
    deta, eta = np.full(len(t), spline.rate if maneuver.periodic else ends[0, 1]), np.full(len(t), ends[0, 0])
    deta[1:] += np.cumsum(0.5 * h * (acceleration[:-1] + acceleration[1:]))
    if damping:
        deta /= growth
        slope = acceleration / growth - damping * deta
        eta[1:] += np.cumsum(0.5 * h * (deta[:-1] + deta[1:]) + h**2 / 12.0 * (slope[:-1] - slope[1:]))
    else:
        eta[1:] += np.cumsum(h * deta[:-1] + h**2 / 6.0 * (2.0 * acceleration[:-1] + acceleration[1:]))
    x = np.stack((eta, deta, y[0], dy1, y[1], dy2))
    if maneuver.periodic:
        x[:, -1] = x[:, 0] + [maneuver.goal[0] - maneuver.start[0], 0.0, 0.0, 0.0, 0.0, 0.0]
        return t, x, f
    if maneuver.elevation_free:
        ends[1, 2] = x[2, -1]
    x[:, [0, -1]] = ends.T
    return t, x, f
