"""An actor that sees what a controller sees, and a critic that also sees the plant.

The critic only serves training, where the plant's draw is known (Pinto et al., "Asymmetric actor critic for image-based
robot learning", 2018): what it explains is no longer noise in the actor's gradient.
"""

from typing import Any

import torch
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.torch_layers import MlpExtractor


class AsymmetricNetworks(MlpExtractor):
    """The hidden layers; those of the actor read the first `n_actor_features` features only."""

    def __init__(self, features: int, n_actor_features: int, *args: Any, **kwargs: Any) -> None:
        super().__init__(features, *args, **kwargs)
        self.n_actor_features = n_actor_features
        self.policy_net = MlpExtractor(n_actor_features, *args, **kwargs).policy_net

    def forward_actor(self, features: torch.Tensor) -> torch.Tensor:
        """From features (N, features) to the last hidden layer."""
        return self.policy_net(features[:, : self.n_actor_features])


class AsymmetricPolicy(ActorCriticPolicy):
    """A policy for PPO, whose actor reads the first `n_actor_features` features of an observation only."""

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
