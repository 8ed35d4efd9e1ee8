"""Program of the pages: built from its sources, with the same helicopter as in Python; live page."""

import hashlib
import subprocess
import sys

import numpy as np
import pytest
from browser import DESKTOP, DRAWN, PHONE, SMALL, SOURCES, STILL, in_browser, in_node, installed, tool
from scipy.integrate import solve_ivp
from scipy.interpolate import interp1d

from heli_gym import HelicopterParameters, Maneuver, linearise
from heli_gym.baselines import fly, make_policy, plan_fastest, riccati_gains
from heli_gym.baselines.commands import demo
from heli_gym.baselines.control.residual import LEARNED, load_learned
from heli_gym.baselines.evaluation.report import WEB
from heli_gym.baselines.paper.boundary_value import ConstrainedProblem
from heli_gym.env import Heli3DOFEnv
from heli_gym.model import dynamics, virtual_input
from heli_gym.plant import PLANTS, Friction, Plant, Push, Rotors, Sensors
from heli_gym.rig import Rig, find_rig
from heli_gym.rigid_body import VARIANTS, solve_rigid_body
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustMap

PERIOD = demo.CONTROL_PERIOD
START = np.radians([4.0, 0.0, -5.0, 0.0, 3.0, 0.0])
FRICTION = Friction(viscous=(0.1, 0.2, 0.3))
ROTORS = Rotors(lag=0.1, thrust_loss=0.08, delay=0.02)
IN_THE_PAGE = [name for name in PLANTS if name != "fleet"]  # on the paper's rig
DRAWS = {
    "nominal": Plant(),
    "lab": Plant(rotors=ROTORS, friction=FRICTION, sensors=Sensors()),
    "without lag": Plant(rotors=Rotors(thrust_loss=0.1, delay=0.04), friction=FRICTION),
    **{
        f"rigid {variant}": Plant(rig=solve_rigid_body(variant), rotors=ROTORS, friction=FRICTION, sensors=Sensors())
        for variant in VARIANTS
    },
}


@pytest.fixture(scope="module")
def live():
    """Data of the page, with those of the paper's rig on top."""
    data = demo.live_data()
    paper = data["rigs"][0]
    return {**data, **paper, "grid": paper["grids"]["paper"]}


@pytest.fixture(scope="module")
def rigs():
    return {rig["name"]: rig for rig in demo.live_data()["rigs"]}


@pytest.fixture(scope="module")
def papers_plan():
    """The plan of Section III-D, by collocation."""
    maneuver = Maneuver()
    return ConstrainedProblem(maneuver).trajectory(demo.solve_from_unconstrained(maneuver))


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    path = tmp_path_factory.mktemp("live") / "live.html"
    demo.main(demo.Args(out=path, open=False))
    return path


# What is built


def test_the_program_is_built_from_the_sources_beside_it():
    names = ["build.mjs", "package-lock.json", *(f"src/{path.name}" for path in (SOURCES / "src").iterdir())]
    hashed = hashlib.sha256()
    for name in sorted(names):
        hashed.update(f"{name}\n".encode() + (SOURCES / name).read_bytes() + b"\n")
    first_line = (WEB / "heli.js").read_text().partition("\n")[0]
    assert first_line.endswith(hashed.hexdigest()), "run `npm ci && npm run build` in web/"


def test_a_new_build_equals_the_shipped_program(tmp_path):
    installed("esbuild")
    subprocess.run([tool("node"), "build.mjs", str(tmp_path)], cwd=SOURCES, check=True, capture_output=True)
    for name in ("heli.js", "heli.css"):
        assert (tmp_path / name).read_bytes() == (WEB / name).read_bytes(), "run `npm ci && npm run build` in web/"


@pytest.mark.slow
def test_the_sources_pass_the_type_checker():
    child = subprocess.run([tool("node"), installed("typescript/bin/tsc")], cwd=SOURCES, capture_output=True, text=True)
    assert child.returncode == 0, child.stdout


def test_the_shipped_program_is_small_and_closes_no_element_of_the_page():
    assert sum(path.stat().st_size for path in WEB.iterdir()) < 1_000_000
    script = (WEB / "heli.js").read_text().lower()
    assert "</script" not in script
    assert "<!--" not in script


