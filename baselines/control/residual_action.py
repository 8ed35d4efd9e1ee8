"""Wrappers with which any learner learns a correction of a controller: u = sat(sat(u_base) + authority a).

`ResidualAction` is for one environment, `VectorResidualAction` for the native vector environment.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.spaces import Box
from gymnasium.vector import AutoresetMode, VectorEnv, VectorWrapper
from gymnasium.vector.utils import batch_space
from numpy.typing import ArrayLike

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.protocol import Policy, StatefulPolicy, assign_columns, select_columns
from heli_gym.env import Heli3DOFEnv, real_array
from heli_gym.task import OBSERVATION_LIMIT, observed_voltage
from heli_gym.trajectory import Trajectory
from heli_gym.vector_env import Heli3DOFVectorEnv

PolicyMaker = Callable[[Trajectory, float], Policy]  # from a reference and a control period in s


def observation_space_with_base(space: Any) -> Box:
    """A space of flat observations, with the base policy's voltages (2,) appended."""
    limit = np.full(2, OBSERVATION_LIMIT, np.float32)
    return Box(np.concatenate((space.low, -limit)), np.concatenate((space.high, limit)), dtype=np.float32)


def observed_base(u_base: np.ndarray) -> np.ndarray:
    """Voltages in V in the units of the observation."""
    return np.clip(observed_voltage(u_base), -OBSERVATION_LIMIT, OBSERVATION_LIMIT).astype(np.float32)


def check_authority(authority: Any) -> float:
    """The authority in V, if it is a finite number, at least 0."""
    value = real_array(authority)
    if value is None or value.shape != () or not 0.0 <= value < math.inf:
        raise ValueError(f"authority = {authority!r}: must be a finite number of volts, at least 0")
    return float(value)


def policy_maker(policy: str | PolicyMaker, core: Heli3DOFEnv | Heli3DOFVectorEnv) -> PolicyMaker:
    """What makes the base policy for a reference, given its name or the maker itself."""
    if callable(policy):
        return policy
    return partial(make_policy, policy, voltage_limits=core.voltage_limits, rig=core.rig)


class ResidualAction(gym.Wrapper, gym.utils.RecordConstructorArgs):
    """Let actions correct a controller: u = sat(sat(u_base) + authority a), with a in [-1, 1]².

    Zero flies the base policy bit for bit. The voltages u_base of the coming period are the last two entries of the
    observation, in its units, and `info["base_voltage"]`, in V. Where a sampler draws the reference, each episode has a
    policy of its own.

    Args:
        env: a Heli3DOF environment, wrapped or not, whose observations are flat.
        policy: the name of a policy of `make_policy`, for the environment's rig, or a maker of policies: a function of
            the reference and the control period in s.
        authority: V, the greatest correction.

    Raises:
        ValueError: for another environment, an unknown policy, or an authority that is negative or not finite.
    """

    def __init__(self, env: gym.Env, policy: str | PolicyMaker = "feedforward+tvlqr", authority: float = 3.0) -> None:
        gym.utils.RecordConstructorArgs.__init__(self, policy=policy, authority=authority)
        gym.Wrapper.__init__(self, env)
        core = env.unwrapped
        if not isinstance(core, Heli3DOFEnv):
            raise ValueError(f"env = {env!r}: must be a Heli3DOF environment; VectorResidualAction is for many at once")
        self.core, self.authority = core, check_authority(authority)
        self.make_base = policy_maker(policy, core)
        self.base: Policy | None = None
        self.made_for: Trajectory | None = None
        if isinstance(core.source, Trajectory):
            self._make(core.source)
        self.observation_space = observation_space_with_base(env.observation_space)

    def _make(self, reference: Trajectory) -> Policy:
        """The base policy for a reference."""
        if self.base is None or reference is not self.made_for:
            self.base, self.made_for = self.make_base(reference, self.core.control_period), reference
        return self.base

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Start an episode of the environment and of the base policy."""
        observation, info = self.env.reset(seed=seed, options=options)
        self._make(self.core.reference).reset(np.random.default_rng(seed))
        return self._with_base(observation, info), info

    def step(self, action: ArrayLike) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Fly one control period with the base policy's voltages, corrected.

        Raises ValueError for an action that is not two finite real numbers.
        """
        a = real_array(action)
        if a is None or a.shape != (2,) or not np.isfinite(a).all():
            raise ValueError(f"action = {action!r}: must be two finite real numbers")
        if self.base is None or not hasattr(self, "u_base"):
            raise gym.error.ResetNeeded("call reset before step")
        u = np.clip(self.u_base + self.authority * np.clip(a, -1.0, 1.0), *self.core.voltage_limits)
        if isinstance(self.base, StatefulPolicy) and hasattr(self.base, "with_applied_input"):
            self.base.memory = self.base.with_applied_input(self.base.memory, u)
        observation, reward, terminated, truncated, info = self.env.step(self.core.to_action(u))
        return self._with_base(observation, info), float(reward), terminated, truncated, info

    def _with_base(self, observation: np.ndarray, info: dict[str, Any]) -> np.ndarray:
        """The observation with the voltages of the base policy, which the info holds too."""
        assert self.base is not None
        self.u_base = np.clip(self.base(info["time"], info["measurement"]), *self.core.voltage_limits)
        info["base_voltage"] = self.u_base.copy()
        return np.concatenate((observation, observed_base(self.u_base)))


