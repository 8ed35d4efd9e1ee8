import copy
import math
from dataclasses import replace
from types import SimpleNamespace

import gymnasium as gym
import numpy as np
import pytest
from independent import hover
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import solve_ivp

from heli_gym.env import find_reference
from heli_gym.model import dynamics, hover_input, thrust, virtual_input, voltage
from heli_gym.parameters import AMPLIFIER_LIMITS, NO_COUPLING, Coupling, HelicopterParameters
from heli_gym.plant import (
    COULOMB_RATE,
    LAB_FRICTION,
    MARGIN,
    NOMINAL_RIGS,
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
    Table,
    ThrustDrift,
    Uniform,
    find_plant,
    fleet_numbers,
)
from heli_gym.rig import Rig, find_rig, fleet_rig_names
from heli_gym.rigid_body import rigid_dynamics, solve_rigid_body
from heli_gym.simulation.layout import DISTURBANCES, GUST, MEASURED, MOTOR, ROTOR, ROW, X
from heli_gym.simulation.simulation import Simulation
from heli_gym.task import hover_voltage, to_action
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustMap

P = HelicopterParameters()
HOVER = (float(voltage(0.5 * hover_input(0.0, P)[0], P)),) * 2
LEVEL = (0.0,) * 6


def simulate(plant, voltages=HOVER, x=LEVEL, duration=2.0, dt=0.02, seed=0):
    """Rows (..., K + 1) at the start and after each control period; voltages constant or one pair per period."""
    steps = round(duration / dt)
    simulation = Simulation([plant], [hover(duration)], dt, AMPLIFIER_LIMITS, math.inf)
    simulation.draw(0, np.random.default_rng(seed))
    simulation.reset(np.zeros(1, int), np.array([x], float))
    flown = [simulation.blocks.reshape(-1, ROW)[:, 0].copy()]
    for action in to_action(
        np.broadcast_to(voltages, (steps, 2)), AMPLIFIER_LIMITS, hover_voltage(P, AMPLIFIER_LIMITS)
    ):
        simulation.step(action[None])
        flown.append(simulation.blocks.reshape(-1, ROW)[:, 0].copy())
    rows = np.array(flown).T
    return SimpleNamespace(
        x=rows[X : X + 6],
        measured=rows[MEASURED : MEASURED + 6] if plant.sensors else rows[X : X + 6],
        motor=rows[MOTOR : MOTOR + 2],
        rotor=rows[ROTOR : ROTOR + 2],
        gust=rows[DISTURBANCES + GUST] if plant.disturbances else None,
    )


def test_nominal_plant_is_equation_3():
    u = (9.0, 7.0)
    flight = simulate(PLANTS["nominal"], u)
    exact = solve_ivp(
        lambda t, x: dynamics(x, virtual_input(thrust(np.array(u), P)), P), (0, 2), LEVEL, rtol=1e-11, atol=1e-12
    )
    assert_allclose(flight.x[:, -1], exact.y[:, -1], atol=1e-9)


@pytest.mark.parametrize("lag", [0.05, 0.2])
@pytest.mark.parametrize("rig", [None, solve_rigid_body("A"), solve_rigid_body("B")], ids=["(3)", "A", "B"])
def test_a_flight_with_lag_and_friction_agrees_with_an_adaptive_integrator(rig, lag):
    loss, d, c, u = 0.1, np.array([0.1, 0.2, 0.3]), np.array([0.02, 0.01, 0.03]), np.array([9.5, 8.0])
    plant = Plant(rig=rig, rotors=Rotors(lag=lag, thrust_loss=loss), friction=Friction(tuple(d), tuple(c)))
    x = (0.0, 0.3, 0.05, -0.1, 0.2, 0.1)

    def rhs(t, z):
        v = virtual_input((1 - loss) * P.k_plus * z[6:] ** 2)
        dx = np.array(dynamics(z[:6], v, P) if rig is None else rigid_dynamics(z[:6], v, rig))
        dx[1::2] -= d * z[1:6:2] + c * z[1:6:2] / np.hypot(z[1:6:2], COULOMB_RATE)
        return np.concatenate((dx, (u - z[6:]) / lag))

    exact = solve_ivp(rhs, (0, 2), (*x, *HOVER), rtol=1e-10, atol=1e-12, method="DOP853", max_step=0.01)
    assert_allclose(simulate(plant, u, x).x[:, -1], exact.y[:6, -1], atol=1e-6)


