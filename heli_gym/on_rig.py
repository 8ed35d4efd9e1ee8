"""Adapt the plant and the reference of an environment to a rig, and reject plans for another rig."""

from dataclasses import replace
from typing import Any

from heli_gym.flatness import replanned
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import (
    DRAG_RATIO,
    LAB_ROTORS,
    NOMINAL_RIGS,
    PLANTS,
    Friction,
    OneOf,
    Plant,
    Sensors,
    Table,
    Uniform,
    find_plant,
    rotor_curves,
)
from heli_gym.rig import PAPER, Rig, body_of_masses, check_same_rig, find_rig, same_dynamics
from heli_gym.rigid_body import VARIANTS, solve_rigid_body
from heli_gym.thrust_map import PowerCurve, ThrustMap
from heli_gym.trajectory import Trajectory

TABLE_I = HelicopterParameters()


def plant_on_rig(plant: str | Plant, rig: Rig) -> Plant:
    """The plant on a rig: its coefficients and thrust map, unless the plant has its own, and its actuators and sensors.

    Rotors like those of `lab` get the rig's delay, and a lag drawn around the rig's; encoders like those of `lab` its
    counts, and a default table its elevation. "rigid" becomes the rigid body of the rig's masses or, for a rig without,
    the rigid bodies whose linearisation about hover has its coefficients. Raises ValueError if no such body exists.
    """
    found = find_plant(plant)
    changes: dict[str, Any] = {}
    if found.rotors == LAB_ROTORS:
        lag = LAB_ROTORS.lag
        share = rig.lag / PAPER.lag
        changes["rotors"] = replace(LAB_ROTORS, lag=Uniform(share * lag.low, share * lag.high), delay=rig.delay)
    if found.sensors == Sensors():
        changes["sensors"] = Sensors(rig.encoder_counts)
    if found.table == Table():
        changes["table"] = Table(rig.table_elevation)
    if not same_dynamics(rig, PAPER) and found.parameters == TABLE_I:
        changes["parameters"] = rig.parameters
        if not rig.thrust_map.is_quadratic and found.thrust_map is None:
            changes["thrust_map"] = rig.thrust_map
        if found.rig == PLANTS["rigid"].rig:
            changes["rig"] = rigid_bodies(rig)
            # the rigid-body equations lack the viscous friction of (3), so it moves into the plant's friction
            changes["friction"] = Friction(
                tuple(map(shift, found.friction.viscous, rig.parameters[-3:])),  # type: ignore[arg-type]
                found.friction.coulomb,
            )
    return replace(found, **changes) if changes else found


def rigid_bodies(rig: Rig) -> OneOf:
    """Rigid bodies of a rig: the one of its masses or, without masses, those with its coefficients.

    Raises ValueError, which names what to do, if there are none.
    """
    try:
        if rig.mass_data is not None:
            bodies: tuple = (body_of_masses(rig.mass_data),)
        else:
            bodies = tuple(solve_rigid_body(variant, rig.parameters) for variant in VARIANTS)
    except ValueError as error:
        raise ValueError(
            f"plant = 'rigid': must be 'nominal' or 'lab' on the rig {rig.name!r}: no rigid body of the usual lengths "
            "has its coefficients; a rig file with [masses] in place of [coefficients] has a rigid body of its own"
        ) from error
    return OneOf(tuple(body._replace(kappa=DRAG_RATIO) for body in bodies))


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
    if isinstance(plant.parameters, OneOf) or isinstance(plant.thrust_map, OneOf):
        return PAPER
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
        if not (same_dynamics(reference.rig, rig) and fits):
            return replanned(reference, rig)
    else:
        check_same_rig("reference", reference.rig, rig, "the environment's")
    # with the same coefficients and thrust map, actuators and sensors may differ: controllers read them from here
    return reference if reference.rig == rig else replace(reference, rig=rig)
