"""Environments on other rigs: plants, hover, references, invalid combinations."""

from dataclasses import replace

import gymnasium as gym
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import HelicopterParameters, Maneuver, PowerCurve, Rig, TableCurve, ThrustMap, find_rig
from heli_gym.baselines import fly, make_policy, plan
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.env import Heli3DOFEnv
from heli_gym.flatness import replanned
from heli_gym.model import hover_input, virtual_input
from heli_gym.on_rig import plant_on_rig
from heli_gym.plant import Plant, Rotors, Sensors, Table, Uniform
from heli_gym.rig import PAPER, Masses
from heli_gym.rigid_body import rigid_dynamics
from heli_gym.vector_env import Heli3DOFVectorEnv

MIXED = Rig(
    "mixed",
    HelicopterParameters(c1=0.05, c2=0.1, c3=0.2),
    thrust_map=ThrustMap(
        PowerCurve(0.03, -0.01, 1.2, 0.5),
        TableCurve((0.0, 2.0, 5.0, 8.0, 12.0), (0.0, 0.05, 0.2, 0.4, 0.65)),
    ),
)
RIGS = ["quanser", "ntnu", MIXED]


@pytest.mark.parametrize("rig", RIGS, ids=str)
def test_the_action_zero_hovers_on_the_rig(rig):
    env = gym.make("Heli3DOF-v0", rig=rig, reference="climb-7.5").unwrapped
    _, info = env.reset(seed=0)
    assert_allclose(env.to_voltage(np.zeros(2)), find_rig(rig).hover_voltage(), atol=1e-12)
    for _ in range(20):
        *_, info = env.step(np.zeros(2, np.float32))
    assert_allclose(info["state"], 0.0, atol=1e-5)


@pytest.mark.parametrize("plant", ["nominal", "lab", "rigid"])
@pytest.mark.parametrize("rig", RIGS, ids=str)
def test_the_papers_controller_flies_half_a_turn_on_any_rig(rig, plant):
    if (plant, rig) == ("rigid", "quanser"):
        with pytest.raises(ValueError, match=r"must be 'nominal' or 'lab' on the rig 'quanser'.*masses"):
            Heli3DOFEnv(plant, "travel-180", rig=rig)
        return
    env = Heli3DOFEnv(plant, "travel-180", rig=rig)
    flight = fly(env, make_policy("feedforward+tvlqr", env.reference), seed=0)
    assert flight.rig == env.rig == find_rig(rig)
    assert flight.duration == pytest.approx(env.reference.duration, abs=0.02)
    error = np.array(flight_metrics(flight, env.reference, env.voltage_limits).rms_error_deg)
    assert (error < (0.005 if plant == "nominal" else (6.0, 2.5, 13.0))).all()


def test_actuators_and_sensors_of_a_plant_are_the_rigs():
    other = replace(PAPER, lag=0.2, delay=0.035, encoder_counts=(2000, 1440, 1000), table_elevation=0.3)
    for rig in (other, replace(find_rig("ntnu"), lag=0.2, delay=0.035, encoder_counts=(2000, 1440, 1000))):
        for name in ("lab", "rigid"):
            plant = Heli3DOFEnv(name, "climb-7.5", rig=rig).plant
            assert plant.sensors.counts == (2000, 1440, 1000)
            assert (plant.rotors.lag, plant.rotors.delay) == (Uniform(0.1, 0.4), 0.035)
            assert plant_on_rig(plant, rig) == plant
    assert Heli3DOFEnv(Plant(table=Table()), "climb-7.5", rig=other).plant.table.elevation == 0.3
    own = Plant(rotors=Rotors(lag=0.1), sensors=Sensors((500, 500, 500)))
    assert Heli3DOFEnv(own, "climb-7.5", rig=other).plant == own
    assert make_policy("kalman-lqr", Heli3DOFEnv("lab", "climb-7.5", rig=other).reference).actuator.lag == 0.2


def test_the_rigid_body_of_a_rig_from_masses_has_these_masses(tmp_path):
    masses = Masses(1.6, 2.05, 0.7, 0.48, 0.19, 0.17, 0.012, 0.02, 0.02)
    rig = Rig.from_masses("mine", masses, voltage_limits=(0.0, 24.0))
    rig.save(tmp_path / "mine.toml")
    assert find_rig(tmp_path / "mine.toml") == rig
    body = Heli3DOFEnv("rigid", "climb-7.5", rig=rig).plant.rig.options[0]
    lengths = body.l_h, body.l_c, body.l_p, body.r, body.d_h, body.d_c, body.e_h
    assert (body.m_h, body.m_c, *lengths) == masses[:9]
    # whose linearisation about hover, by a complex step, is (3)
    v1, h, p = float(hover_input(0.0, rig.parameters)[0]), 1e-20, rig.parameters
    body = body._replace(kappa=0.0)
    for axis, gradient, locked in ((2, p.a1, 1e-9), (4, p.a3, 0.1)):  # (3) locks the other axes
        x = np.zeros(6, complex)
        x[axis] = 1j * h
        slope = np.array(rigid_dynamics(x, (v1, 0.0), body)).imag[axis + 1] / h
        assert slope == pytest.approx(gradient, rel=locked)
    assert replace(rig, parameters=PAPER.parameters).mass_data is None


