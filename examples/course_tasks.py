"""Tasks of the course on one rig, and the same maneuvers with this package's planner and controller.

    python examples/course_tasks.py --rig ntnu        # needs heli-gym[eval,ocp]

Travel by 180 degrees with the pitch within 30 degrees: a quadratic program with the inner loop alone, the same program
with an LQR, and a nonlinear program with an elevation bump on the path; the other rows are the package's own plans. All
are flown on the exact rig and on draws of the plant `lab`; in the last column, angles have the noise of an IMU.
`--plans` compares plans of both on the exact rig instead, those with the bump as a floor included.
"""

import argparse
import math
from dataclasses import replace

import numpy as np

from heli_gym import Limits, Maneuver, Trajectory, find_rig
from heli_gym.baselines import fly, make_policy, plan, plan_fastest
from heli_gym.baselines.control.course import (
    PITCH_COMMAND,
    SchedulePolicy,
    bump,
    elevation_sign,
    flat_over_bump,
    lqr_gain,
    travel_by_qp,
    travel_over_bump,
)
from heli_gym.baselines.control.estimation import ENCODER_COUNTS, ENCODER_NOISE
from heli_gym.env import Heli3DOFEnv
from heli_gym.plant import HELD_OUT_SEED, find_plant
from heli_gym.rig import Rig

TRAVEL, DURATION = math.pi, 15.0  # rad, s
NEAR = math.radians(2.0)
IMU_NOISE = 0.01  # rad, standard deviation of the angles
COLUMNS = ("travel at end", "peak pitch", "elevation off", "bump missed")


def reference_of(rig: Rig) -> Trajectory:
    """Plan the transition with this package, within 30 degrees of pitch."""
    limits = Limits(*rig.limits.u, -PITCH_COMMAND, PITCH_COMMAND)
    return plan(Maneuver(goal=(TRAVEL, 0.0), duration=DURATION, limits=limits, rig=rig))


def outcome(flight: Trajectory, rig: Rig) -> tuple[float, ...]:
    """COLUMNS of a flight, in degrees."""
    up = elevation_sign(rig) * flight.x[2]
    missed = np.maximum(bump(flight.x[0], TRAVEL) - up, 0.0).max()
    values = abs(flight.x[0, -1] - TRAVEL), np.abs(flight.x[4]).max(), np.abs(up).max(), missed
    return tuple(np.degrees(values).tolist())


def settled(flight: Trajectory) -> float:
    """Time in s from which the travel stays within NEAR of its goal."""
    outside = np.flatnonzero(np.abs(flight.x[0] - TRAVEL) > NEAR)
    return float(flight.t[min(outside[-1] + 1, len(flight.t) - 1)])


def compare_plans(rig: Rig) -> None:
    """Print the course's programs and this package's plans side by side, flown on the exact rig."""
    limits = Limits(*rig.limits.u, -PITCH_COMMAND, PITCH_COMMAND)
    level = Maneuver(goal=(TRAVEL, 0.0), duration=DURATION, limits=limits, rig=rig)
    way = np.linspace(0.0, TRAVEL, 201)
    over = replace(level, floor=(way, elevation_sign(rig) * bump(way, TRAVEL)))
    lqr, flown = lqr_gain(rig), "feedforward+tvlqr"
    rows = [("course, quadratic program (LQR)", SchedulePolicy(travel_by_qp(rig, TRAVEL), rig, lqr), plan(level))]
    for name, maneuver in (("", level), (" over the bump", over)):
        if name:
            policy = SchedulePolicy(travel_over_bump(rig, TRAVEL), rig, lqr)
            rows.append((f"course, nonlinear program{name} (LQR)", policy, rows[1][2]))
        for kind, trajectory in (
            ("", plan(maneuver)),
            (", least effort", plan(maneuver, objective="effort")),
            (", fastest", plan_fastest(maneuver)),
        ):
            rows.append((f"planner{name}{kind} (TV-LQR)", make_policy(flown, trajectory), trajectory))
    print(f"rig {rig.name}: duration (s), {', '.join(COLUMNS[1:])} (deg), within {math.degrees(NEAR):g} deg from (s)")
    for name, policy, own in rows:
        flight = fly(Heli3DOFEnv("nominal", own, rig=rig), policy, seed=HELD_OUT_SEED)
        _, pitch, elevation, missed = outcome(flight, rig)
        print(f"{name:48s} {own.duration:5.1f} {pitch:6.1f} {elevation:6.1f} {missed:6.1f} {settled(flight):6.1f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rig", default="ntnu", help="name or .toml file (default: %(default)s)")
    parser.add_argument("--draws", type=int, default=5, help="helicopters of each plant (default: %(default)s)")
    parser.add_argument("--plans", action="store_true", help="compare plans on the exact rig instead")
    args = parser.parse_args()
    rig = find_rig(args.rig)
    if args.plans:
        compare_plans(rig)
        return
    reference = reference_of(rig)
    # the filter derives the noise of the angles from the encoder counts: counts with the same error as the IMU
    counts = round(ENCODER_COUNTS * ENCODER_NOISE / IMU_NOISE)
    noisy = replace(rig, encoder_counts=(counts, counts, counts))
    lab = find_plant("lab")
    assert lab.sensors is not None
    plants = {"exact": "nominal", "lab": lab, "lab, noisy": replace(lab, sensors=replace(lab.sensors, noise=IMU_NOISE))}

    qp, over = travel_by_qp(rig, TRAVEL), travel_over_bump(rig, TRAVEL)
    policies = {
        "QP, inner loop": SchedulePolicy(qp, rig),
        "QP and LQR": SchedulePolicy(qp, rig, lqr_gain(rig)),
        "bump, NLP and LQR": SchedulePolicy(over, rig, lqr_gain(rig)),
    }
    jobs = [(name, policy, reference) for name, policy in policies.items()]
    for kind, own in (("plan", reference), ("bump plan", flat_over_bump(rig, TRAVEL))):
        for label, name in (("TV-LQR", "feedforward+tvlqr"), ("Kalman LQR", "kalman-lqr")):
            jobs.append((f"{kind} and {label}", make_policy(name, own), own))
        jobs.append((f"{kind}, Kalman for noise", make_policy("kalman-lqr", own, rig=noisy), own))
    print(f"rig {rig.name}, {args.draws} draws, means in degrees: {', '.join(COLUMNS)}")
    for name, policy, own in jobs:
        cells = []
        for plant in plants.values():
            env = Heli3DOFEnv(plant, own, rig=rig)
            draws = 1 if plant == "nominal" else args.draws
            flights = [fly(env, policy, seed=HELD_OUT_SEED + k) for k in range(draws)]
            mean = np.mean([outcome(flight, rig) for flight in flights], axis=0)
            cells.append(" ".join(f"{value:7.2f}" for value in mean))
        print(f"{name:24s} | " + " | ".join(cells))


if __name__ == "__main__":
    main()
