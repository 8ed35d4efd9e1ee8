"""Speed of this environment and of others: tables of steps per second and of ratios.

    python benchmarks/environment.py [--quick] [--threads 2] [--table out/environment.md]

Gymnasium's environments are always included; EnvPool (with six), gymnax, and PPO from the extra `train` are measured if
they can be imported. Rates are medians of interleaved runs, so that a slowdown of the machine affects all of them:
quote the ratios. `benchmarks/simulators.py` measures simulators that are incompatible with numpy 2.
"""

import argparse
import importlib.util
import math
import os
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import gymnasium as gym
import numpy as np

import heli_gym  # noqa: F401  registers Heli3DOF-v0
from heli_gym.task import OBSERVED

HELI = "Heli3DOF-v0"
SIZES = (1, 64, 1024, 16384)
ACTIONS = 8  # number of actions drawn in advance
Runner = Callable[[], int]  # runs for a while and returns the number of steps


def single_runner(env: gym.Env, steps: int = 500) -> Runner:
    """Runner of one environment under random actions, over several episodes."""
    env.action_space.seed(0)
    actions = [near_hover(env.action_space.sample()) for _ in range(512)]
    env.reset(seed=0)

    def run() -> int:
        for k in range(steps):
            _, _, terminated, truncated, _ = env.step(actions[k % 512])
            if terminated or truncated:
                env.reset()
        return steps

    return run


def vector_runner(envs: gym.vector.VectorEnv, n: int, lockstep: bool = True) -> Runner:
    """Runner of a vector environment with automatic resets.

    Helicopters start simultaneously with `lockstep`, otherwise spread over the maneuver as in training, so that some
    flights end in every step.
    """
    envs.action_space.seed(0)
    actions = [near_hover(envs.action_space.sample()) for _ in range(ACTIONS)]
    envs.reset(seed=0, options=None if lockstep else {"time": np.linspace(0.0, 9.9, n)})
    return stepping_runner(envs, actions, n)


