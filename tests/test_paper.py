"""What the paper claims, section by section and equation by equation, with the corrections of the reading notes.

The formulas are typed here once more, straight from the paper, and the claims are checked on the plans of
Figs. 4 and 8. What the paper says of the experiment (Section IV) is tested with the flights.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from independent import TABLE_I, central_differences, equation_2, equation_3, inputs, jacobians
from numpy.testing import assert_allclose
from scipy.interpolate import CubicSpline
from scipy.linalg import solve_continuous_are

from heli_gym import HelicopterParameters, Limits, Maneuver, Trajectory, dynamics, linearise, thrust, voltage
from heli_gym.baselines import plan, plan_unconstrained, riccati_gains
from heli_gym.baselines.paper import normal_form, saturation, tvlqr
from heli_gym.baselines.paper.boundary_value import (
    FINE,
    KAPPA,
    ConstrainedProblem,
    setup_functions,
    solve_unconstrained,
)
from heli_gym.baselines.planning.paper_method import solve_from_unconstrained
from heli_gym.model import STATE_NAMES, fan_thrusts, hover_input, inverse_dynamics, virtual_input

NOMINAL, PAPER = HelicopterParameters(), Maneuver()
K_PLUS, K_MINUS = 4.855e-3, -1.503e-3
A1, A2, A3, B1, B2, B3 = -1.1713, 0.3946, -0.5326, -0.6354, -0.6523, 4.6276
Q3 = math.radians(50.0)
F = F_MIN, F_MAX = K_PLUS * 1.0**2, K_PLUS * 11.0**2
RNG = np.random.default_rng(7)
Y1, Y2 = RNG.uniform(-0.5, 0.5, 50), RNG.uniform(-1.2, 1.2, 50)
DDY1, DDY2 = RNG.uniform(-0.4, 0.4, 50), RNG.uniform(-3.0, 3.0, 50)
V1, V2 = RNG.uniform(0.0, 1.2, 50), RNG.uniform(-0.5826, 0.5826, 50)
AT = 0.0, 0.0, Y1, 0.0, Y2, 0.0  # states (44)
XI1, XI2 = RNG.uniform(-2.0, 2.0, 50), RNG.uniform(-2.0, 2.0, 50)


def derivative(t, values):
    """Of smooth samples, in the interior."""
    return (values[..., 2:] - values[..., :-2]) / (t[2:] - t[:-2])


@pytest.fixture(scope="module")
def solution():
    """The solution of (38) for the paper's maneuver, on its own mesh."""
    return ConstrainedProblem(PAPER).solve(solve_from_unconstrained(PAPER), FINE)


@pytest.fixture(scope="module")
def motion(solution):
    return ConstrainedProblem(PAPER).motion(solution.t, solution.Y, solution.p)


# Section I: introduction


def test_section_i_travel_and_elevation_are_a_flat_output(unconstrained_plan):
    _, _, q2, _, q3, _ = unconstrained_plan.x[:, 1:-1]
    v1, _ = inputs(unconstrained_plan.u[:, 1:-1])
    ddq1, ddq2 = derivative(unconstrained_plan.t, unconstrained_plan.x[[1, 3]])
    v1_sin, v1_cos = ddq1 / (B1 * np.cos(q2)), (ddq2 - A1 * np.sin(q2) - A2 * np.cos(q2)) / B2
    assert_allclose(np.arctan2(v1_sin, v1_cos), q3, atol=2e-4)
    assert_allclose(np.hypot(v1_sin, v1_cos), v1, atol=2e-4)


# Section II: problem formulation


def test_the_parameters_hold_table_i():
    assert NOMINAL._asdict() == vars(TABLE_I) | {"c1": 0.0, "c2": 0.0, "c3": 0.0}  # the paper has no friction


def test_section_ii_equation_2_thrust_is_quadratic_in_the_voltage_with_two_coefficients():
    assert_allclose(
        thrust(np.array([-10.0, -1.0, 0.0, 1.0, 10.0])), [-0.1503, -0.001503, 0.0, 0.004855, 0.4855], rtol=1e-12
    )


def test_section_ii_footnote_1_negative_voltages_produce_no_considerable_thrust():
    u = np.linspace(0.5, 12.0, 20)
    assert (np.abs(thrust(-u)) < thrust(u) / 3.0).all()


