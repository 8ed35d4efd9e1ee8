"""kill -9 at random moments of training, leaderboard, tuning and sweep: each resumes to the results of a quiet run."""

import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from heli_gym.baselines.control.weights.stored import TUNED

MOMENTS, SHARE = 100, 1.0
CODE = (
    "import sys, numba; from pathlib import Path; sys.argv[0] = sys.argv.pop(1);"
    "from heli_gym.baselines.control.weights import stored; stored.TUNED = Path(sys.argv.pop(1)) / 'tuned';"
    "from heli_gym import cli; cli.run(sys.argv[0])"
)


class Job(NamedTuple):
    """Command whose results a kill must not change."""

    program: str
    arguments: str
    resume: str  # argument that continue it
    results: Callable[[Path], str]  # digest of what it leaves


def digest_of(folder: Path, *patterns: str) -> str:
    """SHA-256 of the files that match, by their names."""
    found = hashlib.sha256()
    for path in sorted(path for pattern in patterns for path in folder.rglob(pattern)):
        found.update(str(path.relative_to(folder)).encode() + path.read_bytes())
    return found.hexdigest()


def rows_of(folder: Path) -> str:
    """SHA-256 of all flights in a leaderboard; raises ValueError for a flight that is there twice."""
    rows = [line for path in sorted(folder.rglob("*.jsonl")) for line in path.read_text().splitlines()]
    keys = [tuple(json.loads(row)[name] for name in ("policy", "plant", "reference", "seed")) for row in rows]
    if len(set(keys)) < len(keys):
        raise ValueError("a flight is there twice")
    return hashlib.sha256("\n".join(sorted(rows)).encode()).hexdigest()


TRAINING = "--chunk 100 --cell 8 --validation 4 --no-progress"
STUDY = """[settings]
chunk = 100
cell = 8
validation = 4
steps = 25600
[grid]
seed = [0, 1]
"""
TRAIN = f"--steps 64000 {TRAINING} --out out"
FLY = (
    "--plants lab --policies zero lqi kalman-lqr --episodes 40 --batch 4 --references climb-7.5 --no-pages "
    "--workers 1 --out out"
)
TUNE = "--policy lqi --plants lab --draws 2 --candidates 20 --population 5 --reference climb-7.5 --store"
SWEEP = "study.toml --out out"
JOBS = {
    "training": Job("heli-train", TRAIN, "--resume", lambda folder: digest_of(folder, "best.safetensors", "best.json")),
    "leaderboard": Job("heli-leaderboard", FLY, "--resume", rows_of),
    "tuning": Job("heli-tune", TUNE, "", lambda folder: digest_of(folder, "tuned/*.json")),
    "sweep": Job(
        "heli-sweep", "study.toml --out out", "--resume", lambda folder: digest_of(folder, "best.safetensors")
    ),
}


def start(job: Job, folder: Path, more: str = "") -> subprocess.Popen:
    """Start the command in a group of its own."""
    (folder / "study.toml").write_text(STUDY)
    (folder / "tuned").mkdir(exist_ok=True)
    if not (folder / "tuned" / "lab.json").exists():
        shutil.copy(TUNED / "lab.json", folder / "tuned")
    return subprocess.Popen(
        [sys.executable, "-c", CODE, job.program, str(folder), *job.arguments.split(), *more.split()],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
        text=True,
        env={**os.environ, "COLUMNS": "200"},
    )


def finish(job: Job, folder: Path, more: str = "") -> tuple[str, float]:
    """Run the command to its end; its results, and the time in s."""
    began = time.monotonic()
    process = start(job, folder, more)
    _, said = process.communicate()
    if process.returncode:
        raise RuntimeError(f"{job.program}: status {process.returncode}: {said.strip()[-300:]}")
    return job.results(folder), time.monotonic() - began


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    bad, rng = 0, random.Random(seed)
    jobs = {name: job for name, job in JOBS.items() if only in ("", name)}
    if quick and not only:  # tests/train kills and interrupts training and sweeps
        jobs = {name: jobs[name] for name in ("leaderboard", "tuning")}
    for name, job in jobs.items():
        with tempfile.TemporaryDirectory() as place:
            quiet = Path(place) / "quiet"
            quiet.mkdir()
            finish(job, quiet)
            again = Path(place) / "again"
            again.mkdir()
            whole, took = finish(job, again)
            moments = 1 if quick else max(int(SHARE * MOMENTS / len(JOBS)), 1)
            runs = equal = killed = 0
            while killed < moments and runs < 4 * moments:  # a kill may come after the end
                folder = Path(place) / str(runs)
                folder.mkdir()
                runs += 1
                # up to three kills of one run, at any moment from its start on
                for attempt in range(min(rng.randrange(1, 4), moments - killed)):
                    process = start(job, folder, job.resume if attempt else "")
                    try:
                        process.wait(rng.uniform(0.1, 1.0) * took)
                    except subprocess.TimeoutExpired:
                        os.killpg(process.pid, signal.SIGKILL)
                        process.wait()
                        killed += 1
                try:
                    found, _ = finish(job, folder, job.resume)
                    equal += found == whole
                    if found != whole:
                        print(f"    {name} {runs}: other results")
                except (RuntimeError, ValueError) as error:
                    print(f"    {name} {runs}: {error}")
                shutil.rmtree(folder)
            bad += equal != runs
            print(f"{name}: {killed} kills in {runs} runs; {equal} of {runs} resumed to the same results")
            sys.stdout.flush()
    return int(bad > 0)
