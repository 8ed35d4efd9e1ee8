"""Plants between commanded voltage and measurement: rotors, friction, table, disturbances, sensors; and the presets.

A Plant combines small immutable values. Any number in them, except counts and tables of points, may be a `Uniform`
range, from which every episode draws. `docs/plants.md` lists the measured and the assumed numbers of the presets.
Controllers are designed on nominal parameters only and never see a draw.
"""

import itertools
import math
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import cached_property
from numbers import Integral, Real
from typing import Any, TypeAlias

import numpy as np

from heli_gym.notebook import short_repr
from heli_gym.parameters import NO_COUPLING, Coupling, HelicopterParameters
from heli_gym.rig import Rig, find_rig, fleet_rig_names
from heli_gym.rigid_body import VARIANTS, RigidBodyParameters, solve_rigid_body
from heli_gym.thrust_map import EXPONENTS, PowerCurve, TableCurve, ThrustCurve, ThrustMap
from heli_gym.validation import is_number, shown

AXES = ("travel", "elevation", "pitch")
ROTORS = ("front", "back")
HELD_OUT_SEED = 2**31  # first seed of evaluation episodes; tuning and training use smaller seeds
TURN = 2.0 * math.pi  # rad
COULOMB_RATE = 0.02  # rad/s, over which Coulomb friction changes sign: smooth, so that RK4 keeps its order

# Largest accepted values: larger ones describe no laboratory helicopter and would overflow.
LARGEST_VISCOUS = 1000.0  # 1/s, stability limit of the integrator's shortest steps
LARGEST_COULOMB = LARGEST_VISCOUS * COULOMB_RATE  # rad/s², likewise
LARGEST_ACCELERATION = 1000.0  # rad/s²
LARGEST_GAIN = 100.0  # of the thrust, of all drifts together
MOST_DISTURBANCES = 100
MOST_ALTERNATIVES = 1000
LEAST_LIFT = 1e-3  # rad/s² per N, of |b2| where it converts accelerations to forces
LARGEST_DELAY = 0.5  # s
LARGEST = 1e4  # of coefficients, masses and lengths, in SI units
STIFFEST = 5000.0  # 1/s, largest rate of an axis; the integrator then takes steps of 0.1 ms
PLAIN_FRICTION = 5.0  # 1/s, largest rate of an axis for which one Runge-Kutta step of (3) per period is enough

# Contact with the table: each of two feet is a spring and a damper. Frequency and damping are those of the helicopter
# bouncing on both feet, as stiff as steps of 10 ms allow.
CONTACT_FREQUENCY = 30.0  # rad/s
CONTACT_DAMPING = 1.0
# Distance of a rotor, and of the foot below it, from the pitch axis, in lengths of the arm: 0.178 of 0.660 m. The
# ratios of the axes' inertias follow from it and the coefficients of (3).
FOOT_SPREAD = 0.27
TABLE_ELEVATION = math.radians(27.5)  # rad, of the published rigs
NO_TABLE = 1e3  # rad, an elevation that is never reached


@dataclass(frozen=True)
class Uniform:
    """Range of uniform draws, one for every episode."""

    low: float
    high: float

    def __post_init__(self) -> None:
        if not (is_number(self.low) and is_number(self.high) and self.low <= self.high):
            raise ValueError(f"Uniform({shown(self.low)}, {shown(self.high)}): must be finite numbers with low <= high")


Number: TypeAlias = Any  # a float, or a Uniform to draw one from


def check_number(name: str, value: Number, low: float, high: float) -> None:
    """Raise ValueError unless the number, or its whole range, is within [low, high]."""
    bounds = (value.low, value.high) if isinstance(value, Uniform) else (value, value)
    try:
        allowed = all(isinstance(end, Real) and not isinstance(end, bool) for end in bounds)
        allowed = allowed and low <= float(bounds[0]) and float(bounds[1]) <= high
    except OverflowError:
        allowed = False
    if not allowed:
        raise ValueError(f"{name} = {shown(value)}: must be a number, at least {low:g} and at most {high:g}")


def check_magnitude(name: str, value: Number, largest: float) -> None:
    """Raise ValueError unless the magnitude of the number, or of its whole range, is at most `largest`."""
    check_number(name, value, -largest, largest)


def magnitude(value: Number) -> Any:
    """Largest absolute value of a number or of its range."""
    return max(abs(value.low), abs(value.high)) if isinstance(value, Uniform) else abs(value)


def check_choice(name: str, value: Any, choices: tuple[str, ...]) -> None:
    """Raise ValueError unless the value is one of the choices."""
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} = {shown(value)}: must be one of {', '.join(map(repr, choices))}")


def check_tuple(name: str, value: Any, labels: Sequence[str]) -> None:
    """Raise ValueError unless the value is a tuple with one item for each label."""
    if not isinstance(value, tuple) or len(value) != len(labels):
        raise ValueError(f"{name} = {shown(value)}: must be one value each for {', '.join(labels)}")


