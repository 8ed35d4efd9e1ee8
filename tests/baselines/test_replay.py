"""The compiled replay agrees with scipy."""

import numpy as np
import pytest
from independent import inputs, replay
from numpy.testing import assert_allclose

from heli_gym import HelicopterParameters, Maneuver
from heli_gym.baselines import plan
from heli_gym.baselines.planning import replay as compiled


@pytest.mark.parametrize("requested", [Maneuver(), Maneuver(goal=(1.5, -0.2), duration=8.0)], ids=str)
def test_the_end_and_the_extremes_are_those_of_scipys_integrator(requested):
    trajectory = plan(requested)
    flown = replay(trajectory)
    end, lowest, highest = compiled.replay(
        trajectory.x[:, 0], inputs(trajectory.u), trajectory.t, HelicopterParameters()
    )
    assert_allclose(end, flown[:, -1], atol=2e-5)  # voltages have corners
    assert_allclose((lowest, highest), (flown[4].min(), flown[4].max()), atol=2e-3)  # of its own steps


def test_a_flight_of_other_parameters_ends_elsewhere():
    trajectory = plan(Maneuver())
    weaker = HelicopterParameters()._replace(b1=-0.6)
    end, *_ = compiled.replay(trajectory.x[:, 0], inputs(trajectory.u), trajectory.t, weaker)
    assert np.abs(end - trajectory.x[:, -1]).max() > 0.1
