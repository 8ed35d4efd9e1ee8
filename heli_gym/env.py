"""Heli3DOF-v0: one helicopter that tracks a reference."""

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from numbers import Real
from os import PathLike
from pathlib import Path
from typing import Any, overload

import gymnasium as gym
import numpy as np
from gymnasium.envs.registration import EnvSpec
from gymnasium.spaces import Box
from gymnasium.utils.seeding import np_random
from numpy.typing import ArrayLike

from heli_gym import task
from heli_gym.notebook import Picture
from heli_gym.on_rig import plant_on_rig, reference_on_rig, rig_to_fly
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import Plant, find_plant
from heli_gym.rendering import Renderer, RenderState
from heli_gym.rig import PAPER, Rig, find_rig, same_dynamics
from heli_gym.simulation.kernels import ARRIVED, CRASHED, ENDED_OFF_GOAL, FLYING, NOT_FINITE, one_step
from heli_gym.simulation.layout import COMMAND, LAST, MEASURED, N_OUTPUTS_SENSED, REFERENCE_ROW, STEP, TIME, X
from heli_gym.simulation.simulation import Simulation
from heli_gym.trajectory import Sampler, Trajectory
from heli_gym.validation import is_number, real_array, shown

ONLY = np.zeros(1, int)  # index of the only helicopter of its simulation
AT_THE_START = np.zeros(1)  # s, its time there
STATE, MEASUREMENT, VOLTAGE = (
    slice(X, X + 6),
    slice(MEASURED, MEASURED + 6),
    slice(COMMAND, COMMAND + 2),
)  # rows of the outputs
REFERENCES = Path(__file__).parent / "references"
LONGEST = 3600.0  # s, largest duration of a reference
LARGEST_VOLTAGE = 1000.0  # V, largest limit of an amplifier
PERIODS = (1e-4, 0.05)  # s, control periods; one Runge-Kutta step of 0.05 s through (3) is accurate to 1e-7


@overload
def find_reference(reference: str | Trajectory) -> Trajectory: ...
@overload
def find_reference(reference: str | Trajectory | Sampler) -> Trajectory | Sampler: ...
def find_reference(reference: str | Trajectory | Sampler) -> Trajectory | Sampler:
    """Return a reference by the name of a packaged one or the path of an .npz file, or the argument itself.

    Raises ValueError for an unknown name or a file that holds no trajectory.
    """
    if isinstance(reference, Trajectory):
        _check_duration(reference, reference)
        return reference
    if callable(reference):
        _number("reference.duration", getattr(reference, "duration", None), "s", 1e-3, LONGEST)
        return reference
    exists = isinstance(reference, str | PathLike)
    if exists:
        path = Path(reference) if str(reference).endswith(".npz") else REFERENCES / f"{reference}.npz"
        try:
            exists = path.is_file()
        except (OSError, ValueError):  # the name is no valid file name
            exists = False
    if not exists:
        names = ", ".join(sorted(repr(known.stem) for known in REFERENCES.glob("*.npz")))
        raise ValueError(
            f"reference = {shown(reference)}: must be a Trajectory, a sampler, the path of an existing .npz file or "
            f"one of {names}"
        )
    try:
        trajectory = Trajectory.load(path)
    except ValueError as error:
        raise ValueError(f"reference = {reference!r}: {error}") from error
    _check_duration(reference, trajectory)
    return trajectory


def _check_duration(name: Any, reference: Trajectory) -> None:
    if reference.duration > LONGEST:
        raise ValueError(f"reference = {shown(name)}: must take at most {LONGEST:g} s, not {reference.duration:g} s")


def is_packaged(reference: object) -> bool:
    """Whether a reference is the name of a packaged one."""
    return isinstance(reference, str) and not reference.endswith(".npz")


def reference_for(reference: str | Trajectory, rig: str | Rig, force: bool = False) -> Trajectory:
    """Return a reference, by its name or file, for a rig; a packaged one is planned again if the rig cannot fly it.

    Raises ValueError for a plan for another rig, unless `force` relabels it as one for this rig.
    """
    rig, found = find_rig(rig), find_reference(reference)
    if force and not is_packaged(reference) and not same_dynamics(found.rig, rig):
        return replace(found, rig=rig)
    return reference_on_rig(found, rig, is_packaged(reference))


