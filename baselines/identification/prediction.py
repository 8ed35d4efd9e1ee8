"""Prediction error of a model on windows outside the fit, from a state estimated from past data only.

At the start of a window, an extended Kalman filter on the identified model has processed the angles so far. It also
estimates unmodelled accelerations: fading ones, with time constants of 0.3 to 0.5 s, and lasting ones. Within the
window, the voltages are known, as for the black box.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy.signal import savgol_coeffs

from heli_gym.baselines.identification.estimation import Identification
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.log_quantities import ANGLES
from heli_gym.baselines.identification.measured_model import N, dual_thrusts, filter_kernel, prediction_kernel

HORIZONS = (1.0, 3.0)  # s
BETWEEN_STARTS = 0.1  # s
HISTORY = 0.6  # s, airborne, before a window starts
POLYNOMIAL = 0.21  # s, window of the rates and accelerations of the plain predictors
MOVING = np.radians(2.0)  # rad, smallest range of an axis in the validated part for a meaningful ratio
PAST, AHEAD, STEP = 0.4, 1.0, 0.05  # s, window and averaging time of the voltages for the black box
RIDGES = 10.0 ** np.arange(-3.0, 2.1, 1.0)  # weights to choose from, relative to the number of windows
FOLDS = 5


class Settings(NamedTuple):
    """Settings of the filter, (3,) each for travel, elevation and pitch.

    All are decimal logarithms: of the process variances per second of rates, fading and lasting accelerations (in rad,
    s), and of the time constant in s of the fading ones. The defaults are the best on the fitted shares of measured
    flights.
    """

    rates: np.ndarray = np.array([-4.0, -4.0, -3.0])
    fading: np.ndarray = np.array([-2.5, -2.5, -2.0])
    times: np.ndarray = np.array([-0.3, -0.5, -0.3])
    lasting: np.ndarray = np.array([-3.5, -3.5, -3.5])


BOUNDS = Settings(rates=(-7.0, 1.0), fading=(-7.0, 1.0), times=(-1.0, 1.5), lasting=(-7.0, 0.0))  # type: ignore
STEPS = (1.0, 0.5)  # of the search for settings
GAIN, LEAST_GAIN = 0.5, 0.01  # smallest decrease of the error's logarithm for a step: s, divided by the fitted time
SHRINKAGES = np.radians([0.0, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0])  # to choose from
FLOOR = np.radians(0.1)  # rad, added to errors before their logarithm


class FilteredLog:
    """Log with the filter's estimates."""

    def __init__(self, log: FlightLog, model: Identification, settings: Settings = Settings()) -> None:
        self.log, self.model, self.settings = log, model, settings
        self.theta = model.theta.astype(complex)
        self.f = dual_thrusts(model.theta, log.voltages, log.sample_time, model.hover_voltage, np.arange(0))[0]
        dt, airborne = log.sample_time, log.airborne()
        edges = np.flatnonzero(np.diff(np.concatenate(([False], airborne, [False])).astype(int)))
        self.runs = list(zip(edges[::2].tolist(), edges[1::2].tolist()))  # airborne, from first to before last
        self.first = self.runs[0][0] if self.runs else 0
        self.decay = np.exp(-dt / 10.0**settings.times)
        q = np.zeros(N)
        q[1:6:2], q[6:9], q[9:] = 10.0**settings.rates, 10.0**settings.fading, 10.0**settings.lasting
        counts = np.array(model.start.encoder_counts)
        r = 4.0 * (2.0 * math.pi / counts) ** 2 / 12.0  # twice the standard deviation of rounding to one count
        self.z, self.innovations = np.zeros((N, len(log))), np.zeros((3, len(log)))
        rates = polynomial_ends(log)[0]
        for first, last in self.runs:
            self.z[0:6:2, first], self.z[1:6:2, first] = log.angles[:, first], rates[:, first]
            P = np.diag([1e-6, 0.05, 1e-6, 0.05, 1e-6, 0.1, 0.01, 0.01, 0.05, 0.02, 0.02, 0.1])
            filter_kernel()(
                log.angles, self.f, dt, self.theta, q, r, self.decay, self.z, self.innovations, P, first, last
            )

    def predict(self, starts: np.ndarray, n: int) -> np.ndarray:
        """Predict angles (S, 3, n + 1) in rad from the samples starts (S,) on."""
        y = np.empty((len(starts), 3, n + 1))
        prediction_kernel()(self.z, starts, self.f, self.log.sample_time, self.theta, self.decay, y)
        return y


