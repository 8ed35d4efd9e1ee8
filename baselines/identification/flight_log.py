"""FlightLog: measured angles and commanded voltages on a uniform time grid, from CSV and MATLAB files."""

import math
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import loadmat
from scipy.signal import savgol_filter

from heli_gym.storage import atomic_write, parse_json, parse_toml
from heli_gym.validation import is_number as is_finite
from heli_gym.validation import real_array, shown

ANGLES = ("travel", "elevation", "pitch")
VOLTAGES = ("u_front", "u_back")
SUM_AND_DIFFERENCE = ("u_sum", "u_difference")  # alternative names, for sum and difference of the voltages
REFERENCES = ("travel_ref", "elevation_ref", "pitch_ref")
TIME_NAMES = ("t", "time", "Time", "tout")
UNITS = {"rad": 1.0, "deg": math.pi / 180.0, "V": 1.0, "mV": 1e-3, "s": 1.0, "ms": 1e-3, "us": 1e-6}
LOGS = Path(__file__).parent / "logs"  # simulated
SAMPLE_TIME = 0.01  # s, grid of logs with shorter steps
MOST_NUMBERS = 2**25  # of a matrix in a file
MOST_SAMPLES = 2_000_000  # of a log: 5 hours at 10 ms
LONGEST_STEP = 0.5  # s; longer ones are of another unit, or useless
LARGEST_VOLTAGE = 100.0  # V, likewise
LONGEST_GAP = 0.25  # s, longest gap to interpolate
RATE_WINDOW = 0.21  # s, window of the polynomials for rates
TABLE_MARGIN = math.radians(2.0)  # rad, above the table
LEAST_TABLE = math.radians(15.0)  # rad; a log that starts higher starts in the air
FROZEN = 0.5  # s, without any change
OUTLIER = math.radians(6.0)  # of a sample from the median of five about it
FASTEST_CHANGE = 40.0  # rad/s², of an angle's rate, which moves the median
SETTLING = 0.5  # s after leaving the table, without validity of (3)


