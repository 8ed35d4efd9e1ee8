"""Conditions of tests that fly the packaged networks."""

import pytest

from heli_gym.baselines.control.residual import LEARNED, load_learned
from heli_gym.rig import Rig, check_same_rig, find_rig


def is_trained_for(name: str, rig: Rig) -> bool:
    """Whether the packaged network of a name was trained on that rig."""
    try:
        check_same_rig("network", Rig.from_toml(load_learned(LEARNED / name)[0].rig), rig, "the package's")
    except ValueError:
        return False
    return True


needs_fleet_network = pytest.mark.skipif(
    not is_trained_for("fleet", find_rig("fleet")), reason="the packaged network of the fleet is for another rig"
)
