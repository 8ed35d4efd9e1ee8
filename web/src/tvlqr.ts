// Section III-E: the time-varying linear quadratic regulator, by the Riccati equation (50) integrated backwards.

import { type Matrix, solved, symmetric, times, transposed } from "./matrices";
import { type Model, hoverInput, inputAt, linearise, rk4Step } from "./model";
import type { Plan } from "./plan";

/** The weights of (49), 6 x 6 and 2 x 2; M is the cost at the end. */
export interface Weights {
  Q: Matrix;
  R: Matrix;
  M: Matrix;
}

const SETTLING = 40; // s, after which the Riccati equation stands still
const SETTLING_STEP = 0.05; // s

/** The weights with the cost M of holding hover at an elevation for ever: (50), integrated until it stands still. */
export function withStationaryCost({ Q, R }: Omit<Weights, "M">, elevation: number, parameters: Model): Weights {
  const x = [0, 0, elevation, 0, 0, 0];
  const { A, B } = linearise(x, hoverInput(elevation, parameters), parameters);
  const at = { A, gain: solved(R, transposed(B)) };
  let flat = Q.flat();
  for (let t = 0; t < SETTLING; t += SETTLING_STEP) {
    flat = rk4Step((P, where) => riccatiDerivative(P, where, Q, R), flat, [at, at, at], SETTLING_STEP);
  }
  return { Q, R, M: symmetric(rows(flat)) };
}

const rows = (flat: readonly number[]): Matrix => Array.from({ length: 6 }, (_, i) => flat.slice(6 * i, 6 * i + 6));

/** (50), backwards in time; the symmetric P, row by row. */
function riccatiDerivative(flat: readonly number[], { A, gain }: { A: Matrix; gain: Matrix }, Q: Matrix, R: Matrix): number[] {
  const P = rows(flat);
  const PA = times(P, A);
  const K = times(gain, P);
  const KRK = times(transposed(K), times(R, K));
  return P.flatMap((row, i) => row.map((_, j) => PA[i][j] + PA[j][i] - KRK[i][j] + Q[i][j]));
}

/** Gains K (2 x 6) of (51) at every second sample of a plan, one Runge-Kutta step lying between two of them. */
export function riccatiGains(plan: Plan, { Q, R, M }: Weights, parameters: Model): Matrix[] {
  const linearised = plan.x.map((x, k) => {
    const { A, B } = linearise(x, inputAt(plan.u[k], parameters), parameters);
    return { A, gain: solved(R, transposed(B)) };
  });
  const last = plan.x.length - 1;
  let P = M;
  const gains = [times(linearised[last].gain, P)];
  for (let k = last; k > 0; k -= 2) {
    const flat = rk4Step((z, where) => riccatiDerivative(z, where, Q, R), P.flat(), [linearised[k], linearised[k - 1], linearised[k - 2]], 2 * plan.step);
    P = symmetric(rows(flat));
    gains.unshift(times(linearised[k - 2].gain, P));
  }
  return gains;
}
