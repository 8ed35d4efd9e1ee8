// How the errors of all episodes are distributed: one small histogram per policy, all over the same logarithmic axis.

import { make, shown } from "./dom";
import { swatch } from "./marks";
import { svg } from "./svg";

const WIDTH = 300;
const HEIGHT = 84;
const BASE = 62; // of the bars
const BINS = 24;

/** The histograms; `mark` puts a line where the flights that are shown are. */
export class Histograms {
  readonly element: HTMLElement;
  private readonly marks: SVGElement[];
  private readonly figures: HTMLElement[];
  private readonly place: (error: number) => number;

  constructor(errors: number[][], labels: string[], colours: string[]) {
    const all = errors.flat().filter((error) => error > 0);
    const low = Math.log10(Math.min(...all)) - 0.05;
    const high = Math.max(Math.log10(Math.max(...all)) + 0.05, low + 0.2);
    this.place = (error) => (WIDTH * (Math.log10(Math.max(error, 10 ** low)) - low)) / (high - low);
    const ticks = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500].filter((t) => Math.log10(t) > low && Math.log10(t) < high);
    const every = Math.ceil(ticks.length / 7);
    this.marks = [];
    this.figures = errors.map((own, i) => {
      const counts = new Array<number>(BINS).fill(0);
      for (const error of own) counts[Math.min(BINS - 1, Math.max(0, Math.floor((BINS * this.place(error)) / WIDTH)))] += 1;
      const most = Math.max(...counts, 1);
      const median = [...own].sort((a, b) => a - b)[Math.floor(own.length / 2)];
      const text = `${labels[i]}: ${own.length} episodes, median ${shown(median ?? Number.NaN, 2)}°`;
      const picture = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": text });
      ticks.forEach((tick, n) => {
        if (n % every > 0) return;
        const x = this.place(tick);
        picture.append(
          svg("line", { x1: x, x2: x, y1: 4, y2: BASE, class: "grid" }),
          svg("text", { x, y: BASE + 14, class: "tick" }, `${tick}`),
        );
      });
      counts.forEach((count, n) => {
        const height = (BASE - 6) * (count / most);
        picture.append(svg("rect", { x: (n * WIDTH) / BINS + 0.5, width: WIDTH / BINS - 1, y: BASE - height, height, fill: colours[i] }));
      });
      const mark = svg("line", { y1: 2, y2: BASE + 3, class: "mark" });
      picture.append(svg("line", { x1: 0, x2: WIDTH, y1: BASE, y2: BASE, class: "axis" }), mark);
      this.marks.push(mark);
      return make("figure", { class: "histogram" }, make("figcaption", {}, make("span", {}, swatch(i, colours[i]), text)), picture as unknown as Node);
    });
    this.element = make("div", { class: "multiples" }, ...this.figures);
  }

  /** Marks the errors of the flights that are shown; null where there is none. */
  mark(errors: (number | null)[]): void {
    this.marks.forEach((mark, i) => {
      const error = errors[i];
      mark.toggleAttribute("hidden", error == null);
      if (error == null) return;
      const x = this.place(error).toFixed(1);
      mark.setAttribute("x1", x);
      mark.setAttribute("x2", x);
    });
  }

  setVisible(i: number, visible: boolean): void {
    this.figures[i].hidden = !visible;
  }
}