def polynomial_ends(log: FlightLog) -> tuple[np.ndarray, np.ndarray]:
    """Causal rates and accelerations (3, K): at the end of quadratics through the last 0.2 s."""
    n = 2 * max(round(POLYNOMIAL / log.sample_time / 2.0), 1) + 1
    padded = np.concatenate((np.repeat(log.angles[:, :1], n - 1, axis=1), log.angles), axis=1)
    windows = np.lib.stride_tricks.sliding_window_view(padded, n, axis=1)
    rate, acceleration = (
        windows @ savgol_coeffs(n, 2, pos=n - 1, deriv=order, delta=log.sample_time, use="dot") for order in (1, 2)
    )
    return rate, acceleration


def horizon_starts(
    log: FlightLog, share: tuple[float, float], horizon: float, between: float = BETWEEN_STARTS
) -> np.ndarray:
    """First samples (S,) of windows of a horizon in s within a share of the log, airborne throughout."""
    n, step = round(horizon / log.sample_time), max(round(between / log.sample_time), 1)
    history, count = round(HISTORY / log.sample_time), len(log)
    on_ground = np.concatenate(([0], np.cumsum(~log.airborne())))
    first = math.ceil(share[0] * count)
    k = np.arange(first, min(count, math.floor(share[1] * count)) - n, step)
    k = k[k >= history]
    return k[on_ground[k + n + 1] == on_ground[k - history]]


def errors_at(log: FlightLog, starts: np.ndarray, n: int, predicted: np.ndarray) -> np.ndarray:
    """Errors (3, S) in rad of angles (3, S) predicted n samples ahead."""
    return log.angles[:, starts + n] - predicted


def constant_rate(log: FlightLog, starts: np.ndarray, horizon: float) -> np.ndarray:
    """Predict angles (3, S) with constant rates."""
    return log.angles[:, starts] + horizon * polynomial_ends(log)[0][:, starts]


def constant_acceleration(log: FlightLog, starts: np.ndarray, horizon: float) -> np.ndarray:
    """Predict angles (3, S) with constant accelerations."""
    rate, acceleration = polynomial_ends(log)
    return log.angles[:, starts] + horizon * rate[:, starts] + 0.5 * horizon**2 * acceleration[:, starts]


def voltage_features(log: FlightLog, starts: np.ndarray) -> np.ndarray:
    """Mean voltages (S, 56) over 50 ms each, from 0.4 s before the start to 1 s after."""
    step = max(round(STEP / log.sample_time), 1)
    integral = np.concatenate((np.zeros((2, 1)), np.cumsum(log.voltages, axis=1)), axis=1)
    offsets = np.arange(-round(PAST / log.sample_time), round(AHEAD / log.sample_time), step)
    k = np.clip(starts[:, None] + offsets, 0, len(log) - step)
    return ((integral[:, k + step] - integral[:, k]) / step).transpose(1, 0, 2).reshape(len(starts), -1)


def state_features(log: FlightLog, starts: np.ndarray) -> np.ndarray:
    """Current angles and rates (S, 5), without the travel angle, whose zero is arbitrary."""
    return np.concatenate((log.angles[1:, starts], polynomial_ends(log)[0][:, starts])).T


