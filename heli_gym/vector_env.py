"""Heli3DOF-v0, many helicopters at once: what `gymnasium.make_vec` makes."""

import math
from collections.abc import Callable, Sequence
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.spaces import Box
from gymnasium.utils.seeding import np_random
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import ArrayLike

from heli_gym import task
from heli_gym.env import Heli3DOFEnv, find_reference, render_state
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP
from heli_gym.plant import Plant, find_plant
from heli_gym.rendering import Renderer
from heli_gym.simulation.kernels import (
    COMMAND,
    COST,
    MEASURED,
    NOT_FINITE,
    REWARD,
    SUCCEEDED,
    TERMINATED,
    TIME,
    TRUNCATED,
    X,
)
from heli_gym.simulation.simulation import Simulation
from heli_gym.trajectory import Sampler, Trajectory


class Heli3DOFVectorEnv(VectorEnv):
    """Many helicopters in one array; each flies what a `Heli3DOFEnv` with the same seed flies.

    Spaces, rewards, ends of episodes and arguments are those of `Heli3DOFEnv`, whose docstring describes them. Besides:

    Args:
        num_envs: how many helicopters.
        plant: one for all, or a sequence of one each; either all have a rig, or none.
        reference: one for all, or a sequence of one each. Where a sampler draws them, each helicopter has its own.
        autoreset_mode: "NextStep", "SameStep" or "Disabled", or gymnasium's `AutoresetMode`.
        dtype: of the simulation, "float64" or "float32"; the latter is faster for many helicopters, and accurate to
            about 1e-5 over a flight.

    `info["plant"]`, an object array, is there after a `reset` only; `plant_of` and `reference_of` tell at any time what
    a helicopter is and what it follows. `options["plant"]` of a `reset` flies another plant, in all helicopters and
    until the next `reset`. All arrays that are handed out are new.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "autoreset_mode": AutoresetMode.NEXT_STEP}  # noqa: RUF012

    def __init__(
        self,
        num_envs: int = 1,
        plant: str | Plant | Sequence[str | Plant] = "nominal",
        reference: str | Trajectory | Sampler | Sequence[str | Trajectory | Sampler] = "travel-360",
        control_period: float = 0.02,
        pitch_limit: float = PITCH_STOP,
        voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS,
        start_spread_deg: float = 0.0,
        random_start: bool = False,
        render_mode: str | None = None,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        dtype: str = "float64",
        **unknown: Any,
    ) -> None:
        if isinstance(num_envs, bool) or not isinstance(num_envs, int | np.integer) or num_envs < 1:
            raise ValueError(f"num_envs = {num_envs!r}: must be a positive whole number")
        num_envs = int(num_envs)
        if dtype not in ("float64", "float32"):
            raise ValueError(f"dtype = {dtype!r}: must be 'float64' or 'float32'")
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode = {render_mode!r}: must be None or 'rgb_array'")
        self.num_envs, self.render_mode, self.dtype = num_envs, render_mode, np.dtype(dtype).type
        modes = [mode.value for mode in AutoresetMode]
        if not isinstance(autoreset_mode, AutoresetMode) and autoreset_mode not in modes:
            raise ValueError(f"autoreset_mode = {autoreset_mode!r}: must be one of {modes}")
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        plants = broadcast_to_envs("plant", plant, num_envs, find_plant)
        references = broadcast_to_envs("reference", reference, num_envs, find_reference)

        # One environment for each combination checks the arguments and knows the bounds.
        combinations = {(id(p), id(r)): (p, r) for p, r in zip(plants, references)}
        singles = [
            Heli3DOFEnv(
                *combination, control_period, pitch_limit, voltage_limits, start_spread_deg, random_start, **unknown
            )
            for combination in combinations.values()
        ]
        single = singles[0]
        self.control_period, self.pitch_limit = single.control_period, single.pitch_limit
        self.voltage_limits = single.voltage_limits
        self.start_spread_deg, self.random_start = single.start_spread_deg, single.random_start
        self.metadata = {**single.metadata, **self.metadata, "autoreset_mode": self.autoreset_mode}
        bound = np.max([env.bound for env in singles], axis=0)
        self.single_observation_space = Box(-bound, bound, dtype=np.float32)
        self.single_action_space = single.action_space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)

        self.plants, self.references = plants, references
        self.own_simulation = self.simulation = self._simulation(plants)
        self.has_begun = False
        self.everyone = np.arange(num_envs)
        self.all = np.ones(num_envs, bool)
        self.all.setflags(write=False)
        self.is_waiting = False  # whether any flight is over
        self.generators = [np_random()[0] for _ in range(num_envs)]
        self.renderer: Renderer | None = None

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """To the starts of the references.

        Args:
            seed: of the first helicopter, the others counting on from there, or of each.
            options: "state" (6,) or (N, 6) and "plant" as for `Heli3DOFEnv.reset`; "time" (N,) in s, when on their
                references these flights start, and only these; "reset_mask" (N,), bool, tells which helicopters are
                meant.

        Raises:
            ValueError: for a bad seed or option.
        """
        options = dict(options or {})
        mask = options.pop("reset_mask", self.all)
        if not isinstance(mask, np.ndarray) or mask.dtype != bool or mask.shape != (self.num_envs,) or not mask.any():
            raise ValueError(
                f"options['reset_mask'] = {mask!r}: must be a boolean array ({self.num_envs},), at least one true"
            )
        unknown = set(options) - {"state", "plant", "time"}
        if unknown:
            raise ValueError(f"options = {options!r}: only 'state', 'plant', 'time' and 'reset_mask' are known")
        if (not self.has_begun or "plant" in options) and not mask.all():
            raise ValueError("options['reset_mask']: at the first reset, and where the plant changes, all are meant")
        if seed is None:
            seeds: list[int | None] = [None] * self.num_envs
        elif isinstance(seed, int | np.integer):
            seeds = [int(seed) + i for i in range(self.num_envs)]
        else:
            seeds = [None if one is None else int(one) for one in seed]
        if len(seeds) != self.num_envs:
            raise ValueError(f"seed = {seed!r}: must be a whole number, or one for each of {self.num_envs}")
        helicopters = np.flatnonzero(mask)
        times = None if options.get("time") is None else np.asarray(options["time"], float)
        if times is not None and not (times.shape == (self.num_envs,) and np.isfinite(times).all()):
            raise ValueError(f"options['time'] = {options['time']!r}: must be finite times ({self.num_envs},) in s")

        for i in helicopters.tolist():
            if seeds[i] is not None:
                self.generators[i] = np_random(seeds[i])[0]
        simulation, plant = self.simulation, options.get("plant")
        if mask.all():
            simulation = self.own_simulation if plant is None else self._simulation([find_plant(plant)] * self.num_envs)
        starts = [simulation.draw(i, self.generators[i]).x[:, 0] for i in helicopters.tolist()]
        states = self._states(options.get("state"), helicopters, np.array(starts))
        simulation.reset(helicopters, states, times)
        self.simulation = simulation
        if not self.has_begun or mask.all():
            self.over = np.zeros(self.num_envs, bool)
            self.has_begun = True
        observation, outputs = self.simulation.arrays()
        self.simulation.write_outputs(self.everyone, observation, outputs)
        self.over[helicopters] = False
        self.is_waiting = bool(self.over.any())
        info = self._info(outputs, mask.copy())
        info["plant"], info["_plant"] = np.full(self.num_envs, None, object), mask.copy()
        for i in helicopters.tolist():
            info["plant"][i] = self.plant_of(i)
        return observation, info

    def step(self, actions: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """One control period of all helicopters. Raises ValueError for actions that are not (N, 2) finite numbers."""
        if not self.has_begun:
            raise gym.error.ResetNeeded("call reset before step")
        if type(actions) is not np.ndarray or actions.dtype.char not in "fd":
            actions = np.asarray(actions, float)
        if actions.shape != (self.num_envs, 2):
            raise ValueError(f"actions have shape {actions.shape}: must be ({self.num_envs}, 2)")
        mode, waiting = self.autoreset_mode, self.over
        if mode is AutoresetMode.DISABLED and self.is_waiting:
            raise gym.error.ResetNeeded(f"the episodes {np.flatnonzero(waiting)} are over: reset them before step")
        count, observation, outputs = self.simulation.step(actions)
        if count == NOT_FINITE:
            bad = np.flatnonzero(~np.isfinite(actions.astype(self.dtype)).all(axis=1))
            raise ValueError(f"actions[{bad[0]}] = {actions[bad[0]]}: must be two finite numbers")

        flown = self.all
        if mode is AutoresetMode.NEXT_STEP and self.is_waiting:
            flown = ~waiting
            self._begin(np.flatnonzero(waiting), observation, outputs)
        rewards = np.asarray(outputs[REWARD], float)
        if count:
            terminated, truncated = outputs[TERMINATED] > 0.0, outputs[TRUNCATED] > 0.0
            self.over = terminated | truncated
            rewards = rewards.copy()  # the next flight may start before this is returned
        else:
            terminated, truncated, self.over = np.zeros((3, self.num_envs), bool)
        info = self._info(outputs, self.all)
        info["voltage"], info["cost"] = outputs[COMMAND : COMMAND + 2].T, outputs[COST]
        info["_voltage"] = info["_cost"] = flown
        self.is_waiting = count > 0 and bool(self.over.any())
        if self.is_waiting:
            self._end(info, observation, outputs)
        return observation, rewards, terminated, truncated, info

    def reference_of(self, i: int) -> Trajectory:
        """What the helicopter i is to follow in its flight."""
        return self.simulation.reference_of(i)

    def plant_of(self, i: int) -> Plant:
        """The plant that was drawn for the flight of the helicopter i."""
        if not self.has_begun:
            raise gym.error.ResetNeeded("nothing is drawn yet: call reset first")
        return self.simulation.drawn_plant(i)

    def render(self) -> tuple[np.ndarray, ...] | None:
        """A picture (720, 960, 3), uint8, of each helicopter. Raises DependencyNotInstalled without pygame."""
        if self.render_mode is None:
            gym.logger.warn("render: without a render mode nothing is drawn; make the environment with one")
            return None
        if not self.has_begun:
            raise gym.error.ResetNeeded("there is nothing to draw yet: call reset before render")
        if self.renderer is None:
            self.renderer = Renderer()
        return tuple(self.renderer.frame(render_state(self.simulation, j)) for j in range(self.num_envs))

    def close_extras(self, **kwargs: Any) -> None:
        """Frees what drawing took."""
        if self.renderer is not None:
            self.renderer.close()
            self.renderer = None

    def _simulation(self, plants: Sequence[Plant]) -> Simulation:
        return Simulation(
            plants,
            self.references,
            self.control_period,
            self.voltage_limits,
            self.pitch_limit,
            math.radians(self.start_spread_deg),
            self.random_start,
            self.dtype,
        )

    def _states(self, value: Any, helicopters: np.ndarray, starts: np.ndarray) -> np.ndarray | None:
        """The states (N, 6) that an option asks for, if it does; these helicopters' references start at (n, 6)."""
        if value is None:
            return None
        try:
            states = np.array(np.broadcast_to(np.asarray(value, float), (self.num_envs, 6)))
        except (TypeError, ValueError) as error:
            raise ValueError(
                f"options['state'] = {value!r}: must be finite numbers (6,) or ({self.num_envs}, 6)"
            ) from error
        near = (np.abs(states[helicopters] - starts) <= np.array(task.FARTHEST_START)).all()
        if not near or task.crashed(states[helicopters, 4], self.pitch_limit).any():
            raise ValueError(
                f"options['state'] = {value!r}: must be within 1 rad and 1 rad/s of the references' starts, and the "
                f"pitch within {self.pitch_limit:g} rad"
            )
        return states

    def _begin(self, helicopters: np.ndarray, observation: np.ndarray, outputs: np.ndarray) -> None:
        """New flights of these helicopters (n,), and what they observe and tell at first."""
        for i in helicopters.tolist():
            self.simulation.draw(i, self.generators[i])
        self.simulation.reset(helicopters)
        self.simulation.write_outputs(helicopters, observation, outputs)
        outputs[COMMAND : COMMAND + 2, helicopters] = 0.0  # nobody has asked for anything

    def _info(self, outputs: np.ndarray, mask: np.ndarray) -> dict[str, Any]:
        state = outputs[X : X + 6].T
        return {
            "state": state,
            "_state": mask,
            "measurement": outputs[MEASURED : MEASURED + 6].T if len(outputs) > MEASURED else state.copy(order="K"),
            "_measurement": mask,
            "time": outputs[TIME],
            "_time": mask,
        }

    def _end(self, info: dict[str, Any], observation: np.ndarray, outputs: np.ndarray) -> None:
        """Tells of flights that are over, and starts the next ones where that is the mode."""
        over, ended = self.over.copy(), np.flatnonzero(self.over)
        info["is_success"], info["_is_success"] = outputs[SUCCEEDED] > 0.0, over
        if self.autoreset_mode is not AutoresetMode.SAME_STEP:
            return
        final: dict[str, Any] = {}
        for name in ("state", "measurement", "time", "voltage", "cost", "is_success"):
            final[name], final[f"_{name}"] = np.zeros(info[name].shape, info[name].dtype), over
            final[name][ended] = info[name][ended]
        del info["is_success"], info["_is_success"]
        info["final_info"], info["_final_info"] = final, over
        info["final_obs"], info["_final_obs"] = np.full(self.num_envs, None, object), over
        for i in ended:
            info["final_obs"][i] = observation[i].copy()
        self._begin(ended, observation, outputs)
        info.update(self._info(outputs, self.all))
        info["_voltage"] = info["_cost"] = ~over
        self.over, self.is_waiting = np.zeros(self.num_envs, bool), False


def broadcast_to_envs(name: str, value: Any, count: int, find: Callable) -> list:
    """What `find` finds for each helicopter, given one value for all or a sequence of one each."""
    values = value if isinstance(value, list | tuple) else [value] * count
    if len(values) != count:
        raise ValueError(f"{name}: {len(values)} values; must be {count}, or one for all")
    found: dict[Any, Any] = {}
    for one in values:
        key = one if isinstance(one, str) else id(one)
        if key not in found:
            found[key] = find(one)
    return [found[one if isinstance(one, str) else id(one)] for one in values]
