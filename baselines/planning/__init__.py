"""Planners: from a maneuver to a validated Trajectory; imports `heli_gym` and `paper`."""
