"""Tasks of a university course on optimal control: a travel move by QP, with LQR feedback, and over an elevation bump.

An inner loop (PD on pitch, PID on elevation) receives a command every 0.25 s. A quadratic program (OSQP) plans the
commands on the linearised closed loop; with the bump it is a nonlinear program (IPOPT). A discrete LQR corrects the
commands by the measured state.
"""

import math
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse
from scipy.interpolate import make_interp_spline
from scipy.linalg import expm, solve_discrete_are

from heli_gym.baselines.control.protocol import step_index
from heli_gym.baselines.planning.collocation import import_casadi
from heli_gym.flatness import RISE, slowed
from heli_gym.model import fan_thrusts, hover_input
from heli_gym.rig import Rig
from heli_gym.trajectory import Trajectory

STEP = 0.25  # s, between commands
PITCH_COMMAND = math.radians(30.0)  # rad, limit of the pitch command
PITCH_PRICE, ELEVATION_PRICE = 1.0, 1.0  # per rad² of the command; the travel error costs 1 per rad²
BUMP_HEIGHT, BUMP_SHARPNESS = 0.2, 20.0  # rad and 1/rad²: elevation >= HEIGHT exp(-SHARPNESS (travel - middle)²)
BUMP_PLACE = 1.0 / 3.0  # position of the bump, as a share of the travel
STATE_PRICE = np.array([5.0, 1.0, 0.5, 0.2, 10.0, 1.0])  # LQR weights: travel, rate, pitch, rate, elevation, rate
COMMAND_PRICE = np.array([1.0, 1.0])  # LQR weights: pitch and elevation command


class InnerLoop(NamedTuple):
    """Bandwidths and damping ratios of the inner loops, as in the course, and the integral gain of elevation."""

    pitch: float = 1.8  # rad/s
    pitch_damping: float = 1.0
    elevation: float = 0.8  # rad/s
    elevation_damping: float = 1.0
    elevation_integral: float = 0.1  # 1/s³


COURSE_LOOP = InnerLoop()


class Model(NamedTuple):
    """Linear model x+ = A x + B c over STEP: x (travel, rate, pitch, rate, elevation, rate), c (pitch, elevation)."""

    A: np.ndarray  # (6, 6)
    B: np.ndarray  # (6, 2)


@dataclass(frozen=True, eq=False)
class Schedule:
    """Commands (2, N) of pitch and elevation in rad, STEP apart, and predicted states (6, N + 1)."""

    commands: np.ndarray
    x: np.ndarray


def linear_model(rig: Rig, loop: InnerLoop = InnerLoop()) -> Model:
    """Exactly sampled model of the rig about level hover under the inner loop, without its integral part."""
    p = rig.parameters
    lift = float(hover_input(0.0, p)[0])
    A, B = np.zeros((6, 6)), np.zeros((6, 2))
    A[(0, 2, 4), (1, 3, 5)] = 1.0
    A[1, 1], A[1, 2] = -p.c1, p.b1 * lift
    A[3, 2], A[3, 3] = -(loop.pitch**2), -2.0 * loop.pitch_damping * loop.pitch
    A[5, 4], A[5, 5] = -(loop.elevation**2), -2.0 * loop.elevation_damping * loop.elevation
    B[3, 0], B[5, 1] = loop.pitch**2, loop.elevation**2
    block = np.zeros((8, 8))
    block[:6, :6], block[:6, 6:] = A, B
    sampled = expm(STEP * block)
    return Model(sampled[:6, :6], sampled[:6, 6:])


