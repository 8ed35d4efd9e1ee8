// A plan from the coefficients of its splines, as baselines/planning/spline.py has it: elevation and pitch are uniform
// cubic B-splines of t/T, (13) gives the inputs, and the travel follows from (14a), integrated here.

import { basis, internalDynamics, inverseDynamics } from "./equations";
import { float32 } from "./matrices";
import { type Model, type Pair, hoverInput, rk4Step, voltages } from "./model";
import type { Plan } from "./plan";

export interface StoredSpline {
  duration: number; // s
  c: string; // base64 of float32, coefficients of elevation and pitch in turn, rad
}

const SUBSTEPS = 2;

/** The plan sampled every `step` s, from the start at zero to the goal, which is held if the duration is no multiple of 2 steps. */
export function splinePlan({ duration, c }: StoredSpline, goal: Pair, model: Model, step: number): Plan {
  const coefficients = float32(c);
  const segments = coefficients.length / 2 - 3;
  const rate = segments / duration;

  /** Elevation and pitch with their derivatives: [[elevation, pitch], rates, accelerations]. */
  function outputs(t: number): Pair[] {
    const place = segments * Math.min(Math.max(t / duration, 0), 1);
    const j = Math.min(Math.floor(place), segments - 1);
    return basis(place - j).map((values, order) => {
      const sum = (o: number) => rate ** order * values.reduce((total, value, i) => total + value * coefficients[2 * (j + i) + o], 0);
      return [sum(0), sum(1)];
    });
  }

  const state = ([angle, angleRate]: readonly number[], [y, dy]: Pair[]) => [angle, angleRate, y[0], dy[0], y[1], dy[1]];
  const derivative = (travel: readonly number[], t: number) => {
    const at = outputs(t);
    return [travel[1], internalDynamics(state(travel, at), at[2][0], model)];
  };
  const count = 2 * Math.ceil(duration / (2 * step) - 1e-9);
  const h = step / SUBSTEPS;
  const hover = voltages(hoverInput(goal[1], model), model);
  let travel: number[] = [0, 0];
  const x: number[][] = [];
  const u: Pair[] = [];
  for (let k = 0; k <= count; k++) {
    if (k * step >= duration - 1e-9) {
      x.push([goal[0], 0, goal[1], 0, 0, 0]);
      u.push(hover);
      continue;
    }
    const at = outputs(k * step);
    x.push(state(travel, at));
    u.push(voltages(inverseDynamics(x[k], at[2][0], at[2][1], model), model));
    for (let n = 0; n < SUBSTEPS; n++) {
      const t = k * step + n * h;
      travel = rk4Step(derivative, travel, [t, t + h / 2, t + h], h);
    }
  }
  return { step, x, u };
}
