"""SHA-256 of the files behind names of policies, references and rigs, so that a resumed run is of the same ones.

What is packaged has no digest: it belongs to the version of heli_gym.
"""

import json
import sys
from dataclasses import asdict
from hashlib import sha256
from os import PathLike
from pathlib import Path

from heli_gym.baselines.control.policies import SAFE
from heli_gym.baselines.control.residual import load_learned
from heli_gym.baselines.control.weights import weights_of
from heli_gym.rig import Rig, find_rig
from heli_gym.storage import read_arrays


def policy_digest(name: str, rig: Rig) -> str:
    """Digest of the network, the module or the tuned weights of a policy that `make_pilot` has made; "" without any.

    A learned policy's includes the weights of its base. Of a module, other files that it imports do not count.
    """
    name = name.removesuffix(SAFE)
    module, colon, _ = name.partition(":")
    if name.endswith((".zip", ".onnx")):
        return digest_of(Path(name).read_bytes())
    if name.endswith(".json"):
        base = policy_digest(load_learned(name)[0].base, rig)
        return digest_of(learned_digest(name).encode(), base.encode())
    if colon:
        source = getattr(sys.modules.get(module), "__file__", None)
        return digest_of(Path(source).read_bytes()) if source else ""
    if "@" in name:
        return digest_of(json.dumps(asdict(weights_of(name, rig)), sort_keys=True).encode())
    return ""


def learned_digest(path: str | PathLike) -> str:
    """Digest of both files of a learned policy."""
    return digest_of(*(Path(path).with_suffix(suffix).read_bytes() for suffix in (".json", ".safetensors")))


def reference_digest(name: str) -> str:
    """Digest of the arrays in an .npz file; "" for a reference by name."""
    if not name.endswith(".npz"):
        return ""
    arrays = sorted(read_arrays(name).items())
    return digest_of(*(part for key, a in arrays for part in (f"{key} {a.dtype} {a.shape}".encode(), a.tobytes())))


def rig_digest(name: str) -> str:
    """Digest of the rig in a .toml file; "" for a rig by name."""
    return digest_of(find_rig(name).to_toml().encode()) if name.endswith(".toml") else ""


def digest_of(*parts: bytes) -> str:
    """SHA-256 of some bytes, in hexadecimal."""
    return sha256(b"".join(parts)).hexdigest()
