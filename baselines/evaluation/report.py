"""Pages that open from a file, without network: the report of an evaluation; `commands.demo` has the live page.

The program in them is TypeScript, in web/; `npm ci && npm run build` there bundles it into baselines/evaluation/web/.
"""

import json
import os
import re
from collections.abc import Mapping
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym.baselines.paper.tvlqr import riccati_gains
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP, HelicopterParameters
from heli_gym.rigid_body import solve_rigid_body
from heli_gym.storage import atomic_write, check_folder
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory

WEB = Path(str(files("heli_gym.baselines.evaluation") / "web"))
SAMPLE_PERIOD = 0.02  # s, at least, between the samples of a flight in the report
DECIMALS = 7  # of rad, rad/s, V and gains


def check_page(name: str, path: str | os.PathLike) -> None:
    """Raises ValueError unless a page can be written to the path."""
    if Path(path).suffix != ".html" or Path(path).is_dir():
        raise ValueError(f"{name} = {str(path)!r}: must end in .html")
    check_folder(name, Path(path).parent)


def write_page(path: str | os.PathLike, kind: str, title: str, data: Mapping[str, Any]) -> None:
    """One .html file with the program, its style and its data in it; `kind` is "live" or "report".

    Raises ValueError for a path that is not that of an .html file.
    """
    check_page("path", path)
    parts = {
        "kind": kind,
        "title": title,
        "style": (WEB / "heli.css").read_text(),
        "data": json.dumps(data, separators=(",", ":"), allow_nan=False),
        "script": (WEB / "heli.js").read_text(),
    }
    # No text of a user can end the element that it stands in.
    parts["title"] = parts["title"].replace("&", "&amp;").replace("<", "&lt;")
    parts["data"] = parts["data"].replace("<", "\\u003c")
    page = re.sub("<!--([a-z]+)-->", lambda place: parts[place[1]], (WEB / "page.html").read_text())
    with atomic_write(path) as file:
        file.write(page.encode())


def write_report(
    path: str | os.PathLike,
    title: str,
    table: Mapping[str, Any],
    reference: Trajectory,
    flights: Mapping[str, Mapping[str, Trajectory]],
    parameters: HelicopterParameters = HelicopterParameters(),
) -> None:
    """The report of an evaluation: its table, and its flights in plots and in 3D.

    Args:
        path: an .html file.
        title: what was evaluated.
        table: "title" and "caption", "columns" (names) and "rows" (their cells, as they are to be shown).
        reference: what was to be flown.
        flights: by start and policy, as `fly` returns them; every start has the same policies.
        parameters: those that the gains and the constraints are computed with.

    Raises:
        ValueError: if the path is not that of an .html file.
    """
    policies = list(dict.fromkeys(policy for group in flights.values() for policy in group))
    limits = reference.limits
    data = {
        "title": title,
        "subtitle": f"{reference.duration:g} s within {limits}; heli-gym {version('heli-gym')}",
        "table": table,
        "policies": policies,
        "groups": [
            flight_group(label, reference, [group[policy] for policy in policies]) for label, group in flights.items()
        ],
        "gains": sampled_gains(reference, parameters) if "feedforward+tvlqr" in policies else None,
        "limits": {"u": limits.u, "pitch": limits.pitch},
        "amplifier": AMPLIFIER_LIMITS,
        "parameters": parameters._asdict(),
        "rig": solve_rigid_body("A", parameters)._asdict(),
    }
    write_page(path, "report", f"heli_gym: {title}", data)


def flight_group(label: str, reference: Trajectory, flights: list[Trajectory]) -> dict[str, Any]:
    """Flights with the same start and control period, and the reference as they had it, sampled for the page."""
    control_period = float(flights[0].t[1])
    x_ref, u_ref = control_grid(reference, control_period)
    stride = max(1, round(SAMPLE_PERIOD / control_period))
    last = x_ref.shape[1] - 1

    def sampled(x: np.ndarray, u: np.ndarray) -> dict[str, Any]:
        return {"x": rounded(x[:, ::stride]), "u": rounded(u[:, ::stride])}

    def ended(flight: Trajectory) -> str:
        early = f"beyond ±{np.degrees(PITCH_STOP):.0f}° of pitch: the flight ended at {flight.duration:.2f} s"
        return early if len(flight.t) <= last else ""

    return {
        "label": label,
        "step": stride * control_period,
        "reference": sampled(x_ref, u_ref),
        "flights": [{**sampled(flight.x, flight.u), "ended": ended(flight)} for flight in flights],
    }


def sampled_gains(reference: Trajectory, parameters: HelicopterParameters) -> dict[str, Any]:
    """The gains (51) along the reference."""
    t = np.arange(0.0, reference.duration + 0.5 * SAMPLE_PERIOD, SAMPLE_PERIOD)
    return {"step": SAMPLE_PERIOD, "K": rounded(riccati_gains(reference, parameters)(t))}


def rounded(values: np.ndarray) -> list:
    """Values in as few characters as they need."""
    return np.round(values, DECIMALS).tolist()
