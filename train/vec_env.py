"""Vector environments for Stable-Baselines3: plain helicopters, and helicopters whose controller the agent corrects."""

import math
import time
from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.spaces import Box
from gymnasium.vector import AutoresetMode, VectorEnv
from stable_baselines3.common.monitor import Monitor
from stable_baselines3.common.vec_env.base_vec_env import VecEnv

from heli_gym.baselines.control.protocol import assign_columns, step_index
from heli_gym.baselines.control.residual import FEATURE_CLIP, ResidualPolicy
from heli_gym.baselines.evaluation.metrics import crash_cost, tracking_reward
from heli_gym.plant import Plant
from heli_gym.rigid_body import RigidBodyParameters
from heli_gym.simulation.layout import LAG, LOSS, RIG, VISCOUS
from heli_gym.task import TOLERANCE, to_action, to_voltage
from heli_gym.trajectory import Trajectory
from heli_gym.validation import real_array, shown
from heli_gym.vector_env import Heli3DOFVectorEnv

# Random rows of the simulation, with middle and scale of their ranges in the presets.
DRAWN = (
    (LAG, 0.125, 0.05),
    (LOSS, 0.075, 0.05),
    (VISCOUS, 0.11, 0.05),
    (VISCOUS + 1, 0.17, 0.08),
    (VISCOUS + 2, 0.25, 0.12),
    (RIG + RigidBodyParameters._fields.index("e_h"), 0.0, 0.05),
    (RIG + RigidBodyParameters._fields.index("kappa"), 0.0225, 0.005),
)


def plant_features(envs: Heli3DOFVectorEnv) -> np.ndarray:
    """Normalised draws (len(DRAWN), N) of the plants of `lab` or `rigid`, around zero and of order one."""
    return np.array([(envs.simulation.rows(row, 1)[0] - middle) / scale for row, middle, scale in DRAWN])


# Attributes of `Heli3DOFEnv` common to all helicopters of a vector environment.
SHARED = (
    "control_period",
    "voltage_limits",
    "pitch_limit",
    "start_spread_deg",
    "random_start",
    "render_mode",
    "spec",
    "rig",
)


