"""Stable-Baselines3 agents that learn corrections on top of the baselines: still to come."""
