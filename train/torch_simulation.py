"""The control step for torch: the same equations on tensors, so that they fly on a GPU and can be differentiated.

For any number of helicopters in one batch, on whatever device and in whatever dtype the numbers are. Plants may have
rotor lag, thrust loss, slew, delay, friction, a rig and encoders, each with its own numbers; disturbances and noise,
which `heli_gym.simulation.kernels` draws helicopter by helicopter, are refused.
"""

from typing import Any, NamedTuple

import torch

from heli_gym.model import axpy, dynamics, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import quantise, with_friction_and_disturbances
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.simulation import kernels
from heli_gym.simulation.kernels import (
    COMMAND,
    COULOMB,
    COUNTS,
    DELAY,
    DISTURBANCES,
    LAG,
    LAG_DECAY,
    LAST,
    LIMITS,
    LOSS,
    MEASURED,
    MOTOR,
    PARAMETERS,
    PITCH_LIMITS,
    RATE_DECAY,
    REFERENCE_ROW,
    RIG,
    ROTOR,
    SLEW,
    STEP,
    VISCOUS,
    Body,
    LimitArrays,
    X,
)
from heli_gym.simulation.simulation import Simulation
from heli_gym.task import cost, crashed, reward, to_voltage


class Fleet(NamedTuple):
    """N helicopters: what they are, and what they follow. Tensors of numbers (..., N)."""

    body: Body
    share: torch.Tensor  # of the thrust that is left
    lag_kept: torch.Tensor
    has_lag: torch.Tensor
    slew: torch.Tensor  # V/s
    delay: torch.Tensor  # control periods
    counts: torch.Tensor  # (3, N), zero for exact sensors
    rate_kept: torch.Tensor
    limits: LimitArrays
    last: torch.Tensor  # steps
    table: torch.Tensor  # (K, FEATURES), the references
    first: torch.Tensor  # row of the table
    settings: kernels.Settings
    derivative: Any


class State(NamedTuple):
    """What changes in flight. Tensors (..., N)."""

    x: torch.Tensor  # (6, N), (44)
    measured: torch.Tensor  # (6, N)
    command: torch.Tensor  # (2, N), V
    pending: torch.Tensor  # (D, 2, N), V, on their way to the motors, the oldest first
    motor: torch.Tensor  # (2, N), V
    rotor: torch.Tensor  # (2, N), V
    step: torch.Tensor  # (N,)


class Outcome(NamedTuple):
    """What a control step tells. Tensors (N, ...)."""

    observation: torch.Tensor  # (N, 49)
    reward: torch.Tensor
    cost: torch.Tensor
    terminated: torch.Tensor
    truncated: torch.Tensor


def equation_3(x: Any, v: Any, body: Body) -> tuple:
    """(3) and no more."""
    return dynamics(x, v, body.parameters, torch.sin, torch.cos)


def equation_3_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """(3) with friction."""
    dx = dynamics(x, v, body.parameters, torch.sin, torch.cos)
    return with_friction_and_disturbances(x, dx, body.viscous, body.coulomb, body.torques, torch.cos)


def rigid_body_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """The full rigid body with friction."""
    dx = rigid_dynamics(x, v, body.rig, torch.sin, torch.cos)
    return with_friction_and_disturbances(x, dx, body.viscous, body.coulomb, body.torques, torch.cos)


DERIVATIVES = {
    kernels.equation_3: equation_3,
    kernels.equation_3_with_disturbances: equation_3_with_disturbances,
    kernels.rigid_body_with_disturbances: rigid_body_with_disturbances,
}


def to_torch(simulation: Simulation, device: str = "cpu") -> tuple[Fleet, State]:
    """The helicopters of a simulation, as they are now.

    Raises ValueError if a plant has disturbances or noise.
    """
    settings = kernels.shared(simulation.settings.tolist())
    if settings.disturbances or settings.is_noisy:
        raise ValueError("plant: disturbances and noise are not simulated in torch")

    def rows(first: int, count: int) -> torch.Tensor:
        return torch.tensor(simulation.rows(first, count), device=device)

    zero = torch.zeros(1, dtype=rows(X, 1).dtype, device=device)
    body = Body(
        HelicopterParameters(*rows(PARAMETERS, len(HelicopterParameters._fields))),
        RigidBodyParameters(*rows(RIG, 11)),
        rows(VISCOUS, 3),
        rows(COULOMB, 3),
        (zero, zero, zero, zero),
    )
    fleet = Fleet(
        body,
        1.0 - rows(LOSS, 1)[0],
        rows(LAG_DECAY, 1)[0],
        rows(LAG, 1)[0] > 0.0,
        rows(SLEW, 1)[0],
        rows(DELAY, 1)[0],
        rows(COUNTS, 3),
        rows(RATE_DECAY, 1)[0],
        LimitArrays(*rows(LIMITS, 2), *rows(PITCH_LIMITS, 2)),
        rows(LAST, 1)[0].long(),
        torch.tensor(simulation.table, device=device),
        rows(REFERENCE_ROW, 1)[0].long(),
        settings,
        DERIVATIVES[simulation.rhs],
    )
    delay = int(settings.delay)
    state = State(
        rows(X, 6),
        rows(MEASURED, 6) if settings.is_sensed else rows(X, 6),
        rows(COMMAND, 2),
        rows(DISTURBANCES, 2 * delay).reshape(delay, 2, len(simulation.plants)),
        rows(MOTOR, 2),
        rows(ROTOR, 2),
        rows(STEP, 1)[0].long(),
    )
    return fleet, state