class Ridge:
    """Ridge regression of three targets, each with its weight from cross-validation over blocks in time.

    Args:
        X: (S, F) features, in the order of time.
        Y: (S, 3) targets.
        gap: number of windows omitted between fitted and validated blocks, since windows overlap.
    """

    def __init__(self, X: np.ndarray, Y: np.ndarray, gap: int) -> None:
        errors = np.zeros((len(RIDGES), 3))
        folds = np.arange(len(X)) * FOLDS // max(len(X), 1)
        for fold in range(FOLDS):
            judged = np.flatnonzero(folds == fold)
            if not len(judged):
                continue
            fitted = np.ones(len(X), dtype=bool)
            fitted[max(judged[0] - gap, 0) : judged[-1] + gap + 1] = False
            if fitted.sum() < 10:
                continue
            for i, weight in enumerate(RIDGES):
                guess = self.solve(X[fitted], Y[fitted], weight)(X[judged])
                errors[i] += ((Y[judged] - guess) ** 2).sum(axis=0)
        best = errors.argmin(axis=0)
        models = {i: self.solve(X, Y, RIDGES[i]) for i in set(best.tolist())}
        self.best, self.models = best, models

    @staticmethod
    def solve(X: np.ndarray, Y: np.ndarray, weight: float) -> Callable[[np.ndarray], np.ndarray]:
        """Fit the regression with one weight; return its predictor."""
        mean, spread, middle = X.mean(axis=0), X.std(axis=0) + 1e-9, Y.mean(axis=0)
        A = (X - mean) / spread
        coefficients = np.linalg.solve(A.T @ A + weight * len(X) * np.eye(A.shape[1]), A.T @ (Y - middle))
        return lambda features: (features - mean) / spread @ coefficients + middle

    def __call__(self, X: np.ndarray) -> np.ndarray:
        """Predict targets (3, S) at the features X (S, F)."""
        guesses = {i: model(X) for i, model in self.models.items()}
        return np.array([guesses[i][:, axis] for axis, i in enumerate(self.best.tolist())])


def black_box(log: FlightLog, fit_share: float, horizon: float, starts: np.ndarray) -> np.ndarray | None:
    """Predict angles (3, S) by ridge regression; None if the fitted share has too few windows.

    Features are the current angles and rates and the voltages from 0.4 s before to 1 s after; the target is the
    deviation from constant rate. Fitted on the first share of the same log.
    """
    n, between = round(horizon / log.sample_time), 0.02
    fitted = horizon_starts(log, (0.0, fit_share), horizon, between)
    if len(fitted) < 50:
        return None
    target = errors_at(log, fitted, n, constant_rate(log, fitted, horizon)).T
    both = [np.concatenate((state_features(log, k), voltage_features(log, k)), axis=1) for k in (fitted, starts)]
    return constant_rate(log, starts, horizon) + Ridge(both[0], target, round(horizon / between))(both[1])


def shrink(plain: np.ndarray, predicted: np.ndarray, size: Any) -> np.ndarray:
    """Shrink a prediction towards the plain one: half way where they differ by `size` in rad, more where by less.

    Without it, the model's error exceeds that of the plain prediction where little moves.
    """
    difference = predicted - plain
    return plain + difference**3 / (difference**2 + size**2 + 1e-18)


def shrinkage(logs: Sequence[FlightLog], model: Identification, settings: Settings, horizon: float) -> np.ndarray:
    """Best sizes (3,) in rad of `shrink` towards constant rate on the fitted shares, axis by axis."""
    parts = []
    for log in logs:
        k, n = horizon_starts(log, (0.0, model.fit_share), horizon), round(horizon / log.sample_time)
        if len(k):
            predicted = FilteredLog(log, model, settings).predict(k, n)[:, :, n].T
            parts.append((constant_rate(log, k, horizon), predicted, log.angles[:, k + n]))
    if not parts:
        return np.zeros(3)
    plain, predicted, measured = (np.concatenate(values, axis=1) for values in zip(*parts))
    losses = [np.log(np.abs(measured - shrink(plain, predicted, size)) + FLOOR).mean(axis=1) for size in SHRINKAGES]
    return SHRINKAGES[np.argmin(losses, axis=0)]


