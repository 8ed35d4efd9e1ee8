"""Identification by output errors over short windows: multiple shooting with the windows' unknowns eliminated.

A log is split into windows. Each window has a free initial state and three slow accelerations with an estimated spread;
all windows share the rig's parameters. Gauss-Newton steps with Huber's loss minimise the errors of the angles and the
distance from a prior. Model errors make the errors of neighbouring samples correlated; dividing their weight by the
correlation time avoids standard errors that are far too small.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter, savgol_filter
from scipy.stats import chi2

from heli_gym.baselines.identification.flight_log import ANGLES, FlightLog
from heli_gym.baselines.identification.measured_model import (
    NAMES,
    MeasuredParameters,
    dual_thrusts,
    sensitivity_kernel,
)
from heli_gym.model import hover_input
from heli_gym.parameters import Coupling, HelicopterParameters
from heli_gym.rig import Rig, find_rig
from heli_gym.thrust_map import PowerCurve, ThrustMap

WINDOW = 2.0  # s
MIN_WINDOW = 5.0  # s, airborne, to check signs
EVERY = 5  # samples, decimation of the errors
HUBER = 3.0  # standard deviations, above which the loss is linear
LEAST_SPREAD = 3e-4  # rad/s², of the slow accelerations
UNDETERMINED = 0.7  # share of the prior's spread above which a parameter is undetermined
CHANCE = 0.95  # quantile above which a variance exceeds the model's by more than chance
MAX_PARAMETER = 1e6

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

# Effects that (2) and (3) neglect: their parameters, with the values that switch them off.
EFFECTS: dict[str, dict[str, float]] = {
    "trim": {"mismatch": 0.0, "pitch_zero": 0.0, "pitch_trim": 0.0},
    "friction": {"c1": 0.0, "c2": 0.0, "c3": 0.0},
    "lag": {"lag": 0.005, "delay": 0.0},
    "exponent": {"exponent": 2.0},
    "amplifier": {"voltage_limit": 1000.0},
    "centrifugal": {"centrifugal": 0.0, "centre": 0.0},
    "spin": {"pitch_spin": 0.0},
    "gyro": {"gyro": 0.0},
    "airflow": {"pitch_speed": 0.0},
}
CONTRADICTION = 0.1  # least partial correlation of the wrong sign; on measured flights it is 0.14 to 0.98, rightly
STILL = 2e-3  # rad and V, range below which a signal does not move
COEFFICIENTS = ("a1", "a2", "a3", "b1", "b2", "b3")


def rounding(counts: Sequence[int]) -> np.ndarray:
    """Standard deviations (3,) in rad of the rounding to encoder counts per revolution."""
    return 2.0 * math.pi / np.array(counts) / math.sqrt(12.0)


def ablation_cases() -> dict[str, list[str]]:
    """Lists of effects by title: none, one more in each case up to all, and all but one."""
    names = list(EFFECTS)
    cases: dict[str, list[str]] = {"(2) and (3) alone": []}
    cases |= {f"+ {name}": names[: i + 1] for i, name in enumerate(names)}
    return cases | {f"all but {name}": [other for other in names if other != name] for name in names}


@dataclass(frozen=True, eq=False)
class Identification:
    """Identified rig with uncertainties.

    Attributes:
        parameters: all parameters; the unit of thrust is one rotor's at `hover_voltage`.
        hover_voltage: median voltage in V while airborne.
        free: names of the estimated parameters.
        covariance: (P, P) of the estimated parameters.
        undetermined: names of the parameters left at the prior for lack of information in the data.
        sigma: (3,) rad, robust spread of the errors of the angles within the fitted windows.
        correlation_time: (3,) s, of these errors.
        offset_spread: (3,) rad/s², of the slow accelerations from window to window.
        logs: names of the logs.
        fit_share: fitted share of each log.
        start: rig of the prior and of the scale of the thrusts.
        table_elevation: rad, from the logs, or from the start rig if they start in the air.
        voltage_range: smallest and largest voltage in V in the logs.
        sample_time: s, of the logs.
    """

    parameters: MeasuredParameters
    hover_voltage: float
    free: tuple[str, ...]
    covariance: np.ndarray
    undetermined: tuple[str, ...]
    sigma: np.ndarray
    correlation_time: np.ndarray
    offset_spread: np.ndarray
    logs: tuple[str, ...]
    fit_share: float
    start: Rig
    table_elevation: float
    voltage_range: tuple[float, float]
    sample_time: float

    @property
    def theta(self) -> np.ndarray:
        """Parameters as an array."""
        return np.array(self.parameters, dtype=float)

    @property
    def thrust_unit(self) -> float:
        """Unit of thrust in N: one rotor of the start rig in level hover."""
        return 0.5 * float(hover_input(0.0, self.start.parameters)[0])

    @property
    def standard_errors(self) -> dict[str, float]:
        """Standard errors of the free parameters, by name."""
        return dict(zip(self.free, np.sqrt(np.diag(self.covariance)).tolist()))

    @property
    def correlations(self) -> np.ndarray:
        """Correlation matrix (P, P) of the free parameters."""
        spread = np.sqrt(np.diag(self.covariance))
        return self.covariance / np.outer(spread, spread)

    def rig(self, name: str) -> Rig:
        """Convert to a Rig for `heli_gym`: (3), thrust map, amplifier, lag, delay and coupling.

        Pitch is measured from `pitch_zero`, so that travel does not accelerate at zero pitch. The pitch trim becomes a
        difference of the rotors. The scale of the thrusts is that of the start rig, since flights determine only the
        products of b1, b2, b3 with the thrust map.
        """
        p, unit = self.parameters, self.thrust_unit
        table = HelicopterParameters(
            a1=p.a1, a2=p.a2, a3=p.a3, b1=p.b1 / unit, b2=p.b2 / unit, b3=p.b3 / unit, c1=p.c1, c2=p.c2, c3=p.c3
        )  # fmt: skip
        curves = []
        for side in (1.0, -1.0):
            # half of the trim's thrust difference on each rotor, at hover
            gain = 1.0 + side * (p.mismatch + 0.5 * p.pitch_trim / p.b3)
            k = gain * unit / self.hover_voltage**p.exponent
            curves.append(PowerCurve(k, -p.reverse * k, p.exponent))
        low, high = self.start.voltage_limits
        if p.voltage_limit < MAX_PARAMETER and "voltage_limit" in self.free:
            low, high = max(min(low, self.voltage_range[0]), -p.voltage_limit), p.voltage_limit
        else:
            low, high = min(low, self.voltage_range[0]), max(high, self.voltage_range[1])
        return Rig(
            name,
            table,
            ThrustMap(*curves),
            voltage_limits=(float(low), float(high)),
            pitch_limit=self.start.pitch_limit,
            table_elevation=self.table_elevation,
            encoder_counts=self.start.encoder_counts,
            sample_time=self.sample_time,
            lag=float(p.lag),
            delay=float(p.delay),
            sensor_signs=(1, 1, 1),
            sensor_zeros=(0.0, 0.0, float(p.pitch_zero)),
            limits=None,  # type: ignore[arg-type]
            coupling=Coupling(p.centrifugal, p.centre, p.pitch_spin, p.gyro, p.pitch_speed),
            source=f"identified from {', '.join(self.logs)} (first {100.0 * self.fit_share:g} %)",
        )


def identify(
    logs: Sequence[FlightLog],
    start: Rig | str = "paper",
    fit_share: float = 0.6,
    effects: Sequence[str] = tuple(EFFECTS),
    prior: MeasuredParameters | None = None,
    progress: Callable[[str], None] = lambda text: None,
    spread: MeasuredParameters = SPREAD,
) -> Identification:
    """Estimate the parameters of a rig from logs of its flights.

    Args:
        logs: of one rig, with one sample time.
        start: rig of the scale of the thrusts, the sensors, and the undetermined quantities.
        fit_share: share of each log, from its start, to fit.
        effects: names from EFFECTS of effects beyond (2) and (3).
        prior: centre of the prior, by default the middle of identified rigs.
        progress: function that is called with lines of text.
        spread: standard deviations of the prior.

    Raises:
        ValueError: for an empty list, different sample times, a share outside (0, 1], an unknown effect, logs
            without airborne windows, or an axis or rotor with the wrong sign.
    """
    logs = list(logs)
    if not logs:
        raise ValueError("logs: must be at least one")
    if not (isinstance(fit_share, int | float) and 0.0 < fit_share <= 1.0):
        raise ValueError(f"fit_share = {fit_share!r}: must be more than 0 and at most 1")
    for effect in effects:
        if effect not in EFFECTS:
            raise ValueError(f"effects: {effect!r} must be one of {', '.join(EFFECTS)}")
    dt = logs[0].sample_time
    for log in logs:
        if abs(log.sample_time - dt) > 1e-6 * dt:
            raise ValueError(f"logs: must have one sample time, but have {dt:g} s and {log.sample_time:g} s")
    start = find_rig(start)
    problem = Shooting(logs, fit_share, spread, counts=start.encoder_counts)
    check_signs(logs)
    centre = np.array(MeasuredParameters() if prior is None else prior, dtype=float)
    free = list(COEFFICIENTS)
    for effect, neutral in EFFECTS.items():
        if effect in effects:
            free += list(neutral)
        else:
            for name, value in neutral.items():
                centre[NAMES.index(name)] = value
    if problem.share_reversed() > 0.005:
        free.append("reverse")
    theta, limited = centre.copy(), NAMES.index("voltage_limit")
    if "voltage_limit" in free:
        free.remove("voltage_limit")
        theta, limit = best_limit(problem, theta, centre, free, progress)
        if limit is not None:
            free.append("voltage_limit")
            theta[limited] = centre[limited] = limit
    theta = problem.fit(theta, centre, free, progress=progress)
    covariance, robust = problem.covariances(theta, centre, free)
    spreads = np.array([getattr(spread, name) for name in free])
    known = np.sqrt(np.diag(covariance)) < UNDETERMINED * spreads
    undetermined = [name for name, is_known in zip(free, known) if not is_known]
    if undetermined:
        progress(f"the data do not determine {', '.join(undetermined)}: they stay at the prior")
        for name in undetermined:
            theta[NAMES.index(name)] = centre[NAMES.index(name)]
        free = [name for name in free if name not in undetermined]
        if not free:
            raise ValueError("logs: must move more, for they determine no parameter")
        theta = problem.fit(theta, centre, free, progress=progress)
        _, robust = problem.covariances(theta, centre, free)
    tables = [log.table_elevation() for log in logs]
    table = float(np.median([angle for angle in tables if math.isfinite(angle)] or [start.table_elevation]))
    voltages = np.concatenate([log.voltages for log in logs], axis=1)
    return Identification(
        MeasuredParameters(*theta.tolist()),
        problem.hover_voltage,
        tuple(free),
        robust,
        tuple(undetermined),
        problem.sigma.copy(),
        problem.correlation_time.copy(),
        problem.spread.copy(),
        tuple(log.name for log in logs),
        float(fit_share),
        start,
        table,
        (float(voltages.min()), float(voltages.max())),
        dt,
    )


def check_signs(logs: Sequence[FlightLog]) -> None:
    """Raise ValueError for signals that do not move, and for signs that the logs contradict.

    Accelerations are compared with the causes that (3) gives them: pitch with the difference of the lagged voltages,
    elevation with their sum, travel with the sine of pitch; by partial correlations, so that they need not be unique.
    """
    found = []
    for log in logs:
        up = log.airborne()
        if up.sum() < MIN_WINDOW / log.sample_time:
            continue
        for name, values in (*zip(ANGLES, log.angles), ("a voltage", log.voltages)):
            if np.ptp(values[..., up], axis=-1).max() < STILL:
                raise ValueError(f"log {log.name!r}: {name} must change in flight, and is {values[..., up].max():g}")
        n = 2 * max(round(0.1 / log.sample_time), 2) + 1
        q, w = log.angles[:, up], log.rates()[:, up]
        accelerations = savgol_filter(log.angles, n, 3, deriv=2, delta=log.sample_time, axis=1)[:, up]
        keep = math.exp(-log.sample_time / MeasuredParameters().lag)
        lagged = lfilter([1.0 - keep], [1.0, -keep], log.voltages, axis=1, zi=keep * log.voltages[:, :1])[0]
        front, back = savgol_filter(lagged, n, 3, axis=1)[:, up]
        found.append((
            partial_correlation(accelerations[2], front - back, [q[2], w[2], w[0]]),
            -partial_correlation(accelerations[1], front + back, [q[1], w[1], w[0] ** 2]),
            -partial_correlation(accelerations[0], np.sin(q[2]), [w[0]]),
        ))  # fmt: skip
    if not found:
        return
    pitch, elevation, travel = np.mean(found, axis=0)
    hints = []
    if elevation < -CONTRADICTION:
        hints.append("elevation must be positive down (signs: elevation = -1) and the voltages positive forwards")
    if pitch < -CONTRADICTION and travel < -CONTRADICTION:
        hints.append("pitch must rise where u_front is the larger voltage (signs: pitch = -1)")
    elif pitch < -CONTRADICTION:
        hints.append("pitch must rise where u_front is the larger voltage (exchange u_front and u_back)")
    elif travel < -CONTRADICTION:
        hints.append("positive pitch must accelerate travel negatively (signs: travel = -1)")
    if hints:
        raise ValueError(f"logs: by these flights, a sign is wrong: {'; '.join(hints)}")


def partial_correlation(y: np.ndarray, x: np.ndarray, others: Sequence[np.ndarray]) -> float:
    """Correlation of y (K,) and x (K,) once their regressions on the others and a constant are subtracted."""
    A = np.column_stack([np.ones(len(y)), *others])
    y, x = (values - A @ np.linalg.lstsq(A, values, rcond=None)[0] for values in (y, x))
    return float(x @ y / math.sqrt((x @ x) * (y @ y) + 1e-300))


def best_limit(
    problem: "Shooting", theta: np.ndarray, centre: np.ndarray, free: list[str], progress: Callable[[str], None]
) -> tuple[np.ndarray, float | None]:
    """Parameters with the best-fitting voltage limit from a grid, including no limit; the loss has several minima."""
    index = NAMES.index("voltage_limit")
    largest = problem.largest_voltage()
    best, best_loss, best_limit = theta, math.inf, None
    for limit in (None, 0.9 * largest, 0.75 * largest, 0.62 * largest, 0.5 * largest, 0.4 * largest):
        if limit is not None and limit < 1.2 * problem.hover_voltage:
            continue
        trial, middle = theta.copy(), centre.copy()
        trial[index] = middle[index] = centre[index] if limit is None else limit
        names = free if limit is None else [*free, "voltage_limit"]
        problem.reset()
        trial = problem.fit(trial, middle, names, iterations=8, adapt=False)
        loss = problem.loss_value + (0.0 if limit is None else 10.0)  # penalty for one more parameter
        progress(f"amplifier {'without a limit' if limit is None else f'at {trial[index]:.2f} V'}: loss {loss:.0f}")
        if loss < best_loss:
            best, best_loss, best_limit = trial, loss, None if limit is None else float(trial[index])
    problem.reset()
    return best, best_limit


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
