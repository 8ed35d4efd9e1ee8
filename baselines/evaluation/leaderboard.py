"""Leaderboards: policies x plants x maneuvers x draws, flown by several processes into one folder, and standings.

Every flight is a line of a file `flights/POLICY--PLANT--MANEUVER.jsonl`; only one process appends to it. After a kill,
only the incomplete batches are flown again, and no flight counts twice.
"""

import contextlib
import hashlib
import json
import os
import re
import sys
import time
from collections.abc import Iterator, Sequence
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.policies import is_learned
from heli_gym.baselines.control.weights import tuned_name
from heli_gym.baselines.evaluation.agents import make_pilot
from heli_gym.baselines.evaluation.conditions import OUTSIDE, find_condition, nominal_rig
from heli_gym.baselines.evaluation.engine import Engine
from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.baselines.evaluation.scoring import FlightTable, flies_together, score_episodes
from heli_gym.baselines.evaluation.statistics import (
    bootstrapped_means,
    interquartile_mean,
    interval,
    probability_of_improvement,
    rank_crashes_last,
    ranks,
)
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.rig import find_rig
from heli_gym.storage import atomic_write, parse_json, try_lock
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number

TIMED_STEPS = 100
SHOWN = ("rms_error_deg", "rms_travel_deg", "rms_elevation_deg", "cost")


class Condition(NamedTuple):
    """Plant and maneuver of a table."""

    plant: str
    reference: str

    def __str__(self) -> str:
        return f"{self.reference} on {self.plant}"


class Batch(NamedTuple):
    """Episodes of a policy that one process flies together."""

    policy: str
    condition: Condition
    seed: int  # of the first episode
    episodes: int


class Settings(NamedTuple):
    """Common settings of all flights in a leaderboard."""

    seed: int
    episodes: int
    batch: int
    control_period: float
    start_spread_deg: float
    rig: str = ""  # name or .toml file of the nominal rig; by default each plant's own


def policy_on(name: str, plant: str, rig: str = "") -> str:
    """Policy name with @PLANT replaced by the plant, or removed if no weights are stored for it on the rig."""
    return tuned_name(name, plant.removesuffix(OUTSIDE), find_rig(nominal_rig(plant, rig)))


def batches(policies: Sequence[str], conditions: Sequence[Condition], settings: Settings) -> list[Batch]:
    """All batches, with the first batch of every policy at the front, so that errors appear early."""
    pairs = [
        (name, condition)
        for condition in conditions
        for name in dict.fromkeys(policy_on(policy, condition.plant, settings.rig) for policy in policies)
    ]
    return [
        Batch(*pair, settings.seed + first, min(settings.batch, settings.episodes - first))
        for first in range(0, settings.episodes, settings.batch)
        for pair in pairs
    ]


# One process


@lru_cache(maxsize=64)
def pilot_for(policy: str, condition: Condition, control_period: float, rig: str) -> Any:
    """Pilot for a policy and a condition, made once in each process."""
    settings = Settings(0, 1, 1, control_period, 0.0, rig)
    env = Heli3DOFEnv(**env_settings(condition, settings))
    return make_pilot(policy, env.reference, control_period, env.voltage_limits)


@lru_cache
def reference_on(reference: str, rig: str) -> Trajectory:
    """Reference for a rig; if the packaged one is for another rig, each process plans it once."""
    return reference_for(reference, rig)


def env_settings(condition: Condition, settings: Settings) -> dict[str, Any]:
    """Arguments of the environment for a condition."""
    rig = nominal_rig(condition.plant, settings.rig)
    return {
        "plant": find_condition(condition.plant),
        "reference": reference_on(condition.reference, rig),
        "rig": rig,
        "control_period": settings.control_period,
        "start_spread_deg": settings.start_spread_deg,
    }


def fly_batch(batch: Batch, settings: Settings) -> list[dict[str, Any]]:
    """Fly a batch and return its rows."""
    pilot = pilot_for(batch.policy, batch.condition, settings.control_period, settings.rig)
    rows = score_episodes(pilot, env_settings(batch.condition, settings), batch.seed, batch.episodes)
    names = {"policy": batch.policy, **batch.condition._asdict()}
    return [{**names, **row, "within_limits": row["cost"] < 1e-9} for row in rows]


