from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

torch = pytest.importorskip("torch")

from heli_gym.baselines import make_policy  # noqa: E402
from heli_gym.baselines.control.residual import ResidualPolicy  # noqa: E402
from heli_gym.baselines.evaluation.metrics import flight_metrics  # noqa: E402
from heli_gym.baselines.evaluation.rollout import fly_many  # noqa: E402
from heli_gym.env import find_reference, reference_for  # noqa: E402
from heli_gym.plant import Plant, Push, Sensors, ThrustDrift, Uniform, find_plant  # noqa: E402
from heli_gym.train.apg import AHEAD, SINGLE_GROUPS, Actor, batch_of, network_of, task_of, weights_of  # noqa: E402
from heli_gym.train.flight_gradient import (  # noqa: E402
    LANES,
    LEAST_SPEED,
    LEAST_VOLTAGE,
    N_FLIGHT_FEATURES,
    Batch,
    Rollout,
    Weights,
)
from heli_gym.vector_env import Heli3DOFVectorEnv  # noqa: E402

SHORT, LONG = find_reference("climb-7.5"), find_reference("travel-360")
COUNTS = slice(2, 5)


ON_FLEET = reference_for("climb-7.5", "fleet")


def residual_policy(network=None, scale=4.0, plant="lab", law="saturated", reference=SHORT):
    reference = ON_FLEET if plant == "fleet" else reference
    base = make_policy("feedforward+tvlqr" if plant == "fleet" else "feedforward+tvlqr@lab", reference)
    limits = reference.rig.voltage_limits
    return ResidualPolicy(
        base, reference, network, scale, 0.02, limits, feature_groups=SINGLE_GROUPS, law=law, ahead=AHEAD
    )


def still(features):
    """Actions of no correction."""
    return np.zeros((2, *features.shape[1:]))


def helicopters(plant="lab", reference=SHORT, rig="paper"):
    if plant == "fleet":
        reference, rig = ON_FLEET, "fleet"
    return Heli3DOFVectorEnv(LANES, plant, reference, start_spread_deg=5.0, rig=rig)


def random_weights(task, hidden, dtype, seed=0):
    rng = np.random.default_rng(seed)
    shapes = Weights(
        seen=(3 * hidden, N_FLIGHT_FEATURES),
        preview=(3 * hidden, task.preview.shape[1]),
        hidden=(3 * hidden, hidden),
        input_bias=(3 * hidden,),
        hidden_bias=(3 * hidden,),
        output=(2, hidden),
        output_bias=(2,),
    )
    return Weights(*((0.3 * rng.standard_normal(shape)).astype(dtype) for shape in shapes))


def with_slopes_of_their_own(rollout, weights, batch):
    """Batch of those flights that stay off the slow motors, for which the slopes are bounded on purpose."""
    rollout.forward(weights, batch)
    is_slow = np.abs(rollout.base) < LEAST_VOLTAGE, np.abs(rollout.rotors) < LEAST_SPEED
    fast = np.flatnonzero(~(is_slow[0].any((0, 1)) | is_slow[1].any((0, 1))))
    assert len(fast) >= LANES // 2
    lanes = np.resize(fast, LANES)
    return Batch(*(None if values is None else np.ascontiguousarray(values[..., lanes]) for values in batch))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("plant", "law"), [("lab", "saturated"), ("lab", "sum"), ("rigid", "saturated"), ("fleet", "saturated")]
)
def test_the_gradient_is_that_of_central_differences_where_sensors_are_smooth(plant, law):
    envs = helicopters(plant)
    task = task_of(residual_policy(plant=plant, law=law), envs, 0.5, 1.0)
    task = task._replace(
        v_ref=task.v_ref[:40], gains=task.gains[:40], x_ref=task.x_ref[:41], preview=task.preview[:40].astype(float)
    )
    batch = batch_of(envs, 0)
    batch.body[COUNTS] = 0.0
    weights, rollout = random_weights(task, 5, float), Rollout(task, 5, np.float64)
    batch = with_slopes_of_their_own(rollout, weights, batch)
    outcome = rollout.forward(weights, batch)
    assert rollout.loss(outcome) > 0.1
    gradient = rollout.backward(outcome)
    rng, step = np.random.default_rng(1), 1e-6  # shorter than the way to the next voltage at the amplifier's limits
    for name, value, slope in zip(Weights._fields, weights, gradient):
        direction = rng.standard_normal(value.shape)
        up, down = (
            rollout.loss(rollout.forward(weights._replace(**{name: value + sign * step * direction}), batch))
            for sign in (1.0, -1.0)
        )
        assert (up - down) / (2.0 * step) == pytest.approx((slope * direction).sum(), rel=1e-5, abs=1e-7), name


