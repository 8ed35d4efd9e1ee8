"""The interior-point method behind `heli_gym.baselines.planning.spline`, compiled.

The unknowns are the coefficients c (M, 2) of elevation and pitch, except those fixed at each end, s = 1/T² if the
duration is free, and the initial travel rate w if the flight is periodic. The fans' thrusts f at K points, the pitch
coefficients and further rows have bounds. Equations are the travel's two quadratures and the last rows: ends in motion
and via points. Ordered by knots, the normal equations are banded, with a border: s, w, and the multipliers of the
equations. Bounds on the travel, which depends on all earlier accelerations, make the band a full matrix.

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
# Kinds of rows, in order: on coefficients, their differences, knots (two kinds), thrusts at neighbouring points (two
# kinds), ends, and via points (three kinds)
ELEVATION, ELEVATION_RATE, TRAVEL_RATE, FLOOR, SLEW, LEAD, END, VIA_TRAVEL, VIA_ELEVATION, CROSSING = range(10)
START, GOAL, LOOP = 0, 6, 12  # indices of rows at ends: one of these plus 3 for pitch plus the order of the derivative
ENDS = ((KNOT[0], KNOT[1], KNOT[2]), (-0.5, 0.0, 0.5), (1.0, -2.0, 1.0))  # derivatives at a knot, per power of segments
BORDER = 2  # unknowns besides the coefficients: s and the initial travel rate
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


def travel_along(r, s, w, damping, points, rates, angles):
    """Fill in the travel's rates and angles (S + 1,) at the knots, from accelerations r (K,) at the points."""
    _, _, tau, _ = points
    T, segments = 1.0 / math.sqrt(s), len(rates) - 1
    keep, carry = arrival(T / segments, damping)
    rates[0], angles[0] = w, 0.0
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


def partial_weights(u):
    """Weights (4,) of the accelerations at a segment's points, in the double integral from its start to the share u."""
    x = (POINTS[0], POINTS[1], POINTS[2], 1.0)
    weights = np.empty(4)
    for q in range(4):
        a, b, c = x[(q + 1) % 4], x[(q + 2) % 4], x[(q + 3) % 4]
        scale = (x[q] - a) * (x[q] - b) * (x[q] - c)
        # the integral of (u - v) v^n is u^(n+2) / ((n + 1) (n + 2))
        cubic, square, linear, constant = 1.0, -(a + b + c), a * b + b * c + c * a, -a * b * c
        weights[q] = u**2 * (constant / 2.0 + u * (linear / 6.0 + u * (square / 12.0 + u * cubic / 20.0))) / scale
    return weights


def angle_at(j, u, r, T, damping, knots):
    """Travel angle at the share u of the segment j; damping within the segment acts on the rate only."""
    segments, weights = knots.shape[1] - 1, partial_weights(u)
    _, carry = arrival(u * T / segments, damping)
    angle = knots[1, j] + carry * knots[0, j]
    for q in range(4):
        angle += (T / segments) ** 2 * weights[q] * r[3 * j + q]
    return angle


def crossing(travel, near, r, T, damping, knots):
    """Segment and share at which the travel passes an angle, the passage nearest to the time `near`, as tau.

    Without a passage: the point of the closest approach at a knot.
    """
    segments = knots.shape[1] - 1
    best, found, share, closest = math.inf, 0, 0.0, math.inf
    for j in range(segments):
        if (knots[1, j] - travel) * (knots[1, j + 1] - travel) <= 0.0 and knots[1, j] != knots[1, j + 1]:
            low, high = 0.0, 1.0
            rising = knots[1, j + 1] > knots[1, j]
            for _ in range(40):
                middle = 0.5 * (low + high)
                if (angle_at(j, middle, r, T, damping, knots) < travel) == rising:
                    low = middle
                else:
                    high = middle
            distance = abs((j + low) / segments - near)
            if distance < best:
                best, found, share = distance, j, low
    if best < math.inf:
        return found, share
    for j in range(segments):
        if abs(knots[1, j] - travel) < closest:
            closest, found = abs(knots[1, j] - travel), j
    return found, 0.0


