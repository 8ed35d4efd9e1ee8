"""Style of all figures: matplotlib's settings, colours, panels, notes, and files for screen and print."""

import math
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text

from heli_gym.baselines.evaluation.labels import BLUE, GREEN, ORANGE, PINK, RED, SKY
from heli_gym.storage import atomic_write

DPI = 150
FORMATS = ("png", "pdf", "svg")
COLUMN_WIDTHS = {1: 3.5, 2: 7.16}  # inches: one and two columns of a journal
STACKED_HEIGHT = 1.25  # inches of a panel, where panels stand in one column
TALLER = {1: 0.19, 2: 0.13}  # additional height per inch of on-screen width
LEGEND_LETTERS = 55  # per row of a legend, in one column
FONT_SIZES, PRINT_DPI = {1: 6.0, 2: 7.5}, 300
DATELESS = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}

# One colour per meaning; `labels` has the colours of policies.
INK, NOTE = "black", "0.35"
FLOWN = (BLUE, GREEN, PINK, SKY, ORANGE)  # of lines other than policies
LIMIT: dict[str, Any] = {"color": RED, "linestyle": (0, (6, 3)), "linewidth": 1.1}
PLAN: dict[str, Any] = {"color": INK, "linewidth": 1.2}
GUIDE: dict[str, Any] = {"color": NOTE, "linestyle": ":", "linewidth": 1.2}

# Decorator that changes matplotlib's settings only while a figure is made or saved.
styled = rc_context(
    {
        "figure.constrained_layout.use": True,
        "figure.constrained_layout.h_pad": 0.08,  # inches
        "figure.constrained_layout.w_pad": 0.08,
        "font.size": 9,
        "axes.titlesize": 9,
        "axes.labelsize": 9,
        "figure.titlesize": 10,
        "legend.fontsize": 9,
        "legend.frameon": False,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.color": "0.9",
        "grid.linewidth": 0.6,
        "lines.linewidth": 1.5,
        "lines.markersize": 5,
    }
)


