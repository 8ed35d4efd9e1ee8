import math

import gymnasium as gym
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import solve_ivp

from heli_gym.model import dynamics, hover_input, thrust, virtual_input, voltage
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import (
    PLANTS,
    Friction,
    Gust,
    MovingMass,
    OneOf,
    Plant,
    Push,
    RotorFault,
    Rotors,
    Sensors,
    Uniform,
    advance,
    at_rest,
    find_plant,
)
from heli_gym.rigid_body import rigid_dynamics, solve_rigid_body

P = HelicopterParameters()
HOVER = (float(voltage(0.5 * hover_input(0.0, P)[0], P)),) * 2
LEVEL = (0.0,) * 6


def simulate(plant, voltages=HOVER, x=LEVEL, duration=2.0, dt=0.02, seed=0):
    """States after each control period of a drawn plant; voltages constant or one pair per period."""
    rng = np.random.default_rng(seed)
    steps = round(duration / dt)
    voltages = np.broadcast_to(voltages, (steps, 2))
    states = [at_rest(plant, tuple(x), HOVER)]
    for k in range(steps):
        states.append(advance(plant, states[-1], tuple(voltages[k].tolist()), k * dt, dt, rng))
    return states


def path(states):
    return np.array([state.x for state in states]).T


def test_nominal_plant_is_equation_3():
    u = (9.0, 7.0)
    states = simulate(PLANTS["nominal"], u)
    exact = solve_ivp(
        lambda t, x: dynamics(x, virtual_input(thrust(np.array(u), P)), P), (0, 2), LEVEL, rtol=1e-11, atol=1e-12
    )
    assert_allclose(path(states)[:, -1], exact.y[:, -1], atol=1e-9)
    assert states[-1].measurement == states[-1].x


@pytest.mark.parametrize("rig", [None, solve_rigid_body("A"), solve_rigid_body("B")], ids=["(3)", "A", "B"])
def test_a_flight_with_lag_and_friction_agrees_with_an_adaptive_integrator(rig):
    lag, loss, d, c, u = 0.1, 0.1, np.array([0.1, 0.2, 0.3]), np.array([0.02, 0.01, 0.03]), np.array([9.5, 8.0])
    plant = Plant(rig=rig, rotors=Rotors(lag=lag, thrust_loss=loss), friction=Friction(tuple(d), tuple(c)))
    x = (0.0, 0.3, 0.05, -0.1, 0.2, 0.1)

    def rhs(t, z):
        v = virtual_input((1 - loss) * P.k_plus * z[6:] ** 2)
        dx = np.array(dynamics(z[:6], v, P) if rig is None else rigid_dynamics(z[:6], v, rig))
        dx[1::2] -= d * z[1:6:2] + c * np.tanh(z[1:6:2] / 0.02)
        return np.concatenate((dx, (u - z[6:]) / lag))

    exact = solve_ivp(rhs, (0, 2), (*x, *HOVER), rtol=1e-10, atol=1e-12, method="DOP853", max_step=0.01)
    assert_allclose(path(simulate(plant, u, x))[:, -1], exact.y[:6, -1], atol=1e-6)


def test_rotors_follow_a_step_exponentially():
    states = simulate(Plant(rotors=Rotors(lag=0.15)), (11.0, 5.0), duration=0.3)
    expected = np.array([11.0, 5.0]) + (HOVER[0] - np.array([11.0, 5.0])) * math.exp(-0.3 / 0.15)
    assert_allclose(states[-1].rotors, expected, rtol=1e-7)


@pytest.mark.parametrize("delay", [1, 3])
def test_a_delay_shifts_the_flight_by_that_many_control_periods(delay):
    voltages = np.random.default_rng(0).uniform(5.0, 11.0, (50, 2))
    late = path(simulate(Plant(rotors=Rotors(delay=delay)), voltages, duration=1.0))
    shifted = np.concatenate((np.tile(HOVER, (delay, 1)), voltages[:-delay]))
    assert_allclose(late, path(simulate(Plant(), shifted, duration=1.0)), atol=1e-14)