def test_rotors_follow_a_step_exponentially():
    flight = simulate(Plant(rotors=Rotors(lag=0.15)), (11.0, 5.0), duration=0.3)
    expected = np.array([11.0, 5.0]) + (HOVER[0] - np.array([11.0, 5.0])) * math.exp(-0.3 / 0.15)
    assert_allclose(flight.rotor[:, -1], expected, rtol=1e-12)


@pytest.mark.parametrize("delay", [1, 3])
def test_a_delay_of_whole_control_periods_shifts_the_flight(delay):
    voltages = np.random.default_rng(0).uniform(5.0, 11.0, (50, 2))
    late = simulate(Plant(rotors=Rotors(delay=0.02 * delay)), voltages, duration=1.0).x
    shifted = np.concatenate((np.tile(HOVER, (delay, 1)), voltages[:-delay]))
    assert_allclose(late, simulate(Plant(), shifted, duration=1.0).x, atol=1e-14)


def test_the_amplifier_changes_no_faster_than_its_slew_rate():
    u = simulate(Plant(rotors=Rotors(slew=20.0)), (12.0, 0.0), duration=1.0).motor
    assert_allclose(np.abs(np.diff(u)).max(), 20.0 * 0.02, rtol=1e-12)
    assert_allclose(u[:, -1], [12.0, 0.0])


def test_viscous_friction_lets_free_travel_die_out_exponentially():
    plant = Plant(friction=Friction(viscous=(0.4, 0.0, 0.0)))
    assert_allclose(simulate(plant, x=(0, 0.5, 0, 0, 0, 0)).x[1, -1], 0.5 * math.exp(-0.4 * 2.0), rtol=1e-8)


def test_coulomb_friction_decelerates_equally_at_all_speeds():
    plant = Plant(friction=Friction(coulomb=(0.05, 0.0, 0.0)))
    for rate in (0.5, -1.0):
        change = simulate(plant, x=(0, rate, 0, 0, 0, 0)).x[1, -1] - rate
        assert_allclose(change, -math.copysign(0.05 * 2.0, rate), rtol=0.5 * (COULOMB_RATE / 0.4) ** 2)


def test_encoders_count_whole_steps_and_are_off_by_half_a_step_at_most():
    sensors = Sensors(counts=(100, 200, 300))
    flight = simulate(Plant(sensors=sensors), (9.0, 7.5))
    steps = 2.0 * math.pi / np.array(sensors.counts)[:, None]
    counted = flight.measured[0::2] / steps
    assert_allclose(counted, np.round(counted), atol=1e-9)
    assert (np.abs(flight.measured[0::2] - flight.x[0::2]) <= 0.5 * steps + 1e-12).all()


def test_estimated_rates_converge_to_a_constant_rate():
    flight = simulate(Plant(sensors=Sensors(counts=(10**9,) * 3, rate_filter=0.05)), x=(0, 0.7, 0, 0, 0, 0))
    assert_allclose(flight.measured[1, -1], 0.7, rtol=1e-6)


def test_noise_has_the_requested_standard_deviation():
    flight = simulate(Plant(sensors=Sensors(counts=(10**9,) * 3, noise=0.01)), duration=40.0)
    errors = flight.measured[0::2] - flight.x[0::2]
    assert_allclose(errors.std(axis=1), 0.01, rtol=0.06)
    assert_allclose(np.corrcoef(errors[:, 1:], errors[:, :-1]), np.eye(6), atol=0.08)


@pytest.mark.parametrize("start", [0.1, 0.1037, 0.1149])
@pytest.mark.parametrize("duration", [0.003, 0.007, 0.013, 0.016, 0.05])
@pytest.mark.parametrize(("axis", "row"), [("travel", 1), ("elevation", 3), ("pitch", 5)])
def test_a_push_changes_the_rate_by_acceleration_times_duration(axis, row, duration, start):
    plant = Plant(disturbances=(Push(axis, acceleration=2.0, time=start, duration=duration),))
    before, after = (simulate(plant, duration=end).x[row, -1] for end in (0.1, 0.18))
    assert before == pytest.approx(0.0, abs=1e-12)
    assert after == pytest.approx(2.0 * duration, rel=1e-2)


@pytest.mark.parametrize("start", [0.0, -0.25, 0.1037])
def test_a_push_without_end_goes_on(start):
    plant = Plant(disturbances=(Push("travel", acceleration=2.0, time=start, duration=math.inf),))
    assert simulate(plant, duration=1.0).x[1, -1] == pytest.approx(2.0 * (1.0 - max(start, 0.0)), rel=1e-12)


