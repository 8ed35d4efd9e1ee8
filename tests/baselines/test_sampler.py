"""Random maneuvers: feasible, reproducible by seed, plain values."""

import math
import pickle

import numpy as np
import pytest
from independent import replay
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import Limits
from heli_gym.baselines import InfeasibleManeuver, ManeuverSampler
from heli_gym.baselines.planning import sampler as sampler_module

SAMPLER = ManeuverSampler(duration=10.0)


@pytest.mark.parametrize("seed", range(5))
def test_a_draw_arrives_within_its_limits_and_in_its_duration(seed):
    trajectory = SAMPLER(np.random.default_rng(seed))
    flown = replay(trajectory)
    assert trajectory.duration == 10.0
    assert_allclose(flown[:, -1], trajectory.x[:, -1], atol=1e-3)
    assert_array_equal(trajectory.x[[1, 3, 4, 5], -1], 0.0)
    assert abs(trajectory.x[0, -1]) <= 2.0 * math.pi
    assert np.abs(trajectory.x[2, [0, -1]]).max() <= math.radians(8.0)
    assert SAMPLER.limits.u_min <= trajectory.u.min() <= trajectory.u.max() <= SAMPLER.limits.u_max
    assert np.abs(flown[4]).max() <= SAMPLER.limits.pitch_max + 1e-6
    assert trajectory.limits == SAMPLER.limits


def test_the_same_seed_draws_the_same_plan_in_another_process_too():
    copy = pickle.loads(pickle.dumps(SAMPLER))
    assert copy == SAMPLER
    first, again = (sampler(np.random.default_rng(7)) for sampler in (SAMPLER, copy))
    assert_array_equal(first.u, again.u)
    assert_array_equal(first.x, again.x)


def test_draws_differ():
    rng = np.random.default_rng(0)
    goals = {tuple(SAMPLER(rng).x[[0, 2], -1]) for _ in range(5)}
    assert len(goals) == 5


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"travel": (1.0, 0.0)}, "travel = "),
        ({"travel": (0.0, math.inf)}, "travel = "),
        ({"elevation": (-0.1, math.nan)}, "elevation = "),
        ({"elevation": (-1.2, 0.0)}, "hover"),
        ({"duration": 0.0}, "duration = 0.0"),
    ],
    ids=str,
)
def test_invalid_ranges_are_named(arguments, said):
    with pytest.raises(ValueError, match=said):
        ManeuverSampler(**arguments)


def test_where_hardly_anything_can_be_planned_it_says_so(monkeypatch):
    monkeypatch.setattr("heli_gym.baselines.planning.sampler.DRAWS", 3)
    hasty = ManeuverSampler(duration=2.0, travel=(3.0, 6.0), limits=Limits())
    with pytest.raises(InfeasibleManeuver, match=r"none of 3 draws .* longer duration"):
        hasty(np.random.default_rng(0))


def test_draws_that_cannot_meet_their_path_limits_are_not_planned(monkeypatch):
    limits = Limits(elevation_min=-0.02, travel_rate=0.4)
    sampler, drawn = ManeuverSampler(10.0, (0.0, 6.0), (-0.05, 0.05), limits), []
    found = [sampler(np.random.default_rng(seed)) for seed in range(4)]
    monkeypatch.setattr(sampler_module, "exceeds_path_limits", lambda maneuver: drawn.append(maneuver))
    for seed, plan in enumerate(found):
        assert_array_equal(sampler(np.random.default_rng(seed)).x, plan.x)
    assert len(drawn) > 2 * len(found)
