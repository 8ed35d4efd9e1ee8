"""What stands between the voltage and the measurement: rotors, friction, disturbances, sensors; and the presets.

A Plant is made of small values that combine. Any number in them, but for counts and delays, may be a `Uniform` range,
from which every episode draws. The ranges of the presets are those of published models and data of such rigs, except
that travel damping ends at 0.20 of the published 0.48 1/s (see `LAB_FRICTION`); none was measured on one. Controllers
are designed on the nominal parameters only, and are never shown a draw.
"""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import cached_property
from numbers import Integral
from typing import Any, TypeAlias

import numpy as np

from heli_gym.parameters import HelicopterParameters
from heli_gym.rigid_body import VARIANTS, solve_rigid_body

AXES = ("travel", "elevation", "pitch")
ROTORS = ("front", "back")
HELD_OUT_SEED = 2**31  # episodes of evaluations count their seeds from here on; tuning and training use smaller ones
TURN = 2.0 * math.pi  # rad
COULOMB_RATE = 0.02  # rad/s, over which Coulomb friction changes sign: smooth, so that RK4 keeps its order


@dataclass(frozen=True)
class Uniform:
    """A range from which every episode draws."""

    low: float
    high: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.low) and math.isfinite(self.high) and self.low <= self.high):
            raise ValueError(f"{self}: must be finite numbers with low <= high")


Number: TypeAlias = Any  # a float, or a Uniform to draw one from


def check_number(name: str, value: Number, low: float, high: float) -> None:
    """Raises ValueError unless the number, or all of its range, is within [low, high]."""
    bounds = (value.low, value.high) if isinstance(value, Uniform) else (value, value)
    if not (low <= bounds[0] and bounds[1] <= high):
        raise ValueError(f"{name} = {value}: must be at least {low:g} and at most {high:g}")


def check_finite(name: str, value: Number) -> None:
    """Raises ValueError unless it is a finite number, or a range, which is finite."""
    if not (isinstance(value, Uniform) or math.isfinite(value)):
        raise ValueError(f"{name} = {value}: must be a finite number")


def magnitude(value: Number) -> Any:
    """The greatest absolute value of a number, or of its range."""
    return max(abs(value.low), abs(value.high)) if isinstance(value, Uniform) else abs(value)


def check_choice(name: str, value: str, choices: tuple[str, ...]) -> None:
    """Raises ValueError unless the value is one of the choices."""
    if value not in choices:
        raise ValueError(f"{name} = {value!r}: must be one of {', '.join(map(repr, choices))}")


@dataclass(frozen=True)
class OneOf:
    """Alternatives, of which every episode draws one."""

    options: tuple[Any, ...]


def alternatives(value: Any) -> list:
    """The value once for each combination of the options in it, however deep."""
    if isinstance(value, OneOf):
        return [alternative for option in value.options for alternative in alternatives(option)]
    return [with_parts(value, parts) for parts in itertools.product(*map(alternatives, parts_of(value)))]


def count_ranges(value: Any) -> int:
    """How many ranges there are in it, however deep."""
    return 1 if isinstance(value, Uniform) else sum(map(count_ranges, parts_of(value)))


def at_uniforms(value: Any, uniforms: Iterator[float]) -> Any:
    """The value with every range in it, however deep, replaced by its point at the next of the uniforms in [0, 1)."""
    if isinstance(value, Uniform):
        return value.low + (value.high - value.low) * next(uniforms)
    return with_parts(value, [at_uniforms(part, uniforms) for part in parts_of(value)])


def parts_of(value: Any) -> list:
    """The fields of a dataclass, the items of a tuple, nothing of anything else."""
    if is_dataclass(value) and not isinstance(value, Uniform):
        return [getattr(value, f.name) for f in fields(value)]
    return list(value) if isinstance(value, tuple) else []


def with_parts(value: Any, parts: Sequence) -> Any:
    """The value with other parts."""
    if is_dataclass(value) and not isinstance(value, Uniform):
        return replace(value, **{f.name: part for f, part in zip(fields(value), parts)})  # type: ignore[type-var]
    if isinstance(value, tuple):
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return value


