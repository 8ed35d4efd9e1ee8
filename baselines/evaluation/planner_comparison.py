"""Random maneuvers for comparisons of planners, and measures of the plans.

Scipy flies the plans, independently of the planners' own replay in `planning.feasibility`.
"""

import math
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import gymnasium as gym
import numpy as np
from scipy.integrate import solve_ivp
from scipy.stats import binomtest

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.baselines.evaluation.rollout import fly
from heli_gym.baselines.planning.collocation import collocate
from heli_gym.baselines.planning.feasibility import ARRIVAL_TOLERANCE, LIMIT_TOLERANCE, InfeasibleManeuver
from heli_gym.baselines.planning.path import check_ends
from heli_gym.baselines.planning.spline_search import easy_duration
from heli_gym.model import dynamics, hover_input, virtual_input
from heli_gym.parameters import Limits
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.rig import PAPER, Rig
from heli_gym.trajectory import Maneuver, Trajectory

HOVER_MARGIN = 0.05  # least distance of hover from both ends of the thrust window, as a share of it
START_SPREAD_DEG = 5.0


def random_maneuver(rng: np.random.Generator, rig: Rig = PAPER) -> Maneuver:
    """Draw a maneuver: travel up to 720°, pitch limits of 10° to 80°, voltage windows and feasible elevations.

    The voltage windows include hover; for the paper's rig they begin at 0 to 4 V and end at 9 to 12 V.
    """
    parameters = rig.parameters
    pitch = min(math.radians(rng.uniform(10.0, 80.0)), rig.pitch_limit)
    lowest, highest = rig.voltage_limits
    u_min = rng.uniform(lowest, lowest + (highest - lowest) / 3.0)
    u_max = rng.uniform(highest - (highest - lowest) / 4.0, highest)
    limits = Limits(u_min, u_max, -pitch, pitch)
    least, most = rig.thrust_bounds(limits.u)
    low, high = 2.0 * least, 2.0 * most
    elevations = np.radians(np.linspace(-60.0, 60.0, 1201))
    share = (hover_input(elevations, parameters)[0] - low) / (high - low)
    held = elevations[(share > HOVER_MARGIN) & (share < 1.0 - HOVER_MARGIN)]
    start, goal = rng.uniform(held[0], held[-1], 2)
    travel = math.radians(rng.uniform(-720.0, 720.0))
    maneuver = Maneuver((0.0, start), (travel, goal), 1.0, limits, rig=rig)
    return replace(maneuver, duration=2.0 * easy_duration(maneuver))


def constrained_maneuver(rng: np.random.Generator, rig: Rig) -> Maneuver:
    """Draw a maneuver with some of: bump, elevation window, rates, slew, via point, free elevation, motion, lead."""
    own, table = rig.limits, rig.table_elevation
    while True:
        travel, (low, high) = rng.uniform(1.0, 7.0) * rng.choice([-1.0, 1.0]), rng.uniform(-0.12, 0.12, 2)
        has = dict(
            zip(("floor", "window", "rates", "slew", "via", "free", "start", "goal", "lead"), rng.random(9) < 0.3)
        )
        limits: dict[str, float] = {}
        if has["window"]:
            limits |= {"elevation_min": min(low, high) - 0.06, "elevation_max": max(low, high) + 0.06}
        if has["rates"]:
            limits |= {"travel_rate": rng.uniform(0.6, 1.5), "elevation_rate": rng.uniform(0.1, 0.4)}
        if has["slew"] and not has["lead"]:
            limits["slew"] = rng.uniform(0.4, 3.0) * (own.u_max - own.u_min)
        floor = None
        if has["floor"]:
            at = np.sort([0.0, travel]) @ np.array([[1.0], [0.0]]) + np.linspace(0.0, abs(travel), 201)
            height, width = rng.uniform(0.1, 0.25), rng.uniform(0.3, 0.8)
            below = max(low, high, 0.0) + 0.1
            floor = at, below - (below - min(low, high, 0.0) + height) * np.exp(-(((at - travel / 2.0) / width) ** 2))
        moving = np.array([travel, 0.3, high, 0.03, 0.1, 0.0]) * [1.0, np.sign(travel), 1.0, 1.0, 1.0, 1.0]
        via = ((None, 0.5 * travel, min(low, high) - 0.05),) if has["via"] and not has["floor"] else ()
        try:
            maneuver = Maneuver(
                (0.0, low),
                (travel, None if has["free"] and not has["goal"] else high),  # type: ignore[arg-type]
                1.0,
                replace(own, **limits),
                rig=rig,
                floor=floor,
                start_state=(0.0, 0.2, low, 0.0, -0.05, 0.0) if has["start"] and not has["lead"] else None,
                goal_state=tuple(moving) if has["goal"] else None,
                via=via,
                lead=bool(has["lead"]),
            )
            check_ends(maneuver)
        except ValueError:
            continue
        if max(low, high) < table:
            return replace(maneuver, duration=6.0 * easy_duration(maneuver))


