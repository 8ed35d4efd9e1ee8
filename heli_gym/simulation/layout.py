"""Memory layout of a simulation: a table of quantities determines the rows of a block.

A block holds the numbers of `LANES` helicopters, one row per component of a quantity, so that the innermost loops run
over helicopters and become SIMD instructions. Component k of the quantity at row FIRST, of the helicopter i of a block,
is `block[(FIRST + k) * ROW + i]`. The rows of the table are followed by rows whose number depends on the plants:
disturbances, pieces of measured thrust curves, and delayed voltages.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from heli_gym.parameters import Coupling, HelicopterParameters
from heli_gym.plant import NO_TABLE, Plant, rotor_curves
from heli_gym.rigid_body import RigidBodyParameters
from heli_gym.thrust_map import PowerCurve, TableCurve

LANES = 128  # helicopters of a block
ROW = LANES + 8  # distance between rows; a power of two would have rows evict each other from the cache
NOT_NEGATIVE = 2**40 - 1  # mask that tells LLVM an index is non-negative


class Quantity(NamedTuple):
    """Consecutive rows of a block: first row, number of rows, and their values from a plant, if it sets them."""

    row: int
    width: int
    of_plant: Callable[[Plant], Any] | None  # numbers (width,), or ranges


QUANTITIES: dict[str, Quantity] = {}  # by name, in the order of their rows


def rows_in_use() -> int:
    """Number of rows of the quantities defined so far."""
    return sum(quantity.width for quantity in QUANTITIES.values())


def quantity(name: str, width: int = 1, of_plant: Callable[[Plant], Any] | None = None) -> int:
    """Define the next quantity of a block and return its first row."""
    QUANTITIES[name] = Quantity(rows_in_use(), width, of_plant)
    return QUANTITIES[name].row


def power_curve(p: Plant, rotor: int) -> tuple:
    """Power curve of a rotor; zero thrust if the rotor has a measured curve instead."""
    curve = rotor_curves(p.thrust_map)[rotor]
    if curve is None:
        return PowerCurve(p.parameters.k_plus, p.parameters.k_minus)
    return curve if isinstance(curve, PowerCurve) else PowerCurve(0.0, 0.0, 1.0)


def cubic_pieces(curve: TableCurve) -> list[tuple]:
    """Rows ORIGIN to LINEAR of each piece of a measured thrust curve: cubics, and straight lines beyond both ends."""
    u, (low, high) = curve.voltages, curve.end_slopes
    cubics = [(start, 0.0, end - start, *c[:3]) for start, end, c in zip(u, u[1:], curve.cubics.c.T.tolist())]
    return [(u[0], -math.inf, 0.0, 0.0, 0.0, low), *cubics, (u[-1], 0.0, math.inf, 0.0, 0.0, high)]


# Outputs of a step.
X = quantity("state", 6)  # (44)
COMMAND = quantity("command", 2)  # V, within the amplifier's limits
REWARD = quantity("reward")
COST = quantity("cost")
TERMINATED = quantity("terminated")
TRUNCATED = quantity("truncated")
SUCCEEDED = quantity("succeeded")
TIME = quantity("time")  # s, on the reference
N_OUTPUTS = rows_in_use()
MEASURED = quantity("measured", 6)  # (44), where sensors are not exact
N_OUTPUTS_SENSED = rows_in_use()

# State besides (44).
MOTOR = quantity("motor", 2)  # V, at the motors
ROTOR = quantity("rotor", 2)  # V, rotor speed as the steady-state voltage
STEP = quantity("step")  # control periods since the start of the reference
KEY = quantity("key")  # of the flight's random numbers, in [0, 1)

# Reference of the flight.
LAST = quantity("last")  # its last step
REFERENCE_ROW = quantity("reference_row")  # its first row in the table of references
LIMITS = quantity("limits", 2)  # u_min and u_max, V
PITCH_LIMITS = quantity("pitch_limits", 2)  # pitch_min and pitch_max, rad

HOVER = quantity("hover", 2)  # V, of the action zero

# Plant of the flight.
NO_RIGID_BODY = (0.0,) * len(RigidBodyParameters._fields)
PARAMETERS = quantity("parameters", len(HelicopterParameters._fields), lambda p: p.parameters)
RIG = quantity("rig", len(RigidBodyParameters._fields), lambda p: p.rig or NO_RIGID_BODY)
LAG = quantity("lag", 1, lambda p: (p.rotors.lag,))  # s
LOSS = quantity("loss", 1, lambda p: (p.rotors.thrust_loss,))  # share of the thrust
SLEW = quantity("slew", 1, lambda p: (p.rotors.slew,))  # V/s
DELAY = quantity("delay", 1, lambda p: (p.rotors.delay,))  # s
GAINS = quantity("gains", 2, lambda p: p.rotors.gains)  # of the thrusts of front and back
FRONT = quantity("front", 4, lambda p: power_curve(p, 0))  # k_plus, k_minus, exponent, dead zone of the thrust
BACK = quantity("back", 4, lambda p: power_curve(p, 1))
HOVER_VOLTAGE = quantity("hover_voltage", 1, lambda p: (p.hover_voltage or 0.0,))  # V; 0: as the thrust map says
VISCOUS = quantity("viscous", 3, lambda p: p.friction.viscous)  # 1/s
COULOMB = quantity("coulomb", 3, lambda p: p.friction.coulomb)  # rad/s²
COUNTS = quantity("counts", 3, lambda p: p.sensors.counts if p.sensors else (0, 0, 0))  # 0: the true state
NOISE = quantity("noise", 1, lambda p: (p.sensors.noise if p.sensors else 0.0,))  # rad
ZEROS = quantity("zeros", 3, lambda p: p.sensors.zeros if p.sensors else (0.0, 0.0, 0.0))  # rad
RATE_FILTER = quantity("rate_filter", 1, lambda p: (p.sensors.rate_filter if p.sensors else 1.0,))  # s
TRAVEL_LIFT = quantity("travel_lift", 1, lambda p: (p.travel_lift,))  # 1/rad
COUPLING = quantity("coupling", len(Coupling._fields), lambda p: p.coupling)
TABLE = quantity("table", 2, lambda p: (p.table.elevation, p.table.friction) if p.table else (NO_TABLE, 0.0))

# Derived from the plant and the control period, once per flight.
DELAY_PERIODS = quantity("delay_periods")  # whole control periods of the delay
DELAY_REST = quantity("delay_rest")  # s, its fractional rest
SHARE = quantity("share", 2)  # of each rotor's thrust, after loss and gains
LAG_DECAY = quantity("lag_decay")  # of the rotors' deviation over half an integration step
REST_DECAY = quantity("rest_decay")  # the same, over half an integration step within DELAY_REST
RATE_DECAY = quantity("rate_decay")  # of the rate estimate over a control period

# Intermediate results of a step.
TORQUES = quantity("torques", 3)  # rad/s², sum of all disturbances
A2_CHANGE = quantity("a2_change")  # rad/s², likewise
EFFECT = quantity("effect", 2)  # share of each rotor's thrust after faults
REFERENCE = quantity("reference", 6)  # state
NOMINAL = quantity("nominal", 2)  # V
ARRIVING = quantity("arriving", 2)  # V, at the amplifiers, after the delay
AFTER = quantity("after")  # s, from the start of the control period to the integration step
H = quantity("h")  # s, length of the integration step; must be the next row
SPEEDS = quantity("speeds", 6)  # V, ROTOR at the start, in the middle and at the end of the integration step
THRUSTS = quantity("thrusts", 6)  # N, of the rotors at these speeds
ON_ANGLES = quantity("on_angles", 3)  # rad, noise of the sensors

# Rows of each disturbance, after those of the table.
DISTURBANCES, DISTURBANCE = rows_in_use(), 8
KIND, CHANNEL, AMOUNT, BEGIN, DURATION, CORRELATION, DECAY, GUST = range(8)
PULSE, ORNSTEIN_UHLENBECK, RAMP = range(3)  # kinds

# Rows of a measured thrust curve, after those of the disturbances: its thrust at the first point, then PIECE rows of
# each piece, whose contribution is a cubic of the voltage from ORIGIN, clipped to LOW and HIGH.
PIECE = 6
ORIGIN, LOW, HIGH, CUBIC, SQUARE, LINEAR = range(PIECE)  # V, V, V, N/V³, N/V², N/V

# Indices of the uniform numbers at the start of a flight: three angles, time, key, then the plant.
START_ANGLES, START_TIME, START_KEY, START_PLANT = 0, 3, 4, 5


class Settings(NamedTuple):
    """Settings shared by all helicopters of a simulation, passed to the kernels as an array."""

    period: float  # s, of the control
    substeps: int
    u_low: float  # V
    u_high: float  # V
    pitch_limit: float  # rad
    disturbances: int  # of any helicopter, at most
    pieces: int  # of any measured thrust curve, at most
    delay: int  # whole control periods, of any helicopter, at most
    is_fractional: bool  # whether the delay of any helicopter is not a whole number of control periods
    is_sensed: bool
    is_noisy: bool
    start_spread: float  # rad
    random_start: bool


SETTINGS = 16  # length of the settings array


def shared(settings: Any) -> Settings:
    """Unpack the settings array."""
    s = settings
    return Settings(s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10], s[11], s[12])


def curve_rows(s: Any) -> int:
    """First row of the measured thrust curves; each rotor's has 1 + PIECE * s.pieces rows."""
    return DISTURBANCES + DISTURBANCE * int(s.disturbances)


