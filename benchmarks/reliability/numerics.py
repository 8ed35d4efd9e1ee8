"""Numbers against independent ones: integrator, flights, Jacobians, gains, energy, batches, single precision."""

import sys
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import solve_continuous_are

from heli_gym import Maneuver, dynamics, linearise
from heli_gym.baselines import fly, make_policy, plan, riccati_gains
from heli_gym.baselines.evaluation.rollout import fly_many
from heli_gym.env import Heli3DOFEnv, find_reference
from heli_gym.model import fan_thrusts, hover_input, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import PLANTS, Plant
from heli_gym.rigid_body import energy, rigid_dynamics, solve_rigid_body
from heli_gym.vector_env import Heli3DOFVectorEnv

sys.path.insert(0, str(Path(__file__).parent))
import flights

P = HelicopterParameters()
START = np.array([0.2, 0.3, -0.1, 0.2, 0.3, -0.4])
V = (0.7, 0.05)


def order_of_integrator() -> float:
    """Observed order: slope of the error over the step, in logarithms."""
    exact = solve_ivp(lambda t, x: dynamics(x, V, P), (0, 1), START, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    steps = np.array([10, 20, 40, 80])
    errors = []
    for n in steps:
        x = tuple(START)
        for _ in range(n):
            x = rk4_step(dynamics, x, (V, V, V), 1.0 / n, P)
        errors.append(np.abs(np.array(x) - exact).max())
    return float(-np.polyfit(np.log(steps), np.log(errors), 1)[0])


def distance_from_dop853(plant: str) -> float:
    """Greatest difference over 100 control periods between the environment and scipy, in rad and rad/s."""
    body = solve_rigid_body("A")
    env = Heli3DOFEnv(PLANTS["nominal"] if plant == "nominal" else Plant(rig=body))
    env.reset(seed=0, options={"state": env.reference.x[:, 0]})
    x, worst = env.reference.x[:, 0].copy(), 0.0
    for action in np.random.default_rng(1).uniform(-0.3, 0.3, (100, 2)):
        v = virtual_input(thrust(np.array(env.to_voltage(action)), P))
        rhs = (lambda t, y: dynamics(y, v, P)) if plant == "nominal" else (lambda t, y: rigid_dynamics(y, v, body))  # noqa: B023
        x = solve_ivp(rhs, (0, env.control_period), x, "DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
        *_, info = env.step(action)
        worst = max(worst, float(np.abs(info["state"] - x).max()))
    return worst


def jacobian_error() -> float:
    """Greatest difference between `linearise` and derivatives computed in 40 digits, over 50 states."""
    import mpmath

    mpmath.mp.dps = 40
    worst, rng = 0.0, np.random.default_rng(2)
    for _ in range(50):
        x, v = rng.uniform(-1, 1, 6), rng.uniform(0, 1, 2)
        A, B = linearise(x, v, P)
        z = [mpmath.mpf(float(value)) for value in (*x, *v)]
        for j in range(8):

            def value(s, j=j, z=z):
                moved = [*z]
                moved[j] = moved[j] + s
                return dynamics(moved[:6], moved[6:], P, mpmath.sin, mpmath.cos)

            h = mpmath.mpf(10) ** -12
            column = [(a - b) / (2 * h) for a, b in zip(value(h), value(-h))]
            ours = (A[:, j] if j < 6 else B[:, j - 6]).tolist()
            worst = max(worst, max(abs(float(a) - b) for a, b in zip(column, ours)))
    return worst


def gain_error() -> float:
    """Greatest relative difference between the gains of (49)-(51) and a Riccati equation integrated by DOP853."""
    from heli_gym.baselines.paper.tvlqr import Q, R, stationary_cost

    reference = plan(Maneuver())
    gains, worst = riccati_gains(reference), 0.0
    M = stationary_cost(0.0, P, Q, R)
    T = reference.duration

    def matrices(t):
        x, u = reference(t)
        return linearise(x, np.array(virtual_input(thrust(u, P))), P)

    def rhs(s, p):
        A, B = matrices(T - s)
        X = p.reshape(6, 6)
        return (X @ A + A.T @ X - X @ B @ np.linalg.solve(R, B.T @ X) + Q).ravel()

    times = np.linspace(0.0, T, 11)
    found = solve_ivp(rhs, (0, T), M.ravel(), "DOP853", t_eval=T - times[::-1], rtol=1e-11, atol=1e-11, max_step=0.02)
    for t, p in zip(times, found.y.T[::-1]):
        _, B = matrices(t)
        K = np.linalg.solve(R, B.T @ p.reshape(6, 6))
        worst = max(worst, float(np.abs(gains(t) - K).max() / np.abs(K).max()))
    return worst


def stationary_error() -> float:
    """Relative difference between the stationary cost of hover and scipy's solution of the Riccati equation."""
    from heli_gym.baselines.paper.tvlqr import Q, R, stationary_cost

    A, B = linearise(np.zeros(6), hover_input(0.0, P), P)
    expected = solve_continuous_are(A, B, Q, R)
    return float(np.abs(stationary_cost(0.0, P, Q, R) - expected).max() / np.abs(expected).max())


def energy_drift() -> float:
    """Relative change of the energy of a rigid body without thrust over 10 s of integration with 10 ms."""
    body = solve_rigid_body("B")
    x = tuple(START)
    before = energy(np.array(x), body)
    for _ in range(1000):
        x = rk4_step(rigid_dynamics, x, ((0.0, 0.0),) * 3, 0.01, body)
    return abs(float((energy(np.array(x), body) - before) / before))


def fan_error() -> float:
    """Greatest difference after volts to thrusts to virtual inputs and back, in N."""
    f = thrust(np.random.default_rng(3).uniform(-12, 12, (2, 1000)), P)
    return float(np.abs(np.array(fan_thrusts(virtual_input(f))) - f).max())


def single_precision_error(plant: str, episodes: int) -> tuple[float, float, float]:
    """RMS errors of travel in degrees in double and single precision, and the greatest difference of states in rad."""
    reference = find_reference("travel-360")
    rms, states = [], []
    for dtype in ("float64", "float32"):
        envs = Heli3DOFVectorEnv(episodes, plant, reference, start_spread_deg=5.0, dtype=dtype)
        group = fly_many(envs, make_policy("feedforward+tvlqr", reference), 5)
        rms.append(np.mean([np.degrees(np.sqrt(np.mean((f.x[0] - reference(f.t)[0][0]) ** 2))) for f in group]))
        states.append([f.x for f in group])
    apart = max(np.abs(a[:, : b.shape[1]] - b[:, : a.shape[1]])[0::2].max() for a, b in zip(*states))
    return float(rms[0]), float(rms[1]), float(apart)


def main(quick: bool, seed: int, only: str) -> int:
    """Run the part."""
    bad = 0

    def check(title: str, value: float, most: float, least: float = 0.0, unit: str = "") -> None:
        nonlocal bad
        bad += not least <= value <= most
        print(f"{title}: {value:.3g} {unit}; must be {f'{least:g} to ' if least else 'at most '}{most:g}")

    check("order of the integrator", order_of_integrator(), 4.1, 3.9)
    for plant in ("nominal", "rigid"):
        check(f"100 control periods against DOP853, {plant}", distance_from_dop853(plant), 1e-6, unit="rad or rad/s")
    check("Jacobians against derivatives in 40 digits", jacobian_error(), 1e-10)
    check("stationary cost against scipy", stationary_error(), 1e-6)
    if not quick:
        check("gains along the plan against DOP853, relative", gain_error(), 1e-6)
    check("energy of a rigid body over 10 s, relative", energy_drift(), 1e-6)
    check("thrusts to virtual inputs and back", fan_error(), 1e-12, unit="N")
    for plant in flights.PLANT_NAMES:
        threads = flights.together(plant, 1) == flights.together(plant, 2)
        bad += not threads
        print(f"{plant}: 1 = 2 threads, bit for bit: {threads}")
        check(f"{plant}, alone against in a vector environment", flights.distance(plant, 3), 0.0, unit="rad or rad/s")
    reference = find_reference("travel-360")
    flight = fly(Heli3DOFEnv("nominal"), make_policy("feedforward+tvlqr", reference))
    error = np.degrees(np.abs(flight.x - reference(flight.t)[0])[0::2]).max()
    check("the paper's plan flown with its controller, greatest error", float(error), 0.5, unit="degrees")
    for plant in ("lab", "rigid") if not quick else ("lab",):
        double, single, apart = single_precision_error(plant, 20 if quick else 100)
        print(
            f"single precision with feedback on {plant}: RMS travel {single:.3f} degrees, double {double:.3f}; "
            f"single flights up to {apart:.3f} rad apart"
        )
        bad += not abs(single - double) < 0.02
    return int(bad > 0)