def tune(logs: Sequence[FlightLog], model: Identification, start: Settings = Settings()) -> Settings:
    """Search settings of the filter, from the defaults, that predict best at 1 s over the fitted shares.

    Settings are searched axis by axis.
    """

    def criterion(settings: Settings) -> np.ndarray:
        rows = []
        for log in logs:
            k = horizon_starts(log, (0.0, model.fit_share), 1.0)
            if len(k):
                n = round(1.0 / log.sample_time)
                error = errors_at(log, k, n, FilteredLog(log, model, settings).predict(k, n)[:, :, n].T)
                rows.append(np.log(rms(error) + 1e-4))
        return np.mean(rows, axis=0) if rows else np.zeros(3)

    fitted = sum(len(horizon_starts(log, (0.0, model.fit_share), 1.0)) for log in logs) * BETWEEN_STARTS
    gain = max(LEAST_GAIN, GAIN / max(fitted, 1.0))
    settings, best = start, criterion(start)
    for step in STEPS:
        for name in Settings._fields:
            low, high = getattr(BOUNDS, name)
            for sign in (1.0, -1.0):
                for _ in range(3):
                    values = np.clip(
                        getattr(settings, name) + sign * step * (0.5 if name == "times" else 1.0), low, high
                    )
                    found = criterion(settings._replace(**{name: values}))
                    better = found < best - gain
                    if not better.any():
                        break
                    settings = settings._replace(**{name: np.where(better, values, getattr(settings, name))})
                    best = criterion(settings)
    return settings


def rms(errors: np.ndarray) -> np.ndarray:
    """Root mean square (3,) of errors (3, S)."""
    return np.sqrt((errors**2).mean(axis=1))


@dataclass(frozen=True, eq=False)
class Validation:
    """Errors of predictors on the validation windows of one log.

    Attributes:
        name: of the log.
        moved: (3,) rad, range of the angles in the validated part.
        rms: by horizon in s and predictor, (3,) rad.
        windows: number of windows by horizon.
        whiteness: (3,) autocorrelation of the filter's innovations at one sample, 0 for white noise.
        settled: (3,) time in s after which the innovations' autocorrelation is below 0.2.
    """

    name: str
    moved: np.ndarray
    rms: dict[float, dict[str, np.ndarray]]
    windows: dict[float, int]
    whiteness: np.ndarray
    settled: np.ndarray


def validate(
    logs: Sequence[FlightLog],
    model: Identification,
    settings: Settings,
    horizons: Sequence[float] = HORIZONS,
    compare: bool = True,
) -> list[Validation]:
    """Validate the model and, for comparison, the plain predictors, on each log after the fitted share."""
    result = []
    sizes = {horizon: shrinkage(logs, model, settings, horizon)[:, None] for horizon in horizons}
    for log in logs:
        filtered = FilteredLog(log, model, settings)
        share = (model.fit_share, 1.0)
        judged = log.angles[:, math.ceil(model.fit_share * len(log)) :]
        moved = np.ptp(judged, axis=1) if judged.shape[1] else np.zeros(3)
        tables: dict[float, dict[str, np.ndarray]] = {}
        counts = {}
        for horizon in horizons:
            k, n = horizon_starts(log, share, horizon), round(horizon / log.sample_time)
            counts[horizon] = len(k)
            if not len(k):
                continue
            plain, predicted = constant_rate(log, k, horizon), filtered.predict(k, n)[:, :, n].T
            predictors = {
                "constant rate": plain,
                "constant acceleration": constant_acceleration(log, k, horizon) if compare else None,
                "black box": black_box(log, model.fit_share, horizon, k) if compare else None,
                "model": predicted,
                "model, shrunk": shrink(plain, predicted, sizes[horizon]),
            }
            tables[horizon] = {
                name: rms(errors_at(log, k, n, angles)) for name, angles in predictors.items() if angles is not None
            }
        result.append(Validation(log.name, moved, tables, counts, *whiteness(filtered)))
    return result


def whiteness(filtered: FilteredLog) -> tuple[np.ndarray, np.ndarray]:
    """Autocorrelation (3,) of the innovations at one sample, and the time (3,) in s after which it is below 0.2."""
    first, last = max(filtered.runs, key=lambda run: run[1] - run[0], default=(0, 0))
    e = filtered.innovations[:, first + round(1.0 / filtered.log.sample_time) : last]
    if e.shape[1] < 10:
        return np.full(3, np.nan), np.full(3, np.nan)
    e = e - e.mean(axis=1, keepdims=True)
    power = (e**2).mean(axis=1)
    lags = range(1, min(200, e.shape[1] - 1))
    r = np.array([(e[:, lag:] * e[:, :-lag]).mean(axis=1) / power for lag in lags])
    below = np.abs(r) < 0.2
    return r[0], (1.0 + below.argmax(axis=0)) * filtered.log.sample_time


