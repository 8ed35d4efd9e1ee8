"""`python -m heli_gym.train.figures`: draw the figures of the manual's page on learning.

The figures are learning curves of stored runs, one flight with and without a learned correction, and how well its
memory knows the plant's draw.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.residual import ResidualPolicy
from heli_gym.baselines.evaluation.rollout import fly, fly_many
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import Heli3DOFEnv
from heli_gym.storage import atomic_write, check_folder
from heli_gym.train.train import START_SPREAD_DEG, VALIDATION_SEED
from heli_gym.vector_env import Heli3DOFVectorEnv

FIGURES = ("learning-curves", "learning-memory", "learning-flight")
PARTS = (("travel", lambda row: row["rms_error_deg"][0]), ("elevation", lambda row: row["rms_error_deg"][1]))


@dataclass
class Args:
    """Draw the figures of the manual's page on learning."""

    results: Path = Path("results")  # folder of the stored runs
    docs: Path = Path("docs")  # folder of the figures


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


class Recording:
    """Residual policy that records the voltages in V of its base, which must have no memory, and its hidden states."""

    def __init__(self, policy: ResidualPolicy) -> None:
        self.policy = policy
        self.base: list[np.ndarray] = []
        self.hidden: list[np.ndarray] = []

    def reset(self, rng: np.random.Generator) -> None:
        """Start a new record."""
        self.policy.reset(rng)
        self.base, self.hidden = [], []

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        self.base.append(np.clip(self.policy.base(t, measurement), *self.policy.voltage_limits))
        u = self.policy(t, measurement)
        hidden = getattr(self.policy.memory, "hidden", None)
        if hidden is not None:
            self.hidden.append(hidden)
        return u


DRAWN = {
    "rotor lag": lambda plant: plant.rotors.lag,
    "thrust loss": lambda plant: plant.rotors.thrust_loss,
    "travel friction": lambda plant: plant.friction.viscous[0],
    "elevation friction": lambda plant: plant.friction.viscous[1],
    "pitch friction": lambda plant: plant.friction.viscous[2],
}


def parameters_in_memory(name: str, plant: str, seed: int, count: int = 512) -> Figure:
    """How well a linear function of a recurrent network's hidden state gives each drawn parameter, over time.

    Ridge regression on half of the flights; the figure has the coefficient of determination on the others.
    """
    envs = Heli3DOFVectorEnv(count, plant, start_spread_deg=START_SPREAD_DEG)
    policy = make_policy(name, envs.reference_of(0))
    assert isinstance(policy, ResidualPolicy)
    recording = Recording(policy)
    envs.reset(seed=seed)
    plants = [envs.plant_of(i) for i in range(count)]
    fly_many(envs, recording, seed)
    steps = range(4, len(recording.hidden), 5)
    half = count // 2
    figure, axis = plt.subplots(figsize=(7.0, 3.6), layout="constrained")
    for label, value in DRAWN.items():
        drawn = np.array([value(one) for one in plants])
        shares = [determination(recording.hidden[k].T, drawn, half) for k in steps]
        axis.plot(envs.control_period * (np.array(steps) + 1), shares, label=label)
    axis.set_xlabel("time (s)")
    axis.set_ylabel("share of the variance explained")
    axis.set_ylim(0.0, 1.0)
    axis.set_xlim(0.0, envs.control_period * len(recording.hidden))
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
    return figure


def determination(states: np.ndarray, values: np.ndarray, half: int, ridge: float = 1e-2) -> float:
    """Coefficient of determination of a ridge regression of values (N,) on states (N, H), fitted on the first half."""
    mean, value = states[:half].mean(axis=0), values[:half].mean()
    known, new = states[:half] - mean, states[half:] - mean
    matrix = known.T @ known + ridge * half * np.diag(known.var(axis=0)) + 1e-9 * np.eye(known.shape[1])
    weights = np.linalg.solve(matrix, known.T @ (values[:half] - value))
    missed = values[half:] - value - new @ weights
    return float(1.0 - (missed**2).mean() / values[half:].var())


def correction_in_flight(name: str, plant: str, seed: int, seconds: float = 4.0) -> Figure:
    """Errors and voltages at the start of a flight, with and without the correction of a named policy."""
    env = Heli3DOFEnv(plant, start_spread_deg=START_SPREAD_DEG)
    policy = make_policy(name, env.reference)
    assert isinstance(policy, ResidualPolicy)
    recording = Recording(policy)
    corrected = fly(env, recording, seed=seed)
    base = recording.base
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


def run(args: Args) -> None:
    """Draw all figures."""
    check_folder("docs", args.docs)
    runs = {
        "lab": (args.results / "lab/first-stage/0", args.results / "lab/residual/0"),
        "rigid": (args.results / "rigid/residual/0",),
    }
    for folder in (folder for folders in runs.values() for folder in folders):
        if not (folder / "history.json").is_file():
            raise ValueError(
                f"results = {str(args.results)!r}: must hold {folder.relative_to(args.results)}/history.json"
            )
    announce_replaced("heli_gym.train.figures", *(args.docs / f"{name}.png" for name in FIGURES))
    drawn = (
        learning_curves(runs),
        parameters_in_memory("residual", "lab", VALIDATION_SEED),
        correction_in_flight("residual", "lab", VALIDATION_SEED + 3),
    )
    for name, figure in zip(FIGURES, drawn):
        with atomic_write(args.docs / f"{name}.png") as file:
            figure.savefig(file, format="png", dpi=110)
        plt.close(figure)


def main() -> None:
    """Run the module as a command."""
    with command("heli_gym.train.figures"):
        run(parse(Args, "heli_gym.train.figures", __doc__))


if __name__ == "__main__":
    main()
