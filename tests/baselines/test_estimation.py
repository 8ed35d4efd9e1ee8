"""Assumed actuator, Kalman filter on the angles, and disturbance-accommodated reference."""

import math
from dataclasses import replace

import numpy as np
import pytest
from independent import TABLE_I, equation_2, equation_3, hover
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp
from scipy.linalg import expm, solve_discrete_are

from heli_gym import HelicopterParameters, Limits, linearise
from heli_gym.baselines import make_policy
from heli_gym.baselines.control.discrete_lqr import augmented
from heli_gym.baselines.control.estimation import (
    ENCODER_NOISE,
    Noise,
    discretise,
    disturbance_accommodated_reference,
    kalman_gains,
    predict,
    rotor_response,
)
from heli_gym.env import find_reference
from heli_gym.model import hover_input
from heli_gym.rig import PAPER, rig_of

NOMINAL = HelicopterParameters()
DT = 0.02
NOISE = Noise(travel_disturbance=0.3, elevation_disturbance=0.1, pitch_disturbance=0.5, acceleration=0.05)
PITCH_LIMITS = Limits().pitch


def some_states(count: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """States, rotor speeds, voltages and disturbances."""
    rng = np.random.default_rng(seed)
    return (
        rng.uniform(-0.5, 0.5, (6, count)),
        rng.uniform(2.0, 11.0, (2, count)),
        rng.uniform(2.0, 11.0, (2, count)),
        rng.uniform(-0.3, 0.3, (3, count)),
    )


# The actuator


@pytest.mark.parametrize("control_period", [0.005, 0.01, 0.02, 0.04])
@pytest.mark.parametrize("name", ["lag-lqr", "kalman-lqr"])
def test_policies_assume_the_rigs_delay_in_seconds_at_any_control_period(name, control_period):
    rig = replace(PAPER, delay=0.04)
    policy = make_policy(name, find_reference("travel-180"), control_period, rig=rig)
    assert policy.actuator.delay * control_period == pytest.approx(0.04)
    assert policy.actuator.lag == rig.lag


def test_after_its_lag_a_rotor_has_turned_by_all_but_one_over_e():
    assert rotor_response(2.0, 7.0, 0.1, 0.1) == pytest.approx(7.0 - 5.0 / math.e)
    assert rotor_response(2.0, 7.0, 0.0, 0.1) == 7.0


@pytest.mark.parametrize("lag", [0.05, 0.2, 0.0])
def test_the_prediction_agrees_with_an_adaptive_integrator(lag):
    for x, w, u, d in zip(*(part.T for part in some_states(5))):

        def rhs(t, z, w=w, u=u, d=d):
            rotors = u + (w - u) * math.exp(-t / lag) if lag else u
            f_f, f_b = (equation_2(float(rotor)) for rotor in rotors)
            derivative = np.array(equation_3(z, f_f + f_b, f_f - f_b), dtype=float)
            derivative[1::2] += d
            return derivative

        exact = solve_ivp(rhs, (0.0, DT), x, "DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
        later, rotors = predict(x, w, u, d, DT, lag, PAPER)
        assert_allclose(later, exact, atol=5e-6)
        assert_allclose(rotors, rotor_response(w, u, lag, DT))


def test_a_prediction_of_many_is_that_of_each():
    x, w, u, d = some_states(4)
    together = predict(x, w, u, d, DT, 0.1, PAPER)
    for k in range(4):
        alone = predict(x[:, k], w[:, k], u[:, k], d[:, k], DT, 0.1, PAPER)
        for one, many in zip(alone, together):
            assert_allclose(many[:, k], one, rtol=1e-14)


def test_discretised_systems_are_the_matrix_exponentials():
    rng = np.random.default_rng(4)
    A, B = rng.normal(size=(3, 5, 5)), rng.normal(size=(3, 5, 2))
    for a, b, transition, gain in zip(A, B, *discretise(A, B, DT)):
        exact = expm(DT * np.block([[a, b], [np.zeros((2, 7))]]))
        assert_allclose(transition, exact[:5, :5], atol=1e-7)
        assert_allclose(gain, exact[:5, 5:], atol=1e-7)


@pytest.mark.parametrize(("lag", "dt"), [(1e-3, 0.04), (5e-3, 0.02), (0.02, 0.1), (0.1, 1.0)])
def test_discretised_systems_are_the_matrix_exponentials_for_periods_beyond_the_rotors_lag(lag, dt):
    x, v = hovering(1.0)
    system = augmented(*(np.moveaxis(part, -1, 0) for part in linearise(x, v, HelicopterParameters())), lag, True)
    A, B = (part[:1] for part in system)
    (transition,), (gain,) = discretise(A, B, dt)
    exact = expm(dt * np.block([[A[0], B[0]], [np.zeros((2, 12))]]))
    assert_allclose(transition, exact[:10, :10], atol=1e-4)
    assert_allclose(gain, exact[:10, 10:], atol=1e-4)


# The filter


def hovering(duration: float) -> tuple[np.ndarray, np.ndarray]:
    count = round(duration / DT) + 1
    return np.zeros((6, count)), np.repeat(hover_input(0.0, NOMINAL)[:, None], count, axis=1)


def test_far_from_the_start_the_kalman_gain_is_that_of_the_algebraic_riccati_equation():
    gains = kalman_gains(*hovering(30.0), DT, NOMINAL, NOISE)
    A, _ = linearise(np.zeros(6), hover_input(0.0, NOMINAL), NOMINAL)
    extended = np.zeros((9, 9))
    extended[:6, :6] = A
    extended[[1, 3, 5], [6, 7, 8]] = 1.0
    F, H = expm(DT * extended), np.eye(9)[[0, 2, 4]]
    continuous = np.zeros((9, 9))
    continuous[[1, 3, 5], [1, 3, 5]] = NOISE.acceleration**2
    continuous[[6, 7, 8], [6, 7, 8]] = np.array(NOISE[:3]) ** 2
    process = 0.5 * DT * (continuous + F @ continuous @ F.T)
    P = solve_discrete_are(F.T, H.T, process, ENCODER_NOISE**2 * np.eye(3))
    stationary = P @ H.T @ np.linalg.inv(H @ P @ H.T + ENCODER_NOISE**2 * np.eye(3))
    assert_allclose(gains[:, :, -1], stationary, rtol=1e-4, atol=1e-6)


def test_the_filter_finds_the_state_and_a_constant_disturbance_from_the_angles():
    x_ref, v = hovering(6.0)
    gains = kalman_gains(x_ref, v, DT, NOMINAL, NOISE)
    u = hover(1.0).u[:, 0]
    disturbance = np.array([0.02, -0.05, 0.1])
    x = np.array([0.02, 0.01, -0.02, 0.0, 0.01, 0.02])
    estimate, believed = np.zeros(6), np.zeros(3)
    for k in range(gains.shape[2]):
        correction = gains[:, :, k] @ (x - estimate)[0::2]
        corrected, believed = estimate + correction[:6], believed + correction[6:]
        if k == gains.shape[2] - 1:
            break
        estimate, _ = predict(corrected, u, u, believed, DT, 0.0, PAPER)
        x, _ = predict(x, u, u, disturbance, DT, 0.0, PAPER)
    assert_allclose(believed, disturbance, atol=2e-3)
    assert_allclose(corrected, x, atol=2e-3)


# The reference


@pytest.mark.parametrize("seed", range(5))
def test_the_accommodated_reference_accelerates_as_the_reference_does_without_the_disturbance(seed):
    rng = np.random.default_rng(seed)
    x = rng.uniform(-0.3, 0.3, 6)
    v, disturbance = rng.uniform([0.5, -0.1], [0.9, 0.1]), rng.uniform(-0.1, 0.1, 3)
    target, held = disturbance_accommodated_reference(x, v, disturbance, PITCH_LIMITS, NOMINAL)
    wanted = np.array(equation_3(x, *v), dtype=float)[1::2]
    found = np.array(equation_3(target, *held), dtype=float)[1::2] + disturbance
    assert_allclose(found, wanted, atol=1e-12)
    assert_allclose(np.delete(target, 4), np.delete(x, 4))


def test_without_a_disturbance_the_reference_is_left_as_it_is():
    x, v = np.array([0.1, 0.2, -0.1, 0.3, 0.4, 0.5]), np.array([0.7, -0.1])
    for accommodating, given in zip(
        disturbance_accommodated_reference(x, v, np.zeros(3), PITCH_LIMITS, NOMINAL), (x, v)
    ):
        assert_allclose(accommodating, given, atol=1e-15)


def test_the_tilt_stays_within_the_pitch_limits():
    target, _ = disturbance_accommodated_reference(
        np.zeros(6), np.array([0.6, 0.0]), np.array([5.0, 0.0, 0.0]), PITCH_LIMITS, NOMINAL
    )
    assert target[4] == PITCH_LIMITS[1]


def test_a_heavier_helicopter_is_believed_in():
    heavier = NOMINAL._replace(a2=1.2 * TABLE_I.a2)
    v = hover_input(0.0, heavier)
    u = np.full(2, math.sqrt(0.5 * v[0] / TABLE_I.k_plus))
    later, _ = predict(np.zeros(6), u, u, np.zeros(3), DT, 0.1, rig_of(heavier))
    assert_allclose(later, 0.0, atol=1e-15)
