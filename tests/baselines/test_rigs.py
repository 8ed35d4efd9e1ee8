"""Planners, gains and policies on rigs other than the paper's."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from rich.console import Console
from scipy.integrate import solve_ivp

from heli_gym import Limits, Maneuver, PowerCurve, Rig, TableCurve, ThrustMap, Trajectory, dynamics, find_rig
from heli_gym.baselines import ManeuverSampler, make_policy, plan, riccati_gains
from heli_gym.baselines import evaluate as score
from heli_gym.baselines.commands import evaluate, plan_maneuver
from heli_gym.cli import CommandError
from heli_gym.model import virtual_input
from heli_gym.rig import PAPER

MIXED = Rig(
    "mixed",
    thrust_map=ThrustMap(
        PowerCurve(0.03, -0.01, 1.2, 0.5),
        TableCurve((0.0, 2.0, 5.0, 8.0, 12.0), (0.0, 0.05, 0.2, 0.4, 0.65)),
    ),
)


@pytest.mark.parametrize("rig", [find_rig("quanser"), find_rig("ntnu"), MIXED], ids=str)
@pytest.mark.parametrize("method", ["paper", "spline", "flat"])
def test_a_plan_flown_through_the_rigs_thrust_map_and_3_arrives_within_its_limits(rig, method):
    maneuver = Maneuver(goal=(math.pi / 2, math.radians(-5.0)), duration=8.0, rig=rig)
    trajectory = plan(maneuver, method)
    assert trajectory.rig == rig
    low, high = maneuver.limits.u
    assert low - 1e-6 <= trajectory.u.min() and trajectory.u.max() <= high + 1e-6

    def rhs(t, x):
        return dynamics(x, virtual_input(rig.thrust(trajectory(t)[1])), rig.parameters)

    end = solve_ivp(rhs, (0.0, trajectory.duration), trajectory.x[:, 0], max_step=0.02, rtol=1e-8).y[:, -1]
    assert_allclose(end, trajectory.x[:, -1], atol=2e-3)


@pytest.mark.parametrize("name", ["feedforward+tvlqr", "lqi", "lag-lqr", "kalman-lqr"])
def test_on_the_plan_the_feedback_adds_nothing_and_off_it_the_fans_say_so(name):
    rig = find_rig("ntnu")
    reference = plan(Maneuver(goal=(math.pi / 2, 0.0), duration=8.0, rig=rig))
    policy = make_policy(name, reference)
    if name != "feedforward+tvlqr":  # which has no use for them
        assert policy.voltage_limits == rig.voltage_limits
    u = policy(0.0, reference.x[:, 0])
    assert_allclose(u, rig.hover_voltage(), atol=0.2)
    policy.reset(np.random.default_rng(0))
    lower = reference.x[:, 0] + np.array([0.0, 0.0, 0.1, 0.0, 0.0, 0.0])  # positive is down
    assert (policy(0.0, lower) > u + 0.5).all()


def test_gains_are_those_of_the_references_rig_by_default():
    rig = find_rig("ntnu")
    reference = plan(Maneuver(goal=(math.pi / 2, 0.0), duration=8.0, rig=rig))
    assert_allclose(riccati_gains(reference).K, riccati_gains(reference, rig).K)
    assert_allclose(riccati_gains(reference).K, riccati_gains(reference, rig.parameters).K)
    assert np.abs(riccati_gains(reference, PAPER).K - riccati_gains(reference).K).max() > 0.1


@pytest.mark.parametrize("name", ["residual", "lqi@lab", "kalman-lqr@rigid"])
def test_policies_learned_or_tuned_on_the_papers_rig_are_refused_for_another(name):
    reference = plan(Maneuver(goal=(math.pi / 2, 0.0), duration=8.0, rig="ntnu"))
    with pytest.raises(ValueError, match="is for the rig 'paper', and the one that flies is 'ntnu'"):
        make_policy(name, reference)


def test_a_rig_and_parameters_are_not_given_together():
    reference = plan(Maneuver())
    with pytest.raises(ValueError, match="must not be given together with a rig"):
        make_policy("lqi", reference, parameters=PAPER.parameters, rig="paper")


def test_middle_voltage_is_the_middle_of_the_rigs_amplifier():
    reference = plan(Maneuver(goal=(math.pi / 2, 0.0), duration=8.0, rig="quanser"))
    assert_allclose(make_policy("middle-voltage", reference)(0.0, np.zeros(6)), 0.0)
    assert_allclose(make_policy("middle-voltage", reference, voltage_limits=(0.0, 10.0))(0.0, np.zeros(6)), 5.0)


def test_a_plan_within_tighter_limits_meets_them():
    maneuver = Maneuver(goal=(math.pi, 0.0), duration=10.0, rig="ntnu", limits=Limits(1.0, 6.0, -0.6, 0.6))
    trajectory = plan(maneuver)
    assert trajectory.u.min() >= 1.0 - 1e-6 and trajectory.u.max() <= 6.0 + 1e-6
    assert np.abs(trajectory.x[4]).max() <= 0.6 + 1e-6


def test_a_sampler_draws_plans_for_its_rig():
    rig = find_rig("ntnu")
    sampler = ManeuverSampler(duration=10.0, travel=(-1.0, 1.0), limits=rig.limits, rig=rig)
    trajectory = sampler(np.random.default_rng(0))
    assert trajectory.rig == rig


def test_the_commands_plan_for_a_rig_and_refuse_its_plan_on_another(tmp_path, capsys):
    path = tmp_path / "plan.npz"
    plan_maneuver.main(plan_maneuver.Args(rig="ntnu", travel_deg=90.0, duration=8.0, out=path, figure=False))
    assert Trajectory.load(path).rig == find_rig("ntnu")
    settings = {"policies": ("open-loop",), "reference": str(path), "episodes": 1, "figures": False}
    with pytest.raises(CommandError) as raised:
        evaluate.main(evaluate.Args(**settings, out=tmp_path / "out"))
    assert raised.value.code == 2
    assert "is for the rig 'ntnu'" in capsys.readouterr().err
    evaluate.main(evaluate.Args(**settings, rig="ntnu", out=tmp_path / "out"))
    assert "of the rig ntnu" in capsys.readouterr().out
    evaluate.main(evaluate.Args(**settings, force=True, out=tmp_path / "forced"))


def test_commands_fly_the_fleet_on_its_own_rig_unless_another_is_named(tmp_path):
    settings = {"policies": ("open-loop",), "plant": "fleet", "reference": "climb-7.5", "episodes": 2}
    settings |= {"figures": False, "seed": 5}
    args = evaluate.Args(**settings, out=tmp_path / "out")
    flights = evaluate.evaluate(args, Console(quiet=True))
    alone = score("open-loop", "fleet", 2, "climb-7.5", seed=5)
    assert [f.metrics.rms_error_deg[0] for f in flights] == pytest.approx(alone.column("rms_travel_deg"), rel=1e-6)


def test_limits_of_a_rig_bound_the_plans(tmp_path, capsys):
    with pytest.raises(CommandError):
        plan_maneuver.main(plan_maneuver.Args(rig="paper", u_max=13.0, out=tmp_path / "p.npz"))
    assert "must be within the 0 to 12 V of the rig 'paper'" in capsys.readouterr().err