def test_a_gust_has_its_standard_deviation_and_correlation_time():
    plant = Plant(disturbances=(Gust("pitch", strength=0.5, correlation_time=0.4),))
    values = simulate(plant, duration=1000.0, dt=0.05).gust
    assert values[0] == 0.0
    assert_allclose(values.std(), 0.5, rtol=0.05)
    assert_allclose(np.corrcoef(values[:-8], values[8:])[0, 1], math.exp(-1.0), atol=0.05)


def test_a_moved_mass_is_a_change_of_a2():
    moved = Plant(disturbances=(MovingMass(a2_change=0.05, time=-1.0, duration=0.5),))
    assert_allclose(simulate(moved).x, simulate(Plant(P._replace(a2=P.a2 + 0.05)), dt=0.005).x[:, ::4], atol=1e-9)


def test_a_rotor_fault_takes_its_share_of_one_thrust_from_its_time_on():
    states = simulate(Plant(disturbances=(RotorFault("front", loss=0.3, time=1.0),))).x
    assert_allclose(states[:, :51], 0.0, atol=1e-12)
    lost = 0.3 * float(thrust(HOVER[0], P))
    assert states[5, -1] == pytest.approx(-P.b3 * lost * 1.0, rel=0.2)
    assert states[4, -1] < 0.0


@pytest.mark.parametrize("start", [1.003, 1.0149])
def test_a_rotor_fault_off_the_grid_takes_its_share_from_its_very_time_on(start):
    rate = simulate(Plant(disturbances=(RotorFault("front", loss=0.3, time=start),)), duration=1.06).x[5, -1]
    assert rate == pytest.approx(-P.b3 * 0.3 * float(thrust(HOVER[0], P)) * (1.06 - start), rel=1e-2)


POWER = PowerCurve(0.03, -0.01, 1.3, 0.5)
MEASURED_CURVE = TableCurve((-5.0, 0.0, 2.0, 6.0, 12.0), (-0.05, 0.0, 0.04, 0.2, 0.6))
LINEAR = PowerCurve(0.0385, -0.0385, 1.0)


@pytest.mark.parametrize("delay", [0.0, 0.033, 0.0799])
@pytest.mark.parametrize("curves", [(POWER, MEASURED_CURVE), (LINEAR, LINEAR), (MEASURED_CURVE, POWER)])
def test_thrust_maps_delays_in_seconds_gains_and_lift_agree_with_an_adaptive_integrator(curves, delay):
    plant = Plant(
        P._replace(c1=0.1, c2=0.3, c3=0.2),
        rotors=Rotors(lag=0.08, delay=delay, gains=(0.95, 1.05)),
        thrust_map=ThrustMap(*curves),
        travel_lift=-0.1,
    )
    voltages, start = np.random.default_rng(0).uniform(3.0, 10.0, (25, 2)), (0.0, 0.5, 0.0, 0.0, 0.1, 0.0)

    def rhs(t, z, u):
        f = [gain * curve.thrust(w) for gain, curve, w in zip(plant.rotors.gains, curves, z[6:])]
        dx = np.array(dynamics(z[:6], virtual_input(f), plant.parameters))
        dx[3] += plant.travel_lift * z[1] ** 2
        return np.concatenate((dx, (u - z[6:]) / plant.rotors.lag))

    z, t = np.array((*start, *HOVER)), 0.0
    for u, end in zip((np.array(HOVER), *voltages), np.minimum(delay + 0.02 * np.arange(26), 0.5)):
        if end > t:
            z = solve_ivp(rhs, (t, end), z, args=(u,), rtol=1e-10, atol=1e-12, max_step=0.01).y[:, -1]
        t = end
    assert_allclose(simulate(plant, voltages, start, duration=0.5).x[:, -1], z[:6], atol=1e-6)


def test_a_delay_in_seconds_does_not_depend_on_the_control_period():
    plant = Plant(rotors=Rotors(lag=0.1, delay=0.033))
    flights = [simulate(plant, (9.0, 7.0), duration=1.0, dt=dt).x[:, -1] for dt in (0.02, 0.004, 0.05)]
    assert_allclose(flights[1], flights[0], atol=1e-7)
    assert_allclose(flights[2], flights[0], atol=1e-6)


