"""Controllers: exact on the reference, and effective off it."""

import functools
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from independent import TABLE_I, hover, inputs
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import HelicopterParameters
from heli_gym.baselines import POLICIES, fly, make_policy, riccati_gains
from heli_gym.baselines.control.adaptive_filter import LAG
from heli_gym.baselines.control.estimation import IDEAL, Actuator
from heli_gym.baselines.control.model_based import kalman_lqr, lag_lqi, lag_lqr
from heli_gym.baselines.control.weights import LAG_LQR, LQI, TVLQR, WEIGHTS, store_weights
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.plant import Plant, Push, Rotors
from heli_gym.rig import PAPER, find_rig
from heli_gym.task import to_action
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("travel-360")
PERIODS = [0.001, 0.005, 0.02]
CORNER = np.radians([5.0, 0.0, -5.0, 0.0, 5.0, 0.0])
SEEDS = range(6)
FORGETFUL = ["open-loop", "feedforward+tvlqr", "hover-lqr", "zero"]
REMEMBERING = ["lqi", "lag-lqr", "lag-lqi", "kalman-lqr"]
LAG_AWARE = ["lag-lqr", "lag-lqi", "kalman-lqr"]
LAGGING = Plant(rotors=Rotors(lag=Actuator().lag, delay=0.02 * Actuator().delay))  # what the lag-aware ones assume


@functools.cache
def the_papers(control_period: float = 0.02):
    return make_policy("feedforward+tvlqr", REFERENCE, control_period)


@pytest.fixture(scope="module")
def perturbed():
    """Flights at 20 ms from the same starts up to 5 degrees off, by policy."""
    env = Heli3DOFEnv(start_spread_deg=5.0)
    policies = {name: make_policy(name, REFERENCE) for name in FORGETFUL}
    return {name: [fly(env, policy, seed=seed) for seed in SEEDS] for name, policy in policies.items()}


def metrics(flights):
    return [flight_metrics(flight, REFERENCE, (0.0, 12.0)) for flight in flights]


# In flight


@pytest.mark.parametrize("control_period", PERIODS)
def test_on_the_nominal_plant_the_papers_controller_stays_within_a_twentieth_of_a_degree(control_period):
    env = Heli3DOFEnv(control_period=control_period)
    [flown] = metrics([fly(env, the_papers(control_period))])
    assert flown.success
    assert flown.flown == pytest.approx(10.0)
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize("control_period", PERIODS)
def test_from_a_perturbed_start_the_papers_controller_converges(control_period):
    env = Heli3DOFEnv(control_period=control_period)
    start = REFERENCE.x[:, 0] + CORNER
    flight = fly(env, the_papers(control_period), options={"state": start})
    error = np.abs(flight.x - REFERENCE(flight.t)[0])
    assert flight.duration == pytest.approx(10.0)
    assert error[:, -1].max() < 1e-4  # rad and rad/s, on every axis


def test_from_every_drawn_start_the_papers_controller_converges(perturbed):
    for flight in perturbed["feedforward+tvlqr"]:
        assert flight.duration == pytest.approx(10.0)
        assert np.abs(flight.x[:, -1] - REFERENCE.x[:, -1]).max() < 1e-4


def test_from_a_perturbed_start_the_feedforward_alone_does_not_converge(perturbed):
    for flight, flown in zip(perturbed["open-loop"], metrics(perturbed["open-loop"])):
        start, end = (np.abs(flight.x[0::2, k] - REFERENCE.x[0::2, k]).max() for k in (0, -1))
        assert end > 0.5 * start
        assert not flown.success


def test_the_papers_controller_beats_the_others_from_every_start(perturbed):
    papers = metrics(perturbed["feedforward+tvlqr"])
    for name in ("open-loop", "hover-lqr", "zero"):
        for ours, other in zip(papers, metrics(perturbed[name])):
            assert ours.episode_return > 1.3 * other.episode_return
            travel, elevation, _ = zip(ours.rms_error_deg, other.rms_error_deg)
            assert travel[0] < travel[1]
            assert elevation[0] < elevation[1]