def step(fleet: Fleet, state: State, actions: torch.Tensor) -> tuple[State, Outcome]:
    """A control step of all helicopters under actions (N, 2): `kernels.control_step` without its loops."""
    s = fleet.settings
    command = to_voltage(actions.T, (s.u_low, s.u_high)).clamp(s.u_low, s.u_high)
    motor, pending = apply_amplifier(fleet, state, command)
    rotor = torch.where(fleet.has_lag, state.rotor, motor)
    x, h = tuple(state.x), s.period / s.substeps
    for _ in range(int(s.substeps)):
        x, rotor = integrate(fleet, x, motor, rotor, h)

    at = reference_row(fleet, state)
    now, then = fleet.table[at].T, fleet.table[at + 1].T
    earned = s.period * reward(axpy(x, -1.0, then[:6]), command - now[6:8])
    spent = s.period * cost(x[4], command, fleet.limits)
    terminated = crashed(x[4], s.pitch_limit)
    truncated = (state.step + 1 == fleet.last) & ~terminated
    state = State(torch.stack(x), measure(fleet, state, x), command, pending, motor, rotor, state.step + 1)
    return state, Outcome(observe(fleet, state), earned, spent, terminated, truncated)


def apply_amplifier(fleet: Fleet, state: State, command: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """The voltages (2, N) at the motors, and those still on their way."""
    waiting = torch.cat((state.pending, command[None]))
    delay = len(state.pending)
    # the one that was asked for so many periods ago as this helicopter's delay
    arriving = waiting[(delay - fleet.delay).long(), :, torch.arange(len(fleet.delay), device=command.device)].T
    most = fleet.settings.period * fleet.slew
    return torch.minimum(torch.maximum(arriving, state.motor - most), state.motor + most), waiting[1:]


def integrate(fleet: Fleet, x: tuple, motor: torch.Tensor, rotor: torch.Tensor, h: float) -> tuple[tuple, torch.Tensor]:
    """h seconds of flight, the voltages at the motors being held; see `kernels.integrate`."""
    middle = motor + fleet.lag_kept * (rotor - motor)
    end = motor + fleet.lag_kept * (middle - motor)
    inputs = tuple(
        virtual_input(tuple(fleet.share * thrust(w, fleet.body.parameters) for w in pair))
        for pair in (rotor, middle, end)
    )
    return rk4_step(fleet.derivative, x, inputs, h, fleet.body), end


def measure(fleet: Fleet, state: State, x: tuple) -> torch.Tensor:
    """The measurements (6, N) of the states x (6, N); see `plant.Sensors`."""
    if not fleet.settings.is_sensed:
        return torch.stack(x)
    rows = []
    for axis in range(3):
        exact = fleet.counts[axis] == 0.0
        outputs = quantise(x[2 * axis], fleet.counts[axis].clamp(min=1.0), torch.floor)
        last, rate = state.measured[2 * axis], state.measured[2 * axis + 1]
        estimate = fleet.rate_kept * rate + (1.0 - fleet.rate_kept) * (outputs - last) / fleet.settings.period
        rows += [torch.where(exact, x[2 * axis], outputs), torch.where(exact, x[2 * axis + 1], estimate)]
    return torch.stack(rows)


def reference_row(fleet: Fleet, state: State) -> torch.Tensor:
    """Rows (N,) of the table where the references are now; beyond their ends, where they end."""
    return fleet.first + torch.minimum(state.step, fleet.last)


def observe(fleet: Fleet, state: State) -> torch.Tensor:
    """Observations (N, 49), float32."""
    features = fleet.table[reference_row(fleet, state)]
    return torch.cat((state.measured.T - features[:, :6], state.command.T, features), dim=1).float()
