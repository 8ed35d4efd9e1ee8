"""Lead compensation of rotors with lag and dead time: voltage commands for a plan."""

import numpy as np

from heli_gym.trajectory import Trajectory


def lead_voltages(plan: Trajectory, lag: float | None = None, delay: float | None = None) -> Trajectory:
    """The plan with its voltages replaced by open-loop commands for rotors with a first-order lag and a dead time.

    The rotors should turn at the plan's voltages w, so the command is w + lag dw/dt, a dead time earlier, within the
    amplifier's limits. Commands before the start are missing, a small error for a plan with a smooth start. A feedback
    still takes the original plan as its reference.

    Args:
        plan: as `plan` returns it.
        lag: time constant in s; the rig's nominal one by default.
        delay: dead time in s; the rig's nominal one by default.

    Raises:
        ValueError: if lag or delay is negative or not finite.
    """
    lag, delay = plan.rig.lag if lag is None else lag, plan.rig.delay if delay is None else delay
    for name, value in (("lag", lag), ("delay", delay)):
        if not (np.isfinite(value) and value >= 0.0):
            raise ValueError(f"{name} = {value!r}: must be at least 0 s and finite")
    rates = np.gradient(plan.u, plan.t, axis=1)
    commands = [
        np.interp(plan.t + delay, plan.t, w) + lag * np.interp(plan.t + delay, plan.t, dw, right=0.0)
        for w, dw in zip(plan.u, rates)
    ]
    return Trajectory(plan.t, plan.x, np.clip(commands, *plan.rig.voltage_limits), plan.limits, plan.rig)
