"""Planning functions, from a Maneuver to a validated Trajectory, by every method."""

import math
import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from heli_gym.baselines.paper.boundary_value import FINE, solve_unconstrained, unconstrained_trajectory
from heli_gym.baselines.planning import spline, spline_search
from heli_gym.baselines.planning.collocation import collocated_trajectory
from heli_gym.baselines.planning.feasibility import (
    ATTEMPTS,
    LENGTHENING,
    SHORTEST,
    InfeasibleManeuver,
    TimeLimit,
    check_scale,
    followed_by_hover,
    infeasible,
    start_clock,
    validated,
)
from heli_gym.baselines.planning.flat import flat_trajectory
from heli_gym.baselines.planning.lead import with_dead_time, without_dead_time
from heli_gym.baselines.planning.paper_method import (
    plan_by_shooting,
    plan_by_shooting_near,
    plan_fastest_paper,
    plan_paper,
)
from heli_gym.baselines.planning.path import check_ends
from heli_gym.parameters import Limits
from heli_gym.trajectory import Maneuver, Trajectory
from heli_gym.validation import is_number, shown

PITCH_RESERVES = (0.0, 1e-4, 1e-3)  # shares of the pitch limits in reserve for the fastest spline's replay error
RESERVE_ACCURACY = 5e-3  # of the largest reserve
EASIER = (1.0, 8.0)  # multiples of an easy duration from which collocation searches for its least time
FLAT_ACCURACY = 1e-3  # relative, of the shortest duration of a flat plan
VOLTS = {"slew": ("V/s", 1.0), "lead": ("V", 1.0)}  # units of path constraints on voltages; others are of angles
WORTH_NAMING = 0.01  # share of the duration, per whole range of a limit, from which the limit counts as binding


def plan_unconstrained(maneuver: Maneuver) -> Trajectory:
    """Trajectory of (14), Section III-B, which ignores the limits.

    Raises InfeasibleManeuver if there is none: short durations require more than 90 degrees of pitch.
    """
    check_scale(maneuver)
    solution = solve_unconstrained(maneuver, FINE)
    if solution is None:
        raise InfeasibleManeuver(
            f"no unconstrained plan for {maneuver}: the pitch would pass 90 degrees; a longer duration is easier"
        )
    return unconstrained_trajectory(maneuver, solution)


