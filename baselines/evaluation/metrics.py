"""Metrics of a flight."""

from typing import NamedTuple

import numpy as np

from heli_gym.parameters import PITCH_STOP, Limits
from heli_gym.task import control_grid, cost, excess, reward, succeeded
from heli_gym.trajectory import Trajectory

AT_LIMIT = 1e-6  # V, distance from the amplifier's limit that counts as saturated
HALVING_ERROR = np.radians([2.0, 1.0])  # rad, travel and elevation errors that each halve the tracking term


class Metrics(NamedTuple):
    """Metrics of one flight; errors are (travel, elevation, pitch) in degrees.

    A crashed flight counts to the end of the maneuver: with its last error, at `crash_cost`, without reward.
    """

    rms_error_deg: tuple[float, float, float]
    terminal_error_deg: tuple[float, float, float]  # at the end of the flight
    peak_pitch_deg: float
    saturated: float  # share of the flight time with a voltage at a limit of the amplifier
    cost: float  # s, time integral of the excess over the planned limits, in limit widths
    episode_return: float  # s flown on the reference, by the environment's reward
    flown: float  # s
    success: bool
    crashed: bool  # whether the pitch left the plant's limit


def flight_metrics(
    flight: Trajectory,
    reference: Trajectory,
    voltage_limits: tuple[float, float],
    pitch_limit: float = PITCH_STOP,
) -> Metrics:
    """Metrics of a flight from `fly` along its reference.

    Args:
        flight: true states and voltages.
        reference: trajectory to track.
        voltage_limits: (min, max) in V of the amplifier.
        pitch_limit: rad, pitch at which a flight ends.
    """
    control_period = flight.t[1]
    x_ref, u_ref = control_grid(reference, control_period)
    steps = len(flight.t) - 1
    missing = x_ref.shape[1] - 1 - steps  # control periods after an early end
    error = flight.x - x_ref[:, : steps + 1]
    angles_deg = np.degrees(error[0::2])
    u = flight.u[:, :-1]
    low, high = voltage_limits
    at_limit = ((u <= low + AT_LIMIT) | (u >= high - AT_LIMIT)).any(axis=0)
    charged = cost(flight.x[4, 1:], u, reference.limits).sum()
    if missing:
        charged += missing * crash_cost(float(flight.x[4, -1]), voltage_limits, reference.limits)
    per_second = reward(error[:, 1:], u - u_ref[:, :steps], high - low)
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
    """Cost per second, until the end of the maneuver, of a flight that crashed at a pitch in rad.

    The cost assumes this pitch and both voltages at the worse limit of the amplifier. A flying helicopter never costs
    more, because its pitch is within the plant's limit; therefore an early end never pays.
    """
    worst = max(float(excess(u, limits.u_min, limits.u_max)) for u in voltage_limits)
    return float(excess(np.array([pitch, -pitch]), limits.pitch_min, limits.pitch_max).max()) + 2.0 * worst


def tracking_reward(error: np.ndarray, cost: np.ndarray, rewards: np.ndarray) -> np.ndarray:
    """Reward (N,) per second for travel and elevation errors (2, N) in rad and a cost (N,) per second.

    A quarter comes from the environment's rewards (N,), which include pitch, rates and effort. A large cost makes the
    reward negative; therefore a flight that ends early pays `crash_cost` until the end of the maneuver.
    """
    tracking = 1.0 / (1.0 + ((error / HALVING_ERROR[:, None]) ** 2).sum(axis=0))
    return 0.75 * tracking + 0.25 * rewards - cost
