"""What stands between the voltage and the measurement: rotors, friction, disturbances, sensors; and the presets.

A Plant is made of small values that combine. Any number in them may be a `Uniform` range, from which every episode
draws. The ranges of the presets are those of published models and data of such rigs; none was measured on one.
Controllers are designed on the nominal parameters only, and are never shown a draw.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import cached_property, partial
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from heli_gym.model import dynamics, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.rigid_body import VARIANTS, rigid_dynamics, solve_rigid_body

AXES = ("travel", "elevation", "pitch")
ROTORS = ("front", "back")
SUBSTEP = 5e-3  # s, at most, of the integration where there is more than (3): a tenth of the shortest rotor lag
HELD_OUT_SEED = 2**31  # episodes of evaluations count their seeds from here on; tuning and training use smaller ones
COULOMB_RATE = 0.02  # rad/s, over which Coulomb friction changes sign: smooth, so that RK4 keeps its order


@dataclass(frozen=True)
class Uniform:
    """A range from which every episode draws."""

    low: float
    high: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.low) and math.isfinite(self.high) and self.low <= self.high):
            raise ValueError(f"{self}: finite numbers with low <= high are needed")


Number: TypeAlias = Any  # a float, or a Uniform to draw one from


def check_number(name: str, value: Number, low: float, high: float) -> None:
    """Raises ValueError unless the number, or all of its range, is within [low, high]."""
    bounds = (value.low, value.high) if isinstance(value, Uniform) else (value, value)
    if not (low <= bounds[0] and bounds[1] <= high):
        raise ValueError(f"{name} = {value}: at least {low:g} and at most {high:g} is needed")


def check_choice(name: str, value: str, choices: tuple[str, ...]) -> None:
    """Raises ValueError unless the value is one of the choices."""
    if value not in choices:
        raise ValueError(f"{name} = {value!r}: one of {', '.join(map(repr, choices))} is needed")


@dataclass(frozen=True)
class OneOf:
    """Alternatives, of which every episode draws one."""

    options: tuple[Any, ...]


def drawn(value: Any, rng: np.random.Generator) -> Any:
    """The value with every range in it, however deep, replaced by a draw."""
    if isinstance(value, Uniform):
        return float(rng.uniform(value.low, value.high))
    if isinstance(value, OneOf):
        return drawn(value.options[rng.integers(len(value.options))], rng)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{f.name: drawn(getattr(value, f.name), rng) for f in fields(value)})
    if isinstance(value, tuple):
        parts = [drawn(part, rng) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return value


@dataclass(frozen=True)
class Rotors:
    """Amplifiers and rotors: how thrust follows from the voltage that a controller asks for."""

    lag: Number = 0.0  # s, first order, of the rotor speed (and so of the root of the thrust) behind the voltage
    thrust_loss: Number = 0.0  # share that is missing: battery, air density, wear
    slew: Number = math.inf  # V/s, the amplifier's fastest change
    delay: int = 0  # control periods from the measurement to the voltage

    def __post_init__(self) -> None:
        check_number("lag", self.lag, 0.0, math.inf)
        check_number("thrust_loss", self.thrust_loss, 0.0, 1.0)
        check_number("slew", self.slew, 0.0, math.inf)
        check_number("delay", self.delay, 0, 1000)


@dataclass(frozen=True)
class Friction:
    """In the joints of travel, elevation and pitch, as decelerations."""

    viscous: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # 1/s, times the rate
    coulomb: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)  # rad/s², against the direction of motion

    def __post_init__(self) -> None:
        for name in ("viscous", "coulomb"):
            if len(getattr(self, name)) != len(AXES):
                raise ValueError(f"{name} = {getattr(self, name)}: one value each for {', '.join(AXES)} is needed")
            for value in getattr(self, name):
                check_number(name, value, 0.0, math.inf)


@dataclass(frozen=True)
class Sensors:
    """Encoders of the three angles; rates are estimated from them.

    The estimate is the filtered difference quotient r+ = a r + (1 - a) (q+ - q) / dt with a = exp(-dt / rate_filter),
    which is s / (1 + rate_filter s) sampled at the control period dt.
    """

    counts: tuple[int, int, int] = (8192, 4096, 4096)  # per revolution
    noise: Number = 0.0  # rad, standard deviation on each angle
    rate_filter: float = 0.03  # s

    def __post_init__(self) -> None:
        if len(self.counts) != len(AXES) or min(self.counts) < 1:
            raise ValueError(f"counts = {self.counts}: a positive number each for {', '.join(AXES)} is needed")
        check_number("noise", self.noise, 0.0, math.inf)
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
        check_number("correlation_time", self.correlation_time, 1e-6, math.inf)


@dataclass(frozen=True)
class MovingMass:
    """A mass that slides along the arm, and so changes the weight's a2 in (3), linearly over a while."""

    a2_change: Number  # rad/s²
    time: Number  # s
    duration: Number = 1.0  # s

    def __post_init__(self) -> None:
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

    def draw(self, rng: np.random.Generator) -> "Plant":
        """One plant out of the ranges."""
        return drawn(self, rng)

    @cached_property
    def is_random(self) -> bool:
        """Whether episodes draw something from it."""
        return self.draw(np.random.default_rng(0)) != self

    @cached_property
    def is_plain(self) -> bool:
        """Whether it is no more than equation (3), which takes one Runge-Kutta step per control period."""
        return self.rig is None and self.rotors.lag == 0.0 and self.friction == Friction() and not self.disturbances


