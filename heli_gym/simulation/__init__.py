"""The compiled control step: row layout, kernels, fast sine and cosine, and `Simulation`; imports `heli_gym` alone."""
