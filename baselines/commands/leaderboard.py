"""`heli-leaderboard`: tables of policies on common draws of plants, along maneuvers, with intervals and ranks.

Each plant also flies as PLANT+outside: with Coulomb friction, a weaker front rotor and gusts, outside the design
family of all controllers. Every batch of flights is stored at once; after a kill, the command with --resume continues.
Policies are names (`NAME@PLANT`: with weights tuned for the plant), files of learned policies (.json),
Stable-Baselines3 models (.zip) or ONNX networks, and own functions, my_module:make. The folder holds

    flights.parquet, flights.csv   one row per flight
    leaderboard.md, .html, .json   the tables
    pages/                         per table, the median and the worst flight in plots and in 3D
"""

import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import tyro
from rich.console import Console

from heli_gym.baselines.control.policies import POLICIES
from heli_gym.baselines.control.weights import WEIGHTS
from heli_gym.baselines.evaluation.conditions import OUTSIDE, describe_draw, find_condition, nominal_rig
from heli_gym.baselines.evaluation.digests import policy_digest, reference_digest
from heli_gym.baselines.evaluation.engine import Engine, EngineName, check_engine, open_engine, progress_bar
from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.baselines.evaluation.leaderboard import (
    Batch,
    Condition,
    Ledger,
    Settings,
    batches,
    env_settings,
    fly_all,
    flyable,
    microseconds_per_step,
    pilot_for,
    policy_on,
    standings,
    write_tables,
)
from heli_gym.baselines.evaluation.leaderboard_tables import (
    CAPTION,
    cells,
    columns_of,
    heading,
    markdown,
    page,
    page_name,
    print_table,
)
from heli_gym.baselines.evaluation.report import Shown, write_report
from heli_gym.baselines.evaluation.rollout import fly
from heli_gym.cli import command, parse
from heli_gym.env import Heli3DOFEnv
from heli_gym.plant import HELD_OUT_SEED, PLANTS
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, check_folder, read_json_object
from heli_gym.vector_env import Heli3DOFVectorEnv

NOT_COMPARED = ("middle-voltage", "zero", "residual-rigid", "residual-any")
COMPARED = tuple(f"{name}@PLANT" if name in WEIGHTS else name for name in POLICIES if name not in NOT_COMPARED)
SETTINGS = "settings.json"
MOST_EPISODES = 10**7
ON_A_PAGE = 6  # greatest number of policies


@dataclass
class Args:
    """Fly policies on common draws of plants, and write tables with intervals and ranks."""

    policies: Annotated[tuple[str, ...], tyro.conf.arg(aliases=["--policy"])] = COMPARED
    """policies: names, files (.json, .zip of Stable-Baselines3, .onnx), module:function"""
    plants: tuple[str, ...] = tuple(PLANTS)
    outside: bool = True  # also fly each plant with disturbances outside the design family
    references: tuple[str, ...] = ("travel-360",)  # maneuvers: packaged references, or .npz files
    rig: str | None = None  # nominal rig, a name or a .toml file; by default each plant's own
    episodes: int = 1000  # number of draws of each plant
    seed: int = HELD_OUT_SEED  # seed of the first draw, then counting up
    against: str = "feedforward+tvlqr@PLANT"  # policy to compare the others with, if it flies
    start_spread_deg: float = 5.0  # greatest deviation of each angle at the start
    control_period: float = 0.02  # s
    engine: EngineName = "local"  # processes of this machine, or Ray
    address: str | None = None  # Ray cluster, HOST:PORT or auto; by default one is started on this machine
    workers: int = 2  # number of processes
    batch: int = 100  # episodes that a process flies at once, where the policy can; a kill repeats a batch
    out: Path = Path("out/leaderboard")
    resume: bool = False  # continue the leaderboard in this folder; policies, plants and maneuvers may be added
    pages: bool = True  # write pages with plots


