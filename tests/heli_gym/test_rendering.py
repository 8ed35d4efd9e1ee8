"""Pictures: positions against MuJoCo and a camera matrix, visibility, and Gymnasium's rules."""

import math
import subprocess
import sys
from dataclasses import replace

import gymnasium as gym
import mujoco
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.wrappers import HumanRendering, RecordVideo, RenderCollection
from numpy.testing import assert_allclose, assert_array_equal

import heli_gym
from heli_gym.env import Heli3DOFEnv
from heli_gym.model import thrust
from heli_gym.parameters import Limits
from heli_gym.rendering import Renderer, RenderState
from heli_gym.rendering.geometry import (
    BACK,
    FRONT,
    RIG,
    ROTOR_HEIGHT,
    Camera,
    arrow,
    box,
    circle,
    helicopter,
    hoop,
    normals,
    parts,
    pose,
    project,
    rotors,
    shadows,
    tube,
)
from heli_gym.rendering.renderer import ARROW, EYE, GHOST, LIMIT, OVERSAMPLING
from heli_gym.rendering.scene import travel_interval
from heli_gym.rig import PAPER as PAPER_RIG
from heli_gym.rig import find_rig
from heli_gym.rigid_body import mjcf

HOVER_THRUST = 0.5 * 0.3946 / 0.6523  # N, of each rotor
HOVER = RenderState((0.0,) * 6, (7.9, 7.9), (0.0,) * 6, (7.9, 7.9), 0.0, 10.0)
ASTRAY = HOVER._replace(state=(0.8, 0.0, 0.1, 0.0, 0.4, 0.0), voltage=(11.5, 6.0), time=4.0, title="a title")
ANGLES = np.random.default_rng(5).uniform(-1.0, 1.0, (50, 3)) * (math.pi, 1.2, 1.5)


