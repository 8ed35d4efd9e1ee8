"""Logs: loaded signals, their grid, and messages for other files."""

import json
import subprocess
import sys

import numpy as np
import pytest
from measured import LOGS, on_measured_logs
from scipy.io import savemat

from heli_gym.baselines.commands import log as log_command
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.log_quantities import ANGLES


def flown(step=0.002, duration=4.0):
    """Columns of a flight that leaves the table at 1 s."""
    t = np.arange(round(duration / step) + 1) * step
    return {
        "t": t,
        "travel": 0.3 * t,
        "elevation": np.where(t < 1.0, 0.5, 0.5 - 0.3 * (t - 1.0)),
        "pitch": 0.1 * np.sin(t),
        "u_front": 5.0 + np.floor(t / 0.01) % 2,
        "u_back": 4.0 + 0.5 * t,
    }


def write_csv(path, columns, separator=","):
    np.savetxt(
        path, np.array(list(columns.values())).T, delimiter=separator, header=separator.join(columns), comments=""
    )
    return path


def test_angles_are_sampled_and_voltages_averaged_over_the_step_that_follows(tmp_path):
    columns = flown()
    log = FlightLog.load(write_csv(tmp_path / "a.csv", columns))
    assert log.sample_time == pytest.approx(0.01)
    np.testing.assert_allclose(log.angles[2], columns["pitch"][::5], atol=1e-12)
    np.testing.assert_allclose(log.voltages[1, :-1], columns["u_back"][:-1].reshape(-1, 5).mean(axis=1), atol=1e-9)


@pytest.mark.parametrize("separator", [",", ";", "\t", " "])
def test_separators_of_csv(tmp_path, separator):
    log = FlightLog.load(write_csv(tmp_path / "a.csv", flown(), separator))
    np.testing.assert_allclose(log.angles[0], 0.3 * log.t, atol=1e-12)


def test_a_mapping_names_columns_signs_units_and_zeros(tmp_path):
    columns = flown()
    degrees = {"time": 1e3 * columns["t"], "lambda": columns["travel"], "e": -np.degrees(columns["elevation"]) + 30.0}
    degrees |= {"p": columns["pitch"], "Vs": columns["u_front"] + columns["u_back"]}
    degrees |= {"Vd": columns["u_front"] - columns["u_back"]}
    path = write_csv(tmp_path / "a.csv", degrees)
    mapping = tmp_path / "mapping.toml"
    mapping.write_text(
        '[columns]\ntravel = "lambda"\nelevation = "e"\npitch = "p"\nu_sum = "Vs"\nu_difference = "Vd"\n'
        '[signs]\nelevation = -1\n[units]\nelevation = "deg"\nt = "ms"\n[zeros]\nelevation = 30.0\n'
    )
    log = FlightLog.load(path, mapping=mapping)
    plain = FlightLog.load(write_csv(tmp_path / "b.csv", columns))
    np.testing.assert_allclose(log.angles, plain.angles, atol=1e-9)
    np.testing.assert_allclose(log.voltages, plain.voltages, atol=1e-9)
    by_json = tmp_path / "mapping.json"
    by_json.write_text(json.dumps({"columns": {"elevation": "e"}, "signs": {"elevation": 1}}))
    with pytest.raises(ValueError, match=r"'travel'; it holds time, lambda, e, p, Vs, Vd"):
        FlightLog.load(path, mapping=by_json)


def test_matlab_5_structs_and_matrices(tmp_path):
    columns = flown()
    data = np.array([columns[name] for name in ("t", "travel", "elevation", "pitch", "u_front", "u_back")])
    savemat(tmp_path / "a.mat", {"run": {"data": data, "note": "text"}})
    names = {name: f"run.data[{i}]" for i, name in enumerate(("t", *ANGLES, "u_front", "u_back"))}
    log = FlightLog.load(tmp_path / "a.mat", columns=names)
    np.testing.assert_allclose(log.angles[2], columns["pitch"][::5], atol=1e-12)
    with pytest.raises(ValueError, match=r"it holds run\.data \(6, 2001\)"):
        FlightLog.load(tmp_path / "a.mat")


def test_matlab_73_files(tmp_path):
    h5py = pytest.importorskip("h5py")
    columns = flown()
    with h5py.File(tmp_path / "a.mat", "w", userblock_size=512) as file:
        for name, value in columns.items():
            file[f"log/{name}"] = value[None]
    log = FlightLog.load(tmp_path / "a.mat", columns={name: f"log.{name}" for name in columns})
    np.testing.assert_allclose(log.angles[2], columns["pitch"][::5], atol=1e-12)


def test_travel_that_is_wrapped_to_one_turn_goes_on(tmp_path):
    columns = flown()
    columns["travel"] = np.angle(np.exp(3j * columns["t"]))
    log = FlightLog.load(write_csv(tmp_path / "a.csv", columns))
    np.testing.assert_allclose(log.angles[0], 3.0 * log.t, atol=1e-9)


def test_a_saved_log_is_loaded_again(tmp_path):
    log = FlightLog.load(write_csv(tmp_path / "a.csv", flown()))
    log.save(tmp_path / "b.csv")
    again = FlightLog.load(tmp_path / "b.csv")
    np.testing.assert_allclose(again.angles, log.angles, atol=1e-5)
    np.testing.assert_allclose(again.voltages, log.voltages, atol=1e-4)


