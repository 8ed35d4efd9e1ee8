"""The compiled replay agrees with scipy, and voltages linear between samples with thrusts."""

from dataclasses import replace

import numpy as np
import pytest
from independent import inputs, replay
from numpy.testing import assert_allclose

from heli_gym import HelicopterParameters, Limits, Maneuver, PowerCurve, TableCurve, ThrustMap, Trajectory, find_rig
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


CURVES = {
    "quadratic": PowerCurve(4.855e-3),
    "table": TableCurve((-1.0, 0.0, 4.0, 4.5, 12.0), (-0.01, 0.0, 0.01, 0.2, 0.7)),
}


def agile_plan(curve) -> Trajectory:
    """Voltages that jump from limit to limit within two samples, 1 ms apart."""
    t = np.linspace(0.0, 0.05, 51)
    u = np.where((np.arange(51) // 10 % 2 == 0) ^ np.array([[False], [True]]), 1.0, 11.0)
    u[:, ::10] = 6.0
    rig = replace(find_rig("paper"), thrust_map=ThrustMap(curve, curve))
    return Trajectory(t, np.zeros((6, 51)), u, Limits(), rig)


@pytest.mark.parametrize("kind", CURVES)
def test_with_more_samples_linear_voltages_are_linear_thrusts(kind):
    given = agile_plan(CURVES[kind])
    rig, fine = given.rig, np.linspace(0.0, 0.05, 50_001)

    def impulses(plan_):
        flown = rig.thrust(np.stack([np.interp(fine, plan_.t, row) for row in plan_.u]))
        planned = np.stack([np.interp(fine, given.t, row) for row in rig.thrust(given.u)])
        return np.abs(np.trapezoid(flown - planned, fine, axis=1)).max()

    denser = compiled.with_linear_thrusts(given)
    assert set(given.t) <= set(denser.t)
    assert_allclose(rig.thrust(denser(given.t)[1]), rig.thrust(given.u), atol=1e-12)
    assert impulses(denser) < 1e-2 * impulses(given)
    assert impulses(denser) < 10 * 50 * compiled.IMPULSE  # of 50 intervals; a table has corners between


def test_a_gentle_plan_stays_as_it_is():
    trajectory = plan(Maneuver())
    assert compiled.with_linear_thrusts(trajectory) is trajectory
