"""Wrappers for learning a correction of a controller: u = sat(sat(u_base) + authority a).

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
from heli_gym.env import Heli3DOFEnv
from heli_gym.task import OBSERVATION_LIMIT, observed_voltage
from heli_gym.trajectory import Trajectory
from heli_gym.validation import real_array
from heli_gym.vector_env import Heli3DOFVectorEnv

PolicyMaker = Callable[[Trajectory, float], Policy]  # arguments: reference, control period in s


def observation_space_with_base(space: Any) -> Box:
    """Space of flat observations with the base policy's voltages (2,) appended."""
    limit = np.full(2, OBSERVATION_LIMIT, np.float32)
    return Box(np.concatenate((space.low, -limit)), np.concatenate((space.high, limit)), dtype=np.float32)


def observe_base(u_base: np.ndarray) -> np.ndarray:
    """Convert voltages in V to the clipped, normalised units of the observation."""
    return np.clip(observed_voltage(u_base), -OBSERVATION_LIMIT, OBSERVATION_LIMIT).astype(np.float32)


def check_authority(authority: Any) -> float:
    """Authority in V as a float. Raises ValueError unless it is a finite number, at least 0."""
    value = real_array(authority)
    if value is None or value.shape != () or not 0.0 <= value < math.inf:
        raise ValueError(f"authority = {authority!r}: must be a finite number of volts, at least 0")
    return float(value)


def policy_maker(policy: str | PolicyMaker, core: Heli3DOFEnv | Heli3DOFVectorEnv) -> PolicyMaker:
    """Function that makes the base policy for a reference, given a policy name or the function itself."""
    if callable(policy):
        return policy
    return partial(make_policy, policy, voltage_limits=core.voltage_limits, rig=core.rig)


class ResidualAction(gym.Wrapper, gym.utils.RecordConstructorArgs):
    """Wrapper whose actions correct a controller: u = sat(sat(u_base) + authority a), with a in [-1, 1]².

    The action 0 flies the base policy bit for bit. The voltages u_base of the next period are the last two entries of
    the observation, in its units, and `info["base_voltage"]` in V. If a sampler draws the reference, each episode has
    its own base policy.

    Args:
        env: Heli3DOF environment with flat observations, wrapped or not.
        policy: name for `make_policy`, with the environment's rig, or a function of the reference and the control
            period in s that returns a policy.
        authority: greatest correction in V.

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
        """Make the base policy of a reference, or return the current one."""
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
        """Fly one control period with the corrected voltages of the base policy.

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
        """Append the voltages of the base policy to the observation and add them to the info."""
        assert self.base is not None
        self.u_base = np.clip(self.base(info["time"], info["measurement"]), *self.core.voltage_limits)
        info["base_voltage"] = self.u_base.copy()
        return np.concatenate((observation, observe_base(self.u_base)))


@dataclass
class Group:
    """Helicopters that share a base policy, and its memory of their flights, with one column each."""

    members: np.ndarray  # (n,) indices of the helicopters
    policy: Policy | None = None
    memory: Any = None

    def voltages(self, t: np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, Any]:
        """Voltages (2, n) in V at times (n,) in s and measurements (6, n), and the next memory."""
        assert self.policy is not None
        if isinstance(self.policy, StatefulPolicy):
            return self.policy.step(self.memory, t, measurement)
        return self.policy(t, measurement), None


class VectorResidualAction(VectorWrapper):
    """`ResidualAction` for the native vector environment: `VectorResidualAction(gym.make_vec("Heli3DOF-v0", n))`.

    The arguments are those of `ResidualAction`. Helicopters with the same reference share one policy; if a sampler
    draws the reference of a helicopter, it has its own policy.
    """

    def __init__(self, env: VectorEnv, policy: str | PolicyMaker = "feedforward+tvlqr", authority: float = 3.0) -> None:
        super().__init__(env)
        core = env.unwrapped
        if not isinstance(core, Heli3DOFVectorEnv):
            raise ValueError(f"env = {env!r}: must be a native Heli3DOF vector environment")
        self.core, self.authority = core, check_authority(authority)
        self.make_base = policy_maker(policy, core)
        self.groups = self._make_groups()
        self.single_observation_space = observation_space_with_base(env.single_observation_space)
        self.observation_space = batch_space(self.single_observation_space, core.num_envs)
        self.u_base: np.ndarray | None = None
        self.over = np.zeros(core.num_envs, bool)

    def _make_groups(self) -> list[Group]:
        """Groups of helicopters: one for each trajectory, and one for each helicopter with a sampler."""
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
        """Start episodes, of all helicopters or of those in `options["reset_mask"]`, and reset their base policies."""
        observation, info = self.env.reset(seed=seed, options=options)
        mask = (options or {}).get("reset_mask")
        started = np.ones(self.num_envs, bool) if mask is None else np.asarray(mask)
        self._start_flights(started, info)
        self.over = self.over & ~started
        u_base = self._step_base(info, started)
        return self._with_base(observation, info, u_base), info

    def step(self, actions: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Fly one control period with the corrected voltages of the base policies.

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
            self._append_final_base(info, done)
            self._start_flights(done, info)
        elif self.core.autoreset_mode is AutoresetMode.NEXT_STEP:
            self._start_flights(self.over, info)
        self.over = done if self.core.autoreset_mode is AutoresetMode.NEXT_STEP else np.zeros_like(done)
        u_base = self._step_base(info, np.ones(self.num_envs, bool))
        return self._with_base(observation, info, u_base), rewards, terminated, truncated, info

    def _start_flights(self, started: np.ndarray, info: dict[str, Any]) -> None:
        """Set policies and memories of the helicopters in the mask `started` (N,), at the start of their flights."""
        for group in self.groups if started.any() else ():
            columns = np.flatnonzero(started[group.members])
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

    def _step_base(self, info: dict[str, Any], stepped: np.ndarray) -> np.ndarray:
        """Voltages (2, N) in V of the base policies, clipped; updates only helicopters in the mask `stepped` (N,)."""
        u_base = np.empty((2, self.num_envs)) if self.u_base is None else self.u_base.copy()
        for group in self.groups:
            u, memory = group.voltages(info["time"][group.members], info["measurement"][group.members].T)
            columns = np.flatnonzero(stepped[group.members])
            u_base[:, group.members[columns]] = np.clip(u[:, columns], *self.core.voltage_limits)
            if len(columns) == len(group.members):
                group.memory = memory
            elif len(columns):
                group.memory = assign_columns(group.memory, select_columns(memory, columns), columns)
        self.u_base = u_base
        return u_base

    def _append_final_base(self, info: dict[str, Any], done: np.ndarray) -> None:
        """Append the voltages of the base policies to the final observations of the flights in the mask `done` (N,)."""
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
                info["final_obs"][i] = np.concatenate((info["final_obs"][i], observe_base(u[:, column])))

    def _with_base(self, observation: np.ndarray, info: dict[str, Any], u_base: np.ndarray) -> np.ndarray:
        """Append the voltages of the base policies to the observations and add them to the info."""
        info["base_voltage"], info["_base_voltage"] = u_base.T.copy(), info["_time"]
        return np.concatenate((observation, observe_base(u_base).T), axis=1)
