"""Iterative learning control: corrects the voltages from flight to flight of one maneuver by one helicopter.

Norm-optimal, in the lifted form, in parallel to a feedback controller (Bristow, Tharayil and Alleyne, "A survey of
iterative learning control", IEEE Control Systems Magazine 26(3), 2006).
"""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from heli_gym.baselines.control.discrete_lqr import augmented
from heli_gym.baselines.control.estimation import discretise
from heli_gym.baselines.control.model_based import ModelPolicy
from heli_gym.baselines.control.protocol import StatefulPolicy, expand_batch_dims, step_index
from heli_gym.model import linearise, virtual_input
from heli_gym.rig import Rig

EFFORT = 0.02  # degree² per V², weight of the correction against the tracking error
SHARE = 0.8  # learning rate; a smaller one is slower, and more robust to model errors


@dataclass(eq=False)
class LearnedFeedforward(StatefulPolicy):
    """Model-based policy with voltage corrections (2, K + 1) in V, updated by `learn` after every flight.

    It flies one helicopter at a time and records the measurements of a flight from the reference's start.
    """

    base: ModelPolicy
    measured: list[np.ndarray] = field(default_factory=list, init=False, repr=False)

    def __post_init__(self) -> None:
        self.correction = np.zeros_like(self.base.regulator.u)
        self.control_period, self.voltage_limits = self.base.control_period, self.base.voltage_limits

    @property
    def rig(self) -> Rig:
        """Rig that the policy assumes; `fly` checks it."""
        return self.base.rig

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.base.x

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the memory and the record of the last flight; the corrections stay."""
        super().reset(rng)
        self.measured = []

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        self.measured.append(np.asarray(measurement, dtype=float))
        return super().__call__(t, measurement)

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> Any:
        """Memory of the base policy."""
        return self.base.init(t, measurement)

    def step(self, memory: Any, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Any]:
        u, memory = self.base.step(memory, t, measurement)
        k = step_index(t, self.control_period, self.correction.shape[1] - 1)
        u = np.clip(u + expand_batch_dims(self.correction[:, k], measurement), *self.voltage_limits)
        return u, self.base.with_applied_input(memory, u)

    @cached_property
    def lifted(self) -> np.ndarray:
        """Lifted response (2 K, 2 K) in rad/V of travel and elevation in each period to voltages in the earlier ones.

        The model is the nominal helicopter in closed loop along the reference, with lag and delay.
        """
        regulator, lag, delay = self.base.regulator, self.base.actuator.lag, self.base.actuator.delay
        rig, steps = regulator.rig, regulator.x.shape[1] - 1
        v = np.stack(virtual_input(rig.thrust(regulator.u)))
        A, B = (np.moveaxis(part, -1, 0) for part in linearise(regulator.x, v, rig.parameters))
        A, B = discretise(*augmented(A, B, lag, False), self.control_period)
        n = A.shape[1]
        slope = rig.thrust_slope(regulator.u)
        state, response = np.zeros((n, 2 * steps)), np.zeros((steps, 2, 2 * steps))
        for k in range(steps):
            from_voltages = B[k] @ np.array([slope[:, k], slope[:, k] * (1.0, -1.0)])
            state = A[k] @ state - B[k] @ (regulator.gains[:, :n, k] @ state)
            if k >= delay:
                state[:, 2 * (k - delay) : 2 * (k - delay) + 2] += from_voltages
            response[k] = state[[0, 2]]
        return response.reshape(2 * steps, 2 * steps)

    def learn(self) -> None:
        """Update the corrections with the angles measured in the last flight, also if it ended early."""
        steps, states = self.base.x.shape[1] - 1, np.array(self.measured).T
        error = np.zeros((steps, 2))
        flown = min(states.shape[1] - 1, steps)
        error[:flown] = np.degrees(states[0:3:2, 1 : flown + 1] - self.base.x[0:3:2, 1 : flown + 1]).T
        G = np.degrees(self.lifted)
        change = np.linalg.solve(G.T @ G + EFFORT * np.eye(2 * steps), G.T @ error.ravel())
        self.correction = self.correction.copy()
        self.correction[:, :steps] -= SHARE * change.reshape(steps, 2).T