def microseconds_per_step(policy: str, condition: Condition, settings: Settings) -> float:
    """Median processor time in µs of a policy's step for one helicopter on this machine."""
    pilot = pilot_for(policy, condition, settings.control_period, settings.rig)
    env = Heli3DOFEnv(**env_settings(condition, settings))
    observation, info = env.reset(seed=0)
    pilot.reset(np.random.default_rng(0))
    seconds = []
    for _ in range(TIMED_STEPS):
        began = time.process_time()
        if hasattr(pilot, "act"):
            action = pilot.act(observation[None])[0]
        else:
            u = pilot(info["time"], info["measurement"])
        seconds.append(time.process_time() - began)
        observation, _, terminated, truncated, info = env.step(action if hasattr(pilot, "act") else env.to_action(u))
        if terminated or truncated:
            break
    return 1e6 * float(np.median(seconds))


# The folder


class Ledger:
    """Stored rows of a leaderboard in a folder; an open ledger locks the folder against other processes."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "flights").mkdir(parents=True, exist_ok=True)
        self.lock = open(folder / ".lock", "ab")  # noqa: SIM115
        if not try_lock(self.lock):
            self.lock.close()
            raise ValueError(f"out = {str(folder)!r}: another heli-leaderboard is flying into this folder")

    def close(self) -> None:
        """Release the lock of the folder."""
        self.lock.close()

    def path(self, policy: str, condition: Condition) -> Path:
        """File of a policy's flights, with a readable and unique name."""
        name = "--".join((policy, *condition))
        digest = hashlib.sha256(name.encode()).hexdigest()[:8]
        readable = re.sub(r"[^\w.+@-]+", "_", name)[-120:]
        return self.folder / "flights" / f"{readable}--{digest}.jsonl"

    def read(self, policy: str, condition: Condition) -> dict[int, dict[str, Any]]:
        """Complete rows in a file, by seed."""
        path = self.path(policy, condition)
        rows: dict[int, dict[str, Any]] = {}
        if path.is_file():
            for line in path.read_bytes().split(b"\n"):
                with contextlib.suppress(ValueError, KeyError, TypeError):  # a line that a kill cut off
                    row = parse_json(line)
                    if is_row(row, policy, condition):
                        rows.setdefault(row["seed"], row)
        return rows

    def keep_whole(self, wanted: Sequence[Batch]) -> list[Batch]:
        """Remove the rows of incomplete batches from the files, and return the batches still to fly."""
        missing = []
        for policy, condition in dict.fromkeys((batch.policy, batch.condition) for batch in wanted):
            own = [batch for batch in wanted if (batch.policy, batch.condition) == (policy, condition)]
            rows = self.read(policy, condition)
            incomplete = [b for b in own if any(b.seed + k not in rows for k in range(b.episodes))]
            missing += incomplete
            partial = {batch.seed + k for batch in incomplete for k in range(batch.episodes)}
            path = self.path(policy, condition)
            complete = b"".join(line_of(row) for seed, row in rows.items() if seed not in partial)
            if path.is_file() and path.read_bytes() != complete:
                with atomic_write(path) as file:
                    file.write(complete)
        order = {batch: k for k, batch in enumerate(wanted)}
        return sorted(missing, key=order.__getitem__)

    def append(self, batch: Batch, rows: Sequence[dict[str, Any]]) -> None:
        """Append the rows of a batch to its file, and flush it to the disk."""
        with open(self.path(batch.policy, batch.condition), "ab") as file:
            file.write(b"".join(map(line_of, rows)))
            file.flush()
            os.fsync(file.fileno())

    def rows(self, wanted: Sequence[Batch]) -> list[dict[str, Any]]:
        """Stored rows of batches, in order."""
        found = []
        for policy, condition in dict.fromkeys((batch.policy, batch.condition) for batch in wanted):
            seeds = {
                b.seed + k for b in wanted if (b.policy, b.condition) == (policy, condition) for k in range(b.episodes)
            }
            rows = self.read(policy, condition)
            found += [rows[seed] for seed in sorted(seeds & set(rows))]
        return found


def is_row(row: dict[str, Any], policy: str, condition: Condition) -> bool:
    """Whether a value is a whole row of a policy's flight: names of columns, types, and finite numbers."""
    names = {"policy": policy, **condition._asdict()}
    flags, numbers = ("crashed", "success", "within_limits"), ("rms_error_deg", "rms_travel_deg", "rms_elevation_deg")
    return (
        {name: row[name] for name in names} == names
        and type(row["seed"]) is int
        and all(isinstance(row[name], bool) for name in flags)
        and all(is_number(row[name]) for name in (*numbers, "cost"))
    )


def line_of(row: dict[str, Any]) -> bytes:
    """Encode a row as one line of JSON."""
    return json.dumps(row, allow_nan=False).encode() + b"\n"


# All


def fly_all(missing: Sequence[Batch], settings: Settings, ledger: Ledger, engine: Engine) -> Iterator[Batch]:
    """Fly and store batches, and yield each batch once its rows are stored."""
    for index, rows in engine.results(partial(fly_batch, settings=settings), missing):
        ledger.append(missing[index], rows)
        yield missing[index]


