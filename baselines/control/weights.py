"""The weights that the controllers are designed with: in use for all plants, and stored for single ones.

Those of the paper's regulator stand in tvlqr.py.
"""

import json
import re
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from heli_gym.baselines.control.discrete_lqr import IntegralWeights, Weights
from heli_gym.baselines.control.estimation import Noise
from heli_gym.baselines.paper import tvlqr
from heli_gym.rig import PAPER, Rig, check_same_rig, same_dynamics
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


def weights_file(plant: str, rig: Rig) -> Path:
    """Where the weights for a plant of a rig are stored; those of the paper's rig are without its name."""
    name = re.sub(r"[^\w-]", "_", rig.name)
    return TUNED / (f"{plant}.json" if same_dynamics(rig, PAPER) else f"{plant}.{name}.json")


def store_weights(name: str, plant: str, weights: Weights, rig: Rig = PAPER) -> None:
    """Keeps the weights of a policy for a plant, atomically: those that `name@plant` flies with on this rig."""
    path = weights_file(plant, rig)
    rounded = {key: float(f"{value:.4g}") for key, value in asdict(weights).items()}
    with locked(path):
        known = json.loads(path.read_text()) if path.is_file() else {}
        if not same_dynamics(rig, PAPER):
            known["rig"] = rig.to_toml()
        with atomic_write(path) as file:
            file.write((json.dumps({**known, name: rounded}, indent=2, sort_keys=True) + "\n").encode())


def stored_weights(name: str, plant: str, rig: Rig = PAPER) -> Weights:
    """What `store_weights` has kept. Raises ValueError where there is nothing, or only for another rig."""
    path, called = weights_file(plant, rig), f"name = {f'{name}@{plant}'!r}"
    if not path.is_file():  # says which rig has some, if any
        path = TUNED / f"{plant}.json"
    known = json.loads(path.read_text()) if path.is_file() else {}
    if name not in known:
        raise ValueError(f"{called}: no weights are stored for the rig {rig.name!r}; heli-tune --store stores some")
    own = Rig.from_toml(known["rig"]) if "rig" in known else PAPER
    check_same_rig(f"{called}: what is stored", own, rig, "the one that flies")
    try:
        return type(WEIGHTS[name])(**known[name])
    except (TypeError, ValueError) as error:
        raise ValueError(f"{called}: weights in {path}: {error}") from error


def weights_of(name: str, rig: Rig = PAPER) -> Weights:
    """Those that the policy of this name flies with on a rig, "lqi" or "lqi@lab" say."""
    kind, _, plant = name.partition("@")
    return stored_weights(kind, plant, rig) if plant else WEIGHTS[kind]
