"""Planners: a maneuver in, a checked Trajectory out; imports `heli_gym` and `paper`."""
