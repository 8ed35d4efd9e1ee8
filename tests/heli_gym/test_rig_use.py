"""Maneuvers and trajectories know their rig."""

import numpy as np
import pytest

from heli_gym import HelicopterParameters, Limits, Maneuver, PowerCurve, Rig, ThrustMap, Trajectory, find_rig
from heli_gym.rig import PAPER, rig_of
from heli_gym.trajectory import concatenate

NTNU = find_rig("ntnu")


def still(rig: Rig, duration: float = 1.0) -> Trajectory:
    u = np.repeat(rig.hover_voltage()[:, None], 2, axis=1)
    return Trajectory(np.array([0.0, duration]), np.zeros((6, 2)), u, rig.limits, rig)


def test_a_maneuver_flies_the_papers_rig_by_default():
    assert Maneuver().rig == PAPER
    assert Maneuver(parameters=HelicopterParameters()).rig == PAPER
    assert Maneuver().limits == Limits()


def test_a_maneuver_takes_coefficients_and_limits_from_its_rig():
    maneuver = Maneuver(rig="ntnu")
    assert (maneuver.rig, maneuver.parameters, maneuver.limits) == (NTNU, NTNU.parameters, NTNU.limits)


def test_parameters_stand_for_the_papers_rig_with_these():
    heavier = HelicopterParameters(a2=0.45)
    assert Maneuver(parameters=heavier).rig == rig_of(heavier)
    assert rig_of(heavier).thrust_map == PAPER.thrust_map


def test_parameters_and_a_rig_must_not_contradict_each_other():
    assert Maneuver(parameters=NTNU.parameters, rig=NTNU).rig == NTNU
    with pytest.raises(ValueError, match=r"parameters = .*must be those of the rig 'ntnu'"):
        Maneuver(parameters=HelicopterParameters(a2=0.45), rig=NTNU)


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        (Limits(0.0, 13.0), "must be within the 0 to 12 V of the rig 'paper'"),
        (Limits(1.0, 11.0, -1.5, 1.5), "must be within the pitch limit of the rig 'paper', 80 deg"),
    ],
)
def test_limits_must_be_within_the_rigs(limits, message):
    with pytest.raises(ValueError, match=message):
        Maneuver(limits=limits, rig="paper")


def test_hover_of_unequal_rotors_is_named_with_both_voltages():
    rig = Rig("mixed", thrust_map=ThrustMap(PowerCurve(0.1, -0.1, 1.0), PowerCurve(0.05, -0.05, 1.0)))
    with pytest.raises(ValueError, match=r"takes 3\.02 and 6\.05 V, and the limits are 4 to 11 V"):
        Maneuver(rig=rig, limits=Limits(4.0, 11.0))


def test_a_file_carries_the_rig(tmp_path):
    still(NTNU).save(tmp_path / "plan.npz")
    assert Trajectory.load(tmp_path / "plan.npz").rig == NTNU
    assert Trajectory.load(tmp_path / "plan.npz", rig="ntnu").rig == NTNU


def test_a_file_for_another_rig_is_refused_and_differences_are_named(tmp_path):
    still(NTNU).save(tmp_path / "plan.npz")
    with pytest.raises(
        ValueError, match=r"plan\.npz' is for the rig 'ntnu', .* 'paper': a1 0 and -1.1713; .*thrust map"
    ):
        Trajectory.load(tmp_path / "plan.npz", rig="paper")


def test_a_file_from_before_is_the_papers(tmp_path):
    plan = still(PAPER)
    limits = np.array([*plan.limits.u, *plan.limits.pitch])
    np.savez(tmp_path / "old.npz", t=plan.t, x=plan.x, u=plan.u, limits=limits)
    assert Trajectory.load(tmp_path / "old.npz").rig == PAPER


def test_a_damaged_rig_is_no_trajectory(tmp_path):
    plan = still(PAPER)
    limits = np.array([*plan.limits.u, *plan.limits.pitch])
    np.savez(tmp_path / "bad.npz", t=plan.t, x=plan.x, u=plan.u, limits=limits, rig=np.array("name = 3"))
    with pytest.raises(ValueError, match=r"bad\.npz' holds no trajectory"):
        Trajectory.load(tmp_path / "bad.npz")


def test_trajectories_of_different_rigs_are_not_joined():
    with pytest.raises(ValueError, match="second"):
        concatenate(still(PAPER), still(NTNU))
