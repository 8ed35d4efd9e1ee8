"""`heli-identify`: a rig from logs of its flights, with prediction errors on the parts that were not fitted."""

import json
import math
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import tyro
from rich.console import Console
from rich.table import Table

from heli_gym.baselines.evaluation import figure_style, log_figures
from heli_gym.baselines.identification.estimation import Identification, ablation_cases, identify
from heli_gym.baselines.identification.experiment import LONGEST, design
from heli_gym.baselines.identification.flight_log import FlightLog, find_log
from heli_gym.baselines.identification.log_quantities import ANGLES
from heli_gym.baselines.identification.prediction import (
    FilteredLog,
    Validation,
    pooled,
    report,
    tune,
    validate,
    verdicts,
)
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, check_folder

STRONG = 0.9  # least correlation to print


@dataclass
class Args:
    """Identify a rig from logs of its flights, and print the prediction errors on the parts that were not fitted."""

    logs: Annotated[tuple[Path, ...], tyro.conf.Positional] = ()  # .csv or .mat logs of one rig, or `simulated`
    rig: str = "paper"  # name or .toml of a rig: scale of the thrusts, sensors, amplifier
    fit_share: float = 0.6  # share of each log, from its start, to fit; the rest is predicted
    mapping: Path | None = None  # .toml or .json with the tables columns, signs, units and zeros
    sample_time: float | None = None  # s; by default 0.01, or the log's own if that is longer
    out: Path | None = None  # .toml for the identified rig, .csv for the experiment
    design: bool = False  # design an experiment for the rig instead, without logs
    duration: float = LONGEST  # s, duration of the experiment
    json: Path | None = None  # .json for the report
    figures: Path | None = None  # folder for figures of measured and predicted angles
    ablation: bool = False  # also identify without and with each effect, which takes ten times as long
    quiet: bool = False  # hide the progress


def parameter_table(model: Identification) -> Table:
    """Table of the parameters with standard errors."""
    table = Table("parameter", "value", "standard error", "", title=f"{', '.join(model.logs)}")
    errors = model.standard_errors
    for name, value in model.parameters._asdict().items():
        if name in errors:
            table.add_row(name, f"{value:.4g}", f"{errors[name]:.2g}", "")
        elif name in model.undetermined:
            table.add_row(name, f"{value:.4g}", "", "kept at the prior: the data do not determine it")
    return table


def prediction_table(validations: Sequence[Validation], horizon: float) -> Table:
    """Table of RMS errors over all logs, by predictor: in degrees, and relative to constant rate."""
    table = Table("predictor", *ANGLES, title=f"RMS error in degrees after {horizon:g} s (share of constant rate)")
    plain = pooled(validations, horizon, "constant rate")
    for name in ("constant rate", "constant acceleration", "black box", "model", "model, shrunk"):
        values = pooled(validations, horizon, name)
        if values[0] is not None:
            cells = [f"{value:.2f} ({value / max(other, 1e-9):.2f})" for value, other in zip(values, plain)]  # type: ignore
            table.add_row(name, *cells)
    return table


def log_table(validations: Sequence[Validation]) -> Table:
    """Table of errors at 1 s relative to constant rate, by log, for model and black box."""
    table = Table("log", "windows", *ANGLES, title="model, shrunk / black box at 1 s, share of constant rate")
    for v in validations:
        if 1.0 in v.rms:
            plain, model, box = (v.rms[1.0].get(name) for name in ("constant rate", "model, shrunk", "black box"))
            cells = [
                f"{model[i] / plain[i]:.2f} / {'-' if box is None else f'{box[i] / plain[i]:.2f}'}"  # type: ignore
                + ("" if np.degrees(v.moved[i]) > 2.0 else " (still)")
                for i in range(3)
            ]
            table.add_row(v.name, str(v.windows[1.0]), *cells)
    return table


def ablation_table(logs: list[FlightLog], args: Args, progress: Any) -> tuple[Table, dict[str, Any]]:
    """Errors at 1 s of models with effects added one by one, and of the full model without each effect."""
    table = Table("effects", *ANGLES, title="RMS error in degrees at 1 s, windows that were not fitted")
    found = {}
    for title, effects in ablation_cases().items():
        progress(f"ablation: {title}")
        model = identify(logs, args.rig, args.fit_share, effects)
        values = pooled(validate(logs, model, tune(logs, model), (1.0,), compare=False), 1.0, "model")
        found[title] = dict(zip(ANGLES, values))
        table.add_row(title, *(f"{value:.2f}" if value is not None else "-" for value in values))
    return table, found


def check_unused(args: Args, *names: str) -> None:
    """Raise ValueError for an argument that has no effect and is not the default."""
    for name in names:
        value = getattr(args, name)
        if value != getattr(Args, name):
            given = str(value) if isinstance(value, Path) else value
            raise ValueError(f"{name} = {given!r}: must be left out {'with' if args.design else 'without'} --design")