class Heli3DOFEnv(gym.Env):
    """
    ## Description

    A laboratory helicopter with three degrees of freedom: an arm that turns about a vertical axis (travel) and a
    horizontal one (elevation) carries a counterweight at one end and, at the other, a body with two fans that turns
    about the arm (pitch). Pitch tilts the thrust and so drives the travel: three angles, two voltages, an
    underactuated system. The task is to track a reference, by default the 360 degree travel rotation in 10 s of
    Kiefer, Graichen and Kugi, "Trajectory tracking of a 3DOF laboratory helicopter under input and state
    constraints" (IEEE Transactions on Control Systems Technology 18(4), 2010), planned within 1 to 11 V and
    50 degrees of pitch. Equation numbers are the paper's.

    Four plants:

    | Plant     | Model                                                                                     |
    |-----------|-------------------------------------------------------------------------------------------|
    | `nominal` | exactly (3) with the thrust map (2)                                                       |
    | `lab`     | (3) with rotor lag, friction, thrust loss, one period of delay, encoders, estimated rates |
    | `rigid`   | the full rigid body in one of two variants, with the same actuators, friction and sensors |
    | `fleet`   | rigs from 15 measured flights, with their thrust maps, delays, sensor zeros and a table   |

    Every episode draws the parameters of `lab`, `rigid` and `fleet`; the ranges of the first two are from published
    models and data of this kind of rig. The exception is travel damping, published from 0.017 to 0.48 1/s but drawn up
    to 0.20: at the largest travel rate of the paper's plan, a tilt of 50 degrees balances 0.34 1/s at the plan's
    elevation and 0.30 1/s level, and from 0.25 1/s on, tracking the plan exceeds the amplifier's 12 V. The integrator
    is Runge-Kutta of order four: one step per control period on `nominal`, steps of at most 10 ms on the others.

    ## Action Space

    A `Box(-1, 1, (2,), float32)`: the scaled voltages of the two fans. Action 0 is the voltage at which the rig hovers
    with its arm level, -1 and 1 are the amplifier's limits; the voltage is linear from -1 to 0 and from 0 to 1. Actions
    outside saturate. An action that is not two finite real numbers raises `ValueError`. The methods `to_voltage` and
    `to_action` convert.

    | Num | Action           | Min | Max | Voltage at -1 | Voltage at 0 | Voltage at 1 |
    |-----|------------------|-----|-----|---------------|--------------|--------------|
    | 0   | front fan, `u_f` | -1  | 1   | 0 V           | 7.893 V      | 12 V         |
    | 1   | back fan, `u_b`  | -1  | 1   | 0 V           | 7.893 V      | 12 V         |

    The hover voltage is that of the argument `rig`, or of a plant with its own coefficients. If it is closer to a limit
    of the amplifier than a twentieth of the range, action 0 is the middle of the range.

    ## Observation Space

    A `Box` of 48 float32 values, the same for every plant, reference, control period and limit: the measured tracking
    error, the last voltages, then the reference and its nominal voltages now and 0.1, 0.2, 0.4 and 0.8 s ahead, and the
    remaining time, each in the unit of the table. On the nominal plant, the task is then a Markov decision process.
    Entries saturate at 10 units, far beyond a useful flight: at 10 rad of travel error, for example, or 5 rad/s of
    elevation rate. All entries are within -10 and 10, the remaining time within 0 and 10.

    | Num    | Observation                                                        | Unit       |
    |--------|--------------------------------------------------------------------|------------|
    | 0      | travel minus reference                                             | 1 rad      |
    | 1      | travel rate minus reference                                        | 1 rad/s    |
    | 2      | elevation minus reference (positive is down)                       | 0.25 rad   |
    | 3      | elevation rate minus reference                                     | 0.5 rad/s  |
    | 4      | pitch minus reference                                              | 0.5 rad    |
    | 5      | pitch rate minus reference                                         | 2 rad/s    |
    | 6-7    | last voltages (front, back), minus 6 V                             | 6 V        |
    | 8-12   | reference state now, without the travel, in the order of 1-5       | as 1-5     |
    | 13-14  | nominal voltages (front, back) in the coming period, minus 6 V     | 6 V        |
    | 15     | travel of the reference from now to 0.1 s ahead                    | 1 rad      |
    | 16-22  | the same as 8-14, 0.1 s ahead                                      | as 8-14    |
    | 23-30  | the same as 15-22, 0.2 s ahead                                     | as 15-22   |
    | 31-38  | the same, 0.4 s ahead                                              | as 15-22   |
    | 39-46  | the same, 0.8 s ahead                                              | as 15-22   |
    | 47     | remaining time                                                     | 10 s       |

    `info["state"]` is the true state (44), `info["measurement"]` the measured state, for controllers (on the nominal
    plant the true one), `info["time"]` the time in s, `info["voltage"]` the voltages commanded in the last period,
    within the amplifier's limits, and `info["cost"]` the excess of voltages and pitch over the limits of the
    reference's plan, in limit widths times seconds; voltage and cost are zero after a reset. The keys are always the
    same, and the values are numbers. The attribute `drawn_plant` is the plant of the episode, for analysis only.

    ## Rewards

    `control_period / (1 + e² + d²)` per step, where `e²` is the sum of the squared tracking errors, each in units of
    its tolerance, and `d²` the sum of the squared voltage deviations from the nominal ones, in units of half the
    amplifier's range, 6 V on the paper's rig. The tolerances are 3 degrees in travel and elevation, 6 degrees in
    pitch, and 6, 6 and 30 degrees/s in the rates. A return thus counts seconds flown on the reference, 10 at best;
    continuing a flight always increases it.

    ## Starting State

    The start of the reference, at rest except for `elevation-sine`. With `start_spread_deg`, each of the three angles
    is drawn uniformly within that distance of it, and the pitch within its limit. With `random_start`, the episode
    starts at a random time of the maneuver, in the reference's state there, and flies the rest of the maneuver.
    `reset(options={"state": x})` starts the maneuver in the state x (6,), within 1 rad and 1 rad/s of its start;
    `reset(options={"plant": plant})` flies another plant in this episode.

    ## Episode End

    Terminated when the pitch leaves `±pitch_limit`. Elevation has no limit that ends a flight; only a plant with a
    table stops the arm. Truncated at the end of the maneuver; `spec.max_episode_steps` is its number of control
    periods. `info["is_success"]` is true in the last step of a maneuver flown to its end if the true state is within
    the tolerances of Rewards, angles and rates alike, and false in all other steps.

    Success includes the reference's pitch, which suits a reference that ends at rest. "elevation-sine" ends in motion:
    travel damping then takes up to 8 degrees more tilt than the reference on `lab`, and more than the tolerance of 6
    degrees on a quarter of its draws. A policy that tracks the travel to the end succeeds on about half of the draws;
    for more, it must give up the travel shortly before the end.

    ## Arguments

    - `plant`: "nominal", "lab", "rigid", "fleet", or a `heli_gym.plant.Plant`, which may combine friction, rotors,
      sensors, thrust maps, a table, pushes, gusts, a moving mass, rotor faults and drift.
    - `reference`: the name of a packaged reference ("back-60-descend", "climb-15", "climb-7.5", "descend-7.5",
      "elevation-sine", "return-180", "take-off", "travel-180", "travel-360-slow", "travel-360", "travel-90-climb"), the
      path of an .npz file from `Trajectory.save`, a `Trajectory`, or a sampler, which draws one for every episode: a
      callable of the episode's random generator with an attribute `duration`, the longest one in s, for example
      `baselines.ManeuverSampler`. The attribute `reference` is the reference of the current episode.
    - `control_period`: seconds between actions, 0.0001 to 0.05. The paper's is 0.001.
    - `pitch_limit`: rad, where the flight ends; the rig's by default.
    - `voltage_limits`: V, the amplifier's (min, max); the rig's by default.
    - `start_spread_deg`: degrees, see Starting State.
    - `random_start`: whether episodes start at a random time of the maneuver, rather than at its start.
    - `render_mode`: "human" for a window, in real time; "rgb_array" for pictures. Both need `heli-gym[render]`.
    - `rig`: "paper" (the default, except for the plant "fleet"), "fleet", "quanser", "ntnu", the path of a .toml file,
      or a `heli_gym.Rig`. Plants without their own coefficients and thrust map take those of the rig. A packaged
      reference is planned again for a rig that cannot fly it; a plan for another rig raises `ValueError`.

    Arguments are plain values, so that a spec survives JSON, or objects. An invalid value raises a `ValueError` that
    names the argument, an unknown argument a `TypeError`.

    ## Version History

    - v0: first version. Before the first release, the observation space depended on the arguments, with 49 entries in
      rad, rad/s, V and s, and action 0 was the middle of the amplifier's limits; older models must be trained again.
    """

    metadata: dict[str, Any] = {"render_modes": ["human", "rgb_array"], "render_fps": 50}  # noqa: RUF012

    def __init__(
        self,
        plant: str | Plant = "nominal",
        reference: str | Trajectory | Sampler = "travel-360",
        control_period: float = 0.02,
        pitch_limit: float | None = None,
        voltage_limits: tuple[float, float] | None = None,
        start_spread_deg: float = 0.0,
        random_start: bool = False,
        render_mode: str | None = None,
        rig: str | Rig | None = None,
    ) -> None:
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode = {shown(render_mode)}: must be None, 'human' or 'rgb_array'")
        self.render_mode = render_mode
        self.renderer: Renderer | None = None
        self.plant, self.source = find_plant(plant), find_reference(reference)
        self.rig = rig_to_fly(rig, self.plant, self.source)
        self.plant = plant_on_rig(self.plant, self.rig)
        self.source = reference_on_rig(self.source, self.rig, is_packaged(reference))
        self.control_period = _number("control_period", control_period, "s", *PERIODS)
        self.metadata = {**self.metadata, "render_fps": round(1.0 / self.control_period)}
        x = self.source.x if isinstance(self.source, Trajectory) else np.zeros((6, 1))
        steepest = float(np.abs(x[4]).max())
        stop = self.rig.pitch_limit if pitch_limit is None else pitch_limit
        self.pitch_limit = _number("pitch_limit", stop, "rad", steepest, np.pi / 2)
        self.voltage_limits = _pair(
            "voltage_limits", self.rig.voltage_limits if voltage_limits is None else voltage_limits
        )
        room = np.degrees(min(self.pitch_limit - abs(x[4, 0]), task.FARTHEST_START[0]))
        self.start_spread_deg = _number("start_spread_deg", start_spread_deg, "deg", 0.0, room)

        if not isinstance(random_start, bool | np.bool_):
            raise ValueError(f"random_start = {shown(random_start)}: must be True or False")
        self.random_start = bool(random_start)
        self.hover_voltage = hover_voltage(self.plant, self.rig, self.voltage_limits)
        self.own_simulation = self.simulation = self._simulation(self.plant)
        low, high = task.observation_bounds()
        self.observation_space = Box(low.astype(np.float32), high.astype(np.float32), dtype=np.float32)
        self.action_space = Box(-1.0, 1.0, (2,), dtype=np.float32)
        self.over = True
        self._spec: EnvSpec | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Start an episode; see Starting State for the options.

        Raises ValueError for an invalid seed or option; the environment is then unchanged.
        """
        options = checked_options(options, ("state", "plant"))
        generator, own_seed = (self.np_random, self.np_random_seed) if seed is None else seeded(seed)
        plant = self.plant if options["plant"] is None else plant_on_rig(options["plant"], self.rig)
        simulation = self.own_simulation if plant is self.plant else self._simulation(plant)
        with undone_on_error(simulation, [generator]):
            state = self._start(options["state"], simulation.draw(0, generator))
        self._np_random, self._np_random_seed = generator, own_seed
        simulation.reset(ONLY, state, None if state is None else AT_THE_START)
        self.drawn_plant = simulation.drawn_plant(0)
        self.simulation, self.memory = simulation, simulation.memory
        self.step_one = one_step(simulation.rhs, simulation.fly)
        self.over = False
        observation, outputs = simulation.arrays()
        simulation.write_outputs(ONLY, observation, outputs)
        if self.render_mode == "human":
            self.render()
        is_sensed = simulation.outputs == N_OUTPUTS_SENSED
        return observation[0], {
            "state": outputs[STATE, 0],
            "measurement": outputs[MEASUREMENT if is_sensed else STATE, 0].copy(),
            "time": float(outputs[TIME, 0]),
            "voltage": np.zeros(2),
            "cost": 0.0,
            "is_success": False,
        }

    def step(self, action: ArrayLike) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Fly one control period with constant voltages.

        Raises ValueError for an action that is not two finite real numbers; the environment is then unchanged.
        """
        if self.over:
            raise gym.error.ResetNeeded("the episode is over: call reset before step")
        # Array handling in Python dominates the run time, not the flight: run benchmarks/ before adding an array.
        observation, outputs = np.empty(task.OBSERVED, np.float32), np.empty(N_OUTPUTS_SENSED)
        try:
            front, back = action.tolist() if action.dtype.char in "fd" else two_numbers(action)  # type: ignore[union-attr]
            time, reward, cost, over = self.step_one(self.memory, front, back, observation, outputs)
        except (AttributeError, TypeError, ValueError):  # not an array of two numbers
            time, reward, cost, over = self.step_one(self.memory, *two_numbers(action), observation, outputs)
        if over == NOT_FINITE:
            raise ValueError(f"action = {shown(action)}: must be two finite real numbers")
        info = {
            "state": outputs[STATE],
            "measurement": outputs[MEASUREMENT],
            "time": time,
            "voltage": outputs[VOLTAGE],
            "cost": cost,
            "is_success": over == ARRIVED,
        }
        if over != FLYING:
            self.over = True
        if self.render_mode == "human":
            self.render()
        return observation, reward, over == CRASHED, over >= ENDED_OFF_GOAL, info

    @property
    def reference(self) -> Trajectory:
        """Trajectory to track in this episode."""
        return self.simulation.reference_of(0)

    @property
    def spec(self) -> EnvSpec | None:  # type: ignore[override]
        """Specification; `max_episode_steps` is the number of control periods of the (longest) maneuver."""
        return self._spec

    @spec.setter
    def spec(self, value: EnvSpec | None) -> None:
        self._spec = with_episode_steps(value, task.control_steps(self.source.duration, self.control_period))

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "renderer": None}  # a window cannot be copied; `render` opens a new one

    def to_voltage(self, action: ArrayLike) -> np.ndarray:
        """Convert an action (2,) to voltages (2,) in V."""
        return task.to_voltage(_reals("action", action), self.voltage_limits, self.hover_voltage)

    def to_action(self, u: ArrayLike) -> np.ndarray:
        """Convert voltages (2,) in V to an action (2,): the inverse of `to_voltage`."""
        return task.to_action(_reals("u", u), self.voltage_limits, self.hover_voltage)

    def render(self) -> np.ndarray | None:
        """Draw the helicopter: return a picture (720, 960, 3), uint8, or draw in a window and return None.

        Raises gymnasium.error.DependencyNotInstalled without pygame.
        """
        if self.render_mode is None:
            gym.logger.warn("render: without a render mode nothing is drawn; make the environment with one")
            return None
        if not hasattr(self, "step_one"):
            raise gym.error.ResetNeeded("there is nothing to draw yet: call reset before render")
        if self.renderer is None:
            self.renderer = Renderer()
        scene = render_state(self.simulation, 0, self.rig)
        if self.render_mode == "rgb_array":
            return self.renderer.frame(scene).view(Picture)
        self.renderer.show(scene)
        return None

    def close(self) -> None:
        """Close the window, if there is one."""
        if self.renderer is not None:
            self.renderer.close()
            self.renderer = None

    def _simulation(self, plant: Plant) -> Simulation:
        """Simulation of one helicopter of this plant."""
        return Simulation(
            [plant],
            [self.source],
            self.control_period,
            self.voltage_limits,
            self.pitch_limit,
            math.radians(self.start_spread_deg),
            self.random_start,
            hover=self.hover_voltage,
        )

    def _start(self, value: Any, reference: Trajectory) -> np.ndarray | None:
        """Starting state (1, 6) from the option "state"; None without it."""
        if value is None:
            return None
        nominal, state = reference.x[:, 0], _numbers(value, 6)
        near = state is not None and (abs(state - nominal) <= task.FARTHEST_START).all()
        if state is None or not near or task.crashed(state[4], self.pitch_limit):
            raise ValueError(
                f"options['state'] = {shown(value)}: must be six finite numbers, within 1 rad and 1 rad/s of the "
                f"reference's start {nominal} and with the pitch within {self.pitch_limit:g} rad"
            )
        return np.array([state])