def test_many_helicopters_fly_as_one_does():
    envs = Heli3DOFVectorEnv(3, "lab", "travel-180", rig=MIXED, start_spread_deg=3.0)
    env = Heli3DOFEnv("lab", envs.references[0], rig=MIXED, start_spread_deg=3.0)
    policy = make_policy("lag-lqr", envs.references[0])
    for k, flight in enumerate(fly_many(envs, policy, seed=7)):
        assert flight.rig == MIXED
        assert_allclose(flight.x, fly(env, policy, seed=7 + k).x, atol=1e-8)


def test_amplifier_and_pitch_stop_are_the_rigs_unless_given():
    env = Heli3DOFEnv(rig="quanser")
    assert (env.voltage_limits, env.pitch_limit) == ((-24.0, 24.0), find_rig("quanser").pitch_limit)
    assert Heli3DOFEnv(rig="quanser", voltage_limits=(0.0, 20.0)).voltage_limits == (0.0, 20.0)


def test_on_the_papers_rig_nothing_changes():
    mine, default = Heli3DOFEnv(rig="paper"), Heli3DOFEnv()
    assert mine.plant == default.plant and mine.reference is not None
    assert_array_equal(mine.reference.x, default.reference.x)
    assert_array_equal(mine.hover_voltage, default.hover_voltage)


def test_a_plan_for_another_rig_is_refused_and_differences_are_named(tmp_path):
    trajectory = plan(Maneuver(goal=(1.0, 0.0), duration=6.0, rig="ntnu"))
    trajectory.save(tmp_path / "plan.npz")
    for reference in (trajectory, str(tmp_path / "plan.npz")):
        for make in (Heli3DOFEnv, lambda **values: Heli3DOFVectorEnv(2, **values)):
            with pytest.raises(ValueError, match=r"reference is for the rig 'ntnu', .* 'paper': a1 0 and -1\.1713"):
                make(reference=reference)
            assert make(reference=reference, rig="ntnu").rig == find_rig("ntnu")


def test_a_policy_for_another_rig_is_refused():
    env = Heli3DOFEnv(rig="ntnu", reference="climb-7.5")
    paper = Heli3DOFEnv(reference="climb-7.5")
    policy = make_policy("feedforward+tvlqr", paper.reference)
    with pytest.raises(ValueError, match="policy: this TrackingPolicy is for the rig 'paper', and env's is 'ntnu'"):
        fly(env, policy)


def test_a_plant_with_its_own_coefficients_flies_with_them():
    heavier = HelicopterParameters(a2=0.42)
    assert Heli3DOFEnv(Plant(parameters=heavier), rig="ntnu").plant.parameters == heavier
    trajectory = plan(Maneuver(goal=(1.0, 0.0), duration=6.0, parameters=heavier))
    assert Heli3DOFEnv(Plant(parameters=heavier), trajectory).rig == trajectory.rig
    assert Heli3DOFEnv(Plant(parameters=heavier)).rig == PAPER  # the paper's plan on another plant


def test_a_reference_planned_anew_obeys_3_on_its_rig():
    from scipy.integrate import solve_ivp

    from heli_gym import dynamics

    for name in ("return-180", "elevation-sine"):
        reference = replanned(Heli3DOFEnv(reference=name).reference, MIXED)
        low, high = MIXED.limits.u
        assert low <= reference.u.min() and reference.u.max() <= high

        def rhs(t, x, reference=reference):
            return dynamics(x, virtual_input(MIXED.thrust(reference(t)[1])), MIXED.parameters)

        end = solve_ivp(rhs, (0.0, 5.0), reference.x[:, 0], max_step=0.01, rtol=1e-8).y[:, -1]
        assert_allclose(end, reference(5.0)[0], atol=1e-3)


def test_a_rig_with_less_voltage_flies_the_reference_more_slowly():
    weak = Rig("weak", voltage_limits=(5.0, 9.5))
    slower, own = Heli3DOFEnv(rig=weak).reference, Heli3DOFEnv().reference
    assert slower.duration > own.duration
    assert weak.limits.u_min <= slower.u.min() and slower.u.max() <= weak.limits.u_max
    assert_allclose(slower.x[:, -1], own.x[:, -1], atol=1e-9)


def test_elevation_positive_upwards_flips_the_reference():
    up = Rig("up", HelicopterParameters(a1=-1.1713, a2=-0.3946, b2=0.6523))
    env = Heli3DOFEnv(reference="climb-7.5", rig=up)
    assert env.reference.x[2, -1] == pytest.approx(-Heli3DOFEnv(reference="climb-7.5").reference.x[2, -1])
    flight = fly(env, make_policy("feedforward+tvlqr", env.reference))
    assert_allclose(flight.x[2, -1], env.reference.x[2, -1], atol=1e-3)


def test_an_unknown_rig_is_refused_by_name():
    with pytest.raises(ValueError, match="rig = 'no-such-rig': must be"):
        Heli3DOFEnv(rig="no-such-rig")