class HeliVecEnv(VecEnv):
    """Native vector environment as a Stable-Baselines3 `VecEnv`, many times as fast as `make_vec_env`.

    Rewards, lengths and `info["episode"]` equal those of `make_vec_env("Heli3DOF-v0", ...)` with Monitors, bit for bit
    in single precision, and an `info` has the same keys.

    Args:
        envs: `gymnasium.make_vec("Heli3DOF-v0", n, autoreset_mode="SameStep", ...)`, wrapped or not.
        spread: whether a `reset` spreads the helicopters evenly over the maneuver; later flights start at its start.
            Without it all helicopters fly in lockstep, and an update uses one part of the maneuver only.
        reward_unit: s, divisor of all rewards, also in `info["episode"]`. With the control period they are of order 1.
        sparse_infos: whether to fill only the infos of flights that end, which saves time with many helicopters.

    Raises ValueError for an autoreset mode other than "SameStep", that of Stable-Baselines3, or another environment.
    """

    def __init__(
        self, envs: VectorEnv, spread: bool = False, reward_unit: float = 1.0, sparse_infos: bool = False
    ) -> None:
        core = envs.unwrapped
        if not isinstance(core, Heli3DOFVectorEnv):
            raise ValueError(f"envs = {envs!r}: must be a native Heli3DOF vector environment")
        if core.autoreset_mode is not AutoresetMode.SAME_STEP:
            raise ValueError(f"envs: must have the autoreset mode 'SameStep', not {core.autoreset_mode.value!r}")
        if not (math.isfinite(reward_unit) and reward_unit > 0.0):
            raise ValueError(f"reward_unit = {reward_unit!r}: must be a positive number of seconds")
        self.envs, self.core, self.spread = envs, core, spread
        self.reward_unit, self.sparse_infos = reward_unit, sparse_infos
        self.render_mode = core.render_mode
        self.returns, self.lengths = np.zeros(core.num_envs), np.zeros(core.num_envs, int)
        self.begin = time.time()
        super().__init__(core.num_envs, envs.single_observation_space, envs.single_action_space)

    def reset(self) -> np.ndarray:
        """Start episodes with each helicopter's seed from `seed` and options from `set_options`."""
        seed: Any = None if self._seeds[0] is None else list(self._seeds)
        observation, self.info = self.envs.reset(seed=seed, options=self._merged_options())
        self._reset_seeds()
        self._reset_options()
        self.returns[:], self.lengths[:] = 0.0, 0
        self.reset_infos = self._infos(self.info)
        return self.initial_observations(observation)

    def _merged_options(self) -> dict[str, Any]:
        """Options of the vector environment, merged from each helicopter's options."""
        names = {name for own in self._options for name, value in own.items() if value is not None}
        if not names <= {"state", "plant", "time"}:
            raise ValueError(f"options = {self._options!r}: must be among 'state', 'plant', 'time'")
        merged: dict[str, Any] = {}
        if self.spread:
            durations = np.array([reference.duration for reference in self.core.references])
            is_given = [own.get("state") is not None for own in self._options]  # a state at the start
            merged["time"] = np.where(is_given, 0.0, durations * np.arange(self.num_envs) / self.num_envs)
        defaults = {"state": [[math.nan] * 6] * self.num_envs, "plant": self.core.plants}
        defaults["time"] = merged.get("time", [0.0] * self.num_envs)
        for name in names:
            own = [default if (value := one.get(name)) is None else value
                   for one, default in zip(self._options, defaults[name])]  # fmt: skip
            merged[name] = own if name == "plant" else np.array(own, float)
        return merged

    def step_async(self, actions: np.ndarray) -> None:
        """Store the actions for `step_wait`."""
        self.actions = actions

    def step_wait(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, list[dict[str, Any]]]:
        """Fly one control period; the info of a flight that ends has its last observation."""
        observation, rewards, terminated, truncated, self.info = self.envs.step(self.to_env_action(self.actions))
        done = terminated | truncated
        rewards = self.agent_rewards(rewards / self.reward_unit, done).astype(np.float32)
        shown, last = self.agent_observations(observation, done)
        self.returns += rewards
        self.lengths += 1
        infos = [{} for _ in range(self.num_envs)] if self.sparse_infos else self._infos(self.info)
        for column, i in enumerate(np.flatnonzero(done).tolist()):
            infos[i] = self._infos(self.info["final_info"], [i])[0] | {
                "terminal_observation": last[column],
                "TimeLimit.truncated": bool(truncated[i] and not terminated[i]),
                "episode": {
                    "r": round(float(self.returns[i]), 6),
                    "l": int(self.lengths[i]),
                    "t": round(time.time() - self.begin, 6),
                },
            }
        self.returns[done], self.lengths[done] = 0.0, 0
        return shown, rewards, done, infos

    def _infos(self, info: dict[str, Any], indices: Sequence[int] | None = None) -> list[dict[str, Any]]:
        """Infos of all helicopters, or of those at given indices."""
        where = slice(None) if indices is None else list(indices)
        names = [name for name, value in info.items() if isinstance(value, np.ndarray) and name[0] != "_"]
        names = [name for name in names if name != "final_obs"]
        columns = [info[name][where] for name in names]
        rows = zip(*(column.tolist() if column.ndim == 1 else column for column in columns))
        return [dict(zip(names, row)) | {"TimeLimit.truncated": False} for row in rows]

    def agent_rewards(self, rewards: np.ndarray, done: np.ndarray) -> np.ndarray:
        """Rewards (N,) of the agent from the environment's rewards (N,), both in the reward unit."""
        return rewards

    def initial_observations(self, observation: np.ndarray) -> np.ndarray:
        """Observations (N, ...) of the agent after a reset, from the environment's."""
        return observation

    def agent_observations(self, observation: np.ndarray, done: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Observations (N, ...) of the agent after a step, and final ones (n, ...) of the flights that ended."""
        ended = np.flatnonzero(done)
        last = np.array([self.info["final_obs"][i] for i in ended]) if len(ended) else observation[:0]
        return observation, last

    def to_env_action(self, actions: np.ndarray) -> np.ndarray:
        """Actions (N, 2) of the environment for actions (N, 2) of the agent."""
        return actions

    def close(self) -> None:
        """Close the environment."""
        self.envs.close()

    def helicopter(self, i: int) -> "Helicopter":
        """View of helicopter i with the interface of `Heli3DOFEnv`."""
        return Helicopter(self.core, self.envs, i)

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Attribute of each helicopter, by its name in `Heli3DOFEnv`: "reference", "plant", "drawn_plant", ..."""
        return [getattr(self.helicopter(i), attr_name) for i in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Raise an error: the helicopters share one environment."""
        raise NotImplementedError("attributes of single helicopters cannot be set")

    def env_method(self, method_name: str, *args: Any, indices: Any = None, **kwargs: Any) -> list[Any]:
        """Results of each helicopter's method "to_action", "to_voltage" or "render"."""
        return [getattr(self.helicopter(i), method_name)(*args, **kwargs) for i in self._get_indices(indices)]

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        """True for a Monitor, because this environment has its `info["episode"]`; False for other wrappers."""
        return [wrapper_class is Monitor] * len(list(self._get_indices(indices)))

    def get_images(self) -> Sequence[np.ndarray | None]:
        """Picture of each helicopter."""
        pictures: Any = self.envs.render()
        return list(pictures or [])


class Helicopter:
    """Helicopter of a vector environment, with the read-only attributes and methods of `Heli3DOFEnv`."""

    def __init__(self, core: Heli3DOFVectorEnv, envs: VectorEnv, i: int) -> None:
        self.core, self.i = core, i
        self.plant, self.source = core.plants[i], core.references[i]
        self.hover_voltage = core.hover_voltage[:, i]
        self.observation_space, self.action_space = envs.single_observation_space, envs.single_action_space
        for name in SHARED:
            setattr(self, name, getattr(core, name))

    @property
    def reference(self) -> Trajectory:
        """Trajectory to track in this episode."""
        return self.core.reference_of(self.i)

    @property
    def drawn_plant(self) -> Plant:
        """Plant of this episode."""
        return self.core.plant_of(self.i)

    @property
    def np_random(self) -> np.random.Generator:
        """Random generator."""
        return self.core.np_random[self.i]

    @property
    def np_random_seed(self) -> int:
        """Seed of the random generator."""
        return self.core.np_random_seed[self.i]

    def to_voltage(self, action: Any) -> np.ndarray:
        """Voltages (2,) in V for an action (2,)."""
        return to_voltage(np.asarray(action, float), self.core.voltage_limits, self.hover_voltage)

    def to_action(self, u: Any) -> np.ndarray:
        """Action (2,) for voltages (2,) in V."""
        return to_action(np.asarray(u, float), self.core.voltage_limits, self.hover_voltage)

    def render(self) -> np.ndarray | None:
        """Picture of the helicopter."""
        pictures = self.core.render()
        return None if pictures is None else pictures[self.i]


class ResidualVecEnv(HeliVecEnv):
    """Helicopters with a controller that the agent corrects.

    The observations are the features of `ResidualPolicy`; with `privileged`, the true tracking error and the plant's
    draw follow, for the critic only. The objective is "tracking" (`tracking_reward`) or "environment". With "tracking",
    a crash is charged `crash_cost` for all control periods to the end of the maneuver, discounted as the learner does.
    """

    def __init__(
        self,
        envs: Heli3DOFVectorEnv,
        policy: ResidualPolicy,
        objective: str = "tracking",
        privileged: bool = False,
        spread: bool = True,
        discount: float = 1.0,
    ) -> None:
        super().__init__(envs, spread, reward_unit=envs.control_period, sparse_infos=True)
        self.policy, self.objective, self.privileged, self.discount = policy, objective, privileged, discount
        self.policy.reset(np.random.default_rng(0))
        self.n_actor_features = len(self.policy.observe(0.0, self.policy.x[:, 0])[1])
        count = self.n_actor_features + (6 + len(DRAWN) if privileged else 0)
        self.observation_space = Box(-FEATURE_CLIP, FEATURE_CLIP, (count,), np.float32)

    def initial_observations(self, observation: np.ndarray) -> np.ndarray:
        self.policy.reset(np.random.default_rng(0))
        self.t, self.measurement = self.info["time"], self.info["measurement"].T
        self.u_base, features = self.policy.observe(self.t, self.measurement)
        self.draws = plant_features(self.core)
        return self.make_observations(features, self.info["state"].T, self.t)

    def make_observations(self, features: np.ndarray, state: np.ndarray, time: np.ndarray) -> np.ndarray:
        """Observations (N, ...) from features (F, N), true states (6, N) and times (N,) in s."""
        if not self.privileged:
            return features.T.astype(np.float32)
        error = (state - self.reference_at(time)) / np.array(TOLERANCE)[:, None]
        return np.clip(np.concatenate((features, error, self.draws)), -FEATURE_CLIP, FEATURE_CLIP).T.astype(np.float32)

    def reference_at(self, time: np.ndarray) -> np.ndarray:
        """Reference states (6, N) at times (N,) in s."""
        return self.policy.x[:, step_index(time, self.core.control_period, self.policy.x.shape[1] - 1)]

    def agent_rewards(self, rewards: np.ndarray, done: np.ndarray) -> np.ndarray:
        if self.objective == "environment":
            return rewards
        state, time, cost = self.info["state"].T, self.info["time"], self.info["cost"]
        if done.any():
            final = self.info["final_info"]
            state = np.where(done, final["state"].T, state)
            time, cost = np.where(done, final["time"], time), np.where(done, final["cost"], cost)
        earned = tracking_reward((state - self.reference_at(time))[0:3:2], cost / self.core.control_period, rewards)
        for i in np.flatnonzero(done & (np.abs(state[4]) > self.core.pitch_limit)):
            earned[i] -= self.crash_charge(float(state[4, i]), float(time[i]))
        return earned

    def crash_charge(self, pitch: float, time: float) -> float:
        """Discounted cost of the control periods that a crash at a pitch in rad and a time in s leaves out."""
        steps = self.policy.x.shape[1] - 1
        missing = steps - int(step_index(time, self.core.control_period, steps))
        cost = crash_cost(pitch, self.core.voltage_limits, self.policy.reference.limits)
        return cost * float((self.discount ** np.arange(1, missing + 1)).sum())

    def to_env_action(self, actions: np.ndarray) -> np.ndarray:
        given = real_array(actions)
        if given is None or given.shape != (self.num_envs, 2) or not np.isfinite(given).all():
            raise ValueError(f"actions = {shown(actions)}: must be ({self.num_envs}, 2) finite real numbers")
        u = self.policy.correct(self.t, self.measurement, self.u_base, np.clip(given.T, -1.0, 1.0))
        return to_action(u, self.core.voltage_limits, self.core.hover_voltage).T

    def agent_observations(self, observation: np.ndarray, done: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        self.t, self.measurement, state = self.info["time"], self.info["measurement"].T, self.info["state"].T
        ended = np.flatnonzero(done)
        if not len(ended):
            self.u_base, features = self.policy.observe(self.t, self.measurement)
            shown = self.make_observations(features, state, self.t)
            return shown, shown[:0]
        final = self.info["final_info"]
        t_end = np.where(done, final["time"], self.t)
        u_base, features = self.policy.observe(t_end, np.where(done, final["measurement"].T, self.measurement))
        last = self.make_observations(features, np.where(done, final["state"].T, state), t_end)[ended]

        # Reset the policy in the columns of the flights that start now.
        memory = self.policy.memory
        self.policy.reset(np.random.default_rng(0))
        u_base[:, ended], features[:, ended] = self.policy.observe(self.t[ended], self.measurement[:, ended])
        self.policy.memory = assign_columns(memory, self.policy.memory, ended)
        self.u_base = u_base
        self.draws = plant_features(self.core)
        return self.make_observations(features, state, self.t), last
