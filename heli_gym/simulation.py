"""The control step, compiled: of one helicopter or of many, from the voltages asked for to observation and reward.

The equations are those of `model`, `rigid_body`, `plant` and `task`, compiled as they stand; here is only the order in
which they are used, and where the numbers are kept.

The numbers of `LANES` helicopters are a block: one row for each quantity, so that the innermost loops run over
helicopters and become SIMD instructions. All loops are free of calls and branches to that end: the sine and cosine are
own ones, a condition is a selection.
"""

import math
from collections.abc import Callable, Sequence
from functools import cache
from hashlib import sha256
from pathlib import Path
from types import FunctionType
from typing import Any, NamedTuple

import numba
import numpy as np
from numpy import cos, floor, sin

from heli_gym import plant
from heli_gym.model import dynamics, moved, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import AXES, ROTORS, Gust, MovingMass, Plant, Push, RotorFault, encoded, hindered
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.task import FEATURES, control_grid, cost, crashed, reference_features, reward, to_voltage
from heli_gym.trajectory import Trajectory

LANES = 64
SUBSTEP = 10e-3  # s, at most, of the integration where there is more than (3)

# Rows of a block. What a helicopter remembers of its flight:
X, MEASURED, ASKED, MOTOR, ROTOR = 0, 6, 12, 14, 16  # (44), (44), V, V, V
STEP, LAST, TABLE, KEY = 18, 19, 20, 21  # control steps, first of its rows in the table of references, in [0, 1)
LIMITS = 22  # u_min, u_max, pitch_min, pitch_max of its reference
# what it is, in the order of `numbers`:
NUMBERS = PARAMETERS = 26
RIG, LAG, LOSS, SLEW, DELAY, VISCOUS, COULOMB, COUNTS, NOISE, RATE_FILTER = 34, 45, 46, 47, 48, 49, 52, 55, 58, 59
# what follows from that and from the control period, and is kept for speed:
LAG_KEPT, RATE_KEPT = 60, 61
# what a control step needs and leaves:
TORQUES, EFFECT, REFERENCE, EFFORT, REWARD, COST, TERMINATED, TRUNCATED = 62, 66, 68, 76, 78, 79, 80, 81
# its disturbances, DISTURBANCE rows each, and after the last one the voltages still delayed, the oldest first:
DISTURBANCES, DISTURBANCE = 82, 8
KIND, CHANNEL, AMOUNT, TIME, DURATION, CORRELATION, KEPT, GUST = range(8)
PUSH, WANDER, SLIDE = range(3)

NORMALS_PER_STEP = 256  # of one helicopter, at most: its three sensors take the first ones, disturbances one each
START_UNIFORMS = 5  # numbers that a start is made of: three angles, the time, the key
OBSERVED = 8 + FEATURES  # numbers of an observation
REPORT = 16  # numbers that a step tells of each helicopter: x (6), measurement (6), voltages (2), cost, time


class Settings(NamedTuple):
    """What all helicopters of a simulation share. The kernels get it as an array."""

    period: float  # s, of the control
    substeps: int
    u_low: float  # V
    u_high: float  # V
    pitch_limit: float  # rad
    disturbances: int  # of any helicopter, at most
    delay: int  # control periods, of any helicopter, at most
    is_sensed: bool
    is_noisy: bool


class Window(NamedTuple):
    """The limits that `task.cost` reads."""

    u_min: Any
    u_max: Any
    pitch_min: Any
    pitch_max: Any


class Body(NamedTuple):
    """What a time derivative depends on, besides state and thrust."""

    parameters: Any
    rig: Any
    viscous: Any
    coulomb: Any
    torques: Any


def numbers(p: Plant) -> list:
    """The numbers of a plant, some of which may be ranges, in the order of the rows from NUMBERS on.

    Then, of each disturbance, KIND to CORRELATION. Counts of zero stand for sensors that are exact.
    """
    rotors, friction, sensors = p.rotors, p.friction, p.sensors
    rows = [*p.parameters, *(p.rig or (0.0,) * len(RigidBodyParameters._fields))]
    rows += [rotors.lag, rotors.thrust_loss, rotors.slew, rotors.delay, *friction.viscous, *friction.coulomb]
    rows += [*sensors.counts, sensors.noise, sensors.rate_filter] if sensors else [0.0, 0.0, 0.0, 0.0, 1.0]
    for value in p.disturbances:
        match value:
            case Push(axis, acceleration, start, duration):
                rows += [PUSH, AXES.index(axis), acceleration, start, duration, 1.0]
            case Gust(axis, strength, correlation_time):
                rows += [WANDER, AXES.index(axis), strength, 0.0, math.inf, correlation_time]
            case MovingMass(a2_change, start, duration):
                rows += [SLIDE, len(AXES), a2_change, start, duration, 1.0]
            case RotorFault(rotor, loss, start):
                rows += [PUSH, len(AXES) + 1 + ROTORS.index(rotor), loss, start, math.inf, 1.0]
    return rows


