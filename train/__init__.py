"""Agents that learn corrections on top of the baselines; imports `heli_gym` and `baselines`, but for its commands."""