@dataclass(frozen=True)
class Rotors:
    """Amplifiers and rotors: how thrust follows from the voltage that a controller asks for.

    The delay is a whole number, and no range.
    """

    lag: Number = 0.0  # s, first order, of the rotor speed (and so of the root of the thrust) behind the voltage
    thrust_loss: Number = 0.0  # share that is missing: battery, air density, wear
    slew: Number = math.inf  # V/s, the amplifier's fastest change
    delay: int = 0  # control periods from the measurement to the voltage

    def __post_init__(self) -> None:
        check_number("lag", self.lag, 0.0, math.inf)
        check_number("thrust_loss", self.thrust_loss, 0.0, 1.0)
        check_number("slew", self.slew, 0.0, math.inf)
        if not (isinstance(self.delay, Integral) and 0 <= self.delay <= 1000):
            raise ValueError(f"delay = {self.delay}: must be a whole number, at least 0 and at most 1000")


@dataclass(frozen=True)
class Friction:
    """In the joints of travel, elevation and pitch, as decelerations."""

    viscous: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # 1/s, times the rate
    coulomb: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # rad/s², against the direction of motion

    def __post_init__(self) -> None:
        for name in ("viscous", "coulomb"):
            if len(getattr(self, name)) != len(AXES):
                raise ValueError(f"{name} = {getattr(self, name)}: must be one value each for {', '.join(AXES)}")
            for value in getattr(self, name):
                check_number(name, value, 0.0, math.inf)
                check_finite(name, value)


@dataclass(frozen=True)
class Sensors:
    """Encoders of the three angles; rates are estimated from them. The counts are whole numbers, and no ranges.

    The estimate is the filtered difference quotient r+ = a r + (1 - a) (q+ - q) / dt with a = exp(-dt / rate_filter),
    which is s / (1 + rate_filter s) sampled at the control period dt.
    """

    counts: tuple[int, int, int] = (8192, 4096, 4096)  # per revolution
    noise: Number = 0.0  # rad, standard deviation on each angle
    rate_filter: Number = 0.03  # s

    def __post_init__(self) -> None:
        if len(self.counts) != len(AXES) or not all(isinstance(n, Integral) and n >= 1 for n in self.counts):
            raise ValueError(f"counts = {self.counts}: must be a positive whole number each for {', '.join(AXES)}")
        check_number("noise", self.noise, 0.0, math.inf)
        check_finite("noise", self.noise)
        check_number("rate_filter", self.rate_filter, 1e-6, math.inf)


@dataclass(frozen=True)
class Push:
    """A torque on one axis from a time on, for a while: a step if that is long, a knock if it is short."""

    axis: str
    acceleration: Number  # rad/s²
    time: Number  # s
    duration: Number = 0.1  # s

    def __post_init__(self) -> None:
        check_choice("axis", self.axis, AXES)
        check_finite("acceleration", self.acceleration)
        check_finite("time", self.time)
        check_number("duration", self.duration, 0.0, math.inf)


@dataclass(frozen=True)
class Gust:
    """A torque on one axis that wanders: an Ornstein-Uhlenbeck process, from zero."""

    axis: str
    strength: Number  # rad/s², standard deviation
    correlation_time: Number = 1.0  # s

    def __post_init__(self) -> None:
        check_choice("axis", self.axis, AXES)
        check_number("strength", self.strength, 0.0, math.inf)
        check_finite("strength", self.strength)
        check_number("correlation_time", self.correlation_time, 1e-6, math.inf)


@dataclass(frozen=True)
class MovingMass:
    """A mass that slides along the arm, and so changes the weight's a2 in (3), linearly over a while."""

    a2_change: Number  # rad/s²
    time: Number  # s
    duration: Number = 1.0  # s

    def __post_init__(self) -> None:
        check_finite("a2_change", self.a2_change)
        check_finite("time", self.time)
        check_number("duration", self.duration, 1e-6, math.inf)


@dataclass(frozen=True)
class RotorFault:
    """A rotor that from a time on gives only a part of its thrust."""

    rotor: str
    loss: Number  # share
    time: Number = 0.0  # s

    def __post_init__(self) -> None:
        check_choice("rotor", self.rotor, ROTORS)
        check_number("loss", self.loss, 0.0, 1.0)
        check_finite("time", self.time)


Disturbance = Push | Gust | MovingMass | RotorFault


