"""What leaderboards fly: plants, each also with disturbances that no controller was designed or tuned for."""

from dataclasses import replace

from heli_gym.plant import Friction, Gust, Plant, RotorFault, Uniform, find_plant

OUTSIDE = "+outside"
COULOMB = (Uniform(0.0, 0.01), Uniform(0.0, 0.02), Uniform(0.0, 0.05))  # rad/s², of travel, elevation and pitch
WEAKER = Uniform(0.0, 0.06)  # share of the front rotor's thrust
GUSTS = (Gust("travel", 0.02), Gust("elevation", 0.02), Gust("pitch", 0.1))  # rad/s²


def find_condition(name: str | Plant) -> Plant:
    """A plant, or "NAME+outside": with Coulomb friction, a front rotor weaker by up to 6 % and gusts as well.

    Raises ValueError for an unknown name.
    """
    if not isinstance(name, str) or not name.endswith(OUTSIDE):
        return find_plant(name)
    plant = find_plant(name.removesuffix(OUTSIDE))
    return replace(
        plant,
        friction=Friction(plant.friction.viscous, COULOMB),
        disturbances=(*plant.disturbances, RotorFault("front", WEAKER), *GUSTS),
    )
