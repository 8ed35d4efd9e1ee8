"""`heli-evaluate`: its table, its files and its error messages."""

import json
import math
import os
import re
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import asdict, fields
from importlib.metadata import version
from io import StringIO

import numpy as np
import pytest
from matplotlib.image import imread
from rich.console import Console

from heli_gym.baselines import fly, make_policy
from heli_gym.baselines.commands import evaluate
from heli_gym.baselines.commands.evaluate import Args
from heli_gym.baselines.evaluation.metrics import Metrics, flight_metrics
from heli_gym.env import Heli3DOFEnv, find_reference

POLICIES = ("open-loop", "zero")
EPISODES, SEED = 3, 5
FIGURES = {f"fig{number:02d}" for number in (2, 4, 5, 6, 7, 8, 9, 10, 11)}  # the paper's but schematics and photographs


def numbers(value):
    """Every number in a JSON value."""
    if isinstance(value, dict | list):
        for item in value.values() if isinstance(value, dict) else value:
            yield from numbers(item)
    elif isinstance(value, int | float):
        yield value


def read(folder):
    return json.loads((folder / "results.json").read_text())


def without_wall_time(results):
    for row in (*results["summary"], *results["flights"]):
        del row["wall_time"]
    return results["summary"], results["flights"], results["paper"]


@pytest.fixture(scope="module")
def evaluated(tmp_path_factory):
    """The folder and the settings of one evaluation with figures, and what it printed to both streams."""
    folder = tmp_path_factory.mktemp("evaluated") / "out"
    folder.mkdir()
    for earlier in ("results.json", "overview.png"):
        (folder / earlier).touch()
    args = Args(policies=POLICIES, episodes=EPISODES, seed=SEED, out=folder)
    with redirect_stdout(StringIO()) as printed, redirect_stderr(StringIO()) as complaints:
        evaluate.main(args)
    return folder, args, printed.getvalue(), complaints.getvalue()


@pytest.fixture(scope="module")
def results(evaluated):
    return read(evaluated[0])


def test_results_are_valid_json_and_finite(evaluated):
    text = (evaluated[0] / "results.json").read_text()
    assert "NaN" not in text
    assert "Infinity" not in text
    assert all(map(math.isfinite, numbers(json.loads(text))))


def test_results_say_which_version_and_settings_made_them(evaluated, results):
    args = evaluated[1]
    assert results["version"] == version("heli-gym")
    assert results["settings"] == {**asdict(args), "policies": list(POLICIES), "out": str(args.out)}


def test_every_policy_flies_once_exactly_and_then_the_same_episodes(results):
    flown = [(f["policy"], f["start"], f["control_period"], f["seed"]) for f in results["flights"]]
    exact = [(policy, "exact", 0.001, SEED) for policy in POLICIES]
    assert flown == exact + [(p, "perturbed", 0.02, SEED + k) for p in POLICIES for k in range(EPISODES)]


def test_the_metrics_of_an_episode_are_those_of_its_flight(results):
    env = Heli3DOFEnv(start_spread_deg=5.0)
    flight = fly(env, make_policy("open-loop", env.reference), seed=SEED + 1)
    expected = flight_metrics(flight, env.reference, env.voltage_limits)._asdict()
    [row] = [f for f in results["flights"] if (f["policy"], f["seed"]) == ("open-loop", SEED + 1)]
    assert row["metrics"] == json.loads(json.dumps(expected))
    assert row["wall_time"] > 0.0