@dataclass(frozen=True, eq=False)
class FlightLog:
    """Measured flight on a uniform time grid.

    Args:
        t: (K,) times in s, from 0.
        angles: (3, K) measured travel, elevation (positive down) and pitch in rad.
        voltages: (2, K) commanded front and back voltages in V, held from each time to the next.
        references: logged references in rad, (K,) each, by the names `travel_ref`, `elevation_ref`, `pitch_ref`.
        name: of the log.

    Raises:
        ValueError: if a shape is wrong, a value is not finite, or the times are not uniform.
    """

    t: np.ndarray
    angles: np.ndarray
    voltages: np.ndarray
    references: Mapping[str, np.ndarray] = field(default_factory=dict)
    name: str = "log"

    def __post_init__(self) -> None:
        for name in ("t", "angles", "voltages"):
            value = real_array(getattr(self, name))
            if value is None:
                raise ValueError(f"{name} = {shown(getattr(self, name))}: must be an array of real numbers")
            value.setflags(write=False)
            object.__setattr__(self, name, value)
        n = len(self.t) if self.t.ndim == 1 else 0
        for name, shape in (("t", (n,)), ("angles", (3, n)), ("voltages", (2, n))):
            value = getattr(self, name)
            if value.shape != shape or n < 3:
                raise ValueError(
                    f"{name} has shape {value.shape}; the shapes must be t (K,), angles (3, K), voltages (2, K) with "
                    "K >= 3"
                )
            if not np.isfinite(value).all():
                raise ValueError(f"{name} must be finite")
        steps = np.diff(self.t)
        if self.t[0] != 0.0 or not (steps.min() > 0.0 and np.ptp(steps) < 1e-6 * self.t[-1]):
            raise ValueError("t must increase from 0 in even steps")

    @property
    def sample_time(self) -> float:
        """Step of the time grid in s."""
        return float(self.t[-1] / (len(self.t) - 1))

    @property
    def duration(self) -> float:
        """Time of the last sample in s."""
        return float(self.t[-1])

    def __len__(self) -> int:
        return len(self.t)

    def part(self, start: float, end: float) -> "FlightLog":
        """Part of the log from `start` to `end` in s, with its time from 0."""
        first, last = np.searchsorted(self.t, (start - 1e-9, end + 1e-9))
        return FlightLog(
            self.t[first:last] - self.t[first],
            self.angles[:, first:last],
            self.voltages[:, first:last],
            {name: values[first:last] for name, values in self.references.items()},
            self.name,
        )

    def rates(self, window: float = RATE_WINDOW) -> np.ndarray:
        """Non-causal rates (3, K) in rad/s by local cubic polynomials (Savitzky-Golay) over the window in s."""
        n = 2 * max(round(window / self.sample_time / 2.0), 2) + 1
        if len(self) < n:
            return np.gradient(self.angles, self.sample_time, axis=1)
        return savgol_filter(self.angles, n, 3, deriv=1, delta=self.sample_time, axis=1)

    def table_elevation(self) -> float:
        """Elevation in rad of the table if the log starts on it; infinity if it starts in the air."""
        start = float(np.median(self.angles[1, : max(round(0.1 / self.sample_time), 1)]))
        return start if start > LEAST_TABLE else math.inf

    def airborne(self) -> np.ndarray:
        """Mask (K,) of the samples that have been above the table, and not frozen, for at least SETTLING."""
        up = np.asarray(self.angles[1] < self.table_elevation() - TABLE_MARGIN) & ~self.frozen()
        if up.all():
            return up
        n = round(SETTLING / self.sample_time)
        contacts = np.concatenate((np.full(1, True), ~up)).cumsum()[1:]
        before = np.concatenate((np.full(min(n, len(up)), -1), contacts[: max(len(up) - n, 0)]))
        return up & (contacts == before)

    def frozen(self) -> np.ndarray:
        """Mask (K,) of the samples in pieces of FROZEN or longer in which nothing changes: no flight is so still."""
        changes = np.abs(np.diff(np.vstack((self.angles, self.voltages))))
        same = np.append((changes < 1e-9).all(axis=0), False)
        edges = np.flatnonzero(np.diff(np.concatenate(([False], same, [False])).astype(int)))
        mask = np.zeros(len(self), dtype=bool)
        for first, last in zip(edges[::2], edges[1::2]):
            if last - first >= FROZEN / self.sample_time:
                mask[first : last + 1] = True
        return mask

    def saturated(self, limits: tuple[float, float] = (-24.0, 24.0)) -> np.ndarray:
        """Mask (K,) of the samples with a voltage at or beyond the amplifier's limits in V."""
        low, high = limits
        return np.any((self.voltages <= low + 1e-6) | (self.voltages >= high - 1e-6), axis=0)

    def save(self, path: str | os.PathLike) -> None:
        """Write a .csv file that `load` reads back, atomically."""
        path = Path(path)
        if path.suffix != ".csv":
            raise ValueError(f"path = {str(path)!r}: must end in .csv")
        columns = {"t": self.t, **dict(zip(ANGLES, self.angles)), **dict(zip(VOLTAGES, self.voltages))}
        columns.update(self.references)
        with atomic_write(path) as file:
            np.savetxt(
                file, np.array(list(columns.values())).T, "%.6g", delimiter=",", header=",".join(columns), comments=""
            )

    @classmethod
    def load(
        cls,
        path: str | os.PathLike,
        columns: Mapping[str, str] | None = None,
        signs: Mapping[str, float] | None = None,
        units: Mapping[str, str] | None = None,
        zeros: Mapping[str, float] | None = None,
        mapping: str | os.PathLike | None = None,
        sample_time: float | None = None,
    ) -> "FlightLog":
        """Read a flight from a .csv or a .mat file (MATLAB 5 to 7.3).

        The quantities are t, travel, elevation, pitch, u_front, u_back (or u_sum and u_difference), and optionally
        travel_ref, elevation_ref, pitch_ref. A value v in the file is read as sign * (v - zero) * unit.

        The log is resampled on a uniform grid. Its step is `sample_time`; by default 10 ms, or the log's own step if
        that is longer. Angles are interpolated linearly; held voltages are averaged over each step. Rows with values
        that are not finite are omitted, and angles that no rig can reach within a sample; travel is unwrapped.

        Args:
            path: of the file.
            columns: names in the file by quantity. In a .mat file `a.b` is a field, `a[2]` a row or column of a
                matrix, counted from 0.
            signs: -1 for quantities measured in the opposite direction, by quantity.
            units: of the columns: `deg` or `rad`, `V` or `mV`, `s`, `ms` or `us`.
            zeros: values in the file, in its units, at which the quantity is 0.
            mapping: .toml or .json file with the tables columns, signs, units, zeros; arguments take precedence.
            sample_time: in s.

        Raises:
            ValueError: if the file is damaged, has another format, or lacks a column, and the message lists its
                contents; or if values or steps are beyond any rig's, as with another unit.
        """
        path = Path(path)
        tables = read_mapping(mapping) if mapping is not None else {}
        given = {"columns": columns, "signs": signs, "units": units, "zeros": zeros}
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
        t, angles, voltages, references = on_even_grid(values, sample_time, path)
        try:
            return cls(t, angles, voltages, references, path.stem)
        except ValueError as error:
            raise ValueError(f"{str(path)!r}: {error}") from error


def find_log(path: str | os.PathLike, **arguments: Any) -> FlightLog:
    """Load a log by its path, or one of the package by its name; the arguments are those of `FlightLog.load`."""
    path = Path(path)
    packaged = LOGS / f"{path}.csv"
    is_name = path.name == str(path) and not path.suffix and not path.exists()
    if is_name and not packaged.is_file():
        names = ", ".join(repr(known.stem) for known in sorted(LOGS.glob("*.csv")))
        raise ValueError(f"log = {str(path)!r}: must be the path of a .csv or .mat file, or one of {names}")
    return FlightLog.load(packaged if is_name else path, **arguments)


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
        if not is_finite(number):
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


