"""Learned correction of a controller: a small network adds actions a in [-1, 1]² to a base policy.

The law "saturated" is u = sat(sat(u_base) + scale a): the correction has authority even where the base policy exceeds
the amplifier's range by tens of volts. The law "sum" is u = sat(u_base + scale a).

The network receives the controller's signals (`FEATURE_GROUPS`) and nothing of the plant's draw. A safetensors file
stores its weights, a JSON file its settings and the SHA-256 of both; numpy evaluates it.
"""

import json
import math
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.model_based import ModelPolicy
from heli_gym.baselines.control.protocol import Policy, StatefulPolicy, expand_batch_dims, step_index
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import PAPER, Rig, check_same_rig
from heli_gym.storage import atomic_write, read_json_object
from heli_gym.task import TOLERANCE, control_grid
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number

if TYPE_CHECKING:
    from heli_gym.baselines.control.residual_step import SingleStep

LEARNED = Path(__file__).parent / "learned"  # packaged policies: the first seed of each plant
LAWS = ("sum", "saturated")
AHEAD = (0.0, 0.2, 0.4, 0.8)  # s, previews of the reference
BEFORE = (0.1, 0.2, 0.4)  # s, ages of past errors and corrections
FEATURE_GROUPS = {
    "error": "of all six states, in tolerances",
    "integral": "of the errors of travel and elevation",
    "voltages": "of the base policy, nominal, and the last correction",
    "estimate": "of the disturbances and the rotor speeds, by the base policy, where it is a `ModelPolicy`",
    "preview": "of the reference, now and ahead",
    "past": "errors of the angles, and corrections",
}
STATE_SCALE = np.array([math.pi, 1.0, 0.2, 0.5, 1.0, 2.0])  # rad and rad/s, scales of the previewed reference
DISTURBANCE_SCALE, INTEGRAL_SCALE, FEATURE_CLIP = 0.2, 0.1, 5.0  # rad/s², rad s, bound of all features


def normalise_voltage(u: Any, voltage_limits: tuple[float, float]) -> Any:
    """Map voltages u in V to [-1, 1] over the amplifier's range."""
    low, high = voltage_limits
    return (u - 0.5 * (low + high)) / (0.5 * (high - low))


class Memory(NamedTuple):
    """State of a residual policy between control periods."""

    base: Any  # memory of the base policy if it is a `StatefulPolicy`
    integral: np.ndarray  # (2, ...) integrals of the travel and elevation errors in rad s
    past: np.ndarray  # (H, 5, ...) angle errors in tolerances and corrections, newest first
    hidden: np.ndarray | None = None  # (n, ...) hidden state of a recurrent network


