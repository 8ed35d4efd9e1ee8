"""Amplifiers and rotors in loops over the helicopters of a block; see `plant.Rotors` and `thrust_map`."""

from typing import Any

from heli_gym.model import power_thrust
from heli_gym.simulation.fast_math import power
from heli_gym.simulation.layout import (
    ARRIVING,
    BACK,
    COMMAND,
    CUBIC,
    DELAY_PERIODS,
    FRONT,
    HIGH,
    LAG,
    LINEAR,
    LOW,
    MOTOR,
    NOT_NEGATIVE,
    ORIGIN,
    PIECE,
    ROTOR,
    ROW,
    SLEW,
    SPEEDS,
    SQUARE,
    THRUSTS,
    H,
    Settings,
    curve_rows,
    four,
    pending_rows,
    put_two,
    two,
)


def delay_command(block: Any, n: int, s: Settings) -> None:
    """Advance the delayed voltages by one control period, and write those that arrive into ARRIVING."""
    delay, pending = int(s.delay), pending_rows(s)
    for motor in range(2):
        for i in range(n):
            block[(ARRIVING + motor) * ROW + i] = block[(COMMAND + motor) * ROW + i]
        for k in range(delay):
            later = pending + 2 * (k + 1) if k < delay - 1 else COMMAND
            for i in range(n):
                late, own_delay = block[(pending + 2 * k + motor) * ROW + i], block[DELAY_PERIODS * ROW + i]
                arriving = block[(ARRIVING + motor) * ROW + i]
                block[(ARRIVING + motor) * ROW + i] = late if own_delay == delay - k else arriving
                block[(pending + 2 * k + motor) * ROW + i] = block[(later + motor) * ROW + i]


def apply_amplifier(block: Any, n: int, s: Settings) -> None:
    """Move the motor voltages to those that arrive, limited by the slew rate over `substeps` of H seconds."""
    for motor in range(2):
        for i in range(n):
            duration = max(s.substeps * block[H * ROW + i], 1e-12)  # not zero, since the slew rate may be infinite
            last, most = block[(MOTOR + motor) * ROW + i], duration * block[SLEW * ROW + i]
            u = min(max(block[(ARRIVING + motor) * ROW + i], last - most), last + most)
            block[(MOTOR + motor) * ROW + i] = u
            w = block[(ROTOR + motor) * ROW + i]
            block[(ROTOR + motor) * ROW + i] = u if block[LAG * ROW + i] == 0.0 else w  # without lag, at once


# For the general plant


def turn_rotors(block: Any, n: int, decay_row: int) -> None:
    """Advance SPEEDS and ROTOR by an integration step; `decay_row` holds the decay factor over half a step."""
    for i in range(n):
        decay = block[decay_row * ROW + i]
        (u_f, u_b), (w_f, w_b) = two(block, MOTOR, i), two(block, ROTOR, i)
        middle_f, middle_b = u_f + decay * (w_f - u_f), u_b + decay * (w_b - u_b)
        end_f, end_b = u_f + decay * (middle_f - u_f), u_b + decay * (middle_b - u_b)
        put_two(block, SPEEDS, i, (w_f, w_b))
        put_two(block, SPEEDS + 2, i, (middle_f, middle_b))
        put_two(block, SPEEDS + 4, i, (end_f, end_b))
        put_two(block, ROTOR, i, (end_f, end_b))


def map_thrusts(block: Any, n: int, s: Settings) -> None:
    """Compute THRUSTS at the SPEEDS from the power curves or measured curves of the rotors."""
    for stage in range(3):
        for i in range(n):
            w_f, w_b = block[(SPEEDS + 2 * stage) * ROW + i], block[(SPEEDS + 2 * stage + 1) * ROW + i]
            k_plus, k_minus, exponent, dead_zone = four(block, FRONT, i)
            front = power_thrust(w_f, k_plus, k_minus, exponent, dead_zone, power)
            k_plus, k_minus, exponent, dead_zone = four(block, BACK, i)
            back = power_thrust(w_b, k_plus, k_minus, exponent, dead_zone, power)
            block[(THRUSTS + 2 * stage) * ROW + i], block[(THRUSTS + 2 * stage + 1) * ROW + i] = front, back
    if s.pieces > 0.0:
        add_measured_curves(block, n, s)


def add_measured_curves(block: Any, n: int, s: Settings) -> None:
    """Add the measured thrust curves to THRUSTS; the power curves of rotors with a measured curve give zero."""
    for k in range(6):
        rotor = k % 2
        curve = (curve_rows(s) + rotor * (1 + PIECE * int(s.pieces))) & NOT_NEGATIVE
        for i in range(n):
            block[(THRUSTS + k) * ROW + i] += block[curve * ROW + i]
        for j in range(int(s.pieces)):
            piece = (curve + 1 + PIECE * j) & NOT_NEGATIVE
            for i in range(n):
                u = block[(SPEEDS + k) * ROW + i] - block[(piece + ORIGIN) * ROW + i]
                u = min(max(u, block[(piece + LOW) * ROW + i]), block[(piece + HIGH) * ROW + i])
                c3, c2 = block[(piece + CUBIC) * ROW + i], block[(piece + SQUARE) * ROW + i]
                block[(THRUSTS + k) * ROW + i] += ((c3 * u + c2) * u + block[(piece + LINEAR) * ROW + i]) * u