def shortest_known(maneuver: Maneuver, smooth: bool = False) -> float:
    """Shortest duration in s by collocation, with thrusts that start and end in hover if smooth; else infinite."""
    found = collocate(maneuver, "time", smooth=smooth)
    return math.inf if found is None else float(found.t[-1])


def time_planner(
    planner: Callable[..., Trajectory], *arguments: Any, **options: Any
) -> tuple[Trajectory | None, float]:
    """Plan of a planner, or None if it refuses, and its computing time in s."""
    began = time.perf_counter()
    try:
        trajectory = planner(*arguments, **options)
    except InfeasibleManeuver:
        trajectory = None
    return trajectory, time.perf_counter() - began


def fly_open_loop(maneuver: Maneuver, trajectory: Trajectory) -> np.ndarray:
    """States (6, N) of (3) under a plan's voltages from its start, by scipy's integration of order eight."""
    times, voltages = trajectory.t, trajectory.u

    def rhs(t, x):
        u = np.array([np.interp(t, times, row) for row in voltages])
        return dynamics(x, virtual_input(maneuver.rig.thrust(u)), maneuver.parameters, math.sin, math.cos)

    return solve_ivp(rhs, (0.0, times[-1]), trajectory.x[:, 0], "DOP853", rtol=1e-8, atol=1e-10, max_step=0.02).y


def meets_its_limits(maneuver: Maneuver, trajectory: Trajectory) -> bool:
    """Whether a plan meets its limits and its goal in `fly_open_loop`."""
    flown = fly_open_loop(maneuver, trajectory)
    (start, goal), limits = maneuver.ends, maneuver.limits
    return bool(
        np.abs(flown[:, -1] - goal).max() <= ARRIVAL_TOLERANCE
        and (flown[:, 0] == start).all()
        and limits.u_min - LIMIT_TOLERANCE <= trajectory.u.min() <= trajectory.u.max() <= limits.u_max + LIMIT_TOLERANCE
        and limits.pitch_min - LIMIT_TOLERANCE <= flown[4].min() <= flown[4].max() <= limits.pitch_max + LIMIT_TOLERANCE
        and trajectory.t[-1] == maneuver.duration
    )


def plan_measures(maneuver: Maneuver, trajectory: Trajectory) -> dict[str, float]:
    """Duration, effort, reserve and violations of a plan by `fly_open_loop`."""
    u_min, u_max = maneuver.limits.u
    flown = fly_open_loop(maneuver, trajectory)
    pitch_low, pitch_high = maneuver.limits.pitch
    free = min(
        (trajectory.u.min() - u_min) / (0.5 * (u_max - u_min)),
        (u_max - trajectory.u.max()) / (0.5 * (u_max - u_min)),
        1.0 - flown[4].max() / pitch_high,
        1.0 - flown[4].min() / pitch_low,
    )
    over = max(u_min - trajectory.u.min(), trajectory.u.max() - u_max, 0.0)
    tilted = max(pitch_low - flown[4].min(), flown[4].max() - pitch_high, 0.0)
    return {
        "duration (s)": trajectory.duration,
        "effort (N² s)": effort(maneuver, trajectory),
        "reserve (%)": 100.0 * float(free),
        "over voltage (V)": float(over),
        "over pitch (deg)": float(np.degrees(tilted)),
        "misses goal (deg)": float(np.degrees(np.abs(flown[:, -1] - maneuver.ends[1]).max())),
    }


def effort(maneuver: Maneuver, trajectory: Trajectory) -> float:
    """Effort of a plan in N² s: integral of the squared thrusts, relative to those of hover at the goal."""
    f, hover = maneuver.rig.thrust(trajectory.u), 0.5 * hover_input(maneuver.goal[1], maneuver.parameters)[0]
    return float(np.trapezoid(((f - hover) ** 2).sum(axis=0), trajectory.t))


def flights(trajectory: Trajectory, plant: str, draws: int, seed: int = HELD_OUT_SEED) -> dict[str, Any]:
    """Errors and success with the paper's controller along a plan, from starts up to 5° off; draws from a seed on."""
    env = gym.make(
        "Heli3DOF-v0", plant=plant, reference=trajectory, start_spread_deg=START_SPREAD_DEG, rig=trajectory.rig
    )
    policy = make_policy("feedforward+tvlqr", trajectory)
    core: Any = env.unwrapped
    flown = [
        flight_metrics(fly(env, policy, seed=seed + k), trajectory, core.voltage_limits, core.pitch_limit)
        for k in range(draws)
    ]
    arrived = sum(metrics.success for metrics in flown)
    low, high = success_interval(arrived, draws)
    return {
        "RMS travel (deg)": float(np.mean([metrics.rms_error_deg[0] for metrics in flown])),
        "RMS elevation (deg)": float(np.mean([metrics.rms_error_deg[1] for metrics in flown])),
        "success (%)": 100.0 * arrived / draws,
        "95 % interval": f"{100.0 * low:.0f} to {100.0 * high:.0f}",
    }


def success_interval(successes: int, number: int) -> tuple[float, float]:
    """Wilson's 95 % interval of a probability of success."""
    interval = binomtest(successes, number).proportion_ci(method="wilson")
    return interval.low, interval.high
