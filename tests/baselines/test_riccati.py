"""The compiled linearisation and integration against those in numpy."""

import numpy as np
import pytest
from independent import inputs, jacobians
from numpy.testing import assert_allclose

from heli_gym import HelicopterParameters
from heli_gym.baselines import riccati_gains
from heli_gym.baselines.paper import riccati, tvlqr
from heli_gym.rig import PAPER

NOMINAL = HelicopterParameters()


def test_the_derivatives_are_those_of_a_symbolic_derivation(paper_plan):
    t = np.linspace(0.0, 10.0, 50)
    x, u = paper_plan(t)
    v = inputs(u)
    J, rows, columns = riccati.jacobians_along(x, v, NOMINAL)
    expected = np.stack([np.concatenate(jacobians(x[:, k], v[:, k]), axis=1) for k in range(len(t))])
    assert_allclose(J, expected, atol=1e-13)
    looked_at = np.zeros((6, 8), dtype=bool)
    looked_at[rows, columns] = True
    assert not expected[:, ~looked_at].any()


def test_the_nonzero_entries_are_three_kinematic_and_nine_dynamic_ones():
    # (3) depends on two angles and two inputs, and not every line on all of them
    _, rows, columns, varying = riccati.structure(NOMINAL)
    assert sorted(zip(rows.tolist(), columns.tolist())) == [
        (0, 1), (1, 2), (1, 4), (1, 6), (2, 3), (3, 2), (3, 4), (3, 6), (4, 5), (5, 2), (5, 4), (5, 7),
    ]  # fmt: skip
    assert varying.tolist() == [2, 4, 6]


# The corners of the constrained inputs cost the stiff integrator's fixed steps some accuracy.
@pytest.mark.parametrize(("reference", "tolerance"), [("unconstrained_plan", 2e-4), ("paper_plan", 1e-3)])
def test_both_integrations_give_the_same_gains(reference, tolerance, request):
    reference = request.getfixturevalue(reference)
    gains = riccati_gains(reference)
    M = tvlqr.stationary_cost(0.0, NOMINAL, tvlqr.Q, tvlqr.R)
    t = np.linspace(0.0, 10.0, 2001)
    P = tvlqr.integrate_stiff(reference, PAPER, tvlqr.Q, tvlqr.R, M, t)[:: 2000 // (len(gains.t) - 1)]
    assert_allclose(np.moveaxis(gains.P, -1, 0), P, atol=1e-4 * np.abs(P).max())
    _, u = reference(gains.t)
    B = [jacobians(*reference_at)[1] for reference_at in zip(reference(gains.t)[0].T, inputs(u).T)]
    assert_allclose(np.moveaxis(gains.K, -1, 0), np.transpose(B, (0, 2, 1)) @ P, atol=tolerance)  # R is one


def test_stiff_weights_are_noticed_and_integrated_otherwise(paper_plan, monkeypatch):
    called = []
    stiff = tvlqr.integrate_stiff
    monkeypatch.setattr(tvlqr, "integrate_stiff", lambda *args: called.append(True) or stiff(*args))
    riccati_gains(paper_plan)
    assert not called
    P = riccati_gains(paper_plan, R=1e-4 * tvlqr.R).P
    assert called
    assert np.isfinite(P).all()
