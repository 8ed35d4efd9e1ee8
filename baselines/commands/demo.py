"""`heli-demo`: web page that simulates the helicopter in the browser and opens from a file, without network."""

import base64
import json
import math
import webbrowser
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.progress import track
from scipy.integrate import solve_ivp
from scipy.linalg import solve_discrete_are

from heli_gym.baselines.control.discrete_lqr import sampled_problem
from heli_gym.baselines.control.estimation import START_DEVIATIONS, encoder_noise, least_lift, nominal_actuator
from heli_gym.baselines.control.residual import CELL, FEATURE_CLIP, LEARNED, STATE_SCALE, RecurrentNetwork, load_learned
from heli_gym.baselines.control.weights import ObserverWeights, weights_of
from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.baselines.evaluation.report import WEB, body_of, check_page, model_data, plain, write_page
from heli_gym.baselines.paper.boundary_value import (
    FINE,
    KAPPA,
    PITCH_RESERVE,
    ConstrainedProblem,
    Solution,
    solve_unconstrained,
)
from heli_gym.baselines.paper.tvlqr import Q, R, stationary_cost, stationary_gain
from heli_gym.baselines.planning import spline, spline_search
from heli_gym.baselines.planning.feasibility import InfeasibleManeuver, start_clock, validated
from heli_gym.baselines.planning.planner import fastest_spline
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.model import hover_input
from heli_gym.on_rig import plant_on_rig
from heli_gym.parameters import Limits
from heli_gym.plant import AXES, NOMINAL_RIGS, PLANTS
from heli_gym.rig import PAPER, Rig, find_rig, same_dynamics
from heli_gym.simulation.simulation import SUBSTEP
from heli_gym.storage import atomic_write, check_folder
from heli_gym.task import TOLERANCE
from heli_gym.trajectory import Maneuver

PLANS = WEB / "plans.json"
CONTROL_PERIOD = 0.02  # s, the environment's default
DURATIONS = tuple(np.arange(8.5, 16.1, 0.5).tolist())  # s
PITCH_LIMITS_DEG = (30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0)
STEPS = 5  # continuation steps between two durations
VOLTAGE_WINDOWS = ((0.0, 12.0), (1.0, 11.0), (2.0, 10.5), (3.0, 10.0))  # V
ARRIVAL_TOLERANCE = 1e-3  # rad and rad/s
LIMIT_TOLERANCE = 1e-6  # V

RIGS = ("paper", "quanser", "ntnu", "fleet")
SPLINE_PITCH_LIMITS_DEG = (30.0, 40.0, 50.0, 60.0)
VOLTAGE_RESERVES = (0.0, 1.0 / 12.0, 0.25)  # shares of the amplifier's range left unused at each end
LONGER = (0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.5, 4.5, 6.5, 8.5)  # s
LONGEST = 100.0  # s, of the fastest plan

# Controllers of the page (web/src/controllers.ts), and whether they are shown initially.
SHOWN = ("feedforward+tvlqr", "open-loop", "residual")
POLICIES = tuple(
    {"name": name, "label": label_of(name).text, "colour": label_of(name).colour, "shown": name in SHOWN}
    for name in (*SHOWN, "kalman-lqr", "hover-lqr", "yours")
)
NETWORK_FOR = {
    "nominal": "lab",
    "lab": "lab",
    "rigid": "rigid",
}  # name in `heli_gym.baselines.control.residual.LEARNED`, by plant


@dataclass
class Args:
    """Write a web page that simulates the helicopter in the browser, and open it."""

    out: Path = Path("out/live.html")  # the page, one self-contained file; in a folder "page/" it is index.html
    open: bool = True  # open the page
    rig: str = ""  # rig to fly: a name or a .toml file, for which plans are solved; by default the packaged ones
    solve_plans: bool = False  # instead, solve the package's grids of plans anew (minutes)


def maneuver(duration: float, pitch_limit_deg: float, window: tuple[float, float]) -> Maneuver:
    """Paper's rotation with another duration in s, pitch limit in deg and voltage window in V."""
    pitch_limit = math.radians(pitch_limit_deg)
    return Maneuver(duration=duration, limits=Limits(*window, -pitch_limit, pitch_limit))


