// Written by web/translate.py from the Python functions of these names; change those, and run it again.

export interface Parameters {
  k_plus: number;
  k_minus: number;
  a1: number;
  a2: number;
  a3: number;
  b1: number;
  b2: number;
  b3: number;
  c1: number;
  c2: number;
  c3: number;
}

export interface RigidBody {
  l_h: number;
  l_p: number;
  l_c: number;
  g: number;
  m_h: number;
  m_c: number;
  r: number;
  d_h: number;
  d_c: number;
  e_h: number;
  kappa: number;
}

const TINY = 1e-30;
const COULOMB_RATE = 0.02;
const FOOT_SPREAD = 0.27;
const CONTACT_DAMPING = 1.0;
const CONTACT_FREQUENCY = 30.0;
const TURN = 6.283185307179586;

/** Equation (2): thrusts f in N of fans at the voltages u in V, element by element. */
export function thrust(u: number, parameters: Pick<Parameters, "k_plus" | "k_minus">): number {
  const even = parameters.k_plus + parameters.k_minus, odd = parameters.k_plus - parameters.k_minus;
  return 0.5 * (even * u + odd * Math.abs(u)) * u;
}

/** Thrust in N of a rotor at the voltage u in V: k_plus or k_minus (N/V^exponent) times (|u| - dead_zone)^exponent. */
export function powerThrust(u: number, kPlus: number, kMinus: number, exponent: number, deadZone: number): number {
  const excess = Math.abs(u) - deadZone;
  const magnitude = Math.pow(0.5 * (excess + Math.abs(excess)), exponent);
  const direction = u / (Math.abs(u) + TINY);
  return 0.5 * (kPlus + kMinus + (kPlus - kMinus) * direction) * magnitude;
}

/** Equation (4): sum and difference v = (v1, v2) of the thrusts f = (f_f, f_b), in N. */
export function virtualInput(f: readonly number[]): [number, number] {
  return [f[0] + f[1], f[0] - f[1]];
}

/** The inverse of (4): thrusts f = (f_f, f_b) with the sum and difference v = (v1, v2), in N. */
export function fanThrusts(v: readonly number[]): [number, number] {
  return [0.5 * (v[0] + v[1]), 0.5 * (v[0] - v[1])];
}

/** Equation (3) with viscous friction: time derivative of the state x (6, ...) under the inputs v (2, ...) in N. */
export function dynamics(x: readonly number[], v: readonly number[], parameters: Parameters): number[] {
  const [, dq1, q2, dq2, q3, dq3] = x;
  const [v1, v2] = v;
  const p = parameters;
  const ddq1 = p.b1 * Math.cos(q2) * Math.sin(q3) * v1 - p.c1 * dq1;
  const ddq2 = p.a1 * Math.sin(q2) + p.a2 * Math.cos(q2) + p.b2 * Math.cos(q3) * v1 - p.c2 * dq2;
  const ddq3 = p.a3 * Math.cos(q2) * Math.sin(q3) + p.b3 * v2 - p.c3 * dq3;
  return [dq1, ddq1, dq2, ddq2, dq3, ddq3];
}

/** Solution (x1, x2) of a x1 + b x2 = y1 and c x1 + d x2 = y2. */
export function solve_2x2(a: number, b: number, c: number, d: number, y1: number, y2: number): [number, number] {
  const determinant = a * d - b * c;
  return [(d * y1 - b * y2) / determinant, (a * y2 - c * y1) / determinant];
}

/** Invert (3b) and (3c): inputs v (2, ...) in N for accelerations of elevation and pitch in rad/s², at states x. */
export function inverseDynamics(x: readonly number[], ddq2: number, ddq3: number, parameters: Parameters): [number, number] {
  const [, , , elevation, , pitch] = dynamics(x, [0, 0], parameters);
  const [, , , elevation_1, , pitch_1] = dynamics(x, [1, 0], parameters);
  const [, , , elevation_2, , pitch_2] = dynamics(x, [0, 1], parameters);
  return solve_2x2(elevation_1 - elevation, elevation_2 - elevation, pitch_1 - pitch, pitch_2 - pitch, ddq2 - elevation, ddq3 - pitch);
}

