"""Design weights of the controllers: general ones, and stored ones for single plants.

The weights of the paper's regulator are in `baselines/paper/tvlqr.py`.
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
from heli_gym.storage import atomic_write, locked, read_json_object

TUNED = Path(__file__).parent / "tuned"  # one file of weights per plant


@dataclass(frozen=True)
class ObserverWeights(Weights):
    """Weights of a regulator and intensities of the Kalman filter's `Noise`."""

    travel_disturbance: float
    elevation_disturbance: float
    pitch_disturbance: float
    acceleration: float

    @property
    def noise(self) -> Noise:
        """Process noise of the Kalman filter."""
        return Noise(self.travel_disturbance, self.elevation_disturbance, self.pitch_disturbance, self.acceleration)


# All but the paper's are rounded results of a search like that of `heli-tune`, half on nominal helicopters and half on
# draws of `lab`.
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
WEIGHTS: dict[str, Weights] = {  # of the tunable policies
    "feedforward+tvlqr": TVLQR,
    "lqi": LQI,
    "lag-lqr": LAG_LQR,
    "lag-lqi": LAG_LQI,
    "kalman-lqr": KALMAN_LQR,
}


def weights_file(plant: str, rig: Rig) -> Path:
    """File of the stored weights for a plant of a rig; the file name omits the paper's rig."""
    name = re.sub(r"[^\w-]", "_", rig.name)
    return TUNED / (f"{plant}.json" if same_dynamics(rig, PAPER) else f"{plant}.{name}.json")


def store_weights(name: str, plant: str, weights: Weights, rig: Rig = PAPER) -> None:
    """Store the weights of a policy for a plant and a rig, atomically; the policy `name@plant` uses them."""
    path = weights_file(plant, rig)
    rounded = {key: float(f"{value:.4g}") for key, value in asdict(weights).items()}
    with locked(path):
        known = read_json_object(path) if path.is_file() else {}
        if not same_dynamics(rig, PAPER):
            known["rig"] = rig.to_toml()
        with atomic_write(path) as file:
            file.write((json.dumps({**known, name: rounded}, indent=2, sort_keys=True) + "\n").encode())


def stored_weights(name: str, plant: str, rig: Rig = PAPER) -> Weights:
    """Weights that `store_weights` stored. Raises ValueError if there are no weights for the plant and the rig."""
    path, called = weights_file(plant, rig), f"name = {f'{name}@{plant}'!r}"
    if not path.is_file():  # then the message below names the rig that has weights
        path = TUNED / f"{plant}.json"
    known = read_json_object(path) if path.is_file() else {}
    if name not in known:
        raise ValueError(f"{called}: no weights are stored for the rig {rig.name!r}; heli-tune --store stores some")
    try:
        own = Rig.from_toml(str(known["rig"])) if "rig" in known else PAPER
    except ValueError as error:
        raise ValueError(f"{called}: rig in {path}: {error}") from error
    check_same_rig(f"{called}: what is stored", own, rig, "the one that flies")
    try:
        return type(WEIGHTS[name])(**known[name])
    except (TypeError, ValueError) as error:
        raise ValueError(f"{called}: weights in {path}: {error}") from error


def weights_of(name: str, rig: Rig = PAPER) -> Weights:
    """Weights of the named policy on a rig, for example of "lqi" or "lqi@lab"."""
    kind, _, plant = name.partition("@")
    return stored_weights(kind, plant, rig) if plant else WEIGHTS[kind]
