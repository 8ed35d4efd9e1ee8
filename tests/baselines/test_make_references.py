"""Maneuver suite: stored files, replay through (3), limits, start and goal."""

import math

import numpy as np
import pytest
from independent import TABLE_I, equation_3, inputs, replay
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import HelicopterParameters, Limits, Trajectory
from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.commands.make_references import (
    SUITE,
    Args,
    ground_elevation,
    main,
    resample,
    solve_reference,
)
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.env import REFERENCES, Heli3DOFEnv, find_reference
from heli_gym.flatness import invert_motion
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import PAPER

GROUND_DEG = math.degrees(math.atan(-TABLE_I.a2 / TABLE_I.a1))

# travel and elevation at the start and at the end (deg), then the duration (s)
ENDS = {
    "travel-360": ((0.0, 0.0), (360.0, 0.0), 10.0),
    "travel-360-slow": ((0.0, 0.0), (360.0, 0.0), 15.0),
    "travel-180": ((0.0, 0.0), (180.0, 0.0), 10.0),
    "climb-7.5": ((0.0, 0.0), (0.0, -7.5), 5.0),
    "descend-7.5": ((0.0, 0.0), (0.0, 7.5), 5.0),
    "climb-15": ((0.0, 0.0), (0.0, -15.0), 7.0),
    "back-60-descend": ((0.0, 0.0), (-60.0, 5.0), 7.0),
    "travel-90-climb": ((0.0, 0.0), (90.0, -7.5), 8.0),
    "return-180": ((0.0, 0.0), (0.0, 0.0), 20.0),
    "elevation-sine": ((0.0, 0.0), (0.0, 0.0), 20.0),
    "take-off": ((0.0, GROUND_DEG), (0.0, 0.0), 8.0),
}
FROM_REST = [name for name in SUITE if name != "elevation-sine"]
GENTLE = [name for name in FROM_REST if name != "travel-360"]
SEEDS = range(3)


def test_the_suite_is_the_set_of_packaged_references():
    assert {path.stem for path in REFERENCES.glob("*.npz")} == set(SUITE) == set(ENDS)


def test_all_references_together_are_small():
    assert sum(path.stat().st_size for path in REFERENCES.glob("*.npz")) < 300_000


@pytest.mark.parametrize("name", SUITE)
def test_stored_references_equal_those_of_the_command(name):
    made, stored = solve_reference(name), find_reference(name)
    assert_allclose(stored.t, made.t, atol=1e-12)
    # The paper's maneuver is near the shortest that (38) can do, where rounding in the solver moves the solution most.
    assert_allclose(stored.x, made.x, atol=5e-4)  # rad and rad/s
    assert_allclose(stored.u, made.u, atol=0.02)  # V
    assert stored.limits == made.limits


@pytest.mark.parametrize("name", SUITE)
def test_its_voltages_fly_it_through_equation_3(name):
    reference = find_reference(name)
    assert np.abs(replay(reference) - reference.x).max() < 2e-4  # rad and rad/s, all the way


@pytest.mark.parametrize("name", SUITE)
def test_it_leads_from_where_to_where_its_name_says(name):
    reference = find_reference(name)
    start, end, duration = ENDS[name]
    assert_allclose(np.degrees(reference.x[[0, 2], 0]), start, atol=1e-9)
    assert_allclose(np.degrees(reference.x[[0, 2], -1]), end, atol=1e-9)
    assert reference.duration == pytest.approx(duration)


@pytest.mark.parametrize("name", FROM_REST)
def test_it_is_at_rest_at_both_ends(name):
    reference = find_reference(name)
    for k in (0, -1):
        assert_allclose(reference.x[[1, 3, 4, 5], k], 0.0, atol=1e-9)
        derivative = equation_3(reference.x[:, k], *inputs(reference.u[:, k]))
        assert_allclose(np.array(derivative, dtype=float), 0.0, atol=1e-4)


@pytest.mark.parametrize("name", SUITE)
def test_each_reference_meets_its_limits_and_the_amplifiers(name):
    reference = find_reference(name)
    expected = Limits(u_min=0.0) if name == "take-off" else Limits()
    assert reference.limits == expected
    assert reference.u.min() >= expected.u_min - 1e-6
    assert reference.u.max() <= expected.u_max + 1e-6
    assert np.abs(reference.x[4]).max() <= expected.pitch_max
    assert AMPLIFIER_LIMITS[0] <= reference.u.min() <= reference.u.max() <= AMPLIFIER_LIMITS[1]


