"""Files of learned corrections: safetensors with the weights, JSON with the settings and the SHA-256 of both."""

import json
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.residual.features import AHEAD, FEATURE_GROUPS
from heli_gym.baselines.control.residual.networks import CELL, Network, RecurrentNetwork
from heli_gym.baselines.control.residual.policy import LAWS, ResidualPolicy
from heli_gym.rig import PAPER, Rig, check_same_rig
from heli_gym.storage import atomic_write, read_json_object
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number

LEARNED = Path(__file__).parent / "learned"  # packaged policies: the first seed of each plant


@dataclass(frozen=True)
class Learned:
    """Settings of a stored network."""

    base: str  # name of the corrected policy
    scale: float  # V
    reference: str
    plant: str  # of its training
    control_period: float  # s
    features: int
    hidden: tuple[int, ...]
    tanh_output: bool  # whether tanh follows the last layer
    feature_groups: tuple[str, ...] = tuple(FEATURE_GROUPS)  # inputs, of FEATURE_GROUPS
    rig: str = ""  # TOML of the rig of its training; empty for the paper's
    law: str = "saturated"  # one of `LAWS`
    ahead: tuple[float, ...] = AHEAD  # s, previews of the reference
    recurrent: int = 0  # hidden states of a GRU cell before the layers; 0 without a cell


def save_learned(path: str | os.PathLike, settings: Learned, network: Network | RecurrentNetwork) -> None:
    """Write path.safetensors and path.json, each atomically."""
    from safetensors.numpy import save

    tensors: dict[str, np.ndarray] = {}
    if isinstance(network, RecurrentNetwork):
        tensors |= {name: getattr(network, name).astype(np.float32) for name in CELL}
        network = network.head
    for layer, (weight, bias) in enumerate(zip(network.weights, network.biases)):
        tensors[f"{layer}.weight"], tensors[f"{layer}.bias"] = weight.astype(np.float32), bias.astype(np.float32)
    data = save(tensors)
    path = Path(path)
    with atomic_write(path.with_suffix(".safetensors")) as file:
        file.write(data)
    with atomic_write(path.with_suffix(".json")) as file:
        digests = {"sha256": sha256(data).hexdigest(), "settings_sha256": settings_digest(settings)}
        file.write((json.dumps({**asdict(settings), **digests}, indent=2) + "\n").encode())


def settings_digest(settings: Learned) -> str:
    """SHA-256 of all settings, in hexadecimal."""
    return sha256(json.dumps(asdict(settings), sort_keys=True).encode()).hexdigest()


def check_settings(called: str, settings: Learned, path: Path) -> None:
    """Raise ValueError unless all settings of a stored policy have the right types and values."""
    s = settings

    def require(name: str, allowed: bool, what: str) -> None:
        if not allowed:
            raise ValueError(f"{called}: {name} = {getattr(s, name)!r}: must be {what}")

    def all_of(values: Any, kind: type, allowed: Callable = lambda value: True) -> bool:
        return isinstance(values, tuple) and all(type(value) is kind and allowed(value) for value in values)

    for name in ("base", "reference", "plant", "rig"):
        require(name, isinstance(getattr(s, name), str), "text")
    require("base", not s.base.endswith(".json") and not s.base.startswith("residual"), "a policy that is not learned")
    require("scale", is_number(s.scale) and s.scale >= 0.0, "a finite number of volts, at least 0")
    require("control_period", is_number(s.control_period) and s.control_period > 0.0, "a positive number of seconds")
    for name, least in (("features", 1), ("recurrent", 0)):
        require(name, type(getattr(s, name)) is int and getattr(s, name) >= least, f"a whole number, at least {least}")
    require("hidden", all_of(s.hidden, int, lambda size: size >= 1), "a list of positive whole numbers")
    require("tanh_output", isinstance(s.tanh_output, bool), "true or false")
    require("law", s.law in LAWS, f"one of {', '.join(map(repr, LAWS))}")
    require("feature_groups", all_of(s.feature_groups, str, FEATURE_GROUPS.__contains__), "some of FEATURE_GROUPS")
    times = isinstance(s.ahead, tuple) and all(is_number(value) and value >= 0.0 for value in s.ahead)
    require("ahead", times, "a list of seconds, at least 0")


