"""`heli-log`: draw a measured flight, alone or with its plan."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import numpy as np
import tyro

from heli_gym.baselines.evaluation import figure_style, log_figures
from heli_gym.baselines.identification.flight_log import FlightLog, find_log
from heli_gym.baselines.identification.log_quantities import ANGLES
from heli_gym.baselines.identification.replay import PIECE, Replay, replay
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.rig import find_rig
from heli_gym.storage import check_folder
from heli_gym.trajectory import Trajectory

AMPLIFIER = (-24.0, 24.0)  # V, the widest of these rigs


@dataclass
class Args:
    """Draw a measured flight: angles with references, rates, voltages, airborne and saturated parts."""

    log: Annotated[Path, tyro.conf.Positional]  # .csv or .mat log, or the packaged `simulated`
    plan: Path | None = None  # .npz file of the flown plan
    rig: str | None = None  # name or .toml of a rig: its plant flies the logged voltages in a second picture
    piece: float = PIECE  # s, length of the pieces of that flight
    mapping: Path | None = None  # .toml or .json with the tables columns, signs, units and zeros
    sample_time: float | None = None  # s; by default 0.01, or the log's own if that is longer
    u_min: float | None = None  # V, lower limit of the amplifier; by default the rig's, -24 without a rig
    u_max: float | None = None  # V, upper limit of the amplifier; by default the rig's, 24 without a rig
    out: Path | None = None  # .png or .pdf; by default the log's name in out/


def describe(log: FlightLog) -> str:
    """Text on the length, ranges and airborne share of a log."""
    ranges = ", ".join(
        f"{name} {low:.1f}° to {high:.1f}°"
        for name, low, high in zip(ANGLES, np.degrees(log.angles.min(axis=1)), np.degrees(log.angles.max(axis=1)))
    )
    return (
        f"{log.name}: {log.duration:.2f} s at {1e3 * log.sample_time:g} ms, {100.0 * log.airborne().mean():.1f} % "
        f"airborne\n{ranges}, voltages {log.voltages.min():.2f} V to {log.voltages.max():.2f} V"
    )


def describe_replay(log: FlightLog, pieces: Sequence[Replay]) -> str:
    """Text with the RMS differences between log and plant, after 1 s and at the ends of the pieces."""
    n = round(1.0 / log.sample_time)
    lines = []
    for when, at in (("after 1 s", n), ("at the end of each piece", -1)):
        ends = [log.angles[:, round(p.t[at] / log.sample_time)] - p.angles[:, at] for p in pieces]
        values = np.degrees(np.sqrt(np.mean(np.square(ends), axis=0)))
        lines.append(f"{when}, " + ", ".join(f"{name} {value:.2f}°" for name, value in zip(ANGLES, values)))
    return f"replay in {len(pieces)} pieces, RMS difference: {'; '.join(lines)}"


def run(args: Args) -> None:
    """Load the log, draw and save the figure."""
    out = args.out or Path("out") / f"{args.log.stem}.png"
    if out.suffix not in (".png", ".pdf"):
        raise ValueError(f"out = {str(out)!r}: must end in .png or .pdf")
    rig = None if args.rig is None else find_rig(args.rig)
    limits = AMPLIFIER if rig is None else rig.voltage_limits
    u_min, u_max = (own if given is None else given for own, given in zip(limits, (args.u_min, args.u_max)))
    if not (math.isfinite(u_min) and math.isfinite(u_max) and u_min < u_max):
        raise ValueError(f"u_min = {u_min:g}, u_max = {u_max:g}: must be finite, the first the smaller")
    if not (math.isfinite(args.piece) and args.piece > 0.0):
        raise ValueError(f"piece = {args.piece:g}: must be a positive number of seconds")
    check_folder("out", out.parent)
    log = find_log(args.log, mapping=args.mapping, sample_time=args.sample_time)
    flown = None if rig is None else replay(log, rig, piece=args.piece)
    plan = None if args.plan is None else Trajectory.load(args.plan)
    figure = log_figures.flight_log(log, plan, (u_min, u_max))
    second = out.with_name(f"{out.stem}-replay{out.suffix}")
    announce_replaced("heli-log", out, *([second] if flown is not None else []))
    figure_style.save(figure, out)
    print(describe(log))
    print(f"picture: {out}")
    if rig is not None and flown is not None:
        figure_style.save(log_figures.replayed(log, flown, rig.name), second)
        print(describe_replay(log, flown))
        print(f"picture: {second}")


def main(args: Args | None = None) -> None:
    """Run the command `heli-log`."""
    with command("heli-log"):
        run(args or parse(Args, "heli-log"))


if __name__ == "__main__":
    main()
