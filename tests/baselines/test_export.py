"""Exported controllers agree with Python's; tables and .mat files are correct."""

import csv
import shutil
import subprocess

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.io import loadmat

from heli_gym import Maneuver, PowerCurve, Rig, TableCurve, ThrustMap, find_rig
from heli_gym.baselines import make_policy, plan, riccati_gains
from heli_gym.baselines.commands.export import Args, export_files, load_controller, main
from heli_gym.baselines.control.estimation import Actuator
from heli_gym.baselines.control.export import c_source
from heli_gym.baselines.control.model_based import kalman_lqr
from heli_gym.baselines.control.residual import Network, ResidualPolicy
from heli_gym.cli import CommandError
from heli_gym.env import Heli3DOFEnv, find_reference, reference_for

PERIOD = 0.02
TRAVEL_360 = find_reference("travel-360")
MIXED = Rig(
    "mixed",
    thrust_map=ThrustMap(
        PowerCurve(0.03, -0.01, 1.2, 0.5),
        TableCurve((0.0, 2.0, 5.0, 8.0, 12.0), (0.0, 0.05, 0.2, 0.4, 0.65)),
    ),
)
needs_cc = pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler")
STATEFUL = ("lqi", "lag-lqr", "lag-lqi", "kalman-lqr")
MEMORYLESS = ("open-loop", "feedforward+tvlqr", "hover-lqr")


class CPolicy:
    """The compiled controller, as a policy."""

    def __init__(self, policy, rig, precision, folder):
        for name, text in c_source(policy, rig, "a policy", precision).items():
            (folder / name).write_text(text)
        self.loaded, self.number = load_controller(folder, precision)

    def reset(self, rng):
        self.loaded.heli_reset()

    def __call__(self, t, measurement):
        u = (self.number * 2)()
        self.loaded.heli_step(t, (self.number * 6)(*measurement), u)
        return np.array(u[:])


def flown(policy, reference, plant, seed=3):
    """States (K, 6) and voltages (K, 2) of a flight from a perturbed start."""
    env = Heli3DOFEnv(plant, reference, PERIOD, start_spread_deg=3.0)
    _, info = env.reset(seed=seed)
    policy.reset(np.random.default_rng(0))
    x, u, over = [info["state"]], [], False
    while not over:
        action = env.to_action(policy(info["time"], info["measurement"]))
        _, _, terminated, truncated, info = env.step(action)
        x.append(info["state"])
        u.append(info["voltage"])
        over = terminated or truncated
    return np.array(x), np.array(u)


@needs_cc
@pytest.mark.parametrize("plant", ["nominal", "lab"])
@pytest.mark.parametrize("name", [*MEMORYLESS, *STATEFUL, "residual", "residual-rigid", "zero", "middle-voltage"])
def test_c_in_double_precision_flies_as_python_does_to_1e_9(name, plant, tmp_path):
    policy = make_policy(name, TRAVEL_360, PERIOD)
    mine = flown(CPolicy(policy, TRAVEL_360.rig, "double", tmp_path), TRAVEL_360, plant)
    theirs = flown(policy, TRAVEL_360, plant)
    assert_allclose(mine[0], theirs[0], rtol=0.0, atol=1e-9)
    assert_allclose(mine[1], theirs[1], rtol=0.0, atol=1e-7)  # V: near zero the root of (2) is steep


@needs_cc
@pytest.mark.parametrize("name", ["feedforward+tvlqr", *STATEFUL, "residual"])
def test_c_in_single_precision_flies_as_python_does_to_1e_4(name, tmp_path):
    policy = make_policy(name, TRAVEL_360, PERIOD)
    mine, _ = flown(CPolicy(policy, TRAVEL_360.rig, "single", tmp_path), TRAVEL_360, "nominal")
    theirs, _ = flown(policy, TRAVEL_360, "nominal")
    assert_allclose(mine, theirs, rtol=0.0, atol=1e-4)


@needs_cc
@pytest.mark.parametrize("name", ["open-loop", "feedforward+tvlqr"])
def test_along_a_plan_single_precision_holds_on_quantised_angles_too(name, tmp_path):
    """The grid is met despite the rounding of t, so that errors stay far below a count of an encoder."""
    policy = make_policy(name, TRAVEL_360, PERIOD)
    mine, _ = flown(CPolicy(policy, TRAVEL_360.rig, "single", tmp_path), TRAVEL_360, "lab")
    theirs, _ = flown(policy, TRAVEL_360, "lab")
    assert_allclose(mine, theirs, rtol=0.0, atol=1e-5)


