"""Extended Kalman filter for unmeasured states and uncertain parameters of (3), from the three encoder angles.

The filter's state holds (44), the rotor speeds and slowly varying parameters: rotor lag, thrust gain, viscous friction
of the three axes, two centrifugal coefficients and three disturbance accelerations (Gelb, Applied Optimal Estimation,
Section 6.1; Ljung, "Asymptotic behavior of the extended Kalman filter as a parameter estimator for linear systems",
IEEE TAC 24(1), 1979). The priors are the documented ranges of the plant `lab`, never a draw; for a rig with a lag
outside its range, a range in proportion to the rig's lag, as the plant has on it. The transition is one
Runge-Kutta step of `model.dynamics`, differentiated by finite differences, so that the filter follows the model.
"""

import math
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy import cos, sin

from heli_gym.baselines.control.estimation import START_DEVIATIONS, encoder_noise, rotor_response
from heli_gym.compilation import Compiler
from heli_gym.model import dynamics, rk4_step, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import FOOT_SPREAD, LAB_FRICTION, LAB_ROTORS, Uniform
from heli_gym.rig import PAPER, Rig

# Indices in the filter's state (N_STATES,): (44); rotor speeds as voltages in V; lag in s; thrust gain;
# friction in 1/s, on top of the parameters' own; coefficients of two centrifugal terms; accelerations in rad/s².
ROTORS, LAG, GAIN, FRICTION, CENTRIFUGAL, DISTURBANCE, N_STATES = 6, 8, 9, 10, 13, 15, 18
N_FLIGHT = 8  # states before the parameters: (44) and the rotor speeds
# Estimates of the parameters, from LAG on, are clipped to what is physically possible.
LOWEST = (0.02, 0.5, 0.0, 0.0, 0.0, -1.5, -1.5, -3.0, -3.0, -3.0)
HIGHEST = (0.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 3.0, 3.0, 3.0)
OUTLIER = 6.0  # standard deviations; a larger innovation is an outlier: a knock, or a slip of the encoder
# Prior ranges of the coefficients in `unmodelled`: LIFT for laboratory rigs, TURN for any rigid body.
LIFT, TURN = Uniform(-0.17, 0.17), Uniform(-1.0, 0.0)
ROTOR_DEVIATION = 0.3  # V, prior standard deviation of the rotor speeds
N_SAMPLES = 129  # samples of the thrust map
STEP = 1e-6  # finite-difference step, in units of the states


class Fans(NamedTuple):
    """Sampled thrust map of a rig (front, back) for the compiler; cubic interpolation is exact for (2)."""

    samples: Any  # (2, 2, n) thrusts in N and their slopes in N/V
    low: float  # V, voltage of the first sample
    step: float  # V, voltage between samples
    inverse: Any  # (2, n) voltages in V at equidistant thrusts, interpolated linearly
    least: Any  # (2,) N, least thrust
    rise: Any  # (2,) N, thrust between the entries of `inverse`


class Model(NamedTuple):
    """Equation (3) with the estimates of the filter."""

    parameters: Any  # HelicopterParameters, with the estimated friction in it
    fans: Any  # Fans
    gain: Any  # of the thrust, 1 for the rig's own map
    lag: Any  # s
    centrifugal: Any  # 1, coefficients of `unmodelled`
    disturbance: Any  # three accelerations in rad/s²


class FilterNoise(NamedTuple):
    """Process-noise intensities of the filter, prior deviations, and whether parameters are estimated."""

    acceleration: float = 0.004  # rad/s per sqrt(s), white, on every axis
    travel_disturbance: float = 0.008  # rad/s² per sqrt(s), random walks
    elevation_disturbance: float = 0.008
    pitch_disturbance: float = 0.03
    parameters: float = 0.02  # random walk of the parameters, in prior standard deviations per sqrt(s)
    start_disturbance: float = 0.01  # rad/s², standard deviation before a flight
    adaptive: bool = True  # False holds the parameters at the means of their priors


