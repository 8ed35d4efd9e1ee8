"""Discrete-time regulators: optimal, stationary far from the end, and equal to the paper's without extensions."""

from dataclasses import astuple, replace

import numpy as np
import pytest
from independent import jacobians
from numpy.testing import assert_allclose
from scipy.linalg import expm, solve_discrete_are

from heli_gym import HelicopterParameters, thrust
from heli_gym.baselines import riccati_gains
from heli_gym.baselines.control.discrete_lqr import IntegralWeights, augmented, regulator_gains
from heli_gym.baselines.control.weights import LAG_LQI, LAG_LQR, LQI, TVLQR
from heli_gym.env import find_reference
from heli_gym.model import hover_input, virtual_input

NOMINAL = HelicopterParameters()
HOVER = hover_input(0.0, NOMINAL)
DT = 0.02


def hovering(duration: float) -> tuple[np.ndarray, np.ndarray]:
    count = round(duration / DT) + 1
    return np.zeros((6, count)), np.repeat(HOVER[:, None], count, axis=1)


def system(lag: float, integral: bool) -> tuple[np.ndarray, np.ndarray]:
    """The continuous-time system at hover, written down once more."""
    A, B = (np.asarray(part, dtype=float) for part in jacobians(np.zeros(6), HOVER))
    C = np.eye(6)[[0, 2]]
    n = 6 + (2 if lag else 0) + (2 if integral else 0)
    whole, entry = np.zeros((n, n)), np.zeros((n, 2))
    whole[:6, :6] = A
    if lag:
        whole[:6, 6:8], whole[6:8, 6:8], entry[6:8] = B, -np.eye(2) / lag, np.eye(2) / lag
    else:
        entry[:6] = B
    if integral:
        whole[-2:, :6] = C
    return whole, entry


@pytest.mark.parametrize(("weights", "lag"), [(TVLQR, 0.0), (LQI, 0.0), (LAG_LQR, 0.1), (LAG_LQI, 0.1)])
def test_at_hover_the_gain_is_that_of_the_algebraic_riccati_equation(weights, lag):
    integral = isinstance(weights, IntegralWeights)
    A, B = system(lag, integral)
    n = len(A)
    exact = expm(DT * np.block([[A, B], [np.zeros((2, n + 2))]]))
    F, G = exact[:n, :n], exact[:n, n:]
    Q = np.zeros(n)
    Q[:6] = astuple(weights)[:6]
    if integral:
        Q[-2:] = astuple(weights)[8:]
    R = DT * np.diag(astuple(weights)[6:8])
    P = solve_discrete_are(F, G, DT * np.diag(Q), R)
    stationary = np.linalg.solve(R + G.T @ P @ G, G.T @ P @ F)
    gains = regulator_gains(*hovering(2.0), DT, NOMINAL, weights, lag)
    assert_allclose(gains, np.repeat(stationary[:, :, None], gains.shape[2], axis=2), rtol=1e-4, atol=1e-4)


def test_without_lag_and_integral_it_tends_to_the_papers_regulator_as_the_period_does_to_zero():
    reference = find_reference("travel-360")
    continuous = riccati_gains(reference)
    misses = []
    for dt in (0.004, 0.002):
        t = dt * np.arange(round(10.0 / dt) + 1)
        x, u = reference(t)
        v = np.stack(virtual_input(thrust(u)))
        misses.append(np.abs(regulator_gains(x, v, dt, NOMINAL, TVLQR) - continuous(t)).max())
    scale = np.abs(continuous.K).max()
    assert misses[1] < 0.6 * misses[0] < 0.06 * scale


def test_a_lag_and_integrals_are_more_states():
    A, B = jacobians(np.zeros(6), HOVER)
    for lag, integral in ((0.0, False), (0.0, True), (0.1, False), (0.1, True)):
        whole, entry = augmented(np.array([A], dtype=float), np.array([B], dtype=float), lag, integral)
        expected = system(lag, integral)
        assert_allclose(whole[0], expected[0])
        assert_allclose(entry[0], expected[1])


@pytest.mark.parametrize("weights", [LQI, LAG_LQI])
def test_the_closed_loop_at_hover_is_stable(weights):
    lag = 0.1 if weights is LAG_LQI else 0.0
    A, B = system(lag, True)
    n = len(A)
    exact = expm(DT * np.block([[A, B], [np.zeros((2, n + 2))]]))
    K = regulator_gains(*hovering(1.0), DT, NOMINAL, weights, lag)[:, :, 0]
    assert np.abs(np.linalg.eigvals(exact[:n, :n] - exact[:n, n:] @ K)).max() < 1.0


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -1.0, None, "3", 10**400])
@pytest.mark.parametrize("name", ["travel", "travel_integral", "thrust_sum"])
def test_weights_that_are_no_finite_numbers_at_least_zero_are_refused_by_name(name, value):
    with pytest.raises(ValueError, match=f"{name} = "):
        replace(LQI, **{name: value})