def test_the_feedforward_alone_flies_the_maneuver_from_the_exact_start():
    [flown] = metrics([fly(Heli3DOFEnv(), make_policy("open-loop", REFERENCE))])
    assert flown.success
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize(
    ("name", "tolerance"),
    [
        ("feedforward+tvlqr", 1e-3),
        ("hover-lqr", 1e-3),
        *((name, 1e-2) for name in REMEMBERING),
    ],  # integrals take longer
)
@pytest.mark.parametrize("elevation", [-0.1, 0.0, 0.15])
def test_the_regulators_hold_hover_at_any_elevation(name, tolerance, elevation):
    reference = hover(12.0, elevation)
    start = reference.x[:, 0] + CORNER
    flight = fly(Heli3DOFEnv(reference=reference), make_policy(name, reference), options={"state": start})
    assert_allclose(flight.x[:, -1], reference.x[:, -1], atol=tolerance)


def test_on_the_nominal_plant_integral_action_costs_no_accuracy():
    [papers, integral] = metrics([fly(Heli3DOFEnv(), make_policy(name, REFERENCE)) for name in list(WEIGHTS)[:2]])
    assert max(integral.rms_error_deg) < max(papers.rms_error_deg) + 0.01


@pytest.mark.parametrize("name", LAG_AWARE)
def test_on_the_plant_that_they_assume_the_lag_aware_ones_follow_the_reference(name):
    [flown] = metrics([fly(Heli3DOFEnv(LAGGING), make_policy(name, REFERENCE))])
    assert flown.success
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize("name", LAG_AWARE)
def test_knowing_of_the_lag_is_worth_a_lot_where_there_is_one(name):
    env = Heli3DOFEnv(LAGGING, start_spread_deg=5.0)
    aware, papers = (
        metrics([fly(env, policy, seed=seed) for seed in range(3)])
        for policy in (make_policy(name, REFERENCE), the_papers())
    )
    for ours, plain in zip(aware, papers):
        assert ours.episode_return > plain.episode_return + 0.5


@pytest.mark.parametrize("design", [lag_lqr, lag_lqi, kalman_lqr])
def test_on_the_nominal_plant_a_model_without_lag_and_delay_flies_as_well_as_the_papers(design):
    policy = design(REFERENCE, 0.02, HelicopterParameters(), actuator=IDEAL)
    [flown] = metrics([fly(Heli3DOFEnv(), policy)])
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize(
    ("name", "axis"), [(n, a) for n in ("lqi", "lag-lqi", "kalman-lqr") for a in ("elevation", "travel")]
)
def test_against_a_lasting_push_integrals_and_the_observer_leave_no_offset_but_the_papers_does(name, axis):
    reference = hover(40.0)
    rotors = Rotors() if name == "lqi" else LAGGING.rotors
    pushed = Plant(rotors=rotors, disturbances=(Push(axis, acceleration=0.05, time=1.0, duration=100.0),))
    row = {"travel": 0, "elevation": 2}[axis]
    offsets = []
    for controller in (name, "feedforward+tvlqr"):
        flight = fly(Heli3DOFEnv(pushed, reference=reference), make_policy(controller, reference))
        assert flight.duration == pytest.approx(40.0)
        offsets.append(abs(math.degrees(flight.x[row, -1])))
    assert offsets[0] < 0.05
    assert offsets[1] > 0.2


@pytest.mark.parametrize("time", [3.0, 5.0])
def test_a_flight_that_begins_in_the_middle_settles_as_one_from_the_start_does(time):
    rms = {}
    for name in ("feedforward+tvlqr", "kalman-lqr"):
        envs = Heli3DOFVectorEnv(20, start_spread_deg=5.0, autoreset_mode="SameStep")
        _, info = envs.reset(seed=0, options={"time": np.full(20, time)})
        policy, squares = make_policy(name, REFERENCE), []
        for _ in range(200):
            u = policy(info["time"], info["measurement"].T)
            *_, info = envs.step(to_action(u, (0.0, 12.0), envs.hover_voltage).T)
            squares.append((info["state"].T - REFERENCE(info["time"])[0])[0:3:2] ** 2)
        rms[name] = np.sqrt(np.mean(squares, axis=(0, 2)))
    assert (rms["kalman-lqr"] < 1.5 * rms["feedforward+tvlqr"]).all()


