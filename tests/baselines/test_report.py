"""Report of an evaluation: one file with the numbers of the table and the flights."""

import base64
import hashlib
import json
import re
from contextlib import redirect_stdout
from io import StringIO
from types import SimpleNamespace

import numpy as np
import pytest
from browser import DESKTOP, PHONE, check_accessible, in_browser

from heli_gym.baselines import fly, make_policy, riccati_gains
from heli_gym.baselines.commands import demo, evaluate
from heli_gym.baselines.evaluation import figure_style, figures, report
from heli_gym.baselines.evaluation.conditions import describe_draw
from heli_gym.baselines.evaluation.labels import label_of
from heli_gym.env import Heli3DOFEnv
from heli_gym.plant import PLANTS
from heli_gym.task import control_grid
from heli_gym.vector_env import Heli3DOFVectorEnv

POLICIES = ("feedforward+tvlqr", "open-loop")
SEED = 3


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """An evaluation with a report; the exact flights at 20 ms, which takes less time."""
    folder = tmp_path_factory.mktemp("evaluated")
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(StringIO()):
        patch.setattr(evaluate, "PAPER_PERIOD", 0.02)
        page = folder / "report.html"
        evaluate.main(evaluate.Args(policies=POLICIES, episodes=2, seed=SEED, out=folder, figures=False, report=page))
    return folder


@pytest.fixture(scope="module")
def data(folder):
    """What the page holds."""
    [text] = re.findall(
        r'<script id="data" type="application/json">(.*?)</script>', (folder / "report.html").read_text()
    )
    return json.loads(text)


def test_the_table_is_that_of_the_evaluation(folder, data):
    rows = json.loads((folder / "results.json").read_text())["summary"]
    assert data["table"]["rows"] == [evaluate.table_cells(row) for row in rows]
    assert data["table"]["columns"] == list(evaluate.COLUMNS)
    assert all(len(row) == len(evaluate.COLUMNS) for row in data["table"]["rows"])


def test_the_hardest_and_the_median_draw_come_first_and_the_exact_start_last(folder, data):
    hardest, median, exact = data["groups"]
    assert data["policies"] == list(POLICIES)
    flights = json.loads((folder / "results.json").read_text())["flights"]
    ends = [f["metrics"]["rms_error_deg"] for f in flights if f["policy"] == POLICIES[0] and f["start"] == "perturbed"]
    errors = np.hypot(*np.array(ends).T[:2])
    assert data["errors"][0] == pytest.approx(errors)
    seeds = [int(re.search(r"seed (\d+)", group["label"])[1]) for group in (hardest, median)]
    assert sorted(seeds) == [SEED, SEED + 1]
    assert hardest["label"].startswith("hardest draw")
    for group, seed, spread in ((hardest, seeds[0], 5.0), (median, seeds[1], 5.0), (exact, SEED, 0.0)):
        env = Heli3DOFEnv(start_spread_deg=spread)
        for policy, shown in zip(POLICIES, group["flights"], strict=True):
            flight = fly(env, make_policy(policy, env.reference), seed=seed)
            np.testing.assert_allclose(shown["x"], flight.x, rtol=0.0, atol=2e-6)
            np.testing.assert_allclose(shown["u"], flight.u, rtol=0.0, atol=2e-6)
            assert shown["ended"] == ""
        x_ref, _ = control_grid(env.reference, 0.02)
        np.testing.assert_allclose(group["reference"]["x"], x_ref, rtol=0.0, atol=1e-6)
        if spread:
            assert group["errors"][0] == pytest.approx(errors[seed - SEED])


def hand_made(policy, seed, travel, crashed=False):
    metrics = SimpleNamespace(rms_error_deg=(travel, 0.0, 0.0), crashed=crashed)
    return evaluate.Flight(policy, "perturbed", 0.02, seed, 0.0, metrics, None)


def test_the_hardest_draw_is_the_one_that_crashed_and_then_the_one_with_the_greater_error():
    flights = [hand_made("a", 1, 2.0), hand_made("a", 2, 3.0), hand_made("a", 3, 0.1, crashed=True)]
    assert evaluate.hardest_first(flights) == [3, 2, 1]


def test_draws_are_as_hard_as_their_mean_rank_over_the_policies_whatever_the_size_of_the_errors():
    alike = [hand_made(policy, seed, 1.3 - 0.1 * seed) for policy in ("a", "b") for seed in (1, 2, 3)]
    other = [hand_made("c", seed, 33.0 * seed) for seed in (1, 2, 3)]
    assert evaluate.hardest_first(alike + other) == [1, 2, 3]
    assert evaluate.hardest_first(other) == [3, 2, 1]


