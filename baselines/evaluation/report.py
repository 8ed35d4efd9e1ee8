"""Web pages that open from a file, without network: the report of an evaluation (`commands.demo` has the live page).

Their program is TypeScript in web/; `npm ci && npm run build` there bundles it into baselines/evaluation/web/.
"""

import base64
import json
import math
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from hashlib import sha256
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.evaluation.labels import colours_of, label_of
from heli_gym.baselines.paper.tvlqr import riccati_gains
from heli_gym.rig import Rig, body_of_masses
from heli_gym.rigid_body import RigidBodyParameters, solve_rigid_body
from heli_gym.storage import atomic_write, check_folder
from heli_gym.task import control_grid
from heli_gym.thrust_map import TableCurve
from heli_gym.trajectory import Trajectory

WEB = Path(str(files("heli_gym.baselines.evaluation") / "web"))
SAMPLE_PERIOD = 0.02  # s, least time between samples of a flight in the report
DECIMALS = 6  # for rad, rad/s, V and gains


def check_page(name: str, path: str | os.PathLike) -> None:
    """Raise ValueError unless the path is that of an .html file."""
    if Path(path).suffix != ".html" or Path(path).is_dir():
        raise ValueError(f"{name} = {str(path)!r}: must end in .html")
    check_folder(name, Path(path).parent)


def write_page(path: str | os.PathLike, kind: str, title: str, data: Mapping[str, Any]) -> None:
    """Write one .html file with program, style and data; `kind` is "live" or "report".

    Raises ValueError for a path that is not that of an .html file.
    """
    check_page("path", path)
    parts = {
        "kind": kind,
        "title": title,
        "style": (WEB / "heli.css").read_text(encoding="utf-8"),
        "data": json.dumps(data, separators=(",", ":"), allow_nan=False),
        "script": (WEB / "heli.js").read_text(encoding="utf-8"),
    }
    # The hash permits this program only, not a script in a user's text.
    parts["hash"] = base64.b64encode(sha256(parts["script"].encode()).digest()).decode()
    # Escaped, a user's text cannot close its element.
    parts["title"] = parts["title"].replace("&", "&amp;").replace("<", "&lt;")
    parts["data"] = parts["data"].replace("<", "\\u003c")
    page = re.sub("<!--([a-z]+)-->", lambda place: parts[place[1]], (WEB / "page.html").read_text(encoding="utf-8"))
    with atomic_write(path) as file:
        file.write(page.encode())


class Shown(NamedTuple):
    """Flights from one start, shown together in the report."""

    label: str
    flights: Mapping[str, Trajectory]  # by policy
    draw: Sequence[tuple[str, str]] = ()  # name and value with unit of the draw's parameters
    errors: Mapping[str, float] = {}  # deg, by policy: positions of these flights in the histograms


def write_report(
    path: str | os.PathLike,
    title: str,
    table: Mapping[str, Any],
    reference: Trajectory,
    shown: Sequence[Shown],
    errors: Mapping[str, Sequence[float]] | None = None,
    rig: Rig | None = None,
) -> None:
    """Write the report of an evaluation: table, flights in plots and in 3D, and histograms of their errors.

    Args:
        path: .html file.
        title: title of the page.
        table: "title", "caption", "columns" (names) and "rows" (formatted cells); the cells under "policy" are names
            of policies.
        reference: trajectory to track.
        shown: groups of flights, the initial group first; a policy may be missing in a group.
        errors: RMS errors in deg of all episodes, by policy.
        rig: rig of the gains, amplifier and body shown; the reference's by default.

    Raises:
        ValueError: if the path is not that of an .html file.
    """
    policies = list(dict.fromkeys(policy for group in shown for policy in group.flights))
    rig = rig or reference.rig
    limits = reference.limits
    data = {
        "title": title,
        "subtitle": f"{reference.duration:g} s within {limits}; heli-gym {version('heli-gym')}",
        "table": table,
        "policies": policies,
        "labels": [label_of(policy).text for policy in policies],
        "colours": colours_of(policies),
        "groups": [flight_group(group, reference, policies) for group in shown],
        "errors": [list((errors or {}).get(policy, ())) for policy in policies],
        "gains": sampled_gains(reference, rig) if "feedforward+tvlqr" in policies else None,
        "limits": {"u": limits.u, "pitch": limits.pitch},
        "amplifier": rig.voltage_limits,
        "parameters": model_data(rig),
        "rig": body_of(rig)._asdict(),
    }
    write_page(path, "report", f"heli_gym: {title}", data)


def body_of(rig: Rig) -> RigidBodyParameters:
    """Rigid body for the replay: of the rig's masses, else of its coefficients or, without a solution, the paper's."""
    if rig.mass_data is not None:
        return body_of_masses(rig.mass_data)
    try:
        return solve_rigid_body("A", rig.parameters)
    except ValueError:
        return solve_rigid_body("A")


def model_data(rig: Rig) -> dict[str, Any]:
    """Coefficients of (3) and thrust curves of both rotors."""
    return rig.parameters._asdict() | {"front": plain(rig.thrust_map.front), "back": plain(rig.thrust_map.back)}


def plain(value: Any) -> Any:
    """Convert a plant or a draw for JSON: records to dictionaries of their fields, infinity to None."""
    if isinstance(value, TableCurve):
        return {"voltages": value.voltages, "thrusts": value.thrusts, "cubics": value.cubics.c.tolist()}
    if is_dataclass(value):
        return {f.name: plain(getattr(value, f.name)) for f in fields(value)}
    if hasattr(value, "_asdict"):
        return {name: plain(part) for name, part in value._asdict().items()}
    if isinstance(value, tuple):
        return [plain(part) for part in value]
    return None if value == math.inf else value


def flight_group(group: Shown, reference: Trajectory, policies: Sequence[str]) -> dict[str, Any]:
    """Flights with a common start and control period, and their reference, sampled for the page."""
    control_period = float(next(iter(group.flights.values())).t[1])
    x_ref, u_ref = control_grid(reference, control_period)
    stride = max(1, round(SAMPLE_PERIOD / control_period))
    last = x_ref.shape[1] - 1

    def sampled(x: np.ndarray, u: np.ndarray) -> dict[str, Any]:
        return {"x": rounded(x[:, ::stride]), "u": rounded(u[:, ::stride])}

    def flown(flight: Trajectory | None) -> dict[str, Any] | None:
        if flight is None:
            return None
        stop = f"±{np.degrees(flight.rig.pitch_limit):.0f}°"
        early = f"beyond {stop} of pitch: the flight ended at {flight.duration:.2f} s"
        return {**sampled(flight.x, flight.u), "ended": early if len(flight.t) <= last else ""}

    return {
        "label": group.label,
        "step": stride * control_period,
        "reference": sampled(x_ref, u_ref),
        "flights": [flown(group.flights.get(policy)) for policy in policies],
        "draw": [list(pair) for pair in group.draw],
        "errors": [group.errors.get(policy) for policy in policies],
    }


def sampled_gains(reference: Trajectory, rig: Rig) -> dict[str, Any]:
    """Gains (51) along the reference, sampled for the page."""
    t = np.arange(0.0, reference.duration + 0.5 * SAMPLE_PERIOD, SAMPLE_PERIOD)
    return {"step": SAMPLE_PERIOD, "K": rounded(riccati_gains(reference, rig)(t))}


def rounded(values: np.ndarray) -> list:
    """Values as nested lists, rounded to DECIMALS to shorten the page."""
    return np.round(values, DECIMALS).tolist()
