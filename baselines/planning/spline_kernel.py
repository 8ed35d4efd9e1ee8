"""The interior-point method behind `heli_gym.baselines.planning.spline`, compiled.

Unknown are the coefficients c (M, 2) of elevation and pitch, but the first and last three, and, if the duration is
free, s = 1/T². The travel's two quadratures E are the only equations; the fans' thrusts f at K points and the pitch
coefficients have bounds. In the order of the knots, the normal equations are banded, but for a border of three: s and
the multipliers of the two equations.
"""

import math

import numpy as np
from numba import njit

BAND = 8  # diagonals of the lower triangle: four coefficients of two outputs meet in a segment
INNER = 0.5 / math.sqrt(5.0)
POINTS = (0.0, 0.5 - INNER, 0.5 + INNER)  # Lobatto's, of a segment; its fourth is the first of the next
WEIGHTS = (1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0)  # of the quadrature, at a knot the shares of both segments
THIRD = (-1.0, 3.0, -3.0, 1.0)  # third difference
CLOSEST = 0.02  # share of the distance between its bounds that a guess keeps from them
TO_BOUNDARY = 0.99  # share of the way to a bound that a step may go
BACKTRACKS = 14
SUFFICIENT, ROUNDING = 1e-4, 1e-12  # shares of the predicted decrease that a step must reach, and of what rounding adds
DAMPING, MOST_DAMPING = 1e-6, 1e12  # additions to the diagonal where the Hessian is not positive: the first, the last
SINGULAR, TINY = 1e-14, 1e-300  # what counts as zero: pivots of the factorisation, steps


@njit(cache=True)
def basis(u):
    """Uniform cubic B-splines on a segment, u in [0, 1]: four values, four second derivatives by u."""
    w = 1.0 - u
    return (
        (w**3 / 6.0, (3.0 * u**3 - 6.0 * u**2 + 4.0) / 6.0, (3.0 * w**3 - 6.0 * w**2 + 4.0) / 6.0, u**3 / 6.0),
        (w, 3.0 * u - 2.0, 1.0 - 3.0 * u, u),
    )


