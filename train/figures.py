"""`python -m heli_gym.train.figures`: draw the figures of the manual's page on learning into docs/.

The figures are learning curves of stored runs and one flight with and without a learned correction.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.residual import ResidualPolicy
from heli_gym.baselines.evaluation.rollout import fly
from heli_gym.env import Heli3DOFEnv
from heli_gym.storage import atomic_write
from heli_gym.train.train import START_SPREAD_DEG, VALIDATION_SEED

PARTS = (("travel", lambda row: row["rms_error_deg"][0]), ("elevation", lambda row: row["rms_error_deg"][1]))


def learning_curves(runs: Mapping[str, Sequence[Path]]) -> Figure:
    """Errors on the validation helicopters against control periods and CPU time.

    Args:
        runs: folders of `heli-train`, by label; several folders are stages, each initialised with the previous network.
    """
    figure, axes = plt.subplots(1, 2, figsize=(10.0, 3.6), sharey=True, layout="constrained")
    for number, (label, folders) in enumerate(runs.items()):
        steps: list[int] = []
        seconds: list[float] = []
        rows: list[dict[str, Any]] = []
        for stage, folder in enumerate(folders):
            history = json.loads((folder / "history.json").read_text(encoding="utf-8"))
            offset = (steps[-1], seconds[-1]) if steps else (0, 0.0)
            for row in history[1:] if stage else history:
                steps.append(offset[0] + row["steps"])
                seconds.append(offset[1] + row["seconds"])
                rows.append(row)
        for (name, value), style in zip(PARTS, ("-", "--")):
            for axis, x in zip(axes, (np.array(steps) / 1e6, seconds)):
                axis.plot(x, list(map(value, rows)), style, color=f"C{number}", label=f"{label}, {name}")
    axes[0].set_xlabel("control periods flown (millions)")
    axes[1].set_xlabel("CPU time of one core (s)")
    axes[0].set_ylabel("mean RMS error (deg)")
    axes[0].set_yscale("log")
    axes[0].set_yticks([0.5, 1.0, 2.0, 5.0], ["0.5", "1", "2", "5"])
    axes[0].yaxis.set_minor_formatter(NullFormatter())
    for axis in axes:
        axis.grid(alpha=0.3, which="both")
    axes[1].legend(fontsize=8)
    return figure


def correction_in_flight(name: str, plant: str, seed: int, seconds: float = 4.0) -> Figure:
    """Errors and voltages at the start of a flight, with and without the correction of a named policy."""
    env = Heli3DOFEnv(plant, start_spread_deg=START_SPREAD_DEG)
    policy = make_policy(name, env.reference)
    assert isinstance(policy, ResidualPolicy)
    base: list[np.ndarray] = []
    observe = policy.observe

    def recording_observe(t: float, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        u, features = observe(t, measurement)
        base.append(np.clip(u, *policy.voltage_limits))
        return u, features

    policy.observe = recording_observe  # type: ignore[method-assign,assignment]
    corrected = fly(env, policy, seed=seed)
    alone = fly(env, policy.base, seed=seed)
    reference = env.reference(corrected.t)[0]
    figure, axes = plt.subplots(2, 2, figsize=(10.0, 5.0), sharex=True, layout="constrained")
    for axis, row, axis_name in zip(axes[0], (0, 2), ("travel", "elevation")):
        for flight, label in ((alone, "base alone"), (corrected, "with the correction")):
            n = int(np.searchsorted(flight.t, seconds))
            axis.plot(flight.t[:n], np.degrees(flight.x[row, :n] - reference[row, :n]), label=label)
        axis.set_ylabel(f"error of {axis_name} (deg)")
    for axis, motor, motor_name in zip(axes[1], (0, 1), ("front", "back")):
        shown = np.array(base)[:, motor]
        axis.step(corrected.t[:-1], shown, where="post", label="base, saturated", color="C2", lw=1.0)
        axis.step(corrected.t[:-1], corrected.u[motor, :-1], where="post", label="applied", color="C1", lw=1.5)
        axis.fill_between(
            corrected.t[:-1], shown, corrected.u[motor, :-1], step="post", color="C1", alpha=0.2, label="correction"
        )
        axis.set_ylabel(f"{motor_name} voltage (V)")
        axis.set_xlabel("time (s)")
    for axis in axes.flat:
        axis.set_xlim(0.0, seconds)
        axis.grid(alpha=0.3)
    axes[0, 1].legend(fontsize=8)
    axes[1, 1].legend(fontsize=8)
    return figure


def main(results: Path = Path("results"), docs: Path = Path("docs")) -> None:
    """Draw all figures."""
    runs = {
        "lab": (results / "lab/first-stage/0", results / "lab/residual/0"),
        "rigid": (results / "rigid/residual/0",),
    }
    figures = {
        "learning-curves": learning_curves(runs),
        "learning-flight": correction_in_flight("residual", "lab", VALIDATION_SEED + 3),
    }
    for name, figure in figures.items():
        with atomic_write(docs / f"{name}.png") as file:
            figure.savefig(file, format="png", dpi=110)
        plt.close(figure)


if __name__ == "__main__":
    main()