def evaluate(c, s, w, travel, weights, parameters, points, rows, targets, vias, floor, f, r, knots, places, h, e):
    """Fill in thrusts f (2 K,), accelerations r (K,), rows h (R,) and equations e (E,); return the objective.

    `places` (V, 2) receives segments and shares of the via points.
    """
    B, first, tau, weight = points
    smooth, time_weight, effort, hover, thrust_rate = weights
    root = math.sqrt(s)
    new_rate, new_angle, damping, loop = travel
    T = 1.0 / root
    decay, advance = arrival(T, damping)
    e1 = root * (w * (decay - loop) - new_rate)
    e2 = s * (w * advance - new_angle)
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
    if thrust_rate > 0.0:
        for k in range(len(f) - 2):
            objective += 0.5 * thrust_rate * root * (f[k + 2] - f[k]) ** 2 / (tau[k // 2 + 1] - tau[k // 2])
    if len(h) > 0:
        rates, angles = knots[0], knots[1]
        travel_along(r, s, w, damping, points, rates, angles)
        for v in range(len(vias)):
            if vias[v, 0] >= 0.0:
                j = min(int(vias[v, 0] * (len(c) - 3)), len(c) - 4)
                places[v, 0], places[v, 1] = j, vias[v, 0] * (len(c) - 3) - j
            else:
                j, share = crossing(vias[v, 1], -vias[v, 0] - 1.0, r, T, damping, knots)
                places[v, 0], places[v, 1] = j, share
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
            elif kind == LEAD:
                h[n] = f[k + 2] + targets[n] * root * (f[k + 2] - f[k]) / (tau[k // 2 + 1] - tau[k // 2])
            elif kind == END:
                h[n] = end_value(c, s, k) - targets[n] * T ** (k % 3)
            elif kind == VIA_TRAVEL:
                h[n] = angle_at(int(places[k, 0]), places[k, 1], r, T, damping, knots) - vias[k, 1]
            else:
                h[n] = elevation_at(c, int(places[k, 0]), places[k, 1], 0) - vias[k, 2]
    e[0], e[1] = e1, e2
    for q in range(2, len(e)):
        e[q] = h[len(h) - len(e) + q]
    return objective


def end_value(c, s, k):
    """Row of the kind END without its target: a derivative by tau at an end, or its difference between the ends."""
    order, output, segments = k % 3, (k // 3) % 2, len(c) - 3
    total = 0.0
    for i in range(3):
        weight = segments**order * ENDS[order][i]
        if k < GOAL:
            total += weight * c[i, output]
        elif k < LOOP:
            total += weight * c[segments + i, output]
        else:
            total += weight * (c[segments + i, output] - c[i, output])
    return total


def elevation_at(c, j, u, order):
    """Elevation, or its derivative by the share, at the share u of the segment j."""
    values = basis(u)[order]
    return values[0] * c[j, 0] + values[1] * c[j + 1, 0] + values[2] * c[j + 2, 0] + values[3] * c[j + 3, 0]


def crossing_slope(c, k, r, T, damping, knots, places):
    """Change of the elevation with the travel at a via point without a time, along the flight."""
    j, u = int(places[k, 0]), places[k, 1]
    low, high = max(0.0, u - 0.01), min(1.0, u + 0.01)
    turn = angle_at(j, high, r, T, damping, knots) - angle_at(j, low, r, T, damping, knots)
    rise = elevation_at(c, j, u, 1) * (high - low)
    return rise / turn if abs(turn) > 1e-3 * abs(rise) else 0.0


def assemble(
    c,
    s,
    w,
    y,
    stiffness,
    lam,
    travel,
    weights,
    parameters,
    points,
    lead,
    rows,
    targets,
    vias,
    floor,
    f,
    r,
    knots,
    places,
    F,
    M,
    G,
    g,
    J,
    es,
    border,
):
    """Assemble first derivatives and the Hessian of the Lagrangian with the barrier of thrusts and rows.

    Fills in the thrusts' gradients F (2 K, 6) by `invert`'s arguments, the Hessian's lower band M (N, band) by the
    coefficients, its border G (N, 2 + E) with the gradients of the equations, the objective's gradient g (N,), the
    rows' J (R, N + 2), the last columns by s and w, the equations' derivatives es (E, 2) by s and w, and the Hessian
    (2, 2) by s and w. Returns the objective's derivative by s without the duration term. `lead` is the number of fixed
    coefficients at the start.
    """
    B, first, tau, weight = points
    smooth, time_weight, effort, hover, thrust_rate = weights
    unknowns, count, segments, equations = len(g), len(tau), len(c) - 3, len(lam)
    root = math.sqrt(s)
    new_rate, new_angle, damping, loop = travel
    T, lam1, lam2 = 1.0 / root, lam[0], lam[1]
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
    has_rows, bounded = len(rows) > 0, len(rows) - equations + 2
    R, R_s = np.empty((count if has_rows else 0, 8)), np.empty(count if has_rows else 0)
    on_travel, on_travel_s, on_thrusts = np.zeros(count), np.zeros(count), np.zeros(2 * count)
    if has_rows:
        on_rows, offset = np.empty(len(rows)), len(y) - bounded
        for q in range(len(rows)):
            on_rows[q] = y[offset + q] if q < bounded else lam[q - bounded + 2]
        pull_on_travel(c, on_rows, s, damping, points, rows, vias, floor, r, knots, places, on_travel, on_travel_s)
        for q in range(len(rows)):
            if rows[q, 0] == SLEW or rows[q, 0] == LEAD:
                k = rows[q, 1]
                scale = targets[q] if rows[q, 0] == LEAD else 1.0
                by_rate = scale * on_rows[q] * root / (tau[k // 2 + 1] - tau[k // 2])
                on_thrusts[k + 2] += by_rate + (on_rows[q] if rows[q, 0] == LEAD else 0.0)
                on_thrusts[k] -= by_rate
    if thrust_rate > 0.0:
        for k in range(2 * count - 2):
            by_rate = thrust_rate * root * (f[k + 2] - f[k]) / (tau[k // 2 + 1] - tau[k // 2])
            on_thrusts[k + 2] += by_rate
            on_thrusts[k] -= by_rate
    ss, gs = 0.5 * time_weight / s**2, 0.0
    border[:] = 0.0
    decay, advance = arrival(T, damping)
    es1 = (w * (decay * (1.0 + damping * T) - loop) - new_rate) * 0.5 / root
    es2 = w * (advance - 0.5 * T * decay) - new_angle
    ss -= lam1 * (w * (1.0 - loop) - new_rate) * 0.25 / (s * root) + lam2 * 0.25 * w / (s * root)
    es[0, 1], es[1, 1] = root * (decay - loop), s * advance
    sw = lam1 * 0.5 * (decay * (1.0 + damping * T) - loop) / root + lam2 * (advance - 0.5 * T * decay)
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
        base = 2 * (first[p] - lead)
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
                G[n, BORDER] += w1 * eta
                G[n, BORDER + 1] += w2 * eta
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
                n = 2 * (j + i - lead) + o
                if 0 <= n < unknowns:
                    g[n] += smooth[o] * THIRD[i] * third
                    for k in range(max(0, i - n // 2), i + 1):
                        M[n, 2 * (i - k)] += smooth[o] * THIRD[i] * THIRD[k]
    if thrust_rate > 0.0:
        change = np.zeros(unknowns + BORDER)
        for k in range(2 * count - 2):
            begin, end = row_span(SLEW, k, lead, unknowns)
            change[begin:end] = 0.0
            add_thrust(c, s, points, lead, F, k + 2, 1.0, change)
            add_thrust(c, s, points, lead, F, k, -1.0, change)
            stiff = thrust_rate * root / (tau[k // 2 + 1] - tau[k // 2])
            for n in range(begin, end):
                g[n] += stiff * (f[k + 2] - f[k]) * change[n]
                for m in range(begin, n + 1):
                    M[n, n - m] += stiff * change[n] * change[m]
    if has_rows:
        differentiate_rows(c, s, damping, points, lead, rows, targets, vias, floor, f, F, r, R, R_s, knots, places, J)
        offset = len(y) - bounded
        for q in range(bounded):
            stiff = stiffness[offset + q]
            ss += stiff * J[q, unknowns] ** 2
            sw += stiff * J[q, unknowns] * J[q, unknowns + 1]
            border[1, 1] += stiff * J[q, unknowns + 1] ** 2
            begin, end = row_span(rows[q, 0], rows[q, 1], lead, unknowns)
            for n in range(begin, end):
                push = stiff * J[q, n]
                if push != 0.0:
                    G[n, 0] += push * J[q, unknowns]
                    G[n, 1] += push * J[q, unknowns + 1]
                    for m in range(max(begin, n - M.shape[1] + 1), n + 1):
                        M[n, n - m] += push * J[q, m]
        for q in range(bounded, len(rows)):
            k = q - bounded + 2
            for n in range(unknowns):
                G[n, BORDER + k] = J[q, n]
            es[k, 0], es[k, 1] = J[q, unknowns], J[q, unknowns + 1]
            if rows[q, 0] == END:
                order = rows[q, 1] % 3
                ss -= lam[k] * targets[q] * 0.25 * order * (order + 2) * T**order / s**2
    es[0, 0], es[1, 0] = es1, es2
    border[0, 0] += ss
    border[0, 1] += sw
    border[1, 0] += sw
    return gs


def row_span(kind, k, lead, unknowns):
    """First unknown with a derivative of a row, and the one after the last."""
    if kind in (ELEVATION, ELEVATION_RATE):
        return max(0, 2 * (k - lead)), min(unknowns, 2 * (k + 2 - lead))
    if kind in (SLEW, LEAD):
        # both points are in one segment, except that its last one belongs to the next
        first = k // 6 - lead
        return max(0, 2 * first), min(unknowns, 2 * (first + 5))
    return 0, unknowns


def pull_on_travel(c, y, s, damping, points, rows, vias, floor, r, knots, places, on_travel, on_travel_s):
    """Accumulate the rows' multipliers y (R,) times the derivatives of the travel by its accelerations and by s."""
    _, _, tau, _ = points
    angles = knots[1]
    segments, T = len(angles) - 1, 1.0 / math.sqrt(s)
    on_rate, on_angle = np.zeros(segments + 1), np.zeros(segments + 1)
    for n in range(len(rows)):
        kind, k = rows[n, 0], rows[n, 1]
        if kind == TRAVEL_RATE:
            on_rate[k] += y[n]
        elif kind == FLOOR:
            on_angle[k] -= y[n] * floor_at(angles[k], floor)[1]
        elif kind in (VIA_TRAVEL, CROSSING):
            pull = y[n]
            if kind == CROSSING:
                pull *= -crossing_slope(c, k, r, T, damping, knots, places)
            j, u = int(places[k, 0]), places[k, 1]
            weights = partial_weights(u)
            on_angle[j] += pull
            on_rate[j] += pull * arrival(u * T / segments, damping)[1]
            for q in range(4):
                on_travel[3 * j + q] += pull * (T / segments) ** 2 * weights[q]
                on_travel_s[3 * j + q] -= pull * (T / segments) ** 2 * weights[q] / s
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


def differentiate_rows(c, s, damping, points, lead, rows, targets, vias, floor, f, F, r, R, R_s, knots, places, J):
    """Fill in the rows' derivatives J (R, N + 2) from those of accelerations, R (K, 8) by coefficients, R_s by s."""
    _, first, tau, _ = points
    rates, angles = knots[0], knots[1]
    segments, root, unknowns = len(c) - 3, math.sqrt(s), J.shape[1] - BORDER
    T = 1.0 / root
    J[:] = 0.0
    on_travel = False
    for n in range(len(rows)):
        kind = rows[n, 0]
        on_travel = on_travel or kind in (TRAVEL_RATE, FLOOR, VIA_TRAVEL, CROSSING)
    by_rate = np.zeros((segments + 1 if on_travel else 1, unknowns + BORDER))
    by_angle = np.zeros((segments + 1 if on_travel else 1, unknowns + BORDER))
    keep, carry = arrival(T / segments, damping)
    T_s = -0.5 * T / s
    by_rate[0, unknowns + 1] = 1.0
    for j in range(segments if on_travel else 0):
        for n in range(unknowns + BORDER):
            by_rate[j + 1, n] = keep * by_rate[j, n]
            by_angle[j + 1, n] = by_angle[j, n] + carry * by_rate[j, n]
        by_rate[j + 1, unknowns] -= T_s * damping / segments * keep * rates[j]
        by_angle[j + 1, unknowns] += T_s / segments * keep * rates[j]
        for q in range(4):
            p = 3 * j + q
            left = T * ((j + 1.0) / segments - tau[p])
            decay, advance = arrival(left, damping)
            share = SHARES[q] / segments
            base = 2 * (first[p] - lead)
            for i in range(8):
                if 0 <= base + i < unknowns:
                    by_rate[j + 1, base + i] += T * share * decay * R[p, i]
                    by_angle[j + 1, base + i] += T * share * advance * R[p, i]
            by_rate[j + 1, unknowns] += share * (T * decay * R_s[p] + T_s * decay * (1.0 - damping * left) * r[p])
            by_angle[j + 1, unknowns] += share * (T * advance * R_s[p] + T_s * (advance + decay * left) * r[p])
    for n in range(len(rows)):
        kind, k = rows[n, 0], rows[n, 1]
        if kind == ELEVATION:
            J[n, 2 * (k - lead)] = 1.0
        elif kind == ELEVATION_RATE:
            for i in range(2):
                if 0 <= 2 * (k + i - lead) < unknowns:
                    J[n, 2 * (k + i - lead)] = segments * root * (2.0 * i - 1.0)
            J[n, unknowns] = 0.5 * segments / root * (c[k + 1, 0] - c[k, 0])
        elif kind == TRAVEL_RATE:
            for m in range(unknowns + BORDER):
                J[n, m] = by_rate[k, m]
        elif kind == FLOOR:
            slope = floor_at(angles[k], floor)[1]
            for m in range(unknowns + BORDER):
                J[n, m] = -slope * by_angle[k, m]
            for i in range(3):
                if 0 <= 2 * (k + i - lead) < unknowns:
                    J[n, 2 * (k + i - lead)] += KNOT[i]
        elif kind in (SLEW, LEAD):
            scale = root / (tau[k // 2 + 1] - tau[k // 2])
            if kind == LEAD:
                scale *= targets[n]
            add_thrust(c, s, points, lead, F, k + 2, scale + (1.0 if kind == LEAD else 0.0), J[n])
            add_thrust(c, s, points, lead, F, k, -scale, J[n])
            J[n, unknowns] += 0.5 * scale / s * (f[k + 2] - f[k])
        elif kind == END:
            order, output = k % 3, (k // 3) % 2
            for i in range(3):
                weight = segments**order * ENDS[order][i]
                m = 2 * (i - lead) + output
                if (k < GOAL or k >= LOOP) and 0 <= m < unknowns:
                    J[n, m] += -weight if k >= LOOP else weight
                m = 2 * (segments + i - lead) + output
                if k >= GOAL and 0 <= m < unknowns:
                    J[n, m] += weight
            J[n, unknowns] = 0.5 * order * targets[n] * T**order / s
        else:
            j, u = int(places[k, 0]), places[k, 1]
            if kind != VIA_ELEVATION:
                by_travel = 1.0 if kind == VIA_TRAVEL else -crossing_slope(c, k, r, T, damping, knots, places)
                weights, (_, carried) = partial_weights(u), arrival(u * T / segments, damping)
                for m in range(unknowns + BORDER):
                    J[n, m] += by_travel * (by_angle[j, m] + carried * by_rate[j, m])
                J[n, unknowns] += by_travel * T_s * u / segments * rates[j]
                for q in range(4):
                    p = 3 * j + q
                    weight = by_travel * (T / segments) ** 2 * weights[q]
                    base = 2 * (first[p] - lead)
                    for i in range(8):
                        if 0 <= base + i < unknowns:
                            J[n, base + i] += weight * R[p, i]
                    J[n, unknowns] += weight * (R_s[p] - r[p] / s)
            if kind != VIA_TRAVEL:
                values = basis(u)[0]
                for i in range(4):
                    if 0 <= 2 * (j + i - lead) < unknowns:
                        J[n, 2 * (j + i - lead)] += values[i]


def add_thrust(c, s, points, lead, F, k, scale, row):
    """Add to a row (N + 2,) the derivatives of the k-th thrust by the coefficients and by s, times `scale`."""
    B, first, _, _ = points
    p, root, z, unknowns = k // 2, math.sqrt(s), np.empty(6), len(row) - BORDER
    outputs(c, root, B, first, p, z)
    row[unknowns] += scale * (0.5 * (F[k, 1] * z[1] + F[k, 4] * z[4]) + F[k, 2] * z[2] + F[k, 5] * z[5]) / s
    for i in range(4):
        n = 2 * (first[p] + i - lead)
        if 0 <= n < unknowns:
            for o in range(2):
                by_c = B[p, 0, i] * F[k, 3 * o] + root * B[p, 1, i] * F[k, 3 * o + 1] + s * B[p, 2, i] * F[k, 3 * o + 2]
                row[n + o] += scale * by_c


def vjp(force, F, J, rows, c, s, points, lead, g):
    """Add to g the vector-Jacobian product of `force` with thrusts and rows; return its entries for s and w."""
    B, first, tau, _ = points
    by_s, by_w, z, n_ = 0.0, 0.0, np.empty(6), np.empty(6)
    root, unknowns = math.sqrt(s), len(g)
    for p in range(len(tau)):
        outputs(c, root, B, first, p, z)
        for a in range(6):
            n_[a] = force[2 * p] * F[2 * p, a] + force[2 * p + 1] * F[2 * p + 1, a]
        by_s += (0.5 * (n_[1] * z[1] + n_[4] * z[4]) + n_[2] * z[2] + n_[5] * z[5]) / s
        for i in range(4):
            n = 2 * (first[p] + i - lead)
            if 0 <= n < unknowns:
                g[n] += B[p, 0, i] * n_[0] + root * B[p, 1, i] * n_[1] + s * B[p, 2, i] * n_[2]
                g[n + 1] += B[p, 0, i] * n_[3] + root * B[p, 1, i] * n_[4] + s * B[p, 2, i] * n_[5]
    offset = len(force) - len(J)
    for q in range(len(J)):
        begin, end = row_span(rows[q, 0], rows[q, 1], lead, unknowns)
        for n in range(begin, end):
            g[n] += force[offset + q] * J[q, n]
        by_s += force[offset + q] * J[q, unknowns]
        by_w += force[offset + q] * J[q, unknowns + 1]
    return by_s, by_w


def jvp(dx, ds, dw, F, J, rows, c, s, points, lead, df):
    """Add to df the Jacobian-vector product: changes of thrusts (2 K,) and rows for steps of coefficients, s and w."""
    B, first, tau, _ = points
    z, d = np.empty(6), np.empty(6)
    root, unknowns = math.sqrt(s), len(dx)
    for p in range(len(tau)):
        outputs(c, root, B, first, p, z)
        d[0], d[1], d[2] = 0.0, 0.5 * ds * z[1] / s, ds * z[2] / s
        d[3], d[4], d[5] = 0.0, 0.5 * ds * z[4] / s, ds * z[5] / s
        for i in range(4):
            n = 2 * (first[p] + i - lead)
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
        begin, end = row_span(rows[q, 0], rows[q, 1], lead, unknowns)
        for n in range(begin, end):
            df[offset + q] += J[q, n] * dx[n]
        df[offset + q] += J[q, unknowns] * ds + J[q, unknowns + 1] * dw


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


def schur_step(G, columns, g, border, gb, es, e, is_free, step):
    """Fill in the step (2 + E,): steps of s and w, and new multipliers; return whether it is a descent direction.

    columns (N, 3 + E) = M^-1 (G, -g). The Schur complement of the coefficients must be negative definite for the
    multipliers, and that of both positive definite for s and w.
    """
    size, last = G.shape[1], G.shape[1]
    S, rhs = np.zeros((size, size)), np.zeros(size)
    for n in range(len(g)):
        for i in range(size):
            if G[n, i] != 0.0:
                rhs[i] -= G[n, i] * columns[n, last]
                for j in range(size):
                    S[i, j] -= G[n, i] * columns[n, j]
    for i in range(BORDER):
        rhs[i] -= gb[i]
        for j in range(BORDER):
            S[i, j] += border[i, j]
        for k in range(len(e)):
            S[i, BORDER + k] += es[k, i]
            S[BORDER + k, i] += es[k, i]
    for k in range(len(e)):
        rhs[BORDER + k] -= e[k]
    for i in range(BORDER):
        if not is_free[i]:
            for j in range(size):
                S[i, j] = S[j, i] = 0.0
            S[i, i], rhs[i] = 1.0, 0.0
    # elimination without pivoting, from the last equation to s: pivots must be negative, then positive
    for k in range(size - 1, -1, -1):
        pivot = -S[k, k] if k >= BORDER else S[k, k]
        if not pivot > TINY:
            return False
        for i in range(k):
            ratio = S[i, k] / S[k, k]
            if ratio != 0.0:
                rhs[i] -= ratio * rhs[k]
                for j in range(k):
                    S[i, j] -= ratio * S[k, j]
    for i in range(size):
        value = rhs[i]
        for j in range(i):
            value -= S[i, j] * step[j]
        step[i] = value / S[i, i]
    return True


def newton_step(M, G, g, border, gb, es, e, is_free, damping, columns, L, dx, step):
    """Fill in the step dx (N,) of the coefficients and the one of `schur_step`; return the damping.

    The damping is raised until the Hessian is positive definite, so that the step is a descent direction.
    """
    size = G.shape[1]
    while damping < MOST_DAMPING:
        if factorise(M, damping, L):
            for n in range(len(g)):
                for i in range(size):
                    columns[n, i] = G[n, i]
                columns[n, size] = -g[n]
            substitute(L, columns)
            damped = border.copy()
            for i in range(BORDER):
                damped[i, i] += damping
            if schur_step(G, columns, g, damped, gb, es, e, is_free, step):
                for n in range(len(g)):
                    dx[n] = columns[n, size]
                    for i in range(size):
                        dx[n] -= step[i] * columns[n, i]
                return damping
        damping = max(DAMPING, 8.0 * damping)
    return damping


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


def solve(
    c,
    s,
    w,
    held,
    travel,
    low,
    high,
    rows,
    targets,
    vias,
    floor,
    parameters,
    weights,
    is_free,
    mu,
    last_mu,
    tolerance,
    iterations,
):
    """Minimise the objective while the barrier parameter decreases from mu to last_mu.

    Args:
        c, s, w: guess of the coefficients (M, 2) in rad, of 1/T² in 1/s², and of the initial travel rate in rad/s.
        held: numbers of fixed coefficients at the start and at the goal.
        travel: rate and angle at the goal, damping, and 1 for a periodic flight, otherwise 0: rad/s, rad, 1/s. The
            travel starts at zero; a periodic flight's rate at the goal is relative to the initial one.
        low, high: bounds of thrusts in N (2 K,), free pitch coefficients in rad and rows.
        rows: kind and index (R, 2) of further quantities: first those with bounds, then equations.
        targets: (R,) values of rows of the kind END, lag in s of the kind LEAD.
        vias: (V, 3) time as tau, travel and elevation of via points; a free time is -1 minus its estimate.
        floor: travel and elevation (2, N) in rad, for rows of the kind FLOOR.
        parameters: parameters of the helicopter.
        weights: of squared third differences of the coefficients (2,), of the logarithm of the duration, and of the
            mean squared distance of the thrusts from hover; then the hover thrusts in N, and the weight of the integral
            of the squared thrust rates, zero if s is free.
        is_free: whether s may change, and whether w may.
        tolerance: of equations and bounds in N and rad/s²; that of optimality is last_mu.
        iterations: largest number.

    Returns:
        Whether it converged, number of iterations, c, s, w, and multipliers of the lower and upper bounds (2, ...).
    """
    segments, time_weight, lead = len(c) - 3, weights[1], held[0]
    points, free = tables(segments), segments + 3 - lead - held[1]
    count, unknowns = 2 * (3 * segments + 1), 2 * free
    size, offset = len(low), count + free
    bounded = size - offset
    equations = 2 + len(rows) - bounded
    v, dv, new_v, r = np.empty(size), np.empty(size), np.empty(size), np.zeros(size)
    zl, zu, dzl, dzu = np.empty(size), np.empty(size), np.empty(size), np.empty(size)
    y, stiffness, force = np.empty(size), np.empty(size), np.empty(size)
    g, direct, dx = np.empty(unknowns), np.empty(unknowns), np.empty(unknowns)
    f, F, h = np.empty(count), np.empty((count, 6)), np.empty(len(rows))
    band = BAND if bounded == 0 and weights[4] == 0.0 else LOCAL_BAND
    for q in range(bounded):
        if rows[q, 0] == TRAVEL_RATE or rows[q, 0] == FLOOR:
            band = unknowns
    M = np.empty((unknowns, band))
    L, J = np.zeros(M.shape), np.zeros((len(rows), unknowns + BORDER))
    G, columns = np.empty((unknowns, BORDER + equations)), np.empty((unknowns, BORDER + equations + 1))
    step, border, gb = np.zeros(BORDER + equations), np.zeros((BORDER, BORDER)), np.zeros(BORDER)
    e, es, lam = np.zeros(equations), np.zeros((equations, BORDER)), np.zeros(equations)
    acceleration, knots, places = np.empty(count // 2), np.empty((2, segments + 1)), np.zeros((len(vias), 2))
    c, new_c = c.copy(), c.copy()
    for i in range(free):
        inside = CLOSEST * (high[count + i] - low[count + i])
        v[count + i] = c[lead + i, 1] = min(max(c[lead + i, 1], low[count + i] + inside), high[count + i] - inside)
    problem = travel, weights, parameters, points, rows, targets, vias, floor
    values = f, acceleration, knots, places, h, e
    objective = evaluate(c, s, w, *problem, *values)
    for k in range(size):
        if k < count or k >= offset:
            value = f[k] if k < count else h[k - offset]
            inside = CLOSEST * (high[k] - low[k])
            v[k] = min(max(value, low[k] + inside), high[k] - inside)
        zl[k], zu[k], r[k] = mu / (v[k] - low[k]), mu / (high[k] - v[k]), 0.0

    damping, penalty, converged, taken = 0.0, 1.0, False, 0
    while taken < iterations:
        for k in range(count):
            r[k] = f[k] - v[k]
        for k in range(bounded):
            r[offset + k] = h[k] - v[offset + k]
        duals(mu, v, low, high, zl, zu, r, y, stiffness, force)
        direct_s = assemble(
            c,
            s,
            w,
            y,
            stiffness,
            lam,
            travel,
            weights,
            parameters,
            points,
            lead,
            rows,
            targets,
            vias,
            floor,
            f,
            acceleration,
            knots,
            places,
            F,
            M,
            G,
            direct,
            J,
            es,
            border,
        )
        direct_s -= 0.5 * time_weight / s
        for i in range(unknowns):
            g[i] = direct[i]
            for k in range(equations):
                g[i] += lam[k] * G[i, BORDER + k]
        gs, gw = vjp(y, F, J[:bounded], rows, c, s, points, lead, g)
        gs += direct_s
        for k in range(equations):
            gs += lam[k] * es[k, 0]
            gw += lam[k] * es[k, 1]
        for i in range(free):
            g[2 * i + 1] += y[count + i]
            M[2 * i + 1, 0] += stiffness[count + i]
        missed, residual = kkt_residual(mu, v, low, high, zl, zu, r, g)
        for k in range(equations):
            missed = max(missed, abs(e[k]))
        if is_free[0]:
            residual = max(residual, s * abs(gs))
        if is_free[1]:
            residual = max(residual, abs(gw))
        error = max(missed, residual)
        if mu <= last_mu and missed < tolerance and error < 10.0 * mu:
            converged = True
            break
        taken += 1
        while mu > last_mu and error < 10.0 * mu:
            mu = max(last_mu, min(0.2 * mu, mu**1.5))

        duals(mu, v, low, high, zl, zu, r, y, stiffness, force)
        for i in range(unknowns):
            g[i] = direct[i]
        gs, gw = vjp(force, F, J[:bounded], rows, c, s, points, lead, g)
        gb[0], gb[1] = gs + direct_s, gw
        for i in range(free):
            g[2 * i + 1] += force[count + i]
        damping = damping / 8.0 if damping > DAMPING else 0.0
        damping = newton_step(M, G, g, border, gb, es, e, is_free, damping, columns, L, dx, step)
        if damping >= MOST_DAMPING:
            break
        ds, dw = step[0], step[1]
        for k in range(size):
            dv[k] = r[k]
        jvp(dx, ds, dw, F, J[:bounded], rows, c, s, points, lead, dv)
        for i in range(free):
            dv[count + i] = dx[2 * i + 1]
        length, dual = dual_step(mu, v, dv, low, high, zl, zu, dzl, dzu)
        if is_free[0]:
            length = min(length, 0.5 * s / max(abs(ds), TINY))

        missing, slope = 0.0, direct_s * ds
        for k in range(equations):
            missing += abs(e[k])
        for i in range(unknowns):
            slope += direct[i] * dx[i]
        for k in range(size):
            missing += abs(r[k])
            slope += (force[k] - stiffness[k] * r[k]) * dv[k]
        if missing > tolerance:
            penalty = max(penalty, slope / (0.5 * missing))
        before = objective + mu * barrier(v, low, high) + penalty * missing
        accepted = False
        for _ in range(BACKTRACKS):
            new_s, new_w = s + length * ds, w + length * dw
            for i in range(free):
                new_c[lead + i, 0] = c[lead + i, 0] + length * dx[2 * i]
                new_c[lead + i, 1] = c[lead + i, 1] + length * dx[2 * i + 1]
            objective = evaluate(new_c, new_s, new_w, *problem, *values)
            after = objective
            for k in range(equations):
                after += penalty * abs(e[k])
            for k in range(size):
                new_v[k] = v[k] + length * dv[k]
                if k < count:
                    after += penalty * abs(f[k] - new_v[k])
                elif k >= offset:
                    after += penalty * abs(h[k - offset] - new_v[k])
            after += mu * barrier(new_v, low, high)
            if after <= before + SUFFICIENT * length * (slope - penalty * missing) + ROUNDING * abs(before):
                accepted = True
                break
            length *= 0.5
        if accepted:
            s, w, c, new_c, v, new_v = new_s, new_w, new_c, c, new_v, v
            for k in range(equations):
                lam[k] += length * (step[BORDER + k] - lam[k])
            for k in range(size):
                zl[k] += dual * dzl[k]
                zu[k] += dual * dzu[k]
        else:  # repeat with more damping
            objective = evaluate(c, s, w, *problem, *values)
            damping = max(1.0, 64.0 * damping)
    multipliers = np.empty((2, size))
    for k in range(size):
        multipliers[0, k], multipliers[1, k] = zl[k], zu[k]
    return converged, taken, c, s, w, multipliers


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


def run(*arguments):
    """Call `solve` from a compiled entry point, so that `solve` itself is compiled without fast-math."""
    return solve(*arguments)


@cache
def compiled(function: Callable) -> Callable:
    """Compile the function at its first call, cached on disk until (3) or this module changes."""
    return Compiler(careful=CAREFUL).entry(function)