@dataclass
class Group:
    """Helicopters that share a base policy, and what it remembers of their flights, one column each."""

    members: np.ndarray  # (n,)
    policy: Policy | None = None
    memory: Any = None

    def voltages(self, t: np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Any]:
        """Voltages (2, n) in V at times (n,) in s and measurements (6, n), and the memory after that."""
        assert self.policy is not None
        if isinstance(self.policy, StatefulPolicy):
            return self.policy.step(self.memory, t, measurement)
        return self.policy(t, measurement), None


class VectorResidualAction(VectorWrapper):
    """`ResidualAction` for the native vector environment: `VectorResidualAction(gym.make_vec("Heli3DOF-v0", n))`.

    Arguments are those of `ResidualAction`. Helicopters with the same reference share one policy, which flies them at
    once; where samplers draw the references, each helicopter has its own.
    """

    def __init__(self, env: VectorEnv, policy: str | PolicyMaker = "feedforward+tvlqr", authority: float = 3.0) -> None:
        super().__init__(env)
        core = env.unwrapped
        if not isinstance(core, Heli3DOFVectorEnv):
            raise ValueError(f"env = {env!r}: must be a native Heli3DOF vector environment")
        self.core, self.authority = core, check_authority(authority)
        self.make_base = policy_maker(policy, core)
        self.groups = self._grouped()
        self.single_observation_space = observation_space_with_base(env.single_observation_space)
        self.observation_space = batch_space(self.single_observation_space, core.num_envs)
        self.u_base: np.ndarray | None = None
        self.over = np.zeros(core.num_envs, bool)

    def _grouped(self) -> list[Group]:
        """One group for each trajectory, and one for each helicopter whose references are drawn."""
        members: dict[Any, list[int]] = {}
        for i, source in enumerate(self.core.references):
            members.setdefault(id(source) if isinstance(source, Trajectory) else ("drawn", i), []).append(i)
        groups = [Group(np.array(indices)) for indices in members.values()]
        for group in groups:
            source = self.core.references[group.members[0]]
            if isinstance(source, Trajectory):
                group.policy = self.make_base(source, self.core.control_period)
        return groups

    def reset(self, *, seed: Any = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Start episodes of helicopters, those of a `reset_mask` or all, and of their base policies."""
        observation, info = self.env.reset(seed=seed, options=options)
        mask = (options or {}).get("reset_mask")
        begun = np.ones(self.num_envs, bool) if mask is None else np.asarray(mask)
        self._begin(begun, info)
        self.over = self.over & ~begun
        u_base = self._step_base(info, begun)
        return self._with_base(observation, info, u_base), info

    def step(self, actions: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Fly one control period with the base policies' voltages, corrected.

        Raises ValueError for actions that are not (N, 2) finite real numbers.
        """
        if self.u_base is None:
            raise gym.error.ResetNeeded("call reset before step")
        a = real_array(actions)
        if a is None or a.shape != (self.num_envs, 2) or not np.isfinite(a).all():
            raise ValueError(f"actions = {actions!r}: must be ({self.num_envs}, 2) finite real numbers")
        u = np.clip(self.u_base + self.authority * np.clip(a.T, -1.0, 1.0), *self.core.voltage_limits)
        observation, rewards, terminated, truncated, info = self.env.step(self.core.to_action(u.T))
        for group in self.groups:
            if isinstance(group.policy, StatefulPolicy) and hasattr(group.policy, "with_applied_input"):
                group.memory = group.policy.with_applied_input(group.memory, u[:, group.members])
        done = terminated | truncated
        if self.core.autoreset_mode is AutoresetMode.SAME_STEP and done.any():
            self._end(info, done)
            self._begin(done, info)
        elif self.core.autoreset_mode is AutoresetMode.NEXT_STEP:
            self._begin(self.over, info)
        self.over = done if self.core.autoreset_mode is AutoresetMode.NEXT_STEP else np.zeros_like(done)
        u_base = self._step_base(info, np.ones(self.num_envs, bool))
        return self._with_base(observation, info, u_base), rewards, terminated, truncated, info

    def _begin(self, begun: np.ndarray, info: dict[str, Any]) -> None:
        """Set the policies and memories of helicopters whose flights begin, a mask (N,)."""
        for group in self.groups if begun.any() else ():
            columns = np.flatnonzero(begun[group.members])
            if not len(columns):
                continue
            members = group.members[columns]
            if not isinstance(self.core.references[members[0]], Trajectory):
                group.policy = self.make_base(self.core.reference_of(members[0]), self.core.control_period)
                group.memory = None
            if isinstance(group.policy, StatefulPolicy):
                first = group.policy.init(info["time"][members], info["measurement"][members].T)
                whole = group.memory is None or len(columns) == len(group.members)
                group.memory = first if whole else assign_columns(group.memory, first, columns)

    def _step_base(self, info: dict[str, Any], moved: np.ndarray) -> np.ndarray:
        """Voltages (2, N) in V of the base policies, within the limits; those of the others stay as they are."""
        u_base = np.empty((2, self.num_envs)) if self.u_base is None else self.u_base.copy()
        for group in self.groups:
            u, memory = group.voltages(info["time"][group.members], info["measurement"][group.members].T)
            columns = np.flatnonzero(moved[group.members])
            u_base[:, group.members[columns]] = np.clip(u[:, columns], *self.core.voltage_limits)
            if len(columns) == len(group.members):
                group.memory = memory
            elif len(columns):
                group.memory = assign_columns(group.memory, select_columns(memory, columns), columns)
        self.u_base = u_base
        return u_base

    def _end(self, info: dict[str, Any], done: np.ndarray) -> None:
        """Append the voltages of the base policies to the last observations of flights that are over."""
        final = info["final_info"]
        final["base_voltage"], final["_base_voltage"] = np.zeros((self.num_envs, 2)), done.copy()
        for group in self.groups:
            if not done[group.members].any():
                continue
            members = group.members
            ended = done[members]
            t = np.where(ended, final["time"][members], info["time"][members])
            measurement = np.where(ended[:, None], final["measurement"][members], info["measurement"][members]).T
            u = np.clip(group.voltages(t, measurement)[0], *self.core.voltage_limits)
            for column in np.flatnonzero(ended):
                i = members[column]
                final["base_voltage"][i] = u[:, column]
                info["final_obs"][i] = np.concatenate((info["final_obs"][i], observed_base(u[:, column])))

    def _with_base(self, observation: np.ndarray, info: dict[str, Any], u_base: np.ndarray) -> np.ndarray:
        """The observations with the voltages of the base policies, which the info holds too."""
        info["base_voltage"], info["_base_voltage"] = u_base.T.copy(), info["_time"]
        return np.concatenate((observation, observed_base(u_base).T), axis=1)