def test_the_gradient_by_the_first_hidden_states_is_that_of_central_differences():
    task = task_of(residual_policy(), helicopters(), 0.5, 1.0)
    task = task._replace(
        v_ref=task.v_ref[:40], gains=task.gains[:40], x_ref=task.x_ref[:41], preview=task.preview[:40].astype(float)
    )
    batch = batch_of(helicopters(), 0)
    batch.body[COUNTS] = 0.0
    weights, rollout = random_weights(task, 5, float), Rollout(task, 5, np.float64)
    rng, step = np.random.default_rng(1), 1e-6
    hidden, direction = rng.standard_normal((2, 5, LANES))
    batch = with_slopes_of_their_own(rollout, weights, batch._replace(hidden=hidden))
    up, down = (
        rollout.loss(rollout.forward(weights, batch._replace(hidden=batch.hidden + sign * step * direction)))
        for sign in (1.0, -1.0)
    )
    rollout.backward(rollout.forward(weights, batch))
    assert (up - down) / (2.0 * step) == pytest.approx((rollout.d_hidden * direction).sum(), rel=1e-5, abs=1e-8)


@pytest.mark.parametrize("after_crash", [pytest.param(False, marks=pytest.mark.slow), True])
def test_the_gradient_is_that_of_central_differences_where_flights_crash(after_crash):
    task = task_of(residual_policy(), helicopters(), 0.5, 1.0, after_crash=after_crash)
    task = task._replace(
        v_ref=task.v_ref[:40], gains=task.gains[:40], x_ref=task.x_ref[:41], preview=task.preview[:40].astype(float)
    )
    batch = batch_of(helicopters(), 0)
    batch.body[COUNTS] = 0.0
    weights, rollout = random_weights(task, 5, float), Rollout(task, 5, np.float64)
    rollout.forward(weights, batch)
    limit = float(np.median(np.abs(rollout.x[1:, 4]).max(axis=0)))
    settings = task.settings._replace(pitch_limit=limit, pitch_min=-0.5 * limit, pitch_max=0.5 * limit)
    task = task._replace(settings=settings)
    rollout = Rollout(task, 5, np.float64)
    outcome = rollout.forward(weights, batch)
    assert 10 < outcome.crashed.sum() < LANES
    gradient = rollout.backward(outcome)
    rng, step = np.random.default_rng(1), 1e-6
    for name, value, slope in zip(Weights._fields, weights, gradient):
        direction = rng.standard_normal(value.shape)
        up, down = (
            rollout.loss(rollout.forward(weights._replace(**{name: value + sign * step * direction}), batch))
            for sign in (1.0, -1.0)
        )
        assert (up - down) / (2.0 * step) == pytest.approx((slope * direction).sum(), rel=1e-3, abs=1e-6), name


def test_after_a_crash_the_loss_counts_what_the_metrics_do():
    envs = Heli3DOFVectorEnv(LANES, "lab", LONG, start_spread_deg=5.0)
    policy = residual_policy(still, scale=0.0, reference=LONG)
    rollout = Rollout(task_of(policy, envs, 0.5, 1.0, after_crash=True), 3, np.float64)
    nothing = Weights(*map(np.zeros_like, random_weights(rollout.task, 3, float)))
    outcome = rollout.forward(nothing, batch_of(envs, 7))
    metrics = [
        flight_metrics(flight, LONG, envs.voltage_limits, envs.pitch_limit) for flight in fly_many(envs, policy, 7)
    ]
    assert_array_equal(outcome.crashed, [m.crashed for m in metrics])
    assert 0 < outcome.crashed.sum() < LANES
    assert_allclose(outcome.cost, [m.cost for m in metrics], atol=1e-8)
    # the metrics also count the error at the start
    T = len(rollout.task.v_ref)
    start = np.degrees(rollout.x[0] - rollout.task.x_ref[0][:, None])
    for k, rms in enumerate((outcome.travel_deg, outcome.elevation_deg)):
        expected = np.array([m.rms_error_deg[k] for m in metrics])
        assert_allclose(np.sqrt((T * rms**2 + start[2 * k] ** 2) / (T + 1)), expected, atol=1e-8)