def hover_voltage(plant: Plant, rig: Rig, voltage_limits: tuple[float, float]) -> np.ndarray:
    """Voltages (2,) in V of the action zero: hover of the rig, or of a plant with its own coefficients."""
    if same_dynamics(rig, PAPER):
        return task.hover_voltage(design_parameters(plant), voltage_limits)
    return task.within_limits(rig.hover_voltage(), voltage_limits)


def design_parameters(plant: Plant) -> HelicopterParameters:
    """Parameters for the scaling of actions: the plant's unless episodes draw them, else Table I."""
    numbers = plant.parameters
    if not isinstance(numbers, HelicopterParameters):
        return HelicopterParameters()
    return numbers if all(isinstance(number, Real) for number in numbers) else HelicopterParameters()


class SeedError(gym.error.Error, ValueError):
    """Invalid seed; both Gymnasium's error and a ValueError."""


def seeded(seed: Any) -> tuple[np.random.Generator, int]:
    """Return a new random generator and its seed. Raises SeedError unless the seed is a non-negative integer."""
    try:
        return np_random(int(seed) if isinstance(seed, np.integer) else seed)
    except gym.error.Error as error:
        raise SeedError(f"seed = {shown(seed)}: must be a whole number, at least 0") from error


def checked_options(options: Any, names: Sequence[str]) -> dict[str, Any]:
    """Options of a reset by name, None for missing ones. Raises ValueError for an unknown option."""
    if options is not None and not isinstance(options, Mapping):
        raise ValueError(f"options = {shown(options)}: must be a dictionary")
    given = dict(options or {})
    if not set(given) <= set(names):
        raise ValueError(f"options = {shown(options)}: must be among {', '.join(map(repr, names))}")
    return dict.fromkeys(names) | given


