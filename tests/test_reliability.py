"""Short forms of the commands behind docs/reliability.md: each ends with status 0."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

RELIABILITY = Path(__file__).parents[1] / "benchmarks" / "reliability"
PARTS = {
    "fuzz": (),
    "invocations": ("torch", "onnx"),
    "mutations": ("torch", "onnx"),
    "determinism": (),
    "kills": ("torch",),
    "soak": (),
    "numerics": ("mpmath",),
    "caches": (),
}


@pytest.mark.slow
@pytest.mark.parametrize("part", PARTS)
def test_a_short_form_of_the_figures_is_as_it_must_be(part, tmp_path):
    for package in PARTS[part]:
        pytest.importorskip(package)
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    if part != "caches":  # which flies as another user, who may not enter this folder
        environment["TMPDIR"] = str(tmp_path)
    done = subprocess.run(
        [sys.executable, RELIABILITY, part, "--quick"], capture_output=True, text=True, env=environment, cwd=tmp_path
    )
    print(done.stdout)
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-2000:]


def test_every_part_of_the_command_has_a_short_form_in_the_tests():
    listed = subprocess.run([sys.executable, RELIABILITY, "--help"], capture_output=True, text=True, check=True).stdout
    assert all(part in listed for part in PARTS)
    assert {path.stem for path in RELIABILITY.glob("*.py")} - {"__main__", "flights"} == set(PARTS)