def test_a_flight_is_airborne_half_a_second_after_it_has_left_the_table(tmp_path):
    log = FlightLog.load(write_csv(tmp_path / "a.csv", flown()))
    leaves = 1.0 + np.radians(2.0) / 0.3
    assert log.t[log.airborne()][0] == pytest.approx(leaves + 0.5, abs=0.021)
    assert log.part(2.0, 4.0).airborne().all()


def test_rates_of_a_cubic_are_exact(tmp_path):
    t = np.arange(200) * 0.01
    log = FlightLog(t, np.array([t, t**2, t**3]), np.zeros((2, 200)))
    np.testing.assert_allclose(log.rates(), [np.ones(200), 2.0 * t, 3.0 * t**2], atol=1e-9)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"pitch": None}, "no column for 'pitch'; it holds t, travel, elevation, u_front, u_back"),
        ({"t": np.zeros(2001)}, "time must increase"),
        ({"t": np.concatenate((np.arange(1000), np.arange(3000, 4001))) * 0.002}, "gap of 4.002 s"),
        ({"pitch": np.full(2001, np.nan)}, "three rows of finite numbers"),
        ({"pitch": 90.0 * np.sin(flown()["t"])}, "pitch has values up to .*units: pitch = .deg"),
        ({"u_back": 4000.0 * np.ones(2001)}, "units: u_back = .mV"),
        ({"t": 2.0 * np.arange(2001)}, "t has steps of 2 s.*units: t = .ms"),
    ],
)
def test_faulty_files_are_refused(tmp_path, change, message):
    columns = {k: v for k, v in (flown() | change).items() if v is not None}
    with pytest.raises(ValueError, match=message):
        FlightLog.load(write_csv(tmp_path / "a.csv", columns))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"t,travel\n1,2\n2\n3,4\n", "row 2: must have 2 cells"),
        (b"t,travel\n1,2\n2,x\n3,4\n", "row 2, column 'travel': must be a number, not 'x'"),
        (b"\xff\xfe\x00", "must be a text file"),
        (b"", "must have a line of names"),
    ],
)
def test_faulty_text_is_refused(tmp_path, text, message):
    (tmp_path / "a.csv").write_bytes(text)
    with pytest.raises(ValueError, match=message):
        FlightLog.load(tmp_path / "a.csv")


@pytest.mark.parametrize(
    ("argument", "message"),
    [
        ({"columns": {"yaw": "x"}}, "columns: 'yaw' must be one of t, travel"),
        ({"units": {"pitch": "turns"}}, "units: pitch = 'turns': must be one of rad, deg"),
        ({"signs": {"pitch": float("nan")}}, "signs: pitch = nan: must be a finite number"),
        ({"sample_time": -1.0}, "sample_time = -1.0: must be"),
    ],
)
def test_faulty_arguments_are_refused(tmp_path, argument, message):
    path = write_csv(tmp_path / "a.csv", flown())
    with pytest.raises(ValueError, match=message):
        FlightLog.load(path, **argument)


def test_the_command_draws_a_log(tmp_path, capsys):
    path = write_csv(tmp_path / "a.csv", flown())
    log_command.main(log_command.Args(path, out=tmp_path / "a.pdf"))
    content = (tmp_path / "a.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert b"CreationDate" not in content  # equal figures are equal files
    assert "4.00 s at 10 ms" in capsys.readouterr().out


def test_the_command_refuses_in_one_line(tmp_path):
    (tmp_path / "a.mat").write_bytes(b"nothing")
    code = "from heli_gym.baselines.commands.log import main; main()"
    child = subprocess.run([sys.executable, "-c", code, str(tmp_path / "a.mat")], capture_output=True, text=True)
    assert child.returncode == 2
    assert child.stderr.count("\n") == 1 and "must be a .csv or a .mat file" in child.stderr


@on_measured_logs
def test_measured_logs_load_and_start_on_the_table():
    logs = sorted(LOGS.glob("*.csv"))
    assert logs
    for path in logs:
        log = FlightLog.load(path)
        assert 25.0 < np.degrees(log.table_elevation()) < 32.0
        assert 0.9 < log.airborne().mean() < 1.0


def test_single_outliers_are_bridged_and_frozen_pieces_are_no_flight(tmp_path):
    columns = flown()
    columns["pitch"][[700, 1400, 1401]] += 1.0
    log = FlightLog.load(write_csv(tmp_path / "a.csv", columns))
    np.testing.assert_allclose(log.angles[2], 0.1 * np.sin(log.t), atol=1e-3)
    angles, voltages = log.angles.copy(), log.voltages.copy()
    angles[:, 250:320], voltages[:, 250:320] = angles[:, 250:251], voltages[:, 250:251]
    frozen = FlightLog(log.t, angles, voltages)
    assert frozen.frozen()[250:319].all() and not frozen.frozen()[:249].any()
    assert not frozen.airborne()[250:369].any() and frozen.airborne()[371:].all()


def test_decimal_commas_and_capitals(tmp_path):
    columns = {name.capitalize(): values for name, values in flown().items()}
    path = write_csv(tmp_path / "a.csv", columns, ";")
    path.write_text(path.read_text().replace(".", ","))
    np.testing.assert_allclose(FlightLog.load(path).angles[0], 0.3 * FlightLog.load(path).t, atol=1e-12)
