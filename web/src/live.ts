// The live page: the helicopter simulated here, flown by the policies side by side along a plan that is chosen here.

import { FrameMeter, View, deg, isForControl, keyHelp, make, onPrint, onTheme, shown } from "./dom";
import {
  EFFECTS,
  EFFECT_NAMES,
  type Effect,
  Experiment,
  type LiveData,
  type Log,
  type Setup,
  WEIGHTS,
  durationOf,
  effectsOf,
  gridOf,
  initialSetup,
  limitsOf,
  placeOf,
  plantOf,
  rigOf,
  snapped,
  storedPlan,
} from "./experiment";
import { oneSecondAhead, parseLog, save, toCsv, toPicture } from "./files";
import type { Flight } from "./flight";
import { fromHash, toHash } from "./link";
import { swatch } from "./marks";
import type { Pair } from "./model";
import { PaperFigures } from "./paper";
import type { Push } from "./plant";
import { Plot, type PlotOptions } from "./plots";
import { type Pose, makeStage } from "./rig";
import { TaskList } from "./tasks";

const SPEEDS = [0.25, 0.5, 1, 2, 4];
const PUSH = 0.1; // s
const PUSHES = [ // rad/s²
  { label: "◀ pitch", key: "ArrowLeft", axis: 2, acceleration: -6 },
  { label: "pitch ▶", key: "ArrowRight", axis: 2, acceleration: 6 },
  { label: "▲ lift", key: "ArrowUp", axis: 1, acceleration: -3 },
  { label: "▼ press", key: "ArrowDown", axis: 1, acceleration: 3 },
];
const DRAG = { perPixel: 0.05, most: 8 }; // rad/s²
const PLANT_KEYS = ["1", "2", "3", "4"];
const POLICY_KEYS = ["5", "6", "7", "8", "9", "0"];
const PLANT_NOTES: Record<string, string> = {
  nominal: "Equation (3), exactly: what the controllers assume.",
  lab: "(3) with rotor lag, friction, thrust loss, a delay, and encoders.",
  rigid: "The full rigid body, with the rotors, friction and encoders of lab.",
  fleet: "Rigs of measured flights: uneven rotors, drifting thrust, wrong sensor zeros, a table.",
};

type SliderId = "duration" | "pitch" | "window" | "startOff";

