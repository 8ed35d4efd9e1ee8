"""Asymmetric actor-critic: the actor reads a controller's signals, the critic also reads the plant's draw.

The critic is used only in training, where the draw is known (Pinto et al., "Asymmetric actor critic for image-based
robot learning", 2018). A better value estimate reduces the noise in the actor's gradient.
"""

from typing import Any

import torch
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.torch_layers import MlpExtractor


class AsymmetricNetworks(MlpExtractor):
    """Hidden layers of actor and critic; the actor reads only the first `n_actor_features` features."""

    def __init__(self, features: int, n_actor_features: int, *args: Any, **kwargs: Any) -> None:
        super().__init__(features, *args, **kwargs)
        self.n_actor_features = n_actor_features
        self.policy_net = MlpExtractor(n_actor_features, *args, **kwargs).policy_net

    def forward_actor(self, features: torch.Tensor) -> torch.Tensor:
        """Last hidden layer of the actor for features (N, F)."""
        return self.policy_net(features[:, : self.n_actor_features])


class AsymmetricPolicy(ActorCriticPolicy):
    """PPO policy whose actor reads only the first `n_actor_features` features of an observation."""

    def __init__(self, *args: Any, n_actor_features: int, **kwargs: Any) -> None:
        self.n_actor_features = n_actor_features
        super().__init__(*args, **kwargs)

    def _build_mlp_extractor(self) -> None:
        self.mlp_extractor = AsymmetricNetworks(
            self.features_dim,
            self.n_actor_features,
            net_arch=self.net_arch,
            activation_fn=self.activation_fn,
            device=self.device,
        )
