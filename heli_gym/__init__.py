"""The 3-DOF laboratory helicopter of Kiefer, Graichen and Kugi as a Gymnasium environment."""

from heli_gym.model import dynamics, linearise, thrust, voltage
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.trajectory import Maneuver, Trajectory

__all__ = ["HelicopterParameters", "Limits", "Maneuver", "Trajectory", "dynamics", "linearise", "thrust", "voltage"]