@pytest.mark.parametrize("name", ["lab", "rigid"])
def test_the_general_loops_fly_the_same_as_those_for_less(name):
    plant = PLANTS[name].draw(np.random.default_rng(1))
    general = replace(plant, thrust_map=ThrustMap(PowerCurve(P.k_plus, P.k_minus), PowerCurve(P.k_plus, P.k_minus)))
    assert general.is_general and not plant.is_general
    voltages = np.random.default_rng(0).uniform(6.0, 10.0, (50, 2))
    few, all_of_them = (simulate(p, voltages, duration=1.0) for p in (plant, general))
    assert_allclose(all_of_them.x, few.x, rtol=0.0, atol=1e-12)
    assert_allclose(all_of_them.measured[::2], few.measured[::2], rtol=0.0, atol=1e-12)


def test_stiff_friction_brings_the_pitch_to_its_terminal_rate():
    u = np.array([8.4, 7.2])
    flight = simulate(Plant(friction=Friction(viscous=(0.0, 0.0, 400.0))), u, duration=0.1)
    rate = P.b3 * virtual_input(thrust(u, P))[1] / 400.0
    assert_allclose(flight.x[5, 1:], rate, rtol=1e-3)
    assert_allclose(flight.x[4, -1], rate * (0.1 - 1.0 / 400.0), rtol=1e-3)


@pytest.mark.parametrize("coulomb", [1.0, 15.0])
def test_coulomb_friction_holds_a_pitch_that_is_pushed_less(coulomb):
    flight = simulate(Plant(friction=Friction(coulomb=(0.0, 0.0, coulomb))), (8.0, 7.9), duration=2.0)
    assert np.abs(flight.x[5]).max() < COULOMB_RATE


def test_unequal_rotors_are_a_difference_of_thrusts():
    rate = simulate(Plant(rotors=Rotors(gains=(1.05, 0.95))), duration=0.02).x[5, -1]
    assert rate == pytest.approx(P.b3 * 0.1 * float(thrust(HOVER[0], P)) * 0.02, rel=1e-3)


def test_sensors_read_zero_at_their_zeros():
    zeros = (0.3, -0.05, 0.12)
    flight = simulate(Plant(sensors=Sensors(counts=(2**20,) * 3, zeros=zeros)), duration=0.2)
    assert_allclose(flight.x[::2].T + 0.0 * flight.x[0][:, None], flight.measured[::2].T + np.array(zeros), atol=1e-5)
    assert_allclose(flight.measured[1::2], flight.x[1::2], atol=1e-2)


def test_thrust_that_drifts_away_lets_the_helicopter_sink():
    drift = ThrustDrift(loss=0.1, time=1.0, duration=5.0)
    rate = simulate(Plant(disturbances=(drift,)), duration=2.0).x[3]
    assert_allclose(rate[:51], 0.0, atol=1e-12)
    stiffness = -P.a1  # of the linear oscillator that elevation is, which a ramp of force moves
    assert rate[-1] == pytest.approx(P.a2 * 0.1 / 5.0 / stiffness * (1.0 - math.cos(math.sqrt(stiffness))), rel=1e-3)


@pytest.mark.parametrize("plant", [Plant(), PLANTS["rigid"].draw(np.random.default_rng(0))], ids=["(3)", "rigid"])
def test_a_helicopter_without_thrust_comes_to_rest_level_on_the_table(plant):
    plant = replace(plant, table=Table(0.1), rotors=Rotors(lag=0.1))
    flight = simulate(plant, (0.0, 0.0), (0.0, 0.3, 0.0, 0.0, 0.2, 0.0), duration=10.0)
    assert flight.x[2].max() < 0.15
    assert_allclose(flight.x[:, -1], (flight.x[0, -1], 0.0, 0.1, 0.0, 0.0, 0.0), atol=2e-3)


def test_it_takes_off_once_the_thrust_outweighs_it_and_not_before():
    plant, rest = Plant(table=Table(0.1), rotors=Rotors(lag=0.1)), (0.0, 0.0, 0.1, 0.0, 0.0, 0.0)
    hover = float(voltage(0.5 * hover_input(0.1, P)[0], P))
    below, above = (simulate(plant, (u, u), rest, duration=3.0).x[2, -1] for u in (0.98 * hover, 1.02 * hover))
    assert below == pytest.approx(0.1, abs=1e-3)
    assert above < 0.09


def test_the_table_only_pushes_upwards():
    without, near = Plant(rotors=Rotors(lag=0.1)), Plant(table=Table(0.3), rotors=Rotors(lag=0.1))
    flights = [simulate(plant, (8.5, 7.5), duration=1.0).x for plant in (without, near)]
    assert flights[0][2].max() < 0.29
    assert_allclose(flights[1], flights[0], atol=1e-9)