def travel_by_qp(
    rig: Rig,
    travel: float = math.pi,
    duration: float = 12.0,
    pitch_limit: float = PITCH_COMMAND,
    price: float = PITCH_PRICE,
    loop: InnerLoop = InnerLoop(),
) -> Schedule:
    """Plan a travel move by an angle in rad: least squares of travel error and pitch command, solved by OSQP.

    The quadratic program has all states and commands as variables; pitch and its command stay within the limit.
    Raises ImportError without OSQP, ValueError for a duration under two steps, RuntimeError if OSQP gives up.
    """
    steps = steps_of(duration)
    try:
        import osqp
    except ImportError as error:
        raise ImportError("the quadratic program needs OSQP: pip install 'heli-gym[ocp]'") from error
    model = linear_model(rig, loop)
    A, B = model.A[:4, :4], model.B[:4, :1]
    n, start, goal = 4 * steps, np.zeros(4), np.array([travel, 0.0, 0.0, 0.0])
    # Variables of the program: x1..xN, c0..cN-1.
    error_price = sparse.kron(sparse.eye(steps), sparse.diags([1.0, 0.0, 0.0, 0.0]))
    P = 2.0 * sparse.block_diag((error_price, price * sparse.eye(steps)), format="csc")
    q = np.concatenate((np.tile(-2.0 * np.array([travel, 0.0, 0.0, 0.0]), steps), np.zeros(steps)))
    dynamics = sparse.hstack(
        (
            sparse.eye(n) - sparse.kron(sparse.diags([1.0], [-1], shape=(steps, steps)), A),
            -sparse.kron(sparse.eye(steps), B),
        )
    )
    drift = np.concatenate((A @ start, np.zeros(n - 4)))
    pitches = sparse.hstack((sparse.kron(sparse.eye(steps), [[0.0, 0.0, 1.0, 0.0]]), sparse.csc_matrix((steps, steps))))
    commanded = sparse.hstack((sparse.csc_matrix((steps, n)), sparse.eye(steps)))
    end = sparse.hstack((sparse.csc_matrix((4, n - 4)), sparse.eye(4), sparse.csc_matrix((4, steps))))
    bound = np.full(steps, pitch_limit)
    solver = osqp.OSQP()
    solver.setup(
        P,
        q,
        sparse.vstack((dynamics, pitches, commanded, end), format="csc"),
        np.concatenate((drift, -bound, -bound, goal)),
        np.concatenate((drift, bound, bound, goal)),
        verbose=False,
        eps_abs=1e-8,
        eps_rel=1e-8,
        max_iter=100_000,
    )
    result = solver.solve(raise_error=False)
    if result.info.status != "solved":
        raise RuntimeError(f"OSQP: {result.info.status}; a longer duration is easier")
    x = np.zeros((6, steps + 1))
    x[:4, 1:] = result.x[:n].reshape(steps, 4).T
    commands = np.zeros((2, steps))
    commands[0] = np.clip(result.x[n:], -pitch_limit, pitch_limit)
    return Schedule(commands, x)


def travel_over_bump(
    rig: Rig,
    travel: float = math.pi,
    duration: float = 15.0,
    pitch_limit: float = PITCH_COMMAND,
    loop: InnerLoop = InnerLoop(),
) -> Schedule:
    """Plan the move of `travel_by_qp` over an elevation bump: a nonlinear program, solved by IPOPT.

    Raises ImportError without CasADi, ValueError for a duration under two steps, RuntimeError if IPOPT gives up.
    """
    steps, ca = steps_of(duration), import_casadi()
    model, up = linear_model(rig, loop), elevation_sign(rig)
    problem = ca.Opti()
    X, C = problem.variable(6, steps + 1), problem.variable(2, steps)
    problem.subject_to(X[:, 1:] == model.A @ X[:, :-1] + model.B @ C)
    problem.subject_to(X[:, 0] == 0.0)
    problem.subject_to(X[:, steps] == np.array([travel, 0.0, 0.0, 0.0, 0.0, 0.0]))
    problem.subject_to(problem.bounded(-pitch_limit, X[2, :].T, pitch_limit))
    problem.subject_to(problem.bounded(-pitch_limit, C[0, :].T, pitch_limit))
    problem.subject_to(up * X[4, :] >= bump(X[0, :], travel, ca.exp))
    effort = PITCH_PRICE * ca.sumsqr(C[0, :]) + ELEVATION_PRICE * ca.sumsqr(C[1, :])
    problem.minimize(ca.sumsqr(X[0, :] - travel) + effort)
    problem.set_initial(X[0, :], np.linspace(0.0, travel, steps + 1))
    problem.set_initial(X[4, :], up * bump(np.linspace(0.0, travel, steps + 1), travel))
    problem.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_iter": 1000})
    solution = problem.solve()
    return Schedule(np.array(solution.value(C)), np.array(solution.value(X)))


def flat_over_bump(rig: Rig, travel: float = math.pi, duration: float = 15.0) -> Trajectory:
    """Trajectory of the move over the bump for `feedforward+tvlqr`: smooth flat outputs, 2 % above the bump.

    The flight lasts longer than the duration in s if the rig's limits require it. Raises ValueError if the rig cannot
    fly it at any speed tried.
    """

    def motion(t: np.ndarray, duration: float) -> tuple[np.ndarray, np.ndarray]:
        share = t / duration
        rise = travel * np.stack([RISE(share), *(RISE.deriv(n)(share) / duration**n for n in (1, 2))])
        height = make_interp_spline(t, elevation_sign(rig) * 1.02 * bump(rise[0], travel), k=7)
        return rise, np.stack([height(t), *(height.derivative(n)(t) for n in (1, 2))])

    return slowed(motion, duration, rig)


