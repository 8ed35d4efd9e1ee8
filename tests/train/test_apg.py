import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

torch = pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")

from stable_baselines3.common.callbacks import BaseCallback  # noqa: E402

from heli_gym.baselines import make_policy  # noqa: E402
from heli_gym.baselines.control.residual import ResidualPolicy  # noqa: E402
from heli_gym.env import find_reference  # noqa: E402
from heli_gym.train.apg import AHEAD, APG, SINGLE_GROUPS, Actor, network_of  # noqa: E402
from heli_gym.train.flight_gradient import LANES  # noqa: E402
from heli_gym.vector_env import Heli3DOFVectorEnv  # noqa: E402

SHORT = find_reference("climb-7.5")
STEPS = 250 * LANES  # control periods of a batch


def agent(**kwargs):
    envs = Heli3DOFVectorEnv(LANES, "lab", SHORT, start_spread_deg=5.0)
    base = make_policy("feedforward+tvlqr@lab", SHORT)
    return APG(
        ResidualPolicy(base, SHORT, None, 12.0, feature_groups=SINGLE_GROUPS, ahead=AHEAD), envs, hidden=8, **kwargs
    )


@pytest.mark.slow
def test_learning_reduces_the_loss_of_the_same_flights_and_a_callback_can_end_it():
    class AfterThirty(BaseCallback):
        def _on_step(self):
            self.model.next_seed = 0
            return self.model._n_updates < 30

    learner = agent(learning_rate=2e-2)
    learner.learn(100 * STEPS, callback=AfterThirty())
    assert learner._n_updates == 30 and learner.num_timesteps == 30 * STEPS
    first, last = (learner.rollout.loss(outcome) for outcome in (learner.outcomes[0], learner.outcomes[-1]))
    assert last < 0.93 * first


def test_numpy_and_torch_agree_over_many_steps():
    torch.manual_seed(0)
    actor = Actor(41, 96)
    with torch.no_grad():
        actor.head.weight.mul_(100.0)
    network, rng = network_of(actor), np.random.default_rng(0)
    h, hidden = torch.zeros(5, 96), np.zeros((96, 5))
    for _ in range(100):
        features = rng.uniform(-3.0, 3.0, (5, 41)).astype(np.float32)
        with torch.no_grad():
            expected, h = actor(torch.from_numpy(features), h)
        action, hidden = network(features.T.astype(float), hidden)
        assert_allclose(action.T, expected.numpy(), atol=1e-6)
    assert np.abs(action).max() > 0.1
    alone = network(features[2].astype(float), np.zeros(96))[0]
    assert_allclose(alone, network(features.T.astype(float), np.zeros((96, 5)))[0][:, 2], atol=1e-12)


def test_predict_carries_a_state_that_the_start_of_an_episode_clears():
    learner, rng = agent(), np.random.default_rng(0)
    observations = rng.uniform(-1.0, 1.0, (3, 37)).astype(np.float32)
    first, state = learner.predict(observations)
    assert first.shape == (3, 2) and state[0].shape == (3, 8)
    _, second = learner.predict(observations, state)
    assert not np.array_equal(second[0], state[0])
    _, again = learner.predict(observations, state, episode_start=np.array([True, False, True]))
    assert_array_equal(again[0][[0, 2]], state[0][[0, 2]])
    assert_array_equal(again[0][1], second[0][1])
    single, one = learner.predict(observations[0])
    assert single.shape == (2,) and one[0].shape == (8,)
    assert_allclose(single, first[0], atol=1e-6)


def test_a_saved_agent_goes_on_as_it_would_have(tmp_path):
    learner = agent(learning_rate=3e-3)
    learner.learn(STEPS)
    learner.save(tmp_path / "agent")
    loaded = APG.load(tmp_path / "agent", learner.residual, learner.envs)
    for one in (learner, loaded):
        one.next_seed = 5
        one.learn(STEPS, reset_num_timesteps=False)
    assert loaded.num_timesteps == learner.num_timesteps == 2 * STEPS
    for a, b in zip(learner.policy.parameters(), loaded.policy.parameters()):
        assert torch.equal(a, b)


def test_updates_fly_one_reference_after_the_other():
    references = SHORT, find_reference("travel-180")
    policies = [
        ResidualPolicy(
            make_policy("feedforward+tvlqr@lab", r), r, None, 12.0, feature_groups=SINGLE_GROUPS, ahead=AHEAD
        )
        for r in references
    ]
    learner = APG(policies, [Heli3DOFVectorEnv(LANES, "lab", r) for r in references], hidden=4)
    periods = [LANES * (policy.x.shape[1] - 1) for policy in policies]
    assert periods[0] != periods[1]
    for number, flown in enumerate((periods[0], sum(periods), sum(periods) + periods[0]), 1):
        learner.update()
        assert learner.num_timesteps == flown and learner._n_updates == number


def test_features_that_the_network_is_not_made_for_are_refused():
    envs = Heli3DOFVectorEnv(LANES, "lab", SHORT)
    policy = ResidualPolicy(make_policy("feedforward+tvlqr", SHORT), SHORT, None, 12.0)
    with pytest.raises(ValueError, match="feature_groups"):
        APG(policy, envs)
