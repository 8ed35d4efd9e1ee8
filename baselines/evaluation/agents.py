"""Pilots for `fly`, made from policy names, files of agents or a user's own functions.

A policy maps times and measurements to voltages; an agent maps the environment's observations to its actions. Only
numbers are read from files: nothing is unpickled.
"""

import importlib
import inspect
import io
import pickletools
import sys
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym.baselines.control.policies import make_policy
from heli_gym.storage import parse_json
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number

CLIP_MEAN = 2.0  # default of Stable-Baselines3
MAX_BYTES = 2**28  # greatest size of a tensor file
DTYPES = {"FloatStorage": "<f4", "DoubleStorage": "<f8", "HalfStorage": "<f2", "LongStorage": "<i8"}
ACTIVATIONS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "Tanh": np.tanh,
    "ReLU": lambda x: np.maximum(x, 0.0),
    "ELU": lambda x: np.where(x > 0.0, x, np.expm1(np.minimum(x, 0.0))),
    "LeakyReLU": lambda x: np.where(x > 0.0, x, 0.01 * x),
    "Sigmoid": lambda x: 1.0 / (1.0 + np.exp(-x)),
}


class Agent:
    """Agent without memory: maps observations (N, D) of the environment to actions (N, 2) in [-1, 1]."""

    def __init__(self, act: Callable[[np.ndarray], Any], name: str = "agent") -> None:
        self.predict, self.name = act, name

    def reset(self, rng: np.random.Generator) -> None:
        """Do nothing: an agent has no memory."""

    def act(self, observation: np.ndarray) -> np.ndarray:
        """Actions (N, 2) for observations (N, D). Raises ValueError unless they are (N, 2) finite numbers."""
        action = np.asarray(self.predict(observation), dtype=float)
        if action.shape != (len(observation), 2) or not np.isfinite(action).all():
            raise ValueError(f"{self.name}: must give finite actions ({len(observation)}, 2), but gave {action.shape}")
        return np.clip(action, -1.0, 1.0)


class FunctionPolicy:
    """Policy from a user's function of time and measurement; a true `batched` lets it fly many helicopters at once."""

    def __init__(self, function: Callable[[float, np.ndarray], Any]) -> None:
        self.function, self.batched = function, bool(getattr(function, "batched", False))

    def reset(self, rng: np.random.Generator) -> None:
        """Call the function's own `reset`, if it has one."""
        if hasattr(self.function, "reset"):
            self.function.reset(rng)

    def __call__(self, t: float, measurement: np.ndarray) -> np.ndarray:
        u = np.asarray(self.function(t, measurement), dtype=float)
        if u.shape != (2, *measurement.shape[1:]) or not np.isfinite(u).all():
            raise ValueError(f"policy: must return two finite voltages, but returned {u!r} at t = {t:g} s")
        return u


def make_pilot(
    policy: Any,
    reference: Trajectory,
    control_period: float = 0.02,
    voltage_limits: tuple[float, float] | None = None,
) -> Any:
    """Make a pilot for `fly`, a policy or an `Agent`, from a name, a file or an object.

    Args:
        policy: one of
            - a name in `POLICIES`;
            - the path of a learned policy (.json), a Stable-Baselines3 model (.zip) or an ONNX network (.onnx); the
              latter two map observations to actions;
            - "module:function", a function that makes a policy, with any of the arguments `reference`,
              `control_period` and `voltage_limits`;
            - a model with `predict`, a policy, or a function of time and measurement that returns voltages.
        reference: trajectory to track.
        control_period: s.
        voltage_limits: (min, max) in V; by default those of the reference's rig.

    Raises:
        ValueError: for an unknown name or a damaged file.
        ImportError: if the module or ONNX Runtime cannot be imported.
    """
    voltage_limits = voltage_limits or reference.rig.voltage_limits
    if not isinstance(policy, str | Path):
        return as_pilot(policy)
    name = str(policy)
    if name.endswith(".zip"):
        return load_sb3(name)
    if name.endswith(".onnx"):
        return load_onnx(name)
    module, colon, function = name.partition(":")
    if colon and not name.endswith(".json") and all(part.isidentifier() for part in (*module.split("."), function)):
        offered = {"reference": reference, "control_period": control_period, "voltage_limits": voltage_limits}
        make = find_function(name, module, function)
        return as_pilot(make(**{key: value for key, value in offered.items() if accepts(make, key)}))
    return make_policy(name, reference, control_period, voltage_limits=voltage_limits)


