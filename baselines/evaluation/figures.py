"""The paper's figures: each function returns a matplotlib Figure, without a display."""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from heli_gym.baselines.evaluation.figure_style import (
    GUIDE,
    INK,
    LIMIT,
    PLAN,
    annotate,
    columns_of_panels,
    draw_limits,
    finish,
    name_lines,
    note,
    rows_of_panels,
    single_panel,
    styled,
)
from heli_gym.baselines.evaluation.labels import BLUE, RED, SKY, colours_of, label_of
from heli_gym.baselines.paper.normal_form import ddy2_bounds, v1_bounds, v2_bounds
from heli_gym.baselines.paper.saturation import psi1, psi2_bounds, ramp
from heli_gym.baselines.paper.tvlqr import Gains
from heli_gym.model import hover_input, thrust, virtual_input, voltage
from heli_gym.parameters import AMPLIFIER_LIMITS, HelicopterParameters, Limits
from heli_gym.rig import Rig, assumed_rig, rig_of
from heli_gym.trajectory import Maneuver, Trajectory

PAPER_V2 = 0.58  # N, (18) as rounded at the end of Section III-D
PAPER_LEAST_V2 = 0.11  # N, (43) as rounded there


class Quantity(NamedTuple):
    """Quantity in a panel over time."""

    name: str
    unit: str
    values: Callable[[Trajectory], np.ndarray]  # (K,), in `unit`; so are the limits
    limits: Callable[[Limits], tuple[float, float]] | None = None
    held: bool = False  # True: a flight holds each value until the next sample


TRAVEL = Quantity("travel $q_1$", "deg", lambda flight: np.degrees(flight.x[0]))
ELEVATION = Quantity("elevation $q_2$", "deg, positive down", lambda flight: np.degrees(flight.x[2]))
PITCH = Quantity("pitch $q_3$", "deg", lambda flight: np.degrees(flight.x[4]), lambda limits: degrees(limits.pitch))
FRONT = Quantity("front motor $u_f$", "V", lambda flight: flight.u[0], lambda limits: limits.u, held=True)
BACK = Quantity("back motor $u_b$", "V", lambda flight: flight.u[1], lambda limits: limits.u, held=True)


@styled
def thrust_map(parameters: HelicopterParameters, limits: Limits = Limits()) -> Figure:
    """Fig. 2: thrust of one fan over its voltage, (2)."""
    figure, axes = single_panel("voltage $u$ (V)", "thrust of one fan $f$ (N)")
    u = np.linspace(-AMPLIFIER_LIMITS[1], AMPLIFIER_LIMITS[1], 481)
    hover = float(hover_input(0.0, parameters)[0]) / 2.0
    hover_voltage = float(voltage(hover, parameters))
    axes.plot(u, thrust(u, parameters), color=BLUE, label="thrust map (2)")
    axes.plot(hover_voltage, hover, "o", color=INK, label=f"hover: {hover_voltage:.2f} V, {hover:.3f} N")
    draw_limits(axes.axvline, limits.u, limits_label(limits))
    axes.set_xlim(u[0], u[-1])
    axes.legend(loc="upper left")
    return figure


@styled
def feedforward(trajectory: Trajectory, rig: Rig | HelicopterParameters, title: str) -> Figure:
    """Figs. 4 and 8: angles, virtual inputs and voltages of a plan."""
    rig = assumed_rig(trajectory, rig)
    figure = Figure(figsize=(7.2, 7.2))
    *angle_panels, v1_panel, v2_panel, front_panel, back_panel = rows_of_panels(figure, 3, 2, 2)
    quantities = (TRAVEL, ELEVATION, PITCH, FRONT, BACK)
    for axes, quantity in zip((*angle_panels, front_panel, back_panel), quantities):
        draw(axes, quantity, trajectory, {})

    v1, v2 = virtual_input(rig.thrust(trajectory.u))
    f = rig.thrust_bounds(trajectory.limits.u)
    for axes, label, v in (
        (v1_panel, "thrust sum $v_1$ (N)", v1),
        (v2_panel, "thrust difference $v_2$ (N)", v2),
    ):
        axes.plot(trajectory.t, v, label="plan", **PLAN)
        axes.set(ylabel=label, xlim=(0.0, trajectory.duration))
    for bound in v1_bounds(v2, f):
        v1_panel.plot(trajectory.t, bound, **LIMIT)
    draw_limits(v2_panel.axhline, v2_bounds(f))
    note(v1_panel, r"limits $v_1^\pm(v_2)$ of (20)")
    note(v2_panel, v2_label(trajectory.limits, f))
    turn = trajectory.x[[0, 2], -1] - trajectory.x[[0, 2], 0]
    is_papers = np.allclose(turn, np.subtract(Maneuver().goal, Maneuver().start), atol=1e-3)
    paper = paper_says(f"{Maneuver().duration:g} s", trajectory.limits) if is_papers else ""
    figure.suptitle(f"{title}, $T$ = {trajectory.duration:.4g} s{paper}")
    finish(figure)
    return figure


