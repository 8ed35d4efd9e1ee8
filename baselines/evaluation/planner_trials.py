"""Trials of planners: one maneuver, one plan, one row of a table; `heli-compare-planners` runs and prints them."""

import importlib.util
import math
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from heli_gym.baselines.evaluation.planner_comparison import (
    effort,
    flights,
    meets_its_limits,
    plan_measures,
    random_maneuver,
    shortest_known,
    time_planner,
)
from heli_gym.baselines.planning.collocation import collocated_trajectory
from heli_gym.baselines.planning.other_solvers import multiple_shooting, plan_by_bvp, plan_by_do_mpc
from heli_gym.baselines.planning.planner import plan, plan_fastest
from heli_gym.parameters import Limits
from heli_gym.rig import PAPER, Rig
from heli_gym.trajectory import Maneuver, Trajectory

DURATIONS = 0.8, 2.0  # range of random durations, times collocation's shortest
LEISURE = 12.0  # s; every method can plan the paper's maneuver in this time
PATIENCE = 60.0  # s, time limit of splines and of collocation for one maneuver with constraints


@cache
def warm_up() -> None:
    """Compile the kernels of this process before a timing."""
    plan(Maneuver(duration=9.0))


def requests(seed: int, rig: Rig) -> Iterator[tuple[Maneuver, float]]:
    """Random maneuvers, endlessly, each with a duration relative to collocation's shortest."""
    rng = np.random.default_rng(seed)
    while True:
        yield random_maneuver(rng, rig), rng.uniform(*DURATIONS)


def plan_request(request: tuple[Maneuver, float]) -> dict[str, Any] | None:
    """Row of a random maneuver, or None if collocation finds no plan at all."""
    maneuver, ratio = request
    warm_up()
    shortest = shortest_known(maneuver)
    if not math.isfinite(shortest):
        return None
    requested = replace(maneuver, duration=ratio * shortest)
    trajectory, seconds = time_planner(plan, requested)
    return {
        "maneuver": str(requested),
        "duration / shortest known": ratio,
        "planned": trajectory is not None,
        "limits kept": trajectory is not None and meets_its_limits(requested, trajectory),
        "seconds": seconds,
    }


def plan_shortest(maneuver: Maneuver) -> dict[str, Any]:
    """Row of a maneuver's shortest duration, by collocation and by the planner."""
    known, smooth = shortest_known(maneuver), shortest_known(maneuver, smooth=True)
    trajectory, seconds = time_planner(plan_fastest, maneuver)
    found = math.inf if trajectory is None else trajectory.duration
    return {
        "maneuver": str(maneuver),
        "collocation": known,
        "collocation, smooth": smooth,
        "spline": found,
        "ratio": found / known,
        "ratio, smooth": found / smooth,
        "limits kept": trajectory is not None and meets_its_limits(replace(maneuver, duration=found), trajectory),
        "seconds": seconds,
    }


def scale_window(rig: Rig, window: tuple[float, float]) -> tuple[float, float]:
    """Scale a voltage window on 0 to 12 V to the range of a rig's amplifier."""
    low, high = rig.voltage_limits
    u_min, u_max = (low + (high - low) / PAPER.voltage_limits[1] * u for u in window)
    return u_min, u_max


def plan_within(task: tuple[Rig, tuple[float, float], int]) -> dict[str, Any]:
    """Row of a voltage window and a pitch limit in degrees."""
    rig, (u_min, u_max), degrees = task
    pitch = math.radians(degrees)
    maneuver = Maneuver(duration=60.0, limits=Limits(u_min, u_max, -pitch, pitch), rig=rig)
    trajectory, _ = time_planner(plan_fastest, maneuver)
    return {
        "u_min": u_min,
        "u_max": u_max,
        "pitch limit": degrees,
        "spline": math.nan if trajectory is None else trajectory.duration,
        "collocation": shortest_known(maneuver),
    }


