"""Controllers as C99: constants, arrays and laws of a policy, from the policy's own numbers.

At the times of the control grid the C code returns the policy's voltages.
"""

import numpy as np

from heli_gym.baselines.control.constant import ConstantVoltage, MiddleVoltage
from heli_gym.baselines.control.estimation import LEAST_LIFT, settling_periods
from heli_gym.baselines.control.export.source import HEADER, TEMPLATES, CSource
from heli_gym.baselines.control.model_based import PREDICTIONS, ModelPolicy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.residual import (
    DISTURBANCE_SCALE,
    FEATURE_CLIP,
    FEATURE_GROUPS,
    INTEGRAL_SCALE,
    Network,
    RecurrentNetwork,
    ResidualPolicy,
)
from heli_gym.baselines.control.tracking import TrackingPolicy
from heli_gym.model import virtual_input
from heli_gym.rig import Rig
from heli_gym.task import TOLERANCE
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustCurve

EXPORTED = ("open-loop", "feedforward+tvlqr", "hover-lqr", "lqi", "lag-lqr", "lag-lqi", "kalman-lqr", "zero")


def c_source(policy: Policy, rig: Rig, name: str, precision: str = "double") -> dict[str, str]:
    """Contents of `heli_controller.h` and `heli_controller.c`, by file name, for a policy on a rig.

    Raises ValueError for an unknown precision and for a policy without a C form.
    """
    source, title = CSource(precision), f"{name} for the rig {rig.name}"
    source.use("common.c")
    low, high = getattr(policy, "voltage_limits", rig.voltage_limits)
    core = policy.base if isinstance(policy, ResidualPolicy) else policy
    period = getattr(policy, "control_period", rig.sample_time)
    angles_only = isinstance(policy, ModelPolicy) and policy.observer is not None
    source.define(PERIOD=period, U_MIN=low, U_MAX=high, SAFE_VOLTAGE=min(max(0.0, low), high), ANGLES_ONLY=angles_only)
    add_base(source, core, rig, name)
    if isinstance(policy, ResidualPolicy):
        add_residual(source, policy)
    else:
        source.use("step.c")
    header = HEADER.format(title=title, period=period, real=source.real)
    return {"heli_controller.h": header, "heli_controller.c": source.text(title)}


def add_base(source: CSource, policy: Policy, rig: Rig, name: str) -> None:
    """Add the base policy, without a learned correction. Raises ValueError for a policy without a C form."""
    if isinstance(policy, TrackingPolicy):
        add_thrust_map(source, policy.rig, forward=False)
        source.define(SAMPLES=policy.x.shape[1], ROUNDING_OF_TIME=4.0 * float(np.finfo(source.dtype).eps))
        source.array("STATE", policy.x.T)
        source.array("FEEDFORWARD", policy.v.T)
        source.array("GAIN", policy.gains.reshape(12, -1).T)
        source.use("tracking.c")
    elif isinstance(policy, ModelPolicy):
        add_model_based(source, policy)
    elif isinstance(policy, ConstantVoltage | MiddleVoltage):
        source.define(SAMPLES=2, CONSTANT_VOLTAGE=float(policy(0.0, np.zeros(6))[0]))
        source.use("constant.c")
    else:
        raise ValueError(f"policy = {name!r}: must be one of {', '.join(EXPORTED)}, or a learned correction of these")


