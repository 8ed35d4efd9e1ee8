// The paper's plan from its free parameters: with p of (39) known, the boundary value problem (38) is an initial value
// problem. Python solves for p (baselines/paper/boundary_value.py); here it is integrated forwards.

import { type Model, type Pair, clip, hoverInput, rk4Step, thrusts, voltages } from "./model";

export interface Maneuver {
  duration: number; // s
  goal: Pair; // travel and elevation in rad; the start is at zero
  limits: { u: Pair; pitch: Pair }; // V, rad
}

/** States (K x 6) and voltages (K x 2) at times `step` s apart, from 0 to the duration. */
export interface Plan {
  step: number;
  x: number[][];
  u: Pair[];
}

const SUBSTEPS = 4;

/** The plan with the parameters p1, p2 of the ansatz (39), sampled at steps of `step` s, which divides the duration. */
export function integratePlan(
  maneuver: Maneuver,
  [p1, p2]: [number[], number[]],
  pitchReserve: number,
  parameters: Model,
  step: number,
): Plan {
  const { duration, goal, limits } = maneuver;
  const p = parameters;
  const [low, high] = limits.pitch.map((bound) => bound * (1 - pitchReserve));
  const [fMin, fMax] = limits.u.map((u) => thrusts([u, u], p)[0]);

  const phi = (coefficients: number[], tau: number) =>
    coefficients.reduce((sum, c, k) => sum + c * (tau ** (k + 2) - tau), 0);

  /** (25), (30)-(34), (37), then (13): the pitch and its rate, the accelerations and the inputs. */
  function motion(t: number, [y1, , xi1, xi2]: readonly number[]) {
    const m = 4 / (high - low);
    const sigma = 0.5 * (1 + Math.tanh(0.5 * m * xi1)); // (27)
    const y2 = low + (high - low) * sigma;
    const slope = 4 * sigma * (1 - sigma);
    const bend = m * slope * (1 - 2 * sigma) * xi2 ** 2;
    const weight1 = p.a1 * Math.sin(y1) + p.a2 * Math.cos(y1);
    const weight2 = p.a3 * Math.cos(y1) * Math.sin(y2);
    const dxi2 = clip(phi(p2, t / duration), [
      (weight2 + p.b3 * (fMin - fMax) - bend) / slope, // (33), with (18) and (23)
      (weight2 + p.b3 * (fMax - fMin) - bend) / slope,
    ]);
    const v2 = (bend + slope * dxi2 - weight2) / p.b3;
    const lift = p.b2 * Math.cos(y2); // negative: the greatest v1 gives the lowest acceleration in (22)
    const ddy1 = clip(phi(p1, t / duration), [
      weight1 + lift * (2 * fMax - Math.abs(v2)), // (20)
      weight1 + lift * (2 * fMin + Math.abs(v2)),
    ]);
    return { y2, dy2: slope * xi2, dxi2, ddy1, v: [(ddy1 - weight1) / lift, v2] as Pair };
  }

  /** (38), where (14a) is (3) with v1 put in. */
  function derivative(Y: readonly number[], t: number): number[] {
    const { y2, dxi2, ddy1, v } = motion(t, Y);
    return [Y[1], ddy1, Y[3], dxi2, Y[5], p.b1 * Math.cos(Y[0]) * Math.sin(y2) * v[0]];
  }

  const count = Math.round(duration / step);
  const xi1 = ((high - low) / 4) * Math.log(-low / high); // (35): no pitch at the start
  let Y = [0, 0, xi1, 0, 0, 0]; // y1, its rate, xi1, xi2, eta, its rate
  const x: number[][] = [];
  const u: Pair[] = [];
  const h = step / SUBSTEPS;
  for (let k = 0; k <= count; k++) {
    const [y1, dy1, , , eta, deta] = Y;
    const { y2, dy2, v } = motion(k * step, Y);
    x.push([eta, deta, y1, dy1, y2, dy2]);
    u.push(voltages(v, p));
    for (let n = 0; n < SUBSTEPS; n++) {
      const t = k * step + n * h;
      Y = rk4Step(derivative, Y, [t, t + h / 2, t + h], h);
    }
  }
  // The parameters are as exact as the solver's tolerance; what is held after the maneuver is the goal.
  x[count] = [goal[0], 0, goal[1], 0, 0, 0];
  u[count] = voltages(hoverInput(goal[1], p), p);
  return { step, x, u };
}
