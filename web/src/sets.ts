// The sets that the inputs are confined to, and where the flights are in them: (6), and (17)-(20).

import { make } from "./dom";
import type { Pair } from "./model";
import { shapeOf } from "./marks";
import { LIMIT } from "./plots";
import { joined, svg } from "./svg";

const SIZE = 400;
const MARGIN = { left: 44, right: 10, top: 10, bottom: 38 };
const TAIL = 75; // samples
export interface SetOptions {
  title: string;
  axes: [string, string];
  corners?: Pair[]; // of the set
  curve?: Pair[]; // that all points are on
  outer?: Pair[]; // of what the amplifier can do
  ticks: [number[], number[]];
  colours: string[]; // one per flight
  marks?: boolean; // whether a flight has the marker of its index
}

/** A plane with the set in it, one path per flight, and a dot on each. */
export class SetPlot {
  readonly element: HTMLElement;
  private readonly paths: SVGElement[];
  private readonly tails: SVGElement[]; // where each flight has just been
  private readonly dots: SVGElement[];
  private readonly place: (point: Pair) => Pair;
  private points: Pair[][] = [];

  constructor({ title, axes, corners = [], outer = [], curve = [], ticks, colours, marks = true }: SetOptions) {
    const all = [...corners, ...outer, ...curve];
    const bounds = [0, 1].map((i) => [Math.min(...all.map((c) => c[i])), Math.max(...all.map((c) => c[i]))]);
    const pads = bounds.map(([low, high]) => 0.08 * (high - low));
    const inner = { width: SIZE - MARGIN.left - MARGIN.right, height: SIZE - MARGIN.top - MARGIN.bottom };
    this.place = ([x, y]) => [
      MARGIN.left + (inner.width * (x - bounds[0][0] + pads[0])) / (bounds[0][1] - bounds[0][0] + 2 * pads[0]),
      MARGIN.top + inner.height - (inner.height * (y - bounds[1][0] + pads[1])) / (bounds[1][1] - bounds[1][0] + 2 * pads[1]),
    ];
    const picture = svg("svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, role: "img", "aria-label": `${title}: ${axes.join(", ")}` });
    const frame = { x: MARGIN.left, y: MARGIN.top, ...inner };
    picture.append(svg("rect", { ...frame, class: "frame" }));
    for (const tick of ticks[0]) {
      const [x] = this.place([tick, 0]);
      picture.append(
        svg("line", { x1: x, x2: x, y1: frame.y, y2: frame.y + frame.height, class: "grid" }),
        svg("text", { x, y: frame.y + frame.height + 14, class: "tick" }, `${tick}`.replace("-", "\u2212")),
      );
    }
    for (const tick of ticks[1]) {
      const [, y] = this.place([0, tick]);
      picture.append(
        svg("line", { x1: frame.x, x2: frame.x + frame.width, y1: y, y2: y, class: "grid" }),
        svg("text", { x: frame.x - 5, y: y + 4, class: "tick end" }, `${tick}`.replace("-", "\u2212")),
      );
    }
    picture.append(
      svg("text", { x: frame.x + frame.width / 2, y: SIZE - 6, class: "label" }, axes[0]),
      svg("text", { x: 0, y: 0, class: "label", transform: `translate(12 ${frame.y + frame.height / 2}) rotate(-90)` }, axes[1]),
    );
    const polygon = (points: Pair[]) => joined(points.map(this.place));
    if (outer.length) picture.append(svg("polygon", { points: polygon(outer), class: "outer" }));
    if (corners.length) picture.append(svg("polygon", { points: polygon(corners), class: "set", stroke: LIMIT }));
    if (curve.length) picture.append(svg("polyline", { points: polygon(curve), class: "curve" }));
    const line = (kind: string) => colours.map((colour) => svg("polyline", { class: kind, stroke: colour, points: "" }));
    [this.paths, this.tails] = [line("path"), line("path tail")];
    this.dots = colours.map((colour, i) => svg("path", { d: shapeOf(marks ? i : 0), fill: colour, class: "dot" }));
    picture.append(...this.paths, ...this.tails, ...this.dots);
    this.element = make("figure", { class: "set" }, make("figcaption", {}, make("span", {}, title)), picture as unknown as Node);
  }

  /** Points over time, one path per flight. */
  show(points: Pair[][]): void {
    this.points = points.map((path) => path.map(this.place));
    this.paths.forEach((path, i) => path.setAttribute("points", joined(this.points[i])));
  }

  setVisible(line: number, visible: boolean): void {
    for (const element of [this.paths[line], this.tails[line], this.dots[line]]) element.toggleAttribute("hidden", !visible);
  }

  /** Puts the dots to a sample; a flight that ended sooner stays at its end. */
  seek(sample: number): void {
    this.dots.forEach((dot, i) => {
      const points = this.points[i] ?? [];
      if (points.length === 0) return;
      const now = Math.min(sample, points.length - 1);
      const [x, y] = points[now];
      this.tails[i].setAttribute("points", joined(points.slice(Math.max(0, now - TAIL), now + 1)));
      dot.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)}) scale(5)`);
    });
  }
}
