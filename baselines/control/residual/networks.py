"""Networks of learned corrections, evaluated by numpy: layers with tanh, with or without a GRU cell before them."""

from typing import NamedTuple

import numpy as np

from heli_gym.baselines.control.protocol import expand_batch_dims


class Network(NamedTuple):
    """Layers of weights (out, in) and biases (out,), with tanh between them."""

    weights: tuple[np.ndarray, ...]
    biases: tuple[np.ndarray, ...]
    tanh_output: bool  # whether tanh follows the last layer

    def __call__(self, features: np.ndarray) -> np.ndarray:
        """Actions (2, ...) for features (F, ...)."""
        value = features
        for layer, (weight, bias) in enumerate(zip(self.weights, self.biases)):
            value = weight @ value + expand_batch_dims(bias, value)
            if layer < len(self.weights) - 1 or self.tanh_output:
                value = np.tanh(value)
        return value


class RecurrentNetwork(NamedTuple):
    """GRU cell (Cho et al., 2014; gates in torch's order: reset, update, new), followed by the layers of a network."""

    weight_input: np.ndarray  # (3 n, F)
    weight_hidden: np.ndarray  # (3 n, n)
    bias_input: np.ndarray  # (3 n,)
    bias_hidden: np.ndarray  # (3 n,)
    head: Network

    @property
    def size(self) -> int:
        """Number n of hidden states."""
        return self.weight_hidden.shape[1]

    def __call__(self, features: np.ndarray, hidden: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Actions (2, ...) and next hidden state (n, ...) for features (F, ...) and a hidden state (n, ...)."""
        n = self.size
        x = self.weight_input @ features + expand_batch_dims(self.bias_input, features)
        h = self.weight_hidden @ hidden + expand_batch_dims(self.bias_hidden, features)
        gates = 0.5 + 0.5 * np.tanh(0.5 * (x[: 2 * n] + h[: 2 * n]))  # sigmoid, without overflow
        new = np.tanh(x[2 * n :] + gates[:n] * h[2 * n :])
        hidden = new + gates[n:] * (hidden - new)
        return self.head(hidden), hidden


CELL = ("weight_input", "weight_hidden", "bias_input", "bias_hidden")
