// Thrust over voltage, as heli_gym/thrust_map.py has it: power laws, among them (2), and measured points.

import { powerThrust, thrust } from "./equations";

export interface PowerCurve {
  k_plus: number; // N/V^exponent
  k_minus: number;
  exponent: number;
  dead_zone: number; // V
}

/** Measured points and the cubics between them: (4, K - 1), the highest power first. */
export interface TableCurve {
  voltages: number[];
  thrusts: number[];
  cubics: number[][];
}

export type Curve = PowerCurve | TableCurve;

const BISECTIONS = 60;

/** Thrust in N at the voltage u in V. */
export function thrustAt(u: number, curve: Curve): number {
  if ("cubics" in curve) return tableThrust(u, curve);
  const { k_plus, k_minus, exponent, dead_zone } = curve;
  if (exponent === 2 && dead_zone === 0) return thrust(u, curve);
  return powerThrust(u, k_plus, k_minus, exponent, dead_zone);
}

/** The inverse: voltage in V for the thrust f in N; 0 V where the rotor has no backward thrust. */
export function voltageFor(f: number, curve: Curve): number {
  if ("cubics" in curve) return tableVoltage(f, curve);
  const k = f >= 0 ? curve.k_plus : curve.k_minus;
  const ratio = k === 0 ? 0 : f / k;
  const beyond = curve.exponent === 2 ? Math.sqrt(ratio) : ratio ** (1 / curve.exponent);
  return Math.sign(f) * (beyond + (ratio > 0 ? curve.dead_zone : 0));
}

const cubic = ({ cubics: [c3, c2, c1, c0] }: TableCurve, k: number, s: number) => ((c3[k] * s + c2[k]) * s + c1[k]) * s + c0[k];

/** Index of the piece of a rising sequence in which a value is. */
function piece(values: number[], value: number): number {
  const k = values.findIndex((other) => other >= value);
  return Math.min(Math.max((k < 0 ? values.length : k) - 1, 0), values.length - 2);
}

/** Slopes in N/V below the first and above the last point. */
function endSlopes({ voltages: u, thrusts: f }: TableCurve): [number, number] {
  const n = u.length - 1;
  return [(f[1] - f[0]) / (u[1] - u[0]), (f[n] - f[n - 1]) / (u[n] - u[n - 1])];
}

function tableThrust(u: number, curve: TableCurve): number {
  const { voltages } = curve;
  const inside = Math.min(Math.max(u, voltages[0]), voltages.at(-1)!);
  const k = piece(voltages, inside);
  const [low, high] = endSlopes(curve);
  return cubic(curve, k, inside - voltages[k]) + low * Math.min(u - inside, 0) + high * Math.max(u - inside, 0);
}

function tableVoltage(f: number, curve: TableCurve): number {
  const { voltages, thrusts } = curve;
  if (f === tableThrust(0, curve)) return 0;
  const k = piece(thrusts, f);
  const target = Math.min(Math.max(f, thrusts[0]), thrusts.at(-1)!);
  let [low, high] = [0, voltages[k + 1] - voltages[k]];
  for (let n = 0; n < BISECTIONS; n++) {
    const s = 0.5 * (low + high);
    if (cubic(curve, k, s) < target) low = s;
    else high = s;
  }
  const [below, above] = endSlopes(curve);
  return voltages[k] + high + Math.min(f - thrusts[0], 0) / below + Math.max(f - thrusts.at(-1)!, 0) / above;
}
