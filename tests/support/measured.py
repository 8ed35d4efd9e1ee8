"""Measured flights, which are not part of the package: tests that fly them are skipped unless HELI_LOGS is set."""

import os
from pathlib import Path

import pytest

LOGS = Path(os.environ.get("HELI_LOGS", "logs"))
on_measured_logs = pytest.mark.skipif(
    "HELI_LOGS" not in os.environ, reason="HELI_LOGS names no folder of measured logs"
)
