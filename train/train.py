"""`heli-train`: an agent of Stable-Baselines3 learns to correct a controller, or to fly alone.

Read it from top to bottom: the settings; the helicopters and the agent; training, in chunks after each of which the
agent is validated and the run is saved; what is left in the folder of the run:

    settings.json   what was asked for
    best.*          the network that was best on the validation helicopters: what `heli-evaluate` can fly
    history.json    the validation after each chunk
    checkpoints/    the last two states of the run, to go on from with --resume
    events.*        TensorBoard's
"""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import torch
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn
from stable_baselines3 import PPO, SAC, TD3
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.logger import configure
from stable_baselines3.common.utils import set_random_seed

from heli_gym.baselines.control.policies import POLICIES, make_policy
from heli_gym.baselines.control.residual import FEATURE_GROUPS, Learned, Network, ResidualPolicy, save_learned
from heli_gym.baselines.evaluation.metrics import ONE, Metrics, flight_metrics
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.cli import command, parse
from heli_gym.env import find_reference
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.storage import atomic_write, check_folder
from heli_gym.train.asymmetric import AsymmetricPolicy
from heli_gym.train.checkpoint import last_checkpoint, save_checkpoint
from heli_gym.train.vec_env import ResidualVecEnv
from heli_gym.vector_env import Heli3DOFVectorEnv

START_SPREAD_DEG = 5.0
VALIDATION_SEED = HELD_OUT_SEED // 2  # training's seeds stay below, those of evaluations above
EARLY_END_PENALTY = 100.0  # what it takes off the score of a network to fly no time at all; more than errors can save
SCRATCH = "middle-voltage"  # the base of an agent that flies alone, from the middle of the voltages


@dataclass(frozen=True)
class Args:
    """Train an agent."""

    algo: Literal["ppo", "sac", "td3", "tqc"] = "ppo"
    plant: str = "lab"  # that is drawn anew in every flight: lab or rigid
    mode: Literal["residual", "scratch"] = "residual"  # whether the agent corrects the base policy or flies alone
    base: str = ""  # the policy that is corrected; by default "kalman-lqr@PLANT", tuned for what the agent learns too
    scale: float = 3.0  # V, the greatest correction
    feature_groups: tuple[str, ...] = tuple(
        FEATURE_GROUPS
    )  # what of `heli_gym.baselines.control.residual.FEATURE_GROUPS` the agent is shown
    privileged: bool = True  # PPO: whether its critic sees the true errors and the draw of the plant too
    objective: Literal["tracking", "environment"] = "tracking"  # travel, elevation and cost, or the whole reward
    reference: str = "travel-360"
    seed: int = 0
    steps: int = 3_000_000  # control periods that are flown in training, of all helicopters together
    envs: int = 512  # helicopters at once
    chunk: int = 256  # control periods of each between two validations
    hidden: tuple[int, ...] = (64, 64)  # neurons of the layers of the networks
    learning_rate: float = 1e-3  # at first; it falls linearly to a tenth
    gamma: float = 0.99  # discount per control period
    gae_lambda: float = 0.97  # PPO: of the advantage estimate; what a voltage does to travel takes a second to be seen
    log_std: float = -2.7  # PPO: logarithm of the standard deviation of the exploration's weights, at first
    hold: int = 32  # PPO: control periods for which the exploration keeps its direction
    rollout: int = 64  # PPO: control periods of each helicopter between two updates
    batch: int = 2048  # PPO: transitions of a gradient step
    epochs: int = 5  # PPO: passes over the transitions of an update
    buffer: int = 300_000  # SAC, TD3, TQC: transitions that are remembered
    validation: int = 64  # helicopters on which the agent is judged
    out: Path = Path("out/train")  # folder, a run being one in it
    resume: bool = False  # go on with the run of the same settings, if it was interrupted
    progress: bool = True  # whether to show a bar


