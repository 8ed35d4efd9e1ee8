"""Figures of the page on learning: the regression behind one of them, and the command."""

import sys

import numpy as np
import pytest

pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")

from heli_gym.train import figures


def test_without_a_penalty_the_determination_is_that_of_least_squares_on_the_other_half():
    rng = np.random.default_rng(0)
    states = rng.standard_normal((200, 3))
    values = states @ (1.0, -2.0, 0.5) + 4.0 + rng.standard_normal(200)
    design = np.column_stack((np.ones(200), states))
    solution = np.linalg.lstsq(design[:100], values[:100])[0]
    missed = values[100:] - design[100:] @ solution
    expected = 1.0 - (missed**2).mean() / values[100:].var()
    assert figures.determination(states, values, 100, ridge=0.0) == pytest.approx(expected, abs=1e-9)


def test_a_penalty_shrinks_the_weight_of_a_single_state_by_its_share():
    state = np.tile([-1.0, 1.0], 4)
    # the weight 2 becomes 2 / (1 + ridge), here 1, which leaves a quarter of the variance
    assert figures.determination(state[:, None], 2.0 * state, 4, ridge=1.0) == pytest.approx(0.75)


def run(monkeypatch, *arguments):
    monkeypatch.setattr(figures, "parameters_in_memory", None)
    monkeypatch.setattr(sys, "argv", ["figures", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        figures.main()
    return end.value.code


def test_a_wrong_folder_is_one_line_with_status_2_and_help_draws_nothing(tmp_path, monkeypatch, capsys):
    (tmp_path / "file").touch()
    before = sorted(tmp_path.iterdir())
    for arguments, words in (
        (("--docs", tmp_path / "file"), "docs = "),
        (("--docs", tmp_path, "--results", tmp_path), "results = "),
    ):
        assert run(monkeypatch, *arguments) == 2
        complaint = capsys.readouterr().err
        assert complaint.startswith(f"heli_gym.train.figures: {words}") and complaint.count("\n") == 1
    assert run(monkeypatch, "--docs", tmp_path, "--help") == 0
    assert sorted(tmp_path.iterdir()) == before
