import os
import pickle
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
from independent import hover
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym.env import find_reference
from heli_gym.model import rk4_step, thrust, virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP, HelicopterParameters
from heli_gym.plant import NOMINAL_RIGS, PLANTS, Gust, MovingMass, Plant, Push, RotorFault, Rotors, Sensors
from heli_gym.rig import find_rig
from heli_gym.simulation import kernels, motion
from heli_gym.simulation import workers as simulation_workers
from heli_gym.simulation.fast_math import cosine, sine, standard_normal
from heli_gym.simulation.layout import COMMAND, LANES, REWARD, TIME, TRUNCATED, X
from heli_gym.simulation.simulation import Simulation
from heli_gym.simulation.workers import Workers, pool
from heli_gym.task import hover_voltage, reward, to_voltage

REFERENCE = find_reference("travel-360")
GUSTY = Plant(
    rotors=Rotors(lag=0.1, slew=50.0, delay=0.04),
    sensors=Sensors(noise=0.002),
    disturbances=(Gust("pitch", 0.5), Push("travel", 0.3, 0.1), RotorFault("back", 0.2, 0.2), MovingMass(0.05, 0.1)),
)


def simulation(plants, references=None, period=0.02, dtype=np.float64, seed=0, **arguments):
    """Flights of these plants, begun, each from its own seed."""
    references = references or [REFERENCE] * len(plants)
    flights = Simulation(plants, references, period, AMPLIFIER_LIMITS, PITCH_STOP, dtype=dtype, **arguments)
    for j in range(len(plants)):
        flights.draw(j, np.random.default_rng([seed, j]))
    flights.reset(np.arange(len(plants)))
    return flights


def actions(steps, n, seed=1):
    """Actions (steps, N, 2) about hover, with some beyond the amplifier's limits."""
    rng = np.random.default_rng(seed)
    values = rng.normal(0.0, 0.07, (steps, n, 2))
    values[rng.random((steps, n)) < 0.02] *= 25.0
    return values


def interpreted(flights, patch):
    """A copy of these flights that is stepped by the very same functions, uncompiled."""
    copy = pickle.loads(pickle.dumps(flights))
    patch.setattr(motion, "derivative", flights.rhs)
    patch.setattr(kernels, "fly", flights.fly)
    copy.kernels = kernels.Kernels(kernels.reset, kernels.write_outputs, kernels.step, kernels.all_finite)
    return copy


@pytest.mark.parametrize("plant", [*PLANTS.values(), GUSTY], ids=[*PLANTS, "gusty"])
def test_compiled_and_interpreted_flights_are_the_same(plant, monkeypatch):
    compiled = simulation([plant] * 3, start_spread=0.05)
    plain = interpreted(compiled, monkeypatch)
    with np.errstate(all="ignore"):  # of the lanes that no helicopter is in
        for flights in (compiled, plain):
            flights.reset(np.arange(3))
        assert_allclose(compiled.blocks, plain.blocks, rtol=0.0, atol=1e-12)
        for action in actions(25, 3):
            (over, *ours), (over_too, *theirs) = compiled.step(action), plain.step(action)
            assert over == over_too
            assert_array_equal(ours[0].shape, theirs[0].shape)
            for a, b in zip(ours, theirs):
                assert_allclose(a, b, rtol=0.0, atol=1e-12 if a.dtype == float else 1e-6)


