"""Cascaded loops without an observer: PD and PID, common on laboratory rigs, and flatness-based tracking."""

from dataclasses import dataclass, field

import numpy as np

from heli_gym.baselines.control.estimation import least_lift
from heli_gym.baselines.control.protocol import StatefulPolicy, expand_batch_dims, step_index
from heli_gym.baselines.control.weights import FLAT, PD, CascadeGains
from heli_gym.model import dynamics, fan_thrusts, inverse_dynamics, thrust_vector, virtual_input
from heli_gym.parameters import AMPLIFIER_LIMITS
from heli_gym.rig import Rig
from heli_gym.task import control_grid
from heli_gym.trajectory import Trajectory


@dataclass(eq=False)
class CascadePolicy(StatefulPolicy):
    """Cascade: travel commands pitch, pitch commands the thrust difference, elevation commands the thrust sum.

    Without `flat`, PD and PID loops act about hover, with no feedforward (Quanser, "3-DOF Helicopter: laboratory
    manual", 2012; Åström and Murray, Feedback Systems, 2nd ed., Section 11.3). With `flat`, travel and elevation are
    flat outputs: the loops add to the reference's accelerations, and (3) is inverted at the measured state (Kiefer,
    Kugi, Kemmetmüller, "Modeling and flatness-based control of a 3DOF helicopter laboratory experiment", NOLCOS 2004).

    x (6, K + 1) and accelerations (3, K + 1) are the reference's on the control grid. The memory is the integral (...)
    of the elevation error in rad s.
    """

    x: np.ndarray
    accelerations: np.ndarray
    rig: Rig
    gains: CascadeGains
    flat: bool
    pitch_limits: tuple[float, float]
    control_period: float
    voltage_limits: tuple[float, float] = AMPLIFIER_LIMITS
    memory: np.ndarray | None = field(default=None, init=False, repr=False)

    @property
    def reference_states(self) -> np.ndarray:
        """Reference states (6, K + 1) on the control grid; `fly` checks them."""
        return self.x

    def init(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        """Zero integral (...) of the elevation error."""
        return np.zeros(measurement.shape[1:])

    def step(self, memory: np.ndarray, t: float | np.ndarray, measurement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        k = step_index(t, self.control_period, self.x.shape[1] - 1)
        p, g = self.rig.parameters, self.gains
        reference = expand_batch_dims(self.x[:, k], measurement)
        error = measurement - reference
        ddq1 = -g.travel * error[0] - g.travel_rate * error[1]
        ddq2 = -g.elevation * error[2] - g.elevation_rate * error[3] - g.integral * memory
        ddq3 = -g.pitch_rate * error[5]
        level = np.zeros_like(measurement)
        if self.flat:
            wanted = expand_batch_dims(self.accelerations[:, k], measurement)
            ddq1, ddq2, ddq3 = ddq1 + wanted[0], ddq2 + wanted[1], ddq3 + wanted[2]
            point = measurement
        else:
            level[2] = measurement[2]
            ddq3 = -g.pitch_rate * measurement[5]
            point = level
        across, upright = thrust_vector(point, ddq1, ddq2, p)
        tilt = np.clip(np.arctan2(across, np.maximum(upright, least_lift(p))), *self.pitch_limits)
        ddq3 = ddq3 - g.pitch * (measurement[4] - tilt)
        if self.flat:
            v1, v2 = inverse_dynamics(measurement, ddq2, ddq3, p)
        else:
            v1, v2 = inverse_dynamics(level, ddq2, ddq3, p)
        u = self.rig.voltage(fan_thrusts((v1, v2)))
        saturated = (np.clip(u, *self.voltage_limits) != u).any(axis=0)
        return u, memory + self.control_period * np.where(saturated, 0.0, error[2])


def cascade(reference: Trajectory, control_period: float, rig: Rig, gains: CascadeGains, flat: bool) -> CascadePolicy:
    """Make a cascade for a reference."""
    x, u = control_grid(reference, control_period)
    accelerations = np.stack(dynamics(x, virtual_input(rig.thrust(u)), rig.parameters)[1::2])
    limits = reference.limits.pitch
    return CascadePolicy(x, accelerations, rig, gains, flat, limits, control_period, rig.voltage_limits)


def pd_cascade(reference: Trajectory, control_period: float, rig: Rig, weights: CascadeGains = PD) -> CascadePolicy:
    """Cascade of PD loops for travel and pitch and a PID loop for elevation about hover, without feedforward."""
    return cascade(reference, control_period, rig, weights, flat=False)


def flatness(reference: Trajectory, control_period: float, rig: Rig, weights: CascadeGains = FLAT) -> CascadePolicy:
    """Flatness-based tracking: exact linearisation of travel and elevation around an inner pitch loop."""
    return cascade(reference, control_period, rig, weights, flat=True)
