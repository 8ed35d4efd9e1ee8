// The linear quadratic regulator on the control grid for rotors that lag, as baselines/control/discrete_lqr.py has it.

import { discretised } from "./estimation";
import { type Matrix, plus, scaled, solved, symmetric, times, transposed } from "./matrices";
import type { Parameters } from "./equations";
import { type Pair, linearise } from "./model";
import type { Weights } from "./tvlqr";

/** (3), linearised, with v as two more states, which follow the commanded v with a lag in s. */
function augmented(x: readonly number[], v: Pair, lag: number, parameters: Parameters): { A: Matrix; B: Matrix } {
  const { A, B } = linearise(x, v, parameters);
  return {
    A: [...A.map((row, i) => [...row, ...B[i]]), [0, 0, 0, 0, 0, 0, -1 / lag, 0], [0, 0, 0, 0, 0, 0, 0, -1 / lag]],
    B: [...B.map(() => [0, 0]), [1 / lag, 0], [0, 1 / lag]],
  };
}

/** Gains (2 x 8) along a reference, dt seconds apart, backwards from the cost M of holding hover at its end for ever. */
export function regulatorGains(
  x: number[][],
  v: Pair[],
  dt: number,
  parameters: Parameters,
  weights: Weights,
  lag: number,
): Matrix[] {
  const [Q, R] = [scaled(weights.Q, dt), scaled(weights.R, dt)];
  let P = weights.M;
  const gains: Matrix[] = [];
  for (let k = x.length - 1; k >= 0; k--) {
    const continuous = augmented(x[k], v[k], lag, parameters);
    const { A, B } = discretised(continuous.A, continuous.B, dt);
    const [PA, PB] = [times(P, A), times(P, B)];
    const K = solved(plus(R, times(transposed(B), PB)), times(transposed(PB), A));
    P = symmetric(plus(Q, times(transposed(A), plus(PA, times(PB, K), -1))));
    gains.push(K);
  }
  return gains.reverse();
}