def plan(
    maneuver: Maneuver,
    method: str = "auto",
    time_limit: float | None = None,
    near: Trajectory | None = None,
    objective: str | None = None,
    start_state: ArrayLike | None = None,
) -> Trajectory:
    """Plan a trajectory between the maneuver's ends that meets its limits.

    Every returned plan has been validated by a replay through (3) with an adaptive integrator: it ends within 1e-3 rad
    and 1e-3 rad/s of the goal per turn of travel, and meets the limits to 1e-6 V and 1e-6 rad.

    Args:
        maneuver: the transition to plan.
        method: one of
            "paper", which solves (38) with the ansatz (39), (40) by shooting or by collocation, from the unconstrained
            plan as the initial guess. If that fails, it solves a longer, easier duration and shortens it step by step;
            "spline", the smoothest plan with many more free parameters, see `spline`;
            "flat", polynomials in the flat outputs, see `flat`;
            "collocation", the plan of least effort, see `collocation`; the extra `ocp` must be installed;
            "auto", which takes the paper's plan if shooting finds one, otherwise the spline's.
        time_limit: in s, after which the search ends: before the next solution by the interior-point method, of about
            2 s at most; CasADi gets the time left. It includes compilation, about 20 s at the first use after an
            installation.
        near: a plan of a similar maneuver by any method, the initial guess of "paper", "spline" and "auto"; if that
            fails, they start from their usual guess.
        objective: of a spline in the maneuver's duration: "smoothest"; least "effort", the mean squared distance of the
            thrusts from hover at the goal; or most "reserve", the unused share of the voltage and pitch ranges.
            "shortest" is the objective of `plan_fastest`. Where no plan of least effort or of the smoothest thrusts is
            found, mostly just above the shortest duration, a RuntimeWarning says so, and the plan is that of "spline".
        start_state: (6,) instead of the maneuver's start, for example measured in flight; `near` is then the plan in
            flight, and its last part the initial guess.

    Raises:
        ValueError: if the method is unknown or cannot start from a plan, the objective is unknown or of another method,
            an end violates a constraint or is in motion where the method requires rest, or the time limit is not
            positive.
        InfeasibleManeuver: if the method finds no plan (names the binding constraint and the shortest duration that it
            can plan), or after the time limit.
    """
    check_maneuver(maneuver)
    if not isinstance(method, str) or method not in METHODS:
        raise ValueError(f"method = {shown(method)}: must be one of {', '.join(METHODS)}")
    if objective is not None and not (isinstance(objective, str) and objective in OBJECTIVES):
        raise ValueError(f"objective = {shown(objective)}: must be one of {', '.join(OBJECTIVES)}")
    if objective is not None and method not in ("auto", "spline"):
        raise ValueError(f"objective = {objective!r}: must go with method 'auto' or 'spline'")
    if start_state is not None:
        maneuver = replace(maneuver, start_state=start_state)  # type: ignore[arg-type]
    check_method(maneuver, method)
    check_scale(maneuver)
    check_ends(maneuver)
    clock = start_clock(maneuver, time_limit)
    if near is not None:
        if not isinstance(near, Trajectory):
            raise ValueError(f"near = {shown(near)}: must be a Trajectory")
        if method not in NEARBY:
            raise ValueError(
                f"method = {method!r} does not start from another plan: must be one of {', '.join(NEARBY)}"
            )
        if objective is not None:
            raise ValueError(f"objective = {objective!r}: must go without a plan near by")

    def search(maneuver: Maneuver) -> Trajectory:
        if near is not None:
            nearby = spline_near if method == "auto" and not maneuver.is_from_rest_to_rest else NEARBY[method]
            return nearby(maneuver, near, clock) or METHODS[method](maneuver, clock)
        return (METHODS[method] if objective is None else OBJECTIVES[objective])(maneuver, clock)

    return plan_leading(maneuver, search, clock) if maneuver.lead else search(maneuver)


def plan_leading(maneuver: Maneuver, search: Callable[[Maneuver], Trajectory], clock: TimeLimit) -> Trajectory:
    """Plan after the rig's dead time by `search`, with the dead time before it."""
    delay = maneuver.rig.delay
    try:
        trajectory = with_dead_time(search(without_dead_time(maneuver)), delay)
    except InfeasibleManeuver as refusal:
        shortest = refusal.shortest_duration
        if shortest is None or delay == 0.0:
            raise
        raise InfeasibleManeuver(
            f"{refusal}; both durations are those after the rig's dead time of {delay:g} s", shortest + delay
        ) from None
    flown = replace(maneuver, duration=trajectory.duration)
    if validated(flown, trajectory, clock, delay) is None:
        raise infeasible(maneuver, None, clock)
    return trajectory