def test_flights_that_begin_in_different_periods_are_those_of_each_alone():
    times = np.array([0.0, 2.0, 2.5])
    measured = np.random.default_rng(0).normal(0.0, 0.02, (8, 6, 3))
    together = make_policy("kalman-lqr", REFERENCE)
    voltages = [together(times + 0.02 * k, REFERENCE(times + 0.02 * k)[0] + measured[k]) for k in range(8)]
    for i, time in enumerate(times):
        alone = make_policy("kalman-lqr", REFERENCE)
        for k in range(8):
            t = time + 0.02 * k
            assert_allclose(alone(t, REFERENCE(t)[0] + measured[k, :, i]), voltages[k][:, i], atol=1e-9)


# As functions


@pytest.mark.parametrize("name", POLICIES)
def test_every_policy_gives_two_voltages_at_any_time(name):
    policy = make_policy(name, REFERENCE)
    policy.reset(np.random.default_rng(0))
    for t in (0.0, 0.02, 5.0, 10.0, 10.02):
        u = policy(t, REFERENCE(t)[0] + CORNER)
        assert u.shape == (2,)
        assert np.isfinite(u).all()


@pytest.mark.parametrize("name", FORGETFUL)
def test_a_policy_without_memory_repeats_its_voltages(name):
    policy = make_policy(name, REFERENCE)
    assert_array_equal(policy(5.0, CORNER), policy(5.0, CORNER))


def answers(policy, measurements) -> np.ndarray:
    """Voltages (2, ..., T) over the first control periods of a flight that is measured so (T, 6, ...)."""
    policy.reset(np.random.default_rng(0))
    return np.stack([policy(0.02 * k, measured) for k, measured in enumerate(measurements)], axis=-1)


@pytest.mark.parametrize("name", POLICIES)
def test_a_policy_flies_each_of_many_as_if_alone(name):
    policy = make_policy(name, REFERENCE)
    t = 0.02 * np.arange(12)
    flights = np.random.default_rng(5).normal(scale=0.05, size=(12, 6, 3)) + REFERENCE(t)[0].T[:, :, None]
    together = answers(policy, flights)
    assert together.shape == (2, 3, 12)
    tolerance = 1e-7 if name == "adaptive-lqr" else 1e-12  # differences in its filter magnify rounding
    for k in range(3):
        assert_allclose(together[:, k], answers(policy, flights[:, :, k]), rtol=tolerance, atol=tolerance)


@pytest.mark.parametrize("name", REMEMBERING)
def test_after_a_reset_a_policy_remembers_nothing(name):
    policy = make_policy(name, REFERENCE)
    t = 0.02 * np.arange(8)
    flight = REFERENCE(t)[0].T + CORNER
    first = answers(policy, flight)
    assert_array_equal(answers(policy, flight), first)


def test_while_the_amplifier_saturates_nothing_is_integrated():
    policy = make_policy("lqi", REFERENCE)
    policy.reset(np.random.default_rng(0))
    far = REFERENCE(0.0)[0] + np.array([0.0, 0.0, 1.0, 1.0, 0.0, 0.0])  # 57 degrees too low: more than 12 V
    assert (policy(0.0, far) > 12.0).any()
    assert_array_equal(policy.memory.integral, 0.0)
    policy(0.02, REFERENCE(0.02)[0] + 0.1 * CORNER)
    assert_allclose(policy.memory.integral, 0.02 * 0.1 * CORNER[[0, 2]], rtol=1e-6, atol=1e-9)


def test_the_lag_aware_feedforward_leads_by_the_lag():
    policy = lag_lqr(REFERENCE, 0.02, HelicopterParameters(), actuator=Actuator(lag=0.1, delay=0))
    u, command = policy.regulator.u, policy.regulator.command
    rotors = u[:, 0]
    for k in range(policy.x.shape[1] - 1):
        assert_allclose(rotors, u[:, k], atol=0.15)  # V
        rotors = command[:, k] + (rotors - command[:, k]) * math.exp(-0.02 / 0.1)


@pytest.mark.parametrize(("name", "weights"), [("lqi", TVLQR), ("lag-lqr", LQI), ("zero", TVLQR)])
def test_weights_of_another_policy_are_refused(name, weights):
    with pytest.raises(ValueError, match=f"weights = .*for '{name}'"):
        make_policy(name, REFERENCE, weights=weights)