def solve_plans(console: Console) -> dict[str, Any]:
    """Solve the grid of the paper's plans: parameters p (6,) of (39), or None without a solution.

    The parameters are in plans[pitch limit][window][duration]; the page computes the rest.
    """
    jobs = list(product(PITCH_LIMITS_DEG, VOLTAGE_WINDOWS))
    chains = [solve_chain(*job) for job in track(jobs, "planning", console=console)]
    n = len(VOLTAGE_WINDOWS)
    return {
        "durations": DURATIONS,
        "pitch_limits_deg": PITCH_LIMITS_DEG,
        "windows": VOLTAGE_WINDOWS,
        "plans": [chains[n * i : n * i + n] for i in range(len(PITCH_LIMITS_DEG))],
    }


def solve_chain(pitch_limit_deg: float, window: tuple[float, float]) -> list[list[float] | None]:
    """Parameters for each of DURATIONS; the solver goes from the longest to the shortest by continuation."""
    plans: list[list[float]] = []
    last: Solution | None = None
    for duration in reversed(DURATIONS):
        requested = maneuver(duration, pitch_limit_deg, window)
        last = solve_from_unconstrained(requested) if last is None else shorten(last, requested)
        if last is None or not is_sound(requested, last):
            break
        plans.insert(0, last.p.tolist())
    return [*([None] * (len(DURATIONS) - len(plans))), *plans]


def solve_from_unconstrained(requested: Maneuver) -> Solution | None:
    """Solve (38) from the solution of (14), as in the paper."""
    unconstrained = solve_unconstrained(requested)
    problem = ConstrainedProblem(requested)
    return unconstrained and problem.solve(problem.guess(unconstrained.stretched(requested.duration)), FINE)


def shorten(solution: Solution, requested: Maneuver) -> Solution | None:
    """Solve a maneuver from the solution of a longer one, by continuation in small steps."""
    found: Solution | None = solution
    for duration in np.linspace(float(solution.t[-1]), requested.duration, STEPS + 1)[1:].tolist():
        found = found and ConstrainedProblem(replace(requested, duration=duration)).solve(
            found.stretched(duration), FINE
        )
    return found


def is_sound(requested: Maneuver, solution: Solution) -> bool:
    """Whether the voltages meet their limits, and forward integration of (38), as on the page, reaches the goal.

    The voltages exceed their limits where the bounds (22) cross; the pitch always meets its limits.
    """
    problem = ConstrainedProblem(requested)
    low, high = requested.limits.u
    u = problem.trajectory(solution).u
    if u.min() < low - LIMIT_TOLERANCE or u.max() > high + LIMIT_TOLERANCE:
        return False

    def rhs(t: float, Y: np.ndarray) -> np.ndarray:
        return problem.rhs(np.array([t]), Y[:, None], solution.p)[:, 0]

    start, goal = problem.ends()
    end = solve_ivp(rhs, (0.0, requested.duration), start, rtol=1e-6, atol=1e-9, max_step=0.05).y[:, -1]
    return bool(np.abs(end - goal).max() <= ARRIVAL_TOLERANCE)


def live_data(rig: Rig | None = None, console: Console | None = None) -> dict[str, Any]:
    """All data of the page, collected from the modules that define them: of a rig alone, or of the packaged ones."""
    grids = json.loads(PLANS.read_text(encoding="utf-8"))
    packaged = {name: find_rig(name) for name in RIGS}
    named = {name: own for name, own in packaged.items() if rig is not None and own == rig}
    paper = Maneuver()
    return {
        "paper": {
            "duration": paper.duration,
            "pitch_limit_deg": round(math.degrees(paper.limits.pitch_max), 9),
            "window": paper.limits.u,
        },
        "goal": paper.goal,
        "pitch_reserve": PITCH_RESERVE,
        "kappa": KAPPA,
        "control_period": CONTROL_PERIOD,
        "substep": SUBSTEP,
        "axes": AXES,
        "features": {
            "tolerance": TOLERANCE,
            "state_scale": STATE_SCALE.tolist(),
            "largest": FEATURE_CLIP,
        },
        "policies": POLICIES,
        "rigs": [
            rig_data(own, grids, spline_grid(own, console) if name not in grids["splines"] else grids["splines"][name])
            for name, own in (packaged if rig is None else named or {"": rig}).items()
        ],
    }