def add_model_based(source: CSource, policy: ModelPolicy) -> None:
    """Add observer, predictor and regulator of a `ModelPolicy`."""
    regulator, actuator, rig = policy.regulator, policy.actuator, policy.regulator.rig
    period, p = policy.control_period, rig.parameters
    add_thrust_map(source, rig, forward=True)
    source.define(
        SAMPLES=policy.x.shape[1],
        GAINS=regulator.gains.shape[1],
        DELAY=actuator.delay,
        LAGGING=regulator.lagging,
        INTEGRATING=regulator.integrating,
        OBSERVING=policy.observer is not None,
        LAG=actuator.lag,
        STRETCH=max(1, -(-actuator.delay // PREDICTIONS)),
        **{name.upper(): float(getattr(p, name)) for name in ("a1", "a2", "a3", "b1", "b2", "b3", "c1", "c2", "c3")},
    )
    source.array("STATE", regulator.x.T)
    source.array("VOLTAGE", regulator.u.T)
    source.array("HOLD", np.stack(virtual_input(rig.thrust(regulator.u))).T)
    source.array("FEEDFORWARD", np.stack(virtual_input(rig.thrust(regulator.command))).T)
    source.array("GAIN", regulator.gains.reshape(-1, policy.x.shape[1]).T)
    source.use("model_based.c")
    if policy.observer is not None:
        pitch_min, pitch_max = regulator.pitch_limits
        source.define(
            SETTLING=settling_periods(period),
            PITCH_MIN=pitch_min,
            PITCH_MAX=pitch_max,
            LEAST_LIFT=LEAST_LIFT * -p.a2 / p.b2,
        )
        source.array("OBSERVER", policy.observer.gains.reshape(27, -1).T)
        source.use("accommodate.c")
    source.use("regulate.c")


def add_thrust_map(source: CSource, rig: Rig, forward: bool) -> None:
    """Add the functions `front_voltage` and `back_voltage`; with `forward` their inverses too."""
    for rotor in ("front", "back"):
        curve = getattr(rig.thrust_map, rotor)
        source.code.append(thrust_curve(source, rotor, curve, forward))


def thrust_curve(source: CSource, rotor: str, curve: ThrustCurve, forward: bool) -> str:
    """C functions of one rotor's thrust curve."""
    if isinstance(curve, TableCurve):
        upper, points = rotor.upper(), len(curve.voltages)
        below, above = curve.end_slopes
        rounding = 4.0 * np.finfo(source.dtype).eps * max(map(abs, curve.voltages))
        source.define(**{f"{upper}_POINTS": points, f"{upper}_BELOW": below, f"{upper}_ABOVE": above})
        source.define(ROUNDING=rounding)
        source.array(f"{upper}_VOLTAGES", curve.voltages)
        source.array(f"{upper}_THRUSTS", curve.thrusts)
        source.array(f"{upper}_CUBIC", curve.cubics.c.T)
        return (
            (TEMPLATES / "table_curve.c")
            .read_text(encoding="utf-8")
            .replace("@rotor@", rotor)
            .replace("@ROTOR@", upper)
        )
    assert isinstance(curve, PowerCurve)
    number, zone = source.number, source.number(curve.dead_zone)

    def power(value: str, exponent: float) -> str:
        known = {0.5: f"SQRT({value})", 1.0: value, 2.0: f"({value}) * ({value})"}
        return known.get(exponent, f"POW({value}, {number(exponent)})")

    backward = f"-({power(f'f / {number(curve.k_minus)}', 1.0 / curve.exponent)} + {zone})" if curve.k_minus else "0"
    text = f"""
static real {rotor}_voltage(real f) {{
    if (f > REAL(0.0)) {{
        return {power(f"f / {number(curve.k_plus)}", 1.0 / curve.exponent)} + {zone};
    }}
    return f < REAL(0.0) ? {backward} : f;
}}
"""
    if forward:
        text += f"""
static real {rotor}_thrust(real u) {{
    const real beyond = FABS(u) - {zone};
    if (!(beyond > REAL(0.0))) {{
        return REAL(0.0);
    }}
    return (u > REAL(0.0) ? {number(curve.k_plus)} : {number(curve.k_minus)}) * {power("beyond", curve.exponent)};
}}
"""
    return text


def add_residual(source: CSource, policy: ResidualPolicy) -> None:
    """Add the learned correction. Raises ValueError for a network or a base without a C form."""
    network = policy.network
    head = network.head if isinstance(network, RecurrentNetwork) else network
    if not isinstance(head, Network):
        raise ValueError(f"policy: its network must be one that C can express, and {type(network).__name__} is not")
    on_model = isinstance(policy.base, ModelPolicy)
    groups = {group for group in policy.feature_groups if group != "estimate" or on_model}
    inputs = (network.weight_input if isinstance(network, RecurrentNetwork) else head.weights[0]).shape[1]
    hidden = network.size if isinstance(network, RecurrentNetwork) else 1
    corrects = isinstance(policy.base, ModelPolicy) and policy.scale > 0.0
    source.define(
        SCALE=policy.scale,
        SATURATED_FIRST=policy.law == "saturated",
        CORRECTS_MODEL=corrects,
        PAST=max(policy.past_steps),
        FEATURES=inputs,
        RECURRENT=isinstance(network, RecurrentNetwork),
        HIDDEN=hidden,
        WIDEST=max(inputs, hidden, *(len(bias) for bias in head.biases)),
        FEATURE_CLIP=FEATURE_CLIP,
        INTEGRAL_SCALE=INTEGRAL_SCALE,
        DISTURBANCE_SCALE=DISTURBANCE_SCALE,
        PREVIEWED=len(policy.preview),
        **{f"SEES_{group.upper()}": group in groups for group in FEATURE_GROUPS},
    )
    source.settings["TOLERANCE"] = f"{{{', '.join(map(source.number, TOLERANCE))}}}"
    source.settings["PAST_STEPS"] = f"{{{', '.join(map(str, policy.past_steps))}}}"
    if isinstance(policy.base, ConstantVoltage | MiddleVoltage):
        raise ValueError("policy: its base must follow a reference to be exported")
    if "voltages" in groups:
        source.array("NOMINAL", policy.u.T)
    if "preview" in groups:
        source.array("PREVIEW", policy.preview.T)
    if isinstance(network, RecurrentNetwork):
        source.array("CELL_INPUT", network.weight_input.T.ravel())
        source.array("CELL_HIDDEN", network.weight_hidden.T.ravel())
        source.array("CELL_INPUT_BIAS", network.bias_input)
        source.array("CELL_HIDDEN_BIAS", network.bias_hidden)
    lines = []
    source.use("residual.c")
    if isinstance(network, RecurrentNetwork):
        lines += ["    recur(a);", "    for (int i = 0; i < HIDDEN; i++) {", "        a[i] = seen.hidden[i];", "    }"]
    for layer, (weight, bias) in enumerate(zip(head.weights, head.biases)):
        outputs, width = weight.shape
        source.array(f"WEIGHT_{layer}", weight.T.ravel())
        source.array(f"BIAS_{layer}", bias)
        squashed = layer < len(head.weights) - 1 or head.tanh_output
        lines += [
            f"    affine(WEIGHT_{layer}, BIAS_{layer}, a, {width}, {outputs}, b);",
            f"    for (int i = 0; i < {outputs}; i++) {{",
            f"        a[i] = {'TANH(b[i])' if squashed else 'b[i]'};",
            "    }",
        ]
    body = "\n".join(lines)
    function = f"\n/* In place: features to actions. */\nstatic void network(real *a, real *b) {{\n{body}\n}}\n"
    source.code[-1] = source.code[-1].replace("\nvoid heli_reset", f"{function}\nvoid heli_reset", 1)
