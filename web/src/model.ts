// Equations (2)-(4) of the paper, as heli_gym/model.py has them; the numbers come from Python. SI units and radians.

export type Pair = [number, number];

export const clip = (value: number, [low, high]: Pair) => Math.min(Math.max(value, low), high);

/** Table I. */
export interface Parameters {
  k_plus: number;
  k_minus: number;
  a1: number;
  a2: number;
  a3: number;
  b1: number;
  b2: number;
  b3: number;
}

/** (2): thrust in N of a fan at the voltage u in V. */
export function thrust(u: number, p: Parameters): number {
  const even = p.k_plus + p.k_minus;
  const odd = p.k_plus - p.k_minus;
  return 0.5 * (even * u + odd * Math.abs(u)) * u;
}

/** The inverse of (2). */
export function voltage(f: number, p: Parameters): number {
  return Math.sign(f) * Math.sqrt(f / (f >= 0 ? p.k_plus : p.k_minus));
}

/** (4): sum and difference v in N of the thrusts at the voltages u. */
export function virtualInput(u: Pair, p: Parameters): Pair {
  const front = thrust(u[0], p);
  const back = thrust(u[1], p);
  return [front + back, front - back];
}

/** The voltages in V of the virtual inputs v in N. */
export function voltages(v: Pair, p: Parameters): Pair {
  return [voltage(0.5 * (v[0] + v[1]), p), voltage(0.5 * (v[0] - v[1]), p)];
}

/** (3): time derivative of the state x = (travel, elevation, pitch, each with its rate) under v. */
export function dynamics(x: readonly number[], v: Pair, p: Parameters): number[] {
  const [, dq1, q2, dq2, q3, dq3] = x;
  const [v1, v2] = v;
  return [
    dq1,
    p.b1 * Math.cos(q2) * Math.sin(q3) * v1,
    dq2,
    p.a1 * Math.sin(q2) + p.a2 * Math.cos(q2) + p.b2 * Math.cos(q3) * v1,
    dq3,
    p.a3 * Math.cos(q2) * Math.sin(q3) + p.b3 * v2,
  ];
}

/** (47), (48): A (6 x 6) and B (6 x 2) about x and v, by differences of order four, so that they cannot drift from (3). */
export function linearise(x: readonly number[], v: Pair, p: Parameters): { A: number[][]; B: number[][] } {
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
export function hoverInput(elevation: number, p: Parameters): Pair {
  return [-(p.a1 * Math.sin(elevation) + p.a2 * Math.cos(elevation)) / p.b2, 0];
}

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
