"""The Riccati gains against other integrators, the algebraic Riccati equation and simulated costs."""

import numpy as np
import pytest
from independent import hover, inputs, jacobians
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp
from scipy.linalg import solve_continuous_are

from heli_gym import HelicopterParameters, Trajectory
from heli_gym.baselines import riccati_gains
from heli_gym.baselines.paper.tvlqr import Q, R

M = np.diag([30.0, 10.0, 50.0, 10.0, 2.0, 1.0])


def linearised(trajectory: Trajectory, t: float) -> tuple[np.ndarray, np.ndarray]:
    x, u = trajectory(t)
    return jacobians(x, inputs(u))


def stationary_gain(elevation: float) -> np.ndarray:
    A, B = linearised(hover(1.0, elevation), 0.0)
    return np.linalg.solve(R, B.T @ solve_continuous_are(A, B, Q, R))


def closed_loop_cost(trajectory: Trajectory, K, x0: np.ndarray) -> float:
    """The cost (49) of the linear system (46) under Delta u = -K(t) Delta x, from x0, by simulation."""

    def rhs(t, z):
        A, B = linearised(trajectory, t)
        x, u = z[:6], -K(t) @ z[:6]
        return np.concatenate((A @ x + B @ u, [x @ Q @ x + u @ R @ u]))

    flight = solve_ivp(
        rhs, (0.0, trajectory.duration), np.concatenate((x0, [0.0])), rtol=1e-8, atol=1e-10, max_step=0.05
    )
    x_T, cost = flight.y[:6, -1], flight.y[6, -1]
    return cost + x_T @ M @ x_T


@pytest.fixture(scope="module")
def gains(paper_plan):
    return riccati_gains(paper_plan, M=M)


@pytest.mark.parametrize(("elevation", "end"), [(0.0, Q), (-0.2, np.zeros((6, 6))), (0.25, 100.0 * np.eye(6))])
def test_gain_far_from_the_end_is_the_stationary_lqr_gain(elevation, end):
    K = riccati_gains(hover(60.0, elevation), M=end)
    assert_allclose(K(0.0), stationary_gain(elevation), rtol=1e-6, atol=1e-8)


def test_without_a_weight_of_the_end_the_gains_end_at_the_stationary_ones(paper_plan):
    assert_allclose(riccati_gains(paper_plan)(paper_plan.duration), stationary_gain(0.0), rtol=1e-6, atol=1e-8)


# The corners of the constrained inputs below `CORNER` cost some accuracy.
@pytest.mark.parametrize(("reference", "tolerance"), [("unconstrained_plan", 1e-6), ("paper_plan", 5e-5)])
def test_the_gains_are_those_of_an_adaptive_integration_of_the_riccati_equation(reference, tolerance, request):
    reference = request.getfixturevalue(reference)
    gains = riccati_gains(reference, M=M)

    def rhs(t, p):
        (A, B), P = linearised(reference, t), p.reshape(6, 6)
        return -(A.T @ P + P @ A + Q - P @ B @ np.linalg.inv(R) @ B.T @ P).ravel()

    times = gains.t[::-10]
    backwards = solve_ivp(rhs, times[[0, -1]], M.ravel(), t_eval=times, rtol=1e-9, atol=1e-9, max_step=0.05)
    for t, p in zip(times, backwards.y.T):
        _, B = linearised(reference, t)
        assert_allclose(gains(t), np.linalg.solve(R, B.T @ p.reshape(6, 6)), rtol=0.0, atol=tolerance)


def test_P_is_symmetric_and_positive_definite_all_the_way(gains):
    P = np.moveaxis(gains.P, -1, 0)
    assert_allclose(P, P.transpose(0, 2, 1), atol=1e-10)
    assert np.linalg.eigvalsh(P).min() > 0.0
    assert_allclose(P[-1], M, rtol=1e-14)


