"""The published table of policies holds the flights that its study orders, and no others."""

import csv
import importlib.util
import re
import subprocess
from contextlib import nullcontext
from pathlib import Path

import pytest

from heli_gym.baselines.evaluation.leaderboard import policy_on

ROOT = Path(__file__).parents[2]
MANEUVER = "travel-360"


def load_study():
    spec = importlib.util.spec_from_file_location("field_study", ROOT / "benchmarks" / "field.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_published_table_has_the_rows_and_draws_of_its_study():
    ordered: dict = {}
    for part in load_study().FIELD.values():
        for plant in part.plants:
            for policy in part.policies:
                for reference in part.references:
                    key = reference, plant, policy_on(policy, plant)
                    ordered[key] = max(part.draws, ordered.get(key, 0))
    with open(ROOT / "results" / "leaderboard.csv", newline="", encoding="utf-8") as file:
        published = {(row["reference"], row["plant"], row["policy"]): int(row["draws"]) for row in csv.DictReader(file)}
    assert published == ordered


def test_the_page_on_learning_has_the_rows_of_the_published_table():
    with open(ROOT / "results" / "leaderboard.csv", newline="", encoding="utf-8") as file:
        published = {(row["plant"], row["policy"]): row for row in csv.DictReader(file) if row["reference"] == MANEUVER}
    page = (ROOT / "docs" / "learning.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (.+) \| `(.+)` \| (.+) \| (.+) \| (.+) \| (\d+ of \d+) \| (\d+) % \|$", page, re.MULTILINE)
    names = {
        "feedforward + TV-LQR, tuned": "feedforward+tvlqr@{}",
        "Kalman LQR, tuned": "kalman-lqr@{}",
        "adaptive MPC": "adaptive-mpc",
    }
    assert len(rows) == 16
    for label, plant, *cells in rows:
        learned = "residual" if plant.startswith("lab") else "residual-rigid"
        row = published[plant, names.get(label, learned).format(plant.removesuffix("+outside"))]
        errors = [f"{float(row[name]):.2f}" for name in ("rms_travel_deg", "rms_elevation_deg", "cost")]
        assert cells == [*errors, f"{row['crashes']} of {row['draws']}", f"{100.0 * float(row['success']):.0f}"], label
    of_networks = re.findall(
        r"^\| `(residual.*)` \| `(.+)` \| (.+) \[(.+), (.+)\] \| (.+) \[(.+), (.+)\] \| (.+) \| (\d+) \| (\d+) % \|$",
        page,
        re.MULTILINE,
    )
    assert len(of_networks) == 6
    for policy, plant, *cells in of_networks:
        row = published[plant, policy]
        names = ("rms_travel_deg", "rms_elevation_deg")
        errors = [f"{float(row[name + end]):.2f}" for name in names for end in ("", "_low", "_high")]
        errors.append(f"{float(row['cost']):.2f}")
        assert cells == [*errors, row["crashes"], f"{100.0 * float(row['success']):.0f}"], (policy, plant)


def test_a_folder_names_only_commits_that_flew_something(tmp_path, monkeypatch):
    study = load_study()
    file = tmp_path / "nominal" / "flights" / "zero.jsonl"

    def fly(commit, rows, ends=False):
        def leaderboard(*args, **kwargs):
            assert commit in study.commits_of(tmp_path / "nominal")  # should it be killed
            file.parent.mkdir(exist_ok=True)
            with open(file, "a") as opened:
                opened.write("{}\n" * rows)
            if ends:
                raise subprocess.CalledProcessError(130, "heli-leaderboard")

        with monkeypatch.context() as patch:
            patch.setattr(study, "commit_of_packages", lambda: commit)
            patch.setattr(study.subprocess, "run", leaderboard)
            with pytest.raises(subprocess.CalledProcessError) if ends else nullcontext():
                study.fly_field(tmp_path, ["nominal"], 1)
        return study.commits_of(tmp_path / "nominal")

    assert fly("aaaaaaa", 2) == {"aaaaaaa"}
    assert fly("bbbbbbb", 0) == {"aaaaaaa"}
    assert fly("ccccccc", 0, ends=True) == {"aaaaaaa"}
    assert fly("ddddddd", 1, ends=True) == {"aaaaaaa", "ddddddd"}
