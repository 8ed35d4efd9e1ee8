"""`heli-leaderboard`: common draws, resumption after any kill, no duplicates, verifiable tables."""

import csv
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import time
from html import unescape
from pathlib import Path

import numpy as np
import pytest
import tyro

from heli_gym.baselines import evaluate
from heli_gym.baselines.commands import evaluate as evaluate_command
from heli_gym.baselines.commands import leaderboard as command
from heli_gym.baselines.commands.leaderboard import Args
from heli_gym.baselines.control.weights import KALMAN_LQR, store_weights
from heli_gym.baselines.evaluation import leaderboard
from heli_gym.baselines.evaluation.conditions import COULOMB, find_condition
from heli_gym.baselines.evaluation.engine import open_engine
from heli_gym.baselines.evaluation.labels import LABELS, colours_of, label_of
from heli_gym.baselines.evaluation.leaderboard import Condition, Ledger, Settings, batches, fly_all, standings
from heli_gym.baselines.evaluation.leaderboard_tables import flight_order
from heli_gym.baselines.evaluation.statistics import interquartile_mean
from heli_gym.env import find_reference
from heli_gym.plant import PLANTS, RotorFault
from heli_gym.rig import find_rig
from heli_gym.trajectory import Trajectory

SETTINGS = Settings(seed=5, episodes=6, batch=2, control_period=0.02, start_spread_deg=5.0)
CONDITION = Condition("lab", "climb-7.5")
SMALL = {
    "policies": ("kalman-lqr@PLANT", "feedforward+tvlqr", "zero"),
    "plants": ("lab",),
    "references": ("climb-7.5",),
    "episodes": 6,
    "batch": 3,
    "seed": 5,
    "against": "feedforward+tvlqr",
    "workers": 1,
}