def test_a_batch_in_numpy_of_the_same_equations_is_the_compiled_flight():
    flights, p = simulation([Plant()] * 70, start_spread=0.1), HelicopterParameters()
    x = flights.rows(X, 6).copy()
    for k, action in enumerate(actions(50, 70)):
        _, _, outputs = flights.step(action)
        u = np.clip(
            to_voltage(action.T, AMPLIFIER_LIMITS, hover_voltage(p, AMPLIFIER_LIMITS)[:, None]), *AMPLIFIER_LIMITS
        )
        v = virtual_input(thrust(u, p))
        x = np.array(rk4_step(motion.equation_3, x, (v, v, v), 0.02, motion.Body(p, None, None, None, None)))
        error, du = x - REFERENCE(0.02 * (k + 1))[0][:, None], u - REFERENCE(0.02 * (k + 0.5))[1][:, None]
        earned = 0.02 * reward(error, du, AMPLIFIER_LIMITS[1] - AMPLIFIER_LIMITS[0])
        assert_allclose(outputs[X : X + 6], x, rtol=0.0, atol=1e-12)
        assert_allclose(outputs[COMMAND : COMMAND + 2], u, rtol=0.0, atol=1e-12)
        assert_allclose(outputs[REWARD], earned, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("name", PLANTS)
def test_single_precision_flies_nearly_the_same(name):
    at_zero = find_rig(NOMINAL_RIGS[name]).hover_voltage()
    double, single = (simulation([PLANTS[name]] * 5, dtype=dtype, hover=at_zero) for dtype in (np.float64, np.float32))
    for action in actions(100, 5):
        (_, _, exact), (_, _, close) = double.step(action), single.step(action)
    assert close.dtype == np.float32
    assert_allclose(close[X : X + 6], exact[X : X + 6], rtol=0.0, atol=2e-4)


@pytest.mark.parametrize("name", ["nominal", "lab"])
def test_flights_are_the_same_for_any_number_of_threads(name):
    n = 20 * LANES + 3
    flights, first, controls = [], [], actions(12, n)
    for threads in (1, 2, 5):
        flights.append(simulation([PLANTS[name]] * n, threads=threads, start_spread=0.05))
        flights[-1].workers.means[False] = 1e9  # so that the threads are used
        outputs = [flights[-1].step(action) for action in controls]
        first = first or outputs
        for (over, *arrays), (over_too, *others) in zip(outputs, first):
            assert over == over_too
            for a, b in zip(arrays, others):
                assert_array_equal(a, b)


def test_workers_do_each_block_once_and_leave_the_other_threads_out_where_these_are_slower(monkeypatch):
    clock, threads = [0.0], pool(3, os.getpid())

    class SlowPool:
        def run(self, task, count):
            clock[0] += 2.0
            return threads.run(task, count)

    def task(begin, end):
        clock[0] += 1e-3 * (end - begin)
        done.extend(range(begin, end))
        return end - begin

    monkeypatch.setattr(simulation_workers, "time", SimpleNamespace(perf_counter=lambda: clock[0]))
    monkeypatch.setattr(simulation_workers, "pool", lambda *_: SlowPool())
    workers, done = Workers(3), []
    for _ in range(60):
        done.clear()
        assert workers.run(task, 40) == 40
        assert sorted(done) == list(range(40))
    assert workers.means[False] < workers.means[True]
    assert workers.next_probe > 60


@pytest.mark.parametrize("n", [1, LANES - 1, LANES, LANES + 1, 3 * LANES + 8])
def test_each_helicopter_flies_as_if_alone_in_any_block(n):
    together, controls = simulation([PLANTS["lab"]] * n), actions(5, n)
    outputs = [together.step(action)[1:] for action in controls]
    for j in {0, n // 2, n - 1}:
        alone = Simulation([PLANTS["lab"]], [REFERENCE], 0.02, AMPLIFIER_LIMITS, PITCH_STOP)
        alone.draw(0, np.random.default_rng([0, j]))
        alone.reset(np.zeros(1, int))
        for action, (observation, rows) in zip(controls, outputs):
            _, own_observation, own_rows = alone.step(action[j : j + 1])
            assert_allclose(own_observation[0], observation[j], rtol=0.0, atol=1e-6)
            assert_allclose(own_rows[:, 0], rows[:, j], rtol=0.0, atol=1e-12)


def test_plants_delays_and_references_may_differ_from_helicopter_to_helicopter():
    plants = [
        Plant(),
        PLANTS["lab"],
        GUSTY,
        Plant(rotors=Rotors(delay=0.06)),
        Plant(parameters=HelicopterParameters(b1=-0.7)),
    ]
    references = [REFERENCE, hover(3.0), hover(5.0, 0.1), REFERENCE, REFERENCE]
    together, controls = simulation(plants, references, random_start=True), actions(40, 5)
    apart = []
    for j, (p, r) in enumerate(zip(plants, references)):
        apart.append(Simulation([p], [r], 0.02, AMPLIFIER_LIMITS, PITCH_STOP, random_start=True))
        apart[-1].draw(0, np.random.default_rng([0, j]))
        apart[-1].reset(np.zeros(1, int))
    for action in controls:
        outputs = together.step(action)[2]
        for j, alone in enumerate(apart):
            alone.step(action[j : j + 1])
            # a plant without lag takes shorter steps when one with lag flies with it
            assert_allclose(outputs[X : X + 6, j], alone.rows(X, 6)[:, 0], rtol=0.0, atol=1e-9)
            assert outputs[TIME, j] == 0.02 * alone.record().step[0]


def test_the_reported_plant_is_the_flown_plant():
    flights = simulation([PLANTS["rigid"]] * 50)
    record = flights.record()
    for j in range(50):
        drawn = flights.drawn_plant(j)
        numbers = [*drawn.parameters, *drawn.rig, drawn.rotors.lag, drawn.rotors.thrust_loss, *drawn.friction.viscous]
        rows = [*record.parameters[:, j], *record.rig[:, j], record.lag[j], record.loss[j], *record.viscous[:, j]]
        assert_allclose(rows, numbers, rtol=1e-14)
    assert len(set(record.lag)) == 50


def test_a_simulation_that_is_pickled_in_flight_flies_on_the_same():
    flights = simulation([PLANTS["lab"], GUSTY])
    for action in actions(10, 2):
        flights.step(action)
    copy = pickle.loads(pickle.dumps(flights))
    for action in actions(10, 2, seed=2):
        for a, b in zip(flights.step(action), copy.step(action)):
            assert_array_equal(a, b)


def test_a_plant_with_a_rig_does_not_fly_beside_one_without():
    with pytest.raises(ValueError, match="either all plants"):
        simulation([PLANTS["rigid"], PLANTS["lab"]])


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_an_action_that_is_not_finite_changes_nothing(bad):
    flights = simulation([Plant()] * 3)
    before, action = flights.blocks.copy(), np.full((3, 2), 0.3)
    action[1, 1] = bad
    assert flights.step(action)[0] == -1
    assert_array_equal(flights.blocks, before)


def test_flights_are_counted_when_they_are_over():
    flights, last = simulation([Plant()] * 4, [hover(0.1), hover(0.1), hover(0.2), hover(0.2)]), []
    for _ in range(10):
        over, _, outputs = flights.step(np.full((4, 2), 0.31))
        last.append((over, *outputs[TRUNCATED]))
    assert [row[0] for row in last] == [0, 0, 0, 0, 2, 0, 0, 0, 0, 2]


# What the loops are made of


@pytest.mark.parametrize(("ours", "exact"), [(sine, np.sin), (cosine, np.cos)])
def test_sine_and_cosine_are_exact_to_two_units_in_the_last_place(ours, exact):
    rng = np.random.default_rng(0)
    near = rng.integers(-60000, 60000, 20000) * (np.pi / 2) + rng.normal(0.0, 1e-3, 20000)
    x = np.concatenate((rng.uniform(-1e5, 1e5, 200000), rng.uniform(-4.0, 4.0, 200000), near, [0.0, -0.0]))
    compiled = kernels.compiler_of(np.float64, motion.equation_3, motion.step_equation_3).part(ours)
    outputs, right = np.array([compiled(v) for v in x]), exact(x)
    # near a zero of the function, what is left of the reduction counts
    assert (np.abs(outputs - right) <= 2.0 * np.spacing(np.abs(right)) + 1e-20).all()


def test_the_normal_numbers_are_normal_and_independent():
    keys = np.random.default_rng(0).random(200)
    compiled = kernels.compiler_of(np.float64, motion.equation_3, motion.step_equation_3).part(standard_normal)
    z = np.array([[[compiled(key, float(k), channel) for channel in range(4)] for k in range(100)] for key in keys])
    assert abs(z.mean()) < 0.01
    assert z.std() == pytest.approx(1.0, abs=0.01)
    assert (z**3).mean() == pytest.approx(0.0, abs=0.03)
    assert (z**4).mean() == pytest.approx(3.0, abs=0.08)
    for shifted in (z[:, 1:] * z[:, :-1], z[:, :, 1:] * z[:, :, :-1], z[1:] * z[:-1]):
        assert abs(shifted.mean()) < 0.012


# The cache


@pytest.mark.slow
def test_kernels_are_cached_on_disk_and_importing_compiles_nothing(tmp_path):
    script = """
import numba.core.event as event, json
with event.install_recorder("numba:compile") as recorder:
    import heli_gym.env
    imported = len(recorder.buffer)
    env = heli_gym.env.Heli3DOFEnv()
    env.reset()
    env.step(env.action_space.sample())
print(json.dumps([imported, len(recorder.buffer)]))
"""
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    runs = [
        subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
        ).stdout
        for _ in range(2)
    ]
    assert runs[0].startswith("[0, ")
    assert not runs[0].startswith("[0, 0]")
    assert runs[1].startswith("[0, 0]")


@pytest.mark.slow
def test_a_flight_takes_place_where_nothing_can_be_cached_with_one_warning():
    script = """
import warnings, os
import numba.core.caching as caching
def nowhere(*arguments, **options):
    return None
for locator in caching.CacheImpl._locator_classes:
    locator.from_function = classmethod(nowhere)
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    import heli_gym.env
    env = heli_gym.env.Heli3DOFEnv()
    env.reset(seed=0)
    assert env.step(env.action_space.sample())[1] > 0.0
print(len([w for w in caught if "cache" in str(w.message)]))
"""
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["1"]
    assert "compiling" in run.stderr


@pytest.mark.slow
def test_a_damaged_cache_costs_a_warning_and_not_the_flight(tmp_path):
    script = """
import warnings
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    import heli_gym.env
    env = heli_gym.env.Heli3DOFEnv()
    env.reset(seed=0)
    assert env.step(env.action_space.sample())[1] > 0.0
print(len([w for w in caught if "cache" in str(w.message)]))
"""
    warned = []
    for _ in range(2):
        run = subprocess.run(
            [sys.executable, "-c", script],
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
        )
        warned.append(run.stdout.split())
        for path in (*tmp_path.rglob("*.nbi"), *tmp_path.rglob("*.nbc")):
            path.write_bytes(path.read_bytes()[:-7])
    assert warned == [["0"], ["1"]]
