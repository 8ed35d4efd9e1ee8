"""One way to fly: any policy in any environment, to a Trajectory."""

from typing import Any

import gymnasium as gym
import numpy as np

from baselines.policies import Policy
from heli_gym.env import Heli3DOFEnv
from heli_gym.task import to_action
from heli_gym.trajectory import Trajectory


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
    period = getattr(policy, "control_period", core.control_period)
    if period != core.control_period:
        raise ValueError(f"policy: made for a control period of {period:g} s, and env has {core.control_period:g} s")

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
