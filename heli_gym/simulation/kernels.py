"""Compiled control step of one or many helicopters, from the actions to reward and observation.

The equations are those of `model`, `rigid_body`, `plant` and `task`. The modules of this folder call them in loops over
the helicopters of a block; `layout` defines the memory. This module compiles them unchanged; uncompiled, the same
functions give the same results, slowly. The loops have neither calls nor branches, so that LLVM turns them into SIMD
instructions: conditions are selections, and arrays are flat, with constant distances between rows.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from numba import types
from numpy import float64

from heli_gym.compilation import FAST, Compiler
from heli_gym.model import axpy
from heli_gym.simulation import fast_math
from heli_gym.simulation.disturbances import step_gusts, sum_disturbances
from heli_gym.simulation.layout import (
    COMMAND,
    COST,
    HOVER,
    LANES,
    MEASURED,
    NOT_NEGATIVE,
    REWARD,
    ROW,
    SETTINGS,
    SUCCEEDED,
    TERMINATED,
    TIME,
    TRUNCATED,
    Settings,
    X,
    count_rows,
    put_two,
    shared,
    six,
    two,
)
from heli_gym.simulation.motion import (
    equation_3,
    general_rigid_body,
    integrate,
    integrate_general,
    rigid_body_with_disturbances,
    step_equation_3,
    step_plant,
)
from heli_gym.simulation.reward import compute_reward, look_up_reference, reference_row
from heli_gym.simulation.rotors import add_measured_curves, apply_amplifier, delay_command, map_thrusts, turn_rotors
from heli_gym.simulation.sensors import make_noise, measure
from heli_gym.simulation.start import Ranges, init_derived, init_state, sample_parameters
from heli_gym.task import OBSERVATION_LIMIT, OBSERVED, observed_error, observed_voltage, to_voltage

NOT_FINITE, FLYING, CRASHED, ENDED_OFF_GOAL, ARRIVED = -1, 0, 1, 2, 3  # how a step of one helicopter ends

fly = step_plant  # `kernels` rebinds this name to one of the functions that fly a control period


def command(block: Any, n: int, s: Settings, actions: Any, first: int) -> None:
    """Convert actions, two for each helicopter, to voltages within the limits of the amplifier."""
    for i in range(n):
        front, back = actions[2 * (first + i)], actions[2 * (first + i) + 1]
        hover_f, hover_b = two(block, HOVER, i)
        put_two(block, COMMAND, i, (saturated_voltage(front, hover_f, s), saturated_voltage(back, hover_b, s)))


def saturated_voltage(action: Any, hover: Any, s: Settings) -> Any:
    """Voltage of an action, within the limits of the amplifier."""
    u = to_voltage(min(max(action, -1.0), 1.0), (s.u_low, s.u_high), hover)
    return min(max(u, s.u_low), s.u_high)  # exceeded by rounding only


def control_step(block: Any, n: int, s: Settings, table: Any) -> None:
    """Fly one control period with the commanded voltages."""
    fly(block, n, s)
    if s.is_sensed > 0.0:
        if s.is_noisy > 0.0:
            make_noise(block, n, 1)
        measure(block, n, s)
    look_up_reference(block, n, s, table)
    compute_reward(block, n, s)


def write_block(
    block: Any, n: int, s: Settings, table: Any, first: int, count: int, observation: Any, outputs: Any
) -> None:
    """Write observations and outputs of n helicopters, starting at index `first` of `count`."""
    for row in range(len(outputs) // count):
        own = outputs[row * count + first : row * count + first + n]
        for i in range(n):
            own[i] = block[row * ROW + i]
    features = len(observation) // count - 8
    for i in range(n):
        observe(block, i, s, table, features, observation, OBSERVED * (first + i))


def observe(block: Any, i: int, s: Settings, table: Any, features: int, observation: Any, to: int) -> None:
    """Write the observation of the helicopter i into OBSERVED entries from index `to` on.

    `features` is always FEATURES, but as an argument: the compiler would unroll a constant loop instead of using SIMD.
    """
    at, to = reference_row(block, i), to & NOT_NEGATIVE
    for k in range(features):
        observation[to + 8 + k] = table[at + 8 + k]
    measured = six(block, MEASURED, i) if s.is_sensed > 0.0 else six(block, X, i)
    x_ref = (table[at], table[at + 1], table[at + 2], table[at + 3], table[at + 4], table[at + 5])
    e1, e2, e3, e4, e5, e6 = observed_error(axpy(measured, -1.0, x_ref))
    observation[to], observation[to + 1] = saturate(e1), saturate(e2)
    observation[to + 2], observation[to + 3] = saturate(e3), saturate(e4)
    observation[to + 4], observation[to + 5] = saturate(e5), saturate(e6)
    u_f, u_b = two(block, COMMAND, i)
    observation[to + 6], observation[to + 7] = saturate(observed_voltage(u_f)), saturate(observed_voltage(u_b))


def saturate(value: Any) -> Any:
    """Entry of an observation, saturated."""
    return min(max(value, -OBSERVATION_LIMIT), OBSERVATION_LIMIT)


# The compiled entry points. Arrays are flat unless a shape is given.


def are_finite(values: Any) -> bool:
    """Whether all values are finite."""
    bad = 0
    for value in values:
        bad |= 0 if abs(value) < math.inf else 1
    return bad == 0


def all_finite(values: Any) -> bool:
    """Whether all values of an array (N, 2) are finite."""
    return are_finite(values.reshape(-1))


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
    """Start the selected helicopters (n,).

    Column j of each array belongs to helicopter j: rows `initial` (rows, N), uniform numbers `uniforms` (N, ...),
    `states` (N, 6), or (N, 0) for those of the references, and `steps` (N,) of the references; a negative step is
    drawn from the uniform numbers.
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
    """Write observations and outputs of the selected helicopters (n,) of `count`; other entries are unchanged."""
    s, features = shared(settings), len(observation) // count - 8
    for j in helicopters:
        first = j // LANES * size
        block, i = blocks[first : first + size], j % LANES
        for row in range(len(outputs) // count):
            outputs[row * count + j] = block[row * ROW + i]
        observe(block, i, s, table, features, observation, OBSERVED * j)


def step(
    blocks: Any,
    settings: Any,
    table: Any,
    actions_2d: Any,
    observation_2d: Any,
    outputs_2d: Any,
    begin: int,
    end: int,
) -> int:
    """Fly a control step of the blocks [begin, end) under actions (N, 2); return the number of flights that end.

    Writes the observations (N, OBSERVED) and outputs (..., N) of these blocks.
    """
    actions, observation, outputs = actions_2d.reshape(-1), observation_2d.reshape(-1), outputs_2d.reshape(-1)
    s, count = shared(settings), len(actions) // 2
    size = len(blocks) // ((count + LANES - 1) // LANES)
    over = 0.0
    for b in range(begin, end):
        block, first = blocks[b * size : (b + 1) * size], b * LANES
        n = min(LANES, count - first)
        command(block, n, s, actions, first)
        control_step(block, n, s, table)
        write_block(block, n, s, table, first, count, observation, outputs)
        for i in range(n):
            over += block[TERMINATED * ROW + i] + block[TRUNCATED * ROW + i]
    return int(over)


def step_one(memory: Any, front: Any, back: Any, observation: Any, outputs: Any) -> tuple:
    """Fly a control step of a single helicopter; return time, reward, cost and the outcome of the step.

    Python calls this about 100 000 times per second, and passing an array costs as much as a good part of the
    equations: hence few arrays, and scalars passed as scalars. `memory` is settings, block and table in one array;
    `outputs` has N_OUTPUTS_SENSED rows.
    """
    if not (abs(front) < math.inf and abs(back) < math.inf):
        return 0.0, 0.0, 0.0, NOT_FINITE
    s = shared(memory)
    size = ROW * count_rows(s)
    block, table = memory[SETTINGS : SETTINGS + size], memory[SETTINGS + size :]
    hover_f, hover_b = two(block, HOVER, 0)
    put_two(block, COMMAND, 0, (saturated_voltage(front, hover_f, s), saturated_voltage(back, hover_b, s)))
    control_step(block, 1, s, table)
    write_block(block, 1, s, table, 0, 1, observation, outputs)
    if s.is_sensed == 0.0:
        for k in range(6):
            outputs[MEASURED + k] = outputs[X + k]
    over = int(CRASHED * block[TERMINATED * ROW] + ENDED_OFF_GOAL * block[TRUNCATED * ROW] + block[SUCCEEDED * ROW])
    return block[TIME * ROW], block[REWARD * ROW], block[COST * ROW], over


LOOPS = (
    command,
    delay_command,
    apply_amplifier,
    step_gusts,
    sum_disturbances,
    integrate,
    integrate_general,
    step_equation_3,
    turn_rotors,
    map_thrusts,
    add_measured_curves,
    make_noise,
    measure,
    look_up_reference,
    compute_reward,
    write_block,
)


class Kernels(NamedTuple):
    """Compiled entry points of a simulation."""

    reset: Callable
    write_outputs: Callable
    step: Callable
    are_finite: Callable


@cache
def kernels(dtype: type, rhs: Callable, fly: Callable) -> Kernels:
    """Kernels for one dtype, one right-hand side `rhs` and one function `fly` for a control period.

    Each is compiled at its first call, and cached on disk.
    """
    start_up, compiler = compiler_of(dtype, equation_3, step_equation_3), compiler_of(dtype, rhs, fly)
    return Kernels(
        start_up.entry(reset),
        start_up.entry(write_outputs),
        compiler.entry(step, nogil=True),
        start_up.entry(all_finite),
    )


@cache
def one_step(rhs: Callable, fly: Callable) -> Callable:
    """Compile `step_one` in double precision."""
    numbers = types.float64[::1]
    arguments = numbers, types.float64, types.float64, types.float32[::1], numbers
    returns = types.Tuple((*[types.float64] * 3, types.int64))
    return compiler_of(float64, rhs, fly).entry(step_one, returns(*arguments))


# With "contract" and "arcp", LLVM rounds the sums and quotients of one rigid body and of many differently.
RIGID = rigid_body_with_disturbances, general_rigid_body
REPRODUCIBLE = FAST - {"contract", "arcp"}


@cache
def compiler_of(dtype: type, rhs: Callable, fly: Callable) -> Compiler:
    """Compiler of a simulation; cached, so that each function is compiled once."""
    names = {"sin": fast_math.sine, "cos": fast_math.cosine, "derivative": rhs, "fly": fly}
    return Compiler(dtype, names, LOOPS, careful=(are_finite,), fast=REPRODUCIBLE if rhs in RIGID else FAST)
