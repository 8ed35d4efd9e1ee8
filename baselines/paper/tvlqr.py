"""Section III-E: time-varying linear quadratic regulator (46)-(51)."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.linalg import expm, schur, solve_continuous_are

from heli_gym.baselines.paper.riccati import integrate, jacobians_along
from heli_gym.model import hover_input, linearise, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.rig import Rig, assumed_rig
from heli_gym.trajectory import Trajectory

SAMPLE = 0.02  # s, longest time between two samples of the gains
LONGEST = 1e4  # s, duration of a reference; gains along a longer one would fill the memory
CORNER = 0.03  # V/s, change of a voltage's slope at which a step of the Riccati integration ends
STIFF = 1e-4  # estimated relative error of a step above which the stiff integrator is used
SYMMETRY = 1e-5  # largest relative difference of two entries of a symmetric matrix
GAUSS = 0.5 - np.sqrt(3.0) / 6.0, 0.5 + np.sqrt(3.0) / 6.0  # nodes of the linearisation within a step

# Weights of (49), missing in the paper: round numbers by Bryson's rule. Weights found by `python -m
# heli_gym.baselines.commands.tune` are no better on draws outside the tuning set.
Q = np.diag([40.0, 20.0, 40.0, 20.0, 1.0, 0.5])  # per rad² and (rad/s)²
R = np.diag([1.0, 1.0])  # per N²


@dataclass(frozen=True, eq=False)
class Gains:
    """Feedback gains over time: t (N,) in s, K (2, 6, N) of (51), P (6, 6, N) of (50). Calling it interpolates K."""

    t: np.ndarray
    K: np.ndarray
    P: np.ndarray

    def __call__(self, t: ArrayLike) -> np.ndarray:
        """K (2, 6, ...) at the times t in s: linear between samples, constant before the start and after the end."""
        s = np.clip(np.asarray(t, dtype=float) / self.t[1], 0.0, len(self.t) - 1.0)
        k = np.minimum(s.astype(int), len(self.t) - 2)
        return (k + 1 - s) * self.K[:, :, k] + (s - k) * self.K[:, :, k + 1]


def stationary_cost(elevation: float, parameters: HelicopterParameters, Q: np.ndarray, R: np.ndarray) -> np.ndarray:
    """P (6, 6) of the stationary regulator at hover at an elevation in rad, by the algebraic Riccati equation."""
    hover = np.array([[0.0], [0.0], [elevation], [0.0], [0.0], [0.0]])
    J, *_ = jacobians_along(hover, hover_input([elevation], parameters), parameters)
    A, B = J[:, :, :6], J[:, :, 6:]
    # the stable invariant subspace of the Hamiltonian system contains the optimal closed loop (Laub, 1979)
    _, Z, decaying = schur(hamiltonian((A, B), Q, R)[0], sort="lhp")
    if decaying != 6:
        return solve_continuous_are(A[0], B[0], Q, R)  # raises the proper error, if any
    P = np.linalg.solve(Z[:6, :6].T, Z[6:, :6].T)
    return 0.5 * (P + P.T)


def stationary_gain(
    elevation: float, parameters: HelicopterParameters, Q: np.ndarray = Q, R: np.ndarray = R
) -> np.ndarray:
    """Gain K (2, 6) of the stationary regulator at hover at an elevation in rad."""
    _, B = linearise([0.0, 0.0, elevation, 0.0, 0.0, 0.0], hover_input(elevation, parameters), parameters)
    return np.linalg.solve(R, B.T @ stationary_cost(elevation, parameters, Q, R))


def check_weight(name: str, weight: ArrayLike, size: int, definite: bool = False) -> np.ndarray:
    """Return the weight (size, size). Raises ValueError unless it is symmetric and positive (semi)definite."""
    weight = np.asarray(weight, dtype=float)
    finite = weight.shape == (size, size) and np.isfinite(weight).all()
    if not finite or (np.abs(weight - weight.T) > SYMMETRY * np.abs(weight)).any():
        raise ValueError(f"{name} = {weight}: must be a symmetric ({size}, {size}) matrix")
    least = np.linalg.eigvalsh(weight)[0]
    rounding = 1e-12 * np.abs(weight).max()
    if least < -rounding or (definite and least <= rounding):
        kind = "positive definite" if definite else "positive semidefinite"
        raise ValueError(f"{name} = {weight}: must be a {kind} matrix, and one eigenvalue is {least:g}")
    return weight


def riccati_gains(
    reference: Trajectory,
    rig: Rig | HelicopterParameters | None = None,
    Q: np.ndarray = Q,
    R: np.ndarray = R,
    M: np.ndarray | None = None,
) -> Gains:
    """Gains (51) along a reference, from the Riccati equation (50) integrated backwards from P(T) = M.

    The gains act on v, not on u: the model is linear in v, while the thrust map (2) is quadratic. The integrator is
    compiled Runge-Kutta or, if its error estimate shows that the weights make (50) too stiff, a Magnus expansion.

    Args:
        reference: trajectory to track; its duration is T.
        rig: rig of the linearised model (3), the reference's by default; parameters stand for the paper's rig with
            them.
        Q: weight (6, 6) of the state in (49).
        R: weight (2, 2) of the thrusts v in (49).
        M: weight (6, 6) of the final state in (49). Without it, the cost of hover at the end of the reference for
            infinite time, so that the final gains are those of the stationary regulator.

    Raises:
        ValueError: if a weight has the wrong shape, is not symmetric or not positive (semi)definite, or the reference
            is longer than LONGEST.
    """
    if reference.duration > LONGEST:
        raise ValueError(f"reference = a Trajectory of {reference.duration:g} s: must be of at most {LONGEST:g} s")
    Q, R = check_weight("Q", Q, 6), check_weight("R", R, 2, definite=True)
    rig = assumed_rig(reference, rig)
    parameters = rig.parameters
    M = stationary_cost(reference.x[2, -1], parameters, Q, R) if M is None else check_weight("M", M, 6)

    samples = 2 * math.ceil(reference.duration / (2 * SAMPLE))
    t = np.linspace(0.0, reference.duration, samples + 1)
    nodes = np.union1d(t, corners(reference))
    times = np.insert(0.5 * (nodes[:-1] + nodes[1:]), range(len(nodes) - 1), nodes[:-1])  # a step has a middle
    x, u = reference(np.append(times, nodes[-1]))
    J, rows, columns = jacobians_along(x, np.stack(virtual_input(rig.thrust(u))), parameters)
    with np.errstate(all="ignore"):  # where the weights make (50) stiff, these steps diverge
        P, K, error = integrate(J, rows, columns, Q, R, M, np.diff(nodes))
    at = 2 * np.searchsorted(nodes, t)
    P, K, B = P[at], K[:, :, at], J[at, :, 6:]
    if not error < STIFF:
        P = integrate_stiff(reference, rig, Q, R, M, np.linspace(0.0, t[-1], 2 * len(t) - 1))[::2]
        K = np.moveaxis(np.linalg.inv(R) @ B.transpose(0, 2, 1) @ P, 0, -1)
    return Gains(t, K, np.moveaxis(P, 0, -1))


def corners(reference: Trajectory) -> np.ndarray:
    """Times in s at which a voltage of the reference changes its slope by more than `CORNER`."""
    slopes = np.diff(reference.u) / np.diff(reference.t)
    return reference.t[1:-1][(np.abs(np.diff(slopes)) > CORNER).any(axis=0)]


def integrate_stiff(reference, rig, Q, R, M, t) -> np.ndarray:
    """P (N, 6, 6) of (50) at the times t (N,), by a Magnus expansion of order four of the Hamiltonian system.

    It is exact for a constant linearisation, preserves positive semidefinite P, and is stable for stiff (50).
    """

    def linearised(times):
        x, u = reference(times)
        A, B = linearise(x, virtual_input(rig.thrust(u)), rig.parameters)
        return np.moveaxis(A, -1, 0), np.moveaxis(B, -1, 0)

    h, steps = t[1], len(t) - 1
    early, late = (hamiltonian(linearised(t[:-1] + c * h), Q, R) for c in GAUSS)
    transitions = expm(-0.5 * h * (early + late) - np.sqrt(3.0) / 12.0 * h**2 * (late @ early - early @ late))
    P = np.empty((steps + 1, 6, 6))
    P[steps] = M
    for n in range(steps, 0, -1):
        XL = transitions[n - 1] @ np.concatenate((np.eye(6), P[n]))
        P[n - 1] = np.linalg.solve(XL[:6].T, XL[6:].T)
        P[n - 1] = 0.5 * (P[n - 1] + P[n - 1].T)
    return P


def hamiltonian(linearisation: tuple[np.ndarray, np.ndarray], Q: np.ndarray, R: np.ndarray) -> np.ndarray:
    """Hamiltonian matrices H (N, 12, 12) of (50): d(X, L)/dt = H (X, L) and P = L X^-1."""
    A, B = linearisation
    H = np.empty((len(A), 12, 12))
    H[:, :6, :6] = A
    H[:, :6, 6:] = -B @ np.linalg.solve(R, B.transpose(0, 2, 1))
    H[:, 6:, :6] = -Q
    H[:, 6:, 6:] = -A.transpose(0, 2, 1)
    return H
