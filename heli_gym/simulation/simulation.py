"""Simulation of N helicopters: arrays of their numbers, and the compiled kernels that update them."""

import itertools
import math
from collections.abc import Callable, Sequence
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from gymnasium.error import ResetNeeded

from heli_gym import plant
from heli_gym.parameters import NO_COUPLING, HelicopterParameters
from heli_gym.plant import (
    AXES,
    ROTORS,
    Gust,
    MovingMass,
    Plant,
    Push,
    RotorFault,
    Rotors,
    ThrustDrift,
    Uniform,
    rotor_curves,
)
from heli_gym.simulation import kernels, motion
from heli_gym.simulation.layout import (
    COMMAND,
    DISTURBANCE,
    DISTURBANCES,
    HOVER,
    LANES,
    LAST,
    LIMITS,
    N_OUTPUTS,
    N_OUTPUTS_SENSED,
    ORNSTEIN_UHLENBECK,
    PIECE,
    PULSE,
    QUANTITIES,
    RAMP,
    REFERENCE_ROW,
    ROW,
    SETTINGS,
    START_PLANT,
    Settings,
    count_rows,
    cubic_pieces,
    pending_rows,
    shared,
)
from heli_gym.simulation.start import NEARLY, Ranges
from heli_gym.simulation.workers import Workers
from heli_gym.task import OBSERVED, TABLE_WIDTH, control_steps, hover_voltage, reference_table
from heli_gym.thrust_map import TableCurve
from heli_gym.trajectory import Sampler, Trajectory

MOST_BYTES = 3 * 2**29  # of the arrays of a simulation
TABLE_COPIES, BLOCK_COPIES = 3.5, 5.0  # of references and helicopters, while they are made and reset (measured)
SUBSTEP = 10e-3  # s, largest integration step of plants beyond (3)
STABLE = 0.5  # largest product of an integration step and the rate at which friction damps an axis


def plant_values(p: Plant, s: Settings) -> list:
    """Values of the rows `plant_rows` for a plant without ranges."""
    rows = [number for quantity in QUANTITIES.values() if quantity.of_plant for number in quantity.of_plant(p)]
    for value in p.disturbances:
        match value:
            case Push(axis, acceleration, start, duration):
                rows += [PULSE, AXES.index(axis), acceleration, start, duration, 1.0, 0.0, 0.0]
            case Gust(axis, strength, correlation_time):
                rows += [ORNSTEIN_UHLENBECK, AXES.index(axis), strength, 0.0, math.inf, correlation_time, 0.0, 0.0]
            case MovingMass(a2_change, start, duration):
                rows += [RAMP, len(AXES), a2_change, start, duration, 1.0, 0.0, 0.0]
            case RotorFault(rotor, loss, start):
                rows += [PULSE, len(AXES) + 1 + ROTORS.index(rotor), loss, start, math.inf, 1.0, 0.0, 0.0]
            case ThrustDrift(loss, start, duration):
                for rotor in ROTORS:
                    rows += [RAMP, len(AXES) + 1 + ROTORS.index(rotor), loss, start, duration, 1.0, 0.0, 0.0]
    # zeros are disturbances without effect, and curve pieces without contribution
    rows += [0.0] * DISTURBANCE * (s.disturbances - count_disturbances(p))
    if s.pieces:
        for curve in measured_curves(p):
            pieces = cubic_pieces(curve) if curve else []
            base = curve.thrusts[0] if curve else 0.0
            rows += [base, *itertools.chain(*pieces), *[0.0] * PIECE * (s.pieces - len(pieces))]
    return rows


def plant_rows(s: Settings) -> np.ndarray:
    """Rows (R,) set by a plant: its quantities, disturbances and measured curves."""
    own = [q.row + k for q in QUANTITIES.values() if q.of_plant for k in range(q.width)]
    return np.array([*own, *range(DISTURBANCES, pending_rows(s))])


def count_disturbances(p: Plant) -> int:
    """Number of disturbances in the rows of a plant; a drift counts twice, once per rotor."""
    return sum(len(ROTORS) if isinstance(value, ThrustDrift) else 1 for value in p.disturbances)


