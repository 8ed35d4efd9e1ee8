"""`heli-train`: train an agent that corrects a controller, or flies alone.

The learners are the analytic policy gradient of `apg` and algorithms of Stable-Baselines3. This file has three parts:
settings; helicopters and agent; training, in chunks. Each chunk ends with a validation and a checkpoint. The folder
of a run holds:

    settings.json   the settings
    best.*          the best network on the validation helicopters, for `heli-evaluate`
    history.json    the validation after each chunk
    checkpoints/    the last two states of the run, for --resume
    events.*        files of TensorBoard
"""

import json
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Literal

import numpy as np
import torch
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn
from stable_baselines3 import PPO, SAC, TD3
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.logger import configure
from stable_baselines3.common.noise import NormalActionNoise
from stable_baselines3.common.utils import set_random_seed

from heli_gym.baselines.control.policies import POLICIES, make_policy
from heli_gym.baselines.control.residual import (
    AHEAD,
    CELL,
    FEATURE_GROUPS,
    Learned,
    Network,
    RecurrentNetwork,
    ResidualPolicy,
    load_learned,
    save_learned,
)
from heli_gym.baselines.control.residual.step import SINGLE_GROUPS
from heli_gym.baselines.control.weights import tuned_name
from heli_gym.baselines.evaluation.conditions import nominal_rig
from heli_gym.baselines.evaluation.digests import learned_digest, reference_digest, rig_digest
from heli_gym.baselines.evaluation.metrics import HALVING_ERROR, Metrics, flight_metrics
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.baselines.planning.sampler import ManeuverSampler
from heli_gym.cli import command, parse
from heli_gym.env import reference_for
from heli_gym.parameters import Limits
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.rig import PAPER, find_rig, same_dynamics
from heli_gym.storage import atomic_write, check_folder, read_json_object, try_lock
from heli_gym.task import control_steps
from heli_gym.train import apg
from heli_gym.train.apg import APG
from heli_gym.train.asymmetric import AsymmetricPolicy
from heli_gym.train.checkpoint import last_checkpoint, save_checkpoint
from heli_gym.train.vec_env import ResidualVecEnv
from heli_gym.trajectory import Trajectory
from heli_gym.validation import require, shown
from heli_gym.vector_env import Heli3DOFVectorEnv

CONTROL_PERIOD = 0.02  # s
START_SPREAD_DEG = 5.0
VALIDATION_SEED = HELD_OUT_SEED // 2  # seeds of training are smaller, seeds of evaluations greater
DRAWN = "drawn"
DRAWN_DURATIONS = (8.0, 10.0, 12.0, 15.0)  # s
EARLY_END_PENALTY = 100.0  # score penalty for zero flight time
SCRATCH = "middle-voltage"  # base of an agent that flies alone: the middle of the voltage range