def check_tensors(called: str, settings: Learned, tensors: dict[str, np.ndarray]) -> None:
    """Raise ValueError unless the tensors are finite and their shapes agree with the settings."""
    n, inputs = settings.recurrent, settings.features
    shapes: dict[str, tuple[int, ...]] = {}
    if n:
        shapes = dict(zip(CELL, ((3 * n, inputs), (3 * n, n), (3 * n,), (3 * n,))))
        inputs = n
    for layer, size in enumerate((*settings.hidden, 2)):
        shapes |= {f"{layer}.weight": (size, inputs), f"{layer}.bias": (size,)}
        inputs = size
    if set(tensors) != set(shapes):
        raise ValueError(f"{called}: tensors {sorted(tensors)}: must be {sorted(shapes)}")
    for name, shape in shapes.items():
        if tensors[name].shape != shape:
            raise ValueError(f"{called}: {name} has shape {tensors[name].shape}: must be {shape}")
        if not np.isfinite(tensors[name]).all():
            raise ValueError(f"{called}: {name}: must hold finite numbers only")


def load_learned(path: str | os.PathLike) -> tuple[Learned, Network | RecurrentNetwork]:
    """Read the settings and the network that `save_learned` wrote, without unpickling.

    Raises ValueError if a file is missing or damaged, or if the two do not belong together.
    """
    from safetensors.numpy import load

    path = Path(path)
    called = f"path = {str(path)!r}"
    try:
        described = read_json_object(path.with_suffix(".json"))
        data = path.with_suffix(".safetensors").read_bytes()
        digest = described.pop("sha256")
        whole = described.pop("settings_sha256", None)  # absent in older files
        lists = {name: tuple(value) for name, value in described.items() if isinstance(value, list)}
        settings = Learned(**{"law": "sum", **described, **lists})  # older files have no law: it was "sum"
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise ValueError(f"{called}: no learned policy: {error}") from error
    if sha256(data).hexdigest() != digest:
        raise ValueError(f"{called}: the weights are not those that the JSON file describes")
    if whole is not None and settings_digest(settings) != whole:
        raise ValueError(f"{called}: the settings are not those that were stored")
    check_settings(called, settings, path)
    try:
        tensors = load(data)
    except Exception as error:  # safetensors raises its own exception types
        raise ValueError(f"{called}: the weights are no safetensors file: {error}") from error
    check_tensors(called, settings, tensors)
    layers = range(len(settings.hidden) + 1)
    network = Network(
        tuple(tensors[f"{layer}.weight"].astype(float) for layer in layers),
        tuple(tensors[f"{layer}.bias"].astype(float) for layer in layers),
        settings.tanh_output,
    )
    if settings.recurrent:
        return settings, RecurrentNetwork(**{name: tensors[name].astype(float) for name in CELL}, head=network)
    return settings, network


def learned_policy(
    path: str | os.PathLike,
    reference: Trajectory,
    control_period: float,
    rig: Rig,
    make_base: Callable[..., Policy],
) -> ResidualPolicy:
    """Load a stored policy for a reference; `make_base`, called like `make_policy`, makes its base policy.

    Raises ValueError for a rig or a control period other than those of its training.
    """
    settings, network = load_learned(path)
    own = Rig.from_toml(settings.rig) if settings.rig else PAPER
    check_same_rig(f"the policy {Path(path).name}", own, rig, "the one that flies")
    if control_period != settings.control_period:
        raise ValueError(
            f"control_period = {control_period:g} s: the policy {Path(path).name} was trained for "
            f"{settings.control_period:g} s"
        )
    base = make_base(settings.base, reference, control_period, rig=rig)
    return ResidualPolicy(
        base,
        reference,
        network,
        settings.scale,
        control_period,
        rig.voltage_limits,
        feature_groups=settings.feature_groups,
        law=settings.law,
        ahead=settings.ahead,
    )
