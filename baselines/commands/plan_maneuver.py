"""`heli-plan`: plan a maneuver, print its key figures, save and draw it."""

import csv
import sys
import time
import warnings
from dataclasses import dataclass, replace
from math import degrees, isfinite, radians
from pathlib import Path
from typing import Literal

import numpy as np
from rich.console import Console

from heli_gym.baselines.evaluation import figure_style, figures
from heli_gym.baselines.planning.planner import plan, plan_fastest
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.rig import find_rig
from heli_gym.storage import check_folder
from heli_gym.trajectory import Maneuver, Trajectory

PAPERS = Maneuver()
FARTHEST_DEG = 1e7  # about 28,000 turns


@dataclass
class Args:
    """Plan a maneuver from rest to rest. The defaults are the paper's 360° rotation, (8) and (9)."""

    travel_deg: float = degrees(PAPERS.goal[0])  # travel at the goal
    elevation_deg: float = degrees(PAPERS.goal[1])  # elevation at the goal, positive downwards
    duration: float = PAPERS.duration  # s
    start_travel_deg: float = degrees(PAPERS.start[0])  # travel at the start
    start_elevation_deg: float = degrees(PAPERS.start[1])  # elevation at the start
    rig: str = "paper"  # rig: paper, quanser, ntnu, or a .toml file
    pitch_limit_deg: float | None = None  # pitch limit on both sides; by default the rig's, 50 for the paper
    u_min: float | None = None  # V, least voltage; by default the rig's, 1 for the paper
    u_max: float | None = None  # V, greatest voltage; by default the rig's, 11 for the paper
    elevation_min_deg: float | None = None  # least elevation, positive downwards: the upper limit in space
    elevation_max_deg: float | None = None  # greatest elevation: the lower limit in space
    travel_rate_deg: float | None = None  # greatest travel rate in deg/s, in both directions
    elevation_rate_deg: float | None = None  # greatest elevation rate in deg/s, in both directions
    slew: float | None = None  # V/s, greatest change of a voltage
    floor: Path | None = None  # .csv file with columns travel_deg, elevation_deg: a line in space below the flight
    via: Path | None = None  # .csv file with columns time, travel_deg, elevation_deg: points passed in motion
    lead: bool = False  # the voltages lead the rotors' nominal lag and dead time
    method: Literal["auto", "paper", "spline", "flat", "collocation"] = "auto"  # collocation requires the extra ocp
    objective: Literal["shortest", "effort", "reserve", "smoothest"] | None = None  # by default the method's own
    fastest: bool = False  # search for the shortest duration, up to `duration`
    reserve: float = 0.0  # share of the voltage and pitch windows reserved for the feedback, with fastest
    time_limit: float | None = None  # s, limit of the planning time
    out: Path = Path("out/plan.npz")  # the plan; its figure has the same name
    figure: bool = True  # draw the figure


def requested_maneuver(args: Args) -> Maneuver:
    """Maneuver of the arguments. Raises ValueError that names the invalid argument."""
    for name in ("travel_deg", "elevation_deg", "start_travel_deg", "start_elevation_deg"):
        if not abs(getattr(args, name)) <= FARTHEST_DEG:
            raise ValueError(
                f"{name} = {getattr(args, name)!r}: must be at most {FARTHEST_DEG:g} degrees on either side"
            )
    rig = find_rig(args.rig)
    if args.pitch_limit_deg is not None and not 0.01 <= args.pitch_limit_deg < 90.0:
        raise ValueError(f"pitch_limit_deg = {args.pitch_limit_deg!r}: must be at least 0.01 and less than 90 degrees")
    pitch_min, pitch_max = rig.limits.pitch
    if args.pitch_limit_deg is not None:
        pitch_max = radians(args.pitch_limit_deg)
        pitch_min = -pitch_max
    u_min, u_max = (own if given is None else given for own, given in zip(rig.limits.u, (args.u_min, args.u_max)))
    more = path_limits(args) | ({} if args.slew is None else {"slew": args.slew})
    limits = replace(rig.limits, u_min=u_min, u_max=u_max, pitch_min=pitch_min, pitch_max=pitch_max, **more)
    floor = None if args.floor is None else read_floor(args.floor)
    for name in ("start_elevation_deg", "elevation_deg"):
        point = (0.0, radians(getattr(args, name)))
        try:
            Maneuver(point, point, limits=limits, rig=rig)
        except ValueError as error:
            if not str(error).startswith("start"):  # the error is in the limits
                raise
            _, _, reason = str(error).partition(": ")
            raise ValueError(f"{name} = {getattr(args, name)!r}: {reason}") from error
    return Maneuver(
        start=(radians(args.start_travel_deg), radians(args.start_elevation_deg)),
        goal=(radians(args.travel_deg), radians(args.elevation_deg)),
        duration=args.duration,
        limits=limits,
        rig=rig,
        floor=floor,
        via=() if args.via is None else read_via(args.via),
        lead=args.lead,
    )