def test_a_policy_that_did_not_fly_from_every_start_is_left_out_there(tmp_path, monkeypatch):
    monkeypatch.setattr(evaluate, "PAPER_PERIOD", 0.02)
    page = tmp_path / "r.html"
    evaluate.main(evaluate.Args(policies=("zero", "residual"), episodes=2, figures=False, report=page, out=tmp_path))
    [text] = re.findall(r'<script id="data" type="application/json">(.*?)</script>', page.read_text())
    groups = json.loads(text)["groups"]
    assert [[flight is None for flight in group["flights"]] for group in groups] == [[False, False]] * 2 + [
        [False, True]
    ]


def test_the_draws_parameters_are_shown_with_their_ranges():
    envs = Heli3DOFVectorEnv(3, "rigid")
    envs.reset(seed=1)
    for k in range(3):
        shown = dict(describe_draw(envs.plants[k], envs.plant_of(k)))
        assert shown["rotors lag"] == f"{envs.plant_of(k).rotors.lag:.3g} s (0.05 to 0.2)"
        assert shown["rig"] in ("1 of 2", "2 of 2")
        assert set(shown) >= {"rotors thrust loss", "friction viscous travel", "rig kappa"}
    nominal = Heli3DOFVectorEnv(1)
    nominal.reset(seed=0)
    assert describe_draw(nominal.plants[0], nominal.plant_of(0)) == []


def test_options_that_are_drawn_together_are_named_once():
    for k, rig in enumerate(PLANTS["fleet"].alternatives):
        shown = describe_draw(PLANTS["fleet"], rig.draw(np.random.default_rng(k)))
        names = [name for name, _ in shown]
        assert shown[0] == ("rig", f"{k + 1} of 5")
        assert names.count("coupling gyro") == 1 and "coupling" not in names


def test_colours_and_names_are_the_same_in_the_figures_the_report_and_the_live_page(data):
    assert data["colours"] == [label_of(policy).colour for policy in POLICIES]
    assert data["labels"] == ["paper's controller", "open loop"]
    assert [(p["label"], p["colour"]) for p in demo.POLICIES] == [label_of(p["name"])[:2] for p in demo.POLICIES]
    reference = Heli3DOFEnv().reference
    figure = figures.overview(reference, dict.fromkeys(POLICIES, reference), "both")
    lines = {line.get_label(): line.get_color() for line in figure.axes[0].lines}
    assert lines == {**dict(zip(data["labels"], data["colours"])), "plan": figure_style.INK}


def test_a_finer_flight_is_thinned_out_and_one_that_ended_says_so():
    env = Heli3DOFEnv(control_period=0.005)
    flight = fly(env, make_policy("open-loop", env.reference, 0.005), seed=0)
    group = report.flight_group(report.Shown("", {"open-loop": flight}), env.reference, ["open-loop"])
    assert group["step"] == pytest.approx(0.02)
    np.testing.assert_allclose(group["flights"][0]["x"], flight.x[:, ::4], rtol=0.0, atol=1e-6)

    short = type(flight)(flight.t[:401], flight.x[:, :401], flight.u[:, :401], flight.limits)
    [ended] = report.flight_group(report.Shown("", {"a": short}), env.reference, ["a"])["flights"]
    assert "2.00 s" in ended["ended"]


def test_the_gains_are_those_of_the_controller(data):
    gains = riccati_gains(Heli3DOFEnv().reference)(0.02 * np.arange(501))
    np.testing.assert_allclose(data["gains"]["K"], gains, rtol=0.0, atol=1e-6)


def test_there_are_gains_only_where_they_are_flown(tmp_path):
    env = Heli3DOFEnv()
    flight = fly(env, make_policy("open-loop", env.reference), seed=0)
    table = {"title": "", "caption": "", "columns": [], "rows": []}
    report.write_report(tmp_path / "page.html", "some", table, env.reference, [report.Shown("", {"open-loop": flight})])
    assert '"gains":null' in (tmp_path / "page.html").read_text()


def test_the_page_asks_for_nothing_from_a_network(folder):
    text = (folder / "report.html").read_text()
    assert "default-src 'none'" in text
    assert not re.findall(r"(?:src|href)=[\"']?(?!data:)\w+:", text)
    assert len(text) < 2_500_000


def test_users_names_cannot_leave_their_elements_of_the_page(tmp_path):
    path = tmp_path / "page.html"
    report.write_page(path, "report", "<b>&</title>", {"text": "</script><!--script-->"})
    text = path.read_text()
    assert "<title>&lt;b>&amp;&lt;/title></title>" in text
    assert '{"text":"\\u003c/script>\\u003c!--script-->"}' in text


HOSTILE = "<img src=x onerror=\"document.title='ran'\"></script><script>document.title='ran'</script>'\"&"


