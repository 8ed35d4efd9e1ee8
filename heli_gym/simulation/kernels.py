"""The control step in loops, of one helicopter or of many, from the actions to reward and observation.

The equations are those of `model`, `rigid_body`, `plant` and `task`; here is only the order in which they are used, and
where the numbers are kept. `kernels` compiles both, as they stand; uncompiled, the same functions do the same, slowly.

The numbers of `LANES` helicopters are a block: one row for each quantity, so that the innermost loops run over
helicopters and become SIMD instructions. These loops are free of calls and branches to that end: a condition is a
selection, and arrays are flat, with constant distances between rows, so that the compiler sees what overlaps.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from numba import types
from numpy import cos, float64, floor, sin

from heli_gym.compilation import Compiler
from heli_gym.model import axpy, dynamics, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import quantise, with_friction_and_disturbances
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.simulation import fast_math
from heli_gym.simulation.fast_math import standard_normal
from heli_gym.task import FEATURES, cost, crashed, reward, succeeded, to_voltage

LANES = 128
ROW = LANES + 8  # numbers from one row to the next; were it a power of two, rows would fight for places in the cache
NOT_NEGATIVE = 2**40 - 1  # a mask that tells the compiler so, that it need not think of places counted from the end

# Rows of a block. What a step tells of a helicopter: (44), V, the last reward and cost, how the flight ends, if it
# does, and the time on its reference:
X, COMMAND, REWARD, COST, TERMINATED, TRUNCATED, SUCCEEDED, TIME = 0, 6, 8, 9, 10, 11, 12, 13
PITCH = X + 4
MEASURED = 14  # (44), where sensors are not exact
N_OUTPUTS, N_OUTPUTS_SENSED = 14, 20  # rows
# what it remembers besides: voltages in V, the present and the last step of its reference and the first of its rows in
# the table, a number in [0, 1), and u_min, u_max, pitch_min, pitch_max of its reference:
MOTOR, ROTOR, STEP, LAST, REFERENCE_ROW, KEY, LIMITS, PITCH_LIMITS = 20, 22, 24, 25, 26, 27, 28, 30
# what it is, in the order of `simulation.numbers`:
NUMBERS = PARAMETERS = 32
PARAMETERS_REST, RIG, RIG_REST, LAG, LOSS, SLEW, DELAY, VISCOUS, COULOMB = 40, 43, 51, 54, 55, 56, 57, 58, 61
COUNTS, NOISE, RATE_FILTER = 64, 67, 68
# what follows from that and from the control period, and is kept for speed:
LAG_DECAY, RATE_DECAY = 69, 70
# what is passed on within a step: what the disturbances amount to, the reference's state and nominal voltages, the
# voltage that arrives at a motor, and noise on the angles:
TORQUES, A2_CHANGE, EFFECT, REFERENCE, NOMINAL, ARRIVING, ON_ANGLES = 71, 74, 75, 77, 83, 85, 86
# its disturbances, DISTURBANCE rows each, and after the last one the voltages still delayed, the oldest first:
DISTURBANCES, DISTURBANCE = 89, 8
KIND, CHANNEL, AMOUNT, BEGIN, DURATION, CORRELATION, DECAY, GUST = range(8)
PULSE, ORNSTEIN_UHLENBECK, RAMP = range(3)

OBSERVED = 8 + FEATURES  # numbers of an observation
NOT_FINITE, FLYING, CRASHED, ENDED_OFF_GOAL, ARRIVED = -1, 0, 1, 2, 3  # how a step of one helicopter ends
# The uniform numbers that a start is made of: for the three angles, the time, the key; then those of the plant.
START_ANGLES, START_TIME, START_KEY, START_PLANT = 0, 3, 4, 5


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
    start_spread: float  # rad
    random_start: bool


SETTINGS = 16  # numbers that are kept free for them before the blocks


class Ranges(NamedTuple):
    """What plants are drawn from: the numbers (A, R) of A alternatives are low + span * u, u being uniforms[index].

    Of the alternatives, each helicopter (N,) has `count` from `first` on.
    """

    low: Any
    span: Any
    index: Any
    first: Any
    count: Any


class LimitArrays(NamedTuple):
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


# The right-hand sides, one of which is compiled into a simulation.


def equation_3(x: Any, v: Any, body: Body) -> tuple:
    """(3) and no more."""
    return dynamics(x, v, body.parameters, sin, cos)


def equation_3_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """(3) with friction and disturbances."""
    return with_friction_and_disturbances(
        x, dynamics(x, v, body.parameters, sin, cos), body.viscous, body.coulomb, body.torques, cos
    )


def rigid_body_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """The full rigid body with friction and disturbances."""
    return with_friction_and_disturbances(
        x, rigid_dynamics(x, v, body.rig, sin, cos), body.viscous, body.coulomb, body.torques, cos
    )


derivative = equation_3  # a name that `kernels` binds to the one that is needed


# Rows of one helicopter. Spelt out, for the compiler sees what overlaps in memory through one call but not through two,
# and only where `row` is a constant with a name: a sum is not known to be positive when that is looked at.


def two(block: Any, row: int, i: int) -> tuple:
    """This row and the next of the helicopter i."""
    return block[row * ROW + i], block[(row + 1) * ROW + i]


def three(block: Any, row: int, i: int) -> tuple:
    """This row and the next two."""
    return block[row * ROW + i], block[(row + 1) * ROW + i], block[(row + 2) * ROW + i]


def six(block: Any, row: int, i: int) -> tuple:
    """This row and the next five."""
    return (
        block[row * ROW + i],
        block[(row + 1) * ROW + i],
        block[(row + 2) * ROW + i],
        block[(row + 3) * ROW + i],
        block[(row + 4) * ROW + i],
        block[(row + 5) * ROW + i],
    )


def eight(block: Any, row: int, i: int) -> tuple:
    """This row and the next seven."""
    return (
        block[row * ROW + i],
        block[(row + 1) * ROW + i],
        block[(row + 2) * ROW + i],
        block[(row + 3) * ROW + i],
        block[(row + 4) * ROW + i],
        block[(row + 5) * ROW + i],
        block[(row + 6) * ROW + i],
        block[(row + 7) * ROW + i],
    )


def put_two(block: Any, row: int, i: int, values: tuple) -> None:
    """Writes into this row and the next of the helicopter i."""
    block[row * ROW + i], block[(row + 1) * ROW + i] = values


def put_six(block: Any, row: int, i: int, values: tuple) -> None:
    """Writes into this row and the next five."""
    a, b, c, d, e, f = values
    block[row * ROW + i] = a
    block[(row + 1) * ROW + i] = b
    block[(row + 2) * ROW + i] = c
    block[(row + 3) * ROW + i] = d
    block[(row + 4) * ROW + i] = e
    block[(row + 5) * ROW + i] = f


# The control step, in loops over the n helicopters of a block.


def command(block: Any, n: int, s: Settings, actions: Any, first: int) -> None:
    """The voltages asked for by the actions, two for each helicopter, within what the amplifier can do."""
    for i in range(n):
        front, back = actions[2 * (first + i)], actions[2 * (first + i) + 1]
        put_two(block, COMMAND, i, (saturated(front, s), saturated(back, s)))


def saturated(action: Any, s: Settings) -> Any:
    """The voltage of an action, within what the amplifier can do."""
    return min(max(to_voltage(action, (s.u_low, s.u_high)), s.u_low), s.u_high)


def apply_amplifier(block: Any, n: int, s: Settings) -> None:
    """The voltages at the motors: those asked for, delayed, and no faster than the amplifier can."""
    delay = int(s.delay)
    pending = DISTURBANCES + DISTURBANCE * int(s.disturbances)
    for motor in range(2):
        for i in range(n):
            block[ARRIVING * ROW + i] = block[(COMMAND + motor) * ROW + i]
        for k in range(delay):
            later = pending + 2 * (k + 1) if k < delay - 1 else COMMAND
            for i in range(n):
                late, own_delay = block[(pending + 2 * k + motor) * ROW + i], block[DELAY * ROW + i]
                arriving = block[ARRIVING * ROW + i]
                block[ARRIVING * ROW + i] = late if own_delay == delay - k else arriving
                block[(pending + 2 * k + motor) * ROW + i] = block[(later + motor) * ROW + i]
        for i in range(n):
            last, most = block[(MOTOR + motor) * ROW + i], s.period * block[SLEW * ROW + i]
            u = min(max(block[ARRIVING * ROW + i], last - most), last + most)
            block[(MOTOR + motor) * ROW + i] = u
            w = block[(ROTOR + motor) * ROW + i]
            block[(ROTOR + motor) * ROW + i] = u if block[LAG * ROW + i] == 0.0 else w  # without lag, at once


def step_gusts(block: Any, n: int, s: Settings) -> None:
    """The next values of all gusts, Ornstein-Uhlenbeck processes, sampled exactly."""
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        for i in range(n):
            kind, _, strength, _, _, _, decay, gust = eight(block, first, i)
            if kind == ORNSTEIN_UHLENBECK:
                normal = standard_normal(block[KEY * ROW + i], block[STEP * ROW + i], 3 + d)
                block[(first + GUST) * ROW + i] = decay * gust + math.sqrt(1.0 - decay * decay) * strength * normal


def sum_disturbances(block: Any, n: int, s: Settings, after: Any, h: Any) -> None:
    """What the disturbances amount to in h seconds of integration, so many after the start of the control period.

    A push counts for the share of them in which it is on, so that its impulse is right whatever its duration.
    """
    for i in range(n):
        put_six(block, TORQUES, i, (0.0, 0.0, 0.0, 0.0, 1.0, 1.0))
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        for i in range(n):
            kind, channel, amount, init_state, duration, _, _, gust = eight(block, first, i)
            since = s.period * block[STEP * ROW + i] + after - init_state
            on = min(max(since + h, 0.0), duration) - min(max(since, 0.0), duration)  # finite, if the duration is not
            if kind == ORNSTEIN_UHLENBECK:
                value = gust
            elif kind == RAMP:
                value = amount * min(max((since + 0.5 * h) / duration, 0.0), 1.0)
            else:
                value = amount * on / h
            row = TORQUES + int(channel)
            if row < EFFECT:
                block[row * ROW + i] += value
            else:
                block[row * ROW + i] *= 1.0 - value


def integrate(block: Any, n: int, h: Any) -> None:
    """h seconds of flight, the voltages at the motors being held: the rotors exactly, the body by Runge-Kutta."""
    for i in range(n):
        p = HelicopterParameters(*eight(block, PARAMETERS, i), *three(block, PARAMETERS_REST, i))
        rig = RigidBodyParameters(*eight(block, RIG, i), *three(block, RIG_REST, i))
        torques = (*three(block, TORQUES, i), block[A2_CHANGE * ROW + i])
        body = Body(p, rig, three(block, VISCOUS, i), three(block, COULOMB, i), torques)

        decay = block[LAG_DECAY * ROW + i]
        (u_f, u_b), (w_f, w_b) = two(block, MOTOR, i), two(block, ROTOR, i)
        middle_f, middle_b = u_f + decay * (w_f - u_f), u_b + decay * (w_b - u_b)
        end_f, end_b = u_f + decay * (middle_f - u_f), u_b + decay * (middle_b - u_b)
        effect_f, effect_b = two(block, EFFECT, i)
        share = 1.0 - block[LOSS * ROW + i]
        front, back = share * effect_f, share * effect_b
        inputs = (
            virtual_input((front * thrust(w_f, p), back * thrust(w_b, p))),
            virtual_input((front * thrust(middle_f, p), back * thrust(middle_b, p))),
            virtual_input((front * thrust(end_f, p), back * thrust(end_b, p))),
        )
        put_six(block, X, i, rk4_step(derivative, six(block, X, i), inputs, h, body))
        put_two(block, ROTOR, i, (end_f, end_b))


def step_plant(block: Any, n: int, s: Settings) -> None:
    """One control period with all that a plant may add to (3)."""
    apply_amplifier(block, n, s)
    h = s.period / s.substeps
    if s.disturbances > 0.0:
        step_gusts(block, n, s)
    for k in range(int(s.substeps)):
        if s.disturbances > 0.0:
            sum_disturbances(block, n, s, k * h, h)
        integrate(block, n, h)


def step_equation_3(block: Any, n: int, s: Settings) -> None:
    """One control period of (3) with rotors that follow at once: what `step_plant` does then, with less to keep."""
    for i in range(n):
        p, (u_f, u_b) = (
            HelicopterParameters(*eight(block, PARAMETERS, i), *three(block, PARAMETERS_REST, i)),
            two(block, COMMAND, i),
        )
        v = virtual_input((thrust(u_f, p), thrust(u_b, p)))
        put_six(block, X, i, rk4_step(derivative, six(block, X, i), (v, v, v), s.period, Body(p, (), (), (), ())))


fly = step_plant  # as `derivative`


def make_noise(block: Any, n: int, step: int) -> None:
    """The noise on the three angles, so many steps from where STEP tells."""
    for axis in range(3):
        for i in range(n):
            normal = standard_normal(block[KEY * ROW + i], block[STEP * ROW + i] + step, axis)
            block[(ON_ANGLES + axis) * ROW + i] = block[NOISE * ROW + i] * normal


def measure(block: Any, n: int, s: Settings) -> None:
    """The next angles, and the rates estimated from them; see `plant.Sensors`."""
    for axis in range(3):
        for i in range(n):
            true_angle = block[(X + 2 * axis) * ROW + i]
            counts = block[(COUNTS + axis) * ROW + i]
            outputs = quantise(true_angle + block[(ON_ANGLES + axis) * ROW + i], max(counts, 1.0), floor)
            last, rate = block[(MEASURED + 2 * axis) * ROW + i], block[(MEASURED + 2 * axis + 1) * ROW + i]
            decay = block[RATE_DECAY * ROW + i]
            estimate = decay * rate + (1.0 - decay) * (outputs - last) / s.period
            true_rate = block[(X + 2 * axis + 1) * ROW + i]
            block[(MEASURED + 2 * axis) * ROW + i] = true_angle if counts == 0.0 else outputs
            block[(MEASURED + 2 * axis + 1) * ROW + i] = true_rate if counts == 0.0 else estimate


def look_up_reference(block: Any, n: int, s: Settings, table: Any) -> None:
    """On to the next step: the reference's state there, and its nominal voltages on the way."""
    for i in range(n):
        at = reference_row(block, i)
        put_two(block, NOMINAL, i, (table[at + 6], table[at + 7]))
        at += FEATURES
        x_ref = (table[at], table[at + 1], table[at + 2], table[at + 3], table[at + 4], table[at + 5])
        put_six(block, REFERENCE, i, x_ref)
        step = block[STEP * ROW + i] + 1.0
        block[STEP * ROW + i], block[TIME * ROW + i] = step, s.period * step


