// The live page: the helicopter simulated here, flown by the policies side by side along a plan that is chosen here.

import { type ControlData, type Maker, controllersAlong } from "./controllers";
import { FrameMeter, REFERENCE, View, deg, isForControl, keyHelp, make, shown } from "./dom";
import { Flight, type Rules } from "./flight";
import { type Pair, hoverInput, voltages } from "./model";
import { type Plan, integratePlan } from "./plan";
import { type Plant, type Push, drawn } from "./plant";
import { Plot, type PlotOptions } from "./plots";
import { controlGrid } from "./policies";
import { type StoredNetwork, unpacked } from "./residual";
import { type Pose, makeStage } from "./rig";
import type { Rig } from "./rigid";

export interface LiveData extends ControlData {
  paper: { duration: number; pitch_limit_deg: number; window: Pair };
  goal: Pair;
  pitch_stop: number;
  pitch_reserve: number;
  kappa: Pair;
  substep: number;
  plants: Record<string, unknown>;
  rig: Rig;
  policies: { name: string; label: string; colour: string; shown: boolean }[];
  networks: Record<string, StoredNetwork>; // by the plant that each was trained on
  network_for: Record<string, string>; // by plant
  /** Parameters of (39), or null where no plan was found: plans[pitch limit][window][duration]. */
  grid: { durations: number[]; pitch_limits_deg: number[]; windows: Pair[]; plans: (number[] | null)[][][] };
}

const HOLD = 4; // s, for which the goal is held
const SPEEDS = [0.25, 0.5, 1, 2];
const PUSH = 0.1; // s
const PUSHES = [ // rad/s²
  { label: "◀ pitch", key: "ArrowLeft", axis: 2, acceleration: -6 },
  { label: "pitch ▶", key: "ArrowRight", axis: 2, acceleration: 6 },
  { label: "▲ lift", key: "ArrowUp", axis: 1, acceleration: -3 },
  { label: "▼ press", key: "ArrowDown", axis: 1, acceleration: 3 },
];
const POLICY_KEYS = ["4", "5", "6", "7", "8"]; // after those of the plants
const PLANT_NOTES: Record<string, string> = {
  nominal: "Equation (3), exactly: what the controllers believe in.",
  lab: "(3) with rotor lag, friction, thrust loss, a delay, and encoders.",
  rigid: "The full rigid body, with the rotors, friction and encoders of lab.",
};

