"""Rigs: packaged ones, files in both forms, conversion to masses and back, invalid values."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
import tomli_w
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import (
    HelicopterParameters,
    Limits,
    Maneuver,
    Masses,
    PowerCurve,
    Rig,
    TableCurve,
    ThrustMap,
    find_rig,
    thrust,
)
from heli_gym.model import hover_input, linearise, voltage
from heli_gym.rig import COEFFICIENTS, PAPER, RIGS, coefficients_from_masses, rig_names
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics

LAB = {"arm": 0.6604, "counterweight_arm": 0.4699, "rotor_arm": 0.1778}


def test_the_packaged_rigs_are_named_and_say_where_they_are_from():
    assert {"paper", "quanser", "ntnu"} <= set(rig_names())
    for name in rig_names():
        assert find_rig(name).name == name
        assert len(find_rig(name).source) > 40


def test_the_papers_rig_is_table_i_with_the_limits_9():
    rig = find_rig("paper")
    assert rig == PAPER
    assert rig.parameters == HelicopterParameters()
    assert rig.limits == Limits()
    u = np.linspace(-12.0, 12.0, 101) * np.array([[1.0], [0.7]])
    assert_array_equal(rig.thrust(u), thrust(u))
    assert_array_equal(rig.voltage(rig.thrust(u)), voltage(thrust(u)))


def test_quansers_published_linear_model_follows_from_its_rig():
    rig = find_rig("quanser")
    A, B = linearise(np.zeros(6), hover_input(0.0, rig.parameters), rig.parameters)
    per_volt = B @ np.array([[1.0, 1.0], [1.0, -1.0]]) @ np.diag(rig.thrust_slope(rig.hover_voltage()))
    assert_allclose(np.abs(per_volt[3]), 0.0858, atol=5e-5)  # rad/s² per V, of each rotor on elevation
    assert_allclose(np.abs(per_volt[5]), 0.5810, atol=5e-5)  # on pitch
    assert A[1, 4] == pytest.approx(-1.2304, abs=5e-4)  # rad/s² per rad of pitch
    assert_allclose(rig.hover_voltage(), 7.46, atol=0.01)


def test_the_ntnu_rig_hovers_at_a_sum_of_six_to_eight_volts():
    assert 6.0 < find_rig("ntnu").hover_voltage().sum() < 8.0


@pytest.mark.parametrize("name", ["paper", "quanser", "ntnu"])
def test_hover_voltage_holds_the_rig_at_rest(name):
    rig = find_rig(name)
    f = rig.thrust(rig.hover_voltage(0.1))
    assert_allclose([f.sum(), f[0] - f[1]], hover_input(0.1, rig.parameters), atol=1e-14)


def test_a_rig_is_immutable_and_hashable():
    with pytest.raises(AttributeError):
        PAPER.lag = 0.2
    assert len({PAPER, find_rig("paper"), find_rig("ntnu")}) == 2


# Masses


def test_coefficients_are_those_of_the_rigid_body_about_level_hover_with_each_axis_on_its_own():
    masses = Masses(1.3, 1.8, 0.66, 0.46, 0.17, 0.16, 0.01, 0.03, 0.02)
    p = HelicopterParameters()._replace(**coefficients_from_masses(masses))
    m, M, l, L, lp, r, d, D, e, g, *_ = masses  # noqa: E741
    body = RigidBodyParameters(l, lp, L, g, m, M, r, d, D, e, kappa=0.0)
    v = hover_input(0.0, p)
    h = 1e-6
    elevation = [rigid_dynamics((0, 0, q, 0, 0, 0), v, body)[3] for q in (-h, h)]
    assert (elevation[1] - elevation[0]) / (2 * h) == pytest.approx(p.a1, rel=1e-6)
    assert rigid_dynamics((0,) * 6, np.zeros(2), body)[3] == pytest.approx(p.a2, rel=1e-12)
    assert rigid_dynamics((0,) * 6, v, body)[3] == pytest.approx(0.0, abs=1e-14)


@given(
    body=st.floats(0.5, 3.0),
    excess=st.floats(0.01, 0.2),
    arm=st.floats(0.4, 0.9),
    counterweight_arm=st.floats(0.3, 0.6),
    rotor_arm=st.floats(0.1, 0.25),
    share=st.floats(0.5, 1.1),
    body_drop=st.floats(0.0, 0.02),
    hinge_height=st.floats(-0.1, 0.1),
)
@settings(max_examples=100, deadline=None)
def test_masses_to_coefficients_and_back(
    body, excess, arm, counterweight_arm, rotor_arm, share, body_drop, hinge_height
):
    counterweight = (1.0 - excess) * body * arm / counterweight_arm
    given_masses = Masses(
        body, counterweight, arm, counterweight_arm, rotor_arm, share * rotor_arm, body_drop, 0.0, hinge_height
    )
    linear = ThrustMap(PowerCurve(0.5, -0.5, 1.0), PowerCurve(0.5, -0.5, 1.0))
    values = {"thrust_map": linear, "voltage_limits": (-20.0, 20.0)}
    rig = Rig.from_masses("mine", given_masses, **values)
    found = [rig.masses(arm, counterweight_arm, rotor_arm, variant=variant) for variant in "AB"]
    for masses in found:
        again = Rig.from_masses("mine", masses, **values)
        assert_allclose(again.parameters[2:], rig.parameters[2:], rtol=1e-9, atol=1e-9)
    assert_allclose([m.body for m in found], body, rtol=1e-9)
    assert_allclose([m.counterweight for m in found], counterweight, rtol=1e-9)
    heights = [(m.counterweight_drop, m.hinge_height) for m in found]
    assert min(np.abs(np.subtract(h, (0.0, hinge_height))).max() for h in heights) < 1e-6


def test_the_masses_of_the_papers_rig_are_those_of_the_rigid_body():
    masses = PAPER.masses(**LAB)
    assert masses.body == pytest.approx(1.3666, abs=5e-5)
    assert masses.counterweight == pytest.approx(1.8339, abs=5e-5)
    again = Rig.from_masses("paper", masses, limits=Limits(), source=PAPER.source)
    assert_allclose(again.parameters, PAPER.parameters, rtol=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"body": 0.0}, r"masses.body = 0.0: must be a positive number of kg"),
        ({"counterweight": -1.0}, r"masses.counterweight = -1.0: must be a positive number of kg"),
        ({"arm": math.nan}, r"masses.arm = nan: must be a positive number of m"),
        ({"gyration_radius": 0.0}, r"masses.gyration_radius = 0.0"),
        ({"c1": math.inf}, r"masses.c1 = inf"),
        ({"body": 1.0}, r"voltage_limits = .*must permit hover"),  # the counterweight is the heavier side
        ({"body": 5.0}, r"voltage_limits = .*must permit hover"),
    ],
)
def test_masses_that_make_no_rig_are_refused_by_name(change, message):
    masses = PAPER.masses(**LAB)._replace(**change)
    with pytest.raises(ValueError, match=message):
        Rig.from_masses("mine", masses)


# Values


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"parameters": HelicopterParameters(b1=0.0)}, r"parameters.b1 = 0.0: must be a number other than 0"),
        ({"parameters": HelicopterParameters(a1=math.nan)}, r"parameters.a1 = nan: must be a number, and finite"),
        ({"parameters": HelicopterParameters(c2=-0.1)}, r"parameters.c2 = -0.1: must be a number, at least 0"),
        ({"parameters": HelicopterParameters(a2=3.0)}, r"voltage_limits = 0 to 12 V: must permit hover"),
        ({"parameters": HelicopterParameters(a2=-0.3)}, r"voltage_limits = 0 to 12 V: must permit hover"),
        ({"parameters": "paper"}, r"parameters = 'paper': must be HelicopterParameters"),
        ({"voltage_limits": (5.0, 5.0)}, r"voltage_limits = \(5.0, 5.0\): must be"),
        ({"voltage_limits": (0.0, math.nan)}, r"voltage_limits = \(0.0, nan\): must be"),
        ({"voltage_limits": (0.0, 5.0)}, r"voltage_limits = 0 to 5 V: must permit hover"),
        ({"voltage_limits": (2.0, 10.0), "limits": Limits()}, r"limits = .*within the amplifier's voltage_limits"),
        ({"limits": Limits(1.0, 6.0)}, r"limits = 1 to 6 V: must permit hover"),
        ({"pitch_limit": 0.5, "limits": Limits()}, r"limits = .*within pitch_limit"),
        ({"pitch_limit": 0.0}, r"pitch_limit = 0.0: must be more than 0"),
        ({"pitch_limit": "wide"}, r"pitch_limit = 'wide': must be"),
        ({"table_elevation": 2.0}, r"table_elevation = 2.0: must be"),
        ({"encoder_counts": (4096, 4096)}, r"encoder_counts = \(4096, 4096\): must be"),
        ({"encoder_counts": (4096, 0, 4096)}, r"encoder_counts = 0: must be positive whole numbers"),
        ({"sample_time": 0.0}, r"sample_time = 0.0: must be"),
        ({"lag": -0.1}, r"lag = -0.1: must be"),
        ({"delay": math.inf}, r"delay = inf: must be"),
        ({"sensor_signs": (1, 2, 1)}, r"sensor_signs = 2: must be"),
        ({"sensor_zeros": (0.0, math.nan, 0.0)}, r"sensor_zeros = nan: must be"),
        ({"parameters": HelicopterParameters(k_plus=1e300)}, r"thrust_map.front.k_plus = 1e\+300: must be a positive"),
        ({"parameters": HelicopterParameters(k_minus=-1e300)}, r"thrust_map.front.k_minus = -1e\+300: must be a neg"),
        (
            {"thrust_map": ThrustMap(*[PowerCurve(1.0, dead_zone=1e9)] * 2)},
            r"thrust_map.front.dead_zone = 1000000000.0",
        ),
        ({"parameters": HelicopterParameters(k_plus=3.5)}, r"limits = .*thrust_map, k_plus = 3.5, gives 3.5"),
        ({"thrust_map": 3}, r"thrust_map = 3: must be a ThrustMap"),
        ({"limits": (1.0, 11.0)}, r"limits = \(1.0, 11.0\): must be Limits"),
        ({"name": 3}, r"name = 3: must be text"),
    ],
)
def test_values_that_make_no_rig_are_refused_by_name(values, message):
    with pytest.raises(ValueError, match=message):
        Rig(**{"name": "mine", **values})


def test_limits_of_plans_leave_the_papers_share_of_amplifier_and_pitch_by_default():
    rig = Rig("mine")
    assert_allclose(rig.limits.u + rig.limits.pitch, Limits().u + Limits().pitch, rtol=1e-14)


def test_differences_name_fields_with_both_values():
    other = Rig("mine", HelicopterParameters(b1=-0.5), lag=0.2)
    assert PAPER.differences(other) == ["b1 -0.6354 and -0.5", "lag 0.1 and 0.2"]
    assert PAPER.differences(Rig("the same", limits=Limits(2.0, 10.0))) == []


# Files

FORM = """\
name = "mine"

