"""Identification of rigs from measured flights; imports `heli_gym`, `paper` and `planning`."""