@contextmanager
def undone_on_error(simulation: Simulation, generators: Sequence[np.random.Generator]) -> Iterator[None]:
    """Restore generators and drawn references if the block raises, so that a failed reset changes nothing."""
    drawn, uniforms = dict(simulation.drawn), simulation.uniforms.copy()
    states = [generator.bit_generator.state for generator in generators]
    try:
        yield
    except BaseException:
        simulation.drawn, simulation.uniforms[:] = drawn, uniforms
        for generator, state in zip(generators, states):
            generator.bit_generator.state = state
        raise


def with_episode_steps(spec: EnvSpec | None, steps: int) -> EnvSpec | None:
    """Specification with `max_episode_steps` filled in if it is missing."""
    return spec if spec is None or spec.max_episode_steps is not None else replace(spec, max_episode_steps=steps)


def render_state(simulation: Simulation, j: int, rig: Rig) -> RenderState:
    """State, reference, limits and annotations of the helicopter j of a rig, for the renderer."""
    step, last, first = (int(simulation.rows(row, 1)[0, j]) for row in (STEP, LAST, REFERENCE_ROW))
    reference = simulation.reference_of(j)
    return RenderState(
        state=tuple(simulation.rows(X, 6)[:, j].tolist()),
        voltage=tuple(simulation.rows(COMMAND, 2)[:, j].tolist()),
        reference=tuple(simulation.table[first + step, :6].tolist()),
        nominal_voltage=tuple(simulation.table[first + max(step - 1, 0), 6:8].tolist()),
        time=step * simulation.control_period,
        duration=last * simulation.control_period,
        travel_start=float(simulation.table[first, 0]),
        limits=reference.limits,
        voltage_limits=simulation.voltage_limits,
        pitch_limit=simulation.pitch_limit,
        rig=rig,
    )


