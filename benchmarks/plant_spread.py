"""Ranges of the plants and the rigs that were identified from measured flights, effect by effect.

python benchmarks/plant_spread.py --out docs/plants-spread.png
"""

import argparse
import csv
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from heli_gym import PLANTS, Plant, Rig, find_rig
from heli_gym.baselines.evaluation.figure_style import INK, save, styled
from heli_gym.baselines.evaluation.labels import BLUE, RED
from heli_gym.plant import HELD_OUT_SEED, ThrustDrift, rotor_curves
from heli_gym.rig import fleet_rig_names

MEASURED_DRIFT = Path(__file__).parents[1] / "results" / "identification" / "drift.csv"  # of `identification.py drift`
DRAWS = 1000
NAMES = ("nominal", "lab", "rigid", "fleet")
COLOURS = {"nominal": INK, "lab": "0.45", "rigid": "0.7", "fleet": RED}


def friction(axis: int) -> Callable[[Plant], float]:
    """Function of a plant that returns the viscous friction of an axis."""
    return lambda p: p.friction.viscous[axis] + p.parameters[-3 + axis]


def exponent(p: Plant) -> float:
    """Exponent of the thrust in the voltage."""
    curve = rotor_curves(p.thrust_map)[0]
    return 2.0 if curve is None else float(curve.exponent)


def mismatch(p: Plant) -> float:
    """Share in percent by which the front rotor is stronger than the mean."""
    curves = rotor_curves(p.thrust_map)
    front, back = p.rotors.gains
    if curves[0] is not None and curves[0] != curves[1]:
        front, back = front * curves[0].k_plus, back * curves[1].k_plus
    return 100.0 * (front - back) / (front + back)


def pitch_zero(p: Plant) -> float:
    """Pitch in degrees that is measured in level hover."""
    return -math.degrees(p.sensors.zeros[2]) if p.sensors else 0.0


def hover_voltage(p: Plant) -> float:
    """Voltage in V at which the plant hovers."""
    if p.hover_voltage:
        return float(p.hover_voltage)
    curve = rotor_curves(p.thrust_map)[0]
    f = -0.5 * p.parameters.a2 / p.parameters.b2
    if curve is None:
        return math.sqrt(f / ((1.0 - p.rotors.thrust_loss) * p.parameters.k_plus))
    return float(curve.voltage(f))


def lift(p: Plant) -> float:
    """Acceleration of level elevation in rad/s² at a travel rate of 1 rad/s."""
    c = p.coupling
    if p.rig is not None:
        return math.nan  # in its equations
    return p.travel_lift + c.centrifugal * math.sin(c.centre) * math.cos(c.centre)


def drift(p: Plant) -> float:
    """Loss of thrust in percent within 20 s."""
    return 100.0 * sum(d.loss * 20.0 / d.duration for d in p.disturbances if isinstance(d, ThrustDrift))


def measured_drift() -> list[float]:
    """Losses of thrust in percent within 20 s on the measured flights."""
    with open(MEASURED_DRIFT, newline="", encoding="utf-8") as file:
        return [float(row["loss in 20 s (%)"]) for row in csv.DictReader(file)]


EFFECTS: dict[str, Callable[[Plant], float]] = {
    "a1 (rad/s²)": lambda p: p.parameters.a1,
    "a2 (rad/s²)": lambda p: p.parameters.a2,
    "a3 (rad/s²)": lambda p: p.parameters.a3,
    "b1 : b2": lambda p: p.parameters.b1 / p.parameters.b2,
    "b3 : |b2|": lambda p: -p.parameters.b3 / p.parameters.b2,
    "hover voltage (V)": hover_voltage,
    "exponent of the thrust": exponent,
    "front stronger by (%)": mismatch,
    "rotor lag (s)": lambda p: p.rotors.lag,
    "dead time (s)": lambda p: p.rotors.delay,
    "travel friction (1/s)": friction(0),
    "elevation friction (1/s)": friction(1),
    "pitch friction (1/s)": friction(2),
    "pitch read in level hover (deg)": pitch_zero,
    "lift at 1 rad/s (rad/s²)": lift,
    "gyroscopic moment (1/s)": lambda p: p.coupling.gyro,
    "spin": lambda p: p.coupling.spin if p.rig is None else math.nan,
    "thrust lost in 20 s (%)": drift,
}

PAIRS = (  # of numbers that go together on the rigs
    ("a1 (rad/s²)", lambda p: p.parameters.a1, "centrifugal moment", lambda p: p.coupling.centrifugal),
    ("dead time (s)", lambda p: p.rotors.delay, "gyroscopic moment (1/s)", lambda p: p.coupling.gyro),
    ("b1 : b2", lambda p: p.parameters.b1 / p.parameters.b2, "airflow (1/rad)", lambda p: p.coupling.airflow),
)
PAIRED = 300  # draws


@styled
def picture(rigs: dict[str, Rig]) -> Figure:
    """Range of each effect over draws of each plant (bars), and the identified rigs (dots); pairs on `fleet`."""
    figure = Figure(figsize=(11.0, 11.0))
    draws = {
        name: [PLANTS[name].draw(np.random.default_rng(HELD_OUT_SEED + i)) for i in range(DRAWS)] for name in NAMES
    }
    identified = [Plant.from_rig(rig) for rig in rigs.values()]
    panels = figure.subplots(7, 3, gridspec_kw={"height_ratios": [1.0] * 6 + [2.0]})
    for axes, (title, effect) in zip(panels.ravel(), EFFECTS.items()):
        for i, name in enumerate(NAMES):
            values = [effect(p) for p in draws[name]]
            marker = "-" if np.ptp(values) else "s"  # a single value
            axes.plot(
                [min(values), max(values)],
                [3 - i] * 2,
                marker,
                color=COLOURS[name],
                linewidth=5.0,
                markersize=5.0,
                solid_capstyle="butt",
            )
        values = measured_drift() if effect is drift else [effect(p) for p in identified]
        axes.plot(values, [-1] * len(values), "o", color=BLUE, alpha=0.7)
        axes.set(title=title, ylim=(-1.7, 3.7), yticks=range(-1, 4), yticklabels=["measured", *NAMES[::-1]])
    for axes, (x_name, x, y_name, y) in zip(panels[-1], PAIRS):
        for plants, style in (
            (draws["fleet"][:PAIRED], {"color": RED, "alpha": 0.25, "markersize": 3.0}),
            (identified, {"color": BLUE}),
        ):
            axes.plot([x(p) for p in plants], [y(p) for p in plants], "o", **style)
        axes.set(xlabel=x_name, ylabel=y_name)
    return figure


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", default="out/plants-spread.png", help=".png file")
    args = parser.parse_args()
    save(picture({name: find_rig(name) for name in fleet_rig_names()}), args.out)


if __name__ == "__main__":
    main()
