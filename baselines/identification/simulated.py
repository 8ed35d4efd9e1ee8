"""Simulated flight logs of known rigs, to check that identification recovers their parameters."""

import math
from collections.abc import Callable

import numpy as np

from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.measured_model import MeasuredParameters, simulation_kernel, thrust_kernel

COUNTS = (8192, 4096, 4096)  # encoders, per revolution
BLOCK = 2  # samples per control period


def hover_of(parameters: MeasuredParameters, voltage: float) -> np.ndarray:
    """Voltages (2,) in V at which the rig hovers level, where the unit of thrust is one rotor's at `voltage` in V."""
    p = parameters
    total = -p.a2 / (p.b2 * math.cos(p.pitch_zero))
    difference = -(p.pitch_trim - p.a3 * math.sin(p.pitch_zero)) / p.b3
    f = np.array([0.5 * (total + difference) / (1.0 + p.mismatch), 0.5 * (total - difference) / (1.0 - p.mismatch)])
    return voltage * np.sign(f) * np.abs(f) ** (1.0 / p.exponent)


def simulate_log(
    parameters: MeasuredParameters,
    voltage: float,
    excitation: Callable[[float], tuple[float, float]],
    duration: float = 40.0,
    dt: float = 0.01,
    rng: np.random.Generator | None = None,
    name: str = "simulated",
) -> FlightLog:
    """Simulate a flight of a rig: PD control of pitch and elevation about hover, excitation, and encoder counts.

    Args:
        parameters: of the rig.
        voltage: V, at which one rotor has one unit of thrust.
        excitation: function of time in s that returns the references (pitch, elevation) in rad.
        duration: s.
        dt: s, sample time.
        rng: for the phase of the encoders; without it, counts begin at the initial angles.
        name: of the log.
    """
    n = round(duration / dt)
    theta = np.array(parameters, dtype=complex)
    counts = 2.0 * math.pi / np.array(COUNTS)
    phase = np.full(3, 0.5) if rng is None else rng.uniform(0.0, 1.0, 3)
    hover = hover_of(parameters, voltage)
    # accelerations per volt about hover, to scale the gains to the rig
    slope = parameters.exponent * abs(parameters.b3) / voltage
    lift = 2.0 * parameters.exponent * abs(parameters.b2) / voltage
    u, angles = np.tile(hover[:, None], (1, n + 1)), np.empty((3, n + 1))
    z, f = np.zeros(9, dtype=complex), np.zeros((2, 2 * (n + 1) + 1), dtype=complex)
    y = np.empty((6, BLOCK + 1), dtype=complex)
    sums, last, smooth = 0.0, None, np.zeros(3)
    for k in range(0, n + 1, BLOCK):
        measured = quantise(z[0:6:2].real, counts, phase)
        rates = np.zeros(3) if last is None else (measured - last) / (BLOCK * dt)
        smooth = 0.7 * smooth + 0.3 * rates
        last = measured
        pitch, elevation = excitation(k * dt)
        sums = float(np.clip(sums + 0.3 * BLOCK * dt * (measured[1] - elevation), -1.0, 1.0))
        difference = (4.0 * (pitch - measured[2]) - 2.8 * smooth[2]) / (2.0 * slope)
        total = (1.2 * (measured[1] - elevation) + 1.6 * smooth[1] + sums) / lift
        u[:, k : k + BLOCK] = np.clip(hover + np.array([total + difference, total - difference]), -24.0, 24.0)[:, None]
        stop = min(k + BLOCK, n + 1)
        # the thrusts follow from all voltages so far; only those of the last block are new
        first = max(0, k - round((10.0 * parameters.lag + parameters.delay) / dt) - 3)
        part = np.zeros((2, 2 * (stop - first) + 1), dtype=complex)
        thrust_kernel()(np.ascontiguousarray(u[:, first:stop]), theta, dt, voltage, part)
        f[:, 2 * k : 2 * stop + 1] = part[:, 2 * (k - first) :]
        block = y[:, : stop - k + 1]
        simulation_kernel()(z, f, k, dt, theta, block)
        angles[:, k:stop] = quantise(block[0:6:2, :-1].real, counts[:, None], phase[:, None])
        z[:6] = block[:, -1]
    return FlightLog(np.arange(n + 1) * dt, angles, u, name=name)


def quantise(angles: np.ndarray, counts: np.ndarray, phase: np.ndarray) -> np.ndarray:
    """Quantise angles as encoders do, with steps at a phase in [0, 1), without a bias."""
    return counts * (np.floor(angles / counts + phase) + 0.5 - phase)


def square_waves(pitch: float = 0.3, elevation: float = 0.15) -> Callable[[float], tuple[float, float]]:
    """Square-wave references: pitch jumps every 2.5 s between three values, elevation every 4 s."""

    def references(t: float) -> tuple[float, float]:
        return pitch * (0.0, 1.0, -1.0, 0.5, -1.0, 1.0)[int(t / 2.5) % 6], elevation * (0.0, 1.0, -1.0)[
            int(t / 4.0) % 3
        ]

    return references


def random_rig(rng: np.random.Generator) -> tuple[MeasuredParameters, float]:
    """Draw parameters within the range of identified rigs, and the hover voltage in V."""
    a2 = rng.uniform(0.5, 1.1)
    b2 = -0.5 * a2 * rng.uniform(0.95, 1.05)
    p = MeasuredParameters(
        a1=rng.uniform(-1.4, -0.8), a2=a2, a3=rng.uniform(-0.7, 0.0), b1=b2 * rng.uniform(0.9, 1.1), b2=b2,
        b3=rng.uniform(1.5, 3.5), c1=rng.uniform(0.05, 0.15), c2=rng.uniform(0.05, 0.3), c3=rng.uniform(0.05, 0.3),
        exponent=rng.uniform(1.5, 1.95), mismatch=rng.uniform(-0.06, 0.06), lag=rng.uniform(0.06, 0.12),
        delay=rng.uniform(0.005, 0.035), pitch_zero=rng.uniform(-0.1, 0.1), pitch_trim=rng.uniform(-0.3, 0.3),
        centrifugal=rng.uniform(0.85, 1.15), centre=rng.uniform(-0.1, 0.1), pitch_spin=rng.uniform(0.7, 1.3),
        gyro=rng.uniform(-1.3, 0.9), pitch_speed=rng.uniform(-0.1, 0.1),
    )  # fmt: skip
    return p, rng.uniform(3.0, 8.0)