def read(folder):
    with open(folder / "flights.csv", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    folder = tmp_path_factory.mktemp("leaderboard") / "out"
    command.main(Args(**SMALL, out=folder))
    return folder


def test_there_is_one_row_for_every_flight_and_it_is_the_flight_of_its_seed(flown):
    rows = read(flown)
    names = [(row["policy"], row["plant"], int(row["seed"])) for row in rows]
    policies = ("kalman-lqr@lab", "feedforward+tvlqr", "zero")
    assert sorted(names) == sorted(
        (policy, plant, seed) for policy in policies for plant in ("lab", "lab+outside") for seed in range(5, 11)
    )
    alone = evaluate("feedforward+tvlqr", "lab", episodes=6, reference="climb-7.5", seed=5)
    found = [
        float(row["rms_travel_deg"]) for row in rows if (row["plant"], row["policy"]) == ("lab", "feedforward+tvlqr")
    ]
    np.testing.assert_allclose(found, alone.column("rms_travel_deg"), rtol=1e-6)


def test_the_parquet_file_holds_the_same_rows(flown):
    parquet = pytest.importorskip("pyarrow.parquet")
    rows = parquet.read_table(flown / "flights.parquet").to_pylist()
    assert [{name: str(value) for name, value in row.items()} for row in rows] == read(flown)


def test_the_tables_say_the_same_in_markdown_html_and_json(flown):
    tables = json.loads((flown / "leaderboard.json").read_text())["tables"]
    assert [table["plant"] for table in tables] == ["lab", "lab+outside"]
    rows = read(flown)
    for table in tables:
        for entry in table["policies"]:
            own = [r for r in rows if (r["policy"], r["plant"]) == (entry["policy"], table["plant"])]
            errors = np.array([float(r["rms_error_deg"]) for r in own])
            assert entry["rms_error_deg"]["iqm"] == pytest.approx(interquartile_mean(errors))
            low, high = entry["rms_error_deg"]["interval"]
            assert low <= entry["rms_error_deg"]["iqm"] <= high
            for text in ((flown / "leaderboard.md").read_text(), (flown / "leaderboard.html").read_text()):
                assert all(cell.replace("|", "\\|") in unescape(text) for cell in command.cells(entry))
        assert [entry["rank"]["value"] for entry in table["policies"]] == [1.0, 2.0, 3.0]
        assert table["policies"][-1]["policy"] == "zero"


def test_the_page_fetches_nothing_and_runs_nothing(flown):
    text = (flown / "leaderboard.html").read_text()
    assert "default-src 'none'" in text
    assert "<script" not in text
    for link in re.findall(r'href="([^"]+)"', text):
        assert (flown / link).is_file()


def test_a_second_start_in_the_same_folder_is_refused_and_other_settings_too(flown, capsys):
    before = (flown / "flights.csv").read_bytes()
    for change, words in (
        ({}, "holds a leaderboard already; --resume"),
        ({"resume": True, "seed": 6}, "seed = 6"),
        ({"resume": True, "batch": 4}, "batch = 4"),
    ):
        with pytest.raises(SystemExit, match=words):
            command.main(Args(**{**SMALL, **change}, out=flown))
    assert (flown / "flights.csv").read_bytes() == before


def test_flights_of_a_policy_that_has_changed_or_of_another_version_are_not_mixed(flown, tmp_path, monkeypatch):
    before = (flown / "flights.csv").read_bytes()
    resumed = Args(**{**SMALL, "resume": True, "pages": False}, out=flown)
    with monkeypatch.context() as patch:
        patch.setattr("heli_gym.baselines.control.weights.stored.TUNED", tmp_path)
        store_weights("kalman-lqr", "lab", KALMAN_LQR)
        with pytest.raises(SystemExit, match="policies = 'kalman-lqr@lab' on the rig 'paper': has changed since"):
            command.main(resumed)
    with monkeypatch.context() as patch:
        patch.setattr(command, "version", lambda name: "0.0.1")
        with pytest.raises(SystemExit, match=r"version = '0\.0\.1': the leaderboard in .* was begun with"):
            command.main(resumed)
    assert (flown / "flights.csv").read_bytes() == before


def test_files_are_compared_by_content_and_stay_known_when_their_policy_does_not_fly(tmp_path):
    reference = find_reference("climb-7.5")
    path = tmp_path / "mine.npz"
    reference.save(path)
    wanted = batches(("zero",), [Condition("lab", str(path))], SETTINGS)
    digests = command.digests_of(wanted, SETTINGS)
    begun = {**SETTINGS._asdict(), "version": command.version("heli-gym"), "sha256": digests}
    command.write_json(tmp_path / "settings.json", begun)
    args = Args(out=tmp_path, resume=True)
    assert command.check_begun(args, SETTINGS, {"policies = 'x'": "1"}) == {**digests, "policies = 'x'": "1"}
    Trajectory(reference.t, 0.5 * reference.x, reference.u, reference.limits).save(path)
    with pytest.raises(ValueError, match=r"references = '.*mine\.npz': has changed since"):
        command.check_begun(args, SETTINGS, command.digests_of(wanted, SETTINGS))
    del begun["sha256"]  # of a folder without digests
    command.write_json(tmp_path / "settings.json", begun)
    assert command.check_begun(args, SETTINGS, digests) == digests


def test_resuming_a_complete_one_flies_nothing_and_a_new_policy_joins(flown, monkeypatch, tmp_path):
    (tmp_path / "my_own.py").write_text("def make():\n    return lambda t, measurement: (8.0, 8.0)\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [str(tmp_path), *sys.path])
    batches_flown = []
    original = leaderboard.fly_batch

    def counted(batch, settings):
        batches_flown.append(batch)
        return original(batch, settings)

    monkeypatch.setattr(leaderboard, "fly_batch", counted)
    command.main(Args(**{**SMALL, "resume": True, "pages": False}, out=flown))
    assert batches_flown == []
    joined = (*SMALL["policies"], "my_own:make")
    command.main(Args(**{**SMALL, "policies": joined, "resume": True, "pages": False}, out=flown))
    assert {batch.policy for batch in batches_flown} == {"my_own:make"}
    assert "my_own:make" in (flown / "leaderboard.md").read_text()


def fly_into(folder, workers=1, stop_after=None):
    """All rows of a small leaderboard, or of its first batches, as if killed then."""
    wanted = batches(("lqi", "zero"), [CONDITION], SETTINGS)
    ledger = Ledger(folder)
    try:
        with open_engine("local", workers) as engine:
            for n, _ in enumerate(fly_all(ledger.keep_whole(wanted), SETTINGS, ledger, engine)):
                if stop_after is not None and n + 1 == stop_after:
                    break
        return ledger.rows(wanted)
    finally:
        ledger.close()


def test_after_a_kill_only_incomplete_batches_are_flown_again_and_give_the_same_rows(tmp_path):
    whole = fly_into(tmp_path / "whole")
    assert len(whole) == 12
    fly_into(tmp_path / "cut", stop_after=3)
    for path in (tmp_path / "cut" / "flights").iterdir():
        path.write_bytes(path.read_bytes()[:-20])  # in the middle of the last row
    wanted = batches(("lqi", "zero"), [CONDITION], SETTINGS)
    ledger = Ledger(tmp_path / "cut")
    missing = ledger.keep_whole(wanted)
    ledger.close()
    assert len(missing) == 6 - 3 + 2  # the last batch of each of the two files
    assert fly_into(tmp_path / "cut") == whole


def test_rows_that_were_stored_twice_count_once(tmp_path):
    whole = fly_into(tmp_path)
    for path in (tmp_path / "flights").iterdir():
        path.write_bytes(2 * path.read_bytes())
    assert fly_into(tmp_path) == whole


def test_two_leaderboards_do_not_fly_into_the_same_folder(tmp_path):
    ledger = Ledger(tmp_path)
    with pytest.raises(ValueError, match="another heli-leaderboard"):
        Ledger(tmp_path)
    ledger.close()
    Ledger(tmp_path).close()


@pytest.mark.slow
def test_killed_at_any_moment_it_goes_on_and_ends_with_the_rows_of_an_undisturbed_run(tmp_path):
    def order(folder, *more):
        code = "from heli_gym import cli\nif __name__ == '__main__':\n    cli.run('heli-leaderboard')\n"
        (tmp_path / "start.py").write_text(code)
        arguments = [
            "--policies",
            "lqi",
            "zero",
            "--plants",
            "lab",
            "--references",
            "climb-7.5",
            "--episodes",
            "40",
            "--batch",
            "4",
            "--no-pages",
        ]
        return [sys.executable, str(tmp_path / "start.py"), *arguments, "--out", str(tmp_path / folder), *more]

    subprocess.run(order("whole"), check=True, capture_output=True)
    rng = np.random.default_rng(0)
    for _ in range(4):
        child = subprocess.Popen(order("killed", "--resume"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(rng.uniform(3.0, 12.0))
        child.send_signal(signal.SIGKILL)
        child.wait()
    subprocess.run(order("killed", "--resume"), check=True, capture_output=True)
    assert read(tmp_path / "killed") == read(tmp_path / "whole")


@pytest.mark.slow
def test_a_killed_process_costs_its_batch_and_no_row(tmp_path):
    whole = fly_into(tmp_path / "whole")
    wanted = batches(("lqi", "zero"), [CONDITION], SETTINGS)
    ledger = Ledger(tmp_path / "killed")
    killed = False
    with open_engine("local", 2) as engine:
        for _ in fly_all(ledger.keep_whole(wanted), SETTINGS, ledger, engine):
            if not killed:
                children = subprocess.run(
                    ["pgrep", "-P", str(os.getpid()), "-f", "spawn_main"], capture_output=True, text=True
                ).stdout.split()
                os.kill(int(children[0]), signal.SIGKILL)
                killed = True
    rows = ledger.rows(wanted)
    ledger.close()
    assert rows == whole


def test_interrupted_it_says_how_to_go_on_and_leaves_the_rows_so_far(tmp_path, monkeypatch, capsys):
    original = leaderboard.fly_batch
    flown = []

    def interrupted(batch, settings):
        if len(flown) == 3:
            raise KeyboardInterrupt
        flown.append(batch)
        return original(batch, settings)

    monkeypatch.setattr(leaderboard, "fly_batch", interrupted)
    with pytest.raises(SystemExit) as end:
        command.main(Args(**SMALL, out=tmp_path / "out"))
    assert end.value.code == 130
    assert "interrupted; 9 flights are in" in capsys.readouterr().err
    assert len(read(tmp_path / "out")) == 9


def row(policy, seed, error, crashed=False):
    zero = dict.fromkeys(("rms_travel_deg", "rms_elevation_deg", "cost"), error)
    return {
        "policy": policy,
        "seed": seed,
        "rms_error_deg": error,
        **zero,
        "crashed": crashed,
        "success": not crashed,
        "within_limits": True,
    }


def test_the_better_policy_ranks_first_and_a_crash_never_helps():
    rows = [row("a", k, 1.0 + 0.1 * k) for k in range(20)] + [row("b", k, 2.0 + 0.1 * k) for k in range(20)]
    first, second = standings(rows, "b")
    assert (first["policy"], first["rank"]) == ("a", {"value": 1.0, "interval": (1.0, 1.0)})
    assert first["probability_of_improvement"] == 1.0
    assert second["probability_of_improvement"] == 0.5
    crashing = [row("a", k, 0.01, crashed=True) for k in range(20)] + rows[20:]
    entries = {entry["policy"]: entry for entry in standings(crashing, "b")}
    assert entries["a"]["probability_of_improvement"] == 0.0
    some = [row("a", k, 0.01 if k < 12 else 3.0 + k, crashed=k < 12) for k in range(20)] + rows[20:]
    assert standings(some, "b")[0]["policy"] == "b"


def test_the_median_and_the_worst_seed_follow_the_errors_and_a_crash_is_the_worst():
    errors = {7: 3.0, 8: 1.0, 9: 5.0, 10: 2.0, 11: 4.0}
    [entry] = standings([row("a", seed, error) for seed, error in errors.items()], "")
    assert (entry["median_seed"], entry["worst_seed"]) == (7, 9)
    crashing = [row("a", seed, error, crashed=seed == 8) for seed, error in errors.items()]
    [entry] = standings(crashing, "")  # 10, 7, 11, 9, 8
    assert (entry["median_seed"], entry["worst_seed"]) == (11, 8)


def test_policies_are_compared_on_the_draws_that_all_have_flown():
    rows = [row("a", k, 1.0) for k in range(9)] + [row("b", k, 2.0) for k in range(4, 20)]
    assert [entry["draws"] for entry in standings(rows, "a")] == [5, 5]


def test_conditions_outside_the_family_have_effects_of_no_preset():
    for name in PLANTS:
        plant = find_condition(f"{name}+outside")
        assert plant.friction.viscous == PLANTS[name].friction.viscous
        assert any(isinstance(value, RotorFault) and value.rotor == "front" for value in plant.disturbances)
        assert find_condition(name) == PLANTS[name]
    with pytest.raises(ValueError, match="plant = 'x'"):
        find_condition("x+outside")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"episodes": 1}, "episodes"),
        ({"workers": 0}, "workers"),
        ({"workers": 10_000}, "workers"),
        ({"batch": 0}, "batch"),
        ({"seed": -1}, "seed"),
        ({"policies": ()}, "policies"),
        ({"policies": ("zero", "zero")}, "policies"),
        ({"policies": ("foo",)}, "foo"),
        ({"policies": ("none.zip",)}, "none.zip"),
        ({"policies": ("no_such:make",)}, "no_such"),
        ({"plants": ("x",)}, "plant"),
        ({"references": ("x",)}, "reference"),
        ({"control_period": 0.0}, "control_period"),
        ({"start_spread_deg": -1.0}, "start_spread_deg"),
    ],
)
def test_invalid_input_is_refused_before_anything_is_written(tmp_path, change, words):
    with pytest.raises(SystemExit, match=words) as end:
        command.main(Args(**{**SMALL, **change}, out=tmp_path / "out"))
    assert end.value.code in (1, 2)
    assert os.listdir(tmp_path) == []