def path_limits(args: Args) -> dict[str, float]:
    """Limits on elevation and rates in rad and rad/s, by name. Raises ValueError that names the invalid argument."""
    limits = {}
    for name in ("elevation_min", "elevation_max", "travel_rate", "elevation_rate"):
        value = getattr(args, f"{name}_deg")
        if value is None:
            continue
        if not isfinite(value) or (name.endswith("rate") and value <= 0.0):
            kind = "positive" if name.endswith("rate") else "finite"
            raise ValueError(f"{name}_deg = {value!r}: must be a {kind} number")
        limits[name] = radians(value)
    return limits


def read_floor(path: Path) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Travel and elevation (N,) in rad of a line in space. Raises ValueError for a file without these columns."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        travel, elevation = (
            tuple(radians(float(row[name])) for row in rows) for name in ("travel_deg", "elevation_deg")
        )
        return travel, elevation
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"floor = {str(path)!r}: must have the columns travel_deg and elevation_deg") from error


def read_via(path: Path) -> tuple[tuple[float | None, float, float | None], ...]:
    """Via points in s and rad. Raises ValueError for a file without these columns."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return tuple(
            (
                float(row["time"]) if row["time"] else None,
                radians(float(row["travel_deg"])),
                radians(float(row["elevation_deg"])) if row["elevation_deg"] else None,
            )
            for row in rows
        )
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"via = {str(path)!r}: must have the columns time, travel_deg and elevation_deg") from error


def plan_requested(maneuver: Maneuver, args: Args) -> Trajectory:
    """Plan of a maneuver, in its duration or as fast as possible."""
    if args.fastest:
        if args.objective not in (None, "shortest"):
            raise ValueError(
                f"objective = {args.objective!r}: must be left out with --fastest, whose own is 'shortest'"
            )
        return plan_fastest(maneuver, args.method, args.reserve, args.time_limit)
    if args.reserve:
        raise ValueError(
            f"reserve = {args.reserve!r}: only the fastest plan has one; tighter limits are for the others"
        )
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        trajectory = plan(maneuver, args.method, args.time_limit, objective=args.objective)
    for warning in caught:
        print(f"heli-plan: {warning.message}", file=sys.stderr)
    return trajectory


def main(args: Args | None = None) -> None:
    """Run the command `heli-plan`."""
    with command("heli-plan"):
        run(args or parse(Args, "heli-plan"))


def run(args: Args) -> None:
    """Plan and save, then print and draw."""
    console = Console()
    began = time.perf_counter()
    if args.out.suffix != ".npz" or args.out.is_dir():
        raise ValueError(f"out = {str(args.out)!r}: must end in .npz")
    check_folder("out", args.out.parent)
    maneuver = requested_maneuver(args)
    trajectory = plan_requested(maneuver, args)
    picture = args.out.with_suffix(".png")
    announce_replaced("heli-plan", args.out, *([picture] if args.figure else []))
    trajectory.save(args.out)
    on_rig = "" if args.rig == PAPERS.rig.name else f"rig {maneuver.rig.name}, "
    console.print(f"{on_rig}{maneuver}: planned in {time.perf_counter() - began:.2f} s")
    pitch = np.degrees(trajectory.x[4])
    console.print(
        f"{trajectory.duration:.3f} s, pitch {pitch.min():.2f}° to {pitch.max():.2f}°, voltages "
        f"{trajectory.u.min():.2f} V to {trajectory.u.max():.2f} V\nplan: {args.out}"
    )
    if args.figure:
        figure_style.save(figures.feedforward(trajectory, maneuver.rig, "Plan"), picture)
        console.print(f"picture: {picture}")


if __name__ == "__main__":
    main()