def check(args: Args) -> None:
    """Raises ValueError for settings that make no sense."""
    for name in ("steps", "envs", "chunk", "rollout", "batch", "epochs", "buffer", "validation"):
        if getattr(args, name) < 1:
            raise ValueError(f"{name} = {getattr(args, name)}: must be at least 1")
    if base_of(args).partition("@")[0] not in POLICIES:
        raise ValueError(f"base = {args.base!r}: must be one of {', '.join(map(repr, POLICIES))}")
    if not 0 <= args.seed < 10_000:
        raise ValueError(f"seed = {args.seed}: must be 0 to 9999")
    if args.chunk % args.rollout:
        raise ValueError(f"chunk = {args.chunk}: must be a multiple of rollout = {args.rollout}")
    # The seeds of `learn`: no chunk flies the draws of another seed's run, nor those of the validation.
    chunks = chunks_of(args)
    if chunks > 1000:
        raise ValueError(
            f"steps = {args.steps}: {chunks} chunks of {args.chunk} x {args.envs} steps, and at most 1000 "
            "have seeds of their own; a longer chunk makes fewer"
        )
    if (1000 * args.seed + chunks) * args.envs > VALIDATION_SEED:
        raise ValueError(
            f"seed = {args.seed}: with envs = {args.envs} and {chunks} chunks, the validation's draws would be trained "
            f"on; (1000 seed + chunks) envs must be at most {VALIDATION_SEED}"
        )
    check_folder("out", args.out)


