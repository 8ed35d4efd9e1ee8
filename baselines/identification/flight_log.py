"""FlightLog: measured angles and commanded voltages on a uniform time grid."""

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from scipy.signal import savgol_filter

from heli_gym.baselines.identification.log_quantities import ANGLES, VOLTAGES, read_quantities
from heli_gym.storage import atomic_write
from heli_gym.validation import real_array, shown

LOGS = Path(__file__).parent / "logs"  # simulated
RATE_WINDOW = 0.21  # s, window of the polynomials for rates
TABLE_MARGIN = math.radians(2.0)  # rad, above the table
LEAST_TABLE = math.radians(15.0)  # rad; a log that starts higher starts in the air
FROZEN = 0.5  # s, without any change
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
        given = {"columns": columns, "signs": signs, "units": units, "zeros": zeros}
        t, angles, voltages, references = read_quantities(path, given, mapping, sample_time)
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
