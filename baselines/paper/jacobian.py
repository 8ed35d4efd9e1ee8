"""Derivatives of (3) in compiled loops: dual numbers through the unmodified `heli_gym.model.dynamics`.

Dual numbers are complex numbers with imaginary parts so small that terms of second order vanish in rounding.
"""

import math
from typing import Any

from heli_gym.model import dynamics
from heli_gym.parameters import HelicopterParameters

STEP = 1e-30  # imaginary part of the variable of differentiation


def dual_sin(z):
    """Sine of a dual number."""
    return complex(math.sin(z.real), math.cos(z.real) * z.imag)


def dual_cos(z):
    """Cosine of a dual number."""
    return complex(math.cos(z.real), -math.sin(z.real) * z.imag)


def jacobian_column(x: Any, v: Any, j: int, parameters: HelicopterParameters) -> tuple:
    """Derivatives (6,) of (3) by the j-th of its eight variables, the state x (6,) and the inputs v (2,).

    For a literal j, the compiler removes terms that vanish.
    """
    x = (
        complex(x[0], STEP if j == 0 else 0.0),
        complex(x[1], STEP if j == 1 else 0.0),
        complex(x[2], STEP if j == 2 else 0.0),
        complex(x[3], STEP if j == 3 else 0.0),
        complex(x[4], STEP if j == 4 else 0.0),
        complex(x[5], STEP if j == 5 else 0.0),
    )
    v = complex(v[0], STEP if j == 6 else 0.0), complex(v[1], STEP if j == 7 else 0.0)
    d = dynamics(x, v, parameters, dual_sin, dual_cos)
    return (
        (d[0] + 0j).imag / STEP,
        (d[1] + 0j).imag / STEP,
        (d[2] + 0j).imag / STEP,
        (d[3] + 0j).imag / STEP,
        (d[4] + 0j).imag / STEP,
        (d[5] + 0j).imag / STEP,
    )


def jacobian(x: Any, v: Any, parameters: HelicopterParameters) -> tuple:
    """All eight columns of `jacobian_column`, as a tuple (8, 6)."""
    return (
        jacobian_column(x, v, 0, parameters),
        jacobian_column(x, v, 1, parameters),
        jacobian_column(x, v, 2, parameters),
        jacobian_column(x, v, 3, parameters),
        jacobian_column(x, v, 4, parameters),
        jacobian_column(x, v, 5, parameters),
        jacobian_column(x, v, 6, parameters),
        jacobian_column(x, v, 7, parameters),
    )
