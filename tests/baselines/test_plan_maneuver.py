"""`heli-plan`: plans and figures of maneuvers."""

import math
import os
import re
import subprocess
import sys
from dataclasses import fields, replace

import numpy as np
import pytest

from heli_gym import Limits, Maneuver, Trajectory, find_rig
from heli_gym.baselines import plan
from heli_gym.baselines.commands import plan_maneuver
from heli_gym.baselines.commands.plan_maneuver import Args


def test_the_file_is_the_plan_of_the_maneuver_and_its_picture_is_beside_it(tmp_path, capsys):
    out = tmp_path / "plans" / "quarter.npz"
    plan_maneuver.main(
        Args(
            90.0, -5.0, 7.0, start_travel_deg=-10.0, start_elevation_deg=3.0, pitch_limit_deg=40.0, u_max=10.5, out=out
        )
    )
    rad = math.radians
    expected = plan(
        Maneuver((rad(-10.0), rad(3.0)), (rad(90.0), rad(-5.0)), 7.0, Limits(1.0, 10.5, -rad(40.0), rad(40.0)))
    )
    saved = Trajectory.load(out)
    for name in ("t", "x", "u"):
        np.testing.assert_array_equal(getattr(saved, name), getattr(expected, name))
    assert saved.limits == expected.limits
    assert sorted(os.listdir(out.parent)) == ["quarter.npz", "quarter.png"]
    assert out.with_suffix(".png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
    printed = " ".join(capsys.readouterr().out.split())
    assert "travel -10 to 90 deg, elevation 3 to -5 deg in 7 s within 1 to 10.5 V and -40 to 40 deg" in printed


def test_the_limits_of_a_rig_file_hold_unless_an_option_replaces_them(tmp_path):
    own = replace(find_rig("paper"), limits=Limits(elevation_max=0.1, travel_rate=1.2, slew=20.0))
    own.save(tmp_path / "mine.toml")
    mine = {"rig": str(tmp_path / "mine.toml")}
    assert plan_maneuver.requested_maneuver(Args(**mine)).limits == own.limits
    changed = plan_maneuver.requested_maneuver(Args(**mine, u_max=10.0, slew=9.0)).limits
    assert changed == replace(own.limits, u_max=10.0, slew=9.0)


def test_a_plan_without_the_requested_objective_is_announced_in_one_line(tmp_path, capsys):
    out = tmp_path / "plan.npz"
    plan_maneuver.main(Args(duration=8.31, method="spline", objective="effort", figure=False, out=out))
    said = capsys.readouterr().err
    assert said.startswith("heli-plan: objective = 'effort': no plan found for travel 0 to 360")
    assert said.count("\n") == 1 and out.is_file()


def test_the_defaults_are_the_papers_maneuver(tmp_path, paper_plan):
    assert plan_maneuver.requested_maneuver(Args()) == Maneuver()
    plan_maneuver.main(Args(out=tmp_path / "plan.npz", figure=False))
    saved = Trajectory.load(tmp_path / "plan.npz")
    for name in ("t", "x", "u"):
        np.testing.assert_array_equal(getattr(saved, name), getattr(paper_plan, name))
    assert os.listdir(tmp_path) == ["plan.npz"]  # no picture unasked


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"duration": 0.0}, r"duration = 0\.0"),
        ({"duration": -3.0}, r"duration = -3\.0"),
        ({"duration": math.nan}, "duration = nan"),
        ({"travel_deg": math.nan}, "travel_deg = nan: .*degrees"),
        ({"start_travel_deg": math.inf}, "start_travel_deg = inf: .*degrees"),
        ({"elevation_deg": 80.0}, r"elevation_deg = 80\.0: hover .* takes .* V .* limits are 1 to 11 V"),
        ({"start_elevation_deg": -60.0}, r"start_elevation_deg = -60\.0: hover .* takes"),
        ({"u_min": 12.0}, "u_min = 12 V and u_max = 11 V"),
        ({"u_max": math.nan}, "u_max = nan"),
        ({"pitch_limit_deg": 0.0}, r"pitch_limit_deg = 0\.0: .*90 degrees"),
        ({"pitch_limit_deg": 90.0}, r"pitch_limit_deg = 90\.0: .*90 degrees"),
        ({"pitch_limit_deg": -50.0}, r"pitch_limit_deg = -50\.0: .*90 degrees"),
        ({"method": "magic"}, "method = 'magic'"),
        ({"method": "magic", "fastest": True}, "method = 'magic'"),
        ({"reserve": 0.1}, r"reserve = 0\.1: only the fastest plan"),
        ({"fastest": True, "reserve": 1.0}, r"reserve = 1\.0"),
        ({"fastest": True, "objective": "effort"}, "objective = 'effort': must be left out with --fastest"),
        ({"time_limit": 0.0}, r"time_limit = 0\.0"),
    ],
    ids=str,
)
def test_bad_input_is_refused_with_a_message_that_names_it_and_nothing_is_written(
    tmp_path, monkeypatch, arguments, said
):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit, match="heli-plan: .*" + said):
        plan_maneuver.main(Args(**arguments))
    assert os.listdir(tmp_path) == []


