"""Equations (10)-(51) of the paper, one module per section; imports only `heli_gym`."""
