"""Rollouts: true trajectories of any policy, wrapped or not."""

import math
from dataclasses import dataclass, field, replace

import gymnasium as gym
import numpy as np
import pytest
from independent import equation_3, inputs
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import solve_ivp

from heli_gym import Maneuver, Trajectory
from heli_gym.baselines import POLICIES, ManeuverSampler, fly, make_policy, plan
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import check_policy, fly_many, fly_repeatedly
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.rig import PAPER
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("travel-360")


@dataclass
class Scripted:
    """A policy that plays voltages and notes what it was shown."""

    voltages: np.ndarray  # (2,), or (2, K) one after the other
    shown: list = field(default_factory=list)
    drawn: list = field(default_factory=list)

    def reset(self, rng):
        self.shown.clear()
        self.drawn.append(rng.random())

    def __call__(self, t, measurement):
        k = len(self.shown)
        self.shown.append((t, measurement))
        return self.voltages if np.ndim(self.voltages) == 1 else self.voltages[:, k]


@pytest.fixture(scope="module")
def wobble() -> np.ndarray:
    """Voltages for a flight at 20 ms that stays upright."""
    return 7.5 + 0.4 * np.random.default_rng(0).uniform(-1.0, 1.0, (2, 500))


def test_a_flight_is_the_reset_state_and_one_state_and_voltage_per_step(wobble):
    env = Heli3DOFEnv(start_spread_deg=5.0)
    flight = fly(env, Scripted(wobble), seed=3)
    assert isinstance(flight, Trajectory)
    assert flight.limits == REFERENCE.limits
    n = flight.t.size - 1
    assert_allclose(flight.t, 0.02 * np.arange(n + 1), atol=1e-12)
    assert_array_equal(flight.x[:, 0], env.reset(seed=3)[1]["state"])
    assert_allclose(flight.u[:, :-1], wobble[:, :n], atol=1e-12)
    for k in range(n):
        *_, info = env.step(env.unwrapped.to_action(wobble[:, k]))
        assert_allclose(info["state"], flight.x[:, k + 1], atol=1e-9)


def test_each_voltage_is_held_from_its_time_to_the_next(wobble):
    flight = fly(Heli3DOFEnv(start_spread_deg=5.0), Scripted(wobble), seed=3)
    for k in (0, 1, 50, 99):
        v = inputs(flight.u[:, k])
        span = flight.t[k], flight.t[k + 1]
        exact = solve_ivp(lambda t, x, v=v: equation_3(x, *v), span, flight.x[:, k], "DOP853", rtol=1e-12, atol=1e-14)
        assert_allclose(exact.y[:, -1], flight.x[:, k + 1], atol=1e-9)


def test_a_policy_is_shown_the_time_and_the_measurement_of_each_step(wobble):
    policy = Scripted(wobble)
    flight = fly(Heli3DOFEnv(start_spread_deg=5.0), policy, seed=3)
    times, measurements = zip(*policy.shown)
    assert_allclose(times, flight.t[:-1], atol=1e-12)
    assert_array_equal(np.transpose(measurements), flight.x[:, :-1])  # on the nominal plant the state itself


def test_the_amplifier_saturates_a_policys_voltages():
    flight = fly(Heli3DOFEnv(), Scripted(np.array([20.0, 19.0])))
    assert_array_equal(flight.u, 12.0)


def test_the_seed_is_that_of_the_episode_and_of_the_policy():
    env, policy = Heli3DOFEnv(start_spread_deg=5.0), Scripted(np.full(2, 7.0))
    first, again, other = (fly(env, policy, seed=seed) for seed in (1, 1, 2))
    assert_array_equal(first.x, again.x)
    assert not np.array_equal(first.x[:, 0], other.x[:, 0])
    assert policy.drawn[0] == policy.drawn[1] != policy.drawn[2]


def test_options_reach_the_environment():
    start = [0.1, 0.2, -0.1, -0.2, 0.3, 0.0]
    assert_array_equal(fly(Heli3DOFEnv(), Scripted(np.zeros(2)), options={"state": start}).x[:, 0], start)


def test_a_wrapped_environment_is_flown_as_the_bare_one():
    policy = make_policy("feedforward+tvlqr", REFERENCE)
    wrapped = gym.wrappers.RecordEpisodeStatistics(gym.make("Heli3DOF-v0", start_spread_deg=5.0))
    bare = Heli3DOFEnv(start_spread_deg=5.0)
    flights = [fly(env, policy, seed=4) for env in (wrapped, bare)]
    for name in ("t", "x", "u"):
        assert_array_equal(*(getattr(flight, name) for flight in flights))
    assert wrapped.episode_count == 1


def test_a_time_limit_ends_a_flight_early():
    env = gym.wrappers.TimeLimit(Heli3DOFEnv(), 30)
    assert fly(env, Scripted(np.full(2, 7.9))).duration == pytest.approx(0.6)


def test_a_crash_ends_a_flight():
    flight = fly(Heli3DOFEnv(), Scripted(np.array([12.0, 0.0])))
    assert flight.duration < 2.0
    assert abs(flight.x[4, -2]) <= math.radians(80.0) < abs(flight.x[4, -1])


def test_another_maneuver_is_planned_and_flown_end_to_end():
    maneuver = Maneuver(start=(0.5, 0.05), goal=(2.0, -0.1), duration=6.0)
    reference = plan(maneuver)
    flight = fly(Heli3DOFEnv(reference=reference), make_policy("feedforward+tvlqr", reference))
    metrics = flight_metrics(flight, reference, (0.0, 12.0))
    assert metrics.success
    assert max(metrics.rms_error_deg) < 0.05
    assert_allclose(flight.x[:, -1], [2.0, 0.0, -0.1, 0.0, 0.0, 0.0], atol=1e-3)


