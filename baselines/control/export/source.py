"""C source under construction: literals in one precision, constants, arrays and templates."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

TEMPLATES = Path(__file__).parent / "c_code"
PRECISIONS: dict[str, type[np.floating]] = {"double": np.float64, "single": np.float32}
FUNCTIONS = ("sin", "cos", "atan2", "sqrt", "pow", "exp", "fabs", "tanh")

HEADER = """\
/* {title}. Written by heli-export; README.md has the signals, signs and units. */
#ifndef HELI_CONTROLLER_H
#define HELI_CONTROLLER_H

#ifdef __cplusplus
extern "C" {{
#endif

/* Before every flight. */
void heli_reset(void);

/* Every {period:g} s: voltages u (front, back) in V for the time t in s since the start of the reference and the
   measured state y: travel, elevation, pitch, each followed by its rate, in rad and rad/s. */
void heli_step({real} t, const {real} y[6], {real} u[2]);

#ifdef __cplusplus
}}
#endif

#endif
"""


class CSource:
    """C source under construction: settings, constant arrays and code in one precision."""

    def __init__(self, precision: str) -> None:
        if precision not in PRECISIONS:
            raise ValueError(f"precision = {precision!r}: must be one of {', '.join(map(repr, PRECISIONS))}")
        self.dtype = PRECISIONS[precision]
        self.suffix = "F" if precision == "single" else ""
        self.real = "float" if precision == "single" else "double"
        self.settings: dict[str, str] = {}
        self.arrays: list[str] = []
        self.code: list[str] = []

    def number(self, value: float) -> str:
        """C literal of a finite number. Raises ValueError otherwise."""
        if not math.isfinite(value):
            raise ValueError(f"number = {value!r}: must be finite to be exported")
        return f"{self.dtype(value).item()!r}{self.suffix}" if self.suffix == "" else self.short(value)

    def short(self, value: float) -> str:
        """Shortest single-precision literal that reads back as the value."""
        text = np.format_float_scientific(np.float32(value), unique=True, trim="0")
        return f"{text}{self.suffix}"

    def define(self, **settings: Any) -> None:
        """Add constants, floating-point or integer, by name."""
        for name, value in settings.items():
            whole = isinstance(value, bool | int | np.integer)
            self.settings[name] = str(int(value)) if whole else f"({self.number(float(value))})"

    def array(self, name: str, values: Any) -> None:
        """Add a constant array of one or two dimensions."""
        values = np.asarray(values, dtype=float)
        shape = "".join(f"[{n}]" for n in values.shape)
        rows = values if values.ndim == 2 else values[None]
        lines = [", ".join(map(self.number, row)) for row in rows]
        body = ",\n    ".join(f"{{{line}}}" for line in lines) if values.ndim == 2 else lines[0]
        self.arrays.append(f"static const real {name}{shape} = {{\n    {body}\n}};")

    def use(self, template: str, replacements: Mapping[str, str] | None = None) -> None:
        """Append a file of `c_code`, with text replacements."""
        text = (TEMPLATES / template).read_text(encoding="utf-8")
        for old, new in (replacements or {}).items():
            text = text.replace(old, new)
        self.code.append(text)

    def text(self, title: str) -> str:
        """Complete C source under a title comment."""
        common, *code = self.code
        include, _, rest = common.partition("#define LAST")
        functions = [f"#define {name.upper()} {name}{self.suffix.lower()}" for name in FUNCTIONS]
        literal = f"#define REAL(x) x{'##F' if self.suffix else ''}"
        settings = [f"#define {name} {value}" for name, value in self.settings.items()]
        head = f"/* {title}. Written by heli-export. */\n{include}"
        parts = [head, f"typedef {self.real} real;\n\n{literal}", "\n".join(functions), "\n".join(settings)]
        return "\n".join((*parts, "", *self.arrays, "", f"#define LAST{rest}", *code))
