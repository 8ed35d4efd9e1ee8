"""Path constraints, moving ends and objectives, against an independent integrator and a least-effort optimum."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from independent import replay
from numpy.testing import assert_allclose

from heli_gym import Limits, Maneuver, Trajectory, find_rig, thrust
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest
from heli_gym.baselines.planning import spline, spline_search
from heli_gym.baselines.planning.path import excesses, path_limits

TRAVEL = np.linspace(0.0, 2.0 * math.pi, 201)
BUMP = np.radians(8.0 - 16.0 * np.exp(-(((TRAVEL - math.pi) / 0.5) ** 2)))  # 8 degrees above level half-way
CONSTRAINED = {
    "a bump": Maneuver(duration=10.0, floor=(TRAVEL, BUMP)),
    "an elevation window": Maneuver(duration=9.0, limits=Limits(elevation_min=-0.0175, elevation_max=0.0175)),
    "a travel rate": Maneuver(duration=14.0, limits=Limits(travel_rate=1.0)),
    "an elevation rate": Maneuver(goal=(3.0, -0.2), duration=8.0, limits=Limits(elevation_rate=0.04)),
    "a slew": Maneuver(duration=11.0, limits=Limits(slew=6.0)),
    "all of them": Maneuver(
        duration=14.0, floor=(TRAVEL, BUMP), limits=Limits(travel_rate=0.9, elevation_rate=0.2, slew=6.0)
    ),
}


@pytest.mark.parametrize("name", CONSTRAINED)
def test_a_plan_meets_its_constraints_when_flown_through_equation_3(name):
    requested = CONSTRAINED[name]
    trajectory = plan(requested)
    flown = replay(trajectory)
    assert trajectory.duration == requested.duration
    assert_allclose(flown[:, -1], requested.ends[1], atol=1e-3)
    assert excesses(requested, trajectory.t, flown, trajectory.u)
    for constraint, excess in excesses(requested, trajectory.t, flown, trajectory.u).items():
        assert excess < (1e-4 if constraint == "slew" else 2e-5), constraint


@pytest.mark.parametrize("name", ["a bump", "a travel rate", "all of them"])
def test_collocation_meets_the_constraints_too(name):
    requested = CONSTRAINED[name]
    trajectory = plan(requested, "collocation")
    flown = replay(trajectory)
    assert_allclose(flown[:, -1], requested.ends[1], atol=1e-3)
    assert max(excesses(requested, trajectory.t, flown, trajectory.u).values()) < 1e-4


@pytest.mark.parametrize("name", ["a bump", "an elevation window", "an elevation rate"])
def test_with_constraints_the_fastest_spline_is_close_to_collocation(name):
    requested = replace(CONSTRAINED[name], duration=30.0)
    assert plan_fastest(requested).duration < 1.03 * plan_fastest(requested, "collocation").duration


@pytest.mark.parametrize("name", ["a bump", "an elevation window", "an elevation rate"])
def test_the_fastest_plan_meets_the_constraints_and_takes_longer(name):
    requested = replace(CONSTRAINED[name], duration=30.0)
    constrained = plan_fastest(requested)
    free = plan_fastest(Maneuver(requested.start, requested.goal, 30.0))
    assert max(excesses(requested, constrained.t, replay(constrained), constrained.u).values()) < 2e-5
    assert constrained.duration > free.duration + 0.02


def test_without_the_constraints_the_same_plans_exceed_them():
    for requested in CONSTRAINED.values():
        free = plan(Maneuver(requested.start, requested.goal, requested.duration))
        assert max(excesses(requested, free.t, free.x, free.u).values()) > 5e-3


def test_a_refusal_names_the_constraint_and_its_cost():
    tight = Maneuver(duration=8.4, limits=Limits(elevation_min=-0.01, elevation_max=0.01))
    with pytest.raises(InfeasibleManeuver, match=r"the shortest found takes.*elevation \(1 degree more would save"):
        plan(tight)


def test_a_faster_change_of_the_voltages_saves_the_stated_time():
    slow = Maneuver(duration=8.0, limits=Limits(slew=3.0))
    with pytest.raises(InfeasibleManeuver) as refusal:
        plan(slow, "spline")
    stated = float(re.search(r"slew \(1 V/s more would save ([\d.]+) s\)", str(refusal.value))[1])
    faster = plan_fastest(Maneuver(duration=30.0, limits=Limits(slew=3.15))).duration
    assert (refusal.value.shortest_duration - faster) / 0.15 == pytest.approx(stated, rel=0.15)


@pytest.mark.slow
def test_a_volt_more_for_leading_commands_saves_the_stated_time():
    with pytest.raises(InfeasibleManeuver) as refusal:
        plan(Maneuver(duration=8.0, lead=True), "spline")
    stated = float(re.search(r"lead \(1 V more would save ([\d.]+) s\)", str(refusal.value))[1])
    faster = plan_fastest(Maneuver(duration=30.0, limits=Limits(0.95, 11.05), lead=True)).duration
    assert (refusal.value.shortest_duration - faster) / 0.05 == pytest.approx(stated, rel=0.15)


def test_other_methods_refuse_a_violated_constraint_by_name():
    with pytest.raises(InfeasibleManeuver, match="exceeds travel_rate by"):
        plan(Maneuver(duration=14.0, limits=Limits(travel_rate=0.5)), "flat")


def test_the_table_is_a_floor_where_both_ends_are_above_it():
    table = Maneuver().rig.table_elevation
    assert path_limits(Maneuver()).elevation_max == table
    assert path_limits(Maneuver(limits=Limits(elevation_max=0.1))).elevation_max == 0.1


def test_a_looser_elevation_max_does_not_remove_the_table():
    loose = Limits(elevation_max=1.0)
    assert path_limits(Maneuver(limits=loose)).elevation_max == Maneuver().rig.table_elevation
    low = replace(find_rig("paper"), table_elevation=0.05)
    assert path_limits(Maneuver((0.0, 0.1), rig=low, limits=loose)).elevation_max == 1.0  # starts below the table


@pytest.fixture(scope="module")
def upwards():
    """The paper's rig with elevation positive upwards and a table 4 degrees below level."""
    own = find_rig("paper")
    return replace(
        own,
        name="upwards",
        parameters=own.parameters._replace(a2=-own.parameters.a2, b2=-own.parameters.b2),
        table_elevation=math.radians(4.0),
    )


