"""The plants that the environment can fly."""

from dataclasses import dataclass, field

from heli_gym.parameters import HelicopterParameters


@dataclass(frozen=True)
class Plant:
    """What is flown: equation (3) with these parameters. Controllers are designed on the nominal ones only."""

    parameters: HelicopterParameters = field(default_factory=HelicopterParameters)


PLANTS = {"nominal": Plant()}


def find_plant(plant: str | Plant) -> Plant:
    """A plant by its name, or the plant itself. Raises ValueError for an unknown name."""
    if isinstance(plant, Plant):
        return plant
    if plant not in PLANTS:
        raise ValueError(f"plant = {plant!r}: a Plant or one of {', '.join(map(repr, PLANTS))} is needed")
    return PLANTS[plant]
