"""Every controller behind one protocol: policy(t, measurement) -> voltages."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from baselines.tvlqr import Q, R, riccati_gains, stationary_gain
from heli_gym.model import fan_thrusts, hover_input, thrust, virtual_input, voltage
from heli_gym.parameters import HelicopterParameters
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory


class Policy(Protocol):
    """A controller. What it remembers of a flight, `reset` clears."""

    def reset(self, rng: np.random.Generator) -> None:
        """Prepare for a new flight; what is random in it comes from rng."""

    def __call__(self, t: float, measurement: np.ndarray) -> np.ndarray:
        """Voltages (2,) in V to hold from the time t in s on, given the measured state (6,) in rad and rad/s."""


@dataclass(frozen=True, eq=False)
class TrackingPolicy:
    """The two-degrees-of-freedom scheme of Fig. 3: a feedforward and a state feedback on the tracking error, (51).

    On the control grid, K + 1 times `control_period` s apart: x (6, K + 1), the feedforward's v (2, K + 1) in N and the
    gains (2, 6, K + 1), whose correction is in N too.
    """

    x: np.ndarray
    v: np.ndarray
    gains: np.ndarray
    parameters: HelicopterParameters
    control_period: float

    def reset(self, rng: np.random.Generator) -> None:
        """Nothing to do: this policy remembers nothing."""

    def __call__(self, t: float, measurement: np.ndarray) -> np.ndarray:
        k = min(round(t / self.control_period), self.x.shape[1] - 1)
        v = self.v[:, k] - self.gains[:, :, k] @ (measurement - self.x[:, k])
        return voltage(fan_thrusts(v), self.parameters)


@dataclass(frozen=True)
class MotorsOff:
    """No voltage at all."""

    def reset(self, rng: np.random.Generator) -> None:
        """Nothing to do: this policy remembers nothing."""

    def __call__(self, t: float, measurement: np.ndarray) -> np.ndarray:
        return np.zeros(2)


def open_loop(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> TrackingPolicy:
    """The feedforward alone."""
    x, u = control_grid(reference, control_period)
    v = np.stack(virtual_input(thrust(u, parameters)))
    return TrackingPolicy(x, v, np.zeros((2, *x.shape)), parameters, control_period)


def feedforward_tvlqr(
    reference: Trajectory,
    control_period: float,
    parameters: HelicopterParameters,
    Q: np.ndarray = Q,
    R: np.ndarray = R,
) -> TrackingPolicy:
    """The paper's controller: the feedforward of Section III-D and the time-varying regulator of Section III-E."""
    feedforward = open_loop(reference, control_period, parameters)
    times = control_period * np.arange(feedforward.x.shape[1])
    gains = riccati_gains(reference, parameters, Q, R)(times)
    return TrackingPolicy(feedforward.x, feedforward.v, gains, parameters, control_period)


def hover_lqr(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> TrackingPolicy:
    """A stationary regulator about hover at the goal that follows the reference's states without any feedforward."""
    x, _ = control_grid(reference, control_period)
    elevation = float(reference.x[2, -1])
    v = np.repeat(hover_input(elevation, parameters)[:, None], x.shape[1], axis=1)
    gains = np.repeat(stationary_gain(elevation, parameters)[:, :, None], x.shape[1], axis=2)
    return TrackingPolicy(x, v, gains, parameters, control_period)


def zero(reference: Trajectory, control_period: float, parameters: HelicopterParameters) -> MotorsOff:
    """Motors off."""
    return MotorsOff()


POLICIES: dict[str, Callable[[Trajectory, float, HelicopterParameters], Policy]] = {
    "open-loop": open_loop,
    "feedforward+tvlqr": feedforward_tvlqr,
    "hover-lqr": hover_lqr,
    "zero": zero,
}


def make_policy(
    name: str,
    reference: Trajectory,
    control_period: float = 0.02,
    parameters: HelicopterParameters = HelicopterParameters(),
) -> Policy:
    """A policy by its name, for a reference, a control period in s and the parameters that it is to believe in.

    Raises ValueError for an unknown name.
    """
    if name not in POLICIES:
        raise ValueError(f"name = {name!r}: one of {', '.join(map(repr, POLICIES))} is needed")
    return POLICIES[name](reference, control_period, parameters)