def compute_reward(block: Any, n: int, s: Settings) -> None:
    """Reward, cost, and whether the flight is over; see `task`."""
    for i in range(n):
        x, (u_f, u_b) = six(block, X, i), two(block, COMMAND, i)
        x_ref, (nominal_f, nominal_b) = six(block, REFERENCE, i), two(block, NOMINAL, i)
        limits = LimitArrays(*two(block, LIMITS, i), *two(block, PITCH_LIMITS, i))
        step, last = block[STEP * ROW + i], block[LAST * ROW + i]
        error = axpy(x, -1.0, x_ref)
        earned = s.period * reward(error, (u_f - nominal_f, u_b - nominal_b))
        spent = s.period * cost(x[4], (u_f, u_b), limits)
        terminated = 1.0 if crashed(x[4], s.pitch_limit) else 0.0
        truncated = 1.0 - terminated if step == last else 0.0
        put_two(block, REWARD, i, (earned, spent))
        put_two(block, TERMINATED, i, (terminated, truncated))
        block[SUCCEEDED * ROW + i] = truncated if succeeded(error) else 0.0


def control_step(block: Any, n: int, s: Settings, table: Any) -> None:
    """One control period with the voltages asked for."""
    fly(block, n, s)
    if s.is_sensed > 0.0:
        if s.is_noisy > 0.0:
            make_noise(block, n, 1)
        measure(block, n, s)
    look_up_reference(block, n, s, table)
    compute_reward(block, n, s)


