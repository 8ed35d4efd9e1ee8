"""Contents of a picture, as plain values: the flight at one instant, its reference and its limits."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP, Limits
from heli_gym.rig import PAPER, Rig


class RenderState(NamedTuple):
    """Contents of a picture at one instant, in rad, rad/s, V and s."""

    state: Sequence[float]  # (6,), the order of (44)
    voltage: Sequence[float]  # (2,), front and back
    reference: Sequence[float]  # (6,), drawn as the ghost
    nominal_voltage: Sequence[float]  # (2,)
    time: float
    duration: float
    travel_start: float = 0.0  # travel at the start of the maneuver
    limits: Limits = Limits()  # of the plan
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    pitch_limit: float = PITCH_STOP  # where the flight ends
    rig: Rig = PAPER  # whose thrust map and signs of angles the picture shows
    title: str = ""
    note: str = ""  # below the title, as a warning


def in_space(scene: RenderState) -> RenderState:
    """The scene with the paper's signs of the angles, for a rig whose coefficients imply others.

    Thrust then lifts the arm (b2 < 0), more thrust in front raises the front rotor (b3 > 0), and a raised front rotor
    turns the arm clockwise (b1 < 0).
    """
    p = scene.rig.parameters
    pitch, elevation = (1.0 if p.b3 > 0.0 else -1.0), (1.0 if p.b2 < 0.0 else -1.0)
    travel = pitch if p.b1 < 0.0 else -pitch
    signs = np.repeat((travel, elevation, pitch), 2)
    pitches = sorted(pitch * limit for limit in scene.limits.pitch)
    return scene._replace(
        state=(signs * scene.state).tolist(),
        reference=(signs * scene.reference).tolist(),
        travel_start=travel * scene.travel_start,
        limits=replace(scene.limits, pitch_min=pitches[0], pitch_max=pitches[1]),
    )


def travel_interval(scene: RenderState) -> tuple[float, float]:
    """Interval of travel in rad flown since the start, at most one turn."""
    start, now = scene.travel_start, scene.state[0]
    return start, start + min(max(now - start, -2.0 * math.pi), 2.0 * math.pi)