def test_each_policy_has_one_label_and_colours_that_are_shown_together_differ():
    assert label_of("kalman-lqr@lab").text == "Kalman LQR, tuned for lab"
    assert label_of("my_own:make") == label_of("my_own:make")
    names = [*LABELS, "mine", "yours", "kalman-lqr@lab"]
    few = names[:9]
    assert len(set(colours_of(few))) == len(few)


def test_on_the_fleet_the_maneuver_is_planned_for_its_rig_and_networks_for_another_are_left_out():
    condition = Condition("fleet", "climb-7.5")
    wanted = batches(("zero", "residual-rigid"), [condition], SETTINGS)
    kept, left_out = leaderboard.flyable(wanted, SETTINGS)
    assert {batch.policy for batch in kept} == {"zero"}
    [reason] = left_out
    assert reason.startswith("residual-rigid is left out on fleet: ")
    assert leaderboard.env_settings(condition, SETTINGS)["reference"].rig.name == "fleet"


def test_a_plant_on_which_every_policy_is_left_out_has_no_table_and_no_page(tmp_path):
    small = {**SMALL, "policies": ("residual-rigid",), "against": Args.against, "episodes": 2, "outside": False}
    command.main(Args(**{**small, "plants": ("fleet", "rigid")}, out=tmp_path / "out"))
    [table] = json.loads((tmp_path / "out" / "leaderboard.json").read_text())["tables"]
    assert table["plant"] == "rigid"
    assert [path.name for path in (tmp_path / "out" / "pages").iterdir()] == ["rigid-climb-7.5.html"]
    with pytest.raises(SystemExit, match="must name one that flies: residual-rigid is left out on fleet"):
        command.main(Args(**{**small, "plants": ("fleet",)}, out=tmp_path / "none"))
    assert not (tmp_path / "none").exists()


