"""Lead compensation: led voltages fly the plan on rotors with lag and dead time."""

import math

import numpy as np
import pytest
from independent import equation_2, equation_3
from numpy.testing import assert_array_equal
from scipy.integrate import solve_ivp

from heli_gym import Maneuver
from heli_gym.baselines import plan
from heli_gym.baselines.planning.lead import lead_voltages

LAG, DELAY = 0.1, 0.02


def miss(flown, planned) -> float:
    """Distance in rad or rad/s from the plan's end of a flight of rotors with lag and dead time, by scipy."""
    times = np.array(flown.t)

    def rhs(t, z):
        u = np.array([np.interp(t - DELAY, times, row) for row in flown.u])
        f_f, f_b = equation_2(z[6]), equation_2(z[7])
        return [*equation_3(z[:6], f_f + f_b, f_f - f_b, lib=math), *((u - z[6:]) / LAG)]

    start = np.concatenate((planned.x[:, 0], planned.u[:, 0]))
    end = solve_ivp(rhs, (0.0, times[-1]), start, rtol=1e-8, atol=1e-9, max_step=0.02).y[:6, -1]
    return float(np.abs(end - planned.x[:, -1]).max())


def test_the_open_loop_arrives_on_rotors_with_lag_and_dead_time():
    planned = plan(Maneuver(duration=10.0), "spline")
    led = lead_voltages(planned, LAG, DELAY)
    assert miss(led, planned) < 0.006
    assert miss(planned, planned) > 4.0 * miss(led, planned)


def test_without_lag_and_dead_time_the_voltages_are_the_plans():
    planned = plan(Maneuver(duration=13.0), "spline")
    assert_array_equal(lead_voltages(planned, 0.0, 0.0).u, planned.u)


def test_the_commands_are_the_amplifiers():
    planned = plan(Maneuver(duration=9.0), "spline")
    led = lead_voltages(planned, 0.3, 0.0)
    low, high = planned.rig.voltage_limits
    assert low <= led.u.min() <= led.u.max() <= high


@pytest.mark.parametrize("arguments", [{"lag": -1.0}, {"delay": math.nan}], ids=str)
def test_an_invalid_time_is_named(arguments):
    (name,) = arguments
    with pytest.raises(ValueError, match=f"{name} = "):
        lead_voltages(plan(Maneuver(duration=12.0)), **arguments)
