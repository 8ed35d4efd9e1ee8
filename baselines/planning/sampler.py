"""Sampler of maneuvers for the argument `reference` of an environment: a new plan in every episode."""

import math
from dataclasses import dataclass, field

import numpy as np

from heli_gym.baselines.planning import spline_search
from heli_gym.baselines.planning.feasibility import InfeasibleManeuver, validated
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.rig import Rig
from heli_gym.trajectory import Maneuver, Trajectory
from heli_gym.validation import real_array, shown

DRAWS = 200  # largest number until a plan is found


@dataclass(frozen=True)
class ManeuverSampler:
    """Plans of random transitions of one duration; calling it with a random generator draws one.

    Each plan is the smoothest one of `spline`, validated like those of `plan`; a transition without a plan is drawn
    again. A sampler is a plain value: it can be compared, pickled, and sent to other processes.

    Args:
        duration: of every plan, in s.
        travel: range of the travel, in rad; it starts at zero.
        elevation: range of the elevations at the start and at the goal, in rad.
        limits: limits of the plans; the defaults leave the feedback a reserve to (9).
        parameters: parameters of the helicopter, if no rig is given.
        rig: the rig that flies; limits must be within its own.

    Raises:
        ValueError: if a range is not finite or reversed, or hover at an elevation in it exceeds the limits.
    """

    duration: float = 12.0
    travel: tuple[float, float] = (-2.0 * math.pi, 2.0 * math.pi)
    elevation: tuple[float, float] = (-math.radians(8.0), math.radians(8.0))
    limits: Limits = field(default_factory=lambda: Limits(2.0, 10.5, -math.radians(40.0), math.radians(40.0)))
    parameters: HelicopterParameters = field(default_factory=HelicopterParameters)
    rig: Rig | None = None

    def __post_init__(self) -> None:
        for name in ("travel", "elevation"):
            ends = real_array(getattr(self, name))
            if ends is None or ends.shape != (2,) or not -math.inf < ends[0] <= ends[1] < math.inf:
                raise ValueError(f"{name} = {shown(getattr(self, name))}: must be finite (low, high) in rad")
        for corner in self.elevation:
            self.maneuver(self.travel[1], corner, corner)  # raises ValueError without hover

    def maneuver(self, travel: float, start: float, goal: float) -> Maneuver:
        """Maneuver by a travel, between two elevations, all in rad."""
        parameters = self.parameters if self.rig is None else None
        return Maneuver((0.0, start), (travel, goal), self.duration, self.limits, parameters, self.rig)  # type: ignore

    def __call__(self, rng: np.random.Generator) -> Trajectory:
        """Plan a random transition. Raises InfeasibleManeuver if DRAWS of them have no plan in this duration."""
        for _ in range(DRAWS):
            # numpy refuses the range from 0.0 to -0.0
            travel, elevation = (np.add(ends, 0.0) for ends in (self.travel, self.elevation))
            start, goal = rng.uniform(elevation[0], elevation[1], size=2)
            maneuver = self.maneuver(rng.uniform(travel[0], travel[1]), start, goal)
            if exceeds_path_limits(maneuver):
                continue  # the planner would find out a hundred times slower
            trajectory = validated(maneuver, spline_search.plan_smoothest(maneuver))
            if trajectory is not None:
                return trajectory
        raise InfeasibleManeuver(
            f"none of {DRAWS} draws of {self} could be planned; a longer duration or a smaller travel is easier"
        )


def exceeds_path_limits(maneuver: Maneuver) -> bool:
    """Whether the ends of a transition are outside its limits of elevation, or its mean rates above those of rates."""
    limits, (travel, rise) = maneuver.limits, np.abs(np.subtract(maneuver.goal, maneuver.start))
    elevations = maneuver.start[1], maneuver.goal[1]
    return (
        (limits.elevation_min is not None and min(elevations) < limits.elevation_min)
        or (limits.elevation_max is not None and max(elevations) > limits.elevation_max)
        or (limits.travel_rate is not None and travel > limits.travel_rate * maneuver.duration)
        or (limits.elevation_rate is not None and rise > limits.elevation_rate * maneuver.duration)
    )