@dataclass(eq=False)
class ResidualPolicy:
    """Base policy with a learned correction; with scale 0 it flies the base policy bit for bit.

    Args:
        base: policy to correct; a `ModelPolicy` receives the voltages that were applied.
        reference: trajectory to track.
        network: function of features (F, ...) that returns actions (2, ...) in [-1, 1], or a `RecurrentNetwork`.
        scale: greatest correction in V.
        control_period: s.
        voltage_limits: (min, max) in V of the amplifier.
        feature_groups: names in `FEATURE_GROUPS` that the network receives.
        law: "saturated" or "sum".
        ahead: previews of the reference in s.

    Raises:
        ValueError: for a scale that is negative or not finite, or an unknown group or law.
    """

    base: Policy
    reference: Trajectory
    network: Any
    scale: float
    control_period: float = 0.02
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    feature_groups: tuple[str, ...] = tuple(FEATURE_GROUPS)
    law: str = "saturated"
    ahead: tuple[float, ...] = AHEAD
    memory: Memory | None = field(default=None, init=False, repr=False)
    single_step: "SingleStep | None" = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        if not (is_number(self.scale) and self.scale >= 0.0):
            raise ValueError(f"scale = {self.scale!r}: must be a finite number of volts, at least 0")
        if not self.feature_groups or not set(self.feature_groups) <= set(FEATURE_GROUPS):
            raise ValueError(
                f"feature_groups = {self.feature_groups!r}: must name some of {', '.join(map(repr, FEATURE_GROUPS))}"
            )
        if self.law not in LAWS:
            raise ValueError(f"law = {self.law!r}: must be one of {', '.join(map(repr, LAWS))}")
        self.x, self.u = control_grid(self.reference, self.control_period)
        ahead = [control_grid(self.reference, self.control_period, seconds)[0] for seconds in self.ahead]
        self.preview = np.concatenate([(x / STATE_SCALE[:, None])[1:] for x in ahead])
        self.past_steps = [round(seconds / self.control_period) for seconds in BEFORE]

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the memory of the last flight."""
        self.base.reset(rng)
        self.memory = None  # includes the memory of the base policy
        if self.single_step is not None:
            self.single_step.reset()

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        measurement = np.asarray(measurement, dtype=float)
        if self.memory is None and measurement.ndim == 1 and np.ndim(t) == 0:
            if self.single_step is None:
                from heli_gym.baselines.control.residual_step import SingleStep  # which imports this module

                if SingleStep.serves(self):
                    self.single_step = SingleStep(self)
            if self.single_step is not None:
                return self.single_step(float(t), measurement)
        u_base, features = self.observe(t, measurement)
        if isinstance(self.network, RecurrentNetwork):
            assert self.memory is not None
            hidden = self.memory.hidden
            if hidden is None:
                hidden = np.zeros((self.network.size, *features.shape[1:]))
            action, hidden = self.network(features, hidden)
            self.memory = self.memory._replace(hidden=hidden)
        else:
            action = self.network(features)
        return self.correct(t, measurement, u_base, np.clip(action, -1.0, 1.0))

    def observe(self, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Voltages (2, ...) in V of the base policy, and features (F, ...) for the network."""
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        if self.memory is None:
            batch = measurement.shape[1:]
            base = self.base.init(t, measurement) if isinstance(self.base, StatefulPolicy) else None
            self.memory = Memory(base, np.zeros((2, *batch)), np.zeros((max(self.past_steps), 5, *batch)))
        if isinstance(self.base, StatefulPolicy):
            u_base, base = self.base.step(self.memory.base, t, measurement)
            self.memory = self.memory._replace(base=base)
        else:
            u_base = self.base(t, measurement)
        error = measurement - expand_batch_dims(self.x[:, k], measurement)
        past = self.memory.past
        groups = {
            "error": [error / expand_batch_dims(np.array(TOLERANCE), measurement)],
            "integral": [self.memory.integral / INTEGRAL_SCALE],
            "voltages": [
                normalise_voltage(u_base, self.voltage_limits),
                normalise_voltage(
                    expand_batch_dims(self.u[:, k], measurement) + np.zeros_like(u_base), self.voltage_limits
                ),
                past[0, 3:],
            ],
            "estimate": [],
            "preview": [expand_batch_dims(self.preview[:, k], measurement) + np.zeros((1, *measurement.shape[1:]))],
            "past": [past[step - 1] for step in self.past_steps],
        }
        if isinstance(self.base, ModelPolicy):
            groups["estimate"] = [
                self.memory.base.disturbance / DISTURBANCE_SCALE,
                normalise_voltage(self.memory.base.rotors, self.voltage_limits),
            ]
        rows = [row for group in FEATURE_GROUPS if group in self.feature_groups for row in groups[group]]
        return u_base, np.clip(np.concatenate(rows), -FEATURE_CLIP, FEATURE_CLIP)

    def correct(
        self, t: float | np.ndarray, measurement: np.ndarray, u_base: np.ndarray, action: np.ndarray
    ) -> np.ndarray:
        """Voltages (2, ...) in V of base policy and action (2, ...); stores both in the memory.

        Raises ValueError before `observe`.
        """
        if self.memory is None:
            raise ValueError("correct: comes after observe")
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        if self.law == "saturated":
            u_base = np.clip(u_base, *self.voltage_limits)
        u = u_base + self.scale * action if self.scale else u_base
        base = self.memory.base
        if isinstance(self.base, ModelPolicy) and self.scale:
            base = self.base.with_applied_input(base, u)
        error = (measurement - expand_batch_dims(self.x[:, k], measurement))[0::2]
        tolerances = expand_batch_dims(np.array(TOLERANCE[0::2]), measurement)
        now = np.concatenate((error / tolerances, action))[None]
        self.memory = Memory(
            base,
            self.memory.integral + self.control_period * error[:2],
            np.concatenate((now, self.memory.past[:-1])),
            self.memory.hidden,
        )
        return u


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


class Network(NamedTuple):
    """Layers of weights (out, in) and biases (out,), with tanh between them."""

    weights: tuple[np.ndarray, ...]
    biases: tuple[np.ndarray, ...]
    tanh_output: bool  # whether tanh follows the last layer

    def __call__(self, features: np.ndarray) -> np.ndarray:
        """Actions (2, ...) for features (F, ...)."""
        value = features
        for layer, (weight, bias) in enumerate(zip(self.weights, self.biases)):
            value = weight @ value + expand_batch_dims(bias, value)
            if layer < len(self.weights) - 1 or self.tanh_output:
                value = np.tanh(value)
        return value


class RecurrentNetwork(NamedTuple):
    """GRU cell (Cho et al., 2014; gates in torch's order: reset, update, new), followed by the layers of a network."""

    weight_input: np.ndarray  # (3 n, F)
    weight_hidden: np.ndarray  # (3 n, n)
    bias_input: np.ndarray  # (3 n,)
    bias_hidden: np.ndarray  # (3 n,)
    head: Network

    @property
    def size(self) -> int:
        """Number n of hidden states."""
        return self.weight_hidden.shape[1]

    def __call__(self, features: np.ndarray, hidden: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Actions (2, ...) and next hidden state (n, ...) for features (F, ...) and a hidden state (n, ...)."""
        n = self.size
        x = self.weight_input @ features + expand_batch_dims(self.bias_input, features)
        h = self.weight_hidden @ hidden + expand_batch_dims(self.bias_hidden, features)
        gates = 0.5 + 0.5 * np.tanh(0.5 * (x[: 2 * n] + h[: 2 * n]))  # sigmoid, without overflow
        new = np.tanh(x[2 * n :] + gates[:n] * h[2 * n :])
        hidden = new + gates[n:] * (hidden - new)
        return self.head(hidden), hidden


CELL = ("weight_input", "weight_hidden", "bias_input", "bias_hidden")


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
