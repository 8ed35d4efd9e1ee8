"""The interior-point method behind `heli_gym.baselines.planning.spline`, compiled.

The unknowns are the coefficients c (M, 2) of elevation and pitch, except the first and last three, and, if the duration
is free, s = 1/T². The travel's two quadratures E are the only equations; the fans' thrusts f at K points, the pitch
coefficients and further rows have bounds. Ordered by knots, the normal equations are banded with a border of three
columns: s and the multipliers of the two equations. Rows on the travel, which depends on all earlier accelerations,
make the band a full matrix.

The helicopter's equations are those of `heli_gym.model`: values from `inverse_dynamics` and `dynamics`, first
derivatives from dual numbers, second derivatives from differences of these. The travel may have viscous damping.
"""

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from heli_gym.baselines.paper.jacobian import STEP, dual_cos, dual_sin
from heli_gym.compilation import Compiler
from heli_gym.model import dynamics, inverse_dynamics

BAND = 8  # diagonals of the lower triangle: four coefficients of two outputs meet in a segment
LOCAL_BAND = 10  # likewise with rows that connect neighbouring points
DIFFERENCE = 3e-5  # rad, of elevation and pitch, for second derivatives
INNER = 0.5 / math.sqrt(5.0)
POINTS = (0.0, 0.5 - INNER, 0.5 + INNER)  # Lobatto points of a segment; the fourth is the first of the next segment
WEIGHTS = (1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0)  # of the quadrature; at a knot, the sum for both segments
SHARES = (1.0 / 12.0, 5.0 / 12.0, 5.0 / 12.0, 1.0 / 12.0)  # of the quadrature over one segment
KNOT = (1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0)  # values of the splines at a knot
# Kinds of rows, in order: on coefficients, their differences, knots (two kinds), and thrusts at neighbouring points
ELEVATION, ELEVATION_RATE, TRAVEL_RATE, FLOOR, SLEW = 0, 1, 2, 3, 4
THIRD = (-1.0, 3.0, -3.0, 1.0)  # third difference
CLOSEST = 0.02  # distance of a guess from its bounds, as a share of their difference
TO_BOUNDARY = 0.99  # largest step towards a bound, as a share of the distance
BACKTRACKS = 14
SUFFICIENT, ROUNDING = 1e-4, 1e-12  # Armijo share of the predicted decrease; relative rounding error
DAMPING, MOST_DAMPING = 1e-6, 1e12  # first and last addition to the diagonal of an indefinite Hessian
SINGULAR, TINY = 1e-14, 1e-300  # thresholds of zero: pivots of the factorisation, steps


def basis(u):
    """Uniform cubic B-splines at u in [0, 1] of a segment: four values, four first and four second derivatives."""
    w = 1.0 - u
    return (
        (w**3 / 6.0, (3.0 * u**3 - 6.0 * u**2 + 4.0) / 6.0, (3.0 * w**3 - 6.0 * w**2 + 4.0) / 6.0, u**3 / 6.0),
        (-0.5 * w**2, 1.5 * u**2 - 2.0 * u, 0.5 + u - 1.5 * u**2, 0.5 * u**2),
        (w, 3.0 * u - 2.0, 1.0 - 3.0 * u, u),
    )