@pytest.mark.parametrize("exponent", [0.94, 1.22, 1.74])
def test_a_hover_voltage_scales_the_thrust_map_to_hover_there(exponent):
    curve = PowerCurve(1.0, -0.3, exponent, 0.2)
    plant = Plant(P._replace(a2=0.8), thrust_map=ThrustMap(curve, curve), hover_voltage=4.0)
    flight = simulate(plant, (4.0, 4.0))
    assert_allclose(
        flight.x[2:4, 1:], flight.x[2:4, 1:2] * np.ones(100), atol=1e-2
    )  # but for the first voltages, HOVER
    start = simulate(plant, (4.0, 4.0), duration=0.02).x[3, -1]
    assert abs(start) < 1e-9


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
        if name in ("lab", "rigid"):
            assert 0.05 <= draw.rotors.lag <= 0.2
            assert 0.0 <= draw.rotors.thrust_loss <= 0.15
            for value, (low, high) in zip(draw.friction.viscous, [(0.017, 0.2), (0.04, 0.3), (0.04, 0.46)]):
                assert low <= value <= high


def test_every_draw_of_the_fleet_hovers_at_its_hover_voltage_with_a_fifth_of_the_amplifier_to_spare():
    _, high = find_rig(NOMINAL_RIGS["fleet"]).voltage_limits
    for seed in range(20):
        draw = PLANTS["fleet"].draw(np.random.default_rng(seed))
        u = draw.hover_voltage
        assert 0.0 < u < 0.8 * high
        equal = Rotors(gains=(1.0, 1.0))
        rates = simulate(replace(draw, rotors=equal, disturbances=()), (u, u), duration=1.0).x[3]
        assert_allclose(rates, 0.0, atol=1e-9)


def test_a_draw_of_the_fleet_is_near_one_of_the_identified_rigs_in_all_of_its_numbers():
    numbers = [fleet_numbers(find_rig(name)) for name in fleet_rig_names()]
    spans = {name: np.ptp([own[name] for own in numbers]) for name in numbers[0]}
    nearest = set()
    for seed in range(30):
        draw = PLANTS["fleet"].draw(np.random.default_rng(seed))
        front, back = draw.rotors.gains
        own = {**draw.parameters._asdict(), **draw.coupling._asdict(), "front": front, "back": back}
        own |= {"lag": draw.rotors.lag, "delay": draw.rotors.delay}
        own |= {"exponent": draw.thrust_map.exponent, "reverse": draw.thrust_map.k_minus}
        near = [all(abs(own[name] - rig[name]) <= MARGIN * spans[name] + 1e-12 for name in rig) for rig in numbers]
        assert any(near)
        nearest.add(near.index(True))
    assert nearest == set(range(len(numbers)))


def test_the_nominal_rig_of_the_fleet_is_the_mean_of_the_identified_rigs():
    rig, plant = find_rig("fleet"), PLANTS["fleet"]
    numbers = [fleet_numbers(find_rig(name)) for name in fleet_rig_names()]
    own = fleet_numbers(rig)
    for name in set(own) - {"front", "back"}:
        assert own[name] == pytest.approx(np.mean([each[name] for each in numbers]), abs=6e-4, rel=2e-3), name
    assert own["front"] == own["back"] == 1.0
    middle = 0.5 * (plant.hover_voltage.low + plant.hover_voltage.high)
    assert_allclose(rig.hover_voltage(), middle, rtol=2e-3)


def test_options_that_are_drawn_together_have_the_same_position():
    spinning = Coupling(spin=1.0)
    rotors, coupling = (
        OneOf(options, together="rig") for options in ((Rotors(lag=0.1), Rotors(lag=0.2)), (NO_COUPLING, spinning))
    )
    plant = Plant(rotors=rotors, coupling=coupling, sensors=OneOf((None, Sensors())))
    assert [(p.rotors.lag, p.coupling.spin) for p in plant.alternatives] == [(0.1, 0.0)] * 2 + [(0.2, 1.0)] * 2
    with pytest.raises(ValueError, match="options: 2 and 1 together as 'rig'"):
        Plant(rotors=rotors, coupling=OneOf((spinning,), together="rig"))


