"""Nonlinear model predictive control by real-time iterations, compiled, for one helicopter or many.

Each control period runs one iteration of differential dynamic programming with box constraints on the voltages (Tassa,
Mansard and Todorov, "Control-limited differential dynamic programming", ICRA 2014) and Gauss-Newton Hessians. It starts
from the plan of the last period (Diehl, Bock and Schlöder, "A real-time iteration scheme for nonlinear optimization in
optimal feedback control", SIAM J. Control Optim. 43(5), 2005). The prediction model is `adaptive_filter.advance`.
"""

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from heli_gym.baselines.control.adaptive_filter import (
    N_FLIGHT,
    ROTORS,
    Model,
    advance,
    fan_voltage,
    unexplained,
    with_estimates,
)
from heli_gym.baselines.control.estimation import accommodate
from heli_gym.compilation import Compiler
from heli_gym.model import fan_thrusts

N_INPUTS = 2
N_COST = N_FLIGHT + N_INPUTS  # cost terms of a stage: states, then voltages
PITCH = 4
STEP = 1e-6  # finite-difference step


class MpcSettings(NamedTuple):
    """Horizon and weights of the squared deviations in a stage; one degree of tracking error costs 1."""

    nodes: int = 40
    step: float = 0.06  # s, between nodes
    travel: float = 3283.0  # 1/rad², 1 per degree²
    elevation: float = 3283.0
    travel_rate: float = 0.0  # per (rad/s)²
    elevation_rate: float = 0.0
    pitch: float = 0.0
    pitch_rate: float = 0.3
    effort: float = 0.005  # per V², deviation from the voltages that fly the reference
    outside: float = 0.2  # per V², excess over the planned limits (9)
    pitch_barrier: float = 20.0  # 1/rad², pitch beyond its planned limits minus a margin
    pitch_margin: float = 0.05  # rad
    terminal: float = 5.0  # weight of travel and elevation at the last node, in stages
    terminal_rate: float = 3283.0  # per (rad/s)², travel and elevation at the last node
    terminal_pitch: float = 30.0
    terminal_pitch_rate: float = 3.0


class Bounds(NamedTuple):
    """Hard limits of the voltages in V (low, high); soft limits of voltages in V and pitch in rad (min, max)."""

    u_low: float
    u_high: float
    u_min: float
    u_max: float
    pitch_min: float
    pitch_max: float


def excess(value: float, low: float, high: float) -> float:
    """Signed distance of a value to [low, high]; zero inside."""
    return min(value - low, 0.0) + max(value - high, 0.0)


def stage_cost(z: Any, u: Any, target: Any, c: MpcSettings, b: Bounds) -> float:
    """Cost of a stage at states z (N_FLIGHT,) and voltages u (2,), given the target (N_COST,)."""
    u_f, u_b = u[0], u[1]
    over = excess(z[4], b.pitch_min + c.pitch_margin, b.pitch_max - c.pitch_margin)
    out_f, out_b = excess(u_f, b.u_min, b.u_max), excess(u_b, b.u_min, b.u_max)
    return 0.5 * (
        c.travel * (z[0] - target[0]) ** 2
        + c.travel_rate * (z[1] - target[1]) ** 2
        + c.elevation * (z[2] - target[2]) ** 2
        + c.elevation_rate * (z[3] - target[3]) ** 2
        + c.pitch * (z[4] - target[4]) ** 2
        + c.pitch_rate * (z[5] - target[5]) ** 2
        + c.pitch_barrier * over**2
        + c.effort * ((u_f - target[8]) ** 2 + (u_b - target[9]) ** 2)
        + c.outside * (out_f**2 + out_b**2)
    )


def terminal_weights(c: MpcSettings) -> tuple:
    """Weights of the six states at the last node."""
    return (
        c.terminal * c.travel,
        c.terminal_rate,
        c.terminal * c.elevation,
        c.terminal_rate,
        c.terminal_pitch,
        c.terminal_pitch_rate,
    )


def terminal_cost(z: Any, target: Any, c: MpcSettings) -> float:
    """Cost of the last node at states z (N_FLIGHT,), given the target (N_COST,)."""
    w = terminal_weights(c)
    total = 0.0
    for i in range(6):
        total += 0.5 * w[i] * (z[i] - target[i]) ** 2
    return total


def step_model(z: Any, u: Any, out: Any, h: float, model: Model) -> None:
    """Write the states h seconds after z (N_FLIGHT,) at the voltages u (2,) into out."""
    after = advance((z[0], z[1], z[2], z[3], z[4], z[5]), (z[6], z[7]), (u[0], u[1]), h, model)
    for i in range(N_FLIGHT):
        out[i] = after[i]