def test_weights_are_stored_for_a_plant_and_flown_from_there(tmp_path, monkeypatch):
    monkeypatch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path)
    with pytest.raises(ValueError, match=r"'lqi@moon': no weights are stored .* in .*moon.json"):
        make_policy("lqi@moon", REFERENCE)
    weights = replace(LQI, travel=12.5)
    store_weights("lqi", "moon", weights)
    store_weights("lag-lqr", "moon", LAG_LQR)
    measured = REFERENCE(0.0)[0] + CORNER
    stored, given = make_policy("lqi@moon", REFERENCE), make_policy("lqi", REFERENCE, weights=weights)
    assert_array_equal(stored(0.0, measured), given(0.0, measured))
    assert not np.allclose(stored(0.0, measured), make_policy("lqi", REFERENCE)(0.0, measured))


TUNED = [name for name in WEIGHTS if name != "linear-mpc"]  # whose search would take hours


@pytest.mark.parametrize("name", [f"{name}@{plant}" for name in TUNED for plant in ("lab", "rigid")])
def test_the_package_has_weights_of_each_for_both_plants(name):
    assert np.isfinite(make_policy(name, REFERENCE)(0.0, REFERENCE(0.0)[0])).all()


@pytest.mark.parametrize("name", ["kalman-lqr", "lag-lqi"])
def test_a_model_that_runs_along_saturates_at_the_amplifier_of_the_policy(name):
    policy = make_policy(name, REFERENCE, voltage_limits=(0.0, 9.0))
    policy(0.0, REFERENCE(0.0)[0] + np.array([0.0, 0.0, 0.8, 0.0, 0.0, 0.0]))
    assert policy.voltage_limits == (0.0, 9.0)
    assert max(map(np.max, policy.memory.pending)) <= 9.0


def test_a_residual_policy_corrects_the_base_as_the_amplifier_that_it_is_made_for_saturates_it():
    policy = make_policy("residual", REFERENCE, voltage_limits=(0.0, 9.0))
    measurement = REFERENCE(0.0)[0] + np.array([0.0, 0.0, 0.8, 0.0, 0.0, 0.0])
    u_base = policy.base(0.0, measurement)
    assert u_base.max() > 9.0
    assert (np.abs(policy(0.0, measurement) - np.clip(u_base, 0.0, 9.0)) <= policy.scale).all()


@pytest.mark.parametrize("delay", [0, 1, 3])
@pytest.mark.parametrize("name", ["lag-lqr", "kalman-lqr", "adaptive-lqr", "l1-adaptive", "lag-lqr+safe"])
def test_voltages_that_were_applied_in_place_of_its_own_turn_the_rotors_of_a_policys_model(name, delay):
    rig = replace(PAPER, delay=0.02 * delay)
    reference = replace(REFERENCE, rig=rig)
    policy, x = make_policy(name, reference, rig=rig), REFERENCE(0.0)[0]
    start = policy.init(0.0, x)
    own, after = policy.step(start, 0.0, x)
    applied = np.array([3.0, 11.0])
    changed = policy.with_applied_input(after, applied)
    unchanged = policy.with_applied_input(changed, own)
    for k in range(1, delay + 1):
        changed, unchanged = (policy.step(memory, 0.02 * k, x)[1] for memory in (changed, unchanged))
        after = policy.step(after, 0.02 * k, x)[1]
    assert_array_equal(unchanged.rotors, after.rotors)
    lag = rig.lag if name != "adaptive-lqr" else changed.estimate.s[LAG, 0]
    share = 1.0 - math.exp(-0.02 / lag)
    difference = (changed.rotors - unchanged.rotors).reshape(2)
    assert_allclose(difference, share * (applied - own), rtol=2e-2 if name == "adaptive-lqr" else 1e-9)


def test_a_model_based_design_has_the_amplifier_of_its_rig():
    rig = find_rig("ntnu")
    assert lag_lqr(replace(REFERENCE, rig=rig), 0.02, rig).voltage_limits == rig.voltage_limits


def test_the_middle_voltage_is_that_of_the_amplifier():
    assert_array_equal(make_policy("middle-voltage", REFERENCE, voltage_limits=(-24.0, 24.0))(0.0, CORNER), 0.0)
    assert_array_equal(make_policy("middle-voltage", REFERENCE)(0.0, CORNER), 6.0)


@pytest.mark.parametrize("control_period", [math.nan, math.inf, 0.0, -0.02, 10**400, "0.02", None])
def test_a_control_period_that_is_not_positive_and_finite_is_refused(control_period):
    with pytest.raises(ValueError, match="control_period = "):
        make_policy("lqi", REFERENCE, control_period)


