"""Control step in torch: the simulator's equations on tensors, for GPUs and for gradients.

A batch holds any number of helicopters, on any device and in any dtype. Plants may have rotor lag, thrust loss, slew,
delay, friction, a rig and encoders, each with its own numbers. Disturbances and noise are not supported.
"""

from types import SimpleNamespace
from typing import Any, NamedTuple

import torch

from heli_gym.model import axpy, dynamics, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import quantise, with_friction_and_disturbances
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.simulation import motion
from heli_gym.simulation.layout import Settings, shared
from heli_gym.simulation.motion import Body
from heli_gym.simulation.reward import LimitArrays
from heli_gym.simulation.simulation import Simulation
from heli_gym.task import OBSERVATION_LIMIT, cost, crashed, observed_error, observed_voltage, reward, to_voltage


class Batch(NamedTuple):
    """Plants and references of N helicopters, in tensors (..., N)."""

    body: Body
    share: torch.Tensor  # (2, N), remaining share of each rotor's thrust
    lag_decay: torch.Tensor
    has_lag: torch.Tensor
    slew: torch.Tensor  # V/s
    delay: torch.Tensor  # control periods
    zeros: torch.Tensor  # (3, N), rad
    counts: torch.Tensor  # (3, N), zero for exact sensors
    rate_decay: torch.Tensor
    limits: LimitArrays
    last: torch.Tensor  # last step of the reference
    table: torch.Tensor  # (K, TABLE_WIDTH), references
    first: torch.Tensor  # first row in the table
    hover: torch.Tensor  # (2, N), V, voltages of action 0
    settings: Settings
    derivative: Any


class State(NamedTuple):
    """State of N helicopters, in tensors (..., N)."""

    x: torch.Tensor  # (6, N), (44)
    measured: torch.Tensor  # (6, N)
    command: torch.Tensor  # (2, N), V
    pending: torch.Tensor  # (D, 2, N), V, commands in the delay line, oldest first
    motor: torch.Tensor  # (2, N), V
    rotor: torch.Tensor  # (2, N), V
    step: torch.Tensor  # (N,)


class Outcome(NamedTuple):
    """Outputs of a control step, in tensors (N, ...)."""

    observation: torch.Tensor  # (N, OBSERVED)
    reward: torch.Tensor
    cost: torch.Tensor
    terminated: torch.Tensor
    truncated: torch.Tensor


def equation_3(x: Any, v: Any, body: Body) -> tuple:
    """State derivative (6, N) by (3)."""
    return dynamics(x, v, body.parameters, torch.sin, torch.cos)


def equation_3_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """State derivative (6, N) by (3) with friction."""
    dx = dynamics(x, v, body.parameters, torch.sin, torch.cos)
    return with_friction_and_disturbances(x, dx, body.viscous, body.coulomb, body.torques, torch.cos)


def rigid_body_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """State derivative (6, N) of the full rigid body with friction."""
    dx = rigid_dynamics(x, v, body.rig, torch.sin, torch.cos)
    return with_friction_and_disturbances(x, dx, body.viscous, body.coulomb, body.torques, torch.cos)


DERIVATIVES = {
    motion.equation_3: equation_3,
    motion.equation_3_with_disturbances: equation_3_with_disturbances,
    motion.rigid_body_with_disturbances: rigid_body_with_disturbances,
}


def to_torch(simulation: Simulation, device: str = "cpu") -> tuple[Batch, State]:
    """Copy the helicopters of a simulation and their current state to torch.

    Raises ValueError for a plant with disturbances, noise, or effects beyond rotors and friction.
    """
    settings = shared(simulation.settings.tolist())
    if settings.disturbances or settings.is_noisy or simulation.fly is motion.step_general:
        raise ValueError(
            "plant: must have no disturbances, noise, thrust map, table, travel lift or fraction of a period of delay; "
            "torch does not simulate these"
        )

    r = SimpleNamespace(
        **{name: torch.tensor(value, device=device) for name, value in vars(simulation.record()).items()}
    )
    zero = torch.zeros(1, dtype=r.state.dtype, device=device)
    batch = Batch(
        body=Body(
            HelicopterParameters(*r.parameters),
            RigidBodyParameters(*r.rig),
            r.viscous,
            r.coulomb,
            (zero, zero, zero, zero),
        ),
        share=r.share,
        lag_decay=r.lag_decay,
        has_lag=r.lag > 0.0,
        slew=r.slew,
        delay=r.delay_periods,
        zeros=r.zeros,
        counts=r.counts,
        rate_decay=r.rate_decay,
        limits=LimitArrays(*r.limits, *r.pitch_limits),
        last=r.last.long(),
        table=torch.tensor(simulation.table, device=device),
        first=r.reference_row.long(),
        hover=r.hover,
        settings=settings,
        derivative=DERIVATIVES[simulation.rhs],
    )
    state = State(
        x=r.state,
        measured=r.measured if settings.is_sensed else r.state,
        command=r.command,
        pending=r.pending,
        motor=r.motor,
        rotor=r.rotor,
        step=r.step.long(),
    )
    return batch, state