def differentiate(z: Any, u: Any, A: Any, B: Any, shifted: Any, after: Any, h: float, model: Model) -> None:
    """Write the Jacobians of `step_model` at z, u into A (N_FLIGHT, N_FLIGHT), B (N_FLIGHT, 2); the rest is scratch."""
    step_model(z, u, after, h, model)
    for j in range(N_FLIGHT):
        value = z[j]
        z[j] = value + STEP
        step_model(z, u, shifted, h, model)
        z[j] = value
        for i in range(N_FLIGHT):
            A[i, j] = (shifted[i] - after[i]) / STEP
    for j in range(N_INPUTS):
        value = u[j]
        u[j] = value + STEP
        step_model(z, u, shifted, h, model)
        u[j] = value
        for i in range(N_FLIGHT):
            B[i, j] = (shifted[i] - after[i]) / STEP


def box_minimum(H: tuple, g: tuple, low: tuple, high: tuple) -> tuple:
    """Minimiser d1, d2 of g d + d H d / 2 with low <= d <= high, and for each whether it is free (off its bounds).

    H is (h11, h12, h22), positive definite. If the unconstrained minimiser is infeasible, the solution is the best of
    the minimisers on the four edges.
    """
    h11, h12, h22 = H
    determinant = h11 * h22 - h12 * h12
    d1 = (-h22 * g[0] + h12 * g[1]) / determinant
    d2 = (h12 * g[0] - h11 * g[1]) / determinant
    if low[0] <= d1 <= high[0] and low[1] <= d2 <= high[1]:
        return d1, d2, True, True
    best, best_1, best_2, free_1, free_2 = np.inf, low[0], low[1], False, False
    for side in range(4):
        if side < 2:
            e1 = low[0] if side == 0 else high[0]
            e2 = -(g[1] + h12 * e1) / h22
            inside = low[1] <= e2 <= high[1]
            e2 = min(max(e2, low[1]), high[1])
            free = False, inside
        else:
            e2 = low[1] if side == 2 else high[1]
            e1 = -(g[0] + h12 * e2) / h11
            inside = low[0] <= e1 <= high[0]
            e1 = min(max(e1, low[0]), high[0])
            free = inside, False
        value = g[0] * e1 + g[1] * e2 + 0.5 * (h11 * e1 * e1 + 2.0 * h12 * e1 * e2 + h22 * e2 * e2)
        if value < best:
            best, best_1, best_2, free_1, free_2 = value, e1, e2, free[0], free[1]
    return best_1, best_2, free_1, free_2


