"""Amplifier in loops over the helicopters of a block; see `plant.Rotors`."""

from typing import Any

from heli_gym.simulation.layout import (
    ARRIVING,
    COMMAND,
    DELAY,
    DISTURBANCE,
    DISTURBANCES,
    LAG,
    MOTOR,
    ROTOR,
    ROW,
    SLEW,
    Settings,
)


def apply_amplifier(block: Any, n: int, s: Settings) -> None:
    """Delay the commanded voltages, limit their slew rate, and apply them to the motors."""
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
