"""One control period of motion in loops over the helicopters of a block: right-hand sides and integration."""

from typing import Any, NamedTuple

from numpy import cos, sin

from heli_gym.model import dynamics, rk4_step, thrust, virtual_input
from heli_gym.parameters import HelicopterParameters
from heli_gym.plant import with_contact, with_coupling, with_friction_and_disturbances, with_lift
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.simulation.disturbances import step_gusts, sum_disturbances
from heli_gym.simulation.layout import (
    A2_CHANGE,
    AFTER,
    COMMAND,
    COULOMB,
    COUPLING,
    DELAY_REST,
    EFFECT,
    LAG_DECAY,
    MOTOR,
    PARAMETERS,
    REST_DECAY,
    RIG,
    ROTOR,
    ROW,
    SHARE,
    TABLE,
    THRUSTS,
    TORQUES,
    TRAVEL_LIFT,
    VISCOUS,
    H,
    Settings,
    X,
    eleven,
    five,
    put_six,
    put_two,
    six,
    three,
    two,
)
from heli_gym.simulation.rotors import apply_amplifier, delay_command, map_thrusts, turn_rotors

FASTEST = 100.0  # rad/s, far beyond any laboratory helicopter


class Body(NamedTuple):
    """Arguments of a time derivative besides state and thrust."""

    parameters: Any
    rig: Any
    viscous: Any
    coulomb: Any
    torques: Any


class GeneralBody(NamedTuple):
    """Arguments of the time derivative of a general plant besides state and thrust."""

    parameters: Any
    rig: Any
    viscous: Any
    coulomb: Any
    torques: Any
    travel_lift: Any
    table: Any
    coupling: Any


# Right-hand sides; one of them is compiled into a simulation.


def equation_3(x: Any, v: Any, body: Body) -> tuple:
    """Equation (3)."""
    return dynamics(x, v, body.parameters, sin, cos)


def equation_3_with_disturbances(x: Any, v: Any, body: Body | GeneralBody) -> tuple:
    """Equation (3) with friction and disturbances."""
    return with_friction_and_disturbances(
        x, dynamics(x, v, body.parameters, sin, cos), body.viscous, body.coulomb, body.torques, cos
    )


def rigid_body_with_disturbances(x: Any, v: Any, body: Body | GeneralBody) -> tuple:
    """Full rigid body with friction and disturbances."""
    return with_friction_and_disturbances(
        x, rigid_dynamics(x, v, body.rig, sin, cos), body.viscous, body.coulomb, body.torques, cos
    )


def general_equation_3(x: Any, v: Any, body: GeneralBody) -> tuple:
    """Equation (3) with all effects of a general plant."""
    dx = with_contact(x, equation_3_with_disturbances(x, v, body), body.parameters, body.table, sin, cos)
    return with_lift(dx, body.travel_lift)


def coupled_equation_3(x: Any, v: Any, body: GeneralBody) -> tuple:
    """Equation (3) with all effects of a general plant and the moments between its axes."""
    speed = abs(x[1])
    return with_coupling(x, general_equation_3(x, v, body), speed, body.parameters, body.coupling, sin, cos)


def general_rigid_body(x: Any, v: Any, body: GeneralBody) -> tuple:
    """Full rigid body with all effects of a general plant."""
    dx = with_contact(x, rigid_body_with_disturbances(x, v, body), body.parameters, body.table, sin, cos)
    return with_lift(dx, body.travel_lift)


def with_bounded_rates(x: Any) -> tuple:
    """The state with rates of at most FASTEST, so that the quadratic terms of a rigid body never overflow."""
    q1, dq1, q2, dq2, q3, dq3 = x
    return (
        q1,
        min(max(dq1, -FASTEST), FASTEST),
        q2,
        min(max(dq2, -FASTEST), FASTEST),
        q3,
        min(max(dq3, -FASTEST), FASTEST),
    )


derivative = equation_3  # `kernels` rebinds this name to one of these


