"""Plans of random plausible rigs: the fastest, and in 1.02, 1.1 and 2 times its duration.

    python benchmarks/rigs.py --rigs 200 --out out/rigs.csv

Rigs come from random masses or coefficients, with elevation positive down or up, with and without friction, and with
linear, quadratic, power and measured thrust maps, dead zones, unequal rotors and fans that cannot turn backwards. Every
plan is checked without the package's model: its voltages, linear between the samples, are flown open loop through (3),
typed here again, by a Runge-Kutta method with steps of 0.25 ms.
"""

import argparse
import math
import time
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numba import njit

from heli_gym import HelicopterParameters, Limits, Maneuver, PowerCurve, Rig, TableCurve, ThrustMap
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest
from heli_gym.rig import Masses, coefficients_from_masses
from heli_gym.storage import atomic_write, to_csv

TIMES_FASTEST = (1.02, 1.1, 2.0)
LONGEST = 600.0  # s, given to the search for the fastest plan
ARRIVAL = 1e-3  # rad and rad/s, accepted distance of a flight's end from the plan's, per turn of travel
EXCESS = 1e-4  # of the range of a limit, accepted
SUBSTEPS = 4  # of the integration, from each sample of a plan to the next
GROWTH = 4.0  # exponent of error growth in an unstable flight, after which it starts anew
AMPLIFIERS = ((0.0, 12.0), (-10.0, 10.0), (-24.0, 24.0), (-5.0, 15.0), (0.0, 30.0))  # V


def random_coefficients(rng: np.random.Generator) -> dict[str, float]:
    """Coefficients of (3): from masses and lengths, or from ranges around those of identified rigs."""
    if rng.random() < 0.5:
        arm, counterweight_arm = rng.uniform(0.5, 0.9), rng.uniform(0.35, 0.6)
        rotor_arm, body = rng.uniform(0.12, 0.25), rng.uniform(0.8, 2.2)
        masses = Masses(
            body,
            rng.uniform(0.75, 0.97) * body * arm / counterweight_arm,
            arm,
            counterweight_arm,
            rotor_arm,
            rng.uniform(0.7, 1.0) * rotor_arm,
            body_drop=rng.uniform(0.0, 0.03),
            counterweight_drop=rng.uniform(0.0, 0.1),
            hinge_height=rng.uniform(-0.03, 0.03),
        )
        found = coefficients_from_masses(masses)
    else:
        found = {
            "a1": rng.uniform(-2.0, 0.0),
            "a2": rng.uniform(0.2, 1.5),
            "a3": rng.uniform(-2.0, 0.0),
            "b1": -(10.0 ** rng.uniform(-0.7, 0.3)),
            "b2": -(10.0 ** rng.uniform(-0.7, 0.3)),
            "b3": 10.0 ** rng.uniform(0.3, 1.0),
        }
    if rng.random() < 0.7:
        found |= {"c1": rng.uniform(0.0, 0.3), "c2": rng.uniform(0.0, 0.6), "c3": rng.uniform(0.0, 0.6)}
    if rng.random() < 0.3:  # elevation positive upwards
        found |= {"a2": -found["a2"], "b2": -found["b2"]}
    if rng.random() < 0.2:  # the other sense of travel
        found["b1"] = -found["b1"]
    return found


def random_curve(rng: np.random.Generator, kind: str, voltage: float, thrust: float, low: float, high: float) -> Any:
    """Curve of a kind that gives a thrust in N at a voltage in V."""
    backwards = rng.choice([0.0, rng.uniform(0.2, 1.0)])
    if kind == "table":
        exponent, zone = rng.uniform(0.9, 1.8), rng.uniform(0.0, 0.2) * voltage
        points = np.unique(np.concatenate((np.linspace(low, high, 9), [-zone, zone, 0.0])))
        beyond = np.maximum(np.abs(points) - zone, 0.0) ** exponent
        values = thrust * beyond / (voltage - zone) ** exponent * np.where(points < 0.0, -max(backwards, 0.1), 1.0)
        kept = np.concatenate(([True], (np.diff(values) >= 0.0)))
        points, values = points[kept], values[kept]
        if values[1] <= values[0]:  # an amplifier that ends within the dead zone: the curve must rise at its ends
            points, values = np.append(low - 1.0, points), np.append(values[0] - 0.01 * thrust, values)
        return TableCurve(tuple(map(float, points)), tuple(map(float, values)))
    exponent = {"linear": 1.0, "quadratic": 2.0}.get(kind) or rng.uniform(0.9, 1.8)
    zone = rng.choice([0.0, rng.uniform(0.0, 0.2) * voltage]) if kind == "power" else 0.0
    k = thrust / (voltage - zone) ** exponent
    return PowerCurve(float(k), float(-backwards * k), float(exponent), float(zone))


