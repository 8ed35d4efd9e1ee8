"""Saturation functions: bounds, inverses and derivatives."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from heli_gym.baselines.paper.saturation import ddy2, psi1, psi1_inverse, psi2_bounds, ramp

BOUNDS = [(-0.87, 0.87), (-0.3, 1.2), (-1.4, 0.2)]


def equation_27(xi, low, high):
    return high + (low - high) / (1.0 + np.exp(4.0 / (high - low) * xi))


@pytest.mark.parametrize("bounds", BOUNDS)
def test_psi1_is_equation_27(bounds):
    xi = np.linspace(-10.0, 10.0, 201)
    assert_allclose(psi1(xi, bounds).value, equation_27(xi, *bounds), atol=1e-14)


@pytest.mark.parametrize("bounds", BOUNDS)
def test_the_derivatives_of_psi1_are_those_of_equation_27(bounds):
    xi, step = np.linspace(-4.0, 4.0, 81), 1e-5
    saturation = psi1(xi, bounds)
    assert_allclose(saturation.slope, equation_27(xi + 1e-30j, *bounds).imag / 1e-30, rtol=1e-9)
    for name, derivative in (("slope", "curvature"), ("curvature", "third")):
        later, earlier = (getattr(psi1(xi + h, bounds), name) for h in (step, -step))
        assert_allclose(getattr(saturation, derivative), (later - earlier) / (2.0 * step), atol=2e-7)


@pytest.mark.parametrize("bounds", BOUNDS)
def test_psi1_increases_strictly_and_stays_within_its_bounds(bounds):
    low, high = bounds
    value = psi1(np.linspace(-6.0, 6.0, 500), bounds).value
    assert (np.diff(value) > 0.0).all()
    assert ((low < value) & (value < high)).all()


@pytest.mark.parametrize("bounds", BOUNDS)
def test_psi1_reaches_its_bounds_at_infinity_without_overflow(bounds):
    far = psi1(np.array([-1e6, 1e6]), bounds)
    assert_allclose(far.value, bounds, rtol=1e-15)
    assert_array_equal(far.slope, 0.0)
    assert_array_equal(far.curvature, 0.0)


@pytest.mark.parametrize("bounds", BOUNDS)
@given(share=st.floats(1e-6, 1.0 - 1e-6))
def test_psi1_inverts_its_inverse(bounds, share):
    low, high = bounds
    y = low + share * (high - low)
    assert_allclose(psi1(psi1_inverse(y, bounds), bounds).value, y, atol=1e-14)


@pytest.mark.parametrize("bounds", BOUNDS)
@given(xi=st.floats(-3.0, 3.0))
def test_psi1_inverse_inverts_psi1(bounds, xi):
    assert_allclose(psi1_inverse(psi1(xi, bounds).value, bounds), xi, atol=1e-9)


@given(st.floats(-10.0, 10.0), st.floats(-5.0, 0.0), st.floats(0.0, 5.0))
def test_the_ramp_is_the_identity_between_its_bounds_and_constant_outside(v, low, high):
    expected = low if v < low else high if v > high else v
    assert ramp(v, (low, high)) == expected


@pytest.mark.parametrize("bounds", BOUNDS)
@given(xi1=st.floats(-2.0, 2.0), xi2=st.floats(-3.0, 3.0), low=st.floats(-4.0, -0.1), high=st.floats(0.1, 4.0))
def test_on_the_bounds_of_psi2_the_pitch_accelerates_at_its_bounds(bounds, xi1, xi2, low, high):
    saturation = psi1(xi1, bounds)
    reached = [ddy2(saturation, xi2, bound) for bound in psi2_bounds((low, high), saturation, xi2)]
    assert_allclose(reached, (low, high), rtol=1e-10)


@pytest.mark.parametrize("bounds", BOUNDS)
def test_ddy2_is_the_second_derivative_of_the_saturated_motion(bounds):
    t, h = np.linspace(0.0, 5.0, 51), 1e-4
    before, now, after = (equation_27(np.sin(t + shift), *bounds) for shift in (-h, 0.0, h))
    expected = (after - 2.0 * now + before) / h**2
    assert_allclose(ddy2(psi1(np.sin(t), bounds), np.cos(t), -np.sin(t)), expected, atol=1e-6)