class Ranges(NamedTuple):
    """The numbers (A, R) of the A alternatives of a plant: low + span * u, u being that of the uniforms at index."""

    low: np.ndarray
    span: np.ndarray
    index: np.ndarray

    def draw(self, uniforms: np.ndarray) -> np.ndarray:
        """Numbers (R, N) of N drawn plants from uniforms (N, plant.uniforms); what `Plant.at` draws from these."""
        if not uniforms.shape[1]:
            return np.repeat(self.low.T, len(uniforms), axis=1)
        choice = (uniforms[:, 0] * len(self.low)).astype(int)
        own = np.take_along_axis(uniforms, self.index[choice], axis=1)
        return (self.low[choice] + self.span[choice] * own).T


def ranges_of(p: Plant) -> Ranges:
    """The ranges of a plant, in the order in which `Plant.at` meets them."""
    ends = np.concatenate((np.zeros((1, p.uniforms)), np.eye(p.uniforms)[1:]))[:, 1:]
    # the numbers of each alternative where no uniform is one, then where each of them in turn is
    corners = np.array([[numbers(plant.drawn(q, iter(u))) for u in ends.tolist()] for q in p.alternatives], float)
    low = corners[:, 0]
    changed = corners[:, 1:] != low[:, None]
    index = np.where(changed.any(axis=1), changed.argmax(axis=1) + 1, 0) if p.uniforms else np.zeros(low.shape, int)
    high = np.take_along_axis(corners, index[:, None], axis=1)[:, 0]
    span = np.subtract(high, low, out=np.zeros(low.shape), where=index > 0)
    return Ranges(low, span, index)


# The right-hand sides, one of which is compiled into a simulation.


def equation_3(x: Any, v: Any, body: Body) -> tuple:
    """(3) and no more."""
    return dynamics(x, v, body.parameters, sin, cos)


def equation_3_hindered(x: Any, v: Any, body: Body) -> tuple:
    """(3) with friction and disturbances."""
    return hindered(x, dynamics(x, v, body.parameters, sin, cos), body.viscous, body.coulomb, body.torques, cos)


def rigid_body_hindered(x: Any, v: Any, body: Body) -> tuple:
    """The full rigid body with friction and disturbances."""
    return hindered(x, rigid_dynamics(x, v, body.rig, sin, cos), body.viscous, body.coulomb, body.torques, cos)


DERIVATIVES = (equation_3, equation_3_hindered, rigid_body_hindered)
derivative = equation_3  # `kernels` binds this name to the one that is needed

# The control step, in loops over the n helicopters of a block.


# Spelt out, for the compiler sees through one call but not through two where it must know what overlaps in memory.


def two(block: Any, row: int, i: int) -> tuple:
    """This row and the next of the helicopter i."""
    return block[row * LANES + i], block[(row + 1) * LANES + i]


def three(block: Any, row: int, i: int) -> tuple:
    """This row and the next two."""
    return (
        block[row * LANES + i],
        block[(row + 1) * LANES + i],
        block[(row + 2) * LANES + i],
    )


def six(block: Any, row: int, i: int) -> tuple:
    """This row and the next five."""
    return (
        block[row * LANES + i],
        block[(row + 1) * LANES + i],
        block[(row + 2) * LANES + i],
        block[(row + 3) * LANES + i],
        block[(row + 4) * LANES + i],
        block[(row + 5) * LANES + i],
    )


def eight(block: Any, row: int, i: int) -> tuple:
    """This row and the next seven."""
    return (
        block[row * LANES + i],
        block[(row + 1) * LANES + i],
        block[(row + 2) * LANES + i],
        block[(row + 3) * LANES + i],
        block[(row + 4) * LANES + i],
        block[(row + 5) * LANES + i],
        block[(row + 6) * LANES + i],
        block[(row + 7) * LANES + i],
    )


def put_two(block: Any, row: int, i: int, values: tuple) -> None:
    """Writes into this row and the next of the helicopter i."""
    block[row * LANES + i], block[(row + 1) * LANES + i] = values


def put_six(block: Any, row: int, i: int, values: tuple) -> None:
    """Writes into this row and the next five."""
    a, b, c, d, e, f = values
    block[row * LANES + i] = a
    block[(row + 1) * LANES + i] = b
    block[(row + 2) * LANES + i] = c
    block[(row + 3) * LANES + i] = d
    block[(row + 4) * LANES + i] = e
    block[(row + 5) * LANES + i] = f


