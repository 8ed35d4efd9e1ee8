"""The weights that the controllers are designed with: in use for all plants, and stored for single ones.

Those of the paper's regulator stand in tvlqr.py.
"""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from heli_gym.baselines.control.discrete_lqr import IntegralWeights, Weights
from heli_gym.baselines.control.estimation import Noise
from heli_gym.baselines.paper import tvlqr
from heli_gym.storage import atomic_write, locked

TUNED = Path(__file__).parent / "tuned"  # weights for single plants, a file each


@dataclass(frozen=True)
class ObserverWeights(Weights):
    """Those of a regulator, and the intensities of `Noise`."""

    travel_disturbance: float
    elevation_disturbance: float
    pitch_disturbance: float
    acceleration: float

    @property
    def noise(self) -> Noise:
        """What drives the Kalman filter."""
        return Noise(self.travel_disturbance, self.elevation_disturbance, self.pitch_disturbance, self.acceleration)


# But for the paper's, rounded from what a search like that of `heli-tune` found, half on nominal
# helicopters and half on draws of `lab`.
TVLQR = Weights(*np.diag(tvlqr.Q).tolist(), *np.diag(tvlqr.R).tolist())
LQI = IntegralWeights(
    travel=30.0,
    travel_rate=35.0,
    elevation=65.0,
    elevation_rate=40.0,
    pitch=0.8,
    pitch_rate=0.6,
    thrust_sum=1.0,
    thrust_difference=4.0,
    travel_integral=0.8,
    elevation_integral=12.0,
)
LAG_LQR = Weights(
    travel=220.0,
    travel_rate=5.0,
    elevation=200.0,
    elevation_rate=3.0,
    pitch=5.0,
    pitch_rate=3.0,
    thrust_sum=1.0,
    thrust_difference=0.4,
)
LAG_LQI = IntegralWeights(
    travel=100.0,
    travel_rate=3.0,
    elevation=120.0,
    elevation_rate=2.5,
    pitch=1.0,
    pitch_rate=1.0,
    thrust_sum=1.0,
    thrust_difference=0.35,
    travel_integral=1.5,
    elevation_integral=50.0,
)
KALMAN_LQR = ObserverWeights(
    travel=20.0,
    travel_rate=40.0,
    elevation=75.0,
    elevation_rate=45.0,
    pitch=0.12,
    pitch_rate=0.14,
    thrust_sum=1.0,
    thrust_difference=0.55,
    travel_disturbance=0.25,
    elevation_disturbance=0.02,
    pitch_disturbance=0.9,
    acceleration=0.01,
)
WEIGHTS: dict[str, Weights] = {  # of those that can be tuned
    "feedforward+tvlqr": TVLQR,
    "lqi": LQI,
    "lag-lqr": LAG_LQR,
    "lag-lqi": LAG_LQI,
    "kalman-lqr": KALMAN_LQR,
}


def store_weights(name: str, plant: str, weights: Weights) -> None:
    """Keeps the weights of a policy for a plant, atomically: those that `name@plant` flies with."""
    path = TUNED / f"{plant}.json"
    rounded = {key: float(f"{value:.4g}") for key, value in asdict(weights).items()}
    with locked(path):
        known = json.loads(path.read_text()) if path.is_file() else {}
        with atomic_write(path) as file:
            file.write((json.dumps({**known, name: rounded}, indent=2, sort_keys=True) + "\n").encode())


def stored_weights(name: str, plant: str) -> Weights:
    """What `store_weights` has kept. Raises ValueError where there is nothing."""
    path = TUNED / f"{plant}.json"
    known = json.loads(path.read_text()) if path.is_file() else {}
    if name not in known:
        raise ValueError(f"name = {f'{name}@{plant}'!r}: no weights are stored, see heli_gym.baselines.commands.tune")
    return type(WEIGHTS[name])(**known[name])


def weights_of(name: str) -> Weights:
    """Those that the policy of this name flies with, "lqi" or "lqi@lab" say."""
    kind, _, plant = name.partition("@")
    return stored_weights(kind, plant) if plant else WEIGHTS[kind]