[masses]
body = 1.44
counterweight = 1.92
arm = 0.66
counterweight_arm = 0.46
rotor_arm = 0.175

[thrust.front]
voltages = [-10, 0, 10]
thrusts = [-1, 0, 1.5]

[thrust.back]
k_plus = 0.14
k_minus = -0.1
exponent = 1.0

[actuator]
voltage_limits = [-10, 10]

[sensors]
signs = [1, -1, 1]
zeros_deg = [0, 30, 0]
"""


def test_a_file_of_masses_is_the_rig_of_these_masses():
    rig = Rig.from_toml(FORM)
    curves = ThrustMap(TableCurve((-10.0, 0.0, 10.0), (-1.0, 0.0, 1.5)), PowerCurve(0.14, -0.1, 1.0))
    assert rig == Rig.from_masses(
        "mine",
        Masses(1.44, 1.92, 0.66, 0.46, 0.175),
        thrust_map=curves,
        voltage_limits=(-10.0, 10.0),
        sensor_signs=(1, -1, 1),
        sensor_zeros=(0.0, math.radians(30.0), 0.0),
    )


@pytest.mark.parametrize("rig", [*rig_names(), FORM])
def test_saved_values_are_loaded_exactly(rig, tmp_path):
    rig = find_rig(rig) if rig in rig_names() else Rig.from_toml(rig)
    rig.save(tmp_path / "rig.toml")
    loaded = Rig.load(tmp_path / "rig.toml")
    assert loaded == rig == find_rig(tmp_path / "rig.toml")
    assert loaded.source == rig.source


def test_optional_limits_survive_a_file():
    limits = Limits(elevation_min=-0.2, elevation_max=math.radians(7.0), travel_rate=1.2, elevation_rate=0.3, slew=20.0)
    for some in (limits, Limits(slew=15.0), Limits(elevation_max=0.1)):
        rig = replace(PAPER, limits=some)
        assert Rig.from_toml(rig.to_toml()).limits == some
        assert Maneuver(rig=Rig.from_toml(rig.to_toml())).limits == some
    text = replace(PAPER, limits=limits).to_toml()
    assert "elevation_max_deg = 7.0" in text
    with pytest.raises(ValueError, match=r"line \d+: slew = -20.0: must be positive"):
        Rig.from_toml(text.replace("slew = 20.0", "slew = -20.0"))
    with pytest.raises(ValueError, match=r"line \d+: unknown key 'speed' in \[limits\]"):
        Rig.from_toml(text.replace("slew", "speed"))


def test_a_sensor_reads_its_offset_times_its_sign_at_an_angle_of_zero():
    rig = replace(PAPER, sensor_signs=(1, -1, 1), sensor_zeros=(0.1, 0.48, -0.2))
    readings = np.array(rig.sensor_zeros)  # angle = sign * (reading - zero)
    assert rig.sensor_offsets == tuple(np.array(rig.sensor_signs) * readings)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("body = 1.44\n", "", r"line 3: \[masses\] lacks the key 'body'"),
        ("rotor_arm", "rotor_lenght", r"line 8: unknown key 'rotor_lenght' in \[masses\]"),
        ("thrusts = ", "thrust = ", r"line 12: unknown key 'thrust' in \[thrust.front\]"),
        ("k_plus = 0.14\n", "", r"line 14: \[thrust.back\] lacks the key 'k_plus'"),
        ("exponent = 1.0", "exponent = 'one'", r"line 17: exponent = 'one': must be a number"),
        ('name = "mine"', 'title = "mine"', r"line 1: unknown key 'title'"),
        ("[actuator]", "[amplifier]", r"line 19: unknown key 'amplifier'"),
        ("[masses]", "[coefficients]", r"line 4: unknown key 'body' in \[coefficients\]"),
        ("[thrust.front]", "[thrust.left]", r"line 10: unknown key 'left' in \[thrust\]"),
        ("zeros_deg = [0, 30, 0]", "zeros_deg = 'none'", r"line 24: zeros_deg = 'none'"),
        ("zeros_deg = [0, 30, 0]", "zeros_deg = [0, 30 0]", r"no TOML: .*line 24"),
        ("zeros_deg = [0, 30, 0]", "zeros_deg = [0, 30", r"no TOML: .*at end of document"),
        ("body = 1.44", "body = -1.44", r"masses.body = -1.44: must be a positive number of kg"),
        ("voltage_limits = [-10, 10]", "voltage_limits = 10", r"voltage_limits = 10: must be two finite numbers"),
    ],
)
def test_an_error_in_a_file_is_named_with_its_line(old, new, message, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(FORM.replace(old, new, 1))
    with pytest.raises(ValueError, match=message) as raised:
        find_rig(path)
    assert "mine.toml" in str(raised.value)


@pytest.mark.parametrize("bad", ["unknown", "missing.toml", 3, None, ""])
def test_an_unknown_rig_is_refused_by_name(bad):
    with pytest.raises(ValueError, match="rig = "):
        find_rig(bad)


MINE = {
    "name": "mine",
    "pitch_limit_deg": 30.0,
    "table_elevation_deg": 20.0,
    "actuator": {"voltage_limits": [-24.0, 24.0], "lag": 0.1, "delay": 0.02},
    "sensors": {
        "encoder_counts": [4096, 4096, 4096],
        "sample_time": 0.01,
        "signs": [1, -1, 1],
        "zeros_deg": [0.0, 5.0, 0.0],
    },
    "limits": {"u_min": -20.0, "u_max": 20.0, "pitch_min_deg": -15.0, "pitch_max_deg": 15.0},
}
OF_COEFFICIENTS = MINE | {
    "coefficients": {"a1": -1.1, "a2": 0.4, "a3": -0.5, "b1": -0.6, "b2": -0.6, "b3": 4.0, "c1": 0.1},
    "thrust": {"k_plus": 0.1, "k_minus": -0.05, "exponent": 1.2, "dead_zone": 0.5},
}
OF_MASSES = MINE | {
    "masses": {"body": 1.6, "counterweight": 2.05, "arm": 0.7, "counterweight_arm": 0.48, "rotor_arm": 0.19, "c1": 0.1},
    "thrust": {"front": {"voltages": [-24.0, 0.0, 24.0], "thrusts": [-1.4, 0.0, 3.1]}, "back": {"k_plus": 0.11}},
}
NOT_ALLOWED = [math.nan, math.inf, -math.inf, "text", True, [1.0], 1e300, -1e300, -1.0, 0.0, 1e-320]


def paths(tables, above=()):
    """Paths of all tables and keys in a file."""
    for key, value in tables.items():
        yield (*above, key)
        if isinstance(value, dict):
            yield from paths(value, (*above, key))


FIELDS = [(form, path) for form in (OF_COEFFICIENTS, OF_MASSES) for path in paths(form)]


def changed(tables, path, value):
    """Tables of a file with one value replaced, or removed for None."""
    key, *rest = path
    if rest:
        return tables | {key: changed(tables[key], rest, value)}
    return {k: v for k, v in tables.items() if k != key} if value is None else tables | {key: value}


@given(st.sampled_from(FIELDS), st.sampled_from([None, *NOT_ALLOWED]))
@settings(max_examples=1500, deadline=None)
def test_a_rig_file_with_any_field_changed_is_a_rig_or_an_error_with_its_line(field, value):
    form, path = field
    text = tomli_w.dumps(changed(form, path, value))
    try:
        assert Rig.from_toml(Rig.from_toml(text).to_toml()) == Rig.from_toml(text)
    except ValueError as error:
        line, message = re.fullmatch(r"line (\d+): (.*)", str(error), re.DOTALL).groups()
        assert 1 <= int(line) <= len(text.splitlines())
        contradicts = re.match("(limits|voltage_limits|u_min|pitch_min) =", message)  # names both
        if not contradicts and value is not None:
            assert path[-1].removesuffix("_deg") in message or "parameters." in message
            assert path[-1] in text.splitlines()[int(line) - 1] or "parameters." in message


@given(st.sampled_from(FIELDS))
def test_an_unknown_key_anywhere_in_a_file_is_named_with_its_line(field):
    form, path = field
    text = tomli_w.dumps(changed(form, (*path[:-1], "nonsense"), 1.0))
    line = 1 + next(k for k, row in enumerate(text.splitlines()) if row.startswith("nonsense"))
    with pytest.raises(ValueError, match=f"line {line}: unknown key 'nonsense'"):
        Rig.from_toml(text)


def test_a_file_that_is_no_text_is_refused(tmp_path):
    (tmp_path / "rig.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ValueError, match="rig"):
        find_rig(tmp_path / "rig.toml")


def test_the_coefficients_of_the_packaged_files_are_in_the_documented_order():
    text = (RIGS / "paper.toml").read_text()
    assert [text.index(f"\n{name} = ") for name in COEFFICIENTS[:6]] == sorted(
        text.index(f"\n{name} = ") for name in COEFFICIENTS[:6]
    )
