"""Safety filter: pitch stays within the stop for any policy, and voltages are unchanged far from it."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.control.protocol import MemorylessPolicy
from heli_gym.baselines.control.safety import safety_filter
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.model import virtual_input
from heli_gym.plant import Plant, Rotors
from heli_gym.rig import PAPER, find_rig

REFERENCE = find_reference("travel-360")
LAGGING = Plant(rotors=Rotors(lag=0.1, delay=0.02))


class Reckless(MemorylessPolicy):
    """All power on one side, the other side after a while."""

    def __init__(self, side):
        self.side = side

    def __call__(self, t, measurement):
        u = np.array([12.0, 0.0]) if (t < 1.5) == self.side else np.array([0.0, 12.0])
        return u[:, None] + np.zeros(measurement.shape[1:]) if measurement.ndim > 1 else u


@pytest.mark.parametrize("plant", [LAGGING, "lab", "rigid", "nominal"])
@pytest.mark.parametrize("side", [True, False])
def test_a_reckless_policy_crashes_at_once_alone_and_not_behind_the_filter(plant, side):
    env = Heli3DOFEnv(plant)
    assert fly(env, Reckless(side), seed=1).duration < 1.5
    safe = fly(env, safety_filter(Reckless(side), REFERENCE, 0.02, PAPER), seed=1)
    assert safe.duration == pytest.approx(10.0)
    assert np.degrees(np.abs(safe.x[4]).max()) > 55.0  # no more careful than it must be


@pytest.mark.parametrize("name", ["feedforward+tvlqr", "kalman-lqr"])
def test_far_from_the_stop_the_policy_flies_bit_for_bit(name):
    env = Heli3DOFEnv()
    plain, safe = (fly(env, make_policy(one, REFERENCE), seed=0) for one in (name, f"{name}+safe"))
    assert_array_equal(safe.u, plain.u)


def test_the_filter_broadcasts():
    policy = make_policy("kalman-lqr+safe", REFERENCE)
    x = REFERENCE(np.zeros(4))[0]
    x[4:] += np.outer([1.0, 2.0], [0.0, 0.5, 1.0, -1.0])
    together = policy(0.0, x)
    for i in range(4):
        policy.reset(np.random.default_rng(0))
        np.testing.assert_allclose(policy(0.0, x[:, i]), together[:, i], rtol=1e-12)


@pytest.mark.parametrize("name", ["lag-lqr", "kalman-lqr", "adaptive-lqr", "l1-adaptive"])
def test_on_a_rig_without_a_whole_period_of_delay_too_the_policy_flies_bit_for_bit(name):
    rig = replace(PAPER, delay=0.002)
    reference = replace(find_reference("climb-7.5"), rig=rig)
    env = Heli3DOFEnv(reference=reference, rig=rig)
    plain, safe = (fly(env, make_policy(one, reference), seed=0) for one in (name, f"{name}+safe"))
    assert_array_equal(safe.u, plain.u)


def test_fans_that_reverse_leave_the_thrust_sum_as_it_was():
    rig = find_rig("ntnu")
    policy = make_policy("zero+safe", replace(REFERENCE, rig=rig))
    x = np.array([0.0, 0.0, 0.0, 0.0, 0.9 * rig.pitch_limit, 0.5])
    wanted = np.array([9.0, -9.0])
    u = policy.filter_voltages(x, np.full(2, 5.0), wanted)
    assert (np.abs(u) <= 10.0).all()
    sums, differences = zip(*(virtual_input(rig.thrust(one)) for one in (wanted, u)))
    assert differences[1] < differences[0] - 0.1
    assert sums[1] == pytest.approx(sums[0], abs=1e-9)
