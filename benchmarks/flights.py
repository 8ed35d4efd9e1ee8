"""Seeded flights of this commit, for comparison with another commit.

    python benchmarks/flights.py --out before.npz        # on one commit
    python benchmarks/flights.py --against before.npz    # on the other: the largest difference of each flight

Covers every plant, one and many helicopters, random voltages and policies; compares states, observations and rewards.
"""

import argparse
import sys

import gymnasium as gym
import numpy as np

import heli_gym  # noqa: F401, registers Heli3DOF-v0

try:
    from heli_gym.baselines import fly, make_policy
except ModuleNotFoundError:  # commits from before the packages were renamed
    from baselines import fly, make_policy

PLANTS = ("nominal", "lab", "rigid")
POLICIES = ("open-loop", "feedforward+tvlqr", "lqi", "lag-lqr", "kalman-lqr@lab")
SEEDS = (0, 1)
SAME = 1e-12  # relative tolerance, since compilers round differently


def action_of(env, u):
    """Action of voltages in V; its scale differs between commits."""
    core = env.unwrapped
    return core.to_action(u) if hasattr(core, "to_action") else u / 6.0 - 1.0


def random_flight(plant: str, seed: int) -> dict[str, np.ndarray]:
    """Fly one helicopter under random voltages about hover; return its arrays by name."""
    env = gym.make("Heli3DOF-v0", plant=plant, start_spread_deg=3.0)
    _, info = env.reset(seed=seed)
    voltages = np.random.default_rng(seed).normal(7.8, 0.3, (200, 2))
    states, rewards = [info["state"]], []
    for u in voltages:
        _, reward, terminated, truncated, info = env.step(action_of(env, u))
        states.append(info["state"])
        rewards.append(reward)
        if terminated or truncated:
            break
    return {"states": np.array(states), "rewards": np.array(rewards)}


def many_flights(plant: str, count: int = 130, steps: int = 120) -> dict[str, np.ndarray]:
    """Fly many helicopters under random voltages, with automatic resets; return their arrays by name."""
    envs = gym.make_vec("Heli3DOF-v0", num_envs=count, plant=plant, start_spread_deg=3.0)
    envs.reset(seed=5)
    rng = np.random.default_rng(1)
    states, rewards = [], []
    for _ in range(steps):
        _, reward, _, _, info = envs.step(action_of(envs, rng.normal(7.8, 1.2, (count, 2))))
        states.append(info["state"].copy())
        rewards.append(reward)
    return {"states": np.array(states), "rewards": np.array(rewards)}


def policy_flight(plant: str, name: str, seed: int) -> dict[str, np.ndarray]:
    """Fly the default maneuver by a policy; return its arrays by name."""
    env = gym.make("Heli3DOF-v0", plant=plant, start_spread_deg=3.0)
    flight = fly(env, make_policy(name, env.unwrapped.source), seed=seed)
    return {"states": flight.x, "voltages": flight.u}


def all_flights() -> dict[str, np.ndarray]:
    """Arrays of all flights, by name."""
    arrays = {}
    for plant in PLANTS:
        flights = {f"random {seed}": random_flight(plant, seed) for seed in SEEDS}
        flights["vector"] = many_flights(plant)
        flights |= {f"{name} {seed}": policy_flight(plant, name, seed) for name in POLICIES for seed in SEEDS}
        for flight, parts in flights.items():
            arrays |= {f"{plant}, {flight}, {part}": array for part, array in parts.items()}
    return arrays


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--out", help=".npz file to write")
    action.add_argument("--against", help=".npz file of another commit")
    args = parser.parse_args()
    arrays = all_flights()
    if args.out:
        np.savez_compressed(args.out, **arrays)
        print(f"{len(arrays)} arrays in {args.out}")
        return 0
    worst = 0.0
    with np.load(args.against, allow_pickle=False) as others:
        for name, array in arrays.items():
            other = others[name]
            if array.shape != other.shape:
                print(f"{name}: {array.shape} here, {other.shape} there")
                worst = np.inf
                continue
            difference = float((np.abs(array - other) / np.maximum(1.0, np.abs(other))).max())
            worst = max(worst, difference)
            if difference:
                print(f"{name}: {difference:.1e}")
    print(f"{len(arrays)} arrays, largest relative difference {worst:.1e}")
    return int(not worst <= SAME)


if __name__ == "__main__":
    sys.exit(main())
