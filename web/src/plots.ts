// Plots over time: uPlot with limits as shaded bands, a playhead that the keyboard moves too, and values that follow it.

import uPlot from "uplot";
import { make, onTheme, printing, shown, themed } from "./dom";
import { dashOf, shapeOf, swatch } from "./marks";

export interface Line {
  label: string;
  colour: string; // "" is that of the text
  dashed?: boolean;
  held?: boolean; // from each sample to the next
  mark?: number; // index of the policy, whose marker and dashes it has
}

export interface PlotOptions {
  title: string;
  unit: string;
  lines: Line[];
  limits?: readonly [number, number]; // what is beyond is shaded
  range?: readonly [number, number]; // to be shown at least
  duration: number; // s
  digits?: number;
  onTime?: (time: number) => void; // where the reader clicks
  sync?: string; // plots with the same key share cursor and zoom
}

export const LIMIT = "#D55E00";
const FONT = "11px system-ui, sans-serif";
const MARKS = 7; // markers on a line
const MARK_SIZE = 3.6; // px

const groups = new Map<string, Plot[]>();

/** One panel: a heading with the values at the playhead, and the plot. */
export class Plot {
  readonly element: HTMLElement;
  private readonly place: HTMLElement;
  private readonly values: HTMLElement[];
  private readonly playhead = make("div", { class: "playhead" });
  private readonly plot: uPlot;

  constructor(readonly options: PlotOptions) {
    const { title, unit, lines, duration, sync, onTime } = options;
    const heading = `${title} (${unit})`;
    this.values = lines.map(({ colour, label, mark, dashed }) => {
      const sign = mark === undefined ? make("i", { class: dashed ? "line dashed" : "line", style: `--colour:${colour || "var(--ink)"}` }) : swatch(mark, colour);
      return make("span", { title: label, class: "value" }, sign, make("b"));
    });
    const keys = { tabindex: 0, role: "slider", "aria-label": heading, "aria-valuemin": 0, "aria-valuemax": duration, "aria-valuenow": 0, "aria-valuetext": "" };
    this.place = make("div", { class: "plot", ...(onTime ? keys : { role: "img", "aria-label": heading }) });
    this.element = make("figure", {}, make("figcaption", {}, make("span", {}, heading), make("span", { class: "readout" }, ...this.values)), this.place);

    const axis = {
      stroke: () => themed("soft"),
      font: FONT,
      grid: { stroke: () => themed("grid"), width: 1 },
      ticks: { stroke: () => themed("grid"), width: 1, size: 4 },
    };
    const stepped = uPlot.paths.stepped!({ align: 1 });
    this.plot = new uPlot(
      {
        width: 320,
        height: 150,
        legend: { show: false },
        padding: [8, 18, 0, 0],
        cursor: {
          points: { show: false },
          y: false,
          drag: { x: sync !== undefined, y: false },
          ...(sync && { sync: { key: sync, scales: ["x", null] } }),
        },
        scales: {
          x: { time: false, range: (_, low, high) => (Number.isFinite(low) && low < high ? [low, high] : [0, duration]) },
          y: { range: (_, low, high) => this.visible(low ?? 0, high ?? 0, options.range ?? options.limits) },
        },
        axes: [
          { ...axis, size: 26, gap: 3, values: (_, ticks) => ticks.map((tick) => (tick === ticks.at(-1) ? `${tick} s` : `${tick}`)) },
          { ...axis, size: 46, gap: 3, values: (_, ticks) => ticks.map((tick) => `${Number(tick.toPrecision(6))}`.replace("-", "\u2212")) },
        ],
        series: [
          {},
          ...lines.map(({ label, colour, dashed, held, mark }) => ({
            label,
            stroke: () => colour || themed("ink"),
            width: dashed ? 1.25 : 1.6,
            points: { show: false },
            ...(dashed ? { dash: [5, 4] } : mark !== undefined && { dash: dashOf(mark) }),
            ...(held && { paths: stepped }),
          })),
        ],
        hooks: {
          drawClear: [(plot) => options.limits && shade(plot, options.limits)],
          draw: [(plot) => lines.forEach((line, i) => line.mark !== undefined && drawMarks(plot, i + 1, line))],
          setScale: [(plot, key) => key === "x" && this.zoomGroup(plot)],
          setSize: [() => this.seek(this.time)],
        },
      },
      [[0, duration], ...lines.map(() => [null, null])] as uPlot.AlignedData,
      this.place,
    );
    this.plot.over.append(this.playhead);
    if (onTime) {
      this.plot.over.addEventListener("click", (event) => {
        const { left } = this.plot.over.getBoundingClientRect();
        onTime(this.plot.posToVal(event.clientX - left, "x"));
      });
      this.place.addEventListener("keydown", (event) => this.key(event, onTime));
    }
    if (sync) groups.set(sync, [...(groups.get(sync) ?? []), this]);
    const fit = () => printing() || this.plot.setSize({ width: this.place.clientWidth, height: this.place.clientHeight });
    new ResizeObserver(fit).observe(this.place);
    onTheme(() => this.plot.redraw(false));
  }

  private time = 0;

  /** The picture, for what copies it. */
  get canvas(): HTMLCanvasElement {
    return this.plot.ctx.canvas;
  }

  /** Times (K,) in s and one array of values per line. */
  show(times: number[], values: (number | null)[][]): void {
    const [{ min, max }] = [this.plot.scales.x];
    this.plot.setData([times, ...values] as uPlot.AlignedData, false);
    this.plot.setScale("x", { min: min ?? 0, max: max ?? this.options.duration });
  }

