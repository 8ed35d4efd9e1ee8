"""Splines against scipy's, their derivatives against differences, and the interior point against other solvers."""

import math
from dataclasses import replace

import numpy as np
import pytest
from independent import TABLE_I, central_differences, equation_3, shortest_time
from numpy.testing import assert_allclose
from scipy.interpolate import BSpline

from heli_gym import HelicopterParameters, Maneuver
from heli_gym.baselines import plan_fastest
from heli_gym.baselines.planning import spline, spline_search
from heli_gym.baselines.planning.spline_kernel import compiled, derivatives, interpolate, invert

RNG = np.random.default_rng(3)


def test_the_spline_is_scipys():
    c, T = RNG.normal(size=(13, 2)), 7.0
    knots = np.arange(-3, 14) / 10.0 * T
    t = np.linspace(0.0, T, 101)
    expected = [BSpline(knots, c, 3).derivative(n)(t).T if n else BSpline(knots, c, 3)(t).T for n in range(3)]
    assert_allclose(interpolate(c, T, len(t)), expected, atol=1e-12)


def test_a_refined_spline_is_the_same_function():
    coarse = spline.Spline(RNG.normal(size=(13, 2)), 5.0, np.zeros(4))
    fine = spline.refined(coarse)
    assert len(fine.coefficients) == 23
    assert_allclose(interpolate(fine.coefficients, 5.0, 77), interpolate(coarse.coefficients, 5.0, 77), atol=1e-11)


def test_a_guess_starts_and_ends_at_rest_within_the_pitch_limits():
    requested = Maneuver((1.0, -0.2), (9.0, 0.1), 4.0)
    y, dy, ddy = interpolate(spline.guess(requested, 4.0, 30).coefficients, 4.0, 401)
    assert_allclose(y[:, [0, -1]], [[-0.2, 0.1], [0.0, 0.0]], atol=1e-12)
    assert_allclose(np.stack((dy, ddy))[..., [0, -1]], 0.0, atol=1e-10)
    assert np.abs(y[1]).max() < math.radians(50.0)


@pytest.mark.parametrize("case", range(5))
def test_the_inversion_inverts_equation_3(case):
    q2, q3, ddq2, ddq3 = RNG.uniform(-1.0, 1.0, 4)
    v1, v2, ddq1 = invert(q2, 0.0, ddq2, q3, 0.0, ddq3, HelicopterParameters(), math.sin, math.cos)
    rates = equation_3([0.0, 0.0, q2, 0.0, q3, 0.0], v1, v2, TABLE_I)
    assert_allclose(rates, [0.0, ddq1, 0.0, ddq2, 0.0, ddq3], atol=1e-12)


@pytest.mark.parametrize("parameters", [HelicopterParameters(), HelicopterParameters(c1=0.1, c2=0.2, c3=0.5)])
def test_the_derivatives_agree_with_differences(parameters):
    z = RNG.uniform(-1.0, 1.0, 6)  # elevation and pitch, each with two derivatives

    def quantities(z):
        return np.array(invert(*z, parameters, math.sin, math.cos))

    def gradients(z):
        D, H = np.zeros((3, 6)), np.zeros((3, 6, 6))
        compiled(derivatives)(z, parameters, D, H)
        return D, H

    D, H = gradients(z)
    assert_allclose(D, central_differences(quantities, z), atol=1e-8)
    expected = central_differences(lambda z: gradients(z)[0].ravel(), z).reshape(3, 6, 6)
    assert_allclose(H, expected, atol=1e-7)


def third_differences(c):
    """Sum of the squared third differences of coefficients (M, 2), weighted as squared rates of v1 and v2."""
    weights = np.array([TABLE_I.b2, TABLE_I.b3]) ** -2.0
    return (weights * (np.diff(c, 3, axis=0) ** 2).sum(axis=0)).sum()


