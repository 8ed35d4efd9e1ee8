"""Simulated flight logs of known rigs, to check that identification recovers their parameters."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.measured_model import MeasuredParameters, simulation_kernel, thrust_kernel
from heli_gym.plant import Plant
from heli_gym.rig import Rig
from heli_gym.simulation.layout import MEASURED, ROW
from heli_gym.simulation.simulation import Simulation
from heli_gym.task import to_action
from heli_gym.trajectory import Trajectory

BLOCK = 2  # samples per control period


def hover_of(parameters: MeasuredParameters, voltage: float) -> np.ndarray:
    """Voltages (2,) in V at which the rig hovers level, where the unit of thrust is one rotor's at `voltage` in V."""
    p = parameters
    total = -p.a2 / (p.b2 * math.cos(p.pitch_zero))
    difference = -(p.pitch_trim - p.a3 * math.sin(p.pitch_zero)) / p.b3
    f = np.array([0.5 * (total + difference) / (1.0 + p.mismatch), 0.5 * (total - difference) / (1.0 - p.mismatch)])
    return voltage * np.sign(f) * np.abs(f) ** (1.0 / p.exponent)


class HoverController:
    """PD control of pitch and PID control of elevation about hover, for excitation.

    Args:
        hover: V (2,), at which the rig hovers.
        slope: rad/s² per V, of pitch by one voltage.
        lift: rad/s² per V, of elevation by both voltages.
        period: s.
        limits: (min, max) in V.
    """

    def __init__(
        self, hover: np.ndarray, slope: float, lift: float, period: float, limits: tuple[float, float]
    ) -> None:
        self.hover, self.slope, self.lift, self.period, self.limits = hover, slope, lift, period, limits
        self.sums, self.smooth = 0.0, np.zeros(3)
        self.last: np.ndarray | None = None

    def __call__(self, measured: np.ndarray, references: tuple[float, float]) -> np.ndarray:
        """Voltages (2,) in V from measured angles (3,) in rad and references of pitch and elevation in rad."""
        pitch, elevation = references
        rates = np.zeros(3) if self.last is None else (measured - self.last) / self.period
        self.smooth, self.last = 0.7 * self.smooth + 0.3 * rates, measured
        self.sums = float(np.clip(self.sums + 0.3 * self.period * (measured[1] - elevation), -1.0, 1.0))
        difference = (4.0 * (pitch - measured[2]) - 2.8 * self.smooth[2]) / (2.0 * self.slope)
        total = (1.2 * (measured[1] - elevation) + 1.6 * self.smooth[1] + self.sums) / self.lift
        return np.clip(self.hover + np.array([total + difference, total - difference]), *self.limits)


def simulate_log(
    parameters: MeasuredParameters,
    voltage: float,
    excitation: Callable[[float], tuple[float, float]],
    duration: float = 40.0,
    dt: float = 0.01,
    rng: np.random.Generator | None = None,
    name: str = "simulated",
    counts: Sequence[int] = Rig.encoder_counts,
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
        counts: of the encoders, per revolution of each axis.
    """
    n = round(duration / dt)
    theta = np.array(parameters, dtype=complex)
    steps = 2.0 * math.pi / np.array(counts)
    phase = np.full(3, 0.5) if rng is None else rng.uniform(0.0, 1.0, 3)
    hover = hover_of(parameters, voltage)
    # accelerations per volt about hover, to scale the gains to the rig
    slope = parameters.exponent * abs(parameters.b3) / voltage
    lift = 2.0 * parameters.exponent * abs(parameters.b2) / voltage
    u, angles = np.tile(hover[:, None], (1, n + 1)), np.empty((3, n + 1))
    z, f = np.zeros(9, dtype=complex), np.zeros((2, 2 * (n + 1) + 1), dtype=complex)
    y = np.empty((6, BLOCK + 1), dtype=complex)
    control = HoverController(hover, slope, lift, BLOCK * dt, (-24.0, 24.0))
    for k in range(0, n + 1, BLOCK):
        measured = quantise(z[0:6:2].real, steps, phase)
        u[:, k : k + BLOCK] = control(measured, excitation(k * dt))[:, None]
        stop = min(k + BLOCK, n + 1)
        # the thrusts follow from all voltages so far; only those of the last block are new
        first = max(0, k - round((10.0 * parameters.lag + parameters.delay) / dt) - 3)
        part = np.zeros((2, 2 * (stop - first) + 1), dtype=complex)
        thrust_kernel()(np.ascontiguousarray(u[:, first:stop]), theta, dt, voltage, part)
        f[:, 2 * k : 2 * stop + 1] = part[:, 2 * (k - first) :]
        block = y[:, : stop - k + 1]
        simulation_kernel()(z, f, k, dt, theta, block)
        angles[:, k:stop] = quantise(block[0:6:2, :-1].real, steps[:, None], phase[:, None])
        z[:6] = block[:, -1]
    return FlightLog(np.arange(n + 1) * dt, angles, u, name=name)


def simulate_plant(
    plant: Plant,
    rig: Rig,
    excitation: Callable[[float], tuple[float, float]],
    duration: float = 40.0,
    dt: float = 0.01,
    name: str = "simulated",
) -> FlightLog:
    """Simulate a flight of a drawn plant, by the simulation of the environments, under the control of `simulate_log`.

    Args:
        plant: without ranges, but with sensors, whose angles are logged.
        rig: whose hover voltage, thrust slopes and amplifier the controller uses.
        excitation: function of time in s that returns the references (pitch, elevation) in rad.
        duration: s.
        dt: s, sample time.
        name: of the log.
    """
    hover, (low, high) = rig.hover_voltage(), rig.voltage_limits
    slopes, p = rig.thrust_slope(hover), rig.parameters
    lift, slope = abs(p.b2) * float(slopes.sum()), p.b3 * float(slopes.mean())
    control = HoverController(hover, slope, lift, BLOCK * dt, (low, high))
    n = round(duration / dt)
    reference = Trajectory(np.array([0.0, duration + 1.0]), np.zeros((6, 2)), np.tile(hover[:, None], 2))
    simulation = Simulation([plant], [reference], dt, (low, high), math.inf, hover=np.full(2, 0.5 * (low + high)))
    simulation.reset(np.zeros(1, int), np.zeros((1, 6)))
    block = simulation.blocks.reshape(-1, ROW)[:, 0]
    u, angles = np.empty((2, n + 1)), np.empty((3, n + 1))
    for k in range(n + 1):
        angles[:, k] = block[MEASURED : MEASURED + 6 : 2]
        if k % BLOCK == 0:
            command = control(angles[:, k], excitation(k * dt))
        u[:, k] = command
        simulation.step(to_action(command, (low, high), np.full(2, 0.5 * (low + high)))[None])
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
