"""Vector version of Heli3DOF-v0, as `gymnasium.make_vec` creates it."""

import math
from collections.abc import Callable, Sequence
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.envs.registration import EnvSpec
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import ArrayLike

from heli_gym import task
from heli_gym.env import (
    Heli3DOFEnv,
    SeedError,
    checked_options,
    find_reference,
    is_packaged,
    render_state,
    seeded,
    undone_on_error,
    with_episode_steps,
)
from heli_gym.on_rig import plant_on_rig, reference_on_rig, rig_to_fly
from heli_gym.plant import Plant, find_plant
from heli_gym.rendering import Renderer
from heli_gym.rig import Rig, same_dynamics
from heli_gym.simulation.kernels import NOT_FINITE
from heli_gym.simulation.layout import COMMAND, COST, MEASURED, REWARD, SUCCEEDED, TERMINATED, TIME, TRUNCATED, X
from heli_gym.simulation.simulation import Simulation
from heli_gym.trajectory import Sampler, Trajectory
from heli_gym.validation import real_array, shown

MOST_ENVS = 2**17  # helicopters, made in some 4 s
MOST_STEPS = 2**31  # of an episode
MOST_THREADS = 256


class Heli3DOFVectorEnv(VectorEnv):
    """Many helicopters in one array; each flight equals that of a `Heli3DOFEnv` with the same seed.

    Spaces, rewards, ends of episodes and arguments are those of `Heli3DOFEnv`; these are new or different:

    Args:
        num_envs: number of helicopters.
        plant: one for all, or a sequence with one for each; all or none of them must be rigid bodies.
        reference: one for all, or a sequence with one for each. A sampler draws a separate one for each helicopter.
        autoreset_mode: "NextStep", "SameStep" or "Disabled", or gymnasium's `AutoresetMode`.
        max_episode_steps: number of steps after which flights are truncated, if their maneuver is longer.
        dtype: of the simulation, "float64" or "float32", which is faster for many helicopters. In single precision,
            angles of open-loop flights differ by 3e-5 rad; with encoder feedback, whose counts then differ, by 0.01 rad
            in the median and at most 0.07 rad. Means over 100 flights agree to 0.01 degrees.
        threads: number of threads for a step; used where faster, from about a thousand helicopters on, on idle cores.
            Flights are bit-identical for any number of threads.

    `plant_of` and `reference_of` return the plant and the reference of a helicopter's episode. `options["plant"]` of
    `reset` sets another plant, one for all or one for each, until the next `reset`. All returned arrays are new.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "autoreset_mode": AutoresetMode.NEXT_STEP}  # noqa: RUF012

    def __init__(
        self,
        num_envs: int = 1,
        plant: str | Plant | Sequence[str | Plant] = "nominal",
        reference: str | Trajectory | Sampler | Sequence[str | Trajectory | Sampler] = "travel-360",
        control_period: float = 0.02,
        pitch_limit: float | None = None,
        voltage_limits: tuple[float, float] | None = None,
        start_spread_deg: float = 0.0,
        random_start: bool = False,
        render_mode: str | None = None,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        max_episode_steps: int | None = None,
        dtype: str = "float64",
        rig: str | Rig | None = None,
        threads: int = 1,
    ) -> None:
        num_envs, self.threads = _count("num_envs", num_envs, MOST_ENVS), _count("threads", threads, MOST_THREADS)
        self.max_steps = (
            None if max_episode_steps is None else _count("max_episode_steps", max_episode_steps, MOST_STEPS)
        )
        if dtype not in ("float64", "float32"):
            raise ValueError(f"dtype = {shown(dtype)}: must be 'float64' or 'float32'")
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ValueError(f"render_mode = {shown(render_mode)}: must be None or 'rgb_array'")
        self.num_envs, self.render_mode, self.dtype = num_envs, render_mode, np.dtype(dtype).type
        modes = [mode.value for mode in AutoresetMode]
        if not isinstance(autoreset_mode, AutoresetMode) and autoreset_mode not in modes:
            raise ValueError(f"autoreset_mode = {shown(autoreset_mode)}: must be one of {modes}")
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        plants = broadcast_to_envs("plant", plant, num_envs, find_plant)
        references = broadcast_to_envs("reference", reference, num_envs, find_reference)

        # One environment for each combination checks the arguments.
        named = broadcast_to_envs("reference", reference, num_envs, is_packaged)
        rigs = [rig_to_fly(rig, p, r) for p, r in zip(plants, references)]
        keys = [(id(r), n, own) for r, n, own in zip(references, named, rigs)]
        distinct = dict(zip(keys, references))
        tracked = {  # each planned again once
            (number, is_named, own): reference_on_rig(r, own, is_named)
            for (number, is_named, own), r in distinct.items()
        }
        references = [tracked[key] for key in keys]
        combinations = {(id(p), id(r)): (p, r, own) for p, r, own in zip(plants, references, rigs)}
        singles = {
            key: Heli3DOFEnv(p, r, control_period, pitch_limit, voltage_limits, start_spread_deg, random_start, rig=own)
            for key, (p, r, own) in combinations.items()
        }
        each = [singles[id(p), id(r)] for p, r in zip(plants, references)]
        plants, references = [env.plant for env in each], [env.source for env in each]
        single = each[0]
        for i, own in enumerate(each):
            limits = [(one.voltage_limits, one.pitch_limit) for one in (own, single)]
            if not same_dynamics(own.rig, single.rig) or limits[0] != limits[1]:
                raise ValueError(
                    f"plant, reference: the helicopters 0 and {i} have the rigs {single.rig.name!r} and "
                    f"{own.rig.name!r}: must be one, as their actions, limits and rewards are"
                )
        self.rig = single.rig
        self.control_period, self.pitch_limit = single.control_period, single.pitch_limit
        self.voltage_limits = single.voltage_limits
        self.start_spread_deg, self.random_start = single.start_spread_deg, single.random_start
        self.metadata = {**single.metadata, **self.metadata, "autoreset_mode": self.autoreset_mode}
        self.single_observation_space = single.observation_space
        self.single_action_space = single.action_space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)

        self.plants, self.references = plants, references
        self.hover_voltage = np.array([env.hover_voltage for env in each]).T  # (2, N), in V
        self.own_simulation = self.simulation = self._simulation(plants)
        self.has_begun = False
        self.everyone = np.arange(num_envs)
        self.all = np.ones(num_envs, bool)
        self.all.setflags(write=False)
        self.is_waiting = False  # whether any flight is over
        generators, seeds = zip(*(seeded(None) for _ in range(num_envs)))
        self.generators, self.seeds = list(generators), list(seeds)
        self.flown = np.zeros(num_envs, int)  # steps of the current flights, if their number is limited
        self.renderer: Renderer | None = None
        self._spec: EnvSpec | None = None

    def _on_rig(self, plant: str | Plant) -> Plant:
        return plant_on_rig(plant, self.rig)

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Start episodes of all helicopters, or of some.

        Args:
            seed: seed of the first helicopter, with consecutive seeds for the others, or a sequence of seeds.
            options: "state" (6,) or (N, 6), with NaN rows for default starts, and "plant", one for all or a sequence of
                N, as for `Heli3DOFEnv.reset`; "time" (N,) in s, the starting times of only these flights on their
                references, to which a given state must be near; "reset_mask" (N,), bool, selects the helicopters.

        Raises:
            ValueError: for an invalid seed or option; the environment is then unchanged.
            TypeError: for a mask that is not a boolean array.
        """
        known = checked_options(options, ("state", "plant", "time", "reset_mask"))
        mask = self._mask(known["reset_mask"], known["plant"] is not None)
        helicopters = np.flatnonzero(mask)
        chosen = helicopters.tolist()
        times = known["time"] if known["time"] is None else real_array(known["time"])
        if known["time"] is not None and (times is None or not self._are_finite(times, (self.num_envs,))):
            raise ValueError(f"options['time'] = {shown(known['time'])}: must be finite times ({self.num_envs},) in s")

        fresh = self._seeded(seed, chosen)
        generators = [fresh[i][0] if i in fresh else self.generators[i] for i in chosen]
        simulation = self.simulation
        if known["plant"] is not None:
            simulation = self._simulation(
                broadcast_to_envs("options['plant']", known["plant"], self.num_envs, self._on_rig)
            )
        elif mask.all():
            simulation = self.own_simulation
        # Only a given state or a sampled reference can turn out to be invalid after the draw.
        refusable = known["state"] is not None or not all(isinstance(one, Trajectory) for one in self.references)
        with undone_on_error(simulation, generators if refusable and not fresh else []):
            drawn = [simulation.draw(i, generator) for i, generator in zip(chosen, generators)]
            begin = np.zeros(self.num_envs) if times is None else times
            starts = [] if known["state"] is None else [one(begin[i])[0] for i, one in zip(chosen, drawn)]
            states = self._states(known["state"], helicopters, np.array(starts))
        for i, (generator, own_seed) in fresh.items():
            self.generators[i], self.seeds[i] = generator, own_seed
        if states is None:
            simulation.reset(helicopters, None, times)
        else:
            given = ~np.isnan(states[helicopters, 0])
            for part, values, at in ((helicopters[given], states, begin), (helicopters[~given], None, times)):
                simulation.reset(part, values, at)
        self.simulation = simulation
        if not self.has_begun or mask.all():
            self.over = np.zeros(self.num_envs, bool)
            self.has_begun = True
        observation, outputs = self.simulation.arrays()
        self.simulation.write_outputs(self.everyone, observation, outputs)
        outputs[COMMAND : COMMAND + 2, helicopters] = 0.0  # commanded by nobody
        self.over[helicopters], self.flown[helicopters] = False, 0
        self.is_waiting = bool(self.over.any())
        return observation, self._info(outputs, mask.copy(), np.zeros(self.num_envs, bool))

    def _mask(self, mask: Any, plant_changes: bool) -> np.ndarray:
        """Mask (N,) of the helicopters that a reset selects."""
        if mask is None:
            return self.all
        must = f"options['reset_mask'] = {shown(mask)}: must be a boolean array ({self.num_envs},), at least one true"
        if not isinstance(mask, np.ndarray) or mask.dtype != bool:
            raise TypeError(must)
        if mask.shape != (self.num_envs,) or not mask.any():
            raise ValueError(must)
        if (not self.has_begun or plant_changes) and not mask.all():
            raise ValueError("options['reset_mask']: must select all at the first reset, and where the plant changes")
        return mask

    def _seeded(self, seed: Any, chosen: list[int]) -> dict[int, tuple[np.random.Generator, int]]:
        """New generators and seeds of those chosen helicopters that have a seed, by index."""
        if seed is None:
            return {}
        if isinstance(seed, int | np.integer):
            seeded(seed)
            seeds: list[Any] = [int(seed) + i for i in range(self.num_envs)]
        elif isinstance(seed, list | tuple | np.ndarray):
            seeds = list(seed)
        else:
            raise SeedError(f"seed = {shown(seed)}: must be a whole number, or one for each of {self.num_envs}")
        if len(seeds) != self.num_envs:
            raise ValueError(f"seed = {shown(seed)}: must be a whole number, or one for each of {self.num_envs}")
        return {i: seeded(seeds[i]) for i in chosen if seeds[i] is not None}

    def step(self, actions: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Fly one control period of all helicopters.

        Raises ValueError for actions that are not (N, 2) finite real numbers; the environment is then unchanged.
        """
        if not self.has_begun:
            raise gym.error.ResetNeeded("call reset before step")
        if type(actions) is not np.ndarray or actions.dtype.char not in "fd":
            values = real_array(actions)
            if values is None:
                raise ValueError(f"actions = {shown(actions)}: must be ({self.num_envs}, 2) finite real numbers")
            actions = values
        if actions.shape != (self.num_envs, 2):
            raise ValueError(f"actions have shape {actions.shape}: must be ({self.num_envs}, 2)")
        mode, waiting = self.autoreset_mode, self.over
        if mode is AutoresetMode.DISABLED and self.is_waiting:
            raise gym.error.ResetNeeded(f"the episodes {np.flatnonzero(waiting)} are over: reset them before step")
        count, observation, outputs = self.simulation.step(actions)
        if count == NOT_FINITE and np.isfinite(actions).all():  # too large for single precision: they saturate
            count, observation, outputs = self.simulation.step(np.clip(actions, -1.0, 1.0))
        if count == NOT_FINITE:
            bad = np.flatnonzero(~np.isfinite(actions).all(axis=1))
            raise ValueError(f"actions[{bad[0]}] = {actions[bad[0]]}: must be two finite numbers")

        self.flown += 1
        if mode is AutoresetMode.NEXT_STEP and self.is_waiting:
            self._begin(np.flatnonzero(waiting), observation, outputs)
        if self.max_steps is not None and (late := self.flown >= self.max_steps).any():
            outputs[TRUNCATED, late] = 1.0 - outputs[TERMINATED, late]
            count += 1
        rewards = np.asarray(outputs[REWARD], float)
        if count:
            terminated, truncated = outputs[TERMINATED] > 0.0, outputs[TRUNCATED] > 0.0
            self.over, is_success = terminated | truncated, outputs[SUCCEEDED] > 0.0
            rewards = rewards.copy()  # the next flight may start before this is returned
        else:
            terminated, truncated, self.over, is_success = np.zeros((4, self.num_envs), bool)
        info = self._info(outputs, self.all, is_success)
        self.is_waiting = count > 0 and bool(self.over.any())
        if self.is_waiting:
            self._end(info, observation, outputs)
        return observation, rewards, terminated, truncated, info

    def to_voltage(self, actions: ArrayLike) -> np.ndarray:
        """Convert actions (N, 2) to voltages (N, 2) in V."""
        return task.to_voltage(np.asarray(actions, float), self.voltage_limits, self.hover_voltage.T)

    def to_action(self, u: ArrayLike) -> np.ndarray:
        """Convert voltages (N, 2) in V to actions (N, 2): the inverse of `to_voltage`."""
        return task.to_action(np.asarray(u, float), self.voltage_limits, self.hover_voltage.T)

    def reference_of(self, i: int) -> Trajectory:
        """Reference of the current episode of the helicopter i."""
        return self.simulation.reference_of(i)

    def plant_of(self, i: int) -> Plant:
        """Plant of the current episode of the helicopter i."""
        if not self.has_begun:
            raise gym.error.ResetNeeded("nothing is drawn yet: call reset first")
        return self.simulation.drawn_plant(i)

    def render(self) -> tuple[np.ndarray, ...] | None:
        """Pictures (720, 960, 3), uint8, one of each helicopter. Raises DependencyNotInstalled without pygame."""
        if self.render_mode is None:
            gym.logger.warn("render: without a render mode nothing is drawn; make the environment with one")
            return None
        if not self.has_begun:
            raise gym.error.ResetNeeded("there is nothing to draw yet: call reset before render")
        if self.renderer is None:
            self.renderer = Renderer()
        return tuple(self.renderer.frame(render_state(self.simulation, j, self.rig)) for j in range(self.num_envs))

    def close_extras(self, **kwargs: Any) -> None:
        """Free the renderer."""
        if self.renderer is not None:
            self.renderer.close()
            self.renderer = None

    @property  # type: ignore[override]
    def np_random(self) -> tuple[np.random.Generator, ...]:
        """Random generator of each helicopter."""
        return tuple(self.generators)

    @np_random.setter  # type: ignore[override]
    def np_random(self, value: Sequence[np.random.Generator]) -> None:
        generators = list(value) if isinstance(value, list | tuple) else []
        if len(generators) != self.num_envs or not all(isinstance(one, np.random.Generator) for one in generators):
            raise ValueError(f"np_random = {shown(value)}: must be {self.num_envs} random generators")
        self.generators, self.seeds = generators, [-1] * self.num_envs

    @property
    def np_random_seed(self) -> tuple[int, ...]:  # type: ignore[override]
        """Seed of each helicopter's random generator; -1 where it is unknown."""
        return tuple(self.seeds)

    @property
    def spec(self) -> EnvSpec | None:  # type: ignore[override]
        """Specification; `max_episode_steps` is the number of control periods of the longest maneuver."""
        return self._spec

    @spec.setter
    def spec(self, value: EnvSpec | None) -> None:
        longest = max(task.control_steps(reference.duration, self.control_period) for reference in self.references)
        self._spec = with_episode_steps(value, longest if self.max_steps is None else min(longest, self.max_steps))

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "renderer": None}

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
            self.hover_voltage,
            self.threads,
        )

    @staticmethod
    def _are_finite(array: np.ndarray, shape: tuple[int, ...]) -> bool:
        return array.shape == shape and bool(np.isfinite(array).all())

    def _states(self, value: Any, helicopters: np.ndarray, starts: np.ndarray) -> np.ndarray | None:
        """States (N, 6) from the option "state",  NaN rows for default starts; `starts` (n, 6) are the references'."""
        if value is None:
            return None
        array = real_array(value)
        if array is None or array.shape not in ((6,), (self.num_envs, 6)):
            raise ValueError(f"options['state'] = {shown(value)}: must be finite numbers (6,) or ({self.num_envs}, 6)")
        states = np.array(np.broadcast_to(array, (self.num_envs, 6)))
        own = states[helicopters]
        own = np.where(np.isnan(own).all(axis=1)[:, None] & (array.ndim == 2), starts, own)
        near = (np.abs(own - starts) <= np.array(task.FARTHEST_START)).all()
        if not near or task.crashed(own[:, 4], self.pitch_limit).any():
            raise ValueError(
                f"options['state'] = {shown(value)}: must be within 1 rad and 1 rad/s of the references at the start, "
                f"and the pitch within {self.pitch_limit:g} rad"
            )
        return states

    def _begin(self, helicopters: np.ndarray, observation: np.ndarray, outputs: np.ndarray) -> None:
        """Start new flights of these helicopters (n,), and write their first observations and outputs."""
        for i in helicopters.tolist():
            self.simulation.draw(i, self.generators[i])
        self.simulation.reset(helicopters)
        self.simulation.write_outputs(helicopters, observation, outputs)
        outputs[COMMAND : COMMAND + 2, helicopters] = 0.0  # commanded by nobody
        self.flown[helicopters] = 0

    def _info(self, outputs: np.ndarray, mask: np.ndarray, is_success: np.ndarray) -> dict[str, Any]:
        state = outputs[X : X + 6].T
        return {
            "state": state,
            "_state": mask,
            "measurement": outputs[MEASURED : MEASURED + 6].T if len(outputs) > MEASURED else state.copy(order="K"),
            "_measurement": mask,
            "time": outputs[TIME],
            "_time": mask,
            "voltage": outputs[COMMAND : COMMAND + 2].T,
            "_voltage": mask,
            "cost": outputs[COST],
            "_cost": mask,
            "is_success": is_success,
            "_is_success": mask,
        }

    def _end(self, info: dict[str, Any], observation: np.ndarray, outputs: np.ndarray) -> None:
        """In the mode SameStep, add the final infos and observations of ended flights, and start the next flights."""
        over, ended = self.over.copy(), np.flatnonzero(self.over)
        if self.autoreset_mode is not AutoresetMode.SAME_STEP:
            return
        final: dict[str, Any] = {}
        for name in ("state", "measurement", "time", "voltage", "cost", "is_success"):
            final[name], final[f"_{name}"] = np.zeros(info[name].shape, info[name].dtype), over
            final[name][ended] = info[name][ended]
        info["final_info"], info["_final_info"] = final, over
        info["final_obs"], info["_final_obs"] = np.full(self.num_envs, None, object), over
        for i in ended:
            info["final_obs"][i] = observation[i].copy()
        self._begin(ended, observation, outputs)
        info.update(self._info(outputs, self.all, np.zeros(self.num_envs, bool)))
        self.over, self.is_waiting = np.zeros(self.num_envs, bool), False


def _count(name: str, value: Any, most: int) -> int:
    """Return the value. Raises ValueError unless it is an integer from 1 to `most`."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not 1 <= value <= most:
        raise ValueError(f"{name} = {shown(value)}: must be a positive whole number, at most {most}")
    return int(value)


def broadcast_to_envs(name: str, value: Any, count: int, find: Callable) -> list:
    """Apply `find` to the value of each helicopter, given one value for all or a sequence with one for each."""
    values = value if isinstance(value, list | tuple) else [value] * count
    if len(values) != count:
        raise ValueError(f"{name}: {len(values)} values; must be {count}, or one for all")
    found: dict[Any, Any] = {}
    for one in values:
        key = one if isinstance(one, str) else id(one)
        if key not in found:
            found[key] = find(one)
    return [found[one if isinstance(one, str) else id(one)] for one in values]
