"""What is said where no plan is found."""

import numpy as np
import pytest

from heli_gym import Maneuver, Trajectory
from heli_gym.baselines.planning.feasibility import infeasible


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
def test_of_the_shortest_plan_what_is_at_a_limit_is_told_and_nothing_else(front, riding):
    error = infeasible(Maneuver(), shortest(front))
    assert str(error).endswith(f"; the shortest found takes 3.00 s: its pitch reaches 80% of its limit{riding}")
    assert error.shortest_duration == 3.0


@pytest.mark.parametrize(
    ("voltage", "said"), [(7.9, ""), (11.0, ": its voltages ride on the upper limit 50% of the time")]
)
@pytest.mark.parametrize("pitch_deg", [0.0, -1e-6])
def test_of_a_plan_without_pitch_none_is_told(voltage, said, pitch_deg):
    error = infeasible(Maneuver(), shortest(np.full(4, voltage), pitch_deg))
    assert str(error).endswith(f"; the shortest found takes 3.00 s{said}")


def test_where_there_is_no_plan_at_all_that_is_said():
    error = infeasible(Maneuver(), None)
    assert str(error) == f"no plan for {Maneuver()}, nor for the same in any other time"
    assert error.shortest_duration is None