def plan_fastest(
    maneuver: Maneuver, method: str = "auto", reserve: float = 0.0, time_limit: float | None = None
) -> Trajectory:
    """Plan of the shortest duration that a method finds, at most the maneuver's.

    Args:
        maneuver: the transition to plan.
        method: "spline", "paper", "flat" or "collocation", as of `plan`; "auto" is "spline".
        reserve: share of the voltage range and of the pitch range that the plan leaves to the feedback, half of it at
            each end.
        time_limit: in s, after which the search ends.

    Returns:
        A plan validated like those of `plan`, with the maneuver's own limits.

    Raises:
        ValueError: if an argument is invalid, if start and goal are equal, or if hover at the start or at the goal
            exceeds the reduced ranges.
        InfeasibleManeuver: if the shortest duration found is longer than the maneuver's, or after the time limit.
    """
    check_maneuver(maneuver)
    if not isinstance(method, str) or method not in FASTEST:
        raise ValueError(f"method = {shown(method)}: must be one of {', '.join(FASTEST)}")
    if not (is_number(reserve) and 0.0 <= reserve < 1.0):
        raise ValueError(f"reserve = {shown(reserve)}: must be at least 0 and less than 1")
    if maneuver.start == maneuver.goal and maneuver.is_from_rest_to_rest:
        raise ValueError(f"goal = {maneuver.goal}: must differ from the start")
    check_scale(maneuver)
    check_ends(maneuver)
    check_method(maneuver, method)
    if any(time is not None for time, *_ in maneuver.via):
        raise ValueError(f"via = {maneuver.via}: must be without times to be passed as fast as possible")
    requested = replace(maneuver, limits=with_reserve(maneuver.limits, reserve))
    clock = start_clock(maneuver, time_limit)

    def search(maneuver: Maneuver) -> Trajectory:
        return FASTEST[method](maneuver, clock)

    fastest = plan_leading(requested, search, clock) if maneuver.lead else search(requested)
    return replace(fastest, limits=maneuver.limits)


def check_method(maneuver: Maneuver, method: str) -> None:
    """Raise ValueError for a method that only plans from rest to rest, if the maneuver is another one."""
    if not maneuver.is_from_rest_to_rest and method not in GENERAL:
        raise ValueError(
            f"method = {method!r} plans from rest to rest: must be one of {', '.join(GENERAL)} for ends in motion, a "
            "free elevation, via points, and periodic flights"
        )


def check_maneuver(maneuver: Any) -> None:
    """Raise ValueError unless the argument is a maneuver."""
    if not isinstance(maneuver, Maneuver):
        raise ValueError(f"maneuver = {shown(maneuver)}: must be a Maneuver")


def with_reserve(limits: Limits, reserve: float) -> Limits:
    """Limits with voltage and pitch ranges narrowed by a share about the same centres."""
    (u_min, u_max), (pitch_min, pitch_max) = (
        (low + 0.5 * reserve * (high - low), high - 0.5 * reserve * (high - low))
        for low, high in (limits.u, limits.pitch)
    )
    return replace(limits, u_min=u_min, u_max=u_max, pitch_min=pitch_min, pitch_max=pitch_max)


# The methods


