"""Caches of compiled functions: shared at the start, unwritable, damaged. The flight takes place, with one warning."""

import importlib.util
import os
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import heli_gym

CODE = (
    "import hashlib, numpy as np; from heli_gym.env import Heli3DOFEnv; e = Heli3DOFEnv();"
    "o, i = e.reset(seed=1); s = [e.step(np.array([0.1, 0.2]))[4]['state'] for _ in range(20)];"
    "print(hashlib.sha256(np.array(s).tobytes()).hexdigest())"
)
NOBODY = 65534


def fly(cache: Path | None, **more: str) -> subprocess.Popen:
    """Start a process that flies with its cache in a folder."""
    environment = {name: value for name, value in os.environ.items() if name != "NUMBA_CACHE_DIR"} | more
    if cache is not None:
        environment["NUMBA_CACHE_DIR"] = str(cache)
    return subprocess.Popen(
        [sys.executable, "-W", "always", "-c", CODE],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        cwd="/",
    )


def outcome(process: subprocess.Popen) -> tuple[str, int, str]:
    """Digest of the flight, number of warnings on the cache, and all that was said on standard error."""
    out, said = process.communicate()
    return out.strip() if process.returncode == 0 else "failed", said.count("RuntimeWarning: the cache"), said


def fly_read_only(folder: Path) -> subprocess.Popen | None:
    """Fly from a read-only copy of the package, without HOME and not as root; None where that cannot be done."""
    folder.mkdir()
    site = folder / "site"
    package = Path(heli_gym.__file__).parent
    shutil.copytree(package, site / "heli_gym", ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("baselines", "train"):
        source = Path(importlib.util.find_spec(f"heli_gym.{name}").submodule_search_locations[0])
        shutil.copytree(source, site / "heli_gym" / name, ignore=shutil.ignore_patterns("__pycache__"))
    for path in (*site.rglob("*"), site):
        path.chmod(0o555 if path.is_dir() else 0o444)
    folder.chmod(0o755)
    libraries = [path for path in sys.path if path.endswith("site-packages")]
    environment = {"PATH": os.environ["PATH"], "PYTHONPATH": os.pathsep.join([str(site), *libraries])}
    user = NOBODY if os.getuid() == 0 else None
    system = f"/usr/bin/python3.{sys.version_info[1]}"
    for python in (sys.executable, system):
        arguments = {"env": environment, "cwd": "/", "user": user, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        try:
            code = "import sys, numba; sys.exit(not numba)"
            if subprocess.run([python, "-c", code], **arguments).returncode == 0:  # type: ignore[call-overload]
                return subprocess.Popen([python, "-W", "always", "-c", CODE], text=True, **arguments)  # type: ignore
        except OSError:
            continue
    return None


def damage(cache: Path, rng: random.Random) -> None:
    """Damage all files of a cache at random."""
    for path in (path for path in cache.rglob("*") if path.is_file()):
        data = bytearray(path.read_bytes())
        kind = rng.randrange(4)
        if kind == 0:
            data = data[: rng.randrange(len(data))]
        elif kind == 1:
            data[:] = rng.randbytes(len(data))
        elif kind == 2:
            for _ in range(20):
                data[rng.randrange(len(data))] ^= 255
        else:
            data = bytearray()
        path.write_bytes(data)


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    rng, bad = random.Random(seed), 0

    def check(title: str, found: list[tuple[str, int, str]], warnings: int | None) -> None:
        nonlocal bad
        digests, counts = {one[0] for one in found}, sorted({one[1] for one in found})
        good = digests == {expected} and (warnings is None or counts == [warnings])
        bad += not good
        same = "equal" if digests == {expected} else digests
        print(f"{title}: {len(found)} flights, {same}; warnings each: {counts}")
        if not good:
            print("    " + found[0][2].strip()[-300:])

    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        folder.chmod(0o755)
        count = 2 if quick else 6
        (folder / "shared").mkdir()
        started = [fly(folder / "shared") for _ in range(count)]
        found = [outcome(process) for process in started]
        expected = found[0][0]
        bad += expected == "failed"
        check("processes that start at once with an empty cache", found, 0)
        check("one more with that cache", [outcome(fly(folder / "shared"))], 0)
        for k in range(1 if quick else 5):
            shutil.copytree(folder / "shared", folder / f"damaged{k}")
            damage(folder / f"damaged{k}", rng)
            check("damaged cache", [outcome(fly(folder / f"damaged{k}"))], None)
            check("the next flight with it", [outcome(fly(folder / f"damaged{k}"))], 0)
        read_only = fly_read_only(folder / "read-only")
        if read_only is None:
            print("read-only installation: left out, for another user cannot run this Python")
        else:
            check("read-only installation, without HOME, not as root", [outcome(read_only)], 1)
        (folder / "file").write_text("")
        check("cache in a file's place", [outcome(fly(folder / "file"))], None)
        check("cache where the system takes no files", [outcome(fly(Path("/proc/self/cache")))], None)
    return int(bad > 0)
