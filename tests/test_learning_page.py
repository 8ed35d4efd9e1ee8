"""The tables of the page on learning and of the README are those in results/."""

import json
import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "learning.md").read_text(encoding="utf-8")
README = (ROOT / "README.md").read_text(encoding="utf-8")
POLICIES = {
    "feedforward + TV-LQR, the paper's weights": "feedforward+tvlqr",
    "feedforward + TV-LQR, tuned": "feedforward+tvlqr@{}",
    "Kalman LQR, tuned": "kalman-lqr@{}",
    "adaptive MPC": "adaptive-mpc",
    "linear MPC": "linear-mpc",
    "lag LQR": "lag-lqr",
    "lag LQR with integral": "lag-lqi",
    "Kalman LQR": "kalman-lqr",
    "flatness-based": "flatness",
    "L1 adaptive": "l1-adaptive",
    "adaptive LQR": "adaptive-lqr",
    "learned correction (10 seeds)": "residual",
    "learned correction (3 seeds)": "residual",
    "oracle, which knows each draw": "oracle",
    "the paper's controller, tuned": "feedforward+tvlqr@{}",
    "the paper's controller": "feedforward+tvlqr",
    "adaptive predictive control": "adaptive-mpc",
    "linear predictive control": "linear-mpc",
    "a learned correction of the paper's controller, 10 seeds": "residual",
    "a learned correction of the paper's controller, 3 seeds": "residual",
}


def results(name):
    return json.loads((ROOT / "results" / f"{name}.json").read_text(encoding="utf-8"))


def rows_between(start, end):
    """Cells of the rows of a table between two texts of the page, without emphasis."""
    part = PAGE[PAGE.index(start) : PAGE.index(end)].replace("**", "")
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in part.splitlines() if line.startswith("|")]


def with_interval(value):
    return "{:.2f} [{:.2f}, {:.2f}]".format(value["iqm"], *value["interval"])


def percent(share, digits=0):
    return f"{100.0 * share:.{digits}f} %"


def test_the_first_table_has_the_results_of_the_held_out_draws():
    plant, seen = "", []
    for label, *cells in rows_between("| policy | travel (deg)", "Interquartile means over the draws of RMS errors")[
        2:
    ]:
        if label.startswith("`"):
            plant = label.strip("`")
            continue
        row = results(plant)[POLICIES[label].format(plant)]
        means = [with_interval(row[name]) for name in ("travel", "elevation", "cost")]
        assert cells == [*means, percent(row["crashes"]), percent(row["success"])], (plant, label)
        if row["seeds"] > 1:
            assert label.endswith(f"({row['seeds']} seeds)")
        seen.append(plant)
    assert [seen.count(plant) for plant in ("lab", "rigid", "fleet")] == [6, 6, 10]


def test_the_table_of_parts_and_learners_has_the_results_of_the_short_trainings():
    found = results("ablation")
    rows = rows_between("| | seeds | travel (deg)", "Without the memory, the preview or the inner saturation")[2:]
    for label, seeds, *cells in rows:
        row = found[label]
        means = [with_interval(row[name]) for name in ("travel", "elevation", "cost")]
        assert cells == [*means, percent(row["crashes"], 1)], label
        assert seeds == ("" if label == "base alone" else str(row["seeds"]))
    assert len(rows) == 7


def test_the_advantage_over_the_best_classical_policy_on_the_fleet_is_that_of_the_paired_draws():
    row = results("fleet")["residual"]
    for name, text in (("travel", "travel error is smaller by"), ("elevation", "elevation error by")):
        gain = row[f"{name} improvement"]
        values = f"{percent(gain['share'])} [{100 * gain['interval'][0]:.0f}, {100 * gain['interval'][1]:.0f}]"
        assert f"{text} {values}" in " ".join(PAGE.split())
        assert gain["interval"][0] > 0.0


def test_the_readmes_table_has_the_same_results():
    rows = re.findall(r"^\| `(.+)` \| (.+) \| (.+) \| (.+) \| (\d+ %) \|$", README, re.MULTILINE)
    assert len(rows) == 10
    for plant, label, travel, elevation, crashes in rows:
        row = results(plant)[POLICIES[label].format(plant)]
        assert [travel, elevation, crashes] == [
            with_interval(row["travel"]),
            with_interval(row["elevation"]),
            percent(row["crashes"]),
        ], (plant, label)


def test_the_table_of_maneuvers_has_the_results_of_all_of_them():
    rows = rows_between("| maneuver | feedforward", "Over all of them, the network for any maneuver")[2:]
    found = results("maneuvers")
    assert [label.strip("`") for label, *_ in rows] == list(found)
    for label, *cells in rows:
        for cell, row in zip(cells, found[label.strip("`")].values(), strict=True):
            errors = f"{row['travel']['iqm']:.2f} / {row['elevation']['iqm']:.2f}"
            assert cell.partition(",")[0] == errors, label
            assert cell.partition(", ")[2] in (percent(row["crashes"]), "" if row["crashes"] == 0.0 else None)
