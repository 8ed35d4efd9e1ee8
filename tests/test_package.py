"""Structure of the packages: allowed imports, shipped files, no unpickling."""

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
FOLDERS = ("heli_gym", "baselines", "train")
MODULES = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.py"))]
BASELINES = "heli_gym.baselines"
LAYERS = ("paper", "planning", "control", "identification", "evaluation", "commands")
# Which packages of ours the modules of each package may import, apart from their own; a package inside a layer belongs
# to the layer.
MAY_IMPORT = {
    "heli_gym": set(),
    "heli_gym.simulation": {"heli_gym"},
    BASELINES: {"heli_gym", *(f"{BASELINES}.{layer}" for layer in LAYERS[:-1])},
    f"{BASELINES}.paper": {"heli_gym"},
    f"{BASELINES}.planning": {"heli_gym", f"{BASELINES}.paper"},
    f"{BASELINES}.control": {"heli_gym", *(f"{BASELINES}.{layer}" for layer in LAYERS[:2])},
    f"{BASELINES}.identification": {"heli_gym", *(f"{BASELINES}.{layer}" for layer in LAYERS[:2])},
    f"{BASELINES}.evaluation": {"heli_gym", *(f"{BASELINES}.{layer}" for layer in LAYERS[:4])},
    f"{BASELINES}.commands": {"heli_gym", BASELINES, *(f"{BASELINES}.{layer}" for layer in LAYERS[:5])},
    "heli_gym.train": {"heli_gym", BASELINES, *(f"{BASELINES}.{layer}" for layer in LAYERS[:5])},
}
EXTRAS = {"heli_gym": (), "baselines": ("eval",), "train": ("eval", "ocp", "train")}


def package_of(path: Path) -> str:
    """The import name of the package that a module belongs to."""
    parts = path.relative_to(ROOT).parts[:-1]
    return ".".join(parts if parts[0] == "heli_gym" else ("heli_gym", *parts))


def imported(path: Path) -> set[str]:
    """The dotted names of everything that a module imports, unless it can do without."""
    tree = ast.parse(path.read_text())
    attempts = [node for node in ast.walk(tree) if isinstance(node, ast.Try) and "ImportError" in ast.unparse(node)]
    optional = {node for attempt in attempts for node in ast.walk(attempt)}
    names = set()
    for node in set(ast.walk(tree)) - optional:
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: imports are absolute"
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


PACKAGES = sorted({package_of(path) for path in MODULES})


def layer_of(name: str) -> str:
    """The layer that a dotted name lies in: the longest in `MAY_IMPORT` that begins it."""
    return max((package for package in MAY_IMPORT if f"{name}.".startswith(f"{package}.")), key=len)


def module_id(path: Path) -> str:
    return str(path.relative_to(ROOT))


@pytest.mark.parametrize("path", MODULES, ids=module_id)
def test_values_flow_one_way(path):
    layer = layer_of(package_of(path))
    ours = {layer_of(name) for name in imported(path) if name.split(".")[0] == "heli_gym"}
    assert ours <= MAY_IMPORT[layer] | {layer, "heli_gym.simulation"}


@pytest.mark.parametrize("path", MODULES, ids=module_id)
def test_every_package_declares_its_imports(path):
    folder = path.relative_to(ROOT).parts[0]
    optional = PROJECT["project"]["optional-dependencies"]
    required = [*PROJECT["project"]["dependencies"], *(name for extra in EXTRAS[folder] for name in optional[extra])]
    declared = {re.match(r"[\w-]+", requirement)[0].replace("-", "_") for requirement in required}
    roots = {name.split(".")[0] for name in imported(path)}
    assert roots - {"heli_gym"} - sys.stdlib_module_names <= declared


@pytest.mark.parametrize("package", PACKAGES)
def test_every_folder_states_its_contents_and_its_imports(package):
    module = importlib.import_module(package)
    assert "import" in module.__doc__.lower()


def test_the_map_of_imports_names_every_layer():
    assert {name.split(".")[2] for name in PACKAGES if name.startswith(f"{BASELINES}.")} == set(LAYERS)


