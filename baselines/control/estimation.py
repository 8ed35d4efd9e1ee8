"""Prediction and estimation for controllers: rotor lag, delay and disturbances beyond (3).

Controllers know one nominal actuator, not the plant's draw. `predict` simulates it: this estimates the unmeasured rotor
speeds and compensates the delay (a Smith predictor in state space: Åström and Wittenmark, Computer-Controlled Systems,
3rd ed., Section 5.4). `kalman_gains` designs a Kalman filter on the three angles with three disturbance accelerations
as additional states (Anderson and Moore, Optimal Filtering, Chapters 3 and 5). `disturbance_accommodated_reference`
changes a reference so that it balances the estimated disturbances.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.protocol import apply_gains
from heli_gym.model import (
    dynamics,
    hover_input,
    inverse_dynamics,
    linearise,
    rk4_step,
    thrust_vector,
    virtual_input,
)
from heli_gym.parameters import HelicopterParameters
from heli_gym.rig import Rig

ANGLES = (0, 2, 4)  # indices in (44)
RATES = (1, 3, 5)
ENCODER_NOISE = 4e-4  # rad, standard deviation of rounding to 4096 counts per revolution: 2 pi / 4096 / sqrt(12)
ENCODER_COUNTS = 4096  # per revolution, of ENCODER_NOISE
SETTLED = 1.0  # s after the start of a flight, until the filter's gains no longer depend on the start
START_DEVIATIONS = (0.05, 0.05, 0.2)  # prior: angles (rad), rates (rad/s), disturbances (rad/s²)
# Least lift for which a tilt balances disturbances, as a share of hover thrust: 0.2 N on the paper's rig.
LEAST_LIFT = 0.2 / float(hover_input(0.0, HelicopterParameters())[0])


class Actuator(NamedTuple):
    """Nominal dynamics from the commanded voltage to the rotor speed."""

    lag: float = 0.1  # s, first order, of the rotor speed; about the middle of the range of the plant `lab`
    delay: int = 1  # control periods


IDEAL = Actuator(0.0, 0)


def nominal_actuator(rig: Rig, control_period: float) -> Actuator:
    """Nominal lag of the rig and its delay, rounded to whole control periods."""
    return Actuator(rig.lag, round(rig.delay / control_period))


def rotor_response(w: Any, u: Any, lag: float, time: float) -> Any:
    """Rotor speeds (2, ...), as voltages in V, a time in s after the speeds w under constant voltages u."""
    return u + (w - u) * math.exp(-time / lag) if lag else u


def predict(x: Any, w: Any, u: Any, disturbance: Any, dt: float, lag: float, rig: Rig) -> tuple[np.ndarray, Any]:
    """State (6, ...) and rotor speeds (2, ...) after dt seconds at the voltages u (2, ...), by one Runge-Kutta step.

    The disturbance (3, ...) in rad/s² adds to the accelerations of travel, elevation and pitch.
    """
    inputs = tuple(virtual_input(rig.thrust(rotor_response(w, u, lag, share * dt))) for share in (0.0, 0.5, 1.0))
    return np.stack(rk4_step(disturbed_dynamics, x, inputs, dt, disturbance, rig.parameters)), rotor_response(
        w, u, lag, dt
    )


def disturbed_dynamics(x: Any, v: Any, disturbance: Any, parameters: HelicopterParameters) -> tuple:
    """State derivative (6, ...) by (3) with additional accelerations (3, ...) in rad/s²."""
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dynamics(x, v, parameters)
    on_travel, on_elevation, on_pitch = disturbance
    return dq1, ddq1 + on_travel, dq2, ddq2 + on_elevation, dq3, ddq3 + on_pitch


def discretise(A: np.ndarray, B: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Transitions (K, n, n) and (K, n, m) over dt seconds of the systems A (K, n, n), B (K, n, m) with held inputs.

    The matrix exponential is a Taylor series up to order four, as in a Runge-Kutta step of order four. Where dt is too
    long for it, it is that of a fraction of dt, squared repeatedly (scaling and squaring; Moler and Van Loan, "Nineteen
    dubious ways to compute the exponential of a matrix, twenty-five years later", SIAM Review 45(1), 2003).
    """
    n, m = B.shape[1:]
    term = np.broadcast_to(np.eye(n + m), (len(A), n + m, n + m))
    generator = np.zeros_like(term)
    generator[:, :n] = np.concatenate((A, B), axis=2)
    norm = dt * float(np.abs(generator).sum(axis=1).max())
    squarings = 0 if norm <= 1.0 else 2 + math.ceil(math.log2(norm))
    step, total = dt / 2**squarings, term
    for k in range(1, 5):
        term = step / k * generator @ term
        total = total + term
    for _ in range(squarings):
        total = total @ total
    return total[:, :n, :n], total[:, :n, n:]