export function showLive(data: LiveData, main: HTMLElement): void {
  const period = data.control_period;
  const still = matchMedia("(prefers-reduced-motion: reduce)"); // then, nothing flies by itself
  const colours = data.policies.map(({ colour }) => colour);
  const opened = fromHash(location.hash, data);
  let setup = opened.setup;
  const enabled = data.policies.map(({ name }) => opened.shown.includes(name));
  let experiment: Experiment | null = null;
  let log: Log | null = null;
  let flights: (Flight | null)[] = [];
  let pushes: Push[] = [];
  let drag: Pair = [0, 0]; // rad/s² on pitch and elevation, while the body is dragged
  let time = 0;
  let flying = false;
  let changed = true; // whether something is to be drawn although nothing flies
  let speed = 1;

  // The stage and the plots

  const views = data.policies.map(({ label }, i) => new View(label, colours[i], i));
  const canvas = make("canvas", {
    tabindex: 0,
    role: "application",
    "aria-label": "helicopters in 3D: drag or use the arrow keys to look from elsewhere, drag a body to push it; the numbers are below each",
  });
  const stageElement = make("div", { class: "stage" }, canvas, ...views.map((view) => view.element));
  const meter = new FrameMeter();
  const lines = data.policies.map(({ label }, i) => ({ label, colour: colours[i], mark: i }));
  const planLine = { label: "plan", colour: "", dashed: true };
  const plots: { plot: Plot; value: (x: number[], u: Pair, k: number) => number; planned?: boolean }[] = [];
  const seek = (at: number) => {
    flush();
    fly(false);
    time = Math.min(Math.max(at, 0), end());
    catchUp();
    if (time >= end()) complete();
    changed = true;
  };
  const addPlot = (options: Omit<PlotOptions, "duration">, entry: Omit<(typeof plots)[number], "plot">) => {
    const plot = new Plot({ ...options, duration: 1, onTime: seek });
    plots.push({ plot, ...entry });
    return plot;
  };
  const angle = (name: string, i: number, unit = "deg") =>
    addPlot({ title: name, unit, lines: [...lines, planLine], ...(i === 4 && { limits: [0, 0] }) }, { value: (x) => deg(x[i]), planned: true });
  const held = lines.map((line) => ({ ...line, held: true }));
  const fan = (name: string, i: 0 | 1) =>
    addPlot({ title: name, unit: "V", lines: [...held, planLine], limits: [0, 0], range: [0, 12] }, { value: (_, u) => u[i], planned: true });
  angle("travel", 0);
  angle("elevation", 2, "deg, positive down");
  const pitchPlot = angle("pitch", 4);
  const voltagePlots = [fan("front voltage", 0), fan("back voltage", 1)];
  addPlot({ title: "travel error", unit: "deg", lines, range: [-0.1, 0.1] }, { value: (x, _, k) => deg(x[0] - experiment!.reference.x[k][0]) });
  const paper = new PaperFigures(data.policies, period, lines, seek);

  // The controls: each is drawn from the setup, and changes it

  const shows: (() => void)[] = []; // of the controls
  const slider = (id: string, name: string, range: () => { min: number; max: number; step: number; value: number; text: string }, set: (value: number) => void) => {
    const input = make("input", { type: "range", id });
    const output = make("output", { for: id });
    const show = () => {
      const { min, max, step, value, text } = range();
      Object.assign(input, { min: `${min}`, max: `${max}`, step: `${step}` });
      input.value = `${value}`;
      input.setAttribute("aria-valuetext", text);
      output.textContent = text;
    };
    input.addEventListener("input", () => {
      set(Number(input.value));
      soon();
    });
    shows.push(show);
    return make("div", { class: "slider" }, make("label", { for: id }, name), output, input);
  };
  const grid = () => gridOf(rigOf(data, setup.rig), setup.method);
  const places = () => ({ ...placeOf(setup, grid()), startOff: setup.startOff });
  const texts = {
    duration: () => {
      const takes = durationOf(setup, data);
      return setup.duration === null ? `fastest${takes === null ? "" : `, ${takes.toFixed(2)} s`}` : `${setup.duration.toFixed(1)} s`;
    },
    pitch: () => `±${setup.pitchLimit}°`,
    window: () => `${volts(setup.window[0])} to ${volts(setup.window[1])} V`,
    startOff: () => `${setup.startOff}°`,
  };
  const choiceSlider = (id: SliderId, name: string, count: () => number, set: (index: number) => void) =>
    slider(id, name, () => ({ min: 0, max: count() - 1, step: 1, value: places()[id], text: texts[id]() }), set);
  const change = (part: Partial<Setup>) => (setup = { ...setup, ...part });
  const rigChoice = make("select", { id: "rig" }, ...data.rigs.map(({ name }) => make("option", { value: name }, name)));
  const rigNote = make("p", { class: "small" });
  rigChoice.addEventListener("change", () => {
    const fresh = initialSetup(data, rigOf(data, rigChoice.value));
    setup = snapped({ ...fresh, startOff: setup.startOff, plant: setup.plant, draw: setup.draw, weights: setup.weights }, data);
    log = null;
    apply();
  });
  const methodChoice = make("select", { id: "method" }, make("option", { value: "paper" }, "paper's, (38)"), make("option", { value: "spline" }, "splines"));
  methodChoice.addEventListener("change", () => {
    setup = snapped({ ...setup, method: methodChoice.value as Setup["method"] }, data);
    apply();
  });
  const message = make("p", { class: "message", role: "status", hidden: true });
  const remedy = make("button", { id: "remedy", hidden: true, click: () => {
    const better = shortest("spline");
    if (better) setup = better;
    apply();
  } });
  const papersButton = make("button", { click: () => {
    setup = { ...setup, ...limitsAtFirst() };
    apply();
  } }, "the paper's values");
  const limitsAtFirst = () => {
    const { method, duration, pitchLimit, window } = initialSetup(data, rigOf(data, setup.rig));
    return { method, duration, pitchLimit, window };
  };

  const toggles = data.policies.map(({ label }, i) => {
    const box = make("input", { type: "checkbox", id: `policy-${i}` });
    box.addEventListener("change", () => enable(i, box.checked));
    return { box, label: make("label", {}, box, swatch(i, colours[i]), label) };
  });
  const plantNote = make("p", { class: "small", role: "status", id: "plant-note" });
  const drawButton = make("button", { click: () => drawAnew() }, "another draw");
  const plantChoices = make("div", { class: "segments", role: "radiogroup", "aria-label": "plant" });
  const effectSliders = EFFECT_NAMES.map((name) => {
    const { name: text, unit, digits, min, max, step } = EFFECTS[name];
    const value = () => effectsOf(plantOf(setup, data).plant)[name];
    return slider(name, text, () => ({ min, max, step, value: value(), text: `${shown(value(), digits)} ${unit}` }), (set) => change({ effects: { ...setup.effects, [name]: set } }));
  });
  const effectsReset = make("button", { click: () => {
    change({ effects: {} });
    apply();
  } }, "as drawn");
  const weightSliders = WEIGHTS.map((name) =>
    slider(`weight-${name}`, name === "effort" ? "effort (R)" : `${name} (Q)`,
      () => ({ min: -2, max: 2, step: 0.25, value: setup.weights[name], text: `× ${Number((10 ** setup.weights[name]).toPrecision(2))}` }),
      (value) => {
        change({ weights: { ...setup.weights, [name]: value } });
        enabled[data.policies.findIndex((policy) => policy.name === "yours")] = true;
      }),
  );
  const tasks = new TaskList(data, (task) => {
    const first = initialSetup(data, data.rigs[0]);
    setup = snapped({ ...first, ...task.setup }, data);
    data.policies.forEach(({ name }, i) => (enabled[i] = task.policies.includes(name)));
    log = null;
    apply();
  });
  const playButton = make("button", { class: "primary", id: "play", click: () => fly(!flying) });
  const restartButton = make("button", { click: () => restart() }, "Restart");
  const speedChoice = make("select", { "aria-label": "speed", id: "speed" }, ...SPEEDS.map((s) => make("option", { value: s, selected: s === 1 }, `${s}×`)));
  speedChoice.addEventListener("change", () => (speed = Number(speedChoice.value)));
  const clock = make("output", { class: "clock" });
  const pushButtons = PUSHES.map((push) => make("button", { class: "push", click: () => shove(push.axis, push.acceleration) }, push.label));

  const fileNote = make("p", { class: "small", role: "status" });
  const fileInput = make("input", { type: "file", accept: ".csv,text/csv", id: "log", class: "hidden-file" });
  fileInput.addEventListener("change", () => {
    if (fileInput.files?.[0]) openLog(fileInput.files[0]);
    fileInput.value = ""; // or the browser would report no change when the same file is chosen again
  });
  const dropLog = make("button", { hidden: true, click: () => {
    log = null;
    apply();
  } }, "back to the plan");
  const linkButton = make("button", { click: async () => {
    // There is no clipboard on pages that came by plain http.
    await (navigator.clipboard?.writeText(location.href) ?? Promise.reject()).then(() => (fileNote.textContent = "The address of this flight is in the clipboard."), () => (fileNote.textContent = location.href));
  } }, "copy link");
  const csvButton = make("button", { id: "csv", click: () => {
    const flown = data.policies.flatMap(({ name }, i): [string, Flight][] => (flights[i] ? [[name, flights[i]]] : []));
    if (experiment) save("flight.csv", new Blob([toCsv(flown, experiment.reference, period)], { type: "text/csv" }));
  } }, "CSV");
  const pngButton = make("button", { id: "png", click: () => {
    draw(0); // what WebGL draws is there only until the browser shows it
    const picture = toPicture(canvas, views.flatMap(({ element }) => (element.hidden ? [] : [element])), plots.map(({ plot }) => plot), summary());
    picture.toBlob((blob) => blob && save("flight.png", blob));
  } }, "PNG");

  const group = (title: string, ...children: Node[]) => make("fieldset", {}, make("legend", {}, title), ...children);
  const folded = (title: string, ...children: Node[]) => make("details", {}, make("summary", {}, title), ...children);
  const planControls = make(
    "div",
    { class: "stack" },
    make("label", { class: "choice", for: "method" }, "plan by", methodChoice),
    choiceSlider("duration", "duration", () => grid().durations.length, (i) => change({ duration: grid().durations[i] })),
    choiceSlider("pitch", "pitch limit", () => grid().pitch_limits_deg.length, (i) => change({ pitchLimit: grid().pitch_limits_deg[i] })),
    choiceSlider("window", "voltage window", () => grid().windows.length, (i) => change({ window: grid().windows[i] })),
    message,
    remedy,
    papersButton,
  );
  main.classList.add("live");
  main.append(
    make("header", {}, make("h1", {}, "3-DOF helicopter"), make("p", {}, "A 360° rotation between two points of rest, planned within limits and flown in your browser.")),
    stageElement,
    make("div", { class: "transport" }, playButton, restartButton, clock, make("span", { class: "pushes" }, make("span", {}, "push"), ...pushButtons), speedChoice),
    make("div", { class: "panels" }, ...plots.map(({ plot }) => plot.element)),
    paper.element,
    make(
      "aside",
      {},
      group("Tasks", tasks.element),
      group("Rig and plan", make("label", { class: "choice", for: "rig" }, "rig", rigChoice), folded("where its numbers are from", rigNote), planControls),
      group("Flight", choiceSlider("startOff", "start off by", () => 11, (value) => change({ startOff: value })), make("div", { class: "toggles" }, ...toggles.map(({ label }) => label)),
        folded("your weights in (49)", make("p", { class: "small" }, "Factors on the paper's Q and R, for the policy “your weights”."), ...weightSliders)),
      group("Plant", plantChoices, plantNote, make("div", { class: "row" }, drawButton), folded("its effects, one by one", ...effectSliders, effectsReset)),
      group("Files", make("div", { class: "row" }, csvButton, pngButton, linkButton), make("label", { class: "file" }, "open a recorded flight (CSV)", fileInput), dropLog, fileNote),
      keyHelp([
        ["Space", "fly, pause"],
        ["R", "restart"],
        ["← →", "push the pitch; on a plot, move the time; on the 3D view, look around"],
        ["↑ ↓", "lift, press the body"],
        [PLANT_KEYS.join(" "), "nominal, lab, rigid, fleet"],
        ["D", "another draw of the plant"],
        [POLICY_KEYS.join(" "), "show or hide each policy"],
      ]),
      make("p", { class: "small" }, "Pale helicopter and dashed lines: the plan. Shaded: beyond its limits. The start is off in travel and elevation. Drag a body to push it."),
      meter.element,
    ),
  );
  const stage = makeStage(canvas, rigOf(data, setup.rig).body, rigOf(data, setup.rig).parameters);
  if (stage) {
    stage.onBodyDrag = (dx, dy) => {
      const limited = (pixels: number) => Math.min(Math.max(DRAG.perPixel * pixels, -DRAG.most), DRAG.most);
      drag = [limited(dx), limited(dy)];
      if (drag.some((value) => value !== 0) && !flying && time < end()) fly(true);
    };
  }

  // What happens

  const end = () => period * (experiment?.steps ?? 0);
  const summary = () => {
    const { rig, plant, startOff } = setup;
    const what = log ? `recorded flight ${log.name}` : `${texts.duration()}, pitch ${texts.pitch()}, ${texts.window()}`;
    return `rig ${rig}, plant ${plant}; ${what}; start off by ${startOff}°`;
  };

  /** The shortest plan of a method within the limits, as the page has it. */
  function shortest(method: Setup["method"]): Setup | null {
    for (const duration of gridOf(rigOf(data, setup.rig), method).durations) {
      const candidate = snapped({ ...setup, method, duration }, data);
      if (storedPlan(candidate, data)) return candidate;
    }
    return null;
  }

  let isDue = false;

  /** Applies the setup before the next frame: sliders change faster than plans and gains are computed. */
  function soon(): void {
    isDue = true;
    shows.forEach((show) => show());
  }

  function flush(): void {
    if (isDue) apply();
  }

  /** Brings the page in line with the setup, and starts again. */
  function apply(): void {
    isDue = false;
    const rig = rigOf(data, setup.rig);
    experiment = Experiment.make(setup, data, log);
    showChoices(rig);
    const none = experiment === null;
    message.hidden = remedy.hidden = !none;
    stageElement.classList.toggle("stale", none);
    link();
    if (none) {
      const [own, better] = [shortest(setup.method), shortest("spline")];
      const takes = better && durationOf(better, data)!;
      message.textContent = [
        `No plan for ${texts.duration()} within ${texts.pitch()} and ${texts.window()}`,
        setup.method === "paper" ? (own ? `: the paper's method finds none below ${durationOf(own, data)!.toFixed(1)} s` : ": the paper's method finds none") : "",
        takes === null ? "." : `; the fastest of the splines takes ${takes.toFixed(2)} s.`,
      ].join("");
      remedy.hidden = better === null;
      remedy.textContent = takes === null ? "" : `take the spline of ${takes.toFixed(2)} s`;
      fly(false);
      return;
    }
    stage?.setRig(rig.body, rig.parameters);
    const limits = limitsOf(setup);
    pitchPlot.setLimits(limits.pitch.map(deg) as Pair);
    voltagePlots.forEach((plot) => {
      plot.setLimits(limits.u);
      plot.setRange(rig.amplifier);
    });
    plots.forEach(({ plot }) => plot.setDuration(end()));
    paper.rebuild(experiment!, enabled);
    restart(!still.matches);
  }

  function link(): void {
    const names = data.policies.flatMap(({ name }, i) => (enabled[i] ? [name] : []));
    try {
      history.replaceState(null, "", toHash(setup, names, data) || location.pathname + location.search);
    } catch {
      // a page in a frame without an address of its own
    }
  }

  function showChoices(rig: (typeof data.rigs)[number]): void {
    shows.forEach((show) => show());
    rigChoice.value = rig.name;
    rigNote.textContent = rig.source || "from a file";
    methodChoice.value = setup.method;
    methodChoice.options[0].disabled = !rig.grids.paper;
    papersButton.textContent = rig.grids.paper ? "the paper's values" : "as at first";
    planControls.hidden = log !== null;
    dropLog.hidden = log === null;
    data.policies.forEach(({ name }, i) => {
      const offered = name !== "residual" || Object.values(rig.networks).some(({ learned }) => learned !== null);
      toggles[i].label.hidden = !offered;
      toggles[i].box.checked = enabled[i];
      show(i, enabled[i] && offered);
    });
    const offered = Object.keys(rig.plants);
    if (plantChoices.dataset.names !== offered.join()) {
      plantChoices.dataset.names = offered.join();
      plantChoices.replaceChildren(
        ...offered.map((name) => {
          const radio = make("input", { type: "radio", name: "plant", value: name });
          radio.addEventListener("change", () => choosePlant(name));
          return make("label", {}, radio, make("span", {}, name));
        }),
      );
    }
    for (const radio of plantChoices.querySelectorAll("input")) radio.checked = radio.value === setup.plant;
    const { plant, isRandom } = plantOf(setup, data);
    drawButton.hidden = !isRandom;
    effectsReset.hidden = Object.keys(setup.effects).length === 0;
    const effects = effectsOf(plant);
    const value = (name: Effect) => `${EFFECTS[name].name} ${shown(effects[name], EFFECTS[name].digits)} ${EFFECTS[name].unit}`;
    plantNote.textContent =
      (PLANT_NOTES[setup.plant] ?? "") +
      (isRandom ? ` Draw ${setup.draw}: ${EFFECT_NAMES.filter((name) => Math.abs(effects[name]) > 1e-9).map(value).join(", ")}.` : "") +
      (rig.networks[rig.network_for[setup.plant]]?.learned ? ` The residual policy was trained on ${rig.network_for[setup.plant]}.` : "");
  }

  function restart(go = true): void {
    if (experiment === null) return;
    time = 0;
    pushes = [];
    flights = data.policies.map(() => null);
    catchUp();
    fly(go);
  }

  /** Every helicopter that is shown flies, from the start if it was not shown until now. */
  function catchUp(): void {
    if (experiment === null) return;
    const steps = Math.min(Math.ceil(time / period - 1e-9), experiment.steps);
    const flown = Math.max(0, ...flights.map((flight) => (flight ? flight.x.length - 1 : 0)));
    if (steps > flown) {
      drag.forEach((acceleration, i) => {
        if (acceleration !== 0) pushes = [...pushes, { axis: 2 - i, acceleration, time: flown * period, duration: (steps - flown) * period }];
      });
    }
    data.policies.forEach(({ name }, i) => {
      if (!enabled[i]) return;
      const flight = (flights[i] ??= experiment!.begin(name));
      while (flight && flight.x.length <= steps && !flight.crashed) flight.step(pushes);
    });
  }

  function fly(on: boolean): void {
    const over = time >= end();
    const isNew = on && over && time > 0;
    flying = on && experiment !== null;
    changed = true;
    if (flying && isNew) {
      restart();
      return;
    }
    playButton.textContent = flying ? "Pause" : over && time > 0 ? "Fly again" : "Fly";
    playButton.disabled = experiment === null;
  }

  /** The end of a flight that was flown to its end. */
  function complete(): void {
    fly(false);
    const flown = data.policies.flatMap(({ name }, i) => (flights[i] ? [[name, flights[i]] as const] : []));
    tasks.complete({ experiment: experiment!, flights: Object.fromEntries(flown), wasPushed: pushes.length > 0 });
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
    link();
    changed = true;
  }

  function show(i: number, on: boolean): void {
    views[i].element.hidden = !on;
    plots.forEach(({ plot }) => plot.setVisible(i, on));
    paper.setVisible(i, on);
  }

  function choosePlant(name: string): void {
    change({ plant: name, effects: {} });
    apply();
  }

  function drawAnew(): void {
    change({ draw: setup.draw + 1, effects: {} });
    apply();
  }

  async function openLog(file: File): Promise<void> {
    try {
      log = parseLog(await file.text(), file.name, period / 2);
    } catch (error) {
      fileNote.textContent = (error as Error).message;
      return;
    }
    data.policies.forEach(({ name }, i) => (enabled[i] = name === "open-loop"));
    change({ startOff: 0 });
    apply();
    const errors = oneSecondAhead(log, experiment!.plant, experiment!.rules);
    fileNote.textContent =
      `${file.name}: ${(log.step * (log.x.length - 1)).toFixed(1)} s. Dashed and pale: the record; “open loop”: the model under the recorded voltages. ` +
      `One second ahead, the model is off by ${["travel", "elevation", "pitch"].map((name, i) => `${shown(errors[i], 1)}° of ${name}`).join(", ")} (RMS).`;
  }

  /** Redraws one plot. */
  function refresh(i: number): void {
    const { plot, value, planned } = plots[i];
    const { x: xs, middle } = experiment!.reference;
    const times = xs.map((_, k) => k * period);
    const flown = flights.map((flight) =>
      times.map((_, k) => (flight && k < flight.x.length ? value(flight.x[k], flight.u[Math.min(k, flight.u.length - 1)] ?? middle[0], k) : null)),
    );
    plot.show(times, planned ? [...flown, xs.map((x, k) => value(x, middle[k], k))] : flown);
    plot.seek(time);
  }

  function draw(seconds: number): void {
    if (experiment === null) return;
    clock.textContent = `${shown(Math.min(time, end()), 1)} s`;
    const ghost = between(experiment.reference.x, time / period);
    const poses: Pose[] = [];
    flights.forEach((flight, i) => {
      if (!flight) return;
      const sample = Math.min(time / period, flight.x.length - 1);
      const x = between(flight.x, sample);
      const note = flight.crashed && sample >= flight.x.length - 1 ? `beyond ±${deg(experiment!.rules.pitchStop).toFixed(0)}° of pitch: the flight ended` : "";
      const u = flight.u[Math.min(Math.floor(sample), flight.u.length - 1)] ?? flight.rotors;
      views[i].show(x, u, note);
      poses.push({ element: views[i].element, colour: colours[i], x, u: note ? [0, 0] : flying ? flight.rotors : u, ghost });
    });
    stage?.draw(poses, seconds);
  }

  onPrint(stageElement, () => {
    fly(false);
    plots.forEach((_, i) => refresh(i));
    paper.refresh(flights, time, true);
    draw(0);
  });

  let last = performance.now();
  let turn = 0;
  function frame(now: number): void {
    const seconds = Math.min(Math.max((now - last) / 1000, 0), 0.1);
    last = now;
    meter.measure(() => {
      flush();
      if (flying) {
        time = Math.min(time + speed * seconds, end());
        catchUp();
        if (time >= end()) complete();
      }
      if (!flying && !changed && !stage?.moved) return;
      const all = !flying && changed;
      changed = false;
      draw(flying ? speed * seconds : 0);
      if (experiment === null) return;
      // One plot per frame: each is redrawn several times a second.
      if (flying && turn++ % 2) refresh((turn >> 1) % plots.length);
      else if (flying) paper.refresh(flights, time, false);
      else if (all) {
        plots.forEach((_, i) => refresh(i));
        paper.refresh(flights, time, true);
      }
    });
    requestAnimationFrame(frame);
  }

  window.addEventListener("keydown", (event) => {
    if (isForControl(event)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const push = PUSHES.find((candidate) => candidate.key === key);
    const chosenPlant = Object.keys(rigOf(data, setup.rig).plants)[PLANT_KEYS.indexOf(key)];
    const policy = POLICY_KEYS.indexOf(key);
    if (push) shove(push.axis, push.acceleration);
    else if (key === " ") fly(!flying);
    else if (key === "r") restart();
    else if (key === "d" && !drawButton.hidden) drawAnew();
    else if (chosenPlant) choosePlant(chosenPlant);
    else if (toggles[policy] && !toggles[policy].label.hidden) enable(policy, !enabled[policy]);
    else return;
    event.preventDefault();
  });
  window.addEventListener("hashchange", () => {
    const found = fromHash(location.hash, data);
    setup = found.setup;
    data.policies.forEach(({ name }, i) => (enabled[i] = found.shown.includes(name)));
    log = null;
    apply();
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) openLog(file);
  });
  onTheme(() => (changed = true));
  main.dataset.ready = "";

  apply();
  requestAnimationFrame(frame);
}

const volts = (value: number) => shown(value, Number.isInteger(value) ? 0 : 1);

/** The state at a sample that may lie between two. */
function between(states: number[][], sample: number): number[] {
  const k = Math.min(Math.floor(sample), states.length - 1);
  const next = states[Math.min(k + 1, states.length - 1)];
  return states[k].map((value, i) => value + (sample - k) * (next[i] - value));
}