@styled
def input_constraints(limits: Limits, parameters: HelicopterParameters) -> Figure:
    """Fig. 5: admissible thrusts for the voltage limits, and by (17)-(20) their sums and differences."""
    figure = Figure(figsize=(8.0, 4.2))
    thrusts, virtual = figure.subplots(1, 2)
    f_min, f_max = f = rig_of(parameters, limits).thrust_bounds(limits.u)
    v1_hover, v2_hover = hover_input(0.0, parameters)
    box = np.array([[f_min, f_max, f_max, f_min], [f_min, f_min, f_max, f_max]])
    draw_corners(thrusts, box, (v1_hover / 2.0, v1_hover / 2.0))
    v1, v2 = virtual_input(box)
    draw_corners(virtual, np.array([v2, v1]), (v2_hover, v1_hover))

    draw_limits(thrusts.axvline, f)
    draw_limits(thrusts.axhline, f)
    name_limits(thrusts.secondary_xaxis, "top", "f_f", f)
    name_limits(thrusts.secondary_yaxis, "right", "f_b", f)
    thrusts.set(xlabel="front thrust $f_f$ (N)", ylabel="back thrust $f_b$ (N)")
    thrusts.set_title(f"{limits.u_min:g} to {limits.u_max:g} V on each motor")

    v2 = np.linspace(*v2_bounds(f), 201)
    for sign, bound, side in zip("-+", v1_bounds(v2, f), (-1.0, 1.0)):
        virtual.plot(v2, bound, **LIMIT)
        annotate(virtual, f"$v_1^{sign}(v_2)$", (v2[130], bound[130]), (27.0, 10.0 * side), color=RED)
    draw_limits(virtual.axvline, v2_bounds(f), limits_label(limits))
    name_limits(virtual.secondary_xaxis, "top", "v_2", v2_bounds(f))
    least = float(np.abs(parameters.a3) / parameters.b3)
    paper = paper_says(f"±{PAPER_LEAST_V2} N", limits)
    for bound in (-least, least):
        virtual.axvline(bound, label=f"±|$a_3$|/$b_3$ of (43): ±{least:.3f} N{paper}", **GUIDE)
    virtual.set(xlabel="thrust difference $v_2$ (N)", ylabel="thrust sum $v_1$ (N)")
    virtual.set_title(v2_label(limits, f))
    finish(figure)
    return figure


@styled
def smooth_saturation(bounds: tuple[float, float]) -> Figure:
    """Fig. 6: saturation function (27) for pitch bounds (min, max) in rad."""
    reach = 1.5 * (bounds[1] - bounds[0])
    xi = np.linspace(-reach, reach, 401)
    at_0 = psi1(0.0, bounds)
    figure, axes = single_panel(r"new state $\xi_1$ (deg)", r"pitch $q_3 = \psi_1(\xi_1, \psi_1^\pm)$ (deg)")
    draw_saturation(axes, np.degrees(xi), np.degrees(psi1(xi, bounds).value), degrees(bounds), r"\psi_1", "deg")
    axes.axline(
        (0.0, math.degrees(at_0.value)),
        slope=at_0.slope,
        label=f"slope {at_0.slope:.3g} at 0 (paper: 1)",
        **GUIDE,
    )
    axes.legend(loc=(0.52, 0.28))
    return figure


