"""Output errors over short windows: multiple shooting with the windows' unknowns eliminated.

A log is split into windows. Each window has a free initial state and three slow accelerations with an estimated spread;
all windows share the rig's parameters. Gauss-Newton steps with Huber's loss minimise the errors of the angles and the
distance from a prior. Model errors make the errors of neighbouring samples correlated; dividing their weight by the
correlation time avoids standard errors that are far too small.
"""

import math
from collections.abc import Callable, Sequence

import numpy as np
from scipy.stats import chi2

from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.measured_model import (
    NAMES,
    MeasuredParameters,
    dual_thrusts,
    sensitivity_kernel,
)
from heli_gym.rig import Rig

WINDOW = 2.0  # s
EVERY = 5  # samples, decimation of the errors
HUBER = 3.0  # standard deviations, above which the loss is linear
LEAST_SPREAD = 3e-4  # rad/s², of the slow accelerations
CHANCE = 0.95  # quantile above which a variance exceeds the model's by more than chance

# Spread of the prior about the start: wider than that between identified rigs.
SPREAD = MeasuredParameters(
    a1=0.3, a2=0.5, a3=0.5, b1=0.4, b2=0.4, b3=3.0, c1=0.1, c2=0.2, c3=0.2, exponent=0.2, reverse=0.3, mismatch=0.1,
    lag=0.025, delay=0.02, pitch_zero=0.15, pitch_trim=0.5, voltage_limit=20.0, centrifugal=0.3, centre=0.1,
    pitch_spin=0.3, gyro=0.8, pitch_speed=0.1,
)  # fmt: skip
LOW = MeasuredParameters(
    a1=-6.0, a2=-6.0, a3=-6.0, b1=-8.0, b2=-8.0, b3=0.05, c1=0.0, c2=0.0, c3=0.0, exponent=0.5, reverse=0.0,
    mismatch=-0.5, lag=0.005, delay=0.0, pitch_zero=-1.0, pitch_trim=-5.0, voltage_limit=1.0, centrifugal=-1.0,
    centre=-1.0, pitch_spin=-3.0, gyro=-5.0, pitch_speed=-3.0,
)  # fmt: skip
HIGH = MeasuredParameters(
    a1=6.0, a2=6.0, a3=6.0, b1=-0.005, b2=-0.005, b3=40.0, c1=3.0, c2=3.0, c3=3.0, exponent=2.0, reverse=1.5,
    mismatch=0.5, lag=0.5, delay=0.3, pitch_zero=1.0, pitch_trim=5.0, voltage_limit=1000.0, centrifugal=3.0,
    centre=1.0, pitch_spin=3.0, gyro=5.0, pitch_speed=3.0,
)  # fmt: skip


def rounding(counts: Sequence[int]) -> np.ndarray:
    """Standard deviations (3,) in rad of the rounding to encoder counts per revolution."""
    return 2.0 * math.pi / np.array(counts) / math.sqrt(12.0)