def measured_curves(p: Plant) -> list[TableCurve | None]:
    """Measured thrust curve of each rotor; None for a power curve."""
    return [curve if isinstance(curve, TableCurve) else None for curve in rotor_curves(p.thrust_map)]


def delay_periods(p: Plant, control_period: float) -> tuple[int, bool]:
    """Largest number of whole control periods in the delay of a plant, and whether the delay may have a fraction."""
    delays = [delay for q in p.alternatives for delay in (q.rotors.delay,)]
    ends = [end for d in delays for end in ((d.low, d.high) if isinstance(d, Uniform) else (d,))]
    rest = max(abs(end / control_period - round(end / control_period)) for end in ends)
    is_range = any(isinstance(d, Uniform) and d.low < d.high for d in delays)
    return int(max(ends) / control_period + NEARLY), is_range or rest > NEARLY


def ranges_of(p: Plant, s: Settings) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Low, span and index (A, R) of the `Ranges` of the A alternatives of a plant."""
    ends = np.concatenate((np.zeros((1, p.uniforms)), np.eye(p.uniforms)[1:]))[:, 1:]
    # values of each alternative with all uniforms zero, then with each uniform in turn set to one
    corners = np.array(
        [[plant_values(plant.at_uniforms(q, iter(u)), s) for u in ends.tolist()] for q in p.alternatives], float
    )
    low = corners[:, 0]
    changed = corners[:, 1:] != low[:, None]
    index = np.where(changed.any(axis=1), changed.argmax(axis=1) + 1, 0) if p.uniforms > 1 else np.zeros(low.shape, int)
    high = np.take_along_axis(corners, index[:, None], axis=1)[:, 0]
    span = np.subtract(high, low, out=np.zeros(low.shape), where=index > 0)
    return low, span, index


def stack_ranges(plants: Sequence[Plant], s: Settings) -> Ranges:
    """Ranges of all plants."""
    groups = group_by_identity(plants)
    each = [ranges_of(p, s) for p, _ in groups]
    first, count = np.zeros(len(plants), int), np.zeros(len(plants), int)
    place = 0
    for (_, members), (low, _, _) in zip(groups, each):
        first[members], count[members] = place, len(low)
        place += len(low)
    low, span, index = (np.concatenate(parts) for parts in zip(*each))
    return Ranges(plant_rows(s), low, span, index, first, count)


def right_hand_side(plants: Sequence[Plant], is_general: bool) -> Callable:
    """Simplest right-hand side that covers all plants. Raises ValueError if only some are rigid bodies."""
    rigid = {q.rig is not None for p in plants for q in p.alternatives}
    if len(rigid) > 1:
        raise ValueError("plant: either all plants of a simulation have a rig, or none")
    if rigid.pop():
        return motion.general_rigid_body if is_general else motion.rigid_body_with_disturbances
    if is_general:
        is_coupled = any(q.coupling != NO_COUPLING for p in plants for q in p.alternatives)
        return motion.coupled_equation_3 if is_coupled else motion.general_equation_3
    return motion.equation_3 if all(p.is_plain for p in plants) else motion.equation_3_with_disturbances


class Simulation:
    """Simulation of N helicopters: arrays of their numbers, and compiled control steps.

    Args:
        plants: (N) plants, with or without ranges.
        references: (N) trajectories to track, or samplers that draw one for every flight.
        control_period: s.
        voltage_limits: of the amplifier, V.
        pitch_limit: rad, at which a flight ends.
        start_spread: rad, largest distance of each starting angle from the reference's.
        random_start: whether flights start at a random time of their reference, rather than at its start.
        dtype: of the arrays, np.float64 or np.float32.
        hover: V (2,) or (2, N), voltages of the action zero; by default those of Table I.
        threads: number of threads for a step; results do not depend on it.

    Raises:
        ValueError: if only some of the plants are rigid bodies.
    """

    def __init__(
        self,
        plants: Sequence[Plant],
        references: Sequence[Trajectory | Sampler],
        control_period: float,
        voltage_limits: tuple[float, float],
        pitch_limit: float,
        start_spread: float = 0.0,
        random_start: bool = False,
        dtype: type = np.float64,
        hover: np.ndarray | None = None,
        threads: int = 1,
    ) -> None:
        self.threads = threads
        self.plants, self.sources, self.dtype = list(plants), list(references), dtype
        self.control_period, self.voltage_limits, self.pitch_limit = control_period, voltage_limits, pitch_limit
        all_plants = [p for p, _ in group_by_identity(plants)]
        delays, are_fractional = zip(*(delay_periods(p, control_period) for p in all_plants))
        is_general = any(are_fractional) or any(p.is_general for p in all_plants)
        self.rhs = right_hand_side(all_plants, is_general)
        immediate = all(p.is_plain and p.rotors == Rotors() for p in all_plants)
        self.fly = motion.step_equation_3 if immediate else motion.step_plant
        if is_general:
            self.fly = motion.step_general
        stiffness = max(p.stiffness for p in all_plants)
        substep = min(SUBSTEP, STABLE / stiffness) if stiffness > 0.0 else SUBSTEP
        disturbances = max(map(count_disturbances, all_plants))
        curves = [curve for p in all_plants for q in p.alternatives for curve in measured_curves(q) if curve]
        settings = Settings(
            period=control_period,
            substeps=1 if self.rhs is motion.equation_3 else math.ceil(control_period / substep - 1e-9),
            u_low=voltage_limits[0],
            u_high=voltage_limits[1],
            pitch_limit=pitch_limit,
            disturbances=disturbances,
            pieces=max((len(cubic_pieces(curve)) for curve in curves), default=0),
            delay=max(delays),
            is_fractional=any(are_fractional),
            is_sensed=any(p.sensors is not None for p in all_plants),
            is_noisy=any(p.is_noisy for p in all_plants),
            start_spread=start_spread,
            random_start=random_start,
        )
        self.outputs = N_OUTPUTS_SENSED if settings.is_sensed else N_OUTPUTS  # rows
        self.ranges = stack_ranges(plants, settings)
        drawn = start_spread > 0.0 or random_start
        self.draws = [START_PLANT + p.uniforms if drawn or p.is_noisy or p.uniforms else 0 for p in plants]
        self.uniforms = np.zeros((len(plants), START_PLANT + max(p.uniforms for p in all_plants)))

        rows = count_rows(settings)
        self._check_memory(rows)
        self.initial = np.zeros((rows, len(plants)))  # of the blocks at the start of a flight, before the draw
        self.size = rows * ROW
        self.actions: np.ndarray = np.zeros((len(plants), 2), dtype)
        self.no_states, self.no_steps = np.empty((len(plants), 0)), np.full(len(plants), -1.0)
        self.references: list[Trajectory | None] = [None] * len(plants)  # of the current flights
        self.drawn: dict[int, Trajectory] = {}  # sampled references of the next flights
        self.initial[HOVER : HOVER + 2] = self._hover(hover)
        # one array, because passing each array from Python takes time
        parts = np.array(settings), np.zeros(-(-len(plants) // LANES) * self.size), self._table().reshape(-1)
        pad = np.zeros(SETTINGS - len(settings))
        self.memory: np.ndarray = np.concatenate((parts[0], pad, *parts[1:]), dtype=dtype)
        self._bind()

    def _check_memory(self, rows: int) -> None:
        """Raise ValueError if the arrays would take more than MOST_BYTES."""
        longest = {id(source): control_steps(source.duration, self.control_period) + 1 for source in self.sources}
        samplers = [id(source) for source in self.sources if not isinstance(source, Trajectory)]
        table = sum(longest[key] for key in {*longest} - {*samplers}) + sum(map(longest.__getitem__, samplers))
        size = 8 * (TABLE_COPIES * table * TABLE_WIDTH + BLOCK_COPIES * rows * len(self.plants))
        if size > MOST_BYTES:
            raise ValueError(
                f"num_envs = {len(self.plants)}, control_period = {self.control_period:g} s: references of "
                f"{table} steps and {rows} numbers for each helicopter take {size / 2**30:.1f} GB; "
                f"must be at most {MOST_BYTES / 2**30:g} GB"
            )

    def _table(self) -> np.ndarray:
        """Stack the references on the control grid, (K, TABLE_WIDTH), and store the first row of each helicopter.

        A shared reference is stored once; each sampler has rows for its longest reference, per helicopter.
        """
        parts, first = [], 0
        for source, followers in group_by_identity(self.sources):
            if isinstance(source, Trajectory):
                parts.append(reference_table(source, self.control_period).T)
                for j in followers:
                    self._follow(j, source)
                self.initial[REFERENCE_ROW, followers] = first
            else:
                count = control_steps(source.duration, self.control_period) + 1
                self.initial[REFERENCE_ROW, followers] = first + count * np.arange(len(followers))
                parts.append(np.zeros((count * len(followers), TABLE_WIDTH)))
            first += len(parts[-1])
        # a helicopter that waits for its reset is stepped once more, and reads one row past the end
        return np.concatenate((*parts, parts[-1][-1:]))

    def _hover(self, hover: np.ndarray | None) -> np.ndarray:
        """Voltages (2, 1) or (2, N) in V of the action zero."""
        if hover is None:
            hover = hover_voltage(HelicopterParameters(), self.voltage_limits)
        return np.reshape(hover, (2, -1))

    def _follow(self, j: int, reference: Trajectory) -> None:
        """Set start and end of the next flights of the helicopter j from this reference."""
        limits = reference.limits
        self.references[j] = reference
        self.initial[LAST, j] = control_steps(reference.duration, self.control_period)
        self.initial[COMMAND : COMMAND + 2, j] = reference.u[:, 0]
        self.initial[LIMITS : LIMITS + 4, j] = *limits.u, *limits.pitch

    def _bind(self) -> None:
        """Set the attributes that are not pickled: compiled functions, and views of the memory."""
        self.kernels, self.workers = kernels.kernels(self.dtype, self.rhs, self.fly), Workers(self.threads)
        end = SETTINGS + -(-len(self.plants) // LANES) * self.size
        self.settings, self.blocks, self.flat_table = np.split(self.memory, (SETTINGS, end))
        self.table = self.flat_table.reshape(-1, TABLE_WIDTH)

    def __getstate__(self) -> dict[str, Any]:
        bound = ("kernels", "settings", "blocks", "flat_table", "table", "workers")
        return {name: value for name, value in vars(self).items() if name not in bound}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._bind()

    def draw(self, j: int, rng: np.random.Generator) -> Trajectory:
        """Draw uniform numbers (if used) and reference of the next flight of the helicopter j; return the reference.

        Raises ValueError if a sampler draws no trajectory, or one beyond its bounds.
        """
        source = self.sources[j]
        if isinstance(source, Trajectory):
            reference = source
        else:
            reference = self.drawn[j] = self._validate(source, source(rng))
        if self.draws[j]:
            self.uniforms[j, : self.draws[j]] = rng.random(self.draws[j])
        return reference

    def _validate(self, source: Sampler, reference: Any) -> Trajectory:
        """Return a sampled reference. Raises ValueError unless it fits the table and the pitch limit."""
        if not isinstance(reference, Trajectory):
            raise ValueError(f"reference: {source!r} drew {reference!r}; must be a Trajectory")
        if reference.duration > source.duration:
            raise ValueError(
                f"reference: {source!r} drew one of {reference.duration:g} s, "
                f"and its `duration` is {source.duration:g} s"
            )
        steepest = float(np.abs(reference.x[4]).max())
        if steepest > self.pitch_limit:
            raise ValueError(
                f"reference: {source!r} drew one with a pitch of {steepest:g} rad; "
                f"must be at most {self.pitch_limit:g} rad"
            )
        return reference

    def reference_of(self, j: int) -> Trajectory:
        """Reference of the current flight of the helicopter j. Raises ResetNeeded before the first reset."""
        reference = self.references[j]
        if reference is None:
            raise ResetNeeded("no reference is drawn yet: call reset first")
        return reference

    def drawn_plant(self, j: int) -> Plant:
        """Plant of the current flight of the helicopter j."""
        p = self.plants[j]
        return p.at(self.uniforms[j, START_PLANT : START_PLANT + p.uniforms])

    def reset(self, helicopters: np.ndarray, states: np.ndarray | None = None, times: np.ndarray | None = None) -> None:
        """Start flights of the selected helicopters (n,).

        States (N, 6) and times (N,) of the references in s are optional; by default both come from the uniform numbers.
        """
        for j in helicopters.tolist() if self.drawn else ():
            if j in self.drawn:
                reference, first = self.drawn.pop(j), int(self.initial[REFERENCE_ROW, j])
                self._follow(j, reference)
                rows = reference_table(reference, self.control_period).T
                self.table[first : first + len(rows)] = rows
        steps = self.no_steps
        if times is not None:
            steps = np.clip(np.round(times / self.control_period), 0.0, self.initial[LAST] - 1.0)
        self.kernels.reset(
            self.blocks,
            self.settings,
            self.flat_table,
            self.initial,
            self.ranges,
            helicopters,
            self.uniforms,
            self.no_states if states is None else states,
            steps,
        )

    def arrays(self) -> tuple[np.ndarray, np.ndarray]:
        """New arrays for observations (N, OBSERVED) and outputs (self.outputs, N)."""
        n = len(self.plants)
        return np.empty((n, OBSERVED), np.float32), np.empty((self.outputs, n), self.dtype)

    def write_outputs(self, helicopters: np.ndarray, observation: np.ndarray, outputs: np.ndarray) -> None:
        """Write observations and outputs of the selected helicopters (n,) into the arrays."""
        self.kernels.write_outputs(
            self.blocks,
            self.settings,
            self.flat_table,
            helicopters,
            len(self.plants),
            self.size,
            observation.reshape(-1),
            outputs.reshape(-1),
        )

    def step(self, actions: np.ndarray) -> tuple[int, np.ndarray, np.ndarray]:
        """Fly a control step of all helicopters under actions (N, 2).

        Returns the number of ended flights, observations and outputs as from `arrays`. If an action is not finite, the
        number is NOT_FINITE and the simulation is unchanged.
        """
        observation, outputs = self.arrays()
        if self.dtype is np.float32 and actions.dtype != np.float32:
            with np.errstate(over="ignore"):  # the caller saturates actions that become infinite
                self.actions[:] = actions
        else:
            self.actions[:] = actions
        if not self.kernels.are_finite(self.actions):
            return kernels.NOT_FINITE, observation, outputs
        memory = self.blocks, self.settings, self.flat_table, self.actions, observation, outputs
        count = len(self.blocks) // self.size
        if self.threads == 1:
            return self.kernels.step(*memory, 0, count), observation, outputs
        return self.workers.run(partial(self.kernels.step, *memory), count), observation, outputs

    def rows(self, first: int, count: int) -> np.ndarray:
        """Rows of all helicopters, (count, N)."""
        part = self.blocks.reshape(-1, self.size // ROW, ROW)[:, first : first + count, :LANES]
        return part.transpose(1, 0, 2).reshape(count, len(part) * LANES)[:, : len(self.plants)]

    def record(self) -> SimpleNamespace:
        """Copy all quantities under the names of `layout`, (width, N) or (N,): record().state, record().lag, ...

        `pending` (D, 2, N) are the delayed voltages in V, the oldest first.
        """
        values = {name: self.rows(q.row, q.width) for name, q in QUANTITIES.items()}
        settings = shared(self.settings.tolist())
        delay = int(settings.delay)
        pending = self.rows(pending_rows(settings), 2 * delay).reshape(delay, 2, len(self.plants))
        return SimpleNamespace(
            **{name: rows if len(rows) > 1 else rows[0] for name, rows in values.items()}, pending=pending
        )


def group_by_identity(values: Sequence) -> list[tuple[Any, np.ndarray]]:
    """Distinct objects of a sequence, each with its indices."""
    places: dict[int, list[int]] = {}
    for place, value in enumerate(values):
        places.setdefault(id(value), []).append(place)
    return [(values[where[0]], np.array(where)) for where in places.values()]