def read_csv(path: Path) -> dict[str, np.ndarray]:
    """Read the columns, by name, of a text file with a header; separated by commas, semicolons, tabs or blanks."""
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError as error:
        raise ValueError(f"{str(path)!r} must be a text file: {error}") from error
    lines = [line for line in lines if line.strip() and not line.lstrip().startswith(("#", "%"))]
    if len(lines) < 4:
        raise ValueError(f"{str(path)!r} must have a line of names and at least three rows of numbers")
    separator = max((",", ";", "\t"), key=lines[0].count)
    separator_or_blanks = separator if separator in lines[0] else None
    names = [name.strip().strip("\"'") for name in lines[0].split(separator_or_blanks)]
    if all(is_number(name) for name in names):
        names = [f"column[{i}]" for i in range(len(names))]
    else:
        lines = lines[1:]
    if separator_or_blanks != ",":
        lines = [line.replace(",", ".") for line in lines]  # decimal commas
    rows = np.empty((len(lines), len(names)))
    for i, line in enumerate(lines):
        cells = line.split(separator_or_blanks)
        if len(cells) != len(names):
            raise ValueError(
                f"{str(path)!r}, row {i + 1}: must have {len(names)} cells, and has {len(cells)}: {line[:60]!r}"
            )
        for j, cell in enumerate(cells):
            try:
                rows[i, j] = float(cell) if cell.strip() else math.nan
            except ValueError:
                raise ValueError(
                    f"{str(path)!r}, row {i + 1}, column {names[j]!r}: must be a number, not {cell.strip()[:40]!r}"
                ) from None
    return {name: rows[:, j] for j, name in enumerate(names)}


def is_number(text: str) -> bool:
    """Whether the text is a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def read_mat(path: Path) -> dict[str, np.ndarray]:
    """Read all series and matrices of numbers in a MATLAB file, by name; fields of structs by dotted names."""
    with open(path, "rb") as file:
        head = file.read(8)
    if head == b"\x89HDF\r\n\x1a\n" or path_is_hdf5(path):
        return read_hdf5(path)
    try:
        contents = loadmat(path, simplify_cells=True)
    except Exception as error:  # scipy raises exceptions of any type for damaged files
        raise ValueError(f"{str(path)!r} must be a .csv or a .mat file: {error}") from error
    found: dict[str, np.ndarray] = {}
    for name, value in contents.items():
        if not name.startswith("__"):
            flatten(name, value, found)
    return found


def flatten(name: str, value: Any, found: dict[str, np.ndarray]) -> None:
    """Add the series and matrices of numbers in a value of a MATLAB file to `found`, under dotted names."""
    if isinstance(value, dict):
        for key, item in value.items():
            flatten(f"{name}.{key}", item, found)
    elif isinstance(value, Sequence | np.ndarray) and not isinstance(value, str):
        array = np.asarray(value)
        if array.dtype == object or array.dtype.kind not in "biuf":
            for i, item in enumerate(array.ravel()):
                if isinstance(item, dict):
                    flatten(f"{name}[{i}]", item, found)
        elif array.size > 2:
            array = array.squeeze()
            if array.ndim in (1, 2):
                found[name] = array.astype(float)


def path_is_hdf5(path: Path) -> bool:
    """Whether the file is a MATLAB 7.3 file: HDF5 after a header of 512 bytes."""
    with open(path, "rb") as file:
        file.seek(512)
        return file.read(8) == b"\x89HDF\r\n\x1a\n"


def read_hdf5(path: Path) -> dict[str, np.ndarray]:
    """Read all series and matrices of numbers in a MATLAB 7.3 file, whose matrices are stored transposed."""
    try:
        import h5py
    except ImportError as error:
        raise ImportError(f"{str(path)!r} is a MATLAB 7.3 file: pip install 'heli-gym[eval]' (h5py)") from error
    found: dict[str, np.ndarray] = {}

    def visit(name: str, item: Any) -> None:
        if isinstance(item, h5py.Dataset) and item.dtype.kind in "biuf" and not name.startswith("#"):
            if item.size > MOST_NUMBERS:
                raise ValueError(f"{str(path)!r}: {name} has {item.size} numbers; must be at most {MOST_NUMBERS}")
            flatten(name.replace("/", "."), item[()].T, found)

    try:
        with h5py.File(path, "r") as file:
            file.visititems(visit)
    except (OSError, RuntimeError) as error:
        raise ValueError(f"{str(path)!r} must be a MATLAB 7.3 file: {error}") from error
    return found


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
    elif not (is_finite(sample_time) and 1e-4 <= sample_time <= 1.0):
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