def rig_data(rig: Rig, grids: dict[str, Any], splines: dict[str, Any]) -> dict[str, Any]:
    """Data of the page that depend on the rig."""
    parameters, elevation = rig.parameters, Maneuver().goal[1]
    is_paper = same_dynamics(rig, PAPER)
    return {
        "name": rig.name,
        "source": " ".join(rig.source.split()),
        "parameters": model_data(rig),
        "amplifier": rig.voltage_limits,
        "pitch_stop": rig.pitch_limit,
        "encoder_counts": rig.encoder_counts,
        "weights": {"Q": Q.tolist(), "R": R.tolist(), "M": stationary_cost(elevation, parameters, Q, R).tolist()},
        "hover_gain": stationary_gain(elevation, parameters).tolist(),
        "networks": {
            name: network_data(name, elevation, rig) if is_paper else {"kalman": kalman_data(rig), "learned": None}
            for name in sorted(set(NETWORK_FOR.values()) if is_paper else {"lab"})
        },
        "network_for": {name: NETWORK_FOR.get(name, "lab") if is_paper else "lab" for name in PLANTS},
        "plants": plants_of(rig),
        "body": body_of(rig)._asdict(),
        "grids": {"spline": splines} | ({"paper": grids["paper"]} if is_paper else {}),
    }


def plants_of(rig: Rig) -> dict[str, Any]:
    """Plants of the page on a rig: those presets that exist for it."""
    found = {}
    for name in PLANTS:
        if NOMINAL_RIGS[name] == PAPER.name or same_dynamics(rig, find_rig(NOMINAL_RIGS[name])):
            with suppress(ValueError):  # not every rig has a rigid body
                found[name] = plain(plant_on_rig(name, rig))
    return found


def spline_grid(rig: Rig, console: Console | None = None) -> dict[str, Any]:
    """Grid of splines: the fastest and longer ones, for each pitch limit and voltage window.

    In plans[pitch limit][window] the first is the fastest, and the others take DURATIONS beyond the shortest of all
    fastest ones. A plan that is not found is replaced by one for narrower limits, or None.
    """
    low, high = rig.voltage_limits
    windows = [(low + share * (high - low), high - share * (high - low)) for share in VOLTAGE_RESERVES]
    windows = [window for window in windows if can_hover(rig, window)]
    stop, usual = math.degrees(rig.pitch_limit), math.degrees(rig.limits.pitch_max)
    pitch_limits = [degrees for degrees in SPLINE_PITCH_LIMITS_DEG if degrees <= stop]
    pitch_limits = pitch_limits or [max(math.floor(degrees), 1.0) for degrees in (usual, stop)]
    jobs = [(i, j) for i in range(len(pitch_limits)) for j in reversed(range(len(windows)))]  # narrower limits first

    def within(i: int, j: int, duration: float) -> Maneuver:
        pitch = math.radians(pitch_limits[i])
        return Maneuver(duration=duration, limits=Limits(*windows[j], -pitch, pitch), rig=rig)

    def better(i: int, j: int, own: Any, plans: dict) -> Any:
        others = [own, plans.get((i - 1, j)), plans.get((i, j + 1))]
        return min(filter(None, others), key=lambda plan: plan["duration"], default=None)

    fastest: dict[tuple[int, int], Any] = {}
    for i, j in track(jobs, f"planning for {rig.name}: fastest", console=console, disable=console is None):
        fastest[i, j] = better(i, j, fastest_plan(within(i, j, LONGEST)), fastest)
    if not any(fastest.values()):
        raise ValueError(f"rig = {rig.name!r}: must be one for which a plan of {Maneuver(rig=rig)} is found")
    first = math.ceil(2.0 * min(plan["duration"] for plan in fastest.values() if plan)) / 2.0
    durations = [first + longer for longer in LONGER]
    each: list[dict[tuple[int, int], Any]] = [fastest]
    for duration in track(durations, f"planning for {rig.name}: longer", console=console, disable=console is None):
        plans: dict[tuple[int, int], Any] = {}
        for i, j in jobs:
            short = fastest[i, j] is not None and fastest[i, j]["duration"] > duration
            plans[i, j] = better(i, j, None if short else smooth_plan(within(i, j, duration)), plans)
        each.append(plans)
    return {
        "durations": [None, *durations],
        "pitch_limits_deg": pitch_limits,
        "windows": windows,
        "plans": [[[plans[i, j] for plans in each] for j in range(len(windows))] for i in range(len(pitch_limits))],
    }


def can_hover(rig: Rig, window: tuple[float, float]) -> bool:
    """Whether the rig hovers level within a window of voltages in V."""
    least, most = rig.thrust_bounds(window)
    return bool(2.0 * least < hover_input(0.0, rig.parameters)[0] < 2.0 * most)