def step(batch: Batch, state: State, actions: torch.Tensor) -> tuple[State, Outcome]:
    """Fly one control step with actions (N, 2); the batched form of `kernels.control_step`."""
    s = batch.settings
    command = to_voltage(actions.T.clamp(-1.0, 1.0), (s.u_low, s.u_high), batch.hover).clamp(s.u_low, s.u_high)
    motor, pending = apply_amplifier(batch, state, command)
    rotor = torch.where(batch.has_lag, state.rotor, motor)
    x, h = tuple(state.x), s.period / s.substeps
    for _ in range(int(s.substeps)):
        x, rotor = integrate(batch, x, motor, rotor, h)

    at = reference_row(batch, state)
    now, then = batch.table[at].T, batch.table[at + 1].T
    earned = s.period * reward(axpy(x, -1.0, then[:6]), command - now[6:8], s.u_high - s.u_low)
    spent = s.period * cost(x[4], command, batch.limits)
    terminated = crashed(x[4], s.pitch_limit)
    truncated = (state.step + 1 == batch.last) & ~terminated
    state = State(torch.stack(x), measure(batch, state, x), command, pending, motor, rotor, state.step + 1)
    return state, Outcome(observe(batch, state), earned, spent, terminated, truncated)


def apply_amplifier(batch: Batch, state: State, command: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """Motor voltages (2, N) and delay line (D, 2, N) after commands (2, N), all in V."""
    waiting = torch.cat((state.pending, command[None]))
    delay = len(state.pending)
    # commands from one delay ago, by helicopter
    arriving = waiting[(delay - batch.delay).long(), :, torch.arange(len(batch.delay), device=command.device)].T
    most = batch.settings.period * batch.slew
    return torch.minimum(torch.maximum(arriving, state.motor - most), state.motor + most), waiting[1:]


def integrate(batch: Batch, x: tuple, motor: torch.Tensor, rotor: torch.Tensor, h: float) -> tuple[tuple, torch.Tensor]:
    """Integrate h seconds at constant motor voltages; see `motion.integrate`."""
    middle = motor + batch.lag_decay * (rotor - motor)
    end = motor + batch.lag_decay * (middle - motor)
    inputs = tuple(
        virtual_input(tuple(share * thrust(w, batch.body.parameters) for share, w in zip(batch.share, pair)))
        for pair in (rotor, middle, end)
    )
    return rk4_step(batch.derivative, x, inputs, h, batch.body), end


def measure(batch: Batch, state: State, x: tuple) -> torch.Tensor:
    """Measurements (6, N) of the states x (6, N); see `plant.Sensors`."""
    if not batch.settings.is_sensed:
        return torch.stack(x)
    rows = []
    for axis in range(3):
        exact = batch.counts[axis] == 0.0
        angle = quantise(x[2 * axis] - batch.zeros[axis], batch.counts[axis].clamp(min=1.0), torch.floor)
        last, rate = state.measured[2 * axis], state.measured[2 * axis + 1]
        estimate = batch.rate_decay * rate + (1.0 - batch.rate_decay) * (angle - last) / batch.settings.period
        rows += [torch.where(exact, x[2 * axis], angle), torch.where(exact, x[2 * axis + 1], estimate)]
    return torch.stack(rows)


def reference_row(batch: Batch, state: State) -> torch.Tensor:
    """Current rows (N,) of the references in the table, at most their last rows."""
    return batch.first + torch.minimum(state.step, batch.last)


def observe(batch: Batch, state: State) -> torch.Tensor:
    """Observations (N, OBSERVED) in float32."""
    row = batch.table[reference_row(batch, state)]
    error = torch.stack(observed_error(state.measured - row[:, :6].T), dim=1)
    shown = torch.cat((error, observed_voltage(state.command.T), row[:, 8:]), dim=1)
    return shown.clamp(-OBSERVATION_LIMIT, OBSERVATION_LIMIT).float()