class Shooting:
    """Multiple-shooting problem: windows of logs, and their unknowns."""

    def __init__(
        self,
        logs: Sequence[FlightLog],
        share: float,
        prior_spread: MeasuredParameters = SPREAD,
        window: float = WINDOW,
        counts: Sequence[int] = Rig.encoder_counts,
    ) -> None:
        self.least_sigma = rounding(counts)  # errors are at least those of the encoders
        self.logs, self.dt, self.prior_spread = list(logs), logs[0].sample_time, np.array(prior_spread)
        self.n = round(window / self.dt)
        self.starts = [window_starts(log, share, self.n) for log in logs]
        if sum(map(len, self.starts)) < 3:
            raise ValueError(
                f"logs: {', '.join(log.name for log in logs)} must have at least three airborne windows of {window:g} "
                f"s in the first {100.0 * share:g} %"
            )
        airborne = np.concatenate([log.voltages[:, log.airborne()].ravel() for log in logs])
        self.hover_voltage = float(np.median(np.abs(airborne)))
        if self.hover_voltage < 1e-3:
            raise ValueError("logs: the voltages must not be zero while airborne")
        self.measured = [
            np.stack([log.angles[:, k : k + self.n + 1 : EVERY] for k in starts]) if len(starts) else None
            for log, starts in zip(self.logs, self.starts)
        ]
        self.reset()

    def reset(self) -> None:
        """Initialise the unknowns: states from smoothed logs, zero accelerations, first guesses of all spreads."""
        self.z = []
        for log, starts in zip(self.logs, self.starts):
            z = np.zeros((len(starts), 9))
            z[:, 0:6:2], z[:, 1:6:2] = log.angles[:, starts].T, log.rates()[:, starts].T
            self.z.append(z)
        self.sigma = np.array([0.003, 0.004, 0.008])
        self.correlation_time = np.full(3, EVERY * self.dt)
        self.spread = np.array([0.05, 0.05, 0.1])
        self.loss_value = math.inf

    def share_reversed(self) -> float:
        """Share of negative voltages in the fitted windows."""
        parts = [log.voltages[:, k : k + self.n] for log, starts in zip(self.logs, self.starts) for k in starts]
        return float(np.mean(np.concatenate(parts, axis=1) < -0.3))

    def largest_voltage(self) -> float:
        """Largest magnitude of the voltages in V in the fitted windows."""
        return max(
            float(np.abs(log.voltages[:, k : k + self.n]).max())
            for log, starts in zip(self.logs, self.starts)
            for k in starts
        )

    def weights(self) -> np.ndarray:
        """Standard deviations (3, 1) to scale the errors, increased for the correlation of neighbouring errors."""
        return (self.sigma * np.sqrt(np.maximum(self.correlation_time / (EVERY * self.dt), 1.0)))[:, None]

    def simulate(self, theta: np.ndarray, z: list[np.ndarray], chosen: np.ndarray) -> list[tuple]:
        """Simulate angles (W, 3, m) and their derivatives (W, 9 + P, 3, m), for each log with windows."""
        result = []
        for log, starts, states in zip(self.logs, self.starts, z):
            if not len(starts):
                result.append((np.zeros((0, 3, 1)), np.zeros((0, 9 + len(chosen), 3, 1))))
                continue
            f = dual_thrusts(theta, log.voltages, self.dt, self.hover_voltage, chosen)
            y = np.empty((len(starts), 3, self.n + 1))
            dy = np.empty((len(starts), 9 + len(chosen), 3, self.n + 1))
            sensitivity_kernel()(states, starts, f, self.dt, theta.astype(complex), chosen, y, dy)
            result.append((y[:, :, ::EVERY], dy[:, :, :, ::EVERY]))
        return result

    def loss(self, simulated: list[tuple], z: list[np.ndarray], step: np.ndarray) -> float:
        """Huber's loss of the errors, plus squared accelerations and squared distance from the prior."""
        total = float(step @ step)
        for (y, _), measured, states in zip(simulated, self.measured, z):
            if measured is not None:
                size = np.abs(measured - y) / self.weights()
                total += float(np.where(size < HUBER, size**2, 2.0 * HUBER * size - HUBER**2).sum())
                total += float(((states[:, 6:] / self.spread) ** 2).sum())
        return total if math.isfinite(total) else math.inf

    def normal_equations(self, simulated: list[tuple], chosen: np.ndarray) -> tuple:
        """Normal equations of the parameters, with the nine unknowns of each window eliminated (Schur complement).

        Returns matrices (W, P, P) and right-hand sides (W, P) of all windows, and for each log the factors for the step
        of its windows' unknowns.
        """
        matrices, sides = [], []
        back: list[np.ndarray | None] = []
        variance = np.zeros(3)
        for (y, dy), measured, states in zip(simulated, self.measured, self.z):
            if measured is None:
                back.append(None)
                continue
            residual = (measured - y) / self.weights()
            weight = np.sqrt(np.minimum(1.0, HUBER / np.maximum(np.abs(residual), 1e-12)))
            J = (dy / self.weights() * weight[:, None]).reshape(*dy.shape[:2], -1)
            r = (residual * weight).reshape(len(residual), -1)
            H, g = J @ J.transpose(0, 2, 1), (J @ r[:, :, None])[:, :, 0]
            own, i = np.arange(6, 9), np.arange(9)
            H[:, own, own] += 1.0 / self.spread**2
            g[:, own] -= states[:, own] / self.spread**2
            H[:, i, i] *= 1.0 + 1e-9
            solved = np.linalg.solve(H[:, :9, :9], np.concatenate((H[:, :9, 9:], g[:, :9, None]), axis=2))
            across = H[:, 9:, :9]
            matrices.append(H[:, 9:, 9:] - across @ solved[:, :, :-1])
            sides.append(g[:, 9:] - (across @ solved[:, :, -1:])[:, :, 0])
            variance += np.diagonal(np.linalg.inv(H[:, :9, :9]), axis1=1, axis2=2)[:, 6:].sum(axis=0)
            back.append(solved)
        return np.concatenate(matrices), np.concatenate(sides), back, variance / sum(map(len, self.starts))

    def fit(
        self,
        theta: np.ndarray,
        centre: np.ndarray,
        free: Sequence[str],
        iterations: int = 25,
        adapt: bool = True,
        progress: Callable[[str], None] = lambda text: None,
    ) -> np.ndarray:
        """Estimate the free parameters; return all parameters (22,).

        With `adapt`, the spreads of errors and accelerations are estimated along with them.
        """
        chosen = np.array([NAMES.index(name) for name in free])
        low, high = np.array(LOW)[chosen], np.array(HIGH)[chosen]
        prior, theta, damping, variance = self.prior_spread[chosen], theta.copy(), 1e-3, np.zeros(3)

        def distance(values: np.ndarray) -> np.ndarray:
            return (values[chosen] - centre[chosen]) / prior

        simulated = self.simulate(theta, self.z, chosen)
        for iteration in range(iterations):
            if adapt and iteration:
                self.adapt(simulated, variance)
            loss = self.loss(simulated, self.z, distance(theta))
            matrices, sides, back, variance = self.normal_equations(simulated, chosen)
            matrix = matrices.sum(axis=0) + np.diag(1.0 / prior**2)
            side = sides.sum(axis=0) - distance(theta) / prior
            scale, accepted = np.diag(matrix), False
            at_bound = ((theta[chosen] <= low) & (side < 0.0)) | ((theta[chosen] >= high) & (side > 0.0))
            moving = np.flatnonzero(~at_bound)
            for _ in range(8):
                step = np.zeros(len(chosen))
                inner = matrix + damping * np.diag(scale)
                step[moving] = np.linalg.solve(inner[np.ix_(moving, moving)], side[moving])
                new = theta.copy()
                new[chosen] = np.clip(theta[chosen] + step, low, high)
                step = new[chosen] - theta[chosen]
                z = [
                    states if solved is None else states + solved[:, :, -1] - solved[:, :, :-1] @ step
                    for states, solved in zip(self.z, back)
                ]
                trial = self.simulate(new, z, chosen)
                new_loss = self.loss(trial, z, distance(new))
                if new_loss < loss:
                    accepted = True
                    break
                damping = max(10.0 * damping, 1e-6)
            if not accepted:
                break
            theta, self.z, simulated, damping = new, z, trial, max(0.1 * damping, 1e-12)
            progress(f"iteration {iteration + 1}: loss {new_loss:.1f}")
            settled = (np.abs(step) < 0.02 * np.sqrt(1.0 / scale)).all()
            if (settled or loss - new_loss < 1e-4 * loss) and iteration >= (6 if adapt else 2):
                break
        self.loss_value = self.loss(simulated, self.z, distance(theta))
        return theta

    def covariances(self, theta: np.ndarray, centre: np.ndarray, free: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
        """Covariances (P, P) of the free parameters: by the model alone, and with what it may lack.

        Errors of the model change the parameters from window to window by more than the errors of the angles do. Where
        the jackknife exceeds the data's share of the model's variance by more than chance, it replaces this share;
        chance is that of W windows that say equally much. The prior is one more observation; where it is further from
        the estimate than its spread explains, this distance is its error. No standard error is larger than the prior's
        error, which bounds the noise of the jackknife. Correlations are the model's.
        """
        chosen = np.array([NAMES.index(name) for name in free])
        prior, distance = self.prior_spread[chosen], np.abs(theta - centre)[chosen]
        matrices, sides, *_ = self.normal_equations(self.simulate(theta, self.z, chosen), chosen)
        matrix, dof = matrices.sum(axis=0) + np.diag(1.0 / prior**2), len(sides) - 1
        covariance = np.linalg.inv(matrix)
        data, windows = np.diag(covariance) - covariance**2 @ prior**-2.0, jackknife(matrix, matrices, sides)
        data = np.where(windows > data * chi2.ppf(CHANCE, dof) / dof, windows, data)
        error = np.where(distance > prior * math.sqrt(chi2.ppf(CHANCE, 1)), distance, prior)
        variance = np.minimum(data + covariance**2 @ (error / prior**2) ** 2, error**2)
        ratio = np.sqrt(variance / np.diag(covariance))
        return covariance, covariance * np.outer(ratio, ratio)

    def adapt(self, simulated: list[tuple], variance: np.ndarray) -> None:
        """Update spread and correlation time of the errors and spread of the accelerations from current residuals."""
        parts = [m - y for (y, _), m in zip(simulated, self.measured) if m is not None]
        errors = np.concatenate(parts)
        robust = np.maximum(1.4826 * np.median(np.abs(errors), axis=(0, 2)), self.least_sigma)
        step = EVERY * self.dt
        bounded = np.clip(errors, -HUBER * robust[:, None], HUBER * robust[:, None])
        power = (bounded**2).mean(axis=(0, 2))
        # for errors with short tails, such as rounding, the median overestimates the spread
        self.sigma = np.maximum(np.minimum(robust, np.sqrt(power)), self.least_sigma)
        total = np.ones(3)
        positive = np.ones(3, dtype=bool)
        for lag in range(1, errors.shape[2] // 2):
            correlation = (bounded[:, :, lag:] * bounded[:, :, :-lag]).mean(axis=(0, 2)) / power
            positive &= correlation > 0.0  # Geyer's initial positive sequence
            total += np.where(positive, 2.0 * correlation, 0.0)
        self.correlation_time = step * total
        offsets = np.concatenate([states[:, 6:] for states in self.z])
        self.spread = np.clip(np.sqrt((offsets**2).mean(axis=0) + variance), LEAST_SPREAD, 1.0)


def jackknife(matrix: np.ndarray, matrices: np.ndarray, sides: np.ndarray) -> np.ndarray:
    """Variances (P,) of parameters from their changes when one window is left out, linearised about the estimate.

    Takes the matrix (P, P) of all normal equations, the windows' shares (W, P, P) of it and (W, P) of its right-hand
    side (Cameron, Gelbach, Miller, 2008, for clusters of errors). What these sides have in common is the prior's.
    """
    changes = np.linalg.solve(matrix - matrices, (sides - sides.mean(axis=0))[:, :, None])[:, :, 0]
    return (1.0 - 1.0 / len(sides)) * (changes**2).sum(axis=0)


def window_starts(log: FlightLog, share: float, n: int) -> np.ndarray:
    """First samples of consecutive airborne windows of n steps in the first share of a log."""
    on_ground = np.concatenate(([0], np.cumsum(~log.airborne())))
    last, k, starts = int(share * len(log)) - n - 1, 0, []
    while k <= last:
        if on_ground[k + n + 1] == on_ground[k]:
            starts.append(k)
            k += n
        else:
            k += max(n // 40, 1)
    return np.array(starts, dtype=int)
