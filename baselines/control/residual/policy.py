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
from heli_gym.rig import Rig
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
class ResidualPolicy(StatefulPolicy):
    """Base policy with a learned correction; with scale 0 it flies the base policy bit for bit.

    Args:
        base: policy to correct; its method `with_applied_input`, if any, receives the voltages that were applied.
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
    memory: Memory | np.ndarray | None = field(default=None, init=False, repr=False)  # an array: of `single_step`
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
    def rig(self) -> Rig | None:
        """Rig that the base policy assumes; `fly` checks it."""
        return getattr(self.base, "rig", None)

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the memory of the last flight, also the base policy's."""
        super().reset(rng)
        self.base.reset(rng)

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory | np.ndarray:
        """Memory without errors and corrections, of `single_step` for one helicopter if it serves the policy."""
        if measurement.ndim == 1 and np.ndim(t) == 0:
            if self.single_step is None and SingleStep.serves(self):
                self.single_step = SingleStep(self)
            if self.single_step is not None:
                return self.single_step.init()
        return self.init_general(t, measurement)

    def init_general(self, t: float | np.ndarray, measurement: np.ndarray) -> Memory:
        """Memory of one helicopter or many without errors and corrections."""
        batch = measurement.shape[1:]
        base = self.base.init(t, measurement) if isinstance(self.base, StatefulPolicy) else None
        hidden = np.zeros((self.network.size, *batch)) if isinstance(self.network, RecurrentNetwork) else None
        return Memory(base, np.zeros((2, *batch)), np.zeros((max(self.past_steps), 5, *batch)), hidden)

    def step(
        self, memory: Memory | np.ndarray, t: float | np.ndarray, measurement: np.ndarray
    ) -> tuple[np.ndarray, Memory | np.ndarray]:
        if not isinstance(memory, Memory):
            assert self.single_step is not None
            return self.single_step(memory, float(t), measurement)
        u_base, features, memory = self.step_base(memory, t, measurement)
        if isinstance(self.network, RecurrentNetwork):
            assert memory.hidden is not None
            action, hidden = self.network(features, memory.hidden)
            memory = memory._replace(hidden=hidden)
        else:
            action = self.network(features)
        return self.add_correction(memory, t, measurement, u_base, np.clip(action, -1.0, 1.0))

    def with_applied_input(self, memory: Memory | np.ndarray, u: np.ndarray) -> Memory | np.ndarray:
        """Memory after a step in which the voltages u (2, ...) in V were applied instead of the policy's own."""
        if isinstance(memory, Memory) and hasattr(self.base, "with_applied_input"):
            return memory._replace(base=self.base.with_applied_input(memory.base, u))
        return memory

    def observe(self, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Voltages (2, ...) in V of the base policy, and features (F, ...) for the network; stores the memory."""
        memory = self.memory if isinstance(self.memory, Memory) else self.init_general(t, measurement)
        u_base, features, self.memory = self.step_base(memory, t, measurement)
        return u_base, features

    def step_base(
        self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, Memory]:
        """Voltages (2, ...) in V of the base policy, features (F, ...), and the memory after the base's step."""
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        if isinstance(self.base, StatefulPolicy):
            u_base, base = self.base.step(memory.base, t, measurement)
            memory = memory._replace(base=base)
        else:
            u_base = self.base(t, measurement)
        error = measurement - expand_batch_dims(self.x[:, k], measurement)
        past = memory.past
        groups = {
            "error": [error / expand_batch_dims(np.array(TOLERANCE), measurement)],
            "integral": [memory.integral / INTEGRAL_SCALE],
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
                memory.base.disturbance / DISTURBANCE_SCALE,
                normalise_voltage(memory.base.rotors, self.voltage_limits),
            ]
        rows = [row for group in FEATURE_GROUPS if group in self.feature_groups for row in groups[group]]
        return u_base, np.clip(np.concatenate(rows), -FEATURE_CLIP, FEATURE_CLIP), memory

    def correct(
        self, t: float | np.ndarray, measurement: np.ndarray, u_base: np.ndarray, action: np.ndarray
    ) -> np.ndarray:
        """Voltages (2, ...) in V of base policy and action (2, ...); stores both in the memory.

        Raises ValueError before `observe`.
        """
        if not isinstance(self.memory, Memory):
            raise ValueError("correct: comes after observe")
        u, self.memory = self.add_correction(self.memory, t, measurement, u_base, action)
        return u

    def add_correction(
        self, memory: Memory, t: float | np.ndarray, measurement: np.ndarray, u_base: np.ndarray, action: np.ndarray
    ) -> tuple[np.ndarray, Memory]:
        """Voltages (2, ...) in V of base policy and action (2, ...), and the next memory."""
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        if self.law == "saturated":
            u_base = np.clip(u_base, *self.voltage_limits)
        u = u_base + self.scale * action if self.scale else u_base
        base = memory.base
        if self.scale and hasattr(self.base, "with_applied_input"):
            base = self.base.with_applied_input(base, u)
        error = (measurement - expand_batch_dims(self.x[:, k], measurement))[0::2]
        tolerances = expand_batch_dims(np.array(TOLERANCE[0::2]), measurement)
        now = np.concatenate((error / tolerances, action))[None]
        integral = memory.integral + self.control_period * error[:2]
        return u, Memory(base, integral, np.concatenate((now, memory.past[:-1])), memory.hidden)