def check(args: Args) -> tuple[list[Condition], Settings]:
    """Conditions and settings. Raises ValueError for invalid arguments, OSError for the folder."""
    for name, least in (("episodes", 2), ("seed", 0), ("batch", 1)):
        if getattr(args, name) < least:
            raise ValueError(f"{name} = {getattr(args, name)}: must be at least {least}")
    for name in ("episodes", "batch"):
        if getattr(args, name) > MOST_EPISODES:
            raise ValueError(f"{name} = {getattr(args, name)}: must be at most {MOST_EPISODES}")
    kinds = {policy.partition("@")[0] for policy in args.policies}
    if args.against != Args.against and args.against.partition("@")[0] not in kinds:
        raise ValueError(f"against = {args.against!r}: must be one of policies = {args.policies}")
    check_engine(args.engine, args.workers, args.address)
    for name in ("policies", "plants", "references"):
        values = getattr(args, name)
        if not values or len(set(values)) < len(values):
            raise ValueError(f"{name} = {values}: must name at least one, and none twice")
    plants = [
        name
        for plant in args.plants
        for name in ([plant, plant + OUTSIDE] if args.outside and not plant.endswith(OUTSIDE) else [plant])
    ]
    for plant in plants:
        find_condition(plant)
    if args.rig is not None:  # a plant that is a family of rigs, and flies no other
        find_rig(args.rig)
        plants = [plant for plant in plants if nominal_rig(plant) in ("paper", args.rig)]
        if not plants:
            raise ValueError(f"plants = {args.plants}: must name one that flies the rig {args.rig!r}, like 'lab'")
    conditions = [Condition(plant, reference) for reference in args.references for plant in dict.fromkeys(plants)]
    settings = Settings(
        args.seed, args.episodes, args.batch, args.control_period, args.start_spread_deg, args.rig or ""
    )
    for condition in conditions:
        Heli3DOFEnv(**env_settings(condition, settings))
    check_folder("out", args.out)
    return conditions, settings


def digests_of(wanted: Sequence[Batch], settings: Settings) -> dict[str, str]:
    """Digests of the files that the flights of batches depend on, by the argument that names them."""
    found = {}
    for policy, condition in dict.fromkeys((batch.policy, batch.condition) for batch in wanted):
        rig = nominal_rig(condition.plant, settings.rig)
        found[f"policies = {policy!r} on the rig {rig!r}"] = policy_digest(policy, find_rig(rig))
        found[f"references = {condition.reference!r}"] = reference_digest(condition.reference)
    return {name: digest for name, digest in found.items() if digest}


def check_begun(args: Args, settings: Settings, digests: dict[str, str]) -> dict[str, str]:
    """Digests of the leaderboard in the folder, with new ones added.

    Raises ValueError if it has other settings, another version or other files, or if --resume is missing.
    """
    path = args.out / SETTINGS
    if not path.is_file():
        return digests
    if not args.resume:
        raise ValueError(f"out: {args.out} holds a leaderboard already; --resume goes on with it")
    try:
        begun = read_json_object(path)
        earlier = {name: begun[name] for name in Settings._fields if name not in Settings._field_defaults}
        known = {str(name): str(digest) for name, digest in begun.get("sha256", {}).items()}
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"out: {path} must hold the settings of a leaderboard: {error}") from error
    earlier = Settings._field_defaults | earlier | {"rig": begun.get("rig", ""), "version": begun.get("version")}
    for name, value in {**settings._asdict(), "version": version("heli-gym")}.items():
        if earlier[name] != value and name != "episodes":
            raise ValueError(f"{name} = {value!r}: the leaderboard in {args.out} was begun with {earlier[name]!r}")
    if settings.rig and begun.get("rig_toml") != find_rig(settings.rig).to_toml():
        raise ValueError(f"rig = {settings.rig!r}: has changed since the leaderboard in {args.out} was begun")
    for name, digest in digests.items():
        if known.get(name, digest) != digest:
            raise ValueError(f"{name}: has changed since the leaderboard in {args.out} was begun")
    return known | digests


def main(args: Args | None = None) -> None:
    """Run the command `heli-leaderboard`."""
    with command("heli-leaderboard"):
        run(args or parse(Args, "heli-leaderboard", __doc__))