def random_rig(rng: np.random.Generator) -> Rig:
    """Random rig that hovers within its limits."""
    while True:
        found = random_coefficients(rng)
        low, high = AMPLIFIERS[rng.integers(len(AMPLIFIERS))]
        thrust = -0.5 * found["a2"] / found["b2"]
        hover = rng.uniform(0.25, 0.75) * high
        kind = str(rng.choice(["quadratic", "linear", "power", "table"]))
        front = random_curve(rng, kind, hover, thrust, low, high)
        back = front
        if rng.random() < 0.4:
            back = random_curve(rng, kind, hover * rng.uniform(0.9, 1.1), thrust, low, high)
        stop, reserve = math.radians(rng.uniform(20.0, 85.0)), rng.uniform(0.0, 0.15) * (high - low)
        pitch_min, pitch_max = (-math.radians(rng.uniform(10.0, 80.0)), math.radians(rng.uniform(10.0, 80.0)))
        if rng.random() < 0.7:
            pitch_min = -pitch_max
        try:
            return Rig(
                f"{kind}{', unequal' if back is not front else ''}{', up' if found['b2'] > 0.0 else ''}",
                HelicopterParameters()._replace(**found),
                ThrustMap(front, back),
                voltage_limits=(low, high),
                pitch_limit=stop,
                limits=Limits(low + reserve, high - reserve, max(pitch_min, -stop), min(pitch_max, stop)),
            )
        except ValueError:  # does not hover within its limits
            continue


def random_maneuver(rng: np.random.Generator, rig: Rig) -> Maneuver:
    """Random transition of a rig between elevations at which it hovers."""
    while True:
        start, goal = np.radians(rng.uniform(-20.0, 20.0, 2))
        travel = math.radians(
            rng.choice([0.0, rng.uniform(-90.0, 90.0), rng.uniform(-720.0, 720.0)], p=[0.1, 0.3, 0.6])
        )
        try:
            return Maneuver((0.0, float(start)), (travel, float(goal)), LONGEST, rig=rig)
        except ValueError:  # does not hover there
            continue


@njit
def fly_steps(x, sums, differences, steps, p):
    """States (6, K + 1) from x (6,) by SUBSTEPS Runge-Kutta steps between two times, on equation (3) typed again."""
    a1, a2, a3, b1, b2, b3, c1, c2, c3 = p
    states = np.empty((6, len(steps) + 1))
    states[:, 0], now, mean, slope = x, x.copy(), np.empty(6), np.empty(6)
    for k in range(len(steps)):
        h = steps[k]
        for j in range(2 * SUBSTEPS * k, 2 * SUBSTEPS * (k + 1), 2):
            mean[:] = 0.0
            slope[:] = 0.0
            for stage in range(4):
                z = now + (0.0, 0.5 * h, 0.5 * h, h)[stage] * slope
                v1, v2 = sums[j + (0, 1, 1, 2)[stage]], differences[j + (0, 1, 1, 2)[stage]]
                cos2, sin3 = math.cos(z[2]), math.sin(z[4])
                slope[0], slope[2], slope[4] = z[1], z[3], z[5]
                slope[1] = b1 * cos2 * sin3 * v1 - c1 * z[1]
                slope[3] = a1 * math.sin(z[2]) + a2 * cos2 + b2 * math.cos(z[4]) * v1 - c2 * z[3]
                slope[5] = a3 * cos2 * sin3 + b3 * v2 - c3 * z[5]
                mean += (1.0, 2.0, 2.0, 1.0)[stage] / 6.0 * slope
            now += h * mean
        states[:, k + 1] = now
    return states


def fly(x: np.ndarray, t: np.ndarray, u: np.ndarray, rig: Rig) -> np.ndarray:
    """States (6, K) at the times t (K,) of a flight from x (6,) under voltages u (2, K), linear between these times."""
    n = 2 * SUBSTEPS
    times = np.append((t[:-1, None] + np.diff(t)[:, None] * (np.arange(n) / n)).reshape(-1), t[-1])
    f = rig.thrust(np.stack([np.interp(times, t, row) for row in u]))
    return fly_steps(x.copy(), f[0] + f[1], f[0] - f[1], np.diff(t) / SUBSTEPS, tuple(map(float, rig.parameters[2:])))


