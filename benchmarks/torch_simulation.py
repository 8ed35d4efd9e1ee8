"""Speed of the torch simulation on a device, and of the compiled kernels on one core.

    python benchmarks/torch_simulation.py [--device cuda]

Prints helicopters x control steps per second of the plants that torch simulates.
"""

import argparse
import time
from collections.abc import Callable

import numpy as np
import torch

from heli_gym.env import find_reference
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP
from heli_gym.plant import PLANTS
from heli_gym.simulation.simulation import Simulation
from heli_gym.train import torch_simulation

SIZES = {"cpu": (128, 1024, 16384), "cuda": (1024, 16384, 262144)}
SECONDS = 1.0


def make(plant: str, count: int) -> Simulation:
    """Simulation of helicopters with draws of a plant, at the start of the paper's maneuver."""
    references = [find_reference("travel-360")] * count
    own = Simulation([PLANTS[plant]] * count, references, 0.02, AMPLIFIER_LIMITS, PITCH_STOP, dtype=np.float32)
    for k in range(count):
        own.draw(k, np.random.default_rng(k))
    own.reset(np.arange(count))
    return own


def rate(step: Callable[[], object], count: int, wait: Callable[[], object]) -> float:
    """Helicopter steps per second."""
    step(), wait()
    steps, begun = 0, time.perf_counter()
    while time.perf_counter() - begun < SECONDS:
        step(), wait()
        steps += 1
    return count * steps / (time.perf_counter() - begun)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--device", choices=list(SIZES), default="cpu")
    device = parser.parse_args().device
    if device == "cuda" and not torch.cuda.is_available():
        parser.error("device = 'cuda': torch finds no such device")
    torch.set_num_threads(1)
    name = torch.cuda.get_device_name() if device == "cuda" else "one core"
    print(f"| plant | helicopters | torch on {name} (1/s) | kernels on one core (1/s) | ratio |")
    print("|---|---|---|---|---|")
    for plant in ("nominal", "lab", "rigid"):
        for count in SIZES[device]:
            flights = make(plant, count)
            actions = np.full((count, 2), 0.0, np.float32)
            batch, state = torch_simulation.to_torch(flights, device)
            given = torch.tensor(actions, device=device)
            with torch.no_grad():
                theirs = rate(
                    lambda batch=batch, state=state, given=given: torch_simulation.step(batch, state, given),
                    count,
                    torch.cuda.synchronize if device == "cuda" else lambda: None,
                )
            ours = rate(lambda flights=flights, actions=actions: flights.step(actions), count, lambda: None)
            print(f"| `{plant}` | {count} | {theirs:,.0f} | {ours:,.0f} | {theirs / ours:.3f} |", flush=True)


if __name__ == "__main__":
    main()