@styled
def ramp_saturation(limits: Limits = Limits(), parameters: HelicopterParameters = HelicopterParameters()) -> Figure:
    """Fig. 7: saturation function (34) for its bounds (33) at hover."""
    f = rig_of(parameters, limits).thrust_bounds(limits.u)
    low, high = psi2_bounds(ddy2_bounds(np.zeros(6), f, parameters), psi1(0.0, limits.pitch), 0.0)
    v = 2.0 * np.linspace(low, high, 401)
    figure, axes = single_panel(
        r"new input $\tilde v_2$ (rad/s²)", r"$\dot\xi_2 = \psi_2(\tilde v_2, \psi_2^\pm)$ (rad/s²)"
    )
    draw_saturation(axes, v, ramp(v, (low, high)), (low, high), r"\psi_2", "rad/s²")
    note(axes, "bounds (33) at hover")
    return figure


@styled
def gains(gains: Gains) -> Figure:
    """Fig. 9: feedback gains (51) over time: first row above, second row below."""
    figure = Figure(figsize=(7.2, 5.2))
    panels = columns_of_panels(figure, 2, 1)[:, 0]
    for row, axes in enumerate(panels):
        for i, linestyle in enumerate(("-", "--", ":")):
            for j, (color, symbol) in enumerate(((BLUE, f"$q_{i + 1}$"), (SKY, rf"$\dot q_{i + 1}$"))):
                axes.plot(gains.t, gains.K[row, 2 * i + j], color=color, linestyle=linestyle, label=symbol)
        axes.set(ylabel=f"$K_{{{row + 1}i}}$ (N/rad, N s/rad)", xlim=(0.0, gains.t[-1]))
        name_lines(axes)
    figure.align_ylabels()
    return figure


@styled
def angles(reference: Trajectory, flights: Mapping[str, Trajectory], title: str) -> Figure:
    """Fig. 10: planned and flown angles, with the tracking errors in a second column."""
    figure = Figure(figsize=(9.0, 6.4))
    for (left, right), quantity in zip(columns_of_panels(figure, 3, 2), (TRAVEL, ELEVATION, PITCH)):
        draw(left, quantity, reference, flights)
        for (name, flight), colour in zip(flights.items(), colours_of([*flights])):
            right.plot(flight.t, tracking_error(quantity, reference, flight), color=colour, label=label_of(name).text)
        right.axhline(0.0, linestyle="--", **PLAN)
        offsets = {f"{tracking_error(quantity, reference, flight)[0]:+.3g}" for flight in flights.values()}
        if offsets - {"+0", "-0"} and len(offsets) == 1:
            note(right, f"start {offsets.pop()}\N{DEGREE SIGN} off the plan")
        right.set_ylabel(f"error of {quantity.name}\n({quantity.unit})")
    figure.suptitle(title, parse_math=False)  # it contains file names
    finish(figure)
    return figure


@styled
def voltages(reference: Trajectory, flights: Mapping[str, Trajectory], title: str) -> Figure:
    """Fig. 11: planned and flown voltages."""
    figure = Figure(figsize=(7.2, 5.2))
    for axes, quantity in zip(columns_of_panels(figure, 2, 1)[:, 0], (FRONT, BACK)):
        draw(axes, quantity, reference, flights)
    figure.suptitle(title, parse_math=False)  # it contains file names
    finish(figure)
    return figure


@styled
def overview(reference: Trajectory, flights: Mapping[str, Trajectory], title: str) -> Figure:
    """Angles and voltages in one wide figure; without flights, those of the plan."""
    figure = Figure(figsize=(11.0, 5.2))
    for axes, quantity in zip(rows_of_panels(figure, 3, 2), (TRAVEL, ELEVATION, PITCH, FRONT, BACK)):
        draw(axes, quantity, reference, flights)
    figure.suptitle(title, parse_math=False)  # it contains file names
    finish(figure)
    return figure


