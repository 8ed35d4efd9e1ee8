"""Interquartile means, intervals and probabilities, against scipy and closed forms."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import norm, trim_mean

from heli_gym.baselines.evaluation.statistics import (
    improvement,
    interquartile_mean,
    mean_with_interval,
    probability_of_improvement,
    rank_crashes_last,
    with_interval,
)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 7, 100, 1001])
def test_the_interquartile_mean_is_scipys_trimmed_mean(n):
    values = np.random.default_rng(n).standard_normal(n)
    assert interquartile_mean(values) == pytest.approx(trim_mean(values, 0.25), rel=1e-12, abs=1e-15)


def test_crashed_flights_count_at_least_as_the_worst_other_and_the_others_as_they_are():
    values, crashed = np.array([[3.0, 1.0, 2.0, 9.0]]), np.array([[False, True, False, True]])
    assert_allclose(rank_crashes_last(values, crashed), [[3.0, 3.0, 2.0, 9.0]])
    assert_allclose(rank_crashes_last(values, np.ones((1, 4))), values)  # nothing to compare them with


def test_a_crash_is_never_an_improvement_and_two_are_a_tie():
    smaller, larger = np.array([[1.0]]), np.array([[2.0]])
    assert probability_of_improvement(smaller, larger, np.array([[True]])) == 0.0
    assert probability_of_improvement(larger, smaller, others_crashed=np.array([[True]])) == 1.0
    assert probability_of_improvement(smaller, larger, np.array([[True]]), np.array([[True]])) == 0.5


def test_a_mean_has_the_interval_of_the_normal_distribution_that_it_nearly_is():
    values = np.random.default_rng(0).normal(5.0, 2.0, 400)
    found = with_interval(values)
    assert found["mean"] == values.mean()
    assert_allclose(found["interval"], values.mean() + 1.96 * values.std() / 20.0 * np.array([-1.0, 1.0]), rtol=0.01)


def test_constant_values_have_a_mean_and_no_interval():
    assert with_interval(np.full(5, 2.0)) == {"mean": 2.0, "interval": None}
    assert with_interval(np.array([[1.0, 2.0]])) == {"mean": [1.0, 2.0], "interval": None}


def test_the_interquartile_mean_is_the_mean_of_the_middle_half():
    assert interquartile_mean(np.array([[100.0, 1.0, 2.0, -50.0], [3.0, 4.0, 5.0, 99.0]])) == pytest.approx(3.5)


@pytest.mark.slow
def test_an_interval_covers_the_truth_about_as_often_as_it_says():
    rng = np.random.default_rng(0)
    covered = 0
    for _ in range(60):
        low, high = mean_with_interval(rng.standard_normal((1, 60)))["interval"]
        covered += low <= 0.0 <= high
    assert covered / 60 >= 0.85


def test_the_interval_of_a_mean_over_seeds_is_wider_where_the_seeds_differ():
    rng = np.random.default_rng(1)
    alike = rng.standard_normal((10, 50))
    different = alike + 3.0 * rng.standard_normal((10, 1))
    (a, b), (c, d) = (mean_with_interval(values)["interval"] for values in (alike, different))
    assert d - c > 2.0 * (b - a)


def test_improvements_are_paired_by_draw():
    rng = np.random.default_rng(2)
    base = rng.uniform(1.0, 10.0, (1, 80))
    found = improvement(np.repeat(0.6 * base, 5, axis=0), base)
    assert found["share"] == pytest.approx(0.4)
    assert_allclose(found["interval"], [0.4, 0.4], atol=0.02)  # draws differ widely, but in both alike
    assert found["probability"] == 1.0
    assert improvement(base, base)["probability"] == 0.5


def test_the_probability_of_improvement_is_that_of_a_smaller_value():
    rng = np.random.default_rng(3)
    found = improvement(rng.normal(5.0, 1.0, (40, 500)), rng.normal(6.0, 1.0, (1, 500)))
    assert found["probability"] == pytest.approx(norm.cdf(1.0 / np.sqrt(2.0)), abs=0.03)
