"""Fast control step of a `ResidualPolicy`, for one helicopter and the most common form of the correction."""

import math
from typing import TYPE_CHECKING

import numpy as np

from heli_gym.baselines.control.residual.features import FEATURE_CLIP, FEATURE_GROUPS, normalise_voltage
from heli_gym.baselines.control.residual.networks import RecurrentNetwork
from heli_gym.baselines.control.tracking import TrackingPolicy
from heli_gym.task import TOLERANCE
from heli_gym.thrust_map import PowerCurve

if TYPE_CHECKING:
    from heli_gym.baselines.control.residual.policy import ResidualPolicy

SINGLE_GROUPS = ("error", "voltages", "preview")  # in the order of the features
FLIGHT_FEATURES = (*range(8), 10, 11)  # indices in SINGLE_GROUPS; the other features depend on time alone


def voltage_of(curve: PowerCurve, f: float) -> float:
    """`curve.voltage` for one thrust f in N, without numpy."""
    k = curve.k_plus if f >= 0.0 else curve.k_minus
    if f == 0.0 or k == 0.0:
        return 0.0
    ratio = f / k
    beyond = (math.sqrt(ratio) if curve.exponent == 2.0 else ratio ** (1.0 / curve.exponent)) + curve.dead_zone
    return beyond if f >= 0.0 else -beyond


def time_features(features: int) -> list[int]:
    """Indices of the features of `SINGLE_GROUPS`, `features` in all, that depend on time alone."""
    return [k for k in range(features) if k not in FLIGHT_FEATURES]


class SingleStep:
    """Control step of one helicopter, several times faster than the general one and equal to it to rounding.

    It serves recurrent corrections, with the feature groups of `SINGLE_GROUPS`, of a feedforward with state feedback.
    Products with features of time alone are computed beforehand. The memory of a flight is one vector: the hidden state
    of the cell, and its inputs, the features of the last step.

    Args:
        policy: policy whose step is computed.
    """

    def __init__(self, policy: "ResidualPolicy") -> None:
        base, network = policy.base, policy.network
        assert isinstance(base, TrackingPolicy)  # `serves`
        T, n, F = policy.x.shape[1], network.size, network.weight_input.shape[1]
        seen, timed = list(FLIGHT_FEATURES), time_features(F)
        voltages = normalise_voltage(policy.u, policy.voltage_limits)
        values = np.clip(np.concatenate((voltages, policy.preview)), -FEATURE_CLIP, FEATURE_CLIP)
        bias = network.bias_input[:, None] + network.weight_input[:, timed] @ values
        bias[: 2 * n] += network.bias_hidden[: 2 * n, None]
        # The states of the cell and its inputs stand in one vector, so that each step has one product for both gates,
        # and half of their arguments, because sigmoid(x) = 0.5 + 0.5 tanh(0.5 x).
        both = np.concatenate((network.weight_hidden[: 2 * n], network.weight_input[: 2 * n, seen]), axis=1)
        self.gate_weights, self.gate_bias = 0.5 * both, 0.5 * np.ascontiguousarray(bias[: 2 * n].T)
        self.new_weights, self.new_bias = (
            np.ascontiguousarray(network.weight_input[2 * n :, seen]),
            bias[2 * n :].T.copy(),
        )
        self.old_weights, self.old_bias = (
            np.ascontiguousarray(network.weight_hidden[2 * n :]),
            network.bias_hidden[2 * n :],
        )
        (self.head,), (self.head_bias,) = network.head.weights, network.head.biases
        self.x, self.v = np.ascontiguousarray(base.x.T), np.ascontiguousarray(base.v.T)
        self.gains = np.ascontiguousarray(base.gains.transpose(2, 0, 1))
        self.tolerance, self.last, self.period = np.array(TOLERANCE), T - 1, policy.control_period
        self.scale, (self.low, self.high) = policy.scale, policy.voltage_limits
        front, back = base.rig.thrust_map.front, base.rig.thrust_map.back
        assert isinstance(front, PowerCurve) and isinstance(back, PowerCurve)  # `serves`
        self.front, self.back = front, back
        self.size = n
        self.gates, self.new, self.old = np.empty(2 * n), np.empty(n), np.empty(n)

    @staticmethod
    def serves(policy: "ResidualPolicy") -> bool:
        """Whether the policy has this form."""
        network, base = policy.network, policy.base
        return (
            isinstance(network, RecurrentNetwork)
            and isinstance(base, TrackingPolicy)
            and all(isinstance(curve, PowerCurve) for curve in (base.rig.thrust_map.front, base.rig.thrust_map.back))
            and tuple(group for group in FEATURE_GROUPS if group in policy.feature_groups) == SINGLE_GROUPS
            and policy.law == "saturated"
            and len(network.head.weights) == 1
            and network.head.tanh_output
            and policy.scale > 0.0
        )

    def init(self) -> np.ndarray:
        """Memory before the first step of a flight."""
        return np.zeros(self.size + len(FLIGHT_FEATURES))

    def __call__(self, memory: np.ndarray, t: float, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Voltages (2,) in V for a measured state (6,), and the next memory."""
        k = min(max(round(t / self.period), 0), self.last)
        n, low, high, memory = self.size, self.low, self.high, memory.copy()
        hidden, features = memory[:n], memory[n:]
        error = measurement - self.x[k]
        v1, v2 = (self.v[k] - self.gains[k] @ error).tolist()
        front, back = voltage_of(self.front, 0.5 * (v1 + v2)), voltage_of(self.back, 0.5 * (v1 - v2))
        np.divide(error, self.tolerance, out=features[:6])
        features[6] = (front - 0.5 * (low + high)) / (0.5 * (high - low))
        features[7] = (back - 0.5 * (low + high)) / (0.5 * (high - low))
        np.minimum(features, FEATURE_CLIP, out=features)
        np.maximum(features, -FEATURE_CLIP, out=features)
        gates, new, old = self.gates, self.new, self.old
        np.dot(self.gate_weights, memory, out=gates)
        gates += self.gate_bias[k]
        np.tanh(gates, out=gates)
        gates += 1.0
        gates *= 0.5
        np.dot(self.old_weights, hidden, out=old)
        old += self.old_bias
        old *= gates[:n]
        np.dot(self.new_weights, features, out=new)
        new += self.new_bias[k]
        new += old
        np.tanh(new, out=new)
        hidden -= new
        hidden *= gates[n:]
        hidden += new
        action = np.tanh(self.head @ hidden + self.head_bias)
        features[8:] = action
        a_front, a_back = action.tolist()
        u = min(max(front, low), high) + self.scale * a_front, min(max(back, low), high) + self.scale * a_back
        return np.array(u), memory