@dataclass(frozen=True)
class Args:
    """Train an agent. Settings without a value have the learner's default; see `DEFAULTS`."""

    algo: Literal["apg", "ppo", "recurrent-ppo", "sac", "td3", "tqc"] = "apg"
    plant: str = "lab"  # plant of the training, lab, rigid or fleet; every flight draws it anew
    mode: Literal["residual", "scratch"] = "residual"  # correct the base policy, or fly alone
    base: str = ""  # policy to correct; by default "feedforward+tvlqr@PLANT", the paper's with weights for the plant
    scale: float | None = None  # V, greatest correction; by default the amplifier's range, alone half of it
    law: Literal["saturated", "sum"] = "saturated"  # of `residual.LAWS`
    memory: bool = True  # APG: whether the network remembers
    feature_groups: tuple[str, ...] | None = None  # inputs of the agent, of `residual.FEATURE_GROUPS`
    privileged: bool = True  # PPO: the critic also reads true errors and the plant's draw
    objective: Literal["tracking", "environment"] = "tracking"  # travel, elevation and cost, or the full reward
    reference: str = "travel-360"  # or "drawn", for APG: random maneuvers, for a policy for any
    references: int = 32  # APG: number of drawn references
    rig: str | None = None  # rig of the training, a name or a .toml file; by default the plant's
    force: bool = False  # fly a plan even if it is for another rig
    seed: int = 0
    steps: int | None = None  # control periods of training, over all helicopters
    envs: int | None = None  # number of parallel helicopters
    chunk: int | None = None  # control periods of each helicopter between two validations
    init: Path | None = None  # APG: learned policy (.json) with the initial network
    cell: int = 96  # APG and recurrent PPO: hidden states of the GRU cell
    hidden: tuple[int, ...] = (64, 64)  # other learners: neurons of the layers
    learning_rate: float | None = None  # initial value; it falls linearly to a twentieth
    max_grad_norm: float = 2.0  # APG: greatest norm of the clipped gradient
    cost_weight: float = 0.35  # APG: weight of the cost, in degrees of RMS error per second
    elevation_weight: float = 1.0  # APG: weight of the elevation error; the travel error has weight 1
    pitch_penalty: float = 20.0  # APG: 1/(s rad²), penalty of the squared pitch beyond 63 degrees
    after_crash: bool = False  # APG: the loss counts a crashed flight to the end of the maneuver
    gamma: float = 0.99  # discount per control period
    gae_lambda: float = 0.97  # PPO: advantage estimate; travel reacts to a voltage after a second
    log_std: float = -2.7  # initial logarithm of the exploration's standard deviation; PPO's is that of its weights
    hold: int = 32  # PPO: control periods with constant exploration weights
    rollout: int = 64  # PPO: control periods of each helicopter between two updates
    batch: int = 2048  # PPO: transitions in a gradient step
    epochs: int = 5  # PPO: passes over the transitions of an update
    buffer: int = 300_000  # SAC, TD3, TQC: transitions in the replay buffer
    validation: int = 64  # number of validation helicopters
    out: Path = Path("out/train")  # folder of the runs' folders
    resume: bool = False  # continue an interrupted run with the same settings
    progress: bool = True  # show a progress bar


ON_POLICY, OFF_POLICY = ("ppo", "recurrent-ppo"), ("sac", "td3", "tqc")
OF_STABLE_BASELINES: dict[str, Any] = {
    "feature_groups": tuple(FEATURE_GROUPS),
    "steps": 3_000_000,
    "envs": 512,
    "chunk": 256,
    "learning_rate": 1e-3,
}
DEFAULTS: dict[str, dict[str, Any]] = {
    "apg": {
        "feature_groups": SINGLE_GROUPS,
        "steps": 64_000_000,
        "envs": apg.LANES,
        "chunk": 15_000,
        "learning_rate": 4e-3,
    },
    **dict.fromkeys(ON_POLICY + OFF_POLICY, OF_STABLE_BASELINES),
}


@dataclass(frozen=True)
class CompleteArgs(Args):
    """Complete settings, from `with_defaults`."""

    scale: float = field(kw_only=True)
    rig: str = field(kw_only=True)
    feature_groups: tuple[str, ...] = field(kw_only=True)
    steps: int = field(kw_only=True)
    envs: int = field(kw_only=True)
    chunk: int = field(kw_only=True)
    learning_rate: float = field(kw_only=True)


def with_defaults(args: Args) -> CompleteArgs:
    """Settings completed with the learner's defaults, the plant's rig and the name of the base."""
    rig = nominal_rig(args.plant, args.rig)
    missing = {name: value for name, value in DEFAULTS[args.algo].items() if getattr(args, name) is None}
    if args.scale is None:
        low, high = find_rig(rig).voltage_limits
        missing["scale"] = 0.5 * (high - low) if args.mode == "scratch" else high - low
    own = tuned_name("feedforward+tvlqr@PLANT", args.plant, find_rig(rig))
    base = SCRATCH if args.mode == "scratch" else args.base or own
    return CompleteArgs(**{**vars(args), "rig": rig, "base": base, **missing})


# Bounds of the settings: larger values would fill the memory, or overflow, minutes after the start.
MOST_TRANSITIONS, MOST_NEURONS, MOST_LAYERS = 10**7, 4096, 16
SIZES = {
    "references": (1, 10_000),
    "steps": (1, 10**13),
    "envs": (1, 100_000),
    "chunk": (1, 10**7),
    "cell": (1, MOST_NEURONS),
    "hold": (1, 10**7),
    "rollout": (1, 10**6),
    "batch": (2, MOST_TRANSITIONS),
    "epochs": (1, 1000),
    "buffer": (1, MOST_TRANSITIONS),
    "validation": (1, 100_000),
}
RANGES = {
    "scale": (1e-6, 1000.0),
    "learning_rate": (1e-9, 1.0),
    "max_grad_norm": (1e-9, 1e6),
    "cost_weight": (0.0, 1e6),
    "elevation_weight": (0.0, 1e6),
    "pitch_penalty": (0.0, 1e6),
    "log_std": (-20.0, 2.0),
    "gamma": (0.0, 1.0),
    "gae_lambda": (0.0, 1.0),
}


