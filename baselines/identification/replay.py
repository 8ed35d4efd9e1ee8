"""Replay of logged voltages through a plant: does what flies here move as the measured rig did?

A log is cut into pieces. In each the plant starts in the state that fits the first part of the piece best, and then has
nothing but the logged voltages.
"""

import math
from typing import NamedTuple

import numpy as np

from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.plant import Plant
from heli_gym.rig import Rig
from heli_gym.simulation.layout import ROW, X
from heli_gym.simulation.simulation import Simulation
from heli_gym.task import to_action
from heli_gym.trajectory import Trajectory

PIECE = 5.0  # s
FIT_TIME = 0.5  # s, at the start of a piece, to which the initial state is fitted
LEAST = 1.0  # s, shortest piece
DIFFERENCE = 1e-4  # rad and rad/s, for derivatives by the initial state
ITERATIONS = 3  # of Gauss and Newton, which suffice for so short a time


class Replay(NamedTuple):
    """One piece: times (K,) in s of the log, and angles (3, K) in rad as the log has them, with its sensors' zeros."""

    t: np.ndarray
    angles: np.ndarray


def replay(log: FlightLog, rig: Rig, plant: Plant | None = None, piece: float = PIECE) -> list[Replay]:
    """Fly the logged voltages of the airborne pieces of a log through a plant, by default that of the rig.

    Args:
        log: measured flight; its angles have the signs of the model, by `Mapping`, but not the rig's zeros.
        rig: its amplifier's limits, and its sensors' signs and zeros.
        plant: without ranges; its sensors are replaced by exact ones.
        piece: length in s of the pieces; 1 s or more.

    Raises:
        ValueError: for a plant with ranges, a piece that is too short, or a log without airborne pieces.
    """
    if not (isinstance(piece, int | float) and math.isfinite(piece) and piece >= LEAST):
        raise ValueError(f"piece = {piece!r}: must be a number of seconds, {LEAST:g} at least")
    plant = Plant.from_rig(rig, sensors=None) if plant is None else plant
    if plant.is_random:
        raise ValueError("plant: must have numbers only, and no ranges; draw one first")
    found = [fly_piece(log, rig, plant, k, n) for k, n in pieces(log, piece)]
    if not found:
        raise ValueError(f"log {log.name!r}: must be airborne for {LEAST:g} s at least")
    return found


def pieces(log: FlightLog, piece: float) -> list[tuple[int, int]]:
    """First sample and number of steps of consecutive airborne pieces."""
    longest, least = round(piece / log.sample_time), round(LEAST / log.sample_time)
    edges = np.flatnonzero(np.diff(np.concatenate(([False], log.airborne(), [False])).astype(int)))
    return [
        (k, min(longest, last - 1 - k))
        for first, last in zip(edges[::2].tolist(), edges[1::2].tolist())
        for k in range(first, last, longest)
        if last - 1 - k >= least
    ]


def fly_piece(log: FlightLog, rig: Rig, plant: Plant, k: int, n: int) -> Replay:
    """Replay n steps from sample k, from the state that fits the first FIT_TIME best."""
    offsets = np.array(rig.sensor_offsets)
    measured = log.angles[:, k : k + n + 1] - offsets[:, None]
    state = np.empty(6)
    state[0::2], state[1::2] = measured[:, 0], log.rates()[:, k]
    fitted = min(round(FIT_TIME / log.sample_time), n) + 1
    for _ in range(ITERATIONS):
        starts = np.concatenate((state[None], state + DIFFERENCE * np.eye(6)))
        angles = simulate(log, rig, plant, starts, k, fitted - 1)
        J = ((angles[1:] - angles[0]) / DIFFERENCE).reshape(6, -1).T
        state = state + np.linalg.lstsq(J, (measured[:, :fitted] - angles[0]).ravel(), rcond=None)[0]
    angles = simulate(log, rig, plant, state[None], k, n)[0]
    return Replay(log.t[k : k + n + 1], angles + offsets[:, None])


def simulate(log: FlightLog, rig: Rig, plant: Plant, states: np.ndarray, k: int, n: int) -> np.ndarray:
    """True angles (S, 3, n + 1) in rad of n steps from sample k under the logged voltages, from the states (S, 6).

    Before sample k, the voltages are those of the log, from as long before as rotors and dead time reach back.
    """
    dt, (low, high) = log.sample_time, rig.voltage_limits
    warm = min(k, math.ceil((10.0 * plant.rotors.lag + plant.rotors.delay) / dt))
    u = np.clip(log.voltages[:, k - warm : k + n], low, high)
    reference = Trajectory(dt * np.array([0.0, u.shape[1] + 1]), np.zeros((6, 2)), np.tile(u[:, :1], 2))
    middle, count = np.full(2, 0.5 * (low + high)), len(states)
    simulation = Simulation([plant] * count, [reference] * count, dt, (low, high), math.inf, hover=middle)
    simulation.reset(np.arange(count), states)
    x, angles = simulation.blocks.reshape(-1, ROW)[X : X + 6, :count], np.empty((count, 3, n + 1))
    for i, action in enumerate(to_action(u.T, (low, high), middle)):
        if i == warm:
            x[:] = states.T
        if i >= warm:
            angles[:, :, i - warm] = x[0::2].T
        simulation.step(np.tile(action, (count, 1)))
    angles[:, :, n] = x[0::2].T
    return angles