def as_pilot(policy: Any) -> Any:
    """Policy or agent for an object. Raises ValueError for any other object."""
    if isinstance(policy, Agent) or (callable(policy) and hasattr(policy, "reset") and hasattr(policy, "act")):
        return policy
    if callable(policy):
        return policy if type(policy).__module__.startswith("heli_gym.") else FunctionPolicy(policy)
    if hasattr(policy, "predict"):
        return Agent(partial(predict_without_memory, policy), type(policy).__name__)
    raise ValueError(f"policy = {policy!r}: must be a name, a path, a policy, a function or a model with predict")


def predict_without_memory(model: Any, observation: np.ndarray) -> Any:
    """Actions of a model. Raises ValueError for one with a memory, which nobody would hand back to it."""
    action, *memory = model.predict(observation, deterministic=True)
    if any(state is not None for state in memory):
        raise ValueError(
            f"policy: {type(model).__name__} has a memory, its predict returns a state: must be a model without; "
            "a policy of your own can hold the state"
        )
    return action


def find_function(name: str, module: str, function: str) -> Callable[..., Any]:
    """Import the function of "module:function"; the working directory comes first, as for `python -m`."""
    if str(Path.cwd()) not in sys.path:
        sys.path.insert(0, str(Path.cwd()))
    try:
        found = getattr(importlib.import_module(module), function)
    except ModuleNotFoundError as error:
        if error.name != module.partition(".")[0]:
            raise
        raise ValueError(f"policy = {name!r}: there is no module {module!r}") from error
    except AttributeError as error:
        raise ValueError(f"policy = {name!r}: the module {module!r} has no {function!r}") from error
    if not callable(found):
        raise ValueError(f"policy = {name!r}: must name a function")
    return found


def accepts(function: Callable[..., Any], name: str) -> bool:
    """Whether a function has an argument with the given name."""
    parameters = inspect.signature(function).parameters
    return name in parameters or any(p.kind is p.VAR_KEYWORD for p in parameters.values())


# Files


@dataclass(frozen=True)
class Layers:
    """Network of dense layers: maps observations (N, D) to actions (N, 2)."""

    weights: tuple[np.ndarray, ...]  # each (out, in)
    biases: tuple[np.ndarray, ...]
    activation: str
    tanh_output: bool
    limit: float = np.inf  # greatest magnitude of the last layer's outputs, ahead of tanh

    def __call__(self, observation: np.ndarray) -> np.ndarray:
        value = observation.reshape(len(observation), -1).astype(float)
        if value.shape[1] != self.weights[0].shape[1]:
            raise ValueError(
                f"policy: was trained on {self.weights[0].shape[1]} observed numbers, and there are {value.shape[1]}"
            )
        for weight, bias in zip(self.weights[:-1], self.biases[:-1]):
            value = ACTIVATIONS[self.activation](value @ weight.T + bias)
        value = np.clip(value @ self.weights[-1].T + self.biases[-1], -self.limit, self.limit)
        return np.tanh(value) if self.tanh_output else value


