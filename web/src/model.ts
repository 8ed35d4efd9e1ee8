// What controllers and plants need of the model besides its equations, which equations.ts has from Python.

import { type Parameters, dynamics, fanThrusts, inverseDynamics, virtualInput } from "./equations";
import { type Curve, thrustAt, voltageFor } from "./thrust";

export type Pair = [number, number];

export const clip = (value: number, [low, high]: Pair) => Math.min(Math.max(value, low), high);

/** The coefficients of (3) with the thrust curves of both rotors. */
export interface Model extends Parameters {
  front: Curve;
  back: Curve;
}

/** Thrusts in N at the voltages u. */
export const thrusts = (u: Readonly<Pair>, m: Model): Pair => [thrustAt(u[0], m.front), thrustAt(u[1], m.back)];

/** (4): sum and difference v in N of the thrusts at the voltages u. */
export const inputAt = (u: Readonly<Pair>, m: Model): Pair => virtualInput(thrusts(u, m));

/** The voltages in V of the virtual inputs v in N. */
export function voltages(v: Readonly<Pair>, m: Model): Pair {
  const [front, back] = fanThrusts(v);
  return [voltageFor(front, m.front), voltageFor(back, m.back)];
}

/** The range of thrust in N that both rotors reach in a window of voltages. */
export function thrustBounds([low, high]: Readonly<Pair>, m: Model): Pair {
  return [Math.max(...thrusts([low, low], m)), Math.min(...thrusts([high, high], m))];
}

/** (47), (48): A (6 x 6) and B (6 x 2) about x and v, by differences of order four, so that they cannot drift from (3). */
export function linearise(x: readonly number[], v: Readonly<Pair>, p: Parameters): { A: number[][]; B: number[][] } {
  const z = [...x, ...v];
  const step = 1e-3;
  const columns = z.map((_, j) => {
    const at = (h: number) => {
      const moved = z.with(j, z[j] + h);
      return dynamics(moved.slice(0, 6), [moved[6], moved[7]], p);
    };
    const difference = (h: number) => {
      const [ahead, behind] = [at(h), at(-h)];
      return ahead.map((value, i) => (value - behind[i]) / (2 * h));
    };
    const [near, far] = [difference(step), difference(2 * step)];
    return near.map((value, i) => (4 * value - far[i]) / 3);
  });
  const rows = x.map((_, i) => columns.map((column) => column[i]));
  return { A: rows.map((row) => row.slice(0, 6)), B: rows.map((row) => row.slice(6)) };
}

/** v that holds (3) at rest at an elevation in rad. */
export const hoverInput = (elevation: number, p: Parameters): Pair => inverseDynamics([0, 0, elevation, 0, 0, 0], 0, 0, p);

/** The state dt seconds later, by one Runge-Kutta step of order four; the inputs are those at its start, middle, end. */
export function rk4Step<Input>(
  derivative: (z: readonly number[], input: Input) => number[],
  z: readonly number[],
  [start, middle, end]: [Input, Input, Input],
  dt: number,
): number[] {
  const moved = (h: number, d: number[]) => z.map((a, i) => a + h * d[i]);
  const d1 = derivative(z, start);
  const d2 = derivative(moved(dt / 2, d1), middle);
  const d3 = derivative(moved(dt / 2, d2), middle);
  const d4 = derivative(moved(dt, d3), end);
  return z.map((a, i) => a + (dt / 6) * (d1[i] + 2 * (d2[i] + d3[i]) + d4[i]));
}
