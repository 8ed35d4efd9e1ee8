"""Agents that learn corrections of the baselines; imports `heli_gym` and `baselines` except its commands."""
