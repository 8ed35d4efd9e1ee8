"""Damaged and hostile files: each a named error or an identical load, without large allocations."""

import collections
import hashlib
import io
import json
import random
import re
import resource
import tempfile
import warnings
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from heli_gym import Maneuver, Trajectory
from heli_gym.baselines import plan
from heli_gym.baselines.control.residual import LEARNED, Network, load_learned
from heli_gym.baselines.control.weights import stored
from heli_gym.baselines.evaluation.agents import load_onnx, load_sb3
from heli_gym.baselines.evaluation.leaderboard import Batch, Condition, Ledger, Settings, fly_batch, line_of, standings
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.log_quantities import read_mapping
from heli_gym.rig import RIGS, Rig
from heli_gym.storage import read_json_object

MUTATIONS, SHARE = 1000, 1.0
MOST_BYTES = 2**29  # growth of the process's peak memory
HOSTILE = (
    '{"a":' * 100_000 + "1" + "}" * 100_000,
    "[" * 100_000,
    "a = " + "[" * 100_000,
    "NaN",
    "null",
    "[]",
    '"text"',
    "1e999",
    "9" * 10_000,
    "\0" * 1000,
    "\ud800".encode("utf-8", "surrogatepass").decode("latin1"),
    "../../../../etc/passwd",
    "<script>alert(1)</script>",
)
VALUES = (None, True, -1, 0, 1e308, float("nan"), float("inf"), "x", "../../x", [], {}, [[1]], 10**30, "9" * 1000)


class Artifact(NamedTuple):
    """Kind of file: its bytes by file name, the file to damage, and a function that loads it and returns a digest."""

    name: str
    files: dict[str, bytes]
    target: str
    load: Callable[[Path], str]
    has_digest: bool  # whether a change of one bit must be noticed


def digest(*parts: Any) -> str:
    """SHA-256 of arrays and values."""
    found = hashlib.sha256()
    for part in parts:
        found.update(np.asarray(part).tobytes() if isinstance(part, np.ndarray) else repr(part).encode())
    return found.hexdigest()


def load_trajectory(path: Path) -> str:
    one = Trajectory.load(path)
    return digest(one.t, one.x, one.u, one.limits, one.rig.to_toml())


def load_policy(path: Path) -> str:
    settings, network = load_learned(path)
    return digest(settings, repr(network))


def load_log(path: Path) -> str:
    log = FlightLog.load(path)
    return digest(log.t, log.angles, log.voltages)


def load_agent(path: Path) -> str:
    agent = load_sb3(str(path)) if path.suffix == ".zip" else load_onnx(str(path))
    return digest(agent.act(np.linspace(-1, 1, 96).reshape(2, 48)))


def load_weights(path: Path) -> str:
    before = stored.TUNED
    stored.TUNED = path.parent
    try:
        return digest([stored.stored_weights(name, "lab") for name in ("lqi", "feedforward+tvlqr", "kalman-lqr")])
    finally:
        stored.TUNED = before


def load_ledger(path: Path) -> str:
    """Rows of the flights that are whole: a ledger loses damaged lines, which fly again."""
    ledger = Ledger(path.parent.parent)
    try:
        rows = ledger.read("zero", Condition("lab", "climb-15"))
        return digest(sorted(rows), standings(list(rows.values()), "zero"))
    finally:
        ledger.close()


def load_checkpoint(path: Path) -> str:
    from heli_gym.train.checkpoint import last_checkpoint

    state = last_checkpoint(path.parent)
    return digest(state["weights"].numpy(), state["steps"]) if state else "none"


def load_study(path: Path) -> str:
    from heli_gym.train.study import read_study

    return digest(read_study(path))


def sb3_file(folder: Path) -> bytes:
    """Small PPO model in the format of Stable-Baselines3, made without training."""
    import gymnasium as gym
    from stable_baselines3 import PPO

    PPO("MlpPolicy", gym.make("heli_gym:Heli3DOF-v0"), n_steps=8, batch_size=8, seed=0).save(folder / "model.zip")
    return (folder / "model.zip").read_bytes()


