"""Rollouts, metrics, figures and reports; imports `heli_gym`, `paper`, `planning`, `control` and `identification`."""