def two_numbers(action: Any) -> list[float]:
    """Convert an action to two floats. Raises ValueError if it is anything else."""
    values = _numbers(action, 2)
    if values is None:
        raise ValueError(f"action = {shown(action)}: must be two finite real numbers")
    return values


def _numbers(values: Any, count: int) -> list[float] | None:
    """Convert values to `count` finite floats; None if they are anything else."""
    array = real_array(values)
    if array is None or array.shape != (count,):
        return None
    numbers = array.tolist()
    return numbers if all(map(math.isfinite, numbers)) else None


def _reals(name: str, values: Any) -> np.ndarray:
    """Convert values to an array of floats. Raises ValueError unless they are real numbers."""
    array = real_array(values)
    if array is None:
        raise ValueError(f"{name} = {shown(values)}: must be real numbers")
    return array


def _number(name: str, value: Any, unit: str, low: float, high: float) -> float:
    """Return the value as a float. Raises ValueError unless it is a number in [low, high]."""
    if not is_number(value) or not low <= value <= high:
        raise ValueError(f"{name} = {shown(value)}: must be at least {low:g} and at most {high:g} {unit}")
    return float(value)


def _pair(name: str, value: Any) -> tuple[float, float]:
    numbers = _numbers(value, 2)
    if numbers is None or not -LARGEST_VOLTAGE <= numbers[0] < numbers[1] <= LARGEST_VOLTAGE:
        raise ValueError(
            f"{name} = {shown(value)}: must be (min, max) in V with min < max, within {LARGEST_VOLTAGE:g} V of zero"
        )
    return numbers[0], numbers[1]
