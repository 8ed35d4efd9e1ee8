"""Engines: one result for each task, lost processes, interrupts, and errors before the first task."""

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from itertools import count

import pytest
import tasks

from heli_gym.baselines.evaluation import engine as engines
from heli_gym.baselines.evaluation.engine import LocalEngine, check_engine, in_order, open_engine


@pytest.fixture(scope="module")
def two():
    with open_engine("local", 2) as engine:
        yield engine


@pytest.fixture(params=[1, 2])
def engine(request, two):
    return two if request.param == 2 else LocalEngine(1)


def test_every_task_has_one_result(engine):
    assert sorted(engine.results(tasks.square, range(10))) == [(k, k * k) for k in range(10)]
    assert list(in_order(engine.results(tasks.square, range(5)))) == [0, 1, 4, 9, 16]


def test_results_in_order_wait_for_those_before_them():
    assert list(in_order(iter([(2, "c"), (0, "a"), (1, "b")]))) == ["a", "b", "c"]


def test_tasks_may_be_endless(engine):
    results = in_order(engine.results(tasks.square, count()))
    assert [next(results) for _ in range(4)] == [0, 1, 4, 9]
    results.close()


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="the system has no masks of signals")
def test_ctrl_c_does_not_reach_a_process_not_even_while_it_starts(two):
    assert [signal.SIGINT in blocked for _, blocked in two.results(tasks.blocked_signals, [0])] == [True]
    assert tasks.blocked_signals(0) == []


def test_a_killed_process_costs_no_result(two, tmp_path):
    found = sorted(two.results(tasks.die_once, [(tmp_path, x) for x in range(6)]))
    assert found == [(x, x) for x in range(6)]


def test_a_process_killed_between_two_tasks_is_replaced(two):
    assert len(list(two.results(tasks.square, range(4)))) == 4
    for slot in two.slots:
        for process in slot.processes:
            process.kill()
            process.join()
    assert len(list(two.results(tasks.square, range(4)))) == 4


def test_a_task_that_always_loses_its_process_ends_with_its_number(two, monkeypatch):
    monkeypatch.setattr(engines, "RETRIES", 1)
    with pytest.raises(RuntimeError, match="task 1: its process was lost 2 times"):
        list(two.results(tasks.die, [0]))
    ((index, result),) = two.results(tasks.die, [7], if_lost=lambda task, reason: (task, reason))
    assert (index, result[0]) == (0, 7) and "lost 2 times" in result[1]


def test_an_error_of_a_task_is_raised_here(engine):
    with pytest.raises(ValueError, match="x = 3: must not be three"):
        list(engine.results(tasks.refuse, range(100)))


def test_an_error_ends_the_other_running_tasks(two, tmp_path):
    with pytest.raises(ValueError, match="x = 3: must not be three"):
        list(two.results(tasks.wait_or_refuse, [(tmp_path, 0), (tmp_path, 1)]))
    try:
        with pytest.raises(ProcessLookupError):
            os.kill(int((tmp_path / "process").read_text()), 0)
    finally:
        (tmp_path / "end").touch()


@pytest.fixture
def interruptible():
    """SIGINT raises KeyboardInterrupt, which a shell's background jobs ignore otherwise."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.slow
@pytest.mark.usefixtures("interruptible")
def test_an_interrupt_lets_running_tasks_finish_where_this_is_wanted(tmp_path):
    engine, found = LocalEngine(2, finish=True), []
    begun = threading.Thread(target=interrupt_after_two, args=(tmp_path,))
    begun.start()
    with pytest.raises(KeyboardInterrupt):
        for index, _ in engine.results(tasks.note_and_wait, [(tmp_path, x) for x in range(6)]):
            found.append(index)
    begun.join()
    engine.close()
    assert sorted(found) == [0, 1]
    assert sorted(os.listdir(tmp_path)) == ["0", "1", "end"]


def interrupt_after_two(folder, ending=True):
    """Interrupt this process once two tasks have begun, then let them end."""
    while len(os.listdir(folder)) < 2:
        time.sleep(0.01)
    os.kill(os.getpid(), signal.SIGINT)
    if ending:
        (folder / "end").touch()


@pytest.mark.slow
@pytest.mark.usefixtures("interruptible")
def test_an_interrupt_ends_running_tasks_otherwise(tmp_path):
    begun = threading.Thread(target=interrupt_after_two, args=(tmp_path, False))
    begun.start()
    began = time.monotonic()
    with open_engine("local", 2) as engine, pytest.raises(KeyboardInterrupt):
        list(engine.results(tasks.note_and_wait, [(tmp_path, x) for x in range(6)]))
    begun.join()
    assert time.monotonic() - began < 1500.0  # by themselves, the tasks end after 1800 s


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("cloud", 1), "engine = 'cloud'"),
        (("local", 0), "workers = 0"),
        (("local", 10_000), "workers = 10000"),
        (("local", 1, "auto"), "address = 'auto'"),
        (("ray", 1, "nowhere"), "address = 'nowhere': must be HOST:PORT"),
        (("ray", 1, "127.0.0.1:9"), "address = '127.0.0.1:9': must be of a running cluster: .*refused"),
        (("ray", 1, "127.0.0.1:99999"), "address = '127.0.0.1:99999'"),
    ],
)
def test_an_engine_that_cannot_start_is_refused_by_name(arguments, words):
    if arguments[0] == "ray":
        pytest.importorskip("ray")
    with pytest.raises(ValueError, match=words):
        check_engine(*arguments)


def test_an_address_that_speaks_something_else_is_refused_within_the_time(monkeypatch):
    pytest.importorskip("ray")
    monkeypatch.setattr(engines, "CLUSTER_TIMEOUT", 4.0)
    with socket.create_server(("127.0.0.1", 0)) as server:
        address = f"127.0.0.1:{server.getsockname()[1]}"
        with pytest.raises(ValueError, match=f"address = '{address}': .* speaks Ray within 4 s"):
            check_engine("ray", 1, address)


def test_without_ray_its_engine_is_refused_with_the_extra_and_the_other_one_runs(tmp_path):
    (tmp_path / "ray.py").write_text("raise ImportError('no ray')\n")
    code = (
        "from heli_gym.baselines.evaluation.engine import open_engine\n"
        "with open_engine('local', 1) as engine: print(list(engine.results(abs, [-1])))\n"
        "with open_engine('ray', 1): pass"
    )
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    child = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
    assert child.stdout == "[(0, 1)]\n"
    assert child.stderr.splitlines()[-1] == (
        "ValueError: engine = 'ray': must be 'local' without Ray; `pip install \"heli-gym[sweep]\"` brings it"
    )


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_ray_gives_the_same_results_after_lost_processes_and_raises_the_same_errors(tmp_path):
    pytest.importorskip("ray")
    with open_engine("ray", 2) as engine:
        assert sorted(engine.results(tasks.square, range(10))) == [(k, k * k) for k in range(10)]
        assert sorted(engine.results(tasks.die_once, [(tmp_path, x) for x in range(4)])) == [(x, x) for x in range(4)]
        with pytest.raises(ValueError, match="x = 3: must not be three"):
            list(engine.results(tasks.refuse, range(100)))
        assert list(in_order(engine.results(tasks.square, range(3)))) == [0, 1, 4]
