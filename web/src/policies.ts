// Controllers, as baselines/control/policies.py has them.

import { type Actuator, type Uncertainty, disturbanceAccommodated, kalmanGains, predict } from "./estimation";
import { type Matrix, applied, minus } from "./matrices";
import { type Model, type Pair, clip, hoverInput, inputAt, voltages } from "./model";
import type { Plan } from "./plan";
import { regulatorGains } from "./regulation";
import type { Weights } from "./tvlqr";

/** Voltages in V for the k-th control period, given a measured state. Each flight has its own, which may remember it. */
export interface Controller {
  voltages(k: number, measured: readonly number[]): Pair;
}

/** What is to be followed, on the control grid: K + 1 states, and voltages at the start and in the middle of a period. */
export interface Reference {
  x: number[][];
  u: Pair[];
  middle: Pair[]; // what is held is half a period late on average, and this makes up for it
}

/** A plan that is sampled at half the control period, on the control grid. */
export function controlGrid(plan: Plan): Reference {
  const last = plan.x.length - 1;
  const onGrid = plan.x.flatMap((_, k) => (k % 2 === 0 ? [k] : []));
  return {
    x: onGrid.map((k) => plan.x[k]),
    u: onGrid.map((k) => plan.u[k]),
    middle: onGrid.map((k) => plan.u[Math.min(k + 1, last)]),
  };
}

/** States and virtual inputs in N to track on the control grid, and gains (2 x 6), (51), unless the loop is open. */
export interface Tracking {
  x: number[][];
  v: Pair[];
  gains: Matrix[] | null;
}

/** Fig. 3: a feedforward and a state feedback on the tracking error. It remembers nothing. */
export function trackingController(tracking: Tracking, parameters: Model): Controller & { tracking: Tracking } {
  const { x, v, gains } = tracking;
  return {
    tracking,
    voltages(period, measured) {
      const k = Math.min(period, x.length - 1);
      if (gains === null) return voltages(v[k], parameters);
      const [sum, difference] = applied(gains[k], minus(measured, x[k]));
      return voltages([v[k][0] - sum, v[k][1] - difference], parameters);
    },
  };
}

/** The feedforward alone, or with gains the paper's controller. */
export function feedforward({ x, middle }: Reference, gains: Matrix[] | null, parameters: Model): Tracking {
  return { x, v: middle.map((u) => inputAt(u, parameters)), gains };
}

/** A stationary regulator about hover at the goal that follows the states without any feedforward. */
export function hoverTracking({ x }: Reference, gain: Matrix, parameters: Model): Tracking {
  const hover = hoverInput(x.at(-1)![2], parameters);
  return { x, v: x.map(() => hover), gains: x.map(() => gain) };
}

/** What the controller with a Kalman filter assumes. */
export interface KalmanSettings extends Uncertainty {
  actuator: Actuator;
  weights: Weights; // 8 x 8: of the states and of v
  least_lift: number; // N
}

/** What of it depends on the reference alone: on the control grid, (2 x 8) and (9 x 3). */
export interface KalmanGains {
  regulator: Matrix[];
  observer: Matrix[];
}

/** Both gains along a reference. */
export function kalmanLqrGains(
  { x, u }: Reference,
  settings: KalmanSettings,
  period: number,
  parameters: Model,
): KalmanGains {
  const v = u.map((volts) => inputAt(volts, parameters));
  return {
    regulator: regulatorGains(x, v, period, parameters, settings.weights, settings.actuator.lag),
    observer: kalmanGains(x, v, period, parameters, settings),
  };
}

/** All that the controller with a Kalman filter and its correction know of their task. */
export interface Task {
  reference: Reference;
  pitchLimits: Pair; // rad
  amplifier: Pair; // V
  period: number; // s
  parameters: Model;
}

/** A regulator for lagging rotors on the estimates of a filter, predicted for the time when the voltages take effect. */
export class KalmanController implements Controller {
  private readonly command: Pair[]; // V: leading, which the actuator turns into the reference's
  private x: readonly number[]; // predicted
  private pending: Pair[]; // V, commands not yet in effect
  disturbance = [0, 0, 0]; // rad/s², estimated
  rotors: Pair; // V, simulated

  constructor(
    readonly task: Task,
    readonly gains: KalmanGains,
    readonly settings: KalmanSettings,
  ) {
    const { x, u, middle } = task.reference;
    const { lag, delay } = settings.actuator;
    [this.x, this.rotors] = [x[0], u[0]];
    this.pending = Array.from({ length: delay }, () => u[0]);
    this.command = middle.map((held, k) => {
      const next = u[Math.min(k + 1, u.length - 1)];
      return held.map((volts, i) => volts + (lag * (next[i] - u[k][i])) / task.period) as Pair;
    });
  }

  voltages(k: number, measured: readonly number[]): Pair {
    const last = this.task.reference.x.length - 1;
    const now = Math.min(k, last);
    const { delay } = this.settings.actuator;
    const innovation = minus(measured, this.x).filter((_, i) => i % 2 === 0);
    const correction = applied(this.gains.observer[now], innovation);
    const x = this.x.map((value, i) => value + correction[i]);
    this.disturbance = this.disturbance.map((value, i) => value + correction[6 + i]);
    let later = { x, rotors: this.rotors };
    for (const u of this.pending) later = this.predicted(later, u);
    const u = this.regulated(Math.min(now + delay, last), later);
    const [taking, ...pending] = [...this.pending, this.limited(u)];
    ({ x: this.x, rotors: this.rotors } = this.predicted({ x, rotors: this.rotors }, taking));
    this.pending = pending;
    return u;
  }

  private limited(u: Pair): Pair {
    return u.map((volts) => clip(volts, this.task.amplifier)) as Pair;
  }

  private predicted({ x, rotors }: { x: number[]; rotors: Pair }, u: Pair): { x: number[]; rotors: Pair } {
    const { period, parameters } = this.task;
    return predict(x, rotors, u, this.disturbance, period, this.settings.actuator, parameters);
  }

  private regulated(k: number, { x, rotors }: { x: number[]; rotors: Pair }): Pair {
    const { reference, pitchLimits, parameters } = this.task;
    const { least_lift } = this.settings;
    const [v, vReference, vCommand] = [rotors, reference.u[k], this.command[k]].map((u) => inputAt(u, parameters));
    const hold = disturbanceAccommodated(reference.x[k], vReference, this.disturbance, pitchLimits, least_lift, parameters);
    const correction = applied(this.gains.regulator[k], [...minus(x, hold.x), ...minus(v, hold.v)]);
    return voltages(vCommand.map((v, i) => v + (hold.v[i] - vReference[i]) - correction[i]) as Pair, parameters);
  }
}