def bump(position: Any, travel: float, exp: Any = np.exp) -> Any:
    """Least height in rad of the arm's end at a travel position in rad."""
    return BUMP_HEIGHT * exp(-BUMP_SHARPNESS * (position - BUMP_PLACE * travel) ** 2)


def elevation_sign(rig: Rig) -> float:
    """Factor that makes an elevation of the rig positive upwards: 1 or -1."""
    return -1.0 if rig.parameters.b2 < 0.0 else 1.0


def steps_of(duration: float) -> int:
    """Number of commands in a duration in s. Raises ValueError for less than two steps."""
    if not (math.isfinite(duration) and duration >= 2.0 * STEP):
        raise ValueError(f"duration = {duration!r}: must be at least {2.0 * STEP:g} s, and finite")
    return round(duration / STEP)


def lqr_gain(rig: Rig, loop: InnerLoop = InnerLoop()) -> np.ndarray:
    """Gain K (2, 6) of c = c* - K (x - x*) for the linear model, by the discrete algebraic Riccati equation."""
    A, B = linear_model(rig, loop)
    Q, R = np.diag(STATE_PRICE), np.diag(COMMAND_PRICE)
    P = solve_discrete_are(A, B, Q, R)
    return np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)


@dataclass(eq=False)
class SchedulePolicy:
    """Policy that sends scheduled commands to the inner loop, corrected by an optional gain K (2, 6).

    Raises ValueError for a control period that is not positive or longer than STEP.
    """

    schedule: Schedule
    rig: Rig
    gain: np.ndarray | None = None
    loop: InnerLoop = COURSE_LOOP
    control_period: float = 0.02
    pitch_limit: float = PITCH_COMMAND
    integral: Any = field(default=0.0, init=False, repr=False)
    command: Any = field(default=None, init=False, repr=False)
    step: int = field(default=-1, init=False, repr=False)

    def __post_init__(self) -> None:
        if not (math.isfinite(self.control_period) and 0.0 < self.control_period <= STEP):
            raise ValueError(f"control_period = {self.control_period!r}: must be more than 0 and at most {STEP:g} s")

    def reset(self, rng: np.random.Generator) -> None:
        """Clear the integral and the command of the last flight."""
        self.integral, self.command, self.step = 0.0, None, -1

    def __call__(self, t: float, measurement: np.ndarray) -> np.ndarray:
        travel, dtravel, elevation, delevation, pitch, dpitch = np.asarray(measurement, dtype=float)
        k = min(int(step_index(t, self.control_period, 10**9) * self.control_period / STEP + 1e-9), 10**6)
        if k != self.step:  # a new command only every STEP
            last = self.schedule.commands.shape[1] - 1
            command = self.schedule.commands[:, k] if k <= last else np.zeros(2)
            if self.gain is not None:
                state = np.stack((travel, dtravel, pitch, dpitch, elevation, delevation))
                planned = self.schedule.x[:, min(k, last + 1)].reshape(-1, *(1,) * (state.ndim - 1))
                command = command.reshape(-1, *(1,) * (state.ndim - 1)) - self.gain @ (state - planned)
            self.step, self.command = k, command
        pitch_command = np.clip(self.command[0], -self.pitch_limit, self.pitch_limit)
        p, loop = self.rig.parameters, self.loop
        self.integral = self.integral + self.control_period * (elevation - self.command[1])
        wanted_pitch = loop.pitch**2 * (pitch_command - pitch) - 2.0 * loop.pitch_damping * loop.pitch * dpitch
        wanted_elevation = loop.elevation**2 * (self.command[1] - elevation)
        wanted_elevation -= 2.0 * loop.elevation_damping * loop.elevation * delevation
        wanted_elevation -= loop.elevation_integral * self.integral
        # The inner loop knows only the thrust of level hover; PD and PID do the rest.
        v1 = hover_input(0.0, p)[0] + wanted_elevation / p.b2
        return self.rig.voltage(np.stack(fan_thrusts((v1, wanted_pitch / p.b3))))