def amplify(block: Any, n: int, s: Settings) -> None:
    """The voltages at the motors: those asked for, delayed, and no faster than the amplifier can."""
    delay = int(s.delay)
    pending = DISTURBANCES + DISTURBANCE * int(s.disturbances)
    for motor in range(2):
        for i in range(n):
            block[REFERENCE * LANES + i] = block[(ASKED + motor) * LANES + i]
        for k in range(delay):
            later = pending + 2 * (k + 1) if k < delay - 1 else ASKED
            for i in range(n):
                late, own_delay = block[(pending + 2 * k + motor) * LANES + i], block[DELAY * LANES + i]
                arriving = block[REFERENCE * LANES + i]
                block[REFERENCE * LANES + i] = late if own_delay == delay - k else arriving
                block[(pending + 2 * k + motor) * LANES + i] = block[(later + motor) * LANES + i]
        for i in range(n):
            last, most = block[(MOTOR + motor) * LANES + i], s.period * block[SLEW * LANES + i]
            u = min(max(block[REFERENCE * LANES + i], last - most), last + most)
            block[(MOTOR + motor) * LANES + i] = u
            w = block[(ROTOR + motor) * LANES + i]
            block[(ROTOR + motor) * LANES + i] = u if block[LAG * LANES + i] == 0.0 else w  # without lag, at once


def disturb(block: Any, n: int, s: Settings, after: Any) -> None:
    """What the disturbances amount to, so many seconds after the start of the control period."""
    for i in range(n):
        put_six(block, TORQUES, i, (0.0, 0.0, 0.0, 0.0, 1.0, 1.0))
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        for i in range(n):
            kind, channel, amount, start, duration, _, _, gust = eight(block, first, i)
            time = s.period * block[STEP * LANES + i] + after
            if kind == WANDER:
                value = gust
            elif kind == SLIDE:
                value = amount * min(max((time - start) / duration, 0.0), 1.0)
            else:
                value = amount if start <= time < start + duration else 0.0
            row = TORQUES + int(channel)
            if row < EFFECT:
                block[row * LANES + i] += value
            else:
                block[row * LANES + i] *= 1.0 - value


def blow(block: Any, n: int, s: Settings) -> None:
    """The next values of all gusts, Ornstein-Uhlenbeck processes, sampled exactly."""
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        for i in range(n):
            kind, _, strength, _, _, _, kept, gust = eight(block, first, i)
            if kind == WANDER:
                normal = standard_normal(block[KEY * LANES + i], block[STEP * LANES + i], 3 + d)
                block[(first + GUST) * LANES + i] = kept * gust + math.sqrt(1.0 - kept * kept) * strength * normal


def integrate(block: Any, n: int, h: Any) -> None:
    """h seconds of flight, the voltages at the motors being held: the rotors exactly, the body by Runge-Kutta."""
    for i in range(n):
        p = HelicopterParameters(*eight(block, PARAMETERS, i))
        rig = RigidBodyParameters(*eight(block, RIG, i), *three(block, RIG + 8, i))
        torques = (*three(block, TORQUES, i), block[(TORQUES + 3) * LANES + i])
        body = Body(p, rig, three(block, VISCOUS, i), three(block, COULOMB, i), torques)

        kept = block[LAG_KEPT * LANES + i]
        (u_f, u_b), (w_f, w_b) = two(block, MOTOR, i), two(block, ROTOR, i)
        middle_f, middle_b = u_f + kept * (w_f - u_f), u_b + kept * (w_b - u_b)
        end_f, end_b = u_f + kept * (middle_f - u_f), u_b + kept * (middle_b - u_b)
        effect_f, effect_b = two(block, EFFECT, i)
        share = 1.0 - block[LOSS * LANES + i]
        front, back = share * effect_f, share * effect_b
        inputs = (
            virtual_input((front * thrust(w_f, p), back * thrust(w_b, p))),
            virtual_input((front * thrust(middle_f, p), back * thrust(middle_b, p))),
            virtual_input((front * thrust(end_f, p), back * thrust(end_b, p))),
        )
        put_six(block, X, i, rk4_step(derivative, six(block, X, i), inputs, h, body))
        put_two(block, ROTOR, i, (end_f, end_b))


def make_noise(block: Any, n: int, s: Settings) -> None:
    """What the noise adds to the three angles, for the time being in the rows of the reference."""
    for axis in range(3):
        for i in range(n):
            block[(REFERENCE + axis) * LANES + i] = 0.0
        if s.is_noisy:
            for i in range(n):
                normal = standard_normal(block[KEY * LANES + i], block[STEP * LANES + i], axis)
                block[(REFERENCE + axis) * LANES + i] = block[NOISE * LANES + i] * normal