def report(block: Any, n: int, s: Settings, table: Any, first: int, count: int, observation: Any, outputs: Any) -> None:
    """What the helicopters from the first on, of so many, observe and tell."""
    for row in range(len(outputs) // count):
        own = outputs[row * count + first : row * count + first + n]
        for i in range(n):
            own[i] = block[row * ROW + i]
    features = len(observation) // count - 8
    for i in range(n):
        observe(block, i, s, table, features, observation, OBSERVED * (first + i))


def observe(block: Any, i: int, s: Settings, table: Any, features: int, observation: Any, to: int) -> None:
    """What the helicopter i observes, into OBSERVED places from this one on.

    `features` is FEATURES, but the compiler must not know: it would spell the loop out instead of using SIMD.
    """
    at, to = reference_row(block, i), to & NOT_NEGATIVE
    for k in range(features):
        observation[to + 8 + k] = table[at + k]
    measured = six(block, MEASURED, i) if s.is_sensed > 0.0 else six(block, X, i)
    q1, dq1, q2, dq2, q3, dq3 = measured
    observation[to], observation[to + 1] = q1 - table[at], dq1 - table[at + 1]
    observation[to + 2], observation[to + 3] = q2 - table[at + 2], dq2 - table[at + 3]
    observation[to + 4], observation[to + 5] = q3 - table[at + 4], dq3 - table[at + 5]
    observation[to + 6], observation[to + 7] = two(block, COMMAND, i)


def reference_row(block: Any, i: int) -> int:
    """Where in the table the reference of the helicopter i is now; beyond its end, where it ends."""
    step = min(block[STEP * ROW + i], block[LAST * ROW + i])
    return FEATURES * ((int(block[REFERENCE_ROW * ROW + i]) + int(step)) & NOT_NEGATIVE)


# The start of a flight.


def sample_parameters(block: Any, i: int, ranges: Ranges, j: int, u: Any) -> None:
    """The numbers of the plant j, at the uniform numbers u, into the helicopter i of a block."""
    count = ranges.count[j]
    choice = ranges.first[j]
    if count > 1:
        choice += int(u[START_PLANT] * count)
    for r in range(ranges.low.shape[1]):
        value = ranges.low[choice, r]
        if ranges.index[choice, r] > 0:
            value += ranges.span[choice, r] * u[START_PLANT + ranges.index[choice, r]]
        row = NUMBERS + r if r < LAG_DECAY - NUMBERS else DISTURBANCES + r - (LAG_DECAY - NUMBERS)
        block[row * ROW + i] = value


def init_state(block: Any, i: int, s: Settings, table: Any, initial: Any, u: Any, state: Any, step: Any) -> None:
    """The helicopter i, as its reference starts or, if there is one, in a state (6,); `initial` are its rows.

    At this step of its reference, or where that is negative, at the one that the uniform numbers u say.
    """
    for row in range(len(initial)):
        block[row * ROW + i] = initial[row]
    if step >= 0.0:
        block[STEP * ROW + i] = step
    elif s.random_start > 0.0:
        block[STEP * ROW + i] = floor(u[START_TIME] * initial[LAST])
    block[TIME * ROW + i] = s.period * block[STEP * ROW + i]
    at = FEATURES * (int(initial[REFERENCE_ROW]) + int(block[STEP * ROW + i]))
    for k in range(6):
        block[(X + k) * ROW + i] = state[k] if len(state) > 0 else table[at + k]
    if len(state) == 0:
        for axis in range(3):
            block[(X + 2 * axis) * ROW + i] += s.start_spread * (2.0 * u[START_ANGLES + axis] - 1.0)
        block[PITCH * ROW + i] = min(max(block[PITCH * ROW + i], -s.pitch_limit), s.pitch_limit)
    for motor in range(2):
        if block[STEP * ROW + i] > 0.0:
            block[(COMMAND + motor) * ROW + i] = table[at - FEATURES + 6 + motor]
        block[(MOTOR + motor) * ROW + i] = block[(COMMAND + motor) * ROW + i]
        block[(ROTOR + motor) * ROW + i] = block[(COMMAND + motor) * ROW + i]
    block[KEY * ROW + i] = u[START_KEY]


def init_derived(block: Any, i: int, s: Settings) -> None:
    """What follows from the numbers of the helicopter i, just drawn; its first measurement, and no voltage on its way.

    The first rates are the true ones: what estimates them has been running before.
    """
    lag, h = block[LAG * ROW + i], s.period / s.substeps
    block[LAG_DECAY * ROW + i] = math.exp(-0.5 * h / lag) if lag > 0.0 else 0.0
    block[RATE_DECAY * ROW + i] = math.exp(-s.period / block[RATE_FILTER * ROW + i])
    put_six(block, TORQUES, i, (0.0, 0.0, 0.0, 0.0, 1.0, 1.0))
    put_six(block, MEASURED, i, six(block, X, i))
    for axis in range(3):
        block[(ON_ANGLES + axis) * ROW + i] = 0.0
        if s.is_noisy > 0.0:
            normal = standard_normal(block[KEY * ROW + i], block[STEP * ROW + i], axis)
            block[(ON_ANGLES + axis) * ROW + i] = block[NOISE * ROW + i] * normal
        counts = block[(COUNTS + axis) * ROW + i]
        if counts > 0.0:
            noisy = block[(X + 2 * axis) * ROW + i] + block[(ON_ANGLES + axis) * ROW + i]
            block[(MEASURED + 2 * axis) * ROW + i] = quantise(noisy, counts, floor)
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        decay = math.exp(-s.period / block[(first + CORRELATION) * ROW + i])
        put_two(block, first + DECAY, i, (decay, 0.0))
    for k in range(int(s.delay)):
        put_two(block, DISTURBANCES + DISTURBANCE * int(s.disturbances) + 2 * k, i, two(block, COMMAND, i))


# The compiled entry points. Arrays are flat but where stated.


def shared(settings: Any) -> Settings:
    """The settings out of their array."""
    s = settings
    return Settings(s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10])


