"""Heli3DOF-v0: one helicopter that is to follow a reference."""

import inspect
import math
from numbers import Real
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.spaces import Box
from numpy.typing import ArrayLike

from heli_gym import task
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP
from heli_gym.plant import Plant, advance, at_rest, find_plant, measure
from heli_gym.trajectory import Trajectory

REFERENCES = Path(__file__).parent / "references"
PERIODS = (1e-4, 0.05)  # s; up to the latter, one Runge-Kutta step through (3) is accurate to 1e-7


def find_reference(reference: str | Trajectory) -> Trajectory:
    """A reference by the name of a packaged one, by the path of an .npz file, or the trajectory itself.

    Raises ValueError for an unknown name, or a file that holds no trajectory.
    """
    if isinstance(reference, Trajectory):
        return reference
    path = Path(reference) if str(reference).endswith(".npz") else REFERENCES / f"{reference}.npz"
    if not path.is_file():
        names = ", ".join(sorted(repr(known.stem) for known in REFERENCES.glob("*.npz")))
        raise ValueError(
            f"reference = {reference!r}: a Trajectory, the path of an existing .npz file or one of {names} is needed"
        )
    try:
        return Trajectory.load(path)
    except ValueError as error:
        raise ValueError(f"reference = {reference!r}: {error}") from error


