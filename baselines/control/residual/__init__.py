"""Learned correction of a controller: its law, features, networks and files, and the wrappers in which it learns.

Modules import what `control` imports; `action` imports the registry, which imports the others.
"""

from heli_gym.baselines.control.residual.features import (
    AHEAD,
    DISTURBANCE_SCALE,
    FEATURE_CLIP,
    FEATURE_GROUPS,
    INTEGRAL_SCALE,
    STATE_SCALE,
)
from heli_gym.baselines.control.residual.files import LEARNED, Learned, learned_policy, load_learned, save_learned
from heli_gym.baselines.control.residual.networks import CELL, Network, RecurrentNetwork
from heli_gym.baselines.control.residual.policy import LAWS, ResidualPolicy

__all__ = [
    "AHEAD",
    "CELL",
    "DISTURBANCE_SCALE",
    "FEATURE_CLIP",
    "FEATURE_GROUPS",
    "INTEGRAL_SCALE",
    "LAWS",
    "LEARNED",
    "STATE_SCALE",
    "Learned",
    "Network",
    "RecurrentNetwork",
    "ResidualPolicy",
    "learned_policy",
    "load_learned",
    "save_learned",
]