def artifacts(folder: Path) -> list[Artifact]:
    """All kinds of files that can be made with the packages that are installed."""
    plan(Maneuver(duration=20.0), "flat").save(folder / "plan.npz")
    plan_bytes = (folder / "plan.npz").read_bytes()
    t = np.arange(0.0, 3.0, 0.02)
    log = FlightLog(t, np.zeros((3, len(t))) + 0.01 * np.sin(t), np.full((2, len(t)), 6.0))
    log.save(folder / "log.csv")
    settings = Settings(0, 6, 6, 0.02, 5.0)
    lines = b"".join(map(line_of, fly_batch(Batch("zero", Condition("lab", "climb-15"), 0, 6), settings)))
    ledger = Ledger(folder)
    name = ledger.path("zero", Condition("lab", "climb-15")).name
    ledger.close()
    learned = {f"lab{suffix}": (LEARNED / f"lab{suffix}").read_bytes() for suffix in (".json", ".safetensors")}
    tuned = {"lab.json": (stored.TUNED / "lab.json").read_bytes()}
    mapping = b'[columns]\ntravel = "a"\n[signs]\ntravel = -1\n[units]\nt = "ms"\n'
    found = [
        Artifact("plan", {"plan.npz": plan_bytes}, "plan.npz", load_trajectory, False),
        Artifact(
            "rig", {"r.toml": (RIGS / "quanser.toml").read_bytes()}, "r.toml", lambda p: Rig.load(p).to_toml(), False
        ),
        Artifact("log", {"log.csv": (folder / "log.csv").read_bytes()}, "log.csv", load_log, False),
        Artifact("log mapping", {"m.toml": mapping}, "m.toml", lambda p: digest(read_mapping(p)), False),
        Artifact("learned policy: settings", learned, "lab.json", load_policy, True),
        Artifact("learned policy: network", learned, "lab.safetensors", load_policy, True),
        Artifact("tuned weights", tuned, "lab.json", load_weights, False),
        Artifact(
            "settings", {"s.json": b'{"seed": 1, "a": [1, 2]}'}, "s.json", lambda p: digest(read_json_object(p)), False
        ),
        Artifact("leaderboard", {f"flights/{name}": lines}, f"flights/{name}", load_ledger, False),
    ]
    try:
        from scipy.io import savemat

        savemat(folder / "log.mat", {"t": t, "travel": t, "elevation": t, "pitch": t, "u_front": t, "u_back": t})
        found.append(Artifact("MATLAB log", {"l.mat": (folder / "log.mat").read_bytes()}, "l.mat", load_log, False))
        import h5py

        with h5py.File(folder / "log73.mat", "w", userblock_size=512) as file:
            for key in ("t", "travel", "elevation", "pitch", "u_front", "u_back"):
                file[key] = t
        found.append(Artifact("HDF5 log", {"l.mat": (folder / "log73.mat").read_bytes()}, "l.mat", load_log, False))
    except ImportError as error:
        print(f"left out: {error}")
    try:
        import torch

        from heli_gym.train.checkpoint import save_checkpoint

        for number in (1, 2):
            save_checkpoint(folder / "c", number, {"weights": torch.arange(100.0), "steps": number})
        files = {f"c/{path.name}": path.read_bytes() for path in (folder / "c").iterdir()}
        found.append(Artifact("checkpoint", files, "c/000002.safetensors", load_checkpoint, True))
        found.append(Artifact("Stable-Baselines3 model", {"m.zip": sb3_file(folder)}, "m.zip", load_agent, False))
        study = b'[settings]\nplant = "lab"\nsteps = 100000\n[grid]\nseed = [0, 1]\n'
        found.append(Artifact("study", {"s.toml": study}, "s.toml", load_study, False))
        from heli_gym.train.export_onnx import onnx_model

        rng = np.random.default_rng(0)
        layers = tuple(rng.standard_normal(shape) for shape in ((8, 48), (2, 8)))
        model = onnx_model(Network(layers, (np.zeros(8), np.zeros(2)), True)).SerializeToString()
        found.append(Artifact("ONNX network", {"n.onnx": model}, "n.onnx", load_agent, False))
    except ImportError as error:
        print(f"left out: {error}")
    return found