def test_an_infeasible_maneuver_is_refused_with_a_feasible_alternative(tmp_path):
    with pytest.raises(SystemExit) as refusal:
        plan_maneuver.main(Args(0.0, -10.0, 1.0, out=tmp_path / "plan.npz"))
    said = re.search(r"heli-plan: no plan for .* in 1 s .* the shortest found takes ([\d.]+) s", str(refusal.value))
    assert 1.0 < float(said[1]) < 2.0
    assert os.listdir(tmp_path) == []


def test_the_fastest_plan_is_faster_and_leaves_its_reserve(tmp_path, capsys):
    out = tmp_path / "fastest.npz"
    plan_maneuver.main(Args(fastest=True, reserve=0.2, figure=False, out=out))
    saved = Trajectory.load(out)
    assert 8.4 < saved.duration < 10.0
    assert saved.limits == Limits()
    assert 2.0 - 1e-6 <= saved.u.min() <= saved.u.max() <= 10.0 + 1e-6
    assert f"{saved.duration:.3f} s" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["plan.txt", "plan"])
def test_an_out_that_is_no_npz_file_is_refused_before_anything_is_planned(tmp_path, monkeypatch, name):
    monkeypatch.setattr(plan_maneuver, "plan", lambda *args: pytest.fail("planned"))
    with pytest.raises(SystemExit, match=f"heli-plan: .*{name}.*npz"):
        plan_maneuver.main(Args(10.0, duration=6.0, out=tmp_path / name))
    assert os.listdir(tmp_path) == []


def test_an_out_below_a_file_is_refused_with_a_message_that_names_it(tmp_path):
    (tmp_path / "file").write_text("precious")
    with pytest.raises(SystemExit, match=r"heli-plan: .*file"):
        plan_maneuver.main(Args(10.0, duration=6.0, out=tmp_path / "file" / "plan.npz"))
    assert (tmp_path / "file").read_text() == "precious"


def test_arguments_are_read_from_the_command_line(monkeypatch, tmp_path):
    out = tmp_path / "plan.npz"
    monkeypatch.setattr(
        sys, "argv", ["heli-plan", "--travel-deg", "20", "--duration", "6", "--out", str(out), "--no-figure"]
    )
    plan_maneuver.main()
    saved = Trajectory.load(out)
    assert saved.duration == 6.0
    assert saved.x[0, -1] == pytest.approx(math.radians(20.0))


def test_help_names_every_argument():
    child = subprocess.run(
        [sys.executable, "-m", "heli_gym.baselines.commands.plan_maneuver", "--help"], capture_output=True, text=True
    )
    assert (child.returncode, child.stderr) == (0, "")
    for argument in fields(Args):
        assert f"--{argument.name.replace('_', '-')}" in child.stdout


def test_the_limits_on_the_way_are_those_of_the_plan(tmp_path):
    (tmp_path / "floor.csv").write_text("travel_deg,elevation_deg\n-360,5\n80,5\n120,-4\n160,5\n720,5\n")
    args = Args(
        travel_deg=180.0, duration=9.0, travel_rate_deg=50.0, floor=tmp_path / "floor.csv", out=tmp_path / "p.npz"
    )
    plan_maneuver.run(args)
    flown = Trajectory.load(args.out)
    assert np.degrees(np.abs(flown.x[1]).max()) <= 50.0 + 1e-3
    floor_deg = np.interp(np.degrees(flown.x[0]), [-360, 80, 120, 160, 720], [5, 5, -4, 5, 5])
    assert (np.degrees(flown.x[2]) <= floor_deg + 1e-3).all()  # elevation is positive downwards


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"travel_deg": 1e300}, "travel_deg"),
        ({"travel_rate_deg": 0.0}, "travel_rate_deg"),
        ({"elevation_min_deg": np.nan}, "elevation_min_deg"),
        ({"slew": -1.0}, "slew"),
    ],
)
def test_limits_that_make_no_sense_are_refused_by_name(changes, named, tmp_path):
    with pytest.raises(ValueError, match=f"^{named} = "):
        plan_maneuver.requested_maneuver(Args(**changes))


def test_a_floor_without_its_columns_is_refused(tmp_path):
    (tmp_path / "floor.csv").write_text("a,b\n1,2\n")
    with pytest.raises(ValueError, match=r"^floor = .*travel_deg and elevation_deg"):
        plan_maneuver.requested_maneuver(Args(floor=tmp_path / "floor.csv"))


def test_via_points_and_lead_are_those_of_the_plan(tmp_path):
    (tmp_path / "via.csv").write_text("time,travel_deg,elevation_deg\n4,90,-3\n,120,2\n")
    requested = plan_maneuver.requested_maneuver(Args(via=tmp_path / "via.csv", lead=True))
    rad = math.radians
    assert requested.via == ((4.0, rad(90.0), rad(-3.0)), (None, rad(120.0), rad(2.0)))
    assert requested.lead
    (tmp_path / "via.csv").write_text("a\n1\n")
    with pytest.raises(ValueError, match=r"^via = .*time, travel_deg and elevation_deg"):
        plan_maneuver.requested_maneuver(Args(via=tmp_path / "via.csv"))