def test_the_return_trip_turns_half_a_circle_and_rests_there():
    x, _ = find_reference("return-180")(10.0)
    assert_allclose(x, [math.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-9)


def test_the_elevation_sine_is_one_while_the_travel_is_another_and_is_never_at_rest():
    reference = find_reference("elevation-sine")
    t = np.linspace(0.0, 20.0, 2001)
    travel, _, elevation, *_ = np.degrees(reference(t)[0])
    assert_allclose(elevation, 7.5 * np.sin(2.0 * np.pi * t / 5.0), atol=1e-3)
    assert_allclose(travel, 45.0 * np.sin(2.0 * np.pi * t / 20.0), atol=1e-3)
    assert np.abs(reference.x[1::2]).max(axis=0).min() > 0.01  # rad/s, at every time


def test_the_take_off_starts_from_rest_without_voltage_18_6_degrees_below_level():
    reference = find_reference("take-off")
    assert_allclose(reference.u[:, 0], 0.0, atol=1e-6)
    assert math.degrees(reference.x[2, 0]) == pytest.approx(18.6, abs=0.05)
    weightless = equation_3([0.0, 0.0, ground_elevation(HelicopterParameters()), 0.0, 0.0, 0.0], 0.0, 0.0)
    assert_allclose(np.array(weightless, dtype=float), 0.0, atol=1e-12)


def test_an_inverted_flight_is_the_flight():
    # level at a constant pitch: tan(q3) b1 / b2 a2 is the acceleration of the travel, by (14a)
    t, pitch = np.linspace(0.0, 2.0, 401), 0.3
    acceleration = -TABLE_I.b1 / TABLE_I.b2 * TABLE_I.a2 * math.tan(pitch)
    travel = np.stack((0.5 * acceleration * t**2, acceleration * t, np.full_like(t, acceleration)))
    flight = invert_motion(t, travel, np.zeros((3, len(t))), Limits(), PAPER)
    assert_allclose(flight.x[4], pitch, atol=1e-12)
    assert_allclose(replay(flight), flight.x, atol=1e-6)


def test_a_fall_that_no_thrust_can_speed_up_is_refused():
    t = np.linspace(0.0, 1.0, 101)
    falling = np.stack((0.5 * t**2, t, np.ones_like(t)))
    with pytest.raises(ValueError, match="elevation: falls faster than without thrust"):
        invert_motion(t, np.zeros((3, 101)), falling, Limits(), PAPER)


def test_resampled_voltages_err_on_both_sides_within_their_limits():
    t = np.linspace(0.0, 2.0, 2001)
    curved = Trajectory(t, np.zeros((6, len(t))), np.stack((1.0 + t**2, np.minimum(5.0 * t + 1.0, 11.0))))
    coarse = resample(curved, 0.1)
    assert_allclose(np.diff(coarse.t), 0.1)
    miss = coarse(t)[1] - curved.u
    assert np.abs(miss[0].mean()) < 2e-4  # V; the chords of 1 + t² are 1.7e-3 V above it on average
    assert_array_equal(coarse.u[:, [0, -1]], curved.u[:, [0, -1]])
    assert coarse.u.max() <= 11.0


def test_the_command_writes_them_all_and_prints_a_line_for_each(tmp_path, capsys, monkeypatch):
    made = Trajectory(np.array([0.0, 1.0]), np.zeros((6, 2)), np.full((2, 2), 7.893))
    monkeypatch.setattr("heli_gym.baselines.commands.make_references.solve_reference", lambda name: made)
    main(Args(out=tmp_path))
    assert {path.name for path in tmp_path.iterdir()} == {f"{name}.npz" for name in SUITE}
    assert_array_equal(Trajectory.load(tmp_path / "take-off.npz").x, made.x)
    printed = capsys.readouterr().out
    assert all(f"{name}: 1 s" in printed for name in SUITE)


def test_the_command_refuses_a_folder_that_is_a_file(tmp_path):
    path = tmp_path / "file"
    path.touch()
    with pytest.raises(SystemExit, match=r"out"):
        main(Args(out=path))


# In flight


@pytest.mark.parametrize("name", SUITE)
def test_on_the_nominal_plant_the_papers_controller_flies_it(name):
    env = Heli3DOFEnv(reference=name)
    flown = flight_metrics(fly(env, make_policy("feedforward+tvlqr", env.reference)), env.reference, AMPLIFIER_LIMITS)
    assert flown.success
    assert max(flown.rms_error_deg) < 0.05


@pytest.mark.parametrize("name", GENTLE)
def test_the_gentle_ones_succeed_on_plants_with_lag_friction_and_thrust_loss(name):
    env = Heli3DOFEnv("lab", reference=name)
    policy = make_policy("feedforward+tvlqr", env.reference)
    for seed in SEEDS:
        assert flight_metrics(fly(env, policy, seed=seed), env.reference, AMPLIFIER_LIMITS).success
