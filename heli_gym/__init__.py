"""The 3-DOF laboratory helicopter of Kiefer, Graichen and Kugi as a Gymnasium environment.

Importing it registers `Heli3DOF-v0`. It imports nothing else of ours; `heli_gym.baselines` and `heli_gym.train` build
on it.
"""

from gymnasium import register

from heli_gym.model import dynamics, linearise, thrust, voltage
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.rig import Masses, Rig, find_rig
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustMap
from heli_gym.trajectory import Maneuver, Trajectory

__all__ = [
    "HelicopterParameters",
    "Limits",
    "Maneuver",
    "Masses",
    "PowerCurve",
    "Rig",
    "TableCurve",
    "ThrustMap",
    "Trajectory",
    "dynamics",
    "find_rig",
    "linearise",
    "thrust",
    "voltage",
]

__version__ = "0.1.0"

register(
    id="Heli3DOF-v0",
    entry_point="heli_gym.env:Heli3DOFEnv",
    vector_entry_point="heli_gym.vector_env:Heli3DOFVectorEnv",
)
