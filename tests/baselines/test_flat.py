"""The flat outputs determine the flight: their plans agree with (3) for any limits."""

import math

import numpy as np
import pytest
from independent import replay
from numpy.testing import assert_allclose

from heli_gym import Maneuver
from heli_gym.baselines.planning.flat import flat_trajectory
from heli_gym.flatness import RISE

CASES = [Maneuver(duration=12.0), Maneuver((1.0, -0.1), (-2.0, 0.2), 9.0), Maneuver(goal=(0.0, 0.15), duration=5.0)]


@pytest.mark.parametrize("requested", CASES, ids=str)
def test_the_states_are_those_that_the_voltages_lead_to(requested):
    trajectory = flat_trajectory(requested)
    assert_allclose(replay(trajectory), trajectory.x, rtol=0.0, atol=1e-5)


@pytest.mark.parametrize("requested", CASES, ids=str)
def test_travel_and_elevation_are_the_same_polynomial(requested):
    trajectory = flat_trajectory(requested)
    share = RISE(trajectory.t / requested.duration)
    for row, start, goal in ((0, requested.start[0], requested.goal[0]), (2, requested.start[1], requested.goal[1])):
        assert_allclose(trajectory.x[row], start + (goal - start) * share, atol=1e-12)


def test_the_polynomial_rises_from_zero_to_one_with_four_derivatives_zero_at_both_ends():
    assert RISE(0.0) == 0.0
    assert RISE(1.0) == pytest.approx(1.0)
    for n in range(1, 5):
        assert_allclose(RISE.deriv(n)(np.array([0.0, 1.0])), 0.0, atol=1e-9)


def test_a_negative_thrust_sum_is_refused():
    assert flat_trajectory(Maneuver(goal=(0.0, math.radians(15.0)), duration=1.0)) is None