def check_type(name: str, value: Any, kinds: Any, what: str) -> None:
    """Raise ValueError unless the value, or each option of a OneOf, is an instance of one of the kinds."""
    for option in value.options if isinstance(value, OneOf) else (value,):
        if not isinstance(option, kinds):
            raise ValueError(f"{name} = {shown(option)}: must be {what}")


@dataclass(frozen=True)
class OneOf:
    """Alternatives; every episode draws one of them. Those with the same name in `together` draw the same position."""

    options: tuple[Any, ...]
    together: str = ""

    def __post_init__(self) -> None:
        if not isinstance(self.options, tuple) or not self.options:
            raise ValueError(f"options = {shown(self.options)}: must be a tuple of at least one alternative")
        if not isinstance(self.together, str):
            raise ValueError(f"together = {shown(self.together)}: must be a name")


def common_choices(value: Any) -> dict[str, int]:
    """Number of options of each name in `together` of the options nested in a value.

    Raises ValueError if two of a name differ in their number.
    """
    counts: dict[str, int] = {}
    own = [(value.together, len(value.options))] if isinstance(value, OneOf) and value.together else []
    parts = value.options if isinstance(value, OneOf) else parts_of(value)
    for name, count in itertools.chain(own, *(common_choices(part).items() for part in parts)):
        if counts.setdefault(name, count) != count:
            raise ValueError(f"options: {counts[name]} and {count} together as {name!r}; must be equally many")
    return counts


def choices(value: Any) -> list[dict[str, int]]:
    """Positions of the options that are drawn together, by name, for each combination of them."""
    counts = common_choices(value)
    return [dict(zip(counts, places)) for places in itertools.product(*map(range, counts.values()))]


def at_choice(value: Any, places: dict[str, int]) -> Any:
    """The value with the options that are drawn together replaced by those at these positions."""
    if isinstance(value, OneOf):
        if value.together:
            return at_choice(value.options[places[value.together]], places)
        return replace(value, options=tuple(at_choice(option, places) for option in value.options))
    return with_parts(value, [at_choice(part, places) for part in parts_of(value)]) if common_choices(value) else value


def alternatives(value: Any) -> list:
    """List of the value for each combination of the options nested in it."""
    if common_choices(value):
        return [one for places in choices(value) for one in alternatives(at_choice(value, places))]
    if isinstance(value, OneOf):
        return [alternative for option in value.options for alternative in alternatives(option)]
    return [with_parts(value, parts) for parts in itertools.product(*map(alternatives, parts_of(value)))]


def count_alternatives(value: Any) -> int:
    """Number of combinations of the options nested in a value."""

    def count(value: Any, places: dict[str, int]) -> int:
        if isinstance(value, OneOf):
            left = (value.options[places[value.together]],) if value.together else value.options
            return sum(count(option, places) for option in left)
        return math.prod(count(part, places) for part in parts_of(value))

    return sum(count(value, places) for places in choices(value))


def count_ranges(value: Any) -> int:
    """Number of ranges nested in a value."""
    return 1 if isinstance(value, Uniform) else sum(map(count_ranges, parts_of(value)))


def at_uniforms(value: Any, uniforms: Iterator[float]) -> Any:
    """The value with every nested range replaced by its point at the next of the uniforms in [0, 1)."""
    if isinstance(value, Uniform):
        return value.low + (value.high - value.low) * next(uniforms)
    return with_parts(value, [at_uniforms(part, uniforms) for part in parts_of(value)])


def parts_of(value: Any) -> list:
    """Fields of a dataclass or items of a tuple; an empty list for any other value."""
    if is_dataclass(value) and not isinstance(value, Uniform | TableCurve):
        return [getattr(value, f.name) for f in fields(value)]
    return list(value) if isinstance(value, tuple) else []


def with_parts(value: Any, parts: Sequence) -> Any:
    """The dataclass or tuple with its parts replaced."""
    if is_dataclass(value) and not isinstance(value, Uniform | TableCurve):
        return replace(value, **{f.name: part for f, part in zip(fields(value), parts)})  # type: ignore[type-var]
    if isinstance(value, tuple):
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return value


@dataclass(frozen=True, repr=False)
class Rotors:
    """Amplifiers and rotors, from the commanded voltage to the thrust."""

    __repr__ = short_repr

    lag: Number = 0.0  # s, first-order time constant from voltage to rotor speed, the root of the thrust
    thrust_loss: Number = 0.0  # lost share: battery, air density, wear
    slew: Number = math.inf  # V/s, the amplifier's fastest change
    delay: Number = 0.0  # s, from the measurement to the voltage; need not be a multiple of the control period
    gains: tuple[Number, Number] = (1.0, 1.0)  # of the thrusts of the front and of the back rotor

    def __post_init__(self) -> None:
        check_number("lag", self.lag, 0.0, math.inf)
        check_number("thrust_loss", self.thrust_loss, 0.0, 1.0)
        check_number("slew", self.slew, 0.0, math.inf)
        check_number("delay", self.delay, 0.0, LARGEST_DELAY)
        check_tuple("gains", self.gains, ROTORS)
        for gain in self.gains:
            check_number("gains", gain, 0.0, 10.0)


