"""Start of a flight: its plant, its state, and derived quantities."""

import math
from typing import Any, NamedTuple

from numpy import floor

from heli_gym.model import power_thrust
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import quantise
from heli_gym.simulation.fast_math import power, standard_normal
from heli_gym.simulation.layout import (
    ARRIVING,
    BACK,
    COMMAND,
    CORRELATION,
    COUNTS,
    DECAY,
    DELAY,
    DELAY_PERIODS,
    DELAY_REST,
    DISTURBANCE,
    DISTURBANCES,
    FRONT,
    GAINS,
    HOVER_VOLTAGE,
    KEY,
    LAG,
    LAG_DECAY,
    LAST,
    LOSS,
    MEASURED,
    MOTOR,
    NOISE,
    ON_ANGLES,
    PARAMETERS,
    RATE_DECAY,
    RATE_FILTER,
    REFERENCE_ROW,
    REST_DECAY,
    ROTOR,
    ROW,
    SHARE,
    START_ANGLES,
    START_KEY,
    START_PLANT,
    START_TIME,
    STEP,
    TIME,
    TORQUES,
    ZEROS,
    Settings,
    X,
    eleven,
    four,
    pending_rows,
    put_six,
    put_two,
    six,
    two,
)
from heli_gym.task import TABLE_WIDTH

NEARLY = 1e-4  # control periods, tolerance within which a delay is a whole number of periods


class Ranges(NamedTuple):
    """Ranges of the rows `row` (R,) of drawn plants: low + span * uniforms[index], each (A, R).

    The helicopter j draws one of the `count[j]` alternatives that start at index `first[j]` of A.
    """

    row: Any
    low: Any
    span: Any
    index: Any
    first: Any
    count: Any


def sample_parameters(block: Any, i: int, ranges: Ranges, j: int, u: Any) -> None:
    """Write the plant j, drawn at the uniform numbers u, into the helicopter i of a block."""
    count = ranges.count[j]
    choice = ranges.first[j]
    if count > 1:
        choice += int(u[START_PLANT] * count)
    for r in range(ranges.low.shape[1]):
        value = ranges.low[choice, r]
        if ranges.index[choice, r] > 0:
            value += ranges.span[choice, r] * u[START_PLANT + ranges.index[choice, r]]
        block[ranges.row[r] * ROW + i] = value


def init_state(block: Any, i: int, s: Settings, table: Any, initial: Any, u: Any, state: Any, step: Any) -> None:
    """Initialise the helicopter i from its `initial` rows, in the given state (6,) or, without one, at its reference.

    It starts at the given step of its reference; a negative step is drawn from the uniform numbers u.
    """
    for row in range(len(initial)):
        block[row * ROW + i] = initial[row]
    if step >= 0.0:
        block[STEP * ROW + i] = step
    elif s.random_start > 0.0:
        block[STEP * ROW + i] = floor(u[START_TIME] * initial[LAST])
    block[TIME * ROW + i] = s.period * block[STEP * ROW + i]
    at = TABLE_WIDTH * (int(initial[REFERENCE_ROW]) + int(block[STEP * ROW + i]))
    for k in range(6):
        block[(X + k) * ROW + i] = state[k] if len(state) > 0 else table[at + k]
    if len(state) == 0:
        for axis in range(3):
            block[(X + 2 * axis) * ROW + i] += s.start_spread * (2.0 * u[START_ANGLES + axis] - 1.0)
        block[(X + 4) * ROW + i] = min(max(block[(X + 4) * ROW + i], -s.pitch_limit), s.pitch_limit)
    for motor in range(2):
        if block[STEP * ROW + i] > 0.0:
            block[(COMMAND + motor) * ROW + i] = table[at - TABLE_WIDTH + 6 + motor]
        block[(MOTOR + motor) * ROW + i] = block[(COMMAND + motor) * ROW + i]
        block[(ROTOR + motor) * ROW + i] = block[(COMMAND + motor) * ROW + i]
    block[KEY * ROW + i] = u[START_KEY]


def init_derived(block: Any, i: int, s: Settings) -> None:
    """Compute the rows derived from plant and state of the helicopter i, including its first measurement.

    The first rate estimates are the true rates, as after a long run of the estimator. All delayed voltages are the
    initial ones.
    """
    delay = block[DELAY * ROW + i]
    periods = floor(delay / s.period + NEARLY)
    rest = max(delay - s.period * periods, 0.0)
    rest = rest if rest > NEARLY * s.period else 0.0
    block[DELAY_PERIODS * ROW + i], block[DELAY_REST * ROW + i] = periods, rest
    lag, substeps = block[LAG * ROW + i], s.substeps
    block[LAG_DECAY * ROW + i] = math.exp(-0.5 * ((s.period - rest) / substeps) / lag) if lag > 0.0 else 0.0
    block[REST_DECAY * ROW + i] = math.exp(-0.5 * (rest / substeps) / lag) if lag > 0.0 else 0.0
    scale, (gain_f, gain_b) = (1.0 - block[LOSS * ROW + i]) * hover_scale(block, i), two(block, GAINS, i)
    put_two(block, SHARE, i, (scale * gain_f, scale * gain_b))
    put_two(block, ARRIVING, i, two(block, COMMAND, i))
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
            angle = block[(X + 2 * axis) * ROW + i] - block[(ZEROS + axis) * ROW + i]
            noisy = angle + block[(ON_ANGLES + axis) * ROW + i]
            block[(MEASURED + 2 * axis) * ROW + i] = quantise(noisy, counts, floor)
    for d in range(int(s.disturbances)):
        first = DISTURBANCES + DISTURBANCE * d
        decay = math.exp(-s.period / block[(first + CORRELATION) * ROW + i])
        put_two(block, first + DECAY, i, (decay, 0.0))
    for k in range(int(s.delay)):
        put_two(block, pending_rows(s) + 2 * k, i, two(block, COMMAND, i))


def hover_scale(block: Any, i: int) -> Any:
    """Factor on the power curves that makes the helicopter i hover level at HOVER_VOLTAGE; 1 if that is not set."""
    u = block[HOVER_VOLTAGE * ROW + i]
    if u == 0.0:
        return 1.0
    p = HelicopterParameters(*eleven(block, PARAMETERS, i))
    k_plus, k_minus, exponent, dead_zone = four(block, FRONT, i)
    front = power_thrust(u, k_plus, k_minus, exponent, dead_zone, power)
    k_plus, k_minus, exponent, dead_zone = four(block, BACK, i)
    return -p.a2 / (p.b2 * (front + power_thrust(u, k_plus, k_minus, exponent, dead_zone, power)))