def tables(segments):
    """Tables of the K points: basis with two derivatives by tau (K, 3, 4), first coefficient, tau and weight (K,)."""
    count = 3 * segments + 1
    B = np.empty((count, 3, 4))
    first, tau, weight = np.empty(count, np.int64), np.empty(count), np.empty(count)
    for p in range(count):
        first[p] = min(p // 3, segments - 1)
        u = POINTS[p % 3] if p < count - 1 else 1.0
        value, slope, curvature = basis(u)
        for i in range(4):
            B[p, 0, i], B[p, 1, i], B[p, 2, i] = value[i], segments * slope[i], segments**2 * curvature[i]
        tau[p] = (first[p] + u) / segments
        weight[p] = WEIGHTS[p % 3] / segments
    weight[0] = weight[count - 1] = 1.0 / (12.0 * segments)
    return B, first, tau, weight


def outputs(c, root, B, first, p, z):
    """Fill in z (6,): elevation and pitch at a point, each with its first two derivatives by time; root is 1/T."""
    for o in range(2):
        y = dy = ddy = 0.0
        for i in range(4):
            value = c[first[p] + i, o]
            y += B[p, 0, i] * value
            dy += B[p, 1, i] * value
            ddy += B[p, 2, i] * value
        z[3 * o], z[3 * o + 1], z[3 * o + 2] = y, root * dy, root**2 * ddy


def invert(y1, dy1, ddy1, y2, dy2, ddy2, parameters, sin, cos):
    """Inputs v1 and v2, and the undamped second derivative of the travel, by (13) and (14a)."""
    x = 0.0, 0.0, y1, dy1, y2, dy2
    v = inverse_dynamics(x, ddy1, ddy2, parameters, sin, cos)
    return v[0], v[1], dynamics(x, v, parameters, sin, cos)[1]


def dual_column(y1, dy1, ddy1, y2, dy2, ddy2, j, parameters):
    """Derivatives (3,) of `invert` by the j-th of its six arguments."""
    v1, v2, ddeta = invert(
        complex(y1, STEP if j == 0 else 0.0),
        complex(dy1, STEP if j == 1 else 0.0),
        complex(ddy1, STEP if j == 2 else 0.0),
        complex(y2, STEP if j == 3 else 0.0),
        complex(dy2, STEP if j == 4 else 0.0),
        complex(ddy2, STEP if j == 5 else 0.0),
        parameters,
        dual_sin,
        dual_cos,
    )
    return (v1 + 0j).imag / STEP, (v2 + 0j).imag / STEP, (ddeta + 0j).imag / STEP


def gradients(y1, dy1, ddy1, y2, dy2, ddy2, parameters):
    """All six columns of `dual_column`: (6, 3)."""
    return (
        dual_column(y1, dy1, ddy1, y2, dy2, ddy2, 0, parameters),
        dual_column(y1, dy1, ddy1, y2, dy2, ddy2, 1, parameters),
        dual_column(y1, dy1, ddy1, y2, dy2, ddy2, 2, parameters),
        dual_column(y1, dy1, ddy1, y2, dy2, ddy2, 3, parameters),
        dual_column(y1, dy1, ddy1, y2, dy2, ddy2, 4, parameters),
        dual_column(y1, dy1, ddy1, y2, dy2, ddy2, 5, parameters),
    )


def derivatives(z, parameters, D, H):
    """Fill in the first derivatives D (3, 6) and second derivatives H (3, 6, 6) of `invert` at z (6,).

    Only second derivatives with at least one angle are nonzero, since (3) is affine in accelerations and rates.
    """
    y1, dy1, ddy1, y2, dy2, ddy2 = z[0], z[1], z[2], z[3], z[4], z[5]
    d, h = DIFFERENCE, 0.5 / DIFFERENCE
    here = gradients(y1, dy1, ddy1, y2, dy2, ddy2, parameters)
    low1, high1 = (
        gradients(y1 - d, dy1, ddy1, y2, dy2, ddy2, parameters),
        gradients(y1 + d, dy1, ddy1, y2, dy2, ddy2, parameters),
    )
    low2, high2 = (
        gradients(y1, dy1, ddy1, y2 - d, dy2, ddy2, parameters),
        gradients(y1, dy1, ddy1, y2 + d, dy2, ddy2, parameters),
    )
    for a in range(6):
        for i in range(3):
            D[i, a] = here[a][i]
            H[i, 0, a] = H[i, a, 0] = h * (high1[a][i] - low1[a][i])
    for a in range(6):
        for i in range(3):
            H[i, 3, a] = H[i, a, 3] = h * (high2[a][i] - low2[a][i])


def arrival(left, damping):
    """Share of a travel rate that remains after a time `left` in s under damping, and travel per unit of rate, in s."""
    decay = math.exp(-damping * left)
    return decay, (1.0 - decay) / damping if damping > 0.0 or damping < 0.0 else left


def travel_along(r, s, travel, points, rates, angles):
    """Fill in the travel's rates and angles (S + 1,) at the knots, from accelerations r (K,) at the points.

    travel: rate and angle at the start, those at the goal, and the damping.
    """
    _, _, tau, _ = points
    T, segments, damping = 1.0 / math.sqrt(s), len(rates) - 1, travel[4]
    keep, carry = arrival(T / segments, damping)
    rates[0], angles[0] = travel[0], travel[1]
    for j in range(segments):
        rates[j + 1], angles[j + 1] = keep * rates[j], angles[j] + carry * rates[j]
        for q in range(4):
            p = 3 * j + q
            decay, advance = arrival(T * ((j + 1.0) / segments - tau[p]), damping)
            weight = T * SHARES[q] / segments * r[p]
            rates[j + 1] += weight * decay
            angles[j + 1] += weight * advance


def floor_at(angle, floor):
    """Floor elevation and its slope at a travel angle: a polyline (2, N), level beyond its ends."""
    last = floor.shape[1] - 1
    if not floor[0, 0] < angle < floor[0, last]:
        return floor[1, 0 if angle <= floor[0, 0] else last], 0.0
    k = np.searchsorted(floor[0], angle) - 1
    slope = (floor[1, k + 1] - floor[1, k]) / (floor[0, k + 1] - floor[0, k])
    return floor[1, k] + slope * (angle - floor[0, k]), slope


def evaluate(c, s, travel, weights, parameters, points, rows, floor, f, r, knots, h):
    """Fill in thrusts f (2 K,), accelerations r (K,) and rows h (R,); return objective and the travel's equations."""
    B, first, tau, weight = points
    smooth, time_weight, effort, hover = weights
    root = math.sqrt(s)
    T, damping = 1.0 / root, travel[4]
    decay, advance = arrival(T, damping)
    e1 = root * (travel[0] * decay - travel[2])
    e2 = s * (travel[1] + travel[0] * advance - travel[3])
    objective, z = -0.5 * time_weight * math.log(s), np.empty(6)
    for p in range(len(tau)):
        outputs(c, root, B, first, p, z)
        v1, v2, r[p] = invert(z[0], z[1], z[2], z[3], z[4], z[5], parameters, math.sin, math.cos)
        f[2 * p], f[2 * p + 1] = 0.5 * (v1 + v2), 0.5 * (v1 - v2)
        decay, advance = arrival(T * (1.0 - tau[p]), damping)
        e1 += weight[p] * decay * r[p]
        e2 += weight[p] * root * advance * r[p]
        if effort > 0.0:
            objective += 0.5 * effort * weight[p] * ((f[2 * p] - hover) ** 2 + (f[2 * p + 1] - hover) ** 2)
    for j in range(len(c) - 3):
        for o in range(2):
            objective += 0.5 * smooth[o] * (c[j + 3, o] - c[j, o] + 3.0 * (c[j + 1, o] - c[j + 2, o])) ** 2
    if len(h) > 0:
        rates, angles = knots[0], knots[1]
        travel_along(r, s, travel, points, rates, angles)
        for n in range(len(h)):
            kind, k = rows[n, 0], rows[n, 1]
            if kind == ELEVATION:
                h[n] = c[k, 0]
            elif kind == ELEVATION_RATE:
                h[n] = (len(c) - 3) * root * (c[k + 1, 0] - c[k, 0])
            elif kind == TRAVEL_RATE:
                h[n] = rates[k]
            elif kind == FLOOR:
                h[n] = (c[k, 0] + 4.0 * c[k + 1, 0] + c[k + 2, 0]) / 6.0 - floor_at(angles[k], floor)[0]
            elif kind == SLEW:
                h[n] = root * (f[k + 2] - f[k]) / (tau[k // 2 + 1] - tau[k // 2])
    return objective, e1, e2


def assemble(
    c, s, y, stiffness, lam1, lam2, travel, weights, parameters, points, rows, floor, f, r, knots, F, M, G, g, J
):
    """Assemble first derivatives and the Hessian of the Lagrangian with the barrier of thrusts and rows.

    Fills in the thrusts' gradients F (2 K, 6) by `invert`'s arguments, the Hessian's lower band M (N, band) by the
    coefficients, its border G (N, 3) with the gradients of the two equations, the objective's gradient g (N,) and the
    rows' J (R, N + 1), the last column by s. Returns derivatives by s: the objective's first one without the duration
    term, the second derivative, and the first ones of the equations.
    """
    B, first, tau, weight = points
    smooth, time_weight, effort, hover = weights
    unknowns, count, segments = len(g), len(tau), len(c) - 3
    root = math.sqrt(s)
    T, damping = 1.0 / root, travel[4]
    M[:] = 0.0
    G[:] = 0.0
    g[:] = 0.0
    D, H, L, Q = np.zeros((3, 6)), np.zeros((3, 6, 6)), np.zeros((6, 6)), np.zeros((8, 6))
    z, by_s, by_ss, mixed, pull, along = (
        np.empty(6),
        np.zeros(6),
        np.zeros(6),
        np.zeros(6),
        np.zeros(6),
        np.zeros((3, 4)),
    )
    has_rows = len(rows) > 0
    R, R_s = np.empty((count if has_rows else 0, 8)), np.empty(count if has_rows else 0)
    on_travel, on_travel_s, on_thrusts = np.zeros(count), np.zeros(count), np.zeros(2 * count)
    if has_rows:
        on_rows = y[2 * count + segments - 3 :]
        pull_on_travel(on_rows, s, travel, points, rows, floor, knots, on_travel, on_travel_s)
        for q in range(len(rows)):
            if rows[q, 0] == SLEW:
                k = rows[q, 1]
                pulled = on_rows[q] * root / (tau[k // 2 + 1] - tau[k // 2])
                on_thrusts[k + 2] += pulled
                on_thrusts[k] -= pulled
    ss, gs = 0.5 * time_weight / s**2, 0.0
    decay, advance = arrival(T, damping)
    es1 = (travel[0] * decay * (1.0 + damping * T) - travel[2]) * 0.5 / root
    es2 = travel[1] - travel[3] + travel[0] * (advance - 0.5 * T * decay)
    ss -= lam1 * (travel[0] - travel[2]) * 0.25 / (s * root) + lam2 * 0.25 * travel[0] / (s * root)
    for p in range(count):
        outputs(c, root, B, first, p, z)
        derivatives(z, parameters, D, H)
        left = T * (1.0 - tau[p])
        decay, advance = arrival(left, damping)
        w1, w2 = weight[p] * decay, weight[p] * root * advance
        w1_s, w2_s = 0.5 * damping * left * w1 / s, 0.5 * (w2 - weight[p] * decay * (1.0 - tau[p])) / s
        push_f, push_b = effort * weight[p] * (f[2 * p] - hover), effort * weight[p] * (f[2 * p + 1] - hover)
        y_f, y_b = y[2 * p] + push_f + on_thrusts[2 * p], y[2 * p + 1] + push_b + on_thrusts[2 * p + 1]
        stiff_f, stiff_b = stiffness[2 * p] + effort * weight[p], stiffness[2 * p + 1] + effort * weight[p]
        by_v1, by_v2 = 0.5 * (y_f + y_b), 0.5 * (y_f - y_b)
        by_eta, by_eta_s = w1 * lam1 + w2 * lam2 + on_travel[p], w1_s * lam1 + w2_s * lam2 + on_travel_s[p]
        for a in range(6):
            F[2 * p, a], F[2 * p + 1, a] = 0.5 * (D[0, a] + D[1, a]), 0.5 * (D[0, a] - D[1, a])
        for a in range(6):
            for b in range(a + 1):
                L[a, b] = (
                    by_v1 * H[0, a, b]
                    + by_v2 * H[1, a, b]
                    + by_eta * H[2, a, b]
                    + stiff_f * F[2 * p, a] * F[2 * p, b]
                    + stiff_b * F[2 * p + 1, a] * F[2 * p + 1, b]
                )
                L[b, a] = L[a, b]
        # rates are proportional to the root of s, accelerations to s
        by_s[1], by_s[2], by_s[4], by_s[5] = 0.5 * z[1] / s, z[2] / s, 0.5 * z[4] / s, z[5] / s
        by_ss[1], by_ss[4] = -0.25 * z[1] / s**2, -0.25 * z[4] / s**2
        r_s = 0.0
        for a in range(6):
            mixed[a] = 0.0
            for b in range(6):
                mixed[a] += L[a, b] * by_s[b]
            pull[a] = by_v1 * D[0, a] + by_v2 * D[1, a] + by_eta * D[2, a]
            r_s += D[2, a] * by_s[a]
        for a in range(6):
            ss += mixed[a] * by_s[a] + pull[a] * by_ss[a]
            gs += (push_f * F[2 * p, a] + push_b * F[2 * p + 1, a]) * by_s[a]
        ss += 2.0 * by_eta_s * r_s
        es1 += w1 * r_s + w1_s * r[p]
        es2 += w2 * r_s + w2_s * r[p]
        if has_rows:
            R_s[p] = r_s
        for i in range(4):
            along[0, i], along[1, i], along[2, i] = B[p, 0, i], root * B[p, 1, i], s * B[p, 2, i]
        base = 2 * (first[p] - 3)
        for i in range(8):  # coefficient i // 2 of output i % 2
            n, o, k = base + i, 3 * (i % 2), i // 2
            by_c = along[0, k], along[1, k], along[2, k]
            eta = by_c[0] * D[2, o] + by_c[1] * D[2, o + 1] + by_c[2] * D[2, o + 2]
            if has_rows:
                R[p, i] = eta
            if 0 <= n < unknowns:
                for a in range(6):
                    Q[i, a] = by_c[0] * L[o, a] + by_c[1] * L[o + 1, a] + by_c[2] * L[o + 2, a]
                G[n, 0] += by_c[0] * mixed[o] + by_c[1] * mixed[o + 1] + by_c[2] * mixed[o + 2]
                G[n, 0] += 0.5 * by_c[1] / s * pull[o + 1] + by_c[2] / s * pull[o + 2] + by_eta_s * eta
                G[n, 1] += w1 * eta
                G[n, 2] += w2 * eta
                if effort > 0.0:
                    for a in range(3):
                        g[n] += by_c[a] * (push_f * F[2 * p, o + a] + push_b * F[2 * p + 1, o + a])
                for j in range(max(0, -base), i + 1):
                    oj, kj = 3 * (j % 2), j // 2
                    M[n, i - j] += along[0, kj] * Q[i, oj] + along[1, kj] * Q[i, oj + 1] + along[2, kj] * Q[i, oj + 2]
    for j in range(segments):
        for o in range(2):
            third = c[j + 3, o] - c[j, o] + 3.0 * (c[j + 1, o] - c[j + 2, o])
            for i in range(4):
                n = 2 * (j + i - 3) + o
                if 0 <= n < unknowns:
                    g[n] += smooth[o] * THIRD[i] * third
                    for k in range(max(0, i - n // 2), i + 1):
                        M[n, 2 * (i - k)] += smooth[o] * THIRD[i] * THIRD[k]
    if has_rows:
        differentiate_rows(c, s, travel, points, rows, floor, f, F, r, R, R_s, knots, J)
        offset = 2 * count + segments - 3
        for q in range(len(rows)):
            stiff = stiffness[offset + q]
            ss += stiff * J[q, unknowns] ** 2
            begin = 0
            while begin < unknowns and J[q, begin] == 0.0:
                begin += 1
            for n in range(begin, unknowns):
                push = stiff * J[q, n]
                if push != 0.0:
                    G[n, 0] += push * J[q, unknowns]
                    for m in range(max(begin, n - M.shape[1] + 1), n + 1):
                        M[n, n - m] += push * J[q, m]
    return gs, ss, es1, es2


def pull_on_travel(y, s, travel, points, rows, floor, knots, on_travel, on_travel_s):
    """Accumulate the rows' multipliers y (R,) times the derivatives of the travel by its accelerations and by s."""
    _, _, tau, _ = points
    angles = knots[1]
    segments, T, damping = len(angles) - 1, 1.0 / math.sqrt(s), travel[4]
    on_rate, on_angle = np.zeros(segments + 1), np.zeros(segments + 1)
    for n in range(len(rows)):
        kind, k = rows[n, 0], rows[n, 1]
        if kind == TRAVEL_RATE:
            on_rate[k] += y[n]
        elif kind == FLOOR:
            on_angle[k] -= y[n] * floor_at(angles[k], floor)[1]
    keep, carry = arrival(T / segments, damping)
    for j in range(segments - 1, -1, -1):
        for q in range(4):
            p = 3 * j + q
            left = T * ((j + 1.0) / segments - tau[p])
            decay, advance = arrival(left, damping)
            weight = T * SHARES[q] / segments
            pull = weight * (on_rate[j + 1] * decay + on_angle[j + 1] * advance)
            turn = weight * (on_angle[j + 1] * decay - on_rate[j + 1] * damping * decay) * left
            on_travel[p] += pull
            on_travel_s[p] -= 0.5 * (pull + turn) / s
        on_rate[j] += keep * on_rate[j + 1] + carry * on_angle[j + 1]
        on_angle[j] += on_angle[j + 1]


def differentiate_rows(c, s, travel, points, rows, floor, f, F, r, R, R_s, knots, J):
    """Fill in the rows' derivatives J (R, N + 1) from those of accelerations, R (K, 8) by coefficients, R_s by s."""
    _, first, tau, _ = points
    rates, angles = knots[0], knots[1]
    segments, root, unknowns, damping = len(c) - 3, math.sqrt(s), J.shape[1] - 1, travel[4]
    T = 1.0 / root
    J[:] = 0.0
    by_rate, by_angle = np.zeros((segments + 1, unknowns + 1)), np.zeros((segments + 1, unknowns + 1))
    keep, carry = arrival(T / segments, damping)
    T_s = -0.5 * T / s
    for j in range(segments):
        for n in range(unknowns + 1):
            by_rate[j + 1, n] = keep * by_rate[j, n]
            by_angle[j + 1, n] = by_angle[j, n] + carry * by_rate[j, n]
        by_rate[j + 1, unknowns] -= T_s * damping / segments * keep * rates[j]
        by_angle[j + 1, unknowns] += T_s / segments * keep * rates[j]
        for q in range(4):
            p = 3 * j + q
            left = T * ((j + 1.0) / segments - tau[p])
            decay, advance = arrival(left, damping)
            share = SHARES[q] / segments
            base = 2 * (first[p] - 3)
            for i in range(8):
                if 0 <= base + i < unknowns:
                    by_rate[j + 1, base + i] += T * share * decay * R[p, i]
                    by_angle[j + 1, base + i] += T * share * advance * R[p, i]
            by_rate[j + 1, unknowns] += share * (T * decay * R_s[p] + T_s * decay * (1.0 - damping * left) * r[p])
            by_angle[j + 1, unknowns] += share * (T * advance * R_s[p] + T_s * (advance + decay * left) * r[p])
    for n in range(len(rows)):
        kind, k = rows[n, 0], rows[n, 1]
        if kind == ELEVATION:
            J[n, 2 * (k - 3)] = 1.0
        elif kind == ELEVATION_RATE:
            for i in range(2):
                if 0 <= 2 * (k + i - 3) < unknowns:
                    J[n, 2 * (k + i - 3)] = segments * root * (2.0 * i - 1.0)
            J[n, unknowns] = 0.5 * segments / root * (c[k + 1, 0] - c[k, 0])
        elif kind == TRAVEL_RATE:
            for m in range(unknowns + 1):
                J[n, m] = by_rate[k, m]
        elif kind == FLOOR:
            slope = floor_at(angles[k], floor)[1]
            for m in range(unknowns + 1):
                J[n, m] = -slope * by_angle[k, m]
            for i in range(3):
                if 0 <= 2 * (k + i - 3) < unknowns:
                    J[n, 2 * (k + i - 3)] += KNOT[i]
        elif kind == SLEW:
            scale = root / (tau[k // 2 + 1] - tau[k // 2])
            add_thrust(c, s, points, F, k + 2, scale, J[n])
            add_thrust(c, s, points, F, k, -scale, J[n])
            J[n, unknowns] += 0.5 * scale / s * (f[k + 2] - f[k])


def add_thrust(c, s, points, F, k, scale, row):
    """Add to a row (N + 1,) the derivatives of the k-th thrust by the coefficients and by s, times `scale`."""
    B, first, _, _ = points
    p, root, z, unknowns = k // 2, math.sqrt(s), np.empty(6), len(row) - 1
    outputs(c, root, B, first, p, z)
    row[unknowns] += scale * (0.5 * (F[k, 1] * z[1] + F[k, 4] * z[4]) + F[k, 2] * z[2] + F[k, 5] * z[5]) / s
    for i in range(4):
        n = 2 * (first[p] + i - 3)
        if 0 <= n < unknowns:
            for o in range(2):
                by_c = B[p, 0, i] * F[k, 3 * o] + root * B[p, 1, i] * F[k, 3 * o + 1] + s * B[p, 2, i] * F[k, 3 * o + 2]
                row[n + o] += scale * by_c


def vjp(force, F, J, c, s, points, g):
    """Add to g the vector-Jacobian product of `force` with thrusts and rows; return its entry for s."""
    B, first, tau, _ = points
    by_s, z, n_ = 0.0, np.empty(6), np.empty(6)
    root, unknowns = math.sqrt(s), len(g)
    for p in range(len(tau)):
        outputs(c, root, B, first, p, z)
        for a in range(6):
            n_[a] = force[2 * p] * F[2 * p, a] + force[2 * p + 1] * F[2 * p + 1, a]
        by_s += (0.5 * (n_[1] * z[1] + n_[4] * z[4]) + n_[2] * z[2] + n_[5] * z[5]) / s
        for i in range(4):
            n = 2 * (first[p] + i - 3)
            if 0 <= n < unknowns:
                g[n] += B[p, 0, i] * n_[0] + root * B[p, 1, i] * n_[1] + s * B[p, 2, i] * n_[2]
                g[n + 1] += B[p, 0, i] * n_[3] + root * B[p, 1, i] * n_[4] + s * B[p, 2, i] * n_[5]
    offset = len(force) - len(J)
    for q in range(len(J)):
        for n in range(unknowns):
            g[n] += force[offset + q] * J[q, n]
        by_s += force[offset + q] * J[q, unknowns]
    return by_s


def jvp(dx, ds, F, J, c, s, points, df):
    """Add to df the Jacobian-vector product: changes of thrusts (2 K,) and rows for steps of coefficients and s."""
    B, first, tau, _ = points
    z, d = np.empty(6), np.empty(6)
    root, unknowns = math.sqrt(s), len(dx)
    for p in range(len(tau)):
        outputs(c, root, B, first, p, z)
        d[0], d[1], d[2] = 0.0, 0.5 * ds * z[1] / s, ds * z[2] / s
        d[3], d[4], d[5] = 0.0, 0.5 * ds * z[4] / s, ds * z[5] / s
        for i in range(4):
            n = 2 * (first[p] + i - 3)
            if 0 <= n < unknowns:
                for o in range(2):
                    d[3 * o] += B[p, 0, i] * dx[n + o]
                    d[3 * o + 1] += root * B[p, 1, i] * dx[n + o]
                    d[3 * o + 2] += s * B[p, 2, i] * dx[n + o]
        for k in (2 * p, 2 * p + 1):
            for a in range(6):
                df[k] += F[k, a] * d[a]
    offset = len(df) - len(J)
    for q in range(len(J)):
        for n in range(unknowns):
            df[offset + q] += J[q, n] * dx[n]
        df[offset + q] += J[q, unknowns] * ds


def factorise(M, damping, L):
    """Fill in the Cholesky factor L of the banded M plus damping on its diagonal; return whether it exists."""
    band = M.shape[1]
    for i in range(len(M)):
        for k in range(min(band - 1, i), -1, -1):
            j = i - k
            value = M[i, k] + damping if k == 0 else M[i, k]
            for m in range(max(0, i - band + 1), j):
                value -= L[i, i - m] * L[j, j - m]
            if k > 0:
                L[i, k] = value / L[j, 0]
            elif value > SINGULAR:
                L[i, 0] = math.sqrt(value)
            else:
                return False
    return True


def substitute(L, b):
    """Solve L L' x = b (N, columns) in place."""
    size, band = L.shape
    for i in range(size):
        for q in range(b.shape[1]):
            value = b[i, q]
            for k in range(1, min(band - 1, i) + 1):
                value -= L[i, k] * b[i - k, q]
            b[i, q] = value / L[i, 0]
    for i in range(size - 1, -1, -1):
        for q in range(b.shape[1]):
            value = b[i, q]
            for k in range(1, min(band - 1, size - 1 - i) + 1):
                value -= L[i + k, k] * b[i + k, q]
            b[i, q] = value / L[i, 0]


def schur_step(G, columns, g, ss, gs, es, e, fixed):
    """Step of s and new multipliers (3,), given columns = M^-1 (G, -g); NaN if the step is not a descent direction.

    The 3 x 3 Schur complement must have two negative eigenvalues and a positive one.
    """
    S, rhs = np.zeros((3, 3)), np.zeros(3)
    for n in range(len(g)):
        for i in range(3):
            rhs[i] -= G[n, i] * columns[n, 3]
            for j in range(3):
                S[i, j] -= G[n, i] * columns[n, j]
    for i in range(2):
        S[0, 1 + i] += es[i]
        S[1 + i, 0] += es[i]
        rhs[1 + i] -= e[i]
    S[0, 0] += ss
    rhs[0] -= gs
    if fixed:
        for i in range(3):
            S[0, i] = S[i, 0] = 0.0
        S[0, 0], rhs[0] = 1.0, 0.0
    cofactors = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            i1, i2, j1, j2 = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
            cofactors[i, j] = S[i1, j1] * S[i2, j2] - S[i1, j2] * S[i2, j1]
    determinant = S[0, 0] * cofactors[0, 0] + S[0, 1] * cofactors[0, 1] + S[0, 2] * cofactors[0, 2]
    if not determinant > 0.0:
        return math.nan, 0.0, 0.0
    border = np.zeros(3)
    for i in range(3):
        for j in range(3):
            border[i] += cofactors[i, j] * rhs[j] / determinant
    return border[0], border[1], border[2]


def newton_step(M, G, g, ss, gs, es, e, fixed, damping, columns, L, dx):
    """Fill in the step dx (N,) of the coefficients; return the step of s, the new multipliers and the damping.

    The damping is raised until the Hessian is positive definite, so that the step is a descent direction.
    """
    while damping < MOST_DAMPING:
        if factorise(M, damping, L):
            for n in range(len(g)):
                columns[n, 0], columns[n, 1], columns[n, 2], columns[n, 3] = G[n, 0], G[n, 1], G[n, 2], -g[n]
            substitute(L, columns)
            ds, lam1, lam2 = schur_step(G, columns, g, ss + damping, gs, es, e, fixed)
            if not math.isnan(ds):
                for n in range(len(g)):
                    dx[n] = columns[n, 3] - ds * columns[n, 0] - lam1 * columns[n, 1] - lam2 * columns[n, 2]
                return ds, lam1, lam2, damping
        damping = max(DAMPING, 8.0 * damping)
    return 0.0, 0.0, 0.0, damping


def barrier(w, low, high):
    """Sum of -log of the distances of w to its bounds; infinite outside."""
    total = 0.0
    for k in range(len(w)):
        if not low[k] < w[k] < high[k]:
            return math.inf
        total -= math.log((w[k] - low[k]) * (high[k] - w[k]))
    return total


def duals(mu, w, low, high, zl, zu, r, y, stiffness, force):
    """Fill in y = zu - zl, the barrier's stiffness, and its force in the Newton step at the residuals r."""
    for k in range(len(w)):
        below, above = w[k] - low[k], high[k] - w[k]
        y[k] = zu[k] - zl[k]
        stiffness[k] = zl[k] / below + zu[k] / above
        force[k] = mu / above - mu / below + stiffness[k] * r[k]


def dual_step(mu, w, dw, low, high, zl, zu, dzl, dzu):
    """Fill in the steps of the multipliers; return the largest step lengths, at most 1, of w and of the multipliers.

    A step covers at most the share TO_BOUNDARY of each distance to a bound.
    """
    primal = dual = 1.0
    for k in range(len(w)):
        below, above = w[k] - low[k], high[k] - w[k]
        dzl[k] = (mu - zl[k] * dw[k]) / below - zl[k]
        dzu[k] = (mu + zu[k] * dw[k]) / above - zu[k]
        if dw[k] < 0.0:
            primal = min(primal, -TO_BOUNDARY * below / dw[k])
        elif dw[k] > 0.0:
            primal = min(primal, TO_BOUNDARY * above / dw[k])
        if dzl[k] < 0.0:
            dual = min(dual, -TO_BOUNDARY * zl[k] / dzl[k])
        if dzu[k] < 0.0:
            dual = min(dual, -TO_BOUNDARY * zu[k] / dzu[k])
    return primal, dual


def kkt_residual(mu, w, low, high, zl, zu, r, gradient):
    """Residual of the bounds' equations, and scaled residual of stationarity and complementarity."""
    missed = residual = total = 0.0
    for k in range(len(w)):
        missed = max(missed, abs(r[k]))
        total += zl[k] + zu[k]
        residual = max(residual, abs(zl[k] * (w[k] - low[k]) - mu), abs(zu[k] * (high[k] - w[k]) - mu))
    for value in gradient:
        residual = max(residual, abs(value))
    return missed, residual / max(1.0, 0.1 * total / len(w))


def solve(c, s, travel, low, high, rows, floor, parameters, weights, is_free, mu, last_mu, tolerance, iterations):
    """Minimise the objective while the barrier parameter decreases from mu to last_mu.

    Args:
        c, s: guess of the coefficients (M, 2) in rad, three fixed at each end, and of 1/T² in 1/s².
        travel: rate and angle at the start, rate and angle at the goal, and damping: rad/s, rad, rad/s, rad, 1/s.
        low, high: bounds of thrusts in N (2 K,), pitch coefficients in rad (M - 6,) and rows (R,).
        rows: kind and index (R, 2) of further quantities with bounds.
        floor: travel and elevation (2, N) in rad, for rows of the kind FLOOR.
        parameters: parameters of the helicopter.
        weights: of squared third differences of the coefficients (2,), of the logarithm of the duration, and of the
            mean squared distance of the thrusts from hover; then the hover thrusts in N.
        is_free: whether s may change.
        tolerance: of equations and bounds in N and rad/s²; that of optimality is last_mu.
        iterations: largest number.

    Returns:
        Whether it converged, number of iterations, c, s, and multipliers of the lower and upper bounds (2, ...).
    """
    segments, fixed, time_weight = len(c) - 3, not is_free, weights[1]
    points, free = tables(segments), segments - 3
    count, unknowns = 2 * (3 * segments + 1), 2 * free
    size, offset = len(low), count + free
    w, dw, new_w, r = np.empty(size), np.empty(size), np.empty(size), np.zeros(size)
    zl, zu, dzl, dzu = np.empty(size), np.empty(size), np.empty(size), np.empty(size)
    y, stiffness, force = np.empty(size), np.empty(size), np.empty(size)
    g, direct, dx = np.empty(unknowns), np.empty(unknowns), np.empty(unknowns)
    f, F, h = np.empty(count), np.empty((count, 6)), np.empty(len(rows))
    band = BAND if len(rows) == 0 else LOCAL_BAND
    for q in range(len(rows)):
        if rows[q, 0] == TRAVEL_RATE or rows[q, 0] == FLOOR:
            band = unknowns
    M = np.empty((unknowns, band))
    L, J = np.zeros(M.shape), np.empty((len(rows), unknowns + 1))
    G, columns = np.empty((unknowns, 3)), np.empty((unknowns, 4))
    acceleration, knots = np.empty(count // 2), np.empty((2, segments + 1))
    c, new_c = c.copy(), c.copy()
    for i in range(free):
        inside = CLOSEST * (high[count + i] - low[count + i])
        w[count + i] = c[3 + i, 1] = min(max(c[3 + i, 1], low[count + i] + inside), high[count + i] - inside)
    objective, e1, e2 = evaluate(c, s, travel, weights, parameters, points, rows, floor, f, acceleration, knots, h)
    for k in range(size):
        if k < count or k >= offset:
            value = f[k] if k < count else h[k - offset]
            inside = CLOSEST * (high[k] - low[k])
            w[k] = min(max(value, low[k] + inside), high[k] - inside)
        zl[k], zu[k], r[k] = mu / (w[k] - low[k]), mu / (high[k] - w[k]), 0.0

    lam1, lam2, damping, penalty, converged, taken = 0.0, 0.0, 0.0, 1.0, False, 0
    while taken < iterations:
        for k in range(count):
            r[k] = f[k] - w[k]
        for k in range(len(h)):
            r[offset + k] = h[k] - w[offset + k]
        duals(mu, w, low, high, zl, zu, r, y, stiffness, force)
        direct_s, ss, es1, es2 = assemble(
            c,
            s,
            y,
            stiffness,
            lam1,
            lam2,
            travel,
            weights,
            parameters,
            points,
            rows,
            floor,
            f,
            acceleration,
            knots,
            F,
            M,
            G,
            direct,
            J,
        )
        direct_s -= 0.5 * time_weight / s
        for i in range(unknowns):
            g[i] = direct[i] + lam1 * G[i, 1] + lam2 * G[i, 2]
        gs = vjp(y, F, J, c, s, points, g) + direct_s + lam1 * es1 + lam2 * es2
        for i in range(free):
            g[2 * i + 1] += y[count + i]
            M[2 * i + 1, 0] += stiffness[count + i]
        missed, residual = kkt_residual(mu, w, low, high, zl, zu, r, g)
        missed, residual = max(missed, abs(e1), abs(e2)), residual if fixed else max(residual, s * abs(gs))
        error = max(missed, residual)
        if mu <= last_mu and missed < tolerance and error < 10.0 * mu:
            converged = True
            break
        taken += 1
        while mu > last_mu and error < 10.0 * mu:
            mu = max(last_mu, min(0.2 * mu, mu**1.5))

        duals(mu, w, low, high, zl, zu, r, y, stiffness, force)
        for i in range(unknowns):
            g[i] = direct[i]
        gs = vjp(force, F, J, c, s, points, g) + direct_s
        for i in range(free):
            g[2 * i + 1] += force[count + i]
        damping = damping / 8.0 if damping > DAMPING else 0.0
        ds, new_lam1, new_lam2, damping = newton_step(
            M, G, g, ss, gs, (es1, es2), (e1, e2), fixed, damping, columns, L, dx
        )
        if damping >= MOST_DAMPING:
            break
        for k in range(size):
            dw[k] = r[k]
        jvp(dx, ds, F, J, c, s, points, dw)
        for i in range(free):
            dw[count + i] = dx[2 * i + 1]
        step, dual = dual_step(mu, w, dw, low, high, zl, zu, dzl, dzu)
        if not fixed:
            step = min(step, 0.5 * s / max(abs(ds), TINY))

        missing, slope = abs(e1) + abs(e2), direct_s * ds
        for i in range(unknowns):
            slope += direct[i] * dx[i]
        for k in range(size):
            missing += abs(r[k])
            slope += (force[k] - stiffness[k] * r[k]) * dw[k]
        if missing > tolerance:
            penalty = max(penalty, slope / (0.5 * missing))
        before = objective + mu * barrier(w, low, high) + penalty * missing
        accepted = False
        for _ in range(BACKTRACKS):
            new_s = s + step * ds
            for i in range(free):
                new_c[3 + i, 0] = c[3 + i, 0] + step * dx[2 * i]
                new_c[3 + i, 1] = c[3 + i, 1] + step * dx[2 * i + 1]
            objective, e1, e2 = evaluate(
                new_c, new_s, travel, weights, parameters, points, rows, floor, f, acceleration, knots, h
            )
            after = objective + penalty * (abs(e1) + abs(e2))
            for k in range(size):
                new_w[k] = w[k] + step * dw[k]
                if k < count:
                    after += penalty * abs(f[k] - new_w[k])
                elif k >= offset:
                    after += penalty * abs(h[k - offset] - new_w[k])
            after += mu * barrier(new_w, low, high)
            if after <= before + SUFFICIENT * step * (slope - penalty * missing) + ROUNDING * abs(before):
                accepted = True
                break
            step *= 0.5
        if accepted:
            s, c, new_c, w, new_w = new_s, new_c, c, new_w, w
            lam1, lam2 = lam1 + step * (new_lam1 - lam1), lam2 + step * (new_lam2 - lam2)
            for k in range(size):
                zl[k] += dual * dzl[k]
                zu[k] += dual * dzu[k]
        else:  # repeat with more damping
            objective, e1, e2 = evaluate(
                c, s, travel, weights, parameters, points, rows, floor, f, acceleration, knots, h
            )
            damping = max(1.0, 64.0 * damping)
    multipliers = np.empty((2, size))
    for k in range(size):
        multipliers[0, k], multipliers[1, k] = zl[k], zu[k]
    return converged, taken, c, s, multipliers


def interpolate(c, duration, count):
    """Elevation and pitch with their first and second derivatives by time, (3, 2, K) at K equidistant times."""
    segments = len(c) - 3
    y, rate = np.empty((3, 2, count)), segments / duration
    for k in range(count):
        u = segments * k / (count - 1)
        j = min(int(u), segments - 1)
        u -= j
        value, slope, curvature = basis(u)
        for o in range(2):
            y0 = y1 = y2 = 0.0
            for i in range(4):
                y0 += value[i] * c[j + i, o]
                y1 += slope[i] * c[j + i, o]
                y2 += curvature[i] * c[j + i, o]
            y[0, o, k], y[1, o, k], y[2, o, k] = y0, rate * y1, rate**2 * y2
    return y


def thrusts_along(y, dy, ddy, parameters):
    """Thrusts (2, K) of both fans and undamped second derivative (K,) of the travel, along elevation and pitch."""
    f, ddeta = np.empty(y.shape), np.empty(y.shape[1])
    for k in range(y.shape[1]):
        v1, v2, ddeta[k] = invert(
            y[0, k], dy[0, k], ddy[0, k], y[1, k], dy[1, k], ddy[1, k], parameters, math.sin, math.cos
        )
        f[0, k], f[1, k] = 0.5 * (v1 + v2), 0.5 * (v1 - v2)
    return f, ddeta


# compiled without fast-math, because NaN and infinity signal failures
CAREFUL = (solve, schur_step, newton_step, factorise, barrier, dual_step, duals, kkt_residual)


def run(c, s, travel, low, high, rows, floor, parameters, weights, is_free, mu, last_mu, tolerance, iterations):
    """Call `solve` from a compiled entry point, so that `solve` itself is compiled without fast-math."""
    return solve(c, s, travel, low, high, rows, floor, parameters, weights, is_free, mu, last_mu, tolerance, iterations)


@cache
def compiled(function: Callable) -> Callable:
    """Compile the function at its first call, cached on disk until (3) or this module changes."""
    return Compiler(careful=CAREFUL).entry(function)