@dataclass(frozen=True, repr=False)
class Friction:
    """Friction in the joints of travel, elevation and pitch, as decelerations."""

    __repr__ = short_repr

    viscous: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # 1/s, multiplies the rate
    coulomb: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # rad/s², against the direction of motion

    def __post_init__(self) -> None:
        for name, largest in (("viscous", LARGEST_VISCOUS), ("coulomb", LARGEST_COULOMB)):
            check_tuple(name, getattr(self, name), AXES)
            for value in getattr(self, name):
                check_number(name, value, 0.0, largest)


@dataclass(frozen=True)
class Table:
    """Table below the helicopter, which rests on it before take-off with one foot under each rotor.

    Only for plants whose elevation is positive down (b2 < 0) and whose pitch raises the front rotor (b3 > 0).
    """

    elevation: Number = TABLE_ELEVATION  # rad, positive down, of the arm at rest
    friction: Number = 0.3  # coefficient of the feet's Coulomb friction, which holds the travel

    def __post_init__(self) -> None:
        check_magnitude("elevation", self.elevation, math.pi / 2)
        check_number("friction", self.friction, 0.0, 10.0)


@dataclass(frozen=True, repr=False)
class Sensors:
    """Encoders of the three angles, with rates estimated from them. Counts are integers, never ranges.

    The estimate is the filtered difference quotient r+ = a r + (1 - a) (q+ - q) / dt with a = exp(-dt / rate_filter),
    which is s / (1 + rate_filter s) sampled at the control period dt.
    """

    __repr__ = short_repr

    counts: tuple[int, int, int] = (8192, 4096, 4096)  # per revolution
    noise: Number = 0.0  # rad, standard deviation on each angle
    rate_filter: Number = 0.03  # s
    zeros: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # rad, the true angles at which the sensors read zero

    def __post_init__(self) -> None:
        check_tuple("counts", self.counts, AXES)
        if not all(isinstance(n, Integral) and not isinstance(n, bool) and 1 <= n <= 2**31 for n in self.counts):
            raise ValueError(f"counts = {shown(self.counts)}: must be a positive whole number for each axis")
        check_number("noise", self.noise, 0.0, 1.0)
        check_number("rate_filter", self.rate_filter, 1e-3, math.inf)
        check_tuple("zeros", self.zeros, AXES)
        for zero in self.zeros:
            check_magnitude("zeros", zero, math.pi)


@dataclass(frozen=True)
class Push:
    """Constant acceleration on one axis from `time` to `time + duration`: a step if long, a knock if short."""

    axis: str
    acceleration: Number  # rad/s²
    time: Number  # s
    duration: Number = 0.1  # s

    def __post_init__(self) -> None:
        check_choice("axis", self.axis, AXES)
        check_magnitude("acceleration", self.acceleration, LARGEST_ACCELERATION)
        check_time(self.time)
        check_number("duration", self.duration, 0.0, math.inf)


@dataclass(frozen=True)
class Gust:
    """Random acceleration on one axis: an Ornstein-Uhlenbeck process that starts at zero."""

    axis: str
    strength: Number  # rad/s², standard deviation
    correlation_time: Number = 1.0  # s

    def __post_init__(self) -> None:
        check_choice("axis", self.axis, AXES)
        check_number("strength", self.strength, 0.0, LARGEST_ACCELERATION)
        check_number("correlation_time", self.correlation_time, 1e-6, math.inf)


@dataclass(frozen=True)
class MovingMass:
    """Mass that slides along the arm and thereby changes a2 in (3) linearly over a duration."""

    a2_change: Number  # rad/s²
    time: Number  # s
    duration: Number = 1.0  # s

    def __post_init__(self) -> None:
        check_magnitude("a2_change", self.a2_change, LARGEST_ACCELERATION)
        check_time(self.time)
        check_number("duration", self.duration, 1e-6, math.inf)


@dataclass(frozen=True)
class RotorFault:
    """Sudden loss of a share of one rotor's thrust."""

    rotor: str
    loss: Number  # share
    time: Number = 0.0  # s

    def __post_init__(self) -> None:
        check_choice("rotor", self.rotor, ROTORS)
        check_number("loss", self.loss, 0.0, 1.0)
        check_time(self.time)