class PlantState(NamedTuple):
    """All that a drawn plant remembers of a flight."""

    x: tuple[float, ...]  # (44), rad and rad/s
    rotors: tuple[float, ...]  # (2,) V, to which the rotor speeds correspond
    voltage: tuple[float, float]  # V, at the motors
    pending: tuple[tuple[float, float], ...]  # V, asked for and delayed
    gusts: tuple[float, ...]  # rad/s²
    angles: tuple[float, ...]  # (3,) rad, as measured last
    rates: tuple[float, ...]  # (3,) rad/s, as estimated from these

    @property
    def measurement(self) -> tuple[float, ...]:
        """What a controller may use, in the order of (44)."""
        return tuple(value for pair in zip(self.angles, self.rates) for value in pair)


def at_rest(plant: Plant, x: tuple[float, ...], u: tuple[float, float]) -> PlantState:
    """A drawn plant in the state x (6,), its rotors turning at the voltages u (2,) in V."""
    return PlantState(
        x=x,
        rotors=u,
        voltage=u,
        pending=(u,) * plant.rotors.delay,
        gusts=(0.0,) * len(plant.disturbances),
        angles=(x[0], x[2], x[4]),
        rates=(x[1], x[3], x[5]),
    )


def advance(
    plant: Plant, state: PlantState, u: tuple[float, float], time: float, dt: float, rng: np.random.Generator
) -> PlantState:
    """A drawn plant dt seconds later, the voltages u (2,) in V having been asked for at the time given in s."""
    u, *pending = *state.pending, u
    most = plant.rotors.slew * dt
    u_f, u_b = (min(max(asked, last - most), last + most) for asked, last in zip(u, state.voltage))
    gusts = tuple(wander(gust, value, dt, rng) for gust, value in zip(plant.disturbances, state.gusts))

    z = (*state.x, *state.rotors) if plant.rotors.lag else (*state.x, u_f, u_b)
    if plant.is_plain:
        p, kept = plant.parameters, 1.0 - plant.rotors.thrust_loss
        v = virtual_input((kept * thrust(u_f, p), kept * thrust(u_b, p)))
        z = (*rk4_step(lambda x: dynamics(x, v, p, math.sin, math.cos), state.x, dt), u_f, u_b)
    else:
        steps = math.ceil(dt / SUBSTEP - 1e-9)
        h = dt / steps
        for k in range(steps):
            z = rk4_step(partial(derivative, plant, (u_f, u_b), disturb(plant, gusts, time + (k + 0.5) * h)), z, h)
    new = state._replace(x=z[:6], rotors=z[6:], voltage=(u_f, u_b), pending=tuple(pending), gusts=gusts)
    return measure(plant, new, dt, rng)


