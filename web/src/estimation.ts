// What a controller may assume beyond (3), as baselines/control/estimation.py has it: rotors that lag, a delay, and disturbances
// that it has to estimate.

import { type Matrix, diagonal, plus, scaled, solved, symmetric, times, transposed, zeros } from "./matrices";
import { type Parameters, dynamics, inverseDynamics, thrustVector } from "./equations";
import { type Model, type Pair, clip, inputAt, linearise, rk4Step } from "./model";

const ANGLES = [0, 2, 4];
const RATES = [1, 3, 5];

/** Rotors behind a commanded voltage. */
export interface Actuator {
  lag: number; // s, first order, of the rotor speed
  delay: number; // control periods
}

/** What the filter believes of its innovations. */
export interface Uncertainty {
  noise: { travel_disturbance: number; elevation_disturbance: number; pitch_disturbance: number; acceleration: number };
  encoder_noise: number; // rad
  start_deviations: [number, number, number]; // of angles (rad), rates (rad/s) and disturbances (rad/s²)
}

/** State, and rotor speeds as voltages, dt seconds later at the voltages u; disturbances are further accelerations. */
export function predict(
  x: readonly number[],
  w: Pair,
  u: Pair,
  disturbance: readonly number[],
  dt: number,
  { lag }: Actuator,
  parameters: Model,
): { x: number[]; rotors: Pair } {
  const turned = (time: number) => u.map((volts, i) => (lag ? volts + (w[i] - volts) * Math.exp(-time / lag) : volts)) as Pair;
  const derivative = (at: readonly number[], v: Pair) => {
    const dx = dynamics(at, v, parameters);
    RATES.forEach((rate, i) => (dx[rate] += disturbance[i]));
    return dx;
  };
  const [start, middle, end] = [0, 0.5, 1].map((share) => inputAt(turned(share * dt), parameters));
  return { x: rk4Step(derivative, x, [start, middle, end], dt), rotors: turned(dt) };
}

/** Transitions (n x n) and (n x m) over dt seconds of the system A, B with held inputs, by four terms of a series. */
export function discretised(A: Matrix, B: Matrix, dt: number): { A: Matrix; B: Matrix } {
  const n = A.length;
  const size = n + B[0].length;
  const generator = Array.from({ length: size }, (_, i) => (i < n ? [...A[i], ...B[i]] : new Array<number>(size).fill(0)));
  let term = diagonal(new Array<number>(size).fill(1));
  let total = term;
  for (let k = 1; k <= 4; k++) {
    term = scaled(times(generator, term), dt / k);
    total = plus(total, term);
  }
  const rows = total.slice(0, n);
  return { A: rows.map((row) => row.slice(0, n)), B: rows.map((row) => row.slice(n)) };
}

/** Gains (9 x 3) from the innovations of the angles to states and disturbances, along a reference, dt seconds apart. */
export function kalmanGains(
  x: number[][],
  v: Pair[],
  dt: number,
  parameters: Parameters,
  { noise, encoder_noise, start_deviations }: Uncertainty,
): Matrix[] {
  const drive = zeros(9, 6);
  const walks = [noise.travel_disturbance, noise.elevation_disturbance, noise.pitch_disturbance];
  RATES.forEach((rate, i) => {
    drive[rate][i] = noise.acceleration;
    drive[6 + i][3 + i] = walks[i];
  });
  const driven = times(drive, transposed(drive));
  const [onAngle, onRate, onDisturbance] = start_deviations.map((deviation) => deviation ** 2);
  let P = diagonal([onAngle, onRate, onAngle, onRate, onAngle, onRate, onDisturbance, onDisturbance, onDisturbance]);
  return x.map((at, k) => {
    const extended = zeros(9, 9);
    linearise(at, v[k], parameters).A.forEach((row, i) => row.forEach((value, j) => (extended[i][j] = value)));
    RATES.forEach((rate, i) => (extended[rate][6 + i] = 1));
    const { A } = discretised(extended, zeros(9, 1), dt);
    const seen = ANGLES.map((i) => P[i]);
    const S = seen.map((row, i) => ANGLES.map((j, column) => row[j] + (i === column ? encoder_noise ** 2 : 0)));
    const L = transposed(solved(S, seen));
    P = plus(P, times(L, seen), -1);
    // the noise of a period, by the trapezoidal rule: a random walk of the acceleration is felt in rate and angle too
    const process = plus(driven, times(A, times(driven, transposed(A))));
    P = symmetric(plus(times(A, times(P, transposed(A))), process, 0.5 * dt));
    return L;
  });
}

/** The reference x, v with the pitch and the thrusts that also outweigh disturbances on the three axes. */
export function disturbanceAccommodated(
  x: readonly number[],
  v: Pair,
  [onTravel, onElevation, onPitch]: readonly number[],
  pitchLimits: Pair,
  leastLift: number,
  p: Parameters,
): { x: number[]; v: Pair } {
  const [, ddq1, , ddq2, , ddq3] = dynamics(x, v, p);
  const [across, upright] = thrustVector(x, ddq1 - onTravel, ddq2 - onElevation, p);
  const tilted = x.with(4, clip(Math.atan2(across, Math.max(upright, leastLift)), pitchLimits));
  const [, v2] = inverseDynamics(tilted, ddq2 - onElevation, ddq3 - onPitch, p);
  return { x: tilted, v: [Math.hypot(across, upright), v2] };
}