def test_no_script_but_the_program_may_run(folder):
    text = (folder / "report.html").read_text()
    [program] = re.findall(r"<script>(.*?)</script>", text, flags=re.S)
    digest = base64.b64encode(hashlib.sha256(program.encode()).digest()).decode()
    [policy] = re.findall(r'Content-Security-Policy" content="([^"]+)"', text)
    assert f"script-src 'sha256-{digest}';" in policy
    assert "default-src 'none'" in policy


def test_hostile_names_are_shown_and_run_nothing(tmp_path):
    env = Heli3DOFEnv()
    flight = fly(env, make_policy("open-loop", env.reference), seed=0)
    table = {"title": HOSTILE, "caption": HOSTILE, "columns": ["start", HOSTILE], "rows": [["perturbed", HOSTILE]]}
    shown = [report.Shown(HOSTILE, {HOSTILE: flight}, [(HOSTILE, HOSTILE)])]
    report.write_report(tmp_path / "page.html", HOSTILE, table, env.reference, shown)
    seen = in_browser(
        tmp_path / "page.html",
        """
        return {title: await page.title(), text: await page.locator("h1").textContent(),
                images: await page.locator("img").count()};
    """,
    )
    assert seen == {"title": f"heli_gym: {HOSTILE}", "text": HOSTILE, "images": 0}


@pytest.mark.parametrize("name", ["page.txt", "page", "folder.html", "file/page.html"])
def test_another_kind_of_file_is_refused_before_anything_is_flown(tmp_path, monkeypatch, name):
    monkeypatch.setattr(evaluate, "fly", None)
    (tmp_path / "folder.html").mkdir()
    (tmp_path / "file").touch()
    with pytest.raises(SystemExit, match="heli-evaluate: report = "):
        evaluate.main(evaluate.Args(out=tmp_path, report=tmp_path / name))


# In a browser

READ = """
const numbers = (i) => page.locator(".view").nth(i).locator(".numbers").textContent();
const rows = () => page.locator("tbody tr").evaluateAll(
  (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
const slider = page.locator("#time");
"""


@pytest.mark.parametrize("size", [DESKTOP, PHONE])
def test_it_opens_without_complaint_fits_and_shows_the_table(folder, data, size):
    script = """
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        return {rows: await rows(), width, message: await page.locator(".stage").getAttribute("data-message")};
    """
    seen = in_browser(folder / "report.html", READ + script, size)
    labelled = [[row[0], label_of(row[1]).text, *row[2:]] for row in data["table"]["rows"]]
    assert seen == {"rows": labelled, "width": size[0], "message": None}


def test_the_replay_moves_the_helicopters_the_slider_and_the_plots_together(folder):
    script = """
        const heads = () => page.locator(".playhead").evaluateAll((all) => all.map((head) => head.style.transform));
        const look = async () => ({
          time: Number(await slider.inputValue()), numbers: await numbers(1), heads: await heads(),
          picture: (await page.locator(".stage").screenshot()).toString("base64"),
        });
        const before = await look();
        await page.locator("button", {hasText: "Play"}).click();
        await page.waitForFunction(() => Number(document.getElementById("time").value) > 1);
        await page.keyboard.press("Space");
        return [before, await look()];
    """
    before, after = in_browser(folder / "report.html", READ + script)
    assert before["time"] == 0.0
    assert after["time"] > 1.0
    assert before["numbers"] != after["numbers"]
    assert before["picture"] != after["picture"]
    assert len(after["heads"]) > 5
    assert all(head != old for head, old in zip(after["heads"], before["heads"], strict=True))


def test_at_any_time_the_page_shows_the_flight_that_was_chosen(folder, data):
    script = """
        const seen = [];
        for (const key of ["1", "3"]) {
          await page.keyboard.press(key);
          for (const time of ["0", "5", "10"]) {
            await slider.fill(time);
            seen.push(await numbers(1));
          }
        }
        await page.locator(".legend input").first().uncheck();
        return {seen, shown: await page.locator(".view:visible").count()};
    """
    answer = in_browser(folder / "report.html", READ + script)
    for n, text in enumerate(answer["seen"]):
        flight = data["groups"][0 if n < 3 else 2]["flights"][1]
        k = 250 * (n % 3)
        found = [float(value) for value in re.findall(r"-?[\d.]+", text.replace("\N{MINUS SIGN}", "-"))]
        expected = [*np.degrees([flight["x"][i][k] for i in (0, 2, 4)]), *(u[k] for u in flight["u"])]
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=0.051)
    assert answer["shown"] == len(POLICIES) - 1


def test_axe_finds_no_violation_on_the_report(folder):
    check_accessible(folder / "report.html")