class Heli3DOFEnv(gym.Env):
    """
    ## Description

    A laboratory helicopter with three degrees of freedom: an arm that turns about a vertical axis (travel) and a
    horizontal one (elevation) carries a counterweight at one end and, at the other, a body with two fans that turns
    about the arm (pitch). Pitch tilts the thrust and so drives the travel: three angles, two voltages, an
    underactuated system. It is to follow a reference: by default the 360 degree travel rotation in 10 s of
    Kiefer, Graichen and Kugi, "Trajectory tracking of a 3DOF laboratory helicopter under input and state
    constraints" (IEEE Transactions on Control Systems Technology 18(4), 2010), planned within 1 to 11 V and
    50 degrees of pitch. Equation numbers are the paper's.

    Three plants:

    | Plant     | What it is                                                                                |
    |-----------|-------------------------------------------------------------------------------------------|
    | `nominal` | (3) with the thrust map (2), exactly                                                      |
    | `lab`     | (3) with rotor lag, friction, thrust loss, one period of delay, encoders, estimated rates |
    | `rigid`   | the full rigid body in one of two variants, with the same actuators, friction and sensors |

    `lab` and `rigid` are drawn anew in every episode, from ranges of published models and data of such rigs. The
    integrator is Runge-Kutta of order four: one step per control period on `nominal`, steps of 5 ms on the others.

    ## Action Space

    A `Box(-1, 1, (2,), float32)`: the voltages of the two fans, -1 and 1 being the amplifier's limits. Beyond them the
    amplifier saturates. NaN, infinity or a wrong shape is a `ValueError`.

    | Num | Action           | Min | Max | Voltage at min | Voltage at max | Hover  |
    |-----|------------------|-----|-----|----------------|----------------|--------|
    | 0   | front fan, `u_f` | -1  | 1   | 0 V            | 12 V           | 7.89 V |
    | 1   | back fan, `u_b`  | -1  | 1   | 0 V            | 12 V           | 7.89 V |

    ## Observation Space

    A `Box` of 49 float32 values: the measured tracking error, the last voltages, then the reference and its nominal
    voltages now and 0.1, 0.2, 0.4 and 0.8 s ahead, and the remaining time. On the nominal plant that makes the task
    Markov. The bounds follow from the greatest acceleration that the model and the amplifier allow, so that nothing is
    clipped.

    | Num    | Observation                                            | Unit  |
    |--------|--------------------------------------------------------|-------|
    | 0      | travel minus reference                                 | rad   |
    | 1      | travel rate minus reference                            | rad/s |
    | 2      | elevation minus reference (positive is down)           | rad   |
    | 3      | elevation rate minus reference                         | rad/s |
    | 4      | pitch minus reference                                  | rad   |
    | 5      | pitch rate minus reference                             | rad/s |
    | 6-7    | last voltages (front, back)                            | V     |
    | 8-13   | reference state now, in the order of 0-5               | rad, rad/s |
    | 14-15  | nominal voltages (front, back) in the coming period    | V     |
    | 16-23  | the same as 8-15, 0.1 s ahead                          |       |
    | 24-31  | 0.2 s ahead                                            |       |
    | 32-39  | 0.4 s ahead                                            |       |
    | 40-47  | 0.8 s ahead                                            |       |
    | 48     | remaining time                                         | s     |

    `info["state"]` is the true state (44), `info["measurement"]` what a controller may use (on the nominal plant the
    same), `info["time"]` the time in s, and `info["plant"]` the plant that was drawn, for analysis only. After a step,
    `info["voltage"]` are the voltages asked for, within the amplifier's limits, and `info["cost"]` is how far they and
    the pitch were outside the limits that the reference was planned under, in widths of these limits times seconds.

    ## Rewards

    `control_period / (1 + e² + d²)` per step, where `e²` is the sum of the squared tracking errors, each in units of
    its tolerance, and `d²` the sum of the squared voltage deviations from the nominal ones, in units of 6 V. The
    tolerances are 3 degrees in travel and elevation, 6 degrees in pitch, and 6, 6 and 30 degrees/s in the rates.
    A return thus counts seconds flown on the reference, 10 at best, and flying on always pays.

    ## Starting State

    The reference's start, at rest. With `start_spread_deg`, each of the three angles is drawn uniformly within that
    distance of it. `reset(options={"state": x})` starts at the state x (6,) instead, within 1 rad and 1 rad/s of the
    reference's start; `reset(options={"plant": plant})` flies another plant in this episode.

    ## Episode End

    Terminated when the pitch leaves `±pitch_limit`. Truncated when the maneuver is over. Then `info["is_success"]`
    tells whether the maneuver was flown to its end and every tracking error is within its tolerance.

    ## Arguments

    - `plant`: "nominal", "lab", "rigid", or a `heli_gym.plant.Plant`, which may combine friction, rotors, sensors,
      pushes, gusts, a moving mass and rotor faults.
    - `reference`: the name of a packaged reference ("travel-360"), the path of an .npz file that `Trajectory.save`
      wrote, or a `Trajectory`.
    - `control_period`: seconds between actions, 0.0001 to 0.05. The paper's is 0.001.
    - `pitch_limit`: rad, where the flight ends.
    - `voltage_limits`: V, the amplifier's (min, max).
    - `start_spread_deg`: degrees, see Starting State.

    All are plain values, so that a spec survives JSON, or objects. Bad ones raise a `ValueError` that names them.

    ## Version History

    - v0: first version.
    """

    metadata: dict[str, Any] = {"render_modes": []}  # noqa: RUF012

    def __init__(
        self,
        plant: str | Plant = "nominal",
        reference: str | Trajectory = "travel-360",
        control_period: float = 0.02,
        pitch_limit: float = PITCH_STOP,
        voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS,
        start_spread_deg: float = 0.0,
        render_mode: str | None = None,
        **unknown: Any,
    ) -> None:
        if unknown:
            known = ", ".join(inspect.signature(Heli3DOFEnv).parameters).removesuffix(", unknown")
            raise ValueError(f"{', '.join(f'{k} = {v!r}' for k, v in unknown.items())}: the arguments are {known}")
        if render_mode is not None:
            raise ValueError(f"render_mode = {render_mode!r}: None is all there is")
        self.render_mode = render_mode
        self.plant = find_plant(plant)
        self.reference = find_reference(reference)
        self.control_period = _number("control_period", control_period, "s", *PERIODS)
        steepest = float(np.abs(self.reference.x[4]).max())
        self.pitch_limit = _number("pitch_limit", pitch_limit, "rad", steepest, np.pi / 2)
        self.voltage_limits = _pair("voltage_limits", voltage_limits)
        room = np.degrees(min(self.pitch_limit - abs(self.reference.x[4, 0]), task.FARTHEST_START[0]))
        self.start_spread_deg = _number("start_spread_deg", start_spread_deg, "deg", 0.0, room)

        # One row per control step, and plain floats for one helicopter: many times faster than small arrays.
        x_ref, u_ref = task.control_grid(self.reference, self.control_period)
        features = task.reference_features(self.reference, self.control_period).astype(np.float32)
        self.x_ref, self.u_ref = x_ref.T.tolist(), u_ref.T.tolist()
        self.features = np.ascontiguousarray(features.T)
        self.last_step = len(self.x_ref) - 1
        bound = task.observation_bound(
            features, self.plant, self.voltage_limits, self.pitch_limit, self.control_period
        ).astype(np.float32)
        self.observation_space = Box(-bound, bound, dtype=np.float32)
        self.action_space = Box(-1.0, 1.0, (2,), dtype=np.float32)
        self.over = True

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """To the start of the reference; see Starting State for the options. Raises ValueError for others."""
        super().reset(seed=seed)
        options = options or {}
        unknown = set(options) - {"state", "plant"}
        if unknown:
            raise ValueError(f"options = {options!r}: only 'state' and 'plant' are known")
        self.drawn_plant = find_plant(options.get("plant", self.plant)).draw(self.np_random)
        start = self._start(options)
        self.voltage = tuple(self.reference.u[:, 0].tolist())
        self.state = measure(self.drawn_plant, at_rest(self.drawn_plant, start, self.voltage), math.inf, self.np_random)
        self.step_count = 0
        self.over = False
        return self._observation(), self._info()

    def step(self, action: ArrayLike) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """One control period with the voltages held. Raises ValueError for an action that is not two finite numbers."""
        if self.over:
            raise gym.error.ResetNeeded("the episode is over: call reset before step")
        u = self.voltage = self._amplified(action)
        du = [applied - nominal for applied, nominal in zip(u, self.u_ref[self.step_count])]
        time = self.step_count * self.control_period
        self.state = advance(self.drawn_plant, self.state, u, time, self.control_period, self.np_random)
        self.step_count += 1

        error = self._error(self.state.x)
        pitch = self.state.x[4]
        terminated = task.crashed(pitch, self.pitch_limit)
        truncated = not terminated and self.step_count == self.last_step
        self.over = terminated or truncated
        info = self._info()
        info["voltage"] = np.array(u)
        info["cost"] = self.control_period * task.cost(pitch, u, self.reference.limits)
        if self.over:
            info["is_success"] = truncated and bool(task.succeeded(error))
        return self._observation(), self.control_period * task.reward(error, du), terminated, truncated, info

    def _start(self, options: dict[str, Any]) -> tuple[float, ...]:
        start = np.array(self.x_ref[0])
        if "state" not in options:
            spread = math.radians(self.start_spread_deg)
            start[0::2] += self.np_random.uniform(-spread, spread, 3)
            return tuple(start.tolist())
        state = _numbers(options["state"], 6)
        near = state is not None and (abs(state - start) <= task.FARTHEST_START).all()
        if state is None or not near or task.crashed(state[4], self.pitch_limit):
            raise ValueError(
                f"options['state'] = {options['state']!r}: six finite numbers, at most 1 rad and 1 rad/s from the "
                f"reference's start {start} and with the pitch within {self.pitch_limit:g} rad, are needed"
            )
        return tuple(state)

    def _amplified(self, action: ArrayLike) -> tuple[float, float]:
        """The two voltages that the amplifier gives for an action: it saturates, which is all that is ever clipped."""
        values = _numbers(action, 2)
        if values is None:
            raise ValueError(f"action = {action!r}: two finite numbers are needed")
        low, high = self.voltage_limits
        front, back = (min(max(task.to_voltage(value, self.voltage_limits), low), high) for value in values)
        return front, back

    def _error(self, x: tuple[float, ...]) -> list[float]:
        return [value - nominal for value, nominal in zip(x, self.x_ref[self.step_count])]

    def _observation(self) -> np.ndarray:
        known = np.array((*self._error(self.state.measurement), *self.voltage), dtype=np.float32)
        return np.concatenate((known, self.features[self.step_count]))

    def _info(self) -> dict[str, Any]:
        return {
            "state": np.array(self.state.x),
            "measurement": np.array(self.state.measurement),
            "time": self.step_count * self.control_period,
            "plant": self.drawn_plant,
        }


def _numbers(values: Any, count: int) -> list[float] | None:
    """The values as so many finite floats; None if they are anything else."""
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        return None
    numbers = array.tolist()
    return numbers if array.shape == (count,) and all(map(math.isfinite, numbers)) else None


def _number(name: str, value: Any, unit: str, low: float, high: float) -> float:
    """The value, if it is in [low, high]."""
    if not isinstance(value, Real) or not low <= float(value) <= high:
        raise ValueError(f"{name} = {value!r}: at least {low:g} and at most {high:g} {unit} is needed")
    return float(value)


def _pair(name: str, value: Any) -> tuple[float, float]:
    numbers = _numbers(value, 2)
    if numbers is None or not numbers[0] < numbers[1]:
        raise ValueError(f"{name} = {value!r}: (min, max) in V with min < max is needed")
    return numbers[0], numbers[1]
