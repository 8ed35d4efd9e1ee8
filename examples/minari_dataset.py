"""Record flights of a controller as a Minari dataset, for offline learning and imitation.

python examples/minari_dataset.py --policy kalman-lqr --plant lab --episodes 100
"""

import argparse

import gymnasium as gym
import minari
import numpy as np

import heli_gym  # noqa: F401  registers Heli3DOF-v0
from heli_gym.baselines import make_policy


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--policy", default="feedforward+tvlqr", help="of make_policy (default: %(default)s)")
    parser.add_argument("--plant", default="nominal", help="nominal, lab or rigid (default: %(default)s)")
    parser.add_argument("--reference", default="travel-360", help="name or .npz file (default: %(default)s)")
    parser.add_argument("--noise", type=float, default=0.0, help="V, standard deviation added to the voltages")
    parser.add_argument("--episodes", type=int, default=100, help="default: %(default)s")
    parser.add_argument("--steps", type=int, help="at most, of all episodes")
    parser.add_argument("--seed", type=int, default=0, help="of the first episode (default: %(default)s)")
    parser.add_argument("--id", default="helicopter/baseline-v0", help="of the dataset (default: %(default)s)")
    args = parser.parse_args()
    env = minari.DataCollector(
        gym.make("Heli3DOF-v0", plant=args.plant, reference=args.reference, start_spread_deg=5.0), record_infos=True
    )
    core = env.unwrapped
    policy, rng, flown = make_policy(args.policy, core.reference), np.random.default_rng(args.seed), 0
    for k in range(args.episodes):
        _, info = env.reset(seed=args.seed + k)
        policy.reset(rng)
        over = False
        while not over and (args.steps is None or flown < args.steps):
            u = policy(info["time"], info["measurement"]) + rng.normal(0.0, args.noise, 2)
            action = np.clip(core.to_action(u), -1.0, 1.0).astype(np.float32)
            _, _, terminated, truncated, info = env.step(action)
            over, flown = terminated or truncated, flown + 1
    dataset = env.create_dataset(
        args.id, algorithm_name=args.policy, author="heli-gym", description=f"{args.policy} on {args.plant}"
    )
    print(f"{args.id}: {dataset.total_episodes} episodes, {dataset.total_steps} steps")


if __name__ == "__main__":
    main()