export function showLive(data: LiveData, main: HTMLElement): void {
  const { parameters, grid, control_period: period } = data;
  const p = parameters;
  const rules: Rules = {
    controlPeriod: period,
    amplifier: data.amplifier,
    pitchStop: data.pitch_stop,
    substep: data.substep,
  };
  const colours = data.policies.map(({ colour }) => colour);
  const papers = {
    duration: grid.durations.indexOf(data.paper.duration),
    pitch: grid.pitch_limits_deg.indexOf(data.paper.pitch_limit_deg),
    window: grid.windows.findIndex((window) => window.join() === data.paper.window.join()),
  };
  const asked = { ...papers, startOff: 3 };
  const enabled = data.policies.map(({ shown }) => shown);
  const networks = Object.fromEntries(Object.entries(data.networks).map(([name, stored]) => [name, unpacked(stored)]));
  let plantName = Object.keys(data.plants)[0];
  let draws = 1;
  let plant = data.plants[plantName] as Plant;
  let plan: Plan | null = null;
  let reference: { x: number[][]; u: Pair[] } = { x: [], u: [] }; // on the control grid, the goal being held at the end
  let controllers: Record<string, Maker> = {};
  let flights: (Flight | null)[] = [];
  let pushes: Push[] = [];
  let time = 0;
  let flying = false;
  let changed = true; // whether something is to be drawn although nothing flies
  let speed = 1;

  // The stage and the plots

  const views = data.policies.map(({ label }, i) => new View(label, colours[i]));
  const canvas = make("canvas", { role: "img", "aria-label": "the helicopters in 3D; drag to look from elsewhere" });
  const stageElement = make("div", { class: "stage" }, canvas, ...views.map((view) => view.element));
  const meter = new FrameMeter();
  const lines = data.policies.map(({ label }, i) => ({ label, colour: colours[i] }));
  const ghostLine = { label: "reference", colour: REFERENCE, dashed: true };
  const plots: { plot: Plot; value: (x: number[], u: Pair, k: number) => number; nominal?: boolean; held?: boolean }[] = [];
  const addPlot = (options: Omit<PlotOptions, "duration">, entry: Omit<(typeof plots)[number], "plot">) => {
    const plot = new Plot({ ...options, duration: 1 });
    plots.push({ plot, ...entry });
    return plot;
  };
  const angle = (name: string, i: number, unit = "deg") =>
    addPlot({ title: name, unit, lines: [...lines, ghostLine], ...(i === 4 && { limits: [0, 0] }) }, { value: (x) => deg(x[i]), nominal: true });
  const held = lines.map((line) => ({ ...line, held: true }));
  const fan = (name: string, i: 0 | 1) =>
    addPlot({ title: name, unit: "V", lines: [...held, ghostLine], limits: [0, 0], range: data.amplifier }, { value: (_, u) => u[i], nominal: true, held: true });
  angle("travel", 0);
  angle("elevation", 2, "deg, down");
  const pitchPlot = angle("pitch", 4);
  const voltagePlots = [fan("front voltage", 0), fan("back voltage", 1)];
  addPlot({ title: "travel error", unit: "deg", lines, range: [-0.1, 0.1] }, { value: (x, _, k) => deg(x[0] - reference.x[k][0]) });

  // The controls

  const choices = {
    duration: { name: "duration", values: grid.durations.map((value) => `${value.toFixed(1)} s`) },
    pitch: { name: "pitch limit", values: grid.pitch_limits_deg.map((value) => `±${value}°`) },
    window: { name: "voltage window", values: grid.windows.map(([low, high]) => `${low} to ${high} V`) },
    startOff: { name: "start off by", values: Array.from({ length: 11 }, (_, value) => `${value}°`) },
  };
  const sliders = Object.fromEntries(
    Object.entries(choices).map(([id, { name, values }]) => {
      const key = id as keyof typeof asked;
      const input = make("input", { type: "range", id, min: 0, max: values.length - 1, step: 1 });
      const output = make("output", { for: id });
      const show = () => {
        input.value = `${asked[key]}`;
        input.setAttribute("aria-valuetext", values[asked[key]]);
        output.textContent = values[asked[key]];
      };
      input.addEventListener("input", () => {
        asked[key] = Number(input.value);
        show();
        replan();
      });
      show();
      return [id, { show, row: make("div", { class: "slider" }, make("label", { for: id }, name), output, input) }];
    }),
  );
  const showSliders = () => Object.values(sliders).forEach(({ show }) => show());
  const message = make("p", { class: "message", role: "status", hidden: true });
  const remedy = make("button", { hidden: true });
  remedy.addEventListener("click", () => {
    asked.duration = shortest();
    showSliders();
    replan();
  });
  const papersButton = make("button", { click: () => {
    Object.assign(asked, papers);
    showSliders();
    replan();
  } }, "the paper's values");

  const toggles = data.policies.map(({ label }, i) => {
    const box = make("input", { type: "checkbox", checked: enabled[i], id: `policy-${i}` });
    box.addEventListener("change", () => enable(i, box.checked));
    return { box, label: make("label", { style: `--colour:${colours[i]}` }, box, label) };
  });
  const plantNote = make("p", { class: "small", role: "status" });
  const drawButton = make("button", { click: () => drawAnew() }, "another draw");
  const plantChoices = Object.keys(data.plants).map((name) => {
    const radio = make("input", { type: "radio", name: "plant", value: name, checked: name === plantName });
    radio.addEventListener("change", () => choosePlant(name));
    return make("label", {}, radio, make("span", {}, name));
  });
  const playButton = make("button", { class: "primary", id: "play", click: () => fly(!flying) });
  const restartButton = make("button", { click: () => restart() }, "Restart");
  const speedChoice = make("select", { "aria-label": "speed" }, ...SPEEDS.map((s) => make("option", { value: s, selected: s === 1 }, `${s}×`)));
  speedChoice.addEventListener("change", () => (speed = Number(speedChoice.value)));
  const clock = make("output", { class: "clock" });
  const pushButtons = PUSHES.map((push) => make("button", { class: "push", click: () => shove(push.axis, push.acceleration) }, push.label));

  const group = (title: string, ...children: Node[]) => make("fieldset", {}, make("legend", {}, title), ...children);
  main.classList.add("live");
  main.append(
    make("header", {}, make("h1", {}, "3-DOF helicopter"), make("p", {}, "A 360° rotation between two points of rest, planned within limits and flown in your browser.")),
    stageElement,
    make("div", { class: "transport" }, playButton, restartButton, clock, make("span", { class: "pushes" }, make("span", {}, "push"), ...pushButtons), speedChoice),
    make("div", { class: "panels" }, ...plots.map(({ plot }) => plot.element)),
    make(
      "aside",
      {},
      group("Maneuver", ...["duration", "pitch", "window"].map((id) => sliders[id].row), message, remedy, papersButton),
      group("Flight", sliders.startOff.row, make("div", { class: "toggles" }, ...toggles.map(({ label }) => label))),
      group("Plant", make("div", { class: "segments" }, ...plantChoices), plantNote, drawButton),
      keyHelp([
        ["Space", "fly, pause"],
        ["R", "restart"],
        ["← →", "push the pitch"],
        ["↑ ↓", "lift, press the body"],
        ["1 2 3", "nominal, lab, rigid"],
        ["D", "another draw of the plant"],
        [POLICY_KEYS.join(" "), "show or hide each policy"],
      ]),
      make("p", { class: "small" }, "Pale helicopter and dashed lines: the reference. Shaded: beyond the limits of the plan. The start is off in travel and elevation."),
      meter.element,
    ),
  );
  const stage = makeStage(canvas, data.rig, parameters);

  // What happens

  function shortest(): number {
    return grid.plans[asked.pitch][asked.window].findIndex((found) => found !== null);
  }

  /** Plans what the sliders ask for, and starts again. */
  function replan(): void {
    const duration = grid.durations[asked.duration];
    const pitchLimit = (grid.pitch_limits_deg[asked.pitch] * Math.PI) / 180;
    const limits = { u: grid.windows[asked.window], pitch: [-pitchLimit, pitchLimit] as Pair };
    const found = grid.plans[asked.pitch][asked.window][asked.duration];
    message.hidden = remedy.hidden = found !== null;
    stageElement.classList.toggle("stale", found === null);
    if (!found) {
      const best = shortest();
      message.textContent =
        `No plan for ${choices.duration.values[asked.duration]} within ${choices.pitch.values[asked.pitch]} and ` +
        `${choices.window.values[asked.window]} was found` +
        (best < 0 ? "." : `; the shortest takes ${choices.duration.values[best]}.`);
      remedy.hidden = best < 0;
      remedy.textContent = best < 0 ? "" : `take ${choices.duration.values[best]}`;
      plan = null;
      fly(false);
      return;
    }
    plan = integratePlan(
      { duration, goal: data.goal, limits },
      [found.slice(0, data.kappa[0]), found.slice(data.kappa[0])],
      data.pitch_reserve,
      parameters,
      period / 2,
    );
    controllers = controllersAlong(plan, limits.pitch, data);
    const flown = controlGrid(plan);
    const last = flown.x.length - 1;
    const steps = last + Math.round(HOLD / period);
    const onGrid = Array.from({ length: steps + 1 }, (_, k) => Math.min(k, last));
    reference = { x: onGrid.map((k) => flown.x[k]), u: onGrid.map((k) => flown.middle[k]) };
    pitchPlot.setLimits(limits.pitch.map(deg) as Pair);
    voltagePlots.forEach((plot) => plot.setLimits(limits.u));
    plots.forEach(({ plot }) => plot.setDuration(period * steps));
    restart();
  }

  function restart(): void {
    if (plan === null) return;
    time = 0;
    pushes = [];
    flights = data.policies.map(() => null);
    catchUp();
    fly(true);
  }

  /** Every helicopter that is shown flies, from the start if it was not shown until now. */
  function catchUp(): void {
    const steps = Math.min(Math.ceil(time / period - 1e-9), reference.x.length - 1);
    const off = (asked.startOff * Math.PI) / 180;
    const start = reference.x[0].map((value, i) => value + (i === 0 ? -off : i === 2 ? off : 0));
    data.policies.forEach(({ name }, i) => {
      if (!enabled[i]) return;
      const controller = () => controllers[name](networks[data.network_for[plantName]]);
      const flight = (flights[i] ??= new Flight(controller(), plant, rules, start, voltages(hoverInput(0, p), p)));
      while (flight.x.length <= steps && !flight.crashed) flight.step(pushes);
    });
  }

  function fly(on: boolean): void {
    const over = time >= period * (reference.x.length - 1);
    flying = on && plan !== null;
    changed = true;
    if (flying && over && time > 0) {
      restart();
      return;
    }
    playButton.textContent = flying ? "Pause" : over && time > 0 ? "Fly again" : "Fly";
    playButton.disabled = plan === null;
  }

  function shove(axis: number, acceleration: number): void {
    const now = Math.max(0, ...flights.map((flight) => (flight ? flight.x.length - 1 : 0)));
    pushes = [...pushes, { axis, acceleration, time: now * period, duration: PUSH }];
  }

  function enable(i: number, on: boolean): void {
    enabled[i] = toggles[i].box.checked = on;
    if (!on) flights[i] = null;
    show(i, on);
    catchUp();
    changed = true;
  }

  function show(i: number, on: boolean): void {
    views[i].element.hidden = !on;
    plots.forEach(({ plot }) => plot.setVisible(i, on));
  }

  function choosePlant(name: string): void {
    plantName = name;
    const radio = main.querySelector<HTMLInputElement>(`input[value=${name}]`)!;
    radio.checked = true;
    drawPlant();
    restart();
  }

  function drawAnew(): void {
    draws += 1;
    drawPlant();
    restart();
  }

  function drawPlant(): void {
    plant = drawn(data.plants[plantName], generator(draws)) as Plant;
    const isRandom = JSON.stringify(plant) !== JSON.stringify(data.plants[plantName]);
    drawButton.hidden = !isRandom;
    const { rotors, friction } = plant;
    plantNote.textContent = isRandom
      ? `${PLANT_NOTES[plantName] ?? ""} Draw ${draws}: lag ${rotors.lag.toFixed(2)} s, thrust loss ${(100 * rotors.thrust_loss).toFixed(0)} %, ` +
        `friction ${friction.viscous.map((f) => f.toFixed(2)).join(", ")} 1/s.`
      : (PLANT_NOTES[plantName] ?? "");
    plantNote.append(` The residual policy was trained on ${data.network_for[plantName]}.`);
  }

  /** Redraws one plot. */
  function refresh(i: number): void {
    const { plot, value, nominal } = plots[i];
    const times = reference.x.map((_, k) => k * period);
    const flown = flights.map((flight) =>
      times.map((_, k) => (flight && k < flight.x.length ? value(flight.x[k], flight.u[Math.min(k, flight.u.length - 1)] ?? reference.u[0], k) : null)),
    );
    plot.show(times, nominal ? [...flown, reference.x.map((x, k) => value(x, reference.u[k], k))] : flown);
    plot.seek(time);
  }

  function draw(seconds: number): void {
    const end = period * (reference.x.length - 1);
    clock.textContent = `${shown(Math.min(time, end), 1)} s`;
    const ghost = between(reference.x, time / period);
    const poses: Pose[] = [];
    flights.forEach((flight, i) => {
      if (!flight) return;
      const sample = Math.min(time / period, flight.x.length - 1);
      const x = between(flight.x, sample);
      const note = flight.crashed && sample >= flight.x.length - 1 ? `beyond ±${deg(data.pitch_stop).toFixed(0)}° of pitch: the flight ended` : "";
      const u = flight.u[Math.min(Math.floor(sample), flight.u.length - 1)] ?? flight.rotors;
      views[i].show(x, u, note);
      poses.push({ element: views[i].element, colour: colours[i], x, u: note ? [0, 0] : flight.rotors, ghost });
    });
    stage?.draw(poses, seconds);
  }

  let last = performance.now();
  let turn = 0;
  function frame(now: number): void {
    const seconds = Math.min(Math.max((now - last) / 1000, 0), 0.1);
    last = now;
    meter.measure(() => {
      if (flying) {
        time = Math.min(time + speed * seconds, period * (reference.x.length - 1));
        catchUp();
        if (time >= period * (reference.x.length - 1)) fly(false);
      }
      if (!flying && !changed && !stage?.moved) return;
      changed = false;
      draw(flying ? speed * seconds : 0);
      // One plot per frame: each is redrawn ten times a second.
      if (flying) refresh(turn++ % plots.length);
      else if (plan) plots.forEach((_, i) => refresh(i));
    });
    requestAnimationFrame(frame);
  }

  window.addEventListener("keydown", (event) => {
    if (isForControl(event)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const push = PUSHES.find((candidate) => candidate.key === key);
    const chosenPlant = Object.keys(data.plants)[Number(key) - 1];
    const policy = POLICY_KEYS.indexOf(key);
    if (push) shove(push.axis, push.acceleration);
    else if (key === " ") fly(!flying);
    else if (key === "r") restart();
    else if (key === "d" && !drawButton.hidden) drawAnew();
    else if (chosenPlant) choosePlant(chosenPlant);
    else if (toggles[policy]) enable(policy, !enabled[policy]);
    else return;
    event.preventDefault();
  });

  enabled.forEach((on, i) => show(i, on));
  drawPlant();
  replan();
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) fly(false);
  requestAnimationFrame(frame);
}

/** The state at a sample that may lie between two. */
function between(states: number[][], sample: number): number[] {
  const k = Math.min(Math.floor(sample), states.length - 1);
  const next = states[Math.min(k + 1, states.length - 1)];
  return states[k].map((value, i) => value + (sample - k) * (next[i] - value));
}

/** Uniform numbers in [0, 1) from a seed (mulberry32). */
function generator(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