@dataclass(frozen=True)
class ThrustDrift:
    """Linear loss of a share of both rotors' thrust over a duration, as from a battery; a gain if negative."""

    loss: Number  # share
    time: Number = 0.0  # s
    duration: Number = 10.0  # s

    def __post_init__(self) -> None:
        check_number("loss", self.loss, -1.0, 1.0)
        check_time(self.time)
        check_number("duration", self.duration, 1e-6, math.inf)


def check_time(value: Number) -> None:
    """Raise ValueError unless a disturbance can start at this time."""
    check_magnitude("time", value, 1e6)


Disturbance = Push | Gust | MovingMass | RotorFault | ThrustDrift


@dataclass(frozen=True, repr=False)
class Plant:
    """A helicopter with its actuators and sensors; by default exactly equation (3), with its true state measured.

    Raises ValueError, which names the field, if a value has the wrong type, is not finite, or is beyond any real rig.
    """

    __repr__ = short_repr

    parameters: HelicopterParameters = field(default_factory=HelicopterParameters)
    rig: Any = None  # RigidBodyParameters or a OneOf of them: the full rigid body instead of (3)
    rotors: Rotors = field(default_factory=Rotors)
    friction: Friction = field(default_factory=Friction)
    sensors: Sensors | None = None  # None: the state itself is measured
    disturbances: tuple[Disturbance, ...] = ()
    thrust_map: ThrustMap | ThrustCurve | None = None  # instead of (2); a single curve is for both rotors
    hover_voltage: Number = None  # V, scales a map of power curves so that both rotors hold (3) level at it
    travel_lift: Number = 0.0  # 1/rad, acceleration of elevation (positive down) per square of the travel rate
    table: Table | None = None  # None: elevation has no stop
    coupling: Coupling = NO_COUPLING  # moments between the axes, on top of (3)

    @classmethod
    def from_rig(cls, rig: "str | os.PathLike | Rig", **parts: Any) -> "Plant":
        """Make the plant that a rig file describes: its coefficients, friction and coupling, thrust map with unequal
        rotors, lag and dead time, encoders with their zeros, and its table.

        The encoders read as the rig's do after the correction of their signs, without that of their zeros. A rig whose
        elevation is positive upwards, or whose pitch has the other sign, flies without its table.

        `parts` are other fields of `Plant`, or replace these: `disturbances=(ThrustDrift(0.05),)`, `table=None`. The
        amplifier's limits belong to the environment: pass it the same `rig`.

        Raises ValueError as `find_rig` and `Plant`.
        """
        found = find_rig(rig)
        own: dict[str, Any] = {
            "parameters": found.parameters,
            "thrust_map": None if found.thrust_map.is_quadratic else found.thrust_map,
            "rotors": Rotors(lag=found.lag, delay=found.delay),
            "sensors": Sensors(found.encoder_counts, zeros=tuple(0.0 - offset for offset in found.sensor_offsets)),  # type: ignore[arg-type]
            "table": Table(found.table_elevation) if has_table_signs(found.parameters) else None,
            "coupling": found.coupling,
        }
        return cls(**(own | parts))

    def __post_init__(self) -> None:
        check_type("parameters", self.parameters, HelicopterParameters, "HelicopterParameters")
        if count_alternatives(self) > MOST_ALTERNATIVES:
            raise ValueError(f"options: {count_alternatives(self)} combinations; must be at most {MOST_ALTERNATIVES}")
        for parameters in alternatives(self.parameters):
            for name, value in parameters._asdict().items():
                check_magnitude(f"parameters.{name}", value, LARGEST)
            for name in ("c1", "c2", "c3"):
                check_number(f"parameters.{name}", getattr(parameters, name), 0.0, LARGEST_VISCOUS)
        check_type("rig", self.rig, RigidBodyParameters | None, "RigidBodyParameters or None")
        for rig in alternatives(self.rig):
            for name, value in rig._asdict().items() if rig else ():
                positive = name in ("l_h", "l_p", "l_c", "m_h", "m_c", "r")
                check_number(f"rig.{name}", value, 1e-6 if positive else -LARGEST, LARGEST)
        check_type("rotors", self.rotors, Rotors, "Rotors")
        check_type("friction", self.friction, Friction, "Friction")
        check_type("sensors", self.sensors, Sensors | None, "Sensors or None")
        if not isinstance(self.disturbances, tuple):
            raise ValueError(f"disturbances = {shown(self.disturbances)}: must be a tuple of disturbances")
        for value in self.disturbances:
            check_type("disturbances", value, Disturbance, "Push, Gust, MovingMass, RotorFault or ThrustDrift")
        self._check_disturbances()
        check_magnitude("travel_lift", self.travel_lift, 10.0)
        check_type("table", self.table, Table | None, "Table or None")
        check_type("coupling", self.coupling, Coupling, "Coupling")
        for coupling in alternatives(self.coupling):
            for name, value in coupling._asdict().items():
                check_magnitude(f"coupling.{name}", value, math.pi / 4 if name == "centre" else 10.0)
        if self.rig is not None and self.coupling != NO_COUPLING:
            raise ValueError(
                f"coupling = {self.coupling}: must be left out with a rigid body, which has its own moments"
            )
        for p in alternatives(self.parameters) if self.table is not None else ():
            if not has_table_signs(p):
                raise ValueError(
                    f"parameters.b2 = {p.b2!r}, parameters.b3 = {p.b3!r}: must be b2 <= -{LEAST_LIFT:g} (elevation "
                    "positive down) and b3 > 0 with a table"
                )
        self._check_thrust_map()
        if self.stiffness > STIFFEST:
            raise ValueError(
                f"parameters, friction, table: must give no axis a rate of more than {STIFFEST:g} 1/s, "
                f"but give {self.stiffness:.3g} 1/s"
            )

    def _check_disturbances(self) -> None:
        if len(self.disturbances) > MOST_DISTURBANCES:
            raise ValueError(f"disturbances: {len(self.disturbances)} of them; must be at most {MOST_DISTURBANCES}")
        gain = 1.0
        for value in self.disturbances:
            gain *= max(1.0 - lowest(d.loss) if isinstance(d, ThrustDrift) else 1.0 for d in alternatives(value))
        if gain > LARGEST_GAIN:
            raise ValueError(f"disturbances: drifts multiply the thrust by {gain:g}; must be at most {LARGEST_GAIN:g}")

    def _check_thrust_map(self) -> None:
        kinds = ThrustMap | PowerCurve | TableCurve | None
        check_type("thrust_map", self.thrust_map, kinds, "a ThrustMap, a PowerCurve, a TableCurve or None")
        for thrust_map in alternatives(self.thrust_map):
            curves = rotor_curves(thrust_map)
            for rotor, curve in zip(ROTORS, curves) if thrust_map is not None else ():
                name = f"thrust_map.{rotor}"
                check_type(name, curve, PowerCurve | TableCurve, "a PowerCurve or a TableCurve")
                if isinstance(curve, TableCurve):
                    curve.check(name)
                    continue
                check_magnitude(f"{name}.k_plus", curve.k_plus, LARGEST)
                check_magnitude(f"{name}.k_minus", curve.k_minus, LARGEST)
                check_number(f"{name}.exponent", curve.exponent, *EXPONENTS)
                check_number(f"{name}.dead_zone", curve.dead_zone, 0.0, 1000.0)
            if self.hover_voltage is not None and any(isinstance(curve, TableCurve) for curve in curves):
                raise ValueError(f"hover_voltage = {self.hover_voltage}: must be None where the thrust map is a table")
        if self.hover_voltage is not None:
            check_number("hover_voltage", self.hover_voltage, 0.1, 1000.0)
            for p in alternatives(self.parameters):
                high = p.b2.high if isinstance(p.b2, Uniform) else p.b2
                low = p.a2.low if isinstance(p.a2, Uniform) else p.a2
                if not (high <= -LEAST_LIFT and low > 0.0):
                    raise ValueError(
                        f"hover_voltage = {self.hover_voltage}: must be None unless a2 > 0 and b2 <= -{LEAST_LIFT:g}"
                    )
                self._check_hover(p)

    def _check_hover(self, p: HelicopterParameters) -> None:
        """Raise ValueError if the hover voltage gives a rotor no thrust in some draw, or next to none."""
        for thrust_map in alternatives(self.thrust_map):
            for curve in rotor_curves(thrust_map) if thrust_map is not None else (PowerCurve(p.k_plus),):
                beyond = max(lowest(self.hover_voltage) - highest(curve.dead_zone), 0.0)
                least = lowest(curve.k_plus) * min(beyond ** lowest(curve.exponent), beyond ** highest(curve.exponent))
                if not least * LARGEST >= highest(p.a2) / least_magnitude(p.b2):
                    raise ValueError(
                        f"hover_voltage = {self.hover_voltage}: must give both rotors thrust in every draw"
                    )

    def __deepcopy__(self, memo: dict) -> "Plant":
        """The plant itself, since it is immutable; Stable-Baselines3 deep-copies every info that may hold it."""
        return self

    @cached_property
    def alternatives(self) -> list["Plant"]:
        """Plants without options, but with ranges; every episode draws one of them."""
        return alternatives(self)

    @cached_property
    def uniforms(self) -> int:
        """Number of uniform numbers in [0, 1) per draw: one for the alternative and one for each range."""
        ranges = max(map(count_ranges, self.alternatives))
        return 1 + ranges if ranges or len(self.alternatives) > 1 else 0

    def at(self, uniforms: np.ndarray) -> "Plant":
        """The plant drawn at these numbers (self.uniforms,) in [0, 1)."""
        if not self.uniforms:
            return self
        return at_uniforms(self.alternatives[int(uniforms[0] * len(self.alternatives))], iter(uniforms[1:].tolist()))

    def draw(self, rng: np.random.Generator) -> "Plant":
        """Draw a plant from the ranges."""
        return self.at(rng.random(self.uniforms))

    @property
    def is_random(self) -> bool:
        """Whether the plant has ranges or alternatives to draw from."""
        return self.uniforms > 0

    @cached_property
    def is_noisy(self) -> bool:
        """Whether a flight is random after its start, in any draw."""
        return any(
            (p.sensors is not None and p.sensors.noise != 0.0)
            or any(isinstance(value, Gust) for value in p.disturbances)
            for p in self.alternatives
        )

    @cached_property
    def stiffness(self) -> float:
        """Largest rate in 1/s of an axis in any draw: of its friction, its pendulum or its contact with the table."""
        parts = map(alternatives, (self.parameters, self.friction, self.table))
        return max(rate for combination in itertools.product(*parts) for rate in axis_rates(*combination))

    @cached_property
    def is_plain(self) -> bool:
        """Whether every draw is only equation (3), integrated in one Runge-Kutta step per control period."""
        same = (
            replace(p, parameters=HelicopterParameters(), sensors=None, rotors=Rotors(lag=p.rotors.lag))
            for p in self.alternatives
        )
        return all(p == Plant() for p in same) and self.stiffness <= PLAIN_FRICTION

    @cached_property
    def is_general(self) -> bool:
        """Whether the plant has effects beyond rotors, friction and disturbances, which only the general loops have."""
        own = {name: getattr(self, name) for name in ("parameters", "rig", "rotors", "friction", "sensors")}
        return self != Plant(**own, disturbances=self.disturbances)


