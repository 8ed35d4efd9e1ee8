"""Shooting and collocation agree."""

import math

import numpy as np
import pytest
from independent import central_differences
from numpy.testing import assert_allclose

from heli_gym import Maneuver
from heli_gym.baselines import plan
from heli_gym.baselines.paper.boundary_value import FINE, ConstrainedProblem, solve_unconstrained
from heli_gym.baselines.paper.shooting import guess_from, shooter, solve_by_shooting, solve_near, unconstrained_guess
from heli_gym.baselines.planning.paper_method import solve_from_unconstrained

TURN = Maneuver(goal=(1.5, -0.2), duration=8.0)


@pytest.mark.parametrize("requested", [Maneuver(), Maneuver(duration=12.0), TURN], ids=str)
def test_the_solution_of_38_is_that_of_collocation(requested):
    problem = ConstrainedProblem(requested)
    expected = problem.solve(solve_from_unconstrained(requested), FINE)
    found = solve_by_shooting(requested)
    t = np.linspace(0.0, requested.duration, 200)
    assert_allclose(found.interpolate(t), expected.interpolate(t), atol=2e-3)
    assert_allclose(problem.trajectory(found).u, problem.trajectory(expected).u, atol=2e-2)


@pytest.mark.parametrize("requested", [Maneuver(), TURN], ids=str)
def test_the_unconstrained_guess_is_that_of_collocation(requested):
    found, expected = unconstrained_guess(requested), solve_unconstrained(requested, FINE)
    assert_allclose(found.p, expected.p, rtol=1e-5)
    assert_allclose(found.Y, expected.interpolate(found.t), atol=2e-3)


def test_there_is_no_unconstrained_guess_beyond_90_degrees():
    assert unconstrained_guess(Maneuver(duration=4.0)) is None


def test_the_sensitivities_agree_with_differences():
    problem, p = ConstrainedProblem(TURN), np.array([1.0, -0.5, 110.0, -310.0, 345.0, -138.0])
    shoot, nodes = shooter(problem, 100), np.zeros((6, 2))
    expected = central_differences(lambda p: shoot(nodes, p).defects[0], p, 1e-7)
    assert_allclose(shoot(nodes, p).sensitivity[0, :, :6], expected, rtol=1e-4, atol=1e-5)


def test_segments_that_meet_are_one_flight():
    problem, p = ConstrainedProblem(TURN), np.array([1.0, -0.5, 110.0, -310.0, 345.0, -138.0])
    one = shooter(problem, 100)(np.zeros((6, 2)), p)
    many = shooter(problem, 20)(one.Y[:, ::20], p)
    assert_allclose(many.defects[:-1], 0.0, atol=1e-12)
    assert_allclose(many.defects[-1], one.defects[-1], atol=1e-12)
    assert_allclose(many.sensitivity[-1], one.sensitivity[-1], rtol=1e-9, atol=1e-9)


def test_a_newton_step_removes_the_defects_to_first_order():
    problem, found = ConstrainedProblem(TURN), solve_by_shooting(TURN)
    shoot, rng = shooter(problem, 20), np.random.default_rng(0)
    met = found.interpolate(np.linspace(0.0, 8.0, 6))
    for size, left in ((1e-3, 1e-4), (1e-5, 1e-8)):
        apart = shoot(met + size * rng.normal(size=met.shape), found.p)
        nodes = apart.nodes.copy()
        nodes[:, 1:] += apart.sensitivity[:, :, 6].T
        assert np.abs(shoot(nodes, found.p).defects[:-1]).max() < left


def test_a_shot_solves_38():
    requested = Maneuver()
    problem, found = ConstrainedProblem(requested), solve_by_shooting(requested)
    start, goal = problem.ends()
    assert_allclose(found.Y[:, 0], start, atol=1e-12)
    assert_allclose(found.Y[:, -1], goal, atol=1e-5)
    t, h = found.t[1:-1], 1e-6
    rates = (found.interpolate(t + h) - found.interpolate(t - h)) / (2.0 * h)
    assert_allclose(rates, problem.rhs(t, found.interpolate(t), found.p), atol=1e-4)


@pytest.mark.parametrize("like", [Maneuver(duration=10.1), Maneuver(goal=(6.2, 0.02))], ids=str)
def test_a_plan_close_by_leads_to_the_solution_of_38(like):
    t = np.linspace(0.0, 10.0, 200)
    found, expected = solve_near(Maneuver(), plan(like, "paper")), solve_by_shooting(Maneuver())
    assert_allclose(found.interpolate(t), expected.interpolate(t), atol=1e-4)


@pytest.mark.parametrize("duration", [10.1, 10.3, 10.5, 11.0, 14.0])
def test_a_rotation_with_time_to_spare_leaves_the_elevation_nearly_alone(duration):
    # other solutions, by up to 20°, lead to the same goal
    assert np.abs(solve_by_shooting(Maneuver(duration=duration)).Y[0]).max() < math.radians(3.0)


def test_a_plan_that_solves_38_gives_its_parameters():
    solution, trajectory = solve_by_shooting(TURN), plan(TURN, "paper")
    _, p = guess_from(ConstrainedProblem(TURN), trajectory)
    assert_allclose(p, solution.p, rtol=1e-2, atol=0.1)


def test_an_unsolvable_problem_has_no_result():
    assert solve_by_shooting(Maneuver(duration=9.0)) is None
