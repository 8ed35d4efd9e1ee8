"""What several tests share: the two plans of the paper, solved once."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads only slow 6x6 matrices down

import pytest
from hypothesis import settings

from heli_gym import Maneuver, Trajectory
from heli_gym.baselines.planning.planner import plan, plan_unconstrained

settings.register_profile("heli", deadline=None, derandomize=True, database=None, max_examples=50)
settings.load_profile("heli")


@pytest.fixture(scope="session")
def paper_plan() -> Trajectory:
    """The constrained plan of Section III-D, Fig. 8."""
    return plan(Maneuver())


@pytest.fixture(scope="session")
def unconstrained_plan() -> Trajectory:
    """The plan of Section III-B, Fig. 4."""
    return plan_unconstrained(Maneuver())