@styled
def save(figure: Figure, path: str | os.PathLike, columns: int = 0) -> None:
    """Write a figure to a .png, .pdf or .svg file, atomically.

    For print, `columns` = 1 or 2 sets the width to as many columns of a journal; 0 leaves the size unchanged. Equal
    figures give equal bytes.
    """
    kind = Path(path).suffix[1:]
    if kind not in FORMATS:
        raise ValueError(f"path = {str(path)!r}: must end in {', '.join('.' + name for name in FORMATS)}")
    if columns not in (0, *COLUMN_WIDTHS):
        raise ValueError(f"columns = {columns!r}: must be 0, 1 or 2")
    if columns:
        width, height = figure.get_size_inches()
        print_width = COLUMN_WIDTHS[columns]
        if columns == 1 and len(figure.axes) > 2:
            stack_panels(figure)
            figure.set_size_inches(print_width, STACKED_HEIGHT * len(figure.axes) + 1.0)
        else:
            figure.set_size_inches(print_width, print_width * height / width * max(1.0, TALLER[columns] * width))
        for legend in figure.legends:  # as many rows as the width requires
            handles: Any = legend.legend_handles
            labels = [text.get_text() for text in legend.get_texts()]
            legend.remove()
            ncols = max(1, min(len(labels), columns * LEGEND_LETTERS // max(map(len, labels))))
            figure.legend(handles, labels, loc="outside lower center", ncols=ncols)
        for text in figure.findobj(Text):
            text.set_fontsize(min(text.get_fontsize(), FONT_SIZES[columns]))
    # Text stays text in .svg and .pdf; without dates and random names, equal figures give equal bytes.
    with (
        rc_context({"svg.fonttype": "none", "svg.hashsalt": "heli_gym", "pdf.fonttype": 42}),
        atomic_write(path) as file,
    ):
        figure.savefig(file, format=kind, dpi=DPI if not columns else PRINT_DPI, metadata=DATELESS.get(kind))


def single_panel(xlabel: str, ylabel: str) -> tuple[Figure, Axes]:
    figure = Figure(figsize=(5.0, 3.4))
    axes = figure.subplots()
    axes.set(xlabel=xlabel, ylabel=ylabel)
    return figure, axes


def rows_of_panels(figure: Figure, *counts: int) -> list[Axes]:
    """Add rows of panels over time, with given counts and equal total width."""
    columns = math.lcm(*counts)
    grid = figure.add_gridspec(len(counts), columns)
    panels = []
    for row, count in enumerate(counts):
        width = columns // count
        for start in range(0, columns, width):
            panels.append(figure.add_subplot(grid[row, start : start + width], xlabel="time (s)"))
    return panels


def stack_panels(figure: Figure) -> None:
    """Put all panels of a figure below each other; only the lowest names the common time axis."""
    panels = list(figure.axes)
    grid = figure.add_gridspec(len(panels), 1)
    for row, axes in enumerate(panels):
        axes.set_subplotspec(grid[row, 0])
        axes.tick_params(labelbottom=True)
        if row < len(panels) - 1 and axes.get_xlabel() == panels[-1].get_xlabel():
            axes.set_xlabel("")
    figure.align_ylabels()


def columns_of_panels(figure: Figure, rows: int, columns: int) -> np.ndarray:
    """Add panels (rows, columns) with a common time axis."""
    panels = figure.subplots(rows, columns, sharex=True, squeeze=False)
    for axes in panels[-1]:
        axes.set_xlabel("time (s)")
    return panels


def draw_limits(line: Callable[..., Any], limits: tuple[float, float], label: str | None = None) -> None:
    """Draw both limits with an axes' axhline or axvline."""
    low, high = limits
    line(low, label=label, **LIMIT)
    line(high, **LIMIT)


def annotate(axes: Axes, text: str, point: Any, offset: Any, color: str = INK) -> None:
    """Write text at an offset in points from a point."""
    axes.annotate(text, point, offset, textcoords="offset points", ha="center", va="center", color=color)


def name_lines(axes: Axes) -> None:
    """Write each line's label at its right end; labels that would overlap are moved apart."""
    low, high = axes.get_ylim()
    ends = sorted(((float(np.asarray(line.get_ydata())[-1]), line) for line in axes.lines), key=lambda end: end[0])
    heights = np.array([(y - low) / (high - low) for y, _ in ends])
    for _ in range(100):
        for k in range(len(heights) - 1):
            overlap = 0.09 - (heights[k + 1] - heights[k])
            if overlap > 0.0:
                heights[k : k + 2] += (-0.5 * overlap, 0.5 * overlap)
    for (y, line), height in zip(ends, heights):
        axes.annotate(
            str(line.get_label()),
            (1.0, (y - low) / (high - low)),
            (1.03, height),
            xycoords="axes fraction",
            textcoords="axes fraction",
            va="center",
            color=line.get_color(),
            arrowprops={"arrowstyle": "-", "color": "0.8", "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0},
        )


def note(axes: Axes, text: str) -> None:
    """Write a note in small print above a panel."""
    axes.set_title(text.replace("-", "\N{MINUS SIGN}"), loc="right", fontsize="small", color=NOTE)


def finish(figure: Figure) -> None:
    """Align labels, round ticks and add one legend for all panels."""
    figure.align_ylabels()
    entries: dict[str, Artist] = {}
    for axes in figure.axes:
        axes.locator_params(steps=(1, 2, 5, 10))
        for handle, label in zip(*axes.get_legend_handles_labels()):
            entries.setdefault(label, handle)
    rows = math.ceil(len(entries) / 4)
    legend = figure.legend(entries.values(), entries, loc="outside lower center", ncols=math.ceil(len(entries) / rows))
    for shown in legend.legend_handles:
        if isinstance(shown, Line2D):  # one of many faint lines would not be seen alone
            shown.set_alpha(1.0)