def report(
    logs: Sequence[FlightLog], model: Identification, validations: Sequence[Validation], rig: dict[str, Any]
) -> dict[str, Any]:
    """Report of `heli-identify --json`: RMS errors in degrees over the validation windows of all logs.

    Windows of all logs have equal weight. `rms_deg` is the error of the model with `shrink` towards constant rate,
    `model_rms_deg` that of the model alone.
    """
    prediction: dict[str, Any] = {}
    for axis, name in enumerate(ANGLES):
        prediction[name] = {}
        for horizon in HORIZONS:
            table = {
                predictor: pooled(validations, horizon, predictor)[axis]
                for predictor in ("model", "constant rate", "constant acceleration", "black box", "model, shrunk")
            }
            prediction[name][f"{horizon:.1f}"] = {
                "rms_deg": table["model, shrunk"],
                "model_rms_deg": table["model"],
                "constant_rate_rms_deg": table["constant rate"],
                "constant_acceleration_rms_deg": table["constant acceleration"],
                "black_box_rms_deg": table["black box"],
            }
    errors = model.standard_errors
    return {
        "prediction": prediction,
        "plant": {
            **{name: float(value) for name, value in model.parameters._asdict().items()},
            "hover_voltage": model.hover_voltage,
            "thrust_unit": model.thrust_unit,
        },
        "standard_errors": errors,
        "correlations": {"names": list(model.free), "matrix": model.correlations.round(4).tolist()},
        "undetermined": list(model.undetermined),
        "rig": rig,
        "logs": {
            v.name: {
                "moved_deg": np.degrees(v.moved).tolist(),
                "windows": {f"{h:.1f}": count for h, count in v.windows.items()},
                "rms_deg": {
                    f"{h:.1f}": {name: np.degrees(values).tolist() for name, values in table.items()}
                    for h, table in v.rms.items()
                },
                "innovation_autocorrelation": finite(v.whiteness),
                "innovation_correlation_time": finite(v.settled),
            }
            for v in validations
        },
        "fit_share": model.fit_share,
    }


def finite(values: np.ndarray) -> list[float | None]:
    """List of the values; None for those that are not finite, which JSON does not have."""
    return [value if math.isfinite(value) else None for value in values.tolist()]


def pooled(validations: Sequence[Validation], horizon: float, predictor: str) -> list[float | None]:
    """RMS error in degrees of each axis over all windows of all logs; None without windows."""
    total, count = np.zeros(3), 0
    for v in validations:
        values = v.rms.get(horizon, {}).get(predictor)
        if values is not None:
            total += v.windows[horizon] * values**2
            count += v.windows[horizon]
    return np.degrees(np.sqrt(total / count)).tolist() if count else [None, None, None]


def verdicts(validations: Sequence[Validation]) -> list[str]:
    """Sentences, axis by axis, on the prediction 1 s ahead, over the logs in which the axis moves."""
    lines = []
    for axis, name in enumerate(ANGLES):
        moving = [v for v in validations if v.moved[axis] > MOVING and 1.0 in v.rms]
        if not moving:
            lines.append(f"{name}: moves by less than 2° in the judged part; nothing can be said")
            continue
        ratios = [v.rms[1.0]["model, shrunk"][axis] / v.rms[1.0]["constant rate"][axis] for v in moving]
        boxes = [
            v.rms[1.0]["model, shrunk"][axis] / v.rms[1.0].get("black box", np.full(3, np.inf))[axis] for v in moving
        ]
        ratio, box = float(np.median(ratios)), float(np.median(boxes))
        settled = float(np.nanmedian([v.settled[axis] for v in moving]))
        word = (
            "well predicted"
            if ratio <= (0.2, 0.4, 0.3)[axis]
            else "fairly predicted"
            if ratio < 0.7
            else "not predicted"
        )
        lines.append(
            f"{name}: {word}: {ratio:.2f} of the constant rate's error at 1 s, "
            f"{f'{box:.2f} of the black box' + chr(39) + 's' if box else 'no black box'}; innovations correlated over "
            f"{settled:.2f} s"
        )
    return lines
