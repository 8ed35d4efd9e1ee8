// The figures of the paper, each with its equation, drawn from the flights that are shown.

import type { Experiment } from "./experiment";
import { limitsOf } from "./experiment";
import { deg, make } from "./dom";
import { dynamics } from "./equations";
import type { Flight } from "./flight";
import { swatch } from "./marks";
import { equation } from "./math";
import { type Pair, inputAt, thrustBounds, thrusts } from "./model";
import { type Line, Plot } from "./plots";
import { SetPlot } from "./sets";

const GAINS = ["travel", "travel rate", "elevation", "elevation rate", "pitch", "pitch rate"];
const GAIN_COLOURS = ["#0072B2", "#56B4E9", "#009E73", "#E69F00", "#CC79A7", "#7A5195"];

interface Policy {
  name: string;
  colour: string;
}

/** Corners of the voltages within a window. */
export const box = ([low, high]: Readonly<Pair>): Pair[] => [[low, low], [high, low], [high, high], [low, high]];

/** Ticks between two numbers at steps of 1, 2 or 5 of a power of ten. */
export function ticksBetween(low: number, high: number): number[] {
  const rough = (high - low) / 4;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(6)));
}

/** The section; `rebuild` for another plan or rig, `refresh` one figure as flights go on, `seek` to a time. */
export class PaperFigures {
  readonly element = make("section", { class: "paper" });
  private figures: { refresh: () => void; seek: (time: number) => void; show?: (i: number, on: boolean) => void }[] = [];
  private experiment: Experiment | null = null;
  private flights: (Flight | null)[] = [];
  private turn = 0;

  constructor(private readonly policies: Policy[], private readonly period: number, private readonly lines: Line[], private readonly onTime: (time: number) => void) {}