def derivative(plant: Plant, u: tuple[float, float], disturbance: tuple, z: Sequence) -> tuple:
    """Time derivative of z = (x, rotors) (8,): the model, friction, disturbances, and the rotors' lag behind u (2,)."""
    *x, w_f, w_b = z
    (travel, elevation, pitch, a2_change), (front, back) = disturbance
    p, rotors, friction = plant.parameters, plant.rotors, plant.friction
    kept = 1.0 - rotors.thrust_loss
    v = virtual_input((kept * front * thrust(w_f, p), kept * back * thrust(w_b, p)))
    if plant.rig is None:
        dx = dynamics(x, v, p, math.sin, math.cos)
    else:
        dx = rigid_dynamics(x, v, plant.rig, math.sin, math.cos)
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dx
    elevation += a2_change * math.cos(x[2])
    slow1, slow2, slow3 = (
        viscous * rate + coulomb * math.tanh(rate / COULOMB_RATE)
        for viscous, coulomb, rate in zip(friction.viscous, friction.coulomb, (dq1, dq2, dq3))
    )
    dw_f, dw_b = ((u[0] - w_f) / rotors.lag, (u[1] - w_b) / rotors.lag) if rotors.lag else (0.0, 0.0)
    return dq1, ddq1 + travel - slow1, dq2, ddq2 + elevation - slow2, dq3, ddq3 + pitch - slow3, dw_f, dw_b


def disturb(plant: Plant, gusts: tuple[float, ...], time: float) -> tuple[list[float], list[float]]:
    """At a time in s: accelerations (4,) in rad/s² of travel, elevation and pitch and in a2; effectiveness (2,)."""
    accelerations, effectiveness = [0.0, 0.0, 0.0, 0.0], [1.0, 1.0]
    for disturbance, gust in zip(plant.disturbances, gusts):
        match disturbance:
            case Push(axis, acceleration, start, duration):
                if start <= time < start + duration:
                    accelerations[AXES.index(axis)] += acceleration
            case Gust(axis):
                accelerations[AXES.index(axis)] += gust
            case MovingMass(a2_change, start, duration):
                accelerations[3] += a2_change * min(max((time - start) / duration, 0.0), 1.0)
            case RotorFault(rotor, loss, start):
                if time >= start:
                    effectiveness[ROTORS.index(rotor)] *= 1.0 - loss
    return accelerations, effectiveness


def wander(disturbance: Disturbance, gust: float, dt: float, rng: np.random.Generator) -> float:
    """The next value of an Ornstein-Uhlenbeck process, sampled exactly; nothing for what is not a gust."""
    if not isinstance(disturbance, Gust):
        return 0.0
    kept = math.exp(-dt / disturbance.correlation_time)
    return kept * gust + math.sqrt(1.0 - kept**2) * disturbance.strength * rng.standard_normal()


def measure(plant: Plant, state: PlantState, dt: float, rng: np.random.Generator) -> PlantState:
    """The state with new measurements, dt seconds after the last ones."""
    true_angles, true_rates = state.x[0::2], state.x[1::2]
    if plant.sensors is None:
        return state._replace(angles=true_angles, rates=true_rates)
    kept = math.exp(-dt / plant.sensors.rate_filter)
    angles, rates = [], []
    for angle, counts, last, rate in zip(true_angles, plant.sensors.counts, state.angles, state.rates):
        count = 2.0 * math.pi / counts
        noisy = angle + plant.sensors.noise * rng.standard_normal() if plant.sensors.noise else angle
        angles.append(count * round(noisy / count))
        rates.append(kept * rate + (1.0 - kept) * (angles[-1] - last) / dt)
    return state._replace(angles=tuple(angles), rates=tuple(rates))


LAB_ROTORS = Rotors(lag=Uniform(0.05, 0.2), thrust_loss=Uniform(0.0, 0.15), delay=1)
# The published range of travel damping goes on to 0.48 1/s; from about 0.27 on, the paper's maneuver needs more voltage
# than there is.
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
        raise ValueError(f"plant = {plant!r}: a Plant or one of {', '.join(map(repr, PLANTS))} is needed")
    return PLANTS[plant]
