"""Riccati equation (50), integrated by compiled Runge-Kutta steps of order four.

The linearisation is that of `heli_gym.model.dynamics`, see `jacobian`; its zero and constant entries are detected
beforehand.
"""

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from heli_gym.baselines.paper.jacobian import jacobian_column
from heli_gym.compilation import jit_cached
from heli_gym.model import linearise
from heli_gym.parameters import HelicopterParameters

TINY = 1e-300  # prevents a division by zero
# Two generic states and inputs, at which zero and constant entries of the Jacobians are detected.
GENERIC = np.array([[0.3, 0.7, -0.2, 0.5, 0.4, -0.6, 0.9, 0.1], [-1.1, 0.2, 0.6, -0.3, -0.7, 0.8, 0.4, -0.3]])


@cache
def linearising_kernel() -> Callable:
    """Compile a function that fills in the given columns of J (N, 6, 8), derivatives of (3) by z (8, N) = (x, v)."""

    def linearise_along(z, columns, parameters, J):
        for n in range(z.shape[1]):
            for j in columns:
                x = z[0, n], z[1, n], z[2, n], z[3, n], z[4, n], z[5, n]
                dx = jacobian_column(x, (z[6, n], z[7, n]), j, parameters)
                for i in range(6):
                    J[n, i, j] = dx[i]

    return jit_cached(linearise_along)


@cache
def riccati_kernel() -> Callable:
    """Compile a function that fills in P (2 N + 1, 6, 6), backwards from its last entry, and K (2, 6, 2 N + 1) of (51).

    J (2 N + 1, 6, 8) are the Jacobians at the same times; only the entries given by `rows` and `columns` are read. R is
    the inverse of the weight. A step of h (N,) spans two entries, and the entry between them is interpolated. Returns
    the largest error estimate of a step relative to the diagonal of P: the difference to an embedded step of order
    three, which uses the slope at the end.
    """

    def integrate(P, J, rows, columns, Q, R, h, K):
        S, W, V, now, k = np.empty((6, 6)), np.empty((2, 6)), np.empty((2, 6)), np.empty((6, 6)), np.empty((5, 6, 6))
        scale, last, worst = np.empty(6), len(P) - 1, 0.0
        slope(P[last], J[last], rows, columns, Q, R, S, W, V, k[4])
        for n in range(last, 0, -2):
            step = h[n // 2 - 1]
            for i in range(6):
                for j in range(i + 1):
                    k[0, i, j] = k[4, i, j]
            for stage in range(1, 4):
                share = step if stage == 3 else 0.5 * step
                for i in range(6):
                    for j in range(i + 1):
                        now[i, j] = now[j, i] = P[n, i, j] + share * k[stage - 1, i, j]
                slope(now, J[n - 2 if stage == 3 else n - 1], rows, columns, Q, R, S, W, V, k[stage])
            for i in range(6):
                for j in range(i + 1):
                    rise = k[0, i, j] + 2.0 * (k[1, i, j] + k[2, i, j]) + k[3, i, j]
                    P[n - 2, i, j] = P[n - 2, j, i] = P[n, i, j] + step / 6.0 * rise
            slope(P[n - 2], J[n - 2], rows, columns, Q, R, S, W, V, k[4])
            error = 0.0
            for i in range(6):
                scale[i] = 1.0 / (math.sqrt(abs(P[n - 2, i, i])) + TINY)
                for j in range(i + 1):
                    error = max(error, abs(k[4, i, j] - k[3, i, j]) * scale[i] * scale[j])
                    middle = 0.5 * (P[n, i, j] + P[n - 2, i, j]) + 0.125 * step * (k[0, i, j] - k[4, i, j])
                    P[n - 1, i, j] = P[n - 1, j, i] = middle
            worst = max(worst, step / 6.0 * error)
        for n in range(last + 1):
            feedback(P[n], J[n], rows, columns, R, W, V)
            for i in range(6):
                K[0, i, n], K[1, i, n] = V[0, i], V[1, i]
        return worst

    return jit_cached(integrate)


def slope(P, J, rows, columns, Q, R, S, W, V, rate):
    """Fill in the lower triangle of -dP/dt (50); S is a work array for A' P, for W and V see `feedback`."""
    for i in range(6):
        for j in range(6):
            S[i, j] = 0.0
    for k in range(len(rows)):
        row, column = rows[k], columns[k]
        if column < 6:
            for i in range(6):
                S[column, i] += J[row, column] * P[row, i]
    feedback(P, J, rows, columns, R, W, V)
    for i in range(6):
        for j in range(i + 1):
            rate[i, j] = S[i, j] + S[j, i] + Q[i, j] - V[0, i] * W[0, j] - V[1, i] * W[1, j]


def feedback(P, J, rows, columns, R, W, V):
    """Fill in W = B' P and the gains V = R^-1 B' P (51), both (2, 6)."""
    for i in range(6):
        W[0, i] = W[1, i] = 0.0
    for k in range(len(rows)):
        row, column = rows[k], columns[k]
        if column >= 6:
            for i in range(6):
                W[column - 6, i] += J[row, column] * P[row, i]
    for i in range(6):
        V[0, i] = R[0, 0] * W[0, i] + R[0, 1] * W[1, i]
        V[1, i] = R[1, 0] * W[0, i] + R[1, 1] * W[1, i]


def jacobians_along(x: np.ndarray, v: np.ndarray, parameters: HelicopterParameters) -> tuple[np.ndarray, ...]:
    """Derivatives (N, 6, 8) of (3) by states x (6, N) and inputs v (2, N), and rows and columns of nonzero entries."""
    sample, rows, columns, varying = structure(parameters)
    J = np.empty((x.shape[1], 6, 8))
    J[:] = sample
    linearising_kernel()(np.concatenate((x, v)), varying, parameters, J)
    return J, rows, columns


@cache
def structure(parameters: HelicopterParameters) -> tuple[np.ndarray, ...]:
    """Derivatives (6, 8) of (3) at one point, rows and columns of the nonzero ones, and the columns that vary."""
    samples = np.stack([np.concatenate(linearise(z[:6], z[6:], parameters), axis=1) for z in GENERIC])
    return samples[0], *np.nonzero(samples.any(axis=0)), np.flatnonzero((samples[0] != samples[1]).any(axis=0))


def integrate(
    J: np.ndarray, rows: np.ndarray, columns: np.ndarray, Q: np.ndarray, R: np.ndarray, M: np.ndarray, h: np.ndarray
) -> tuple[np.ndarray, np.ndarray, float]:
    """P (2 N + 1, 6, 6) of (50), K (2, 6, 2 N + 1) of (51), and an upper estimate of the largest relative error.

    Takes N steps of h (N,) in s; J (2 N + 1, 6, 8) are the Jacobians of (3).
    """
    P, K = np.empty((len(J), 6, 6)), np.empty((2, 6, len(J)))
    P[-1] = M
    error = riccati_kernel()(P, J, rows, columns, Q, np.linalg.inv(R), h, K)
    return P, K, error
