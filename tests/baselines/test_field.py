"""The published table of policies holds the flights that its study orders, and no others."""

import csv
import importlib.util
from pathlib import Path

from heli_gym.baselines.evaluation.leaderboard import policy_on

ROOT = Path(__file__).parents[2]


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
