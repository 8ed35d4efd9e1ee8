// A learned correction on top of the paper's controller, as baselines/control/residual/policy.py has it.

import { type Matrix, applied, float32, minus } from "./matrices";
import { type Pair, clip } from "./model";
import type { Controller, KalmanSettings, Task } from "./policies";
import type { Weights } from "./tvlqr";

/** Scales of the features. */
export interface FeatureSettings {
  tolerance: number[]; // of the tracking error, rad and rad/s
  state_scale: number[]; // of the reference, rad and rad/s
  largest: number; // what features are clipped to
}

/** The arrays of a network: matrices by their rows. */
export interface Arrays<M, V> {
  weight_input: M; // of the GRU cell, its gates being reset, update, new
  weight_hidden: M;
  bias_input: V;
  bias_hidden: V;
  weight: M; // of the last layer, the tanh of which are the actions
  bias: V;
}

/** A network, and the weights of the controller that it corrects. */
export interface Learned<A> {
  weights: Weights;
  scale: number; // V, the greatest correction
  ahead: number[]; // s, at which the network sees the reference
  arrays: A;
}

/** The controllers for a plant: the Kalman LQR's settings, and the learned correction where there is one. */
export interface Trained<A> {
  kalman: KalmanSettings;
  learned: Learned<A> | null;
}

/** Arrays as base64 of float32, row by row. */
export type StoredNetwork = Trained<Arrays<string, string>>;
export type Network = Trained<Arrays<Matrix, number[]>>;

export function unpacked({ kalman, learned }: StoredNetwork): Network {
  if (learned === null) return { kalman, learned };
  const { arrays, ...settings } = learned;
  const matrix = (stored: string, rows: number): Matrix => {
    const flat = float32(stored);
    const columns = flat.length / rows;
    return Array.from({ length: rows }, (_, i) => flat.slice(i * columns, (i + 1) * columns));
  };
  const [bias_input, bias_hidden, bias] = [arrays.bias_input, arrays.bias_hidden, arrays.bias].map(float32);
  const unpackedArrays = {
    weight_input: matrix(arrays.weight_input, bias_input.length),
    weight_hidden: matrix(arrays.weight_hidden, bias_hidden.length),
    weight: matrix(arrays.weight, bias.length),
    bias_input,
    bias_hidden,
    bias,
  };
  return { kalman, learned: { ...settings, arrays: unpackedArrays } };
}

const affine = (weight: Matrix, bias: number[], values: readonly number[]): number[] =>
  applied(weight, values).map((sum, i) => sum + bias[i]);

/** The actions in [-1, 1]² for features, and the next hidden state. */
export function actions({ arrays }: Learned<Arrays<Matrix, number[]>>, features: number[], hidden: readonly number[]): { action: Pair; hidden: number[] } {
  const n = hidden.length;
  const x = affine(arrays.weight_input, arrays.bias_input, features);
  const h = affine(arrays.weight_hidden, arrays.bias_hidden, hidden);
  const sigmoid = (i: number) => 0.5 + 0.5 * Math.tanh(0.5 * (x[i] + h[i]));
  const next = hidden.map((old, i) => {
    const fresh = Math.tanh(x[2 * n + i] + sigmoid(i) * h[2 * n + i]);
    return fresh + sigmoid(n + i) * (old - fresh);
  });
  return { action: affine(arrays.weight, arrays.bias, next).map(Math.tanh) as Pair, hidden: next };
}

/** A controller, corrected by a network within what the amplifier can do: u = sat(sat(u_base) + scale a). */
export class ResidualController implements Controller {
  private hidden: number[];
  private last = [0, 0]; // correction

  constructor(
    readonly base: Controller,
    readonly task: Task,
    readonly network: Learned<Arrays<Matrix, number[]>>,
    readonly settings: FeatureSettings,
  ) {
    this.hidden = network.arrays.weight_hidden[0].map(() => 0);
  }

  voltages(k: number, measured: readonly number[]): Pair {
    const { reference, amplifier } = this.task;
    const uBase = this.base.voltages(k, measured);
    const features = this.features(Math.min(k, reference.x.length - 1), measured, uBase);
    const { action, hidden } = actions(this.network, features, this.hidden);
    [this.hidden, this.last] = [hidden, action];
    return uBase.map((volts, i) => clip(volts, amplifier) + this.network.scale * action[i]) as Pair;
  }

  private features(k: number, measured: readonly number[], uBase: Pair): number[] {
    const { reference, amplifier, period } = this.task;
    const { tolerance, state_scale, largest } = this.settings;
    const [middle, half] = [0.5 * (amplifier[0] + amplifier[1]), 0.5 * (amplifier[1] - amplifier[0])];
    const normalised = (u: Pair) => u.map((volts) => (volts - middle) / half);
    const last = reference.x.length - 1;
    return [
      ...minus(measured, reference.x[k]).map((value, i) => value / tolerance[i]),
      ...normalised(uBase),
      ...normalised(reference.middle[k]),
      ...this.last,
      // the travel of the reference is not among what is seen
      ...this.network.ahead.flatMap((seconds) => {
        const x = reference.x[Math.min(k + Math.round(seconds / period), last)];
        return x.map((value, i) => value / state_scale[i]).slice(1);
      }),
    ].map((value) => clip(value, [-largest, largest]));
  }
}
