"""The paper's rotation on models of measured rigs: planned within each rig's limits, flown by the paper's controller.

    python benchmarks/measured_rigs.py --draws 100 --out docs/measured-rigs.png

For each identified rig (`heli_gym/rigs/fleet`), the 360 degree rotation is planned in the shortest time and with
reserves of time, by equation (3) with friction and the rig's thrust map. `feedforward+tvlqr` flies each plan

* on the rig's own plant (`Plant.from_rig`), with all effects that were identified,
* on draws of that plant: thrust that drifts, and slow accelerations as large as those of the logs,
* on the same draws, where the pitch zero is not taken off the measurement,
* on draws of `fleet`, which are other rigs;

`kalman-lqr`, which knows lag and dead time, flies it on the draws of the rig's own plant. Reserves are distances to the
amplifier's limits and to the pitch stop in the plan; a flight succeeds if it ends within the environment's tolerances,
of 3 degrees of travel and elevation among others.
"""

import argparse
from dataclasses import replace

import gymnasium as gym
import numpy as np
from matplotlib.figure import Figure

from heli_gym import PLANTS, Gust, Maneuver, Plant, Sensors, ThrustDrift, Trajectory
from heli_gym.baselines import fly, fly_many, make_policy, plan, plan_fastest
from heli_gym.baselines.evaluation.figure_style import INK, finish, save, styled
from heli_gym.baselines.evaluation.labels import BLUE, RED
from heli_gym.baselines.evaluation.metrics import flight_metrics
from heli_gym.plant import DRIFT_DURATION, FLEET_DRIFT, HELD_OUT_SEED
from heli_gym.rig import Rig, find_rig, fleet_rig_names

FACTORS = (1.0, 1.25, 1.5, 2.0)  # durations relative to the shortest one
PAPERS, DELAY_AWARE = "feedforward+tvlqr", "kalman-lqr"
LONGEST = 60.0  # s
SLOW = {"travel": 0.02, "elevation": 0.07, "pitch": 0.15}  # rad/s², spread of the logs' slow accelerations
CORRELATION_TIME = 2.0  # s, the windows in which they were estimated


def plants_of(rig: Rig) -> dict[str, Plant]:
    """Plants on which a plan of the rig is flown, by name."""
    known, raw = Plant.from_rig(rig, sensors=Sensors(rig.encoder_counts)), Plant.from_rig(rig)
    slow = tuple(Gust(axis, size, CORRELATION_TIME) for axis, size in SLOW.items())
    drift = ThrustDrift(FLEET_DRIFT, duration=DRIFT_DURATION)
    return {
        "its own plant": known,
        "draws of it": replace(known, disturbances=(drift, *slow)),
        "draws, pitch zero unknown": replace(raw, disturbances=(drift, *slow)),
        "fleet": PLANTS["fleet"],
    }


def flights_on(plant: Plant, reference: Trajectory, draws: int, policy_name: str = PAPERS) -> list[Trajectory]:
    """Flights of a plan; one where the plant is not random."""
    rig, policy = reference.rig, make_policy(policy_name, reference)
    if not (plant.is_random or plant.is_noisy):
        return [fly(gym.make("Heli3DOF-v0", plant=plant, rig=rig, reference=reference), policy, seed=HELD_OUT_SEED)]
    envs = gym.make_vec("Heli3DOF-v0", num_envs=draws, plant=plant, rig=rig, reference=reference)
    return fly_many(envs.unwrapped, policy, HELD_OUT_SEED)


def reserves(flight: Trajectory, rig: Rig) -> tuple[float, float]:
    """Smallest distances of the voltages to the amplifier's limits in V, and of pitch to its stop in degrees."""
    low, high = rig.voltage_limits
    pitch = rig.pitch_limit - np.abs(flight.x[4]).max()
    return float(min(flight.u.min() - low, high - flight.u.max())), float(np.degrees(pitch))


def summary(reference: Trajectory, flights: list[Trajectory]) -> str:
    """Numbers of flights that succeed and that crash."""
    rig = reference.rig
    found = [flight_metrics(flight, reference, rig.voltage_limits, rig.pitch_limit) for flight in flights]
    return f"{sum(m.success for m in found)}, {sum(m.crashed for m in found)}"