  rebuild(experiment: Experiment, shown: boolean[]): void {
    this.experiment = experiment;
    this.figures = [];
    const colours = this.policies.map(({ colour }) => colour);
    const { rig } = experiment;
    const limits = limitsOf(experiment.setup);
    const model = rig.parameters;
    const duration = this.period * experiment.steps;
    const figure = (number: string, text: string, caption: string, ...parts: HTMLElement[]) =>
      make("div", { class: "figure" }, make("h3", {}, number), equation(text), make("p", { class: "small" }, caption), ...parts);

    const set = (options: ConstructorParameters<typeof SetPlot>[0], points: (flight: Flight) => Pair[]) => {
      const plot = new SetPlot(options);
      this.figures.push({
        refresh: () => plot.show(this.flights.map((flight) => (flight ? points(flight) : []))),
        seek: (time) => plot.seek(Math.floor(time / this.period)),
        show: (i, on) => plot.setVisible(i, on),
      });
      return plot.element;
    };
    const over = (title: string, unit: string, lines: Line[], values: () => (number | null)[][], digits = 1, range?: Pair) => {
      const plot = new Plot({ title, unit, lines, duration, digits, onTime: this.onTime, ...(range && { range }) });
      const times = experiment.reference.x.map((_, k) => k * this.period);
      this.figures.push({
        refresh: () => plot.show(times, values()),
        seek: (time) => plot.seek(time),
        show: (i, on) => lines === this.lines && plot.setVisible(i, on),
      });
      return plot.element;
    };
    const along = (value: (flight: Flight, k: number) => number) => () =>
      this.flights.map((flight) => experiment.reference.x.map((_, k) => (flight && k < flight.x.length ? value(flight, k) : null)));
    const at = (flight: Flight, k: number): Pair => flight.u[Math.min(k, flight.u.length - 1)] ?? flight.rotors;

    const [low, high] = rig.amplifier;
    const volts = ticksBetween(low, high);
    const curve = Array.from({ length: 61 }, (_, i): Pair => [low + ((high - low) * i) / 60, thrusts([low + ((high - low) * i) / 60, 0], model)[0]]);
    const [fLeast, fMost] = thrustBounds(limits.u, model);
    const diamond = ([f0, f1]: Pair): Pair[] => [[0, 2 * f0], [f1 - f0, f0 + f1], [0, 2 * f1], [f0 - f1, f0 + f1]];
    const reach = thrustBounds(rig.amplifier, model);
    const sums = ticksBetween(2 * reach[0], 2 * reach[1]);
    const bound = limits.pitch[1];
    const saturation = Array.from({ length: 61 }, (_, i): Pair => {
      const xi = (i / 30 - 1) * 1.6 * bound;
      return [deg(xi), deg(bound * Math.tanh(xi / bound))];
    });
    const inner = (pitch: number) => bound * Math.atanh(Math.min(Math.max(pitch / bound, -0.999), 0.999));
    const angles = ticksBetween(-1.5 * deg(bound), 1.5 * deg(bound));
    const { front } = model;
    const law = "cubics" in front ? "f_i = f ( u_i )" : `f_i = k_± ${front.dead_zone ? "( | u_i | − u_0 )" : "| u_i |"}^${front.exponent} sgn u_i`.replace("| u_i |^2 sgn u_i", "| u_i | u_i").replace("k_± | u_i |^1 sgn u_i", "k u_i");
    const tracking = this.policies.findIndex(({ name }, i) => shown[i] && (name === "feedforward+tvlqr" || name === "yours"));
    const gains = experiment.gains(tracking < 0 ? "feedforward+tvlqr" : this.policies[tracking].name);
    const gainLines: Line[] = GAINS.map((label, i) => ({ label, colour: GAIN_COLOURS[i], mark: i }));
    const gainRow = (row: number) => () => GAINS.map((_, i) => experiment.reference.x.map((_, k) => gains![Math.min(k, gains!.length - 1)][row][i]));

    this.element.replaceChildren(
      make("h2", {}, "The paper, drawn from this flight"),
      make(
        "div",
        { class: "figures" },
        figure("(2) thrust", law, "Thrust of the front fan over its voltage, and where each flight is on it.",
          set({ title: "thrust of the front fan", axes: ["front voltage (V)", "thrust (N)"], curve, ticks: [volts, ticksBetween(curve[0][1], curve[60][1])], colours },
            (flight) => flight.u.map((u): Pair => [u[0], thrusts(u, model)[0]]))),
        figure("(3a) travel", "q̈_1 = b_1 cos q_2 sin q_3 v_1 − c_1 q̇_1", "Only a pitched helicopter accelerates sideways: the travel acceleration that (3) makes of pitch and thrust.",
          over("travel acceleration", "deg/s²", this.lines, along((flight, k) => deg(dynamics(flight.x[k], inputAt(at(flight, k), model), model)[1])), 1, [-1, 1])),
        figure("(6), (9) voltages", "u_min ≤ u_f , u_b ≤ u_max", "The window of the plan, in the range of the amplifier.",
          set({ title: "voltages", axes: ["front voltage (V)", "back voltage (V)"], corners: box(limits.u), outer: box(rig.amplifier), ticks: [volts, volts], colours },
            (flight) => flight.u)),
        figure("(4), (17)–(20) virtual inputs", "v_1 = f_f + f_b , v_2 = f_f − f_b", "The window becomes a rhombus: much thrust leaves little for the difference.",
          set({ title: "virtual inputs", axes: ["thrust difference v2 (N)", "thrust sum v1 (N)"], corners: diamond([fLeast, fMost]), outer: diamond(reach), ticks: [ticksBetween(reach[0] - reach[1], reach[1] - reach[0]), sums], colours },
            (flight) => flight.u.map((u) => inputAt(u, model).reverse() as Pair))),
        figure("(25)–(29) pitch limit", "q_3 = ψ_1 ( ξ_1 )", "The paper's smooth saturation: whatever ξ does, the pitch of the plan stays within its limits.",
          set({ title: "saturation of the pitch", axes: ["ξ (deg)", "pitch (deg)"], curve: saturation, ticks: [angles, ticksBetween(-deg(bound), deg(bound))], colours },
            (flight) => flight.x.map((x): Pair => {
              const pitch = Math.min(Math.max(x[4], -0.98 * bound), 0.98 * bound);
              return [deg(inner(pitch)), deg(pitch)];
            }))),
        figure("(51) feedback", "v = v_d − K ( t ) ( x − x_d )", "Fig. 10: a start that is off, and how the feedback removes the error of the elevation.",
          over("elevation error", "deg, positive down", this.lines, along((flight, k) => deg(flight.x[k][2] - experiment.reference.x[k][2])), 2, [-0.1, 0.1])),
        ...(gains
          ? [
              figure("(50), (51) gains", "K ( t ) = R^−1 B^T P ( t )", "Gains on the thrust sum, in N/rad and N s/rad; the marker names the state.",
                over("gains on v1", "N/rad, N s/rad", gainLines, gainRow(0))),
              figure("(50), (51) gains", "− Ṗ = P A + A^T P − P B R^−1 B^T P + Q", "Gains on the thrust difference.",
                over("gains on v2", "N/rad, N s/rad", gainLines, gainRow(1)),
                make("p", { class: "legend small" }, ...GAINS.map((label, i) => make("span", {}, swatch(i, GAIN_COLOURS[i]), label)))),
            ]
          : []),
      ),
    );
    this.policies.forEach((_, i) => this.setVisible(i, shown[i]));
  }

  setVisible(i: number, on: boolean): void {
    for (const { show } of this.figures) show?.(i, on);
  }

  /** Redraws the next figure, or all of them. */
  refresh(flights: (Flight | null)[], time: number, all: boolean): void {
    if (!this.experiment) return;
    this.flights = flights;
    const due = all ? this.figures : [this.figures[this.turn++ % this.figures.length]];
    for (const figure of due) {
      figure.refresh();
      figure.seek(time);
    }
  }
}