def test_a_summary_is_the_mean_and_an_interval_around_it(results):
    rows = {(row["start"], row["policy"]): row for row in results["summary"]}
    assert list(rows) == [(start, policy) for start in ("exact", "perturbed") for policy in POLICIES]
    for (start, policy), row in rows.items():
        group = [f for f in results["flights"] if (f["start"], f["policy"]) == (start, policy)]
        assert row["episodes"] == len(group) == (1 if start == "exact" else EPISODES)
        for name in (*Metrics._fields, "wall_time"):
            values = np.array([f.get(name, f["metrics"].get(name)) for f in group], float)
            np.testing.assert_allclose(row[name]["mean"], values.mean(axis=0), rtol=1e-12, atol=1e-15)
            if (values == values[0]).all():
                assert row[name]["interval"] is None
            else:
                low, high = np.array(row[name]["interval"])
                ordered = [values.min(axis=0), low, values.mean(axis=0), high, values.max(axis=0)]
                assert (np.diff(ordered, axis=0) >= -1e-9 * np.abs(ordered[-1])).all()
                assert np.any(high > low)


def test_the_papers_numbers_stand_with_ours(results):
    assert results["paper"]
    for statement in results["paper"]:
        assert set(statement) == {"what", "paper", "here"}
    both = {statement["what"]: (statement["paper"], statement["here"]) for statement in results["paper"]}
    [(paper, here)] = [pair for what, pair in both.items() if "(43)" in what]
    assert float(paper.split()[0]) == pytest.approx(float(here.split()[0]), abs=0.01)


def test_one_table_is_printed_with_every_policy_and_metric(evaluated):
    printed = evaluated[2]
    for words in (*POLICIES, "RMS", "peak pitch", "saturated", "cost", "success", "wall time", "The paper's numbers"):
        assert words in printed


def test_every_figure_of_the_paper_is_a_picture(evaluated):
    pictures = sorted(evaluated[0].glob("*.png"))
    assert {picture.name[:5] for picture in pictures} >= FIGURES
    for picture in pictures:
        assert picture.read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
        pixels = imread(picture)
        assert min(pixels.shape[:2]) > 300
        assert pixels[..., :3].std() > 0.01  # something is drawn
    assert {name for name in os.listdir(evaluated[0]) if not name.endswith(".png")} == {"results.json"}


def test_earlier_results_and_figures_are_listed_before_they_are_replaced(evaluated):
    for name in ("results.json", "overview.png"):
        assert f"heli-evaluate: replaces {evaluated[0] / name} of an earlier run\n" in evaluated[3]


def test_equal_seeds_give_equal_results_and_figures_are_optional(evaluated, results, tmp_path):
    evaluate.main(Args(policies=POLICIES, episodes=EPISODES, seed=SEED, out=tmp_path, figures=False))
    assert os.listdir(tmp_path) == ["results.json"]
    assert without_wall_time(read(tmp_path)) == without_wall_time(read(evaluated[0]))


@pytest.mark.parametrize("name", ["climb-7.5", "own.npz"])
def test_figures_of_flights_show_the_flown_maneuver_and_figures_of_plans_the_papers(
    tmp_path, monkeypatch, paper_plan, unconstrained_plan, name
):
    flown = find_reference("climb-7.5")
    flown.save(tmp_path / "own.npz")
    monkeypatch.setattr(evaluate, "PAPER_PERIOD", 0.02)  # sooner flown
    drawn = {}

    def save(figure, path, columns):
        drawn[path.stem[:5]] = figure

    monkeypatch.setattr(evaluate.figure_style, "save", save)
    reference = str(tmp_path / name) if name == "own.npz" else name
    args = Args(reference=reference, plant="lab", seed=SEED, out=tmp_path)
    evaluate.draw_figures(args, unconstrained_plan, paper_plan, Console(quiet=True))
    for figure in (drawn["overv"], drawn["fig10"], drawn["fig11"]):
        assert figure.get_suptitle() == f"{name} on the plant lab at 20 ms"
        [plan] = [line for line in figure.axes[0].lines if line.get_label() == "plan"]
        np.testing.assert_array_equal(plan.get_xdata(), flown.t)
    elevation, [start, *_] = flown.x[2], drawn["overv"].axes[1].lines[0].get_ydata()
    assert start == pytest.approx(np.degrees(elevation[0]) + evaluate.FIGURE_START_DEG[1])
    assert drawn["fig08"].axes[0].lines[0].get_xdata()[-1] == 10.0