@pytest.fixture(autouse=True)
def no_display(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")


@pytest.fixture(scope="module")
def renderer():
    return Renderer(480)


def seen(picture, colour, within=12):
    """How many pixels have about this colour."""
    return int((np.abs(picture.astype(int) - colour).max(axis=2) <= within).sum())


# Geometry


def test_forward_kinematics_is_that_of_mujoco():
    model = mujoco.MjModel.from_xml_string(mjcf(RIG))
    data = mujoco.MjData(model)
    for angles in ANGLES:
        data.qpos[:] = angles
        mujoco.mj_kinematics(model, data)
        at = pose(np.array((angles[0], 0.0, angles[1], 0.0, angles[2], 0.0)))
        expected = np.stack([data.site(name).xpos for name in ("front", "back")], axis=1)
        assert_allclose(rotors(at), expected, atol=1e-14)
        assert_allclose(at.hinge, data.body("body").xpos, atol=1e-14)
        assert_allclose(at.body, data.body("body").xmat.reshape(3, 3), atol=1e-14)
        assert_allclose(at.arm @ (-RIG.l_c, 0.0, -RIG.d_c), data.geom("counterweight").xpos, atol=1e-14)


def test_projection_is_that_of_a_camera_matrix():
    camera = Camera((1.0, -2.0, 1.5), (0.2, 0.1, -0.3), 700.0, (320.0, 200.0))
    points = np.random.default_rng(2).uniform(-0.8, 0.8, (3, 40))
    # A right-handed frame on the camera's axis, turned so that its x is level, and the intrinsic matrix.
    backward = np.subtract(camera.eye, camera.target) / np.linalg.norm(np.subtract(camera.eye, camera.target))
    azimuth = math.atan2(backward[1], backward[0])
    right = np.array((-math.sin(azimuth), math.cos(azimuth), 0.0))
    view = np.eye(4)
    view[:3, :3] = right, np.cross(backward, right), backward
    view[:3, 3] = -view[:3, :3] @ camera.eye
    intrinsic = np.array([[700.0, 0.0, -320.0, 0.0], [0.0, -700.0, -200.0, 0.0], [0.0, 0.0, -1.0, 0.0]])
    x, y, w = intrinsic @ view @ np.concatenate((points, np.ones((1, 40))))
    pixels, depth = project(points, camera)
    assert_allclose(depth, w, rtol=1e-12)
    assert_allclose(pixels, (x / w, y / w), rtol=1e-10)


def test_the_camera_target_is_in_the_centre_and_higher_points_are_above():
    camera = Camera((1.0, -2.0, 1.5), (0.0, 0.0, 0.2), 700.0, (320.0, 200.0))
    pixels, depth = project((0.0, 0.0, 0.2), camera)
    assert_allclose(pixels, camera.centre, atol=1e-12)
    assert depth == pytest.approx(math.dist(camera.eye, camera.target))
    x, y = project((0.0, 0.0, 0.4), camera)[0]
    assert x == pytest.approx(320.0)
    assert y < 200.0


def test_points_are_projected_in_any_shape():
    points = np.random.default_rng(1).uniform(-0.5, 0.5, (3, 4, 5))
    camera = Camera(EYE, (0.0, 0.0, 0.0), 500.0, (0.0, 0.0))
    pixels, depth = project(points, camera)
    assert pixels.shape == (2, 4, 5)
    assert_allclose(pixels[:, 2, 3], project(points[:, 2, 3], camera)[0], rtol=1e-12)
    assert_allclose(depth.ravel(), project(points.reshape(3, -1), camera)[1], rtol=1e-12)


def volume(mesh):
    """By the divergence theorem: positive only if the faces are turned outwards."""
    a, b, c, d = np.moveaxis(mesh.vertices[:, mesh.faces], 2, 0)
    area = 0.5 * np.linalg.norm(np.cross(c - a, d - b, axis=0), axis=0)
    return ((a + b + c + d) / 4.0 * normals(mesh)).sum(axis=0) @ area / 3.0


def test_boxes_and_tubes_are_closed_and_turned_outwards():
    assert volume(box((-0.1, 0.0, 0.2), (0.3, 0.5, 0.3), FRONT)) == pytest.approx(0.4 * 0.5 * 0.1)
    for pieces in (1, 5):
        mesh = tube((0.1, 0.2, 0.3), (0.4, -0.1, 0.5), 0.02, FRONT, sides=60, pieces=pieces)
        assert volume(mesh) == pytest.approx(math.pi * 0.02**2 * math.sqrt(0.22), rel=0.01)


def test_a_hoop_is_seen_from_both_sides():
    mesh = hoop((0.0, 0.0, 0.0), 0.1, 0.02, FRONT)
    assert_allclose(normals(mesh).sum(axis=1), 0.0, atol=1e-12)
    assert volume(mesh) == pytest.approx(0.0, abs=1e-12)


def test_moving_the_rig_keeps_its_shape():
    at = pose((1.0, 0.0, 0.3, 0.0, -0.5, 0.0))
    still, turned = helicopter(pose((0.0,) * 6)), helicopter(at)
    body = parts()["body"].vertices.shape[1]
    for part in (slice(-body, None), slice(parts()["yoke"].vertices.shape[1], -body)):
        before, after = still.vertices[:, part], turned.vertices[:, part]
        assert_allclose(
            np.linalg.norm(after - after[:, :1], axis=0), np.linalg.norm(before - before[:, :1], axis=0), atol=1e-12
        )


def test_shadows_are_below_their_objects():
    at = pose((0.7, 0.0, 0.2, 0.0, 0.5, 0.0))
    *_, front, back = shadows(at)
    assert_allclose(
        np.stack((front[:, :-1].mean(axis=1), back[:, :-1].mean(axis=1)), axis=1), rotors(at)[:2], atol=1e-9
    )


def test_an_arrow_points_along_its_vector_and_faces_the_eye():
    foot, way = np.array((0.6, 0.1, 0.0)), np.array((0.0, 0.1, 0.2))
    corners = arrow(foot, way, EYE)
    assert_allclose(corners[:, 3], foot + way)
    assert_allclose(0.5 * (corners[:, 0] + corners[:, -1]), foot)
    across = corners[:, 0] - corners[:, -1]
    assert_allclose([across @ way, across @ (foot - np.array(EYE))], 0.0, atol=1e-12)


def test_an_arc_has_its_radius_and_ends():
    points = circle(2.0, 5, 0.0, math.pi / 2)
    assert_allclose(np.hypot(*points), 2.0)
    assert_allclose(points[:, [0, -1]], [[2.0, 0.0], [0.0, 2.0]], atol=1e-12)


@pytest.mark.parametrize(
    ("travel", "end"), [(1.0, 1.0), (-1.0, -1.0), (7.0, 0.5 + 2.0 * math.pi), (-9.0, 0.5 - 2.0 * math.pi)]
)
def test_the_way_flown_is_one_turn_at_most(travel, end):
    scene = HOVER._replace(state=(travel, 0.0, 0.0, 0.0, 0.0, 0.0), travel_start=0.5)
    assert travel_interval(scene) == pytest.approx((0.5, end))


# Pictures


@pytest.mark.parametrize("width", [160, 480, 960])
def test_a_picture_is_an_array_of_bytes_four_to_three(width):
    picture = Renderer(width).frame(ASTRAY)
    assert (picture.shape, picture.dtype) == ((width * 3 // 4, width, 3), np.uint8)
    assert picture.flags.writeable


def test_equal_scenes_give_equal_pictures_after_any_other_picture(renderer):
    first = renderer.frame(ASTRAY)
    renderer.frame(HOVER._replace(voltage_limits=(-12.0, 12.0)))
    assert_array_equal(renderer.frame(ASTRAY), first)
    assert_array_equal(Renderer(480).frame(ASTRAY), first)


@pytest.mark.parametrize(
    "changes",
    [
        {"state": (0.81, 0.0, 0.1, 0.0, 0.4, 0.0)},
        {"state": (0.8, 0.0, 0.12, 0.0, 0.4, 0.0)},
        {"state": (0.8, 0.0, 0.1, 0.0, 0.42, 0.0)},
        {"voltage": (11.5, 6.3)},
        {"voltage": (11.2, 6.0)},
        {"reference": (0.0, 0.0, 0.1, 0.0, 0.0, 0.0)},
        {"nominal_voltage": (8.2, 7.9)},
        {"time": 4.3},
        {"duration": 12.0},
        {"travel_start": 0.2},
        {"limits": heli_gym.Limits(2.0, 10.0)},
        {"voltage_limits": (0.0, 15.0)},
        {"pitch_limit": 1.2},
        {"title": "another"},
        {"note": "over"},
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_everything_in_a_scene_is_shown(renderer, changes):
    assert (renderer.frame(ASTRAY._replace(**changes)) != renderer.frame(ASTRAY)).any()


def test_an_arrow_is_where_the_thrust_acts(renderer):
    at = pose(HOVER.state)
    middle = rotors(at) + (ROTOR_HEIGHT + 0.4 * ARROW * float(thrust(7.9)) / HOVER_THRUST) * at.body[:, 2:]
    columns, rows = (project(middle, renderer.camera)[0] / OVERSAMPLING).astype(int)
    picture = renderer.frame(HOVER).astype(int)
    for row, column, colour in zip(rows, columns, (FRONT, BACK)):
        assert np.abs(picture[row, column] - colour).max() < 12


def test_arrows_grow_with_the_voltage(renderer):
    view = [renderer.frame(HOVER._replace(voltage=(u, u)))[:270] for u in (0.0, 4.0, 8.0, 11.0)]
    for colour in (FRONT, BACK):
        areas = [seen(picture, colour, within=4) for picture in view]
        assert areas == sorted(set(areas))


def test_a_rig_with_other_signs_is_drawn_as_the_papers_in_the_same_position(renderer):
    p = PAPER_RIG.parameters
    other = replace(PAPER_RIG, name="other", parameters=p._replace(a2=-p.a2, b1=p.b1, b2=-p.b2, b3=-p.b3))
    state, reference = np.array((0.4, 0.0, 0.1, 0.0, 0.3, 0.0)), np.array((0.5, 0.0, 0.05, 0.0, 0.2, 0.0))
    signs = np.array((-1.0, 1.0, -1.0, 1.0, -1.0, 1.0))
    scene = HOVER._replace(state=state, reference=reference, limits=Limits(1.0, 11.0, -0.4, 0.8))
    same = scene._replace(
        state=signs * state, reference=signs * reference, limits=Limits(1.0, 11.0, -0.8, 0.4), rig=other
    )
    above = slice(0, int(0.75 * renderer.size[1]))  # without the readouts, which have the rig's own numbers
    assert_array_equal(renderer.frame(scene)[above], renderer.frame(same)[above])


def test_at_hover_the_arrows_of_every_rig_are_equally_long(renderer):
    areas = []
    for rig in (PAPER_RIG, find_rig("ntnu"), find_rig("quanser")):
        scene = HOVER._replace(voltage=tuple(rig.hover_voltage()), voltage_limits=rig.voltage_limits, rig=rig)
        areas.append([seen(renderer.frame(scene)[:270], colour, within=4) for colour in (FRONT, BACK)])
    assert_allclose(areas[1:], [areas[0]] * 2, rtol=0.05)


def test_the_ghost_is_seen_only_off_the_reference(renderer):
    green = (GHOST[0] + 115, GHOST[1] + 35, GHOST[2] + 65)  # on the sky
    on, off = (renderer.frame(HOVER._replace(reference=(q1, 0.0, 0.0, 0.0, 0.0, 0.0)))[:270] for q1 in (0.0, 1.0))
    assert 10 * seen(on, green, within=30) < seen(off, green, within=30)


def test_a_voltage_outside_of_the_plans_window_is_red(renderer):
    inside, outside = (seen(renderer.frame(HOVER._replace(voltage=(u, 7.9))), LIMIT) for u in (10.9, 11.1))
    assert outside > inside + 500


def test_extreme_scenes_are_drawn(renderer):
    extreme = HOVER._replace(state=(900.0, 0.0, -3.0, 0.0, 1.6, 0.0), voltage=(-12.0, 24.0), time=99.0)
    assert renderer.frame(extreme).std() > 0.0


def test_pictures_survive_that_somebody_quits_pygame(renderer):
    first = renderer.frame(ASTRAY)
    renderer.pygame.quit()
    assert_array_equal(renderer.frame(ASTRAY), first)


@pytest.mark.parametrize("width", [0, -480, 100, 481, 480.0, "480", None, 10**6])
def test_another_width_is_refused(width):
    with pytest.raises(ValueError, match=f"width = {width!r}"):
        Renderer(width)


def test_without_pygame_the_message_names_the_extra_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(gym.error.DependencyNotInstalled, match=r"pip install \"heli-gym\[render\]\""):
        Renderer()


def test_importing_the_environment_loads_no_pygame():
    script = "import sys, heli_gym.env, heli_gym.rendering; assert 'pygame' not in sys.modules"
    subprocess.run([sys.executable, "-c", script], check=True)


# A window


def test_the_window_shows_the_picture(renderer):
    renderer.show(ASTRAY)
    shown = renderer.pygame.surfarray.array3d(renderer.pygame.display.get_surface())
    assert_array_equal(shown.transpose(1, 0, 2), renderer.frame(ASTRAY))
    renderer.close()
    assert not renderer.pygame.display.get_init()
    renderer.close()


class Recorder:
    """In place of pygame's clock."""

    def __init__(self):
        self.ticks = []

    def tick(self, rate):
        self.ticks.append(rate)


def test_a_window_shows_flights_in_real_time_and_skips_excess_frames(renderer):
    renderer.show(HOVER)
    renderer.clock = clock = Recorder()
    for milliseconds in range(1, 101):
        renderer.show(HOVER._replace(time=1e-3 * milliseconds))
    assert_allclose(clock.ticks, 1.0 / 0.017)
    renderer.show(HOVER)  # another flight
    renderer.show(HOVER._replace(time=0.02))
    assert clock.ticks[5:] == [pytest.approx(50.0)]
    renderer.close()


# The environment


def test_an_environment_draws_its_state():
    env = gym.make("Heli3DOF-v0", render_mode="rgb_array", plant="lab")
    env.reset(seed=0)
    first = env.render()
    assert first.shape == (720, 960, 3)
    assert_array_equal(env.render(), first)
    env.step(np.zeros(2, dtype=np.float32))
    assert (env.render() != first).any()
    env.close()
    assert env.render().shape == first.shape  # as long as somebody asks
    env.close()
    env.close()


def test_an_environment_opens_a_window_by_itself_and_closes_it():
    import pygame

    env = gym.make("Heli3DOF-v0", render_mode="human")
    env.reset(seed=0)
    assert pygame.display.get_surface().get_size() == (960, 720)
    env.step(np.zeros(2, dtype=np.float32))
    assert env.unwrapped.renderer.shown == pytest.approx(0.02)
    assert env.render() is None
    env.close()
    assert not pygame.display.get_init()
    env.close()


def test_a_window_without_a_display_says_that_nothing_is_seen(monkeypatch, caplog):
    for name in ("SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    env = gym.make("Heli3DOF-v0", render_mode="human")
    env.reset(seed=0)
    env.step(np.zeros(2, dtype=np.float32))
    env.close()
    assert [record.message for record in caplog.records if "finds no display" in record.message] == [
        "heli_gym: render_mode='human' finds no display: nothing is seen; 'rgb_array' gives pictures"
    ]


def test_without_a_render_mode_drawing_is_warned_about():
    env = Heli3DOFEnv()
    env.reset(seed=0)
    with pytest.warns(UserWarning, match="render"):
        assert env.render() is None
    env.close()


def test_before_the_first_reset_there_is_nothing_to_draw():
    with pytest.raises(gym.error.ResetNeeded, match="reset"):
        Heli3DOFEnv(render_mode="rgb_array").render()


@pytest.mark.parametrize("mode", ["ansi", "rgb_array_list", "", 1])
def test_another_render_mode_is_refused(mode):
    with pytest.raises(ValueError, match=f"render_mode = {mode!r}"):
        Heli3DOFEnv(render_mode=mode)


@pytest.mark.parametrize(("period", "fps"), [(0.02, 50), (0.001, 1000), (0.03, 33)])
def test_the_frame_rate_is_that_of_the_control_steps(period, fps):
    env = Heli3DOFEnv(control_period=period)
    assert env.metadata["render_fps"] == fps
    assert type(env.metadata["render_fps"]) is int
    assert Heli3DOFEnv.metadata["render_fps"] == 50


def test_the_checkers_have_nothing_to_say_about_pictures():
    checker = pytest.importorskip("stable_baselines3.common.env_checker")
    env = gym.make("Heli3DOF-v0", render_mode="rgb_array").unwrapped
    check_env(env)
    checker.check_env(env)


def test_gymnasiums_wrappers_collect_and_show_the_pictures():
    env = RenderCollection(gym.make("Heli3DOF-v0", render_mode="rgb_array"))
    env.reset(seed=0)
    for _ in range(3):
        env.step(env.action_space.sample())
    assert len(env.render()) == 4
    env.close()

    env = HumanRendering(gym.make("Heli3DOF-v0", render_mode="rgb_array"))
    env.reset(seed=0)
    env.step(env.action_space.sample())
    env.close()


def test_record_video_writes_a_video(tmp_path):
    pytest.importorskip("moviepy")
    env = RecordVideo(gym.make("Heli3DOF-v0", render_mode="rgb_array"), str(tmp_path / "videos"), video_length=10)
    env.reset(seed=0)
    for _ in range(12):
        env.step(env.action_space.sample())
    env.close()
    (video,) = (tmp_path / "videos").glob("*.mp4")
    assert video.stat().st_size > 1000
