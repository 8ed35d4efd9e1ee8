"""Logged voltages flown by the plant of the rig that flew them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from heli_gym import Coupling, Plant, Uniform
from heli_gym.baselines.commands import log as command
from heli_gym.baselines.identification.estimation import identify
from heli_gym.baselines.identification.flight_log import FlightLog, find_log
from heli_gym.baselines.identification.replay import pieces, replay


@pytest.fixture(scope="module")
def log():
    return find_log("simulated")


@pytest.fixture(scope="module")
def rig(log):
    return identify([log]).rig("found")


def test_the_plant_of_the_identified_rig_moves_as_the_log_does(log, rig):
    flown = replay(log, rig, piece=3.0)
    errors = [log.angles[:, round(p.t[-1] / log.sample_time)] - p.angles[:, -1] for p in flown]
    assert len(flown) == 10
    assert (np.degrees(np.sqrt(np.mean(np.square(errors), axis=0))) < (1.0, 0.3, 1.0)).all()


def test_without_the_moments_between_the_axes_it_moves_less_like_the_log(log, rig):
    def worst(plant):
        found = replay(log, rig, plant, piece=3.0)
        return max(np.abs(log.angles[2, round(p.t[-1] / log.sample_time)] - p.angles[2, -1]) for p in found)

    assert worst(Plant.from_rig(rig, sensors=None)) < 0.3 * worst(
        Plant.from_rig(rig, sensors=None, coupling=Coupling())
    )


def test_a_zero_of_a_sensor_with_the_other_sign_counts_the_other_way(log, rig):
    flown = log.part(0.0, 8.0)
    zeros = rig.sensor_zeros
    turned = replace(rig, sensor_signs=(1, -1, -1), sensor_zeros=(0.0, -0.0, -zeros[2]))
    assert zeros[2] != 0.0
    for mine, same in zip(replay(flown, rig), replay(flown, turned)):
        np.testing.assert_array_equal(same.angles, mine.angles)


def test_pieces_are_airborne_and_cover_the_rest():
    t = np.arange(1001) * 0.01
    elevation = np.where(t < 1.0, 0.5, 0.0)
    flown = FlightLog(t, np.array([t, elevation, t]), np.ones((2, len(t))))
    found = pieces(flown, 4.0)
    assert [n for _, n in found] == [400, 400]
    assert t[found[0][0]] == pytest.approx(1.5, abs=0.02)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [({"piece": 0.1}, "piece = 0.1: must be"), ({"plant": Plant(travel_lift=Uniform(0.0, 0.1))}, "plant: must have")],
)
def test_bad_arguments_are_refused(log, rig, arguments, message):
    with pytest.raises(ValueError, match=message):
        replay(log, rig, **arguments)


def test_the_command_draws_the_replay(log, rig, tmp_path, capsys):
    rig.save(tmp_path / "mine.toml")
    command.main(command.Args("simulated", rig=str(tmp_path / "mine.toml"), out=tmp_path / "a.pdf"))
    assert (tmp_path / "a-replay.pdf").read_bytes().startswith(b"%PDF")
    assert "replay in 6 pieces" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "limits"),
    [({}, (-24.0, 24.0)), ({"rig": "ntnu"}, (-10.0, 10.0)), ({"rig": "ntnu", "u_max": 6.0}, (-10.0, 6.0))],
)
def test_the_command_marks_the_limits_of_the_rigs_amplifier(arguments, limits, tmp_path, monkeypatch):
    class Drawn(Exception):
        pass

    def draw(log, plan, limits):
        raise Drawn(limits)

    monkeypatch.setattr(command.log_figures, "flight_log", draw)
    monkeypatch.setattr(command, "replay", lambda *given, **named: [])
    with pytest.raises(Drawn) as drawn:
        command.run(command.Args(Path("simulated"), out=tmp_path / "a.pdf", **arguments))
    assert drawn.value.args == (limits,)


def test_an_unknown_name_lists_the_packaged_logs():
    with pytest.raises(ValueError, match=r"must be the path of a .csv or .mat file, or one of 'simulated'"):
        find_log("nothing")