def test_on_a_rig_with_elevation_positive_upwards_the_table_is_the_least_elevation(upwards):
    assert path_limits(Maneuver(rig=upwards))[:2] == (-upwards.table_elevation, None)
    tight, loose = (replace(upwards.limits, elevation_min=low) for low in (-0.01, -1.0))
    assert path_limits(Maneuver(rig=upwards, limits=tight)).elevation_min == -0.01
    assert path_limits(Maneuver(rig=upwards, limits=loose)).elevation_min == -upwards.table_elevation
    sinking = Maneuver((0.0, 0.0), (3.0, -0.06), 7.0, rig=upwards)
    assert plan(sinking).x[2].min() > -upwards.table_elevation - 1e-5


def test_a_floor_is_refused_on_a_rig_with_elevation_positive_upwards(upwards):
    with pytest.raises(ValueError, match=r"floor = .*: must be None for the rig 'upwards'.*b2 = 0.6523"):
        Maneuver(rig=upwards, floor=(TRAVEL, BUMP))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"floor": ([0.0, 0.0], [0.1, 0.1])}, "floor = .*travel increasing"),
        ({"floor": 3}, "floor = 3"),
        ({"start_state": (0.0, 1.0)}, "start_state = "),
        ({"goal_state": [math.nan] * 6}, "goal_state = "),
    ],
    ids=str,
)
def test_invalid_constraints_and_ends_are_named(arguments, said):
    with pytest.raises(ValueError, match=said):
        Maneuver(**arguments)