def lowest(value: Number) -> Any:
    """A number, or the lower end of its range."""
    return value.low if isinstance(value, Uniform) else value


def highest(value: Number) -> Any:
    """A number, or the upper end of its range."""
    return value.high if isinstance(value, Uniform) else value


def least_magnitude(value: Number) -> Any:
    """Smallest absolute value of a number or of its range."""
    return max(lowest(value), -highest(value), 0.0)


def has_table_signs(p: HelicopterParameters) -> bool:
    """Whether elevation is positive down and pitch with the front rotor up, in any draw, as `with_contact` assumes."""
    return highest(p.b2) <= -LEAST_LIFT and lowest(p.b3) > 0.0


def axis_rates(own: HelicopterParameters, friction: Friction, table: Table | None) -> list[float]:
    """Rates in 1/s: damping of each axis, and frequencies of pendulum and contact."""
    rates = [
        magnitude(viscous) + magnitude(coulomb) / COULOMB_RATE + magnitude(linear)
        for viscous, coulomb, linear in zip(friction.viscous, friction.coulomb, own[-3:])
    ]
    rates += [math.sqrt(magnitude(own.a1) + magnitude(own.a2)), math.sqrt(magnitude(own.a3))]
    if table is not None:
        lift = least_magnitude(own.b2)
        weight = (magnitude(own.a1) + magnitude(own.a2)) / lift  # N
        rates.append(CONTACT_FREQUENCY * math.sqrt(FOOT_SPREAD * magnitude(own.b3) / lift))
        rates.append(magnitude(own.b1) * highest(table.friction) * weight / COULOMB_RATE)
    return rates