# What is refused


def test_a_policy_for_another_control_period_is_refused():
    policy = make_policy("open-loop", REFERENCE, 0.01)
    with pytest.raises(ValueError, match=r"policy.*0\.01 s.*0\.02 s"):
        fly(Heli3DOFEnv(control_period=0.02), policy)


FLIGHTS = {  # one helicopter, and many
    "fly": lambda policy, **arguments: fly(Heli3DOFEnv(**arguments), policy, seed=0),
    "fly_many": lambda policy, **arguments: fly_many(Heli3DOFVectorEnv(2, **arguments), policy, seed=0),
}


@pytest.mark.parametrize("flown", FLIGHTS.values(), ids=FLIGHTS)
def test_flights_that_start_at_random_times_are_refused(flown):
    # their times would not be those of the reference, and their errors nonsense
    with pytest.raises(ValueError, match=r"starts? at its"):
        flown(make_policy("feedforward+tvlqr", REFERENCE), random_start=True)


@pytest.mark.parametrize("flown", FLIGHTS.values(), ids=FLIGHTS)
@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("open-loop", "TrackingPolicy"),
        ("feedforward+tvlqr", "TrackingPolicy"),
        ("lqi", "ModelPolicy"),
        ("residual", "ResidualPolicy"),
    ],
)
@pytest.mark.parametrize(
    ("reference", "said"),
    [("travel-180", "another reference than env's.* rad"), ("climb-15", "a reference of 10 s, and env's takes 7 s")],
)
def test_a_policy_for_another_reference_is_refused(flown, name, kind, reference, said):
    with pytest.raises(ValueError, match=f"policy: this {kind} was made for {said}"):
        flown(make_policy(name, REFERENCE), reference=reference)


def test_a_policy_is_compared_with_the_reference_that_is_drawn():
    env = Heli3DOFEnv(reference=ManeuverSampler())
    env.reset(seed=1)
    policy = make_policy("feedforward+tvlqr", env.reference)
    assert flight_metrics(fly(env, policy, seed=1), env.reference, env.voltage_limits).success
    with pytest.raises(ValueError, match="another reference"):
        fly(env, policy, seed=2)


def test_a_reference_that_is_solved_again_is_the_same():
    x = REFERENCE.x + 1e-4 * np.random.default_rng(0).uniform(-1.0, 1.0, REFERENCE.x.shape)
    again = Trajectory(REFERENCE.t, x, REFERENCE.u)
    assert fly(Heli3DOFEnv(), make_policy("feedforward+tvlqr", again)).duration == pytest.approx(10.0)


@pytest.mark.parametrize("flown", FLIGHTS.values(), ids=FLIGHTS)
def test_a_policy_for_another_amplifier_is_refused(flown):
    policy = make_policy("lqi", REFERENCE)
    with pytest.raises(ValueError, match=r"policy: this ModelPolicy .* 0 to 12 V, .* 1 to 10 V"):
        flown(policy, voltage_limits=(1.0, 10.0))
    policy.voltage_limits = (1.0, 10.0)
    flown(policy, voltage_limits=(1.0, 10.0))


@pytest.mark.parametrize("name", [name for name in POLICIES if name not in ("zero", "middle-voltage")])
def test_a_policy_for_another_rig_is_refused_by_name(name):
    if name == "linear-mpc":
        pytest.importorskip("osqp")
    other = replace(PAPER, name="other", parameters=PAPER.parameters._replace(a3=0.02))
    env = Heli3DOFEnv(reference=replace(REFERENCE, rig=other), rig=other)
    with pytest.raises(ValueError, match="is for the rig 'paper', and env's is 'other'"):
        check_policy(make_policy(name, REFERENCE), env, env.reference)


def test_repeated_flights_on_another_rig_are_refused():
    other = replace(PAPER, name="other", parameters=PAPER.parameters._replace(a3=0.02))
    with pytest.raises(ValueError, match="is for the rig 'paper', and env's is 'other'"):
        fly_repeatedly(Heli3DOFEnv(reference=replace(REFERENCE, rig=other), rig=other), make_policy("lqi", REFERENCE))


@pytest.mark.parametrize("policy", [make_policy("zero", REFERENCE), Scripted(np.full(2, 7.9))])
def test_a_policy_that_was_made_for_no_reference_or_amplifier_flies_any(policy):
    if isinstance(policy, Scripted):
        policy.x = np.zeros(6)  # what a user calls x is the user's own
    fly(Heli3DOFEnv(reference="climb-15", voltage_limits=(1.0, 10.0)), policy)


@pytest.mark.parametrize("make", [lambda: gym.make("Pendulum-v1"), lambda: gym.make_vec("Heli3DOF-v0", 2)])
def test_an_environment_that_is_not_one_helicopter_is_refused(make):
    with pytest.raises(ValueError, match=r"env = .*Heli3DOF"):
        fly(make(), Scripted(np.zeros(2)))


@pytest.mark.parametrize("voltages", [np.array([math.nan, 7.0]), np.zeros(3)])
def test_voltages_that_are_not_two_finite_numbers_are_refused(voltages):
    with pytest.raises(ValueError, match="action = "):
        fly(Heli3DOFEnv(), Scripted(voltages))
