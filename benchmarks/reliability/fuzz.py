"""Odd actions and configurations: each a finite result inside the observation space, or an error that names it."""

import collections
import math
import os
import random
import re
import resource
import tempfile
import time
import warnings
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np

from heli_gym import HelicopterParameters, Limits, Maneuver, Rig, Trajectory
from heli_gym.baselines import InfeasibleManeuver, ManeuverSampler, make_policy, plan, plan_fastest
from heli_gym.baselines.control.policies import POLICIES
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.parameters import Coupling
from heli_gym.plant import (
    PLANTS,
    Friction,
    Gust,
    MovingMass,
    OneOf,
    Plant,
    Push,
    RotorFault,
    Rotors,
    Sensors,
    Table,
    ThrustDrift,
    Uniform,
)
from heli_gym.rig import rig_names
from heli_gym.rigid_body import RigidBodyParameters
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustMap
from heli_gym.vector_env import Heli3DOFVectorEnv

SECONDS, BYTES = 5.0, 2 * 2**30
ACTIONS, CONFIGURATIONS = 1_000_000, 10_000
NUMBERS = (0.0, -0.0, 1.0, -1.0, 0.5, 12.0, 1e-300, 5e-324, 1e-6, 1e3, 1e6, 1e30, 1e39, 1e300, 1.7e308, -1e300)
ODD = (math.nan, math.inf, -math.inf, 10**400, -(10**400), 10**5000, True, None, "1", "", "é\0", b"1", 1j, [], {}, (1,))
DTYPES = ("f2", "f4", "f8", ">f4", ">f8", "g", "i1", "u8", "?", "c8", "U4", "O", "M8[s]")
SHAPES = ((2,), (2,), (2,), (1, 2), (2, 1), (), (0,), (3,), (2, 2))


def odd_array(rng: random.Random, shape: tuple[int, ...]) -> Any:
    """Array of any dtype with values of any size."""
    size, dtype = math.prod(shape), rng.choice(DTYPES)
    values = [
        rng.choice((*NUMBERS, math.nan, math.inf)) if rng.random() < 0.3 else rng.uniform(-2, 2) for _ in range(size)
    ]
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            array = np.array(values, "f8").astype(dtype).reshape(shape)
        except (TypeError, ValueError, OverflowError):
            return values
    kind = rng.randrange(6)
    if kind == 0 and array.ndim:
        return np.repeat(array, 2, axis=0)[::2]  # not contiguous
    if kind == 1:
        return np.ma.masked_array(array)
    return array.tolist() if kind == 2 else array


def odd_action(rng: random.Random) -> Any:
    """Action of any type."""
    if rng.random() < 0.5:
        return np.array([rng.uniform(-1, 1), rng.uniform(-1, 1)], rng.choice(("f4", "f8")))
    if rng.random() < 0.3:
        return [rng.choice(NUMBERS + ODD) for _ in range(rng.choice((1, 2, 2, 2, 3)))]
    if rng.random() < 0.1:
        return rng.choice(ODD)
    return odd_array(rng, rng.choice(SHAPES))


def is_inside(space: gym.Space, observation: np.ndarray) -> bool:
    """Whether all numbers are finite and within the bounds."""
    return bool(
        np.isfinite(observation).all() and (observation >= space.low).all() and (observation <= space.high).all()
    )


def fly_actions(count: int, rng: random.Random) -> collections.Counter:
    """Steps of single environments of each plant."""
    found: collections.Counter = collections.Counter()
    envs = [Heli3DOFEnv(plant, start_spread_deg=5.0) for plant in PLANTS]
    for k, env in enumerate(envs):
        env.reset(seed=k)
    for _ in range(count):
        env, action = rng.choice(envs), odd_action(rng)
        before = env.simulation.blocks.copy() if rng.random() < 0.01 else None
        try:
            observation, reward, terminated, truncated, info = env.step(action)
        except ValueError as error:
            found["refused by name" if str(error).startswith("action") else f"not named: {error}"] += 1
            if before is not None and not np.array_equal(before, env.simulation.blocks, equal_nan=True):
                found["changed by a refused action"] += 1
            continue
        except Exception as error:
            found[f"{type(error).__name__}: {error} from {action!r}"[:200]] += 1
            continue
        numbers = [reward, info["time"], info["cost"], *info["state"], *info["measurement"], *info["voltage"]]
        good = is_inside(env.observation_space, observation) and all(map(math.isfinite, numbers))
        found["finite and inside" if good else f"outside the space or not finite from {action!r}"[:200]] += 1
        if terminated or truncated:
            env.reset()
    return found