def measure(block: Any, n: int, s: Settings) -> None:
    """The next angles, and the rates estimated from them; see `plant.Sensors`."""
    for axis in range(3):
        for i in range(n):
            true_angle = block[(X + 2 * axis) * LANES + i]
            counts = block[(COUNTS + axis) * LANES + i]
            told = encoded(true_angle + block[(REFERENCE + axis) * LANES + i], max(counts, 1.0), floor)
            last, rate = block[(MEASURED + 2 * axis) * LANES + i], block[(MEASURED + 2 * axis + 1) * LANES + i]
            kept = block[RATE_KEPT * LANES + i]
            estimate = kept * rate + (1.0 - kept) * (told - last) / s.period
            true_rate = block[(X + 2 * axis + 1) * LANES + i]
            block[(MEASURED + 2 * axis) * LANES + i] = true_angle if counts == 0.0 else told
            block[(MEASURED + 2 * axis + 1) * LANES + i] = true_rate if counts == 0.0 else estimate


def measure_exactly(block: Any, n: int) -> None:
    """The state itself."""
    for k in range(6):
        for i in range(n):
            block[(MEASURED + k) * LANES + i] = block[(X + k) * LANES + i]


def look_up(block: Any, n: int, table: Any) -> None:
    """The reference's state and nominal voltages (8,) at the step of each helicopter."""
    for i in range(n):
        row = int(block[TABLE * LANES + i]) + int(block[STEP * LANES + i])
        for k in range(8):
            block[(REFERENCE + k) * LANES + i] = table[row, k]


def control_step(block: Any, n: int, s: Settings, table: Any) -> None:
    """One control period with the voltages asked for."""
    blow(block, n, s)
    amplify(block, n, s)
    h = s.period / s.substeps
    for k in range(int(s.substeps)):
        disturb(block, n, s, (k + 0.5) * h)
        integrate(block, n, h)

    look_up(block, n, table)
    for i in range(n):
        (u_f, u_b), (nominal_f, nominal_b) = two(block, ASKED, i), two(block, REFERENCE + 6, i)
        put_two(block, EFFORT, i, (u_f - nominal_f, u_b - nominal_b))
        block[STEP * LANES + i] += 1.0
    if s.is_sensed:
        make_noise(block, n, s)
        measure(block, n, s)
    else:
        measure_exactly(block, n)
    look_up(block, n, table)
    judge(block, n, s)


def judge(block: Any, n: int, s: Settings) -> None:
    """Reward, cost, and whether the flight is over; see `task`."""
    for i in range(n):
        error = moved(six(block, X, i), -1.0, six(block, REFERENCE, i))
        pitch, u = block[(X + 4) * LANES + i], two(block, ASKED, i)
        limits = Window(*two(block, LIMITS, i), *two(block, LIMITS + 2, i))
        put_two(block, REWARD, i, (s.period * reward(error, two(block, EFFORT, i)), s.period * cost(pitch, u, limits)))
        terminated = 1.0 if crashed(pitch, s.pitch_limit) else 0.0
        is_last = 1.0 if block[STEP * LANES + i] == block[LAST * LANES + i] else 0.0
        put_two(block, TERMINATED, i, (terminated, is_last * (1.0 - terminated)))


def observe(block: Any, i: int, table: Any, features: Any, observation: Any) -> None:
    """What the helicopter i observes, into (49,)."""
    row = int(block[TABLE * LANES + i]) + int(block[STEP * LANES + i])
    for k in range(6):
        observation[k] = block[(MEASURED + k) * LANES + i] - table[row, k]
    observation[6] = block[ASKED * LANES + i]
    observation[7] = block[(ASKED + 1) * LANES + i]
    for k in range(FEATURES):
        observation[8 + k] = features[row, k]


def begin(block: Any, i: int, s: Settings) -> None:
    """What follows from the numbers of the helicopter i, just drawn; its first measurement, and no voltage on its way.

    The first rates are the true ones: what estimates them has been running before.
    """
    lag, h = block[LAG * LANES + i], s.period / s.substeps
    block[LAG_KEPT * LANES + i] = math.exp(-0.5 * h / lag) if lag > 0.0 else 0.0
    block[RATE_KEPT * LANES + i] = math.exp(-s.period / block[RATE_FILTER * LANES + i])
    put_six(block, TORQUES, i, (0.0, 0.0, 0.0, 0.0, 1.0, 1.0))
    put_six(block, MEASURED, i, six(block, X, i))
    if s.is_sensed:
        make_noise(block, i + 1, s)
        for axis in range(3):
            counts = block[(COUNTS + axis) * LANES + i]
            if counts > 0.0:
                noisy = block[(X + 2 * axis) * LANES + i] + block[(REFERENCE + axis) * LANES + i]
                block[(MEASURED + 2 * axis) * LANES + i] = encoded(noisy, counts, floor)
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        kept = math.exp(-s.period / block[(first + CORRELATION) * LANES + i])
        put_two(block, first + KEPT, i, (kept, 0.0))
    for k in range(int(s.delay)):
        put_two(block, DISTURBANCES + DISTURBANCE * int(s.disturbances) + 2 * k, i, two(block, ASKED, i))


