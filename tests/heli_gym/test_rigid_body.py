"""The full rigid body against a derivation from point masses, MuJoCo, its energy, and equation (3)."""

import math

import mujoco
import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym import HelicopterParameters
from heli_gym.model import fan_thrusts
from heli_gym.rigid_body import (
    MODELS,
    VARIANTS,
    coriolis,
    energy,
    generalised_forces,
    gravity,
    mass_matrix,
    mjcf,
    rigid_dynamics,
    solve_rigid_body,
)

TABLE_I = HelicopterParameters()
RIGS = {variant: solve_rigid_body(variant) for variant in VARIANTS}
HOVER = np.array([-TABLE_I.a2 / TABLE_I.b2, 0.0])
RNG = np.random.default_rng(3)
STATES = RNG.uniform(-1.0, 1.0, (6, 1000)) * np.array([[math.pi], [3.0], [1.2], [3.0], [1.4], [6.0]])
INPUTS = RNG.uniform(-1.0, 1.0, (2, 1000)) * np.array([[1.5], [1.0]])

both_rigs = pytest.mark.parametrize("p", RIGS.values(), ids=RIGS)


def relative_error(value, reference):
    """Of vectors (n, N), each against the largest component of its reference."""
    return np.max(np.abs(value - reference) / np.max(np.abs(reference), axis=0))


def symmetric(D):
    D11, D22, D33, D12, D13, D23 = D
    return np.array([[D11, D12, D13], [D12, D22, D23], [D13, D23, D33]])


def level(elevation, pitch):
    """Cosines and sines of eps = -q2 and of phi."""
    return np.cos(elevation), -np.sin(elevation), np.cos(pitch), np.sin(pitch)


@pytest.fixture(scope="module")
def lagrange():
    """M(q), h(q, dq) and Q(q, v) of M ddq + h = Q, from the positions of the masses and of the rotors.

    In the paper's own coordinates: the right-handed turn by q2 about y takes the arm downwards.
    """
    p = sp.symbols("l_h l_p l_c g m_h m_c r d_h d_c e_h kappa")
    l_h, l_p, l_c, g, m_h, m_c, r, d_h, d_c, e_h, kappa = p
    q, dq, v = sp.Matrix(sp.symbols("q1:4")), sp.Matrix(sp.symbols("w1:4")), sp.symbols("v1:3")
    arm = sp.rot_ccw_axis3(q[0]) * sp.rot_ccw_axis2(q[1])
    body = arm * sp.rot_ccw_axis1(q[2])

    def on_body(y, z):
        return arm * sp.Matrix([l_h, 0, e_h]) + body * sp.Matrix([0, y, z])

    masses = [(m_c, arm * sp.Matrix([-l_c, 0, -d_c])), (m_h / 2, on_body(r, -d_h)), (m_h / 2, on_body(-r, -d_h))]
    kinetic = sum(m / 2 * (at.jacobian(q) * dq).dot(at.jacobian(q) * dq) for m, at in masses)
    potential = sum(m * g * at[2] for m, at in masses)
    momentum = sp.Matrix([kinetic]).jacobian(dq).T
    M = momentum.jacobian(dq)
    h = momentum.jacobian(q) * dq - sp.Matrix([kinetic - potential]).jacobian(q).T

    # Virtual work: thrusts along the body's z at the rotors, and the drag torques about it.
    up = body[:, 2]
    turn = sp.Matrix.hstack(sp.Matrix([0, 0, 1]), arm[:, 1], arm[:, 0])  # angular velocity of the body = turn dq
    front, back = fan_thrusts(v)
    Q = on_body(l_p, 0).jacobian(q).T * up * front + on_body(-l_p, 0).jacobian(q).T * up * back
    Q += turn.T * up * kappa * (back - front)
    return sp.lambdify([*q, *dq, *v, *p], [M, h, Q], "numpy", cse=True)


@both_rigs
def test_the_equations_of_motion_are_those_of_lagrange(lagrange, p):
    expected = np.empty((3, STATES.shape[1]))
    for k, (x, v) in enumerate(zip(STATES.T, INPUTS.T)):
        M, h, Q = lagrange(*x[0::2], *x[1::2], *v, *p)
        expected[:, k] = np.linalg.solve(M, Q - h)[:, 0]
    derivative = rigid_dynamics(STATES, INPUTS, p)
    assert relative_error(np.stack(derivative[1::2]), expected) < 1e-12
    assert_array_equal(np.stack(derivative[0::2]), STATES[1::2])


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_accelerations_are_those_of_mujoco_on_the_packaged_model(variant):
    model = mujoco.MjModel.from_xml_path(str(MODELS / f"heli_{variant.lower()}.xml"))
    data = mujoco.MjData(model)
    expected = np.empty((3, STATES.shape[1]))
    for k, (x, v) in enumerate(zip(STATES.T, INPUTS.T)):
        data.qpos, data.qvel, data.ctrl = x[0::2], x[1::2], fan_thrusts(v)
        mujoco.mj_forward(model, data)
        expected[:, k] = data.qacc
    assert relative_error(np.stack(rigid_dynamics(STATES, INPUTS, RIGS[variant])[1::2]), expected) < 1e-10


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_packaged_mujoco_models_are_those_of_table_i(variant):
    assert (MODELS / f"heli_{variant.lower()}.xml").read_text(encoding="utf-8") == mjcf(RIGS[variant])


