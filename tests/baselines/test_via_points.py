"""Via points, free ends, periodic flights and moving ends, against an independent integrator and collocation."""

import math
from dataclasses import replace

import numpy as np
import pytest
from independent import replay
from numpy.testing import assert_allclose

from heli_gym import Maneuver
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest
from heli_gym.baselines.planning.collocation import collocated_trajectory

FIGURE_EIGHT = (
    (2.0, 0.5, 0.1),
    (4.0, 0.8, 0.0),
    (6.0, 0.5, -0.1),
    (8.0, 0.0, 0.0),
    (10.0, -0.5, 0.1),
    (12.0, -0.8, 0.0),
    (14.0, -0.5, -0.1),
)
MOVING = (0.0, 0.5, 0.05, 0.02, 0.1, 0.0), (2.0, 0.5, 0.05, 0.02, 0.1, 0.0)
GENERAL = {
    "via points in given times": Maneuver(duration=12.0, via=((4.0, 2.0, -0.1), (8.0, 4.0, 0.1))),
    "via points in free times": Maneuver(duration=12.0, via=((None, 2.0, -0.1), (None, 4.0, 0.1))),
    "a travel in a given time": Maneuver(duration=12.0, via=((6.0, 2.0, None),)),
    "a free elevation at the goal": Maneuver(goal=(3.0, None), duration=8.0),
    "a moving start": Maneuver(start_state=MOVING[0], duration=9.0),
    "a moving goal": Maneuver(goal_state=MOVING[1], duration=6.0),
    "both ends in motion": Maneuver(start_state=MOVING[0], goal_state=MOVING[1], duration=5.0),
    "a figure of eight": Maneuver(goal=(0.0, 0.0), duration=16.0, via=FIGURE_EIGHT, periodic=True),
    "turns without end": Maneuver(duration=8.0, via=((None, math.pi, -0.15),), periodic=True),
}
FASTEST = "via points in free times", "a free elevation at the goal", "a moving start", "both ends in motion"


def check(requested, trajectory):
    """Fly a plan open loop through (3), and compare the flight with everything requested."""
    flown, limits = replay(trajectory), requested.limits
    first, last = flown[:, 0], flown[:, -1]
    start, goal = requested.ends
    if requested.periodic:
        assert_allclose(last - first, [goal[0] - start[0], 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-3)
        assert_allclose(first[[0, 2]], start[[0, 2]], atol=1e-9)
    else:
        known = [0, 1, 3, 4, 5] if requested.elevation_free else list(range(6))
        assert_allclose(first, start, atol=1e-9)
        assert_allclose(last[known], goal[known], atol=1e-3)
    for time, travel, elevation in requested.via:
        if time is None:
            k = np.flatnonzero(np.diff(np.sign(flown[0] - travel)))
            assert np.abs(flown[2, k] - elevation).min() < 1e-3
        else:
            k = np.abs(trajectory.t - time).argmin()
            assert abs(flown[0, k] - travel) < 2e-3  # the nearest sample is up to half a millisecond away
            assert elevation is None or abs(flown[2, k] - elevation) < 1e-3
    assert limits.u_min - 1e-6 <= trajectory.u.min() <= trajectory.u.max() <= limits.u_max + 1e-6
    assert limits.pitch_min - 1e-5 <= flown[4].min() <= flown[4].max() <= limits.pitch_max + 1e-5


@pytest.mark.parametrize("method", ["auto", "collocation"])
@pytest.mark.parametrize("name", GENERAL)
def test_the_plan_flown_through_equation_3_does_what_was_requested(name, method):
    requested = GENERAL[name]
    trajectory = plan(requested, method)
    assert trajectory.duration == requested.duration
    check(requested, trajectory)


@pytest.mark.parametrize("name", FASTEST)
def test_the_fastest_plan_does_it_too_and_in_the_time_of_collocation(name):
    requested = replace(GENERAL[name], duration=30.0)
    fastest = plan_fastest(requested)
    check(requested, fastest)
    optimum = collocated_trajectory(requested, "time", smooth=True)
    assert fastest.duration < 1.01 * optimum.duration


def test_a_via_point_costs_time_and_a_free_elevation_saves_some():
    direct = plan_fastest(Maneuver()).duration
    assert plan_fastest(Maneuver(via=((None, 3.0, -0.3),), duration=30.0)).duration > 1.01 * direct
    level, free = Maneuver(goal=(3.0, -0.2)), Maneuver(goal=(3.0, None))
    assert plan_fastest(free).duration < plan_fastest(level).duration


def test_a_periodic_plan_can_be_repeated():
    requested = GENERAL["a figure of eight"]
    trajectory = plan(requested)
    assert_allclose(trajectory.u[:, -1], trajectory.u[:, 0], atol=1e-6)
    assert np.abs(trajectory.x[1:, 0]).max() > 0.1  # in motion


def test_an_impossible_moving_goal_is_refused_with_a_duration_that_works():
    requested = replace(GENERAL["a moving goal"], duration=3.0)
    with pytest.raises(InfeasibleManeuver, match=r"the shortest found takes .* limit") as refusal:
        plan(requested)
    longer = replace(requested, duration=refusal.value.shortest_duration)
    assert plan(longer).duration == longer.duration


def test_an_impossible_via_point_is_named():
    with pytest.raises(InfeasibleManeuver, match=r"via\[0\] = \(1\.0, 3\.0, 0\.0\)"):
        plan(Maneuver(via=((1.0, 3.0, 0.0),)))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"via": ((1.0, 2.0),)}, r"via\[0\] = .*must be \(time, travel, elevation\)"),
        ({"via": ((None, 2.0, None),)}, r"via\[0\] = .*a time or an elevation"),
        ({"via": ((11.0, 2.0, 0.0),)}, r"via\[0\] = .*duration of 10 s"),
        ({"via": ((4.0, 2.0, 0.0), (3.0, 3.0, 0.0))}, r"via\[1\] = .*increasing"),
        ({"via": ((None, math.nan, 0.0),)}, r"via\[0\] = .*finite"),
        ({"periodic": True, "goal": (1.0, 0.1)}, "goal = .*elevation of the start"),
        ({"periodic": True, "start_state": MOVING[0]}, "periodic = True: must go with"),
        ({"elevation_free": True, "goal_state": MOVING[1]}, "elevation_free = True"),
    ],
    ids=str,
)
def test_what_contradicts_itself_is_named(arguments, said):
    with pytest.raises(ValueError, match=said):
        Maneuver(**arguments)


@pytest.mark.parametrize("method", ["paper", "flat"])
@pytest.mark.parametrize("name", ["via points in free times", "a free elevation at the goal", "a figure of eight"])
def test_methods_from_rest_to_rest_refuse_by_name(name, method):
    with pytest.raises(ValueError, match=f"method = '{method}' plans from rest to rest"):
        plan(GENERAL[name], method)


def test_times_of_via_points_contradict_the_fastest_plan():
    with pytest.raises(ValueError, match=r"via = .*without times"):
        plan_fastest(GENERAL["via points in given times"])
