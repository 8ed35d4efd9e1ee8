"""Quantities of a flight among the columns of a file: their names, signs and units, and their uniform time grid."""

import math
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym.baselines.identification.log_files import read_csv, read_mat
from heli_gym.storage import parse_json, parse_toml
from heli_gym.validation import is_number

ANGLES = ("travel", "elevation", "pitch")
VOLTAGES = ("u_front", "u_back")
SUM_AND_DIFFERENCE = ("u_sum", "u_difference")  # alternative names, for sum and difference of the voltages
REFERENCES = ("travel_ref", "elevation_ref", "pitch_ref")
TIME_NAMES = ("t", "time", "Time", "tout")
UNITS = {"rad": 1.0, "deg": math.pi / 180.0, "V": 1.0, "mV": 1e-3, "s": 1.0, "ms": 1e-3, "us": 1e-6}
SAMPLE_TIME = 0.01  # s, grid of logs with shorter steps
MOST_SAMPLES = 2_000_000  # of a log: 5 hours at 10 ms
LONGEST_STEP = 0.5  # s; longer ones are of another unit, or useless
LARGEST_VOLTAGE = 100.0  # V, likewise
LONGEST_GAP = 0.25  # s, longest gap to interpolate
OUTLIER = math.radians(6.0)  # of a sample from the median of five about it
FASTEST_CHANGE = 40.0  # rad/s², of an angle's rate, which moves the median


def read_quantities(
    path: Path,
    given: Mapping[str, Mapping[str, Any] | None],
    mapping: str | os.PathLike | None,
    sample_time: float | None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, dict[str, np.ndarray]]:
    """Times (K,), angles (3, K), voltages (2, K) and references of a file; arguments and errors: `FlightLog.load`.

    `given` has the tables columns, signs, units and zeros, which take precedence over those of the mapping file.
    """
    tables = read_mapping(mapping) if mapping is not None else {}
    merged = {name: {**tables.get(name, {}), **(table or {})} for name, table in given.items()}
    known = ("t", *ANGLES, *VOLTAGES, *SUM_AND_DIFFERENCE, *REFERENCES)
    for table, entries in merged.items():
        for name in entries:
            if name not in known:
                raise ValueError(f"{table}: {name!r} must be one of {', '.join(known)}")
    held = read_csv(path) if path.suffix.lower() in (".csv", ".txt") else read_mat(path)
    for name in set(known) - set(held) - set(merged["columns"]):
        same = [key for key in held if key.lower() == name]
        if len(same) == 1:
            held[name] = held.pop(same[0])
    values = {name: column(held, name, merged, path) for name in known if is_wanted(held, name, merged["columns"])}
    for name in ("t", *ANGLES):
        if name not in values:
            raise ValueError(missing_column(path, name, held))
    if all(name in values for name in SUM_AND_DIFFERENCE):
        total, difference = (values.pop(name) for name in SUM_AND_DIFFERENCE)
        values["u_front"], values["u_back"] = 0.5 * (total + difference), 0.5 * (total - difference)
    for name in VOLTAGES:
        if name not in values:
            raise ValueError(missing_column(path, name, held))
    return on_even_grid(values, sample_time, path)


def is_wanted(held: Mapping[str, np.ndarray], name: str, columns: Mapping[str, str]) -> bool:
    """Whether the file has the quantity under its own name or the mapping names a column for it."""
    return name in columns or name in held or (name == "t" and any(other in held for other in TIME_NAMES))


def missing_column(path: Path, name: str, held: Mapping[str, np.ndarray]) -> str:
    """Error message about a missing column."""
    contents = ", ".join(f"{key} {value.shape}" if value.ndim > 1 else key for key, value in held.items())
    return (
        f"{str(path)!r} has no column for {name!r}; it holds {contents or 'nothing of numbers'}. Say which is which: "
        f"columns={{{name!r}: ...}}, or a mapping file with a table [columns]"
    )


def column(
    held: Mapping[str, np.ndarray], name: str, tables: Mapping[str, Mapping[str, Any]], path: Path
) -> np.ndarray:
    """Series of a quantity in rad, V or s. Raises ValueError if it is missing or not a series of numbers."""
    key = str(tables["columns"].get(name, name))
    if name == "t" and key not in held and name not in tables["columns"]:
        key = next(other for other in TIME_NAMES if other in held)
    found = re.fullmatch(r"(.*?)(?:\[(\d+)\])?", key)
    assert found is not None
    base, index = found.groups()
    if key in held:
        value = held[key]
    elif base in held and index is not None and held[base].ndim == 2:
        table = held[base] if held[base].shape[0] <= held[base].shape[1] else held[base].T
        if int(index) >= len(table):
            raise ValueError(
                f"columns: {name} = {key!r}: {base} must have more than {index} series, it has {len(table)}"
            )
        value = table[int(index)]
    else:
        raise ValueError(missing_column(path, name, held).replace(f"for {name!r}", f"{key!r} for {name!r}"))
    if value.ndim != 1:
        raise ValueError(
            f"columns: {name} = {key!r}: must be one series, but has the shape {value.shape}; try {key}[0]"
        )
    unit = tables["units"].get(name, "s" if name == "t" else "V" if name.startswith("u_") else "rad")
    if unit not in UNITS:
        raise ValueError(f"units: {name} = {unit!r}: must be one of {', '.join(UNITS)}")
    sign, zero = tables["signs"].get(name, 1.0), tables["zeros"].get(name, 0.0)
    for label, number in (("signs", sign), ("zeros", zero)):
        if not is_number(number):
            raise ValueError(f"{label}: {name} = {number!r}: must be a finite number")
    return float(sign) * UNITS[unit] * (value - float(zero))