@both_rigs
def test_the_mass_matrix_is_positive_definite(p):
    D = symmetric(np.broadcast_arrays(*mass_matrix(*level(*STATES[2::2]), p)))
    assert np.linalg.eigvalsh(D.transpose(2, 0, 1)).min() > 1e-3


@both_rigs
def test_coriolis_torques_do_the_work_that_the_kinetic_energy_takes_up(p):
    """For Christoffel symbols dD/dt - 2 C is skew, so that dq' (C dq) = dq' (dD/dt) dq / 2."""
    w = np.stack((STATES[1], -STATES[3], STATES[5]))
    angles, rates, step = STATES[2::2].astype(complex), STATES[3::2], 1e-30
    rate_of_D = symmetric(np.broadcast_arrays(*mass_matrix(*level(*(angles + 1j * step * rates)), p))).imag / step
    power = np.einsum("ik,ijk,jk->k", w, rate_of_D, w) / 2.0
    assert_allclose(np.sum(w * coriolis(*level(*STATES[2::2]), *w, p), axis=0), power, rtol=1e-10, atol=1e-12)


@both_rigs
def test_free_motion_conserves_energy(p):
    def derivative(x):
        return rigid_dynamics(x, (0.0, 0.0), p, math.sin, math.cos)

    x, dt = (0.0, 2.0, 0.5, -1.0, 1.0, 4.0), 1e-3
    start = energy(x, p)
    drift = 0.0
    for _ in range(10_000):
        d1 = derivative(x)
        d2 = derivative([a + 0.5 * dt * b for a, b in zip(x, d1)])
        d3 = derivative([a + 0.5 * dt * b for a, b in zip(x, d2)])
        d4 = derivative([a + dt * b for a, b in zip(x, d3)])
        x = tuple(a + dt / 6.0 * (b + 2.0 * (c + d) + e) for a, b, c, d, e in zip(x, d1, d2, d3, d4))
        drift = max(drift, abs(energy(x, p, math.sin, math.cos) - start))
    assert drift < 1e-8 * abs(start)


@both_rigs
def test_the_power_of_the_thrusts_is_the_rate_of_the_energy(p):
    step = 1e-30
    moved = STATES + 1j * step * np.stack(rigid_dynamics(STATES, INPUTS, p))
    Q = generalised_forces(*level(*STATES[2::2]), *INPUTS, p)
    power = STATES[1] * Q[0] - STATES[3] * Q[1] + STATES[5] * Q[2]
    assert_allclose(energy(moved, p).imag / step, power, rtol=1e-9, atol=1e-10)


@both_rigs
def test_level_hover_is_an_equilibrium(p):
    assert_allclose(rigid_dynamics(np.zeros(6), HOVER, p), 0.0, atol=1e-14)


def axes_alone(x, v, p):
    """Accelerations (travel, elevation, pitch) at rest, of each axis while the other two are held."""
    angles = level(x[2], x[4])
    D11, D22, D33, *_ = mass_matrix(*angles, p)
    f1, f2, f3 = np.array(generalised_forces(*angles, *v, p)) - np.array(gravity(*angles, p))
    return np.array([f1 / D11, -f2 / D22, f3 / D33])


def released(x, v, p):
    return np.array(rigid_dynamics(x, v, p)[1::2])


def coefficients(accelerations, p):
    """(a1, a2, a3, b1, b2, b3) of the linearisation about level hover, by complex steps."""

    def slope(i, k):
        z = np.concatenate((np.zeros(6), HOVER)).astype(complex)
        z[k] += 1e-30j
        return accelerations(z[:6], z[6:], p)[i].imag / 1e-30

    a2 = accelerations(np.zeros(6), np.zeros(2), p)[1]
    return np.array([slope(1, 2), a2, slope(2, 4), slope(0, 4) / HOVER[0], slope(1, 6), slope(2, 7)])


@both_rigs
def test_each_axis_alone_has_the_coefficients_of_table_i_at_hover(p):
    assert_allclose(coefficients(axes_alone, p), TABLE_I[2:8], rtol=1e-13)


@both_rigs
def test_inertial_coupling_at_hover_is_at_most_2_6_percent_of_table_i(p):
    change = coefficients(released, p) / TABLE_I[2:8] - 1.0
    assert_allclose(change, [0.0, 0.0, -0.0258, -0.0018, 0.0, 0.0002], atol=5e-5)


