"""The experiment meets its limits and prints its expected errors."""

import math
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from heli_gym import Coupling, Plant, Rig, Trajectory
from heli_gym.baselines.commands import export
from heli_gym.baselines.commands import identify as command
from heli_gym.baselines.identification.estimation import identify
from heli_gym.baselines.identification.experiment import MODEL_ERROR, design, expected_errors, multisine, parameters_of
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.simulated import simulate_log
from heli_gym.env import Heli3DOFEnv
from heli_gym.rig import find_rig


@pytest.fixture(scope="module")
def experiment():
    return design(find_rig("ntnu"), 40.0)


def test_it_meets_the_limits_of_the_rig(experiment):
    rig, log = find_rig("ntnu"), experiment.log
    assert rig.limits.u_min <= log.voltages.min() and log.voltages.max() <= rig.limits.u_max
    assert np.abs(log.angles[2]).max() < rig.limits.pitch_max
    assert log.duration == pytest.approx(40.0)
    assert np.ptp(log.references["pitch_ref"]) > np.radians(10.0)


def test_its_flight_gives_the_coefficients_within_the_expected_errors(experiment):
    found = identify([experiment.log], "ntnu", fit_share=1.0)
    parameters, voltage = parameters_of(find_rig("ntnu"))
    unit = (found.hover_voltage / voltage) ** parameters.exponent
    for name in ("a1", "a2", "a3"):
        error = getattr(found.parameters, name) - getattr(parameters, name)
        assert abs(error) < 3.0 * experiment.standard_errors[name]
    for name in ("b1", "b2", "b3"):
        error = getattr(found.parameters, name) - unit * getattr(parameters, name)
        assert abs(error) < 3.0 * experiment.standard_errors[name]
    smaller = [experiment.standard_errors[name] > error for name, error in found.standard_errors.items()]
    assert MODEL_ERROR > 1.0 and np.mean(smaller) > 0.8  # for its errors are no more than rounding


def test_the_expected_flight_has_the_moments_between_the_axes_of_the_rig():
    coupling = Coupling(centrifugal=0.9, centre=0.03, spin=0.7, gyro=-1.1, airflow=0.12)
    found, _ = parameters_of(replace(find_rig("ntnu"), coupling=coupling))
    assert (found.centrifugal, found.centre, found.pitch_spin, found.gyro, found.pitch_speed) == coupling
    unknown, _ = parameters_of(find_rig("ntnu"))
    assert (unknown.centrifugal, unknown.gyro) == (1.0, 0.0)  # common to identified rigs


def test_the_expected_flight_and_errors_have_the_encoder_counts_of_the_rig():
    coarse = replace(find_rig("ntnu"), encoder_counts=(1000, 500, 250))
    parameters, voltage = parameters_of(coarse)
    references = lambda t: (0.1 * math.sin(t), 0.05 * math.sin(0.5 * t))  # noqa: E731
    log = simulate_log(parameters, voltage, references, 20.0, counts=coarse.encoder_counts)
    for angles, counts in zip(log.angles, coarse.encoder_counts):
        assert np.diff(np.unique(angles)).min() == pytest.approx(2.0 * math.pi / counts)
    fine, rough = (expected_errors(log, parameters, voltage, c)[0] for c in (Rig.encoder_counts, (1000, 500, 250)))
    assert rough["b3"] > 3.0 * fine["b3"]


def test_a_multisine_has_its_amplitude_and_rests_at_both_ends():
    reference = multisine((0.1, 1.0), 30.0, 0.3, np.random.default_rng(0))
    values = np.array([reference(t) for t in np.arange(0.0, 30.01, 0.01)])
    assert values[0] == pytest.approx(0.0) and values[-1] == pytest.approx(0.0, abs=1e-6)
    assert 0.15 < np.abs(values).max() <= 0.3 * 1.001


@pytest.mark.parametrize("duration", [5.0, 61.0, float("nan")])
def test_other_durations_are_refused(duration):
    with pytest.raises(ValueError, match=r"duration = .*: must be 10 to 60 s"):
        design(find_rig("ntnu"), duration)


def test_the_command_writes_references_and_the_expected_flight(tmp_path, capsys):
    command.main(command.Args(design=True, rig="ntnu", duration=10.0, out=tmp_path / "experiment.csv"))
    log = FlightLog.load(tmp_path / "experiment.csv")
    assert set(log.references) == {"pitch_ref", "elevation_ref"}
    assert "expected standard error" in capsys.readouterr().out


@pytest.mark.parametrize(
    "unused",
    [
        {"json": Path("r.json")},
        {"figures": Path("out")},
        {"mapping": Path("m.toml")},
        {"sample_time": 0.02},
        {"fit_share": 0.5},
        {"ablation": True},
    ],
    ids=lambda unused: next(iter(unused)),
)
def test_options_without_effect_on_the_design_are_refused_by_name(unused):
    with pytest.raises(ValueError, match=rf"{next(iter(unused))} = .*: must be left out with --design"):
        command.check(command.Args(design=True, **unused))


def test_a_duration_without_a_design_is_refused():
    with pytest.raises(ValueError, match=r"duration = 30\.0: must be left out without --design"):
        command.check(command.Args((Path("simulated"),), duration=30.0))


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler")
def test_the_experiment_flown_by_the_exported_c_controller_gives_the_coefficients_within_the_expected_errors(tmp_path):
    rig = find_rig("ntnu")
    command.main(command.Args(design=True, rig="ntnu", duration=40.0, out=tmp_path / "experiment.csv"))
    export.main(export.Args(str(tmp_path / "experiment.npz"), out=tmp_path, control_period=0.01))
    loaded, number = export.load_controller(tmp_path, "double")
    reference = Trajectory.load(tmp_path / "experiment.npz")
    env = Heli3DOFEnv(Plant.from_rig(rig, table=None), reference, 0.01, rig=rig)
    _, info = env.reset(seed=0)
    loaded.heli_reset()
    angles, voltages, u, over = [], [], (number * 2)(), False
    while not over:
        loaded.heli_step(info["time"], (number * 6)(*info["measurement"]), u)
        angles.append(info["measurement"][0::2])
        _, _, terminated, truncated, info = env.step(env.to_action(np.array(u[:])))
        voltages.append(info["voltage"])
        over = terminated or truncated
    assert not terminated
    log = FlightLog(0.01 * np.arange(len(angles)), np.array(angles).T, np.array(voltages).T)
    found, expected = identify([log], "ntnu", fit_share=1.0), design(rig, 40.0).standard_errors
    parameters, voltage = parameters_of(rig)
    unit = (found.hover_voltage / voltage) ** parameters.exponent
    for name in ("a1", "a2", "a3", "b1", "b2", "b3"):
        true = getattr(parameters, name) * (unit if name.startswith("b") else 1.0)
        assert abs(getattr(found.parameters, name) - true) < 3.0 * expected[name]