def chunks_of(args: Args) -> int:
    """How many chunks the steps take."""
    return -(-args.steps // (args.chunk * args.envs))


def base_of(args: Args) -> str:
    """The name of the policy that is corrected."""
    return args.base or f"kalman-lqr@{args.plant}"


def run_folder(args: Args) -> Path:
    """Where the run with these settings leaves what it leaves: a folder for each plant, method and seed."""
    method = f"{args.algo}-{base_of(args)}" if args.mode == "residual" else f"{args.algo}-scratch"
    for name in (
        *(group for group in FEATURE_GROUPS if group not in args.feature_groups),
        *([] if args.privileged else ["privileged"]),
    ):
        method += f"-without-{name}"
    return args.out / args.plant / method / str(args.seed)


def settings_of(args: Args) -> dict[str, Any]:
    """What a run depends on, as JSON has it."""
    ours = {name: value for name, value in asdict(args).items() if name not in ("out", "resume", "progress")}
    return json.loads(json.dumps({**ours, "base": base_of(args)}))


def check_begun(args: Args, folder: Path) -> bool:
    """Whether there is a run in this folder to go on with.

    Raises ValueError if there is one that is not to be gone on with, or one that was begun with other settings.
    """
    path = folder / "settings.json"
    if not path.is_file():
        return False
    if not args.resume:
        raise ValueError(f"out: {folder} holds a run already; --resume goes on with it")
    begun, ours = json.loads(path.read_text()), settings_of(args)
    for name in ours:
        if begun.get(name) != ours[name]:
            raise ValueError(f"{name} = {ours[name]!r}: the run in {folder} was begun with {begun.get(name)!r}")
    return True


# The helicopters and the agent


def make_residual_policy(args: Args, reference: Any, network: Any = None) -> ResidualPolicy:
    """The policy that is learnt, with a network of its own or with the agent in its place."""
    if args.mode == "scratch":
        return ResidualPolicy(
            make_policy(SCRATCH, reference), reference, network, 6.0, feature_groups=args.feature_groups
        )
    return ResidualPolicy(
        make_policy(base_of(args), reference), reference, network, args.scale, feature_groups=args.feature_groups
    )


def make_agent(args: Args, helicopters: ResidualVecEnv) -> BaseAlgorithm:
    """The agent, whose first actions are small: its last layer is near zero."""
    common: dict[str, Any] = {
        "learning_rate": args.learning_rate,
        "gamma": args.gamma,
        "seed": args.seed,
        "device": "cpu",
    }
    networks: dict[str, Any] = {"net_arch": list(args.hidden), "activation_fn": torch.nn.Tanh}
    if args.algo == "ppo":
        return PPO(
            AsymmetricPolicy,
            helicopters,
            n_steps=args.rollout,
            batch_size=args.batch,
            n_epochs=args.epochs,
            gae_lambda=args.gae_lambda,
            # White noise at 50 Hz hardly moves a helicopter: explore with one direction for a while.
            use_sde=True,
            sde_sample_freq=args.hold,
            policy_kwargs={**networks, "log_std_init": args.log_std, "n_actor_features": helicopters.n_actor_features},
            **common,
        )
    # one gradient step per control period of all helicopters, with a batch that is large enough for them
    off_policy = {"buffer_size": args.buffer, "batch_size": 1024, "train_freq": 1, "gradient_steps": 1}
    env_kwargs: dict[str, Callable] = {"sac": SAC, "td3": TD3}
    if args.algo == "tqc":
        from sb3_contrib import TQC

        env_kwargs["tqc"] = TQC
    agent = env_kwargs[args.algo](
        "MlpPolicy", helicopters, policy_kwargs=networks, learning_starts=0, **off_policy, **common
    )
    with torch.no_grad():
        last = agent.actor.mu if args.algo != "td3" else agent.actor.mu[-2]
        last.weight.mul_(0.01), last.bias.mul_(0.01)
        if args.algo != "td3":
            agent.actor.log_std.weight.mul_(0.01), agent.actor.log_std.bias.fill_(args.log_std)
    return agent


def network_of(agent: BaseAlgorithm) -> Network:
    """What the agent does without exploring, for numpy."""
    policy: Any = agent.policy
    if isinstance(agent, PPO):
        modules, tanh_output = [*policy.mlp_extractor.policy_net, policy.action_net], False
    elif isinstance(agent, TD3):
        modules, tanh_output = [*policy.actor.mu], True
    else:
        modules, tanh_output = [*policy.actor.latent_pi, policy.actor.mu], True
    layers = [module for module in modules if isinstance(module, torch.nn.Linear)]
    weights, biases = (
        [getattr(layer, name).detach().numpy().astype(float) for layer in layers] for name in ("weight", "bias")
    )
    return Network(tuple(weights), tuple(biases), tanh_output)


def validate(args: Args, agent: BaseAlgorithm | None, envs: Heli3DOFVectorEnv, seed: int) -> dict[str, Any]:
    """Means over flights of the helicopters, seeded from `seed` on, with the agent or, without one, the base alone."""
    reference = envs.reference_of(0)
    network = network_of(agent) if agent else lambda features: np.zeros((2, *features.shape[1:]))
    flights = fly_many(envs, make_residual_policy(args, reference, network), seed)
    metrics = [flight_metrics(flight, reference, envs.voltage_limits) for flight in flights]
    return {name: np.mean([getattr(m, name) for m in metrics], axis=0).tolist() for name in Metrics._fields}


def score(args: Args, row: dict[str, Any]) -> float:
    """What decides which network is the best: the return, or small errors and few failures."""
    if args.objective == "environment":
        return row["episode_return"]
    travel, elevation = np.radians(row["rms_error_deg"][:2]) / ONE
    unflown = 1.0 - row["flown"] / find_reference(args.reference).duration  # errors are of the time flown only
    return row["success"] - 0.5 * (travel + elevation) - EARLY_END_PENALTY * unflown


# Training


def train(args: Args, console: Console, stop_after: int | None = None) -> Path:
    """Trains, or goes on, and returns the folder of the run; `stop_after` so many chunks, as if interrupted."""
    check(args)
    folder = run_folder(args)
    name = "/".join(folder.parts[-3:])
    begun = check_begun(args, folder)
    torch.set_num_threads(1)
    reference = find_reference(args.reference)
    env_kwargs: dict[str, Any] = {"plant": args.plant, "reference": reference, "start_spread_deg": START_SPREAD_DEG}
    helicopters = ResidualVecEnv(
        Heli3DOFVectorEnv(args.envs, autoreset_mode="SameStep", **env_kwargs),
        make_residual_policy(args, reference),
        args.objective,
        privileged=args.privileged and args.algo == "ppo",
    )
    validation_envs = Heli3DOFVectorEnv(args.validation, **env_kwargs)
    agent = make_agent(args, helicopters)
    (folder / "checkpoints").mkdir(parents=True, exist_ok=True)  # only now: what is refused leaves nothing
    agent.set_logger(configure(str(folder), ["tensorboard"]))

    history: list[dict[str, Any]] = []
    checkpoint = last_checkpoint(folder / "checkpoints") if begun else None
    if checkpoint:
        history = restore(agent, checkpoint)
    else:
        history.append({"steps": 0, **validate(args, None, validation_envs, VALIDATION_SEED)})
        write_json(folder / "settings.json", settings_of(args))
    best_so_far = max((score(args, row) for row in history[1:]), default=-np.inf)

    chunks = chunks_of(args)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, disable=not args.progress) as progress:
        bar = progress.add_task(name, total=chunks, completed=len(history) - 1)
        for number in range(len(history) - 1, chunks if stop_after is None else min(chunks, stop_after)):
            learn(args, agent, helicopters, number, chunks)
            row = {"steps": agent.num_timesteps, **validate(args, agent, validation_envs, VALIDATION_SEED)}
            history.append(row)
            if score(args, row) > best_so_far:
                best_so_far = score(args, row)
                save_learned(folder / "best", learned_settings(args, helicopters), network_of(agent))
            for metric, value in row.items():
                agent.logger.record(f"validation/{metric}", np.mean(value))
            agent.logger.dump(agent.num_timesteps)
            write_json(folder / "history.json", history)
            save_checkpoint(folder / "checkpoints", number, state_of(agent, history))
            travel, elevation, _ = row["rms_error_deg"]
            progress.update(
                bar,
                advance=1,
                description=f"{name}: return {row['episode_return']:.2f} s, RMS {travel:.2f}°, {elevation:.2f}°",
            )
    return folder


