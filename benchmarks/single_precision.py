"""Error of single precision in open loop and with feedback: the same flights in float32 and float64.

    python benchmarks/single_precision.py [--episodes 100]

Each flight has its own measurements: rounding changes encoder counts, and the feedback reacts to that.
"""

import argparse

import numpy as np

import heli_gym  # noqa: F401  registers Heli3DOF-v0
from heli_gym.baselines import make_policy
from heli_gym.vector_env import Heli3DOFVectorEnv

PLANTS = ("nominal", "lab", "rigid")
POLICIES = ("open-loop", "feedforward+tvlqr", "kalman-lqr")


def flights(plant: str, name: str, episodes: int, dtype: str) -> tuple[np.ndarray, np.ndarray]:
    """Angles (K, 3, N) in rad of flights until the first one ends, and their errors from the reference."""
    envs = Heli3DOFVectorEnv(episodes, plant=plant, dtype=dtype, autoreset_mode="Disabled")
    _, info = envs.reset(seed=0)
    reference = envs.reference_of(0)
    policy = make_policy(name, reference)
    policy.reset(np.random.default_rng(0))
    angles, errors, t, over = [], [], 0.0, False
    while not over:
        u = np.broadcast_to(np.asarray(policy(t, np.asarray(info["measurement"], float).T)).T, (episodes, 2))
        _, _, terminated, truncated, info = envs.step(np.clip(envs.to_action(u), -1.0, 1.0))
        t, over = float(info["time"][0]), bool((terminated | truncated).any())
        angles.append(np.array(info["state"], float).T[::2])
        errors.append(angles[-1] - reference(t)[0][::2, None])
    return np.array(angles), np.array(errors)


def main() -> None:
    """Fly and print a table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--episodes", type=int, default=100)
    episodes = parser.parse_args().episodes
    print("| plant | policy | median, rad | 90 %, rad | worst, rad | mean RMS travel in float64, float32, degrees |")
    print("|---|---|---|---|---|---|")
    for plant in PLANTS:
        for name in POLICIES:
            (exact, error), (close, close_error) = (flights(plant, name, episodes, d) for d in ("float64", "float32"))
            steps = min(len(exact), len(close))
            off = np.quantile(np.abs(exact[:steps] - close[:steps]).max(axis=(0, 1)), (0.5, 0.9, 1.0))
            rms = [np.degrees(np.sqrt((e[:steps, 0] ** 2).mean(axis=0)).mean()) for e in (error, close_error)]
            print(
                f"| `{plant}` | {name} | {off[0]:.0e} | {off[1]:.0e} | {off[2]:.0e} | {rms[0]:.3f}, {rms[1]:.3f} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