def errors(reference: Trajectory, flight: Trajectory) -> str:
    """RMS errors of one flight, or the time at which it crashed."""
    rig = reference.rig
    m = flight_metrics(flight, reference, rig.voltage_limits, rig.pitch_limit)
    return f"crash at {m.flown:.1f} s" if m.crashed else " / ".join(f"{value:.1f}" for value in m.rms_error_deg)


@styled
def picture(cases: dict[str, tuple[Trajectory, dict[str, list[Trajectory]]]]) -> Figure:
    """Slowest plans (dashed), flights on draws of the own plant (blue) and of `fleet` (red); a column for each rig."""
    figure = Figure(figsize=(2.9 * len(cases), 7.6))
    panels = figure.subplots(4, len(cases), sharex="col", squeeze=False)
    for column, (name, (reference, flown)) in zip(panels.T, cases.items()):
        quantities = (
            ("travel (deg)", lambda f: np.degrees(f.x[0])),
            ("elevation (deg, positive down)", lambda f: np.degrees(f.x[2])),
            ("pitch (deg)", lambda f: np.degrees(f.x[4])),
            ("front motor (V)", lambda f: f.u[0]),
        )
        for axes, (label, values) in zip(column, quantities):
            axes.set_ylabel(label if name == next(iter(cases)) else "")
            for where, colour, alpha in (("fleet", RED, 0.15), ("draws of it", BLUE, 0.25)):
                for i, flight in enumerate(flown[where][:30]):
                    axes.plot(flight.t, values(flight), color=colour, alpha=alpha, linewidth=0.8,
                              label=None if i else where)  # fmt: skip
            axes.plot(reference.t, values(reference), color=INK, linestyle="--", linewidth=1.2, label="plan")
            axes.set_xlim(0.0, reference.duration)
        for limit in reference.rig.voltage_limits:
            column[3].axhline(limit, color="0.5", linewidth=0.8)
        for limit in (-1.0, 1.0):
            column[2].axhline(limit * np.degrees(reference.rig.pitch_limit), color="0.5", linewidth=0.8)
        column[0].set_ylim(-60.0, 420.0)
        column[1].set_ylim(-40.0, 40.0)
        column[0].set_title(f"{name}, {reference.duration:.1f} s")
        column[3].set_xlabel("time (s)")
    finish(figure)
    return figure


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rigs", nargs="+", default=[*fleet_rig_names(), "fleet"])
    parser.add_argument("--draws", type=int, default=100)
    parser.add_argument("--out", help=".png file for the figure")
    args = parser.parse_args()
    print(f"Successes and crashes of {args.draws} draws each.\n")
    print("| rig | duration | reserve | RMS errors (deg) | own draws | zero unknown | fleet | own draws, kalman-lqr |")
    print("|---|---|---|---|---|---|---|---|")
    cases = {}
    for name in args.rigs:
        rig = find_rig(name)
        maneuver = Maneuver(goal=(2.0 * np.pi, 0.0), duration=LONGEST, rig=rig)
        fastest = plan_fastest(maneuver)
        for factor in FACTORS:
            longer = replace(maneuver, duration=factor * fastest.duration)
            reference, plants = fastest if factor == 1.0 else plan(longer), plants_of(rig)
            flown = {where: flights_on(plant, reference, args.draws) for where, plant in plants.items()}
            (own,), *others = flown.values()
            others.append(flights_on(plants["draws of it"], reference, args.draws, DELAY_AWARE))
            volts, pitch = reserves(reference, rig)
            cells = " | ".join(summary(reference, flights) for flights in others)
            print(
                f"| {name} | {reference.duration:.2f} s | {volts:.2f} V, {pitch:.0f}° | {errors(reference, own)} "
                f"| {cells} |",
                flush=True,
            )
            cases[name] = reference, flown
    if args.out:
        save(picture(cases), args.out)


if __name__ == "__main__":
    main()
