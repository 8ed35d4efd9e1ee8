"""Tasks of the course: solutions of the programs, and their flights."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp
from scipy.optimize import linprog

from heli_gym import dynamics, find_rig
from heli_gym.baselines import fly, make_policy, plan
from heli_gym.baselines.control.course import (
    PITCH_COMMAND,
    STEP,
    SchedulePolicy,
    bump,
    elevation_sign,
    flat_over_bump,
    linear_model,
    lqr_gain,
    travel_by_qp,
    travel_over_bump,
)
from heli_gym.env import Heli3DOFEnv
from heli_gym.model import virtual_input
from heli_gym.trajectory import Maneuver

NTNU = find_rig("ntnu")
osqp = pytest.importorskip("osqp")


@pytest.fixture(scope="module")
def schedule():
    return travel_by_qp(NTNU)


def test_the_sampled_model_is_the_rig_under_its_inner_loop_near_hover():
    A, B = linear_model(NTNU)
    c, x = np.array([1e-3, 0.0]), np.zeros(6)
    policy = SchedulePolicy(type("Held", (), {"commands": np.tile(c[:, None], 2), "x": np.zeros((6, 3))})(), NTNU)
    policy.control_period = 1e-9  # no integral to speak of

    def rhs(t, z):
        policy.reset(None)
        v = virtual_input(NTNU.thrust(policy(0.0, z)))
        return dynamics(z, v, NTNU.parameters)

    end = solve_ivp(rhs, (0.0, STEP), x, rtol=1e-10, atol=1e-13).y[:, -1]
    assert_allclose(end[[0, 1, 4, 5, 2, 3]], A @ x + B @ c, atol=1e-7)


def test_the_quadratic_program_obeys_the_model_and_the_limits_and_arrives(schedule):
    A, B = linear_model(NTNU)
    x, c = schedule.x, schedule.commands
    assert_allclose(x[:4, 1:], (A @ x[:, :-1] + B @ c)[:4], atol=1e-6)
    assert np.abs(c[0]).max() <= PITCH_COMMAND
    assert np.abs(x[2]).max() <= PITCH_COMMAND + 1e-6
    assert_allclose(x[:4, -1], [math.pi, 0.0, 0.0, 0.0], atol=1e-6)


def test_no_feasible_change_of_the_commands_makes_the_quadratic_program_better(schedule):
    # optimality: the gradient of the cost does not fall along any direction that keeps the constraints, to first order
    A, B = (part for part in linear_model(NTNU))
    A, b, n = A[:4, :4], B[:4, 0], schedule.commands.shape[1]
    response = np.zeros((n + 1, 4, n))
    for k in range(n):
        response[k + 1] = A @ response[k]
        response[k + 1][:, k] += b
    x, c = schedule.x[:4], schedule.commands[0]
    gradient = 2.0 * ((x[0, 1:] - math.pi) @ response[1:, 0] + c)
    pitch = response[1:, 2]
    at_top, at_bottom = x[2, 1:] > PITCH_COMMAND - 1e-4, x[2, 1:] < -PITCH_COMMAND + 1e-4
    rows = np.concatenate((pitch[at_top], -pitch[at_bottom]))
    bounds = [
        (-1.0 if value > -PITCH_COMMAND + 1e-4 else 0.0, 1.0 if value < PITCH_COMMAND - 1e-4 else 0.0) for value in c
    ]
    found = linprog(
        gradient,
        A_ub=rows if len(rows) else None,
        b_ub=np.zeros(len(rows)) if len(rows) else None,
        A_eq=response[-1],
        b_eq=np.zeros(4),
        bounds=bounds,
    )
    assert found.success
    assert found.fun > -1e-2


def test_the_linear_regulator_brings_the_travel_to_its_goal(schedule):
    env = Heli3DOFEnv(reference=plan(Maneuver(goal=(math.pi, 0.0), duration=15.0, rig=NTNU)), rig=NTNU)
    alone = fly(env, SchedulePolicy(schedule, NTNU))
    corrected = fly(env, SchedulePolicy(schedule, NTNU, lqr_gain(NTNU)))
    assert abs(corrected.x[0, -1] - math.pi) < 0.01 < abs(alone.x[0, -1] - math.pi)
    assert np.abs(corrected.x[4]).max() < 1.1 * PITCH_COMMAND


def test_the_nonlinear_program_clears_the_bump():
    pytest.importorskip("casadi")
    over = travel_over_bump(NTNU)
    A, B = linear_model(NTNU)
    assert_allclose(over.x[:, 1:], A @ over.x[:, :-1] + B @ over.commands, atol=1e-6)
    assert (elevation_sign(NTNU) * over.x[4] >= bump(over.x[0], math.pi) - 1e-6).all()
    assert_allclose(over.x[:4, -1], [math.pi, 0.0, 0.0, 0.0], atol=1e-6)


def test_the_packages_reference_over_the_bump_is_flown_over_it():
    reference = flat_over_bump(NTNU)
    flight = fly(Heli3DOFEnv(reference=reference, rig=NTNU), make_policy("feedforward+tvlqr", reference))
    assert (-flight.x[2] >= bump(flight.x[0], math.pi) - 1e-3).all()
    assert_allclose(flight.x[:, -1], reference.x[:, -1], atol=1e-3)


@pytest.mark.parametrize("duration", [0.1, math.nan, math.inf])
def test_a_duration_under_two_steps_is_refused(duration):
    with pytest.raises(ValueError, match="duration = "):
        travel_by_qp(NTNU, duration=duration)


def test_a_move_that_takes_longer_is_refused_with_the_solvers_word():
    with pytest.raises(RuntimeError, match=r"OSQP: .*infeasible.*longer"):
        travel_by_qp(NTNU, duration=2.0)


def test_a_control_period_longer_than_a_step_is_refused(schedule):
    with pytest.raises(ValueError, match=r"control_period = 0\.3"):
        SchedulePolicy(schedule, NTNU, control_period=0.3)
