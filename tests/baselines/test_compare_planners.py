"""The comparison draws its ranges, detects violated limits, and writes its results."""

import csv
import math
from dataclasses import replace

import numpy as np
import pytest
from rich.console import Console

from heli_gym import Limits, Maneuver
from heli_gym.baselines import plan
from heli_gym.baselines.commands import compare_planners
from heli_gym.baselines.commands.compare_planners import Args
from heli_gym.baselines.evaluation.engine import open_engine
from heli_gym.baselines.evaluation.planner_comparison import meets_its_limits, random_maneuver


@pytest.mark.parametrize("seed", range(10))
def test_random_maneuvers_are_within_the_ranges_of_the_comparison(seed):
    drawn = random_maneuver(np.random.default_rng(seed))
    assert abs(drawn.goal[0] - drawn.start[0]) <= math.radians(720.0)
    assert 0.0 <= drawn.limits.u_min < drawn.limits.u_max <= 12.0
    assert math.radians(10.0) <= drawn.limits.pitch_max <= math.radians(80.0)
    assert drawn.limits.pitch_min == -drawn.limits.pitch_max


def test_violated_limits_of_a_plan_are_detected():
    requested = Maneuver()
    good = plan(requested)
    assert meets_its_limits(requested, good)
    assert not meets_its_limits(replace(requested, duration=11.0), good)
    assert not meets_its_limits(replace(requested, goal=(6.0, 0.0)), good)
    assert not meets_its_limits(replace(requested, limits=Limits(u_max=10.9)), good)
    assert not meets_its_limits(replace(requested, limits=Limits(pitch_max=0.8)), good)
    assert not meets_its_limits(requested, replace(good, u=0.99 * good.u))


def test_results_are_written_and_printed(tmp_path):
    console = Console(record=True, width=200)
    args = Args(maneuvers=1, fastest=1, out=tmp_path)
    with open_engine() as engine:
        compare_planners.robustness(args, console, engine)
        compare_planners.shortest(args, console, engine)
    with open(tmp_path / "robustness.csv") as file:
        rows = list(csv.DictReader(file))
    spare = [row for row in rows if float(row["duration / shortest known"]) >= 1.1]
    assert [(row["planned"], row["limits kept"]) for row in spare] == [("True", "True")]
    with open(tmp_path / "shortest.csv") as file:
        ratios = [float(row["ratio"]) for row in csv.DictReader(file)]
    assert len(ratios) == 2
    assert 1.0 < min(ratios) <= max(ratios) < 1.05
    assert "with 10 % to spare" in console.export_text()


@pytest.mark.slow
def test_several_processes_write_the_rows_of_one(tmp_path):
    found = []
    for workers in (1, 2):
        args = Args(("robustness", "reserve"), maneuvers=3, draws=2, workers=workers, out=tmp_path / str(workers))
        compare_planners.run(args)
        rows = []
        for part in args.parts:
            with open(args.out / f"{part}.csv") as file:
                rows += [{**row, "seconds": ""} for row in csv.DictReader(file)]
        found.append(rows)
    assert found[0] == found[1]