def draw(axes: Axes, quantity: Quantity, reference: Trajectory, flights: Mapping[str, Trajectory]) -> None:
    """Draw a quantity as flown and as planned, with its limits."""
    drawstyle = "steps-post" if quantity.held else "default"
    for (name, flight), colour in zip(flights.items(), colours_of([*flights])):
        axes.plot(flight.t, quantity.values(flight), color=colour, drawstyle=drawstyle, label=label_of(name).text)
    linestyle = "--" if flights else "-"
    axes.plot(reference.t, quantity.values(reference), linestyle=linestyle, label="plan", **PLAN)
    if quantity.limits:
        draw_limits(axes.axhline, quantity.limits(reference.limits), limits_label(reference.limits))
        note(axes, range_text(quantity, reference, flights))
    low, high = axes.get_ylim()
    least = max(1.0 - 0.5 * (high - low), 0.0)  # otherwise rounding errors of a constant fill the panel
    axes.set(
        ylabel=f"{quantity.name}\n({quantity.unit})",
        xlim=(0.0, reference.duration),
        ylim=(low - least, high + least),
    )


def draw_corners(axes: Axes, corners: np.ndarray, hover: tuple[float, float]) -> None:
    """Fill the area between corners (2, 4); letters A to D identify the same corner in the other plane."""
    axes.fill(*corners, facecolor=SKY, alpha=0.2, edgecolor="none")
    centre = corners.mean(axis=1)
    for letter, corner in zip("ABCD", corners.T):
        annotate(axes, letter, corner, 10.0 * np.sign(np.round(corner - centre, 9)))
    axes.plot(*hover, "o", color=INK, label="hover")
    axes.set_aspect("equal")
    axes.margins(0.14)


def draw_saturation(
    axes: Axes, x: np.ndarray, y: np.ndarray, bounds: tuple[float, float], symbol: str, unit: str
) -> None:
    """Draw a saturation function, and its bounds with their values."""
    axes.plot(x, y, color=BLUE)
    draw_limits(axes.axhline, bounds)
    for sign, bound, offset in zip("-+", bounds, (8.0, -8.0)):
        annotate(axes, f"${symbol}^{sign} = {bound:.3g}$ {unit}", (0.0, bound), (0.0, offset))
    axes.set(xlim=(x[0], x[-1]), ylim=1.25 * np.array(bounds))


def name_limits(second: Callable[..., Any], side: str, symbol: str, limits: tuple[float, float]) -> None:
    """Write the symbols of both limits on an axes' secondary_xaxis or secondary_yaxis."""
    axis = second(side)
    axis.set_ticks(limits, labels=[f"${symbol}^-$", f"${symbol}^+$"])
    axis.tick_params(length=0.0, labelcolor=RED)
    axis.spines[:].set_visible(False)


def limits_label(limits: Limits) -> str:
    return "limits (9) of the paper" if limits == Limits() else "limits"


def paper_says(value: str, limits: Limits) -> str:
    """Text with the paper's number, or no text for limits other than (9)."""
    return f" (paper: {value})" if limits == Limits() else ""


def v2_label(limits: Limits, f: tuple[float, float]) -> str:
    return f"$v_2^\\pm$ = ±{v2_bounds(f)[1]:.3f} N{paper_says(f'±{PAPER_V2} N', limits)}"


def range_text(quantity: Quantity, reference: Trajectory, flights: Mapping[str, Trajectory]) -> str:
    """Text with the flown range, or the planned one without flights, and the limits."""
    assert quantity.limits
    values = np.concatenate([quantity.values(flight) for flight in flights.values() or (reference,)])
    low, high = quantity.limits(reference.limits)
    return f"{values.min():.1f} to {values.max():.1f} {quantity.unit}, limits {low:.3g} to {high:.3g}"


def tracking_error(quantity: Quantity, reference: Trajectory, flight: Trajectory) -> np.ndarray:
    """Flown minus planned values (K,) at the times of the flight."""
    planned = Trajectory(flight.t, *reference(flight.t))
    return quantity.values(flight) - quantity.values(planned)


def degrees(window: tuple[float, float]) -> tuple[float, float]:
    low, high = window
    return math.degrees(low), math.degrees(high)
