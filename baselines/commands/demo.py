"""`heli-demo`: web page that simulates the helicopter in the browser and opens from a file, without network."""

import base64
import json
import math
import webbrowser
from dataclasses import dataclass, fields, is_dataclass, replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.progress import track
from scipy.integrate import solve_ivp
from scipy.linalg import solve_discrete_are

from heli_gym.baselines.control.discrete_lqr import sampled_problem
from heli_gym.baselines.control.estimation import ENCODER_NOISE, LEAST_LIFT, START_DEVIATIONS, Actuator
from heli_gym.baselines.control.residual import (
    CELL,
    FEATURE_CLIP,
    LEARNED,
    STATE_SCALE,
    RecurrentNetwork,
    load_learned,
)
from heli_gym.baselines.control.weights import ObserverWeights, weights_of
from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.baselines.evaluation.report import WEB, check_page, write_page
from heli_gym.baselines.paper.boundary_value import (
    FINE,
    KAPPA,
    PITCH_RESERVE,
    ConstrainedProblem,
    Solution,
    solve_unconstrained,
)
from heli_gym.baselines.paper.tvlqr import Q, R, stationary_cost, stationary_gain
from heli_gym.cli import command, parse
from heli_gym.model import hover_input
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.plant import AXES, PLANTS, Rotors
from heli_gym.rig import PAPER, Rig, check_same_rig, find_rig
from heli_gym.rigid_body import solve_rigid_body
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

# Controllers of the page (web/src/controllers.ts), and whether they are shown initially.
SHOWN = ("feedforward+tvlqr", "open-loop", "residual")
POLICIES = tuple(
    {"name": name, "label": label_of(name).text, "colour": label_of(name).colour, "shown": name in SHOWN}
    for name in (*SHOWN, "kalman-lqr", "hover-lqr")
)
NETWORK_FOR = {
    "nominal": "lab",
    "lab": "lab",
    "rigid": "rigid",
}  # name in `heli_gym.baselines.control.residual.LEARNED`, by plant


@dataclass
class Args:
    """Write a web page that simulates the helicopter in the browser, and open it."""

    out: Path = Path("out/live.html")  # the page, one self-contained file
    open: bool = True  # open the page
    rig: str = "paper"  # rig: a name, or a .toml file; coefficients and thrust map must be the paper's
    solve_plans: bool = False  # instead, solve the package's grid of plans anew (minutes)


def maneuver(duration: float, pitch_limit_deg: float, window: tuple[float, float]) -> Maneuver:
    """Paper's rotation with another duration in s, pitch limit in deg and voltage window in V."""
    pitch_limit = math.radians(pitch_limit_deg)
    return Maneuver(duration=duration, limits=Limits(*window, -pitch_limit, pitch_limit))