def test_the_amplifier_changes_no_faster_than_its_slew_rate():
    states = simulate(Plant(rotors=Rotors(slew=20.0)), (12.0, 0.0), duration=1.0)
    u = np.array([state.voltage for state in states])
    assert_allclose(np.abs(np.diff(u, axis=0)).max(), 20.0 * 0.02, rtol=1e-12)
    assert_allclose(u[-1], [12.0, 0.0])


def test_viscous_friction_lets_free_travel_die_out_exponentially():
    plant = Plant(friction=Friction(viscous=(0.4, 0.0, 0.0)))
    assert_allclose(path(simulate(plant, x=(0, 0.5, 0, 0, 0, 0)))[1, -1], 0.5 * math.exp(-0.4 * 2.0), rtol=1e-8)


def test_coulomb_friction_takes_the_same_speed_off_whatever_the_speed():
    plant = Plant(friction=Friction(coulomb=(0.05, 0.0, 0.0)))
    for rate in (0.5, -1.0):
        change = path(simulate(plant, x=(0, rate, 0, 0, 0, 0)))[1, -1] - rate
        assert_allclose(change, -math.copysign(0.05 * 2.0, rate), rtol=1e-6)


def test_encoders_count_whole_steps_and_are_off_by_half_a_step_at_most():
    sensors = Sensors(counts=(100, 200, 300))
    for state in simulate(Plant(sensors=sensors), (9.0, 7.5))[1:]:
        steps = 2.0 * math.pi / np.array(sensors.counts)
        counted = np.array(state.angles) / steps
        assert_allclose(counted, np.round(counted), atol=1e-9)
        assert (np.abs(np.array(state.angles) - state.x[0::2]) <= 0.5 * steps + 1e-12).all()


def test_estimated_rates_converge_to_a_constant_rate():
    states = simulate(Plant(sensors=Sensors(counts=(10**9,) * 3, rate_filter=0.05)), x=(0, 0.7, 0, 0, 0, 0))
    assert_allclose(states[-1].rates[0], 0.7, rtol=1e-6)


def test_noise_has_the_standard_deviation_that_was_asked_for():
    states = simulate(Plant(sensors=Sensors(counts=(10**9,) * 3, noise=0.01)), duration=40.0)
    errors = np.array([np.array(state.angles) - state.x[0::2] for state in states[1:]])
    assert_allclose(errors.std(axis=0), 0.01, rtol=0.06)


@pytest.mark.parametrize(("axis", "row"), [("travel", 1), ("elevation", 3), ("pitch", 5)])
def test_a_push_changes_the_rate_by_acceleration_times_duration(axis, row):
    plant = Plant(disturbances=(Push(axis, acceleration=2.0, time=0.1, duration=0.05),))
    before, after = (path(simulate(plant, duration=duration))[row, -1] for duration in (0.1, 0.16))
    assert before == pytest.approx(0.0, abs=1e-12)
    assert after == pytest.approx(0.1, rel=1e-2)


def test_a_gust_has_its_standard_deviation_and_correlation_time():
    rng = np.random.default_rng(0)
    plant = Plant(disturbances=(Gust("pitch", strength=0.5, correlation_time=0.4),))
    state, values = at_rest(plant, LEVEL, HOVER), []
    for k in range(20000):
        state = advance(plant, state._replace(x=LEVEL), HOVER, k * 0.05, 0.05, rng)
        values.append(state.gusts[0])
    values = np.array(values)
    assert_allclose(values.std(), 0.5, rtol=0.05)
    assert_allclose(np.corrcoef(values[:-8], values[8:])[0, 1], math.exp(-1.0), atol=0.05)


def test_a_moved_mass_is_a_change_of_a2():
    moved = Plant(disturbances=(MovingMass(a2_change=0.05, time=-1.0, duration=0.5),))
    assert_allclose(
        path(simulate(moved)), path(simulate(Plant(P._replace(a2=P.a2 + 0.05)), dt=0.005))[:, ::4], atol=1e-9
    )


