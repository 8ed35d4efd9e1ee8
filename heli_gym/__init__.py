"""The 3-DOF laboratory helicopter of Kiefer, Graichen and Kugi as a Gymnasium environment.

Importing this package registers `Heli3DOF-v0`. It imports neither `heli_gym.baselines` nor `heli_gym.train`; both build
on it.
"""

import importlib
from typing import TYPE_CHECKING, Any

from gymnasium import register

from heli_gym.model import dynamics, linearise, thrust, voltage
from heli_gym.parameters import Coupling, HelicopterParameters, Limits
from heli_gym.plant import (
    PLANTS,
    Friction,
    Gust,
    MovingMass,
    OneOf,
    Plant,
    Push,
    RotorFault,
    Rotors,
    Sensors,
    Table,
    ThrustDrift,
    Uniform,
    find_plant,
)
from heli_gym.rig import Masses, Rig, find_rig
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustMap
from heli_gym.trajectory import Maneuver, Sampler, Trajectory

if TYPE_CHECKING:
    from heli_gym.env import Heli3DOFEnv, find_reference
    from heli_gym.vector_env import Heli3DOFVectorEnv

__all__ = [
    "PLANTS",
    "Coupling",
    "Friction",
    "Gust",
    "Heli3DOFEnv",
    "Heli3DOFVectorEnv",
    "HelicopterParameters",
    "Limits",
    "Maneuver",
    "Masses",
    "MovingMass",
    "OneOf",
    "Plant",
    "PowerCurve",
    "Push",
    "Rig",
    "RotorFault",
    "Rotors",
    "Sampler",
    "Sensors",
    "Table",
    "TableCurve",
    "ThrustDrift",
    "ThrustMap",
    "Trajectory",
    "Uniform",
    "dynamics",
    "find_plant",
    "find_reference",
    "find_rig",
    "linearise",
    "thrust",
    "voltage",
]

__version__ = "0.2.0"

register(
    id="Heli3DOF-v0",
    entry_point="heli_gym.env:Heli3DOFEnv",
    vector_entry_point="heli_gym.vector_env:Heli3DOFVectorEnv",
)

# Importing the environments loads the compiler, half of the import time: postponed until their first use.
LAZY = {"Heli3DOFEnv": "env", "find_reference": "env", "Heli3DOFVectorEnv": "vector_env"}


def __getattr__(name: str) -> Any:
    if name in LAZY:
        return getattr(importlib.import_module(f"heli_gym.{LAZY[name]}"), name)
    if name in LAZY.values():
        return importlib.import_module(f"heli_gym.{name}")
    raise AttributeError(f"module 'heli_gym' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *LAZY, *LAZY.values()})
