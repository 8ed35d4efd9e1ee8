"""Figures of measured flights."""

from collections.abc import Iterator, Sequence

import numpy as np
from matplotlib.figure import Figure

from heli_gym.baselines.evaluation.figure_style import INK, LIMIT, NOTE, columns_of_panels, finish, note, styled
from heli_gym.baselines.evaluation.labels import BLUE, RED
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.log_quantities import ANGLES, VOLTAGES
from heli_gym.baselines.identification.prediction import FilteredLog, constant_rate, horizon_starts
from heli_gym.baselines.identification.replay import FIT_TIME, Replay
from heli_gym.trajectory import Trajectory

ON_TABLE = {"color": "0.5", "alpha": 0.25, "linewidth": 0.0}
SATURATED = {"color": RED, "alpha": 0.15, "linewidth": 0.0}


@styled
def flight_log(log: FlightLog, plan: Trajectory | None = None, limits: tuple[float, float] = (-24.0, 24.0)) -> Figure:
    """Angles with references or a plan, smoothed rates, and voltages of a log; parts on the table are grey."""
    figure = Figure(figsize=(11.0, 8.4))
    panels = columns_of_panels(figure, 4, 2)
    rates = np.degrees(log.rates())
    end = log.duration if plan is None else max(log.duration, plan.duration)
    for i, name in enumerate(ANGLES):
        left, right = panels[i]
        left.plot(log.t, np.degrees(log.angles[i]), color=BLUE, label="measured")
        if f"{name}_ref" in log.references:
            left.plot(log.t, np.degrees(log.references[f"{name}_ref"]), color=INK, linestyle="--", linewidth=1.0,
                      label="reference")  # fmt: skip
        right.plot(log.t, rates[i], color=BLUE, label="measured, smoothed")
        if plan is not None:
            left.plot(plan.t, np.degrees(plan.x[2 * i]), color=NOTE, label="plan")
            right.plot(plan.t, np.degrees(plan.x[2 * i + 1]), color=NOTE, label="plan")
        left.set_ylabel(f"{name} $q_{i + 1}$ (deg)")
        right.set_ylabel(f"{name} rate (deg/s)")
    for i, name in enumerate(VOLTAGES):
        axes = panels[3, i]
        axes.plot(log.t, log.voltages[i], color=BLUE, drawstyle="steps-post", linewidth=0.9, label="commanded")
        if plan is not None:
            axes.plot(plan.t, plan.u[i], color=NOTE, label="plan")
        low, high = axes.get_ylim()
        for limit in limits:
            if low <= limit <= high:
                axes.axhline(limit, **LIMIT)
        axes.set_ylabel(f"{name[2:]} motor (V)")
    on_table, saturated = ~log.airborne(), log.saturated(limits)
    for axes in panels.ravel():
        for first, last in runs(on_table):
            axes.axvspan(log.t[first], log.t[last], **ON_TABLE)
        axes.set_xlim(0.0, end)
    for axes in panels[3]:
        for first, last in runs(saturated):
            axes.axvspan(log.t[first], log.t[last], **SATURATED)
        note(axes, f"{100.0 * saturated.mean():.1f} % at the amplifier's limits, {limits[0]:g} and {limits[1]:g} V")
    note(panels[1, 0], f"{100.0 * (~on_table).mean():.1f} % airborne; grey: on the table or just off it")
    figure.suptitle(f"{log.name}: {log.duration:.2f} s, {1e3 * log.sample_time:g} ms", parse_math=False)
    finish(figure)
    return figure


@styled
def replayed(log: FlightLog, pieces: Sequence[Replay], plant: str) -> Figure:
    """Measured angles, those of a plant under the logged voltages, in pieces, and their differences."""
    figure = Figure(figsize=(11.0, 7.6))
    panels = columns_of_panels(figure, 4, 2)
    for axis, name in enumerate(ANGLES):
        left, right = panels[axis]
        left.plot(log.t, np.degrees(log.angles[axis]), color=INK, linewidth=1.0, label="measured")
        for i, (t, angles) in enumerate(pieces):
            k = round(t[0] / log.sample_time)
            error = np.degrees(log.angles[axis, k : k + len(t)] - angles[axis])
            left.plot(t, np.degrees(angles[axis]), color=BLUE, label=None if i else plant)
            right.plot(t, error, color=BLUE)
            for axes in (left, right):
                axes.axvline(t[0], color="0.8", linewidth=0.6)
        left.set_ylabel(f"{name} $q_{axis + 1}$ (deg)")
        right.set_ylabel("difference (deg)")
    for i, name in enumerate(VOLTAGES):
        panels[3, i].plot(log.t, log.voltages[i], color=INK, drawstyle="steps-post", linewidth=0.9)
        panels[3, i].set_ylabel(f"{name[2:]} motor (V)")
    for axes in panels.ravel():
        for first, last in runs(~log.airborne()):
            axes.axvspan(log.t[first], log.t[last], **ON_TABLE)
        axes.set_xlim(0.0, log.duration)
    note(panels[0, 1], f"each piece starts in the state that fits its first {FIT_TIME:g} s")
    figure.suptitle(f"{log.name}: the logged voltages, flown by {plant}", parse_math=False)
    finish(figure)
    return figure


def runs(mask: np.ndarray) -> Iterator[tuple[int, int]]:
    """Yield first and last index of each run of true values in a mask."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], mask, [False])).astype(int)))
    for first, after in zip(edges[::2], edges[1::2]):
        yield int(first), min(int(after), len(mask) - 1)


@styled
def predictions(filtered: FilteredLog, fit_share: float, horizon: float = 1.0) -> Figure:
    """Measured angles, predictions a horizon in s ahead, and their errors; the fitted part is grey."""
    log = filtered.log
    figure = Figure(figsize=(11.0, 6.4))
    n = round(horizon / log.sample_time)
    k = horizon_starts(log, (0.0, 1.0), horizon)
    y = filtered.predict(k, n)[:, :, n].T
    plain = constant_rate(log, k, horizon)
    for axis, (left, right) in enumerate(columns_of_panels(figure, 3, 2)):
        left.plot(log.t, np.degrees(log.angles[axis]), color=INK, linewidth=1.0, label="measured")
        left.plot(log.t[k + n], np.degrees(y[axis]), color=BLUE, label=f"predicted {horizon:g} s before")
        for values, colour, label in ((plain, "0.6", "constant rate"), (y, BLUE, f"predicted {horizon:g} s before")):
            error = np.degrees(log.angles[axis, k + n] - values[axis])
            right.plot(log.t[k + n], error, color=colour, label=label)
        for axes in (left, right):
            axes.axvspan(0.0, fit_share * log.duration, **ON_TABLE)
            axes.set_xlim(0.0, log.duration)
        left.set_ylabel(f"{ANGLES[axis]} $q_{axis + 1}$ (deg)")
        right.set_ylabel("error (deg)")
    figure.suptitle(f"{log.name}; grey: the part that was fitted", parse_math=False)
    finish(figure)
    return figure
