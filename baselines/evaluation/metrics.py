"""What a flight is judged by."""

from typing import NamedTuple

import numpy as np

from heli_gym.task import control_grid, cost, reward, succeeded
from heli_gym.trajectory import Trajectory

AT_LIMIT = 1e-6  # V, from the amplifier's limit, which counts as saturated
ONE = np.radians([2.0, 1.0])  # errors of travel and elevation that halve `tracking_reward`


class Metrics(NamedTuple):
    """Of one flight. Errors are (travel, elevation, pitch) in degrees, over the time flown."""

    rms_error_deg: tuple[float, float, float]
    terminal_error_deg: tuple[float, float, float]
    peak_pitch_deg: float
    saturated: float  # share of the time in which a voltage is at a limit of the amplifier
    cost: float  # time integral of the excess over the planned limits, in widths of these times seconds
    episode_return: float  # seconds flown on the reference, as the environment's reward counts them
    flown: float  # s
    success: bool


def flight_metrics(flight: Trajectory, reference: Trajectory, voltage_limits: tuple[float, float]) -> Metrics:
    """The metrics of a flight, as `fly` returns it, along its reference, with an amplifier that gives (min, max) V."""
    control_period = flight.t[1]
    x_ref, u_ref = control_grid(reference, control_period)
    steps = len(flight.t) - 1
    error = flight.x - x_ref[:, : steps + 1]
    angles_deg = np.degrees(error[0::2])
    u = flight.u[:, :-1]
    low, high = voltage_limits
    at_limit = ((u <= low + AT_LIMIT) | (u >= high - AT_LIMIT)).any(axis=0)
    excess = cost(flight.x[4, 1:], u, reference.limits)
    per_second = reward(error[:, 1:], u - u_ref[:, :steps])
    return Metrics(
        rms_error_deg=tuple(np.sqrt((angles_deg**2).mean(axis=1)).tolist()),
        terminal_error_deg=tuple(np.abs(angles_deg[:, -1]).tolist()),
        peak_pitch_deg=float(np.degrees(np.abs(flight.x[4]).max())),
        saturated=float(at_limit.mean()),
        cost=float(control_period * excess.sum()),
        episode_return=float(control_period * per_second.sum()),
        flown=flight.duration,
        success=bool(steps == x_ref.shape[1] - 1 and succeeded(error[:, -1])),
    )


def tracking_reward(error: np.ndarray, cost: np.ndarray, rewards: np.ndarray) -> np.ndarray:
    """One second's reward (N,) at errors (2, N) of travel and elevation in rad, and a cost (N,) per second.

    With a share of the environment's rewards (N,), which also ask for pitch, rates and effort.
    """
    tracking = 1.0 / (1.0 + ((error / ONE[:, None]) ** 2).sum(axis=0))
    return 0.75 * tracking + 0.25 * rewards - cost
