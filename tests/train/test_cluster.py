"""A study on a Ray cluster of two nodes survives a killed worker, a lost node and a killed command."""

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("stable_baselines3")
pytest.importorskip("ray")

BENCHMARK = Path(__file__).parents[2] / "benchmarks" / "cluster.py"


@pytest.mark.slow
def test_the_disturbed_study_has_the_weights_of_the_undisturbed_one():
    run = subprocess.run([sys.executable, str(BENCHMARK), "--short"], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    for words in ("killed worker", "removed the second node", "added a node", "killed heli-sweep after"):
        assert words in run.stdout
    assert run.stdout.splitlines()[-1].startswith("nothing lost, nothing twice: 5 trials")
