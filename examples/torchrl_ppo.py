"""PPO of TorchRL on `GymEnv("Heli3DOF-v0")`.

python examples/torchrl_ppo.py --steps 200000
"""

import argparse

import torch
from tensordict.nn import NormalParamExtractor, TensorDictModule
from torch import nn
from torchrl.collectors import Collector
from torchrl.envs import GymEnv, RewardScaling, StepCounter, TransformedEnv
from torchrl.modules import ProbabilisticActor, TanhNormal, ValueOperator
from torchrl.objectives import ClipPPOLoss
from torchrl.objectives.value import GAE

import heli_gym  # noqa: F401  registers Heli3DOF-v0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=200_000, help="default: %(default)s")
    parser.add_argument("--plant", default="nominal", help="nominal, lab or rigid (default: %(default)s)")
    args = parser.parse_args()
    torch.manual_seed(0)
    torch.set_num_threads(1)
    env = GymEnv("Heli3DOF-v0", plant=args.plant, start_spread_deg=5.0)
    env = TransformedEnv(env, RewardScaling(loc=0.0, scale=50.0))  # per second, so that rewards are of order one
    env.append_transform(StepCounter())
    n = env.observation_spec["observation"].shape[-1]

    # A small scale, so that the first flights stay near the action zero, which is hover.
    parameters = NormalParamExtractor(scale_mapping="biased_softplus_0.1", scale_lb=1e-3)
    actor = nn.Sequential(nn.Linear(n, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), nn.Linear(64, 4), parameters)
    policy = ProbabilisticActor(
        TensorDictModule(actor, in_keys=["observation"], out_keys=["loc", "scale"]),
        in_keys=["loc", "scale"],
        distribution_class=TanhNormal,
        return_log_prob=True,
    )
    critic = nn.Sequential(nn.Linear(n, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), nn.Linear(64, 1))
    value = ValueOperator(critic, in_keys=["observation"])
    advantage = GAE(gamma=0.99, lmbda=0.95, value_network=value)
    loss = ClipPPOLoss(policy, value, clip_epsilon=0.2)
    optimiser = torch.optim.Adam(loss.parameters(), lr=3e-4)
    frames = min(1000, args.steps)
    collector = Collector(env, policy, frames_per_batch=frames, total_frames=args.steps)
    for data in collector:
        for _ in range(4):
            advantage(data)
            for index in torch.randperm(len(data)).split(250):
                losses = loss(data[index])
                total = losses["loss_objective"] + losses["loss_critic"] + losses["loss_entropy"]
                optimiser.zero_grad()
                total.backward()
                torch.nn.utils.clip_grad_norm_(loss.parameters(), 0.5)
                optimiser.step()
        reward = data["next", "reward"].mean().item()
        print(f"reward {reward:.3f} per second, flights of {data['step_count'].max().item()} steps at most")
    collector.shutdown()


if __name__ == "__main__":
    main()
