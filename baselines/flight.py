"""One way to fly: any policy in any environment, to a Trajectory; and many flights at once."""

from typing import Any

import gymnasium as gym
import numpy as np

from baselines.policies import Policy
from heli_gym.env import Heli3DOFEnv
from heli_gym.task import control_steps, to_action
from heli_gym.trajectory import Trajectory
from heli_gym.vector_env import Heli3DOFVectorEnv


def fly(env: gym.Env, policy: Policy, seed: int | None = None, options: dict[str, Any] | None = None) -> Trajectory:
    """One episode: true states and applied voltages, u[:, k] being held from t[k] to t[k + 1].

    Args:
        env: a Heli3DOF environment, wrapped or not.
        policy: gives voltages for times and measurements.
        seed: of the episode and of the policy's own randomness.
        options: for `env.reset`.

    Raises:
        ValueError: if the environment is another, or the policy was made for another control period.
    """
    core = env.unwrapped
    if not isinstance(core, Heli3DOFEnv):
        raise ValueError(f"env = {env!r}: a Heli3DOF environment is needed")
    check_period(policy, core.control_period)
    _, info = env.reset(seed=seed, options=options)
    policy.reset(np.random.default_rng(seed))
    states, voltages = [info["state"]], []
    over = False
    while not over:
        action = to_action(policy(info["time"], info["measurement"]), core.voltage_limits)
        _, _, terminated, truncated, info = env.step(action)
        states.append(info["state"])
        voltages.append(info["voltage"])
        over = terminated or truncated
    t = core.control_period * np.arange(len(states))
    u = np.array([*voltages, voltages[-1]])
    return Trajectory(t, np.array(states).T, u.T, core.reference.limits)


def fly_many(envs: Heli3DOFVectorEnv, policy: Policy, seed: int) -> list[Trajectory]:
    """One episode of each helicopter, all at once: what `fly` returns for the seeds from `seed` on, to rounding.

    Args:
        envs: helicopters with the same reference, which all start at its start.
        policy: gives voltages (2, N) for a time and measurements (6, N).
        seed: of the first episode, the others counting on, and of the policy's own randomness.

    Raises:
        ValueError: if the helicopters follow different references or start at random times, or if the policy was made
            for another control period.
    """
    reference = envs.references[0]
    same = all(other is reference for other in envs.references)
    if not (isinstance(reference, Trajectory) and same) or envs.random_start:
        raise ValueError("envs: helicopters with the same reference, which start at its start, are needed")
    check_period(policy, envs.control_period)
    _, info = envs.reset(seed=seed)
    policy.reset(np.random.default_rng(seed))
    steps = control_steps(reference.duration, envs.control_period)
    states, voltages = np.empty((steps + 1, 6, envs.num_envs)), np.empty((steps, 2, envs.num_envs))
    states[0] = info["state"].T
    flown = np.full(envs.num_envs, steps)  # control periods until the end of each flight; what follows is another one
    for k in range(steps):
        action = to_action(policy(k * envs.control_period, info["measurement"].T), envs.voltage_limits)
        _, _, terminated, _, info = envs.step(action.T)
        states[k + 1], voltages[k] = info["state"].T, info["voltage"].T
        flown[terminated] = np.minimum(flown[terminated], k + 1)
    t = envs.control_period * np.arange(steps + 1)
    return [
        Trajectory(t[: n + 1], states[: n + 1, :, i].T, voltages[[*range(n), n - 1], :, i].T, reference.limits)
        for i, n in enumerate(flown)
    ]


def check_period(policy: Policy, control_period: float) -> None:
    """Raises ValueError if the policy was made for another control period than this one in s."""
    period = getattr(policy, "control_period", control_period)
    if period != control_period:
        raise ValueError(f"policy: made for a control period of {period:g} s, and env has {control_period:g} s")
