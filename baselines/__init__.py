"""Planners and controllers that know the model, and their evaluation; imports `heli_gym`, never `heli_gym.train`."""

from heli_gym.baselines.control.policies import POLICIES, make_policy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.residual.action import ResidualAction, VectorResidualAction
from heli_gym.baselines.evaluation.metrics import Metrics, flight_metrics
from heli_gym.baselines.evaluation.rollout import fly, fly_many
from heli_gym.baselines.evaluation.scoring import evaluate
from heli_gym.baselines.paper.tvlqr import riccati_gains
from heli_gym.baselines.planning.feasibility import InfeasibleManeuver
from heli_gym.baselines.planning.lead import lead_voltages
from heli_gym.baselines.planning.planner import plan, plan_fastest, plan_unconstrained
from heli_gym.baselines.planning.sampler import ManeuverSampler

__all__ = [
    "POLICIES",
    "InfeasibleManeuver",
    "ManeuverSampler",
    "Metrics",
    "Policy",
    "ResidualAction",
    "VectorResidualAction",
    "evaluate",
    "flight_metrics",
    "fly",
    "fly_many",
    "lead_voltages",
    "make_policy",
    "plan",
    "plan_fastest",
    "plan_unconstrained",
    "riccati_gains",
]