# The compiled entry points.


def standard_normal(key: Any, step: Any, channel: int) -> Any:
    """A number of the standard normal distribution that depends on these three alone.

    SplitMix64 (Steele, Lea, Flood, 2014) of a counter gives two uniform numbers, Box and Muller's transform the rest.
    """
    counter = np.uint64(key * 2.0**53) + np.uint64(0x9E3779B97F4A7C15) * np.uint64(step * NORMALS_PER_STEP + channel)
    z = scrambled(counter)
    u1 = (np.float64(z >> np.uint64(32)) + 0.5) * 2.0**-32
    u2 = np.float64(z & np.uint64(0xFFFFFFFF)) * 2.0**-32
    return math.sqrt(-2.0 * math.log(u1)) * math.cos(2.0 * math.pi * u2)


def scrambled(z: Any) -> Any:
    """SplitMix64's output function of a 64-bit integer."""
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))


def sine(x: Any) -> Any:
    """sin x for |x| up to 1e5, exact to about one unit in the last place, without calls and branches."""
    k = floor(x * (2.0 / math.pi) + 0.5)
    r = ((x - k * HALF_PI_1) - k * HALF_PI_2) - k * HALF_PI_3
    quadrant = k - 4.0 * floor(0.25 * k)
    value = cosine_polynomial(r) if quadrant == 1.0 or quadrant == 3.0 else sine_polynomial(r)
    return -value if quadrant >= 2.0 else value


def cosine(x: Any) -> Any:
    """cos x, likewise."""
    k = floor(x * (2.0 / math.pi) + 0.5)
    r = ((x - k * HALF_PI_1) - k * HALF_PI_2) - k * HALF_PI_3
    quadrant = k - 4.0 * floor(0.25 * k)
    value = sine_polynomial(r) if quadrant == 1.0 or quadrant == 3.0 else cosine_polynomial(r)
    return -value if quadrant == 1.0 or quadrant == 2.0 else value


def sine_polynomial(r: Any) -> Any:
    """Taylor's polynomial, for |r| up to pi/4."""
    y = r * r
    tail = ((((((S8 * y + S7) * y + S6) * y + S5) * y + S4) * y + S3) * y + S2) * y + S1
    return r + r * y * tail


def cosine_polynomial(r: Any) -> Any:
    """Taylor's polynomial, for |r| up to pi/4."""
    y = r * r
    tail = (((((C8 * y + C7) * y + C6) * y + C5) * y + C4) * y + C3) * y + C2
    return 1.0 + (y * y * tail - 0.5 * y)


S1, S2, S3, S4, S5, S6, S7, S8 = ((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 9))
C2, C3, C4, C5, C6, C7, C8 = ((-1.0) ** k / math.factorial(2 * k) for k in range(2, 9))
# pi/2 in three parts (Cody and Waite, 1980; those of Moshier's Cephes), of which k times the first two is exact
HALF_PI_1, HALF_PI_2, HALF_PI_3 = 1.57079625129699707031, 7.54978941586159635335e-8, 5.39030285815811905290e-15


# These are compiled on their own, so that their loops are vectorised before they meet others.
LOOPS = (amplify, disturb, blow, integrate, make_noise, measure, measure_exactly, look_up, judge)


class Kernels(NamedTuple):
    """What is compiled, for one kind of number and one right-hand side."""

    begin_all: Callable
    observe_some: Callable
    step_one: Callable
    step_all: Callable


