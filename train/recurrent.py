"""Recurrent PPO of sb3-contrib with the cell of `RecurrentNetwork`, a GRU in place of its LSTM."""

from typing import Any

import torch
from sb3_contrib.common.recurrent.policies import RecurrentActorCriticPolicy

States = tuple[torch.Tensor, torch.Tensor]


class Gru(torch.nn.GRU):
    """GRU between the two states of an LSTM, as the policies of sb3-contrib have them; the second stays as it is."""

    def forward(self, features: torch.Tensor, states: States) -> tuple[torch.Tensor, States]:  # type: ignore[override]
        """Outputs (T, N, H) and next states (1, N, H) for features (T, N, F) and states (1, N, H)."""
        outputs, hidden = super().forward(features, states[0])
        return outputs, (hidden, states[1])


class GruPolicy(RecurrentActorCriticPolicy):
    """Actor and critic with a GRU each, and a linear layer from the actor's states to the actions."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, net_arch={"pi": [], "vf": [64]}, **kwargs)  # type: ignore[misc]
        size = self.lstm_actor.hidden_size
        self.lstm_actor, self.lstm_critic = (Gru(self.features_dim, size) for _ in range(2))  # type: ignore[assignment]
        rate = self.optimizer.param_groups[0]["lr"]
        self.optimizer = self.optimizer_class(self.parameters(), lr=rate, **self.optimizer_kwargs)  # type: ignore[call-arg]