def test_the_order_of_a_single_flight_is_a_command_that_flies_it_as_the_leaderboard_does():
    settings = Settings(seed=5, episodes=6, batch=2, control_period=0.04, start_spread_deg=2.0)
    program, *arguments = shlex.split(flight_order("kalman-lqr", Condition("fleet", "climb-7.5"), 7, settings))
    args = tyro.cli(evaluate_command.Args, args=arguments)
    assert program == "heli-evaluate"
    assert args == evaluate_command.Args(
        policies=("kalman-lqr",),
        plant="fleet",
        rig="fleet",
        reference="climb-7.5",
        episodes=1,
        seed=7,
        control_period=0.04,
        start_spread_deg=2.0,
        figures=False,
        report=Path("flight.html"),
    )


def test_outside_the_family_friction_is_added_to_the_plants_own():
    for name in ("lab", "fleet"):
        inside, outside = find_condition(name).friction.coulomb, find_condition(f"{name}+outside").friction.coulomb
        for own, more, added in zip(inside, outside, COULOMB):
            own_high = getattr(own, "high", own)
            assert more.high == pytest.approx(own_high + added.high)


def test_another_rig_flies_its_own_reference_leaves_networks_and_the_fleet_out_and_is_part_of_the_folder(
    tmp_path, capsys
):
    path = tmp_path / "mine.toml"
    find_rig("ntnu").save(path)
    small = {**SMALL, "policies": ("feedforward+tvlqr@PLANT", "residual"), "episodes": 2, "outside": False}
    small |= {"plants": ("lab", "fleet"), "rig": str(path), "out": tmp_path / "out"}
    command.main(Args(**small))
    assert list((tmp_path / "out" / "pages").glob("lab-*.html"))
    assert "residual is left out on lab" in capsys.readouterr().out
    rows = read(tmp_path / "out")
    assert {(row["policy"], row["plant"]) for row in rows} == {("feedforward+tvlqr", "lab")}
    alone = evaluate("feedforward+tvlqr", "lab", 2, "climb-7.5", seed=5, rig="ntnu")
    np.testing.assert_allclose([float(row["rms_error_deg"]) for row in rows], alone.column("rms_error_deg"), rtol=1e-6)
    with pytest.raises(SystemExit, match="rig = ''"):
        command.main(Args(**{**small, "rig": None, "resume": True, "plants": ("lab",)}))
    find_rig("quanser").save(path)
    leaderboard.reference_on.cache_clear()  # another process would read the file anew
    with pytest.raises(SystemExit, match="has changed since"):
        command.main(Args(**small, resume=True))