def rotor_curves(thrust_map: ThrustMap | ThrustCurve | None) -> tuple:
    """Thrust curves of the front and the back rotor; None stands for (2)."""
    return (thrust_map.front, thrust_map.back) if isinstance(thrust_map, ThrustMap) else (thrust_map, thrust_map)


def friction(rate: Any, viscous: Any, coulomb: Any) -> Any:
    """Friction as a deceleration in rad/s² at a rate in rad/s."""
    return viscous * rate + coulomb * rate / (rate * rate + COULOMB_RATE * COULOMB_RATE) ** 0.5


def with_friction_and_disturbances(
    x: Any, dx: tuple, viscous: Any, coulomb: Any, torques: Any, cos: Any = np.cos
) -> tuple:
    """Add friction (3, ...) and disturbances to the time derivative dx (6, ...) of a model's state x.

    The torques (4, ...) are accelerations of travel, elevation and pitch and a change of a2 in (3), all in rad/s².
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


def with_lift(dx: tuple, travel_lift: Any) -> tuple:
    """Add the elevation acceleration due to the travel rate to the derivative dx (6, ...); travel_lift in 1/rad."""
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dx
    return dq1, ddq1, dq2, ddq2 + travel_lift * dq1 * dq1, dq3, ddq3


def with_coupling(
    x: Any, dx: tuple, speed: Any, parameters: Any, coupling: Any, sin: Any = np.sin, cos: Any = np.cos
) -> tuple:
    """Add the moments of `Coupling` to the time derivative dx (6, ...) of the state x.

    These are the centrifugal and Coriolis moments of arm and body, as `heli_gym.rigid_body` has them; the gyroscopic
    moment of rotors with one sense of rotation, with its reaction on the arm; and the moment of the airflow on pitch.
    `speed` is the magnitude of the travel rate. Both reactions have the inertia of elevation, FOOT_SPREAD b2 / b3 in
    units of that of pitch: the gyroscopic moments do no work where b1 = b2, and elsewhere, per inertia of pitch,
    gyro (1 - b2 / b1) sin(q3) dq1 dq3.
    """
    _, w1, q2, w2, q3, w3 = x
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dx
    p, (centrifugal, centre, spin, gyro, airflow) = parameters, coupling
    up, along, sine, cosine = sin(q2 - centre), cos(q2 - centre), sin(q3), cos(q3)
    reaction = gyro * FOOT_SPREAD * p.b2 / p.b3 * w3
    return (
        dq1,
        ddq1 + 2.0 * centrifugal * up / along * w1 * w2 + reaction * sine,
        dq2,
        ddq2 - centrifugal * up * along * w1 * w1 + reaction * cosine,
        dq3,
        ddq3 + airflow * speed * w1 - spin * sine * cosine * (w1 * w1 - w2 * w2) + gyro * (w2 * cosine + w1 * sine),
    )


def with_contact(x: Any, dx: tuple, parameters: Any, table: Any, sin: Any = np.sin, cos: Any = np.cos) -> tuple:
    """Add the forces of a table (rad, friction) on two feet to the time derivative dx (6, ...) of the state x.

    Each foot is a spring and a damper that acts at the rotor above it and never pulls. Coulomb friction of both feet
    holds the travel. Elevation is positive down (b2 < 0) and pitch with the front rotor up (b3 > 0).
    """
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dx
    p, (elevation, coefficient) = parameters, table
    turn, spread = FOOT_SPREAD * cos(x[4]) * dq3, FOOT_SPREAD * sin(x[4])
    front = foot_force(x[2] - spread - elevation, dq2 - turn, p.b2)
    back = foot_force(x[2] + spread - elevation, dq2 + turn, p.b2)
    normal = front + back
    slip = dq1 / (dq1 * dq1 + COULOMB_RATE * COULOMB_RATE) ** 0.5
    return (
        dq1,
        ddq1 - abs(p.b1) * coefficient * normal * slip,
        dq2,
        ddq2 - abs(p.b2) * normal,
        dq3,
        ddq3 + p.b3 * (front - back),
    )


def foot_force(depth: Any, rate: Any, b2: Any) -> Any:
    """Force in N of the table on a foot that is `depth` rad of elevation below its top and sinks at a rate in rad/s."""
    deep = 0.5 * (depth + abs(depth))
    damping = 2.0 * CONTACT_DAMPING * CONTACT_FREQUENCY * deep / (deep + 1e-3)  # grows from zero within 1 mrad
    force = 0.5 * (CONTACT_FREQUENCY * CONTACT_FREQUENCY * deep + damping * rate) / abs(b2)
    return 0.5 * (force + abs(force))


def quantise(angle: Any, counts: Any, floor: Any = np.floor) -> Any:
    """The angle in rad as an encoder with this many counts per revolution reads it."""
    count = TURN / counts
    return count * floor(angle / count + 0.5)


LAB_ROTORS = Rotors(lag=Uniform(0.05, 0.2), thrust_loss=Uniform(0.0, 0.15), delay=0.02)
# The published range of travel damping extends to 0.48 1/s, too much for the paper's plan of 10 s within 50 degrees of
# pitch. At the plan's largest travel rate, 88 degrees/s, hover tilted by 50 degrees balances 0.34 1/s at the plan's
# elevation (0.30 1/s level). From 0.25 1/s on, tracking the plan's accelerations exceeds the amplifier's 12 V.
LAB_FRICTION = Friction(viscous=(Uniform(0.017, 0.2), Uniform(0.04, 0.30), Uniform(0.04, 0.46)))
DRAG_RATIO = Uniform(0.015, 0.03)  # m


# The plant `fleet` draws one of the rigs that were identified from measured flights, and moves each of its numbers by
# up to MARGIN of that number's range over these rigs, within the bounds below.
MARGIN = 0.2
FLEET_BOUNDS = {"c1": (0.0, 1.0), "c2": (0.0, 1.0), "c3": (0.0, 1.0), "delay": (0.0, 0.1), "exponent": EXPONENTS}
# These are drawn independently of the rig: they change from flight to flight, or were not measured.
FLEET_DRIFT = Uniform(-0.02, 0.06)  # share of the thrust that a flight of DRIFT_DURATION loses
DRIFT_DURATION = 20.0  # s
FLEET_COULOMB = Uniform(0.0, 0.02)  # rad/s², of each axis
FLEET_ELEVATION_ZERO = math.radians(2.0)  # largest magnitude
FLEET_AMPLIFIER = 12.0  # V, most of a rig whose hover voltage counts; CTU's amplifiers have 24 V


def fleet_numbers(rig: Rig) -> dict[str, float]:
    """Numbers of a rig, by name, that `fleet` draws together.

    The unit of thrust, which no flight determines, is the one in which b2 is Table I's.
    """
    p, (front, back) = rig.parameters, (rig.thrust_map.front, rig.thrust_map.back)
    unit, mean = HelicopterParameters().b2 / p.b2, 0.5 * (front.k_plus + back.k_plus)  # type: ignore[union-attr]
    return {
        **{name: float(getattr(p, name)) for name in ("a1", "a2", "a3", "c1", "c2", "c3")},
        "b1": unit * p.b1,
        "b3": unit * p.b3,
        "exponent": front.exponent,  # type: ignore[union-attr]
        "reverse": 0.5 * (front.k_minus + back.k_minus) / mean,  # type: ignore[union-attr]
        "front": front.k_plus / mean,  # type: ignore[union-attr]
        "back": back.k_plus / mean,  # type: ignore[union-attr]
        "lag": rig.lag,
        "delay": rig.delay,
        **rig.coupling._asdict(),
    }


def ranges_around(values: Sequence[float], low: float = -math.inf, high: float = math.inf) -> list[Uniform]:
    """Range around each of the values, by MARGIN of the range of all to either side, within bounds."""
    reach = MARGIN * (max(values) - min(values))
    return [Uniform(min(max(v - reach, low), high), min(max(v + reach, low), high)) for v in values]


def widened_range(values: Sequence[float]) -> Uniform:
    """Range of the values, wider by MARGIN of it at either end."""
    around = ranges_around(values)
    return Uniform(min(r.low for r in around), max(r.high for r in around))


def fleet(rigs: Sequence[Rig]) -> Plant:
    """Plant that draws one of these rigs and a rig near it, which hovers level at a drawn voltage; see MARGIN."""
    numbers = [fleet_numbers(rig) for rig in rigs]
    ranges = {name: ranges_around([own[name] for own in numbers], *FLEET_BOUNDS.get(name, ())) for name in numbers[0]}
    drawn = [{name: around[k] for name, around in ranges.items()} for k in range(len(rigs))]

    def one_of(make: Callable[[dict[str, Uniform]], Any]) -> Any:
        return OneOf(tuple(map(make, drawn)), together="rig")

    hover = [float(rig.hover_voltage().mean()) for rig in rigs if rig.voltage_limits[1] <= FLEET_AMPLIFIER]
    zero = max(abs(rig.sensor_zeros[2]) for rig in rigs)
    coefficients = ("a1", "a2", "a3", "b1", "b3", "c1", "c2", "c3")
    return Plant(
        one_of(lambda r: HelicopterParameters()._replace(**{name: r[name] for name in coefficients})),
        rotors=one_of(lambda r: Rotors(lag=r["lag"], delay=r["delay"], gains=(r["front"], r["back"]))),
        friction=Friction(coulomb=(FLEET_COULOMB,) * 3),
        sensors=Sensors(zeros=(0.0, Uniform(-FLEET_ELEVATION_ZERO, FLEET_ELEVATION_ZERO), Uniform(-zero, zero))),
        disturbances=(ThrustDrift(FLEET_DRIFT, duration=DRIFT_DURATION),),
        thrust_map=one_of(lambda r: PowerCurve(1.0, r["reverse"], r["exponent"])),
        hover_voltage=widened_range(hover),
        table=Table(Uniform(*(pick(rig.table_elevation for rig in rigs) for pick in (min, max)))),
        coupling=one_of(lambda r: Coupling(**{name: r[name] for name in Coupling._fields})),
    )


PLANTS = {
    "nominal": Plant(),
    "lab": Plant(rotors=LAB_ROTORS, friction=LAB_FRICTION, sensors=Sensors()),
    "rigid": Plant(
        rig=OneOf(tuple(solve_rigid_body(variant)._replace(kappa=DRAG_RATIO) for variant in VARIANTS)),
        rotors=LAB_ROTORS,
        friction=LAB_FRICTION,
        sensors=Sensors(),
    ),
    "fleet": fleet([find_rig(name) for name in fleet_rig_names()]),
}
# Rigs for which controllers of these plants are designed; see `rig.find_rig`.
NOMINAL_RIGS = {"nominal": "paper", "lab": "paper", "rigid": "paper", "fleet": "fleet"}


def find_plant(plant: str | Plant) -> Plant:
    """Return a plant by its name, or the plant itself. Raises ValueError for an unknown name."""
    if isinstance(plant, Plant):
        return plant
    if not isinstance(plant, str) or plant not in PLANTS:
        raise ValueError(f"plant = {shown(plant)}: must be a Plant or one of {', '.join(map(repr, PLANTS))}")
    return PLANTS[plant]