def check(maneuver: Maneuver, found: Any) -> dict[str, float]:
    """Distance of a plan from flights of its voltages, in rad and rad/s, and its excess, as a share of limit ranges.

    A flight starts anew on the plan where an unstable hover has amplified its error by e^GROWTH. The distances of the
    ends of all flights are added up.
    """
    rig, limits = maneuver.rig, maneuver.limits
    p, growth = rig.parameters, 0.0
    for elevation in (maneuver.start[1], maneuver.goal[1]):  # of pitch and elevation about hover
        pitching, sinking = p.a3 * math.cos(elevation), p.a1 * math.cos(elevation) - p.a2 * math.sin(elevation)
        for slope, friction in ((pitching, p.c3), (sinking, p.c2)):
            growth = max(growth, float(np.roots([1.0, friction, -slope]).real.max()))
    pieces = 1 + math.floor(growth * found.duration / GROWTH)
    ends = np.unique(np.searchsorted(found.t, np.linspace(0.0, found.duration, pieces + 1)))
    missed, flown = 0.0, []
    for first, last in pairwise(ends.tolist()):
        along = slice(first, last + 1)
        x = fly(found.x[:, first], found.t[along], found.u[:, along], rig)
        missed += float(np.abs(x[:, -1] - found.x[:, last]).max())
        flown.append(x[4])
    pitch = np.concatenate(flown)
    (low, high), (pitch_low, pitch_high) = limits.u, limits.pitch
    excess = max(
        max(low - found.u.min(), found.u.max() - high) / (high - low),
        max(pitch_low - pitch.min(), pitch.max() - pitch_high) / (pitch_high - pitch_low),
    )
    goal = [maneuver.goal[0], 0.0, maneuver.goal[1], 0.0, 0.0, 0.0]
    start = [maneuver.start[0], 0.0, maneuver.start[1], 0.0, 0.0, 0.0]
    missed += float(max(np.abs(found.x[:, 0] - start).max(), np.abs(found.x[:, -1] - goal).max()))
    return {"missed": missed, "excess": float(max(excess, 0.0)), "late": abs(found.duration - maneuver.duration)}


def is_good(checked: dict[str, float], travel: float) -> bool:
    """Whether a checked plan is a flight of its voltages within the limits, from start to goal in its duration."""
    tolerance = ARRIVAL * max(1.0, abs(travel) / (2.0 * math.pi))
    return checked["missed"] <= tolerance and checked["excess"] <= EXCESS and checked["late"] < 1e-9


def rows_of(seed: int) -> Iterator[dict[str, Any]]:
    """Rows of one random rig: the fastest plan, and plans of longer durations."""
    rng = np.random.default_rng([14, seed])
    rig = random_rig(rng)
    maneuver = random_maneuver(rng, rig)
    fastest = None
    for factor in (1.0, *TIMES_FASTEST):
        row: dict[str, Any] = {"rig": seed, "kind": rig.name, "maneuver": str(maneuver), "factor": factor}
        began = time.perf_counter()
        try:
            if factor == 1.0:
                requested = maneuver
                fastest = found = plan_fastest(maneuver)
                requested = replace(maneuver, duration=found.duration)
            elif fastest is None:
                return
            else:
                requested = replace(maneuver, duration=factor * fastest.duration)
                found = plan(requested)
        except (InfeasibleManeuver, ValueError, ArithmeticError) as error:
            yield {**row, "planned": False, "seconds": time.perf_counter() - began, "reason": str(error)}
            continue
        row |= {"planned": True, "seconds": time.perf_counter() - began, "duration": found.duration}
        checked = check(requested, found)
        yield {**row, **checked, "good": is_good(checked, maneuver.goal[0] - maneuver.start[0]), "reason": ""}


def main() -> None:
    """Plan for all rigs, write the rows, and print how many were planned and passed the check."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rigs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0, help="of the first rig, then counting up")
    parser.add_argument("--out", type=Path, default=Path("out/rigs.csv"))
    args = parser.parse_args()
    rows: list[dict[str, Any]] = []
    for seed in range(args.seed, args.seed + args.rigs):
        for row in rows_of(seed):
            rows.append(row)
            if not row["planned"] or not row["good"]:
                print(row, flush=True)
    with atomic_write(args.out) as file:
        file.write(to_csv(rows))
    print(f"{args.rigs} rigs from seed {args.seed} on; {args.out}")
    print("| duration | planned | pass the check | largest miss | largest excess | median s | longest s |")
    print("|---|---|---|---|---|---|---|")
    for factor in (1.0, *TIMES_FASTEST):
        own = [row for row in rows if row["factor"] == factor]
        planned = [row for row in own if row["planned"]]
        seconds = [row["seconds"] for row in own]
        name = "the fastest" if factor == 1.0 else f"{factor:g} times it"
        print(
            f"| {name} | {len(planned)} of {len(own)} | {sum(row['good'] for row in planned)} | "
            f"{max(row['missed'] for row in planned):.1e} | {max(row['excess'] for row in planned):.1e} | "
            f"{np.median(seconds):.2f} | {max(seconds):.1f} |"
        )


if __name__ == "__main__":
    main()