@pytest.mark.parametrize(("plant", "policy"), [("lab", "open-loop"), ("nominal", "residual")])
def test_the_title_of_the_table_names_its_starts(evaluated, plant, policy):
    args = Args(policies=(policy,), plant=plant, episodes=1)
    rows = evaluate.summarise(evaluate.evaluate(args, Console(quiet=True)))
    assert [row["start"] for row in rows] == ["perturbed"]
    assert evaluate.table_title(args, rows).endswith(f"on the plant {plant}: perturbed: 1 starts up to 5° off at 20 ms")
    assert "exact start at 1 ms; perturbed: 3 starts" in " ".join(evaluated[2].split())


def test_the_caption_says_when_a_flight_is_a_success_and_what_saturates(evaluated):
    printed = " ".join(evaluated[2].split())
    assert "success: flown to the end of the maneuver, every error within its tolerance there (3 / 6 / 3 /" in printed
    assert "saturated: time with a voltage at a limit of the amplifier" in printed


def test_every_policy_is_looked_up_before_the_first_is_flown(tmp_path, monkeypatch):
    for name in ("fly", "fly_many"):
        monkeypatch.setattr(evaluate, name, lambda *args, **kwargs: pytest.fail("flown"))
    with pytest.raises(SystemExit, match="heli-evaluate: name = 'foo'"):
        evaluate.main(Args(policies=("zero", "foo"), episodes=1, out=tmp_path))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("policies", ("no-such-policy",)),
        ("policies", ()),
        ("reference", "no-such-reference"),
        ("plant", "no-such-plant"),
        ("episodes", 0),
        ("seed", -1),
        ("control_period", 0.0),
        ("control_period", math.nan),
        ("start_spread_deg", -1.0),
        ("start_spread_deg", 90.0),
    ],
)
def test_bad_input_is_refused_with_a_message_that_names_it_and_nothing_is_written(tmp_path, monkeypatch, name, value):
    monkeypatch.chdir(tmp_path)
    args = Args(**{"policies": ("zero",), "episodes": 1, "figures": False, name: value})
    with pytest.raises(SystemExit) as refusal:
        evaluate.main(args)
    said = {"policies": "polic|name", "seed": "[Ss]eed"}.get(name, name)
    shown = re.escape(repr(value[0] if isinstance(value, tuple) and value else value))
    assert re.search(f"heli-evaluate: .*({said}).*{shown}", str(refusal.value))
    assert os.listdir(tmp_path) == []


def test_an_out_that_is_a_file_is_refused_with_a_message_that_names_it(tmp_path, monkeypatch):
    monkeypatch.setattr(evaluate, "PAPER_PERIOD", 0.02)  # takes less time
    out = tmp_path / "file"
    out.write_text("precious")
    with pytest.raises(SystemExit, match=r"heli-evaluate: .*file"):
        evaluate.main(Args(policies=("zero",), episodes=1, out=out, figures=False))
    assert out.read_text() == "precious"


def test_arguments_are_read_from_the_command_line(monkeypatch, tmp_path):
    monkeypatch.setattr(sys, "argv", ["heli-evaluate", "--plant", "lunar", "--out", str(tmp_path / "out")])
    with pytest.raises(SystemExit, match="heli-evaluate: plant = 'lunar'"):
        evaluate.main()
    assert not (tmp_path / "out").exists()


def test_help_names_every_argument():
    child = subprocess.run(
        [sys.executable, "-m", "heli_gym.baselines.commands.evaluate", "--help"], capture_output=True, text=True
    )
    assert (child.returncode, child.stderr) == (0, "")
    for argument in fields(Args):
        assert f"--{argument.name.replace('_', '-')}" in child.stdout