def stepping_runner(envs: Any, actions: list, n: int) -> Runner:
    """Runner that steps n environments at once and cycles through the actions."""
    rounds = max(2, 20000 // n)

    def run() -> int:
        for k in range(rounds):
            envs.step(actions[k % ACTIONS])
        return rounds * n

    return run


def near_hover(action):
    """Scale actions (N, 2) of helicopters so that flights last longer; return other actions unchanged."""
    is_heli = isinstance(action, np.ndarray) and action.dtype == np.float32 and action.shape[-1] == 2
    return (0.02 * action).astype(np.float32) if is_heli else action


def envpool_runner(name: str, n: int) -> Runner:
    """Runner of EnvPool with one thread. Raises ImportError if it is not installed."""
    import envpool

    envs = envpool.make(name, env_type="gymnasium", num_envs=n, batch_size=n, num_threads=1, seed=0)
    envs.reset()
    rng = np.random.default_rng(0)
    actions = [
        rng.uniform(-2, 2, (n, 1)).astype(np.float32)
        if name == "Pendulum-v1"
        else rng.integers(0, 2, n).astype(np.int32)
        for _ in range(ACTIONS)
    ]
    return stepping_runner(envs, actions, n)


def gymnax_runner(name: str, n: int) -> Runner:
    """Runner of gymnax, compiled for the CPU. Raises ImportError if it is not installed."""
    import gymnax
    import jax

    env, parameters = gymnax.make(name)
    step = jax.jit(jax.vmap(env.step, in_axes=(0, 0, 0, None)))
    keys = jax.random.split(jax.random.key(0), n)
    _, state = jax.jit(jax.vmap(env.reset, in_axes=(0, None)))(keys, parameters)
    rng = np.random.default_rng(0)
    action = rng.uniform(-2, 2, (n, 1)).astype(np.float32) if name == "Pendulum-v1" else rng.integers(0, 2, n)
    rounds = max(2, 20000 // n)
    held = [state]

    def run() -> int:
        for _ in range(rounds):
            observation, held[0], *_ = step(keys, held[0], action, parameters)
            np.asarray(observation)
        return rounds * n

    return run


def rates(runners: dict[str, Runner], seconds: float, turns: int = 7) -> dict[str, float]:
    """Steps per second of each runner: medians over interleaved turns."""
    measured: dict[str, list[float]] = {name: [] for name in runners}
    for run in runners.values():
        run()  # compiles
    for _ in range(turns):
        for name, run in runners.items():
            steps, begin = 0, time.perf_counter()
            while (took := time.perf_counter() - begin) < seconds:
                steps += run()
            measured[name].append(steps / took)
    return {name: statistics.median(values) for name, values in measured.items()}


def peers_of_many(n: int) -> dict[str, Runner]:
    """Runners of EnvPool and gymnax, if installed."""
    found = {}
    for name, make in (("EnvPool, 1 thread", envpool_runner), ("gymnax", gymnax_runner)):
        for task in ("Pendulum-v1", "Acrobot-v1"):
            try:
                found[f"{task}, {name}"] = make(task, n)
            except ImportError:
                print(f"{name} is not installed")
    return found


def table_of_one(seconds: float) -> list[str]:
    """Table of `env.step` with the default wrappers."""
    peers = {name: single_runner(gym.make(name)) for name in ("Pendulum-v1", "Acrobot-v1", "CartPole-v1")}
    ours = {
        f"{HELI} {plant}": single_runner(gym.make(HELI, plant=plant)) for plant in ("nominal", "lab", "rigid", "fleet")
    }
    found = rates(peers | ours, seconds)
    lines = ["| one environment | steps/s | of Pendulum-v1 |", "|---|---|---|"]
    return lines + [f"| {name} | {rate:,.0f} | {rate / found['Pendulum-v1']:.2f} |" for name, rate in found.items()]


def table_of_many(n: int, seconds: float, threads: int) -> list[str]:
    """Table of steps of n environments at once, Heli3DOF-v0 with the given number of threads."""
    cartpole = "CartPole-v1, Gymnasium's own"
    runners = {cartpole: vector_runner(gym.make_vec("CartPole-v1", n, "vector_entry_point"), n)}
    if n <= 64:
        runners["Pendulum-v1, SyncVectorEnv"] = vector_runner(gym.make_vec("Pendulum-v1", n, "sync"), n)
    runners |= peers_of_many(n)
    for plant, dtype in (
        ("nominal", "float64"),
        ("nominal", "float32"),
        ("lab", "float64"),
        ("rigid", "float64"),
        ("fleet", "float64"),
    ):
        for lockstep in (True, False):
            name = f"{HELI} {plant}, {dtype}" + ("" if lockstep else ", spread over the maneuver")
            runners[name] = vector_runner(gym.make_vec(HELI, n, plant=plant, dtype=dtype, threads=threads), n, lockstep)
    found = rates(runners, seconds)
    acrobot = found.get("Acrobot-v1, EnvPool, 1 thread", math.nan)
    lines = [
        f"| {n} environments | env-steps/s | ns | of CartPole-v1 | of EnvPool's Acrobot-v1 |",
        "|---|---|---|---|---|",
    ]
    return lines + [
        f"| {name} | {rate:,.0f} | {1e9 / rate:.1f} | {rate / found[cartpole]:.2f} | {rate / acrobot:.1f} |"
        for name, rate in found.items()
    ]


def floor_of_many(n: int) -> str:
    """Line with the time in which a core writes as many bytes as the observations to memory outside its cache."""
    buffers, row = [np.empty((n, OBSERVED), np.float32) for _ in range(4)], np.ones(OBSERVED, np.float32)
    begin, rounds = time.perf_counter(), max(4, 400_000 // n)
    for k in range(rounds):
        buffers[k % 4][:] = row
    return (
        f"Writing {OBSERVED} numbers for each of {n} takes {1e9 * (time.perf_counter() - begin) / rounds / n:.1f} ns."
    )


def share_of_ppo(n: int = 256, rollout: int = 32) -> str:
    """Line with the environment's share of the run time of Stable-Baselines3's PPO."""
    import torch
    from stable_baselines3 import PPO

    from heli_gym.train.vec_env import HeliVecEnv
    from heli_gym.vector_env import Heli3DOFVectorEnv

    torch.set_num_threads(1)
    envs = HeliVecEnv(Heli3DOFVectorEnv(n, autoreset_mode="SameStep"))
    step, spent = envs.step_wait, [0.0]

    def timed_step():
        begin = time.perf_counter()
        result = step()
        spent[0] += time.perf_counter() - begin
        return result

    envs.step_wait = timed_step  # type: ignore[method-assign]
    agent = PPO("MlpPolicy", envs, n_steps=rollout, batch_size=2048, n_epochs=10, device="cpu")
    agent.learn(2 * n * rollout)
    spent[0], begin = 0.0, time.perf_counter()
    agent.learn(8 * n * rollout)
    took = time.perf_counter() - begin
    return (
        f"PPO with {n} environments: {8 * n * rollout / took:,.0f} steps/s, {spent[0] / took:.1%} in the environment."
    )


def main() -> None:
    """Measure, print and write the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a tenth of the time")
    parser.add_argument("--sizes", type=int, nargs="*", default=SIZES, help="how many environments")
    parser.add_argument("--threads", type=int, default=1, help="of our vector environment")
    parser.add_argument("--table", type=Path, help="a Markdown file to write")
    args = parser.parse_args()
    seconds = 0.05 if args.quick else 0.5
    lines = [f"Load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores; Gymnasium {gym.__version__}"]
    lines += ["", *table_of_one(seconds)]
    for n in args.sizes:
        lines += ["", *table_of_many(n, seconds, args.threads)]
        lines += ["", floor_of_many(n)]
    if importlib.util.find_spec("stable_baselines3"):
        lines += ["", share_of_ppo()]
    print("\n".join(lines))
    if args.table:
        args.table.parent.mkdir(parents=True, exist_ok=True)
        args.table.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