def mutate(data: bytes, rng: random.Random) -> bytes:
    """Random damage of bytes, or of the structure of an archive or a text."""
    kind = rng.randrange(12)
    n = len(data)
    at = rng.randrange(n)
    if kind == 0:
        changed = bytearray(data)
        changed[at] ^= 1 << rng.randrange(8)
        return bytes(changed)
    if kind == 1:
        return data[:at]
    if kind == 2:
        length = rng.randrange(1, max(n // 2, 2))
        return data[:at] + data[at + length :]
    if kind == 3:
        length = rng.randrange(1, 200)
        return data[:at] + bytes(length) + data[at + length :]
    if kind == 4:
        return data[:at] + rng.randbytes(rng.randrange(1, 100)) + data[at:]
    if kind == 5:
        return rng.randbytes(rng.randrange(2000))
    if kind == 6:
        return rng.choice(HOSTILE).encode("utf-8", "replace")
    if kind == 7:
        return rng.choice(FOREIGN)
    if data[:2] == b"PK":
        return mutated_archive(data, rng)
    return mutated_text(data, rng)


FOREIGN: list[bytes] = []  # files of the other kinds


def mutated_archive(data: bytes, rng: random.Random) -> bytes:
    """Archive with another shape, dtype, name or content of a member, or with a member that expands to much."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as new:
        names = old.namelist()
        victim = rng.choice(names)
        kind = rng.randrange(6)
        for name in names:
            content = old.read(name)
            if name == victim:
                if kind == 0:
                    continue
                if kind == 1:
                    name = rng.choice(("../../escaped", "/tmp/escaped", "t.npy", "x" * 300, "policy.pth"))
                elif kind == 2:
                    content = content.replace(b"(", b"(99999999999, ", 1)
                elif kind == 3:
                    content = content.replace(b"<f8", rng.choice((b"|O8", b"<c8", b"<U2", b"<f2")), 1)
                elif kind == 4:
                    with new.open(name, "w", force_zip64=True) as member:
                        for _ in range(3 * 2**8):
                            member.write(bytes(2**20))
                    continue
                else:
                    content = mutate(content, rng) if content else b"x"
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                new.writestr(name, content)
    return buffer.getvalue()


def mutated_text(data: bytes, rng: random.Random) -> bytes:
    """Text with another value in place of a number or word; JSON with another value of a key."""
    try:
        value = json.loads(data)
        keys = list(value)
        key = rng.choice(keys)
        where = value
        while isinstance(where[key], dict) and where[key] and rng.random() < 0.7:
            where = where[key]
            key = rng.choice(list(where))
        if rng.random() < 0.2:
            del where[key]
        else:
            where[rng.choice((key, "unknown"))] = rng.choice(VALUES)
        return json.dumps(value).encode()
    except Exception:
        words = data.split(b" ") if data.count(b" ") > 5 else data.split(b",")
        words[rng.randrange(len(words))] = str(rng.choice(VALUES)).encode()
        return (b" " if data.count(b" ") > 5 else b",").join(words)


def attempt(artifact: Artifact, data: bytes, folder: Path, whole: str) -> str:
    """Outcome of loading the damaged file."""
    for name, content in artifact.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data if name == artifact.target else content)
    before = set(folder.rglob("*"))
    try:
        loaded = artifact.load(folder / artifact.target)
    except (ValueError, OSError) as error:
        if not re.search(rf"(?<!\w){re.escape(Path(artifact.target).name)}(?!\w)", str(error)):
            return f"error without the file's name: {error}"
        outcome = "named error"
    except BaseException as error:
        return f"{type(error).__name__}: {error}"
    else:
        outcome = "identical" if loaded == whole else "other valid content"
        if outcome != "identical" and artifact.has_digest and artifact.name != "checkpoint":
            outcome = "changed content accepted"
    after = {path for path in folder.rglob("*") if ".lock" not in path.name}
    return outcome if after <= before and not Path("/tmp/escaped").exists() else "wrote files"


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    rng, bad = random.Random(seed), 0
    with tempfile.TemporaryDirectory() as place, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        made = Path(place) / "made"
        made.mkdir()
        kinds = [kind for kind in artifacts(made) if only in kind.name]
        FOREIGN.extend(content for kind in kinds for content in kind.files.values())
        wholes = []
        for k, kind in enumerate(kinds):
            folder = Path(place) / f"whole{k}"
            for name, content in kind.files.items():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_bytes(content)
            wholes.append(kind.load(folder / kind.target))
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        count = 5 if quick else int(-(-SHARE * MUTATIONS // len(kinds)))
        for k, (kind, whole) in enumerate(zip(kinds, wholes)):
            found: collections.Counter = collections.Counter()
            for number in range(count):
                folder = Path(place) / f"{k}-{number}"
                folder.mkdir()
                found[attempt(kind, mutate(kind.files[kind.target], rng), folder, whole)[:160]] += 1
            faults = {o: n for o, n in found.items() if o not in ("named error", "identical", "other valid content")}
            bad += sum(faults.values())
            counts = ", ".join(
                f"{found[o]} {o}" for o in ("named error", "identical", "other valid content") if found[o]
            )
            print(f"{kind.name}: {count} mutations: {counts}; {sum(faults.values())} faults")
            for outcome, n in faults.items():
                print(f"    {n} x {outcome}")
        growth = 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - peak)
    print(f"growth of the peak memory: {growth / 2**20:.0f} MB; at most {MOST_BYTES >> 20} MB")
    return int(bad > 0 or growth > MOST_BYTES)