def are_finite(values: Any) -> bool:
    """Whether no value is infinite or NaN."""
    bad = 0
    for value in values:
        bad |= 0 if abs(value) < math.inf else 1
    return bad == 0


def reset(
    blocks: Any,
    settings: Any,
    table: Any,
    initial: Any,
    ranges: Ranges,
    helicopters: Any,
    uniforms: Any,
    states: Any,
    steps: Any,
) -> None:
    """Starts these helicopters (n,).

    Of the rows `initial` (rows, N) and numbers `uniforms` (N, ...), in [0, 1), each takes its own; so it does of the
    `states` (N, 6), where that is not (N, 0), and of the `steps` (N,) of their references, where that is not negative.
    """
    s, size = shared(settings), len(initial) * ROW
    for j in helicopters:
        first = j // LANES * size
        block, i = blocks[first : first + size], j % LANES
        init_state(block, i, s, table, initial[:, j], uniforms[j], states[j], steps[j])
        sample_parameters(block, i, ranges, j, uniforms[j])
        init_derived(block, i, s)


def write_outputs(
    blocks: Any, settings: Any, table: Any, helicopters: Any, count: int, size: int, observation: Any, outputs: Any
) -> None:
    """What these helicopters (n,), of so many, observe and tell; the rest of the arrays stays as it is."""
    s, features = shared(settings), len(observation) // count - 8
    for j in helicopters:
        first = j // LANES * size
        block, i = blocks[first : first + size], j % LANES
        for row in range(len(outputs) // count):
            outputs[row * count + j] = block[row * ROW + i]
        observe(block, i, s, table, features, observation, OBSERVED * j)


def step(blocks: Any, settings: Any, table: Any, actions_2d: Any, observation_2d: Any, told_2d: Any) -> int:
    """A control step of all helicopters under actions (N, 2): how many flights are over.

    If an action is not finite, nothing is done and the answer is NOT_FINITE. Writes observations (N, OBSERVED) and what
    is told, the first rows (..., N).
    """
    actions, observation, outputs = actions_2d.reshape(-1), observation_2d.reshape(-1), told_2d.reshape(-1)
    if not are_finite(actions):
        return NOT_FINITE
    s, count = shared(settings), len(actions) // 2
    size = len(blocks) // ((count + LANES - 1) // LANES)
    over = 0.0
    for b in range(len(blocks) // size):
        block, first = blocks[b * size : (b + 1) * size], b * LANES
        n = min(LANES, count - first)
        command(block, n, s, actions, first)
        control_step(block, n, s, table)
        report(block, n, s, table, first, count, observation, outputs)
        for i in range(n):
            over += block[TERMINATED * ROW + i] + block[TRUNCATED * ROW + i]
    return int(over)


def step_one(memory: Any, front: Any, back: Any, observation: Any, outputs: Any) -> tuple:
    """A control step of a helicopter that is alone: time, reward, cost, and whether the flight is over, and how.

    Python calls this some hundred thousand times a second, and handing over an array takes as long as a good part of
    the equations: there are as few as can be, and numbers come and go as numbers. `memory` are the settings, then the
    block, then the table; `outputs` the rows up to TOLD_AND_MEASURED.
    """
    if not (abs(front) < math.inf and abs(back) < math.inf):
        return 0.0, 0.0, 0.0, NOT_FINITE
    s = shared(memory)
    size = ROW * (DISTURBANCES + DISTURBANCE * int(s.disturbances) + 2 * int(s.delay))
    block, table = memory[SETTINGS : SETTINGS + size], memory[SETTINGS + size :]
    put_two(block, COMMAND, 0, (saturated(front, s), saturated(back, s)))
    control_step(block, 1, s, table)
    report(block, 1, s, table, 0, 1, observation, outputs)
    if s.is_sensed == 0.0:
        for k in range(6):
            outputs[MEASURED + k] = outputs[X + k]
    over = int(CRASHED * block[TERMINATED * ROW] + ENDED_OFF_GOAL * block[TRUNCATED * ROW] + block[SUCCEEDED * ROW])
    return block[TIME * ROW], block[REWARD * ROW], block[COST * ROW], over


LOOPS = (
    command,
    apply_amplifier,
    step_gusts,
    sum_disturbances,
    integrate,
    step_equation_3,
    make_noise,
    measure,
    look_up_reference,
    compute_reward,
    report,
)


class Kernels(NamedTuple):
    """What is compiled."""

    reset: Callable
    write_outputs: Callable
    step: Callable


@cache
def kernels(dtype: type, rhs: Callable, fly: Callable) -> Kernels:
    """The compiled simulation for one kind of number, one right-hand side and one way to fly a control period.

    Compiled at the first call of each function, and then kept on disk.
    """
    start_up, compiler = compiler_of(dtype, equation_3, step_equation_3), compiler_of(dtype, rhs, fly)
    return Kernels(start_up.entry(reset), start_up.entry(write_outputs), compiler.entry(step))


@cache
def one_step(rhs: Callable, fly: Callable) -> Callable:
    """The compiled `step_one`, for double precision."""
    numbers = types.float64[::1]
    arguments = numbers, types.float64, types.float64, types.float32[::1], numbers
    returns = types.Tuple((*[types.float64] * 3, types.int64))
    return compiler_of(float64, rhs, fly).entry(step_one, returns(*arguments))


@cache
def compiler_of(dtype: type, rhs: Callable, fly: Callable) -> Compiler:
    """What knows the functions that are compiled already."""
    names = {"sin": fast_math.sine, "cos": fast_math.cosine, "derivative": rhs, "fly": fly}
    return Compiler(dtype, names, LOOPS, careful=(are_finite,))
