"""Console commands, one module each; may import all of `heli_gym` and `baselines`; no module imports a command."""
