"""Checkpoints of a training run, which can continue after an interrupt at any moment.

A checkpoint is one safetensors file: tensors, and in its metadata a tree with their positions. It is written
atomically, with its SHA-256 in a second file. A run has at most two checkpoints.
"""

import json
import logging
from hashlib import sha256
from pathlib import Path
from typing import Any

import torch
from safetensors.torch import load, save

from heli_gym.storage import atomic_write

KEPT = 2
FORMAT = "{:06d}"


def split(value: Any, tensors: dict[str, torch.Tensor]) -> Any:
    """Convert a value to plain JSON, and move its tensors to `tensors`."""
    if isinstance(value, torch.Tensor):
        name = str(len(tensors))
        tensors[name] = value.detach().clone().contiguous()
        return {"tensor": name}
    if isinstance(value, dict):
        return {"items": [[key, split(item, tensors)] for key, item in value.items()]}
    if isinstance(value, list | tuple):
        return {"list": [split(item, tensors) for item in value]}
    return {"value": value}


def join(tree: Any, tensors: dict[str, torch.Tensor]) -> Any:
    """Invert `split`, except that tuples become lists."""
    if "tensor" in tree:
        return tensors[tree["tensor"]]
    if "items" in tree:
        return {key: join(item, tensors) for key, item in tree["items"]}
    return [join(item, tensors) for item in tree["list"]] if "list" in tree else tree["value"]


def write_state(path: Path, state: dict[str, Any]) -> None:
    """Write path.safetensors, and its SHA-256 to path.sha256, each atomically."""
    tensors: dict[str, torch.Tensor] = {}
    tree = split(state, tensors)
    data = save(tensors, metadata={"tree": json.dumps(tree)})
    with atomic_write(path.with_suffix(".safetensors")) as file:
        file.write(data)
    with atomic_write(path.with_suffix(".sha256")) as file:
        file.write((sha256(data).hexdigest() + "\n").encode())


def save_checkpoint(folder: Path, number: int, state: dict[str, Any]) -> None:
    """Write the state of a run, and remove all checkpoints except the last two."""
    write_state(folder / FORMAT.format(number), state)
    for old in sorted(folder.glob("*.safetensors"))[:-KEPT]:
        old.unlink()
        old.with_suffix(".sha256").unlink(missing_ok=True)


def read_checkpoint(path: Path) -> dict[str, Any]:
    """Read a state that `write_state` wrote. Raises ValueError for a damaged file."""
    try:
        data, digest = path.read_bytes(), path.with_suffix(".sha256").read_text(encoding="utf-8").strip()
    except OSError as error:
        raise ValueError(f"checkpoint {path}: {error}") from error
    if sha256(data).hexdigest() != digest:
        raise ValueError(f"checkpoint {path} is damaged: its SHA-256 is not the one stored with it")
    length = int.from_bytes(data[:8], "little")
    return join(json.loads(json.loads(data[8 : 8 + length])["__metadata__"]["tree"]), load(data))


def last_checkpoint(folder: Path) -> dict[str, Any] | None:
    """Latest valid checkpoint, or None without a checkpoint; prints the name of each damaged one and skips it.

    Raises ValueError if all checkpoints are damaged.
    """
    paths = sorted(folder.glob("*.safetensors"), reverse=True)
    for path in paths:
        try:
            return read_checkpoint(path)
        except ValueError as error:
            logging.warning("%s; the one before it is used, if there is one", error)
    if paths:
        raise ValueError(f"{folder}: all {len(paths)} checkpoints are damaged; remove the run's folder to begin anew")
    return None
