"""Flights side by side as a GIF."""

import math
import os
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from PIL import Image

from heli_gym import Trajectory
from heli_gym.baselines.commands import film
from heli_gym.baselines.commands.film import Args, render_state_at, write_gif
from heli_gym.env import Heli3DOFEnv

ENV = Heli3DOFEnv("lab")


def ended(reference, seconds):
    """The first seconds of a reference, flown exactly, as a flight whose voltages were held."""
    t = 0.02 * np.arange(round(seconds / 0.02) + 1)
    return Trajectory(t, *reference(t), reference.limits)


def test_a_scene_is_the_flight_and_its_reference_at_that_time():
    flight = ended(ENV.reference, 10.0)
    shown = render_state_at(flight, ENV, 2.51, "name")
    assert_allclose(shown.state, flight(2.51)[0])
    assert_array_equal(shown.voltage, flight.u[:, 125])  # held since 2.50 s
    assert_allclose(shown.reference, ENV.reference(2.51)[0])
    assert_allclose(shown.nominal_voltage, ENV.reference(2.51)[1])
    assert (shown.time, shown.duration, shown.title, shown.note) == (2.51, 10.0, "name", "")


def test_a_flight_that_is_over_stays_where_it_ended_and_says_why():
    flight = ended(ENV.reference, 4.0)
    shown = render_state_at(flight, ENV, 7.0, "name")
    assert shown.time == flight.duration
    assert_allclose(shown.state, flight.x[:, -1])
    assert shown.note == "ended: pitch beyond 80°"
    assert render_state_at(flight, ENV, flight.duration, "name").note == ""


def test_a_film_shows_every_flight_to_its_end_side_by_side():
    flights = {"long": ended(ENV.reference, 2.0), "short": ended(ENV.reference, 1.0)}
    pictures = film.film(flights, ENV, 160, 0.3)
    assert len(pictures) == 8  # 0, 0.3, ... 1.8 and 2.0 s
    assert {picture.shape for picture in pictures} == {(120, 320, 3)}
    assert_array_equal(pictures[5][:, 160:], pictures[7][:, 160:])  # over
    assert (pictures[5][:, :160] != pictures[7][:, :160]).any()


def test_a_gif_holds_the_pictures_their_times_and_repeats(tmp_path):
    flights = {"one": ended(ENV.reference, 3.0)}
    pictures = film.film(flights, ENV, 160, 0.5)
    write_gif(pictures, 0.5, tmp_path / "film.gif")
    with Image.open(tmp_path / "film.gif") as gif:
        assert (gif.size, gif.n_frames, gif.info["loop"]) == ((160, 120), len(pictures), 0)
        durations = []
        for k, picture in enumerate(pictures):
            gif.seek(k)
            durations.append(gif.info["duration"])
            difference = np.abs(np.asarray(gif.convert("RGB")).astype(int) - picture)
            assert difference.mean() < 4.0
        assert durations == [500] * (len(pictures) - 1) + [2000]
    assert os.listdir(tmp_path) == ["film.gif"]


@pytest.mark.parametrize("frame_time", [0.0, -0.1, 0.015, 0.01, math.nan, math.inf])
def test_a_frame_time_that_no_gif_has_is_refused(tmp_path, frame_time):
    with pytest.raises(ValueError, match="frame_time"):
        write_gif([np.zeros((8, 8, 3), np.uint8)], frame_time, tmp_path / "film.gif")
    assert os.listdir(tmp_path) == []


def test_the_command_flies_the_policies_and_writes_the_same_film_again(monkeypatch, tmp_path, capsys):
    for name in ("a", "b"):
        out = tmp_path / f"{name}.gif"
        words = "--policies feedforward+tvlqr open-loop --plant lab --seed 0 --width 160 --frame-time 0.5 --out"
        monkeypatch.setattr(sys, "argv", ["film", *words.split(), str(out)])
        film.main()
        assert f"{name}.gif: " in capsys.readouterr().out.replace("\n", "")
    assert (tmp_path / "a.gif").read_bytes() == (tmp_path / "b.gif").read_bytes()
    with Image.open(tmp_path / "a.gif") as gif:
        assert gif.size == (320, 120)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"policies": ()}, "policies"),
        ({"policies": ("open-loop", "open-loop")}, "policies"),
        ({"policies": ("magic",)}, "name = 'magic'"),
        ({"plant": "moon"}, "plant = 'moon'"),
        ({"reference": "nowhere"}, "reference = 'nowhere'"),
        ({"width": 81}, "width = 81"),
        ({"frame_time": 0.033}, r"frame_time = 0\.033"),
        ({"frame_time": 0.0}, r"frame_time = 0\.0"),
        ({"seed": -1}, "seed = -1"),
        ({"name": "film.mp4"}, "film.mp4"),
    ],
    ids=str,
)
def test_bad_input_is_refused_before_anything_is_written(tmp_path, arguments, said):
    name = arguments.pop("name", "film.gif")
    with pytest.raises(SystemExit, match="heli-film: .*" + said):
        film.main(Args(**{"policies": ("open-loop",), "width": 160, **arguments, "out": tmp_path / name}))
    assert os.listdir(tmp_path) == []


def test_the_film_of_the_readme_is_small():
    assert (Path(__file__).parents[2] / "docs" / "flight.gif").stat().st_size < 2e6
