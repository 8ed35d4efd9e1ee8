"""Identification of a rig from logs: which effects, which parameters are free, and what is known about them after.

The fit is that of `multiple_shooting`.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter, savgol_filter

from heli_gym.baselines.identification.flight_log import ANGLES, FlightLog
from heli_gym.baselines.identification.measured_model import NAMES, MeasuredParameters
from heli_gym.baselines.identification.multiple_shooting import SPREAD, Shooting
from heli_gym.model import hover_input
from heli_gym.parameters import Coupling, HelicopterParameters
from heli_gym.rig import Rig, find_rig
from heli_gym.thrust_map import PowerCurve, ThrustMap

MIN_WINDOW = 5.0  # s, airborne, to check signs
UNDETERMINED = 0.7  # share of the prior's spread above which a parameter is undetermined
MAX_PARAMETER = 1e6

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