def learn(args: Args, agent: BaseAlgorithm, helicopters: ResidualVecEnv, number: int, chunks: int) -> None:
    """One chunk. What is random in it follows from the seed and the chunk's number alone.

    So an interrupted run can go on with the chunk in which it was interrupted, and ends with the same weights.
    """
    seed = 1000 * args.seed + number
    set_random_seed(seed)
    agent.action_space.seed(seed)
    helicopters.seed(seed * args.envs)
    agent._last_obs = None  # Stable-Baselines3 then resets the helicopters
    rate = args.learning_rate * (1.0 - 0.9 * number / chunks)
    agent.lr_schedule = lambda _: rate
    agent.learn(args.chunk * args.envs, reset_num_timesteps=False, log_interval=10**9)


def state_of(agent: BaseAlgorithm, history: list[dict[str, Any]]) -> dict[str, Any]:
    """All that the rest of a run depends on."""
    _, variables = agent._get_torch_save_params()
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


def restore(agent: BaseAlgorithm, state: dict[str, Any]) -> list[dict[str, Any]]:
    """Puts the agent into this state, and returns the history of its run."""
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


def learned_settings(args: Args, helicopters: ResidualVecEnv) -> Learned:
    """What is stored beside the network."""
    return Learned(
        base=base_of(args) if args.mode == "residual" else SCRATCH,
        scale=helicopters.policy.scale,
        reference=args.reference,
        plant=args.plant,
        control_period=helicopters.envs.control_period,
        features=helicopters.n_actor_features,
        hidden=args.hidden,
        tanh_output=args.algo != "ppo",
        feature_groups=helicopters.policy.feature_groups,
    )


def write_json(path: Path, value: Any) -> None:
    """Atomically."""
    with atomic_write(path) as file:
        file.write((json.dumps(value, indent=2, default=str) + "\n").encode())


def main() -> None:
    """The command `heli-train`."""
    with command("heli-train"):
        console = Console()
        folder = train(parse(Args, "heli-train", __doc__), console)
        first, *_, last = json.loads((folder / "history.json").read_text())
        console.print(
            f"validation: return {first['episode_return']:.2f} s before, {last['episode_return']:.2f} s after\n"
            f"{folder}/best.safetensors: the best network; heli-evaluate --policies {folder}/best.json flies it"
        )


if __name__ == "__main__":
    main()