class Noise(NamedTuple):
    """Process-noise intensities of the Kalman filter."""

    travel_disturbance: float  # rad/s² per sqrt(s), random walk of each disturbance
    elevation_disturbance: float
    pitch_disturbance: float
    acceleration: float  # rad/s per sqrt(s), white acceleration on every axis


def encoder_noise(rig: Rig) -> float:
    """Standard deviation in rad of the rounding error of the rig's coarsest encoder."""
    return ENCODER_NOISE * (ENCODER_COUNTS / min(rig.encoder_counts))


def kalman_gains(
    x: np.ndarray,
    v: np.ndarray,
    dt: float,
    parameters: HelicopterParameters,
    noise: Noise,
    angle_noise: float = ENCODER_NOISE,
) -> np.ndarray:
    """Kalman gains (9, 3, K) from the angles' innovations to states and disturbances, from the start of a flight.

    The filter's states are (44) and three accelerations in rad/s², modelled as random walks. The covariances follow
    from (3), linearised along the reference x (6, K), v (2, K), dt seconds apart.
    """
    A = np.moveaxis(linearise(x, v, parameters)[0], -1, 0)
    extended = np.zeros((len(A), 9, 9))
    extended[:, :6, :6] = A
    extended[:, RATES, (6, 7, 8)] = 1.0
    transitions, _ = discretise(extended, np.zeros((len(A), 9, 1)), dt)
    drive = np.zeros((9, 6))
    drive[RATES, (0, 1, 2)] = noise.acceleration
    drive[(6, 7, 8), (3, 4, 5)] = noise[:3]
    # Process noise of a period by the trapezoidal rule: a random acceleration also changes rate and angle.
    driven = transitions @ drive
    process = 0.5 * dt * (drive @ drive.T + driven @ driven.transpose(0, 2, 1))
    on_angles, on_rates, on_disturbances = START_DEVIATIONS
    P = np.diag([on_angles**2, on_rates**2] * 3 + [on_disturbances**2] * 3)
    gains = np.empty((len(A), 9, 3))
    for k in range(len(A)):
        S = P[np.ix_(ANGLES, ANGLES)] + angle_noise**2 * np.eye(3)
        L = gains[k] = np.linalg.solve(S, P[ANGLES, :]).T
        P = P - L @ P[ANGLES, :]
        P = transitions[k] @ P @ transitions[k].T + process[k]
        P = 0.5 * (P + P.T)
    return np.moveaxis(gains, 0, -1)


def settling_gains(
    x: np.ndarray,
    v: np.ndarray,
    dt: float,
    parameters: HelicopterParameters,
    noise: Noise,
    start: int,
    angle_noise: float = ENCODER_NOISE,
) -> np.ndarray:
    """Kalman gains (9, 3, J) of the first SETTLED seconds of a flight that starts at the index `start`."""
    along = slice(start, start + settling_periods(dt))
    return kalman_gains(x[:, along], v[:, along], dt, parameters, noise, angle_noise)


def settling_periods(dt: float) -> int:
    """Number of steps of dt seconds until a filter has settled."""
    return max(1, round(SETTLED / dt))


