"""Learned correction of a controller: a small network adds actions a in [-1, 1]² to a base policy.

The law "saturated" is u = sat(sat(u_base) + scale a): the correction has authority even where the base policy exceeds
the amplifier's range by tens of volts. The law "sum" is u = sat(u_base + scale a).

The network receives the controller's signals (`FEATURE_GROUPS`) and nothing of the plant's draw; numpy evaluates it.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.model_based import ModelPolicy
from heli_gym.baselines.control.protocol import Policy, StatefulPolicy, expand_batch_dims, step_index
from heli_gym.baselines.control.residual.features import (
    AHEAD,
    BEFORE,
    DISTURBANCE_SCALE,
    FEATURE_CLIP,
    FEATURE_GROUPS,
    INTEGRAL_SCALE,
    STATE_SCALE,
    normalise_voltage,
)
from heli_gym.baselines.control.residual.networks import RecurrentNetwork
from heli_gym.baselines.control.residual.step import SingleStep
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.task import TOLERANCE, control_grid
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number

LAWS = ("sum", "saturated")


class Memory(NamedTuple):
    """State of a residual policy between control periods."""

    base: Any  # memory of the base policy if it is a `StatefulPolicy`
    integral: np.ndarray  # (2, ...) integrals of the travel and elevation errors in rad s
    past: np.ndarray  # (H, 5, ...) angle errors in tolerances and corrections, newest first
    hidden: np.ndarray | None = None  # (n, ...) hidden state of a recurrent network


@dataclass(eq=False)
class ResidualPolicy:
    """Base policy with a learned correction; with scale 0 it flies the base policy bit for bit.

    Args:
        base: policy to correct; a `ModelPolicy` receives the voltages that were applied.
        reference: trajectory to track.
        network: function of features (F, ...) that returns actions (2, ...) in [-1, 1], or a `RecurrentNetwork`.
        scale: greatest correction in V.
        control_period: s.
        voltage_limits: (min, max) in V of the amplifier.
        feature_groups: names in `FEATURE_GROUPS` that the network receives.
        law: "saturated" or "sum".
        ahead: previews of the reference in s.

    Raises:
        ValueError: for a scale that is negative or not finite, or an unknown group or law.
    """

    base: Policy
    reference: Trajectory
    network: Any
    scale: float
    control_period: float = 0.02
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    feature_groups: tuple[str, ...] = tuple(FEATURE_GROUPS)
    law: str = "saturated"
    ahead: tuple[float, ...] = AHEAD
    memory: Memory | None = field(default=None, init=False, repr=False)
    single_step: SingleStep | None = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        if not (is_number(self.scale) and self.scale >= 0.0):
            raise ValueError(f"scale = {self.scale!r}: must be a finite number of volts, at least 0")
        if not self.feature_groups or not set(self.feature_groups) <= set(FEATURE_GROUPS):
            raise ValueError(
                f"feature_groups = {self.feature_groups!r}: must name some of {', '.join(map(repr, FEATURE_GROUPS))}"
            )
        if self.law not in LAWS:
            raise ValueError(f"law = {self.law!r}: must be one of {', '.join(map(repr, LAWS))}")
        self.x, self.u = control_grid(self.reference, self.control_period)
        ahead = [control_grid(self.reference, self.control_period, seconds)[0] for seconds in self.ahead]
        self.preview = np.concatenate([(x / STATE_SCALE[:, None])[1:] for x in ahead])
        self.past_steps = [round(seconds / self.control_period) for seconds in BEFORE]

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the memory of the last flight."""
        self.base.reset(rng)
        self.memory = None  # includes the memory of the base policy
        if self.single_step is not None:
            self.single_step.reset()

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        measurement = np.asarray(measurement, dtype=float)
        if self.memory is None and measurement.ndim == 1 and np.ndim(t) == 0:
            if self.single_step is None and SingleStep.serves(self):
                self.single_step = SingleStep(self)
            if self.single_step is not None:
                return self.single_step(float(t), measurement)
        u_base, features = self.observe(t, measurement)
        if isinstance(self.network, RecurrentNetwork):
            assert self.memory is not None
            hidden = self.memory.hidden
            if hidden is None:
                hidden = np.zeros((self.network.size, *features.shape[1:]))
            action, hidden = self.network(features, hidden)
            self.memory = self.memory._replace(hidden=hidden)
        else:
            action = self.network(features)
        return self.correct(t, measurement, u_base, np.clip(action, -1.0, 1.0))

    def observe(self, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Voltages (2, ...) in V of the base policy, and features (F, ...) for the network."""
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        if self.memory is None:
            batch = measurement.shape[1:]
            base = self.base.init(t, measurement) if isinstance(self.base, StatefulPolicy) else None
            self.memory = Memory(base, np.zeros((2, *batch)), np.zeros((max(self.past_steps), 5, *batch)))
        if isinstance(self.base, StatefulPolicy):
            u_base, base = self.base.step(self.memory.base, t, measurement)
            self.memory = self.memory._replace(base=base)
        else:
            u_base = self.base(t, measurement)
        error = measurement - expand_batch_dims(self.x[:, k], measurement)
        past = self.memory.past
        groups = {
            "error": [error / expand_batch_dims(np.array(TOLERANCE), measurement)],
            "integral": [self.memory.integral / INTEGRAL_SCALE],
            "voltages": [
                normalise_voltage(u_base, self.voltage_limits),
                normalise_voltage(
                    expand_batch_dims(self.u[:, k], measurement) + np.zeros_like(u_base), self.voltage_limits
                ),
                past[0, 3:],
            ],
            "estimate": [],
            "preview": [expand_batch_dims(self.preview[:, k], measurement) + np.zeros((1, *measurement.shape[1:]))],
            "past": [past[step - 1] for step in self.past_steps],
        }
        if isinstance(self.base, ModelPolicy):
            groups["estimate"] = [
                self.memory.base.disturbance / DISTURBANCE_SCALE,
                normalise_voltage(self.memory.base.rotors, self.voltage_limits),
            ]
        rows = [row for group in FEATURE_GROUPS if group in self.feature_groups for row in groups[group]]
        return u_base, np.clip(np.concatenate(rows), -FEATURE_CLIP, FEATURE_CLIP)

    def correct(
        self, t: float | np.ndarray, measurement: np.ndarray, u_base: np.ndarray, action: np.ndarray
    ) -> np.ndarray:
        """Voltages (2, ...) in V of base policy and action (2, ...); stores both in the memory.

        Raises ValueError before `observe`.
        """
        if self.memory is None:
            raise ValueError("correct: comes after observe")
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        if self.law == "saturated":
            u_base = np.clip(u_base, *self.voltage_limits)
        u = u_base + self.scale * action if self.scale else u_base
        base = self.memory.base
        if isinstance(self.base, ModelPolicy) and self.scale:
            base = self.base.with_applied_input(base, u)
        error = (measurement - expand_batch_dims(self.x[:, k], measurement))[0::2]
        tolerances = expand_batch_dims(np.array(TOLERANCE[0::2]), measurement)
        now = np.concatenate((error / tolerances, action))[None]
        self.memory = Memory(
            base,
            self.memory.integral + self.control_period * error[:2],
            np.concatenate((now, self.memory.past[:-1])),
            self.memory.hidden,
        )
        return u