def backward_pass(
    Z: Any,
    U: Any,
    targets: Any,
    A: Any,
    B: Any,
    K: Any,
    k_ff: Any,
    V: Any,
    VA: Any,
    VB: Any,
    Qzz: Any,
    v: Any,
    Qz: Any,
    c: MpcSettings,
    b: Bounds,
    h: float,
    model: Model,
) -> None:
    """Write feedforward k_ff (nodes, 2) and gains K (nodes, 2, N_FLIGHT) of an iteration along Z, U.

    Z is (nodes + 1, N_FLIGHT), U (nodes, 2) in V; A, B, V, VA, VB, Qzz, v and Qz are scratch.
    """
    n = c.nodes
    w = terminal_weights(c)
    for i in range(N_FLIGHT):
        v[i] = 0.0
        for j in range(N_FLIGHT):
            V[i, j] = 0.0
    for i in range(6):
        v[i] = w[i] * (Z[n, i] - targets[n, i])
        V[i, i] = w[i]
    for k in range(n - 1, -1, -1):
        z, u, target = Z[k], U[k], targets[k]
        differentiate(z, u, A, B, VA[0], VA[1], h, model)
        for i in range(N_FLIGHT):
            for j in range(N_FLIGHT):
                total = 0.0
                for m in range(N_FLIGHT):
                    total += V[i, m] * A[m, j]
                VA[i, j] = total
            for j in range(N_INPUTS):
                total = 0.0
                for m in range(N_FLIGHT):
                    total += V[i, m] * B[m, j]
                VB[i, j] = total
        for i in range(N_FLIGHT):
            total = 0.0
            for m in range(N_FLIGHT):
                total += A[m, i] * v[m]
            Qz[i] = total
            for j in range(i + 1):
                total = 0.0
                for m in range(N_FLIGHT):
                    total += A[m, i] * VA[m, j]
                Qzz[i, j] = total
                Qzz[j, i] = total
        weights = (c.travel, c.travel_rate, c.elevation, c.elevation_rate, c.pitch, c.pitch_rate)
        for i in range(6):
            Qz[i] += weights[i] * (z[i] - target[i])
            Qzz[i, i] += weights[i]
        over = excess(z[4], b.pitch_min + c.pitch_margin, b.pitch_max - c.pitch_margin)
        if over != 0.0:
            Qz[4] += c.pitch_barrier * over
            Qzz[4, 4] += c.pitch_barrier
        out_f, out_b = excess(u[0], b.u_min, b.u_max), excess(u[1], b.u_min, b.u_max)
        g1 = c.effort * (u[0] - target[8]) + c.outside * out_f
        g2 = c.effort * (u[1] - target[9]) + c.outside * out_b
        h11 = c.effort + (c.outside if out_f != 0.0 else 0.0)
        h22 = c.effort + (c.outside if out_b != 0.0 else 0.0)
        h12 = 0.0
        for m in range(N_FLIGHT):
            g1 += B[m, 0] * v[m]
            g2 += B[m, 1] * v[m]
            h11 += B[m, 0] * VB[m, 0]
            h12 += B[m, 0] * VB[m, 1]
            h22 += B[m, 1] * VB[m, 1]
        low = b.u_low - u[0], b.u_low - u[1]
        high = b.u_high - u[0], b.u_high - u[1]
        d1, d2, free_1, free_2 = box_minimum((h11, h12, h22), (g1, g2), low, high)
        k_ff[k, 0], k_ff[k, 1] = d1, d2
        determinant = h11 * h22 - h12 * h12
        for j in range(N_FLIGHT):
            q1, q2 = 0.0, 0.0
            for m in range(N_FLIGHT):
                q1 += B[m, 0] * VA[m, j]
                q2 += B[m, 1] * VA[m, j]
            if free_1 and free_2:
                K[k, 0, j] = (-h22 * q1 + h12 * q2) / determinant
                K[k, 1, j] = (h12 * q1 - h11 * q2) / determinant
            else:
                K[k, 0, j] = -q1 / h11 if free_1 else 0.0
                K[k, 1, j] = -q2 / h22 if free_2 else 0.0
            VB[j, 0], VB[j, 1] = q1, q2  # VB holds Quz from here on
        for i in range(N_FLIGHT):
            a1, a2 = K[k, 0, i], K[k, 1, i]
            b1, b2 = h11 * a1 + h12 * a2, h12 * a1 + h22 * a2
            v[i] = Qz[i] + b1 * d1 + b2 * d2 + a1 * g1 + a2 * g2 + VB[i, 0] * d1 + VB[i, 1] * d2
            for j in range(N_FLIGHT):
                V[i, j] = (
                    Qzz[i, j]
                    + b1 * K[k, 0, j]
                    + b2 * K[k, 1, j]
                    + a1 * VB[j, 0]
                    + a2 * VB[j, 1]
                    + VB[i, 0] * K[k, 0, j]
                    + VB[i, 1] * K[k, 1, j]
                )
        for i in range(N_FLIGHT):
            for j in range(i):
                mean = 0.5 * (V[i, j] + V[j, i])
                V[i, j] = mean
                V[j, i] = mean


def forward_pass(
    Z: Any,
    U: Any,
    K: Any,
    k_ff: Any,
    share: float,
    Z_new: Any,
    U_new: Any,
    targets: Any,
    c: MpcSettings,
    b: Bounds,
    h: float,
    model: Model,
) -> float:
    """Roll out U + share k_ff + K (z - Z), clipped to the box, from Z_new[0] into Z_new, U_new; return the cost."""
    total = 0.0
    for k in range(c.nodes):
        for i in range(N_INPUTS):
            u = U[k, i] + share * k_ff[k, i]
            for j in range(N_FLIGHT):
                u += K[k, i, j] * (Z_new[k, j] - Z[k, j])
            U_new[k, i] = min(max(u, b.u_low), b.u_high)
        total += stage_cost(Z_new[k], U_new[k], targets[k], c, b)
        step_model(Z_new[k], U_new[k], Z_new[k + 1], h, model)
    return total + terminal_cost(Z_new[c.nodes], targets[c.nodes], c)


def write_targets(
    targets: Any,
    x_ref: Any,
    v_ref: Any,
    first: int,
    stride: int,
    c: MpcSettings,
    b: Bounds,
    lift: float,
    p: Any,
    model: Model,
) -> None:
    """Write the targets (nodes + 1, N_COST) of the nodes, from the grid index `first` on.

    Travel, elevation and rates are the reference's; pitch and voltages fly the reference on the estimated model.
    """
    last = x_ref.shape[1] - 1
    for k in range(c.nodes + 1):
        at = min(first + k * stride, last)
        x = (x_ref[0, at], x_ref[1, at], x_ref[2, at], x_ref[3, at], x_ref[4, at], x_ref[5, at])
        v = v_ref[0, at], v_ref[1, at]
        tilt, v1, v2 = accommodate(x, v, unexplained(x, v, model, p), (b.pitch_min, b.pitch_max), lift, p)
        f = fan_thrusts((v1, v2))
        for i in range(6):
            targets[k, i] = x[i]
        targets[k, PITCH] = tilt
        for i in range(N_INPUTS):
            targets[k, N_FLIGHT + i] = fan_voltage(model.fans, i, f[i] / model.gain)
            targets[k, ROTORS + i] = targets[k, N_FLIGHT + i]


