"""Known rigs are identified within the stated errors; predictions are better than simple ones."""

import json

import numpy as np
import pytest
from measured import LOGS, on_measured_logs

from heli_gym import HelicopterParameters
from heli_gym.baselines.commands import identify as command
from heli_gym.baselines.identification.estimation import (
    COEFFICIENTS,
    EFFECTS,
    ablation_cases,
    identify,
)
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.measured_model import MeasuredParameters
from heli_gym.baselines.identification.multiple_shooting import SPREAD, Shooting, jackknife
from heli_gym.baselines.identification.prediction import FilteredLog, Settings, horizon_starts, pooled, validate
from heli_gym.baselines.identification.simulated import hover_of, random_rig, simulate_log, square_waves
from heli_gym.rig import Rig


def standardised(parameters, voltage, model):
    """Errors in standard errors; the true coefficients in the unit of thrust of the model."""
    unit = (model.hover_voltage / voltage) ** parameters.exponent
    true = parameters._replace(b1=parameters.b1 * unit, b2=parameters.b2 * unit, b3=parameters.b3 * unit)
    return {
        name: (getattr(model.parameters, name) - getattr(true, name)) / error
        for name, error in model.standard_errors.items()
    }


@pytest.fixture(scope="module")
def known():
    rng = np.random.default_rng(5)
    parameters, voltage = random_rig(rng)
    return parameters, voltage, simulate_log(parameters, voltage, square_waves(), 30.0, rng=rng)


@pytest.fixture(scope="module")
def model(known):
    return identify([known[2]], fit_share=0.6)


def test_the_simulated_rig_hovers_where_it_should(known):
    parameters, voltage, _ = known
    log = simulate_log(parameters, voltage, lambda t: (parameters.pitch_zero, 0.0), 10.0)
    assert np.abs(np.degrees(log.angles[1:, -200:] - [[0.0], [parameters.pitch_zero]])).max() < 3.0
    np.testing.assert_allclose(log.voltages[:, -400:].mean(axis=1), hover_of(parameters, voltage), rtol=0.03)


def test_a_known_rig_comes_back_within_its_errors(known, model):
    errors = np.array(list(standardised(known[0], known[1], model).values()))
    assert len(errors) >= 18
    assert np.abs(errors).max() < 4.0
    assert (np.abs(errors) < 1.96).mean() > 0.8


@pytest.mark.slow
def test_of_the_95_percent_intervals_on_100_simulated_logs_90_to_99_percent_hold():
    rng, errors = np.random.default_rng(11), []
    for _ in range(100):
        parameters, voltage = random_rig(rng)
        log = simulate_log(parameters, voltage, square_waves(), 40.0, rng=rng)
        errors += standardised(parameters, voltage, identify([log], fit_share=1.0)).values()
    assert 0.90 < (np.abs(errors) < 1.96).mean() < 0.99


def test_an_amplifiers_limit_is_found(known):
    parameters, voltage, _ = known
    limited = parameters._replace(voltage_limit=1.45 * voltage)
    log = simulate_log(limited, voltage, square_waves(0.5, 0.25), 30.0)
    assert (np.abs(log.voltages) > limited.voltage_limit).mean() > 0.002
    found = identify([log], fit_share=1.0)
    assert found.parameters.voltage_limit == pytest.approx(limited.voltage_limit, rel=0.02)


def test_what_hover_does_not_show_is_named_and_kept(known):
    parameters, voltage, _ = known
    log = simulate_log(parameters, voltage, lambda t: (0.0, 0.0), 12.0)
    found = identify([log], fit_share=1.0)
    assert {"gyro", "centrifugal"} & set(found.undetermined)
    for name in found.undetermined:
        assert getattr(found.parameters, name) == getattr(MeasuredParameters(), name)
        assert name not in found.standard_errors


def test_outliers_change_little(known, model):
    log = known[2]
    angles = log.angles.copy()
    angles[:, 700:1500:97] += 0.5
    found = identify([FlightLog(log.t, angles, log.voltages)], fit_share=0.6)
    for name, error in model.standard_errors.items():
        change = abs(getattr(found.parameters, name) - getattr(model.parameters, name))
        assert change < 12.0 * error + 0.02 * abs(getattr(model.parameters, name))


def test_two_logs_of_one_rig_say_more_than_one(known, model):
    parameters, voltage, log = known
    second = simulate_log(parameters, voltage, square_waves(-0.25, 0.1), 30.0)
    both = identify([log, second], fit_share=0.6)
    smaller = [both.standard_errors[name] < error for name, error in model.standard_errors.items()]
    assert np.mean(smaller) > 0.9