# For controllers that do not adapt, disturbances also absorb the parameter errors.
UNADAPTED = FilterNoise(
    acceleration=0.01,
    travel_disturbance=0.1,
    elevation_disturbance=0.05,
    pitch_disturbance=0.3,
    start_disturbance=0.03,
    adaptive=False,
)


def sample_thrust_map(rig: Rig, voltage_limits: tuple[float, float]) -> Fans:
    """Sample the thrust map of a rig between voltages (min, max) in V."""
    u, step = np.linspace(*voltage_limits, N_SAMPLES, retstep=True)
    f = rig.thrust(np.stack((u, u)))
    rises = np.diff(f, axis=1)
    # Limited slopes stay finite at corners of a curve and make the cubics monotone.
    steepest = 3.0 * np.minimum(np.pad(rises, ((0, 0), (1, 0)), "edge"), np.pad(rises, ((0, 0), (0, 1)), "edge")) / step
    slope = np.minimum(rig.thrust_slope(np.stack((u, u))), steepest)
    thrusts = np.linspace(f[:, 0], f[:, -1], N_SAMPLES, axis=1)
    inverse = np.stack([np.interp(wanted, given, u) for wanted, given in zip(thrusts, f)])
    rise = (f[:, -1] - f[:, 0]) / (N_SAMPLES - 1)
    return Fans(np.stack((f, slope), axis=1), float(u[0]), float(step), inverse, f[:, 0].copy(), rise)


def fan_thrust(fans: Any, fan: int, u: float) -> float:
    """Thrust in N of fan 0 or 1 at the voltage u in V."""
    at = (u - fans.low) / fans.step
    k = min(max(int(at), 0), N_SAMPLES - 2)
    r = at - k
    f0, f1 = fans.samples[fan, 0, k], fans.samples[fan, 0, k + 1]
    d0, d1 = fans.step * fans.samples[fan, 1, k], fans.step * fans.samples[fan, 1, k + 1]
    rise = f1 - f0
    return f0 + r * (d0 + r * (3.0 * rise - 2.0 * d0 - d1 + r * (d0 + d1 - 2.0 * rise)))


def fan_voltage(fans: Any, fan: int, f: float) -> float:
    """Voltage in V for the thrust f in N of fan 0 or 1, clipped to the sampled range."""
    at = min(max((f - fans.least[fan]) / fans.rise[fan], 0.0), N_SAMPLES - 1.0)
    k = min(int(at), N_SAMPLES - 2)
    return fans.inverse[fan, k] + (at - k) * (fans.inverse[fan, k + 1] - fans.inverse[fan, k])


def with_estimates(s: Any, p: Any, fans: Any) -> Model:
    """Model with the estimates in the filter's state s (N_STATES,), from nominal parameters p."""
    adapted = HelicopterParameters(
        p.k_plus,
        p.k_minus,
        p.a1,
        p.a2,
        p.a3,
        p.b1,
        p.b2,
        p.b3,
        p.c1 + s[FRICTION],
        p.c2 + s[FRICTION + 1],
        p.c3 + s[FRICTION + 2],
    )
    centrifugal = s[CENTRIFUGAL], s[CENTRIFUGAL + 1]
    return Model(adapted, fans, s[GAIN], s[LAG], centrifugal, (s[DISTURBANCE], s[DISTURBANCE + 1], s[DISTURBANCE + 2]))


def unexplained(x: Any, v: Any, model: Any, p: Any) -> tuple:
    """Accelerations (3,) in rad/s² of the model minus those of (3) with nominal parameters p, at x and v."""
    q = model.parameters
    on_travel, on_elevation, on_pitch = unmodelled(x, dynamics(x, v, p, sin, cos)[1], model)
    return (
        on_travel - (q.c1 - p.c1) * x[1],
        on_elevation - (q.c2 - p.c2) * x[3],
        on_pitch - (q.c3 - p.c3) * x[5],
    )