def test_travel_damping_ends_before_the_paper_s_plan_takes_more_voltage_than_there_is():
    reference = find_reference("travel-360")
    (_, dq1, q2, _, q3, _), u = reference(np.linspace(0.0, reference.duration, 2001))
    v1 = virtual_input(thrust(u, P))[0]

    def tilt_and_voltage(damping):
        """Pitch in degrees, and voltage at both fans, with which travel and elevation are the plan's nevertheless."""
        sideways, lift = v1 * np.sin(q3) + damping * dq1 / (P.b1 * np.cos(q2)), v1 * np.cos(q3)
        return np.degrees(np.arctan2(sideways, lift)), voltage(0.5 * np.hypot(sideways, lift), P)

    fastest = np.abs(dq1).argmax()
    assert np.degrees(dq1[fastest]) == pytest.approx(88.0, abs=0.5)
    assert tilt_and_voltage(0.35)[0][fastest] == pytest.approx(-50.0, abs=0.5)
    assert tilt_and_voltage(LAB_FRICTION.viscous[0].high)[1].max() < 12.0
    assert tilt_and_voltage(0.25)[1].max() == pytest.approx(12.0, abs=0.05)


def test_the_rigid_plant_draws_both_variants_and_the_drag_ratio():
    draws = [PLANTS["rigid"].draw(np.random.default_rng(seed)).rig for seed in range(20)]
    assert {draw.e_h > 0 for draw in draws} == {True, False}
    kappas = [draw.kappa for draw in draws]
    assert 0.015 <= min(kappas) < max(kappas) <= 0.03


@pytest.mark.parametrize("name", ["lab", "rigid"])
def test_same_seed_same_flight_and_another_seed_another(name):
    def flight(seed):
        env = gym.make("heli_gym:Heli3DOF-v0", plant=name)
        env.reset(seed=seed)
        observations = [env.step(np.array([0.3, 0.32], np.float32))[0] for _ in range(50)]
        return env.unwrapped.drawn_plant, np.array(observations)

    (plant, first), (again, second), (other, third) = flight(1), flight(1), flight(2)
    assert plant == again != other
    assert_array_equal(first, second)
    assert not np.array_equal(first, third)


