"""Section III-E: the time-varying linear quadratic regulator (46)-(51)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.linalg import solve_continuous_are

from heli_gym.model import hover_input, linearise, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.trajectory import Trajectory

STEP = 0.01  # s, at most, of the Riccati integration

# The weights of (49), which the paper does not give.
Q = np.diag([40.0, 20.0, 40.0, 20.0, 1.0, 0.5])  # per rad² and (rad/s)²
R = np.diag([1.0, 1.0])  # per N²


@dataclass(frozen=True, eq=False)
class Gains:
    """Feedback gains over time: t (N,) in s, K (2, 6, N) of (51), P (6, 6, N) of (50). Called, interpolates K."""

    t: np.ndarray
    K: np.ndarray
    P: np.ndarray

    def __call__(self, t: ArrayLike) -> np.ndarray:
        """K (2, 6, ...) at the times t in s, linear in between; before and after, the ends are held."""
        s = np.clip(np.asarray(t, dtype=float) / self.t[1], 0.0, len(self.t) - 1.0)
        k = np.minimum(s.astype(int), len(self.t) - 2)
        return (k + 1 - s) * self.K[:, :, k] + (s - k) * self.K[:, :, k + 1]


def stationary_cost(elevation: float, parameters: HelicopterParameters, Q: np.ndarray, R: np.ndarray) -> np.ndarray:
    """P (6, 6) of the stationary regulator at hover at an elevation in rad, by the algebraic Riccati equation."""
    A, B = linearise([0.0, 0.0, elevation, 0.0, 0.0, 0.0], hover_input(elevation, parameters), parameters)
    return solve_continuous_are(A, B, Q, R)


def stationary_gain(
    elevation: float, parameters: HelicopterParameters, Q: np.ndarray = Q, R: np.ndarray = R
) -> np.ndarray:
    """Gain K (2, 6) of the stationary regulator at hover at an elevation in rad."""
    _, B = linearise([0.0, 0.0, elevation, 0.0, 0.0, 0.0], hover_input(elevation, parameters), parameters)
    return np.linalg.solve(R, B.T @ stationary_cost(elevation, parameters, Q, R))


def check_weight(name: str, weight: np.ndarray, size: int, definite: bool) -> None:
    weight = np.asarray(weight, dtype=float)
    if weight.shape != (size, size) or not np.isfinite(weight).all() or not np.allclose(weight, weight.T):
        raise ValueError(f"{name} = {weight}: a symmetric ({size}, {size}) matrix is needed")
    least = np.linalg.eigvalsh(weight).min()
    rounding = 1e-12 * np.abs(weight).max()
    if least < -rounding or (definite and least <= rounding):
        kind = "positive definite" if definite else "positive semidefinite"
        raise ValueError(f"{name} = {weight}: a {kind} matrix is needed, and one eigenvalue is {least:g}")


def riccati_gains(
    reference: Trajectory,
    parameters: HelicopterParameters = HelicopterParameters(),
    Q: np.ndarray = Q,
    R: np.ndarray = R,
    M: np.ndarray | None = None,
) -> Gains:
    """Gains (51) along a reference, by the Riccati equation (50) integrated backwards from P(T) = M.

    The gains act on v, not on u: the model is linear in v, while the thrust map (2) is quadratic.

    Args:
        reference: what is flown; its duration is T.
        parameters: those of the model (3) that is linearised.
        Q, R, M: the weights (6, 6), (2, 2) and (6, 6) of (49). Without an M, the cost of holding the end of the
            reference for ever, so that the gains end where the stationary regulator's are.

    Raises:
        ValueError: if a weight has the wrong shape, is not symmetric or not positive (semi)definite.
    """
    if M is None:
        M = stationary_cost(reference.x[2, -1], parameters, Q, R)
    for name, weight, size, definite in (("Q", Q, 6, False), ("R", R, 2, True), ("M", M, 6, False)):
        check_weight(name, weight, size, definite)

    steps = int(np.ceil(reference.duration / STEP))
    t = np.linspace(0.0, reference.duration, 2 * steps + 1)  # with the midpoints that RK4 needs
    x, u = reference(t)
    A, B = linearise(x, virtual_input(thrust(u, parameters)), parameters)
    A, B = np.moveaxis(A, -1, 0), np.moveaxis(B, -1, 0)
    BRB = B @ np.linalg.solve(R, B.transpose(0, 2, 1))

    def minus_dP(P, k):
        PA = P @ A[k]
        return PA + PA.T + Q - P @ BRB[k] @ P

    P = np.empty((steps + 1, 6, 6))
    P[steps] = M
    h = t[2]
    for n in range(steps, 0, -1):
        k = 2 * n
        d1 = minus_dP(P[n], k)
        d2 = minus_dP(P[n] + 0.5 * h * d1, k - 1)
        d3 = minus_dP(P[n] + 0.5 * h * d2, k - 1)
        d4 = minus_dP(P[n] + h * d3, k - 2)
        P[n - 1] = P[n] + h / 6.0 * (d1 + 2.0 * (d2 + d3) + d4)
    K = np.linalg.solve(R, B[::2].transpose(0, 2, 1) @ P)
    return Gains(t[::2], np.moveaxis(K, 0, -1), np.moveaxis(P, 0, -1))