@pytest.mark.parametrize("voltage_limits", [(math.nan, 1.0), (0.0, math.inf), (12.0, 0.0), (1.0,), (0.0, 10**400)])
def test_voltage_limits_that_are_not_finite_and_increasing_are_refused(voltage_limits):
    with pytest.raises(ValueError, match="voltage_limits = "):
        make_policy("lqi", REFERENCE, voltage_limits=voltage_limits)


def test_a_step_depends_on_the_memory_it_is_given_alone():
    policy = make_policy("kalman-lqr", REFERENCE)
    start = policy.init(0.0, REFERENCE(0.0)[0])
    u, later = policy.step(start, 0.0, REFERENCE(0.0)[0] + CORNER)
    policy.step(later, 0.02, REFERENCE(0.02)[0] - CORNER)
    assert policy.memory is None
    again, _ = policy.step(start, 0.0, REFERENCE(0.0)[0] + CORNER)
    assert_array_equal(again, u)


@pytest.mark.parametrize("name", WEIGHTS)
def test_the_weights_of_a_policy_are_those_it_is_made_with_by_default(name):
    measured = REFERENCE(0.0)[0] + CORNER
    default, given = make_policy(name, REFERENCE), make_policy(name, REFERENCE, weights=WEIGHTS[name])
    assert_array_equal(default(0.0, measured), given(0.0, measured))


@pytest.mark.parametrize("name", ["open-loop", "feedforward+tvlqr"])
@pytest.mark.parametrize("control_period", [0.02, 0.03])
def test_on_the_reference_nothing_is_corrected(name, control_period):
    policy = make_policy(name, REFERENCE, control_period)
    for k in range(0, round(10.0 / control_period), 7):
        t = k * control_period
        x, u = REFERENCE(t)[0], REFERENCE(t + 0.5 * control_period)[1]  # the voltages of the middle of the period
        assert_allclose(policy(t, x), u, atol=1e-9)


def test_off_the_reference_the_correction_of_the_thrusts_is_the_gain_times_the_error():
    gains = riccati_gains(REFERENCE)
    for t in (0.0, 2.5, 5.0, 9.98):
        x, u = REFERENCE(t)[0], REFERENCE(t + 0.01)[1]
        for error in (*(1e-3 * np.eye(6)), CORNER):
            v = inputs(the_papers()(t, x + error))
            assert_allclose(v - inputs(u), -gains(t) @ error, atol=1e-9)


def test_open_loop_does_not_look_at_the_measurement():
    policy = make_policy("open-loop", REFERENCE)
    assert_array_equal(policy(3.0, np.zeros(6)), policy(3.0, CORNER))


def test_hover_lqr_asks_for_hover_on_the_reference_and_for_the_stationary_gain_off_it():
    policy = make_policy("hover-lqr", REFERENCE)
    stationary = riccati_gains(hover(1.0))(0.0)
    each = math.sqrt(-0.5 * TABLE_I.a2 / TABLE_I.b2 / TABLE_I.k_plus)
    for t in (0.0, 4.0, 9.0):
        x = REFERENCE(t)[0]
        assert_allclose(policy(t, x), each, atol=1e-9)
        assert_allclose(inputs(policy(t, x + CORNER)) - inputs(np.full(2, each)), -stationary @ CORNER, atol=1e-9)


def test_zero_is_no_voltage():
    assert_array_equal(make_policy("zero", REFERENCE)(1.0, CORNER), 0.0)


def test_a_policy_believes_in_the_parameters_it_is_given():
    twice = HelicopterParameters()._replace(k_plus=2.0 * HelicopterParameters().k_plus)
    hovering = make_policy("hover-lqr", REFERENCE, parameters=twice)(0.0, REFERENCE.x[:, 0])
    assert_allclose(hovering, make_policy("hover-lqr", REFERENCE)(0.0, REFERENCE.x[:, 0]) / math.sqrt(2.0))


@pytest.mark.parametrize("name", ["lqr", "", "Zero", None])
def test_an_unknown_policy_is_named_with_those_that_there_are(name):
    with pytest.raises(ValueError, match=re.escape(f"name = {name!r}") + ".*'feedforward\\+tvlqr'"):
        make_policy(name, REFERENCE)
