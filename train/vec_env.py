"""Helicopters for Stable-Baselines3: as they are, and with an agent that corrects a controller."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.spaces import Box
from gymnasium.vector import AutoresetMode
from stable_baselines3.common.vec_env.base_vec_env import VecEnv

from heli_gym.baselines.control.protocol import step_index
from heli_gym.baselines.control.residual import FEATURE_CLIP, ResidualPolicy
from heli_gym.baselines.evaluation.metrics import tracking_reward
from heli_gym.rigid_body import RigidBodyParameters
from heli_gym.simulation.layout import LAG, LOSS, RIG, VISCOUS
from heli_gym.task import TOLERANCE, to_action
from heli_gym.vector_env import Heli3DOFVectorEnv

# Rows of the simulation that an episode draws, with the middles and the scales of the presets' ranges.
DRAWN = (
    (LAG, 0.125, 0.05),
    (LOSS, 0.075, 0.05),
    (VISCOUS, 0.11, 0.05),
    (VISCOUS + 1, 0.17, 0.08),
    (VISCOUS + 2, 0.25, 0.12),
    (RIG + RigidBodyParameters._fields.index("e_h"), 0.0, 0.05),
    (RIG + RigidBodyParameters._fields.index("kappa"), 0.0225, 0.005),
)


class HeliVecEnv(VecEnv):
    """The native vector environment as a Stable-Baselines3 `VecEnv`.

    After a reset, the helicopters are spread evenly over the maneuver, unless `spread` is false: did they all start at
    its start, they would march in lockstep, and an update would see one part of the maneuver only. Later flights start
    at its start.

    Raises ValueError unless its autoreset mode is "SameStep", which is Stable-Baselines3's.
    """

    def __init__(self, envs: Heli3DOFVectorEnv, spread: bool = True) -> None:
        if envs.autoreset_mode is not AutoresetMode.SAME_STEP:
            raise ValueError(f"envs: must have the autoreset mode 'SameStep', not {envs.autoreset_mode.value!r}")
        self.envs, self.spread = envs, spread
        self.render_mode = envs.render_mode
        self.returns, self.lengths = np.zeros(envs.num_envs), np.zeros(envs.num_envs, int)
        super().__init__(envs.num_envs, envs.single_observation_space, envs.single_action_space)

    def reset(self) -> np.ndarray:
        """All to their starts; the seeds are those of `seed`."""
        seed = None if self._seeds[0] is None else list(self._seeds)
        durations = np.array([reference.duration for reference in self.envs.references])
        times = durations * np.arange(self.num_envs) / self.num_envs
        options = {"time": times} if self.spread else {}
        observation, self.info = self.envs.reset(seed=seed, options=options | self._options[0])
        self._reset_seeds()
        self._reset_options()
        self.returns[:], self.lengths[:] = 0.0, 0
        return self.observed_at_start(observation)

    def step_async(self, actions: np.ndarray) -> None:
        """Keeps the actions for `step_wait`."""
        self.actions = actions

    def step_wait(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, list[dict[str, Any]]]:
        """Rewards per second, so that they are of order one; the last observation of a flight is in its info."""
        observation, rewards, terminated, truncated, self.info = self.envs.step(self.to_env_action(self.actions))
        done = terminated | truncated
        rewards = self.rewarded(rewards / self.envs.control_period, done)
        ended = np.flatnonzero(done)
        shown, last = self.observed(observation, done)
        self.returns += rewards * self.envs.control_period
        self.lengths += 1
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for column, i in enumerate(ended):
            infos[i] = {
                "terminal_observation": last[column],
                "TimeLimit.truncated": bool(truncated[i]),
                "episode": {"r": float(self.returns[i]), "l": int(self.lengths[i]), "t": 0.0},
                "is_success": bool(self.info["final_info"]["is_success"][i]),
            }
        self.returns[ended], self.lengths[ended] = 0.0, 0
        return shown, rewards.astype(np.float32), done, infos

    def rewarded(self, rewards: np.ndarray, done: np.ndarray) -> np.ndarray:
        """What the agent is rewarded with (N,) per second, given the environment's rewards."""
        return rewards

    def observed_at_start(self, observation: np.ndarray) -> np.ndarray:
        """What the agent sees (N, ...) after a reset, given the environment's observation."""
        return observation

    def observed(self, observation: np.ndarray, done: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """What the agent sees (N, ...) after a step, and at the ends of those flights that are over."""
        ended = np.flatnonzero(done)
        last = np.array([self.info["final_obs"][i] for i in ended]) if len(ended) else observation[:0]
        return observation, last

    def to_env_action(self, actions: np.ndarray) -> np.ndarray:
        """The environment's actions (N, 2) for those of the agent."""
        return actions

    def close(self) -> None:
        """Closes the environment."""
        self.envs.close()

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """The attribute of the environment, once for each helicopter."""
        return [getattr(self.envs, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Refused: the helicopters share one environment."""
        raise NotImplementedError("attributes of single helicopters cannot be set")

    def env_method(self, method_name: str, *args: Any, indices: Any = None, **kwargs: Any) -> list[Any]:
        """The result of the environment's method, once for each helicopter."""
        return [getattr(self.envs, method_name)(*args, **kwargs)] * len(list(self._get_indices(indices)))

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        """No helicopter is wrapped on its own."""
        return [False] * len(list(self._get_indices(indices)))

    def get_images(self) -> Sequence[np.ndarray | None]:
        """A picture of each helicopter."""
        return self.envs.render() or []


class ResidualVecEnv(HeliVecEnv):
    """Helicopters flown by a controller that the agent corrects.

    The agent sees the features of `ResidualPolicy`; with `privileged`, what only its critic may use follows these: the
    true tracking error and the draw of the plant. The objective is "tracking", `tracking_reward`, or "environment".
    """

    def __init__(
        self,
        envs: Heli3DOFVectorEnv,
        policy: ResidualPolicy,
        objective: str = "tracking",
        privileged: bool = False,
        spread: bool = True,
    ) -> None:
        super().__init__(envs, spread)
        self.policy, self.objective, self.privileged = policy, objective, privileged
        self.policy.reset(np.random.default_rng(0))
        self.n_actor_features = len(self.policy.observe(0.0, self.policy.x[:, 0])[1])
        count = self.n_actor_features + (6 + len(DRAWN) if privileged else 0)
        self.observation_space = Box(-FEATURE_CLIP, FEATURE_CLIP, (count,), np.float32)

    def observed_at_start(self, observation: np.ndarray) -> np.ndarray:
        self.policy.reset(np.random.default_rng(0))
        self.t, self.measurement = self.info["time"], self.info["measurement"].T
        self.u_base, features = self.policy.observe(self.t, self.measurement)
        self.draws = self.drawn()
        return self.shown(features, self.info["state"].T, self.t)

    def drawn(self) -> np.ndarray:
        """The draws of the plants (len(DRAWN), N), about zero and of order one."""
        rows = [(self.envs.simulation.rows(row, 1)[0] - middle) / scale for row, middle, scale in DRAWN]
        return np.array(rows)

    def shown(self, features: np.ndarray, state: np.ndarray, time: np.ndarray) -> np.ndarray:
        """Observations (N, ...) out of features (F, N), the true states (6, N) and the times (N,)."""
        if not self.privileged:
            return features.T.astype(np.float32)
        error = (state - self.reference_at(time)) / np.array(TOLERANCE)[:, None]
        return np.clip(np.concatenate((features, error, self.draws)), -FEATURE_CLIP, FEATURE_CLIP).T.astype(np.float32)

    def reference_at(self, time: np.ndarray) -> np.ndarray:
        """The states (6, N) of the reference at times (N,) in s."""
        return self.policy.x[:, step_index(time, self.envs.control_period, self.policy.x.shape[1] - 1)]

    def rewarded(self, rewards: np.ndarray, done: np.ndarray) -> np.ndarray:
        if self.objective == "environment":
            return rewards
        state, time, cost = self.info["state"].T, self.info["time"], self.info["cost"]
        if done.any():
            final = self.info["final_info"]
            state = np.where(done, final["state"].T, state)
            time, cost = np.where(done, final["time"], time), np.where(done, final["cost"], cost)
        return tracking_reward((state - self.reference_at(time))[0:3:2], cost / self.envs.control_period, rewards)

    def to_env_action(self, actions: np.ndarray) -> np.ndarray:
        u = self.policy.correct(self.t, self.measurement, self.u_base, np.clip(actions.T, -1.0, 1.0).astype(float))
        return to_action(u, self.envs.voltage_limits, self.envs.hover_voltage).T

    def observed(self, observation: np.ndarray, done: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        self.t, self.measurement, state = self.info["time"], self.info["measurement"].T, self.info["state"].T
        ended = np.flatnonzero(done)
        if not len(ended):
            self.u_base, features = self.policy.observe(self.t, self.measurement)
            shown = self.shown(features, state, self.t)
            return shown, shown[:0]
        final = self.info["final_info"]
        t_end = np.where(done, final["time"], self.t)
        u_base, features = self.policy.observe(t_end, np.where(done, final["measurement"].T, self.measurement))
        last = self.shown(features, np.where(done, final["state"].T, state), t_end)[ended]

        # The flights that start now: as if the policies had just been reset, in their columns.
        memory = self.policy.memory
        self.policy.reset(np.random.default_rng(0))
        u_base[:, ended], features[:, ended] = self.policy.observe(self.t[ended], self.measurement[:, ended])
        self.policy.memory = assign_columns(memory, self.policy.memory, ended)
        self.u_base = u_base
        self.draws = self.drawn()
        return self.shown(features, state, self.t), last


def assign_columns(old: Any, new: Any, columns: np.ndarray) -> Any:
    """Arrays (..., N), or tuples of them, with these columns replaced by arrays (..., n)."""
    if isinstance(old, tuple):
        parts = [assign_columns(a, b, columns) for a, b in zip(old, new)]
        return type(old)(*parts) if hasattr(old, "_fields") else tuple(parts)
    if old is None:
        return None
    result = old.copy()
    result[..., columns] = new
    return result
