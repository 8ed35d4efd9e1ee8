"""Flight by keyboard: effects of the keys, and of the paper's feedback."""

import math
import subprocess
import sys

import gymnasium as gym
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import expm

from heli_gym import HelicopterParameters, dynamics
from heli_gym.env import Heli3DOFEnv
from heli_gym.model import fan_thrusts, linearise, thrust, virtual_input
from heli_gym.play import FARTHEST, LIFT, ROLL, Assist, fly, hold_gain, main, mapping, set_point
from heli_gym.task import hover_voltage, to_voltage

pygame = pytest.importorskip("pygame")
TABLE_I = HelicopterParameters()
KEYS = {"up": pygame.K_UP, "down": pygame.K_DOWN, "left": pygame.K_LEFT, "right": pygame.K_RIGHT}


@pytest.fixture(autouse=True)
def no_display(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")


def voltages(*names):
    actions, rest = mapping(Heli3DOFEnv())
    chosen = {tuple(sorted(keys)): action for keys, action in actions.items()}
    action = chosen[tuple(sorted(KEYS[name] for name in names))] if names else rest
    return to_voltage(action.astype(float), (0.0, 12.0), hover_voltage(TABLE_I, (0.0, 12.0)))


def accelerations(*names):
    """Of travel, elevation and pitch, at level hover."""
    return np.array(dynamics(np.zeros(6), virtual_input(thrust(voltages(*names))), TABLE_I))[1::2]


def test_without_a_key_it_hovers():
    assert_allclose(accelerations(), 0.0, atol=1e-6)


def test_up_lifts_and_down_sinks():
    assert accelerations("up")[1] < -0.1  # the elevation is positive downwards
    assert accelerations("down")[1] > 0.1
    assert_allclose(voltages("up") - voltages(), LIFT, atol=1e-6)


def test_left_leads_to_a_positive_travel_and_right_to_a_negative_one():
    for name, sign in (("left", 1.0), ("right", -1.0)):
        rolling = accelerations(name)[2]
        tilted = np.array([0.0, 0.0, 0.0, 0.0, math.copysign(0.1, rolling), 0.0])
        hover = virtual_input(thrust(voltages()))
        assert sign * dynamics(tilted, hover, TABLE_I)[1] > 0.01
        assert abs(rolling) > 0.2
    assert_allclose(voltages("left") - voltages(), [-ROLL, ROLL], atol=1e-6)


def test_keys_add_up_and_opposite_ones_cancel():
    rest = voltages()
    assert_allclose(voltages("up", "left") - rest, voltages("up") + voltages("left") - 2.0 * rest, atol=1e-6)
    assert_allclose(voltages("left", "right"), rest, atol=1e-6)
    assert_allclose(voltages(*KEYS), rest, atol=1e-6)


@pytest.mark.parametrize("wrap", [lambda env: env, Assist], ids=["direct", "assist"])
def test_every_combination_of_keys_is_an_action(wrap):
    env = wrap(Heli3DOFEnv())
    actions, rest = mapping(env)
    assert len(actions) == 15
    assert all(action in env.action_space for action in (rest, *actions.values()))


# The feedback


def test_the_gain_stabilises_hover_and_is_the_limit_of_the_riccati_equation():
    A, B = linearise(np.zeros(6), virtual_input(thrust(voltages())), TABLE_I)
    K = hold_gain()
    assert np.linalg.eigvals(A - B @ K).real.max() < -0.3
    # The optimal gain is a fixed point of improving it: one step of Kleinman's iteration, its cost by quadrature.
    tolerance = np.radians([3.0, 6.0, 3.0, 6.0, 6.0, 30.0])
    R = np.eye(2) / (TABLE_I.k_plus * 6.0**2) ** 2
    weight = np.diag(tolerance**-2) + K.T @ R @ K
    step = expm((A - B @ K) * 0.01)
    P, moved = np.zeros((6, 6)), np.eye(6)
    for k in range(4000):
        P += 0.01 * (0.5 if k == 0 else 1.0) * moved.T @ weight @ moved
        moved = step @ moved
    assert_allclose(np.linalg.solve(R, B.T @ P), K, rtol=5e-3, atol=5e-3 * np.abs(K).max())


def test_a_set_point_has_the_requested_accelerations():
    rng = np.random.default_rng(0)
    for position, rate, acceleration in zip(*rng.uniform(-0.3, 0.3, (3, 20, 2))):
        x, v = set_point(position, rate, acceleration, TABLE_I)
        assert_allclose(x[:4], [position[0], rate[0], position[1], rate[1]])
        assert x[5] == 0.0
        assert_allclose(np.array(dynamics(x, v, TABLE_I))[1::2], [*acceleration, 0.0], atol=1e-12)
        assert min(fan_thrusts(v)) > 0.0


def flight(env, commands, seed=0):
    """States (6, K) of a flight under commands (K, 2), and how it ended."""
    _, info = env.reset(seed=seed)
    states = [info["state"]]
    for command in commands:
        *_, terminated, truncated, info = env.step(np.array(command, dtype=np.float32))
        states.append(info["state"])
        if terminated or truncated:
            return np.transpose(states), terminated
    return np.transpose(states), False


def test_with_help_and_hands_off_it_stays_where_it_starts():
    env = Assist(Heli3DOFEnv(start_spread_deg=5.0))
    states, crashed = flight(env, np.zeros((499, 2)), seed=3)
    assert not crashed
    assert_allclose(states[:, -1], [states[0, 0], 0.0, states[2, 0], 0.0, 0.0, 0.0], atol=2e-3)


def test_without_help_and_hands_off_it_keeps_swinging():
    env = Heli3DOFEnv(start_spread_deg=5.0)
    _, rest = mapping(env)
    states, _ = flight(env, np.tile(rest, (499, 1)), seed=3)
    assert np.abs(states[4, -200:]).max() > 0.9 * abs(states[4, 0]) > 0.01


@pytest.mark.parametrize("plant", ["nominal", "lab", "rigid"])
@pytest.mark.parametrize("seed", [0, 1])
def test_with_help_it_follows_commands_on_every_plant(plant, seed):
    commands = np.array([(float(k < 300), -float(k < 100) + float(k >= 380)) for k in range(499)])
    env = Assist(Heli3DOFEnv(plant))
    set_points = [np.zeros(2)]
    env.env.step = lambda action, step=env.env.step: (set_points.append(env.position), step(action))[1]
    states, crashed = flight(env, commands, seed)
    set_points = np.transpose(set_points)
    assert not crashed
    assert np.abs(states[4]).max() < math.radians(60.0)
    assert_allclose(states[0], set_points[0], atol=0.2)
    assert_allclose(states[2], set_points[1], atol=0.12)
    assert set_points[0, -1] > 4.0


def test_the_set_point_stays_within_reach():
    env = Assist(Heli3DOFEnv())
    for sign in (1.0, -1.0):
        env.reset(seed=0)
        for _ in range(400):
            env.step(np.array((0.0, sign), dtype=np.float32))
        assert sign * env.position[1] == pytest.approx(FARTHEST, abs=0.01)


def test_a_reset_forgets_the_flight_before():
    env = Assist(Heli3DOFEnv())
    first, _ = flight(env, np.tile((1.0, -1.0), (100, 1)))
    again, _ = flight(env, np.tile((1.0, -1.0), (100, 1)))
    np.testing.assert_array_equal(first, again)


# At the keyboard


class Player(gym.Wrapper):
    """Presses keys at certain steps, and writes down the voltages that follow."""

    def __init__(self, env, script):
        super().__init__(env)
        self.script, self.voltages = script, []

    def step(self, action):
        result = self.env.step(action)
        self.voltages.append(result[4]["voltage"])
        for event, key in self.script.get(len(self.voltages), ()):
            pygame.event.post(pygame.event.Event(event, {} if key is None else {"key": key}))
        return result


def played(monkeypatch, script, **options):
    """The voltages (2, K) of a flight in which the script is played, and nobody waits."""
    monkeypatch.setattr(pygame.time, "Clock", lambda: type("", (), {"tick": lambda self, rate: None})())
    player = Player(Heli3DOFEnv(render_mode="rgb_array", **options), script)
    fly(player, seed=0)
    return np.transpose(player.voltages)


def test_keys_fly_and_escape_ends(monkeypatch):
    script = {
        2: [(pygame.KEYDOWN, pygame.K_UP)],
        4: [(pygame.KEYDOWN, pygame.K_LEFT)],
        6: [(pygame.KEYUP, pygame.K_UP)],
        8: [(pygame.KEYUP, pygame.K_LEFT)],
        10: [(pygame.KEYDOWN, pygame.K_ESCAPE)],
    }
    u = played(monkeypatch, script)
    expected = [(), (), ("up",), ("up",), ("up", "left"), ("up", "left"), ("left",), ("left",), (), ()]
    assert_allclose(u.T, [voltages(*names) for names in expected], atol=1e-5)
    assert not pygame.display.get_init()


@pytest.mark.slow
def test_closing_the_window_ends_it_and_each_episode_is_summed_up(monkeypatch, capsys):
    script = {2: [(pygame.KEYDOWN, pygame.K_LEFT)], 450: [(pygame.QUIT, None)]}
    played(monkeypatch, script, pitch_limit=math.radians(51.0))
    lines = capsys.readouterr().out.splitlines()
    summed = [line for line in lines if "flown" in line]
    assert summed
    assert all("the pitch left its limit" in line for line in summed)


@pytest.mark.parametrize("arguments", [["--plant", "moon"], ["--reference", "nowhere"]])
def test_bad_arguments_are_refused_with_a_message_that_names_them(arguments):
    with pytest.raises(SystemExit, match=f"heli-play: {arguments[0][2:]} = '{arguments[1]}'"):
        main(arguments)


def test_without_pygame_the_command_names_the_extra_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(SystemExit, match=r"pip install \"heli-gym\[render\]\""):
        main([])


def test_help_names_every_argument_and_the_keys():
    child = subprocess.run([sys.executable, "-m", "heli_gym.play", "--help"], capture_output=True, text=True)
    assert (child.returncode, child.stderr) == (0, "")
    for word in ("--assist", "--plant", "--rig", "--reference", "--seed", "--force", "arrow keys", "Escape"):
        assert word in child.stdout


@pytest.mark.parametrize("assist", [[], ["--assist"]])
def test_the_command_flies_until_the_player_leaves(monkeypatch, assist):
    flown = []

    def play(env, **options):
        flown.append((isinstance(env, Assist), options["seed"], env.unwrapped.render_mode))

    monkeypatch.setattr("gymnasium.utils.play.play", play)
    main([*assist, "--seed", "4"])
    assert flown == [(bool(assist), 4, "rgb_array")]


def test_without_a_display_the_command_says_so(monkeypatch, capsys):
    for name in ("SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.raises(SystemExit) as ended:
        main([])
    assert "must have a display" in str(ended.value.code) + capsys.readouterr().err
