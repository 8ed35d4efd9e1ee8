"""The full rigid-body model behind equation (3): three hinges, the counterweight, and the helicopter body.

The arm turns about the vertical (travel, q1) and tilts (elevation: eps = -q2, positive when it lifts the body); the
body turns about the arm (pitch, phi = q3). In the arm's frame, x along the arm and z up, the counterweight is a point
mass at (-l_c, 0, -d_c) and the pitch hinge is at (l_h, 0, e_h). The body is two half masses, r to either side of a
centre of mass d_h below the hinge. The rotors are l_p to either side of the hinge, the front one at positive y.
"""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from heli_gym.parameters import HelicopterParameters, Scalar
from heli_gym.storage import atomic_write

VARIANTS = ("A", "B")
LEVEL = 1e-14  # relative to a moment of inertia: smaller squared heights are rounding
MODELS = Path(__file__).parent / "models"


class RigidBodyParameters(NamedTuple):
    """Geometry and masses of the rig, as `solve_rigid_body` returns them. Fields may be arrays (N,)."""

    l_h: Scalar  # m, from the travel axis to the body
    l_p: Scalar  # m, from the pitch axis to a rotor
    l_c: Scalar  # m, from the travel axis to the counterweight
    g: Scalar  # m/s²
    m_h: Scalar  # kg, body
    m_c: Scalar  # kg, counterweight
    r: Scalar  # m, radius of gyration of the body, along the line through the rotors
    d_h: Scalar  # m, centre of mass of the body below the pitch hinge
    d_c: Scalar  # m, counterweight below the arm
    e_h: Scalar  # m, pitch hinge above the arm
    kappa: Scalar = 0.02  # m, drag torque per thrust of a rotor; 0.015 to 0.03 in published models of such rigs


def solve_rigid_body(
    variant: str,
    parameters: HelicopterParameters = HelicopterParameters(),
    *,
    l_h: Scalar = 0.6604,
    l_p: Scalar = 0.1778,
    l_c: Scalar = 0.4699,
    g: Scalar = 9.81,
) -> RigidBodyParameters:
    """Rig of this geometry (m, m/s²) whose linearisation about level hover has the coefficients of (3).

    The coefficients of each axis are exact while the other two axes are locked, the assumption of (3). With all axes
    free, the product of inertia between travel and pitch makes a3 2.6 % and b1 0.2 % smaller and b3 0.02 % larger.
    There are two solutions: variant "A" has the pitch hinge above the arm and the counterweight below it, variant "B"
    the body below the arm. The centrifugal lift is downwards in "A" and upwards in "B".

    Raises ValueError for another variant, or if there is no solution for this geometry.
    """
    if variant not in VARIANTS:
        raise ValueError(f"variant = {variant!r}: must be one of {', '.join(map(repr, VARIANTS))}")
    p = parameters
    if not np.all((p.b1 < 0.0) & (p.b2 < 0.0) & (p.b3 > 0.0)):
        raise ValueError(f"{p}: must have b1 < 0, b2 < 0 and b3 > 0")

    # Inertias from b1, b2, b3; first moments from a1, a2, a3.
    D11, D22, D33 = -l_h / p.b1, -l_h / p.b2, l_p / p.b3
    up = p.a1 * D22 / g  # m_h (e_h - d_h) - m_c d_c
    out = p.a2 * D22 / g  # m_h l_h - m_c l_c
    down = -p.a3 * D33 / g  # m_h d_h

    # D11 = m_c l_c² + m_h l_h² + D33 - down² / m_h, with m_c l_c = m_h l_h - out
    a, b = l_h * (l_h + l_c), D11 - D33 + l_c * out
    m_h = (b + (b**2 + 4.0 * a * down**2) ** 0.5) / (2.0 * a)
    m_c = (m_h * l_h - out) / l_c
    d_h = down / m_h
    r2 = D33 / m_h - d_h**2

    # D22 = m_c (l_c² + d_c²) + m_h (l_h² + (e_h - d_h)²), with m_h (e_h - d_h) = up + m_c d_c
    rest = D22 - m_c * l_c**2 - m_h * l_h**2
    discriminant = up**2 - (m_h + m_c) * (up**2 - m_h * rest) / m_c
    # only rounding where hinge and counterweight are level with the arm: set to zero
    discriminant = discriminant * (abs(discriminant) > LEVEL * (m_h + m_c) * m_h * D22 / m_c)
    if not np.all((m_c > 0.0) & (r2 > 0.0) & (discriminant >= 0.0)):
        raise ValueError(
            f"{p}: no rig with {l_h = }, {l_p = }, {l_c = } m and {g = } m/s² has these coefficients; "
            "to vary a rig, solve for the nominal one and replace its masses and lengths"
        )
    root = discriminant**0.5 if variant == "A" else -(discriminant**0.5)
    d_c = (root - up) / (m_h + m_c)
    e_h = d_h + (up + m_c * d_c) / m_h
    return RigidBodyParameters(l_h, l_p, l_c, g, m_h, m_c, r2**0.5, d_h, d_c, e_h)