def test_the_rig_hovers_at_the_voltages_of_the_flight(known, model):
    parameters, voltage, _ = known
    rig = model.rig("found")
    np.testing.assert_allclose(rig.hover_voltage(), hover_of(parameters, voltage), rtol=0.03)
    assert Rig.from_toml(rig.to_toml()) == rig
    assert rig.parameters.b2 * rig.thrust(rig.hover_voltage()).sum() == pytest.approx(-rig.parameters.a2)


def test_thrusts_have_the_scale_of_the_start(known):
    heavy = Rig("heavy", HelicopterParameters(b1=-0.3, b2=-0.3, b3=2.3), voltage_limits=(0.0, 20.0))
    one, other = (identify([known[2]], start).rig("x") for start in ("paper", heavy))
    ratio = one.parameters.b3 / other.parameters.b3
    assert ratio == pytest.approx(0.6523 / 0.3, rel=1e-3)
    np.testing.assert_allclose(one.hover_voltage(), other.hover_voltage(), rtol=1e-3)


def test_the_model_predicts_better_than_the_plain_predictors(known, model):
    v = validate([known[2]], model, Settings())
    for horizon in (1.0, 3.0):
        plain, own = pooled(v, horizon, "constant rate"), pooled(v, horizon, "model")
        assert all(a < 0.25 * b for a, b in zip(own, plain))
    assert all(a < b for a, b in zip(pooled(v, 1.0, "model"), pooled(v, 1.0, "black box")))


def test_judged_windows_lie_after_the_fitted_share_and_in_the_air():
    t = np.arange(3000) * 0.01
    elevation = np.where((t > 1.0) & (t < 25.0), 0.0, 0.5)
    log = FlightLog(t, np.array([t, elevation, t]), np.ones((2, 3000)))
    starts = horizon_starts(log, (0.6, 1.0), 1.0)
    assert t[starts].min() >= 18.0
    assert t[starts].max() < 24.0


def test_predictions_do_not_use_later_samples(known, model):
    log = known[2]
    angles = log.angles.copy()
    angles[:, 2000:] += 1.0
    later = FlightLog(log.t, angles, log.voltages)
    k = np.array([1500, 1999])
    one, other = (FilteredLog(each, model).predict(k, 100) for each in (log, later))
    np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"logs": []}, "logs: must be at least one"),
        ({"fit_share": 0.0}, "fit_share = 0.0: must be"),
        ({"fit_share": 0.05}, "at least three airborne windows"),
        ({"effects": ("magic",)}, "effects: 'magic' must be one of trim"),
        ({"start": "nowhere"}, "rig = 'nowhere'"),
    ],
)
def test_bad_arguments_are_refused(known, arguments, message):
    with pytest.raises(ValueError, match=message):
        identify(**({"logs": [known[2]]} | arguments))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda a, u: (a * [[-1], [1], [1]], u), "signs: travel = -1"),
        (lambda a, u: (a * [[1], [-1], [1]], u), "signs: elevation = -1"),
        (lambda a, u: (a * [[1], [1], [-1]], u), "signs: pitch = -1"),
        (lambda a, u: (a, u[::-1]), "exchange u_front and u_back"),
        (lambda a, u: (a, -u), "voltages positive forwards"),
        (lambda a, u: (a * [[1], [1], [0]], u), "pitch must change in flight"),
        (lambda a, u: (a, 0 * u + 4.0), "a voltage must change in flight"),
    ],
)
def test_wrong_signs_and_dead_signals_are_named(known, change, message):
    log = known[2]
    with pytest.raises(ValueError, match=message):
        identify([FlightLog(log.t, *change(log.angles, log.voltages))])


@pytest.mark.parametrize("step", [0.001, 0.04])
def test_other_sample_times_give_the_same_rig(known, model, step, tmp_path):
    log = known[2]
    t = np.arange(0.0, log.duration, step)
    values = [np.interp(t, log.t, angle) for angle in log.angles]
    values += [u[np.clip((t / 0.01 + 1e-6).astype(int), 0, len(log) - 1)] for u in log.voltages]
    np.savetxt(tmp_path / "a.csv", np.array([t, *values]).T, delimiter=",", comments="",
               header="t,travel,elevation,pitch,u_front,u_back")  # fmt: skip
    found = identify([FlightLog.load(tmp_path / "a.csv")])
    for name in ("a1", "a2", "b1", "b2", "b3", "exponent"):
        assert getattr(found.parameters, name) == pytest.approx(getattr(model.parameters, name), rel=0.1)


def test_an_effect_that_is_left_out_has_no_influence(known):
    found = identify([known[2]], effects=[name for name in EFFECTS if name != "gyro"])
    assert found.parameters.gyro == 0.0
    assert "gyro" not in found.free