def test_section_ii_equation_3_is_the_dynamics():
    q2, q3 = Y1, Y2
    state = 0.2, 0.5, q2, -0.3, q3, 0.7
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dynamics(state, (V1, V2), NOMINAL)
    assert (dq1, dq2, dq3) == (0.5, -0.3, 0.7)
    assert_allclose(ddq1, B1 * np.cos(q2) * np.sin(q3) * V1)
    assert_allclose(ddq2, A1 * np.sin(q2) + A2 * np.cos(q2) + B2 * np.cos(q3) * V1)
    assert_allclose(ddq3, A3 * np.cos(q2) * np.sin(q3) + B3 * V2)


def test_section_ii_equation_4_the_inputs_are_sum_and_difference_of_the_thrusts():
    f_f, f_b = 0.4, 0.25
    assert_allclose(virtual_input(np.array([f_f, f_b])), (f_f + f_b, f_f - f_b))
    assert_allclose(fan_thrusts((f_f + f_b, f_f - f_b)), (f_f, f_b))


@pytest.mark.parametrize("which", ["paper_plan", "unconstrained_plan"])
def test_section_ii_equation_5_plans_lead_from_rest_to_rest_without_pitch(which, request):
    x = request.getfixturevalue(which).x
    assert_allclose(x[:, 0], 0.0, atol=1e-6)
    assert_allclose(x[:, -1], [2.0 * math.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-6)


def test_section_ii_equation_8_the_default_maneuver_is_the_360_deg_rotation_in_10_s():
    assert PAPER.start == (0.0, 0.0)
    assert PAPER.goal == (2.0 * math.pi, 0.0)
    assert PAPER.duration == 10.0


def test_section_ii_equations_6_7_9_the_default_limits_are_1_to_11_volts_and_50_deg():
    assert PAPER.limits.u == (1.0, 11.0)
    assert PAPER.limits.pitch == (-Q3, Q3)


@pytest.mark.parametrize(("pitch_deg", "duration"), [(10.0, 22.0), (80.0, 10.0)])
def test_section_ii_all_pitch_limits_between_10_and_80_deg_would_be_possible(pitch_deg, duration):
    limits = Limits(pitch_min=-math.radians(pitch_deg), pitch_max=math.radians(pitch_deg))
    trajectory = plan(replace(PAPER, duration=duration, limits=limits))
    assert np.degrees(np.abs(trajectory.x[4])).max() <= pitch_deg


# Section III-A: normal form


def test_section_iii_a_equation_10_the_outputs_elevation_and_pitch_have_relative_degree_2_and_2():
    C = np.eye(6)[[STATE_NAMES.index("elevation"), STATE_NAMES.index("pitch")]]
    for q2, q3, v1, v2 in zip(Y1, Y2, V1, V2):
        A, B = linearise([0.0, 0.0, q2, 0.0, q3, 0.0], (v1, v2), NOMINAL)
        assert_allclose(C @ B, 0.0)
        assert_allclose(C @ A @ B, np.diag([B2 * np.cos(q3), B3]), atol=1e-15)


def test_section_iii_a_equation_11_is_the_normal_form():
    assert_allclose(normal_form.alpha1(AT, V1, NOMINAL), A1 * np.sin(Y1) + A2 * np.cos(Y1) + B2 * np.cos(Y2) * V1)
    assert_allclose(normal_form.alpha2(AT, V2, NOMINAL), A3 * np.cos(Y1) * np.sin(Y2) + B3 * V2)
    ddeta = normal_form.internal_dynamics(AT, normal_form.alpha1(AT, V1, NOMINAL), NOMINAL)
    assert_allclose(ddeta, B1 * np.sin(Y2) * np.cos(Y1) * V1, atol=1e-12)


def test_section_iii_a_equation_12_the_setup_functions_meet_the_boundary_conditions():
    maneuver = Maneuver(start=(1.0, -0.1), goal=(3.0, 0.2), duration=7.0)
    y1, y2 = setup_functions(maneuver, np.array([0.0, 7.0]), np.array([3.0, -8.0]))
    assert_allclose(y1[:2], [[-0.1, 0.2], [0.0, 0.0]], atol=1e-13)
    assert_allclose(y2[:2], 0.0, atol=1e-13)
    solved = solve_unconstrained(maneuver, FINE)
    assert_allclose(solved.Y[:, [0, -1]], [[1.0, 3.0], [0.0, 0.0]], atol=1e-8)


# Section III-B: feedforward without constraints


def test_section_iii_b_equation_13_is_the_feedforward():
    v1, v2 = inverse_dynamics(AT, DDY1, DDY2, NOMINAL)
    assert_allclose(v1, (DDY1 - A1 * np.sin(Y1) - A2 * np.cos(Y1)) / (B2 * np.cos(Y2)))
    assert_allclose(v2, (DDY2 - A3 * np.cos(Y1) * np.sin(Y2)) / B3)


def test_section_iii_b_equation_13_hover_takes_0_6049_newton_and_7_893_volts():
    v1, v2 = hover_input(0.0, NOMINAL)
    assert (round(float(v1), 4), float(v2)) == (0.6049, 0.0)
    assert_allclose(v1, -A2 / B2)
    assert np.round(voltage(fan_thrusts((v1, v2))), 3).tolist() == [7.893, 7.893]


def test_section_iii_b_equation_14_is_the_internal_dynamics():
    expected = B1 / B2 * np.tan(Y2) * (DDY1 - A1 * np.sin(Y1) - A2 * np.cos(Y1)) * np.cos(Y1)
    assert_allclose(normal_form.internal_dynamics(AT, DDY1, NOMINAL), expected)


@pytest.mark.parametrize("which", ["paper_plan", "unconstrained_plan"])
def test_section_iii_b_equation_14_the_travel_of_the_plans_follows_the_internal_dynamics(which, request):
    plan = request.getfixturevalue(which)
    _, deta, y1, dy1, y2, _ = plan.x
    ddy1 = derivative(plan.t, dy1)
    y1, y2 = y1[1:-1], y2[1:-1]
    expected = B1 / B2 * np.tan(y2) * (ddy1 - A1 * np.sin(y1) - A2 * np.cos(y1)) * np.cos(y1)
    assert_allclose(derivative(plan.t, deta), expected, atol=5e-4)


def test_section_iii_b_the_setup_functions_are_smooth_enough_and_hover_at_both_ends():
    # y in C3 for (13), and, ours: no acceleration at the ends, so that the inputs start and end at hover
    maneuver, h = Maneuver(goal=(1.0, 0.2)), 1e-4
    t = np.linspace(0.5, 9.5, 19)
    before, now, after = (setup_functions(maneuver, t + shift, np.array([40.0, -80.0])) for shift in (-h, 0.0, h))
    assert_allclose(now[:, 1:], (after - before)[:, :2] / (2.0 * h), atol=1e-6)
    ends = setup_functions(maneuver, np.array([0.0, 10.0]), np.array([40.0, -80.0]))
    assert_allclose(ends[:, 2], 0.0, atol=1e-13)


def test_section_iii_b_only_the_pitch_depends_on_the_free_parameters():
    t = np.linspace(0.0, 10.0, 11)
    some, others = (setup_functions(Maneuver(goal=(1.0, 0.2)), t, np.array(p)) for p in ([0.0, 0.0], [40.0, -80.0]))
    assert_allclose(some[0], others[0])
    assert np.abs(some[1] - others[1]).max() > 0.1


def test_section_iii_b_unconstrained_travel_increases_strictly(unconstrained_plan):
    assert (unconstrained_plan.x[1, 100:-100] > 0.0).all()
    assert (np.diff(unconstrained_plan.x[0, 100:-100]) > 0.0).all()


def test_section_iii_b_unconstrained_elevation_stays_zero(unconstrained_plan):
    assert_allclose(unconstrained_plan.x[[2, 3]], 0.0, atol=1e-12)


def test_section_iii_b_pitch_undershoots_to_accelerate_and_overshoots_to_decelerate(unconstrained_plan):
    t, x = unconstrained_plan.t, unconstrained_plan.x
    assert (x[4, (t > 0.1) & (t < 4.9)] < 0.0).all()
    assert (x[4, (t > 5.1) & (t < 9.9)] > 0.0).all()
    assert abs(t[x[1].argmax()] - 5.0) < 0.01


def test_section_iii_b_the_unconstrained_pitch_violates_its_limits(unconstrained_plan):
    low, high = PAPER.limits.pitch
    assert unconstrained_plan.x[4].min() < low
    assert unconstrained_plan.x[4].max() > high


def test_section_iii_b_both_unconstrained_voltages_exceed_the_upper_limit(unconstrained_plan):
    assert (unconstrained_plan.u.max(axis=1) > PAPER.limits.u_max).all()


def test_section_iii_b_a_longer_transition_time_makes_the_unconstrained_plan_keep_the_limits():
    u_min, u_max = PAPER.limits.u
    for duration, keeps in ((10.0, False), (15.0, True)):
        trajectory = plan_unconstrained(replace(PAPER, duration=duration))
        assert (trajectory.u.max() <= u_max and np.abs(trajectory.x[4]).max() <= Q3) == keeps
        assert trajectory.u.min() >= u_min


# Section III-C: reformulation of the constrained problem


@pytest.mark.parametrize("window", [(1.0, 11.0), (-4.0, 10.0), (-9.0, -2.0)])
def test_section_iii_c_equations_15_16_are_the_thrust_bounds(window):
    f_min, f_max = (K_PLUS * u**2 if u >= 0 else K_MINUS * u**2 for u in window)
    assert_allclose(PAPER.rig.thrust_bounds(window), (f_min, f_max))


def test_section_iii_c_equations_17_to_20_describe_the_image_of_the_voltage_box():
    u_f, u_b = np.random.default_rng(10).uniform(-1.0, 13.0, (2, 20000))
    f_f, f_b = np.vectorize(equation_2)(u_f), np.vectorize(equation_2)(u_b)
    v1, v2 = f_f + f_b, f_f - f_b
    in_the_box = (abs(u_f - 6.0) < 5.0) & (abs(u_b - 6.0) < 5.0)
    low, high = 2 * F_MIN, 2 * F_MAX
    by_17 = (low < v1 + v2) & (v1 + v2 < high) & (low < v1 - v2) & (v1 - v2 < high)
    (v2_min, v2_max), (v1_min, v1_max) = normal_form.v2_bounds(F), normal_form.v1_bounds(v2, F)
    by_18_to_20 = (v2_min < v2) & (v2 < v2_max) & (v1_min < v1) & (v1 < v1_max)
    assert 0.2 < in_the_box.mean() < 0.8
    np.testing.assert_array_equal(by_17, in_the_box)
    np.testing.assert_array_equal(by_18_to_20, in_the_box)


def test_section_iii_c_footnote_3_fixed_bounds_of_v1_and_varying_ones_of_v2_are_equivalent():
    v1, v2 = np.random.default_rng(11).uniform([[-0.2], [-0.8]], [[1.4], [0.8]], (2, 20000))
    (v2_min, v2_max), (v1_min, v1_max) = normal_form.v2_bounds(F), normal_form.v1_bounds(v2, F)
    by_paper = (v2_min < v2) & (v2 < v2_max) & (v1_min < v1) & (v1 < v1_max)
    low, high = 2 * F_MIN, 2 * F_MAX
    varying = np.minimum(v1 - low, high - v1)
    by_footnote = (low < v1) & (v1 < high) & (-varying < v2) & (v2 < varying)
    np.testing.assert_array_equal(by_paper, by_footnote)


def test_section_iii_c_equation_21_the_plans_outputs_accelerate_within_the_bounds(paper_plan):
    _, _, y1, dy1, y2, dy2 = paper_plan.x
    _, v2 = inputs(paper_plan.u)
    for rate, (low, high) in (
        (dy1, normal_form.ddy1_bounds((0.0, 0.0, y1, 0.0, y2, 0.0), v2, F, NOMINAL)),
        (dy2, normal_form.ddy2_bounds((0.0, 0.0, y1, 0.0, y2, 0.0), F, NOMINAL)),
    ):
        acceleration = derivative(paper_plan.t, rate)
        assert (low[1:-1] - 2e-3 < acceleration).all()
        assert (acceleration < high[1:-1] + 2e-3).all()


def test_section_iii_c_equation_22_are_the_bounds_of_the_elevation_acceleration():
    v1_min, v1_max = normal_form.v1_bounds(V2, F)
    lower = A1 * np.sin(Y1) + A2 * np.cos(Y1) + B2 * np.cos(Y2) * v1_max  # b2 < 0 swaps them, see the notes
    upper = A1 * np.sin(Y1) + A2 * np.cos(Y1) + B2 * np.cos(Y2) * v1_min
    assert (lower < upper).all()
    assert_allclose(normal_form.ddy1_bounds(AT, V2, F, NOMINAL), (lower, upper))


def test_section_iii_c_equation_23_are_the_bounds_of_the_pitch_acceleration():
    lower = A3 * np.cos(Y1) * np.sin(Y2) + B3 * (F_MIN - F_MAX)
    upper = A3 * np.cos(Y1) * np.sin(Y2) + B3 * (F_MAX - F_MIN)
    assert_allclose(normal_form.ddy2_bounds(AT, F, NOMINAL), (lower, upper))


def test_section_iii_c_equation_24_the_planned_pitch_stays_within_its_limits(paper_plan):
    low, high = PAPER.limits.pitch
    assert low <= paper_plan.x[4].min()
    assert paper_plan.x[4].max() <= high


def test_section_iii_c_remark_1_each_input_accelerates_one_output():
    _, B = linearise([0.0, 0.0, 0.1, 0.0, 0.3, 0.0], [0.6, 0.1], NOMINAL)
    ddy1, ddy2 = STATE_NAMES.index("elevation rate"), STATE_NAMES.index("pitch rate")
    assert (B[ddy1] != 0.0).tolist() == [True, False]
    assert (B[ddy2] != 0.0).tolist() == [False, True]


# Section III-D: constraints in the boundary value problem

PSI1 = [(-Q3, Q3), (-0.4, 1.1)]


def equation_27(xi, low, high):
    m = 4.0 / (high - low)
    return high + (low - high) / (1.0 + np.exp(m * xi))


@pytest.mark.parametrize("bounds", PSI1)
def test_section_iii_d_equation_27_is_psi1(bounds):
    assert_allclose(saturation.psi1(XI1, bounds).value, equation_27(XI1, *bounds), rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("bounds", PSI1)
def test_section_iii_d_the_slope_of_psi1_is_1_at_0(bounds):
    assert saturation.psi1(0.0, bounds).slope == pytest.approx(1.0, rel=1e-15)
    h = 1e-5
    assert (equation_27(h, *bounds) - equation_27(-h, *bounds)) / (2.0 * h) == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("bounds", PSI1)
def test_section_iii_d_psi1_increases_strictly_towards_asymptotic_limits(bounds):
    assert (saturation.psi1(np.linspace(-6.0, 6.0, 1000), bounds).slope > 0.0).all()
    assert_allclose([saturation.psi1(xi, bounds).value for xi in (-40.0, 40.0)], bounds, rtol=1e-12)


def test_section_iii_d_equations_25_26_the_planned_pitch_is_psi1_between_the_pitch_limits(solution, paper_plan):
    xi1 = solution.interpolate(paper_plan.t)[2]
    assert_allclose(paper_plan.x[4], equation_27(xi1, -Q3, Q3), atol=2e-5)
    assert_allclose(ConstrainedProblem(PAPER).pitch_bounds, (-Q3, Q3), atol=2e-5)


def test_section_iii_d_equation_28_the_pitch_rate_is_the_slope_times_xi2(solution, paper_plan):
    xi1, xi2 = solution.interpolate(paper_plan.t)[[2, 3]]
    slope = equation_27(xi1 + 1e-30j, -Q3, Q3).imag / 1e-30
    assert_allclose(paper_plan.x[5], slope * xi2, atol=5e-5)


def test_section_iii_d_equation_29_xi2_is_the_rate_of_xi1(solution):
    t = np.linspace(0.0, 10.0, 10001)
    xi1, xi2 = solution.interpolate(t)[[2, 3]]
    assert_allclose(derivative(t, xi1), xi2[1:-1], atol=1e-4)


@pytest.mark.parametrize("bounds", PSI1)
def test_section_iii_d_equation_30_is_the_second_derivative_of_the_pitch(bounds):
    e, m = np.exp(4.0 / (bounds[1] - bounds[0]) * XI1), 4.0 / (bounds[1] - bounds[0])
    first = 4.0 * e / (1.0 + e) ** 2
    second = 4.0 * m * e * (1.0 - e) / (1.0 + e) ** 3
    actual = saturation.ddy2(saturation.psi1(XI1, bounds), XI2, DDY2)
    assert_allclose(actual, second * XI2**2 + first * DDY2, rtol=1e-10)


def test_section_iii_d_equations_31_32_the_rate_of_xi2_keeps_the_bounds_of_the_pitch_acceleration(solution, motion):
    y1, xi1, xi2 = solution.Y[[0, 2, 3]]
    e, m = np.exp(4.0 / (2.0 * Q3) * xi1), 4.0 / (2.0 * Q3)
    first, second = 4.0 * e / (1.0 + e) ** 2, 4.0 * m * e * (1.0 - e) / (1.0 + e) ** 3
    y2 = equation_27(xi1, -Q3, Q3)
    low, high = (
        (A3 * np.cos(y1) * np.sin(y2) + B3 * v2 - second * xi2**2) / first for v2 in (F_MIN - F_MAX, F_MAX - F_MIN)
    )
    assert (low - 1e-3 <= motion.dxi2).all()
    assert (motion.dxi2 <= high + 1e-3).all()


@pytest.mark.parametrize("v", [-3.0, -2.0, -0.5, 0.0, 0.9, 1.0, 4.0])
def test_section_iii_d_equations_34_37_are_ramps(v):
    low, high = -2.0, 1.0
    expected = low if v < low else high if v > high else v
    assert saturation.ramp(v, (low, high)) == expected


@pytest.mark.parametrize("bounds", PSI1)
def test_section_iii_d_equation_35_inverts_psi1(bounds):
    assert_allclose(saturation.psi1_inverse(equation_27(XI1, *bounds), bounds), XI1, atol=1e-9)


def test_section_iii_d_equation_36_xi2_vanishes_at_both_ends(solution):
    assert_allclose(solution.Y[3, [0, -1]], 0.0, atol=1e-9)


def test_section_iii_d_equation_38_xi1_vanishes_at_both_ends_of_symmetric_limits(solution):
    assert_allclose(solution.Y[2, [0, -1]], 0.0, atol=1e-9)


def test_section_iii_d_equation_38_is_the_boundary_value_problem():
    problem, T, rng = ConstrainedProblem(PAPER), 10.0, np.random.default_rng(8)
    for _ in range(200):
        t, p = rng.uniform(0.0, T), rng.uniform(-1.0, 1.0, 6) * [3.0, 3.0, 15.0, 15.0, 15.0, 15.0]
        y1, dy1, xi1, xi2, _, deta = Y = rng.uniform(-1.0, 1.0, 6) * [0.4, 1.0, 1.5, 1.5, 6.0, 1.0]
        phi1 = sum(p[k - 1] * ((t / T) ** (k + 1) - t / T) for k in (1, 2))
        phi2 = sum(p[k + 1] * ((t / T) ** (k + 1) - t / T) for k in (1, 2, 3, 4))
        low, high = problem.pitch_bounds
        y2, e, m = equation_27(xi1, low, high), np.exp(4.0 / (high - low) * xi1), 4.0 / (high - low)
        first, second = 4.0 * e / (1.0 + e) ** 2, 4.0 * m * e * (1.0 - e) / (1.0 + e) ** 3
        weight = A3 * math.cos(y1) * math.sin(y2)
        psi2_low, psi2_high = ((weight + B3 * v2 - second * xi2**2) / first for v2 in (F_MIN - F_MAX, F_MAX - F_MIN))
        dxi2 = min(max(phi2, psi2_low), psi2_high)
        v2 = (second * xi2**2 + first * dxi2 - weight) / B3
        lift = A1 * math.sin(y1) + A2 * math.cos(y1)
        v1_low, v1_high = max(2 * F_MIN - v2, 2 * F_MIN + v2), min(2 * F_MAX - v2, 2 * F_MAX + v2)
        ddy1 = min(max(phi1, lift + B2 * math.cos(y2) * v1_high), lift + B2 * math.cos(y2) * v1_low)
        ddeta = B1 / B2 * math.tan(y2) * (ddy1 - lift) * math.cos(y1)
        actual = problem.rhs(np.array([t]), Y[:, None], p)[:, 0]
        assert_allclose(actual, [dy1, ddy1, xi2, dxi2, deta, ddeta], rtol=1e-9, atol=1e-11)


def test_section_iii_d_equation_39_the_new_inputs_vanish_at_both_ends():
    for basis in ConstrainedProblem(PAPER).ansatz(np.array([0.0, 10.0])):
        assert_allclose(basis, 0.0, atol=1e-15)


def test_section_iii_d_equation_40_there_are_2_and_4_free_parameters():
    assert KAPPA == (2, 4)
    assert [len(basis) for basis in ConstrainedProblem(PAPER).ansatz(np.zeros(1))] == [2, 4]


def test_section_iii_d_footnote_4_the_guess_of_xi_is_the_unconstrained_plan_where_that_keeps_the_limits():
    problem, unconstrained = ConstrainedProblem(PAPER), solve_unconstrained(PAPER)
    t, Y, _ = problem.guess(unconstrained)[:3]
    y2, dy2, _ = setup_functions(PAPER, t, unconstrained.p)[1]
    inside = np.abs(y2) < 0.9 * Q3
    at_xi1 = saturation.psi1(Y[2], problem.pitch_bounds)
    assert 0.2 < inside.mean() < 1.0
    assert_allclose(at_xi1.value[inside], y2[inside], atol=1e-9)
    assert_allclose((at_xi1.slope * Y[3])[inside], dy2[inside], atol=1e-9)


def test_section_iii_d_both_constraints_are_kept_by_the_plan(paper_plan):
    assert np.degrees(np.abs(paper_plan.x[4]).max()) <= 50.0 + 1e-4
    assert paper_plan.u.min() >= 1.0 - 1e-6
    assert paper_plan.u.max() <= 11.0 + 1e-6


def test_section_iii_d_v2_is_further_increased_to_keep_the_pitch_within_its_limits(paper_plan, unconstrained_plan):
    constrained, unconstrained = (np.abs(inputs(p.u)[1]).max() for p in (paper_plan, unconstrained_plan))
    assert constrained > 2.0 * unconstrained


def test_section_iii_d_the_inputs_are_most_aggressive_around_5_s(paper_plan):
    t, (_, v2) = paper_plan.t, inputs(paper_plan.u)
    assert abs(t[np.abs(v2).argmax()] - 5.0) < 0.5
    rates = np.abs(np.diff(paper_plan.u)).max(axis=0) / np.diff(t)
    assert abs(t[rates.argmax()] - 5.0) < 0.5


def test_section_iii_d_the_constrained_travel_leads_to_a_full_turn_without_turning_back(paper_plan):
    assert paper_plan.x[1].min() > -1e-4
    assert paper_plan.x[0, -1] == pytest.approx(2.0 * math.pi, abs=1e-6)


def test_section_iii_d_remark_2_pitch_rate_and_acceleration_vanish_towards_the_limits():
    far = saturation.psi1(np.array([-15.0, 15.0]), (-Q3, Q3))
    assert_allclose(far.value, (-Q3, Q3), atol=1e-9)
    assert_allclose(far.slope * 3.0, 0.0, atol=1e-9)
    assert_allclose(saturation.ddy2(far, 3.0, 3.0), 0.0, atol=1e-9)


def test_section_iii_d_equations_41_42_the_bounds_of_the_pitch_acceleration_always_include_zero():
    y1, y2 = np.meshgrid(np.linspace(-math.pi / 2, math.pi / 2, 91), np.linspace(-math.pi / 2, math.pi / 2, 91))
    low, high = normal_form.ddy2_bounds((0.0, 0.0, y1, 0.0, y2, 0.0), F, NOMINAL)
    assert (low < 0.0).all()
    assert (high > 0.0).all()


def test_section_iii_d_equation_43_holds_with_0_11_newton_against_0_58_newton():
    conservative = abs(A3) / B3
    assert conservative == pytest.approx(0.1151, abs=5e-5)
    v2_min, v2_max = normal_form.v2_bounds(PAPER.rig.thrust_bounds(PAPER.limits.u))
    assert (round(v2_min, 4), round(v2_max, 4)) == (-0.5826, 0.5826)
    assert v2_min < -conservative
    assert v2_max > conservative


# Section III-E: feedback


@pytest.fixture(scope="module")
def gains(paper_plan):
    return riccati_gains(paper_plan)


def test_section_iii_e_equation_44_the_state_is_travel_elevation_and_pitch_with_their_rates(paper_plan):
    assert STATE_NAMES == ("travel", "travel rate", "elevation", "elevation rate", "pitch", "pitch rate")
    assert_allclose(derivative(paper_plan.t, paper_plan.x[0::2]), paper_plan.x[1::2, 1:-1], atol=1e-4)


def test_section_iii_e_equation_45_the_plan_follows_the_dynamics(paper_plan):
    f = np.array(equation_3(paper_plan.x, *inputs(paper_plan.u)))
    assert_allclose(derivative(paper_plan.t, paper_plan.x), f[:, 1:-1], atol=1e-2)
    assert_allclose(np.median(np.abs(derivative(paper_plan.t, paper_plan.x) - f[:, 1:-1]), axis=1), 0.0, atol=1e-5)


def test_section_iii_e_equation_46_the_linear_system_is_what_small_deviations_follow(paper_plan):
    rng = np.random.default_rng(9)
    for t in (1.0, 4.6, 5.0, 8.2):
        x, u = paper_plan(t)
        v = inputs(u)
        A, B = linearise(x, v, NOMINAL)
        dx, du = rng.normal(size=6), rng.normal(size=2)
        for size in (1e-3, 1e-4):
            exact = np.subtract(equation_3(x + size * dx, *(v + size * du)), equation_3(x, *v))
            assert_allclose(exact, size * (A @ dx + B @ du), atol=20.0 * size**2)


def test_section_iii_e_equations_47_48_are_the_jacobians_along_the_plan(paper_plan):
    for t in np.linspace(0.0, 10.0, 23):
        x, u = paper_plan(t)
        A, B = linearise(x, inputs(u), NOMINAL)
        for ours, symbolic in zip((A, B), jacobians(x, inputs(u))):
            assert_allclose(ours, symbolic, rtol=1e-12, atol=1e-14)
        numeric = central_differences(lambda z: np.array(equation_3(z[:6], *z[6:])), np.concatenate((x, inputs(u))))
        assert_allclose(np.hstack((A, B)), numeric, atol=1e-8)


def test_section_iii_e_equation_49_the_weights_are_definite_as_the_paper_asks(gains):
    assert np.linalg.eigvalsh(tvlqr.Q).min() > 0.0
    assert np.linalg.eigvalsh(tvlqr.R).min() > 0.0
    assert np.linalg.eigvalsh(gains.P[..., -1]).min() >= 0.0


def test_section_iii_e_equation_50_P_obeys_the_riccati_equation(unconstrained_plan):
    M = 3.0 * np.eye(6)
    gains = riccati_gains(unconstrained_plan, M=M)
    dP = CubicSpline(gains.t, gains.P, axis=-1).derivative()
    for k in range(100, len(gains.t) - 100, 37):
        x, u = unconstrained_plan(gains.t[k])
        (A, B), P = jacobians(x, inputs(u)), gains.P[..., k]
        right = A.T @ P + P @ A + tvlqr.Q - P @ B @ np.linalg.inv(tvlqr.R) @ B.T @ P
        assert_allclose(-dP(gains.t[k]), right, atol=1e-4)
    assert_allclose(gains.P[..., -1], M)


def test_section_iii_e_equation_51_are_the_gains(paper_plan, gains):
    for k in range(0, len(gains.t), 53):
        x, u = paper_plan(gains.t[k])
        _, B = jacobians(x, inputs(u))
        assert_allclose(gains.K[..., k], np.linalg.inv(tvlqr.R) @ B.T @ gains.P[..., k], rtol=1e-9, atol=1e-9)


def test_section_iii_e_equation_51_far_from_the_end_of_a_hover_the_gain_is_stationary():
    u = np.full((2, 2), math.sqrt(0.5 * -A2 / B2 / K_PLUS))
    gains = riccati_gains(Trajectory([0.0, 40.0], np.zeros((6, 2)), u), M=tvlqr.Q)
    A, B = jacobians(np.zeros(6), (-A2 / B2, 0.0))
    P = solve_continuous_are(A, B, tvlqr.Q, tvlqr.R)
    assert_allclose(gains(0.0), np.linalg.solve(tvlqr.R, B.T @ P), rtol=1e-5, atol=1e-7)


def test_section_iii_e_figure_9_travel_acts_on_the_thrust_sum_only_while_the_body_is_pitched(gains, paper_plan):
    # (3a): level, the sum of the thrusts does not move travel
    pitched = paper_plan.t[np.abs(paper_plan.x[4]).argmax()]
    assert abs(gains(10.0)[0, 0]) < 1e-6
    assert abs(gains(pitched)[0, 0]) > 0.1