def mass_matrix(ce: Any, se: Any, cf: Any, sf: Any, p: RigidBodyParameters) -> tuple:
    """(D11, D22, D33, D12, D13, D23) in kg m² of (q1, eps, phi), from the cosines and sines of eps and phi."""
    z = p.e_h - p.d_h * cf
    D11 = p.m_c * (p.l_c * ce - p.d_c * se) ** 2 + p.m_h * (
        (p.l_h * ce - z * se) ** 2 + p.r**2 * (1.0 - ce**2 * sf**2) + p.d_h**2 * sf**2
    )
    D22 = p.m_c * (p.l_c**2 + p.d_c**2) + p.m_h * (p.l_h**2 + z**2 + p.r**2 * sf**2)
    D33 = p.m_h * (p.r**2 + p.d_h**2)
    D12 = p.m_h * sf * (p.r**2 * ce * cf + p.d_h * (p.l_h * se + z * ce))
    D13 = p.m_h * ((p.r**2 + p.d_h**2) * se + p.d_h * cf * (p.l_h * ce - p.e_h * se))
    D23 = p.m_h * p.d_h * p.l_h * sf
    return D11, D22, D33, D12, D13, D23


def coriolis(ce: Any, se: Any, cf: Any, sf: Any, w1: Any, w2: Any, w3: Any, p: RigidBodyParameters) -> tuple:
    """Coriolis and centrifugal torques in N m at the rates w of (q1, eps, phi): the Christoffel symbols of D."""
    z = p.e_h - p.d_h * cf
    radius, height = p.l_h * ce - z * se, p.l_h * se + z * ce  # of the body's centre of mass
    radius_c, height_c = p.l_c * ce - p.d_c * se, p.l_c * se + p.d_c * ce  # of the counterweight, opposite
    D11_e = 2.0 * p.m_h * (p.r**2 * ce * se * sf**2 - radius * height) - 2.0 * p.m_c * radius_c * height_c
    D12_e = p.m_h * sf * (p.d_h * radius - p.r**2 * se * cf)
    D13_e = p.m_h * ((p.r**2 + p.d_h**2) * ce - p.d_h * cf * (p.l_h * se + p.e_h * ce))
    D11_f = 2.0 * p.m_h * sf * (cf * (p.d_h**2 - p.r**2 * ce**2) - p.d_h * se * radius)
    D22_f = 2.0 * p.m_h * sf * (p.d_h * z + p.r**2 * cf)
    D12_f = p.m_h * (p.r**2 * ce * (cf**2 - sf**2) + p.d_h * (cf * height + p.d_h * sf**2 * ce))
    D13_f = -p.m_h * p.d_h * sf * (p.l_h * ce - p.e_h * se)
    D23_f = p.m_h * p.d_h * p.l_h * cf
    return (
        w1 * (D11_e * w2 + D11_f * w3) + D12_e * w2**2 + (D12_f + D13_e) * w2 * w3 + D13_f * w3**2,
        -0.5 * D11_e * w1**2 + (D12_f - D13_e) * w1 * w3 + D22_f * w2 * w3 + D23_f * w3**2,
        -0.5 * D11_f * w1**2 + (D13_e - D12_f) * w1 * w2 - 0.5 * D22_f * w2**2,
    )


def gravity(ce: Any, se: Any, cf: Any, sf: Any, p: RigidBodyParameters) -> tuple:
    """Gradient of the potential energy in N m."""
    out = p.m_h * (p.l_h * ce - (p.e_h - p.d_h * cf) * se) - p.m_c * (p.l_c * ce - p.d_c * se)
    return 0.0, p.g * out, p.g * p.m_h * p.d_h * sf * ce


def generalised_forces(ce: Any, se: Any, cf: Any, sf: Any, v1: Any, v2: Any, p: RigidBodyParameters) -> tuple:
    """Torques in N m of the thrust and drag of the two rotors, which turn in opposite directions."""
    drag = -p.kappa * v2
    return (
        -v1 * sf * (p.l_h * ce - p.e_h * se) + p.l_p * se * v2 + drag * ce * cf,
        p.l_h * cf * v1 + drag * sf,
        p.l_p * v2,
    )


def solve_symmetric(D: tuple, f: tuple) -> tuple:
    """Solve D a = f for a, by cofactors."""
    D11, D22, D33, D12, D13, D23 = D
    f1, f2, f3 = f
    C11, C22, C33 = D22 * D33 - D23**2, D11 * D33 - D13**2, D11 * D22 - D12**2
    C12, C13, C23 = D13 * D23 - D12 * D33, D12 * D23 - D13 * D22, D12 * D13 - D11 * D23
    det = D11 * C11 + D12 * C12 + D13 * C13
    return (
        (C11 * f1 + C12 * f2 + C13 * f3) / det,
        (C12 * f1 + C22 * f2 + C23 * f3) / det,
        (C13 * f1 + C23 * f2 + C33 * f3) / det,
    )


