"""Flights of exported C controllers against Python's, for policies, rigs and both precisions.

    python benchmarks/exports.py [RIG ...]       # names and .toml files; by default the packaged ones

Every controller is compiled by `cc -std=c99 -pedantic -Wall -Wextra -Werror` and flies the same perturbed start as the
policy in Python: on `nominal`, and on a draw of `lab`, whose encoders round. Differences are the largest of any state,
in rad and rad/s; for single precision on `lab`, the column RMS has the difference of the RMS travel errors in degrees.
The column "same" feeds both compiled precisions the measurements recorded in the flight on `lab` of Python's policy,
without feedback: the largest difference of their voltages, as a share of the amplifier's range. The last column is a
flight on `lab` of Python's policy in double precision, on measurements rounded to single.
"""

import argparse
import math
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym import find_rig
from heli_gym.baselines import make_policy
from heli_gym.baselines.commands.export import load_controller
from heli_gym.baselines.control.export import EXPORTED, PRECISIONS, c_source
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.rig import rig_names

PERIOD = 0.02  # s
SEED = 3
CALLS = 20000


class CPolicy:
    """Compiled controller, as a policy."""

    def __init__(self, policy: Any, rig: Any, name: str, precision: str) -> None:
        with tempfile.TemporaryDirectory() as folder:
            for file, text in c_source(policy, rig, name, precision).items():
                Path(folder, file).write_text(text)
            self.loaded, self.number = load_controller(Path(folder), precision)

    def reset(self, rng: np.random.Generator) -> None:
        """Start a flight."""
        self.loaded.heli_reset()

    def __call__(self, t: float, measurement: np.ndarray) -> np.ndarray:
        u = (self.number * 2)()
        self.loaded.heli_step(t, (self.number * 6)(*measurement), u)
        return np.array(u[:])

    def microseconds(self, reference: Any) -> float:
        """Mean time in µs of a step along the reference, without that of a call from Python."""
        y, u = [(self.number * 6)(*reference(PERIOD * k)[0]) for k in range(100)], (self.number * 2)()
        times = [self.number(PERIOD * k) for k in range(100)]
        self.loaded.heli_reset()

        def seconds(function: Any, *more: Any) -> float:
            began = time.perf_counter()
            for k in range(CALLS):
                function(*(() if not more else (times[k % 100], y[k % 100], u)))
            return time.perf_counter() - began

        return 1e6 / CALLS * max(seconds(self.loaded.heli_step, u) - seconds(self.loaded.heli_reset), 0.0)


Measured = list[tuple[float, np.ndarray]]


def fly(policy: Any, env: Heli3DOFEnv, dtype: type = np.float64, measured: Measured | None = None) -> np.ndarray:
    """States (K, 6) of a flight from the perturbed start of SEED, on measurements rounded to a precision.

    Times and measurements are appended to `measured`.
    """
    _, info = env.reset(seed=SEED)
    policy.reset(np.random.default_rng(0))
    x, over = [info["state"]], False
    while not over:
        if measured is not None:
            measured.append((info["time"], info["measurement"].copy()))
        u = policy(info["time"], info["measurement"].astype(dtype).astype(float))
        _, _, terminated, truncated, info = env.step(env.to_action(u))
        x.append(info["state"])
        over = terminated or truncated
    return np.array(x)


def answer(policy: CPolicy, measured: Measured) -> np.ndarray:
    """Voltages (K, 2) of a controller for recorded measurements."""
    policy.reset(np.random.default_rng(0))
    return np.array([policy(t, y) for t, y in measured])


def apart(one: np.ndarray, other: np.ndarray) -> float:
    """Largest difference in rad or rad/s; infinite for flights of different length."""
    return float(np.abs(one - other).max()) if one.shape == other.shape else math.inf


def rms_deg(x: np.ndarray, reference: Any) -> float:
    """RMS travel error in degrees of a flight (K, 6)."""
    error = x[:, 0] - reference(PERIOD * np.arange(len(x)))[0][0]
    return float(np.degrees(np.sqrt((error**2).mean())))


def main() -> None:
    """Print a row per rig and policy."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rigs", nargs="*", default=rig_names())
    parser.add_argument("--policies", nargs="*", default=[*EXPORTED, "residual"])
    args = parser.parse_args()
    print(
        "| rig | policy | double, nominal | lab | single, nominal | lab | RMS | same | µs (double) | (single) "
        "| rounded, lab |"
    )
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for rig in map(find_rig, args.rigs):
        reference = reference_for("travel-180", rig)
        envs = [Heli3DOFEnv(plant, reference, PERIOD, start_spread_deg=3.0, rig=rig) for plant in ("nominal", "lab")]
        for name in args.policies:
            try:
                policy = make_policy(name, envs[0].reference, PERIOD, rig=rig)
            except ValueError:  # a network for another rig
                continue
            measured: Measured = []
            flights = [fly(policy, envs[0]), fly(policy, envs[1], measured=measured)]
            cells, times, answers = [], [], []
            for precision in PRECISIONS:
                compiled = CPolicy(policy, rig, name, precision)
                own = [fly(compiled, env) for env in envs]
                cells += [f"{apart(one, flight):.1e}" for one, flight in zip(own, flights)]
                answers.append(answer(compiled, measured))
                times.append(f"{compiled.microseconds(reference):.2f}")
            errors = [rms_deg(flight, envs[1].reference) for flight in (own[1], flights[1])]
            share = np.abs(answers[0] - answers[1]).max() / np.ptp(rig.voltage_limits)
            cells += [f"{abs(errors[0] - errors[1]):.0e}", f"{share:.1e}", *times]
            cells.append(f"{apart(fly(policy, envs[1], np.float32), flights[1]):.1e}")
            print(f"| {rig.name} | {name} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
