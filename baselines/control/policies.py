"""Registry of all controllers by name.

To add a controller, write `my_controller(reference, control_period, rig) -> Policy` in a file of this folder and add
one line to `POLICIES`; `heli-evaluate` and the tests of all policies then include it.
"""

import math
from collections.abc import Callable
from functools import partial
from os import PathLike
from typing import Any

from heli_gym.baselines.control.cascade import flatness, pd_cascade
from heli_gym.baselines.control.constant import middle_voltage, zero
from heli_gym.baselines.control.discrete_lqr import Weights
from heli_gym.baselines.control.l1_adaptive import l1_adaptive
from heli_gym.baselines.control.linear_mpc import linear_mpc
from heli_gym.baselines.control.model_based import kalman_lqr, lag_lqi, lag_lqr, lqi
from heli_gym.baselines.control.predictive import adaptive_lqr, adaptive_mpc, nmpc
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.residual import LEARNED, learned_policy
from heli_gym.baselines.control.safety import safety_filter
from heli_gym.baselines.control.scheduled import gain_scheduled
from heli_gym.baselines.control.tracking import feedforward_tvlqr, hover_lqr, open_loop
from heli_gym.baselines.control.weights import WEIGHTS, weights_of
from heli_gym.baselines.paper.tvlqr import LONGEST
from heli_gym.parameters import HelicopterParameters
from heli_gym.rig import Rig, assumed_rig, find_rig, same_dynamics
from heli_gym.trajectory import Trajectory
from heli_gym.validation import is_number, real_array, shown


def load_policy(path: Any, reference: Trajectory, control_period: float, rig: Rig) -> Policy:
    """Load the learned policy at a path without suffix; its base policy comes from this registry."""
    return learned_policy(path, reference, control_period, rig, make_base=make_policy)


def residual(reference: Trajectory, control_period: float, rig: Rig) -> Policy:
    """Packaged learned correction for a rig: the network of the fleet on its rig, the one of `lab` on the paper's."""
    return load_policy(
        LEARNED / ("fleet" if same_dynamics(rig, find_rig("fleet")) else "lab"), reference, control_period, rig
    )


PERIODS = (1e-4, 1.0)  # s, control periods
MOST_STEPS = 4_000_000  # control periods of a reference; more would fill the memory
SAFE = "+safe"  # suffix of the name of a policy behind a `SafetyFilter`
POLICIES: dict[str, Callable[..., Policy]] = {
    "open-loop": open_loop,
    "feedforward+tvlqr": feedforward_tvlqr,
    "lqi": lqi,
    "lag-lqr": lag_lqr,
    "lag-lqi": lag_lqi,
    "kalman-lqr": kalman_lqr,
    "adaptive-lqr": adaptive_lqr,
    "adaptive-mpc": adaptive_mpc,
    "nmpc": nmpc,
    "linear-mpc": linear_mpc,
    "l1-adaptive": l1_adaptive,
    "gain-scheduled": gain_scheduled,
    "flatness": flatness,
    "pd-cascade": pd_cascade,
    "residual": residual,
    "residual-rigid": partial(load_policy, LEARNED / "rigid"),
    "residual-any": partial(load_policy, LEARNED / "any"),
    "hover-lqr": hover_lqr,
    "middle-voltage": middle_voltage,
    "zero": zero,
}


def is_learned(name: str) -> bool:
    """Whether the named policy was learned; it then requires the control period of its training."""
    return name.startswith("residual") or name.removesuffix(SAFE).endswith(".json")


def make_policy(
    name: str,
    reference: Trajectory,
    control_period: float = 0.02,
    parameters: HelicopterParameters | None = None,
    weights: Weights | None = None,
    voltage_limits: tuple[float, float] | None = None,
    rig: str | Rig | None = None,
) -> Policy:
    """Make the policy of a name for a reference.

    Args:
        name: one of `POLICIES`. A suffix "@PLANT" selects the weights that `heli-tune --store` stored for the plant,
            as in "lqi@lab". A name ending in ".json" is the path of a learned policy (module `residual`). The suffix
            "+safe" puts the policy behind a `safety.SafetyFilter`.
        reference: trajectory to track.
        control_period: s.
        parameters: coefficients of (2) and (3) that the policy assumes, instead of a rig.
        weights: design weights in place of those in `WEIGHTS`, of the same type.
        voltage_limits: (min, max) in V of the assumed amplifier; the rig's by default.
        rig: rig that the policy assumes; the reference's by default.

    Raises:
        ValueError: for an unknown name; weights of another type; weights or a network for another rig; a control period
            that is out of range; too long a reference; voltage limits that are not finite and increasing.
    """
    if not isinstance(reference, Trajectory):
        raise ValueError(f"reference = {shown(reference)}: must be a Trajectory")
    if not isinstance(name, str | PathLike):
        raise ValueError(f"name = {shown(name)}: must be one of {', '.join(map(repr, POLICIES))}, or a path")
    shortest, longest = PERIODS
    if not (is_number(control_period) and shortest <= control_period <= longest):
        raise ValueError(
            f"control_period = {shown(control_period)}: must be at least {shortest:g} and at most {longest:g} s"
        )
    most = min(LONGEST, MOST_STEPS * control_period)
    if reference.duration > most:
        raise ValueError(
            f"reference = a Trajectory of {reference.duration:g} s: must be of at most {most:g} s, "
            f"with control_period = {control_period:g}"
        )
    if parameters is not None and rig is not None:
        raise ValueError(f"parameters = {shown(parameters)}: must not be given together with a rig")
    rig = assumed_rig(reference, parameters if rig is None else rig)
    window = real_array(rig.voltage_limits if voltage_limits is None else voltage_limits)
    if window is None or window.shape != (2,) or not -math.inf < window[0] < window[1] < math.inf:
        raise ValueError(f"voltage_limits = {shown(voltage_limits)}: must be two finite voltages, the lower one first")
    limits = float(window[0]), float(window[1])
    if str(name).endswith(SAFE):
        base = make_policy(str(name).removesuffix(SAFE), reference, control_period, None, weights, limits, rig)
        policy: Policy = safety_filter(base, reference, control_period, rig)
    elif str(name).endswith(".json") and weights is None:
        policy = load_policy(name, reference, control_period, rig)
    else:
        kind, _, plant = str(name).partition("@")
        if kind not in POLICIES or ("@" in str(name) and not (plant and kind in WEIGHTS)):
            known = ", ".join(map(repr, POLICIES))
            raise ValueError(f"name = {shown(name)}: must be one of {known}, or the path of a learned policy, .json")
        if weights is None and plant:
            weights = weights_of(name, rig)
        if weights is not None and type(weights) is not type(WEIGHTS.get(kind)):
            needed = type(WEIGHTS[kind]).__name__ if kind in WEIGHTS else "None, because the policy has no weights,"
            raise ValueError(f"weights = {shown(weights)}: must be {needed} for {name!r}")
        policy = POLICIES[kind](reference, control_period, rig, *([] if weights is None else [weights]))
    parts: tuple[Any, ...] = policy, getattr(policy, "base", None)
    for part in parts:
        if hasattr(part, "voltage_limits"):
            part.voltage_limits = limits
    return policy