def test_the_packages_name_no_registry():
    assert "resolved" not in (SOURCES / "package-lock.json").read_text()


# The same helicopter

FLY = """((controller) => {
    const rules = {controlPeriod: live.control_period, amplifier: live.amplifier,
                   pitchStop: live.pitch_stop, substep: live.substep};
    const flight = new heli.Flight(controller, plant, rules, start, rest);
    for (let k = 0; k < steps; k++) flight.step(pushes);
    return {x: flight.x, u: flight.u};
})"""


TRACKING = "heli.trackingController(controls, live.parameters)"
ALONG = "heli.controllersAlong(controls.plan, controls.pitch, live)[controls.name](heli.unpacked(controls.network))"


def tracking(policy):
    """A tracking policy's own reference and gains, for the browser."""
    gains = np.moveaxis(policy.gains, -1, 0)
    return {"x": policy.x.T.tolist(), "v": policy.v.T.tolist(), "gains": gains.tolist() if gains.any() else None}


def fly_in_node(live, plant, reference, controls, start, steps, pushes=(), controller=TRACKING):
    """States (6, K + 1) and voltages (2, K) of a flight with a controller, an expression that uses the controls."""
    flight = in_node(
        f"{FLY}({controller})",
        live=live,
        plant=demo.plain(plant),
        controls=controls,
        start=list(start),
        rest=reference.u[:, 0].tolist(),
        steps=steps,
        pushes=[{**demo.plain(push), "axis": live["axes"].index(push.axis)} for push in pushes],
    )
    return np.array(flight["x"]).T, np.array(flight["u"]).T