def load_sb3(path: str) -> Agent:
    """Load the deterministic actor of a Stable-Baselines3 model: PPO, A2C, SAC, TQC, TD3 or DDPG with an MlpPolicy.

    Only the parameters, the name of the activation function and the options of gSDE are read.

    Raises OSError if the file cannot be read, ValueError for another file or another network.
    """
    with open(path, "rb") as file:
        try:
            with zipfile.ZipFile(file) as archive:
                tensors = read_state_dict(member(archive, "policy.pth"))
                settings = parse_json(member(archive, "data"))
        except Exception as error:  # a damaged archive, tensor table or JSON raises many types, OSError among them
            raise ValueError(f"policy = {path!r}: must be a model that Stable-Baselines3 saved: {error}") from error
    layouts = (  # names of hidden and last layers, default activation, tanh at the end
        ("mlp_extractor.policy_net.", "action_net.", "Tanh", False),
        ("actor.latent_pi.", "actor.mu.", "ReLU", True),
        ("actor.mu.", None, "ReLU", True),
    )
    found = next((layout for layout in layouts if ordered_layers(tensors, layout[0])), None)
    if found is None:
        raise ValueError(
            f"policy = {path!r}: must have an MlpPolicy; its parameters are {', '.join(sorted(tensors)[:4])}"
        )
    hidden, last, activation, tanh_output = found
    names = ordered_layers(tensors, hidden)
    if any(name.startswith(("lstm", "features_extractor.cnn", "pi_features_extractor.cnn")) for name in tensors):
        raise ValueError(f"policy = {path!r}: must be without recurrent or convolutional layers")
    chosen = settings.get("policy_kwargs") if isinstance(settings, dict) else None
    chosen = chosen if isinstance(chosen, dict) else {}
    tanh_output = tanh_output or chosen.get("squash_output") is True  # of PPO and A2C with gSDE
    limit = np.inf
    if last is not None:
        clipped = ordered_layers(tensors, last)  # of SAC and TQC with gSDE: a layer and a Hardtanh
        names += clipped or [last.rstrip(".")]
        limit = chosen.get("clip_mean", CLIP_MEAN) if clipped else np.inf
        if clipped and not (is_number(limit) and limit > 0.0):
            raise ValueError(f"policy = {path!r}: clip_mean = {limit!r}: must be a positive number")
    activation = str(chosen.get("activation_fn", "")).rstrip("'>").rpartition(".")[2] or activation
    if activation not in ACTIVATIONS:
        raise ValueError(f"policy = {path!r}: its activation {activation!r} must be one of {', '.join(ACTIVATIONS)}")
    try:
        weights = tuple(tensors[f"{name}.weight"].astype(float) for name in names)
        biases = tuple(tensors[f"{name}.bias"].astype(float) for name in names)
    except KeyError as error:
        raise ValueError(f"policy = {path!r}: has no parameter {error}") from error
    shapes = [weight.shape for weight in weights]
    fits = all(len(shape) == 2 and bias.shape == shape[:1] for shape, bias in zip(shapes, biases))
    if not (fits and all(a[0] == b[1] for a, b in pairwise(shapes)) and shapes[-1][0] == 2):
        raise ValueError(f"policy = {path!r}: its layers {shapes} must lead to two actions")
    if not all(np.isfinite(values).all() for values in (*weights, *biases)):
        raise ValueError(f"policy = {path!r}: its parameters must be finite")
    return Agent(Layers(weights, biases, activation, tanh_output, limit), path)


def ordered_layers(tensors: dict[str, np.ndarray], prefix: str) -> list[str]:
    """Names of the dense layers `prefix`N, in the order of N."""
    numbers = {name[len(prefix) :].partition(".")[0] for name in tensors if name.startswith(prefix)}
    return [f"{prefix}{n}" for n in sorted((n for n in numbers if n.isdigit()), key=int)]


def member(archive: zipfile.ZipFile, name: str) -> bytes:
    """Contents of a file in an archive. Raises ValueError above MAX_BYTES."""
    if archive.getinfo(name).file_size > MAX_BYTES:
        raise ValueError(f"{name} is too large")
    return archive.read(name)


def read_state_dict(data: bytes) -> dict[str, np.ndarray]:
    """Read the tensors of a state dictionary that PyTorch saved as a zip archive, without unpickling.

    The pickle is parsed as a list of instructions, and only the instructions of a state dictionary are interpreted:
    nothing is imported or called. Raises ValueError for any other instruction.
    """
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        [table] = [name for name in archive.namelist() if name.endswith("/data.pkl")]
        folder = table.removesuffix("data.pkl")
        if f"{folder}byteorder" in archive.namelist() and archive.read(f"{folder}byteorder") != b"little":
            raise ValueError("its bytes are in another order")

        def tensor(storage: Any, offset: int, shape: tuple, strides: tuple) -> np.ndarray:
            _, (_, kind), key, _, size = storage
            values = np.frombuffer(member(archive, f"{folder}data/{key}"), DTYPES[kind])
            if len(values) < size or min((offset, *shape, *strides), default=0) < 0:
                raise ValueError("a tensor is not whole")
            if np.prod([float(n) for n in shape]) > len(values):
                raise ValueError("a tensor is larger than its storage")
            if shape and 0 not in shape and offset + sum((n - 1) * s for n, s in zip(shape, strides)) >= len(values):
                raise ValueError("a tensor is not whole")
            return np.lib.stride_tricks.as_strided(
                values[offset:], shape, [s * values.itemsize for s in strides], writeable=False
            ).copy()

        return follow(member(archive, table), tensor)