def unmodelled(x: Any, ddq1: Any, model: Any) -> tuple:
    """Accelerations (3,) in rad/s² added to (3): disturbances and centrifugal terms, at a travel acceleration ddq1.

    While the arm turns, a body off the arm's line is lifted or lowered (first coefficient). An inclined arm and a
    pitched long body are turned level (second coefficient: minus the share of their inertia that is distributed along
    their lengths, -1 for thin rods and 0 in (3)). The reactions of the body on travel and elevation follow, for a level
    arm, from the ratios of the axes' inertias. Source: `rigid_body.mass_matrix` and `coriolis`.
    """
    on_travel, on_elevation, on_pitch = model.disturbance
    lift, turn = model.centrifugal
    p = model.parameters
    arm = FOOT_SPREAD / p.b3  # (inertia of pitch) / (inertia of travel or elevation) = arm |b1| or arm |b2|
    rate, pitch_rate, s, c = x[1], x[5], sin(x[4]), cos(x[4])
    on_travel = on_travel + 2.0 * turn * arm * p.b1 * s * c * rate * pitch_rate
    on_elevation = on_elevation + (lift + turn * sin(x[2]) * cos(x[2])) * rate * rate
    on_elevation = on_elevation - turn * arm * p.b2 * s * (2.0 * s * rate * pitch_rate - c * ddq1)
    return on_travel, on_elevation, on_pitch + turn * s * c * rate * rate


def model_derivative(x: Any, v: Any, model: Any) -> tuple:
    """State derivative (6,) by (3) and `unmodelled`."""
    dq1, ddq1, dq2, ddq2, dq3, ddq3 = dynamics(x, v, model.parameters, sin, cos)
    on_travel, on_elevation, on_pitch = unmodelled(x, ddq1, model)
    return dq1, ddq1 + on_travel, dq2, ddq2 + on_elevation, dq3, ddq3 + on_pitch


def advance(x: tuple, w: tuple, u: tuple, dt: float, model: Any) -> tuple:
    """State (6,) and rotor speeds (2,) after dt seconds at the voltages u (2,): `estimation.predict`, compiled."""
    fans, gain, lag = model.fans, model.gain, model.lag
    middle = rotor_response(w[0], u[0], lag, 0.5 * dt), rotor_response(w[1], u[1], lag, 0.5 * dt)
    end = rotor_response(w[0], u[0], lag, dt), rotor_response(w[1], u[1], lag, dt)
    inputs = (
        virtual_input((gain * fan_thrust(fans, 0, w[0]), gain * fan_thrust(fans, 1, w[1]))),
        virtual_input((gain * fan_thrust(fans, 0, middle[0]), gain * fan_thrust(fans, 1, middle[1]))),
        virtual_input((gain * fan_thrust(fans, 0, end[0]), gain * fan_thrust(fans, 1, end[1]))),
    )
    return (*rk4_step(model_derivative, x, inputs, dt, model), *end)


def advance_filter_state(s: Any, u: tuple, dt: float, p: Any, fans: Any) -> tuple:
    """Entries 0 to N_FLIGHT - 1 of the filter's state s (N_STATES,) after dt seconds at the voltages u (2,)."""
    return advance((s[0], s[1], s[2], s[3], s[4], s[5]), (s[6], s[7]), u, dt, with_estimates(s, p, fans))