def test_a_rotor_fault_takes_its_share_of_one_thrust_from_its_time_on():
    states = path(simulate(Plant(disturbances=(RotorFault("front", loss=0.3, time=1.0),))))
    assert_allclose(states[:, :51], 0.0, atol=1e-12)
    lost = 0.3 * float(thrust(HOVER[0], P))
    assert states[5, -1] == pytest.approx(-P.b3 * lost * 1.0, rel=0.2)
    assert states[4, -1] < 0.0


def ranges(value):
    if isinstance(value, Uniform | OneOf):
        yield value
    elif isinstance(value, tuple):
        for part in value:
            yield from ranges(part)
    elif hasattr(value, "__dataclass_fields__"):
        for name in value.__dataclass_fields__:
            yield from ranges(getattr(value, name))


@pytest.mark.parametrize("name", PLANTS)
def test_draws_are_within_the_ranges_and_leave_none(name):
    plant = PLANTS[name]
    for seed in range(20):
        draw = plant.draw(np.random.default_rng(seed))
        assert not list(ranges(draw))
        assert draw == plant.draw(np.random.default_rng(seed))
        if name != "nominal":
            assert 0.05 <= draw.rotors.lag <= 0.2
            assert 0.0 <= draw.rotors.thrust_loss <= 0.15
            assert 0.017 <= draw.friction.viscous[0] <= 0.2


def test_the_rigid_plant_draws_both_variants_and_the_drag_ratio():
    draws = [PLANTS["rigid"].draw(np.random.default_rng(seed)).rig for seed in range(20)]
    assert {draw.e_h > 0 for draw in draws} == {True, False}
    kappas = [draw.kappa for draw in draws]
    assert 0.015 <= min(kappas) < max(kappas) <= 0.03


@pytest.mark.parametrize("name", ["lab", "rigid"])
def test_same_seed_same_flight_and_another_seed_another(name):
    def flight(seed):
        env = gym.make("heli_gym:Heli3DOF-v0", plant=name)
        _, info = env.reset(seed=seed)
        observations = [env.step(np.array([0.3, 0.32], np.float32))[0] for _ in range(50)]
        return info["plant"], np.array(observations)

    (plant, first), (again, second), (other, third) = flight(1), flight(1), flight(2)
    assert plant == again != other
    assert_array_equal(first, second)
    assert not np.array_equal(first, third)


def test_reset_can_set_the_plant_of_one_episode():
    env = gym.make("heli_gym:Heli3DOF-v0", plant="lab")
    faulty = Plant(disturbances=(RotorFault("back", 0.5),))
    assert env.reset(seed=0, options={"plant": faulty})[1]["plant"] == faulty
    assert env.reset(seed=0, options={"plant": "nominal"})[1]["plant"] == PLANTS["nominal"]
    assert env.reset(seed=0)[1]["plant"].rotors.delay == 1


@pytest.mark.parametrize(
    ("make", "name"),
    [
        (lambda: find_plant("moon"), "plant"),
        (lambda: Uniform(2.0, 1.0), "Uniform"),
        (lambda: Uniform(math.nan, 1.0), "Uniform"),
        (lambda: Rotors(lag=-0.1), "lag"),
        (lambda: Rotors(lag=Uniform(-0.1, 0.1)), "lag"),
        (lambda: Rotors(thrust_loss=1.5), "thrust_loss"),
        (lambda: Rotors(delay=-1), "delay"),
        (lambda: Rotors(slew=math.nan), "slew"),
        (lambda: Friction(viscous=(-0.1, 0.0, 0.0)), "viscous"),
        (lambda: Friction(coulomb=(0.1, 0.0)), "coulomb"),
        (lambda: Sensors(counts=(0, 1, 1)), "counts"),
        (lambda: Sensors(noise=-1.0), "noise"),
        (lambda: Push("yaw", 1.0, 0.0), "axis"),
        (lambda: Gust("pitch", -1.0), "strength"),
        (lambda: MovingMass(0.1, 0.0, 0.0), "duration"),
        (lambda: RotorFault("left", 0.1), "rotor"),
        (lambda: RotorFault("front", 2.0), "loss"),
    ],
)
def test_a_value_that_no_rig_has_is_refused_by_name(make, name):
    with pytest.raises(ValueError, match=name):
        make()