def integrate(block: Any, n: int, h: Any) -> None:
    """Integrate over h seconds at constant motor voltages: rotors exactly, the body by one Runge-Kutta step."""
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
        share_f, share_b = two(block, SHARE, i)
        front, back = share_f * effect_f, share_b * effect_b
        inputs = (
            virtual_input((front * thrust(w_f, p), back * thrust(w_b, p))),
            virtual_input((front * thrust(middle_f, p), back * thrust(middle_b, p))),
            virtual_input((front * thrust(end_f, p), back * thrust(end_b, p))),
        )
        put_six(block, X, i, with_bounded_rates(rk4_step(derivative, six(block, X, i), inputs, h, body)))
        put_two(block, ROTOR, i, (end_f, end_b))


def step_plant(block: Any, n: int, s: Settings) -> None:
    """Fly one control period of a plant with power curves and a whole number of delay periods."""
    delay_command(block, n, s)
    h = s.period / s.substeps
    for i in range(n):
        put_two(block, AFTER, i, (0.0, h))
    apply_amplifier(block, n, s)
    if s.disturbances > 0.0:
        step_gusts(block, n, s)
    for k in range(int(s.substeps)):
        if s.disturbances > 0.0:
            for i in range(n):
                put_two(block, AFTER, i, (k * h, h))
            sum_disturbances(block, n, s)
        integrate(block, n, h)


def integrate_general(block: Any, n: int) -> None:
    """Integrate the body by one Runge-Kutta step of H seconds with the THRUSTS of the rotors."""
    for i in range(n):
        p = HelicopterParameters(*eleven(block, PARAMETERS, i))
        rig = RigidBodyParameters(*eleven(block, RIG, i))
        torques = (*three(block, TORQUES, i), block[A2_CHANGE * ROW + i])
        lift, table = block[TRAVEL_LIFT * ROW + i], two(block, TABLE, i)
        own = three(block, VISCOUS, i), three(block, COULOMB, i)
        body = GeneralBody(p, rig, *own, torques, lift, table, five(block, COUPLING, i))

        (effect_f, effect_b), (share_f, share_b) = two(block, EFFECT, i), two(block, SHARE, i)
        front, back = share_f * effect_f, share_b * effect_b
        f1, b1, f2, b2, f3, b3 = six(block, THRUSTS, i)
        inputs = (
            virtual_input((front * f1, back * b1)),
            virtual_input((front * f2, back * b2)),
            virtual_input((front * f3, back * b3)),
        )
        x = rk4_step(derivative, six(block, X, i), inputs, block[H * ROW + i], body)
        put_six(block, X, i, with_bounded_rates(x))


def fly_part(block: Any, n: int, s: Settings, decay_row: int) -> None:
    """Integrate over the steps of a part of the control period; AFTER and H are those of the first step."""
    for _ in range(int(s.substeps)):
        if s.disturbances > 0.0:
            sum_disturbances(block, n, s)
        turn_rotors(block, n, decay_row)
        map_thrusts(block, n, s)
        integrate_general(block, n)
        for i in range(n):
            block[AFTER * ROW + i] += block[H * ROW + i]


def step_general(block: Any, n: int, s: Settings) -> None:
    """Fly one control period of any plant, in two parts: before and after the arrival of the delayed voltages."""
    if s.disturbances > 0.0:
        step_gusts(block, n, s)
    if s.is_fractional > 0.0:
        for i in range(n):
            put_two(block, AFTER, i, (0.0, block[DELAY_REST * ROW + i] / s.substeps))
        apply_amplifier(block, n, s)
        fly_part(block, n, s, REST_DECAY)
    delay_command(block, n, s)
    for i in range(n):
        rest = block[DELAY_REST * ROW + i]
        put_two(block, AFTER, i, (rest, (s.period - rest) / s.substeps))
    apply_amplifier(block, n, s)
    fly_part(block, n, s, LAG_DECAY)


def step_equation_3(block: Any, n: int, s: Settings) -> None:
    """Fly one control period of (3) with rotors without lag: the special case of `step_plant` with less memory."""
    for i in range(n):
        p, (u_f, u_b) = HelicopterParameters(*eleven(block, PARAMETERS, i)), two(block, COMMAND, i)
        v = virtual_input((thrust(u_f, p), thrust(u_b, p)))
        x = rk4_step(derivative, six(block, X, i), (v, v, v), s.period, Body(p, (), (), (), ()))
        put_six(block, X, i, with_bounded_rates(x))