def mpc_step(
    s: Any,
    x_ref: Any,
    v_ref: Any,
    first: Any,
    stride: int,
    u_plan: Any,
    z_plan: Any,
    gains: Any,
    iterations: int,
    shift: float,
    p: Any,
    fans: Any,
    lift: float,
    c: MpcSettings,
    b: Bounds,
) -> None:
    """Iterate the plans of N helicopters in place, from the filter's states s (N_STATES, N) at grid indices first (N,).

    u_plan (nodes, 2, N) in V, z_plan (nodes + 1, N_FLIGHT, N) and gains (nodes, 2, N_FLIGHT, N) hold the plan of the
    last period; `shift` is the time since then as a share of a node.
    """
    n = c.nodes
    Z, Z_new, Z_best = np.empty((n + 1, N_FLIGHT)), np.empty((n + 1, N_FLIGHT)), np.empty((n + 1, N_FLIGHT))
    U, U_new, U_best = np.empty((n, N_INPUTS)), np.empty((n, N_INPUTS)), np.empty((n, N_INPUTS))
    K, k_ff, targets = np.empty((n, N_INPUTS, N_FLIGHT)), np.zeros((n, N_INPUTS)), np.empty((n + 1, N_COST))
    A, V, VA, Qzz = (
        np.empty((N_FLIGHT, N_FLIGHT)),
        np.empty((N_FLIGHT, N_FLIGHT)),
        np.empty((N_FLIGHT, N_FLIGHT)),
        np.empty((N_FLIGHT, N_FLIGHT)),
    )
    B, VB, v, Qz = (
        np.empty((N_FLIGHT, N_INPUTS)),
        np.empty((N_FLIGHT, N_INPUTS)),
        np.empty(N_FLIGHT),
        np.empty(N_FLIGHT),
    )
    for one in range(s.shape[1]):
        model = with_estimates(s[:, one], p, fans)
        write_targets(targets, x_ref, v_ref, first[one], stride, c, b, lift, p, model)
        for k in range(n):
            later = min(k + 1, n - 1)
            for i in range(N_INPUTS):
                U[k, i] = (1.0 - shift) * u_plan[k, i, one] + shift * u_plan[later, i, one]
                k_ff[k, i] = 0.0
                for j in range(N_FLIGHT):
                    K[k, i, j] = (1.0 - shift) * gains[k, i, j, one] + shift * gains[later, i, j, one]
            for j in range(N_FLIGHT):
                Z[k, j] = (1.0 - shift) * z_plan[k, j, one] + shift * z_plan[k + 1, j, one]
        for j in range(N_FLIGHT):
            Z[n, j] = z_plan[n, j, one]
            Z_new[0, j] = s[j, one]
            Z_best[0, j] = s[j, one]
        best = forward_pass(Z, U, K, k_ff, 0.0, Z_best, U_best, targets, c, b, c.step, model)
        for _ in range(iterations):
            backward_pass(Z_best, U_best, targets, A, B, K, k_ff, V, VA, VB, Qzz, v, Qz, c, b, c.step, model)
            share = 1.0
            for _ in range(4):
                cost = forward_pass(Z_best, U_best, K, k_ff, share, Z_new, U_new, targets, c, b, c.step, model)
                if cost < best:
                    best = cost
                    for k in range(n):
                        for i in range(N_INPUTS):
                            U_best[k, i] = U_new[k, i]
                        for j in range(N_FLIGHT):
                            Z_best[k, j] = Z_new[k, j]
                    for j in range(N_FLIGHT):
                        Z_best[n, j] = Z_new[n, j]
                    break
                share *= 0.4
        for k in range(n):
            for i in range(N_INPUTS):
                u_plan[k, i, one] = U_best[k, i]
                for j in range(N_FLIGHT):
                    gains[k, i, j, one] = K[k, i, j]
            for j in range(N_FLIGHT):
                z_plan[k, j, one] = Z_best[k, j]
        for j in range(N_FLIGHT):
            z_plan[n, j, one] = Z_best[n, j]


@cache
def compiled_mpc_step() -> Any:
    """Compile `mpc_step` at its first use."""
    loops = (step_model, differentiate, backward_pass, forward_pass, write_targets)
    return Compiler(loops=loops).entry(mpc_step)
