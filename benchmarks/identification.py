"""What `heli-identify` makes of measured flights: the tables of docs/identification.md.

    python benchmarks/identification.py rigs --logs FOLDER
    python benchmarks/identification.py without-rig whole drift --logs FOLDER --out out   # fits each rig once for all

Parts:
    rigs         each rig from the first 60 % of all of its logs, judged on the rest
    logs         each log alone
    without-rig  like rigs, with a prior made of the other rigs, and a search for the filter's settings from one value
    whole        fitted to the whole of each log and judged on the same rest, in-sample, and rigs again; the model alone
    ablation     effects added one by one, and all but one: degrees of the model alone
    parameters   of each rig from the first 60 % of its logs, with standard errors; b1 to b3 per N
    prior        changes of the parameters, in standard errors, when the prior's spread of `centrifugal` is halved
    drift        thrust lost in 20 s: slope of the filter's lasting acceleration of elevation, over a2
    faults       one log with faults: ratios, or the refusal

Errors are RMS at 1 s, as a share of constant rate's where no unit is given. A log is named RIG-NUMBER.csv. The prior
of without-rig has the median of the values that the other rigs' logs determine, and 1.5 times their standard deviation,
half of their range, or 0.3 of the default spread, whichever is largest; the default prior served to find those values.
"""

import argparse
import tempfile
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from scipy.io import savemat

from heli_gym.baselines.identification.estimation import Identification, ablation_cases, identify
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.log_quantities import ANGLES
from heli_gym.baselines.identification.measured_model import MeasuredParameters
from heli_gym.baselines.identification.multiple_shooting import SPREAD
from heli_gym.baselines.identification.prediction import (
    MOVING,
    FilteredLog,
    Settings,
    Validation,
    pooled,
    tune,
    validate,
)
from heli_gym.storage import atomic_write, to_csv

Row = dict[str, Any]
Rigs = dict[str, list[FlightLog]]
Columns = dict[str, np.ndarray]
HORIZON = 1.0  # s
PREDICTORS = ("model, shrunk", "model", "black box")
ONE_START = Settings(*(np.full(3, value) for value in (-4.0, -2.5, -0.3, -3.5)))
OFF = ("centrifugal", "pitch_spin", "gyro", "pitch_speed")  # 0 unless two other rigs have them
SETTLE = 3.0  # s after which the filter has forgotten its start
FAULTY = "ntnu-f-1"


def load(folder: Path, chosen: Iterable[str]) -> Rigs:
    """Logs of the folder by rig; of the chosen rigs if there are any."""
    chosen = tuple(chosen)
    rigs: Rigs = {}
    for path in sorted(folder.glob("*.csv")):
        rig = path.stem.rsplit("-", 1)[0]
        if not chosen or rig in chosen:
            rigs.setdefault(rig, []).append(FlightLog.load(path))
    if not rigs:
        raise SystemExit(f"{folder}: must hold logs named RIG-NUMBER.csv{' of ' * bool(chosen)}{', '.join(chosen)}")
    return rigs


def rows_of(rig: str, validations: Iterable[Validation]) -> Iterator[Row]:
    """Row of each log and axis: windows, RMS of constant rate in degrees, and each predictor's share of it."""
    for v in validations:
        if HORIZON in v.rms:
            plain = v.rms[HORIZON]["constant rate"]
            for i, axis in enumerate(ANGLES):
                row = {"rig": rig, "log": v.name, "axis": axis, "moves": bool(v.moved[i] > MOVING)}
                row |= {"windows": v.windows[HORIZON], "constant_rate_deg": float(np.degrees(plain[i]))}
                for name, values in v.rms[HORIZON].items():
                    if name in PREDICTORS:
                        row[name] = float(values[i] / plain[i])
                yield row


@cache
def fit(*logs: FlightLog) -> tuple[Identification, Settings]:
    """Rig and the filter's settings from the first 60 % of its logs."""
    model = identify(logs)
    return model, tune(logs, model)


def judge(rig: str, logs: list[FlightLog], model: Identification, settings: Settings) -> list[Row]:
    """Rows of a rig."""
    return list(rows_of(rig, validate(logs, model, settings, (HORIZON,))))