def test_a_parameter_whose_prior_has_no_spread_stays_there(known):
    found = identify(
        [known[2]], prior=MeasuredParameters(gyro=0.3), spread=SPREAD._replace(gyro=1e-6), effects=["lag", "gyro"]
    )
    assert found.parameters.gyro == 0.3
    assert found.undetermined == ("gyro",)


def test_where_data_and_prior_contradict_each_other_the_standard_error_is_larger(known):
    parameters, _, log = known
    spread = SPREAD._replace(gyro=0.03)
    near, far = (
        identify([log], prior=MeasuredParameters(gyro=parameters.gyro + away), spread=spread) for away in (0.0, 0.2)
    )
    assert far.standard_errors["gyro"] > 2.0 * near.standard_errors["gyro"]
    assert abs(far.parameters.gyro - parameters.gyro) < 2.0 * far.standard_errors["gyro"]


def test_the_jackknife_is_that_of_estimates_without_each_window():
    rng = np.random.default_rng(8)
    J, y = rng.normal(size=(6, 10, 3)), rng.normal(size=(6, 10))
    found = np.linalg.lstsq(J.reshape(-1, 3), y.ravel())[0]
    without = [
        np.linalg.lstsq(np.delete(J, w, axis=0).reshape(-1, 3), np.delete(y, w, axis=0).ravel())[0] for w in range(6)
    ]
    matrices, sides = J.transpose(0, 2, 1) @ J, np.einsum("wij,wi->wj", J, y - J @ found)
    variance = jackknife(matrices.sum(axis=0), matrices, sides)
    np.testing.assert_allclose(variance, 5.0 / 6.0 * ((np.array(without) - found) ** 2).sum(axis=0))


@pytest.mark.parametrize(("left_out", "least", "most"), [((), 0.0, 0.3), (("lag",), 0.7, 1.0)])
def test_standard_errors_exceed_the_models_where_it_lacks_something(known, left_out, least, most):
    problem, centre = Shooting([known[2]], 1.0), MeasuredParameters()
    for effect in left_out:
        centre = centre._replace(**EFFECTS[effect])
    free = list(COEFFICIENTS)
    for effect, neutral in EFFECTS.items():
        if effect not in (*left_out, "amplifier"):
            free += neutral
    theta = problem.fit(np.array(centre), np.array(centre), free)
    own, robust = (np.diag(covariance) for covariance in problem.covariances(theta, np.array(centre), free))
    assert (robust > (1.0 - 1e-9) * own).all()
    assert least <= (robust > 1.01 * own).mean() <= most


def test_each_effect_is_left_out_once_and_added_once():
    cases = ablation_cases()
    added = [effects for title, effects in cases.items() if title.startswith("+")]
    assert [set(after) - set(before) for before, after in zip([[], *added], added)] == [{name} for name in EFFECTS]
    assert [set(EFFECTS) - set(cases[f"all but {name}"]) for name in EFFECTS] == [{name} for name in EFFECTS]


def test_the_command_writes_rig_report_and_pictures(known, tmp_path, capsys):
    known[2].save(tmp_path / "flight.csv")
    for earlier in ("r.json", "flight.png"):
        (tmp_path / earlier).touch()
    args = command.Args(
        (tmp_path / "flight.csv",), out=tmp_path / "mine.toml", json=tmp_path / "r.json", figures=tmp_path, quiet=True
    )
    command.main(args)
    assert Rig.load(tmp_path / "mine.toml").name == "mine"
    report = json.loads((tmp_path / "r.json").read_text())
    for axis in ("travel", "elevation", "pitch"):
        for horizon in ("1.0", "3.0"):
            entry = report["prediction"][axis][horizon]
            assert entry["rms_deg"] < entry["constant_rate_rms_deg"]
    assert report["plant"]["b3"] > 0.0
    assert (tmp_path / "flight.png").read_bytes()
    printed = capsys.readouterr()
    assert "well predicted" in printed.out
    assert f"replaces {tmp_path / 'r.json'}, {tmp_path / 'flight.png'} of" in printed.err


@on_measured_logs
def test_on_measured_flights_the_axes_that_move_are_predicted_better_than_by_the_black_box():
    logs = [FlightLog.load(LOGS / f"ntnu-f-{i}.csv") for i in (1, 3)]
    found = identify(logs)
    v = validate(logs, found, Settings(), (1.0,))
    own, box = pooled(v, 1.0, "model"), pooled(v, 1.0, "black box")
    assert all(a < b for a, b in zip(own, box))
    assert found.parameters.centrifugal == pytest.approx(1.0, abs=0.1)
