"""Fly by keyboard: `heli-play`, and with `--assist` through the paper's feedback.

The arrow keys raise and lower the helicopter and turn it left (counter-clockwise seen from above) or right. Without
`--assist` they change the two voltages about hover; with it they move the set-point of the regulator (49)-(51). The
ghost shows the reference to track. Escape ends.
"""

import argparse
import math
import sys
import warnings
from itertools import combinations
from typing import Any, NoReturn

import gymnasium as gym
import numpy as np
from scipy.linalg import solve_continuous_are

from heli_gym.cli import command, print_version
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.model import fan_thrusts, hover_input, inverse_dynamics, linearise, thrust_vector
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import NOMINAL_RIGS
from heli_gym.rendering import has_display, load_pygame
from heli_gym.rig import PAPER, Rig
from heli_gym.task import TOLERANCE
from heli_gym.validation import real_array, shown

LIFT, ROLL = 1.5, 0.6  # V on each fan while a key is pressed
FASTEST = np.array((0.9, 0.15))  # rad/s, travel and elevation rates of the set-point while a key is pressed
PACE = np.array((0.8, 2.0))  # 1/s, bandwidth from the keys to these rates
# Tolerance of a thrust as a share of that of hover; on the paper's rig it is the thrust of 6 V, as in the reward.
EFFORT = float(PAPER.thrust(np.full(2, 6.0))[0] / (0.5 * hover_input(0.0, PAPER.parameters)[0]))
FARTHEST = math.radians(12.0)  # rad, of its elevation, up and down: hover thrust is zero at 18.6 deg down


class Assist(gym.Wrapper):
    """Wrapper in which the paper's feedback flies to a set-point moved by the player.

    Actions are `Box(-1, 1, (2,), float32)`: commanded travel and elevation rates of the set-point in units of
    `fastest`. Its rates follow with a double lag, so that rates and accelerations are continuous.
    """

    def __init__(self, env: gym.Env) -> None:
        super().__init__(env)
        self.helicopter: Heli3DOFEnv = env.unwrapped  # type: ignore[assignment]
        self.rig = self.helicopter.rig
        self.gain = hold_gain(self.rig)
        # a narrower pitch stop permits less acceleration of the travel
        self.fastest = FASTEST * np.array((min(1.0, self.rig.pitch_limit / PAPER.pitch_limit), 1.0))
        self.highest, self.lowest = elevation_range(self.rig)

    def reset(self, **options: Any) -> tuple[np.ndarray, dict[str, Any]]:
        """Reset the environment, and put the set-point at the helicopter's position, at rest."""
        observation, info = self.env.reset(**options)
        self.measurement = info["measurement"]
        self.position, self.rate, self.acceleration = self.measurement[[0, 2]], np.zeros(2), np.zeros(2)
        return observation, info

    def step(self, action: Any) -> tuple[np.ndarray, Any, bool, bool, dict[str, Any]]:
        """Move the set-point by the player's command, and fly one control period towards it."""
        given = real_array(action)
        if given is None or given.shape != (2,) or not np.isfinite(given).all():
            raise ValueError(f"action = {shown(action)}: must be two finite real numbers")
        period = self.helicopter.control_period
        commanded = self.fastest * np.clip(given, -1.0, 1.0)
        rest = self.position + (2.0 * PACE * self.rate + self.acceleration) / PACE**2  # where it would stop
        if commanded[1] * rest[1] > 0.0 and not self.highest < rest[1] < self.lowest:
            commanded[1] = 0.0
        jerk = PACE * (PACE * (commanded - self.rate) - 2.0 * self.acceleration)
        self.position = self.position + period * self.rate
        self.rate = self.rate + period * self.acceleration
        self.acceleration = self.acceleration + period * jerk
        x, v = set_point(self.position, self.rate, self.acceleration, self.rig.parameters)
        u = self.rig.voltage(fan_thrusts(v - self.gain @ (self.measurement - x)))
        observation, reward, terminated, truncated, info = self.env.step(self.helicopter.to_action(u))
        self.measurement = info["measurement"]
        return observation, reward, terminated, truncated, info


def elevation_range(rig: Rig) -> tuple[float, float]:
    """Elevation range in rad of the set-point: within FARTHEST of level, where the rig hovers within its limits."""
    least, most = rig.thrust_bounds(rig.limits.u)
    elevations = np.linspace(-FARTHEST, FARTHEST, 241)
    half = 0.5 * hover_input(elevations, rig.parameters)[0]
    held = elevations[(least < half) & (half < most)]
    return float(held.min()), float(held.max())


def hold_gain(rig: Rig = PAPER) -> np.ndarray:
    """Gain K (2, 6) of (51) at hover, from the stationary solution of (50).

    The weights follow from the reward's tolerances by Bryson's rule.
    """
    parameters = rig.parameters
    lift = hover_input(0.0, parameters)
    A, B = linearise(np.zeros(6), lift, parameters)
    R = np.eye(2) / (EFFORT * 0.5 * float(lift[0])) ** 2
    P = solve_continuous_are(A, B, np.diag(1.0 / np.square(TOLERANCE)), R)
    return np.linalg.solve(R, B.T @ P)


