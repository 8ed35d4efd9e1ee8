"""Odd values are refused by the name of the argument, everywhere, and what is accepted flies finitely."""

import math
import tracemalloc

import gymnasium as gym
import numpy as np
import pytest

from heli_gym import HelicopterParameters, Limits, Maneuver, Rig, Trajectory
from heli_gym.baselines import ManeuverSampler, fly, make_policy, plan, plan_fastest, riccati_gains
from heli_gym.baselines.evaluation.scoring import evaluate
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.plant import (
    PLANTS,
    Friction,
    Gust,
    MovingMass,
    OneOf,
    Plant,
    Push,
    Rotors,
    Sensors,
    Table,
    ThrustDrift,
    Uniform,
)
from heli_gym.simulation.simulation import BLOCK_COPIES, TABLE_COPIES
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustMap
from heli_gym.validation import is_number, real_array, shown
from heli_gym.vector_env import Heli3DOFVectorEnv

REFERENCE = find_reference("climb-15")
TWO = np.zeros((2, 2)), np.zeros((6, 2))
ODD = [10**400, 10**5000, "1", None, 1j, [], math.nan, b"1", {}]
# each with the argument's name, which the message must have
CALLS = [
    ("u_min", lambda v: Limits(u_min=v)),
    ("pitch_max", lambda v: Limits(pitch_max=v)),
    ("duration", lambda v: Maneuver(duration=v)),
    ("start", lambda v: Maneuver(start=(v, 0.0))),
    ("goal_state", lambda v: Maneuver(goal_state=(v, 0, 0, 0, 0, 0))),
    ("floor", lambda v: Maneuver(floor=((0, v), (0, 1)))),
    ("b1", lambda v: Maneuver(parameters=HelicopterParameters(b1=v))),
    ("lag", lambda v: Rig("x", lag=v)),
    ("voltage_limits", lambda v: Rig("x", voltage_limits=(0, v))),
    ("encoder_counts", lambda v: Rig("x", encoder_counts=(v, 1, 1))),
    ("k_plus", lambda v: Rig("x", thrust_map=ThrustMap(PowerCurve(v), PowerCurve(v)))),
    ("voltages", lambda v: Rig("x", thrust_map=ThrustMap(TableCurve((0, v), (0, 1)), TableCurve((0, v), (0, 1))))),
    ("body", lambda v: Rig.from_masses("x", body=v, counterweight=1, arm=1, counterweight_arm=1, rotor_arm=1)),
    (r"^t( =| is| must)", lambda v: Trajectory([0, v], TWO[1], TWO[0])),
    ("limits", lambda v: Trajectory([0, 1], TWO[1], TWO[0], limits=v)),
    ("lag", lambda v: Rotors(lag=v)),
    ("viscous", lambda v: Friction(viscous=(0.0, 0.0, v))),
    ("noise", lambda v: Sensors(noise=v)),
    ("Uniform", lambda v: Uniform(0.0, v)),
    ("control_period", lambda v: make_policy("lqi", REFERENCE, v)),
    ("voltage_limits", lambda v: make_policy("lqi", REFERENCE, voltage_limits=(0, v))),
    ("reference", lambda v: make_policy("lqi", v)),
    ("name", lambda v: make_policy(v, REFERENCE)),
    ("reference", lambda v: Heli3DOFEnv(reference=v)),
    ("maneuver", lambda v: plan(v)),
    ("reserve", lambda v: plan_fastest(Maneuver(), reserve=v)),
    ("method", lambda v: plan(Maneuver(), v)),
    ("duration", lambda v: ManeuverSampler(v)),
    ("travel", lambda v: ManeuverSampler(travel=v)),
    ("episodes", lambda v: evaluate("zero", episodes=v)),
    ("start_spread_deg", lambda v: Heli3DOFEnv(start_spread_deg=v)),
    ("control_period", lambda v: Heli3DOFEnv(control_period=v)),
    ("num_envs", lambda v: Heli3DOFVectorEnv(v)),
    ("env", lambda v: fly(v, None)),
]


@pytest.mark.parametrize("value", ODD, ids=["10**400", "10**5000", *map(repr, ODD[2:])])
@pytest.mark.parametrize(("name", "call"), CALLS, ids=[f"{k}-{name}" for k, (name, _) in enumerate(CALLS)])
def test_an_odd_value_is_refused_by_the_name_of_the_argument(name, call, value):
    with pytest.raises(ValueError, match=name) as error:
        call(value)
    assert len(str(error.value)) < 1500