def fly_method(task: tuple[Rig, str, str, int]) -> dict[str, Any]:
    """Row of a method, "in" ample time or "fastest", and of flights along its plan."""
    rig, name, kind, draws = task
    planner, duration = (plan, LEISURE) if kind == "in" else (plan_fastest, 2.0 * LEISURE)
    maneuver = Maneuver(duration=duration, rig=rig)
    planner(maneuver, name)  # compiles the kernels before the timing
    trajectory, seconds = time_planner(planner, maneuver, name)
    assert trajectory is not None
    rate = np.diff(trajectory.u) / np.diff(trajectory.t)
    return {
        "method": name,
        "wanted duration": f"{LEISURE:g} s" if kind == "in" else kind,
        "duration (s)": trajectory.duration,
        "effort (N² s)": effort(maneuver, trajectory),
        "peak pitch (deg)": float(np.degrees(np.abs(trajectory.x[4]).max())),
        "RMS voltage rate (V/s)": float(np.sqrt((rate**2).mean())),
        "planning (ms)": 1e3 * seconds,
        **flights(trajectory, "lab", draws),
    }


def fly_plan(task: tuple[str, Trajectory, str, int]) -> dict[str, Any]:
    """Row of flights along a plan on a plant."""
    name, trajectory, plant, draws = task
    flown = flights(trajectory, plant, draws)
    return {"reserve": name, "duration (s)": trajectory.duration, "plant": plant, **flown}


def plan_constrained(maneuver: Maneuver) -> dict[str, Any]:
    """Row of a maneuver with path constraints, ends in motion or lead: its shortest durations by both methods."""
    trajectory, seconds = time_planner(plan_fastest, maneuver, "spline", time_limit=PATIENCE)
    known = collocated_trajectory(maneuver, "time", PATIENCE, smooth=True)
    found = math.nan if trajectory is None else trajectory.duration
    waiting = maneuver.rig.delay if maneuver.lead else 0.0  # before the flight, which collocation leaves out
    optimum = math.nan if known is None else known.duration + waiting
    return {
        "rig": maneuver.rig.name,
        "maneuver": str(maneuver),
        "floor": maneuver.floor is not None,
        "lead": maneuver.lead,
        "in motion": (maneuver.start_state is not None) + (maneuver.goal_state is not None),
        "collocation": optimum,
        "spline": found,
        "ratio": found / optimum,
        "seconds": seconds,
    }


def available_solvers() -> dict[str, Callable[[Maneuver], Trajectory | None]]:
    """Solvers of least effort and of the paper's (38), by name; do-mpc where it is installed."""
    solvers: dict[str, Callable[[Maneuver], Trajectory | None]] = {
        "spline, smoothest": lambda maneuver: plan(maneuver, "spline"),
        "spline, least effort": lambda maneuver: plan(maneuver, objective="effort"),
        "spline, most reserve": lambda maneuver: plan(maneuver, objective="reserve"),
        "paper, (38) by shooting": lambda maneuver: plan(maneuver, "paper"),
        "flat": lambda maneuver: plan(maneuver, "flat"),
        "paper, (38) by solve_bvp": plan_by_bvp,
        "collocation, IPOPT": lambda maneuver: plan(maneuver, "collocation"),
        "multiple shooting, IPOPT": lambda maneuver: multiple_shooting(maneuver, "ipopt"),
        "multiple shooting, fatrop": lambda maneuver: multiple_shooting(maneuver, "fatrop"),
    }
    if importlib.util.find_spec("do_mpc") is not None:
        solvers["do-mpc"] = plan_by_do_mpc
    return solvers


def time_solver(name: str, solve: Callable[[Maneuver], Trajectory | None], maneuver: Maneuver) -> dict[str, Any] | None:
    """Row of a solver: computing time and measures of its plan; None without a plan."""
    solve(maneuver)  # compiles the kernels before the timing
    began = time.perf_counter()
    trajectory = solve(maneuver)
    seconds = time.perf_counter() - began
    if trajectory is None:
        return None
    return {"solver": name, "time (ms)": 1e3 * seconds, **plan_measures(maneuver, trajectory)}
