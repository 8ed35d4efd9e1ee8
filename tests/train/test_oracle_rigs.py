"""The oracle optimises the flown rig, for any coefficients and thrust map."""

import pytest

from heli_gym import PowerCurve, Rig, TableCurve, ThrustMap
from heli_gym.baselines import fly
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.env import Heli3DOFEnv
from heli_gym.plant import Plant, Rotors

pytest.importorskip("casadi")
from heli_gym.train.oracle import Oracle

LAGGING = Plant(rotors=Rotors(lag=0.1))


def test_on_another_rig_without_disturbance_the_optimum_is_the_reference():
    env = Heli3DOFEnv(LAGGING, "climb-7.5", rig="ntnu")
    oracle = Oracle(env.plant, env.reference, env.control_period, env.voltage_limits, env.pitch_limit)
    _, info = env.reset(seed=0)
    policy = oracle.policy(env.drawn_plant, info["state"], env.reference.u[:, 0], env.control_period)
    metrics = flight_metrics(fly(env, policy, seed=0), env.reference, env.voltage_limits, env.pitch_limit)
    assert max(metrics.rms_error_deg[:2]) < 0.01


def test_a_table_of_thrusts_is_refused_by_name():
    table = TableCurve((0.0, 5.0, 12.0), (0.0, 0.15, 0.7))
    rig = Rig("table", thrust_map=ThrustMap(table, PowerCurve(4.855e-3)))
    env = Heli3DOFEnv(LAGGING, "climb-7.5", rig=rig)
    with pytest.raises(ValueError, match="thrust map must be power curves"):
        Oracle(env.plant, env.reference, env.control_period, env.voltage_limits, env.pitch_limit)