def check(args: Args) -> None:
    """Raise ValueError for invalid arguments."""
    if args.design:
        if args.logs:
            raise ValueError("logs: must be left out with --design")
        if args.out is not None and args.out.suffix != ".csv":
            raise ValueError(f"out = {str(args.out)!r}: must end in .csv with --design")
        check_unused(args, "fit_share", "mapping", "sample_time", "json", "figures", "ablation")
        return
    check_unused(args, "duration")
    if not args.logs:
        raise ValueError("logs: must be at least one file")
    if not (math.isfinite(args.fit_share) and 0.0 < args.fit_share <= 1.0):
        raise ValueError(f"fit_share = {args.fit_share!r}: must be more than 0 and at most 1")
    for name, suffix in (("out", ".toml"), ("json", ".json")):
        path = getattr(args, name)
        if path is not None:
            if path.suffix != suffix or path.is_dir():
                raise ValueError(f"{name} = {str(path)!r}: must end in {suffix}")
            check_folder(name, path.parent)
    if args.figures is not None:
        check_folder("figures", args.figures)


def run_design(args: Args) -> None:
    """Design an experiment, write its references and expected flight, print the expected errors."""
    out = args.out or Path("out/experiment.csv")
    check_folder("out", out.parent)
    rig, plan = find_rig(args.rig), out.with_suffix(".npz")
    announce_replaced("heli-identify", out, plan)
    experiment = design(rig, args.duration)
    experiment.log.save(out)
    experiment.trajectory(rig).save(plan)
    table = Table("parameter", "expected standard error", "share of the prior's spread")
    for name, error in experiment.standard_errors.items():
        table.add_row(name, f"{error:.2g}", f"{experiment.share_of_prior[name]:.2f}")
    console, log = Console(), experiment.log
    console.print(table)
    console.print(
        f"{log.duration:g} s, pitch {np.degrees(log.angles[2].min()):.1f}° to {np.degrees(log.angles[2].max()):.1f}°, "
        f"voltages {log.voltages.min():.2f} V to {log.voltages.max():.2f} V\nreferences and expected flight: {out}\n"
        f"the flight as a plan, for heli-export: {plan}"
    )


def run(args: Args) -> None:
    """Load the logs, identify, predict, write and print."""
    check(args)
    find_rig(args.rig)
    if args.design:
        run_design(args)
        return
    console, began = Console(), time.perf_counter()

    def progress(text: str) -> None:
        if not args.quiet:
            print(f"{time.perf_counter() - began:6.1f} s  {text}", file=sys.stderr, flush=True)

    logs = [find_log(path, mapping=args.mapping, sample_time=args.sample_time) for path in args.logs]
    pictures = [args.figures / f"{log.name}.png" for log in logs] if args.figures else []
    announce_replaced("heli-identify", *(path for path in (args.out, args.json, *pictures) if path))
    model = identify(logs, args.rig, args.fit_share, progress=progress)
    progress("settings of the filter")
    settings = tune(logs, model)
    progress("predictions")
    validations = validate(logs, model, settings)
    name = args.out.stem if args.out else logs[0].name
    rig: dict[str, Any] = {}
    try:
        identified = model.rig(name)
        rig, why = {"name": name, "toml": identified.to_toml()}, None
    except ValueError as error:
        identified, why = None, error
    results = report(logs, model, validations, rig)
    ablation = None
    if args.ablation:
        ablation, results["ablation"] = ablation_table(logs, args, progress)
    if args.json:
        with atomic_write(args.json) as file:
            file.write((json.dumps(results, indent=1) + "\n").encode())
    if args.out:
        if identified is None:
            raise ValueError(f"out = {str(args.out)!r}: the model makes no rig that hovers: {why}") from why
        identified.save(args.out)
    console.print(parameter_table(model))
    for i, one in enumerate(model.free):
        for j in range(i):
            if abs(model.correlations[i, j]) > STRONG:
                console.print(f"correlation of {model.free[j]} and {one}: {model.correlations[i, j]:.2f}")
    if any(1.0 in v.rms for v in validations):
        for horizon in (1.0, 3.0):
            console.print(prediction_table(validations, horizon))
        console.print(log_table(validations))
        for line in verdicts(validations):
            console.print(line)
    else:
        console.print("no window was left to predict: fit_share must be smaller, or the log longer")
    if ablation is not None:
        console.print(ablation)
    for log, path in zip(logs, pictures):
        figure_style.save(log_figures.predictions(FilteredLog(log, model, settings), args.fit_share), path)
        console.print(f"picture: {path}")
    for kind, written in (("rig", args.out), ("report", args.json)):
        if written:
            console.print(f"{kind}: {written}")


def main(args: Args | None = None) -> None:
    """Run the command `heli-identify`."""
    with command("heli-identify"):
        run(args or parse(Args, "heli-identify"))


if __name__ == "__main__":
    main()
