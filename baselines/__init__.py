"""Policies that know the model: the paper's planner and time-varying LQR, and how they are flown and judged."""

from baselines.flight import fly
from baselines.planner import plan, plan_fastest, plan_unconstrained
from baselines.policies import POLICIES, Policy, make_policy
from baselines.sampler import ManeuverSampler
from baselines.search import InfeasibleManeuver
from baselines.tvlqr import riccati_gains

__all__ = [
    "POLICIES",
    "InfeasibleManeuver",
    "ManeuverSampler",
    "Policy",
    "fly",
    "make_policy",
    "plan",
    "plan_fastest",
    "plan_unconstrained",
    "riccati_gains",
]
