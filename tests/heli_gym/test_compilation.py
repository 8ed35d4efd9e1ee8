"""Compiled equations agree with Python, and a change recompiles them."""

import subprocess
import sys
import types

import numpy as np
import pytest

from heli_gym import HelicopterParameters
from heli_gym.baselines.paper.normal_form import internal_dynamics
from heli_gym.compilation import Compiler, compiler

SCALE = 1.0


def outer(x):
    return inner(x) + SCALE


def inner(x):
    return 2.0 * x


def test_compiled_functions_agree_with_python():
    arguments = (0.1, -0.4, 0.3, 0.2, 0.5, 0.6), -0.2, HelicopterParameters()
    assert compiler().part(internal_dynamics)(*arguments) == pytest.approx(internal_dynamics(*arguments), rel=1e-14)


def test_calls_are_compiled_along():
    assert compiler().part(outer)(3.0) == outer(3.0)


def test_another_equation_is_another_version_even_where_only_a_call_or_a_number_differs():
    def other(x):
        return 3.0 * x

    assert Compiler().version(outer) == Compiler().version(outer)
    versions = [
        Compiler().version(outer),
        Compiler().version(types.FunctionType(outer.__code__, {**globals(), "inner": other})),
        Compiler().version(types.FunctionType(outer.__code__, {**globals(), "SCALE": 2.5})),
        Compiler(np.float32).version(outer),
        Compiler(names={"SCALE": 3.0}).version(outer),
        Compiler(loops=(inner,)).version(outer),
        Compiler(fast=()).version(outer),
    ]
    assert len(set(versions)) == len(versions)


def test_the_next_process_loads_what_this_one_compiled():
    code = (
        "from heli_gym.baselines.planning import replay; import numpy as np;"
        "from heli_gym import HelicopterParameters as P;"
        "k = replay.replay_kernel(); k(np.zeros(6), np.full((2, 3), 0.6), np.linspace(0.0, 1.0, 3), P());"
        "print(sum(k.stats.cache_hits.values()), sum(k.stats.cache_misses.values()))"
    )
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True) for _ in range(2)]
    assert [run.returncode for run in runs] == [0, 0], runs[0].stderr
    assert runs[1].stdout.split() == ["1", "0"]
    assert np.isfinite(float(runs[0].stdout.split()[0]))