@needs_cc
@pytest.mark.parametrize("name", [*MEMORYLESS, *STATEFUL])
@pytest.mark.parametrize("rig", [MIXED, find_rig("quanser"), find_rig("ntnu")], ids=str)
def test_c_answers_as_python_does_on_any_thrust_map(name, rig, tmp_path):
    reference = plan(Maneuver(goal=(0.6, -0.1), duration=6.0, rig=rig))
    policy = make_policy(name, reference, PERIOD)
    c_policy = CPolicy(policy, rig, "double", tmp_path)
    rng = np.random.default_rng(0)
    policy.reset(rng)
    c_policy.reset(rng)
    for k in range(400):  # beyond the end of the reference too
        t = k * PERIOD
        y = reference(t)[0] + rng.normal(0.0, 0.02, 6)
        assert_allclose(c_policy(t, y), np.clip(policy(t, y), *rig.voltage_limits), rtol=0.0, atol=1e-9)


@needs_cc
def test_c_flies_the_correction_of_the_fleet_as_python_does(tmp_path):
    reference = reference_for("travel-360", "fleet")
    policy = make_policy("residual", reference, PERIOD)
    c_policy, rng = CPolicy(policy, reference.rig, "double", tmp_path), np.random.default_rng(0)
    for one in (policy, c_policy):
        one.reset(rng)
    for k in range(400):
        y = reference(k * PERIOD)[0] + rng.normal(0.0, 0.02, 6)
        expected = np.clip(policy(k * PERIOD, y), *reference.rig.voltage_limits)
        assert_allclose(c_policy(k * PERIOD, y), expected, rtol=0.0, atol=1e-9)


@needs_cc
def test_between_the_samples_the_papers_controller_is_interpolated(tmp_path):
    policy = make_policy("feedforward+tvlqr", TRAVEL_360, PERIOD)
    c_policy = CPolicy(policy, TRAVEL_360.rig, "double", tmp_path)
    t = np.arange(0.0, 9.98, PERIOD / 4)
    u = np.array([c_policy(s, TRAVEL_360(s)[0]) for s in t])
    at_samples = u[::4]
    assert_allclose(u[2::4][:-1], 0.5 * (at_samples[:-1] + at_samples[1:])[: len(u[2::4]) - 1], atol=0.05)


@needs_cc
def test_a_measurement_that_is_no_number_gives_the_voltage_nearest_to_zero(tmp_path):
    policy = make_policy("feedforward+tvlqr", TRAVEL_360, PERIOD)
    c_policy = CPolicy(policy, TRAVEL_360.rig, "double", tmp_path)
    assert c_policy(0.0, np.full(6, np.nan)).tolist() == [0.0, 0.0]
    assert np.isfinite(c_policy(np.nan, np.zeros(6))).all()


@needs_cc
@pytest.mark.parametrize("name", ["feedforward+tvlqr", *STATEFUL, "residual"])
def test_after_a_measurement_that_is_no_number_the_flight_goes_on(name, tmp_path):
    c_policy = CPolicy(make_policy(name, TRAVEL_360, PERIOD), TRAVEL_360.rig, "double", tmp_path)

    class Interrupted:
        def reset(self, rng):
            c_policy.reset(rng)

        def __call__(self, t, measurement):
            missed = round(t / PERIOD) in (0, 100)
            u = c_policy(t, np.full(6, np.nan) if missed else measurement)
            assert np.isfinite(u).all() and (not missed or (u == 0.0).all())
            return u

    x, _ = flown(Interrupted(), TRAVEL_360, "nominal")
    assert len(x) == 501
    assert_allclose(x[-1, [0, 2]], TRAVEL_360.x[[0, 2], -1], atol=0.05)


@needs_cc
@pytest.mark.parametrize("name", ["kalman-lqr", "residual"])
def test_c_saturates_at_the_amplifier_of_the_policy(name, tmp_path):
    policy = make_policy(name, TRAVEL_360, voltage_limits=(1.0, 9.0))
    c_policy, low = CPolicy(policy, TRAVEL_360.rig, "double", tmp_path), np.array([0.0, 0.0, 0.8, 0.0, 0.0, 0.0])
    c_policy.reset(None)
    policy.reset(np.random.default_rng(0))
    for k in range(20):
        y = TRAVEL_360(k * PERIOD)[0] + (low if k % 2 else -low)
        expected = np.clip(policy(k * PERIOD, y), 1.0, 9.0)
        assert_allclose(c_policy(k * PERIOD, y), expected, rtol=0.0, atol=1e-9)


