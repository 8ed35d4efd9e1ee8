"""Shooting finds what collocation finds."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from baselines.boundary_value import FINE, ConstrainedProblem, solve_unconstrained
from baselines.planner import solve_from_unconstrained
from baselines.shooting import End, parameters_of, solve_by_shooting, unconstrained_parameters
from heli_gym import Maneuver

TURN = Maneuver(goal=(1.5, -0.2), duration=8.0)


@pytest.mark.parametrize("asked", [Maneuver(), Maneuver(duration=12.0), TURN], ids=str)
def test_the_solution_of_38_is_that_of_collocation(asked):
    problem = ConstrainedProblem(asked)
    expected = problem.solve(solve_from_unconstrained(asked), FINE)
    found = solve_by_shooting(asked)
    t = np.linspace(0.0, asked.duration, 200)
    assert_allclose(found.interpolate(t), expected.interpolate(t), atol=2e-3)
    assert_allclose(problem.trajectory(found).u, problem.trajectory(expected).u, atol=2e-2)


@pytest.mark.parametrize("asked", [Maneuver(), TURN], ids=str)
def test_the_unconstrained_parameters_are_those_of_collocation(asked):
    assert_allclose(unconstrained_parameters(asked), solve_unconstrained(asked, FINE).p, rtol=1e-5)


def test_there_are_no_unconstrained_parameters_beyond_90_degrees():
    assert unconstrained_parameters(Maneuver(duration=4.0)) is None


def test_the_guess_ends_where_the_pitch_should():
    problem = ConstrainedProblem(TURN)
    missed = End(TURN, 200)(parameters_of(problem, unconstrained_parameters(TURN)))
    assert_allclose(missed[2:4], 0.0, atol=0.05)


def test_a_shot_solves_38():
    asked = Maneuver()
    problem, found = ConstrainedProblem(asked), solve_by_shooting(asked)
    start, goal = problem.ends()
    assert_allclose(found.Y[:, 0], start, atol=1e-12)
    assert_allclose(found.Y[:, -1], goal, atol=1e-5)
    rates = problem.rhs(found.t, found.Y, found.p)
    assert_allclose(found.interpolate(found.t, 1), rates, atol=1e-8)


def test_parameters_close_by_are_enough():
    found = solve_by_shooting(TURN)
    again = solve_by_shooting(replace(TURN, duration=8.05), found.p)
    assert again is not None


def test_where_there_is_no_solution_none_is_found():
    assert solve_by_shooting(Maneuver(duration=9.0)) is None
