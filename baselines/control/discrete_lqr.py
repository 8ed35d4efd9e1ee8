"""Linear quadratic regulators on the control grid, for (3) with rotor lag and error integrals.

The paper's continuous-time regulator is in `baselines/paper/tvlqr.py`. In discrete time (Åström and Wittenmark,
Computer-Controlled Systems, 3rd ed., Chapter 11) rotor lag and error integrals are additional states.
"""

from dataclasses import astuple, dataclass, fields
from typing import NamedTuple

import numpy as np
from scipy.linalg import solve_discrete_are

from heli_gym.baselines.control.estimation import discretise
from heli_gym.model import hover_input, linearise
from heli_gym.parameters import HelicopterParameters
from heli_gym.validation import is_number

INTEGRATED = (0, 2)  # indices in (44): travel and elevation


@dataclass(frozen=True)
class Weights:
    """Diagonals of Q and R in (49), per rad², (rad/s)² and N².

    Raises ValueError, here and in subclasses, for a weight that is negative or not finite, or a thrust weight of 0.
    """

    travel: float
    travel_rate: float
    elevation: float
    elevation_rate: float
    pitch: float
    pitch_rate: float
    thrust_sum: float
    thrust_difference: float

    def __post_init__(self) -> None:
        for item in fields(self):
            value, positive = getattr(self, item.name), item.name.startswith("thrust")
            if not (is_number(value) and value >= 0.0) or (positive and value == 0.0):
                least = "more than 0" if positive else "at least 0"
                raise ValueError(f"{item.name} = {value!r}: must be a finite number, {least}")

    @property
    def Q(self) -> np.ndarray:
        """State weights (6, 6)."""
        return np.diag(astuple(self)[:6])

    @property
    def R(self) -> np.ndarray:
        """Input weights (2, 2)."""
        return np.diag(astuple(self)[6:8])


@dataclass(frozen=True)
class IntegralWeights(Weights):
    """Weights with two more, on the integrals of the travel and elevation errors, per (rad s)²."""

    travel_integral: float
    elevation_integral: float


def augmented(A: np.ndarray, B: np.ndarray, lag: float, integral: bool) -> tuple[np.ndarray, np.ndarray]:
    """Linearisation A (K, n, n), B (K, n, 2) with additional states after the six of A (K, 6, 6), B (K, 6, 2).

    - With a lag in s: the input v (2,) itself, which follows the commanded v. For small deviations, a lag of the rotor
      speed is a lag of the thrust with the same time constant.
    - With `integral`: the integrals (2,) of the deviations of travel and elevation (Davison and Smith, "Pole assignment
      in linear time-invariant multivariable systems with constant disturbances", Automatica 7(4), 1971).
    """
    lagging = 2 if lag else 0
    n = 6 + lagging + (2 if integral else 0)
    A_augmented, B_augmented = np.zeros((len(A), n, n)), np.zeros((len(A), n, 2))
    A_augmented[:, :6, :6] = A
    if lag:
        A_augmented[:, :6, 6:8] = B
        A_augmented[:, (6, 7), (6, 7)] = -1.0 / lag
        B_augmented[:, (6, 7), (0, 1)] = 1.0 / lag
    else:
        B_augmented[:, :6] = B
    if integral:
        A_augmented[:, (n - 2, n - 1), INTEGRATED] = 1.0
    return A_augmented, B_augmented


class Problem(NamedTuple):
    """Sampled linear-quadratic problem at K times, on the states of `augmented`."""

    A: np.ndarray  # (K, n, n) transitions
    B: np.ndarray  # (K, n, 2)
    Q: np.ndarray  # (n, n) state cost of one control period
    R: np.ndarray  # (2, 2)


def sampled_problem(
    x: np.ndarray, v: np.ndarray, dt: float, parameters: HelicopterParameters, weights: Weights, lag: float
) -> Problem:
    """Linear-quadratic problem for deviations from x (6, K), v (2, K), with inputs held for dt seconds."""
    A, B = (np.moveaxis(part, -1, 0) for part in linearise(x, v, parameters))
    A, B = discretise(*augmented(A, B, lag, isinstance(weights, IntegralWeights)), dt)
    n = A.shape[1]
    Q = np.zeros((n, n))
    Q[:6, :6] = weights.Q
    if isinstance(weights, IntegralWeights):
        Q[(n - 2, n - 1), (n - 2, n - 1)] = weights.travel_integral, weights.elevation_integral
    return Problem(A, B, dt * Q, dt * weights.R)


def regulator_gains(
    x: np.ndarray, v: np.ndarray, dt: float, parameters: HelicopterParameters, weights: Weights, lag: float = 0.0
) -> np.ndarray:
    """Gains (2, n, K) on the states of `augmented` along a reference x (6, K), v (2, K), dt seconds apart.

    The Riccati difference equation runs backwards from the stationary cost of hover at the reference's last elevation.
    `IntegralWeights` add the error integrals to the states.
    """
    elevation = float(x[2, -1])
    x = np.concatenate((x, [[0.0], [0.0], [elevation], [0.0], [0.0], [0.0]]), axis=1)
    v = np.concatenate((v, hover_input(elevation, parameters)[:, None]), axis=1)
    A, B, Q, R = sampled_problem(x, v, dt, parameters, weights, lag)
    P = solve_discrete_are(A[-1], B[-1], Q, R)
    gains = np.empty((len(A) - 1, 2, A.shape[1]))
    for k in range(len(A) - 2, -1, -1):
        PA, PB = P @ A[k], P @ B[k]
        gains[k] = np.linalg.solve(R + B[k].T @ PB, PB.T @ A[k])
        P = Q + A[k].T @ (PA - PB @ gains[k])
        P = 0.5 * (P + P.T)
    return np.moveaxis(gains, 0, -1)