def summary(rows: list[Row], predictor: str, other: str = "black box") -> str:
    """Sentence for each axis over the logs in which it moves: pooled, median, and logs on which it beats another."""
    lines = []
    for axis in ANGLES:
        moving = [row for row in rows if row["axis"] == axis and row["moves"] and predictor in row]
        if moving:
            square = [row["windows"] * row["constant_rate_deg"] ** 2 for row in moving]
            share = np.array([row[predictor] for row in moving])
            wins = sum(row[predictor] < row[other] for row in moving if other in row)
            lines.append(
                f"{axis}, {predictor}: pooled {np.sqrt(np.average(share**2, weights=square)):.3f}, median "
                f"{np.median(share):.3f}; less than {other} on {wins} of {len(moving)} logs"
            )
    return "\n".join(lines)


def prior_without(rig: str, models: dict[str, Identification]) -> tuple[MeasuredParameters, MeasuredParameters]:
    """Centre and spread of a prior from the other rigs."""
    centre, spread = MeasuredParameters()._asdict(), SPREAD._asdict()
    for name in centre:
        values = [getattr(m.parameters, name) for other, m in models.items() if other != rig and name in m.free]
        if name == "voltage_limit":
            continue
        if len(values) > 1:
            centre[name] = float(np.median(values))
            spread[name] = max(1.5 * float(np.std(values)), 0.5 * float(np.ptp(values)), 0.3 * spread[name])
        elif name in OFF:
            centre[name] = 0.0
    return MeasuredParameters(**centre), MeasuredParameters(**spread)


