"""Parameters of plants flown by the environments' simulation come back."""

import numpy as np
import pytest

from heli_gym import PLANTS, Plant, Sensors, find_rig
from heli_gym.baselines.identification.estimation import identify
from heli_gym.baselines.identification.simulated import simulate_plant, square_waves


def test_lab_comes_back_with_its_friction_lag_delay_and_loss():
    plant, rig = PLANTS["lab"].draw(np.random.default_rng(3)), find_rig("paper")
    found = identify([simulate_plant(plant, rig, square_waves(), 30.0)], fit_share=1.0)
    unit = (1.0 - plant.rotors.thrust_loss) * rig.parameters.k_plus * found.hover_voltage**2
    p, q = found.parameters, rig.parameters
    np.testing.assert_allclose(p[:6], (q.a1, q.a2, q.a3, unit * q.b1, unit * q.b2, unit * q.b3), rtol=0.04)
    np.testing.assert_allclose(p[6:9], plant.friction.viscous, atol=0.02)
    np.testing.assert_allclose((p.lag, p.delay), (plant.rotors.lag, 0.02), atol=0.006)
    assert abs(p.gyro) < 0.1 and abs(p.pitch_zero) < 0.003


def test_the_plant_of_a_packaged_identified_rig_is_identified_as_that_rig():
    rig = find_rig("fleet/ntnu-f")
    plant = Plant.from_rig(rig, table=None, sensors=Sensors(rig.encoder_counts, zeros=(0.0, 0.0, -rig.sensor_zeros[2])))
    found = identify([simulate_plant(plant, rig, square_waves(), 30.0)], rig, fit_share=1.0).rig("again")
    for name in ("a1", "a2", "b1", "b2", "b3"):
        assert getattr(found.parameters, name) == pytest.approx(getattr(rig.parameters, name), rel=0.05)
    assert found.coupling.gyro == pytest.approx(rig.coupling.gyro, abs=0.1)
    assert found.sensor_zeros[2] == pytest.approx(rig.sensor_zeros[2], abs=0.005)