/** Invert (3a) and (3b): components (v1 sin q3, v1 cos q3) in N of the thrust that accelerates travel and elevation. */
export function thrustVector(x: readonly number[], ddq1: number, ddq2: number, parameters: Parameters): [number, number] {
  const [q1, dq1, q2, dq2, , dq3] = x;
  const upright = [q1, dq1, q2, dq2, 0 * q2, dq3], tilted = [q1, dq1, q2, dq2, 0 * q2 + 0.5 * Math.PI, dq3];
  const [, travel, , elevation, , ] = dynamics(upright, [0, 0], parameters);
  const [, travelU, , elevationU, , ] = dynamics(upright, [1, 0], parameters);
  const [, travelT, , elevationT, , ] = dynamics(tilted, [1, 0], parameters);
  return solve_2x2(travelT - travel, travelU - travel, elevationT - elevation, elevationU - elevation, ddq1 - travel, ddq2 - elevation);
}

/** (D11, D22, D33, D12, D13, D23) in kg m² of (q1, eps, phi), from the cosines and sines of eps and phi. */
export function massMatrix(ce: number, se: number, cf: number, sf: number, p: RigidBody): number[] {
  const z = p.e_h - p.d_h * cf;
  const D11 = p.m_c * (p.l_c * ce - p.d_c * se) ** 2 + p.m_h * ((p.l_h * ce - z * se) ** 2 + p.r ** 2 * (1 - ce ** 2 * sf ** 2) + p.d_h ** 2 * sf ** 2);
  const D22 = p.m_c * (p.l_c ** 2 + p.d_c ** 2) + p.m_h * (p.l_h ** 2 + z ** 2 + p.r ** 2 * sf ** 2);
  const D33 = p.m_h * (p.r ** 2 + p.d_h ** 2);
  const D12 = p.m_h * sf * (p.r ** 2 * ce * cf + p.d_h * (p.l_h * se + z * ce));
  const D13 = p.m_h * ((p.r ** 2 + p.d_h ** 2) * se + p.d_h * cf * (p.l_h * ce - p.e_h * se));
  const D23 = p.m_h * p.d_h * p.l_h * sf;
  return [D11, D22, D33, D12, D13, D23];
}

/** Coriolis and centrifugal torques in N m at the rates w of (q1, eps, phi): the Christoffel symbols of D. */
export function coriolis(ce: number, se: number, cf: number, sf: number, w1: number, w2: number, w3: number, p: RigidBody): number[] {
  const z = p.e_h - p.d_h * cf;
  const radius = p.l_h * ce - z * se, height = p.l_h * se + z * ce;
  const radiusC = p.l_c * ce - p.d_c * se, heightC = p.l_c * se + p.d_c * ce;
  const D11_e = 2 * p.m_h * (p.r ** 2 * ce * se * sf ** 2 - radius * height) - 2 * p.m_c * radiusC * heightC;
  const D12_e = p.m_h * sf * (p.d_h * radius - p.r ** 2 * se * cf);
  const D13_e = p.m_h * ((p.r ** 2 + p.d_h ** 2) * ce - p.d_h * cf * (p.l_h * se + p.e_h * ce));
  const D11_f = 2 * p.m_h * sf * (cf * (p.d_h ** 2 - p.r ** 2 * ce ** 2) - p.d_h * se * radius);
  const D22_f = 2 * p.m_h * sf * (p.d_h * z + p.r ** 2 * cf);
  const D12_f = p.m_h * (p.r ** 2 * ce * (cf ** 2 - sf ** 2) + p.d_h * (cf * height + p.d_h * sf ** 2 * ce));
  const D13_f = -p.m_h * p.d_h * sf * (p.l_h * ce - p.e_h * se);
  const D23_f = p.m_h * p.d_h * p.l_h * cf;
  return [w1 * (D11_e * w2 + D11_f * w3) + D12_e * w2 ** 2 + (D12_f + D13_e) * w2 * w3 + D13_f * w3 ** 2, -0.5 * D11_e * w1 ** 2 + (D12_f - D13_e) * w1 * w3 + D22_f * w2 * w3 + D23_f * w3 ** 2, -0.5 * D11_f * w1 ** 2 + (D13_e - D12_f) * w1 * w2 - 0.5 * D22_f * w2 ** 2];
}