def solve_plans(console: Console) -> dict[str, Any]:
    """Solve the grid of plans: parameters p (6,) of (39), or None without a solution.

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


def live_data(rig: Rig = PAPER) -> dict[str, Any]:
    """All data of the page, collected from the modules that define them.

    Raises ValueError for a rig with other coefficients or another thrust map: the grid of plans is the paper's.
    """
    check_same_rig("the page's grid of plans", PAPER, rig, "the one to fly")
    parameters, paper = rig.parameters, Maneuver()
    elevation = paper.goal[1]
    return {
        "parameters": parameters._asdict(),
        "paper": {
            "duration": paper.duration,
            "pitch_limit_deg": round(math.degrees(paper.limits.pitch_max), 9),
            "window": paper.limits.u,
        },
        "goal": paper.goal,
        "amplifier": rig.voltage_limits,
        "pitch_stop": rig.pitch_limit,
        "pitch_reserve": PITCH_RESERVE,
        "kappa": KAPPA,
        "control_period": CONTROL_PERIOD,
        "substep": SUBSTEP,
        "axes": AXES,
        "weights": {"Q": Q.tolist(), "R": R.tolist(), "M": stationary_cost(elevation, parameters, Q, R).tolist()},
        "hover_gain": stationary_gain(elevation, parameters).tolist(),
        "features": {
            "tolerance": TOLERANCE,
            "state_scale": STATE_SCALE.tolist(),
            "largest": FEATURE_CLIP,
        },
        "networks": {name: network_data(name, elevation, parameters) for name in sorted(set(NETWORK_FOR.values()))},
        "network_for": NETWORK_FOR,
        "plants": {name: plain(plant) for name, plant in PLANTS.items() if not plant.is_general},
        "rig": solve_rigid_body("A")._asdict(),
        "policies": POLICIES,
        "grid": json.loads(PLANS.read_text()),
    }


def kalman_data(name: str, elevation: float, parameters: HelicopterParameters) -> dict[str, Any]:
    """Model, weights and noise of a policy with a Kalman filter; M is the stationary cost of hover at `elevation`."""
    weights = weights_of(name)
    assert isinstance(weights, ObserverWeights)
    hover = np.array([0.0, 0.0, elevation, 0.0, 0.0, 0.0])[:, None], hover_input(elevation, parameters)[:, None]
    A, B, cost, effort = sampled_problem(*hover, CONTROL_PERIOD, parameters, weights, Actuator().lag)
    M = solve_discrete_are(A[0], B[0], cost, effort)
    return {
        "actuator": Actuator()._asdict(),
        "weights": {"Q": (cost / CONTROL_PERIOD).tolist(), "R": weights.R.tolist(), "M": M.tolist()},
        "noise": weights.noise._asdict(),
        "encoder_noise": ENCODER_NOISE,
        "start_deviations": START_DEVIATIONS,
        "least_lift": LEAST_LIFT * -parameters.a2 / parameters.b2,
    }


def network_data(name: str, elevation: float, parameters: HelicopterParameters) -> dict[str, Any]:
    """Controllers for a plant: Kalman LQR, and the learned correction with its base regulator.

    The network's arrays are base64-encoded float32, row by row.
    """
    settings, network = load_learned(LEARNED / name)
    assert isinstance(network, RecurrentNetwork) and (settings.law, len(network.head.weights)) == ("saturated", 1)
    assert settings.feature_groups == ("error", "voltages", "preview")
    weights = weights_of(settings.base)
    M = stationary_cost(elevation, parameters, weights.Q, weights.R)
    arrays = {field: getattr(network, field) for field in CELL}
    arrays |= {"weight": network.head.weights[0], "bias": network.head.biases[0]}
    return {
        "kalman": kalman_data(f"kalman-lqr@{settings.plant}", elevation, parameters),
        "weights": {"Q": weights.Q.tolist(), "R": weights.R.tolist(), "M": M.tolist()},
        "scale": settings.scale,
        "ahead": settings.ahead,
        "arrays": {key: base64.b64encode(value.astype("<f4").tobytes()).decode() for key, value in arrays.items()},
    }


def plain(value: Any) -> Any:
    """Convert a plant or a draw for JSON: records to dictionaries of their fields, infinity to None.

    The page counts delays in control periods.
    """
    if isinstance(value, Rotors):
        return {f.name: plain(getattr(value, f.name)) for f in fields(value)} | {
            "delay": round(value.delay / CONTROL_PERIOD)
        }
    if is_dataclass(value):
        return {f.name: plain(getattr(value, f.name)) for f in fields(value)}
    if hasattr(value, "_asdict"):
        return {name: plain(part) for name, part in value._asdict().items()}
    if isinstance(value, tuple):
        return [plain(part) for part in value]
    return None if value == math.inf else value


def main(args: Args | None = None) -> None:
    """Run the command `heli-demo`."""
    with command("heli-demo"):
        run(args or parse(Args, "heli-demo"))


def run(args: Args) -> None:
    """Write and open the page, or solve its grid of plans."""
    console = Console()
    if args.solve_plans:
        check_folder("the package's folder", PLANS.parent)
        plans = solve_plans(console)
        with atomic_write(PLANS) as file:
            file.write(json.dumps(plans).encode())
        console.print(f"plans: {PLANS}")
        return
    check_page("out", args.out)
    write_page(args.out, "live", "heli_gym: fly the helicopter", live_data(find_rig(args.rig)))
    console.print(f"page: {args.out}")
    if args.open:
        webbrowser.open(args.out.absolute().as_uri())


if __name__ == "__main__":
    main()
