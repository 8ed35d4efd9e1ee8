"""How the house is built: who imports whom, what is shipped, and that nothing is unpickled."""

import ast
import importlib
import json
import re
import subprocess
import sys
import tomllib
from fnmatch import fnmatch
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from heli_gym import Trajectory

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
PACKAGES = ("heli_gym", "baselines", "train")
MODULES = [path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py"))]
MAY_IMPORT = {"heli_gym": set(), "baselines": {"heli_gym"}, "train": {"heli_gym", "baselines"}}
EXTRAS = {"heli_gym": (), "baselines": ("eval",), "train": ("eval", "ocp", "train")}


def imported(path: Path) -> set[str]:
    """The top-level names of everything that a module imports, unless it can do without."""
    tree = ast.parse(path.read_text())
    attempts = [node for node in ast.walk(tree) if isinstance(node, ast.Try) and "ImportError" in ast.unparse(node)]
    dispensable = {node for attempt in attempts for node in ast.walk(attempt)}
    names = set()
    for node in set(ast.walk(tree)) - dispensable:
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(path.relative_to(ROOT).parts[0] if node.level else node.module.split(".")[0])
    return names


def module_id(path: Path) -> str:
    return str(path.relative_to(ROOT))


@pytest.mark.parametrize("path", MODULES, ids=module_id)
def test_values_flow_one_way(path):
    package = path.relative_to(ROOT).parts[0]
    assert imported(path) & set(PACKAGES) <= MAY_IMPORT[package] | {package}


@pytest.mark.parametrize("path", MODULES, ids=module_id)
def test_what_a_package_imports_is_what_it_declares(path):
    package = path.relative_to(ROOT).parts[0]
    optional = PROJECT["project"]["optional-dependencies"]
    required = [*PROJECT["project"]["dependencies"], *(name for extra in EXTRAS[package] for name in optional[extra])]
    declared = {re.match(r"[\w-]+", requirement)[0].replace("-", "_") for requirement in required}
    assert imported(path) - set(PACKAGES) - sys.stdlib_module_names <= declared


def test_importing_the_environment_or_the_policies_loads_nothing_heavy():
    script = (
        "import sys, json, heli_gym, heli_gym.env; first = list(sys.modules);"
        "import baselines; print(json.dumps([first, list(sys.modules)]))"
    )
    child = subprocess.run([sys.executable, "-W", "error", "-c", script], capture_output=True, text=True)
    assert child.returncode == 0, child.stderr
    with_environment, with_policies = map(set, json.loads(child.stdout))
    heavy = {"torch", "matplotlib", "stable_baselines3", "train"}
    assert not with_environment & (heavy | {"baselines"})
    assert not with_policies & heavy


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("heli_gym", "HelicopterParameters Limits Maneuver Trajectory dynamics linearise thrust voltage"),
        ("baselines", "InfeasibleManeuver fly make_policy plan riccati_gains"),
    ],
)
def test_public_names(module, names):
    package = importlib.import_module(module)
    assert set(names.split()) <= set(package.__all__)
    for name in package.__all__:
        assert getattr(package, name) is not None


@pytest.mark.parametrize("path", MODULES, ids=module_id)
def test_nothing_is_unpickled_or_evaluated(path):
    assert not imported(path) & {"pickle", "cPickle", "cloudpickle", "dill", "joblib", "marshal", "shelve", "runpy"}
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Call):
            called = ast.unparse(node.func)
            assert called not in {"eval", "exec", "compile", "__import__", "torch.load", "torch.jit.load"}
            if called in {"np.load", "numpy.load"}:
                assert "allow_pickle=False" in ast.unparse(node)
            assert "allow_pickle=True" not in ast.unparse(node)


# What is shipped


def test_every_file_of_the_packages_is_shipped():
    setuptools = PROJECT["tool"]["setuptools"]
    for package in PACKAGES:
        for path in (ROOT / package).rglob("*"):
            if path.is_dir() or "__pycache__" in path.parts:
                continue
            if path.suffix == ".py":
                assert ".".join(path.parent.relative_to(ROOT).parts) in setuptools["packages"]
            else:
                patterns = setuptools["package-data"].get(package, [])
                assert any(fnmatch(str(path.relative_to(ROOT / package)), pattern) for pattern in patterns), path


def test_the_package_says_that_it_is_typed_and_brings_its_references():
    assert (files("heli_gym") / "py.typed").is_file()
    assert (files("heli_gym") / "references" / "travel-360.npz").is_file()


@pytest.mark.parametrize("target", [*PROJECT["project"]["scripts"].values()])
def test_each_command_leads_to_a_function(target):
    module, function = target.split(":")
    assert callable(getattr(importlib.import_module(module), function))


def test_the_packaged_reference_is_the_papers_plan(paper_plan):
    packaged = Trajectory.load(str(files("heli_gym") / "references" / "travel-360.npz"))
    x, u = paper_plan(packaged.t)
    np.testing.assert_allclose(packaged.x, x, rtol=0.0, atol=1e-5)  # rad and rad/s
    np.testing.assert_allclose(packaged.u, u, rtol=0.0, atol=0.02)  # V, most where they have corners
    assert packaged.limits == paper_plan.limits


def test_the_packaged_reference_keeps_the_papers_limits_and_set_points():
    packaged = Trajectory.load(str(files("heli_gym") / "references" / "travel-360.npz"))
    np.testing.assert_allclose(packaged.x[:, 0], 0.0, atol=1e-12)
    np.testing.assert_allclose(packaged.x[:, -1], [2.0 * np.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-12)
    assert packaged.duration == 10.0
    assert packaged.u.min() >= 1.0 - 1e-6
    assert packaged.u.max() <= 11.0 + 1e-6
    assert np.degrees(np.abs(packaged.x[4]).max()) <= 50.0
