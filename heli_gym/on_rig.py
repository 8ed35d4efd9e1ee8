"""Adapt the plant and the reference of an environment to a rig, and reject plans for another rig."""

from dataclasses import replace
from typing import Any

from heli_gym.flatness import replanned
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import DRAG_RATIO, NOMINAL_RIGS, PLANTS, Friction, OneOf, Plant, Uniform, find_plant, rotor_curves
from heli_gym.rig import PAPER, Rig, check_same_rig, find_rig, same_dynamics
from heli_gym.rigid_body import VARIANTS, solve_rigid_body
from heli_gym.thrust_map import PowerCurve, ThrustMap
from heli_gym.trajectory import Trajectory

TABLE_I = HelicopterParameters()


def plant_on_rig(plant: str | Plant, rig: Rig) -> Plant:
    """The plant with a rig's coefficients and thrust map; a plant with its own coefficients is returned unchanged.

    "rigid" becomes the rigid bodies whose linearisation about hover has the rig's coefficients. Raises ValueError if
    no such body exists.
    """
    found = find_plant(plant)
    if same_dynamics(rig, PAPER) or found.parameters != TABLE_I:
        return found
    changes: dict[str, Any] = {"parameters": rig.parameters}
    if not rig.thrust_map.is_quadratic and found.thrust_map is None:
        changes["thrust_map"] = rig.thrust_map
    if found.rig == PLANTS["rigid"].rig:
        try:
            bodies = tuple(solve_rigid_body(variant, rig.parameters)._replace(kappa=DRAG_RATIO) for variant in VARIANTS)
        except ValueError as error:
            raise ValueError(f"plant = 'rigid': must be another on the rig {rig.name!r}, of whose {error}") from error
        changes["rig"] = OneOf(bodies)
        # the rigid-body equations lack the viscous friction of (3), so it moves into the plant's friction
        changes["friction"] = Friction(
            tuple(map(shift, found.friction.viscous, rig.parameters[-3:])),  # type: ignore[arg-type]
            found.friction.coulomb,
        )
    return replace(found, **changes)


def shift(value: Any, by: float) -> Any:
    """A number or a range, increased by a constant."""
    return Uniform(value.low + by, value.high + by) if isinstance(value, Uniform) else value + by


def rig_to_fly(rig: Any, plant: Plant, reference: Any) -> Rig:
    """The rig of an environment: the given one, else the reference's if the plant has its model, else the preset's."""
    if rig is not None:
        return find_rig(rig)
    preset = next((name for name, known in PLANTS.items() if known is plant), "nominal")
    if NOMINAL_RIGS[preset] != PAPER.name:
        return find_rig(NOMINAL_RIGS[preset])
    own = reference.rig if isinstance(reference, Trajectory) else PAPER
    is_own = own.parameters[2:] == plant.parameters[2:] and plant_thrust_map(plant) == own.thrust_map
    return own if is_own else PAPER


def plant_thrust_map(plant: Plant) -> ThrustMap:
    """Thrust map of the plant: its own, or (2) with its coefficients."""
    curve = PowerCurve(plant.parameters.k_plus, plant.parameters.k_minus)
    return ThrustMap(*(own or curve for own in rotor_curves(plant.thrust_map)))


def reference_on_rig(reference: Any, rig: Rig, is_packaged: bool) -> Any:
    """The reference if it is for the rig; a packaged one is planned again for a rig that cannot fly it.

    Raises ValueError, which names the differences, for a plan for another rig.
    """
    if not isinstance(reference, Trajectory):
        own = getattr(reference, "rig", None)
        if isinstance(own, Rig):
            check_same_rig("reference", own, rig, "the environment's")
        return reference
    if is_packaged:
        (low, high), within = rig.voltage_limits, rig.pitch_limit
        u, pitch = reference.u, reference.x[4]
        fits = low <= u.min() and u.max() <= high and abs(pitch).max() <= within
        return reference if same_dynamics(reference.rig, rig) and fits else replanned(reference, rig)
    check_same_rig("reference", reference.rig, rig, "the environment's")
    return reference