def follow(program: bytes, tensor: Callable[..., np.ndarray]) -> dict[str, np.ndarray]:
    """Interpret a pickle's instructions as a dictionary; `tensor` makes its tensors."""
    mark = object()
    stack: list[Any] = []
    memo: dict[int, Any] = {}

    def pop_to_mark() -> list[Any]:
        items = []
        while (item := stack.pop()) is not mark:
            items.append(item)
        return items[::-1]

    def reduce() -> Any:
        arguments, function = stack.pop(), stack.pop()
        if function == ("collections", "OrderedDict"):
            return {}
        if function == ("torch._utils", "_rebuild_tensor_v2"):
            return tensor(*arguments[:4])
        raise ValueError(f"it calls {function}")

    argument: Any
    for opcode, argument, _ in pickletools.genops(program):
        match opcode.name:
            case "PROTO" | "FRAME":
                pass
            case "STOP":
                [state] = stack
                if not isinstance(state, dict):
                    raise ValueError("it is no dictionary")
                return {str(k): v for k, v in state.items() if isinstance(v, np.ndarray)}
            case "MARK":
                stack.append(mark)
            case "EMPTY_DICT":
                stack.append({})
            case "EMPTY_TUPLE":
                stack.append(())
            case "NONE" | "NEWTRUE" | "NEWFALSE":
                stack.append({"NONE": None, "NEWTRUE": True, "NEWFALSE": False}[opcode.name])
            case "BININT" | "BININT1" | "BININT2" | "LONG1" | "BINUNICODE" | "SHORT_BINUNICODE" | "BINFLOAT":
                stack.append(argument)
            case "GLOBAL":
                stack.append(tuple(argument.split(" ", 1)))
            case "BINPUT" | "LONG_BINPUT":
                memo[argument] = stack[-1]
            case "MEMOIZE":
                memo[len(memo)] = stack[-1]
            case "BINGET" | "LONG_BINGET":
                stack.append(memo[argument])
            case "TUPLE":
                stack.append(tuple(pop_to_mark()))
            case "TUPLE1" | "TUPLE2" | "TUPLE3":
                n = int(opcode.name[-1])
                stack[-n:] = [tuple(stack[-n:])]
            case "BINPERSID":
                pass  # the storage's description replaces the storage
            case "REDUCE":
                stack.append(reduce())
            case "SETITEM":
                value, key = stack.pop(), stack.pop()
                stack[-1][key] = value
            case "SETITEMS":
                items = pop_to_mark()
                stack[-1].update(zip(items[0::2], items[1::2]))
            case "BUILD":
                stack.pop()  # drop the metadata of the dictionary
            case other:
                raise ValueError(f"it has the instruction {other}")
    raise ValueError("it has no end")


def load_onnx(path: str) -> Agent:
    """Load an ONNX network that maps observations (N, D) to actions (N, 2); ONNX Runtime evaluates it.

    Raises ValueError for a damaged file or another network, ImportError without ONNX Runtime.
    """
    try:
        import onnxruntime
    except ImportError as error:
        raise ImportError(f"policy = {path!r}: ONNX Runtime must be installed, `pip install onnxruntime`") from error
    try:
        data = Path(path).read_bytes()
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        session = onnxruntime.InferenceSession(data, options, providers=["CPUExecutionProvider"])
    except Exception as error:  # ONNX Runtime raises its own exception types
        raise ValueError(f"policy = {path!r}: must be a network in ONNX: {str(error).splitlines()[0]}") from error
    [first, *others] = session.get_inputs()
    if others or len(first.shape) != 2:
        raise ValueError(f"policy = {path!r}: must have one input, observations (N, D)")
    width = first.shape[1]

    def act(observation: np.ndarray) -> np.ndarray:
        if isinstance(width, int) and observation.shape[1] != width:
            raise ValueError(f"policy = {path!r}: has {width} inputs, and {observation.shape[1]} numbers are observed")
        return session.run(None, {first.name: observation.astype(np.float32)})[0]

    return Agent(act, path)