@pytest.mark.parametrize(
    ("limits", "said"),
    [
        ({"travel_rate": -1.0}, "travel_rate = -1"),
        ({"slew": math.inf}, "slew = inf"),
        ({"elevation_min": 0.1, "elevation_max": 0.0}, "elevation_min = 0.1"),
    ],
    ids=str,
)
def test_invalid_limits_are_named(limits, said):
    with pytest.raises(ValueError, match=said):
        Limits(**limits)


def test_an_end_below_the_floor_is_named():
    with pytest.raises(ValueError, match=r"goal = .*: must keep floor"):
        plan(Maneuver(floor=([0.0, 6.0, 6.2], [0.1, 0.1, -0.1])))


def test_limits_survive_a_file(tmp_path):
    trajectory = replace(plan(Maneuver(duration=12.0)), limits=Limits(travel_rate=2.0, slew=30.0))
    trajectory.save(tmp_path / "plan.npz")
    assert Trajectory.load(tmp_path / "plan.npz").limits == trajectory.limits


# Ends in motion


@pytest.mark.parametrize("elapsed", [0.5, 3.0, 6.0, 8.0])
def test_from_a_state_in_flight_a_new_plan_arrives_at_the_same_time(elapsed):
    before = plan(Maneuver(duration=11.0), "spline")
    x = before(elapsed)[0] + np.array([0.02, 0.01, -0.01, 0.005, 0.01, -0.01])
    again = plan(Maneuver(duration=11.0 - elapsed), near=before, start_state=x)
    assert_allclose(again.x[:, 0], x, atol=1e-12)
    assert_allclose(replay(again)[:, -1], [2.0 * math.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-3)


@pytest.mark.parametrize("left", [9.0, 4.0, 1.5, 0.5])
def test_from_a_measured_state_there_is_a_plan_or_a_duration_in_which_there_is_one(left):
    before, rng = plan(Maneuver(duration=11.0), "spline"), np.random.default_rng(1)
    for _ in range(5):
        x = before(11.0 - left)[0] + np.radians([1.0, 2.0, 1.0, 2.0, 2.0, 4.0]) * rng.normal(size=6)
        requested = Maneuver(duration=left)
        try:
            again = plan(requested, near=before, start_state=x)
        except InfeasibleManeuver as refusal:
            requested = Maneuver(duration=1.02 * refusal.shortest_duration)
            assert requested.duration > left
            again = plan(requested, near=before, start_state=x)
        assert_allclose(again.x[:, 0], x, atol=1e-12)
        assert_allclose(replay(again)[:, -1], requested.ends[1], atol=1e-3)


def test_a_pitch_that_starts_outside_its_limits_returns_within_them():
    before = plan(Maneuver(duration=9.0), "spline")
    k = before.x[4].argmax()
    x = before.x[:, k] + np.radians([0.0, 0.0, 0.0, 0.0, 2.0, 3.0])
    again = plan(Maneuver(duration=float(9.3 - before.t[k])), near=before, start_state=x)
    pitch = np.degrees(replay(again)[4])
    assert pitch[0] > 50.0
    assert pitch[again.t > 0.8].max() < 50.001


def test_a_plan_may_end_in_motion():
    goal = (2.0, 0.5, 0.05, 0.02, 0.1, 0.0)
    assert_allclose(replay(plan(Maneuver(goal_state=goal, duration=6.0)))[:, -1], goal, atol=1e-3)


@pytest.mark.parametrize("method", ["paper", "flat"])
def test_methods_from_rest_to_rest_refuse_other_ends(method):
    with pytest.raises(ValueError, match="from rest to rest"):
        plan(Maneuver(goal_state=(2.0, 0.5, 0.0, 0.0, 0.0, 0.0)), method)


# Objectives


def effort(trajectory):
    f = thrust(trajectory.u)
    return np.trapezoid(((f - 0.5 * 0.3946 / 0.6523) ** 2).sum(axis=0), trajectory.t)


def roughness(trajectory):
    return ((np.diff(thrust(trajectory.u)) / np.diff(trajectory.t)) ** 2).sum()


def reserve(trajectory):
    margins = (trajectory.u - 1.0) / 5.0, (11.0 - trajectory.u) / 5.0, 1.0 - np.abs(trajectory.x[4]) / math.radians(50)
    return min(margin.min() for margin in margins)


@pytest.mark.parametrize("duration", [10.0, 12.0])
def test_each_objective_gives_the_best_value_of_its_own_measure(duration):
    plans = {
        objective: plan(Maneuver(duration=duration), "spline", objective=objective)
        for objective in ("effort", "reserve")
    }
    plans |= {"smoothest": plan(Maneuver(duration=duration), "spline", objective="smoothest")}
    assert min(plans, key=lambda name: effort(plans[name])) == "effort"
    assert max(plans, key=lambda name: reserve(plans[name])) == "reserve"
    assert min(plans, key=lambda name: roughness(plans[name])) == "smoothest"


def test_least_effort_is_close_to_that_of_collocation():
    requested = Maneuver(duration=12.0)
    assert effort(plan(requested, objective="effort")) < 1.25 * effort(plan(requested, "collocation"))


def test_an_objective_is_named_where_it_is_unknown_or_of_another_method():
    with pytest.raises(ValueError, match=r"objective = 'fuel': must be one of shortest, effort, reserve, smoothest"):
        plan(Maneuver(), objective="fuel")
    with pytest.raises(ValueError, match="objective = 'effort': must go with"):
        plan(Maneuver(), "flat", objective="effort")


@pytest.mark.parametrize("objective", ["effort", "smoothest"])
def test_a_plan_without_the_requested_objective_is_announced(objective):
    requested = Maneuver(duration=8.31)  # next to the shortest
    with pytest.warns(RuntimeWarning, match=f"objective = '{objective}': no plan found for travel 0 to 360"):
        found = plan(requested, "spline", objective=objective)
    assert_allclose(found.u, plan(requested, "spline").u)


@pytest.mark.parametrize("objective", [None, "effort"])
def test_a_start_and_a_goal_on_the_floor_are_planned(objective):
    travel = np.linspace(0.0, math.pi, 201)
    bump = -0.2 * np.exp(-20.0 * (travel - 2.0 * math.pi / 3.0) ** 2)  # the course's, level at both ends
    requested = Maneuver(goal=(math.pi, 0.0), duration=15.0, rig="ntnu", floor=(travel, bump))
    trajectory = plan(requested, objective=objective)
    assert excesses(requested, trajectory.t, trajectory.x, trajectory.u)["floor"] < 1e-6


def test_a_search_is_checked_before_each_solution(monkeypatch):
    solutions, checks = [], []
    optimise = spline.optimise
    monkeypatch.setattr(spline, "optimise", lambda *given: solutions.append(1) or optimise(*given))

    def check():
        checks.append(1)
        if len(checks) == 4:
            raise TimeoutError

    slewed = Maneuver(duration=60.0, limits=Limits(slew=6.0))
    with pytest.raises(TimeoutError):
        spline_search.plan_fastest(slewed, check)
    assert len(solutions) == 3


def test_where_no_fastest_plan_is_found_the_smoothest_ones_are_shortened():
    limits = replace(find_rig("quanser").limits, travel_rate=1.1, elevation_rate=0.34, slew=58.0)
    requested = Maneuver((0.0, 0.07), (6.4, -0.11), 60.0, limits, rig="quanser")
    found, trajectory = spline_search.plan_shortened(requested, 12.0, spline.unlimited)
    assert found.duration == trajectory.duration
    assert 6.4 / 1.1 < found.duration < 9.0
    assert max(excesses(requested, trajectory.t, trajectory.x, trajectory.u).values()) < 1e-6