def thrust_rates(c):
    """Integral of the squared rates of the thrusts, linear between the Lobatto points, over 14 s."""
    p, segments = TABLE_I, len(c) - 3
    inner = 0.5 / math.sqrt(5.0)
    tau = np.append((np.arange(segments)[:, None] + [0.0, 0.5 - inner, 0.5 + inner]).ravel() / segments, 1.0)
    knots = np.arange(-3, segments + 4) / segments
    q2, q3 = BSpline(knots, c, 3)(tau).T
    ddq2, ddq3 = BSpline(knots, c, 3).derivative(2)(tau).T / 14.0**2
    v1 = (ddq2 - p.a1 * np.sin(q2) - p.a2 * np.cos(q2)) / (p.b2 * np.cos(q3))
    v2 = (ddq3 - p.a3 * np.cos(q2) * np.sin(q3)) / p.b3
    f = 0.5 * np.stack((v1 + v2, v1 - v2))
    return (np.diff(f) ** 2 / np.diff(14.0 * tau)).sum()


@pytest.mark.parametrize(
    ("objective", "weights"),
    [(third_differences, (1.0, 0.0, 0.0, 0.0)), (thrust_rates, (0.0, 0.0, 0.0, 1e3))],
    ids=["third differences", "thrust rates"],
)
def test_the_spline_minimises_its_objective(objective, weights):
    # the barrier being lowered until the limits, which are far away, do not matter
    requested = Maneuver(goal=(1.0, 0.1), duration=14.0)
    bounds = spline.Bounds(requested.rig.thrust_bounds(requested.limits.u))
    start = spline.smoothest(requested, spline.guess(requested, 14.0, 30), bounds)
    best = spline.optimise(requested, start, bounds, 14.0, weights, spline.COLD, 1e-10)
    t = np.linspace(0.0, 14.0, 1401)

    def arrival(c):
        (y1, y2), _, (ddy1, _) = interpolate(c, 14.0, len(t))
        p = TABLE_I
        lift = ddy1 - p.a1 * np.sin(y1) - p.a2 * np.cos(y1)
        ddeta = p.b1 / p.b2 * np.tan(y2) * lift * np.cos(y1)
        return np.array([np.trapezoid(ddeta, t), np.trapezoid((14.0 - t) * ddeta, t)])

    free = slice(3, -3)
    assert_allclose(arrival(best.coefficients), [0.0, 1.0], atol=1e-5)
    shape = best.coefficients[free].shape

    def moved(z):
        c = best.coefficients.copy()
        c[free] += z.reshape(shape)
        return c

    zero = np.zeros(math.prod(shape))
    gradient = central_differences(lambda z: np.array([objective(moved(z))]), zero, 1e-5)[0]
    constraints = central_differences(lambda z: arrival(moved(z)), zero, 1e-5)
    rest = gradient - constraints.T @ np.linalg.lstsq(constraints.T, gradient)[0]
    assert np.abs(rest).max() < 1e-3 * np.abs(gradient).max()


def test_more_time_is_smoother():
    def roughness(duration):
        requested = Maneuver(duration=duration)
        bounds = spline.Bounds(requested.rig.thrust_bounds(requested.limits.u))
        found = spline.smoothest(requested, spline.guess(requested, duration, 30), bounds)
        return np.abs(interpolate(found.coefficients, duration, 500)[2]).max()

    assert roughness(14.0) < roughness(12.0) < roughness(10.0)


def test_no_plan_is_found_where_there_is_none():
    requested = Maneuver(duration=8.0)
    assert spline_search.plan_smoothest(requested) is None


@pytest.mark.slow
def test_random_maneuvers_with_ten_percent_of_the_time_to_spare_are_planned():
    from heli_gym.baselines.evaluation.planner_comparison import random_maneuver

    rng = np.random.default_rng(11)
    for _ in range(20):
        requested = random_maneuver(rng)
        fastest = plan_fastest(requested)
        shortest = shortest_time(requested, fastest, intervals=100)
        assert fastest.duration < 1.05 * shortest
        assert spline_search.plan_fastest(replace(requested, duration=1.1 * shortest), lambda: None) is not None