def test_a_users_own_train_and_baselines_do_not_get_in_the_way(tmp_path):
    (tmp_path / "train.py").write_text("raise SystemExit('the wrong train')\n")
    (tmp_path / "baselines").mkdir()
    (tmp_path / "baselines" / "__init__.py").write_text("raise SystemExit('the wrong baselines')\n")
    code = (
        "import heli_gym.train, heli_gym.baselines.paper.tvlqr, sys;"
        "assert not {'train', 'baselines'} & set(sys.modules);"
        "files = [m.__file__ for name, m in sys.modules.items() if name.startswith('heli_gym')];"
        "print(len(files) - len(set(files)))"
    )
    child = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path)
    assert (child.returncode, child.stderr) == (0, "")
    assert child.stdout.strip() == "0"  # no module is in memory twice


def test_help_works_after_importing_the_package_alone():
    code = "import heli_gym, pydoc; print(pydoc.render_doc(heli_gym.env.Heli3DOFEnv)[:200]); pydoc.render_doc(heli_gym)"
    child = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True)
    assert child.returncode == 0, child.stderr
    assert "Heli3DOFEnv" in child.stdout


def test_importing_the_environment_or_the_policies_loads_nothing_heavy():
    script = (
        "import sys, json, heli_gym, heli_gym.env; first = list(sys.modules);"
        "import heli_gym.baselines; print(json.dumps([first, list(sys.modules)]))"
    )
    child = subprocess.run([sys.executable, "-W", "error", "-c", script], capture_output=True, text=True)
    assert child.returncode == 0, child.stderr
    with_environment, with_policies = map(set, json.loads(child.stdout))
    heavy = {"torch", "matplotlib", "stable_baselines3", "heli_gym.train"}
    assert not with_environment & (heavy | {"heli_gym.baselines"})
    assert not with_policies & heavy


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("heli_gym", "HelicopterParameters Limits Maneuver Trajectory dynamics linearise thrust voltage"),
        ("heli_gym.baselines", "InfeasibleManeuver fly make_policy plan riccati_gains"),
        ("heli_gym.train", "APG HeliVecEnv ResidualVecEnv"),
    ],
)
def test_public_names(module, names):
    package = importlib.import_module(module)
    assert set(names.split()) <= set(package.__all__)
    for name in package.__all__:
        assert getattr(package, name) is not None


@pytest.mark.parametrize("path", MODULES, ids=module_id)
def test_nothing_is_unpickled_or_evaluated(path):
    roots = {name.split(".")[0] for name in imported(path)}
    assert not roots & {"pickle", "cPickle", "cloudpickle", "dill", "joblib", "marshal", "shelve", "runpy"}
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
    for folder in FOLDERS:
        for path in (ROOT / folder).rglob("*"):
            if path.is_dir() or "__pycache__" in path.parts:
                continue
            package, name = package_of(path), path.name
            if path.suffix != ".py":
                while package not in setuptools["packages"]:  # a folder of data
                    package, _, data = package.rpartition(".")
                    name = f"{data}/{name}"
                patterns = setuptools["package-data"].get(package, [])
                assert any(fnmatch(name, pattern) for pattern in patterns), path
            assert package in setuptools["packages"], path


def test_every_folder_of_the_repository_is_in_the_sdist():
    if not (ROOT / ".git").exists():
        pytest.skip("not a checkout")
    listed = subprocess.run(["git", "ls-files"], capture_output=True, text=True, cwd=ROOT, check=True).stdout.split()
    folders = {name.split("/")[0] for name in listed if "/" in name and not name.startswith(".")}
    grafted = re.findall(r"^graft (\S+)", (ROOT / "MANIFEST.in").read_text(), re.M)
    assert folders <= {*FOLDERS, *grafted}


def test_nothing_names_a_folder_next_to_the_repository():
    for folder in (*FOLDERS, "benchmarks", "docs", "examples", "tests"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix in {".py", ".md", ".ipynb", ".toml"}:
                assert not re.search(r"\.\./shared|parents.\d. / .shared.", path.read_text()), path


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


def test_the_packaged_reference_meets_the_papers_limits_and_set_points():
    packaged = Trajectory.load(str(files("heli_gym") / "references" / "travel-360.npz"))
    np.testing.assert_allclose(packaged.x[:, 0], 0.0, atol=1e-12)
    np.testing.assert_allclose(packaged.x[:, -1], [2.0 * np.pi, 0.0, 0.0, 0.0, 0.0, 0.0], atol=1e-12)
    assert packaged.duration == 10.0
    assert packaged.u.min() >= 1.0 - 1e-6
    assert packaged.u.max() <= 11.0 + 1e-6
    assert np.degrees(np.abs(packaged.x[4]).max()) <= 50.0