@dataclass(frozen=True)
class Plant:
    """What is flown. By default equation (3), exactly, and its true state is what is measured."""

    parameters: HelicopterParameters = field(default_factory=HelicopterParameters)
    rig: Any = None  # RigidBodyParameters, or a OneOf of such: the full rigid body, in place of equation (3)
    rotors: Rotors = field(default_factory=Rotors)
    friction: Friction = field(default_factory=Friction)
    sensors: Sensors | None = None  # without any, the state itself is measured
    disturbances: tuple[Disturbance, ...] = ()

    def __deepcopy__(self, memo: dict) -> "Plant":
        """Itself, for it never changes: Stable-Baselines3 copies every info, in which it is."""
        return self

    @cached_property
    def alternatives(self) -> list["Plant"]:
        """The plants, with ranges but without options, of which every episode draws one."""
        return alternatives(self)

    @cached_property
    def uniforms(self) -> int:
        """How many numbers in [0, 1) a draw takes: one for the alternative, and one for each range."""
        ranges = max(map(count_ranges, self.alternatives))
        return 1 + ranges if ranges or len(self.alternatives) > 1 else 0

    def at(self, uniforms: np.ndarray) -> "Plant":
        """The plant out of the ranges at these numbers (self.uniforms,) in [0, 1)."""
        if not self.uniforms:
            return self
        return at_uniforms(self.alternatives[int(uniforms[0] * len(self.alternatives))], iter(uniforms[1:].tolist()))

    def draw(self, rng: np.random.Generator) -> "Plant":
        """One plant out of the ranges."""
        return self.at(rng.random(self.uniforms))

    @property
    def is_random(self) -> bool:
        """Whether episodes draw something from it."""
        return self.uniforms > 0

    @cached_property
    def is_noisy(self) -> bool:
        """Whether chance plays a part in a flight after its start."""
        noise = 0.0 if self.sensors is None else self.sensors.noise
        return noise != 0.0 or any(isinstance(value, Gust) for value in self.disturbances)

    @cached_property
    def is_plain(self) -> bool:
        """Whether it is no more than equation (3), which takes one Runge-Kutta step per control period."""
        return self.rig is None and self.rotors.lag == 0.0 and self.friction == Friction() and not self.disturbances


def friction(rate: Any, viscous: Any, coulomb: Any) -> Any:
    """Deceleration in rad/s² by friction at a rate in rad/s."""
    return viscous * rate + coulomb * rate / (rate * rate + COULOMB_RATE * COULOMB_RATE) ** 0.5


def with_friction_and_disturbances(
    x: Any, dx: tuple, viscous: Any, coulomb: Any, torques: Any, cos: Any = np.cos
) -> tuple:
    """The time derivative dx (6, ...) of a model's state x, with friction (3, ...) and disturbances.

    The torques (4, ...) are accelerations in rad/s² of travel, elevation and pitch, and a change of a2 in (3).
    """
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dx
    on_travel, on_elevation, on_pitch, a2_change = torques
    return (
        dq1,
        ddq1 + on_travel - friction(dq1, viscous[0], coulomb[0]),
        dq2,
        ddq2 + on_elevation + a2_change * cos(x[2]) - friction(dq2, viscous[1], coulomb[1]),
        dq3,
        ddq3 + on_pitch - friction(dq3, viscous[2], coulomb[2]),
    )


def quantise(angle: Any, counts: Any, floor: Any = np.floor) -> Any:
    """The angle in rad that an encoder of so many counts per revolution tells."""
    count = TURN / counts
    return count * floor(angle / count + 0.5)


LAB_ROTORS = Rotors(lag=Uniform(0.05, 0.2), thrust_loss=Uniform(0.0, 0.15), delay=1)
# The published range of travel damping goes on to 0.48 1/s, which the paper's plan, 10 s within 50 degrees of pitch,
# cannot make up for. At its greatest travel rate, 88 degrees/s, a tilt of 50 degrees outweighs 0.35 1/s and no more;
# and where it also accelerates, following it takes more than the amplifier's 12 V from 0.25 1/s on.
LAB_FRICTION = Friction(viscous=(Uniform(0.017, 0.2), Uniform(0.04, 0.30), Uniform(0.04, 0.46)))
DRAG_RATIO = Uniform(0.015, 0.03)  # m

PLANTS = {
    "nominal": Plant(),
    "lab": Plant(rotors=LAB_ROTORS, friction=LAB_FRICTION, sensors=Sensors()),
    "rigid": Plant(
        rig=OneOf(tuple(solve_rigid_body(variant)._replace(kappa=DRAG_RATIO) for variant in VARIANTS)),
        rotors=LAB_ROTORS,
        friction=LAB_FRICTION,
        sensors=Sensors(),
    ),
}


def find_plant(plant: str | Plant) -> Plant:
    """A plant by its name, or the plant itself. Raises ValueError for an unknown name."""
    if isinstance(plant, Plant):
        return plant
    if not isinstance(plant, str) or plant not in PLANTS:
        raise ValueError(f"plant = {plant!r}: must be a Plant or one of {', '.join(map(repr, PLANTS))}")
    return PLANTS[plant]
