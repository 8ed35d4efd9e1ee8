"""PPO of Stable-Baselines3 on one environment, on `make_vec_env`, or on the native vector environment.

    python examples/sb3_ppo.py --form native --steps 1000000

Observations are of order one for every plant and reference, without normalisation. Rewards are at most the control
period, 0.02 per step, so that a return counts seconds. A value function learns faster from numbers of order one, hence
`reward_unit` in the native form and VecNormalize of rewards only in the others. The first actions should stay near
zero, which is hover: with a standard deviation of one (`log_std_init=0`), the pitch deviates by 20 degrees.
"""

import argparse

import gymnasium as gym
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.env_util import make_vec_env
from stable_baselines3.common.evaluation import evaluate_policy
from stable_baselines3.common.vec_env import VecEnv, VecNormalize

import heli_gym  # noqa: F401  registers Heli3DOF-v0
from heli_gym.train.vec_env import HeliVecEnv

FORMS = ("make", "make_vec_env", "native")


def helicopters(form: str, n: int, **arguments) -> VecEnv:
    """Make the training environment, with rewards of order one."""
    if form == "native":
        envs = gym.make_vec("Heli3DOF-v0", n, autoreset_mode="SameStep", **arguments)
        return HeliVecEnv(envs, spread=True, reward_unit=envs.unwrapped.control_period, sparse_infos=True)
    vec = make_vec_env("Heli3DOF-v0", 1 if form == "make" else n, env_kwargs=arguments)
    return VecNormalize(vec, norm_obs=False, norm_reward=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--form", choices=FORMS, default="native")
    parser.add_argument("--envs", type=int, default=64, help="helicopters at once (default: %(default)s)")
    parser.add_argument("--plant", default="nominal", help="nominal, lab or rigid (default: %(default)s)")
    parser.add_argument("--steps", type=int, default=1_000_000, help="of all helicopters (default: %(default)s)")
    parser.add_argument("--save", help=".zip file for the agent")
    args = parser.parse_args()
    torch.set_num_threads(1)
    vec = helicopters(args.form, args.envs, plant=args.plant, start_spread_deg=5.0)
    n_steps = max(2, min(2048 // vec.num_envs, args.steps // vec.num_envs))
    agent = PPO(
        "MlpPolicy",
        vec,
        n_steps=n_steps,
        batch_size=min(256, n_steps * vec.num_envs),
        gamma=0.99,
        learning_rate=3e-4,
        policy_kwargs={"log_std_init": -2.0},
        device="cpu",
        seed=0,
    )
    agent.learn(args.steps)
    held_out = make_vec_env("Heli3DOF-v0", 1, seed=1, env_kwargs={"plant": args.plant, "start_spread_deg": 5.0})
    mean, spread = evaluate_policy(agent, held_out, n_eval_episodes=5)
    print(f"{args.form}: {mean:.2f} ± {spread:.2f} s of 10 s on the reference")
    if args.save:
        agent.save(args.save)


if __name__ == "__main__":
    main()
