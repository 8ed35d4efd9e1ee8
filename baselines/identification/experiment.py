"""Design of an identification experiment: multisine references about hover that excite all parameters."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import savgol_filter

from heli_gym.baselines.identification.estimation import COEFFICIENTS, EFFECTS
from heli_gym.baselines.identification.flight_log import FlightLog
from heli_gym.baselines.identification.measured_model import MeasuredParameters
from heli_gym.baselines.identification.multiple_shooting import SPREAD, Shooting
from heli_gym.baselines.identification.simulated import simulate_log
from heli_gym.parameters import NO_COUPLING, Coupling
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory

LONGEST = 60.0  # s
TONES = 12  # of each reference
PITCH_BAND, ELEVATION_BAND = (0.016, 1.5), (0.04, 0.6)  # Hz; slow pitch makes travel fast
CANDIDATES = 12  # number of random sets of phases
SMOOTHING = 0.2  # s, of the encoder counts in the reference
FADE = 2.0  # s, fade-in and fade-out of the references
MODEL_ERROR = 3.0  # ratio of errors of measured flights, correlation included, to rounding


@dataclass(frozen=True, eq=False)
class Experiment:
    """Maneuver for identification.

    Attributes:
        log: the expected flight, with the references `pitch_ref` and `elevation_ref`.
        standard_errors: expected ones of each parameter, for errors of MODEL_ERROR times the encoders' rounding.
        share_of_prior: standard errors relative to the prior; near 1, the experiment has no information.
    """

    log: FlightLog
    standard_errors: dict[str, float]
    share_of_prior: dict[str, float]

    def trajectory(self, rig: Rig) -> Trajectory:
        """The expected flight as a reference for controllers, and for `heli-export`.

        Its voltages are those that lead to it on the rig with lag and dead time, so `feedforward+tvlqr` flies it.
        """
        log = self.log
        n = 2 * round(0.5 * SMOOTHING / log.sample_time) + 1
        x = np.empty((6, len(log)))
        x[0::2] = savgol_filter(log.angles, n, 3, axis=1)
        x[1::2] = savgol_filter(log.angles, n, 3, deriv=1, delta=log.sample_time, axis=1)
        return Trajectory(log.t, x, log.voltages, rig.limits, rig)


def parameters_of(rig: Rig) -> tuple[MeasuredParameters, float]:
    """Parameters of the rig in the model of real flights, and hover voltage in V.

    For a rig without a known coupling, the moments between the axes are those common to identified rigs.
    """
    hover = rig.hover_voltage()
    if not np.isfinite(hover).all():
        raise ValueError(f"rig = {rig.name!r}: must hover within its thrust map")
    voltage = float(hover.mean())
    both = np.full(2, voltage)
    f, slope = rig.thrust(both), rig.thrust_slope(both)
    backwards = float(-rig.thrust(-both).sum() / f.sum())
    unit, p = float(f.mean()), rig.parameters
    return MeasuredParameters(
        a1=p.a1, a2=p.a2, a3=p.a3, b1=p.b1 * unit, b2=p.b2 * unit, b3=p.b3 * unit, c1=p.c1, c2=p.c2, c3=p.c3,
        exponent=float((slope * voltage / f).mean()), reverse=max(backwards, 0.0),
        mismatch=float((f[0] - f[1]) / f.sum()), lag=max(rig.lag, 0.005), delay=rig.delay,
        voltage_limit=rig.voltage_limits[1], **({} if rig.coupling == NO_COUPLING else measured_coupling(rig.coupling)),
    ), voltage  # fmt: skip


def measured_coupling(coupling: Coupling) -> dict[str, float]:
    """The moments between the axes by their names in `MeasuredParameters`."""
    names = ("centrifugal", "centre", "pitch_spin", "gyro", "pitch_speed")
    return dict(zip(names, coupling))


def multisine(
    band: tuple[float, float], duration: float, amplitude: float, rng: np.random.Generator
) -> Callable[[float], float]:
    """Sum of tones at harmonics of the duration, logarithmically spaced, with random phases.

    Its maximum is `amplitude`; it fades in from zero and out to zero.
    """
    harmonics = np.unique(np.maximum(np.round(np.geomspace(*band, TONES) * duration), 1.0))
    frequencies = 2.0 * math.pi * harmonics / duration
    phases = rng.uniform(0.0, 2.0 * math.pi, len(frequencies))
    weights = frequencies**-0.5  # more power at low frequencies, where an axis moves far at small voltages
    grid = np.arange(0.0, duration, 0.02)
    largest = np.abs(np.cos(np.outer(grid, frequencies) + phases) @ weights).max()

    def reference(t: float) -> float:
        fade = max(min(t / FADE, (duration - t) / FADE, 1.0), 0.0)
        return fade * amplitude / largest * float(np.cos(frequencies * t + phases) @ weights)

    return reference


def design(rig: Rig, duration: float = LONGEST, seed: int = 0) -> Experiment:
    """Best of CANDIDATES multisine experiments, by the mean logarithm of the expected standard errors.

    The references of a controller about hover excite pitch and elevation simultaneously, as far as the rig's limits
    permit: voltages within `rig.limits`, pitch within half of them.

    Raises ValueError for a duration that is not 10 to 60 s, or a rig whose limits permit no excitation.
    """
    if not (isinstance(duration, int | float) and 10.0 <= duration <= LONGEST):
        raise ValueError(f"duration = {duration!r}: must be 10 to {LONGEST:g} s")
    parameters, voltage = parameters_of(rig)
    rng = np.random.default_rng(seed)
    best, best_score = None, math.inf
    for _ in range(CANDIDATES):
        log = largest_flight(rig, parameters, voltage, duration, rng)
        if log is None:
            continue
        errors, shares = expected_errors(log, parameters, voltage, rig.encoder_counts)
        score = float(np.mean(np.log(list(shares.values()))))
        if score < best_score:
            best, best_score = Experiment(log, errors, shares), score
    if best is None:
        raise ValueError(f"rig = {rig.name!r}: its limits, {rig.limits}, must permit more than hover")
    return best


def largest_flight(
    rig: Rig, parameters: MeasuredParameters, voltage: float, duration: float, rng: np.random.Generator
) -> FlightLog | None:
    """Flight on random multisines of the largest size within the limits; None if that size is too small."""
    pitch = multisine(PITCH_BAND, duration, 1.0, rng)
    elevation = multisine(ELEVATION_BAND, duration, 1.0, rng)
    low, high = rig.limits.u
    allowed = 0.5 * min(rig.limits.pitch_max, -rig.limits.pitch_min)
    size = 1.0
    while size > 0.05:

        def references(t: float, size: float = size) -> tuple[float, float]:
            return size * allowed * pitch(t), size * math.radians(10.0) * elevation(t)

        log = simulate_log(
            parameters, voltage, references, duration, name=f"{rig.name}-experiment", counts=rig.encoder_counts
        )
        inside = low <= log.voltages.min() and log.voltages.max() <= high
        if inside and np.abs(log.angles[2]).max() < 2.0 * allowed and np.abs(log.angles[1]).max() < math.radians(25.0):
            values = np.array([references(float(t)) for t in log.t]).T
            named = {"pitch_ref": values[0], "elevation_ref": values[1]}
            return FlightLog(log.t, log.angles, log.voltages, named, log.name)
        size *= 0.8
    return None


def expected_errors(
    log: FlightLog, parameters: MeasuredParameters, voltage: float, counts: Sequence[int] = Rig.encoder_counts
) -> tuple[dict[str, float], dict[str, float]]:
    """Expected standard errors of the parameters from a flight, absolute and relative to the prior's spread."""
    problem = Shooting([log], 1.0, counts=counts)
    names = [*COEFFICIENTS, *(name for effect in EFFECTS.values() for name in effect if name != "voltage_limit")]
    problem.sigma = MODEL_ERROR * problem.least_sigma
    problem.correlation_time = np.full(3, 0.2)
    theta = np.array(parameters, dtype=float)
    problem.hover_voltage = voltage
    covariance, _ = problem.covariances(theta, theta, names)
    errors, prior = np.sqrt(np.diag(covariance)), np.array([getattr(SPREAD, name) for name in names])
    return dict(zip(names, errors.tolist())), dict(zip(names, (errors / prior).tolist()))
