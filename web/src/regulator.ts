// Section III-E: the time-varying linear quadratic regulator, by the Riccati equation (50) integrated backwards.

import { type Pair, type Parameters, linearise, rk4Step, virtualInput } from "./model";
import type { Plan } from "./plan";

/** The weights of (49), 6 x 6 and 2 x 2; M is the cost at the end. */
export interface Weights {
  Q: number[][];
  R: number[][];
  M: number[][];
}

const times = (A: number[][], B: number[][]) =>
  A.map((row) => B[0].map((_, j) => row.reduce((sum, a, k) => sum + a * B[k][j], 0)));
const transposed = (A: number[][]) => A[0].map((_, j) => A.map((row) => row[j]));

/** Gains K (2 x 6) of (51) at every second sample of a plan, one Runge-Kutta step lying between two of them. */
export function riccatiGains(plan: Plan, { Q, R, M }: Weights, parameters: Parameters): number[][][] {
  const [[r11, r12], [r21, r22]] = R;
  const det = r11 * r22 - r12 * r21;
  const inverse = [
    [r22 / det, -r12 / det],
    [-r21 / det, r11 / det],
  ];
  const linearised = plan.x.map((x, k) => {
    const { A, B } = linearise(x, virtualInput(plan.u[k], parameters), parameters);
    return { A, gain: times(inverse, transposed(B)) };
  });
  const last = plan.x.length - 1;

  /** (50), backwards in time; the symmetric P, row by row. */
  function derivative(flat: readonly number[], { A, gain }: (typeof linearised)[number]): number[] {
    const P = Array.from({ length: 6 }, (_, i) => flat.slice(6 * i, 6 * i + 6));
    const PA = times(P, A);
    const K = times(gain, P);
    const KRK = times(transposed(K), times(R, K));
    return P.flatMap((row, i) => row.map((_, j) => PA[i][j] + PA[j][i] - KRK[i][j] + Q[i][j]));
  }

  let P = M;
  const gains = [times(linearised[last].gain, P)];
  for (let k = last; k > 0; k -= 2) {
    const flat = rk4Step(derivative, P.flat(), [linearised[k], linearised[k - 1], linearised[k - 2]], 2 * plan.step);
    P = P.map((row, i) => row.map((_, j) => 0.5 * (flat[6 * i + j] + flat[6 * j + i])));
    gains.unshift(times(linearised[k - 2].gain, P));
  }
  return gains;
}

/** v - K (x - x_ref) in N: (51) around a feedforward v. */
export function feedback(v: Pair, K: number[][], measured: readonly number[], x: readonly number[]): Pair {
  const correct = (row: number[]) => row.reduce((sum, k, i) => sum + k * (measured[i] - x[i]), 0);
  return [v[0] - correct(K[0]), v[1] - correct(K[1])];
}
