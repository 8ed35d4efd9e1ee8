"""PPO in one file, in the manner of CleanRL, on the native vector environment.

    python examples/cleanrl_ppo.py --steps 1000000 --residual

With `--residual`, the agent adds at most 3 V to the paper's controller and observes the controller's voltages. It
starts from a working controller, and its small actions limit the risk of exploration.
"""

import argparse
import time

import gymnasium as gym
import numpy as np
import torch
from torch import nn
from torch.distributions import Normal

import heli_gym  # noqa: F401  registers Heli3DOF-v0
from heli_gym.baselines import VectorResidualAction


class Agent(nn.Module):
    """Actor and critic; the standard deviation of the actions is independent of the observation."""

    def __init__(self, n_observations: int, n_actions: int) -> None:
        super().__init__()
        self.critic = self.network(n_observations, 1, 1.0)
        self.actor = self.network(n_observations, n_actions, 0.01)
        self.log_std = nn.Parameter(torch.full((n_actions,), -2.0))  # the first flights stay about hover

    @staticmethod
    def network(n_in: int, n_out: int, last: float) -> nn.Sequential:
        """Network with two hidden layers; `last` is the gain of the output layer's initial weights."""
        layers = nn.Linear(n_in, 64), nn.Linear(64, 64), nn.Linear(64, n_out)
        for layer, gain in zip(layers, (2.0**0.5, 2.0**0.5, last)):
            nn.init.orthogonal_(layer.weight, gain)
            nn.init.zeros_(layer.bias)
        return nn.Sequential(layers[0], nn.Tanh(), layers[1], nn.Tanh(), layers[2])

    def distribution(self, observation: torch.Tensor) -> Normal:
        """Distribution of the actions (N, 2)."""
        return Normal(self.actor(observation), self.log_std.exp())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=1_000_000, help="of all helicopters (default: %(default)s)")
    parser.add_argument("--envs", type=int, default=64, help="helicopters at once (default: %(default)s)")
    parser.add_argument("--rollout", type=int, default=32, help="steps between updates (default: %(default)s)")
    parser.add_argument("--plant", default="nominal", help="nominal, lab or rigid (default: %(default)s)")
    parser.add_argument("--residual", action="store_true", help="correct the paper's controller")
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    torch.manual_seed(args.seed)
    torch.set_num_threads(1)
    gamma, trace, clip, epochs, minibatches = 0.99, 0.95, 0.2, 4, 4

    # NextStep, Gymnasium's default: the step after an end is the reset of the next flight, and no transition.
    envs = gym.make_vec("Heli3DOF-v0", args.envs, plant=args.plant, start_spread_deg=5.0)
    period = envs.unwrapped.control_period
    if args.residual:
        envs = VectorResidualAction(envs, authority=3.0)
    agent = Agent(envs.single_observation_space.shape[0], 2)
    optimiser = torch.optim.Adam(agent.parameters(), lr=3e-4, eps=1e-5)

    T, N = args.rollout, args.envs
    observations = torch.zeros(T, N, envs.single_observation_space.shape[0])
    actions, log_probabilities = torch.zeros(T, N, 2), torch.zeros(T, N)
    rewards, values, terminated, truncated, valid = (torch.zeros(T, N) for _ in range(5))
    # Starts are spread over the maneuver, so that every update includes all of it.
    options = {"time": np.linspace(0.0, envs.unwrapped.references[0].duration, N, endpoint=False)}
    observation = torch.as_tensor(envs.reset(seed=args.seed, options=options)[0])
    over, returns, finished, begin = torch.zeros(N), np.zeros(N), [], time.time()

    for update in range(max(1, args.steps // (T * N))):
        for t in range(T):
            observations[t], valid[t] = observation, 1.0 - over
            with torch.no_grad():
                distribution = agent.distribution(observation)
                actions[t] = distribution.sample()
                log_probabilities[t] = distribution.log_prob(actions[t]).sum(1)
                values[t] = agent.critic(observation).squeeze(1)
            array, reward, ended, cut, _ = envs.step(actions[t].numpy())
            observation = torch.as_tensor(array)
            rewards[t] = torch.as_tensor(reward / period)  # per second, so that they are of order one
            terminated[t], truncated[t] = torch.as_tensor(ended).float(), torch.as_tensor(cut).float()
            over = torch.maximum(terminated[t], truncated[t])
            returns += reward
            finished += returns[over.bool().numpy()].tolist()
            returns[over.bool().numpy()] = 0.0

        # Generalised advantage estimation; a truncated flight is bootstrapped by the critic.
        with torch.no_grad():
            following = torch.cat((values[1:], agent.critic(observation).squeeze(1)[None]))
        advantages, last = torch.zeros(T, N), torch.zeros(N)
        for t in reversed(range(T)):
            delta = rewards[t] + gamma * (1.0 - terminated[t]) * following[t] - values[t]
            last = delta + gamma * trace * (1.0 - torch.maximum(terminated[t], truncated[t])) * last
            advantages[t] = last = last * valid[t]
        targets = advantages + values

        used = valid.reshape(-1).nonzero().squeeze(1)
        parts = [x.reshape(T * N, -1)[used] for x in (observations, actions, log_probabilities, advantages, targets)]
        for _ in range(epochs):
            for index in torch.randperm(len(used)).chunk(minibatches):
                o, a, old, advantage, target = (part[index] for part in parts)
                distribution = agent.distribution(o)
                ratio = (distribution.log_prob(a).sum(1, keepdim=True) - old).exp()
                advantage = (advantage - advantage.mean()) / (advantage.std() + 1e-8)
                gain = torch.minimum(ratio * advantage, ratio.clamp(1.0 - clip, 1.0 + clip) * advantage).mean()
                loss = 0.5 * ((agent.critic(o) - target) ** 2).mean() - gain
                optimiser.zero_grad()
                loss.backward()
                nn.utils.clip_grad_norm_(agent.parameters(), 0.5)
                optimiser.step()
        if update % 10 == 0 and finished:
            rate = (update + 1) * T * N / (time.time() - begin)
            print(f"{(update + 1) * T * N} steps, {rate:.0f}/s, return {np.mean(finished[-100:]):.2f} s")
    print(f"return of the last flights: {np.mean(finished[-100:]) if finished else float('nan'):.2f} s")


if __name__ == "__main__":
    main()
