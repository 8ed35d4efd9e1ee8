// The policies that can be flown here, by their names in Python.

import type { Matrix } from "./matrices";
import type { Model, Pair } from "./model";
import type { Plan } from "./plan";
import {
  type Controller,
  KalmanController,
  type KalmanGains,
  type KalmanSettings,
  type Task,
  type Tracking,
  controlGrid,
  feedforward,
  hoverTracking,
  kalmanLqrGains,
  trackingController,
} from "./policies";
import { type FeatureSettings, type Network, ResidualController } from "./residual";
import { type Weights, riccatiGains } from "./tvlqr";

/** What Python says of the controllers. */
export interface ControlData {
  parameters: Model;
  amplifier: Pair; // V
  control_period: number; // s
  weights: Weights;
  hover_gain: Matrix;
  features: FeatureSettings;
  yours?: Weights; // the reader's, of the paper's controller
}

/** A controller for one flight, with what was trained and tuned for a plant; null where nothing was trained. */
export type Maker = (network: Network) => Controller | null;

/** Every policy along a plan that is sampled at half the control period. Gains are computed when they are first flown. */
export function controllersAlong(plan: Plan, pitchLimits: Pair, data: ControlData): Record<string, Maker> {
  const { parameters, amplifier, control_period: period } = data;
  const reference = controlGrid(plan);
  const task: Task = { reference, pitchLimits, amplifier, period, parameters };
  const yours = once(() => riccatiGains(plan, data.yours ?? data.weights, parameters));
  const tvlqr = once(() => riccatiGains(plan, data.weights, parameters));
  const known = new Map<KalmanSettings, KalmanGains>();
  const gainsOf = (base: KalmanSettings): KalmanGains => {
    if (!known.has(base)) known.set(base, kalmanLqrGains(reference, base, period, parameters));
    return known.get(base)!;
  };
  const tracking = (values: Tracking) => trackingController(values, parameters);
  const corrected = new Map<Weights, Matrix[]>();
  const trackingWith = (weights: Weights) => {
    if (!corrected.has(weights)) corrected.set(weights, riccatiGains(plan, weights, parameters));
    return tracking(feedforward(reference, corrected.get(weights)!, parameters));
  };
  return {
    "feedforward+tvlqr": () => tracking(feedforward(reference, tvlqr(), parameters)),
    yours: () => tracking(feedforward(reference, yours(), parameters)),
    "open-loop": () => tracking(feedforward(reference, null, parameters)),
    "hover-lqr": () => tracking(hoverTracking(reference, data.hover_gain, parameters)),
    "kalman-lqr": ({ kalman }) => new KalmanController(task, gainsOf(kalman), kalman),
    residual: ({ learned }) =>
      learned && new ResidualController(trackingWith(learned.weights), task, learned, data.features),
  };
}

function once<T>(make: () => T): () => T {
  let value: T | undefined;
  return () => (value ??= make());
}