@pytest.mark.parametrize("policy", ["feedforward+tvlqr", "open-loop", "hover-lqr"])
@pytest.mark.parametrize("plant", DRAWS)
def test_a_flight_in_the_browser_is_that_of_python(live, plant, policy):
    env = Heli3DOFEnv(DRAWS[plant], control_period=PERIOD)
    controller = make_policy(policy, env.reference, PERIOD)
    flight = fly(env, controller, seed=0, options={"state": START})
    x, u = fly_in_node(live, DRAWS[plant], env.reference, tracking(controller), START, len(flight.t) - 1)
    np.testing.assert_allclose(x, flight.x, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(u, flight.u[:, :-1], rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("policy", ["kalman-lqr", "residual"])
@pytest.mark.parametrize("plant", DRAWS)
def test_a_flight_with_filter_gains_of_the_browser_equals_that_of_python(live, plant, policy):
    env = Heli3DOFEnv(DRAWS[plant], control_period=PERIOD)
    reference = env.reference
    network = "rigid" if plant.startswith("rigid") else "lab"
    in_python = f"kalman-lqr@{network}" if policy == "kalman-lqr" else {"lab": policy}.get(network, "residual-rigid")
    flight = fly(env, make_policy(in_python, reference, PERIOD), seed=0, options={"state": START})
    x, u = reference(0.5 * PERIOD * np.arange(round(2.0 * reference.duration / PERIOD) + 1))
    controls = {
        "name": policy,
        "plan": {"step": 0.5 * PERIOD, "x": x.T.tolist(), "u": u.T.tolist()},
        "pitch": reference.limits.pitch,
        "network": live["networks"][network],
    }
    x, u = fly_in_node(live, DRAWS[plant], reference, controls, START, len(flight.t) - 1, controller=ALONG)
    if policy == "residual":
        # Gains by other steps change voltages by 1e-5 V, until a count of an encoder more makes a difference.
        np.testing.assert_allclose(u[:, :50], flight.u[:, :50], rtol=0.0, atol=1e-4)
        np.testing.assert_allclose(x[:, :50], flight.x[:, :50], rtol=0.0, atol=1e-5)
        np.testing.assert_allclose(x[0::2], flight.x[0::2], rtol=0.0, atol=0.02)
    else:
        np.testing.assert_allclose(x, flight.x, rtol=0.0, atol=1e-9)
        np.testing.assert_allclose(u, flight.u[:, :-1], rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("plant", IN_THE_PAGE)
def test_the_network_of_a_plant_in_the_browser_is_that_of_python(live, plant):
    settings, network = load_learned(LEARNED / live["network_for"][plant])
    assert settings.plant == plant or plant == "nominal"
    assert (settings.base, settings.control_period) == (f"feedforward+tvlqr@{settings.plant}", PERIOD)
    features = np.random.default_rng(0).normal(size=(20, settings.features))
    found = in_node(
        """
        (() => {
          const network = heli.unpacked(stored).learned;
          let hidden = network.arrays.weight_hidden[0].map(() => 0);
          return features.map((seen) => {
            const step = heli.actions(network, seen, hidden);
            hidden = step.hidden;
            return step.action;
          });
        })()
        """,
        stored=live["networks"][settings.plant],
        features=features.tolist(),
    )
    hidden = np.zeros(settings.recurrent)
    for seen, action in zip(features, found):
        expected, hidden = network(seen, hidden)
        np.testing.assert_allclose(action, expected, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("plant", ["nominal", "lab"])
def test_a_push_in_the_browser_is_that_of_python(live, plant):
    pushes = (
        Push("pitch", acceleration=4.0, time=2.0),
        Push("elevation", acceleration=3.0, time=3.0037, duration=0.013),  # off the steps of the integration
        Push("travel", acceleration=-2.0, time=5.0, duration=0.3),
    )
    draw = DRAWS[plant]
    env = Heli3DOFEnv(Plant(rotors=draw.rotors, friction=draw.friction, sensors=draw.sensors, disturbances=pushes))
    controller = make_policy("feedforward+tvlqr", env.reference, PERIOD)
    flight = fly(env, controller, seed=0)
    steps, start = len(flight.t) - 1, env.reference.x[:, 0]
    x, _ = fly_in_node(live, draw, env.reference, tracking(controller), start, steps, pushes)
    np.testing.assert_allclose(x, flight.x, rtol=0.0, atol=1e-9)
    calm, _ = fly_in_node(live, draw, env.reference, tracking(controller), start, steps)
    assert np.abs(x - calm)[:, :100].max() < 1e-8  # with a push, it is integrated in smaller steps
    assert np.abs(x - calm)[4, 110:].max() > np.radians(2.0)


@pytest.mark.parametrize("plant", IN_THE_PAGE)
def test_draws_in_the_browser_are_within_the_ranges_of_python(plant):
    preset = PLANTS[plant]
    low, middle, high = in_node("[0, 0.5, 0.999].map((at) => heli.drawn(plant, () => at))", plant=demo.plain(preset))
    if plant == "nominal":
        assert low == middle == high == demo.plain(preset)
        return
    lag = preset.rotors.lag
    assert low["rotors"]["lag"] == lag.low
    assert middle["rotors"]["lag"] == pytest.approx((lag.low + lag.high) / 2.0)
    assert low["rotors"]["lag"] < high["rotors"]["lag"] <= lag.high
    assert (low["rig"] != high["rig"]) == (plant == "rigid")  # the other variant


def test_the_equations_of_the_page_are_translated_from_python():
    child = subprocess.run([sys.executable, SOURCES / "translate.py", "--check"], capture_output=True, text=True)
    assert child.returncode == 0, child.stderr + "run `python web/translate.py` and `npm run build` in web/"


@pytest.mark.parametrize("name", ["quanser", "ntnu", "fleet"])
@pytest.mark.parametrize("policy", ["feedforward+tvlqr", "open-loop"])
def test_a_flight_on_another_rig_in_the_browser_is_that_of_python(live, rigs, name, policy):
    data = {**live, **rigs[name]}
    env = Heli3DOFEnv(rig=name, control_period=PERIOD)
    controller = make_policy(policy, env.reference, PERIOD)
    flight = fly(env, controller, seed=0, options={"state": env.reference.x[:, 0] + START})
    x, u = fly_in_node(data, env.plant, env.reference, tracking(controller), flight.x[:, 0], len(flight.t) - 1)
    # the power of a real exponent is not the same to the last digit in both
    np.testing.assert_allclose(x, flight.x, rtol=0.0, atol=1e-7)
    np.testing.assert_allclose(u, flight.u[:, :-1], rtol=0.0, atol=1e-6)


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_a_draw_of_fleet_in_the_browser_is_that_of_python(live, rigs, seed):
    """All effects of a general plant: uneven rotors, drift, delays between two periods, sensor zeros, lift, a table."""
    draw = PLANTS["fleet"].draw(np.random.default_rng(seed))
    env = Heli3DOFEnv(draw, control_period=PERIOD, rig="fleet")
    controller = make_policy("feedforward+tvlqr", env.reference, PERIOD)
    flight = fly(env, controller, seed=0)
    start = flight.x[:, 0]
    x, _ = fly_in_node({**live, **rigs["fleet"]}, draw, env.reference, tracking(controller), start, len(flight.t) - 1)
    np.testing.assert_allclose(x, flight.x, rtol=0.0, atol=1e-7)


TABLE = TableCurve((-10.0, -4.0, 0.0, 2.0, 6.0, 12.0), (-0.3, -0.1, 0.0, 0.0, 0.4, 1.1))


@pytest.mark.parametrize("curve", [PowerCurve(0.13, -0.05, 1.22, 0.4), PowerCurve(0.005, 0.0), TABLE])
def test_thrust_and_voltage_in_the_browser_are_those_of_python(curve):
    u = np.linspace(-12.0, 14.0, 53)
    f = np.linspace(-0.4, 1.3, 35)
    found = in_node(
        "({f: u.map((x) => heli.thrustAt(x, c)), u: f.map((x) => heli.voltageFor(x, c))})",
        u=u.tolist(),
        f=f.tolist(),
        c=demo.plain(curve),
    )
    np.testing.assert_allclose(found["f"], curve.thrust(u), rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(found["u"], curve.voltage(f), rtol=0.0, atol=1e-9)


SPLINES = "plans.map((plan) => heli.splinePlan(plan, live.goal, live.parameters, live.control_period / 2))"


@pytest.mark.parametrize("name", demo.RIGS)
def test_the_splines_of_every_rig_arrive_within_their_limits(live, rigs, name):
    """Also against Python: the plan replayed by `solve_ivp` from the thrusts of the page arrives."""
    rig, grid = find_rig(name), rigs[name]["grids"]["spline"]
    low, high = rig.voltage_limits
    cells = [(i, j) for i in range(len(grid["pitch_limits_deg"])) for j in range(len(grid["windows"]))]
    chosen = [(i, j, k) for i, j in cells for k in (0, 4) if grid["plans"][i][j][k] is not None]
    assert len(chosen) > len(cells)
    stored = [grid["plans"][i][j][k] for i, j, k in chosen]
    for (i, j, _), plan, found in zip(chosen, stored, in_node(SPLINES, plans=stored, live={**live, **rigs[name]})):
        x, u = np.array(found["x"]).T, np.array(found["u"]).T
        arrival = int(plan["duration"] / found["step"])
        (u_low, u_high), pitch = grid["windows"][j], np.radians(grid["pitch_limits_deg"][i])
        # a sample may be up to 10 ms before the goal
        np.testing.assert_allclose(x[0::2, arrival], [*live["goal"], 0.0], rtol=0.0, atol=2e-3)
        assert u_low - 1e-3 <= u.min() <= u.max() <= u_high + 1e-3
        assert np.abs(x[4]).max() <= pitch + 1e-6
        assert low <= u_low < u_high <= high
    times = found["step"] * np.arange(arrival)
    v = virtual_input(rig.thrust(u))
    along = [interp1d(found["step"] * np.arange(x.shape[1]), row, "cubic") for row in v]

    def rhs(t, at):
        return np.stack(dynamics(at, [row(t) for row in along], rig.parameters))

    replayed = solve_ivp(rhs, (0.0, times[-1]), x[:, 0], t_eval=times, rtol=1e-8, atol=1e-10, max_step=0.02).y
    np.testing.assert_allclose(replayed, x[:, : len(times)], rtol=0.0, atol=5e-3)


def test_the_fastest_spline_of_the_page_is_the_planners(live):
    grid = live["grids"]["spline"]
    fastest = grid["plans"][grid["pitch_limits_deg"].index(50.0)][grid["windows"].index([1.0, 11.0])][0]
    assert fastest["duration"] == pytest.approx(plan_fastest(Maneuver(duration=20.0)).duration, abs=1e-3)


def test_a_rig_from_a_file_gets_its_own_grid_of_plans(tmp_path):
    Rig("mine", find_rig("ntnu").parameters, voltage_limits=(0.0, 15.0), thrust_map=ThrustMap(TABLE, TABLE)).save(
        tmp_path / "mine.toml"
    )
    [rig] = demo.live_data(find_rig(tmp_path / "mine.toml"))["rigs"]
    assert (rig["name"], rig["parameters"]["front"]["thrusts"]) == ("mine", TABLE.thrusts)
    assert rig["grids"]["spline"]["durations"][0] is None
    assert any(plan for window in rig["grids"]["spline"]["plans"] for cells in window for plan in cells)


def test_the_linearisation_in_the_browser_is_that_of_python():
    rng = np.random.default_rng(0)
    x, v = rng.uniform(-1.0, 1.0, 6), rng.uniform(-1.0, 1.0, 2)
    parameters = HelicopterParameters()
    found = in_node("heli.linearise(x, v, p)", x=x.tolist(), v=v.tolist(), p=parameters._asdict())
    for matrix, expected in zip((found["A"], found["B"]), linearise(x, v, parameters)):
        np.testing.assert_allclose(matrix, expected, rtol=0.0, atol=1e-11)


PLAN = """maneuvers.map(({p, ...maneuver}) => {
    const plan = heli.integratePlan(maneuver, [p.slice(0, live.kappa[0]), p.slice(live.kappa[0])], live.pitch_reserve,
                                    live.parameters, live.control_period / 2);
    return {x: plan.x, u: plan.u, gains: gains ? heli.riccatiGains(plan, live.weights, live.parameters) : null};
})"""


def maneuvers(live):
    """Every maneuver of the grid that has a plan, as the page asks for it."""
    grid = live["grid"]
    for pitch_limit_deg, chains in zip(grid["pitch_limits_deg"], grid["plans"]):
        for window, chain in zip(grid["windows"], chains):
            for duration, p in zip(grid["durations"], chain):
                if p is not None:
                    pitch = [-np.radians(pitch_limit_deg), np.radians(pitch_limit_deg)]
                    limits = {"u": window, "pitch": pitch}
                    yield {"duration": duration, "goal": live["goal"], "limits": limits, "p": p}


def test_the_papers_plan_and_its_gains_in_the_browser_are_those_of_python(live, papers_plan):
    limits = papers_plan.limits
    [maneuver] = [
        m
        for m in maneuvers(live)
        if (m["duration"], *m["limits"]["u"]) == (papers_plan.duration, *limits.u)
        and np.allclose(m["limits"]["pitch"], limits.pitch)
    ]
    [found] = in_node(PLAN, live=live, maneuvers=[maneuver], gains=True)
    t = 0.5 * PERIOD * np.arange(len(found["x"]))
    x, u = papers_plan(t)
    np.testing.assert_allclose(np.array(found["x"]).T, x, rtol=0.0, atol=1e-5)
    np.testing.assert_allclose(np.array(found["u"]).T, u, rtol=0.0, atol=1e-4)
    gains = np.moveaxis(np.array(found["gains"]), 0, -1)
    np.testing.assert_allclose(gains, riccati_gains(papers_plan)(t[::2]), rtol=0.0, atol=1e-3)


@pytest.mark.slow
def test_every_plan_of_the_grid_arrives_within_its_limits(live):
    requested = list(maneuvers(live))
    assert len(requested) > 200
    for maneuver, found in zip(requested, in_node(PLAN, live=live, maneuvers=requested, gains=False)):
        x, u = np.array(found["x"]), np.array(found["u"])
        # the last sample is the goal by definition, and the one before a hundredth of a second away from it
        np.testing.assert_allclose(x[-2, 0::2], x[-1, 0::2], rtol=0.0, atol=1e-3)
        np.testing.assert_allclose(x[-1, 0::2], [*live["goal"], 0.0])
        (low, high), (pitch_low, pitch_high) = maneuver["limits"]["u"], maneuver["limits"]["pitch"]
        assert low - 1e-6 <= u.min() <= u.max() <= high + 1e-6
        assert pitch_low - 1e-6 <= x[:, 4].min() <= x[:, 4].max() <= pitch_high + 1e-6


@pytest.mark.slow
def test_the_grid_agrees_with_the_solver(live):
    grid = live["grid"]
    i, j = len(demo.PITCH_LIMITS_DEG) - 1, 1
    chain = demo.solve_chain(demo.PITCH_LIMITS_DEG[i], demo.VOLTAGE_WINDOWS[j])
    assert (grid["durations"], grid["pitch_limits_deg"]) == (list(demo.DURATIONS), list(demo.PITCH_LIMITS_DEG))
    assert [tuple(window) for window in grid["windows"]] == list(demo.VOLTAGE_WINDOWS)
    for stored, found in zip(grid["plans"][i][j], chain, strict=True):
        assert (stored is None) == (found is None)
        if found is not None:
            np.testing.assert_allclose(stored, found, rtol=0.0, atol=1e-3)


# The live page

READ = (
    DRAWN
    + """
const readout = async (plot) => {
  const figure = page.locator("figure", {hasText: plot}).first();
  const texts = await figure.locator(".readout span").allTextContents();
  return texts.map((text) => Number(text.replace("\\u2212", "-")));
};
const numbers = () => page.locator(".view").first().locator(".numbers").textContent();
const clock = async () => parseFloat(await page.locator(".clock").textContent());
const until = async (time) => {
  await page.waitForFunction((t) => parseFloat(document.querySelector(".clock").textContent) >= t, time);
};
const press = async (keys) => {
  await page.locator(".plot").first().focus();
  for (const key of keys) await page.keyboard.press(key);
  await drawn();
};
const slide = async (id, steps) => {
  await page.locator(id).focus();
  for (let k = 0; k < Math.abs(steps); k++) await page.keyboard.press(steps < 0 ? "ArrowLeft" : "ArrowRight");
};
"""
)


@pytest.mark.parametrize("size", [DESKTOP, PHONE])
def test_the_page_opens_without_complaint_fits_and_flies(page, size):
    script = """
        await until(0.2);
        const first = [await numbers(), (await page.locator(".stage").screenshot()).toString("base64")];
        await until(1.5);
        const second = [await numbers(), (await page.locator(".stage").screenshot()).toString("base64")];
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        return {first, second, width, message: await page.locator(".stage").getAttribute("data-message")};
    """
    seen = in_browser(page, READ + script, size)
    assert seen["message"] is None
    assert seen["width"] <= size[0]
    for before, after in zip(seen["first"], seen["second"]):
        assert before != after


@pytest.mark.slow
def test_a_push_moves_the_pitch(page):
    script = """
        await slide("#startOff", -3);  // on the reference
        await press(["ArrowRight", "ArrowRight"]);
        const before = await readout("pitch");
        await page.evaluate(() => document.activeElement.blur());
        await page.keyboard.press("ArrowRight");
        await press(Array(4).fill("ArrowRight"));
        const after = await readout("pitch");
        return {before, after};
    """
    seen = in_browser(page, STILL + READ + SMALL + script)
    controlled, *_, reference = seen["before"]
    assert abs(controlled - reference) < 0.2
    controlled, open_loop, *_, reference = seen["after"]
    assert controlled - reference > 2.0
    assert open_loop - reference > 2.0


def test_keys_that_come_within_one_frame_all_move_the_time(page):
    script = """
        await press(["Home"]);
        await page.evaluate(() => {
          const key = () => new KeyboardEvent("keydown", {key: "ArrowRight", bubbles: true});
          for (let k = 0; k < 4; k++) document.activeElement.dispatchEvent(key());
        });
        await drawn();
        return clock();
    """
    assert in_browser(page, STILL + READ + SMALL + script) == 0.4


@pytest.mark.slow
def test_a_slider_changes_the_flight_and_a_missing_plan_is_reported(page, papers_plan):
    script = """
        const references = [];
        for (const steps of [0, 8]) {  // 10 s, then 14 s
          await slide("#duration", steps);
          await press(["Home", ...Array(3).fill("Shift+ArrowRight")]);
          references.push([await clock(), (await readout("travel")).at(-1)]);
        }
        await slide("#duration", -11);  // 8.5 s
        const message = await page.locator(".message").textContent();
        const disabled = await page.locator("#play").isDisabled();
        await page.locator("#remedy").click();
        await drawn();
        return {references, message, disabled, duration: await page.locator("output[for=duration]").textContent(),
                hidden: await page.locator(".message").isHidden()};
    """
    seen = in_browser(page, STILL + READ + SMALL + script)
    (time, travel), (later_time, slower) = seen["references"]
    assert abs(travel - np.degrees(papers_plan(time)[0][0])) < 6.0  # the clock shows tenths
    assert slower < 0.7 * np.degrees(papers_plan(later_time)[0][0])
    assert "8.5 s" in seen["message"]
    assert "none below 10.0 s" in seen["message"]
    assert "splines takes 8.30 s" in seen["message"]
    assert seen["disabled"]
    assert (seen["duration"], seen["hidden"]) == ("fastest, 8.30 s", True)


def test_plants_and_policies_are_chosen_with_the_keyboard_too(page):
    script = """
        await until(0.2);
        const seen = {};
        for (const key of ["3", "2", "1"]) {
          await page.keyboard.press(key);
          seen[key] = [await page.locator("input[name=plant]:checked").inputValue(),
                       await page.locator("#plant-note").textContent()];
        }
        await page.keyboard.press("2");
        await page.keyboard.press("d");
        seen.d = await page.locator("#plant-note").textContent();
        await page.keyboard.press("5");
        seen.shown = await page.locator(".view").evaluateAll((views) => views.filter((view) => !view.hidden).length);
        await page.keyboard.press("Space");
        seen.play = await page.locator("#play").textContent();
        await page.keyboard.press("Tab");
        seen.focused = await page.evaluate(() => document.activeElement.tagName);
        return seen;
    """
    seen = in_browser(page, READ + SMALL + script)
    assert [seen[key][0] for key in "123"] == IN_THE_PAGE
    assert "Draw 1" in seen["2"][1]
    assert "Draw" not in seen["1"][1]
    assert "Draw 2" in seen["d"]
    assert seen["shown"] == sum(policy["shown"] for policy in demo.POLICIES) - 1
    assert seen["play"] == "Fly"
    assert seen["focused"] == "CANVAS"  # the first stop; arrow keys turn the view there


@pytest.mark.slow
def test_the_residual_policy_uses_the_plants_network_and_differs_from_its_base(page):
    script = """
        const shown = async () => {
          const values = [];
          for (const plot of ["elevation", "pitch", "front voltage", "back voltage"]) values.push(await readout(plot));
          return values;
        };
        const seen = {};
        for (const [key, plant] of [["2", "lab"], ["3", "rigid"]]) {
          await page.keyboard.press(key);
          await page.locator(".toggles label", {hasText: "Kalman LQR"}).locator("input").check();
          await press(["Home", ...Array(2).fill("Shift+ArrowRight")]);
          seen[plant] = [await shown(), await page.locator("#plant-note").textContent()];
        }
        await page.keyboard.press("7");
        await drawn();
        seen.without = await shown();
        return seen;
    """
    seen = in_browser(page, STILL + READ + SMALL + script)
    for plant in ("lab", "rigid"):
        values, note = seen[plant]
        _, _, residual, kalman, hover, *_ = zip(*values)
        assert max(abs(a - b) for a, b in zip(residual, kalman)) > 0.3
        assert set(hover) == {None}  # not shown at first
        assert f"trained on {plant}" in note
    _, _, residual, kalman, *_ = zip(*seen["without"])
    assert set(residual) == {None}
    assert None not in kalman


def test_a_page_that_is_no_html_file_is_refused_by_name(tmp_path):
    with pytest.raises(SystemExit, match=r"heli-demo: out = .*page\.txt"):
        demo.main(demo.Args(out=tmp_path / "page.txt", open=False))
    assert list(tmp_path.iterdir()) == []


def test_a_folder_gets_the_page_as_its_index(tmp_path):
    demo.main(demo.Args(out=tmp_path / "site", open=False))
    assert [path.name for path in (tmp_path / "site").iterdir()] == ["index.html"]
