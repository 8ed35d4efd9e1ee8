import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym.env import find_reference
from heli_gym.parameters import AMPLIFIER_LIMITS, PITCH_STOP
from heli_gym.plant import PLANTS, Gust, Plant, Rotors, Sensors
from heli_gym.simulation.layout import COST, MEASURED, REWARD, TERMINATED, TRUNCATED, X
from heli_gym.simulation.simulation import Simulation

torch = pytest.importorskip("torch")
torch_simulation = pytest.importorskip("heli_gym.train.torch_simulation")

SLOW = Plant(rotors=Rotors(lag=0.1, slew=30.0, delay=0.04))


def simulation(plants, dtype=np.float64):
    flights = Simulation(
        plants,
        [find_reference("travel-360")] * len(plants),
        0.02,
        AMPLIFIER_LIMITS,
        PITCH_STOP,
        random_start=True,
        start_spread=0.1,
        dtype=dtype,
    )
    for j in range(len(plants)):
        flights.draw(j, np.random.default_rng(j))
    flights.reset(np.arange(len(plants)))
    return flights


@pytest.mark.parametrize(("dtype", "tolerance"), [(np.float64, 1e-12), (np.float32, 1e-6)])
@pytest.mark.parametrize("name", ["nominal", "mixed", "rigid"])
def test_torch_takes_the_step_that_the_compiled_kernel_takes(name, dtype, tolerance):
    plants = {"mixed": [PLANTS["lab"], SLOW, Plant()] * 5}.get(name) or [PLANTS[name]] * 70
    flights, rng = simulation(plants, dtype), np.random.default_rng(0)
    for _ in range(20):
        action = rng.normal(0.31, 0.1, (len(plants), 2)).astype(dtype)
        fleet, state = torch_simulation.to_torch(flights)
        state, outputs = torch_simulation.step(fleet, state, torch.tensor(action))
        _, observation, rows = flights.step(action)
        measured = rows[MEASURED:] if len(rows) > MEASURED else rows[X : X + 6]
        assert_allclose(state.x, rows[X : X + 6], rtol=tolerance, atol=tolerance)
        # a rate estimated from counts is off by a count where rounding differs
        assert (np.abs(state.measured.numpy() - measured) > 100.0 * tolerance).mean() < 0.01
        assert_allclose(outputs.reward, rows[REWARD], rtol=tolerance, atol=tolerance)
        assert_allclose(outputs.cost, rows[COST], rtol=tolerance, atol=tolerance)
        assert_array_equal(outputs.terminated, rows[TERMINATED] > 0.0)
        assert_array_equal(outputs.truncated, rows[TRUNCATED] > 0.0)
        if dtype is np.float64:
            assert_allclose(outputs.observation, observation, rtol=0.0, atol=1e-6)


def test_a_flight_of_many_steps_stays_the_same():
    flights, rng = simulation([PLANTS["lab"]] * 10), np.random.default_rng(0)
    fleet, state = torch_simulation.to_torch(flights)
    for _ in range(100):
        action = rng.normal(0.31, 0.03, (10, 2))
        state, _ = torch_simulation.step(fleet, state, torch.tensor(action))
        flights.step(action)
    assert_allclose(state.x, flights.rows(X, 6), rtol=0.0, atol=1e-10)


def test_the_return_has_a_gradient_with_respect_to_the_actions():
    fleet, state = torch_simulation.to_torch(simulation([Plant()] * 3))
    actions = torch.full((3, 2), 0.31, dtype=torch.float64, requires_grad=True)
    total = torch.zeros((), dtype=torch.float64)
    for _ in range(5):
        state, outputs = torch_simulation.step(fleet, state, actions)
        total = total + outputs.reward.sum()
    total.backward()
    assert torch.isfinite(actions.grad).all()
    assert (actions.grad != 0.0).all()


@pytest.mark.parametrize(
    "plant", [Plant(sensors=Sensors(noise=0.01)), Plant(disturbances=(Gust("pitch", 0.5),)), Plant(travel_lift=-0.1)]
)
def test_plants_with_effects_that_torch_lacks_are_refused(plant):
    with pytest.raises(ValueError, match="noise"):
        torch_simulation.to_torch(simulation([plant]))