@both_rigs
def test_elevation_without_pitch_and_motion_is_equation_3_at_any_elevation(p):
    q2, v1 = STATES[2], INPUTS[0]
    x = np.zeros_like(STATES)
    x[2] = q2
    t = TABLE_I
    expected = t.a1 * np.sin(q2) + t.a2 * np.cos(q2) + t.b2 * v1
    assert_allclose(rigid_dynamics(x, np.stack((v1, 0.0 * v1)), p)[3], expected, rtol=1e-11, atol=1e-13)


def test_the_rigs_are_those_of_the_specification_to_the_digits_it_gives():
    for variant, d_c, e_h in (("A", 0.0779, 0.0176), ("B", -0.0024, -0.0901)):
        p = RIGS[variant]
        assert_allclose((p.m_h, p.m_c, p.r, p.d_c, p.e_h), (1.3666, 1.8339, 0.1677, d_c, e_h), rtol=0.0, atol=5e-5)
        assert_allclose(p.d_h, 0.00153, rtol=0.0, atol=5e-6)


def test_the_variants_differ_in_the_sign_of_the_centrifugal_lift():
    turning = np.array([0.0, 1.0, 0.0, 0.0, 0.0, 0.0])
    lift = [-rigid_dynamics(turning, HOVER, RIGS[variant])[3] for variant in VARIANTS]
    assert_allclose(lift, [-0.08, 0.08], atol=0.01)


@both_rigs
def test_the_centrifugal_pitching_moment_at_40_deg_and_1_3_rad_per_s_is_0_8_rad_per_s2(p):
    turning = np.array([0.0, 1.3, 0.0, 0.0, math.radians(40.0), 0.0])
    at_rest = turning * np.array([1.0, 0.0, 1.0, 1.0, 1.0, 1.0])
    moment = rigid_dynamics(turning, HOVER, p)[5] - rigid_dynamics(at_rest, HOVER, p)[5]
    assert moment == pytest.approx(-0.8, abs=0.05)


def test_other_tables_are_solved_too():
    table = TABLE_I._replace(a1=-1.0, a2=0.35, b1=-0.65, b2=-0.64, b3=4.4)
    for variant in VARIANTS:
        p = solve_rigid_body(variant, table, l_c=0.5)
        assert_allclose(axes_alone(np.zeros(6), (0.0, 1.0), p)[2], table.b3, rtol=1e-13)
        assert_allclose(axes_alone(np.zeros(6), (1.0, 0.0), p)[1], table.a2 + table.b2, rtol=1e-13)
        x = np.array([0.0, 0.0, math.pi / 2, 0.0, 0.0, 0.0])
        assert_allclose(axes_alone(x, (0.0, 0.0), p)[1], table.a1, rtol=1e-13)


def test_a_table_of_arrays_gives_as_many_rigs():
    b3 = np.array([4.4, 4.6276, 4.8])
    fleet = solve_rigid_body("B", TABLE_I._replace(b3=b3))
    x, v = STATES[:, 0], INPUTS[:, 0]
    members = [rigid_dynamics(x, v, solve_rigid_body("B", TABLE_I._replace(b3=float(b)))) for b in b3]
    assert_allclose(
        np.stack(np.broadcast_arrays(*rigid_dynamics(x, v, fleet))), np.transpose(members), rtol=1e-12, atol=1e-12
    )


def test_an_unknown_variant_is_refused():
    with pytest.raises(ValueError, match="variant = 'C'"):
        solve_rigid_body("C")


@pytest.mark.parametrize(
    "table",
    [TABLE_I._replace(b1=0.0), TABLE_I._replace(b1=math.nan), TABLE_I._replace(b1=-0.6), TABLE_I._replace(a1=-9.0)],
)
def test_a_table_that_no_rig_has_is_refused(table):
    with pytest.raises(ValueError, match="HelicopterParameters"):
        solve_rigid_body("A", table)


@both_rigs
def test_a_batch_is_its_members(p):
    batch = np.stack(rigid_dynamics(STATES[:, :50], INPUTS[:, :50], p))
    members = [rigid_dynamics(x, v, p) for x, v in zip(STATES.T[:50], INPUTS.T)]
    assert_allclose(batch, np.transpose(members), rtol=1e-13, atol=1e-13)


def test_python_floats_stay_python_floats():
    derivative = rigid_dynamics(STATES[:, 0].tolist(), INPUTS[:, 0].tolist(), RIGS["A"], math.sin, math.cos)
    assert all(type(value) is float for value in derivative)
    assert all(type(value) is float for value in RIGS["A"])


def test_casadi_runs_the_dynamics_unchanged():
    ca = pytest.importorskip("casadi")
    x, v = ca.SX.sym("x", 6), ca.SX.sym("v", 2)
    f = ca.Function(
        "f", [x, v], [ca.vertcat(*rigid_dynamics(ca.vertsplit(x), ca.vertsplit(v), RIGS["B"], ca.sin, ca.cos))]
    )
    expected = rigid_dynamics(STATES[:, 0], INPUTS[:, 0], RIGS["B"])
    assert_allclose(f(STATES[:, 0], INPUTS[:, 0]).full()[:, 0], expected, rtol=1e-12)
