"""`heli-make-references`: the maneuver suite, that is, the references of `gym.make("Heli3DOF-v0", reference=name)`.

Most are plans of Section III-D from rest to rest. The elevation sine and the take-off prescribe travel and elevation
over time; by (3), these determine pitch, thrusts and voltages.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import pi, radians
from pathlib import Path

import numpy as np
from numpy.polynomial import Polynomial
from rich.console import Console
from scipy.interpolate import make_lsq_spline
from scipy.optimize import brentq

from heli_gym.baselines.planning.planner import plan
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import REFERENCES
from heli_gym.flatness import invert_motion
from heli_gym.model import dynamics
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.rig import PAPER
from heli_gym.storage import check_folder
from heli_gym.trajectory import Maneuver, Trajectory, concatenate

# s, between stored samples. Replayed through (3), they stay within 2e-4 rad and rad/s.
SAMPLE_PERIOD = 0.04
CORNERED_PERIOD = 0.005  # s, for the paper's maneuver: its voltages have corners at their limits
INVERSION_PERIOD = 1e-3  # s, grid of the inversion of (3)

# From rest to rest with zero second and third derivatives at both ends: the thrust leaves zero like t², and the
# voltage, its root, like t. (The setup polynomial of Section III-B would give sqrt(t).)
SMOOTH_RISE = Polynomial([0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0])
TAKE_OFF_DURATION = 8.0  # s

SINE_DURATION = 20.0  # s: one period of the travel, four of the elevation
SINE_TRAVEL, SINE_ELEVATION = radians(45.0), radians(7.5)  # amplitudes


def ground_elevation(parameters: HelicopterParameters) -> float:
    """Elevation in rad, below level, at which (3) is at rest without thrust."""

    def acceleration(elevation: float) -> float:
        return float(dynamics((0.0, 0.0, elevation, 0.0, 0.0, 0.0), (0.0, 0.0), parameters)[3])

    return brentq(acceleration, -0.5 * pi, 0.5 * pi, xtol=1e-15, rtol=1e-15)


def inversion_times(duration: float) -> np.ndarray:
    """Times (K,) in s of the inversion grid."""
    return np.linspace(0.0, duration, 1 + round(duration / INVERSION_PERIOD))


def elevation_sine() -> Trajectory:
    """Sinusoidal elevation, and travel at a quarter of its frequency, without rest at the start."""
    t = inversion_times(SINE_DURATION)

    def sine(amplitude: float, period: float) -> np.ndarray:
        w = 2.0 * pi / period
        return amplitude * np.stack((np.sin(w * t), w * np.cos(w * t), -(w**2) * np.sin(w * t)))

    travel, elevation = sine(SINE_TRAVEL, SINE_DURATION), sine(SINE_ELEVATION, SINE_DURATION / 4.0)
    return invert_motion(t, travel, elevation, Limits(), PAPER)


def take_off() -> Trajectory:
    """Rise to level from rest without thrust, 18.6 degrees below level; the voltages start at 0 V."""
    T = TAKE_OFF_DURATION
    ground, t = ground_elevation(PAPER.parameters), inversion_times(T)
    elevation = np.stack([-ground * SMOOTH_RISE.deriv(n)(t / T) / T**n for n in range(3)])
    elevation[0] += ground
    return invert_motion(t, np.zeros_like(elevation), elevation, Limits(u_min=0.0), PAPER)


def plan_from_rest(travel_deg: float, elevation_deg: float, duration: float, start_deg: float = 0.0) -> Trajectory:
    """Plan within the paper's limits, from level at `start_deg` to a travel and elevation; degrees and s."""
    goal = radians(travel_deg), radians(elevation_deg)
    return plan(Maneuver((radians(start_deg), 0.0), goal, duration), method="paper")


def return_trip() -> Trajectory:
    """Half a turn forth and back."""
    return concatenate(plan_from_rest(180.0, 0.0, 10.0), plan_from_rest(0.0, 0.0, 10.0, start_deg=180.0))


# Elevation is positive downwards.
SUITE: dict[str, Callable[[], Trajectory]] = {
    "travel-360": partial(plan, Maneuver(), method="paper"),
    "travel-360-slow": partial(plan_from_rest, 360.0, 0.0, 15.0),
    "travel-180": partial(plan_from_rest, 180.0, 0.0, 10.0),
    "climb-7.5": partial(plan_from_rest, 0.0, -7.5, 5.0),
    "descend-7.5": partial(plan_from_rest, 0.0, 7.5, 5.0),
    "climb-15": partial(plan_from_rest, 0.0, -15.0, 7.0),
    "back-60-descend": partial(plan_from_rest, -60.0, 5.0, 7.0),
    "travel-90-climb": partial(plan_from_rest, 90.0, -7.5, 8.0),
    "return-180": return_trip,
    "elevation-sine": elevation_sine,
    "take-off": take_off,
}


def solve_reference(name: str) -> Trajectory:
    """Solve a reference of the suite by its name, sampled for storage."""
    return resample(SUITE[name](), CORNERED_PERIOD if name == "travel-360" else SAMPLE_PERIOD)


def resample(trajectory: Trajectory, period: float) -> Trajectory:
    """Resample a finer trajectory with about `period` seconds between samples.

    The states, and the voltages at both ends, are exact. The other voltages are a least-squares fit of their linear
    interpolation, clipped to the limits. (Exact samples would be chords on one side of a curve; over four integrations
    from pitch to travel, their error would accumulate.)
    """
    times = np.linspace(0.0, trajectory.duration, 1 + round(trajectory.duration / period))
    knots = np.concatenate((times[:1], times, times[-1:]))
    u = make_lsq_spline(trajectory.t, trajectory.u.T, knots, k=1)(times).T
    u[:, [0, -1]] = trajectory.u[:, [0, -1]]
    return Trajectory(times, trajectory(times)[0], np.clip(u, *trajectory.limits.u), trajectory.limits)


@dataclass
class Args:
    """Solve every maneuver of the suite and store it."""

    out: Path = REFERENCES  # folder; the package's own by default


def main(args: Args | None = None) -> None:
    """Run the command `heli-make-references`."""
    with command("heli-make-references"):
        run(args or parse(Args, "heli-make-references", __doc__))


def run(args: Args) -> None:
    """Solve and store the references one after the other."""
    console = Console()
    check_folder("out", args.out)
    paths = {name: args.out / f"{name}.npz" for name in SUITE}
    announce_replaced("heli-make-references", *paths.values())
    for name, path in paths.items():
        reference = solve_reference(name)
        reference.save(path)
        pitch = np.degrees(reference.x[4])
        console.print(
            f"{name}: {reference.duration:g} s, pitch {pitch.min():.1f}° to {pitch.max():.1f}°, voltages "
            f"{reference.u.min():.2f} to {reference.u.max():.2f} V, {path.stat().st_size / 1000:.0f} kB"
        )


if __name__ == "__main__":
    main()
