"""Long flights: growth of memory, speed and statistics over time, and environments made and closed."""

import gc
import os
import time

import numpy as np

from heli_gym.env import Heli3DOFEnv
from heli_gym.vector_env import Heli3DOFVectorEnv

VECTOR_STEPS, SCALAR_STEPS, ENVIRONMENTS = 1_000_000_000, 10_000_000, 10_000
SHARE = 1.0
N, PIECES = 4096, 20
MOST_GROWTH = 5.0  # MB
MOST_DRIFT = 4.0  # standard errors between the first and the last third


def resident() -> float:
    """Memory of this process in MB."""
    gc.collect()
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def report(title: str, steps: int, memory: list[float], speed: list[float], means: list[float]) -> bool:
    """Print the figures of a soak; whether they are as they must be. The first piece warms up."""
    growth = memory[-1] - memory[1]
    third = max((len(means) - 1) // 3, 1)
    first, last = np.array(means[1 : 1 + third]), np.array(means[-third:])
    error = np.sqrt((first.var(ddof=1) + last.var(ddof=1)) / third) if third > 1 else np.inf
    drift = abs(first.mean() - last.mean()) / max(error, 1e-12)
    slowest, fastest = min(speed[1:]), max(speed[1:])
    print(
        f"{title}: {steps:.2e} steps; memory grew by {growth:.2f} MB (at most {MOST_GROWTH:g}); "
        f"{speed[1] / 1e6:.3g} to {speed[-1] / 1e6:.3g} million steps/s of CPU time from first to last piece "
        f"({slowest / 1e6:.3g} to {fastest / 1e6:.3g}); mean reward {first.mean():.5f} and {last.mean():.5f}, "
        f"{drift:.1f} standard errors apart (at most {MOST_DRIFT:g})"
    )
    return growth <= MOST_GROWTH and (third < 3 or drift <= MOST_DRIFT)


def soak_vector(steps: int, seed: int) -> bool:
    """Vector environment of `lab` with random actions near hover."""
    env = Heli3DOFVectorEnv(N, "lab", start_spread_deg=5.0)
    env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    actions = rng.uniform(-0.1, 0.1, (64, N, 2))
    memory, speed, means = [], [], []
    per_piece = max(steps // (N * PIECES), 1)
    for _ in range(PIECES):
        began, total = time.process_time(), 0.0
        for k in range(per_piece):
            _, rewards, *_ = env.step(actions[k % 64])
            total += rewards.mean()
        speed.append(N * per_piece / (time.process_time() - began))
        means.append(total / per_piece)
        memory.append(resident())
    return report("vector environment", N * per_piece * PIECES, memory, speed, means)


def soak_scalar(steps: int, seed: int) -> bool:
    """Single environment of `lab`, likewise."""
    env = Heli3DOFEnv("lab", start_spread_deg=5.0)
    env.reset(seed=seed)
    actions = np.random.default_rng(seed).uniform(-0.1, 0.1, (997, 2))
    memory, speed, means = [], [], []
    per_piece = steps // PIECES
    for _ in range(PIECES):
        began, total = time.process_time(), 0.0
        for k in range(per_piece):
            _, reward, terminated, truncated, _ = env.step(actions[k % 997])
            total += reward
            if terminated or truncated:
                env.reset()
        speed.append(per_piece / (time.process_time() - began))
        means.append(total / per_piece)
        memory.append(resident())
    return report("single environment", per_piece * PIECES, memory, speed, means)


def make_and_close(count: int) -> bool:
    """Environments of all plants, single and vector, made, flown for a step and closed."""
    memory = []
    for piece in range(PIECES):
        for k in range(count // PIECES):
            plant = ("nominal", "lab", "rigid", "fleet")[k % 4]
            env = Heli3DOFEnv(plant) if k % 2 else Heli3DOFVectorEnv(3, plant)
            env.reset(seed=k)
            env.step(np.zeros((3, 2)) if k % 2 == 0 else np.zeros(2))
            env.close()
        if piece in (PIECES // 4, PIECES - 1):
            memory.append(resident())
    growth = memory[1] - memory[0]
    print(f"environments made and closed: {count}; memory grew by {growth:.2f} MB (at most {MOST_GROWTH:g})")
    return growth <= MOST_GROWTH


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    share = 0.002 if quick else SHARE
    good = True
    if only in ("", "vector"):
        good &= soak_vector(int(share * VECTOR_STEPS), seed)
    if only in ("", "scalar"):
        good &= soak_scalar(int(share * SCALAR_STEPS), seed)
    if only in ("", "environments"):
        good &= make_and_close(400 if quick else int(share * ENVIRONMENTS))
    return int(not good)
