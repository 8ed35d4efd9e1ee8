"""Notebook display: a trajectory as a plot, a rendered frame as a picture."""

import io
import struct
import zlib
from dataclasses import MISSING, fields
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from heli_gym.trajectory import Trajectory


class Picture(np.ndarray):
    """RGB array (height, width, 3), uint8, that a notebook displays as a picture."""

    def _repr_png_(self) -> bytes | None:
        if self.ndim != 3 or self.dtype != np.uint8:
            return None  # a slice of a picture, or a result of arithmetic
        return png(np.asarray(self))


def png(pixels: np.ndarray) -> bytes:
    """Encode an RGB array (height, width, 3), uint8, as a PNG file."""
    height, width, _ = pixels.shape
    lines = np.concatenate((np.zeros((height, 1), np.uint8), pixels.reshape(height, -1)), axis=1)  # 0: no filter

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(lines.tobytes()))
        + chunk(b"IEND", b"")
    )


def plot_trajectory(trajectory: "Trajectory") -> bytes | None:
    """PNG file of angles and voltages over time; None without matplotlib."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        return None
    figure = Figure(figsize=(8.0, 3.2), dpi=100, layout="constrained")
    left, right = figure.subplots(1, 2)
    for row, label, style in (
        (0, "travel $q_1$", "-"),
        (2, "elevation $q_2$, positive down", "--"),
        (4, "pitch $q_3$", "-."),
    ):
        left.plot(trajectory.t, np.degrees(trajectory.x[row]), style, label=label)
    for row, label, style in ((0, "front $u_f$", "-"), (1, "back $u_b$", "--")):
        right.plot(trajectory.t, trajectory.u[row], style, label=label)
    for axes, unit in ((left, "deg"), (right, "V")):
        axes.set(xlabel="time (s)", ylabel=unit)
        axes.grid(alpha=0.3)
        axes.legend(frameon=False, fontsize="small")
    file = io.BytesIO()
    figure.savefig(file, format="png")
    return file.getvalue()


def short_repr(value: Any) -> str:
    """Constructor call of a dataclass, without arguments that equal their defaults."""
    parts = []
    for f in fields(value):
        default = f.default if f.default_factory is MISSING else f.default_factory()
        if getattr(value, f.name) != default:
            parts.append(f"{f.name}={getattr(value, f.name)!r}")
    return f"{type(value).__name__}({', '.join(parts)})"