@pytest.mark.parametrize("value", [10**400, "1", None, 1j, {}, b"1"])
def test_conversions_and_lookups_refuse_odd_values(value):
    env = Heli3DOFEnv()
    with pytest.raises(ValueError, match="action = "):
        env.to_voltage([value, value])
    with pytest.raises(ValueError, match="u = "):
        env.to_action([value, value])
    with pytest.raises(ValueError, match="t = "):
        REFERENCE(value)


def test_a_reference_too_long_for_gains_along_it_is_refused_by_name():
    days = Trajectory([0.0, 1e5], *TWO[::-1])
    with pytest.raises(ValueError, match=r"reference = a Trajectory of 100000 s: must be of at most 10000 s"):
        make_policy("feedforward+tvlqr", days)
    with pytest.raises(ValueError, match=r"reference = a Trajectory of 100000 s: must be of at most 10000 s"):
        riccati_gains(days)


@pytest.mark.parametrize("load", [Trajectory.load, Rig.load])
@pytest.mark.parametrize("path", [0, 1, None, b"x", "a\0b", 1.5])
def test_a_path_that_is_none_is_refused_by_name(load, path):
    with pytest.raises(ValueError, match="path = "):
        load(path)


def test_numbers_are_finite_reals_within_the_range_of_a_float():
    assert all(map(is_number, (0, -1.5, np.float32(2), np.int64(3))))
    assert not any(map(is_number, (True, "1", None, 1j, math.nan, math.inf, 10**400, np.array([1.0]), np.bool_(True))))
    assert real_array([10**400, 1.0]) is None
    np.testing.assert_array_equal(real_array([1, 2]), [1.0, 2.0])


def test_a_sampler_whose_range_ends_at_negative_zero_draws():
    flight = ManeuverSampler(12.0, (0.0, -0.0), (-0.05, 0.05))(np.random.default_rng(0))
    assert flight.x[0, -1] == 0.0


def test_a_refused_value_is_shown_in_part():
    assert shown("x" * 1000).endswith("...")
    assert "digits" in shown(10**5000)


HP = HelicopterParameters
NOT_FLYABLE = [
    ("b2", lambda: Plant(HP(b2=0.0), table=Table())),
    ("b2", lambda: Plant(HP(b2=Uniform(-1.0, 1.0)), table=Table())),
    ("hover_voltage", lambda: Plant(thrust_map=PowerCurve(1.0, 0.0, 1.0, 5.0), hover_voltage=3.0)),
    ("hover_voltage", lambda: Plant(thrust_map=PowerCurve(0.0, 0.0, 1.0), hover_voltage=3.0)),
    ("hover_voltage", lambda: Plant(HP(k_plus=0.0), hover_voltage=3.0)),
    ("hover_voltage", lambda: Plant(HP(b2=-1e-300), thrust_map=PowerCurve(1.0), hover_voltage=3.0)),
    ("hover_voltage", lambda: Plant(thrust_map=PowerCurve(1.0, 0.0, 1.0, Uniform(0.0, 5.0)), hover_voltage=3.0)),
    ("voltages", lambda: Plant(thrust_map=TableCurve((0.0, 1e-300), (0.0, 1.0)))),
    ("thrusts", lambda: Plant(thrust_map=TableCurve((0.0, 1.0), (0.0, 1e300)))),
    ("thrusts", lambda: Plant(thrust_map=TableCurve((0.0, 1.0), 1.0))),
    ("disturbances", lambda: Plant(disturbances=(ThrustDrift(-1.0),) * 20)),
    ("disturbances", lambda: Plant(disturbances=(Push("pitch", 0.0, 0.0),) * 1000)),
    ("rate", lambda: Plant(HP(b1=-1e4, b2=-1e-3), table=Table(0.0, 10.0))),
    ("options", lambda: Plant(rotors=OneOf((Rotors(),) * 40), friction=OneOf((Friction(),) * 40))),
]


@pytest.mark.parametrize(("name", "make"), NOT_FLYABLE)
def test_plants_that_would_not_fly_finitely_are_refused_by_name(name, make):
    with pytest.raises(ValueError, match=name):
        make()


STIFF = {
    "pendulum of pitch": Plant(HP(a3=-1e4)),
    "pendulum of elevation": Plant(HP(a1=-1e4)),
    "friction": Plant(HP(c3=1000.0), friction=Friction((1000.0,) * 3, (20.0,) * 3)),
    "contact": Plant(HP(b3=1e4), table=Table(0.0, 10.0)),
    "Coriolis": Plant(rig=PLANTS["rigid"].rig, disturbances=(Push("travel", 1000.0, 0.0, 10.0),)),
    "lift": Plant(travel_lift=10.0, disturbances=(Push("travel", 1000.0, 0.0, 10.0), MovingMass(1000.0, 0.0))),
}


