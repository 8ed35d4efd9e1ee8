"""Flights whose SHA-256 `determinism` compares; run alone, it prints them as JSON."""

import hashlib
import json
import sys

import numpy as np

from heli_gym.baselines import fly, make_policy
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.vector_env import Heli3DOFVectorEnv

SEED, STEPS, COUNT = 11, 60, 40
PLANT_NAMES = ("nominal", "lab", "rigid", "fleet")


def sha(*arrays: np.ndarray) -> str:
    """SHA-256 of the bytes of arrays."""
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def actions(count: int) -> np.ndarray:
    """Actions (STEPS, count, 2), the same in every process."""
    return np.random.default_rng(SEED).uniform(-0.3, 0.3, (STEPS, count, 2))


def single(plant: str, j: int = 0) -> str:
    """Flight of one environment with the seed and the actions of the helicopter j."""
    env = Heli3DOFEnv(plant, start_spread_deg=5.0)
    observation, info = env.reset(seed=SEED + j)
    rows = [np.concatenate((observation, info["state"], info["measurement"]))]
    for action in actions(COUNT)[:, j]:
        observation, _, terminated, truncated, info = env.step(action)
        rows.append(np.concatenate((observation, info["state"], info["measurement"])))
        if terminated or truncated:
            break
    return sha(np.array(rows))


def together(plant: str, threads: int = 1, dtype: str = "float64", j: int | None = None) -> str:
    """Flights of a vector environment, or the one of the helicopter j, until it ends."""
    env = Heli3DOFVectorEnv(COUNT, plant, start_spread_deg=5.0, threads=threads, dtype=dtype)
    observation, info = env.reset(seed=SEED)
    pick = slice(None) if j is None else slice(j, j + 1)

    def row() -> np.ndarray:
        return np.concatenate((observation[pick], info["state"][pick], info["measurement"][pick]), axis=1)

    rows = [row()]
    for step in actions(COUNT):
        observation, _, terminated, truncated, info = env.step(step)
        rows.append(row())
        if j is not None and (terminated[j] or truncated[j]):
            break
    return sha(np.array(rows)[:, 0] if j is not None else np.array(rows))


def distance(plant: str, j: int) -> float:
    """Greatest difference in rad or rad/s between a flight alone and in a vector environment."""
    envs, env = Heli3DOFVectorEnv(COUNT, plant, start_spread_deg=5.0), Heli3DOFEnv(plant, start_spread_deg=5.0)
    envs.reset(seed=SEED)
    env.reset(seed=SEED + j)
    greatest = 0.0
    for step in actions(COUNT):
        *_, together = envs.step(step)
        *_, terminated, truncated, alone = env.step(step[j])
        greatest = max(greatest, float(np.abs(together["state"][j] - alone["state"]).max()))
        if terminated or truncated:
            break
    return greatest


def with_feedback() -> str:
    """Flight of the paper's controller on `lab`."""
    reference = find_reference("travel-360")
    flight = fly(Heli3DOFEnv("lab"), make_policy("feedforward+tvlqr", reference), seed=SEED)
    return sha(flight.t, flight.x, flight.u)


def all_flights(_: object = None) -> dict[str, str]:
    """Digests of all flights by name."""
    found = {f"{plant}, single": single(plant) for plant in PLANT_NAMES}
    found |= {f"{plant}, vector": together(plant) for plant in PLANT_NAMES}
    found["lab, vector, single precision"] = together("lab", dtype="float32")
    found["lab, the paper's controller"] = with_feedback()
    return found


def states() -> np.ndarray:
    """Final states (4, 6) of the single flights, to measure differences."""
    ends = []
    for plant in PLANT_NAMES:
        env = Heli3DOFEnv(plant, start_spread_deg=5.0)
        env.reset(seed=SEED)
        for action in actions(COUNT)[:, 0]:
            *_, info = env.step(action)
        ends.append(info["state"])
    return np.array(ends)


if __name__ == "__main__":
    print(json.dumps({"digests": all_flights(), "states": states().tolist()}))
    sys.stdout.flush()
