"""Replays, bounds and refusals of plans, against an independent integrator and an optimal-control solver."""

import itertools
import math
import re
import signal
from contextlib import contextmanager
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from independent import TABLE_I, central_differences, equation_2, replay, shortest_time
from numpy.testing import assert_allclose
from scipy.optimize import root

from heli_gym import HelicopterParameters, Limits, Maneuver
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest, plan_unconstrained
from heli_gym.baselines.paper.boundary_value import FINE, ConstrainedProblem, solve_unconstrained
from heli_gym.baselines.planning import feasibility as search
from heli_gym.baselines.planning.planner import FASTEST, METHODS


def maneuver(start, goal, duration, pitch_deg=(-50.0, 50.0), u=(1.0, 11.0), **parameters) -> Maneuver:
    """A maneuver between (travel, elevation) in degrees."""
    limits = Limits(*u, *(math.radians(pitch) for pitch in pitch_deg))
    points = (tuple(math.radians(angle) for angle in point) for point in (start, goal))
    return Maneuver(*points, duration, limits, HelicopterParameters(**parameters))


MANEUVERS = {
    "the paper's": Maneuver(),
    "half a turn": maneuver((0, 0), (180, 0), 8),
    "two turns": maneuver((0, 0), (720, 0), 15),
    "two turns back": maneuver((0, 0), (-720, 0), 16),
    "climb on the spot": maneuver((0, 0), (0, -10), 4),
    "descend and turn": maneuver((0, -18), (45, 15), 10),
    "climb and turn": maneuver((0, 10), (90, -15), 8),
    "start elsewhere": maneuver((100, -5), (-80, 5), 9),
    "little pitch to one side": maneuver((0, 0), (360, 0), 12, pitch_deg=(-60, 25)),
    "little pitch": maneuver((0, 0), (360, 0), 22, pitch_deg=(-10, 10)),
    "few volts": maneuver((0, 0), (180, 0), 9, u=(3, 10)),
    "fans may reverse": maneuver((0, 0), (270, 0), 9, u=(-4, 12)),
    "stay": maneuver((30, 5), (30, 5), 5),
    "a heavier helicopter": maneuver((0, 0), (360, 0), 12, b1=-0.58, b2=-0.6),
}


PLANNED = {
    f"{name}, {method}": (method, maneuver)
    for name, maneuver in MANEUVERS.items()
    for method in ("paper", "spline")
    if (name, method) != ("stay", "spline")  # of which there is nothing to compare
}
PLANNED |= {
    "the paper's in more time, flat": ("flat", replace(Maneuver(), duration=12.0)),
    "descend and turn, flat": ("flat", maneuver((0, -18), (45, 15), 14)),
    "the paper's, collocation": ("collocation", Maneuver()),
    "few volts, collocation": ("collocation", MANEUVERS["few volts"]),
    "close to what is possible, auto": ("auto", replace(Maneuver(), duration=8.5)),
    "little pitch, two turns, auto": ("auto", maneuver((0, 5), (720, -8), 24, pitch_deg=(-12, 12))),
}


@pytest.fixture(scope="module", params=PLANNED.values(), ids=PLANNED.keys())
def planned(request):
    method, maneuver = request.param
    return maneuver, plan(maneuver, method)


def test_a_plan_flown_through_equation_3_arrives_within_its_limits(planned):
    maneuver, trajectory = planned
    flown = replay(trajectory, maneuver.parameters)
    for k, (travel, elevation) in ((0, maneuver.start), (-1, maneuver.goal)):
        assert_allclose(flown[:, k], [travel, 0.0, elevation, 0.0, 0.0, 0.0], rtol=0.0, atol=1e-3)
    assert_allclose(flown, trajectory.x, rtol=0.0, atol=1e-3)
    low, high = maneuver.limits.pitch
    for pitch in (flown[4], trajectory.x[4]):
        assert low - 1e-6 <= pitch.min() <= pitch.max() <= high + 1e-6
    low, high = maneuver.limits.u
    assert low - 1e-6 <= trajectory.u.min() <= trajectory.u.max() <= high + 1e-6