def test_reset_can_set_the_plant_of_one_episode():
    env = gym.make("heli_gym:Heli3DOF-v0", plant="lab")
    faulty = Plant(disturbances=(RotorFault("back", 0.5),))
    env.reset(seed=0, options={"plant": faulty})
    assert env.unwrapped.drawn_plant == faulty
    env.reset(seed=0, options={"plant": "nominal"})
    assert env.unwrapped.drawn_plant == PLANTS["nominal"]
    env.reset(seed=0)
    assert env.unwrapped.drawn_plant.rotors.delay == 0.02


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
        (lambda: Rotors(delay="0.02"), "delay"),
        (lambda: Rotors(delay=Uniform(0.0, 2.0)), "delay"),
        (lambda: Rotors(delay=1), "delay"),
        (lambda: Rotors(delay=math.nan), "delay"),
        (lambda: Rotors(slew=math.nan), "slew"),
        (lambda: Friction(viscous=(-0.1, 0.0, 0.0)), "viscous"),
        (lambda: Friction(coulomb=(0.1, 0.0)), "coulomb"),
        (lambda: Sensors(counts=(0, 1, 1)), "counts"),
        (lambda: Friction(viscous=(0.0, math.inf, 0.0)), "viscous"),
        (lambda: Sensors(counts=(8192, 4096.5, 4096)), "counts"),
        (lambda: Sensors(counts=(8192, Uniform(1.0, 9.0), 4096)), "counts"),
        (lambda: Sensors(noise=-1.0), "noise"),
        (lambda: Sensors(noise=math.inf), "noise"),
        (lambda: Push("yaw", 1.0, 0.0), "axis"),
        (lambda: Push("pitch", math.nan, 0.0), "acceleration"),
        (lambda: Push("pitch", -math.inf, 0.0), "acceleration"),
        (lambda: Push("pitch", 1.0, math.nan), "time"),
        (lambda: Push("pitch", 1.0, -math.inf), "time"),
        (lambda: Push("pitch", 1.0, 0.0, math.nan), "duration"),
        (lambda: Gust("pitch", -1.0), "strength"),
        (lambda: Gust("pitch", math.inf), "strength"),
        (lambda: MovingMass(0.1, 0.0, 0.0), "duration"),
        (lambda: MovingMass(math.inf, 0.0), "a2_change"),
        (lambda: MovingMass(0.1, math.nan), "time"),
        (lambda: RotorFault("front", 0.1, math.inf), "time"),
        (lambda: RotorFault("front", 0.1, math.nan), "time"),
        (lambda: RotorFault("left", 0.1), "rotor"),
        (lambda: RotorFault("front", 2.0), "loss"),
        (lambda: ThrustDrift(2.0), "loss"),
        (lambda: ThrustDrift(0.1, duration=0.0), "duration"),
        (lambda: Rotors(gains=(1.0,)), "gains"),
        (lambda: Rotors(gains=(1.0, -1.0)), "gains"),
        (lambda: Sensors(zeros=(0.0, 0.0, math.nan)), "zeros"),
        (lambda: Sensors(counts=(256,) * 3, rate_filter=1e-6), "rate_filter"),
        (lambda: Table(elevation=2.0), "elevation"),
        (lambda: Table(friction=-1.0), "friction"),
        (lambda: Friction(viscous=(0.0, 0.0, 1e300)), "viscous"),
        (lambda: Friction(coulomb=(0.0, 1e300, 0.0)), "coulomb"),
        (lambda: Push("pitch", 1e300, 0.0), "acceleration"),
        (lambda: Push("pitch", 10**400, 0.0), "acceleration"),
        (lambda: Plant(HelicopterParameters(b1=math.inf)), "parameters.b1"),
        (lambda: Plant(HelicopterParameters(a1=Uniform(0.0, 1e300))), "parameters.a1"),
        (lambda: Plant(HelicopterParameters(c2=-0.1)), "parameters.c2"),
        (lambda: Plant(HelicopterParameters(c2="0.1")), "parameters.c2"),
        (lambda: Plant("nominal"), "parameters"),
        (lambda: Plant(rig=solve_rigid_body("A")._replace(m_h=math.nan)), "rig.m_h"),
        (lambda: Plant(rig=OneOf((solve_rigid_body("A")._replace(l_h=0.0),))), "rig.l_h"),
        (lambda: Plant(rotors=0.1), "rotors"),
        (lambda: Plant(friction=None), "friction"),
        (lambda: Plant(sensors=(8192, 4096, 4096)), "sensors"),
        (lambda: Plant(disturbances=[]), "disturbances"),
        (lambda: Plant(disturbances=(0.1,)), "disturbances"),
        (lambda: Plant(thrust_map=0.1), "thrust_map"),
        (lambda: Plant(thrust_map=ThrustMap(POWER, PowerCurve(1.0, exponent=3.0))), "thrust_map.back.exponent"),
        (lambda: Plant(thrust_map=ThrustMap(POWER, MEASURED_CURVE), hover_voltage=5.0), "hover_voltage"),
        (lambda: Plant(HelicopterParameters(a2=-0.4), hover_voltage=5.0), "hover_voltage"),
        (lambda: Plant(travel_lift=math.nan), "travel_lift"),
        (lambda: Plant(table=0.5), "table"),
        (lambda: OneOf(()), "options"),
        (lambda: find_plant(5), "plant"),
    ],
)
def test_a_value_that_no_rig_has_is_refused_by_name(make, name):
    with pytest.raises(ValueError, match=name):
        make()


def test_every_parameter_that_may_be_a_range_is_drawn_and_flown():
    one, several = Uniform(0.1, 0.2), (Uniform(0.1, 0.2),) * 3
    plant = Plant(
        parameters=HelicopterParameters(k_plus=Uniform(4e-3, 5e-3), b1=Uniform(-0.7, -0.6)),
        rotors=Rotors(lag=one, thrust_loss=one, slew=Uniform(40.0, 50.0), delay=one, gains=(one, one)),
        friction=Friction(viscous=several, coulomb=several),
        sensors=Sensors(noise=Uniform(0.001, 0.002), rate_filter=one, zeros=several),
        disturbances=(
            Push("pitch", one, one, one),
            Gust("pitch", one, one),
            MovingMass(one, one, one),
            RotorFault("back", one, one),
            ThrustDrift(one, one, one),
        ),
        thrust_map=PowerCurve(Uniform(0.9, 1.1), -0.3, Uniform(1.0, 1.5), one),
        hover_voltage=Uniform(4.0, 5.0),
        travel_lift=Uniform(-0.2, -0.1),
        table=Table(Uniform(0.4, 0.5), one),
    )
    env = gym.make("heli_gym:Heli3DOF-v0", plant=plant)
    draws = []
    for seed in range(5):
        env.reset(seed=seed)
        draws.append(env.unwrapped.drawn_plant)
    for _ in range(20):
        env.step(np.array([0.3, 0.3], np.float32))
    assert len({draw.parameters.b1 for draw in draws}) == 5
    assert all(-0.7 <= draw.parameters.b1 <= -0.6 and not list(ranges(draw)) for draw in draws)


