"""The examples run for a few hundred steps if their library is installed."""

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"
RUNS = [
    ("torch", "cleanrl_ppo.py", ["--steps", "512", "--envs", "16", "--rollout", "16"], "return of the last flights"),
    ("torch", "cleanrl_ppo.py", ["--steps", "512", "--envs", "16", "--residual"], "return of the last flights"),
    *(("stable_baselines3", "sb3_ppo.py", ["--steps", "256", "--form", form], "s on the reference")
      for form in ("make", "make_vec_env", "native")),
    ("torchrl", "torchrl_ppo.py", ["--steps", "500"], "reward"),
    ("tree", "rllib_ppo.py", ["--steps", "512"], "return"),
    ("skrl", "skrl_ppo.py", ["--steps", "512"], "reward of the last rollout"),
    ("osqp", "course_tasks.py", ["--rig", "ntnu", "--draws", "1"], "plan and TV-LQR"),
    ("minari", "minari_dataset.py", ["--steps", "300", "--id", "helicopter/test-v0"], "1 episodes, 300 steps"),
]  # fmt: skip


def run(arguments: list[str], folder: Path) -> str:
    """What a command prints; it has to end well."""
    environment = os.environ | {"MINARI_DATASETS_PATH": str(folder), "OMP_NUM_THREADS": "1"}
    child = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, cwd=folder, env=environment)
    assert child.returncode == 0, child.stderr
    return child.stdout


def test_every_example_is_run():
    assert {path.name for path in EXAMPLES.glob("*.py")} == {name for _, name, _, _ in RUNS}


@pytest.mark.slow
@pytest.mark.parametrize(("library", "name", "arguments", "said"), RUNS, ids=lambda value: str(value))
def test_an_example_runs(library, name, arguments, said, tmp_path):
    if find_spec(library) is None:
        pytest.skip(f"{library} is not installed")
    assert said in run([str(EXAMPLES / name), *arguments], tmp_path)


@pytest.mark.slow
def test_rl_zoo3_trains_with_the_hyperparameters_of_the_examples(tmp_path):
    pytest.importorskip("rl_zoo3")
    arguments = ["-m", "rl_zoo3.train", "--algo", "ppo", "--env", "Heli3DOF-v0", "--gym-packages", "heli_gym"]
    arguments += ["--conf-file", str(EXAMPLES / "rl_zoo3.yml"), "-n", "512", "--eval-freq", "-1"]
    run([*arguments, "--log-folder", str(tmp_path)], tmp_path)
    assert list(tmp_path.rglob("Heli3DOF-v0.zip"))
