"""Controllers behind one protocol, one module each, and their registry; imports `heli_gym`, `paper` and `planning`."""