/** Gradient of the potential energy in N m. */
export function gravity(ce: number, se: number, cf: number, sf: number, p: RigidBody): number[] {
  const out = p.m_h * (p.l_h * ce - (p.e_h - p.d_h * cf) * se) - p.m_c * (p.l_c * ce - p.d_c * se);
  return [0, p.g * out, p.g * p.m_h * p.d_h * sf * ce];
}

/** Torques in N m of the thrust and drag of the two rotors, which turn in opposite directions. */
export function generalisedForces(ce: number, se: number, cf: number, sf: number, v1: number, v2: number, p: RigidBody): number[] {
  const drag = -p.kappa * v2;
  return [-v1 * sf * (p.l_h * ce - p.e_h * se) + p.l_p * se * v2 + drag * ce * cf, p.l_h * cf * v1 + drag * sf, p.l_p * v2];
}

/** Solve D a = f for a, by cofactors. */
export function solveSymmetric(D: readonly number[], f: readonly number[]): number[] {
  const [D11, D22, D33, D12, D13, D23] = D;
  const [f1, f2, f3] = f;
  const C11 = D22 * D33 - D23 ** 2, C22 = D11 * D33 - D13 ** 2, C33 = D11 * D22 - D12 ** 2;
  const C12 = D13 * D23 - D12 * D33, C13 = D12 * D23 - D13 * D22, C23 = D12 * D13 - D11 * D23;
  const det = D11 * C11 + D12 * C12 + D13 * C13;
  return [(C11 * f1 + C12 * f2 + C13 * f3) / det, (C12 * f1 + C22 * f2 + C23 * f3) / det, (C13 * f1 + C23 * f2 + C33 * f3) / det];
}

/** Time derivative of the state x (6, ...) under the virtual input v (2, ...) in N, in the full model. */
export function rigidDynamics(x: readonly number[], v: readonly number[], p: RigidBody): number[] {
  const [, dq1, q2, dq2, q3, dq3] = x;
  const [v1, v2] = v;
  const ce = Math.cos(q2), se = -Math.sin(q2), cf = Math.cos(q3), sf = Math.sin(q3);
  const D = massMatrix(ce, se, cf, sf, p);
  const [c1, c2, c3] = coriolis(ce, se, cf, sf, dq1, -dq2, dq3, p);
  const [g1, g2, g3] = gravity(ce, se, cf, sf, p);
  const [Q1, Q2, Q3] = generalisedForces(ce, se, cf, sf, v1, v2, p);
  const [ddq1, ddeps, ddq3] = solveSymmetric(D, [Q1 - c1 - g1, Q2 - c2 - g2, Q3 - c3 - g3]);
  return [dq1, ddq1, dq2, -ddeps, dq3, ddq3];
}

/** Friction as a deceleration in rad/s² at a rate in rad/s. */
export function friction(rate: number, viscous: number, coulomb: number): number {
  return viscous * rate + coulomb * rate / (rate * rate + COULOMB_RATE * COULOMB_RATE) ** 0.5;
}

/** Add friction (3, ...) and disturbances to the time derivative dx (6, ...) of a model's state x. */
export function withFrictionAndDisturbances(x: readonly number[], dx: readonly number[], viscous: readonly number[], coulomb: readonly number[], torques: readonly number[]): number[] {
  const [dq1, ddq1, dq2, ddq2, dq3, ddq3] = dx;
  const [onTravel, onElevation, onPitch, a2Change] = torques;
  return [dq1, ddq1 + onTravel - friction(dq1, viscous[0], coulomb[0]), dq2, ddq2 + onElevation + a2Change * Math.cos(x[2]) - friction(dq2, viscous[1], coulomb[1]), dq3, ddq3 + onPitch - friction(dq3, viscous[2], coulomb[2])];
}