def test_a_copy_of_a_plant_is_the_plant_itself():
    assert copy.deepcopy({"plant": PLANTS["lab"]})["plant"] is PLANTS["lab"]


def test_the_moments_between_the_axes_agree_with_an_adaptive_integrator():
    c, p = Coupling(0.9, 0.08, 1.1, -1.3, 0.1), P._replace(c1=0.1)
    plant, start, thrusts = Plant(p, coupling=c), (0.0, 1.2, 0.15, 0.2, 0.3, -0.4), thrust(np.array(HOVER), p)

    def rhs(t, x):
        dx = np.array(dynamics(x, virtual_input(thrusts), p))
        _, w1, q2, w2, q3, w3 = x
        up, along = np.sin(q2 - c.centre), np.cos(q2 - c.centre)
        dx[1] += 2.0 * c.centrifugal * up / along * w1 * w2 + 0.27 * c.gyro * p.b2 / p.b3 * w3 * np.sin(q3)
        dx[3] += -c.centrifugal * up * along * w1**2 + 0.27 * c.gyro * p.b2 / p.b3 * w3 * np.cos(q3)
        dx[5] += c.airflow * abs(w1) * w1 - c.spin * np.sin(q3) * np.cos(q3) * (w1**2 - w2**2)
        dx[5] += c.gyro * (w2 * np.cos(q3) + w1 * np.sin(q3))
        return dx

    x = solve_ivp(rhs, (0.0, 0.5), start, rtol=1e-10, atol=1e-12).y[:, -1]
    assert_allclose(simulate(plant, HOVER, start, duration=0.5, dt=0.005).x[:, -1], x, atol=1e-6)


def test_the_plant_of_a_rig_has_its_effects():
    curves = ThrustMap(PowerCurve(0.03, -0.01, 1.7), PowerCurve(0.027, -0.01, 1.7))
    coupling = Coupling(centrifugal=1.0, gyro=-1.2)
    rig = Rig("own", P._replace(c1=0.1), curves, lag=0.11, delay=0.03, sensor_zeros=(0.0, 0.0, 0.1), coupling=coupling)
    plant = Plant.from_rig(Rig.from_toml(rig.to_toml()))
    assert plant.parameters == rig.parameters and plant.thrust_map == curves and plant.coupling == coupling
    assert (plant.rotors.lag, plant.rotors.delay) == (0.11, 0.03)
    assert plant.sensors.zeros[2] == -0.1  # where the sensor reads zero, not what it reads at zero
    assert plant.table == Table(rig.table_elevation)
    assert Plant.from_rig("paper", sensors=None, table=None, rotors=Rotors()) == Plant()
    assert Plant.from_rig(rig, table=None).table is None


def test_the_encoders_of_a_rig_read_with_its_signs_and_without_its_zeros():
    zeros, signs = (0.0, math.radians(27.5), 0.1), (1, -1, 1)
    rig = Rig("own", encoder_counts=(2**20,) * 3, sensor_zeros=zeros, sensor_signs=signs)
    flight = simulate(Plant.from_rig(rig, table=None, rotors=Rotors()), duration=0.2)
    readings = np.array(signs) * flight.x[::2].T + np.array(zeros)  # of the rig: angle = sign * (reading - zero)
    assert_allclose(flight.measured[::2].T, np.array(signs) * readings, atol=1e-5)


def test_a_table_is_refused_where_elevation_is_positive_upwards_or_pitch_has_the_other_sign():
    upwards, otherwise = P._replace(a2=-P.a2, b2=-P.b2), P._replace(b3=-P.b3)
    for parameters in (upwards, otherwise, P._replace(b2=Uniform(-1.0, 0.0))):
        with pytest.raises(ValueError, match=r"parameters.b2 = .*must be b2 <= -0.001 .* with a table"):
            Plant(parameters, table=Table())
    for parameters in (upwards, otherwise):
        assert Plant.from_rig(Rig("own", parameters)).table is None


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Plant(coupling=(1.0,)), "coupling = "),
        (lambda: Plant(coupling=Coupling(gyro=math.nan)), "coupling.gyro"),
        (lambda: Plant(coupling=Coupling(centre=1.0)), "coupling.centre"),
        (lambda: Plant(rig=solve_rigid_body("A"), coupling=Coupling(gyro=1.0)), "must be left out with a rigid body"),
        (lambda: Rig("own", coupling=Coupling(spin=math.inf)), "coupling.spin"),
        (lambda: Plant.from_rig("nowhere"), "rig = 'nowhere'"),
    ],
)
def test_bad_coupling_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