def flown(weights, hidden, policy, seed, plant="lab"):
    """The states (6, T + 1, LANES) of compiled flights, and what the environment flies; and both costs."""
    envs = helicopters(plant)
    rollout = Rollout(task_of(residual_policy(plant=plant), envs, 0.5, 1.0), hidden, np.float64)
    outcome = rollout.forward(weights, batch_of(envs, seed))
    flights = fly_many(envs, policy, seed)
    assert not outcome.crashed.any()
    costs = [flight_metrics(flight, policy.reference, envs.voltage_limits).cost for flight in flights]
    return rollout.x.transpose(1, 0, 2), np.stack([f.x for f in flights], axis=-1), outcome.cost, np.array(costs)


@pytest.mark.parametrize("plant", ["lab", pytest.param("rigid", marks=pytest.mark.slow)])
def test_without_a_correction_the_flights_are_those_of_the_base_in_the_environment(plant):
    task = task_of(residual_policy(), helicopters(), 0.5, 1.0)
    nothing = Weights(*map(np.zeros_like, random_weights(task, 3, float)))
    states, expected, cost, expected_cost = flown(nothing, 3, residual_policy(still, scale=0.0), 7, plant)
    assert_allclose(states, expected, atol=1e-9)
    assert_allclose(cost, expected_cost, atol=1e-9)


@pytest.mark.slow
def test_the_flights_of_a_fleet_are_those_of_the_environment_but_for_longer_integration_steps():
    fleet = find_plant("fleet")  # with encoders so fine that none of their counts comes a period early or late
    fleet = replace(fleet, sensors=replace(fleet.sensors, counts=(2**31 - 1,) * 3))
    envs, policy = helicopters(fleet, ON_FLEET, "fleet"), residual_policy(still, scale=0.0, plant="fleet")
    task = task_of(residual_policy(plant="fleet"), envs, 0.5, 1.0)
    nothing = Weights(*map(np.zeros_like, random_weights(task, 3, float)))
    rollout = Rollout(task, 3, np.float64)
    rollout.forward(nothing, batch_of(envs, 7))
    states = rollout.x.transpose(1, 0, 2)
    flights = fly_many(envs, policy, 7)
    flying = [i for i, flight in enumerate(flights) if flight.x.shape[1] == states.shape[1]]
    above = [i for i in flying if flights[i].x[2].max() < np.radians(25.0)]  # the table is left out
    apart = np.array([np.abs(flights[i].x - states[:, :, i]).max() for i in above])
    assert len(above) > 100
    assert np.median(apart) < 1e-5 and (apart < 2e-3).mean() > 0.95 and apart.max() < 0.02


def test_the_flights_are_those_of_the_network_by_numpy_in_the_environment():
    torch.manual_seed(0)
    task = task_of(residual_policy(), helicopters(), 0.5, 1.0)
    actor = Actor(N_FLIGHT_FEATURES + task.preview.shape[1], 16).double()
    with torch.no_grad():
        actor.head.weight.mul_(100.0)
    policy = residual_policy(network_of(actor))
    states, expected, cost, expected_cost = flown(weights_of(actor.parameters()), 16, policy, 7)
    apart = np.abs(states - expected).max(axis=(0, 1))
    assert np.median(apart) < 1e-4  # tanh is approximated, and a count more or less of an encoder makes a difference
    assert apart.max() < 0.05
    assert_allclose(cost, expected_cost, atol=5e-3)


@pytest.mark.parametrize(
    "drift", [ThrustDrift(0.05, time=1.0, duration=20.0), ThrustDrift(0.05, duration=Uniform(4.0, 20.0))]
)
def test_a_drift_that_is_not_linear_over_the_whole_flight_is_refused(drift):
    fleet = find_plant("fleet")
    envs = helicopters(replace(fleet, disturbances=(drift,)), ON_FLEET, "fleet")
    with pytest.raises(ValueError, match=r"plant: ThrustDrift\(.*\) must have time = 0 and a duration of at least 5 s"):
        task_of(residual_policy(plant="fleet"), envs, 0.5, 1.0)


def test_other_plants_and_bases_are_refused():
    for plant in ("nominal", Plant(sensors=Sensors(), disturbances=(Push("pitch", 1.0, 1.0),))):
        with pytest.raises(ValueError, match="plant: must have"):
            task_of(residual_policy(), helicopters(plant), 0.5, 1.0)
    base = make_policy("kalman-lqr", SHORT)
    with pytest.raises(ValueError, match="base: must be"):
        task_of(
            ResidualPolicy(base, SHORT, None, 1.0, feature_groups=SINGLE_GROUPS, ahead=AHEAD), helicopters(), 0.5, 1.0
        )