def test_a_policy_that_flies_one_helicopter_at_a_time_is_stored_flight_by_flight_and_joins_from_its_own_folder(
    tmp_path, monkeypatch
):
    (tmp_path / "my_module.py").write_text(
        "import numpy as np\n"
        "def make(reference):\n"
        "    def policy(t, measurement):\n"
        "        assert measurement.shape == (6,)\n"
        "        return reference(t)[1]\n"
        "    return policy\n"
    )
    monkeypatch.chdir(tmp_path)
    wanted, _ = leaderboard.flyable(batches(("lqi", "my_module:make"), [CONDITION], SETTINGS), SETTINGS)
    assert [batch.episodes for batch in wanted if batch.policy == "lqi"] == [2, 2, 2]
    assert [batch.episodes for batch in wanted if batch.policy == "my_module:make"] == [1] * 6
    small = {**SMALL, "policies": ("my_module:make", "open-loop"), "against": "open-loop"}
    small |= {"outside": False, "pages": False, "workers": 1}
    command.main(Args(**{**small, "out": tmp_path / "out"}))
    rows = read(tmp_path / "out")
    mine, planned = ([row for row in rows if row["policy"] == name] for name in ("my_module:make", "open-loop"))
    assert len(mine) == len(planned) == Args(**small).episodes
    for one, other in zip(mine, planned):  # the voltages of the start of a period are nearly those of its middle
        assert float(one["rms_error_deg"]) == pytest.approx(float(other["rms_error_deg"]), rel=0.2)


def test_behind_the_safety_filter_a_policy_keeps_its_tuned_weights_and_its_label():
    assert leaderboard.policy_on("kalman-lqr@PLANT+safe", "lab+outside") == "kalman-lqr@lab+safe"
    assert leaderboard.policy_on("hover-lqr@PLANT+safe", "lab") == "hover-lqr+safe"
    assert label_of("hover-lqr+safe").text == "hover LQR, safety filter"
    assert "delay" in label_of("hover-lqr+safe").needs
