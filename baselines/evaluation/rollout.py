"""Flights of any policy in any environment, one or many at once, as trajectories."""

from typing import Any

import gymnasium as gym
import numpy as np

from heli_gym.baselines.control.ilc import LearnedFeedforward
from heli_gym.baselines.control.model_based import ModelPolicy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.env import Heli3DOFEnv
from heli_gym.rig import UNNAMED, Rig, check_same_rig
from heli_gym.task import control_grid, control_steps, to_action
from heli_gym.trajectory import Trajectory
from heli_gym.validation import shown
from heli_gym.vector_env import Heli3DOFVectorEnv

# rad and rad/s, tolerance for equal references: solvers on other machines, and files, round differently
SAME_REFERENCE = 1e-3


def fly(env: gym.Env, policy: Policy, seed: int | None = None, options: dict[str, Any] | None = None) -> Trajectory:
    """Fly one episode: true states, and commanded voltages within the amplifier's limits.

    u[:, k] is the command from t[k] to t[k + 1]; the rotors follow with the plant's delay and lag.

    Args:
        env: Heli3DOF environment, wrapped or not, with episodes that start at the start of the reference.
        policy: function of time and measurement that returns voltages, or an object whose method `act` maps
            observations (N, D) to actions.
        seed: of the episode and of the policy's random numbers.
        options: for `env.reset`.

    Raises:
        ValueError: for another environment, random start times, or a policy for another control period, amplifier or
            reference.
    """
    core = env.unwrapped if isinstance(env, gym.Env) else None
    if not isinstance(core, Heli3DOFEnv):
        raise ValueError(f"env = {shown(env)}: must be a Heli3DOF environment")
    if core.random_start:
        raise ValueError(f"env = {shown(env)}: must start at its reference's start, without random_start")
    observation, info = env.reset(seed=seed, options=options)
    check_policy(policy, core, core.reference)
    policy.reset(np.random.default_rng(seed))
    states, voltages = [info["state"]], []
    over = False
    while not over:
        if hasattr(policy, "act"):
            action = policy.act(observation[None])[0]
        else:
            u = np.asarray(policy(info["time"], info["measurement"]))
            if u.shape != (2,):
                raise ValueError(f"action = {u!r}: must be two finite voltages, from {type(policy).__name__}")
            action = to_action(u, core.voltage_limits, core.hover_voltage)
        observation, _, terminated, truncated, info = env.step(action)
        states.append(info["state"])
        voltages.append(info["voltage"])
        over = terminated or truncated
    t = core.control_period * np.arange(len(states))
    u = np.array([*voltages, voltages[-1]])
    return Trajectory(t, np.array(states).T, u.T, core.reference.limits, core.rig)


def fly_many(envs: Heli3DOFVectorEnv, policy: Policy, seed: int) -> list[Trajectory]:
    """Fly one episode of each helicopter, all at once; up to rounding, the flights of `fly` for `seed`, `seed` + 1, ...

    Args:
        envs: helicopters with a common reference, which all start at its start.
        policy: function of time and measurements (6, N) that returns voltages (2, N), or an object with `act`.
        seed: of the first episode and of the policy's random numbers.

    Raises:
        ValueError: for different references, random start times, or a policy for another control period, amplifier or
            reference.
    """
    reference = envs.references[0]
    same = all(other is reference for other in envs.references)
    if not (isinstance(reference, Trajectory) and same) or envs.random_start:
        raise ValueError("envs: must have one and the same reference, and start at its start")
    check_policy(policy, envs, reference)
    observation, info = envs.reset(seed=seed)
    policy.reset(np.random.default_rng(seed))
    steps = control_steps(reference.duration, envs.control_period)
    states, voltages = np.empty((steps + 1, 6, envs.num_envs)), np.empty((steps, 2, envs.num_envs))
    states[0] = info["state"].T
    flown = np.full(envs.num_envs, steps)  # control periods of each flight, before the next one starts
    for k in range(steps):
        if hasattr(policy, "act"):
            action = policy.act(observation).T
        else:
            u = policy(k * envs.control_period, info["measurement"].T)
            action = to_action(u, envs.voltage_limits, envs.hover_voltage)
        observation, _, terminated, _, info = envs.step(action.T)
        states[k + 1], voltages[k] = info["state"].T, info["voltage"].T
        flown[terminated] = np.minimum(flown[terminated], k + 1)
    t = envs.control_period * np.arange(steps + 1)
    return [
        Trajectory(
            t[: n + 1], states[: n + 1, :, i].T, voltages[[*range(n), n - 1], :, i].T, reference.limits, envs.rig
        )
        for i, n in enumerate(flown)
    ]


def fly_repeatedly(env: gym.Env, base: ModelPolicy, flights: int = 10, seed: int = 0) -> list[Trajectory]:
    """Fly one helicopter repeatedly from one start, with iterative learning control of a model-based policy.

    Args:
        env: as for `fly`.
        base: model-based policy, for example `make_policy("kalman-lqr", reference)`.
        flights: number of flights.
        seed: of every episode: same draw, start and noise.
    """
    policy, flown = LearnedFeedforward(base), []
    for _ in range(flights):
        flown.append(fly(env, policy, seed=seed))
        policy.learn()
    return flown


def check_policy(policy: Policy, env: Heli3DOFEnv | Heli3DOFVectorEnv, reference: Trajectory) -> None:
    """Raise ValueError for a policy with another control period, amplifier, rig or reference.

    The check uses the policy's optional attributes `control_period` (s), `voltage_limits` (V), `rig` and
    `reference_states` (6, K + 1) on the control grid.
    """
    name = f"policy: this {type(policy).__name__} was made for"
    period = getattr(policy, "control_period", env.control_period)
    if period != env.control_period:
        raise ValueError(f"{name} a control period of {period:g} s, and env has {env.control_period:g} s")
    low, high = getattr(policy, "voltage_limits", env.voltage_limits)
    if (low, high) != env.voltage_limits:
        raise ValueError(
            f"{name} an amplifier of {low:g} to {high:g} V, and env's gives "
            f"{env.voltage_limits[0]:g} to {env.voltage_limits[1]:g} V"
        )
    rig = getattr(policy, "rig", None)
    if isinstance(rig, Rig) and rig.name != UNNAMED:
        check_same_rig(f"policy: this {type(policy).__name__}", rig, env.rig, "env's")
    states = getattr(policy, "reference_states", None)
    if states is not None:
        x, _ = control_grid(reference, env.control_period)
        last = states.shape[1] - 1
        if states.shape != x.shape:
            raise ValueError(
                f"{name} a reference of {last * period:g} s, and env's takes {(x.shape[1] - 1) * period:g} s"
            )
        apart = np.abs(states - x).max(axis=0)
        if apart.max() > SAME_REFERENCE:
            k = int(apart.argmax())
            raise ValueError(
                f"{name} another reference than env's: at {k * period:g} s they are {apart[k]:.3g} rad or rad/s apart"
            )
