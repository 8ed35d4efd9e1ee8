"""Types of design weights, and the general ones of each controller, which serve every plant.

The weights of the paper's regulator are in `baselines/paper/tvlqr.py`.
"""

from dataclasses import asdict, dataclass, fields
from typing import Any

import numpy as np

from heli_gym.baselines.control.adaptive_filter import UNADAPTED, FilterNoise
from heli_gym.baselines.control.discrete_lqr import IntegralWeights, Weights
from heli_gym.baselines.control.estimation import Noise
from heli_gym.baselines.control.nmpc import MpcSettings
from heli_gym.baselines.paper import tvlqr
from heli_gym.validation import is_number


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


@dataclass(frozen=True)
class L1Weights(Weights):
    """Weights of a regulator, and settings of the L1 adaptive law."""

    predictor: float  # 1/s, pole of the state predictor
    bandwidth: float  # rad/s, low-pass filter between estimate and control
    largest: float  # rad/s², bound of the estimates

    def __post_init__(self) -> None:
        super().__post_init__()
        check_positive(self, ("predictor", "bandwidth", "largest"))


@dataclass(frozen=True)
class PositiveNumbers:
    """Positive, finite numbers. Raises ValueError, which names the field, for others."""

    def __post_init__(self) -> None:
        check_positive(self, [item.name for item in fields(self)])


def check_positive(numbers: Any, names: Any) -> None:
    """Raise ValueError for a named field that is not a positive, finite number."""
    for name in names:
        value = getattr(numbers, name)
        if not (is_number(value) and value > 0.0):
            raise ValueError(f"{name} = {value!r}: must be a finite number, more than 0")


@dataclass(frozen=True)
class CascadeGains(PositiveNumbers):
    """Gains of the outer loops (travel, elevation), which command accelerations, and of the inner pitch loop."""

    travel: float  # 1/s²
    travel_rate: float  # 1/s
    elevation: float  # 1/s²
    elevation_rate: float  # 1/s
    integral: float  # 1/s³, on the integral of the elevation error
    pitch: float  # 1/s²
    pitch_rate: float  # 1/s


@dataclass(frozen=True)
class MpcWeights(PositiveNumbers):
    """Fields of `MpcSettings` and `FilterNoise` that are searched."""

    elevation: float
    pitch_rate: float
    effort: float
    outside: float
    pitch_barrier: float
    terminal: float
    acceleration: float
    travel_disturbance: float
    elevation_disturbance: float
    pitch_disturbance: float

    @property
    def settings(self) -> MpcSettings:
        """Settings of the MPC."""
        return MpcSettings()._replace(**{k: v for k, v in asdict(self).items() if k in MpcSettings._fields})

    def noise(self, base: FilterNoise) -> FilterNoise:
        """Noise of the filter, in all other fields that of the base."""
        return base._replace(**{k: v for k, v in asdict(self).items() if k in FilterNoise._fields})


def mpc_weights(settings: MpcSettings, noise: FilterNoise) -> MpcWeights:
    """The weights with these settings and noise."""
    known = settings._asdict() | noise._asdict()
    return MpcWeights(**{item.name: known[item.name] for item in fields(MpcWeights)})


@dataclass(frozen=True)
class LinearMpcWeights(PositiveNumbers):
    """Weights of a stage relative to errors of 1 degree, and intensities of the filter's disturbances."""

    pitch: float  # 1/rad²
    pitch_rate: float  # per (rad/s)²
    effort: float  # 1/N², of each fan's thrust
    terminal: float  # weight of the last node, in stages
    travel_disturbance: float  # rad/s² per sqrt(s)
    elevation_disturbance: float
    pitch_disturbance: float


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
L1 = L1Weights(
    **{item.name: getattr(KALMAN_LQR, item.name) for item in fields(Weights)}, predictor=5.0, bandwidth=2.0, largest=0.5
)
PD = CascadeGains(
    travel=0.318, travel_rate=9.45, elevation=4.61, elevation_rate=2.63, integral=4.27, pitch=17.4, pitch_rate=7.82
)
FLAT = CascadeGains(
    travel=0.9, travel_rate=1.6, elevation=4.0, elevation_rate=3.0, integral=1.0, pitch=10.0, pitch_rate=5.0
)
ADAPTIVE_MPC = mpc_weights(MpcSettings(), FilterNoise())
NMPC = mpc_weights(MpcSettings(), UNADAPTED)
LINEAR_MPC = LinearMpcWeights(
    pitch=10.0,
    pitch_rate=1.0,
    effort=20.0,
    terminal=5.0,
    travel_disturbance=UNADAPTED.travel_disturbance,
    elevation_disturbance=UNADAPTED.elevation_disturbance,
    pitch_disturbance=UNADAPTED.pitch_disturbance,
)
WEIGHTS: dict[str, Any] = {  # of the tunable policies
    "feedforward+tvlqr": TVLQR,
    "lqi": LQI,
    "lag-lqr": LAG_LQR,
    "lag-lqi": LAG_LQI,
    "kalman-lqr": KALMAN_LQR,
    "gain-scheduled": TVLQR,
    "l1-adaptive": L1,
    "pd-cascade": PD,
    "flatness": FLAT,
    "linear-mpc": LINEAR_MPC,
    "nmpc": NMPC,
    "adaptive-mpc": ADAPTIVE_MPC,
}
