"""SHA-256 of flights in one process, in subprocesses of each kind, alone and together, with threads, on another CPU."""

import hashlib
import json
import multiprocessing
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import flights
import numpy as np

HERE = Path(__file__).parent


def in_process(method: str) -> dict[str, str]:
    """Digests of the flights in a process of this kind."""
    with multiprocessing.get_context(method).Pool(1) as pool:
        return pool.map(flights.all_flights, [None])[0]


def run_alone(**environment: str) -> dict:
    """What `flights` prints in a new process with these environment variables."""
    env = {**os.environ, **environment}
    done = subprocess.run([sys.executable, HERE / "flights.py"], capture_output=True, text=True, env=env, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def weights_of_training(folder: Path, name: str) -> str:
    """Digest of the network after a short training in a new process."""
    arguments = ["--steps", "38400", "--chunk", "100", "--cell", "8", "--validation", "4"]
    code = "import sys; sys.argv = ['heli-train', *sys.argv[1:]]; from heli_gym import cli; cli.run('heli-train')"
    out = folder / name
    subprocess.run(
        [sys.executable, "-c", code, *arguments, "--out", str(out), "--no-progress"], check=True, capture_output=True
    )
    [best] = out.rglob("best.safetensors")
    return hashlib.sha256(best.read_bytes()).hexdigest()


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    own, bad = flights.all_flights(), 0

    def compare(title: str, found: dict[str, str]) -> None:
        nonlocal bad
        different = [name for name in found if found[name] != own[name]]
        bad += len(different)
        print(f"{title}: {len(found) - len(different)} of {len(found)} digests are equal {different or ''}")

    for name, digest in own.items():
        print(f"{digest[:16]}  {name}")
    compare("once more in this process", flights.all_flights())
    for method in ("fork", "forkserver", "spawn"):
        compare(f"in a process by {method}", in_process(method))
    for threads in (1, 2):
        for plant in flights.PLANT_NAMES:
            compare(f"{plant}, {threads} threads", {f"{plant}, vector": flights.together(plant, threads)})
    chosen = (0, flights.COUNT - 1) if quick else range(flights.COUNT)
    for plant in flights.PLANT_NAMES:
        same = sum(flights.single(plant, j) == flights.together(plant, 1, j=j) for j in chosen)
        bad += same < len(chosen)
        print(f"{plant}: {same} of {len(chosen)} flights alone are those in a vector environment, bit for bit")
    if not quick:
        with tempfile.TemporaryDirectory() as folder:
            first, second = (weights_of_training(Path(folder), name) for name in ("a", "b"))
        bad += first != second
        print(f"training twice: {'equal' if first == second else 'DIFFERENT'} weights, {first[:16]}")
        with tempfile.TemporaryDirectory() as cache:
            generic = run_alone(NUMBA_CPU_NAME="generic", NUMBA_CPU_FEATURES="", NUMBA_CACHE_DIR=cache)
        apart = np.abs(np.array(generic["states"]) - flights.states()).max(axis=1)
        equal = sum(generic["digests"][name] == own[name] for name in own)
        print(
            f"code for a generic CPU: {equal} of {len(own)} digests are equal; states after {flights.STEPS} steps are"
        )
        for plant, distance in zip(flights.PLANT_NAMES, apart):
            print(f"    {distance:.1e} rad or rad/s apart on {plant}")
        bad += not apart.max() < 1e-6
    return int(bad > 0)