def fastest_plan(requested: Maneuver) -> dict[str, Any] | None:
    """Fastest spline of a maneuver, packed for the page; None if none is found."""
    try:
        return packed(fastest_spline(requested, start_clock(requested, None))[0])
    except InfeasibleManeuver:
        return None


def smooth_plan(requested: Maneuver) -> dict[str, Any] | None:
    """Smoothest spline in the maneuver's duration, packed for the page; None if none is found."""
    for segments in spline_search.SEGMENTS:
        start = spline.guess(requested, requested.duration, segments)
        found = spline.solve_within_limits(requested, spline.smoothest, start)
        if found is not None and validated(requested, found[1]) is not None:
            return packed(found[0])
    return None


def packed(found: spline.Spline) -> dict[str, Any]:
    """Duration and coefficients of a spline, as base64-encoded float32."""
    return {"duration": found.duration, "c": base64.b64encode(found.coefficients.astype("<f4").tobytes()).decode()}


def kalman_data(rig: Rig, name: str = "kalman-lqr") -> dict[str, Any]:
    """Model, weights and noise of a policy with a Kalman filter; M is the stationary cost of hover at the goal."""
    weights, actuator = weights_of(name, rig), nominal_actuator(rig, CONTROL_PERIOD)
    assert isinstance(weights, ObserverWeights)
    elevation, parameters = Maneuver().goal[1], rig.parameters
    hover = np.array([0.0, 0.0, elevation, 0.0, 0.0, 0.0])[:, None], hover_input(elevation, parameters)[:, None]
    A, B, cost, effort = sampled_problem(*hover, CONTROL_PERIOD, parameters, weights, actuator.lag)
    M = solve_discrete_are(A[0], B[0], cost, effort)
    return {
        "actuator": actuator._asdict(),
        "weights": {"Q": (cost / CONTROL_PERIOD).tolist(), "R": weights.R.tolist(), "M": M.tolist()},
        "noise": weights.noise._asdict(),
        "encoder_noise": encoder_noise(rig),
        "start_deviations": START_DEVIATIONS,
        "least_lift": least_lift(parameters),
    }


def network_data(name: str, elevation: float, rig: Rig) -> dict[str, Any]:
    """Controllers for a plant: Kalman LQR, and the learned correction with its base regulator.

    The network's arrays are base64-encoded float32, row by row.
    """
    settings, network = load_learned(LEARNED / name)
    assert isinstance(network, RecurrentNetwork) and (settings.law, len(network.head.weights)) == ("saturated", 1)
    assert settings.feature_groups == ("error", "voltages", "preview")
    weights = weights_of(settings.base)
    M = stationary_cost(elevation, rig.parameters, weights.Q, weights.R)
    arrays = {field: getattr(network, field) for field in CELL}
    arrays |= {"weight": network.head.weights[0], "bias": network.head.biases[0]}
    return {
        "kalman": kalman_data(rig, f"kalman-lqr@{settings.plant}"),
        "learned": {
            "weights": {"Q": weights.Q.tolist(), "R": weights.R.tolist(), "M": M.tolist()},
            "scale": settings.scale,
            "ahead": settings.ahead,
            "arrays": {key: base64.b64encode(value.astype("<f4").tobytes()).decode() for key, value in arrays.items()},
        },
    }


def main(args: Args | None = None) -> None:
    """Run the command `heli-demo`."""
    with command("heli-demo"):
        run(args or parse(Args, "heli-demo"))


def run(args: Args) -> None:
    """Write and open the page, or solve its grid of plans."""
    console = Console()
    if args.solve_plans:
        check_folder("the package's folder", PLANS.parent)
        announce_replaced("heli-demo", PLANS)
        splines = {name: spline_grid(find_rig(name), console) for name in RIGS}
        plans = {"paper": solve_plans(console), "splines": splines}
        with atomic_write(PLANS) as file:
            file.write(json.dumps(plans).encode())
        console.print(f"plans: {PLANS}")
        return
    page = args.out if args.out.suffix else args.out / "index.html"
    check_page("out", page)
    announce_replaced("heli-demo", page)
    data = live_data(find_rig(args.rig) if args.rig else None, console)
    write_page(page, "live", "heli_gym: fly the helicopter", data)
    console.print(f"page: {page}")
    if args.open:
        webbrowser.open(page.absolute().as_uri())


if __name__ == "__main__":
    main()
