"""Collocation of the package against that of the tests; the message without CasADi."""

import math
import subprocess
import sys

import numpy as np
import pytest
from independent import shortest_time

from heli_gym import Maneuver, thrust
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest
from heli_gym.baselines.planning import planner
from heli_gym.baselines.planning.collocation import collocate


@pytest.mark.parametrize("requested", [Maneuver(), Maneuver(goal=(-2.0, 0.2))], ids=str)
def test_least_time_is_that_of_another_transcription(requested):
    assert collocate(requested, "time").t[-1] == pytest.approx(
        shortest_time(requested, plan(requested), intervals=100), rel=2e-3
    )


def test_the_fastest_plan_does_not_depend_on_the_duration_that_is_allowed(monkeypatch):
    guesses = []

    def failing(maneuver, *_):
        guesses.append(maneuver.duration)

    monkeypatch.setattr(planner, "collocated_trajectory", failing)
    for duration in (6.0, 600.0):
        with pytest.raises(InfeasibleManeuver):
            plan_fastest(Maneuver(duration=duration), "collocation")
    assert guesses[: len(guesses) // 2] == guesses[len(guesses) // 2 :]


def test_least_effort_takes_less_than_other_plans():
    def effort(trajectory):
        f = thrust(trajectory.u)
        return np.trapezoid(((f - f[:, :1]) ** 2).sum(axis=0), trajectory.t)

    least, *others = (effort(plan(Maneuver(duration=12.0), method)) for method in ("collocation", "spline", "flat"))
    # hover at the end is what effort is measured from, and where all others start
    f = thrust(plan(Maneuver(duration=12.0), "collocation").u)
    hover = 0.5 * 0.3946 / 0.6523
    least = np.trapezoid(((f - hover) ** 2).sum(axis=0), np.linspace(0.0, 12.0, f.shape[1]))
    assert least < min(others)


def test_impossible_maneuvers_have_no_plan():
    assert collocate(Maneuver(duration=8.0), "time") is None
    assert collocate(Maneuver(duration=8.0), "effort") is None


def test_an_unknown_objective_is_named():
    with pytest.raises(ValueError, match="objective = 'fuel': must be one of time, effort"):
        collocate(Maneuver(), "fuel")


def test_without_casadi_the_message_names_the_extra_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "casadi", None)
    with pytest.raises(ImportError, match=r"heli-gym\[ocp\]"):
        plan(Maneuver(), "collocation")


def test_importing_the_baselines_loads_neither_casadi_nor_compiled_kernels():
    heavy = {"casadi", "heli_gym.baselines.planning.spline_kernel"}
    code = f"import sys, heli_gym.baselines; print(sorted({heavy} & set(sys.modules)))"
    child = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (child.stdout.strip(), child.stderr) == ("[]", "")


def test_a_time_limit_is_passed_on():
    assert collocate(Maneuver(), "effort", time_limit=1e-9) is None
    assert math.isfinite(collocate(Maneuver(), "effort").t[-1])