def plan_auto(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """The paper's plan if shooting finds one, otherwise a spline, otherwise a plan by another method."""
    if not maneuver.is_from_rest_to_rest:
        return first_plan(("spline", "collocation"), METHODS, maneuver, clock)
    trajectory = plan_by_shooting(maneuver, clock)
    if trajectory is not None:
        return trajectory
    try:
        return plan_spline(maneuver, clock)
    except InfeasibleManeuver as refusal:
        clock.check()
        if refusal.shortest_duration is not None and refusal.shortest_duration > maneuver.duration:
            raise
    fastest = plan_fastest_auto(maneuver, clock)
    trajectory = validated(maneuver, followed_by_hover(fastest, maneuver), clock)
    if trajectory is None:
        raise infeasible(maneuver, fastest, clock)
    return trajectory


def plan_fastest_auto(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Fastest spline, otherwise the fastest plan by another method."""
    names = ("spline", "collocation", "flat", "paper") if maneuver.is_from_rest_to_rest else ("spline", "collocation")
    return first_plan(names, FASTEST, maneuver, clock)


def first_plan(names: tuple[str, ...], methods: dict, maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Plan of the first method that finds one; the first error with a shortest duration ends the search."""
    refusals = []
    for name in names:
        try:
            return methods[name](maneuver, clock)
        except ImportError:  # CasADi is missing
            continue
        except InfeasibleManeuver as refusal:
            clock.check()
            if refusal.shortest_duration is not None:
                raise
            refusals.append(refusal)
    raise refusals[0]


def auto_near(maneuver: Maneuver, near: Trajectory, clock: TimeLimit) -> Trajectory | None:
    """Plan by shooting or splines with a plan of a similar maneuver as the guess; None if that fails."""
    return (
        plan_by_shooting_near(maneuver, near, clock)
        or plan_by_shooting(maneuver, clock)
        or spline_near(maneuver, near, clock)
    )


def spline_near(maneuver: Maneuver, near: Trajectory, clock: TimeLimit) -> Trajectory | None:
    """Smoothest spline from a plan of a similar maneuver; None if that fails.

    From a measured state, raises InfeasibleManeuver with the shortest duration if that is longer than the maneuver's.
    """
    if maneuver.start_state is None or maneuver.via:
        return validated(maneuver, spline_search.plan_near(maneuver, near, clock.check), clock)
    found = validated(maneuver, spline_search.replan(maneuver, near, is_fixed=True), clock)
    if found is not None:
        return found
    fastest = spline_search.fastest_from(maneuver)
    if fastest is not None and fastest.duration > maneuver.duration:
        raise slower_than_requested(maneuver, fastest)
    found = validated(maneuver, spline_search.replan(maneuver, near, is_fixed=False), clock)
    if found is None and fastest is not None:
        found = validated(maneuver, spline_search.plan_lengthened(maneuver, fastest, clock.check), clock)
    if found is not None:
        return found
    for longer_by in spline_search.LADDER:  # short plans, of which the solver finds no fastest one
        longer = replace(maneuver, duration=maneuver.duration + longer_by)
        found = validated(longer, spline_search.plan_few(longer), clock)
        if found is not None:
            if longer_by == 0.0:
                return found
            raise InfeasibleManeuver(
                f"no plan for {maneuver}; the shortest found takes {longer.duration:.2f} s", longer.duration
            )
    return None


def plan_spline(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Smoothest spline from the initial guess, otherwise by lengthening the fastest spline if that is short enough."""
    trajectory = validated(maneuver, spline_search.plan_smoothest(maneuver, check=clock.check), clock)
    if trajectory is not None:
        return trajectory
    if any(time is not None for time, *_ in maneuver.via):
        raise infeasible_via(maneuver, clock)
    fastest, trajectory = fastest_spline(maneuver, clock)
    if fastest.duration > maneuver.duration:
        raise slower_than_requested(maneuver, fastest)
    lengthened = validated(maneuver, spline_search.plan_lengthened(maneuver, fastest, clock.check), clock)
    if lengthened is None and maneuver.goal_state is None and not maneuver.periodic:
        lengthened = validated(maneuver, followed_by_hover(trajectory, maneuver), clock)
    if lengthened is None:
        raise infeasible(maneuver, trajectory, clock)
    return lengthened


def infeasible_via(maneuver: Maneuver, clock: TimeLimit) -> InfeasibleManeuver:
    """Make the error for via points in given times: names those without which there is a plan."""
    for k in range(len(maneuver.via)):
        others = replace(maneuver, via=maneuver.via[:k] + maneuver.via[k + 1 :])
        if validated(others, spline_search.plan_smoothest(others, check=clock.check)) is not None:
            return InfeasibleManeuver(
                f"no plan found for {maneuver}; without via[{k}] = {maneuver.via[k]} there is one"
            )
    return infeasible(maneuver, None, clock)


def plan_fastest_spline(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Spline of the shortest duration."""
    fastest, trajectory = fastest_spline(maneuver, clock)
    if fastest.duration > maneuver.duration:
        raise slower_than_requested(maneuver, fastest)
    return trajectory


def plan_objective(maneuver: Maneuver, clock: TimeLimit, name: str, optimum: Callable) -> Trajectory:
    """Spline for an objective in the maneuver's duration; if that fails, the plan of `plan_spline`, with a warning."""
    found = validated(maneuver, spline_search.plan_smoothest(maneuver, optimum, clock.check), clock)
    if found is not None:
        return found
    found = plan_spline(maneuver, clock)
    message = f"objective = {name!r}: no plan found for {maneuver}; this one is without the objective"
    warnings.warn(message, RuntimeWarning, stacklevel=4)
    return found


def plan_reserve(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Smoothest spline in the narrowest voltage and pitch ranges, found by bisection of the reserve."""
    best, low, high = plan_spline(maneuver, clock), 0.0, 1.0
    while high - low > RESERVE_ACCURACY:
        share = 0.5 * (low + high)
        try:
            narrower = replace(maneuver, limits=with_reserve(maneuver.limits, share))
        except ValueError:  # hover exceeds the narrowed limits
            high = share
            continue
        near = spline_search.plan_near(narrower, best, clock.check)
        found = validated(narrower, near or spline_search.plan_smoothest(narrower, check=clock.check))
        if found is None:
            high = share
        else:
            best, low = found, share
    return replace(best, limits=maneuver.limits)


def slower_than_requested(maneuver: Maneuver, fastest: spline.Spline) -> InfeasibleManeuver:
    """Make the error for a maneuver that is shorter than the fastest spline."""
    return InfeasibleManeuver(
        f"no plan for {maneuver}; the shortest found takes {fastest.duration:.2f} s: "
        f"{binding_limits(maneuver, fastest)}",
        fastest.duration,
    )


def fastest_spline(maneuver: Maneuver, clock: TimeLimit) -> tuple[spline.Spline, Trajectory]:
    """Fastest spline and its validated trajectory. Raises InfeasibleManeuver if there is none."""
    limits = maneuver.limits
    # the commands of plans that lead are sampled anew after the dead time, which must not exceed the limits either
    for share in PITCH_RESERVES[1:] if maneuver.lead else PITCH_RESERVES:
        pitch_min, pitch_max = (1.0 - share) * limits.pitch_min, (1.0 - share) * limits.pitch_max
        narrower = replace(maneuver, limits=replace(limits, pitch_min=pitch_min, pitch_max=pitch_max))
        found = spline_search.plan_fastest(narrower, clock.check)
        if found is None:
            break
        fastest = found[0]
        at_once = replace(maneuver, duration=fastest.duration)
        trajectory = validated(at_once, replace(found[1], limits=limits), clock)
        if trajectory is not None:
            return fastest, trajectory
    raise infeasible(maneuver, None, clock)


def binding_limits(maneuver: Maneuver, fastest: spline.Spline) -> str:
    """Message about the binding limits of the fastest plan, with the time saved by relaxing each, from multipliers."""
    limits = maneuver.limits
    low, high, pitch_low, pitch_high = fastest.duration * fastest.multipliers
    slope_low, slope_high = maneuver.rig.thrust_slope(np.array(limits.u) * np.ones((2, 1))).max(axis=0)
    degree = math.pi / 180.0
    savings = {
        f"the lower voltage limit (1 V less would save {low * slope_low:.2g} s)": low * slope_low,
        f"the upper voltage limit (1 V more would save {high * slope_high:.2g} s)": high * slope_high,
        f"the pitch limits (1 degree more would save {(pitch_low + pitch_high) * degree:.2g} s)": (
            (pitch_low + pitch_high) * max(limits.pitch)
        ),
    }
    savings |= {
        f"{name} (1 {unit} more would save {fastest.duration * value * by:.2g} s)": fastest.duration * value * by
        for name, value in fastest.by_path
        for unit, by in [VOLTS.get(name) or ("deg/s" if "rate" in name else "degree", degree)]
    }
    named = [name for name, saving in savings.items() if saving > WORTH_NAMING * fastest.duration]
    return f"in the way are {' and '.join(named)}" if named else "none of its limits stands out as the cause"


def plan_flat(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Plan with polynomials in the flat outputs."""
    trajectory = validated(maneuver, flat_trajectory(maneuver), clock)
    if trajectory is None:
        raise infeasible(maneuver, flat_above(maneuver, maneuver.duration, clock), clock)
    return trajectory


def plan_fastest_flat(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Fastest plan with polynomials in the flat outputs."""
    fastest = flat_above(maneuver, 0.0, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise infeasible(maneuver, fastest, clock)
    return fastest


def flat_above(maneuver: Maneuver, shortest: float, clock: TimeLimit) -> Trajectory | None:
    """Shortest flat plan of a duration above `shortest`, by bisection; None if there is none."""

    def attempt(duration: float) -> Trajectory | None:
        clock.check()
        longer = replace(maneuver, duration=duration)
        return validated(longer, flat_trajectory(longer), clock)

    slow, best = max(shortest, SHORTEST), None
    for _ in range(ATTEMPTS):
        best = attempt(slow)
        if best is not None:
            break
        shortest, slow = slow, LENGTHENING * slow
    while best is not None and best.duration - shortest > FLAT_ACCURACY * best.duration:
        middle = 0.5 * (shortest + best.duration)
        faster = attempt(middle)
        best, shortest = (best, middle) if faster is None else (faster, shortest)
    return best


def plan_collocation(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Plan of least effort, by direct collocation."""
    trajectory = validated(maneuver, collocated_trajectory(maneuver, "effort", clock.left), clock)
    if trajectory is None:
        clock.check()
        raise infeasible(maneuver, collocated_above(maneuver, clock), clock)
    return trajectory


def plan_fastest_collocation(maneuver: Maneuver, clock: TimeLimit) -> Trajectory:
    """Plan of least time, by direct collocation."""
    fastest = collocated_above(maneuver, clock)
    if fastest is None or fastest.duration > maneuver.duration:
        raise infeasible(maneuver, fastest, clock)
    return fastest


def collocated_above(maneuver: Maneuver, clock: TimeLimit) -> Trajectory | None:
    """Plan of least time by direct collocation, regardless of the maneuver's duration; None if there is none.

    Nor do the initial guesses depend on it: a longer duration must not be refused where a shorter one is planned.
    """
    easy = spline_search.easy_duration(maneuver)
    is_timed = any(time is not None for time, *_ in maneuver.via)
    found = []
    for duration in [max(maneuver.duration, easy)] if is_timed else [stretch * easy for stretch in EASIER]:
        trajectory = collocated_trajectory(replace(maneuver, duration=duration), "time", clock.left)
        clock.check()
        if trajectory is not None:
            found.append(validated(replace(maneuver, duration=trajectory.duration), trajectory, clock))
    return min((one for one in found if one is not None), key=lambda one: one.duration, default=None)


GENERAL = "auto", "spline", "collocation"  # methods for all maneuvers
METHODS: dict[str, Callable[[Maneuver, TimeLimit], Trajectory]] = {
    "auto": plan_auto,
    "paper": plan_paper,
    "spline": plan_spline,
    "flat": plan_flat,
    "collocation": plan_collocation,
}
NEARBY: dict[str, Callable[[Maneuver, Trajectory, TimeLimit], Trajectory | None]] = {
    "auto": auto_near,
    "paper": plan_by_shooting_near,
    "spline": spline_near,
}
OBJECTIVES: dict[str, Callable[[Maneuver, TimeLimit], Trajectory]] = {
    "shortest": plan_fastest_auto,
    "effort": partial(plan_objective, name="effort", optimum=spline.least_effort),
    "reserve": plan_reserve,
    "smoothest": partial(plan_objective, name="smoothest", optimum=spline.least_rates),
}
FASTEST: dict[str, Callable[[Maneuver, TimeLimit], Trajectory]] = {
    "auto": plan_fastest_auto,
    "spline": plan_fastest_spline,
    "paper": plan_fastest_paper,
    "flat": plan_fastest_flat,
    "collocation": plan_fastest_collocation,
}
