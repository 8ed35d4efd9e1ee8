"""Messages for infeasible maneuvers."""

import re

import numpy as np
import pytest

from heli_gym import HelicopterParameters, Limits, Maneuver, Trajectory
from heli_gym.baselines import plan
from heli_gym.baselines.planning.feasibility import infeasible, start_clock, validated

CLOCK = start_clock(Maneuver(), None)


def shortest(front, pitch_deg=40.0) -> Trajectory:
    """A plan with this pitch at most, the voltages at the front being these (K,) and hover at the back."""
    x = np.zeros((6, len(front)))
    x[4, 1] = np.radians(pitch_deg)
    return Trajectory(np.arange(float(len(front))), x, np.array([front, np.full(len(front), 7.9)]))


@pytest.mark.parametrize(
    ("front", "riding"),
    [
        ([7.9, 7.9, 7.9, 7.9], ""),
        ([7.9, 1.0, 7.9, 7.9], ", and its voltages ride on the lower limit 12% of the time"),
        ([7.9, 11.0, 11.0, 7.9], ", and its voltages ride on the upper limit 25% of the time"),
        (
            [1.0, 11.0, 11.0, 7.9],
            ", and its voltages ride on the lower limit 12% and on the upper limit 25% of the time",
        ),
    ],
)
def test_binding_limits_of_the_shortest_plan_are_exactly_those_at_a_limit(front, riding):
    error = infeasible(Maneuver(), shortest(front), CLOCK)
    assert str(error).endswith(f"; the shortest found takes 3.00 s: its pitch reaches 80% of its limit{riding}")
    assert error.shortest_duration == 3.0


@pytest.mark.parametrize(
    ("voltage", "said"), [(7.9, ""), (11.0, ": its voltages ride on the upper limit 50% of the time")]
)
@pytest.mark.parametrize("pitch_deg", [0.0, -1e-6])
def test_a_plan_without_pitch_has_no_binding_limit(voltage, said, pitch_deg):
    error = infeasible(Maneuver(), shortest(np.full(4, voltage), pitch_deg), CLOCK)
    assert str(error).endswith(f"; the shortest found takes 3.00 s{said}")


def test_where_no_plan_was_found_nothing_more_is_claimed():
    error = infeasible(Maneuver(), None, start_clock(Maneuver(), None))
    assert str(error) == f"no plan found for {Maneuver()}; the search found none in other durations either"
    assert error.shortest_duration is None


def test_a_plan_that_misses_the_goal_when_replayed_is_reported_as_that():
    plan_, clock = plan(Maneuver()), start_clock(Maneuver(), None)
    weaker = Maneuver(parameters=HelicopterParameters(c1=0.1))
    assert validated(weaker, plan_, clock) is None
    assert re.search(r"the plan, replayed, misses the goal by \d.*rad", str(infeasible(weaker, None, clock)))


def test_a_plan_that_exceeds_a_limit_is_reported_with_it():
    clock = start_clock(Maneuver(), None)
    assert validated(Maneuver(limits=Limits(u_max=10.5)), plan(Maneuver()), clock) is None
    assert clock.rejected == ["the plan's voltages exceed their limits by 0.5 V"]