@pytest.mark.parametrize("dtype", ["float64", "float32"])
@pytest.mark.parametrize("name", STIFF)
def test_stiff_plants_fly_finitely_at_the_longest_control_period(name, dtype):
    env = Heli3DOFVectorEnv(2, STIFF[name], control_period=0.05, dtype=dtype)
    observation, _ = env.reset(seed=0)
    for _ in range(60):
        assert env.observation_space.contains(observation)
        observation, rewards, _, _, info = env.step(np.array([[0.4, 0.2], [-1.0, 1.0]]))
        assert np.isfinite(info["state"]).all() and np.isfinite(rewards).all()


def test_a_stiff_pendulum_swings_with_its_own_frequency():
    """Pitch of a3 = -1e4 rad/s² swings at 100 rad/s, one sample a period would not follow it."""
    plant = Plant(HP(a3=-1e4, b3=0.0))
    env = Heli3DOFEnv(plant, control_period=0.05, voltage_limits=(0.0, 12.0))
    start = REFERENCE.x[:, 0] * 0.0
    start[4] = 0.01
    env.reset(options={"state": start})
    for k in range(1, 20):
        *_, info = env.step(np.zeros(2))
        angle = 0.01 * math.cos(100.0 * math.sqrt(math.cos(info["state"][2])) * 0.05 * k)
        assert abs(info["state"][4] - angle) < 1e-3


@pytest.mark.parametrize(
    "make",
    [
        lambda: Heli3DOFEnv(reference=Trajectory([0.0, 3600.0], TWO[1], np.full((2, 2), 6.0)), control_period=1e-4),
        lambda: Heli3DOFVectorEnv(2**17, Plant(rotors=Rotors(delay=0.5)), control_period=1e-3),
        lambda: Heli3DOFVectorEnv(50_000, reference=ManeuverSampler(3000.0)),
    ],
)
def test_environments_that_would_take_gigabytes_are_refused_by_name(make):
    with pytest.raises(ValueError, match=r"num_envs = .*control_period = .*GB"):
        make()


@pytest.mark.parametrize(
    "arguments",
    [
        {"reference": Trajectory([0.0, 3600.0], TWO[1], np.full((2, 2), 6.0)), "control_period": 0.05},
        {"num_envs": 2**12},
    ],
)
def test_an_environment_takes_no_more_memory_than_was_expected_of_it(arguments):
    Heli3DOFVectorEnv(**{"num_envs": 1, **arguments}).reset(seed=0)  # compiles
    tracemalloc.start()
    env = Heli3DOFVectorEnv(**{"num_envs": 1, **arguments})
    env.reset(seed=0)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    flown = env.simulation
    expected = 8 * (TABLE_COPIES * flown.table.size + BLOCK_COPIES * flown.initial.size)
    assert 0.8 * expected < peak < expected + 2e6


@pytest.mark.parametrize(
    "plant",
    [
        Plant(rotors=OneOf((Rotors(), Rotors(lag=0.1)))),
        Plant(rotors=OneOf((Rotors(lag=0.1),))),
        Plant(sensors=OneOf((None, Sensors(noise=0.01)))),
        Plant(friction=OneOf((Friction(), Friction((1.0,) * 3)))),
        Plant(OneOf((HP(), HP(b1=-0.6)))),
        Plant(thrust_map=OneOf((PowerCurve(5e-3), PowerCurve(0.05, 0.0, 1.0)))),
        Plant(disturbances=(OneOf((Gust("pitch", 0.1), Push("pitch", 0.1, 0.0))),)),
    ],
)
def test_any_part_of_a_plant_may_be_one_of_several(plant):
    env = Heli3DOFEnv(plant)
    assert env.plant.is_noisy == ("Gust" in repr(plant) or "noise=0.01" in repr(plant))
    for seed in range(4):
        observation, _ = env.reset(seed=seed)
        for _ in range(3):
            observation, *_ = env.step(np.zeros(2))
        assert env.observation_space.contains(observation)


def test_presets_take_no_shorter_steps_than_their_friction_demands():
    for name, plant in PLANTS.items():
        assert plant.stiffness <= 50.0, name
    assert gym.make("Heli3DOF-v0").unwrapped.own_simulation.settings[1] == 1.0
