// The full rigid body of heli_gym/rigid_body.py, whose docstrings explain it. Its parameters are solved for in Python.

import type { Pair } from "./model";

export interface Rig {
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

type Angles = { ce: number; se: number; cf: number; sf: number };
type Triple = [number, number, number];
type Symmetric = [number, number, number, number, number, number]; // 11, 22, 33, 12, 13, 23

function massMatrix({ ce, se, cf, sf }: Angles, p: Rig): Symmetric {
  const z = p.e_h - p.d_h * cf;
  const r2 = p.r ** 2;
  return [
    p.m_c * (p.l_c * ce - p.d_c * se) ** 2 +
      p.m_h * ((p.l_h * ce - z * se) ** 2 + r2 * (1 - ce ** 2 * sf ** 2) + p.d_h ** 2 * sf ** 2),
    p.m_c * (p.l_c ** 2 + p.d_c ** 2) + p.m_h * (p.l_h ** 2 + z ** 2 + r2 * sf ** 2),
    p.m_h * (r2 + p.d_h ** 2),
    p.m_h * sf * (r2 * ce * cf + p.d_h * (p.l_h * se + z * ce)),
    p.m_h * ((r2 + p.d_h ** 2) * se + p.d_h * cf * (p.l_h * ce - p.e_h * se)),
    p.m_h * p.d_h * p.l_h * sf,
  ];
}

function coriolis({ ce, se, cf, sf }: Angles, [w1, w2, w3]: Triple, p: Rig): Triple {
  const z = p.e_h - p.d_h * cf;
  const r2 = p.r ** 2;
  const radius = p.l_h * ce - z * se;
  const height = p.l_h * se + z * ce;
  const radiusC = p.l_c * ce - p.d_c * se;
  const heightC = p.l_c * se + p.d_c * ce;
  const D11e = 2 * p.m_h * (r2 * ce * se * sf ** 2 - radius * height) - 2 * p.m_c * radiusC * heightC;
  const D12e = p.m_h * sf * (p.d_h * radius - r2 * se * cf);
  const D13e = p.m_h * ((r2 + p.d_h ** 2) * ce - p.d_h * cf * (p.l_h * se + p.e_h * ce));
  const D11f = 2 * p.m_h * sf * (cf * (p.d_h ** 2 - r2 * ce ** 2) - p.d_h * se * radius);
  const D22f = 2 * p.m_h * sf * (p.d_h * z + r2 * cf);
  const D12f = p.m_h * (r2 * ce * (cf ** 2 - sf ** 2) + p.d_h * (cf * height + p.d_h * sf ** 2 * ce));
  const D13f = -p.m_h * p.d_h * sf * (p.l_h * ce - p.e_h * se);
  const D23f = p.m_h * p.d_h * p.l_h * cf;
  return [
    w1 * (D11e * w2 + D11f * w3) + D12e * w2 ** 2 + (D12f + D13e) * w2 * w3 + D13f * w3 ** 2,
    -0.5 * D11e * w1 ** 2 + (D12f - D13e) * w1 * w3 + D22f * w2 * w3 + D23f * w3 ** 2,
    -0.5 * D11f * w1 ** 2 + (D13e - D12f) * w1 * w2 - 0.5 * D22f * w2 ** 2,
  ];
}

function gravity({ ce, se, cf, sf }: Angles, p: Rig): Triple {
  const out = p.m_h * (p.l_h * ce - (p.e_h - p.d_h * cf) * se) - p.m_c * (p.l_c * ce - p.d_c * se);
  return [0, p.g * out, p.g * p.m_h * p.d_h * sf * ce];
}

function generalisedForces({ ce, se, cf, sf }: Angles, [v1, v2]: Pair, p: Rig): Triple {
  const drag = -p.kappa * v2;
  return [
    -v1 * sf * (p.l_h * ce - p.e_h * se) + p.l_p * se * v2 + drag * ce * cf,
    p.l_h * cf * v1 + drag * sf,
    p.l_p * v2,
  ];
}

function solveSymmetric([D11, D22, D33, D12, D13, D23]: Symmetric, [f1, f2, f3]: Triple): Triple {
  const C11 = D22 * D33 - D23 ** 2;
  const C22 = D11 * D33 - D13 ** 2;
  const C33 = D11 * D22 - D12 ** 2;
  const C12 = D13 * D23 - D12 * D33;
  const C13 = D12 * D23 - D13 * D22;
  const C23 = D12 * D13 - D11 * D23;
  const det = D11 * C11 + D12 * C12 + D13 * C13;
  return [
    (C11 * f1 + C12 * f2 + C13 * f3) / det,
    (C12 * f1 + C22 * f2 + C23 * f3) / det,
    (C13 * f1 + C23 * f2 + C33 * f3) / det,
  ];
}

/** Time derivative of the state x under v, in the full model. */
export function rigidDynamics(x: readonly number[], v: Pair, p: Rig): number[] {
  const [, dq1, q2, dq2, q3, dq3] = x;
  const angles = { ce: Math.cos(q2), se: -Math.sin(q2), cf: Math.cos(q3), sf: Math.sin(q3) };
  const c = coriolis(angles, [dq1, -dq2, dq3], p);
  const g = gravity(angles, p);
  const Q = generalisedForces(angles, v, p);
  const [ddq1, ddeps, ddq3] = solveSymmetric(massMatrix(angles, p), [
    Q[0] - c[0] - g[0],
    Q[1] - c[1] - g[1],
    Q[2] - c[2] - g[2],
  ]);
  return [dq1, ddq1, dq2, -ddeps, dq3, ddq3];
}
