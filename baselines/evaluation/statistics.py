"""Statistics of flights on the same draws: interquartile means, bootstrapped intervals, probabilities of improvement.

Source: Agarwal et al., "Deep reinforcement learning at the edge of the statistical precipice", 2021. Values are errors
or costs (seeds, draws); smaller is better. A crashed flight ranks behind all others, so that a crash never pays.
"""

from typing import Any

import numpy as np

RESAMPLES, CONFIDENCE = 2000, 0.95


def interquartile_mean(values: np.ndarray) -> float:
    """Mean of the middle half of all values."""
    return float(middle_mean(np.ravel(values)[None])[0])


def middle_mean(rows: np.ndarray) -> np.ndarray:
    """Mean (N,) of the middle half of each row of (N, n), without a quarter (rounded down) at each end."""
    n = rows.shape[1]
    cut = n // 4
    if cut:
        rows = np.partition(rows, (cut, n - cut - 1), axis=1)[:, cut : n - cut]
    return rows.mean(axis=1)


def rank_crashes_last(values: np.ndarray, crashed: np.ndarray) -> np.ndarray:
    """Values (..., draws), where each crashed flight is at least as bad as the worst flight without a crash."""
    crashed = np.asarray(crashed, bool)
    if crashed.all():
        return values
    return np.where(crashed, np.maximum(values, values[~crashed].max()), values)


def resample_indices(shape: tuple[int, int], rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Random indices of seeds (S, 1) and draws (1, D), with replacement, for values of shape (S, D)."""
    seeds, draws = shape
    return rng.integers(seeds, size=seeds)[:, None], rng.integers(draws, size=draws)[None]


def interval(values: Any) -> tuple[float, float]:
    """Interval with the middle 95 % of bootstrapped values."""
    low, high = np.quantile(values, [0.5 - CONFIDENCE / 2, 0.5 + CONFIDENCE / 2])
    return float(low), float(high)


def mean_with_interval(values: np.ndarray, resample_rows: bool = True) -> dict[str, Any]:
    """Interquartile mean of values (seeds, draws) as "iqm", and its "interval" by a bootstrap of seeds and draws.

    Without `resample_rows`, the bootstrap is of draws alone: for rows that are no sample, like maneuvers, and share the
    draws.
    """
    rng = np.random.default_rng(0)

    def resampled() -> np.ndarray:
        rows, draws = resample_indices(values.shape, rng)
        return values[rows if resample_rows else np.arange(len(values))[:, None], draws]

    bootstrapped = [interquartile_mean(resampled()) for _ in range(RESAMPLES)]
    return {"iqm": interquartile_mean(values), "interval": interval(bootstrapped)}


def probability_of_improvement(
    values: np.ndarray,
    others: np.ndarray,
    crashed: np.ndarray | bool = False,
    others_crashed: np.ndarray | bool = False,
) -> float:
    """Probability that a value (seeds, draws) is smaller than the other (1, draws) of its draw; a tie counts half.

    A crashed flight is always worse than a flight without a crash; two crashes are a tie.
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
    """Improvement of values (seeds, draws) over others (1, draws) on the same draws.

    "share" is the relative reduction of the interquartile mean, "interval" its bootstrap interval, "probability" the
    result of `probability_of_improvement`.
    """
    rng = np.random.default_rng(0)

    def share(seeds: np.ndarray, draws: np.ndarray) -> float:
        return 1.0 - interquartile_mean(values[seeds, draws]) / interquartile_mean(others[0, draws])

    everyone = np.arange(values.shape[0])[:, None], np.arange(values.shape[1])[None]
    bootstrapped = [share(*resample_indices(values.shape, rng)) for _ in range(RESAMPLES)]
    return {
        "share": share(*everyone),
        "interval": interval(bootstrapped),
        "probability": probability_of_improvement(values, others, crashed, others_crashed),
    }


def with_interval(values: np.ndarray) -> dict[str, Any]:
    """Mean of values (episodes, ...) and its bootstrapped "interval", which is None for one value or equal values."""
    values = np.asarray(values, dtype=float)
    mean = values.mean(axis=0)
    if len(values) < 2 or np.all(values == values[0]):
        return {"mean": mean.tolist(), "interval": None}
    rng = np.random.default_rng(0)
    means = np.array([values[rng.integers(len(values), size=len(values))].mean(axis=0) for _ in range(RESAMPLES)])
    low, high = np.quantile(means, [0.5 - CONFIDENCE / 2, 0.5 + CONFIDENCE / 2], axis=0)
    return {"mean": mean.tolist(), "interval": [low.tolist(), high.tolist()]}


def bootstrapped_means(values: np.ndarray, resamples: int = 1000) -> np.ndarray:
    """Interquartile means (resamples, P) of values (P, draws); all P share the resampled draws (paired)."""
    rng = np.random.default_rng(0)
    draws = rng.integers(values.shape[1], size=(resamples, values.shape[1]))
    return np.stack([middle_mean(row[draws]) for row in values], axis=1)


def ranks(means: np.ndarray) -> np.ndarray:
    """Ranks (..., P), from 1 for the smallest, of means (..., P); equal means share their average rank."""
    smaller = (means[..., None, :] < means[..., :, None]).sum(axis=-1)
    alike = (means[..., None, :] == means[..., :, None]).sum(axis=-1)
    return smaller + 0.5 * (alike + 1)
