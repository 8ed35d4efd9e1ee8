"""Maneuver (a transition to plan) and Trajectory (a plan or a flight)."""

import functools
import math
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from heli_gym.model import hover_input
from heli_gym.notebook import plot_trajectory
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.rig import PAPER, UNNAMED, Rig, check_same_rig, find_rig, rig_of
from heli_gym.storage import atomic_write, read_arrays
from heli_gym.validation import as_path, is_number, real_array, shown

LARGEST_GAP = 1e-9  # rad and rad/s, between the end of a trajectory and the start of the next


@dataclass(frozen=True)
class Maneuver:
    """Transition between two set-points at rest with zero pitch, (5). The defaults are the paper's (8), (9).

    Args:
        start: travel and elevation in rad at the start.
        goal: travel and elevation in rad at the end; None as the elevation leaves it free.
        duration: transition time T in s.
        limits: limits (6), (7) of the plan's voltages and pitch; the rig's by default, which are (9) for the paper's.
        parameters: coefficients of (3), the rig's by default; without a rig, of (2) and (3).
        rig: the rig that flies, or its name or file; "paper" by default.
        floor: travel (N,), increasing, and elevation (N,) in rad of a polyline, level beyond its ends. The helicopter
            stays on or above it: q2 is at most the line's elevation, since elevation is positive down. None on rigs
            whose elevation is positive upwards (b2 > 0).
        start_state: state (6,) instead of start, if not at rest.
        goal_state: state (6,) instead of goal, if not at rest.
        via: points passed in motion, in order: (time, travel, elevation) in s and rad. Without a time (None), the
            elevation is that at this travel, whenever it is passed; without an elevation, the travel is that at this
            time.
        periodic: whether the flight repeats itself: it starts in motion, in the state in which it ends but for the
            travel, which may advance. The elevation at the start and at the goal must be equal.
        elevation_free: whether the elevation at the goal is free; set by a goal without an elevation.
        lead: whether the plan's voltages lead, so that they arrive open loop on rotors with the rig's nominal lag and
            dead time. The limits apply to these commands; the flight begins after the dead time.

    Raises:
        ValueError: if a value is not finite, the duration is not positive, hover at the start or at the goal exceeds
            the voltage limits, via points are not in order, or parameters and rig contradict each other.
    """

    start: tuple[float, float] = (0.0, 0.0)
    goal: tuple[float, float] = (2.0 * math.pi, 0.0)
    duration: float = 10.0
    limits: Limits = None  # type: ignore[assignment]
    parameters: HelicopterParameters = None  # type: ignore[assignment]
    rig: Rig = None  # type: ignore[assignment]
    floor: tuple[tuple[float, ...], tuple[float, ...]] | None = None
    start_state: tuple[float, ...] | None = None
    goal_state: tuple[float, ...] | None = None
    via: tuple[tuple[float | None, float, float | None], ...] = ()
    periodic: bool = False
    elevation_free: bool = False
    lead: bool = False

    def __post_init__(self) -> None:
        for end in ("start", "goal"):
            state = getattr(self, f"{end}_state")
            if state is not None:
                x = real_array(state)
                if x is None or x.shape != (6,) or not np.isfinite(x).all() or not abs(x[4]) < math.pi / 2:
                    raise ValueError(
                        f"{end}_state = {shown(state)}: must be a finite state (6,) with a pitch below 90 deg"
                    )
                object.__setattr__(self, f"{end}_state", tuple(x.tolist()))
                object.__setattr__(self, end, (float(x[0]), float(x[2])))
        if isinstance(self.goal, tuple | list) and len(self.goal) == 2 and self.goal[1] is None:
            object.__setattr__(self, "goal", (self.goal[0], self.start[1]))
            object.__setattr__(self, "elevation_free", True)
        if self.floor is not None:
            object.__setattr__(self, "floor", validate_floor(self.floor))
        if not isinstance(self.limits, Limits | None):
            raise ValueError(f"limits = {shown(self.limits)}: must be a Limits")
        rig = None if self.rig is None else find_rig(self.rig)
        if rig is None or self.parameters not in (None, rig.parameters):
            if rig is not None and rig.name not in (PAPER.name, UNNAMED):
                raise ValueError(f"parameters = {self.parameters}: must be those of the rig {rig.name!r}, or no others")
            parameters = PAPER.parameters if self.parameters is None else self.parameters
            rig = rig_of(parameters, self.limits or Limits())
        object.__setattr__(self, "rig", rig)
        object.__setattr__(self, "parameters", rig.parameters)
        object.__setattr__(self, "limits", self.limits or rig.limits)
        if self.floor is not None and rig.parameters.b2 > 0.0:
            raise ValueError(
                f"floor = {shown(self.floor)}: must be None for the rig {rig.name!r}, whose elevation is positive "
                f"upwards (b2 = {rig.parameters.b2:g})"
            )
        low, high = rig.voltage_limits
        if not low <= self.limits.u_min < self.limits.u_max <= high:
            raise ValueError(
                f"limits = {self.limits}: must be within the {low:g} to {high:g} V of the rig {rig.name!r}'s amplifiers"
            )
        if max(self.limits.pitch_max, -self.limits.pitch_min) > rig.pitch_limit:
            raise ValueError(
                f"limits = {self.limits}: must be within the pitch limit of the rig {rig.name!r}, "
                f"{math.degrees(rig.pitch_limit):g} deg"
            )
        if not (is_number(self.duration) and self.duration > 0.0):
            raise ValueError(f"duration = {shown(self.duration)}: must be a positive, finite number of seconds")
        low, high = rig.thrust_bounds(self.limits.u)
        for name in ("start", "goal"):
            point = real_array(getattr(self, name))
            if point is None or point.shape != (2,) or not np.isfinite(point).all():
                raise ValueError(f"{name} = {shown(getattr(self, name))}: must be finite (travel, elevation) in rad")
            object.__setattr__(self, name, (float(point[0]), float(point[1])))
            elevation = float(point[1])
            thrust_sum = hover_thrust_sum(elevation, self.parameters)
            if abs(elevation) >= math.pi / 2 or not low < 0.5 * thrust_sum < high:
                front, back = rig.hover_voltage(elevation)
                volts = f"{front:.2f} V on each motor" if front == back else f"{front:.2f} and {back:.2f} V"
                given = name if getattr(self, f"{name}_state") is None else f"{name}_state"
                raise ValueError(
                    f"{given} = {getattr(self, given)!r}: hover at elevation {math.degrees(elevation):.2f} deg takes "
                    f"{volts}, and the limits are {self.limits.u_min:g} to {self.limits.u_max:g} V"
                )

        object.__setattr__(self, "via", validate_via(self.via, self.duration))
        if not isinstance(self.periodic, bool):
            raise ValueError(f"periodic = {shown(self.periodic)}: must be True or False")
        if self.periodic and (self.start_state, self.goal_state, self.elevation_free) != (None, None, False):
            raise ValueError("periodic = True: must go with start and goal, not with states or a free elevation")
        if self.periodic and self.start[1] != self.goal[1]:
            raise ValueError(f"goal = {self.goal!r}: must have the elevation of the start, {self.start[1]:g} rad")
        if self.lead and (self.start_state is not None or self.periodic or self.limits.slew is not None):
            raise ValueError("lead = True: must go with a start at rest, and without a slew limit")
        if self.elevation_free and self.goal_state is not None:
            raise ValueError("elevation_free = True: must go with goal, not with goal_state")

    @property
    def ends(self) -> np.ndarray:
        """States (2, 6) at the start and at the goal."""
        points = (self.start, self.start_state), (self.goal, self.goal_state)
        return np.array([[travel, 0.0, lift, 0.0, 0.0, 0.0] if x is None else x for (travel, lift), x in points])

    @property
    def is_from_rest_to_rest(self) -> bool:
        """Whether it is a transition between two set-points, without via points and leading voltages."""
        is_moving = self.start_state is not None or self.goal_state is not None or self.periodic
        return not (is_moving or self.elevation_free or self.via or self.lead)

    def __str__(self) -> str:
        (travel, elevation), (new_travel, new_elevation) = np.degrees(self.start), np.degrees(self.goal)
        lift = "any" if self.elevation_free else f"{new_elevation:g} deg"
        more = f" via {len(self.via)} point{'s' if len(self.via) > 1 else ''}" if self.via else ""
        return (
            f"travel {travel:g} to {new_travel:g} deg, elevation {elevation:g} to {lift}{more}"
            f"{', periodic,' if self.periodic else ''}{', leading,' if self.lead else ''} in {self.duration:g} s "
            f"within {self.limits}"
        )


