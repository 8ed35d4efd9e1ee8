"""Console commands, one module each; imports everything in `heli_gym` and `baselines`, and is imported by nothing."""
