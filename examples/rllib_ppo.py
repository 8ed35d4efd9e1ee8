"""PPO of RLlib on the registered environment.

python examples/rllib_ppo.py --steps 200000
"""

import argparse

import gymnasium as gym
from ray.rllib.algorithms.ppo import PPOConfig
from ray.tune.registry import register_env


def make(arguments: dict) -> gym.Env:
    """Make one environment, in any process of RLlib."""
    import heli_gym  # noqa: F401  registers Heli3DOF-v0

    env = gym.make("Heli3DOF-v0", **arguments)
    return gym.wrappers.TransformReward(env, lambda reward: 50.0 * reward)  # per second: of order one


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=200_000, help="default: %(default)s")
    parser.add_argument("--plant", default="nominal", help="nominal, lab or rigid (default: %(default)s)")
    args = parser.parse_args()
    register_env("helicopter", make)
    batch = min(4000, args.steps)
    config = (
        PPOConfig()
        .environment("helicopter", env_config={"plant": args.plant, "start_spread_deg": 5.0})
        .env_runners(num_env_runners=0)
        .training(train_batch_size=batch, minibatch_size=min(256, batch), num_epochs=4, gamma=0.99, lr=3e-4)
    )
    algorithm = config.build_algo()
    for _ in range(max(1, args.steps // batch)):
        found = algorithm.train()["env_runners"]
        print(f"return {found.get('episode_return_mean', float('nan')) / 50.0:.2f} s")
    algorithm.stop()


if __name__ == "__main__":
    main()