def check(args: CompleteArgs) -> None:
    """Raise ValueError for invalid settings."""
    for name, (least, most) in SIZES.items():
        require(name, getattr(args, name), least <= getattr(args, name) <= most, f"{least} to {most}")
    if not 1 <= len(args.hidden) <= MOST_LAYERS or not all(1 <= n <= MOST_NEURONS for n in args.hidden):
        raise ValueError(
            f"hidden = {shown(args.hidden)}: must be 1 to {MOST_LAYERS} layers, each of 1 to {MOST_NEURONS} neurons"
        )
    for name, (low, high) in RANGES.items():
        require(name, getattr(args, name), low <= getattr(args, name) <= high, f"{low:g} to {high:g}")
    if args.algo in ON_POLICY and args.rollout * args.envs > MOST_TRANSITIONS:
        raise ValueError(
            f"rollout = {args.rollout}: must be 1 to {MOST_TRANSITIONS // args.envs} with envs = {args.envs}, "
            "which fit the memory"
        )
    if args.base.partition("@")[0] not in POLICIES:
        raise ValueError(f"base = {args.base!r}: must be one of {', '.join(map(repr, POLICIES))}")
    if args.reference == DRAWN and args.algo != "apg":
        raise ValueError(f"reference = {DRAWN!r}: must be one maneuver for {args.algo}")
    if args.algo == "apg" and args.mode == "scratch":
        raise ValueError("mode = 'scratch': must be 'residual' for apg, which differentiates a base policy")
    if not 0 <= args.seed < 10_000:
        raise ValueError(f"seed = {args.seed}: must be 0 to 9999")
    if args.algo in ON_POLICY and args.chunk % args.rollout:
        raise ValueError(f"chunk = {args.chunk}: must be a multiple of rollout = {args.rollout}")
    # Seeds of `learn`: no chunk uses the draws of another run or of the validation.
    chunks, draws = chunks_of(args), draws_of(args)
    if chunks > 1000:
        raise ValueError(
            f"steps = {args.steps}: {chunks} chunks of {args.chunk} x {args.envs} steps, and at most 1000 "
            "have seeds of their own; a longer chunk makes fewer"
        )
    if (1000 * args.seed + chunks) * draws > VALIDATION_SEED:
        raise ValueError(
            f"seed = {args.seed}: with {chunks} chunks of {draws} draws each, the validation's draws would be trained "
            f"on; (1000 seed + chunks) draws must be at most {VALIDATION_SEED}"
        )
    check_folder("out", args.out)


