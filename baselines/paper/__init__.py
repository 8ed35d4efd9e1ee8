"""Equations (10)-(51) of the paper, one module a section; imports `heli_gym` alone."""