@pytest.mark.parametrize("seed", [0, 1])
def test_the_cost_of_the_closed_loop_agrees_with_P(paper_plan, gains, seed):
    x0 = 0.1 * np.random.default_rng(seed).normal(size=6)
    assert_allclose(closed_loop_cost(paper_plan, gains, x0), x0 @ gains.P[..., 0] @ x0, rtol=1e-4)


@pytest.mark.parametrize("seed", [0, 1])
def test_any_other_gain_costs_more(paper_plan, gains, seed):
    rng = np.random.default_rng(seed)
    x0, other = rng.normal(size=6), 1.0 + 0.3 * rng.normal(size=(2, 6))
    assert closed_loop_cost(paper_plan, lambda t: other * gains(t), x0) > 1.001 * x0 @ gains.P[..., 0] @ x0


def test_the_closed_loop_at_hover_is_stable():
    A, B = linearised(hover(1.0), 0.0)
    K = riccati_gains(hover(20.0))(0.0)
    assert np.linalg.eigvals(A - B @ K).real.max() < -0.1


def test_gains_are_linear_in_between_and_held_before_and_after(gains):
    k, share = 123, 0.3
    t = (1.0 - share) * gains.t[k] + share * gains.t[k + 1]
    assert_allclose(gains(t), (1.0 - share) * gains.K[..., k] + share * gains.K[..., k + 1], rtol=1e-9)
    assert_allclose(gains(gains.t[k]), gains.K[..., k], rtol=1e-9)
    np.testing.assert_array_equal(gains(-1.0), gains.K[..., 0])
    np.testing.assert_array_equal(gains(1e3), gains.K[..., -1])


def test_gains_at_many_times_are_those_one_by_one(gains):
    times = np.linspace(-1.0, 11.0, 7)
    np.testing.assert_array_equal(gains(times), np.stack([gains(t) for t in times], axis=-1))


def test_scaling_all_weights_alike_changes_no_gain(paper_plan, gains):
    scaled = riccati_gains(paper_plan, Q=5.0 * Q, R=5.0 * R, M=5.0 * M)
    assert_allclose(scaled.K, gains.K, rtol=1e-7, atol=1e-9)


def test_gains_belong_to_the_parameters_of_the_model():
    weaker = HelicopterParameters()._replace(b3=2.0)
    assert np.abs(riccati_gains(hover(1.0), weaker).K - riccati_gains(hover(1.0)).K).max() > 0.1


SYMMETRIC_INDEFINITE = np.diag([1.0, 1.0, 1.0, 1.0, 1.0, -1.0])


@pytest.mark.parametrize("end", [M, None], ids=["with M", "without M"])
@pytest.mark.parametrize(
    ("name", "weight"),
    [
        ("Q", np.eye(5)),
        ("Q", np.ones(6)),
        ("Q", SYMMETRIC_INDEFINITE),
        ("Q", np.eye(6) + np.eye(6, k=1)),
        ("Q", np.full((6, 6), np.nan)),
        ("R", np.eye(6)),
        ("R", np.diag([1.0, 0.0])),
        ("R", np.diag([1.0, -1.0])),
        ("R", np.array([[1.0, 0.5], [0.0, 1.0]])),
        ("R", np.diag([1.0, np.inf])),
    ],
)
def test_an_invalid_weight_is_named(name, weight, end):
    with pytest.raises(ValueError, match=rf"^{name} = "):
        riccati_gains(hover(1.0), M=end, **{name: weight})


@pytest.mark.parametrize(
    "weight", [np.eye(2), SYMMETRIC_INDEFINITE, np.eye(6) + np.eye(6, k=1), np.full((6, 6), np.inf)]
)
def test_an_invalid_terminal_weight_is_named(weight):
    with pytest.raises(ValueError, match=r"^M = "):
        riccati_gains(hover(1.0), M=weight)


def test_weights_may_be_lists():
    lists = riccati_gains(hover(1.0), Q=Q.tolist(), R=R.tolist(), M=M.tolist())
    np.testing.assert_array_equal(lists.K, riccati_gains(hover(1.0), M=M).K)
