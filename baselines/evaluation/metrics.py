"""What a flight is judged by."""

from typing import NamedTuple

import numpy as np

from heli_gym.parameters import PITCH_STOP, Limits
from heli_gym.task import control_grid, cost, excess, reward, succeeded
from heli_gym.trajectory import Trajectory

AT_LIMIT = 1e-6  # V, from the amplifier's limit, which counts as saturated
ONE = np.radians([2.0, 1.0])  # errors of travel and elevation that halve `tracking_reward`


class Metrics(NamedTuple):
    """Of one flight. Errors are (travel, elevation, pitch) in degrees.

    A flight that crashed counts to the end of the maneuver: at its last error, at `crash_cost`, without any reward.
    """

    rms_error_deg: tuple[float, float, float]
    terminal_error_deg: tuple[float, float, float]  # the last ones
    peak_pitch_deg: float
    saturated: float  # share of the time flown in which a voltage is at a limit of the amplifier
    cost: float  # time integral of the excess over the planned limits, in widths of these times seconds
    episode_return: float  # seconds flown on the reference, as the environment's reward counts them
    flown: float  # s
    success: bool
    crashed: bool  # whether the pitch left the plant's limit


def flight_metrics(
    flight: Trajectory,
    reference: Trajectory,
    voltage_limits: tuple[float, float],
    pitch_limit: float = PITCH_STOP,
) -> Metrics:
    """The metrics of a flight, as `fly` returns it, along its reference.

    Args:
        flight: the true states and the voltages.
        reference: what was to be flown.
        voltage_limits: what the amplifier gives, (min, max) V.
        pitch_limit: rad, beyond which a flight ends.
    """
    control_period = flight.t[1]
    x_ref, u_ref = control_grid(reference, control_period)
    steps = len(flight.t) - 1
    missing = x_ref.shape[1] - 1 - steps  # control periods that a flight which ended early has left
    error = flight.x - x_ref[:, : steps + 1]
    angles_deg = np.degrees(error[0::2])
    u = flight.u[:, :-1]
    low, high = voltage_limits
    at_limit = ((u <= low + AT_LIMIT) | (u >= high - AT_LIMIT)).any(axis=0)
    charged = cost(flight.x[4, 1:], u, reference.limits).sum()
    if missing:
        charged += missing * crash_cost(float(flight.x[4, -1]), voltage_limits, reference.limits)
    per_second = reward(error[:, 1:], u - u_ref[:, :steps])
    squares = (angles_deg**2).sum(axis=1) + missing * angles_deg[:, -1] ** 2
    return Metrics(
        rms_error_deg=tuple(np.sqrt(squares / x_ref.shape[1]).tolist()),
        terminal_error_deg=tuple(np.abs(angles_deg[:, -1]).tolist()),
        peak_pitch_deg=float(np.degrees(np.abs(flight.x[4]).max())),
        saturated=float(at_limit.mean()),
        cost=float(control_period * charged),
        episode_return=float(control_period * per_second.sum()),
        flown=flight.duration,
        success=bool(not missing and succeeded(error[:, -1])),
        crashed=bool(missing or abs(flight.x[4, -1]) > pitch_limit),
    )


def crash_cost(pitch: float, voltage_limits: tuple[float, float], limits: Limits) -> float:
    """Cost per second, to the end of the maneuver, of a flight that crashed at this pitch in rad.

    That of this pitch with both voltages at the amplifier's limit that is farther outside: while it flies, no
    helicopter is charged more, because its pitch has not yet left the plant's limit. So ending early never pays.
    """
    worst = max(float(excess(u, limits.u_min, limits.u_max)) for u in voltage_limits)
    return float(excess(np.array([pitch, -pitch]), limits.pitch_min, limits.pitch_max).max()) + 2.0 * worst


def tracking_reward(error: np.ndarray, cost: np.ndarray, rewards: np.ndarray) -> np.ndarray:
    """One second's reward (N,) at errors (2, N) of travel and elevation in rad, and a cost (N,) per second.

    With a share of the environment's rewards (N,), which also ask for pitch, rates and effort. It is negative where the
    cost is large: a flight that ends early is charged `crash_cost` to the end of the maneuver.
    """
    tracking = 1.0 / (1.0 + ((error / ONE[:, None]) ** 2).sum(axis=0))
    return 0.75 * tracking + 0.25 * rewards - cost
