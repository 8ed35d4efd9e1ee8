"""The published table of policies holds the flights that its study orders, and no others."""

import csv
import importlib.util
import re
from pathlib import Path

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
