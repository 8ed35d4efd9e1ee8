// The report of an evaluation: its table, and its flights to look at in 3D and in plots.

import { FrameMeter, View, deg, isForControl, keyHelp, make, onPrint, onTheme, scrollable, shown } from "./dom";
import { Histograms } from "./histogram";
import type { RigidBody } from "./equations";
import { type Model, type Pair, inputAt, thrustBounds } from "./model";
import { swatch } from "./marks";
import { Plot, type PlotOptions } from "./plots";
import { type Pose, makeStage } from "./rig";
import { SetPlot } from "./sets";

/** States (6 x K) in rad and rad/s and voltages (2 x K) in V, `step` s apart. */
interface Samples {
  x: number[][];
  u: number[][];
}

interface Group {
  label: string;
  step: number;
  reference: Samples;
  flights: ((Samples & { ended: string }) | null)[]; // one per policy; null where it has not flown
  draw: [string, string][]; // parameters of the plant
  errors: (number | null)[]; // deg, one per policy
}

export interface ReportData {
  title: string;
  subtitle: string;
  table: { title: string; caption: string; columns: string[]; rows: string[][] };
  policies: string[];
  labels: string[];
  colours: string[];
  errors: number[][]; // deg, of all episodes, one array per policy
  groups: Group[];
  gains: { step: number; K: number[][][] } | null; // 2 x 6 x K
  limits: { u: Pair; pitch: Pair };
  amplifier: Pair;
  parameters: Model;
  rig: RigidBody;
}

type Lines = "flights" | "gains" | number; // one line per policy, none, or all of one policy
const SPEEDS = [0.25, 0.5, 1, 2, 4];
const ANGLES = ["travel", "elevation", "pitch"];
const GAIN_COLOURS = ["#0072B2", "#56B4E9", "#009E73", "#E69F00", "#CC79A7", "#7A5195"];
const GAIN_LABELS = ["travel", "travel rate", "elevation", "elevation rate", "pitch", "pitch rate"];