def pending_rows(s: Any) -> int:
    """First row of the delayed voltages: two rows for each period of the delay, the oldest first."""
    return curve_rows(s) + (2 * (1 + PIECE * int(s.pieces)) if s.pieces > 0.0 else 0)


def count_rows(s: Any) -> int:
    """Number of rows of a block."""
    return pending_rows(s) + 2 * int(s.delay)


# Consecutive rows of one helicopter. Written out, because LLVM's alias analysis sees through one call, not through two.


def two(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next for the helicopter i."""
    return block[row * ROW + i], block[(row + 1) * ROW + i]


def three(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next two for the helicopter i."""
    return block[row * ROW + i], block[(row + 1) * ROW + i], block[(row + 2) * ROW + i]


def four(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next three for the helicopter i."""
    return block[row * ROW + i], block[(row + 1) * ROW + i], block[(row + 2) * ROW + i], block[(row + 3) * ROW + i]


def five(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next four for the helicopter i."""
    return (
        block[row * ROW + i],
        block[(row + 1) * ROW + i],
        block[(row + 2) * ROW + i],
        block[(row + 3) * ROW + i],
        block[(row + 4) * ROW + i],
    )


def six(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next five for the helicopter i."""
    return (
        block[row * ROW + i],
        block[(row + 1) * ROW + i],
        block[(row + 2) * ROW + i],
        block[(row + 3) * ROW + i],
        block[(row + 4) * ROW + i],
        block[(row + 5) * ROW + i],
    )


def eight(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next seven for the helicopter i."""
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


def eleven(block: Any, row: int, i: int) -> tuple:
    """Values of this row and the next ten for the helicopter i."""
    return (
        block[row * ROW + i],
        block[(row + 1) * ROW + i],
        block[(row + 2) * ROW + i],
        block[(row + 3) * ROW + i],
        block[(row + 4) * ROW + i],
        block[(row + 5) * ROW + i],
        block[(row + 6) * ROW + i],
        block[(row + 7) * ROW + i],
        block[(row + 8) * ROW + i],
        block[(row + 9) * ROW + i],
        block[(row + 10) * ROW + i],
    )


def put_two(block: Any, row: int, i: int, values: tuple) -> None:
    """Write two values into this row and the next of the helicopter i."""
    block[row * ROW + i], block[(row + 1) * ROW + i] = values


def put_six(block: Any, row: int, i: int, values: tuple) -> None:
    """Write six values into this row and the next five of the helicopter i."""
    a, b, c, d, e, f = values
    block[row * ROW + i] = a
    block[(row + 1) * ROW + i] = b
    block[(row + 2) * ROW + i] = c
    block[(row + 3) * ROW + i] = d
    block[(row + 4) * ROW + i] = e
    block[(row + 5) * ROW + i] = f
