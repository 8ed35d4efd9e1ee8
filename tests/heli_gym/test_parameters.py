"""Parameters and limits are immutable, consistent values."""

import dataclasses
import math
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from heli_gym import HelicopterParameters, Limits
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP


def test_parameters_are_immutable():
    with pytest.raises(AttributeError):
        HelicopterParameters().b1 = 0.0


def test_a_variant_leaves_the_nominal_parameters_alone():
    nominal = HelicopterParameters()
    heavier = nominal._replace(b1=0.9 * nominal.b1)
    assert heavier.b1 == 0.9 * nominal.b1
    assert heavier[:5] + heavier[6:] == nominal[:5] + nominal[6:]
    assert nominal == HelicopterParameters()


def test_a_mistyped_parameter_is_an_error():
    with pytest.raises((TypeError, ValueError), match="b4"):  # TypeError from Python 3.13 on
        HelicopterParameters()._replace(b4=1.0)
    with pytest.raises(TypeError, match="u_maximum"):
        Limits(u_maximum=12.0)


def test_limits_are_immutable():
    with pytest.raises(dataclasses.FrozenInstanceError):
        Limits().u_max = 24.0


@pytest.mark.parametrize("value", [HelicopterParameters(b3=5.0), Limits(u_min=-2.0, pitch_max=1.0)])
def test_values_survive_pickle(value):
    assert pickle.loads(pickle.dumps(value)) == value


def test_windows_are_the_limits():
    limits = Limits(u_min=2.0, u_max=9.0, pitch_min=-0.4, pitch_max=0.7)
    assert limits.u == (2.0, 9.0)
    assert limits.pitch == (-0.4, 0.7)


def test_limits_are_printed_in_volts_and_degrees():
    assert (
        str(Limits(u_min=-3.0, u_max=10.5, pitch_min=math.radians(-25.0))) == "-3 to 10.5 V and -25 to 50 deg of pitch"
    )


@pytest.mark.parametrize("name", ["u_min", "u_max", "pitch_min", "pitch_max"])
@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_limit_that_is_not_finite_is_named(name, value):
    with pytest.raises(ValueError, match=f"{name} = {value}"):
        Limits(**{name: value})


@given(st.floats(-20.0, 20.0), st.floats(-20.0, 20.0))
def test_a_voltage_window_is_accepted_if_and_only_if_it_is_one(u_min, u_max):
    if u_max - u_min >= 1e-3:
        assert Limits(u_min=u_min, u_max=u_max).u == (u_min, u_max)
    else:
        with pytest.raises(ValueError, match=r"u_min = .* V and u_max = .* V"):
            Limits(u_min=u_min, u_max=u_max)


@pytest.mark.parametrize(
    ("pitch_min", "pitch_max"),
    [(0.1, 0.5), (-0.5, -0.1), (0.5, -0.5), (0.0, 0.5), (-0.5, 0.0), (-1.6, 0.5), (-0.5, 1.6), (-1e-300, 0.5)],
)
def test_a_pitch_window_without_zero_or_beyond_90_degrees_is_refused(pitch_min, pitch_max):
    with pytest.raises(ValueError, match=f"pitch_min = {pitch_min:g} rad and pitch_max = {pitch_max:g} rad"):
        Limits(pitch_min=pitch_min, pitch_max=pitch_max)


def test_the_planner_leaves_a_reserve_to_the_feedback():
    low, high = AMPLIFIER_LIMITS
    assert low < Limits().u_min < Limits().u_max < high
    assert -PITCH_STOP < Limits().pitch_min < Limits().pitch_max < PITCH_STOP < math.pi / 2