def read_mapping(path: str | os.PathLike) -> dict[str, dict[str, Any]]:
    """Read the tables columns, signs, units and zeros of a .toml or .json file. Raises ValueError for anything else."""
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8")
        tables = parse_json(text) if path.suffix == ".json" else parse_toml(text)
    except (ValueError, UnicodeDecodeError) as error:
        raise ValueError(f"mapping = {str(path)!r}: {error}") from error
    if not isinstance(tables, dict):
        raise ValueError(f"mapping = {str(path)!r}: must have the tables columns, signs, units, zeros")
    for name, table in tables.items():
        if name not in ("columns", "signs", "units", "zeros") or not isinstance(table, dict):
            raise ValueError(
                f"mapping = {str(path)!r}: must have the tables columns, signs, units, zeros, and no {name!r}"
            )
    return tables


def on_even_grid(values: dict[str, np.ndarray], sample_time: float | None, path: Path) -> tuple:
    """Resample times, angles, voltages and references on a uniform grid; see `FlightLog.load`."""
    lengths = {name: len(value) for name, value in values.items()}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"{str(path)!r}: the columns must be of one length, and are {lengths}")
    needed = np.array([values[name] for name in ("t", *ANGLES, *VOLTAGES)])
    good = np.isfinite(needed).all(axis=0)
    if good.sum() < 3:
        raise ValueError(f"{str(path)!r} must have at least three rows of finite numbers, and has {good.sum()}")
    values = {name: value[good] for name, value in values.items()}
    t = values["t"]
    steps = np.diff(t)
    if not (steps > 0.0).all():
        row = int(np.argmax(steps <= 0.0))
        raise ValueError(f"{str(path)!r}: time must increase; after t = {t[row]:g} s comes {t[row + 1]:g} s")
    if steps.max() > max(LONGEST_GAP, 3.0 * float(np.median(steps))):
        row = int(np.argmax(steps))
        raise ValueError(
            f"{str(path)!r}: gap of {steps[row]:g} s after t = {t[row]:g} s; must be cut into two logs there"
        )
    own = float(np.median(steps))
    for name, largest, value, other in (
        ("t", LONGEST_STEP, own, "ms"),
        *((name, math.pi, float(np.abs(values[name]).max()), "deg") for name in ANGLES[1:]),
        *((name, LARGEST_VOLTAGE, float(np.abs(values[name]).max()), "mV") for name in VOLTAGES),
    ):
        if value > largest:
            what = f"steps of {value:g} s" if name == "t" else f"values up to {value:g}"
            raise ValueError(
                f"{str(path)!r}: {name} has {what}: must be at most {largest:.3g}; units: {name} = {other!r}?"
            )
    if sample_time is None:
        sample_time = max(SAMPLE_TIME, own)
    elif not (is_number(sample_time) and 1e-4 <= sample_time <= 1.0):
        raise ValueError(f"sample_time = {sample_time!r}: must be 0.0001 to 1 s")
    if not (t[-1] - t[0]) / sample_time <= MOST_SAMPLES:
        raise ValueError(
            f"{str(path)!r}: {t[-1] - t[0]:g} s are more than {MOST_SAMPLES} samples of {sample_time:g} s; "
            "must be shorter, or in the unit that the mapping states"
        )
    grid = np.arange(math.floor((t[-1] - t[0]) / sample_time + 1e-6) + 1) * sample_time
    if len(grid) < 3:
        raise ValueError(f"{str(path)!r} must be longer than two samples of {sample_time:g} s")
    angles = np.array(
        [np.interp(grid, t - t[0], without_outliers(t, unwrapped_angle(values, name))) for name in ANGLES]
    )
    # increments of the integral of the held voltages are their means over the steps
    ends = np.append(t - t[0], t[-1] - t[0] + max(own, sample_time))
    voltages = np.empty((2, len(grid)))
    for mean, name in zip(voltages, VOLTAGES):
        integral = np.concatenate(([0.0], np.cumsum(values[name] * np.diff(ends))))
        mean[:] = np.diff(np.interp(np.append(grid, grid[-1] + sample_time), ends, integral)) / sample_time
    references = {name: np.interp(grid, t - t[0], values[name]) for name in REFERENCES if name in values}
    return grid, angles, voltages, references


def without_outliers(t: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Interpolate single samples, or two in a row, that leave the median of five by more than an angle can move."""
    if len(t) < 5:
        return angle
    middle = np.median(np.lib.stride_tricks.sliding_window_view(np.pad(angle, 2, mode="edge"), 5), axis=1)
    good = np.abs(angle - middle) <= OUTLIER + FASTEST_CHANGE * float(np.median(np.diff(t))) ** 2
    return np.interp(t, t[good], angle[good]) if good.sum() >= 2 else angle


def unwrapped_angle(values: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """Return an angle; travel is unwrapped if it jumps by a turn."""
    return np.unwrap(values[name]) if name == "travel" else values[name]
