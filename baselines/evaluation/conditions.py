"""Conditions of leaderboards: plants, and plants with disturbances outside the design family."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from typing import Any

from heli_gym.plant import (
    AXES,
    NOMINAL_RIGS,
    Gust,
    OneOf,
    Plant,
    RotorFault,
    Uniform,
    at_choice,
    choices,
    common_choices,
    find_plant,
    parts_of,
)

OUTSIDE = "+outside"
# Magnitudes of our own choice, without a measurement behind them. For scale: `fleet` assumes Coulomb friction of up to
# 0.02 rad/s² on each axis, rotors of measured rigs differ by 2 to 10 %, and the plan accelerates travel by 0.48 rad/s².
COULOMB = (Uniform(0.0, 0.01), Uniform(0.0, 0.02), Uniform(0.0, 0.05))  # rad/s²: travel, elevation, pitch
WEAKER = Uniform(0.0, 0.06)  # share of the front rotor's thrust
GUSTS = (Gust("travel", 0.02), Gust("elevation", 0.02), Gust("pitch", 0.1))  # rad/s²


def find_condition(name: str | Plant) -> Plant:
    """Plant NAME, or "NAME+outside": with Coulomb friction, a front rotor weaker by up to 6 %, and gusts.

    Raises ValueError for an unknown name.
    """
    if not isinstance(name, str) or not name.endswith(OUTSIDE):
        return find_plant(name)
    plant = find_plant(name.removesuffix(OUTSIDE))
    travel, elevation, pitch = map(widened, plant.friction.coulomb, COULOMB)
    return replace(
        plant,
        friction=replace(plant.friction, coulomb=(travel, elevation, pitch)),
        disturbances=(*plant.disturbances, RotorFault("front", WEAKER), *GUSTS),
    )


def widened(value: Any, more: Uniform) -> Uniform:
    """Range of a number or a range, with the bounds of another range added."""
    low, high = (value.low, value.high) if isinstance(value, Uniform) else (value, value)
    return Uniform(low + more.low, high + more.high)


def nominal_rig(name: str | Plant, given: str | None = None) -> str:
    """Rig for which the controllers of a plant are designed: the given one if there is one, else the plant's."""
    if given:
        return given
    return NOMINAL_RIGS.get(name.removesuffix(OUTSIDE), "paper") if isinstance(name, str) else "paper"


UNITS = {  # of plant parameters, by the last word of their names
    "lag": "s",
    "thrust_loss": "",
    "viscous": "1/s",
    "coulomb": "rad/s²",
    "kappa": "m",
    "acceleration": "rad/s²",
    "strength": "rad/s²",
    "time": "s",
    "duration": "s",
    "noise": "rad",
}


def describe_draw(plant: Plant, draw: Plant) -> list[tuple[str, str]]:
    """Names and values of the random parameters in a draw of a plant."""
    counts, chosen = common_choices(plant), {}
    if counts:
        chosen = next((places for places in choices(plant) if fits(at_choice(plant, places), draw)), {})
        plant = at_choice(plant, chosen) if chosen else plant
    together = [(name, f"{place + 1} of {counts[name]}") for name, place in chosen.items()]
    return together + [(name.replace("_", " "), value) for name, value in random_values(plant, draw, "")]


def random_values(preset: Any, drawn: Any, name: str) -> Iterator[tuple[str, str]]:
    """Yield names and values of the random parameters, recursively through a plant and its draw."""
    if isinstance(preset, Uniform):
        unit = next((unit for word, unit in UNITS.items() if word in name), "")
        yield name, f"{drawn:.3g} {unit}".strip() + f" ({preset.low:g} to {preset.high:g})"
    elif isinstance(preset, OneOf):
        matching = [k for k, option in enumerate(preset.options) if fits(option, drawn)]
        if matching:
            yield name, f"{matching[0] + 1} of {len(preset.options)}"
            yield from random_values(preset.options[matching[0]], drawn, name)
    elif is_dataclass(preset):
        for f in fields(preset):
            yield from random_values(getattr(preset, f.name), getattr(drawn, f.name), f"{name} {f.name}".strip())
    elif isinstance(preset, tuple):
        names = getattr(preset, "_fields", AXES if len(preset) == len(AXES) else range(1, len(preset) + 1))
        for part_name, part, value in zip(names, preset, drawn):
            yield from random_values(part, value, f"{name} {part_name}")


def fits(preset: Any, drawn: Any) -> bool:
    """Whether a value is a possible draw of the preset."""
    if isinstance(preset, Uniform):
        return isinstance(drawn, float | int) and preset.low <= drawn <= preset.high
    if isinstance(preset, OneOf):
        return any(fits(option, drawn) for option in preset.options)
    parts = parts_of(preset)
    if not parts:
        return preset == drawn
    return type(preset) is type(drawn) and all(map(fits, parts, parts_of(drawn)))