@functools.lru_cache(maxsize=1024)
def hover_thrust_sum(elevation: float, parameters: HelicopterParameters) -> float:
    """Sum of the thrusts in N in hover at an elevation in rad."""
    return float(hover_input(elevation, parameters)[0])


def validate_floor(floor: Any) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the floor as tuples of floats. Raises ValueError unless its travel increases."""
    nothing = np.zeros(0)
    try:
        travel, elevation = (nothing if (row := real_array(given)) is None else row for given in floor)
    except (TypeError, ValueError):
        travel = elevation = nothing
    fits = travel.ndim == 1 and travel.shape == elevation.shape
    if not fits or not (len(travel) > 1 and np.isfinite([travel, elevation]).all() and (np.diff(travel) > 0.0).all()):
        raise ValueError(
            f"floor = {shown(floor)}: must be (travel, elevation), finite (N,) each, in rad, travel increasing"
        )
    return tuple(travel.tolist()), tuple(elevation.tolist())


def validate_via(via: Any, duration: float) -> tuple[tuple[float | None, float, float | None], ...]:
    """Return via points as tuples of floats. Raises ValueError unless they are in order and within the duration."""
    points, last = [], 0.0
    if not isinstance(via, tuple | list):
        raise ValueError(f"via = {shown(via)}: must be a tuple of points")
    for k, point in enumerate(via):
        said = f"via[{k}] = {shown(point)}: must be (time, travel, elevation) in s and rad, "
        if not isinstance(point, tuple | list) or len(point) != 3:
            raise ValueError(said + "time or elevation None if free")
        if not all(value is None or is_number(value) for value in point):
            raise ValueError(said + "finite, time or elevation None if free")
        time, travel, elevation = (None if value is None else float(value) for value in point)
        if travel is None or (time is None and elevation is None):
            raise ValueError(said + "with a travel, and a time or an elevation")
        if elevation is not None and not abs(elevation) < math.pi / 2:
            raise ValueError(said + "with an elevation within 90 degrees")
        if time is not None and not last < time < duration:
            raise ValueError(said + f"times increasing between 0 and the duration of {duration:g} s")
        last = last if time is None else time
        points.append((time, travel, elevation))
    return tuple(points)


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory:
    """States and voltages over time: a plan or a flight.

    Args:
        t: (K,) times in s, increasing from 0.
        x: (6, K) states (44) in rad and rad/s.
        u: (2, K) voltages (front, back) in V; linear between the samples of a plan, held from each sample to the next
            in a flight.
        limits: limits of the plan, (9) by default.
        rig: rig of the plan or flight, the paper's by default.

    Raises:
        ValueError: if a shape does not fit, a value is not finite, or t does not increase from 0.
    """

    t: np.ndarray
    x: np.ndarray
    u: np.ndarray
    limits: Limits = field(default_factory=Limits)
    rig: Rig = PAPER

    def __post_init__(self) -> None:
        if not isinstance(self.rig, Rig):
            raise ValueError(f"rig = {shown(self.rig)}: must be a Rig")
        if not isinstance(self.limits, Limits):
            raise ValueError(f"limits = {shown(self.limits)}: must be Limits")
        for name in ("t", "x", "u"):
            value = real_array(getattr(self, name))
            if value is None:
                raise ValueError(f"{name} = {shown(getattr(self, name))}: must be an array of real numbers")
            value.setflags(write=False)
            object.__setattr__(self, name, value)
        n = len(self.t) if self.t.ndim == 1 else 0
        for name, shape in (("t", (n,)), ("x", (6, n)), ("u", (2, n))):
            value = getattr(self, name)
            if value.shape != shape or n < 2:
                raise ValueError(
                    f"{name} has shape {value.shape}; the shapes must be t (K,), x (6, K), u (2, K) with K >= 2"
                )
            if not np.isfinite(value).all():
                raise ValueError(f"{name} is not finite")
        if self.t[0] != 0.0 or not (np.diff(self.t) > 0.0).all():
            raise ValueError("t must increase from 0")

    def __repr__(self) -> str:
        pitch = np.degrees(np.abs(self.x[4]).max())
        return (
            f"Trajectory({self.duration:g} s, {len(self.t)} samples, rig {self.rig.name!r}, "
            f"pitch up to {pitch:.1f} deg, {self.u.min():.2f} to {self.u.max():.2f} V)"
        )

    def _repr_png_(self) -> bytes | None:
        return plot_trajectory(self)

    @property
    def duration(self) -> float:
        """Time of the last sample in s."""
        return float(self.t[-1])

    def __call__(self, t: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """State (6, ...) and voltages (2, ...) at the times t in s; constant before the start and after the end.

        Angles are cubic Hermite interpolants of angles and rates, and rates their derivatives, so that both stay
        consistent. Voltages are linear, so that they meet their limits between the samples.
        """
        given = real_array(t)
        if given is None:
            raise ValueError(f"t = {shown(t)}: must be times in s")
        times = np.clip(given, 0.0, self.duration)
        k = np.clip(np.searchsorted(self.t, times, side="right") - 1, 0, len(self.t) - 2)
        h = self.t[k + 1] - self.t[k]
        s = (times - self.t[k]) / h
        last, new = self.x.take(k, axis=1), self.x.take(k + 1, axis=1)  # faster than indexing
        rise, start, end = new[0::2] - last[0::2], h * last[1::2], h * new[1::2]
        a, b = 3.0 * rise - 2.0 * start - end, start + end - 2.0 * rise
        x = np.empty((6, *times.shape))
        x[0::2] = last[0::2] + s * (start + s * (a + s * b))
        x[1::2] = (start + s * (2.0 * a + 3.0 * s * b)) / h
        u = (1.0 - s) * self.u.take(k, axis=1) + s * self.u.take(k + 1, axis=1)
        return x, u

    def save(self, path: str | os.PathLike) -> None:
        """Write to an .npz file, with limits and rig, atomically and without pickle."""
        path = Path(path)
        if path.suffix != ".npz":
            raise ValueError(f"path = {str(path)!r}: must end in .npz")
        limits = np.array([math.nan if value is None else value for value in vars(self.limits).values()])
        with atomic_write(path) as file:
            np.savez_compressed(file, t=self.t, x=self.x, u=self.u, limits=limits, rig=np.array(self.rig.to_toml()))

    @classmethod
    def load(cls, path: str | os.PathLike, rig: "str | os.PathLike | Rig | None" = None) -> "Trajectory":
        """Read a file written by `save`; a file without a rig is for the paper's.

        Raises ValueError if the file holds no trajectory, or if it is for another rig than the given one, with the
        differences.
        """
        path = as_path("path", path)
        try:
            data = read_arrays(path)
            values: list[Any] = [None if math.isnan(limit) else float(limit) for limit in data["limits"]]
            limits = Limits(*values)
            own = Rig.from_toml(str(data["rig"])) if "rig" in data else PAPER
            trajectory = cls(data["t"], data["x"], data["u"], limits, own)
        except KeyError as error:
            raise ValueError(f"path = {str(path)!r} holds no trajectory: it lacks {error}") from error
        except (TypeError, ValueError) as error:
            raise ValueError(f"path = {str(path)!r} holds no trajectory: {error}") from error
        if rig is not None:
            check_same_rig(f"path = {str(path)!r}", own, find_rig(rig), "the one that it is loaded for")
        return trajectory


class Sampler(Protocol):
    """Source of a reference for every flight, reproducible from the generator's state, as `ManeuverSampler`."""

    @property
    def duration(self) -> float:
        """Duration in s of the longest reference that it draws."""

    def __call__(self, rng: np.random.Generator) -> Trajectory:
        """Draw the reference of one flight."""


def concatenate(first: Trajectory, second: Trajectory) -> Trajectory:
    """Join two trajectories, the second starting in the last state of the first; the limits are the first's.

    Raises ValueError if the second starts in another state, or if their limits differ.
    """
    gap = np.abs(second.x[:, 0] - first.x[:, -1]).max()
    if gap > LARGEST_GAP:
        raise ValueError(
            f"second: starts in {second.x[:, 0]}, {gap:g} rad or rad/s from {first.x[:, -1]}, where the first ends"
        )
    if first.limits != second.limits:
        raise ValueError(f"second: planned within {second.limits}, and the first within {first.limits}")
    check_same_rig("second", second.rig, first.rig, "the first's")
    t = np.concatenate((first.t, first.duration + second.t[1:]))
    x, u = (np.concatenate((a, b[:, 1:]), axis=1) for a, b in ((first.x, second.x), (first.u, second.u)))
    return Trajectory(t, x, u, first.limits, first.rig)
