"""Many maneuvers: drawn plans, and the table over them."""

import numpy as np
import pytest

pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")

from heli_gym.plant import HELD_OUT_SEED
from heli_gym.train.maneuvers import Args, maneuvers, rows_of
from heli_gym.train.results import METRICS
from heli_gym.train.train import VALIDATION_SEED, drawn_references


def test_drawn_maneuvers_of_training_validation_and_judgement_differ_and_keep_the_limits():
    plans = [drawn_references("paper", seed, 3) for seed in (0, VALIDATION_SEED, HELD_OUT_SEED)]
    goals = {tuple(np.round(plan.x[[0, 2], -1], 9)) for group in plans for plan in group}
    assert len(goals) == 9
    assert {plan.duration for plan in plans[0]} == {8.0, 10.0, 12.0}
    for plan in plans[0]:
        assert plan.u.min() > 1.0 - 1e-3 and plan.u.max() < 11.0 + 1e-3
        assert np.abs(np.degrees(plan.x[4])).max() < 50.0 + 1e-3


def test_the_maneuvers_are_the_packaged_ones_and_drawn_ones():
    names = list(maneuvers(Args(drawn=2)))
    assert len(names) == 13 and "travel-360" in names and names[-2:] == ["drawn 1", "drawn 2"]


def test_the_table_has_the_middle_half_of_the_draws_and_counts_crashes():
    rng = np.random.default_rng(0)
    values = rng.uniform(1.0, 2.0, (2, len(METRICS), 1, 8))
    values[:, METRICS.index("crashed")] = 0.0
    values[1, METRICS.index("crashed"), 0, :2] = 1.0
    rows = rows_of({"one": {"a": values[0]}, "two": {"a": values[1]}})
    travel = np.sort(values[0, METRICS.index("travel"), 0])
    assert rows["one"]["a"]["travel"]["iqm"] == pytest.approx(travel[2:6].mean())
    assert [rows[name]["a"]["crashes"] for name in ("one", "two", "all")] == [0.0, 0.25, 0.125]


def test_maneuvers_that_fly_the_same_draws_alike_have_together_the_interval_of_one():
    values = np.random.default_rng(0).uniform(1.0, 2.0, (len(METRICS), 1, 24))
    values[METRICS.index("crashed")] = 0.0
    rows = rows_of({str(k): {"a": values} for k in range(9)})
    low, high = rows["all"]["a"]["travel"]["interval"]
    one_low, one_high = rows["0"]["a"]["travel"]["interval"]
    assert high - low == pytest.approx(one_high - one_low, rel=0.1)
    assert rows["all"]["a"]["travel"]["iqm"] == pytest.approx(rows["0"]["a"]["travel"]["iqm"])