@needs_cc
def test_a_time_that_is_no_number_counts_as_the_start(tmp_path):
    c_policy, x = CPolicy(make_policy("residual", TRAVEL_360), TRAVEL_360.rig, "double", tmp_path), TRAVEL_360.x[:, 0]
    c_policy.reset(None)
    first = c_policy(0.0, x)
    for t in (np.nan, -1.0):
        c_policy.reset(None)
        assert_array_equal(c_policy(t, x), first)


@needs_cc
def test_a_regulator_on_the_angles_needs_no_rates(tmp_path):
    c_policy = CPolicy(make_policy("kalman-lqr", TRAVEL_360), TRAVEL_360.rig, "double", tmp_path)
    c_policy.reset(None)
    assert (c_policy(0.0, TRAVEL_360.x[:, 0] + 3 * [0.0, np.nan]) > 1.0).all()


@needs_cc
def test_the_header_is_c_plus_plus_too(tmp_path):
    for name, data in export_files(Args("travel-360")).items():
        (tmp_path / name).write_bytes(data)
    (tmp_path / "main.cpp").write_text(
        '#include "heli_controller.h"\nint main() { double y[6] = {0}, u[2]; heli_reset(); heli_step(0.0, y, u); }\n'
    )
    source, program = tmp_path / "heli_controller.c", tmp_path / "program"
    subprocess.run(
        ["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-c", source, "-o", tmp_path / "c.o"], check=True
    )
    if shutil.which("c++"):
        subprocess.run(["c++", tmp_path / "main.cpp", tmp_path / "c.o", "-o", program, "-lm"], check=True)
        assert subprocess.run([program]).returncode == 0


def test_the_table_has_reference_feedforward_and_gains():
    text = export_files(Args("travel-360", format="csv"))["heli_controller.csv"].decode()
    header, *rows = csv.reader(text.splitlines())
    values = np.array(rows, dtype=float)
    t = values[:, header.index("t_s")]
    assert_allclose(t, PERIOD * np.arange(501))
    x, _ = TRAVEL_360(t)
    assert_allclose(values[:, header.index("pitch_rad")], x[4], atol=1e-15)
    assert_allclose(values[:, header.index("u_front_V")], TRAVEL_360(t + 0.5 * PERIOD)[1][0], atol=1e-12)
    gains = riccati_gains(TRAVEL_360)(t)
    assert_allclose(values[:, header.index("K_difference_pitch")], gains[1, 4])
    assert len(header) == 1 + 6 + 4 + 12


def test_the_mat_file_has_structures_with_time(tmp_path):
    (tmp_path / "c.mat").write_bytes(export_files(Args("travel-360", format="mat"))["heli_controller.mat"])
    data = loadmat(tmp_path / "c.mat", squeeze_me=False)
    t = PERIOD * np.arange(501)
    for name, width in (("x_ref", 6), ("u_ff", 2), ("v_ff", 2)):
        signal = data[name][0, 0]
        assert_allclose(signal["time"], t[:, None])
        assert signal["signals"][0, 0]["values"].shape == (501, width)
        assert signal["signals"][0, 0]["dimensions"].item() == width
    gains = data["K"][0, 0]["signals"][0, 0]
    assert gains["dimensions"].ravel().tolist() == [2, 6]
    assert_allclose(gains["values"], riccati_gains(TRAVEL_360)(t))
    assert_allclose(data["x_ref"][0, 0]["signals"][0, 0]["values"], TRAVEL_360(t)[0].T, atol=1e-15)
    assert Rig.from_toml(str(data["rig"][0])) == TRAVEL_360.rig


@pytest.mark.parametrize("name", ["feedforward+tvlqr", "lag-lqi", "kalman-lqr"])
def test_the_document_says_order_signs_and_units(name):
    text = export_files(Args("travel-360", name, "csv"))["README.md"].decode()
    for words in ("positive **down**", "rad/s", "front, back", "0 to 12 V", "thrust sum"):
        assert words in text
    assert ("differences of the angles" in text) == (name != "kalman-lqr")
    assert ("prediction over the rig's delay" in text) == (name != "feedforward+tvlqr")
    if name == "lag-lqi":
        assert "thrust_difference, travel_integral" in text
        assert "multiply integrals of `y - x_ref`" in text


