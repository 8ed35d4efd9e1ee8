"""Statistics of flights on the same draws: interquartile means, bootstrapped intervals, probabilities of improvement.

After Agarwal et al., "Deep reinforcement learning at the edge of the statistical precipice", 2021. Values are errors or
costs (seeds, draws), smaller is better. A crashed flight ranks behind all others, so that a crash never pays.
"""

from typing import Any

import numpy as np

RESAMPLES, CONFIDENCE = 2000, 0.95


def interquartile_mean(values: np.ndarray) -> float:
    """The mean of the middle half of all values."""
    return float(middle_mean(np.ravel(values)[None])[0])


def middle_mean(rows: np.ndarray) -> np.ndarray:
    """The mean (N,) of the middle half of each row of (N, n): the quarter at each end, rounded down, is left out."""
    n = rows.shape[1]
    cut = n // 4
    if cut:
        rows = np.partition(rows, (cut, n - cut - 1), axis=1)[:, cut : n - cut]
    return rows.mean(axis=1)


def rank_crashes_last(values: np.ndarray, crashed: np.ndarray) -> np.ndarray:
    """The values (..., draws), those of crashed flights raised to the largest of the flights that did not crash.

    So no crashed flight counts less than any other of the same policy.
    """
    crashed = np.asarray(crashed, bool)
    if crashed.all():
        return values
    return np.where(crashed, np.maximum(values, values[~crashed].max()), values)


def resampled(shape: tuple[int, int], rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Indices that draw as many seeds and as many draws as there are, (seeds, draws), with replacement."""
    seeds, draws = shape
    return rng.integers(seeds, size=seeds)[:, None], rng.integers(draws, size=draws)[None]


def interval(values: Any) -> tuple[float, float]:
    """The middle 95 % of bootstrapped values."""
    low, high = np.quantile(values, [0.5 - CONFIDENCE / 2, 0.5 + CONFIDENCE / 2])
    return float(low), float(high)


def mean_with_interval(values: np.ndarray) -> dict[str, Any]:
    """Interquartile mean of values (seeds, draws) as "iqm", and its "interval" by a bootstrap of seeds and draws."""
    rng = np.random.default_rng(0)
    bootstrapped = [interquartile_mean(values[resampled(values.shape, rng)]) for _ in range(RESAMPLES)]
    return {"iqm": interquartile_mean(values), "interval": interval(bootstrapped)}


def probability_of_improvement(
    values: np.ndarray,
    others: np.ndarray,
    crashed: np.ndarray | bool = False,
    others_crashed: np.ndarray | bool = False,
) -> float:
    """How probably a value (seeds, draws) is smaller than the other (1, draws) of the same draw; a tie counts half.

    A flight that crashed is never better than one that did not; two crashes are a tie.
    """
    values = np.where(crashed, np.inf, values)
    others = np.where(others_crashed, np.inf, others)
    return float(np.mean(values < others) + 0.5 * np.mean(values == others))


def improvement(
    values: np.ndarray,
    others: np.ndarray,
    crashed: np.ndarray | bool = False,
    others_crashed: np.ndarray | bool = False,
) -> dict[str, Any]:
    """By which "share" values (seeds, draws) are smaller than others (1, draws) on the same draws, and how often.

    The share compares interquartile means and has an "interval"; the "probability" is that of improvement.
    """
    rng = np.random.default_rng(0)

    def share(seeds: np.ndarray, draws: np.ndarray) -> float:
        return 1.0 - interquartile_mean(values[seeds, draws]) / interquartile_mean(others[0, draws])

    everyone = np.arange(values.shape[0])[:, None], np.arange(values.shape[1])[None]
    bootstrapped = [share(*resampled(values.shape, rng)) for _ in range(RESAMPLES)]
    return {
        "share": share(*everyone),
        "interval": interval(bootstrapped),
        "probability": probability_of_improvement(values, others, crashed, others_crashed),
    }


def with_interval(values: np.ndarray) -> dict[str, Any]:
    """Mean of values (episodes, ...) and its bootstrapped "interval"; None where there is nothing to resample."""
    values = np.asarray(values, dtype=float)
    mean = values.mean(axis=0)
    if len(values) < 2 or np.all(values == values[0]):
        return {"mean": mean.tolist(), "interval": None}
    rng = np.random.default_rng(0)
    means = np.array([values[rng.integers(len(values), size=len(values))].mean(axis=0) for _ in range(RESAMPLES)])
    low, high = np.quantile(means, [0.5 - CONFIDENCE / 2, 0.5 + CONFIDENCE / 2], axis=0)
    return {"mean": mean.tolist(), "interval": [low.tolist(), high.tolist()]}


def bootstrapped_means(values: np.ndarray, resamples: int = 1000) -> np.ndarray:
    """Interquartile means (resamples, P) of values (P, draws), the same resampled draws for all P: paired."""
    rng = np.random.default_rng(0)
    draws = rng.integers(values.shape[1], size=(resamples, values.shape[1]))
    return np.stack([middle_mean(row[draws]) for row in values], axis=1)


def ranks(means: np.ndarray) -> np.ndarray:
    """Ranks from 1 on (..., P) of means (..., P), the smallest first; what is alike shares the middle of its ranks."""
    smaller = (means[..., None, :] < means[..., :, None]).sum(axis=-1)
    alike = (means[..., None, :] == means[..., :, None]).sum(axis=-1)
    return smaller + 0.5 * (alike + 1)