def rigid_dynamics(x: Any, v: Any, p: RigidBodyParameters, sin: Any = np.sin, cos: Any = np.cos) -> tuple:
    """Time derivative of the state x (6, ...) under the virtual input v (2, ...) in N, in the full model.

    Accepts the same types as `heli_gym.model.dynamics`, with matching `sin` and `cos`.
    """
    _, dq1, q2, dq2, q3, dq3 = x
    v1, v2 = v
    ce, se, cf, sf = cos(q2), -sin(q2), cos(q3), sin(q3)  # eps = -q2
    D = mass_matrix(ce, se, cf, sf, p)
    c1, c2, c3 = coriolis(ce, se, cf, sf, dq1, -dq2, dq3, p)
    g1, g2, g3 = gravity(ce, se, cf, sf, p)
    Q1, Q2, Q3 = generalised_forces(ce, se, cf, sf, v1, v2, p)
    ddq1, ddeps, ddq3 = solve_symmetric(D, (Q1 - c1 - g1, Q2 - c2 - g2, Q3 - c3 - g3))
    return dq1, ddq1, dq2, -ddeps, dq3, ddq3


def energy(x: Any, p: RigidBodyParameters, sin: Any = np.sin, cos: Any = np.cos) -> Any:
    """Kinetic and potential energy in J of the state x (6, ...); potential energy is zero at the pivot's height."""
    _, w1, q2, dq2, q3, w3 = x
    w2 = -dq2
    ce, se, cf, sf = cos(q2), -sin(q2), cos(q3), sin(q3)
    D11, D22, D33, D12, D13, D23 = mass_matrix(ce, se, cf, sf, p)
    kinetic = 0.5 * (D11 * w1**2 + D22 * w2**2 + D33 * w3**2) + D12 * w1 * w2 + D13 * w1 * w3 + D23 * w2 * w3
    body, counterweight = p.l_h * se + (p.e_h - p.d_h * cf) * ce, -p.l_c * se - p.d_c * ce
    return kinetic + p.g * (p.m_h * body + p.m_c * counterweight)


def mjcf(p: RigidBodyParameters) -> str:
    """MuJoCo model of the rig: qpos and qvel are q and dq with the same signs, ctrl the thrusts (front, back) in N."""
    # The inertia of a point mass is zero; MuJoCo rejects less than 1e-15 kg m² about any axis.
    nil, roll = "2e-15", repr(p.m_h * p.r**2)
    return f"""\
<!-- Written by python -m heli_gym.rigid_body.
     qpos is travel, elevation (positive downwards) and pitch in rad; ctrl is the thrust (front, back) in N. -->
<mujoco model="heli">
  <compiler angle="radian"/>
  <option gravity="0 0 {-p.g!r}" timestep="0.001" integrator="RK4"/>
  <default>
    <geom contype="0" conaffinity="0"/>
  </default>
  <worldbody>
    <geom name="post" type="capsule" size="0.02" fromto="0 0 -0.7 0 0 0"/>
    <body name="arm">
      <joint name="travel" axis="0 0 1"/>
      <joint name="elevation" axis="0 1 0"/>
      <inertial pos="{-p.l_c!r} 0 {-p.d_c!r}" mass="{p.m_c!r}" diaginertia="{nil} {nil} {nil}"/>
      <geom name="beam" type="capsule" size="0.01" fromto="{-p.l_c!r} 0 0 {p.l_h!r} 0 0"/>
      <geom name="counterweight" type="sphere" size="0.05" pos="{-p.l_c!r} 0 {-p.d_c!r}"/>
      <body name="body" pos="{p.l_h!r} 0 {p.e_h!r}">
        <joint name="pitch" axis="1 0 0"/>
        <inertial pos="0 0 {-p.d_h!r}" mass="{p.m_h!r}" diaginertia="{roll} {nil} {roll}"/>
        <geom name="frame" type="capsule" size="0.01" fromto="0 {-p.l_p!r} 0 0 {p.l_p!r} 0"/>
        <geom name="front_disc" type="cylinder" size="0.1 0.005" pos="0 {p.l_p!r} 0"/>
        <geom name="back_disc" type="cylinder" size="0.1 0.005" pos="0 {-p.l_p!r} 0"/>
        <site name="front" pos="0 {p.l_p!r} 0"/>
        <site name="back" pos="0 {-p.l_p!r} 0"/>
      </body>
    </body>
  </worldbody>
  <actuator>
    <motor name="front" site="front" gear="0 0 1 0 0 {-p.kappa!r}"/>
    <motor name="back" site="back" gear="0 0 1 0 0 {p.kappa!r}"/>
  </actuator>
</mujoco>
"""


if __name__ == "__main__":
    for variant in VARIANTS:
        with atomic_write(MODELS / f"heli_{variant.lower()}.xml") as file:
            file.write(mjcf(solve_rigid_body(variant)).encode())