def run_rigs(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Each rig from all of its logs."""
    for rig, logs in rigs.items():
        yield from judge(rig, logs, *fit(*logs))


def run_logs(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Each log alone."""
    for rig, logs in rigs.items():
        for log in logs:
            yield from judge(rig, [log], *fit(log))


def run_without_rig(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Each rig with a prior of the others."""
    models = {rig: fit(*logs)[0] for rig, logs in rigs.items()}
    for rig, logs in rigs.items():
        centre, spread = prior_without(rig, models)
        model = identify(logs, prior=centre, spread=spread)
        yield from judge(rig, logs, model, tune(logs, model, ONE_START))


def run_whole(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Each rig from the whole of its logs, and from its first 60 %: the model alone."""
    for rig, logs in rigs.items():
        part, whole = fit(*logs), identify(logs, fit_share=1.0)
        settings = tune(logs, whole)
        whole = replace(whole, fit_share=part[0].fit_share)
        both = (judge(rig, logs, *part), rows_of(rig, validate(logs, whole, settings, (HORIZON,), compare=False)))
        for row, other in zip(*both):
            yield row | {"whole": other["model"]}


def is_chosen(title: str, only: list[str]) -> bool:
    """Whether the title has one of the texts, or there are none."""
    return not only or any(text in title for text in only)


def run_ablation(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Errors of the model alone in degrees over all windows of each rig, by effects; chosen cases."""
    for rig, logs in rigs.items():
        for title, effects in ablation_cases().items():
            if is_chosen(title, only):
                model = identify(logs, effects=effects)
                values = pooled(validate(logs, model, tune(logs, model), (HORIZON,), compare=False), HORIZON, "model")
                yield {"rig": rig, "effects": title} | dict(zip(ANGLES, values))


def run_parameters(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Parameters of each rig with standard errors, in brackets where they are the prior's."""
    models = {rig: identify(logs) for rig, logs in rigs.items()}
    for name in MeasuredParameters._fields:
        row: Row = {"parameter": name}
        for rig, m in models.items():
            unit = m.thrust_unit if name in ("b1", "b2", "b3") else 1.0
            value, error = getattr(m.parameters, name) / unit, m.standard_errors.get(name)
            row[rig] = f"({value:.3g})" if error is None else f"{value:.3g} ± {error / unit:.1g}"
        yield row


def run_prior(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Changes of the parameters, in standard errors, when the prior's spread of `centrifugal` is halved."""
    narrow = SPREAD._replace(centrifugal=0.5 * SPREAD.centrifugal)
    for rig, logs in rigs.items():
        model, other = identify(logs), identify(logs, spread=narrow)
        change = {
            name: abs(getattr(other.parameters, name) - getattr(model.parameters, name)) / error
            for name, error in model.standard_errors.items()
            if name in other.free
        }
        worst = max(change, key=lambda name: change[name])
        rms = float(np.sqrt(np.mean(np.square(list(change.values())))))
        yield {"rig": rig, "RMS": rms, "largest": change[worst], "of": worst}


def run_drift(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Share in percent of the thrust that each log loses in 20 s."""
    for rig, logs in rigs.items():
        model, settings = fit(*logs)
        for log in logs:
            filtered = FilteredLog(log, model, settings)
            k = np.arange(filtered.first + round(SETTLE / log.sample_time), len(log))
            k = k[log.airborne()[k]]
            slope = np.polyfit(log.t[k], filtered.z[10, k], 1)[0]
            yield {"rig": rig, "log": log.name, "loss in 20 s (%)": 100.0 * 20.0 * slope / model.parameters.a2}


def even(c: Columns, dt: float) -> Columns:
    """Columns at another sample time: angles interpolated, voltages held."""
    t = np.arange(0.0, c["t"][-1], dt)
    held = np.searchsorted(c["t"], t + 1e-6, side="right") - 1
    return {n: t if n == "t" else v[held] if n.startswith("u") else np.interp(t, c["t"], v) for n, v in c.items()}


def between(c: Columns, start: float, end: float) -> Columns:
    """Columns of a part of the flight, whose time starts at 0."""
    inside = (c["t"] >= start) & (c["t"] < end)
    return {n: v[inside] - (start if n == "t" else 0.0) for n, v in c.items()}


def changed(c: Columns, where: Any, **values: Any) -> Columns:
    """Columns with values at some samples; functions are called with the column."""
    c = {n: v.copy() for n, v in c.items()}
    for n, value in values.items():
        c[n][where] = value(c[n][where]) if callable(value) else value
    return c


def frozen(c: Columns) -> Columns:
    """Columns that end with 5 s in which nothing changes."""
    c = {n: np.concatenate((v, np.full(500, v[-1]))) for n, v in c.items()}
    return c | {"t": 0.01 * np.arange(len(c["t"]))}


def faulty(c: Columns) -> dict[str, Columns]:
    """Faulty versions of the columns of a log, by name."""
    rng, n = np.random.default_rng(0), len(c["t"])
    some, jitter = rng.integers(0, n, 40), rng.uniform(-0.003, 0.003, n)
    piece, everywhere = slice(n // 2, n // 2 + 300), slice(None)
    still = {name: v[piece.start] for name, v in c.items() if name != "t"}
    cases = {"as it is": c}
    cases |= {f"sampled at {1000.0 * dt:g} ms": even(c, dt) for dt in (0.001, 0.02, 0.04, 0.1)}
    cases |= {f"{start} to {end} s": between(c, start, end) for start, end in ((0, 20), (0, 12), (0, 8), (10, 30))}
    cases |= {f"{0.01 * k:g} s lost": {m: np.delete(v, slice(1500, 1500 + k)) for m, v in c.items()} for k in (20, 100)}
    return cases | {
        "rows of NaN": changed(c, [100, 1700, 1701], pitch=np.nan),
        "jittered times": changed(c, everywhere, t=lambda t: t + jitter),
        "times from 1970 on": changed(c, everywhere, t=lambda t: t + 1.7e9),
        "40 outliers": changed(c, some, pitch=lambda v: v + rng.normal(0.0, 1.0, 40), travel=lambda v: v + 3.0),
        "40 spikes of the voltages": changed(c, some, u_front=24.0, u_back=-24.0),
        "frozen for 3 s": changed(c, piece, **still),
        "frozen for 5 s at the end": frozen(c),
        "voltages times 4.4": changed(c, everywhere, u_front=lambda u: 4.4 * u, u_back=lambda u: 4.4 * u),
        "pitch constant": changed(c, everywhere, pitch=0.0),
        "voltages constant": changed(c, everywhere, u_front=3.0, u_back=3.0),
        "travel reversed": changed(c, everywhere, travel=np.negative),
        "elevation reversed": changed(c, everywhere, elevation=np.negative),
        "pitch reversed": changed(c, everywhere, pitch=np.negative),
        "rotors exchanged": changed(c, everywhere, u_front=c["u_back"], u_back=c["u_front"]),
        "degrees as radians": changed(c, everywhere, **dict.fromkeys(ANGLES, np.degrees)),
        "other names": {f"{name}_measured": v for name, v in c.items()},
    }


def write_csv(path: Path, c: Columns) -> Path:
    """Write columns with a line of names; return the path."""
    np.savetxt(path, np.array(list(c.values())).T, fmt="%.15g", delimiter=",", header=",".join(c), comments="")
    return path


def mat_logs(folder: Path, c: Columns) -> Iterator[tuple[str, list[FlightLog]]]:
    """The log as .mat files of MATLAB 5 and 7.3, by form."""
    signals = np.array([{"values": v, "label": n} for n, v in c.items()], dtype=object)
    forms: dict[str, tuple[dict[str, Any], dict[str, str] | None]] = {
        "series": (c, None),
        "matrix": ({"ans": np.array(list(c.values()))}, {n: f"ans[{i}]" for i, n in enumerate(c)}),
        "scope": ({"scope": {"signals": signals}}, {n: f"scope.signals[{i}].values" for i, n in enumerate(c)}),
    }
    for name, (held, columns) in forms.items():
        path = folder / f"{name}.mat"
        savemat(path, held)
        yield f".mat, MATLAB 5, {name}", [FlightLog.load(path, columns)]
    with h5py.File(folder / "new.mat", "w", userblock_size=512) as file:
        for name, values in c.items():
            file[name] = values[None]
    yield ".mat, MATLAB 7.3", [FlightLog.load(folder / "new.mat")]


def run_faults(rigs: Rigs, only: list[str]) -> Iterator[Row]:
    """Faulty versions of a log: shares of constant rate's error, or the refusal; chosen ones."""
    log = next(log for logs in rigs.values() for log in logs if log.name == FAULTY)
    arrays = (log.t, *log.angles, *log.voltages)
    c = dict(zip(("t", *ANGLES, "u_front", "u_back"), arrays))

    def row(title: str, read: Callable[[], list[FlightLog]], fit_share: float = 0.6) -> Row:
        try:
            logs = read()
            model = identify(logs, fit_share=fit_share)
            found = judge(title, logs, model, tune(logs, model))
            return {"fault": title} | {one["axis"]: one["model, shrunk"] for one in found[:3]} | {"refused": ""}
        except ValueError as error:
            why = " ".join(str(error).replace(f"{folder}/", "").split())
            return {"fault": title} | dict.fromkeys(ANGLES) | {"refused": why}

    def load_columns(c: Columns) -> FlightLog:
        return FlightLog.load(write_csv(folder / "log.csv", c))

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for title, columns in faulty(c).items():
            if is_chosen(title, only):
                yield row(title, partial(lambda c: [load_columns(c)], columns))
        for share in (0.3, 0.5, 0.9):
            if is_chosen(title := f"fitted share {share}", only):
                yield row(title, lambda: [log], share)
        if is_chosen(title := "two sample times", only):
            yield row(title, lambda: [log, load_columns(even(c, 0.02))])
        for title, logs in mat_logs(folder, c):
            if is_chosen(title, only):
                yield row(title, partial(list, logs))


PARTS = {
    "rigs": run_rigs,
    "logs": run_logs,
    "without-rig": run_without_rig,
    "whole": run_whole,
    "ablation": run_ablation,
    "parameters": run_parameters,
    "prior": run_prior,
    "drift": run_drift,
    "faults": run_faults,
}


def cell(value: Any) -> str:
    """Value as a cell of a table."""
    return "" if value is None else f"{value:.2f}" if isinstance(value, float) else str(value)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="+", choices=PARTS)
    parser.add_argument("--logs", type=Path, required=True, help="folder of the logs")
    parser.add_argument("--rigs", nargs="*", default=(), help="rigs to do, by default all")
    parser.add_argument("--only", nargs="*", default=(), help="parts of the titles to do, of ablation and faults")
    parser.add_argument("--out", type=Path, help="folder for PART.csv with the rows")
    args = parser.parse_args()
    rigs = load(args.logs, args.rigs)
    for part in args.parts:
        rows: list[Row] = []
        for row in PARTS[part](rigs, args.only):
            rows.append(row)
            if args.out:
                with atomic_write(args.out / f"{part}.csv") as file:
                    file.write(to_csv(rows))
            if len(rows) == 1:
                print(f"\n{part}\n\n| {' | '.join(row)} |\n{'|---' * len(row)}|")
            print(f"| {' | '.join(map(cell, row.values()))} |", flush=True)
        if rows and "model" in rows[0]:
            print()
            print("\n".join(filter(None, (summary(rows, name) for name in (*PREDICTORS, "whole")))), flush=True)


if __name__ == "__main__":
    main()
