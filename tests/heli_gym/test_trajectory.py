"""Maneuvers and trajectories: validation, immutability, interpolation, files."""

import dataclasses
import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from independent import TABLE_I, equation_2
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import Limits, Maneuver, Trajectory
from heli_gym.trajectory import concatenate


@st.composite
def trajectories(draw):
    steps = draw(st.lists(st.floats(0.01, 2.0), min_size=1, max_size=4))
    numbers = st.floats(-100.0, 100.0)
    n = len(steps) + 1
    x, u = draw(arrays(float, (6, n), elements=numbers)), draw(arrays(float, (2, n), elements=numbers))
    return Trajectory(np.concatenate(([0.0], np.cumsum(steps))), x, u)


def some_trajectory() -> Trajectory:
    rng = np.random.default_rng(2)
    return Trajectory(
        np.cumsum(rng.uniform(0.1, 0.5, 20)) * (np.arange(20) > 0), *np.split(rng.normal(size=(8, 20)), [6])
    )


# Maneuver


@pytest.mark.parametrize("duration", [0.0, -1.0, math.nan, math.inf])
def test_a_duration_that_is_not_positive_and_finite_is_named(duration):
    with pytest.raises(ValueError, match=f"duration = {duration}"):
        Maneuver(duration=duration)


@pytest.mark.parametrize("name", ["start", "goal"])
@pytest.mark.parametrize("point", [(math.nan, 0.0), (0.0, math.inf), (0.0,), (0.0, 0.0, 0.0), 0.0])
def test_a_set_point_that_is_not_two_finite_angles_is_named(name, point):
    with pytest.raises(ValueError, match=f"{name} = "):
        Maneuver(**{name: point})


@pytest.mark.parametrize("name", ["start", "goal"])
@given(elevation=st.floats(-1.5, 1.5))
def test_a_set_point_is_accepted_if_and_only_if_hover_holds_it_within_the_voltages(name, elevation):
    p, limits = TABLE_I, Limits()
    thrust_per_fan = -0.5 * (p.a1 * math.sin(elevation) + p.a2 * math.cos(elevation)) / p.b2
    if equation_2(limits.u_min) < thrust_per_fan < equation_2(limits.u_max):
        assert getattr(Maneuver(**{name: (1.0, elevation)}), name) == (1.0, elevation)
    else:
        with pytest.raises(ValueError, match=rf"{name} = \(1.0, .*V on each motor"):
            Maneuver(**{name: (1.0, elevation)})


@pytest.mark.parametrize("name", ["start_state", "goal_state"])
def test_an_elevation_that_hover_does_not_hold_is_refused_by_the_argument_that_gave_it(name):
    with pytest.raises(ValueError, match=rf"^{name} = \(0.0, 0.0, 1.0, .*hover at elevation 57.30 deg takes"):
        Maneuver(**{name: (0.0, 0.0, 1.0, 0.0, 0.0, 0.0)})


def test_a_wider_voltage_window_holds_more():
    with pytest.raises(ValueError, match="goal"):
        Maneuver(goal=(0.0, math.radians(-22.0)))
    Maneuver(goal=(0.0, math.radians(-22.0)), limits=Limits(u_max=12.0))


def test_a_maneuver_is_an_immutable_value():
    maneuver = Maneuver(goal=[1, 0])
    assert maneuver == Maneuver(goal=(1.0, 0.0))
    assert pickle.loads(pickle.dumps(maneuver)) == maneuver
    with pytest.raises(dataclasses.FrozenInstanceError):
        maneuver.duration = 5.0


def test_a_maneuver_prints_its_goal_in_degrees():
    text = str(Maneuver(start=(0.0, math.radians(5.0)), goal=(math.pi, 0.0), duration=8.0))
    assert text == "travel 0 to 180 deg, elevation 5 to 0 deg in 8 s within 1 to 11 V and -50 to 50 deg of pitch"


# Trajectory: what it accepts


@pytest.mark.parametrize(
    ("t", "x", "u", "name"),
    [
        (np.zeros((2, 2)), np.zeros((6, 2)), np.zeros((2, 2)), "t"),
        (np.array(1.0), np.zeros((6, 1)), np.zeros((2, 1)), "t"),
        (np.array([0.0]), np.zeros((6, 1)), np.zeros((2, 1)), "t"),
        (np.array([]), np.zeros((6, 0)), np.zeros((2, 0)), "t"),
        (np.arange(3.0), np.zeros((3, 6)), np.zeros((2, 3)), "x"),
        (np.arange(3.0), np.zeros((6, 4)), np.zeros((2, 3)), "x"),
        (np.arange(3.0), np.zeros((6, 3)), np.zeros((3, 2)), "u"),
        (np.arange(3.0), np.zeros((6, 3)), np.zeros(3), "u"),
    ],
)
def test_a_wrong_shape_is_named(t, x, u, name):
    with pytest.raises(ValueError, match=f"^{name} has shape"):
        Trajectory(t, x, u)


