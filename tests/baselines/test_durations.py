"""Durations from a tenth to a hundred times the paper's, and many turns, by every method: plans, or true refusals."""

import math
import time

import numpy as np
import pytest
from independent import replay

from heli_gym import Maneuver
from heli_gym.baselines import InfeasibleManeuver, plan
from heli_gym.baselines.planning.planner import METHODS

RATIOS = 0.1, 0.5, 0.8, 2.0, 10.0, 100.0
TIME_LIMIT = 120.0  # s; on a busy machine


@pytest.mark.slow
@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("method", METHODS)
def test_every_duration_is_planned_or_refused_with_a_longer_one(method, ratio):
    requested = Maneuver(duration=10.0 * ratio)
    began = time.process_time()
    try:
        trajectory = plan(requested, method, time_limit=TIME_LIMIT)
    except InfeasibleManeuver as refusal:
        assert "any other time" not in str(refusal)
        if refusal.shortest_duration is None:  # the time limit, or a method that states why its plan failed
            assert "time limit" in str(refusal) or "replayed" in str(refusal) or "no plan found" in str(refusal)
        else:
            assert refusal.shortest_duration > requested.duration
    else:
        assert trajectory.duration == requested.duration
        assert len(trajectory.t) <= 200_001
        assert np.abs(trajectory.x[:, -1] - requested.ends[1]).max() < 1e-9
        if ratio <= 10.0:
            assert np.abs(replay(trajectory)[:, -1] - requested.ends[1]).max() < 1e-3
    assert time.process_time() - began < 2.0 * TIME_LIMIT


@pytest.mark.slow
@pytest.mark.parametrize("turns", [50, 200])
def test_many_turns_are_planned(turns):
    requested = Maneuver(goal=(2.0 * math.pi * turns, 0.0), duration=12.0 * math.sqrt(turns) + 4.0 * turns)
    trajectory = plan(requested, time_limit=TIME_LIMIT)
    assert np.abs(replay(trajectory)[:, -1] - requested.ends[1]).max() < 1e-3 * turns
