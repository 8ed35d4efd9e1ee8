"""Plans whose voltages lead the rotors' lag and dead time, flown open loop on the rig with both, by scipy."""

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp

from heli_gym import Maneuver, dynamics
from heli_gym.baselines import InfeasibleManeuver, plan, plan_fastest
from heli_gym.baselines.planning.lead import leading_commands, rotor_voltages

TRAVEL = np.linspace(0.0, 2.0 * math.pi, 101)
BUMP = np.radians(8.0 - 16.0 * np.exp(-(((TRAVEL - math.pi) / 0.5) ** 2)))
LEADING = {
    "the paper's rig": Maneuver(duration=11.0, lead=True),
    "close to the limits": Maneuver(duration=9.0, lead=True),
    "over a bump": Maneuver(duration=12.0, floor=(TRAVEL, BUMP), lead=True),
    "the rig of the course": Maneuver(goal=(3.0, 0.1), duration=12.0, rig="ntnu", lead=True),
    "Quanser's rig": Maneuver(goal=(-3.0, 0.1), duration=14.0, rig="quanser", lead=True),
    "a via point": Maneuver(duration=12.0, via=((5.0, 2.0, -0.1),), lead=True),
}


def flown_open_loop(planned, rig) -> np.ndarray:
    """State (6,) at the end of an open-loop flight on rotors with the rig's lag and dead time, by DOP853."""
    times, hover = planned.t.copy(), rig.hover_voltage(planned.x[2, 0])

    def rhs(t, z):
        u = np.array([np.interp(t - rig.delay, times, row, left=h) for row, h in zip(planned.u, hover)])
        f_f, f_b = rig.thrust(z[6:])
        rates = dynamics(z[:6], (f_f + f_b, f_f - f_b), rig.parameters, math.sin, math.cos)
        return [*rates, *((u - z[6:]) / rig.lag)]

    start = np.concatenate((planned.x[:, 0], hover))
    flight = solve_ivp(rhs, (0.0, times[-1]), start, "DOP853", rtol=1e-8, atol=1e-10, max_step=0.01)
    return flight.y[:6, -1]


@pytest.mark.parametrize("name", LEADING)
def test_the_open_loop_arrives_on_the_rig_with_lag_and_dead_time_within_the_limits(name):
    requested = LEADING[name]
    planned = plan(requested)
    assert planned.duration == requested.duration
    assert_allclose(flown_open_loop(planned, requested.rig), requested.ends[1], atol=2e-3)
    assert requested.limits.u_min - 1e-6 <= planned.u.min() <= planned.u.max() <= requested.limits.u_max + 1e-6
    late = planned.t <= requested.rig.delay
    assert_allclose(planned.x[:, late], np.repeat(requested.ends[:1], late.sum(), axis=0).T)


def test_without_lead_the_same_open_loop_misses():
    requested = replace(LEADING["close to the limits"], lead=False)
    miss = np.abs(flown_open_loop(plan(requested), requested.rig) - requested.ends[1]).max()
    assert miss > 0.05


@pytest.mark.slow
def test_lag_and_dead_time_cost_time():
    follows, leads = (plan_fastest(Maneuver(duration=20.0, lead=lead)) for lead in (False, True))
    assert follows.duration + 0.02 < leads.duration < 1.1 * follows.duration
    assert_allclose(flown_open_loop(leads, leads.rig), Maneuver().ends[1], atol=2e-3)


MOVING = (2.8, 0.3, -0.08, 0.03, 0.1, 0.0)


@pytest.mark.parametrize(
    "requested",
    [
        Maneuver((0.0, 0.1), duration=60.0, goal_state=MOVING, lead=True),  # the thrust map is flat at low voltages
        Maneuver(goal=(5.0, None), duration=60.0, rig="quanser", lead=True),
        Maneuver((0.0, 0.04), (5.6, 0.08), 60.0, rig="ntnu", lead=True),
    ],
    ids=["to a goal in motion", "to any elevation", "the rig of the course"],
)
@pytest.mark.slow
def test_the_fastest_plan_leads_within_its_limits(requested):
    leads = plan_fastest(requested, "spline")
    flown = flown_open_loop(leads, requested.rig)
    goal = np.array(requested.ends[1])
    goal[2] = leads.x[2, -1] if requested.elevation_free else goal[2]
    assert_allclose(flown, goal, atol=1e-3)
    limits = requested.limits
    assert limits.u_min - 1e-6 <= leads.u.min() <= leads.u.max() <= limits.u_max + 1e-6


def test_commands_lead_to_any_voltages():
    rng, t = np.random.default_rng(4), np.linspace(0.0, 2.0, 2001)
    w = np.stack([np.interp(t, np.linspace(0.0, 2.0, 8), rng.uniform(2.0, 10.0, 8)) for _ in range(2)])
    times, u = leading_commands(t, w, 0.1)
    assert len(t) < len(times) < 2.0 * len(t)
    response = rotor_voltages(times, u, 0.1, 0.0, w[:, 0])
    assert_allclose(response[:, np.searchsorted(times, t)], w, atol=1e-3)
    assert np.abs(np.trapezoid(response[:, np.searchsorted(times, t)] - w, t)).max() < 1e-5


def test_collocation_leads_too():
    requested = LEADING["close to the limits"]
    planned = plan(requested, "collocation")
    assert_allclose(flown_open_loop(planned, requested.rig), requested.ends[1], atol=2e-3)


def test_the_response_of_the_rotors_is_scipys():
    t, rng = np.concatenate((np.linspace(0.0, 1.0, 401), 1.0 + np.linspace(0.01, 1.0, 100))), np.random.default_rng(0)
    u = np.stack([np.interp(t, np.linspace(0.0, 2.0, 9), rng.uniform(2.0, 10.0, 9)) for _ in range(2)])
    before = np.array([5.0, 6.0])
    w = rotor_voltages(t, u, 0.1, 0.0, before)

    def rhs(t_, w_):
        return [(np.interp(t_, t, row) - value) / 0.1 for row, value in zip(u, w_)]

    exact = solve_ivp(rhs, (0.0, 2.0), before, t_eval=t, rtol=1e-9, atol=1e-9, max_step=2e-3).y
    assert_allclose(w, exact, atol=1e-5)


@pytest.mark.slow
def test_a_refusal_states_a_duration_that_works():
    with pytest.raises(InfeasibleManeuver, match=r"dead time of 0\.02 s") as refusal:
        plan(Maneuver(duration=8.0, lead=True))
    longer = Maneuver(duration=refusal.value.shortest_duration, lead=True)
    assert plan(longer).duration == longer.duration


@pytest.mark.parametrize("arguments", [{"start_state": (0.0, 0.1, 0.0, 0.0, 0.0, 0.0)}, {"periodic": True}], ids=str)
def test_a_lead_without_a_start_at_rest_is_named(arguments):
    with pytest.raises(ValueError, match="lead = True: must go with a start at rest"):
        Maneuver(lead=True, **arguments)