@cache
def kernels(dtype: type, derivative: Callable) -> Kernels:
    """The compiled simulation; compiled at the first call, and then kept on disk."""
    # not "reassoc", which would undo the reduction in `sine`
    options = {"error_model": "numpy", "fastmath": {"contract", "nnan", "nsz", "arcp"}}
    own = {"sin": sine, "cos": cosine, "derivative": derivative}
    known: dict[FunctionType, Callable] = {}

    def compiled(function: FunctionType) -> Callable:
        """A function and all that it calls, in terms of the dtype and with `own` for what has these names."""
        if function not in known:
            names = {
                name: value
                for name, value in {**function.__globals__, **own}.items()
                if name in function.__code__.co_names
            }
            names = {k: compiled(v) if isinstance(v, FunctionType) else of_dtype(v) for k, v in names.items()}
            code = function.__code__.replace(co_consts=of_dtype(function.__code__.co_consts))
            copy = FunctionType(code, {**function.__globals__, **names}, function.__name__, function.__defaults__)
            known[function] = numba.njit(copy, forceinline=function not in LOOPS, **options)
        return known[function]

    def of_dtype(constant: Any) -> Any:
        # numba takes every literal for double precision, and would compute in that whatever meets one
        if isinstance(constant, tuple) and not hasattr(constant, "_fields"):
            return tuple(map(of_dtype, constant))
        return dtype(constant) if type(constant) is float else constant

    step_block, observe_one, begin_one, in_volts = map(compiled, (control_step, observe, begin, to_voltage))
    finite = numba.njit(are_finite)  # without the assumption that nothing is NaN
    version = source_version()  # in the kernels' closures, and so in the keys under which they are kept on disk

    @numba.njit(cache=True, **options)
    def begin_all(blocks: Any, settings: Any, initial: Any, helicopters: Any) -> None:
        """Starts these helicopters (n,), whose rows are the columns of `initial` (rows, n)."""
        version  # noqa: B018
        s = shared(settings)
        size = len(initial) * LANES
        for column in range(len(helicopters)):
            b, i = helicopters[column] // LANES, helicopters[column] % LANES
            block = blocks[b * size : (b + 1) * size]
            for row in range(len(initial)):
                block[row * LANES + i] = initial[row, column]
            begin_one(block, i, s)

    @numba.njit(cache=True, **options)
    def observe_some(
        blocks: Any,
        size: int,
        settings: Any,
        table: Any,
        features: Any,
        helicopters: Any,
        observation: Any,
        told: Any,
    ) -> None:
        """What these helicopters (n,) observe and tell, into their rows of (N, 49) and columns of (16, N)."""
        version  # noqa: B018
        for column in range(len(helicopters)):
            j = helicopters[column]
            block = blocks[j // LANES * size : (j // LANES + 1) * size]
            observe_one(block, j % LANES, table, features, observation[j])
            for row in range(REPORT - 2):
                told[row, j] = block[row * LANES + j % LANES]
            told[REPORT - 2, j] = 0.0
            told[REPORT - 1, j] = settings[0] * block[STEP * LANES + j % LANES]

    @numba.njit(cache=True, **options)
    def step_one(
        blocks: Any, settings: Any, table: Any, features: Any, front: float, back: float, observation: Any, told: Any
    ) -> tuple:
        """A control step of the only helicopter, with these actions: reward, cost, terminated, truncated."""
        version  # noqa: B018
        s = shared(settings)
        limits = (s.u_low, s.u_high)
        blocks[ASKED * LANES] = min(max(in_volts(front, limits), s.u_low), s.u_high)
        blocks[(ASKED + 1) * LANES] = min(max(in_volts(back, limits), s.u_low), s.u_high)
        step_block(blocks, 1, s, table)
        observe_one(blocks, 0, table, features, observation)
        for row in range(REPORT - 2):
            told[row] = blocks[row * LANES]
        return (
            blocks[REWARD * LANES],
            blocks[COST * LANES],
            blocks[TERMINATED * LANES] > 0.0,
            blocks[TRUNCATED * LANES] > 0.0,
        )

    @numba.njit(cache=True, **options)
    def step_all(
        blocks: Any,
        size: int,
        settings: Any,
        table: Any,
        features: Any,
        actions: Any,
        observation: Any,
        rewards: Any,
        terminated: Any,
        truncated: Any,
        told: Any,
    ) -> int:
        """A control step of all N helicopters: how many flights are over.

        If an action is not finite, nothing is done and the answer is -1. Reads actions (N, 2); writes observation (N, 49), rewards, terminated and truncated (N,), and told (16, N).
        """
        version  # noqa: B018
        if not finite(actions):
            return -1
        s = shared(settings)
        limits, over = (s.u_low, s.u_high), 0
        for b in range(len(blocks) // size):
            block = blocks[b * size : (b + 1) * size]
            first = b * LANES
            n = min(LANES, len(actions) - first)
            for motor in range(2):
                for i in range(n):
                    block[(ASKED + motor) * LANES + i] = actions[first + i, motor]
                for i in range(n):
                    u = in_volts(block[(ASKED + motor) * LANES + i], limits)
                    block[(ASKED + motor) * LANES + i] = min(max(u, s.u_low), s.u_high)
            step_block(block, n, s, table)
            for i in range(n):
                observe_one(block, i, table, features, observation[first + i])
                rewards[first + i] = block[REWARD * LANES + i]
                terminated[first + i] = block[TERMINATED * LANES + i] > 0.0
                truncated[first + i] = block[TRUNCATED * LANES + i] > 0.0
                over += terminated[first + i] or truncated[first + i]
            for row in range(REPORT - 2):
                for i in range(n):
                    told[row, first + i] = block[row * LANES + i]
            for i in range(n):
                told[REPORT - 2, first + i] = block[COST * LANES + i]
                told[REPORT - 1, first + i] = s.period * block[STEP * LANES + i]
        return over

    return Kernels(begin_all, observe_some, step_one, step_all)


@numba.njit(forceinline=True)
def shared(settings: Any) -> Settings:
    """The settings out of their array."""
    s = settings
    return Settings(s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8])


def are_finite(values: Any) -> bool:
    """Whether no value (N, 2) is infinite or NaN."""
    total = 0.0
    for i in range(len(values)):
        total += 0.0 * values[i, 0] + 0.0 * values[i, 1]
    return total == 0.0


def source_version() -> str:
    """A digest of all that is compiled here, whatever file it is in."""
    digest = sha256()
    for name in ("model", "parameters", "plant", "rigid_body", "simulation", "task"):
        digest.update(Path(__file__).with_name(f"{name}.py").read_bytes())
    return digest.hexdigest()


def right_hand_side(plants: Sequence[Plant]) -> Callable:
    """The simplest one that serves all these plants. Raises ValueError if only some of them are rigid bodies."""
    rigid = {q.rig is not None for p in plants for q in p.alternatives}
    if len(rigid) > 1:
        raise ValueError("plant: either all plants of a simulation have a rig, or none")
    if rigid.pop():
        return rigid_body_hindered
    return equation_3 if all(p.is_plain for p in plants) else equation_3_hindered


class Simulation:
    """N helicopters in flight: their numbers, and the compiled steps that work on these.

    Args:
        plants: (N) of each helicopter, with ranges or without.
        references: (N) that each follows.
        control_period: s.
        voltage_limits: V, the amplifier's.
        pitch_limit: rad, where a flight ends.
        start_spread: rad, within which each angle starts about the reference's.
        random_start: whether flights start at a random time of their reference, rather than at its start.
        dtype: of the numbers, np.float64 or np.float32.

    Raises:
        ValueError: if only some of the plants are rigid bodies.
    """

    def __init__(
        self,
        plants: Sequence[Plant],
        references: Sequence[Trajectory],
        control_period: float,
        voltage_limits: tuple[float, float],
        pitch_limit: float,
        start_spread: float = 0.0,
        random_start: bool = False,
        dtype: type = np.float64,
    ) -> None:
        self.plants, self.references = list(plants), list(references)
        self.control_period, self.voltage_limits, self.pitch_limit = control_period, voltage_limits, pitch_limit
        self.start_spread, self.random_start = start_spread, random_start
        self.groups = group_by_identity(plants)
        self.ranges = [ranges_of(p) for p, _ in self.groups]
        all_plants = [p for p, _ in self.groups]
        disturbances = max(len(p.disturbances) for p in all_plants)
        delay = max(p.rotors.delay for p in all_plants)
        settings = Settings(
            period=control_period,
            substeps=1 if all(p.is_plain for p in all_plants) else math.ceil(control_period / SUBSTEP - 1e-9),
            u_low=voltage_limits[0],
            u_high=voltage_limits[1],
            pitch_limit=pitch_limit,
            disturbances=disturbances,
            delay=delay,
            is_sensed=any(p.sensors is not None for p in all_plants),
            is_noisy=any(p.is_noisy for p in all_plants),
        )
        self.settings = np.array(settings, dtype)
        rows = DISTURBANCES + DISTURBANCE * disturbances + 2 * delay
        self.uniforms = START_UNIFORMS + max(p.uniforms for p in all_plants)
        self.is_random = start_spread > 0.0 or random_start or settings.is_noisy or self.uniforms > START_UNIFORMS

        # The references on the control grid, one below the other; each once.
        grids, table, features, first = group_by_identity(references), [], [], 0
        self.initial = np.zeros((rows, len(plants)))  # the blocks of helicopters that start, but for what is drawn
        for reference, followers in grids:
            x_ref, u_ref = control_grid(reference, control_period)
            table.append(np.concatenate((x_ref, u_ref)).T)
            features.append(reference_features(reference, control_period).T)
            limits = reference.limits
            self.initial[TABLE, followers] = first
            self.initial[ASKED : ASKED + 2, followers] = reference.u[:, :1]
            self.initial[LAST, followers] = len(table[-1]) - 1
            self.initial[LIMITS : LIMITS + 4, followers] = np.array([[*limits.u, *limits.pitch]]).T
            first += len(table[-1])
        # a helicopter that waits for its next start is stepped on once more, beyond the end
        self.table = np.concatenate((*table, table[-1][-1:])).astype(dtype)
        self.features = np.concatenate((*features, features[-1][-1:])).astype(np.float32)

        self.size = rows * LANES
        self.blocks = np.zeros(-(-len(plants) // LANES) * self.size, dtype)
        self.bind()

    def bind(self) -> None:
        """Finds the compiled functions, which are not pickled."""
        self.kernels = kernels(self.blocks.dtype.type, right_hand_side([p for p, _ in self.groups]))

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "kernels"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self.bind()

    def draw(self, rng: np.random.Generator) -> np.ndarray:
        """Uniform numbers (self.uniforms,) in [0, 1), of which a flight is made; where none matters, none is drawn."""
        return rng.random(self.uniforms) if self.is_random else np.zeros(self.uniforms)

    def begin(
        self,
        helicopters: np.ndarray,
        uniforms: np.ndarray,
        states: np.ndarray | None = None,
        times: np.ndarray | None = None,
    ) -> None:
        """Starts the flights of these helicopters (n,), made of uniform numbers (n, self.uniforms).

        In these states (6, n), and at these times (n,) of their references in s, or where and when the numbers say.
        """
        start = self.initial[:, helicopters]
        if times is not None:
            start[STEP] = np.clip(np.round(times / self.control_period), 0.0, start[LAST] - 1.0)
        elif self.random_start:
            start[STEP] = np.floor(uniforms[:, 3] * start[LAST])
        row = (start[TABLE] + start[STEP]).astype(int)
        start[X : X + 6] = self.table[row, :6].T if states is None else states
        if states is None:
            start[X : X + 6 : 2] += self.start_spread * (2.0 * uniforms[:, :3].T - 1.0)
        start[ASKED : ASKED + 2] = np.where(start[STEP] > 0.0, self.table[row - 1, 6:].T, start[ASKED : ASKED + 2])
        start[MOTOR : MOTOR + 2] = start[ROTOR : ROTOR + 2] = start[ASKED : ASKED + 2]
        start[KEY] = uniforms[:, 4]
        for (_, members), ranges in zip(self.groups, self.ranges):
            chosen = np.isin(helicopters, members) if len(self.groups) > 1 else slice(None)
            values = ranges.draw(uniforms[chosen, START_UNIFORMS:])
            start[NUMBERS:LAG_KEPT, chosen] = values[: LAG_KEPT - NUMBERS]
            for d, own in enumerate(values[LAG_KEPT - NUMBERS :].reshape(-1, KEPT, values.shape[1])):
                first = DISTURBANCES + DISTURBANCE * d
                start[first : first + KEPT, chosen] = own
        self.kernels.begin_all(self.blocks, self.settings, start.astype(self.blocks.dtype), helicopters)

    def observe(self, helicopters: np.ndarray, observation: np.ndarray, told: np.ndarray) -> None:
        """What these helicopters (n,) observe and tell now, into their rows of (N, 49) and columns of (16, N)."""
        self.kernels.observe_some(
            self.blocks, self.size, self.settings, self.table, self.features, helicopters, observation, told
        )

    def step(self, actions: np.ndarray) -> tuple:
        """A control step of all helicopters under actions (N, 2), float32 or float64.

        How many flights are over, observations (N, 49), rewards, terminated and truncated (N,), and what is told
        (16, N). If an action is not finite, nothing is done, and the first answer is -1.
        """
        n = len(actions)
        observation, told = np.empty((n, OBSERVED), np.float32), np.empty((REPORT, n), self.blocks.dtype)
        rewards, terminated, truncated = np.empty(n), np.empty(n, bool), np.empty(n, bool)
        over = self.kernels.step_all(
            self.blocks,
            self.size,
            self.settings,
            self.table,
            self.features,
            actions,
            observation,
            rewards,
            terminated,
            truncated,
            told,
        )
        return over, observation, rewards, terminated, truncated, told

    def errors(self) -> np.ndarray:
        """Tracking errors (6, N) of the true states, now."""
        row = (self.rows(TABLE, 1) + self.rows(STEP, 1))[0].astype(int)
        return self.rows(X, 6) - self.table[row, :6].T

    def rows(self, first: int, count: int) -> np.ndarray:
        """These rows of all helicopters, (count, N)."""
        shown = self.blocks.reshape(-1, self.size // LANES, LANES)[:, first : first + count]
        return shown.transpose(1, 0, 2).reshape(count, -1)[:, : len(self.plants)]


def group_by_identity(values: Sequence) -> list[tuple[Any, np.ndarray]]:
    """Each distinct object, and where in the sequence it is."""
    places: dict[int, list[int]] = {}
    for place, value in enumerate(values):
        places.setdefault(id(value), []).append(place)
    return [(values[where[0]], np.array(where)) for where in places.values()]
