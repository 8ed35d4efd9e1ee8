"""Weights stored for single plants, one file a plant: `heli-tune --store` writes them."""

import json
import re
from dataclasses import asdict
from pathlib import Path
from typing import Any

from heli_gym.baselines.control.weights.design import WEIGHTS
from heli_gym.rig import PAPER, Rig, check_same_rig, same_dynamics
from heli_gym.storage import atomic_write, locked, read_json_object

TUNED = Path(__file__).parent / "tuned"  # one file of weights per plant


def weights_file(plant: str, rig: Rig) -> Path:
    """File of the stored weights for a plant of a rig; the file name omits the paper's rig."""
    name = re.sub(r"[^\w-]", "_", rig.name)
    return TUNED / (f"{plant}.json" if same_dynamics(rig, PAPER) else f"{plant}.{name}.json")


def store_weights(name: str, plant: str, weights: Any, rig: Rig = PAPER) -> None:
    """Store the weights of a policy for a plant and a rig, atomically; the policy `name@plant` uses them."""
    path = weights_file(plant, rig)
    rounded = {key: float(f"{value:.4g}") for key, value in asdict(weights).items()}
    with locked(path):
        known = read_json_object(path) if path.is_file() else {}
        if not same_dynamics(rig, PAPER):
            known["rig"] = rig.to_toml()
        with atomic_write(path) as file:
            file.write((json.dumps({**known, name: rounded}, indent=2, sort_keys=True) + "\n").encode())


def stored_weights(name: str, plant: str, rig: Rig = PAPER) -> Any:
    """Weights that `store_weights` stored. Raises ValueError if there are no weights for the plant and the rig."""
    path, called = weights_file(plant, rig), f"name = {f'{name}@{plant}'!r}"
    if not path.is_file():  # then the message below names the rig that has weights
        path = TUNED / f"{plant}.json"
    known = read_json_object(path) if path.is_file() else {}
    if name not in known:
        raise ValueError(
            f"{called}: no weights are stored for the rig {rig.name!r} in {path}; heli-tune --store stores some"
        )
    try:
        own = Rig.from_toml(str(known["rig"])) if "rig" in known else PAPER
    except ValueError as error:
        raise ValueError(f"{called}: rig in {path}: {error}") from error
    check_same_rig(f"{called}: what is stored", own, rig, "the one that flies")
    try:
        return type(WEIGHTS[name])(**known[name])
    except (TypeError, ValueError) as error:
        raise ValueError(f"{called}: weights in {path}: {error}") from error


def tuned_name(name: str, plant: str, rig: Rig = PAPER) -> str:
    """Policy name with @PLANT replaced by the plant, or removed if no weights of the policy are stored for it."""
    kind, mark, suffix = name.partition("@PLANT")
    if not mark:
        return name
    path = weights_file(plant, rig)
    is_stored = kind in WEIGHTS and path.is_file() and kind in read_json_object(path)
    return f"{kind}@{plant}{suffix}" if is_stored else kind + suffix


def weights_of(name: str, rig: Rig = PAPER) -> Any:
    """Weights of the named policy on a rig, for example of "lqi" or "lqi@lab"."""
    kind, _, plant = name.partition("@")
    return stored_weights(kind, plant, rig) if plant else WEIGHTS[kind]
