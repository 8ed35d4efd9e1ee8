"""Displays of values in a notebook: short texts, plots and pictures."""

import io

import gymnasium as gym
import numpy as np
import pytest

import heli_gym  # noqa: F401
from heli_gym.env import find_reference
from heli_gym.notebook import png, short_repr
from heli_gym.plant import PLANTS, Friction, OneOf, Plant, Rotors, Sensors, Uniform, find_plant  # noqa: F401


def test_a_png_holds_the_pixels_that_it_was_made_of():
    image = pytest.importorskip("matplotlib.image")
    pixels = np.random.default_rng(0).integers(0, 256, (5, 7, 3), np.uint8)
    np.testing.assert_array_equal(np.round(255.0 * image.imread(io.BytesIO(png(pixels)))[..., :3]), pixels)


def test_a_rendered_frame_shows_itself_and_parts_of_it_do_not():
    pytest.importorskip("pygame")
    env = gym.make("Heli3DOF-v0", render_mode="rgb_array")
    env.reset(seed=0)
    frame = env.render()
    assert frame._repr_png_().startswith(b"\x89PNG")
    assert (frame.astype(float) / 2.0)._repr_png_() is None
    assert frame[0]._repr_png_() is None
    env.close()


def test_a_trajectory_has_a_short_text_and_a_plot():
    pytest.importorskip("matplotlib")
    trajectory = find_reference("climb-15")
    assert len(repr(trajectory)) < 120
    assert trajectory._repr_png_().startswith(b"\x89PNG")


def test_a_plant_is_written_as_the_call_that_makes_it_without_defaults():
    assert repr(Plant()) == "Plant()"
    assert repr(Rotors(lag=0.1)) == "Rotors(lag=0.1)"
    assert eval(repr(PLANTS["lab"])) == PLANTS["lab"]
    assert short_repr(Friction()) == "Friction()"
