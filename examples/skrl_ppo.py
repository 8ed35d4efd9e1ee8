"""PPO of skrl on the native vector environment.

python examples/skrl_ppo.py --steps 200000
"""

import argparse
import tempfile

import gymnasium as gym
import torch
from skrl.agents.torch.ppo import PPO, PPO_CFG
from skrl.envs.wrappers.torch import wrap_env
from skrl.memories.torch import RandomMemory
from skrl.models.torch import DeterministicMixin, GaussianMixin, Model
from skrl.trainers.torch import SequentialTrainer
from torch import nn

import heli_gym  # noqa: F401  registers Heli3DOF-v0


class Policy(GaussianMixin, Model):
    """Actor; its first flights stay about the action zero, which is hover."""

    def __init__(self, *, observation_space, state_space, action_space, device) -> None:
        Model.__init__(self, observation_space=observation_space, action_space=action_space, device=device)
        GaussianMixin.__init__(self)
        self.net = network(self.num_observations, self.num_actions)
        self.log_std = nn.Parameter(torch.full((self.num_actions,), -2.0))

    def compute(self, inputs, role):
        return self.net(inputs["observations"]), {"log_std": self.log_std}


class Value(DeterministicMixin, Model):
    """Critic."""

    def __init__(self, *, observation_space, state_space, action_space, device) -> None:
        Model.__init__(self, observation_space=observation_space, action_space=action_space, device=device)
        DeterministicMixin.__init__(self)
        self.net = network(self.num_observations, 1)

    def compute(self, inputs, role):
        return self.net(inputs["observations"]), {}


def network(n_in: int, n_out: int) -> nn.Sequential:
    """Network with two hidden layers."""
    return nn.Sequential(nn.Linear(n_in, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), nn.Linear(64, n_out))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=200_000, help="of all helicopters (default: %(default)s)")
    parser.add_argument("--envs", type=int, default=16, help="helicopters at once (default: %(default)s)")
    parser.add_argument("--plant", default="nominal", help="nominal, lab or rigid (default: %(default)s)")
    args = parser.parse_args()
    torch.set_num_threads(1)
    env = wrap_env(gym.make_vec("Heli3DOF-v0", args.envs, plant=args.plant, start_spread_deg=5.0))
    spaces = {
        "observation_space": env.observation_space,
        "state_space": None,
        "action_space": env.action_space,
        "device": env.device,
    }
    models = {"policy": Policy(**spaces), "value": Value(**spaces)}
    config = PPO_CFG()
    config.rollouts = 32
    config.learning_rate = 3e-4
    config.rewards_shaper = lambda rewards, timestep, timesteps: 50.0 * rewards  # per second: of order one
    config.experiment.directory = tempfile.mkdtemp()
    config.experiment.write_interval = config.experiment.checkpoint_interval = 0
    memory = RandomMemory(memory_size=config.rollouts, num_envs=env.num_envs, device=env.device)
    agent = PPO(models=models, memory=memory, cfg=config, **spaces)
    SequentialTrainer(
        cfg={"timesteps": max(32, args.steps // args.envs), "headless": True}, env=env, agents=agent
    ).train()
    reward = memory.get_tensor_by_name("rewards").mean().item()
    print(f"reward of the last rollout: {reward:.3f} per second")
    env.close()


if __name__ == "__main__":
    main()
