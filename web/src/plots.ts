// Plots over time: uPlot with limits as shaded bands, one playhead, and values that follow it.

import uPlot from "uplot";
import { shown } from "./dom";

export interface Line {
  label: string;
  colour: string;
  dashed?: boolean;
  held?: boolean; // from each sample to the next
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

const INK = "#5d6876";
const GRID = "#e6eaef";
export const LIMIT = "#D55E00";
const FONT = "11px system-ui, sans-serif";

const groups = new Map<string, Plot[]>();

/** One panel: a heading with the values at the playhead, and the plot. */
export class Plot {
  readonly element = document.createElement("figure");
  private readonly values: HTMLElement[];
  private readonly playhead = document.createElement("div");
  private readonly plot: uPlot;

  constructor(private readonly options: PlotOptions) {
    const { title, unit, lines, duration, sync, onTime } = options;
    const caption = document.createElement("figcaption");
    const heading = caption.appendChild(document.createElement("span"));
    heading.textContent = `${title} (${unit})`;
    const readout = caption.appendChild(document.createElement("span"));
    readout.className = "readout";
    this.values = lines.map(({ colour, label }) => {
      const value = readout.appendChild(document.createElement("span"));
      value.style.color = colour;
      value.title = label;
      return value;
    });
    const place = document.createElement("div");
    place.className = "plot";
    this.element.append(caption, place);

    const axis = { stroke: INK, font: FONT, grid: { stroke: GRID, width: 1 }, ticks: { stroke: GRID, width: 1, size: 4 } };
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
          ...lines.map(({ label, colour, dashed, held }) => ({
            label,
            stroke: colour,
            width: dashed ? 1.25 : 1.6,
            points: { show: false },
            ...(dashed && { dash: [5, 4] }),
            ...(held && { paths: stepped }),
          })),
        ],
        hooks: {
          drawClear: [(plot) => options.limits && shade(plot, options.limits)],
          setScale: [(plot, key) => key === "x" && this.zoomGroup(plot)],
          setSize: [() => this.seek(this.time)],
        },
      },
      [[0, duration], ...lines.map(() => [null, null])] as uPlot.AlignedData,
      place,
    );
    this.playhead.className = "playhead";
    this.plot.over.append(this.playhead);
    if (onTime) {
      this.plot.over.addEventListener("click", (event) => {
        const { left } = this.plot.over.getBoundingClientRect();
        onTime(this.plot.posToVal(event.clientX - left, "x"));
      });
    }
    if (sync) groups.set(sync, [...(groups.get(sync) ?? []), this]);
    new ResizeObserver(() => this.plot.setSize({ width: place.clientWidth, height: place.clientHeight })).observe(place);
  }

  private time = 0;

  /** Times (K,) in s and one array of values per line. */
  show(times: number[], values: (number | null)[][]): void {
    const [{ min, max }] = [this.plot.scales.x];
    this.plot.setData([times, ...values] as uPlot.AlignedData, false);
    this.plot.setScale("x", { min: min ?? 0, max: max ?? this.options.duration });
  }

  /** The whole of a flight of another duration. */
  setDuration(duration: number): void {
    this.options.duration = duration;
    this.plot.setScale("x", { min: 0, max: duration });
  }

  setLimits(limits: readonly [number, number]): void {
    this.options.limits = limits;
  }

  setVisible(line: number, visible: boolean): void {
    this.plot.setSeries(line + 1, { show: visible });
    this.values[line].hidden = !visible;
  }

  /** Puts the playhead and the values beside the heading to a time in s. */
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
      this.values[i].textContent = value == null ? "–" : shown(value, this.options.digits ?? 1);
    });
  }

  private visible(low: number, high: number, least?: readonly [number, number]): [number, number] {
    const from = Math.min(low, least?.[0] ?? low);
    const to = Math.max(high, least?.[1] ?? high);
    const margin = Math.max(0.07 * (to - from), 1e-6);
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
