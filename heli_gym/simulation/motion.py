"""One control period of motion in loops over the helicopters of a block: right-hand sides and integration."""

from typing import Any, NamedTuple

from numpy import cos, sin

from heli_gym.model import dynamics, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import with_friction_and_disturbances
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.simulation.disturbances import step_gusts, sum_disturbances
from heli_gym.simulation.layout import (
    A2_CHANGE,
    COMMAND,
    COULOMB,
    EFFECT,
    LAG_DECAY,
    LOSS,
    MOTOR,
    PARAMETERS,
    RIG,
    ROTOR,
    ROW,
    TORQUES,
    VISCOUS,
    Settings,
    X,
    eleven,
    put_six,
    put_two,
    six,
    three,
    two,
)
from heli_gym.simulation.rotors import apply_amplifier


class Body(NamedTuple):
    """What a time derivative depends on besides state and thrust."""

    parameters: Any
    rig: Any
    viscous: Any
    coulomb: Any
    torques: Any


# The right-hand sides, one of which is compiled into a simulation.


def equation_3(x: Any, v: Any, body: Body) -> tuple:
    """Equation (3)."""
    return dynamics(x, v, body.parameters, sin, cos)


def equation_3_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """Equation (3) with friction and disturbances."""
    return with_friction_and_disturbances(
        x, dynamics(x, v, body.parameters, sin, cos), body.viscous, body.coulomb, body.torques, cos
    )


def rigid_body_with_disturbances(x: Any, v: Any, body: Body) -> tuple:
    """The full rigid body with friction and disturbances."""
    return with_friction_and_disturbances(
        x, rigid_dynamics(x, v, body.rig, sin, cos), body.viscous, body.coulomb, body.torques, cos
    )


derivative = equation_3  # a name that `kernels` binds to one of these


def integrate(block: Any, n: int, h: Any) -> None:
    """Integrate h seconds at constant motor voltages: the rotors exactly, the body by one Runge-Kutta step."""
    for i in range(n):
        p = HelicopterParameters(*eleven(block, PARAMETERS, i))
        rig = RigidBodyParameters(*eleven(block, RIG, i))
        torques = (*three(block, TORQUES, i), block[A2_CHANGE * ROW + i])
        body = Body(p, rig, three(block, VISCOUS, i), three(block, COULOMB, i), torques)

        decay = block[LAG_DECAY * ROW + i]
        (u_f, u_b), (w_f, w_b) = two(block, MOTOR, i), two(block, ROTOR, i)
        middle_f, middle_b = u_f + decay * (w_f - u_f), u_b + decay * (w_b - u_b)
        end_f, end_b = u_f + decay * (middle_f - u_f), u_b + decay * (middle_b - u_b)
        effect_f, effect_b = two(block, EFFECT, i)
        share = 1.0 - block[LOSS * ROW + i]
        front, back = share * effect_f, share * effect_b
        inputs = (
            virtual_input((front * thrust(w_f, p), back * thrust(w_b, p))),
            virtual_input((front * thrust(middle_f, p), back * thrust(middle_b, p))),
            virtual_input((front * thrust(end_f, p), back * thrust(end_b, p))),
        )
        put_six(block, X, i, rk4_step(derivative, six(block, X, i), inputs, h, body))
        put_two(block, ROTOR, i, (end_f, end_b))


def step_plant(block: Any, n: int, s: Settings) -> None:
    """Fly one control period with all that a plant may add to (3)."""
    apply_amplifier(block, n, s)
    h = s.period / s.substeps
    if s.disturbances > 0.0:
        step_gusts(block, n, s)
    for k in range(int(s.substeps)):
        if s.disturbances > 0.0:
            sum_disturbances(block, n, s, k * h, h)
        integrate(block, n, h)


def step_equation_3(block: Any, n: int, s: Settings) -> None:
    """Fly one control period of (3) with rotors that follow at once: `step_plant` for that case, with less to store."""
    for i in range(n):
        p, (u_f, u_b) = HelicopterParameters(*eleven(block, PARAMETERS, i)), two(block, COMMAND, i)
        v = virtual_input((thrust(u_f, p), thrust(u_b, p)))
        put_six(block, X, i, rk4_step(derivative, six(block, X, i), (v, v, v), s.period, Body(p, (), (), (), ())))