def test_the_command_writes_the_files_and_the_time_of_a_step(tmp_path, capsys):
    main(Args("travel-360", out=tmp_path))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["README.md", "heli_controller.c", "heli_controller.h"]
    assert "time per step" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"plan": "nowhere.npz"}, "reference = 'nowhere.npz': must be"),
        ({"policy": "unknown"}, "name = 'unknown': must be one of"),
        ({"policy": "residual", "format": "csv"}, "policy = 'residual': must have a feedforward and gains"),
        ({"policy": "pd-cascade"}, "policy = 'pd-cascade': must be one of open-loop, feedforward+tvlqr"),
        ({"policy": "adaptive-mpc", "format": "mat"}, "policy = 'adaptive-mpc': must have a feedforward and gains"),
        ({"policy": "nmpc"}, "or a learned correction of these"),
        ({"rig": "ntnu"}, "PLAN = 'travel-360' is for the rig 'paper', and the one to export for is 'ntnu'"),
        ({"control_period": 0.0}, "control_period = 0.0: must be"),
        ({"rig": "no-such-rig"}, "rig = 'no-such-rig'"),
    ],
)
def test_a_policy_without_an_exported_form_is_refused_in_a_line_and_leaves_nothing(values, message, tmp_path, capsys):
    with pytest.raises(CommandError) as raised:
        main(Args(**{"plan": "travel-360", "out": tmp_path / "new", **values}))
    assert raised.value.code == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "new" / "README.md").exists()


def test_another_rig_is_exported_for_by_force():
    files = export_files(Args("travel-360", "feedforward+tvlqr", rig="ntnu", force=True))
    assert b"ntnu" in files["heli_controller.c"]


@needs_cc
def test_a_delay_of_many_periods_is_bridged_alike(tmp_path):
    policy = make_policy("kalman-lqr", TRAVEL_360, 0.004)
    assert policy.actuator.delay == 5
    c_policy = CPolicy(policy, TRAVEL_360.rig, "double", tmp_path)
    rng = np.random.default_rng(0)
    policy.reset(rng)
    for k in range(300):
        y = TRAVEL_360(0.004 * k)[0] + rng.normal(0.0, 0.01, 6)
        assert_allclose(c_policy(0.004 * k, y), np.clip(policy(0.004 * k, y), 0.0, 12.0), rtol=0.0, atol=1e-8)


@needs_cc
@pytest.mark.parametrize("name", ["lag-lqi", "kalman-lqr"])
def test_both_precisions_answer_the_same_measurements_of_encoders_alike(name, tmp_path):
    policy, measured = make_policy(name, TRAVEL_360, PERIOD), []
    env = Heli3DOFEnv("lab", TRAVEL_360, PERIOD, start_spread_deg=3.0)
    _, info = env.reset(seed=3)
    policy.reset(np.random.default_rng(0))
    for _ in range(200):
        measured.append((info["time"], info["measurement"]))
        *_, info = env.step(env.to_action(policy(*measured[-1])))
    answers = []
    for precision in ("double", "single"):
        (tmp_path / precision).mkdir()
        compiled = CPolicy(policy, TRAVEL_360.rig, precision, tmp_path / precision)
        compiled.reset(None)
        answers.append(np.array([compiled(t, y) for t, y in measured]))
    assert_allclose(answers[1], answers[0], atol=1e-3 * 12.0)
    assert np.median(np.abs(answers[1] - answers[0])) < 1e-4 * 12.0


@needs_cc
@pytest.mark.parametrize("delay", [0, 1])
def test_c_and_python_simulate_the_corrected_voltages_with_and_without_a_delay(delay, tmp_path):
    base = kalman_lqr(TRAVEL_360, PERIOD, TRAVEL_360.rig, actuator=Actuator(0.1, delay))
    rng = np.random.default_rng(1)
    groups = ("error", "voltages", "estimate")
    network = Network((0.3 * rng.standard_normal((2, 17)),), (0.3 * rng.standard_normal(2),), True)
    policy = ResidualPolicy(base, TRAVEL_360, network, 3.0, feature_groups=groups)
    mine = flown(CPolicy(policy, TRAVEL_360.rig, "double", tmp_path), TRAVEL_360, "lab")
    theirs = flown(policy, TRAVEL_360, "lab")
    assert_allclose(mine[0], theirs[0], rtol=0.0, atol=1e-9)
    assert_allclose(mine[1], theirs[1], rtol=0.0, atol=1e-7)