def set_point(
    position: np.ndarray, rate: np.ndarray, acceleration: np.ndarray, parameters: HelicopterParameters
) -> tuple[np.ndarray, np.ndarray]:
    """State (6,) and virtual input (2,) in N at which (3) has the given accelerations, with constant pitch.

    Position, rate and acceleration are (2,), travel and elevation, in rad and s.
    """
    x = np.array((position[0], rate[0], position[1], rate[1], 0.0, 0.0))
    x[4] = math.atan2(*thrust_vector(x, acceleration[0], acceleration[1], parameters))
    return x, np.array(inverse_dynamics(x, acceleration[1], 0.0, parameters))


def keyboard(hover: np.ndarray, up: np.ndarray, left: np.ndarray) -> dict[tuple[int, ...], np.ndarray]:
    """Map every combination of the arrow keys to its action (2,); opposite keys cancel."""
    pygame = load_pygame()
    effects = {pygame.K_UP: up, pygame.K_DOWN: -up, pygame.K_LEFT: left, pygame.K_RIGHT: -left}
    return {
        keys: hover + sum(effects[key] for key in keys)
        for count in range(1, len(effects) + 1)
        for keys in combinations(effects, count)
    }


def mapping(env: gym.Env) -> tuple[dict[tuple[int, ...], np.ndarray], np.ndarray]:
    """Actions (2,), float32, of the arrow keys in an environment, and the action without a key."""
    rest = np.zeros(2, dtype=np.float32)  # hover, or no command to the feedback
    if isinstance(env, Assist):
        up = np.sign(env.rig.parameters.b2)  # of the elevation, which is positive downwards where b2 < 0
        commands = keyboard(rest, np.array((0.0, up)), np.array((1.0, 0.0)))
        return {keys: np.clip(command, -1.0, 1.0).astype(np.float32) for keys, command in commands.items()}, rest
    helicopter: Heli3DOFEnv = env.unwrapped  # type: ignore[assignment]
    hover = helicopter.hover_voltage
    low, high = helicopter.rig.voltage_limits
    share = (high - low) / 12.0  # of the paper's amplifier
    turn = -np.sign(helicopter.rig.parameters.b1 * helicopter.rig.parameters.b3)
    # Less front thrust tilts the helicopter so that the travel grows, since b1 < 0 in (3).
    voltages = keyboard(hover, share * LIFT * np.ones(2), share * ROLL * turn * np.array((-1.0, 1.0)))
    return {keys: helicopter.to_action(u).clip(-1.0, 1.0).astype(np.float32) for keys, u in voltages.items()}, rest


def main(arguments: list[str] | None = None) -> None:
    """Run the command `heli-play`."""
    with command("heli-play"):
        run(sys.argv[1:] if arguments is None else arguments)


class Parser(argparse.ArgumentParser):
    """Parser whose errors are ValueErrors, one line each like those of all commands."""

    def error(self, message: str) -> NoReturn:
        """Raise ValueError with the message."""
        raise ValueError(f"{message}; see heli-play --help")


def run(arguments: list[str]) -> None:
    """Parse the arguments and fly."""
    parser = Parser(prog="heli-play", allow_abbrev=False, description=__doc__.partition("\n\n")[2])
    parser.add_argument("--assist", action="store_true", help="let the paper's feedback help")
    parser.add_argument("--plant", default="nominal", help="nominal, lab, rigid or fleet (default: %(default)s)")
    parser.add_argument("--reference", default="travel-360", help="name or .npz file (default: %(default)s)")
    parser.add_argument("--rig", help="name or .toml file (default: the plant's)")
    parser.add_argument("--force", action="store_true", help="fly a plan that is for another rig")
    parser.add_argument("--seed", type=int, help="of the first episode (default: none)")
    print_version("heli-play", arguments)
    args = parser.parse_args(arguments)
    if args.seed is not None and args.seed < 0:
        raise ValueError(f"seed = {args.seed}: must be at least 0")
    rig = args.rig or NOMINAL_RIGS.get(args.plant, PAPER.name)
    env: gym.Env = Heli3DOFEnv(
        args.plant, reference_for(args.reference, rig, args.force), rig=rig, render_mode="rgb_array"
    )
    fly(Assist(env) if args.assist else env, args.seed)


def fly(env: gym.Env, seed: int | None = None) -> None:
    """Fly episodes by keyboard, and print a summary line after each, until Escape or the window is closed.

    Raises gymnasium.error.DependencyNotInstalled without pygame, ValueError without a display.
    """
    actions, rest = mapping(env)
    pygame = load_pygame()
    if not has_display(pygame):
        pygame.display.quit()
        raise ValueError("window: must have a display, and there is none here")
    with warnings.catch_warnings(action="ignore"):  # from matplotlib without Tk, although nothing is plotted
        from gymnasium.utils.play import play  # imports pygame

    rewards = []

    def sum_up(
        before: Any, after: Any, action: Any, reward: float, terminated: bool, truncated: bool, info: dict
    ) -> None:
        rewards.append(reward)
        if terminated or truncated:
            end = "the pitch left its limit" if terminated else "the maneuver is over"
            print(f"{info['time']:.1f} s flown, {sum(rewards):.2f} s of them on the reference: {end}")
            rewards.clear()

    play(env, keys_to_action=actions, noop=rest, seed=seed, callback=sum_up)
    env.close()


if __name__ == "__main__":
    main()