export function showReport(data: ReportData, main: HTMLElement): void {
  const { policies, labels, colours, parameters, limits } = data;
  const durations = data.groups.map(({ reference, step }) => step * (reference.x[0].length - 1));
  const visible = policies.map(() => true);
  let group = data.groups[0];
  let duration = durations[0];
  let time = 0;
  let playing = false;
  let speed = 1;

  // The table

  const table = make(
    "table",
    {},
    make("thead", {}, make("tr", {}, ...data.table.columns.map((name) => make("th", { scope: "col" }, name)))),
    make(
      "tbody",
      {},
      ...data.table.rows.map((row, n) =>
        make(
          "tr",
          n > 0 && row[0] !== data.table.rows[n - 1][0] ? { class: "section" } : {},
          ...row.map((cell, i) => {
            const known = i === 1 ? policies.indexOf(cell) : -1;
            if (known < 0) return make("td", {}, cell);
            return make("td", { title: cell }, swatch(known, colours[known]), labels[known]);
          }),
        ),
      ),
    ),
  );

  // The stage

  const views = policies.map((_, i) => new View(labels[i], colours[i], i));
  const canvas = make("canvas", { tabindex: 0, role: "application", "aria-label": "the flights in 3D; drag, or use the arrow keys, to look from elsewhere" });
  const stageElement = make("div", { class: "stage" }, canvas, ...views.map((view) => view.element));
  const meter = new FrameMeter();

  // The plots

  const reference = { label: "plan", colour: "", dashed: true };
  const flown = labels.map((label, i) => ({ label, colour: colours[i], mark: i }));
  const fans = ["front", "back"];
  const common = { duration, sync: "report", onTime: (at: number) => seek(at) };
  const plots: { plot: Plot; values: () => (number | null)[][]; lines: Lines }[] = [];
  const addPlot = (options: Omit<PlotOptions, "duration">, values: () => (number | null)[][], lines: Lines = "flights") => {
    const plot = new Plot({ ...common, ...options });
    plots.push({ plot, values, lines });
    return plot.element;
  };
  const padded = (values: number[]): (number | null)[] =>
    group.reference.x[0].map((_, k) => (k < values.length ? values[k] : null));
  const toDegrees = (values: number[]) => padded(values.map(deg));
  const pitchLimits = limits.pitch.map(deg) as Pair;
  const panels = ANGLES.flatMap((name, i) => [
    addPlot(
      { title: name, unit: i === 1 ? "deg, positive down" : "deg", lines: [...flown, reference], ...(i === 2 && { limits: pitchLimits }) },
      () => [...group.flights.map((flight) => toDegrees(flight?.x[2 * i] ?? [])), toDegrees(group.reference.x[2 * i])],
    ),
    addPlot({ title: `${name} error`, unit: i === 1 ? "deg, positive down" : "deg", lines: flown, digits: 2, range: [-0.01, 0.01] }, () =>
      group.flights.map((flight) => toDegrees((flight?.x[2 * i] ?? []).map((q, k) => q - group.reference.x[2 * i][k]))),
    ),
  ]);
  // voltages as small multiples: one panel per policy, the same axes in all
  const multiples = make(
    "div",
    { class: "multiples" },
    ...policies.map((_, i) =>
      addPlot(
        {
          title: labels[i],
          unit: "V",
          lines: [
            ...fans.map((label, n) => ({ label, colour: n === 0 ? colours[i] : "", held: true })),
            ...fans.map((label) => ({ label: `${label}, plan`, colour: "#7f8a97", dashed: true })),
          ],
          limits: limits.u,
          range: data.amplifier,
        },
        () => [...fans.map((_, n) => padded(group.flights[i]?.u[n] ?? [])), ...fans.map((_, n) => padded(group.reference.u[n]))],
        i,
      ),
    ),
  );
  const { gains } = data;
  if (gains) {
    const lines = GAIN_LABELS.map((label, i) => ({ label, colour: GAIN_COLOURS[i], mark: i }));
    panels.push(
      make(
        "div",
        { class: "legend wide" },
        ...GAIN_LABELS.map((label, i) => make("span", {}, swatch(i, GAIN_COLOURS[i]), label)),
      ),
      ...["thrust sum", "thrust difference"].map((title, row) =>
        addPlot(
          { title: `gains on the ${title}`, unit: "N/rad and N s/rad", lines, digits: 1 },
          () => gains.K[row].map((values) => group.reference.x[0].map((_, k) => at(values, (k * group.step) / gains.step))),
          "gains",
        ),
      ),
    );
  }

  // The sets

  const box = ([low, high]: Pair): Pair[] => [[low, low], [high, low], [high, high], [low, high]];
  const diamond = (window: Pair): Pair[] => {
    const [fMin, fMax] = thrustBounds(window, parameters);
    return [[0, 2 * fMin], [fMax - fMin, fMin + fMax], [0, 2 * fMax], [fMin - fMax, fMin + fMax]];
  };
  const sets = [
    new SetPlot({
      title: "voltages, (6)",
      axes: ["front voltage (V)", "back voltage (V)"],
      corners: box(limits.u),
      outer: box(data.amplifier),
      ticks: [[0, 3, 6, 9, 12], [0, 3, 6, 9, 12]],
      colours,
    }),
    new SetPlot({
      title: "virtual inputs, (17)–(20)",
      axes: ["thrust difference v2 (N)", "thrust sum v1 (N)"],
      corners: diamond(limits.u),
      outer: diamond(data.amplifier),
      ticks: [[-0.6, -0.3, 0, 0.3, 0.6], [0, 0.4, 0.8, 1.2]],
      colours,
    }),
  ];

  // The controls

  const histograms = data.errors.some((own) => own.length > 1) ? new Histograms(data.errors, labels, colours) : null;
  const drawList = make("dl", { class: "draw" });
  const slider = make("input", { type: "range", class: "time", min: 0, max: duration, step: 0.01, value: 0, "aria-label": "time", id: "time" });
  const clock = make("output", { for: "time" });
  const playButton = make("button", { class: "primary", click: () => play(!playing) }, "Play");
  const speedChoice = make("select", { "aria-label": "speed" }, ...SPEEDS.map((s) => make("option", { value: s, selected: s === 1 }, `${s}×`)));
  const groupChoice = make("select", { "aria-label": "flights" }, ...data.groups.map(({ label }, i) => make("option", { value: i }, label)));
  const legend = make(
    "div",
    { class: "legend" },
    ...policies.map((policy, i) => {
      const box = make("input", { type: "checkbox", checked: true });
      box.addEventListener("change", () => setVisible(i, box.checked));
      return make("label", { title: policy }, box, swatch(i, colours[i]), labels[i]);
    }),
    make("span", { class: "line dashed" }, "plan"),
  );
  slider.addEventListener("input", () => seek(Number(slider.value)));
  speedChoice.addEventListener("change", () => (speed = Number(speedChoice.value)));
  groupChoice.addEventListener("change", () => choose(Number(groupChoice.value)));

  main.append(
    make("header", {}, make("h1", {}, data.title), make("p", {}, data.subtitle)),
    make("section", {}, make("h2", {}, "Results"), make("p", {}, data.table.title), scrollable("results", table), make("p", { class: "small" }, data.table.caption)),
    make("section", {}, make("h2", {}, "Flights"), make("div", { class: "bar" }, make("label", {}, "flights ", groupChoice), legend), stageElement, drawList),
    ...(histograms === null
      ? []
      : [make("section", {}, make("h2", {}, "RMS error over all episodes (deg)"), histograms.element, make("p", { class: "small" }, "Travel and elevation together, on a logarithmic axis; the line marks the flight that is shown."))]),
    make(
      "section",
      {},
      make("div", { class: "panels" }, ...panels, ...sets.map((set) => set.element)),
      make("h2", {}, "Voltages"),
      make("p", { class: "small" }, "Coloured: front motor; black: back motor; dashed: the plan."),
      multiples,
      make("p", { class: "small" }, "Shaded: beyond the limits of the plan. Drag across a plot to zoom, double-click to see all, click to go to a time."),
    ),
    make(
      "footer",
      {},
      keyHelp([["Space", "play, pause"], ["← →", "0.1 s back, forwards (with Shift 1 s); on the 3D view, look around"], ["Home End", "to the start, to the end"], ["1 2", "first, second choice of flights"], ["+ - 0", "on a plot: zoom in, out, show all"]]),
      meter.element,
    ),
    make("div", { class: "transport" }, playButton, slider, clock, speedChoice),
  );
  const stage = makeStage(canvas, data.rig, parameters);

  // What happens

  function setVisible(i: number, on: boolean): void {
    visible[i] = on;
    showLines();
    draw(0);
  }

  function showLines(): void {
    policies.forEach((_, i) => {
      const on = visible[i] && group.flights[i] !== null;
      views[i].element.hidden = !on;
      for (const { plot, lines } of plots) {
        if (lines === "flights") plot.setVisible(i, on);
        else if (lines === i) plot.element.hidden = !on;
      }
      for (const set of sets) set.setVisible(i, on);
      histograms?.setVisible(i, visible[i] && data.errors[i].length > 0);
    });
  }

  function choose(index: number): void {
    group = data.groups[index];
    duration = durations[index];
    groupChoice.value = `${index}`;
    slider.max = `${duration}`;
    const times = group.reference.x[0].map((_, k) => k * group.step);
    for (const { plot, values } of plots) plot.show(times, values());
    const pairs = group.flights.map((flight) => (flight?.u[0] ?? []).map((front, k): Pair => [front, flight!.u[1][k]]));
    sets[0].show(pairs);
    sets[1].show(pairs.map((path) => path.map((u) => inputAt(u, parameters).reverse() as Pair)));
    drawList.replaceChildren(...group.draw.map(([name, value]) => make("div", {}, make("dt", {}, name), make("dd", {}, value))));
    drawList.hidden = group.draw.length === 0;
    histograms?.mark(group.errors);
    showLines();
    seek(Math.min(time, duration));
  }

  function seek(at: number, seconds = 0): void {
    time = Math.min(Math.max(at, 0), duration);
    slider.value = `${time}`;
    clock.textContent = `${shown(time, 2)} s`;
    for (const { plot } of plots) plot.seek(time);
    for (const set of sets) set.seek(Math.round(time / group.step));
    draw(seconds);
  }

  function draw(seconds: number): void {
    const sample = time / group.step;
    const poses: Pose[] = [];
    const ghost = group.reference.x.map((values) => at(values, sample));
    group.flights.forEach((flight, i) => {
      if (flight === null) return;
      const last = flight.x[0].length - 1;
      const x = flight.x.map((values) => at(values, sample));
      const u = flight.u.map((values) => values[Math.min(Math.floor(sample), last)]) as Pair;
      views[i].show(x, u, sample > last ? flight.ended : "");
      if (visible[i]) poses.push({ element: views[i].element, colour: colours[i], x, u, ghost });
    });
    stage?.draw(poses, seconds);
  }

  function play(on: boolean): void {
    if (on && time >= duration) time = 0;
    playing = on;
    playButton.textContent = on ? "Pause" : "Play";
  }

  onPrint(stageElement, () => {
    play(false);
    draw(0);
  });

  let last = performance.now();
  function frame(now: number): void {
    const seconds = Math.min(Math.max((now - last) / 1000, 0), 0.1);
    last = now;
    meter.measure(() => {
      if (playing) seek(time + speed * seconds, speed * seconds);
      else if (stage?.moved) draw(0);
    });
    if (playing && time >= duration) play(false);
    requestAnimationFrame(frame);
  }

  window.addEventListener("keydown", (event) => {
    if (isForControl(event)) return;
    const step = event.shiftKey ? 1 : 0.1;
    const actions: Record<string, () => void> = {
      " ": () => play(!playing),
      ArrowLeft: () => seek(time - step),
      ArrowRight: () => seek(time + step),
      Home: () => seek(0),
      End: () => seek(duration),
    };
    const chosen = Number(event.key) - 1;
    if (data.groups[chosen]) choose(chosen);
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
  });
  onTheme(() => draw(0));
  choose(0);
  requestAnimationFrame(frame);
}

/** The value at a sample that may lie between two; the ends are held. */
function at(values: number[], sample: number): number {
  const k = Math.min(Math.max(Math.floor(sample), 0), values.length - 1);
  const next = Math.min(k + 1, values.length - 1);
  const share = Math.min(Math.max(sample - k, 0), 1);
  return (1 - share) * values[k] + share * values[next];
}