def fly_vector_actions(count: int, rng: random.Random) -> collections.Counter:
    """Steps of vector environments of each plant in each precision and mode."""
    found: collections.Counter = collections.Counter()
    n = 5
    envs = [
        Heli3DOFVectorEnv(n, plant, start_spread_deg=5.0, dtype=dtype, autoreset_mode=mode)
        for plant in PLANTS
        for dtype in ("float64", "float32")
        for mode in ("NextStep", "SameStep")
    ]
    for k, env in enumerate(envs):
        env.reset(seed=k)
    for _ in range(count):
        env = rng.choice(envs)
        actions = odd_array(rng, (n, 2)) if rng.random() < 0.7 else odd_action(rng)
        try:
            observation, rewards, _, _, info = env.step(actions)
        except ValueError as error:
            found["refused by name" if str(error).startswith("action") else f"not named: {error}"] += 1
            continue
        except Exception as error:
            found[f"{type(error).__name__}: {error} from {actions!r}"[:200]] += 1
            continue
        good = is_inside(env.observation_space, observation) and bool(np.isfinite(rewards).all())
        good = good and all(np.isfinite(info[name]).all() for name in ("state", "measurement", "voltage", "cost"))
        found["finite and inside" if good else f"outside the space or not finite from {actions!r}"[:200]] += 1
    return found


# Configurations


