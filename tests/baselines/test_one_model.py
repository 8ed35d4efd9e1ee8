"""One line of `heli_gym/model.py` is changed in a copy of the package: plans, gains and flights follow it.

The changed equation is typed here once more, and flown by scipy's DOP853.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

CHANGES = {  # a line of the model, what takes its place, and what is added to the accelerations of (3)
    "travel damping": ("- p.c1 * dq1\n", "- p.c1 * dq1 - 0.1 * dq1\n", "[-0.1 * dq1, 0.0, 0.0]"),
    "weight on pitch": ("- p.c3 * dq3\n", "- p.c3 * dq3 + 0.3 * cos(q2)\n", "[0.0, 0.0, 0.3 * cos(q2)]"),
}

CODE = """
import json
from math import cos, pi, sin

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import solve_continuous_are

from heli_gym import HelicopterParameters, Maneuver, linearise, thrust
from heli_gym.baselines import fly, make_policy, plan, plan_fastest, plan_unconstrained, riccati_gains
from heli_gym.baselines.paper import tvlqr
from heli_gym.env import Heli3DOFEnv
from heli_gym.model import hover_input

p = HelicopterParameters()


def changed_equation(x, v1, v2):
    q1, dq1, q2, dq2, q3, dq3 = x
    on_travel, on_elevation, on_pitch = ADDED
    return np.array([
        dq1, p.b1 * cos(q2) * sin(q3) * v1 + on_travel,
        dq2, p.a1 * sin(q2) + p.a2 * cos(q2) + p.b2 * cos(q3) * v1 + on_elevation,
        dq3, p.a3 * cos(q2) * sin(q3) + p.b3 * v2 + on_pitch,
    ])


def fly_through(voltages, x, duration, step):
    def rhs(t, x):
        f = thrust(np.array(voltages(t)))
        return changed_equation(x, f[0] + f[1], f[0] - f[1])

    return solve_ivp(rhs, (0.0, duration), x, "DOP853", rtol=1e-8, atol=1e-10, max_step=step).y[:, -1]


def miss(plan):
    end = fly_through(lambda t: [np.interp(t, plan.t, row) for row in plan.u], plan.x[:, 0], plan.duration, 0.05)
    return float(np.abs(end - [2.0 * pi, 0.0, 0.0, 0.0, 0.0, 0.0]).max())


asked, found = Maneuver(duration=15.0), {}
for method in ("auto", "paper", "spline", "flat", "collocation"):
    found[method] = miss(plan(asked, method))
found["fastest"] = miss(plan_fastest(asked))
found["unconstrained"] = miss(plan_unconstrained(asked))

reference = plan(asked)
gains = riccati_gains(reference)
hover = np.concatenate((np.zeros(6), hover_input(0.0, p)))
jacobian = np.stack([
    (changed_equation((hover + d)[:6], *(hover + d)[6:]) - changed_equation((hover - d)[:6], *(hover - d)[6:])) / 2e-6
    for d in 1e-6 * np.eye(8)
], axis=1)
P = solve_continuous_are(jacobian[:, :6], jacobian[:, 6:], tvlqr.Q, tvlqr.R)
found["gain"] = float(np.abs(gains(15.0) - np.linalg.solve(tvlqr.R, jacobian[:, 6:].T @ P)).max())

env = Heli3DOFEnv(reference=reference)
flown = fly(env, make_policy("open-loop", reference))
held = lambda t: flown.u[:, min(int(np.searchsorted(flown.t, t, side="right")) - 1, flown.u.shape[1] - 1)]
x = flown.x[:, 0]
for k in range(len(flown.t) - 1):
    f = thrust(flown.u[:, k])
    x = solve_ivp(lambda t, x: changed_equation(x, f[0] + f[1], f[0] - f[1]), (flown.t[k], flown.t[k + 1]), x,
                  "DOP853", rtol=1e-9, atol=1e-11).y[:, -1]
found["flight"] = float(np.abs(x - flown.x[:, -1]).max())
print(json.dumps(found))
"""


@pytest.mark.slow
@pytest.mark.parametrize("name", CHANGES)
def test_plans_gains_and_flights_follow_a_changed_line_of_the_model(name, tmp_path):
    line, changed, added = CHANGES[name]
    shutil.copytree(ROOT / "heli_gym", tmp_path / "heli_gym")
    for folder in ("baselines", "train"):
        shutil.copytree(ROOT / folder, tmp_path / "heli_gym" / folder)
    model = tmp_path / "heli_gym" / "model.py"
    text = model.read_text()
    assert text.count(line) == 1
    model.write_text(text.replace(line, changed))
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    code = f"import heli_gym; assert heli_gym.__file__.startswith({str(tmp_path)!r})\n" + CODE.replace("ADDED", added)
    child = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, env=environment, check=False
    )
    assert child.returncode == 0, child.stderr
    found = json.loads(child.stdout)
    assert found.pop("gain") < 1e-4
    assert found.pop("flight") < 1e-6
    for method, miss in found.items():
        assert miss < 1e-3, (method, miss)