def chunks_of(args: CompleteArgs) -> int:
    """Number of chunks in a run."""
    return -(-args.steps // (args.chunk * args.envs))


def draws_of(args: CompleteArgs) -> int:
    """Number of seeds in a chunk."""
    if args.algo != "apg":
        return args.envs  # later flights of a helicopter continue its generator
    shortest = min(reference.duration for reference in references_of(args))
    return args.envs * -(-args.chunk // control_steps(shortest, CONTROL_PERIOD))


@cache
def planned_reference(reference: str, rig: str, force: bool) -> Trajectory:
    """Cached `reference_for`."""
    return reference_for(reference, rig, force)


def references_of(args: Args) -> list[Trajectory]:
    """References of the training."""
    if args.reference == DRAWN:
        return drawn_references(args.rig, 1000 * args.seed, args.references)
    return [planned_reference(args.reference, args.rig, args.force)]


def validation_references(args: Args) -> list[Trajectory]:
    """References of the validation; drawn ones are others than those of any training."""
    return drawn_references(args.rig, VALIDATION_SEED, 8) if args.reference == DRAWN else references_of(args)


@cache
def drawn_references(rig: str, seed: int, count: int) -> list[Trajectory]:
    """Plans of random maneuvers within the limits (9), of different durations, with seeds from `seed` on."""
    drawn = []
    for k in range(seed, seed + count):
        rng = np.random.default_rng(k)
        duration = DRAWN_DURATIONS[k % len(DRAWN_DURATIONS)]
        drawn.append(ManeuverSampler(duration, limits=Limits(), rig=find_rig(rig))(rng))
    return drawn


def run_folder(args: CompleteArgs) -> Path:
    """Folder of a run, by plant, method and seed."""
    method = f"{args.algo}-{args.base}" if args.mode == "residual" else f"{args.algo}-scratch"
    for name in (
        *(group for group in DEFAULTS[args.algo]["feature_groups"] if group not in args.feature_groups),
        *([] if args.privileged else ["privileged"]),
        *([] if args.memory else ["memory"]),
        *([] if args.law == "saturated" else ["inner-saturation"]),
    ):
        method += f"-without-{name}"
    if args.reference == DRAWN:
        method += "-any-maneuver"
    if args.init:
        method += "-initialised"
    rig = find_rig(args.rig)
    plant = args.plant if same_dynamics(rig, PAPER) else f"{args.plant}.{rig.name}"
    return args.out / plant / method / str(args.seed)


def settings_of(args: Args) -> dict[str, Any]:
    """Settings that determine a run, as plain JSON."""
    ours = {name: value for name, value in asdict(args).items() if name not in ("out", "resume", "progress")}
    return json.loads(json.dumps(ours, default=str))


def settings_and_files(args: Args) -> dict[str, Any]:
    """Settings that determine a run and, if they name files, the digests of these by setting, as "sha256"."""
    digests = digests_of(args)
    return {**settings_of(args), **({"sha256": digests} if digests else {})}


def digests_of(args: Args) -> dict[str, str]:
    """Digests of the files that settings name, by setting."""
    digests = {
        "init": learned_digest(args.init) if args.init else "",
        "reference": reference_digest(args.reference),
        "rig": rig_digest(args.rig or ""),
    }
    return {name: digest for name, digest in digests.items() if digest}


def check_begun(args: Args, folder: Path) -> bool:
    """Whether the folder holds a run to continue.

    Raises ValueError for a run with other settings or files, or for any run without --resume.
    """
    path = folder / "settings.json"
    if not path.is_file():
        return False
    if not args.resume:
        raise ValueError(f"out: {folder} holds a run already; --resume goes on with it")
    begun = read_json_object(path)
    ours = settings_of(args)
    for name in ours:
        if begun.get(name) != ours[name]:
            raise ValueError(f"{name} = {ours[name]!r}: the run in {folder} was begun with {begun.get(name)!r}")
    known = begun.get("sha256", {})
    for name, digest in digests_of(args).items():
        if isinstance(known, dict) and known.get(name, digest) != digest:
            raise ValueError(f"{name} = {ours[name]!r}: has changed since the run in {folder} was begun")
    return True


# Helicopters and agent


def make_residual_policy(args: CompleteArgs, reference: Any, network: Any = None) -> ResidualPolicy:
    """Residual policy of the settings, with a network, or without one for an agent in its place."""
    return ResidualPolicy(
        make_policy(args.base, reference),
        reference,
        network,
        args.scale,
        CONTROL_PERIOD,
        reference.rig.voltage_limits,
        feature_groups=args.feature_groups,
        law=args.law,
        ahead=apg.AHEAD if args.algo == "apg" else AHEAD,
    )


def make_helicopters(args: CompleteArgs) -> list[Heli3DOFVectorEnv] | ResidualVecEnv:
    """Helicopters of the training; for APG on each of its references."""
    fleets = [
        Heli3DOFVectorEnv(
            args.envs, args.plant, reference, start_spread_deg=START_SPREAD_DEG, autoreset_mode="SameStep", rig=args.rig
        )
        for reference in references_of(args)
    ]
    if args.algo == "apg":
        return fleets
    envs, reference = fleets[0], fleets[0].reference_of(0)
    privileged = args.privileged and args.algo == "ppo"
    policy = make_residual_policy(args, reference)
    return ResidualVecEnv(envs, policy, args.objective, privileged=privileged, discount=args.gamma)


def make_agent(args: CompleteArgs, helicopters: Any, first: torch.nn.Module | None = None) -> APG | BaseAlgorithm:
    """New agent with small initial actions: its last layer is near zero. `first` is an argument of APG."""
    if args.algo == "apg":
        agent = APG(
            [make_residual_policy(args, reference) for reference in references_of(args)],
            helicopters,
            args.learning_rate,
            hidden=args.cell,
            max_grad_norm=args.max_grad_norm,
            cost_weight=args.cost_weight,
            elevation_weight=args.elevation_weight,
            pitch_penalty=args.pitch_penalty,
            after_crash=args.after_crash,
            memory=args.memory,
            seed=args.seed,
            first=first,
        )
        if args.init:
            apg.set_network(agent.policy, load_learned(args.init)[1])
        return agent
    common: dict[str, Any] = {
        "learning_rate": args.learning_rate,
        "gamma": args.gamma,
        "seed": args.seed,
        "device": "cpu",
    }
    networks: dict[str, Any] = {"net_arch": list(args.hidden), "activation_fn": torch.nn.Tanh}
    if args.algo in ON_POLICY:
        on_policy = {
            **common,
            "n_steps": args.rollout,
            "batch_size": args.batch,
            "n_epochs": args.epochs,
            "gae_lambda": args.gae_lambda,
            # White noise at 50 Hz hardly moves a helicopter; exploration with constant weights does.
            "use_sde": True,
            "sde_sample_freq": args.hold,
        }
        exploration = {"log_std_init": args.log_std}
        if args.algo == "ppo":
            kwargs = {**networks, **exploration, "n_actor_features": helicopters.n_actor_features}
            return PPO(AsymmetricPolicy, helicopters, policy_kwargs=kwargs, **on_policy)
        from sb3_contrib import RecurrentPPO

        from heli_gym.train.recurrent import GruPolicy

        kwargs = {**exploration, "lstm_hidden_size": args.cell}
        return RecurrentPPO(GruPolicy, helicopters, policy_kwargs=kwargs, **on_policy)
    # one gradient step per control period of all helicopters, with a large batch
    off_policy: dict[str, Any] = {"buffer_size": args.buffer, "batch_size": 1024, "train_freq": 1, "gradient_steps": 1}
    env_kwargs: dict[str, Callable] = {"sac": SAC, "td3": TD3}
    if args.algo == "tqc":
        from sb3_contrib import TQC

        env_kwargs["tqc"] = TQC
    if args.algo == "td3":  # its actor is deterministic
        off_policy["action_noise"] = NormalActionNoise(np.zeros(2), np.full(2, np.exp(args.log_std)))
    agent = env_kwargs[args.algo](
        "MlpPolicy", helicopters, policy_kwargs=networks, learning_starts=0, **off_policy, **common
    )
    with torch.no_grad():
        last = agent.actor.mu if args.algo != "td3" else agent.actor.mu[-2]
        last.weight.mul_(0.01), last.bias.mul_(0.01)
        if args.algo == "td3":
            agent.actor_target.load_state_dict(agent.actor.state_dict())
        else:
            agent.actor.log_std.weight.mul_(0.01), agent.actor.log_std.bias.fill_(args.log_std)
    return agent


def network_of(agent: APG | BaseAlgorithm) -> Network | RecurrentNetwork:
    """Copy of the agent's deterministic network in numpy."""
    if isinstance(agent, APG):
        return apg.network_of(agent.policy)
    policy: Any = agent.policy
    recurrent = hasattr(policy, "lstm_actor")
    if recurrent:
        modules, tanh_output = [policy.action_net], False
    elif isinstance(agent, PPO):
        modules, tanh_output = [*policy.mlp_extractor.policy_net, policy.action_net], False
    elif isinstance(agent, TD3):
        modules, tanh_output = [*policy.actor.mu], True
    else:
        modules, tanh_output = [*policy.actor.latent_pi, policy.actor.mu], True
    layers = [module for module in modules if isinstance(module, torch.nn.Linear)]
    weights, biases = (
        [getattr(layer, name).detach().numpy().astype(float) for layer in layers] for name in ("weight", "bias")
    )
    network = Network(tuple(weights), tuple(biases), tanh_output)
    if not recurrent:
        return network
    cell = zip(CELL, policy.lstm_actor.parameters())
    return RecurrentNetwork(**{name: t.detach().numpy().astype(float) for name, t in cell}, head=network)


def validate(
    args: CompleteArgs, agent: APG | BaseAlgorithm | None, fleets: list[Heli3DOFVectorEnv], seed: int
) -> dict[str, Any]:
    """Mean metrics of flights with seeds from `seed` on, with the agent or, without one, the base alone."""
    network = network_of(agent) if agent else lambda features: np.zeros((2, *features.shape[1:]))
    metrics: list[Metrics] = []
    for envs in fleets:
        reference = envs.reference_of(0)
        flights = fly_many(envs, make_residual_policy(args, reference, network), seed + len(metrics))
        metrics += [flight_metrics(flight, reference, envs.voltage_limits, envs.pitch_limit) for flight in flights]
    return {name: np.mean([getattr(m, name) for m in metrics], axis=0).tolist() for name in Metrics._fields}


def score(args: Args, row: dict[str, Any]) -> float:
    """Score for the choice of the best network: the return, or a penalty of errors, cost and early ends."""
    if args.objective == "environment":
        return row["episode_return"]
    travel, elevation = np.radians(row["rms_error_deg"][:2]) / HALVING_ERROR
    duration = np.mean([reference.duration for reference in validation_references(args)])
    missing_share = 1.0 - row["flown"] / float(duration)
    return row["success"] - 0.5 * (travel + elevation) - 0.25 * row["cost"] - EARLY_END_PENALTY * missing_share


# Training


def train(
    args: Args,
    console: Console,
    stop_after: int | None = None,
    after_chunk: Callable[[int], None] | None = None,
) -> Path:
    """Train, or continue, and return the folder of the run; `stop_after` chunks it stops like an interrupt.

    Calls `after_chunk` with the number of chunks so far, after each checkpoint. Raises ValueError for wrong settings,
    and while another process trains in this folder.
    """
    args = with_defaults(args)
    check(args)
    folder = run_folder(args)
    check_begun(args, folder)
    torch.set_num_threads(1)
    helicopters = make_helicopters(args)
    references = validation_references(args)
    validation_envs = [
        Heli3DOFVectorEnv(
            -(-args.validation // len(references)),
            args.plant,
            reference,
            start_spread_deg=START_SPREAD_DEG,
            rig=args.rig,
        )
        for reference in references
    ]
    agent = make_agent(args, helicopters)
    (folder / "checkpoints").mkdir(parents=True, exist_ok=True)  # after all checks: an error leaves no folder
    with open(folder / ".lock", "ab") as lock:
        if not try_lock(lock):
            raise ValueError(f"out: another heli-train is at work in {folder}")
        train_in(folder, args, agent, helicopters, validation_envs, console, stop_after, after_chunk)
    return folder


def train_in(
    folder: Path,
    args: CompleteArgs,
    agent: APG | BaseAlgorithm,
    helicopters: Any,
    validation_envs: list[Heli3DOFVectorEnv],
    console: Console,
    stop_after: int | None,
    after_chunk: Callable[[int], None] | None,
) -> None:
    """Train, or continue, in a locked folder."""
    name = "/".join(folder.parts[-3:])
    begun = check_begun(args, folder)  # another process may have begun, or gone on, before the lock was taken
    checkpoint = last_checkpoint(folder / "checkpoints") if begun else None
    agent.set_logger(configure(str(folder), ["tensorboard"]))

    history: list[dict[str, Any]] = []
    if checkpoint:
        history = restore(agent, checkpoint)
    else:
        history.append({"steps": 0, "seconds": 0.0, **validate(args, None, validation_envs, VALIDATION_SEED)})
        write_json(folder / "settings.json", settings_and_files(args))
    best_so_far = max((score(args, row) for row in history[1:]), default=-np.inf)

    chunks = chunks_of(args)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, disable=not args.progress) as progress:
        bar = progress.add_task(name, total=chunks, completed=len(history) - 1)
        for number in range(len(history) - 1, chunks if stop_after is None else min(chunks, stop_after)):
            begin = time.process_time()
            learn(args, agent, helicopters, number, chunks)
            seconds = history[-1]["seconds"] + time.process_time() - begin
            result = validate(args, agent, validation_envs, VALIDATION_SEED)
            row = {"steps": agent.num_timesteps, "seconds": seconds, **result}
            history.append(row)
            if score(args, row) > best_so_far:
                best_so_far = score(args, row)
                save_learned(folder / "best", learned_settings(args, agent), network_of(agent))
            for metric, value in row.items():
                agent.logger.record(f"validation/{metric}", np.mean(value))
            agent.logger.dump(agent.num_timesteps)
            write_json(folder / "history.json", history)
            save_checkpoint(folder / "checkpoints", number, state_of(agent, history))
            if after_chunk:
                after_chunk(number + 1)
            travel, elevation, _ = row["rms_error_deg"]
            progress.update(
                bar,
                advance=1,
                description=f"{name}: return {row['episode_return']:.2f} s, RMS {travel:.2f}°, {elevation:.2f}°",
            )


def learn(args: CompleteArgs, agent: APG | BaseAlgorithm, helicopters: Any, number: int, chunks: int) -> None:
    """Learn for one chunk, with random numbers that depend only on the seed and the number of the chunk.

    Therefore a run that repeats its interrupted chunk ends with the same weights.
    """
    seed = 1000 * args.seed + number
    set_random_seed(seed)
    if isinstance(agent, APG):
        agent.next_seed = seed * draws_of(args)
    else:
        agent.action_space.seed(seed)
        helicopters.seed(seed * draws_of(args))
        agent._last_obs = None  # makes Stable-Baselines3 reset the helicopters
    rate = args.learning_rate * (1.0 - 0.95 * number / chunks)
    agent.lr_schedule = lambda _: rate
    agent.learn(args.chunk * args.envs, reset_num_timesteps=False, log_interval=10**9)


def state_of(agent: APG | BaseAlgorithm, history: list[dict[str, Any]]) -> dict[str, Any]:
    """State that determines the rest of a run."""
    variables = [] if isinstance(agent, APG) else agent._get_torch_save_params()[1]
    state = {
        "history": json.dumps(history),
        "parameters": agent.get_parameters(),
        "variables": {name: getattr(agent, name) for name in variables if getattr(agent, name) is not None},
        "steps": agent.num_timesteps,
        "updates": agent._n_updates,
    }
    buffer = getattr(agent, "replay_buffer", None)
    if buffer is not None:
        state["buffer"] = {name: torch.from_numpy(getattr(buffer, name)) for name in BUFFER}
        state["position"], state["full"] = buffer.pos, buffer.full
    return state


BUFFER = ("observations", "next_observations", "actions", "rewards", "dones", "timeouts")


def restore(agent: APG | BaseAlgorithm, state: dict[str, Any]) -> list[dict[str, Any]]:
    """Restore the agent from a state, and return the history of its run."""
    agent.set_parameters(state["parameters"])
    for name, value in state["variables"].items():
        getattr(agent, name).data.copy_(value)
    agent.num_timesteps, agent._n_updates = state["steps"], state["updates"]
    buffer = getattr(agent, "replay_buffer", None)
    if buffer is not None:
        for name, value in state["buffer"].items():
            getattr(buffer, name)[:] = value.numpy()
        buffer.pos, buffer.full = state["position"], state["full"]
    return json.loads(state["history"])


def learned_settings(args: CompleteArgs, agent: APG | BaseAlgorithm) -> Learned:
    """Settings to store with the network."""
    residual = agent.residual if isinstance(agent, APG) else agent.get_env().policy  # type: ignore[union-attr]
    network = network_of(agent)
    if isinstance(network, RecurrentNetwork):
        head, features, recurrent = network.head, network.weight_input.shape[1], network.size
    else:
        head, features, recurrent = network, network.weights[0].shape[1], 0
    return Learned(
        base=args.base,
        scale=args.scale,
        reference=args.reference,
        plant=args.plant,
        control_period=CONTROL_PERIOD,
        features=features,
        hidden=tuple(map(len, head.biases[:-1])),
        tanh_output=head.tanh_output,
        feature_groups=residual.feature_groups,
        law=residual.law,
        ahead=residual.ahead,
        recurrent=recurrent,
        rig="" if same_dynamics(find_rig(args.rig), PAPER) else find_rig(args.rig).to_toml(),
    )


def write_json(path: Path, value: Any) -> None:
    """Write a value as JSON, atomically."""
    with atomic_write(path) as file:
        file.write((json.dumps(value, indent=2, default=str) + "\n").encode())


def main() -> None:
    """Run the command `heli-train`."""
    with command("heli-train"):
        console = Console()
        folder = train(parse(Args, "heli-train", __doc__), console)
        first, *_, last = json.loads((folder / "history.json").read_text(encoding="utf-8"))
        console.print(
            f"validation: return {first['episode_return']:.2f} s before, {last['episode_return']:.2f} s after\n"
            f"{folder}/best.safetensors: the best network; heli-evaluate --policies {folder}/best.json flies it"
        )


if __name__ == "__main__":
    main()