@njit(cache=True)
def tables(segments):
    """Of all K points: values and second derivatives by tau (K, 4), first coefficient, tau and weight (K,)."""
    count = 3 * segments + 1
    B, ddB = np.empty((count, 4)), np.empty((count, 4))
    first, tau, weight = np.empty(count, np.int64), np.empty(count), np.empty(count)
    for p in range(count):
        first[p] = min(p // 3, segments - 1)
        u = POINTS[p % 3] if p < count - 1 else 1.0
        value, curvature = basis(u)
        for i in range(4):
            B[p, i], ddB[p, i] = value[i], segments**2 * curvature[i]
        tau[p] = (first[p] + u) / segments
        weight[p] = WEIGHTS[p % 3] / segments
    weight[0] = weight[count - 1] = 1.0 / (12.0 * segments)
    return B, ddB, first, tau, weight


@njit(cache=True)
def outputs(c, B, ddB, first, p):
    """Elevation, pitch, and their second derivatives by tau, at a point."""
    y1 = y2 = d1 = d2 = 0.0
    for i in range(4):
        c1, c2 = c[first[p] + i, 0], c[first[p] + i, 1]
        y1 += B[p, i] * c1
        y2 += B[p, i] * c2
        d1 += ddB[p, i] * c1
        d2 += ddB[p, i] * c2
    return y1, y2, d1, d2


@njit(cache=True)
def inverse_dynamics(y1, y2, A1, A2, model):
    """Equations (13), (14a): the thrusts of both fans and the travel's second derivative."""
    a1, a2, a3, b1, b2, b3 = model
    excess = A1 - a1 * math.sin(y1) - a2 * math.cos(y1)
    v1 = excess / (b2 * math.cos(y2))
    v2 = (A2 - a3 * math.cos(y1) * math.sin(y2)) / b3
    return 0.5 * (v1 + v2), 0.5 * (v1 - v2), b1 / b2 * math.tan(y2) * excess * math.cos(y1)


@njit(cache=True)
def derivatives(y1, y2, A1, model, D, H):
    """Fills in first derivatives D (3, 4) and second ones H (3, 4, 4), lower triangle, of (v1, v2, ddeta).

    They are by (y1, A1, y2, A2), A1 and A2 being the second derivatives of y1 and y2. What vanishes is left alone.
    """
    a1, a2, a3, b1, b2, b3 = model
    s1, c1, s2, c2 = math.sin(y1), math.cos(y1), math.sin(y2), math.cos(y2)
    t = s2 / c2
    squared = 1.0 + t * t
    lift, slope = a1 * s1 + a2 * c1, a1 * c1 - a2 * s1
    excess, k, ratio = A1 - lift, 1.0 / (b2 * c2), b1 / b2
    turn = -s1 * excess - c1 * slope
    D[0, 0], D[0, 1], D[0, 2] = -slope * k, k, excess * k * t
    D[1, 0], D[1, 2], D[1, 3] = a3 * s1 * s2 / b3, -a3 * c1 * c2 / b3, 1.0 / b3
    D[2, 0], D[2, 1], D[2, 2] = ratio * t * turn, ratio * t * c1, ratio * squared * c1 * excess
    H[0, 0, 0], H[0, 2, 0], H[0, 2, 1], H[0, 2, 2] = lift * k, -slope * k * t, k * t, excess * k * (1.0 + 2.0 * t * t)
    H[1, 0, 0], H[1, 2, 0], H[1, 2, 2] = a3 * c1 * s2 / b3, a3 * s1 * c2 / b3, a3 * c1 * s2 / b3
    H[2, 0, 0], H[2, 1, 0] = ratio * t * (c1 * lift - c1 * excess + 2.0 * s1 * slope), -ratio * t * s1
    H[2, 2, 0], H[2, 2, 1] = ratio * squared * turn, ratio * squared * c1
    H[2, 2, 2] = 2.0 * ratio * t * squared * c1 * excess


@njit(cache=True)
def evaluate(c, s, travel, smooth, time_weight, model, points, f):
    """Fills in the thrusts f (2 K,); returns the objective and the two equations that the travel must meet."""
    B, ddB, first, tau, weight = points
    e1, e2 = 0.0, -travel * s
    for p in range(len(tau)):
        y1, y2, d1, d2 = outputs(c, B, ddB, first, p)
        f[2 * p], f[2 * p + 1], ddeta = inverse_dynamics(y1, y2, s * d1, s * d2, model)
        e1 += weight[p] * ddeta
        e2 += weight[p] * (1.0 - tau[p]) * ddeta
    objective = -0.5 * time_weight * math.log(s)
    for j in range(len(c) - 3):
        for o in range(2):
            objective += 0.5 * smooth[o] * (c[j + 3, o] - c[j, o] + 3.0 * (c[j + 1, o] - c[j + 2, o])) ** 2
    return objective, e1, e2


@njit(cache=True)
def assemble(c, s, y, stiffness, lam1, lam2, travel, smooth, time_weight, model, points, F, M, G, g):
    """The Hessian of the Lagrangian, the stiffness of the thrusts' barrier included, and the first derivatives.

    Fills in the thrusts' gradients F (2 K, 4) by (y1, A1, y2, A2), the Hessian's lower band M (N, BAND) by the
    coefficients, its border G (N, 3) with the gradients of the two equations, and the objective's gradient g (N,).
    Returns by s: the second derivative, and the first ones of the equations.
    """
    B, ddB, first, tau, weight = points
    unknowns = len(g)
    M[:] = 0.0
    G[:] = 0.0
    g[:] = 0.0
    D, H, L, Q, mixed = np.zeros((3, 4)), np.zeros((3, 4, 4)), np.zeros((4, 4)), np.zeros((8, 4)), np.zeros(4)
    ss, es1, es2 = 0.5 * time_weight / s**2, 0.0, -travel
    for p in range(len(tau)):
        y1, y2, d1, d2 = outputs(c, B, ddB, first, p)
        derivatives(y1, y2, s * d1, model, D, H)
        w1, w2 = weight[p], weight[p] * (1.0 - tau[p])
        by_v1, by_v2 = 0.5 * (y[2 * p] + y[2 * p + 1]), 0.5 * (y[2 * p] - y[2 * p + 1])
        by_eta = w1 * lam1 + w2 * lam2
        for a in range(4):
            F[2 * p, a], F[2 * p + 1, a] = 0.5 * (D[0, a] + D[1, a]), 0.5 * (D[0, a] - D[1, a])
        for a in range(4):
            for b in range(a + 1):
                L[a, b] = (
                    by_v1 * H[0, a, b]
                    + by_v2 * H[1, a, b]
                    + by_eta * H[2, a, b]
                    + stiffness[2 * p] * F[2 * p, a] * F[2 * p, b]
                    + stiffness[2 * p + 1] * F[2 * p + 1, a] * F[2 * p + 1, b]
                )
                L[b, a] = L[a, b]
        for a in range(4):  # A1 = s d1 and A2 = s d2 depend on s
            mixed[a] = L[a, 1] * d1 + L[a, 3] * d2
        ss += mixed[1] * d1 + mixed[3] * d2
        es1 += w1 * D[2, 1] * d1
        es2 += w2 * D[2, 1] * d1
        slopes = by_v1 * D[0, 1] + by_eta * D[2, 1], by_v2 * D[1, 3]
        base = 2 * (first[p] - 3)
        for i in range(8):  # coefficient i // 2 of output i % 2
            n, o, value, curvature = base + i, 2 * (i % 2), B[p, i // 2], ddB[p, i // 2]
            if 0 <= n < unknowns:
                for a in range(4):
                    Q[i, a] = value * L[o, a] + s * curvature * L[o + 1, a]
                eta = value * D[2, o] + s * curvature * D[2, o + 1]
                G[n, 0] += value * mixed[o] + s * curvature * mixed[o + 1] + curvature * slopes[i % 2]
                G[n, 1] += w1 * eta
                G[n, 2] += w2 * eta
                for j in range(max(0, -base), i + 1):
                    oj = 2 * (j % 2)
                    M[n, i - j] += B[p, j // 2] * Q[i, oj] + s * ddB[p, j // 2] * Q[i, oj + 1]
    for j in range(len(c) - 3):
        for o in range(2):
            third = c[j + 3, o] - c[j, o] + 3.0 * (c[j + 1, o] - c[j + 2, o])
            for i in range(4):
                n = 2 * (j + i - 3) + o
                if 0 <= n < unknowns:
                    g[n] += smooth[o] * THIRD[i] * third
                    for k in range(max(0, i - n // 2), i + 1):
                        M[n, 2 * (i - k)] += smooth[o] * THIRD[i] * THIRD[k]
    return ss, es1, es2


@njit(cache=True)
def vjp(force, F, c, s, points, g):
    """Adds to g the gradient of force (2 K,) times the thrusts; returns its derivative by s."""
    B, ddB, first, tau, _ = points
    by_s = 0.0
    for p in range(len(tau)):
        _, _, d1, d2 = outputs(c, B, ddB, first, p)
        n1, a1, n2, a2 = 0.0, 0.0, 0.0, 0.0
        for k in (2 * p, 2 * p + 1):
            n1 += force[k] * F[k, 0]
            a1 += force[k] * F[k, 1]
            n2 += force[k] * F[k, 2]
            a2 += force[k] * F[k, 3]
        by_s += a1 * d1 + a2 * d2
        for i in range(4):
            n = 2 * (first[p] + i - 3)
            if 0 <= n < len(g):
                g[n] += B[p, i] * n1 + s * ddB[p, i] * a1
                g[n + 1] += B[p, i] * n2 + s * ddB[p, i] * a2
    return by_s


@njit(cache=True)
def jvp(dx, ds, F, c, s, points, df):
    """Adds to df (2 K,) the change of the thrusts with the coefficients and s."""
    B, ddB, first, tau, _ = points
    for p in range(len(tau)):
        _, _, d1, d2 = outputs(c, B, ddB, first, p)
        n1, a1, n2, a2 = 0.0, ds * d1, 0.0, ds * d2
        for i in range(4):
            n = 2 * (first[p] + i - 3)
            if 0 <= n < len(dx):
                n1 += B[p, i] * dx[n]
                a1 += s * ddB[p, i] * dx[n]
                n2 += B[p, i] * dx[n + 1]
                a2 += s * ddB[p, i] * dx[n + 1]
        for k in (2 * p, 2 * p + 1):
            df[k] += F[k, 0] * n1 + F[k, 1] * a1 + F[k, 2] * n2 + F[k, 3] * a2


@njit(cache=True)
def factorise(M, damping, L):
    """Cholesky factor L of the banded M plus damping on its diagonal; whether that is positive definite."""
    for i in range(len(M)):
        for k in range(min(BAND - 1, i), -1, -1):
            j = i - k
            value = M[i, k] + damping if k == 0 else M[i, k]
            for m in range(max(0, i - BAND + 1), j):
                value -= L[i, i - m] * L[j, j - m]
            if k > 0:
                L[i, k] = value / L[j, 0]
            elif value > SINGULAR:
                L[i, 0] = math.sqrt(value)
            else:
                return False
    return True


@njit(cache=True)
def substitute(L, b):
    """Solves L L' x = b (N, columns) in place."""
    size = len(L)
    for i in range(size):
        for q in range(b.shape[1]):
            value = b[i, q]
            for k in range(1, min(BAND - 1, i) + 1):
                value -= L[i, k] * b[i - k, q]
            b[i, q] = value / L[i, 0]
    for i in range(size - 1, -1, -1):
        for q in range(b.shape[1]):
            value = b[i, q]
            for k in range(1, min(BAND - 1, size - 1 - i) + 1):
                value -= L[i + k, k] * b[i + k, q]
            b[i, q] = value / L[i, 0]


@njit(cache=True)
def schur_step(G, columns, g, ss, gs, es, e, fixed):
    """The step of s and the new multipliers (3,), given columns = M^-1 (G, -g); NaN where that does not lead downhill.

    With two equations, of the three eigenvalues of their matrix two must be negative and one positive.
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


@njit(cache=True)
def newton_step(M, G, g, ss, gs, es, e, fixed, damping, columns, L, dx):
    """Fills in the step dx (N,) of the coefficients; returns that of s, the new multipliers, and the damping it took.

    As much is added to the Hessian as makes it positive definite, so that the step leads downhill.
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


@njit(cache=True)
def barrier(w, low, high):
    """The sum of -log of the distances of w to its bounds; infinite outside."""
    total = 0.0
    for k in range(len(w)):
        if not low[k] < w[k] < high[k]:
            return math.inf
        total -= math.log((w[k] - low[k]) * (high[k] - w[k]))
    return total


@njit(cache=True)
def duals(mu, w, low, high, zl, zu, r, y, stiffness, force):
    """Fills in y = zu - zl, the barrier's stiffness, and the force that its Newton step exerts at the residuals r."""
    for k in range(len(w)):
        below, above = w[k] - low[k], high[k] - w[k]
        y[k] = zu[k] - zl[k]
        stiffness[k] = zl[k] / below + zu[k] / above
        force[k] = mu / above - mu / below + stiffness[k] * r[k]


@njit(cache=True)
def dual_step(mu, w, dw, low, high, zl, zu, dzl, dzu):
    """Fills in the steps of the multipliers; returns the longest steps, at most 1, of w and of the multipliers.

    Longest is what leaves a share of every distance to a bound.
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


@njit(cache=True)
def kkt_residual(mu, w, low, high, zl, zu, r, gradient):
    """What is left of the equations of the bounds, and of stationarity and complementarity, these scaled."""
    missed = residual = total = 0.0
    for k in range(len(w)):
        missed = max(missed, abs(r[k]))
        total += zl[k] + zu[k]
        residual = max(residual, abs(zl[k] * (w[k] - low[k]) - mu), abs(zu[k] * (high[k] - w[k]) - mu))
    for value in gradient:
        residual = max(residual, abs(value))
    return missed, residual / max(1.0, 0.1 * total / len(w))


@njit(cache=True)
def solve(c, s, travel, thrust, pitch, model, smooth, time_weight, mu, last_mu, tolerance, iterations):
    """Minimises haste log(T) + smoothness, the barrier being lowered from mu to last_mu.

    Args:
        c, s: the guess, coefficients (M, 2) in rad and 1/T² in 1/s²; s stays if haste is zero.
        travel: to be travelled, in rad.
        thrust, pitch: bounds in N and rad.
        model: a1, a2, a3, b1, b2, b3.
        smooth: weights (2,) of the squared third differences of the coefficients.
        tolerance: of equations and bounds in N and rad/s²; optimality is judged by last_mu.
        iterations: at most.

    Returns:
        Whether it converged, the iterations taken, c, s, and the sums of the multipliers of the lower and upper bounds
        of the thrusts, then of the pitch (4,).
    """
    segments, fixed = len(c) - 3, time_weight == 0.0
    points, free = tables(segments), segments - 3
    count, unknowns = 2 * (3 * segments + 1), 2 * free
    size = count + free
    low, high, r = np.empty(size), np.empty(size), np.zeros(size)
    w, dw, new_w = np.empty(size), np.empty(size), np.empty(size)
    zl, zu, dzl, dzu = np.empty(size), np.empty(size), np.empty(size), np.empty(size)
    y, stiffness, force = np.empty(size), np.empty(size), np.empty(size)
    g, direct, dx = np.empty(unknowns), np.empty(unknowns), np.empty(unknowns)
    f, F, M, L = np.empty(count), np.empty((count, 4)), np.empty((unknowns, BAND)), np.zeros((unknowns, BAND))
    G, columns = np.empty((unknowns, 3)), np.empty((unknowns, 4))
    c, new_c = c.copy(), c.copy()
    for k in range(size):
        low[k], high[k] = thrust if k < count else pitch
    for i in range(free):
        inside = CLOSEST * (pitch[1] - pitch[0])
        w[count + i] = c[3 + i, 1] = min(max(c[3 + i, 1], pitch[0] + inside), pitch[1] - inside)
    objective, e1, e2 = evaluate(c, s, travel, smooth, time_weight, model, points, f)
    for k in range(size):
        if k < count:
            inside = CLOSEST * (thrust[1] - thrust[0])
            w[k] = min(max(f[k], thrust[0] + inside), thrust[1] - inside)
        zl[k], zu[k], r[k] = mu / (w[k] - low[k]), mu / (high[k] - w[k]), 0.0

    lam1, lam2, damping, penalty, converged, taken = 0.0, 0.0, 0.0, 1.0, False, 0
    while taken < iterations:
        for k in range(count):
            r[k] = f[k] - w[k]
        duals(mu, w, low, high, zl, zu, r, y, stiffness, force)
        ss, es1, es2 = assemble(
            c, s, y, stiffness, lam1, lam2, travel, smooth, time_weight, model, points, F, M, G, direct
        )
        for i in range(unknowns):
            g[i] = direct[i] + lam1 * G[i, 1] + lam2 * G[i, 2]
        gs = vjp(y, F, c, s, points, g) - 0.5 * time_weight / s + lam1 * es1 + lam2 * es2
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
        gs = vjp(force, F, c, s, points, g) - 0.5 * time_weight / s
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
        jvp(dx, ds, F, c, s, points, dw)
        for i in range(free):
            dw[count + i] = dx[2 * i + 1]
        step, dual = dual_step(mu, w, dw, low, high, zl, zu, dzl, dzu)
        if not fixed:
            step = min(step, 0.5 * s / max(abs(ds), TINY))

        missing, slope = abs(e1) + abs(e2), -0.5 * time_weight * ds / s
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
            objective, e1, e2 = evaluate(new_c, new_s, travel, smooth, time_weight, model, points, f)
            after = objective + penalty * (abs(e1) + abs(e2))
            for k in range(size):
                new_w[k] = w[k] + step * dw[k]
                if k < count:
                    after += penalty * abs(f[k] - new_w[k])
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
        else:  # once more, and more carefully
            objective, e1, e2 = evaluate(c, s, travel, smooth, time_weight, model, points, f)
            damping = max(1.0, 64.0 * damping)
    sums = np.zeros(4)
    for k in range(size):
        sums[0 if k < count else 2] += zl[k]
        sums[1 if k < count else 3] += zu[k]
    return converged, taken, c, s, sums


@njit(cache=True)
def interpolate(c, duration, count):
    """Elevation and pitch, their first and their second derivatives by time, (3, 2, K) at K equidistant times."""
    segments = len(c) - 3
    y, rate = np.empty((3, 2, count)), segments / duration
    for k in range(count):
        u = segments * k / (count - 1)
        j = min(int(u), segments - 1)
        u -= j
        w = 1.0 - u
        value, curvature = basis(u)
        slope = (-0.5 * w**2, 1.5 * u**2 - 2.0 * u, 0.5 + u - 1.5 * u**2, 0.5 * u**2)
        for o in range(2):
            y0 = y1 = y2 = 0.0
            for i in range(4):
                y0 += value[i] * c[j + i, o]
                y1 += slope[i] * c[j + i, o]
                y2 += curvature[i] * c[j + i, o]
            y[0, o, k], y[1, o, k], y[2, o, k] = y0, rate * y1, rate**2 * y2
    return y


@njit(cache=True)
def thrusts_along(y, ddy, model):
    """The thrusts (2, K) of both fans and the travel's second derivative (K,) along outputs and theirs, (2, K) each."""
    f, ddeta = np.empty(y.shape), np.empty(y.shape[1])
    for k in range(y.shape[1]):
        f[0, k], f[1, k], ddeta[k] = inverse_dynamics(y[0, k], y[1, k], ddy[0, k], ddy[1, k], model)
    return f, ddeta
