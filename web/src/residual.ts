// A learned correction on top of a controller, as baselines/control/residual.py has it.

import { type Matrix, applied, minus } from "./matrices";
import { type Pair, clip } from "./model";
import type { Controller, KalmanController, KalmanSettings } from "./policies";

/** How what the network sees is scaled. */
export interface FeatureSettings {
  tolerance: number[]; // of the tracking error, rad and rad/s
  state_scale: number[]; // of the reference, rad and rad/s
  integral_scale: number; // rad s
  disturbance_scale: number; // rad/s²
  ahead: number[]; // s, at which it sees the reference
  before: number[]; // s, at which it sees past errors and corrections
  largest: number; // what features are clipped to
}

/** A stored network: what it corrects, and its layers as base64 of float32, row by row. */
export interface StoredNetwork {
  base: KalmanSettings;
  featureGroups: string[]; // which groups of features
  scale: number; // V, the greatest correction
  tanhOutput: boolean; // whether the tanh of the last layer is taken too
  layers: { weight: string; bias: string }[];
}

export interface Network extends Omit<StoredNetwork, "layers"> {
  layers: { weight: Matrix; bias: number[] }[];
}

const float32 = (base64: string): number[] =>
  Array.from(new Float32Array(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer));

export function unpacked({ layers, ...settings }: StoredNetwork): Network {
  return {
    ...settings,
    layers: layers.map((layer) => {
      const [flat, bias] = [float32(layer.weight), float32(layer.bias)];
      const columns = flat.length / bias.length;
      return { weight: bias.map((_, i) => flat.slice(i * columns, (i + 1) * columns)), bias };
    }),
  };
}

/** The actions in [-1, 1]² for features. */
export function actions({ layers, tanhOutput }: Network, features: number[]): Pair {
  const last = layers.length - 1;
  const out = layers.reduce((value, { weight, bias }, k) => {
    const sums = applied(weight, value).map((sum, i) => sum + bias[i]);
    return k < last || tanhOutput ? sums.map(Math.tanh) : sums;
  }, features);
  return out.map((action) => clip(action, [-1, 1])) as Pair;
}

/** The controller with a Kalman filter, corrected by a network. */
export class ResidualController implements Controller {
  private integral = [0, 0]; // rad s, of the errors of travel and elevation
  private readonly past: number[][]; // errors of the angles in tolerances, and corrections, the last first

  constructor(
    readonly base: KalmanController,
    readonly network: Network,
    readonly settings: FeatureSettings,
  ) {
    const longest = Math.max(...settings.before.map((seconds) => this.steps(seconds)));
    this.past = Array.from({ length: longest }, () => [0, 0, 0, 0, 0]);
  }

  voltages(k: number, measured: readonly number[]): Pair {
    const { reference } = this.base.task;
    const now = Math.min(k, reference.x.length - 1);
    const uBase = this.base.voltages(k, measured);
    const error = minus(measured, reference.x[now]);
    const action = actions(this.network, this.features(now, error, uBase));
    const u = uBase.map((volts, i) => volts + this.network.scale * action[i]) as Pair;
    this.base.replaceLast(u);
    this.integral = this.integral.map((sum, i) => sum + this.base.task.period * error[2 * i]);
    this.past.pop();
    this.past.unshift([...[0, 2, 4].map((i) => error[i] / this.settings.tolerance[i]), ...action]);
    return u;
  }

  private features(k: number, error: number[], uBase: Pair): number[] {
    const { task, disturbance, rotors } = this.base;
    const { reference, amplifier } = task;
    const { tolerance, state_scale, integral_scale, disturbance_scale, ahead, before, largest } = this.settings;
    const [middle, half] = [0.5 * (amplifier[0] + amplifier[1]), 0.5 * (amplifier[1] - amplifier[0])];
    const toAction = (u: Pair) => u.map((volts) => (volts - middle) / half);
    const last = reference.x.length - 1;
    // The groups in the order of GROUPS in Python; the travel of the reference is not among what is seen.
    const groups: Record<string, number[]> = {
      error: error.map((value, i) => value / tolerance[i]),
      integral: this.integral.map((value) => value / integral_scale),
      voltages: [...toAction(uBase), ...toAction(reference.middle[k]), ...this.past[0].slice(3)],
      estimate: [...disturbance.map((value) => value / disturbance_scale), ...toAction(rotors)],
      preview: ahead.flatMap((seconds) => {
        const x = reference.x[Math.min(k + this.steps(seconds), last)];
        return x.map((value, i) => value / state_scale[i]).slice(1);
      }),
      past: before.flatMap((seconds) => this.past[this.steps(seconds) - 1]),
    };
    const seen = Object.entries(groups).flatMap(([name, values]) => (this.network.featureGroups.includes(name) ? values : []));
    return seen.map((value) => clip(value, [-largest, largest]));
  }

  private steps(seconds: number): number {
    return Math.round(seconds / this.base.task.period);
  }
}
