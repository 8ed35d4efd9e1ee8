"""Policies that know the model: the paper's planner and time-varying LQR, and how they are flown and judged."""

from baselines.planner import InfeasibleManeuver, plan, plan_unconstrained
from baselines.tvlqr import riccati_gains

__all__ = ["InfeasibleManeuver", "plan", "plan_unconstrained", "riccati_gains"]