def write_tables(folder: Path, rows: list[dict[str, Any]]) -> list[Path]:
    """Write all rows to flights.csv and, with pyarrow, flights.parquet; return the paths."""
    paths = [folder / "flights.csv"]
    FlightTable(rows).to_csv(paths[0])
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        print("heli-leaderboard: without pyarrow there is no flights.parquet", file=sys.stderr)
        return paths
    paths.append(folder / "flights.parquet")
    with atomic_write(paths[1]) as file:
        pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows), file)
    return paths


def standings(rows: Sequence[dict[str, Any]], against: str) -> list[dict[str, Any]]:
    """One entry per policy, the best first, from flights of one condition on the same draws.

    The rank follows the interquartile mean of the RMS distance from the reference in travel and elevation; a crash
    counts as the worst flight. The interval of a rank comes from paired resamples of the draws.
    """
    by_policy: dict[str, dict[int, dict[str, Any]]] = {}
    for row in rows:
        by_policy.setdefault(row["policy"], {})[row["seed"]] = row
    if not by_policy:
        return []
    common = sorted(set.intersection(*(set(flights) for flights in by_policy.values())))
    if not common:
        return []
    names = list(by_policy)
    crashed = np.array([[by_policy[name][seed]["crashed"] for seed in common] for name in names])
    values = {
        key: np.array([[by_policy[name][seed][key] for seed in common] for name in names], float)
        for key in (*SHOWN, "success", "within_limits")
    }
    ranked = {key: np.array([rank_crashes_last(row, c) for row, c in zip(values[key], crashed)]) for key in SHOWN}
    bootstrapped = {key: bootstrapped_means(ranked[key]) for key in SHOWN}
    orders = ranks(bootstrapped["rms_error_deg"])
    rank = ranks(np.array([interquartile_mean(row) for row in ranked["rms_error_deg"]]))
    paper = names.index(against) if against in names else None
    table = []
    for k, name in enumerate(names):
        entry: dict[str, Any] = {"policy": name, "label": label_of(name).text, "draws": len(common)}
        entry["rank"] = {"value": float(rank[k]), "interval": interval(orders[:, k])}
        for key in SHOWN:
            entry[key] = {"iqm": interquartile_mean(ranked[key][k]), "interval": interval(bootstrapped[key][:, k])}
        entry |= {key: float(values[key][k].mean()) for key in ("success", "within_limits")}
        entry["crashed"] = float(crashed[k].mean())
        entry["probability_of_improvement"] = (
            None
            if paper is None
            else probability_of_improvement(
                values["rms_error_deg"][[k]],
                values["rms_error_deg"][[paper]],
                crashed[[k]],
                crashed[[paper]],
            )
        )
        order = np.argsort(np.where(crashed[k], np.inf, values["rms_error_deg"][k]), kind="stable")
        entry["median_seed"], entry["worst_seed"] = common[order[len(common) // 2]], common[order[-1]]
        table.append(entry)
    return sorted(table, key=lambda entry: (entry["rank"]["value"], entry["policy"]))


def flyable(wanted: Sequence[Batch], settings: Settings) -> tuple[list[Batch], list[str]]:
    """Batches that can be flown, and reasons why others cannot: networks for another rig.

    Every policy is made once in this process, so that its errors appear before the first flight. A policy that flies
    one helicopter at a time has batches of a single episode, so that a kill repeats one flight only.
    """
    alone: set[tuple[str, Condition]] = set()
    refused: dict[tuple[str, Condition], str] = {}
    for policy, condition in dict.fromkeys((batch.policy, batch.condition) for batch in wanted):
        if is_learned(policy) and settings.control_period != 0.02:
            raise ValueError(f"policies: {policy!r} was trained for 0.02 s, not {settings.control_period:g} s")
        try:
            pilot = pilot_for(policy, condition, settings.control_period, settings.rig)
            if not flies_together(pilot, env_settings(condition, settings)["reference"]):
                alone.add((policy, condition))
        except ValueError as error:
            if nominal_rig(condition.plant, settings.rig) == "paper" or not is_learned(policy):
                raise
            refused[policy, condition] = f"{policy} is left out on {condition.plant}: {error}"
    flown = [
        part
        for batch in wanted
        if (batch.policy, batch.condition) not in refused
        for part in (single_episodes(batch) if (batch.policy, batch.condition) in alone else [batch])
    ]
    return flown, list(refused.values())


def single_episodes(batch: Batch) -> list[Batch]:
    """The batch as batches of one episode each."""
    return [batch._replace(seed=batch.seed + k, episodes=1) for k in range(batch.episodes)]