class Draw:
    """Random arguments; `names` are those that were given, one of which an error must name."""

    def __init__(self, seed: int, folder: Path) -> None:
        self.rng, self.folder, self.names = random.Random(seed), folder, set()

    def number(self, name: str, low: float, high: float, odd: float = 0.08) -> Any:
        """Number in a range, or an odd one."""
        self.names.add(name)
        if self.rng.random() < odd:
            return self.rng.choice(NUMBERS + ODD)
        if self.rng.random() < 0.1:
            return self.rng.choice((low, high))
        return self.rng.uniform(low, high)

    def maybe_range(self, name: str, low: float, high: float) -> Any:
        """Number, or a range of draws."""
        self.names.add(name)
        if self.rng.random() < 0.2:
            ends = sorted(self.rng.uniform(low, high) for _ in range(2))
            return Uniform(*ends)
        return self.number(name, low, high)

    def choice(self, name: str, good: Any, odd: float = 0.08) -> Any:
        """One of the good values, or an odd one."""
        self.names.add(name)
        return self.rng.choice(NUMBERS + ODD) if self.rng.random() < odd else self.rng.choice(list(good))

    def several(self, options: dict[str, Any]) -> dict[str, Any]:
        """Some of the arguments, made by calls without arguments."""
        given = {}
        for name, make in options.items():
            if self.rng.random() < 0.3:
                self.names.add(name)
                given[name] = make()
        return given

    def parameters(self) -> HelicopterParameters:
        base = HelicopterParameters()._asdict()
        scale = self.rng.choice((1.5, 10.0, 1e3))
        return HelicopterParameters(
            **{
                name: self.maybe_range(name, *sorted((value / scale, value * scale)))
                if self.rng.random() < 0.2
                else value
                for name, value in base.items()
            }
        )

    def triple(self, name: str, low: float, high: float) -> Any:
        return tuple(self.maybe_range(name, low, high) for _ in range(3))

    def curve(self) -> Any:
        if self.rng.random() < 0.5:
            return PowerCurve(
                self.maybe_range("k_plus", 1e-4, 1.0),
                self.maybe_range("k_minus", -1.0, 0.0),
                self.maybe_range("exponent", 0.5, 2.0),
                self.maybe_range("dead_zone", 0.0, 3.0),
            )
        n = self.rng.choice((1, 2, 3, 8))
        self.names |= {"voltages", "thrusts"}
        up = sorted(self.rng.uniform(-12, 24) for _ in range(n)) if n < 8 else list(range(n))
        return TableCurve(tuple(up), tuple(0.1 * k for k in range(n)))

    def disturbance(self) -> Any:
        axis, rotor = self.choice("axis", ("travel", "elevation", "pitch")), self.choice("rotor", ("front", "back"))
        when, duration = self.number("time", 0.0, 10.0), self.number("duration", 1e-3, 100.0)
        strength = self.maybe_range("acceleration", -1000.0, 1000.0)
        self.names |= {"a2_change", "correlation_time"}  # as some kinds call acceleration and duration
        return self.rng.choice(
            (
                lambda: Push(axis, strength, when, duration),
                lambda: Gust(axis, self.number("strength", 0.0, 1000.0), duration),
                lambda: MovingMass(strength, when, duration),
                lambda: RotorFault(rotor, self.number("loss", 0.0, 1.0), when),
                lambda: ThrustDrift(self.maybe_range("loss", -1.0, 1.0), when, duration),
            )
        )()

    def plant(self) -> Any:
        if self.rng.random() < 0.3:
            return self.choice("plant", PLANTS)
        rng = self.rng
        parts = {
            "parameters": self.parameters,
            "rig": lambda: PLANTS["rigid"].rig if rng.random() < 0.8 else self.body(),
            "rotors": lambda: Rotors(
                **self.several(
                    {
                        "lag": lambda: self.maybe_range("lag", 0.0, 2.0),
                        "thrust_loss": lambda: self.maybe_range("thrust_loss", 0.0, 1.0),
                        "slew": lambda: self.number("slew", 0.0, 1e4),
                        "delay": lambda: self.maybe_range("delay", 0.0, 0.5),
                        "gains": lambda: tuple(self.maybe_range("gains", 0.0, 10.0) for _ in range(2)),
                    }
                )
            ),
            "friction": lambda: Friction(self.triple("viscous", 0.0, 1000.0), self.triple("coulomb", 0.0, 20.0)),
            "sensors": lambda: Sensors(
                **self.several(
                    {
                        "counts": lambda: tuple(self.choice("counts", (1, 256, 8192, 2**31)) for _ in range(3)),
                        "noise": lambda: self.maybe_range("noise", 0.0, 1.0),
                        "rate_filter": lambda: self.maybe_range("rate_filter", 1e-3, 10.0),
                        "zeros": lambda: self.triple("zeros", -3.0, 3.0),
                    }
                )
            ),
            "disturbances": lambda: tuple(self.disturbance() for _ in range(rng.choice((1, 2, 3, 30)))),
            "thrust_map": lambda: rng.choice((self.curve, lambda: ThrustMap(self.curve(), self.curve())))(),
            "hover_voltage": lambda: self.maybe_range("hover_voltage", 0.1, 12.0),
            "coupling": lambda: Coupling(*(self.number("coupling", -0.7, 0.7) for _ in Coupling._fields)),
            "travel_lift": lambda: self.maybe_range("travel_lift", -10.0, 10.0),
            "table": lambda: Table(self.maybe_range("elevation", -1.5, 1.5), self.maybe_range("friction", 0.0, 10.0)),
        }
        made = self.several(parts)
        if rng.random() < 0.1 and made:
            name = rng.choice(list(made))
            made[name] = OneOf((made[name], made[name])) if rng.random() < 0.7 else self.choice(name, ODD)
        return Plant(**made)

    def body(self) -> RigidBodyParameters:
        base = PLANTS["rigid"].alternatives[0].rig
        return base._replace(
            **{name: self.maybe_range(name, 0.01, 10.0) for name in base._fields if self.rng.random() < 0.3}
        )

    def limits(self) -> Limits:
        return Limits(
            **self.several(
                {
                    "u_min": lambda: self.number("u_min", 0.0, 5.0),
                    "u_max": lambda: self.number("u_max", 6.0, 12.0),
                    "pitch_min": lambda: self.number("pitch_min", -1.3, -0.2),
                    "pitch_max": lambda: self.number("pitch_max", 0.2, 1.3),
                    "elevation_min": lambda: self.number("elevation_min", -0.5, -0.1),
                    "elevation_max": lambda: self.number("elevation_max", 0.1, 0.5),
                    "travel_rate": lambda: self.number("travel_rate", 0.5, 3.0),
                    "elevation_rate": lambda: self.number("elevation_rate", 0.1, 1.0),
                    "slew": lambda: self.number("slew", 1.0, 100.0),
                }
            )
        )

    def rig(self) -> Any:
        if self.rng.random() < 0.5:
            return self.choice("rig", rig_names())
        return Rig(
            "drawn",
            **self.several(
                {
                    "parameters": self.parameters,
                    "thrust_map": lambda: ThrustMap(self.curve(), self.curve()),
                    "voltage_limits": lambda: (
                        self.number("voltage_limits", -24, 1),
                        self.number("voltage_limits", 9, 24),
                    ),
                    "pitch_limit": lambda: self.number("pitch_limit", 0.2, 1.5),
                    "table_elevation": lambda: self.number("table_elevation", -1.0, 1.0),
                    "encoder_counts": lambda: tuple(self.choice("encoder_counts", (1, 8192)) for _ in range(3)),
                    "sample_time": lambda: self.number("sample_time", 1e-4, 1.0),
                    "lag": lambda: self.number("lag", 0.0, 1.0),
                    "delay": lambda: self.number("delay", 0.0, 0.3),
                    "sensor_signs": lambda: tuple(self.choice("sensor_signs", (1, -1)) for _ in range(3)),
                    "sensor_zeros": lambda: tuple(self.number("sensor_zeros", -1, 1) for _ in range(3)),
                    "limits": self.limits,
                }
            ),
        )

    def trajectory(self) -> Trajectory:
        self.names |= {"t", "x", "u"}
        n = self.rng.choice((1, 2, 5, 50))
        t = np.linspace(0.0, self.rng.choice((1e-3, 1.0, 20.0, 3600.0, 1e5)), n)
        x = np.array([[self.rng.uniform(-0.3, 0.3) for _ in range(n)] for _ in range(6)])
        u = np.full((2, n), self.rng.choice((6.0, 0.0, 1e3)))
        if self.rng.random() < 0.1:
            x[0, -1] = self.rng.choice(NUMBERS[:12])
        return Trajectory(t, x, u, self.limits() if self.rng.random() < 0.2 else Limits())

    def file(self) -> str:
        """Path of a file with odd contents, or of none."""
        self.names.add("reference")
        path = self.folder / f"{self.rng.randrange(10**9)}{self.rng.choice(('.npz', '.npz', '.toml', ''))}"
        kind = self.rng.randrange(5)
        if kind == 0:
            path.write_bytes(self.rng.randbytes(self.rng.choice((0, 1, 100, 5000))))
        elif kind == 1:
            data = bytearray((Path(__import__("heli_gym").__file__).parent / "references/climb-15.npz").read_bytes())
            for _ in range(self.rng.choice((1, 10))):
                data[self.rng.randrange(len(data))] ^= 1 << self.rng.randrange(8)
            path.write_bytes(data[: self.rng.choice((len(data), len(data) // 2))])
        elif kind == 2:
            np.savez(path.open("wb"), t=np.zeros(3), x=np.zeros(3))
        elif kind == 3:
            path.mkdir()
        return str(path)

    def reference(self) -> Any:
        kind = self.rng.random()
        if kind < 0.4:
            return self.choice("reference", ("travel-360", "climb-15", "take-off"))
        if kind < 0.7:
            return self.trajectory()
        return self.file() if kind < 0.8 else self.sampler() if kind < 0.85 else "travel-360"

    def sampler(self) -> ManeuverSampler:
        return ManeuverSampler(
            **self.several(
                {
                    "duration": lambda: self.number("duration", 8.0, 20.0),
                    "travel": lambda: (0.0, self.number("travel", 0.1, 3.0)),
                    "elevation": lambda: (-0.1, self.number("elevation", 0.0, 0.1)),
                    "limits": self.limits,
                }
            )
        )

    def env(self) -> dict[str, Any]:
        options = {
            "plant": self.plant,
            "reference": self.reference,
            "control_period": lambda: self.number("control_period", 1e-4, 0.05),
            "pitch_limit": lambda: self.number("pitch_limit", 0.2, 1.57),
            "voltage_limits": lambda: (self.number("voltage_limits", -24, 0), self.number("voltage_limits", 9, 24)),
            "start_spread_deg": lambda: self.number("start_spread_deg", 0.0, 40.0),
            "random_start": lambda: self.choice("random_start", (True, False)),
            "render_mode": lambda: self.choice("render_mode", (None, "rgb_array")),
            "rig": self.rig,
        }
        return self.several(options)

    def vector(self) -> dict[str, Any]:
        options = {
            "num_envs": lambda: self.choice("num_envs", (1, 2, 5, 300)),
            "dtype": lambda: self.choice("dtype", ("float64", "float32")),
            "autoreset_mode": lambda: self.choice("autoreset_mode", ("NextStep", "SameStep", "Disabled")),
            "max_episode_steps": lambda: self.choice("max_episode_steps", (None, 1, 7)),
            "threads": lambda: self.choice("threads", (1, 2)),
        }
        chosen = self.env() | self.several(options)
        if isinstance(chosen.get("reference"), ManeuverSampler) and chosen.get("num_envs") == 300:
            chosen["num_envs"] = 20  # each plans a maneuver of its own
        return chosen

    def reset_options(self, n: int | None) -> dict[str, Any]:
        self.names |= {"seed", "options"}
        state = [self.number("state", -0.1, 0.1) for _ in range(6)]
        if self.rng.random() < 0.3:
            state = odd_array(self.rng, self.rng.choice(((6,), (3,), (2, 6), (n or 1, 6))))
        options = {"state": lambda: state, "plant": self.plant}
        if n:
            options["time"] = lambda: odd_array(self.rng, (n,))
            options["reset_mask"] = lambda: np.array([self.rng.random() < 0.5 for _ in range(n)])
        chosen = self.several(options)
        if self.rng.random() < 0.05:
            chosen[self.rng.choice(("stat", "", "é"))] = 1
        return {
            "seed": self.choice("seed", (None, 0, 2**40)),
            "options": chosen if self.rng.random() < 0.9 else self.choice("options", ({},)),
        }


def try_env(draw: Draw) -> str:
    """Make an environment, reset it with options, fly a few steps."""
    env = Heli3DOFEnv(**draw.env())
    observation, _ = env.reset(**(draw.reset_options(None) if draw.rng.random() < 0.5 else {"seed": 1}))
    for _ in range(4):
        if not is_inside(env.observation_space, observation):
            return "outside the space"
        observation, reward, terminated, truncated, info = env.step(np.array([draw.rng.uniform(-1, 1)] * 2))
        numbers = [reward, info["cost"], *info["state"], *info["measurement"], *info["voltage"]]
        if not all(map(math.isfinite, numbers)):
            return "not finite"
        if terminated or truncated:
            break
    return "finite and inside" if is_inside(env.observation_space, observation) else "outside the space"


def try_vector_env(draw: Draw) -> str:
    """Likewise, a vector environment."""
    env = Heli3DOFVectorEnv(**draw.vector())
    env.reset(seed=3)
    if draw.rng.random() < 0.5:
        env.reset(**draw.reset_options(env.num_envs))
    for _ in range(4):
        try:
            observation, rewards, _, _, info = env.step(np.full((env.num_envs, 2), draw.rng.uniform(-1, 1)))
        except gym.error.ResetNeeded:
            break
        if not is_inside(env.observation_space, observation):
            return "outside the space"
        if not all(np.isfinite(values).all() for values in (rewards, info["state"], info["measurement"], info["cost"])):
            return "not finite"
    return "finite and inside"


def try_plan(draw: Draw) -> str:
    """Plan a maneuver within a time limit."""
    maneuver = Maneuver(
        **draw.several(
            {
                "start": lambda: (draw.number("start", -1, 1), draw.number("start", -0.1, 0.1)),
                "goal": lambda: (draw.number("goal", -7, 7), draw.number("goal", -0.2, 0.2)),
                "duration": lambda: draw.number("duration", 1.0, 30.0),
                "limits": draw.limits,
                "parameters": draw.parameters,
                "rig": draw.rig,
                "floor": lambda: ((0.0, draw.number("floor", 0.1, 3.0)), (0.3, draw.number("floor", -0.1, 0.3))),
                "via": lambda: (
                    (draw.number("via", 0.5, 5.0), draw.number("via", -3, 3), draw.choice("via", (None, 0.1))),
                ),
                "periodic": lambda: draw.choice("periodic", (False,)),
                "goal_state": lambda: tuple(draw.number("goal_state", -0.3, 0.3) for _ in range(6)),
            }
        )
    )
    if draw.rng.random() < 0.7:
        return "made"
    limit = draw.number("time_limit", 0.1, 3.0, odd=0.02)
    if draw.rng.random() < 0.3:
        found = plan_fastest(maneuver, draw.choice("method", ("auto", "flat")), draw.number("reserve", 0, 0.5), limit)
    else:
        found = plan(maneuver, draw.choice("method", ("auto", "spline", "flat", "paper")), limit)
    return "planned" if np.isfinite(found.x).all() else "not finite"


def try_policy(draw: Draw) -> str:
    """Make a policy and call it."""
    cheap = [name for name in POLICIES if "mpc" not in name]
    draw.names.add("reference")
    options = draw.several(
        {
            "parameters": draw.parameters,
            "rig": draw.rig,
            "voltage_limits": lambda: (draw.number("voltage_limits", -10, 0), draw.number("voltage_limits", 9, 24)),
            "control_period": lambda: draw.choice("control_period", (0.02, 0.05)),
            "weights": lambda: draw.choice("weights", (None,)),
        }
    )
    reference = find_reference("climb-15") if draw.rng.random() < 0.9 else draw.reference()
    policy = make_policy(draw.choice("name", cheap), reference, **options)
    policy.reset(np.random.default_rng(0))
    u = policy(0.0, reference.x[:, 0])
    return "finite and inside" if np.isfinite(u).all() else "not finite"


KINDS = ((try_env, 0.45), (try_vector_env, 0.35), (try_plan, 0.12), (try_policy, 0.08))
DOCUMENTED = (ValueError, InfeasibleManeuver, gym.error.ResetNeeded)


def try_one(k: int, draw: "Draw") -> tuple[str, str]:
    """Outcome of one configuration, and the name of what was tried."""
    [attempt] = draw.rng.choices([kind for kind, _ in KINDS], [share for _, share in KINDS])
    name = attempt.__name__
    try:
        return attempt(draw), name
    except DOCUMENTED as error:
        text = str(error)
        words = re.findall(r"\w+", re.sub(r" = .*?: ", ": ", text, flags=re.S))  # a value may hold other names
        is_named = isinstance(error, InfeasibleManeuver) or not draw.names.isdisjoint(words)
        return "refused by name" if is_named else f"{k} not named: {text}"[:200], name
    except TypeError as error:
        return "refused by name" if "reset_mask" in str(error) else f"{k} {name} TypeError: {error}"[:200], name
    except Exception as error:
        return f"{k} {name} {type(error).__name__}: {error}"[:200], name


def configure(count: int, seed: int) -> tuple[collections.Counter, float]:
    """Try configurations; outcomes and the longest time in s."""
    found: collections.Counter = collections.Counter()
    longest = 0.0
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for k in range(count):
            for _ in range(2):  # compilation, which one of them may be the first to cause, does not count
                began = time.process_time()
                outcome, attempt = try_one(k, Draw(seed * count + k, Path(folder)))
                took = time.process_time() - began
                if took <= SECONDS:
                    break
            longest = max(longest, took)
            if took > SECONDS:
                outcome = f"{k} {attempt} took {took:.1f} s"
            elif outcome in ("outside the space", "not finite"):
                outcome = f"{k} {attempt} {outcome}"
            found[outcome] += 1
    return found, longest


SHARE = 1.0
GOOD = ("finite and inside", "refused by name", "made", "planned")


def show(title: str, found: collections.Counter) -> int:
    """Print outcomes, and return the number of bad ones."""
    bad = sum(count for outcome, count in found.items() if outcome not in GOOD)
    print(
        f"{title}: {sum(found.values())} tried, {bad} faults; "
        + ", ".join(f"{found[name]} {name}" for name in GOOD if found[name])
    )
    for outcome, count in found.most_common():
        if outcome not in GOOD:
            print(f"    {count} x {outcome}")
    return bad


def warm_up(only: str) -> None:
    """Compile the kernels, which the time limit of a configuration does not cover."""
    if only == "actions":
        return
    table = Table()
    plants = [*PLANTS.values(), Plant(rotors=Rotors(lag=0.1)), Plant(friction=Friction((1.0,) * 3)), Plant(table=table)]
    plants += [Plant(rig=PLANTS["rigid"].rig, table=table)]
    for plant in plants:
        env = Heli3DOFEnv(plant)
        env.reset(seed=0)
        env.step(np.zeros(2))
        for dtype in ("float64", "float32"):
            vector = Heli3DOFVectorEnv(2, plant, dtype=dtype)
            vector.reset(seed=0)
            vector.step(np.zeros((2, 2)))
    for method in ("auto", "spline", "flat", "paper"):
        plan(Maneuver(duration=20.0), method)
    plan_fastest(Maneuver())
    for name in POLICIES:
        if "mpc" not in name:
            make_policy(name, find_reference("climb-15"))


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    warm_up(only)
    actions, configurations = (20_000, 300) if quick else (int(SHARE * ACTIONS), int(SHARE * CONFIGURATIONS))
    bad = 0
    if only in ("", "actions"):
        bad += show("actions, single environments", fly_actions(actions * 4 // 5, random.Random(seed)))
        bad += show("actions, vector environments", fly_vector_actions(actions // 5, random.Random(seed + 1)))
    if only in ("", "configurations"):
        found, longest = configure(configurations, seed)
        bad += show("configurations", found)
        print(f"longest configuration: {longest:.1f} s of CPU time; at most {SECONDS:g} s")
    peak = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"peak memory of the process: {peak / 2**30:.2f} GB; at most {BYTES / 2**30:g} GB")
    return int(bad > 0 or peak > BYTES)


os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