@dataclass(frozen=True, eq=False)
class Observer:
    """Kalman filter with precomputed gains (9, 3, K + 1) on the control grid, for flights from the reference's start.

    A flight that starts in a later period uses the gains settling(period) (9, 3, J) until the filter has settled.
    """

    gains: np.ndarray
    settling: Callable[[int], np.ndarray]
    control_period: float
    known: dict[int, np.ndarray] = field(default_factory=dict, init=False, repr=False)

    def __call__(
        self, x: np.ndarray, disturbance: np.ndarray, measurement: np.ndarray, now: Any, start: Any
    ) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and disturbance (3, ...), updated with the angles of the measurement (6, ...).

        x and disturbance are predictions; now and start are the present and the first control period, each also (N,).
        """
        correction = apply_gains(self.gains_at(now, start), (measurement - x)[0::2])
        return x + correction[:6], disturbance + correction[6:]

    def gains_at(self, now: Any, start: Any) -> np.ndarray:
        """Gains (9, 3), or (9, 3, N), in the control period `now` of flights that started in the period `start`."""
        settles = (start > 0) & (now - start < settling_periods(self.control_period))
        if np.ndim(now) == 0:
            return self.first_gains(start)[:, :, now - start] if settles else self.gains[:, :, now]
        gains = self.gains[:, :, now]
        for i in np.flatnonzero(settles):
            gains[:, :, i] = self.first_gains(int(start[i]))[:, :, now[i] - start[i]]
        return gains

    def first_gains(self, start: int) -> np.ndarray:
        """Gains settling(start), computed once for each start."""
        if start not in self.known:
            self.known[start] = self.settling(start)
        return self.known[start]


def disturbance_accommodated_reference(
    x: Any, v: Any, disturbance: Any, pitch_limits: tuple[float, float], parameters: HelicopterParameters
) -> tuple[np.ndarray, np.ndarray]:
    """Reference x (6, ...), v (2, ...) with pitch and thrusts that balance a disturbance (3, ...) in rad/s².

    Travel, elevation and all rates stay unchanged; see `accommodate`.
    """
    q1, dq1, q2, dq2, _, dq3 = x
    tilt, v1, v2 = accommodate(x, v, disturbance, pitch_limits, least_lift(parameters), parameters)
    target = np.stack(np.broadcast_arrays(q1, dq1, q2, dq2, tilt, dq3))
    return target, np.stack(np.broadcast_arrays(v1, v2))


def least_lift(parameters: HelicopterParameters) -> float:
    """Least lift in N for which a tilt balances disturbances."""
    return LEAST_LIFT * float(hover_input(0.0, parameters)[0])


def accommodate(
    x: Any, v: Any, disturbance: Any, pitch_limits: tuple[float, float], lift: float, parameters: HelicopterParameters
) -> tuple:
    """Pitch in rad and inputs v1, v2 in N that give the accelerations of x (6, ...), v (2, ...) despite a disturbance.

    In (3a) and (3b) the thrust is a vector v1 (sin q3, cos q3). The vector that balances the disturbances of travel and
    elevation is added to it; the sum gives tilt and v1. The thrust difference v2 holds the tilt by (3c). The tilt stays
    within the pitch limits and assumes at least `lift` in N upwards.
    """
    q1, dq1, q2, dq2, _, dq3 = x
    on_travel, on_elevation, on_pitch = disturbance
    low, high = pitch_limits
    _, ddq1, _, ddq2, _, ddq3 = dynamics(x, v, parameters, np.sin, np.cos)
    ddq2 = ddq2 - on_elevation
    across, upright = thrust_vector(x, ddq1 - on_travel, ddq2, parameters, np.sin, np.cos)
    tilt = np.minimum(np.maximum(np.arctan2(across, np.maximum(upright, lift)), low), high)
    _, v2 = inverse_dynamics((q1, dq1, q2, dq2, tilt, dq3), ddq2, ddq3 - on_pitch, parameters, np.sin, np.cos)
    return tilt, np.hypot(across, upright), v2