def predict_one(s: Any, P: Any, F: Any, FP: Any, u: tuple, dt: float, p: Any, fans: Any, Q: Any) -> None:
    """Propagate estimate s (N_STATES,) and covariance P (N_STATES, N_STATES) in place; F and FP are scratch."""
    after = advance_filter_state(s, u, dt, p, fans)
    for j in range(N_STATES):
        value = s[j]
        s[j] = value + STEP
        shifted = advance_filter_state(s, u, dt, p, fans)
        s[j] = value
        for i in range(N_FLIGHT):
            F[i, j] = (shifted[i] - after[i]) / STEP
    for i in range(N_FLIGHT):
        s[i] = after[i]
        for j in range(N_STATES):
            total = 0.0
            for m in range(N_STATES):
                total += F[i, m] * P[m, j]
            FP[i, j] = total
    for i in range(N_FLIGHT):
        for j in range(i + 1):
            total = Q[i, j]
            for m in range(N_STATES):
                total += FP[i, m] * F[j, m]
            P[i, j] = total
            P[j, i] = total
        for j in range(N_FLIGHT, N_STATES):
            P[i, j] = FP[i, j]
            P[j, i] = FP[i, j]
    for i in range(N_FLIGHT, N_STATES):
        P[i, i] += Q[i, i]


def update_one(
    s: Any, P: Any, column: Any, angles: tuple, variance: float, dt: float, fans: Any, lag_scale: float
) -> None:
    """Update s and P in place with the three measured angles, one after the other.

    An outlier inflates the variances of its axis first: angle and rate follow it, the parameters do not.
    """
    for axis in range(3):
        row = 2 * axis
        innovation = angles[axis] - s[row]
        if innovation * innovation > OUTLIER * OUTLIER * (P[row, row] + variance):
            P[row, row] += innovation * innovation
            P[row + 1, row + 1] += (innovation / dt) ** 2
        for i in range(N_STATES):
            column[i] = P[i, row]
        S = column[row] + variance
        for i in range(N_STATES):
            s[i] += column[i] / S * innovation
            for j in range(N_STATES):
                P[i, j] -= column[i] * column[j] / S
    for i in range(2):
        s[ROTORS + i] = min(max(s[ROTORS + i], fans.low), fans.low + fans.step * (N_SAMPLES - 1))
    s[LAG] = min(max(s[LAG], lag_scale * LOWEST[0]), lag_scale * HIGHEST[0])
    for i in range(1, N_STATES - LAG):
        s[LAG + i] = min(max(s[LAG + i], LOWEST[i]), HIGHEST[i])


def filter_step(
    s: Any,
    P: Any,
    angles: Any,
    u: Any,
    dt: float,
    p: Any,
    fans: Any,
    Q: Any,
    variance: float,
    lag_scale: float,
    updates: bool,
    predicts: bool,
) -> None:
    """Update s (N_STATES, N) and P (N_STATES, N_STATES, N) in place: measurement update, then prediction.

    angles (3, N) in rad are used if `updates`, the voltages u (2, N) in V of one control period if `predicts`.
    """
    one, covariance = np.empty(N_STATES), np.empty((N_STATES, N_STATES))
    F, FP, column = np.zeros((N_FLIGHT, N_STATES)), np.empty((N_FLIGHT, N_STATES)), np.empty(N_STATES)
    for n in range(s.shape[1]):
        for i in range(N_STATES):
            one[i] = s[i, n]
            for j in range(N_STATES):
                covariance[i, j] = P[i, j, n]
        if updates:
            update_one(
                one, covariance, column, (angles[0, n], angles[1, n], angles[2, n]), variance, dt, fans, lag_scale
            )
        if predicts:
            predict_one(one, covariance, F, FP, (u[0, n], u[1, n]), dt, p, fans, Q)
        for i in range(N_STATES):
            s[i, n] = one[i]
            for j in range(N_STATES):
                P[i, j, n] = covariance[i, j]


@cache
def compiled_filter_step() -> Any:
    """Compile `filter_step` at its first use."""
    return Compiler(loops=(predict_one, update_one, advance_filter_state)).entry(filter_step)


class Estimate(NamedTuple):
    """Mean and covariance of the filter's state."""

    s: np.ndarray  # (N_STATES, N)
    P: np.ndarray  # (N_STATES, N_STATES, N)


