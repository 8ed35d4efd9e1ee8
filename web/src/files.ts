// Files of the live page: flights as CSV, the page as a picture, and recorded flights that are dropped on it.

import { deg, make, rad, themed } from "./dom";
import type { Log } from "./experiment";
import type { Flight, Rules } from "./flight";
import type { Pair } from "./model";
import { type Plant, advance, atRest, prepared } from "./plant";
import type { Plot } from "./plots";

/** Offers a file to the reader. */
export function save(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  make("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Flights by their names and the plan, sample by sample. */
export function toCsv(flights: [string, Flight][], reference: { x: number[][]; u: Pair[] }, period: number): string {
  const columns = ["travel", "elevation", "pitch"];
  const names = [...flights.map(([name]) => name), "plan"];
  const head = ["t", ...names.flatMap((name) => [...columns.map((column) => `${name} ${column}_deg`), `${name} u_front`, `${name} u_back`])];
  const rows = reference.x.map((planned, k) => {
    const cells = [...flights.map(([, { x, u }]) => [x[k], u[Math.min(k, u.length - 1)]] as const), [planned, reference.u[k]] as const];
    const texts = cells.flatMap(([x, u]) => (x && u ? [...[x[0], x[2], x[4]].map(deg), ...u].map((value) => value.toFixed(6)) : ["", "", "", "", ""]));
    return [(k * period).toFixed(4), ...texts].join(",");
  });
  return [head.map((name) => (/[",]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name)).join(","), ...rows, ""].join("\n");
}

/** The 3D view with its names and numbers, and the plots below, as one picture. */
export function toPicture(stage: HTMLCanvasElement, views: HTMLElement[], plots: Plot[], title: string): HTMLCanvasElement {
  const scale = 2;
  const [width, margin, plotHeight] = [1200, 16, 170];
  const columns = 3;
  const stageHeight = Math.round((width * stage.clientHeight) / Math.max(stage.clientWidth, 1));
  const rows = Math.ceil(plots.length / columns);
  const canvas = make("canvas", { width: scale * width, height: scale * (40 + stageHeight + rows * (plotHeight + 26) + margin) });
  const context = canvas.getContext("2d")!;
  context.scale(scale, scale);
  const write = (text: string, x: number, y: number, weight = 400) => {
    context.font = `${weight} 13px system-ui, sans-serif`;
    context.fillText(text, x, y);
  };
  context.fillStyle = themed("paper");
  context.fillRect(0, 0, width, canvas.height);
  context.drawImage(stage, 0, 40, width, stageHeight);
  context.fillStyle = themed("ink");
  write(title, margin, 26, 600);
  const frame = stage.getBoundingClientRect();
  for (const view of views) {
    const place = view.getBoundingClientRect();
    const zoom = width / frame.width;
    const [x, y] = [(place.left - frame.left) * zoom + margin, 40 + (place.top - frame.top) * zoom];
    write(view.querySelector(".name")!.textContent!, x, y + 22, 600);
    write([...view.querySelectorAll(".numbers span")].map((number) => number.textContent).join("   "), x, y + place.height * zoom - 10);
  }
  plots.forEach((plot, i) => {
    const x = margin + (i % columns) * ((width - margin) / columns);
    const y = 40 + stageHeight + Math.floor(i / columns) * (plotHeight + 26);
    write(`${plot.options.title} (${plot.options.unit})`, x, y + 20, 600);
    context.drawImage(plot.canvas, x, y + 26, (width - margin) / columns - margin, plotHeight);
  });
  return canvas;
}

// Recorded flights

const TIME = /^(t|time|zeit)\b/i;
const WANTED = [/travel/i, /elev/i, /pitch/i, /(u|v|volt\w*)[ _-]*f|front/i, /(u|v|volt\w*)[ _-]*b|back|rear/i];
const NAMES = ["travel", "elevation", "pitch", "front voltage", "back voltage"];
const NOT_MEASURED = /ref|plan|rate|des|target|set/i;
const SMOOTHING = 4; // samples to either side, over which rates are estimated

/** A recorded flight from a CSV with time, three angles and two voltages, sampled every `step` s. Throws what is missing. */
export function parseLog(text: string, name: string, step: number): Log {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
  if (lines.length < 3) throw new Error(`${name}: must have a line of names and at least two of numbers`);
  const separator = [",", ";", "\t"].find((mark) => lines[0].includes(mark)) ?? ",";
  const names = lines[0].split(separator).map((cell) => cell.trim().replaceAll('"', ""));
  const column = (pattern: RegExp, what: string): number => {
    const found = names.findIndex((cell) => pattern.test(cell) && !NOT_MEASURED.test(cell));
    if (found < 0) throw new Error(`${name}: must have a column for ${what}; it has ${names.join(", ")}`);
    return found;
  };
  const [timeColumn, ...columns] = [column(TIME, "the time"), ...WANTED.map((pattern, i) => column(pattern, NAMES[i]))];
  const rows = lines.slice(1).map((line) => line.split(separator).map(Number));
  const used = [timeColumn, ...columns];
  const good = rows.filter((row) => used.every((i) => Number.isFinite(row[i])));
  const times = good.map((row) => row[timeColumn] - good[0][timeColumn]);
  if (good.length < 2 || !times.every((t, k) => k === 0 || t > times[k - 1])) {
    throw new Error(`${name}: must have numbers, and times that rise from line to line`);
  }
  const unit = columns.map((i) => (/deg|°/i.test(names[i]) ? rad(1) : 1));
  const values = columns.map((i, n) => good.map((row) => row[i] * unit[n]));
  const sampled = (series: number[], t: number) => {
    let k = Math.min(Math.floor((t / times.at(-1)!) * (times.length - 1)), times.length - 2);
    while (k > 0 && times[k] > t) k--;
    while (k < times.length - 2 && times[k + 1] <= t) k++;
    const share = Math.min(Math.max((t - times[k]) / (times[k + 1] - times[k]), 0), 1);
    return series[k] + share * (series[k + 1] - series[k]);
  };
  const count = 2 * Math.floor(times.at(-1)! / (2 * step));
  const grid = Array.from({ length: count + 1 }, (_, k) => k * step);
  const [travel, elevation, pitch, front, back] = values.map((series) => grid.map((t) => sampled(series, t)));
  const rates = [travel, elevation, pitch].map((angle) => slopes(angle, step));
  return {
    name,
    step,
    x: grid.map((_, k) => [travel[k], rates[0][k], elevation[k], rates[1][k], pitch[k], rates[2][k]]),
    u: grid.map((_, k) => [front[k], back[k]]),
  };
}

/** Rates by straight lines through the samples around each. */
function slopes(values: number[], step: number): number[] {
  return values.map((_, k) => {
    const [from, to] = [Math.max(k - SMOOTHING, 0), Math.min(k + SMOOTHING, values.length - 1)];
    const middle = 0.5 * (from + to);
    let [above, below] = [0, 0];
    for (let i = from; i <= to; i++) {
      above += (i - middle) * values[i];
      below += (i - middle) ** 2;
    }
    return above / below / step;
  });
}

/** RMS of the errors in deg of travel, elevation and pitch, one second after starts of a plant at the record's states. */
export function oneSecondAhead(log: Log, plant: Plant, rules: Rules): number[] {
  const ready = prepared({ ...plant, disturbances: [] }, rules.controlPeriod, rules.substep);
  const stride = Math.round(rules.controlPeriod / log.step);
  const ahead = Math.round(1 / rules.controlPeriod);
  const squares = [0, 0, 0];
  let starts = 0;
  for (let k = 0; k + ahead * stride < log.x.length; k += (ahead * stride) / 2) {
    let state = atRest(ready, log.x[k], log.u[k]);
    for (let n = 0; n < ahead; n++) state = advance(ready, state, log.u[k + n * stride], 0, rules.controlPeriod, [], false);
    [0, 2, 4].forEach((row, i) => (squares[i] += (state.x[row] - log.x[k + ahead * stride][row]) ** 2));
    starts += 1;
  }
  return squares.map((sum) => deg(Math.sqrt(sum / Math.max(starts, 1))));
}