def test_a_plan_is_sampled_every_millisecond_from_rest_to_rest(planned):
    maneuver, trajectory = planned
    assert trajectory.duration == maneuver.duration
    assert np.diff(trajectory.t).max() <= 1.001e-3
    assert trajectory.limits == maneuver.limits
    for k, (travel, elevation) in ((0, maneuver.start), (-1, maneuver.goal)):
        assert_allclose(trajectory.x[:, k], [travel, 0.0, elevation, 0.0, 0.0, 0.0], rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("method", ["paper", "spline", "flat"])
@pytest.mark.parametrize("start, goal", [((0.0, 0.0), (2.0 * math.pi, 0.0)), ((1.0, -0.1), (-1.0, 0.2))])
def test_plans_but_those_of_least_effort_start_and_end_with_the_voltages_of_hover(method, start, goal):
    requested = Maneuver(start, goal, 13.0)
    trajectory, p = plan(requested, method), requested.parameters
    for k, (_, q2) in ((0, start), (-1, goal)):
        v1 = -(p.a1 * math.sin(q2) + p.a2 * math.cos(q2)) / p.b2
        assert_allclose([equation_2(u) for u in trajectory.u[:, k]], 0.5 * v1, atol=1e-6)


@pytest.mark.parametrize("name", [name for name in MANEUVERS if name != "stay"])
def test_no_plan_is_faster_than_optimal_control(name):
    assert shortest_time(MANEUVERS[name], plan(MANEUVERS[name])) < MANEUVERS[name].duration


@pytest.mark.parametrize(("pitch_deg", "shortest"), [(50.0, 8.23), (89.0, 7.50)])
def test_the_shortest_time_of_any_control_is_the_one_measured_in_the_notes(paper_plan, pitch_deg, shortest):
    relaxed = maneuver((0, 0), (360, 0), 10, pitch_deg=(-pitch_deg, pitch_deg))
    assert shortest_time(relaxed, paper_plan, intervals=100) == pytest.approx(shortest, abs=0.01)


@pytest.mark.parametrize("method", ["paper", "spline"])
def test_the_mirrored_maneuver_is_the_mirrored_flight(method):
    straight, mirrored = (plan(replace(Maneuver(), goal=(travel, 0.0)), method) for travel in (6.0, -6.0))
    assert_allclose(mirrored.x, straight.x * [[-1.0], [-1.0], [1.0], [1.0], [-1.0], [-1.0]], atol=1e-4)
    assert_allclose(mirrored.u, straight.u[::-1], atol=1e-3)


def test_where_travel_starts_does_not_matter(paper_plan):
    elsewhere = plan(Maneuver(start=(-3.0, 0.0), goal=(2.0 * math.pi - 3.0, 0.0)))
    assert_allclose(elsewhere.x[1:], paper_plan.x[1:], atol=1e-4)
    assert_allclose(elsewhere.x[0], paper_plan.x[0] - 3.0, atol=1e-4)


@pytest.mark.parametrize("method", METHODS)
def test_the_same_maneuver_gives_the_same_plan(method):
    first, again = (plan(Maneuver(duration=12.0), method) for _ in range(2))
    np.testing.assert_array_equal(again.x, first.x)
    np.testing.assert_array_equal(again.u, first.u)


def test_by_default_the_papers_maneuver_is_planned_as_in_the_paper(paper_plan):
    papers = plan(Maneuver(), "paper")
    np.testing.assert_array_equal(paper_plan.u, papers.u)


# From a plan near by


@pytest.mark.parametrize("method", ["auto", "paper", "spline"])
@pytest.mark.parametrize("like", [replace(Maneuver(), duration=10.1), maneuver((10, 2), (368, -1), 10.2)], ids=str)
@pytest.mark.parametrize("its_method", ["paper", "spline"])
def test_a_plan_from_one_near_by_is_the_one_from_scratch(method, like, its_method):
    near = plan(like, its_method)
    found, expected = plan(Maneuver(), method, near=near), plan(Maneuver(), method)
    assert_allclose(found.x, expected.x, atol=5e-3)
    assert found.limits == expected.limits


@pytest.mark.parametrize("method", ["auto", "paper", "spline"])
def test_a_plan_near_by_spares_the_search(method, monkeypatch):
    near = plan(Maneuver(duration=10.1), method)
    monkeypatch.setitem(METHODS, method, None)
    assert plan(Maneuver(), method, near=near).duration == 10.0


@pytest.mark.parametrize("method", ["auto", "paper", "spline"])
@pytest.mark.parametrize("like", ["stay", "two turns back", "little pitch"])
def test_a_plan_far_away_does_no_harm(method, like):
    requested = MANEUVERS["the paper's"]
    found = plan(requested, method, near=plan(MANEUVERS[like]))
    flown = replay(found)
    assert_allclose(flown[:, -1], [2.0 * math.pi, 0.0, 0.0, 0.0, 0.0, 0.0], rtol=0.0, atol=1e-3)


def test_an_infeasible_maneuver_stays_infeasible_with_an_initial_guess(paper_plan):
    with pytest.raises(InfeasibleManeuver, match="the shortest found takes"):
        plan(Maneuver(duration=8.0), near=paper_plan)


@pytest.mark.parametrize(
    ("method", "near", "said"),
    [("flat", None, "method = 'flat'.*paper, spline"), ("collocation", None, "auto"), ("paper", Maneuver(), "near = ")],
)
def test_an_invalid_start_is_named(method, near, said, paper_plan):
    with pytest.raises(ValueError, match=said):
        plan(Maneuver(), method, near=near or paper_plan)


# Section III-B


@pytest.mark.parametrize("goal", [(2.0 * math.pi, 0.0), (-math.pi, 0.1)])
def test_the_unconstrained_plan_solves_14_by_quadrature_and_root_finding_too(goal):
    maneuver, p = Maneuver(goal=goal), TABLE_I
    s, weights = np.polynomial.legendre.leggauss(80)
    s, weights, T = 0.5 * (s + 1.0), 0.5 * weights * maneuver.duration, maneuver.duration
    rise, ddrise = 10 * s**3 - 15 * s**4 + 6 * s**5, (60 * s - 180 * s**2 + 120 * s**3) / T**2
    y1, ddy1 = goal[1] * rise, goal[1] * ddrise

    def misses(parameters):
        y2 = s**3 * (1.0 - s) ** 3 * (parameters[0] + parameters[1] * s)
        ddeta = p.b1 / p.b2 * np.tan(y2) * (ddy1 - p.a1 * np.sin(y1) - p.a2 * np.cos(y1)) * np.cos(y1)
        return weights @ ddeta, weights @ (T * (1.0 - s) * ddeta) - goal[0]

    found = root(misses, np.zeros(2), tol=1e-12)
    assert found.success
    solution = solve_unconstrained(maneuver, FINE)
    assert_allclose(solution.p, found.x, rtol=1e-4)


@pytest.mark.parametrize("goal", [(2.0 * math.pi, 0.0), (-math.pi, 0.1)])
def test_the_unconstrained_plan_arrives_when_flown_through_equation_3(goal):
    trajectory = plan_unconstrained(Maneuver(goal=goal))
    assert_allclose(replay(trajectory), trajectory.x, rtol=0.0, atol=1e-4)
    assert_allclose(trajectory.x[:, -1], [goal[0], 0.0, goal[1], 0.0, 0.0, 0.0], atol=1e-4)


def test_an_unconstrained_plan_that_would_pitch_beyond_90_degrees_is_infeasible():
    with pytest.raises(InfeasibleManeuver, match="pitch would pass 90 degrees"):
        plan_unconstrained(Maneuver(duration=4.0))


# The analytic Jacobian of (38)


@pytest.mark.parametrize("name", ["the paper's", "fans may reverse"])
def test_the_analytic_jacobian_of_38_agrees_with_differences_on_all_branches(name):
    problem, rng, n = ConstrainedProblem(MANEUVERS[name]), np.random.default_rng(0), 200
    T, branches = problem.maneuver.duration, set()
    for p in rng.uniform(-1.0, 1.0, (12, 6)) * [3.0, 3.0, 15.0, 15.0, 15.0, 15.0]:
        t = rng.uniform(0.0, T, n)
        Y = rng.uniform(-1.0, 1.0, (6, n)) * np.array([[0.4], [1.0], [1.5], [1.5], [6.0], [1.0]])

        def rhs(z, t=t, Y=Y, p=p):
            return problem.rhs(t, Y + z[:6, None], p + z[6:])

        step, z = 1e-6, np.zeros(12)
        bend = np.stack([rhs(step * e) - 2.0 * rhs(z) + rhs(-step * e) for e in np.eye(12)]) / step
        smooth = np.abs(bend).max(axis=(0, 1)) < 1e-3  # elsewhere a corner of a ramp lies in between
        assert smooth.mean() > 0.95
        analytic = np.concatenate(problem.rhs_jacobian(t, Y, p), axis=1)
        assert_allclose(analytic[..., smooth], central_differences(rhs, z, step)[..., smooth], rtol=1e-5, atol=1e-6)

        _, ddy1, _, dxi2, _, _ = rhs(z)
        phi1 = sum(p[k - 1] * ((t / T) ** (k + 1) - t / T) for k in (1, 2))
        phi2 = sum(p[k + 1] * ((t / T) ** (k + 1) - t / T) for k in (1, 2, 3, 4))
        saturated = (np.sign(np.where(np.isclose(a, b), 0.0, a - b)) for a, b in ((ddy1, phi1), (dxi2, phi2)))
        branches |= set(zip(*(side[smooth] for side in saturated)))
    # with v2 on a bound of (18) the bounds (20) of v1 meet, so that v1 is on them too
    assert branches == set(itertools.product((-1.0, 0.0, 1.0), repeat=2)) - {(0.0, -1.0), (0.0, 1.0)}


# What cannot be planned


@contextmanager
def at_most(seconds: float):
    """Raises TimeoutError after so many seconds of computing."""

    def stop(*_):
        raise TimeoutError(f"still computing after {seconds} s")

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("requested", [maneuver((0, 0), (0, -10), 0.5), maneuver((0, 0), (360, 0), 8)], ids=str)
def test_an_infeasible_maneuver_names_its_binding_limits_and_a_feasible_duration(requested, method):
    said = r"in the way .* voltage limit" if method in ("auto", "spline") else "its pitch reaches|its voltages ride"
    with at_most(15.0), pytest.raises(InfeasibleManeuver, match=said) as refusal:
        plan(requested, method)
    shortest = refusal.value.shortest_duration
    assert f"{shortest:.2f} s" in str(refusal.value)
    assert shortest > requested.duration
    if method != "collocation":  # at the very shortest, there is no least effort to look for
        assert plan(replace(requested, duration=shortest), method).duration == shortest


@pytest.mark.parametrize("method", ["paper", "spline"])
def test_a_longer_time_than_one_that_works_works_too(method):
    # hover at the goal would fill the rest
    half_turn = maneuver((0, 0), (180, 0), 5)
    with pytest.raises(InfeasibleManeuver) as refusal:
        plan(half_turn, method)
    longer = replace(half_turn, duration=max(7.0, 1.05 * refusal.value.shortest_duration))
    assert plan(longer, method).duration == longer.duration


def test_a_relaxed_binding_limit_saves_the_stated_time():
    with pytest.raises(InfeasibleManeuver) as refusal:
        plan(Maneuver(duration=8.0), "spline")
    said = str(refusal.value)
    volt = float(re.search(r"upper voltage limit \(1 V more would save ([\d.]+) s\)", said)[1])
    degree = float(re.search(r"pitch limits \(1 degree more would save ([\d.]+) s\)", said)[1])
    narrow, more_volts, more_pitch = (
        plan_fastest(maneuver((0, 0), (360, 0), 10, pitch_deg=(-pitch, pitch), u=(1.0, u_max))).duration
        for pitch, u_max in ((50.0, 11.0), (50.0, 11.1), (51.0, 11.0))
    )
    assert 10.0 * (narrow - more_volts) == pytest.approx(volt, rel=0.1)
    assert narrow - more_pitch == pytest.approx(degree, rel=0.1)


@pytest.mark.parametrize("method", METHODS)
def test_a_time_limit_ends_the_search(method, monkeypatch):
    clock = itertools.count(0, 3)  # three seconds for every look at it
    monkeypatch.setattr(search.time, "perf_counter", lambda: float(next(clock)))
    with pytest.raises(InfeasibleManeuver, match="within the time limit of 2 s") as refusal:
        plan(Maneuver(duration=7.0), method, time_limit=2.0)
    assert refusal.value.shortest_duration is None


@pytest.mark.parametrize("time_limit", [0.0, -1.0, math.nan])
def test_an_invalid_time_limit_is_named(time_limit):
    with pytest.raises(ValueError, match="time_limit = "):
        plan(Maneuver(), time_limit=time_limit)


@pytest.mark.parametrize("method", METHODS)
def test_a_maneuver_of_minutes_is_planned_in_seconds(method):
    with at_most(10.0):
        plan(maneuver((0, 0), (360, 0), 200), method)


@pytest.mark.parametrize(
    ("requested", "like"),
    [(maneuver((0, 0), (360, 0), 8), "the paper's"), (maneuver((0, 0), (0, -10), 0.5), "climb on the spot")],
)
def test_some_refused_maneuvers_are_infeasible_for_any_control(requested, like):
    assert shortest_time(requested, plan(MANEUVERS[like])) > requested.duration


def test_an_unknown_method_is_named_with_those_there_are():
    with pytest.raises(ValueError, match=r"method = 'flatness': .*paper"):
        plan(Maneuver(), method="flatness")


# Any rig, any duration

ROW = Maneuver(
    (0.0, -0.0458),
    (5.98, 0.0189),
    60.0,
    Limits(1.59, 11.83, -0.4116, 0.4116),
    HelicopterParameters(0.0231, -0.0106, -1.22, 2.27, -5.66, -0.914, -0.911, 6.32),
)


def random_rig_maneuver(rng) -> Maneuver:
    """A maneuver of a rig that hovers, its coefficients and limits drawn from wide ranges."""
    while True:
        k_plus, k_minus, a1, a2, a3, b1, b2, b3 = (
            sign * math.exp(rng.uniform(math.log(low), math.log(high)))
            for sign, low, high in (
                (1.0, 2e-3, 3e-2),
                (-1.0, 5e-4, 1e-2),
                (-1.0, 0.3, 3.0),
                (1.0, 0.2, 3.0),
                (-1.0, 0.1, 8.0),
                (-1.0, 0.3, 1.5),
                (-1.0, 0.3, 1.5),
                (1.0, 1.0, 10.0),
            )
        )
        friction = rng.uniform(0.0, 0.2), rng.uniform(0.0, 0.3), rng.uniform(0.0, 0.5)
        parameters = HelicopterParameters(k_plus, k_minus, a1, a2, a3, b1, b2, b3, *friction)
        pitch = math.radians(rng.uniform(10.0, 70.0))
        limits = Limits(rng.uniform(0.0, 3.0), rng.uniform(9.0, 12.0), -pitch, pitch)
        start, goal = rng.uniform(-0.35, 0.35, 2)
        try:
            return Maneuver((0.0, start), (rng.uniform(-12.0, 12.0), goal), 1000.0, limits, parameters)
        except ValueError:
            continue


def test_a_rig_that_the_spline_could_not_plan_is_planned():
    assert plan_fastest(ROW).duration < 4.8
    for duration in (4.8, 8.0, 60.0):
        assert plan(replace(ROW, duration=duration)).duration == duration


@pytest.mark.parametrize("seed", range(8))
def test_the_fastest_plan_of_any_rig_is_planned_in_every_longer_time(seed):
    requested = random_rig_maneuver(np.random.default_rng([5, seed]))
    fastest = plan_fastest(requested)
    for ratio in (1.0, 1.02, 1.5, 5.0, 20.0):
        longer = replace(requested, duration=ratio * fastest.duration)
        trajectory = plan(longer)
        assert trajectory.duration == longer.duration
        assert_allclose(trajectory.x[:, -1], [longer.goal[0], 0.0, longer.goal[1], 0.0, 0.0, 0.0], atol=1e-9)
        assert trajectory.u.min() >= longer.limits.u_min - 1e-6
        assert trajectory.u.max() <= longer.limits.u_max + 1e-6


def test_sixty_turns_are_planned():
    requested = Maneuver(goal=(120.0 * math.pi, 0.0), duration=200.0)
    assert np.abs(replay(plan(requested))[:, -1] - [120.0 * math.pi, 0.0, 0.0, 0.0, 0.0, 0.0]).max() < 0.06


@pytest.mark.parametrize("method", METHODS)
def test_elevation_may_be_positive_upwards(method):
    parameters = HelicopterParameters(a2=-0.3946, b2=0.6523)
    requested = Maneuver(goal=(2.0 * math.pi, 0.1), duration=12.0, parameters=parameters)
    trajectory = plan(requested, method)
    assert_allclose(replay(trajectory, parameters)[:, -1], [2.0 * math.pi, 0.0, 0.1, 0.0, 0.0, 0.0], atol=1e-3)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("friction", [{"c1": 0.12}, {"c2": 0.3, "c3": 0.5}], ids=str)
def test_every_method_knows_friction(method, friction):
    parameters = HelicopterParameters(**friction)
    trajectory = plan(Maneuver(duration=14.0, parameters=parameters), method)
    table = SimpleNamespace(**parameters._asdict())
    assert_allclose(replay(trajectory, table)[:, -1], [2.0 * math.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-3)


@pytest.mark.parametrize(
    ("requested", "said"),
    [
        (Maneuver(duration=1e5), "duration = 100000: must be"),
        (Maneuver(duration=1e-300), "duration = 1e-300: must be"),
        (Maneuver(duration=1e300), r"duration = 1e\+300: must be"),
        (Maneuver(goal=(1e9, 0.0)), "goal = .*: must be within"),
    ],
    ids=str,
)
@pytest.mark.parametrize("planner", [plan, plan_fastest, plan_unconstrained])
def test_a_maneuver_beyond_all_scales_is_refused_by_name(planner, requested, said):
    with pytest.raises(ValueError, match=said):
        planner(requested)


def test_a_plan_of_hours_has_no_more_samples_than_one_of_minutes():
    trajectory = plan(Maneuver(duration=1e4), time_limit=60.0)
    assert trajectory.duration == 1e4
    assert len(trajectory.t) <= 200_001


def test_a_fast_plan_then_hover_is_a_plan_of_a_longer_time():
    requested = Maneuver(duration=20.0)
    trajectory = search.followed_by_hover(plan_fastest(requested), requested)
    assert trajectory.duration == 20.0
    assert search.fault_of(requested, trajectory) is None


# The shortest duration


def test_the_papers_maneuver_takes_no_more_than_three_and_a_half_percent_more_than_optimal_control(paper_plan):
    fastest = plan_fastest(Maneuver())
    assert fastest.duration <= 8.5
    assert 1.0 <= fastest.duration / shortest_time(Maneuver(), paper_plan, intervals=100) < 1.035


def test_a_fastest_plan_with_a_long_arc_at_its_pitch_limit_meets_it_when_flown():
    travel, start, goal, pitch = np.radians([-50.8018, 8.75858, 7.00393, 18.1729])
    limits = Limits(2.12767, 11.2298, -pitch, pitch)
    assert plan_fastest(Maneuver((0.0, start), (travel, goal), 25.0, limits)).duration < 5.0


@pytest.mark.parametrize("name", ["descend and turn", "little pitch to one side", "little pitch", "fans may reverse"])
def test_the_fastest_plan_is_near_optimal_and_meets_its_limits(name):
    requested = replace(MANEUVERS[name], duration=30.0)
    fastest = plan_fastest(requested)
    flown = replay(fastest)
    assert_allclose(flown[:, -1], [requested.goal[0], 0.0, requested.goal[1], 0.0, 0.0, 0.0], rtol=0.0, atol=1e-3)
    low, high = requested.limits.pitch
    assert low - 1e-6 <= flown[4].min() <= flown[4].max() <= high + 1e-6
    low, high = requested.limits.u
    assert low - 1e-6 <= fastest.u.min() <= fastest.u.max() <= high + 1e-6
    assert 1.0 <= fastest.duration / shortest_time(requested, fastest, intervals=100) < 1.05


def test_methods_by_their_shortest_durations():
    durations = {method: plan_fastest(Maneuver(duration=12.0), method).duration for method in FASTEST}
    assert durations["collocation"] < durations["spline"] == durations["auto"] < durations["paper"] < durations["flat"]


@pytest.mark.parametrize("method", ["spline", "flat", "collocation"])
def test_a_reserve_is_left_at_both_ends_of_both_windows(method):
    fastest = plan_fastest(Maneuver(duration=14.0), method, reserve=0.1)
    assert fastest.limits == Limits()
    assert fastest.u.min() >= 1.5 - 1e-6
    assert fastest.u.max() <= 10.5 + 1e-6
    assert np.degrees(np.abs(fastest.x[4]).max()) <= 45.0 + 1e-4
    assert fastest.duration > plan_fastest(Maneuver(duration=14.0), method).duration


@pytest.mark.parametrize("method", FASTEST)
def test_a_too_short_duration_is_refused_with_the_shortest_one(method):
    with pytest.raises(InfeasibleManeuver, match="the shortest found takes") as refusal:
        plan_fastest(Maneuver(duration=7.0), method)
    fastest = plan_fastest(Maneuver(duration=20.0), method)
    assert refusal.value.shortest_duration == pytest.approx(fastest.duration, rel=1e-4)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"method": "magic"}, "method = 'magic'.*spline"),
        ({"reserve": -0.1}, "reserve = -0.1"),
        ({"reserve": 1.0}, "reserve = 1.0"),
        ({"reserve": math.nan}, "reserve = nan"),
        ({"reserve": 0.9}, "hover"),  # from 5.5 to 6.5 V
        ({"time_limit": 0.0}, "time_limit = 0.0"),
    ],
    ids=str,
)
def test_arguments_that_the_fastest_plan_cannot_have_are_named(arguments, said):
    with pytest.raises(ValueError, match=said):
        plan_fastest(Maneuver(), **arguments)


def test_there_is_no_fastest_way_to_stay():
    with pytest.raises(ValueError, match=r"goal = \(1\.0, 0\.0\): must differ"):
        plan_fastest(Maneuver((1.0, 0.0), (1.0, 0.0)))