  /** The whole of a flight of another duration. */
  setDuration(duration: number): void {
    this.options.duration = duration;
    this.place.setAttribute("aria-valuemax", `${duration}`);
    this.plot.setScale("x", { min: 0, max: duration });
  }

  setLimits(limits: readonly [number, number]): void {
    this.options.limits = limits;
  }

  setRange(range: readonly [number, number]): void {
    this.options.range = range;
  }

  setVisible(line: number, visible: boolean): void {
    this.plot.setSeries(line + 1, { show: visible });
    this.values[line].hidden = !visible;
  }

  /** Puts the playhead, and the values under the heading, to a time in s. */
  seek(time: number): void {
    this.time = time;
    const { left, width } = this.plot.bbox;
    const x = this.plot.valToPos(time, "x");
    this.playhead.style.transform = `translateX(${x}px)`;
    this.playhead.hidden = !(x >= 0 && x <= width / devicePixelRatio + 1) || left === 0;
    const [times, ...lines] = this.plot.data;
    let k = 0;
    if (times.length > 1) k = Math.min(Math.max(Math.round((time - times[0]) / (times[1] - times[0])), 0), times.length - 1);
    lines.forEach((line, i) => {
      const value = line[k];
      const text = value == null ? "–" : shown(value, this.options.digits ?? 1);
      const place = this.values[i].lastElementChild!;
      if (place.textContent !== text) place.textContent = text;
    });
    if (document.activeElement === this.place) this.describe();
  }

  /** What the plot shows now, in words. */
  private describe(): void {
    const texts = this.values.flatMap((value) => (value.hidden ? [] : [`${value.title} ${value.textContent}`]));
    this.place.setAttribute("aria-valuenow", this.time.toFixed(2));
    this.place.setAttribute("aria-valuetext", `at ${this.time.toFixed(2)} s: ${texts.join(", ")} ${this.options.unit}`);
  }

  /** Arrows move the time, plus and minus zoom where that is possible. */
  private key(event: KeyboardEvent, onTime: (time: number) => void): void {
    const step = event.shiftKey ? 1 : 0.1;
    const { min, max } = this.plot.scales.x;
    const zoomed = (factor: number) => {
      const half = 0.5 * factor * ((max ?? 1) - (min ?? 0));
      const middle = Math.min(Math.max(this.time, half), Math.max(this.options.duration - half, half));
      this.plot.setScale("x", { min: Math.max(middle - half, 0), max: Math.min(middle + half, this.options.duration) });
    };
    const move = (time: number) => {
      this.time = Math.min(Math.max(time, 0), this.options.duration); // more keys may come before the next frame
      onTime(this.time);
    };
    const actions: Record<string, () => void> = {
      ArrowLeft: () => move(this.time - step),
      ArrowRight: () => move(this.time + step),
      Home: () => move(0),
      End: () => move(this.options.duration),
      ...(this.options.sync && { "+": () => zoomed(0.5), "=": () => zoomed(0.5), "-": () => zoomed(2), "0": () => zoomed(1e3) }),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    action();
    this.describe();
    event.preventDefault();
  }

  private visible(low: number, high: number, least?: readonly [number, number]): [number, number] {
    const from = Math.min(low, least?.[0] ?? low);
    const to = Math.max(high, least?.[1] ?? high);
    const margin = Math.max(0.07 * (to - from), 0.01);
    return [from - margin, to + margin];
  }

  private zoomGroup(plot: uPlot): void {
    const { min, max } = plot.scales.x;
    if (min == null || max == null) return;
    for (const other of groups.get(this.options.sync ?? "") ?? []) {
      const scale = other.plot?.scales.x;
      if (other !== this && scale && (scale.min !== min || scale.max !== max)) other.plot.setScale("x", { min, max });
    }
    this.seek(this.time);
  }
}

/** What is beyond the limits, and the limits themselves. */
function shade(plot: uPlot, limits: readonly [number, number]): void {
  const { ctx, bbox } = plot;
  const [low, high] = limits.map((limit) => Math.min(Math.max(plot.valToPos(limit, "y", true), bbox.top), bbox.top + bbox.height));
  ctx.save();
  ctx.fillStyle = `${LIMIT}17`;
  ctx.fillRect(bbox.left, bbox.top, bbox.width, high - bbox.top);
  ctx.fillRect(bbox.left, low, bbox.width, bbox.top + bbox.height - low);
  ctx.strokeStyle = `${LIMIT}99`;
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  for (const y of [low, high]) {
    ctx.moveTo(bbox.left, Math.round(y) + 0.5);
    ctx.lineTo(bbox.left + bbox.width, Math.round(y) + 0.5);
  }
  ctx.stroke();
  ctx.restore();
}

/** A few markers along a line, at other places than those of the other lines. */
function drawMarks(plot: uPlot, series: number, { mark = 0, colour }: Line): void {
  if (!plot.series[series].show) return;
  const { ctx, bbox } = plot;
  const { min, max } = plot.scales.x;
  const [times, values] = [plot.data[0], plot.data[series]];
  if (min == null || max == null || times.length < 2) return;
  const size = MARK_SIZE * devicePixelRatio;
  const shape = new Path2D(shapeOf(mark));
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.fillStyle = colour || themed("ink");
  for (let n = 0; n < MARKS; n++) {
    const time = min + ((n + 0.2 + 0.13 * mark) / MARKS) * (max - min);
    const value = values[Math.round((time - times[0]) / (times[1] - times[0]))];
    if (value == null) continue;
    ctx.save();
    ctx.translate(plot.valToPos(time, "x", true), plot.valToPos(value, "y", true));
    ctx.scale(size, size);
    ctx.fill(shape);
    ctx.restore();
  }
  ctx.restore();
}