@dataclass(frozen=True, eq=False)
class AdaptiveFilter:
    """Extended Kalman filter with its tuning; all methods return new estimates."""

    rig: Rig
    control_period: float
    noise: FilterNoise
    voltage_limits: tuple[float, float] | None = None  # V; the rig's by default

    @cached_property
    def fans(self) -> Fans:
        """Thrust map of the rig, sampled between the voltage limits."""
        return sample_thrust_map(self.rig, self.voltage_limits or self.rig.voltage_limits)

    @cached_property
    def lag_scale(self) -> float:
        """Ratio of the range of the lag to that of `lab`; 1 for a rig with a lag in that range."""
        return 1.0 if LAB_ROTORS.lag.low <= self.rig.lag <= LAB_ROTORS.lag.high else self.rig.lag / PAPER.lag

    def init(self, x: np.ndarray, u: np.ndarray) -> Estimate:
        """Prior estimate at states x (6, N) with the rotors at the voltages u (2, N) in V."""
        mean, deviation = prior_moments(self.noise, self.lag_scale)
        on_angles, on_rates, _ = START_DEVIATIONS
        deviations = (
            [on_angles, on_rates] * 3 + [ROTOR_DEVIATION] * 2 + [*deviation] + [self.noise.start_disturbance] * 3
        )
        count = x.shape[1]
        s = np.concatenate((x, u, np.repeat(mean[:, None], count, axis=1), np.zeros((3, count))))
        return Estimate(s, np.repeat(np.diag(np.square(deviations))[:, :, None], count, axis=2))

    def step(self, estimate: Estimate, angles: np.ndarray | None, u: np.ndarray | None) -> Estimate:
        """Estimate after an update with angles (3, N) in rad and a period at u (2, N) in V; None skips either."""
        s, P = estimate.s.copy(), estimate.P.copy()
        nothing = np.empty((3, 0))
        compiled_filter_step()(
            s,
            P,
            nothing if angles is None else np.ascontiguousarray(angles),
            nothing if u is None else np.ascontiguousarray(u),
            self.control_period,
            self.rig.parameters,
            self.fans,
            process_noise(self.noise, self.control_period, self.lag_scale),
            encoder_noise(self.rig) ** 2,
            self.lag_scale,
            angles is not None,
            u is not None,
        )
        return Estimate(s, P)


def prior_moments(noise: FilterNoise, lag_scale: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    """Prior means and standard deviations (7,) of the parameters, from their documented uniform ranges."""
    lag = Uniform(lag_scale * LAB_ROTORS.lag.low, lag_scale * LAB_ROTORS.lag.high)
    loss: Uniform = LAB_ROTORS.thrust_loss
    ranges = [lag, Uniform(1.0 - loss.high, 1.0 - loss.low), *LAB_FRICTION.viscous, LIFT, TURN]
    mean = np.array([0.5 * (one.low + one.high) for one in ranges])
    deviation = np.array([(one.high - one.low) / math.sqrt(12.0) for one in ranges])
    return mean, deviation if noise.adaptive else np.zeros(len(mean))


@cache
def process_noise(noise: FilterNoise, dt: float, lag_scale: float) -> np.ndarray:
    """Process-noise covariance (N_STATES, N_STATES) for a step of dt seconds."""
    Q = np.zeros((N_STATES, N_STATES))
    for axis in range(3):
        angle, rate = 2 * axis, 2 * axis + 1
        intensity = noise.acceleration**2
        Q[angle, angle], Q[rate, rate] = intensity * dt**3 / 3.0, intensity * dt
        Q[angle, rate] = Q[rate, angle] = intensity * dt**2 / 2.0
        Q[DISTURBANCE + axis, DISTURBANCE + axis] = noise[1 + axis] ** 2 * dt
    indices = range(LAG, DISTURBANCE)
    Q[indices, indices] = (noise.parameters * prior_moments(noise, lag_scale)[1]) ** 2 * dt
    return Q
