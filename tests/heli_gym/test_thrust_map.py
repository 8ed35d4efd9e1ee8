"""Thrust curves against their definitions; thrust and voltage are inverses."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import HelicopterParameters, PowerCurve, Rig, TableCurve, ThrustMap, thrust
from heli_gym.compilation import jit_cached
from heli_gym.model import power_thrust, voltage

QUADRATIC = PowerCurve(4.855e-3, -1.503e-3)
LINEAR = PowerCurve(0.14, -0.14, 1.0)
POWERS = [
    QUADRATIC,
    LINEAR,
    PowerCurve(0.02, -0.01, 1.7),
    PowerCurve(0.3, -0.2, 0.5),
    PowerCurve(0.1, -0.05, 1.3, 0.8),
    PowerCurve(0.1, 0.0, 1.2),
]
TABLES = [
    TableCurve((-10.0, -4.0, 0.0, 3.0, 6.0, 12.0), (-0.2, -0.05, 0.0, 0.06, 0.25, 0.9)),
    TableCurve((0.0, 2.0, 2.5, 7.0, 12.0), (0.0, 0.1, 0.3, 0.5, 0.51)),
    TableCurve((-2.0, -1.0, 1.0, 5.0), (-0.4, 0.0, 0.0, 1.0)),
]
VOLTS = np.linspace(-14.0, 14.0, 561)


@pytest.mark.parametrize("curve", [*POWERS, *TABLES])
def test_thrust_of_the_voltage_of_a_thrust_is_that_thrust(curve):
    low = 0.0 if isinstance(curve, PowerCurve) and curve.k_minus == 0.0 else -0.6
    f = np.linspace(low, 1.5, 211)
    assert_allclose(curve.thrust(curve.voltage(f)), f, rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize("curve", [*POWERS, *TABLES])
def test_voltage_of_the_thrust_of_a_voltage_is_that_voltage_wherever_the_curve_rises(curve):
    rising = curve.slope(VOLTS) > 1e-6
    assert rising.sum() > 200
    assert_allclose(curve.voltage(curve.thrust(VOLTS))[rising], VOLTS[rising], rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("curve", [*POWERS, *TABLES])
def test_slope_is_the_derivative_of_the_thrust(curve):
    u = VOLTS + 0.0123  # off the corners
    numeric = (curve.thrust(u + 1e-6) - curve.thrust(u - 1e-6)) / 2e-6
    assert_allclose(curve.slope(u), numeric, rtol=1e-5, atol=1e-7)


@pytest.mark.parametrize("curve", [*POWERS, *TABLES])
def test_thrust_never_falls(curve):
    assert (np.diff(curve.thrust(VOLTS)) >= 0.0).all()


def test_exponent_two_is_equation_2():
    assert_allclose(QUADRATIC.thrust(VOLTS), thrust(VOLTS), rtol=1e-14, atol=1e-18)
    assert_allclose(QUADRATIC.slope(VOLTS)[VOLTS > 0], 2.0 * 4.855e-3 * VOLTS[VOLTS > 0], rtol=1e-12)


def test_exponent_one_is_linear_through_zero():
    assert_allclose(LINEAR.thrust(VOLTS), 0.14 * VOLTS, rtol=1e-14, atol=1e-16)
    assert_allclose(LINEAR.slope(np.array([-1.0, 0.0, 1.0])), 0.14, rtol=1e-14)


def test_within_the_dead_zone_nothing_thrusts():
    curve = POWERS[4]
    assert_array_equal(curve.thrust(np.array([-0.8, -0.3, 0.0, 0.5, 0.8])), 0.0)
    assert curve.thrust(np.array(1.8)) == pytest.approx(0.1)
    assert curve.voltage(1e-12) > 0.8


def test_a_fan_without_backward_thrust_gets_no_voltage_for_one():
    assert_array_equal(PowerCurve(0.1).voltage(np.array([-0.3, 0.0])), 0.0)
    assert_array_equal(voltage(np.array([-0.3, 0.0]), HelicopterParameters(k_minus=0.0)), 0.0)


@pytest.mark.parametrize("table", TABLES)
def test_a_table_passes_through_its_points_and_stays_between_neighbours(table):
    u, f = np.array(table.voltages), np.array(table.thrusts)
    assert_allclose(table.thrust(u), f, rtol=1e-14, atol=1e-16)
    between = table.thrust(np.linspace(u[:-1], u[1:], 11))
    assert ((f[:-1] - 1e-15 <= between) & (between <= f[1:] + 1e-15)).all()


def test_the_formula_of_the_power_laws_compiles_and_says_the_same():
    compiled = jit_cached(power_thrust)
    for curve in POWERS:
        mine = [compiled(u, *map(float, curve)) for u in VOLTS]
        assert_allclose(mine, curve.thrust(VOLTS), rtol=1e-13, atol=1e-16)


def test_front_and_back_rotor_have_curves_of_their_own():
    rig = Rig("mixed", thrust_map=ThrustMap(LINEAR, TABLES[0]), voltage_limits=(-8.0, 8.0))
    u = np.array([[3.0, 4.0], [5.0, -1.0]])
    f = rig.thrust(u)
    assert_allclose(f[0], LINEAR.thrust(u[0]))
    assert_allclose(f[1], TABLES[0].thrust(u[1]))
    assert_allclose(rig.voltage(f), u, atol=1e-12)
    least, most = rig.thrust_bounds((-8.0, 8.0))
    assert least == max(LINEAR.thrust(-8.0), TABLES[0].thrust(-8.0))
    assert most == min(LINEAR.thrust(8.0), TABLES[0].thrust(8.0))


@pytest.mark.parametrize(
    ("curve", "message"),
    [
        (PowerCurve(0.0), r"thrust_map.front.k_plus = 0.0: must be a positive"),
        (PowerCurve(0.1, 0.1), r"thrust_map.front.k_minus = 0.1: must be a negative"),
        (PowerCurve(0.1, -0.1, 2.5), r"thrust_map.front.exponent = 2.5: must be 0.5 to 2"),
        (PowerCurve(0.1, -0.1, 1.0, -1.0), r"thrust_map.front.dead_zone = -1.0: must be"),
        (PowerCurve(np.nan), r"thrust_map.front.k_plus = nan: must be a positive number, .*and finite"),
        (TableCurve((0.0, 1.0, 1.0), (0.0, 0.1, 0.2)), r"thrust_map.front.voltages = .*must rise"),
        (TableCurve((0.0, 1.0, 2.0), (0.0, 0.2, 0.1)), r"thrust_map.front.thrusts = .*must not fall"),
        (TableCurve((0.0, 1.0), (0.0,)), r"thrust_map.front.thrusts = .*as many"),
        ("linear", r"thrust_map.front = 'linear': must be a PowerCurve or a TableCurve"),
    ],
)
def test_curves_that_do_not_rise_are_refused_by_name(curve, message):
    with pytest.raises(ValueError, match=message):
        Rig("bad", thrust_map=ThrustMap(curve, LINEAR))