/** Add the elevation acceleration due to the travel rate to the derivative dx (6, ...); travel_lift in 1/rad. */
export function withLift(dx: readonly number[], travelLift: number): number[] {
  const [dq1, ddq1, dq2, ddq2, dq3, ddq3] = dx;
  return [dq1, ddq1, dq2, ddq2 + travelLift * dq1 * dq1, dq3, ddq3];
}

/** Add the moments of `Coupling` to the time derivative dx (6, ...) of the state x. */
export function withCoupling(x: readonly number[], dx: readonly number[], speed: number, parameters: Parameters, coupling: readonly number[]): number[] {
  const [, w1, q2, w2, q3, w3] = x;
  const [dq1, ddq1, dq2, ddq2, dq3, ddq3] = dx;
  const p = parameters, [centrifugal, centre, spin, gyro, airflow] = coupling;
  const up = Math.sin(q2 - centre), along = Math.cos(q2 - centre), sine = Math.sin(q3), cosine = Math.cos(q3);
  const reaction = gyro * FOOT_SPREAD * p.b2 / p.b3 * w3;
  return [dq1, ddq1 + 2 * centrifugal * up / along * w1 * w2 + reaction * sine, dq2, ddq2 - centrifugal * up * along * w1 * w1 + reaction * cosine, dq3, ddq3 + airflow * speed * w1 - spin * sine * cosine * (w1 * w1 - w2 * w2) + gyro * (w2 * cosine + w1 * sine)];
}

/** Force in N of the table on a foot that is `depth` rad of elevation below its top and sinks at a rate in rad/s. */
export function footForce(depth: number, rate: number, b2: number): number {
  const deep = 0.5 * (depth + Math.abs(depth));
  const damping = 2 * CONTACT_DAMPING * CONTACT_FREQUENCY * deep / (deep + 0.001);
  const force = 0.5 * (CONTACT_FREQUENCY * CONTACT_FREQUENCY * deep + damping * rate) / Math.abs(b2);
  return 0.5 * (force + Math.abs(force));
}

/** Add the forces of a table (rad, friction) on two feet to the time derivative dx (6, ...) of the state x. */
export function withContact(x: readonly number[], dx: readonly number[], parameters: Parameters, table: readonly number[]): number[] {
  const [dq1, ddq1, dq2, ddq2, dq3, ddq3] = dx;
  const p = parameters, [elevation, coefficient] = table;
  const turn = FOOT_SPREAD * Math.cos(x[4]) * dq3, spread = FOOT_SPREAD * Math.sin(x[4]);
  const front = footForce(x[2] - spread - elevation, dq2 - turn, p.b2);
  const back = footForce(x[2] + spread - elevation, dq2 + turn, p.b2);
  const normal = front + back;
  const slip = dq1 / (dq1 * dq1 + COULOMB_RATE * COULOMB_RATE) ** 0.5;
  return [dq1, ddq1 - Math.abs(p.b1) * coefficient * normal * slip, dq2, ddq2 - Math.abs(p.b2) * normal, dq3, ddq3 + p.b3 * (front - back)];
}

/** The angle in rad as an encoder with this many counts per revolution reads it. */
export function quantise(angle: number, counts: number): number {
  const count = TURN / counts;
  return count * Math.floor(angle / count + 0.5);
}

/** Equation (14a): second derivative of the travel, v1 eliminated from (11c) by (13a). */
export function internalDynamics(x: readonly number[], ddy1: number, p: Parameters): number {
  return dynamics(x, inverseDynamics(x, ddy1, 0, p), p)[1];
}

/** Uniform cubic B-splines at u in [0, 1] of a segment: four values, four first and four second derivatives. */
export function basis(u: number): number[][] {
  const w = 1 - u;
  return [[w ** 3 / 6, (3 * u ** 3 - 6 * u ** 2 + 4) / 6, (3 * w ** 3 - 6 * w ** 2 + 4) / 6, u ** 3 / 6], [-0.5 * w ** 2, 1.5 * u ** 2 - 2 * u, 0.5 + u - 1.5 * u ** 2, 0.5 * u ** 2], [w, 3 * u - 2, 1 - 3 * u, u]];
}
