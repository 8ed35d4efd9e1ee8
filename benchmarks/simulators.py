"""Speed of other flight simulators relative to Gymnasium's Pendulum-v1, in their own interpreter.

    /path/to/their/venv/bin/python benchmarks/simulators.py PyFlyt.gym_envs:PyFlyt/QuadX-Hover-v4 [module:id ...]

They depend on other versions of numpy than this package; compare the ratios to Pendulum-v1.
"""

import statistics
import sys
import time

import gymnasium as gym


def rate(env: gym.Env, seconds: float = 1.0) -> float:
    """Steps per second under one constant action, over several episodes."""
    env.action_space.seed(0)
    action = env.action_space.sample()
    env.reset(seed=0)
    steps, begin = 0, time.perf_counter()
    while (took := time.perf_counter() - begin) < seconds:
        _, _, terminated, truncated, _ = env.step(action)
        steps += 1
        if terminated or truncated:
            env.reset()
    return steps / took


def main() -> None:
    """Measure in turns and print medians."""
    envs = {name: gym.make(name) for name in ("Pendulum-v1", *sys.argv[1:])}
    turns = [{name: rate(env) for name, env in envs.items()} for _ in range(5)]
    print("| one environment | steps/s | of Pendulum-v1 |", "|---|---|---|", sep="\n")
    for name in envs:
        own = statistics.median(turn[name] for turn in turns)
        share = statistics.median(turn[name] / turn["Pendulum-v1"] for turn in turns)
        print(f"| {name} | {own:,.0f} | {share:.4f} |")


if __name__ == "__main__":
    main()
