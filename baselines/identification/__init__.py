"""Measured flights in, identified rigs out; imports `heli_gym`, `paper` and `planning`."""