@pytest.mark.parametrize("name", ["t", "x", "u"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_value_that_is_not_finite_is_named(name, value):
    data = {"t": np.arange(3.0), "x": np.zeros((6, 3)), "u": np.zeros((2, 3))}
    data[name][..., 1] = value
    with pytest.raises(ValueError, match=f"^{name} is not finite"):
        Trajectory(**data)


@pytest.mark.parametrize("t", [[0.0, 2.0, 1.0], [0.0, 1.0, 1.0], [1.0, 2.0, 3.0], [-1.0, 0.0, 1.0]])
def test_times_that_do_not_increase_from_zero_are_refused(t):
    with pytest.raises(ValueError, match="t must increase from 0"):
        Trajectory(t, np.zeros((6, 3)), np.zeros((2, 3)))


def test_a_trajectory_is_read_only_and_does_not_share_its_arrays():
    t, x, u = np.arange(3.0), np.zeros((6, 3)), np.zeros((2, 3))
    trajectory = Trajectory(t, x, u)
    x[:] = 7.0
    assert_array_equal(trajectory.x, 0.0)
    for array in (trajectory.t, trajectory.x, trajectory.u):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        trajectory.x = x


# Trajectory: in between


@given(trajectories())
def test_at_its_times_it_returns_its_samples(trajectory):
    x, u = trajectory(trajectory.t)
    assert_allclose(x, trajectory.x, rtol=1e-12, atol=1e-9)
    assert_allclose(u, trajectory.u, rtol=1e-12, atol=1e-12)


@given(trajectories(), st.floats(0.0, 1.0))
def test_before_and_after_it_holds_its_ends(trajectory, late):
    for t, end in ((-late, 0.0), (trajectory.duration + late, trajectory.duration)):
        for held, at_end in zip(trajectory(t), trajectory(end)):
            assert_array_equal(held, at_end)
    assert trajectory.duration == trajectory.t[-1]


@given(trajectories(), st.floats(0.0, 1.0))
def test_voltages_in_between_stay_between_the_neighbours(trajectory, share):
    t = share * trajectory.duration
    k = np.clip(np.searchsorted(trajectory.t, t) - 1, 0, len(trajectory.t) - 2)
    low, high = np.sort(trajectory.u[:, k : k + 2], axis=1).T
    _, u = trajectory(t)
    assert (low - 1e-12 <= u).all()
    assert (u <= high + 1e-12).all()


def test_interpolated_rates_are_the_derivatives_of_interpolated_angles():
    trajectory, step = some_trajectory(), 1e-6
    middles = 0.5 * (trajectory.t[1:] + trajectory.t[:-1])
    t = np.concatenate((middles, middles + 0.03, middles - 0.04))
    later, earlier = trajectory(t + step)[0], trajectory(t - step)[0]
    assert_allclose((later - earlier)[0::2] / (2.0 * step), trajectory(t)[0][1::2], atol=1e-6)


def test_states_are_continuous_at_the_samples():
    trajectory, step = some_trajectory(), 1e-10
    inside = trajectory.t[1:-1]
    assert_allclose(trajectory(inside - step)[0], trajectory(inside + step)[0], atol=1e-6)


def test_a_motion_that_is_cubic_in_time_is_interpolated_exactly():
    coefficients = np.random.default_rng(3).normal(size=(3, 4))
    angles = [np.polynomial.Polynomial(c) for c in coefficients]

    def motion(t):
        return np.stack([y for q in angles for y in (q(t), q.deriv()(t))])

    t, times = np.array([0.0, 0.3, 1.0, 1.4]), np.linspace(0.0, 1.4, 57)
    assert_allclose(Trajectory(t, motion(t), np.zeros((2, 4)))(times)[0], motion(times), atol=1e-12)


def test_many_times_at_once_are_as_one_by_one():
    trajectory, t = some_trajectory(), np.linspace(-1.0, 9.0, 34).reshape(2, 17)
    x, u = trajectory(t)
    assert x.shape == (6, 2, 17)
    assert u.shape == (2, 2, 17)
    for index in np.ndindex(t.shape):
        x_one, u_one = trajectory(t[index])
        assert_array_equal(x[:, *index], x_one)
        assert_array_equal(u[:, *index], u_one)


# Trajectory: one after the other


def test_of_two_joined_trajectories_the_second_is_flown_after_the_first():
    first = some_trajectory()
    second = Trajectory([0.0, 0.4, 1.0], np.column_stack((first.x[:, -1], np.ones((6, 2)))), np.ones((2, 3)))
    both = concatenate(first, second)
    assert both.duration == pytest.approx(first.duration + 1.0)
    assert len(both.t) == len(first.t) + 2
    for t in np.linspace(0.0, 0.999 * first.duration, 7):
        assert_allclose(both(t)[0], first(t)[0], atol=1e-12)
    for t in np.linspace(0.0, 1.0, 7):
        assert_allclose(both(first.duration + t)[0], second(t)[0], atol=1e-9)


def test_a_second_trajectory_that_starts_elsewhere_or_has_other_limits_is_refused():
    first = some_trajectory()
    with pytest.raises(ValueError, match="second: starts in"):
        concatenate(first, Trajectory([0.0, 1.0], np.full((6, 2), 9.0), np.zeros((2, 2))))
    x = np.repeat(first.x[:, -1:], 2, axis=1)
    with pytest.raises(ValueError, match="second: planned within"):
        concatenate(first, Trajectory([0.0, 1.0], x, np.zeros((2, 2)), Limits(u_max=10.0)))


# Trajectory: on disk


@given(trajectories())
def test_load_inverts_save(tmp_path_factory, trajectory):
    path = tmp_path_factory.mktemp("round") / "trip.npz"
    limits = Limits(u_min=-1.0, u_max=10.0, pitch_min=-0.3, pitch_max=0.6)
    saved = dataclasses.replace(trajectory, limits=limits)
    saved.save(path)
    loaded = Trajectory.load(path)
    for name in ("t", "x", "u"):
        assert_array_equal(getattr(loaded, name), getattr(saved, name))
    assert loaded.limits == limits


def test_a_saved_file_needs_no_pickle(tmp_path):
    path = tmp_path / "plan.npz"
    some_trajectory().save(str(path))
    with np.load(path, allow_pickle=False) as data:
        assert {data[name].dtype.kind for name in data.files} == {"f", "U"}
        assert {"t", "x", "u"} <= set(data.files)


def test_a_name_without_npz_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"path = .*plan\.dat"):
        some_trajectory().save(tmp_path / "plan.dat")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("failing", ["numpy.savez_compressed", "os.replace"])
def test_a_failure_in_writing_leaves_the_old_file_and_no_litter(tmp_path, monkeypatch, failing):
    path = tmp_path / "plan.npz"
    some_trajectory().save(path)
    before = path.read_bytes()

    def fail(file, *args, **kwargs):
        if hasattr(file, "write"):
            file.write(b"half of it")
        raise OSError("no space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(failing, fail)
        with pytest.raises(OSError, match="no space left"):
            Trajectory([0.0, 1.0], np.ones((6, 2)), np.ones((2, 2))).save(path)
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_a_save_replaces_the_old_file_and_leaves_no_litter(tmp_path):
    path = tmp_path / "plan.npz"
    some_trajectory().save(path)
    Trajectory([0.0, 1.0], np.ones((6, 2)), np.ones((2, 2))).save(path)
    assert_array_equal(Trajectory.load(path).x, 1.0)
    assert list(tmp_path.iterdir()) == [path]


def no_archive(path):
    path.write_text("t, x, u\n0, 1, 2\n")


def empty(path):
    path.write_bytes(b"")


def half(path):
    some_trajectory().save(path)
    path.write_bytes(path.read_bytes()[:300])


def one_array(path):
    with open(path, "wb") as file:
        np.save(file, np.zeros(3))


def other_arrays(path):
    np.savez(path, t=np.arange(3.0), a=np.zeros(3))


def pickled_objects(path):
    t = np.array([0.0, 1.0, 2.0], dtype=object)
    np.savez(path, t=t, x=np.zeros((6, 3)), u=np.zeros((2, 3)), limits=np.array([1.0, 11.0, -1.0, 1.0]))


def shapes_that_do_not_fit(path):
    np.savez(path, t=np.arange(3.0), x=np.zeros((3, 6)), u=np.zeros((2, 3)), limits=np.array([1.0, 11.0, -1.0, 1.0]))


def limits_that_contradict(path):
    np.savez(path, t=np.arange(3.0), x=np.zeros((6, 3)), u=np.zeros((2, 3)), limits=np.array([11.0, 1.0, -1.0, 1.0]))


@pytest.mark.parametrize(
    "write",
    [
        no_archive,
        empty,
        half,
        one_array,
        other_arrays,
        pickled_objects,
        shapes_that_do_not_fit,
        limits_that_contradict,
    ],
)
def test_a_file_that_is_something_else_is_named(tmp_path, write):
    path = tmp_path / "plan.npz"
    write(path)
    with pytest.raises(ValueError, match=r"path = .*plan\.npz"):
        Trajectory.load(path)


def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(FileNotFoundError, match="nowhere"):
        Trajectory.load(tmp_path / "nowhere.npz")