def run(args: Args) -> None:
    """Fly the missing batches, then write and print the tables; an interrupt writes those of the flights so far."""
    conditions, settings = check(args)
    wanted, left_out = flyable(batches(args.policies, conditions, settings), settings)
    digests = check_begun(args, settings, digests_of(wanted, settings))
    flown_on = {batch.condition for batch in wanted}
    conditions = [condition for condition in conditions if condition in flown_on]
    if not conditions:
        raise ValueError(f"policies = {args.policies}: must name one that flies: {'; '.join(left_out)}")
    console = Console(width=None if sys.stdout.isatty() else 180)
    for reason in left_out:
        console.print(reason)
    ledger = Ledger(args.out)
    try:
        own = {"rig_toml": find_rig(settings.rig).to_toml()} if settings.rig else {}
        begun = {**settings._asdict(), **own, "version": version("heli-gym"), "sha256": digests}
        write_json(args.out / SETTINGS, begun)
        missing = ledger.keep_whole(wanted)
        try:
            if missing:
                with open_engine(args.engine, args.workers, args.address, finish=True) as engine:
                    fly_missing(wanted, missing, settings, ledger, engine, console)
        except KeyboardInterrupt:
            rows = ledger.rows(wanted)
            if rows:
                write_tables(args.out, rows)
            raise KeyboardInterrupt(f"{len(rows)} flights are in {args.out}; --resume goes on") from None
        rows = ledger.rows(wanted)
        for path in write_tables(args.out, rows):
            console.print(f"flights: {path}")
        tables = summarise(args, conditions, settings, rows)
        write_json(args.out / "leaderboard.json", {"settings": settings._asdict(), "tables": tables})
        write_text(args.out / "leaderboard.md", markdown(tables, settings))
        write_text(args.out / "leaderboard.html", page(tables, settings, args.pages))
        for table in tables:
            print_table(table, console)
        console.print(CAPTION)
        if args.pages:
            for condition, table in zip(conditions, tables):
                errors: dict[str, list[float]] = {}
                for row in rows:
                    if (row["plant"], row["reference"]) == condition:
                        errors.setdefault(row["policy"], []).append(row["rms_error_deg"])
                write_flights(args.out / page_name(condition), condition, table, settings, errors)
        console.print(f"written to {args.out}")
    finally:
        ledger.close()


def fly_missing(
    wanted: Sequence[Batch],
    missing: Sequence[Batch],
    settings: Settings,
    ledger: Ledger,
    engine: Engine,
    console: Console,
) -> None:
    """Fly the missing batches, with a progress bar."""
    total, left = (sum(batch.episodes for batch in part) for part in (wanted, missing))
    with progress_bar(console) as progress:
        bar = progress.add_task("flying", total=total, completed=total - left)
        for batch in fly_all(missing, settings, ledger, engine):
            progress.update(bar, advance=batch.episodes, description=f"{batch.policy} on {batch.condition.plant}")


def summarise(
    args: Args, conditions: Sequence[Condition], settings: Settings, rows: Sequence[dict[str, Any]]
) -> list[dict[str, Any]]:
    """One table per condition: standings, with time per step and required knowledge of each policy."""
    tables = []
    for condition in conditions:
        own = [row for row in rows if (row["plant"], row["reference"]) == condition]
        flown = {row["policy"] for row in own}
        tuned = policy_on(args.against, condition.plant, settings.rig)
        against = tuned if tuned in flown else tuned.partition("@")[0]
        entries = standings(own, against)
        for entry in entries:
            entry["microseconds_per_step"] = microseconds_per_step(entry["policy"], condition, settings)
            entry["must_know"] = label_of(entry["policy"]).needs
        compared = label_of(against).text if against in flown else ""
        tables.append({**condition._asdict(), "title": str(condition), "against": compared, "policies": entries})
    return tables


def write_flights(
    path: Path, condition: Condition, table: dict[str, Any], settings: Settings, errors: dict[str, list[float]]
) -> None:
    """Write a condition's page: the best policies and the compared one, on the best one's median and worst draw."""
    entries = table["policies"]
    chosen = [entry["policy"] for entry in entries[:ON_A_PAGE]]
    own = env_settings(condition, settings)
    env, envs = Heli3DOFEnv(**own), Heli3DOFVectorEnv(1, **own)
    shown = []
    for name in ("worst", "median"):
        seed = entries[0][f"{name}_seed"]
        envs.reset(seed=seed)
        pilots = {p: pilot_for(p, condition, settings.control_period, settings.rig) for p in chosen}
        flights = {p: fly(env, pilot, seed=seed) for p, pilot in pilots.items()}
        label = f"{name} draw of {entries[0]['label']}, seed {seed}"
        shown.append(Shown(label, flights, describe_draw(env.plant, envs.plant_of(0))))
    names = columns_of(table)
    write_report(
        path,
        title=str(condition),
        table={
            "title": heading(table),
            "caption": CAPTION,
            "columns": names,
            "rows": [[row[0], entry["policy"], *row[2:]] for entry in entries for row in [cells(entry)]],
        },
        reference=own["reference"],
        shown=shown,
        errors=errors,
    )


def write_json(path: Path, value: Any) -> None:
    """Write a value as JSON, atomically."""
    write_text(path, json.dumps(value, indent=1) + "\n")


def write_text(path: Path, text: str) -> None:
    """Write text, atomically."""
    with atomic_write(path) as file:
        file.write(text.encode())


if __name__ == "__main__":
    main()
