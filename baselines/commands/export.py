"""`heli-export`: a plan and its controller for the laboratory, as CSV, for Simulink or as C."""

import csv
import io
import shutil
import subprocess
import tempfile
import time
from ctypes import CDLL, c_double, c_float
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import tyro
from rich.console import Console

from heli_gym.baselines.control.constant import ConstantVoltage, MiddleVoltage
from heli_gym.baselines.control.export import EXPORTED, c_source
from heli_gym.baselines.control.model_based import ModelPolicy
from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.control.protocol import Policy
from heli_gym.baselines.control.residual import ResidualPolicy
from heli_gym.baselines.control.tracking import TrackingPolicy
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import find_reference
from heli_gym.rig import Rig, check_same_rig, find_rig
from heli_gym.storage import atomic_write, check_folder
from heli_gym.trajectory import Trajectory

PROGRAM = "heli-export"
STATES = ("travel", "travel_rate", "elevation", "elevation_rate", "pitch", "pitch_rate")
UNITS = ("rad", "rad/s") * 3
EXTRA = ("thrust_sum", "thrust_difference", "travel_integral", "elevation_integral")
TIMED_STEPS = 20000
COMPILE = ("cc", "-std=c99", "-pedantic", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared")


@dataclass
class Args:
    """Write a plan and its controller: reference, feedforward and gains as CSV or .mat, or the controller as C."""

    plan: Annotated[str, tyro.conf.arg(name="PLAN"), tyro.conf.Positional]
    """.npz file of heli-plan, or a packaged reference"""
    policy: str = "feedforward+tvlqr"  # controller; format c also supports learned ones
    format: Literal["csv", "mat", "c"] = "c"
    out: Path = Path("out/export")  # folder
    precision: Literal["double", "single"] = "double"  # precision of the C code
    control_period: float = 0.02  # s
    rig: str | None = None  # name or .toml file; by default the plan's
    force: bool = False  # use a plan even if it is for another rig


@dataclass(frozen=True)
class Controller:
    """Reference, feedforward and gains of a controller on its control grid."""

    t: np.ndarray  # (K,) s
    x: np.ndarray  # (6, K) reference, rad and rad/s
    u: np.ndarray  # (2, K) feedforward, V
    v: np.ndarray  # (2, K) feedforward, N
    K: np.ndarray  # (2, n, K) gains, N per unit of the deviation


def controller_of(policy: Policy, rig: Rig, name: str) -> Controller:
    """Reference, feedforward and gains of a policy. Raises ValueError for a policy with more than these."""
    if isinstance(policy, TrackingPolicy):
        x, v, gains = policy.x, policy.v, policy.gains
        u = rig.voltage((0.5 * (v[0] + v[1]), 0.5 * (v[0] - v[1])))
    elif isinstance(policy, ModelPolicy):
        x, u, gains = policy.regulator.x, policy.regulator.command, policy.regulator.gains
        f = rig.thrust(u)
        v = np.stack((f[0] + f[1], f[0] - f[1]))
    else:
        takes_c = isinstance(policy, ResidualPolicy | ConstantVoltage | MiddleVoltage)
        raise ValueError(
            f"policy = {name!r}: must have a feedforward and gains, as {', '.join(EXPORTED[:-1])}, to be a table"
            + ("; format c takes it" if takes_c else "")
        )
    return Controller(policy.control_period * np.arange(x.shape[1]), x, u, v, gains)


def gain_inputs(controller: Controller, policy: Policy) -> list[str]:
    """Names of the signals behind the columns of the gains."""
    extra: tuple[str, ...] = ()
    if isinstance(policy, ModelPolicy):
        extra = (EXTRA[:2] if policy.regulator.lagging else ()) + (EXTRA[2:] if policy.regulator.integrating else ())
    return [*STATES, *extra][: controller.K.shape[1]]


def csv_text(controller: Controller, inputs: list[str]) -> str:
    """CSV text with one row per sample; the header names signals and units."""
    columns = ["t_s", *(f"{name}_{unit.replace('/', '_per_')}" for name, unit in zip(STATES, UNITS))]
    columns += ["u_front_V", "u_back_V", "v_sum_N", "v_difference_N"]
    columns += [f"K_{row}_{name}" for row in ("sum", "difference") for name in inputs]
    rows = np.concatenate(
        (controller.t[None], controller.x, controller.u, controller.v, controller.K.reshape(-1, len(controller.t)))
    ).T
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([[repr(float(value)) for value in row] for row in rows])
    return buffer.getvalue()


def from_workspace(t: np.ndarray, values: np.ndarray) -> dict[str, Any]:
    """Structure with time for Simulink's From Workspace block, from a signal (n, K) or (m, n, K)."""
    signals: dict[str, Any]
    if values.ndim == 2:
        signals = {"values": values.T, "dimensions": float(len(values))}
    else:
        signals = {"values": values, "dimensions": np.array(values.shape[:2], dtype=float)}
    return {"time": t[:, None], "signals": signals}


def mat_bytes(controller: Controller, inputs: list[str], rig: Rig, policy: str) -> bytes:
    """MATLAB 5 file of `from_workspace` structures."""
    from scipy.io import savemat

    c, buffer = controller, io.BytesIO()
    signals = {"x_ref": c.x, "u_ff": c.u, "v_ff": c.v, "K": c.K}
    content: dict[str, Any] = {name: from_workspace(c.t, values) for name, values in signals.items()}
    content |= {
        "gain_inputs": np.array(inputs, dtype=object),
        "sample_time": float(c.t[1]),
        "voltage_limits": np.array(rig.voltage_limits),
        "rig": rig.to_toml(),
        "policy": policy,
    }
    savemat(buffer, content, do_compression=True, oned_as="column")
    return buffer.getvalue()


README = """\
# {policy} for the rig {rig}

Written by `heli-export`. Reference of {duration:g} s, a sample every {period:g} s.

## Signals

| signal | order | unit |
|---|---|---|
| `y`, `x_ref` | travel, its rate, elevation, its rate, pitch, its rate | rad, rad/s |
| `u`, `u_ff` | front, back | V |
| `v_ff` | thrust sum, thrust difference (front minus back) | N |
| `K` | rows sum and difference; columns {inputs} | N per unit of the column |

Feedback: `v = v_ff - K (y - x_ref)`. {reads}
{columns}
Signs: travel is positive counter-clockwise seen from above; elevation is positive **{elevation}**; pitch is positive
when the front rotor is higher, which more thrust in front brings about; a positive pitch accelerates the travel
{pitch_turns}. Positive thrusts lift.

Zero of elevation: the arm is level. Zero of travel: where the reference starts from 0. The rig's sensors:
angle = sign * (sensor - zero), with the signs {signs} and the zeros {zeros} rad of travel, elevation and pitch, and
{counts} counts per revolution.

## From v to u

The rotors' thrusts are `f_front = (v_sum + v_difference) / 2` and `f_back = (v_sum - v_difference) / 2`. Each goes
through the inverse of its thrust curve and is limited to {low:g} to {high:g} V:

{curves}
{more}
## Rig

```toml
{toml}```
"""

C_NOTES = """
## C

`heli_controller.c` and `heli_controller.h` are C99 in {precision} precision; link with `-lm`. Nothing is allocated.

```c
heli_reset();                 /* before every flight */
heli_step(t, y, u);           /* every {period:g} s: t in s from 0 on, y (6) as above, u (2) in V, saturated */
```

`t` outside the reference holds its ends. {between} A `y` that is no number gives the voltage nearest to zero and
updates nothing but the simulated rotors and state; the next measurement is answered as usual.
"""

PREDICTED = """
In place of `y` stands its prediction over the rig's delay, and the row is that of the time when `u` takes effect.
"""
COLUMNS = {  # what K multiplies after the deviations of the state, by the first one
    "thrust_sum": """
`thrust_sum` and `thrust_difference` multiply the thrusts in N of modelled rotors, which follow `u` with the rig's lag
and delay, less those of the plan's own voltages; `v_ff` leads these by the lag.
""",
    "travel_integral": """
`travel_integral` and `elevation_integral` multiply integrals of `y - x_ref` in rad s, which stand still while `u` is
saturated.
""",
}
ANGLES, ALL = (
    "Of `y` only the angles are read: a Kalman filter estimates the rates.",
    "The rates in `y` are read too: measure them, or filter differences of the angles.",
)

TABLE_NOTES = {
    "csv": "\n`heli_controller.csv` has one row a sample, with signals and units in its header.\n",
    "mat": "\n`heli_controller.mat` holds `x_ref`, `u_ff`, `v_ff` and `K` as structures with time, which Simulink's\n"
    "From Workspace blocks read: `time` (samples x 1), `signals.values`, `signals.dimensions`. `K` is 2 x n.\n",
}


def readme(args: Args, policy: Policy, rig: Rig, reference: Trajectory, inputs: list[str]) -> str:
    """Text of README.md on signals, signs and units."""

    def words(rotor: str) -> str:
        curve = getattr(rig.thrust_map, rotor)
        if hasattr(curve, "voltages"):
            return f"- {rotor}: monotone cubics through the points of the table `[thrust]` below"
        zone = f" + {curve.dead_zone:g} V" if curve.dead_zone else ""
        backward = (
            f"-(f / {curve.k_minus:g})^(1/{curve.exponent:g}){zone.replace('+', '-')}" if curve.k_minus else "0 V"
        )
        forward = f"u = (f / {curve.k_plus:g})^(1/{curve.exponent:g}){zone}"
        return f"- {rotor}: {forward} for f >= 0, and {backward} for f < 0"

    memory = not isinstance(policy, TrackingPolicy)
    between = (
        "Call it once a period: the controller remembers."
        if memory
        else "Between the samples it interpolates linearly."
    )
    notes = TABLE_NOTES.get(args.format) or C_NOTES.format(
        precision=args.precision, period=args.control_period, between=between
    )
    return README.format(
        policy=args.policy,
        pitch_turns="negatively" if rig.parameters.b1 < 0.0 else "positively",
        elevation="down" if rig.parameters.b2 < 0.0 else "up",
        rig=rig.name,
        duration=reference.duration,
        period=args.control_period,
        columns=(PREDICTED if isinstance(policy, ModelPolicy) and policy.actuator.delay else "")
        + "".join(text for name, text in COLUMNS.items() if name in inputs),
        reads=ANGLES if isinstance(policy, ModelPolicy) and policy.observer is not None else ALL,
        inputs=", ".join(inputs) if inputs else "of the base controller",
        signs=rig.sensor_signs,
        zeros=rig.sensor_zeros,
        counts=rig.encoder_counts,
        low=rig.voltage_limits[0],
        high=rig.voltage_limits[1],
        curves="\n".join(map(words, ("front", "back"))),
        more=notes,
        toml=rig.to_toml(),
    )


def export_files(args: Args) -> dict[str, bytes]:
    """Contents of the exported files, by name. Raises ValueError for a policy without an exported form."""
    reference = find_reference(args.plan)
    assert isinstance(reference, Trajectory)
    rig = reference.rig if args.rig is None else find_rig(args.rig)
    if not args.force:
        check_same_rig(f"PLAN = {args.plan!r}", reference.rig, rig, "the one to export for")
    policy = make_policy(args.policy, reference, args.control_period, rig=rig)
    files: dict[str, bytes] = {}
    inputs: list[str] = []
    if isinstance(policy, TrackingPolicy | ModelPolicy):
        inputs = gain_inputs(controller_of(policy, rig, args.policy), policy)
    if args.format == "c":
        files = {name: text.encode() for name, text in c_source(policy, rig, args.policy, args.precision).items()}
    elif args.format == "csv":
        files = {"heli_controller.csv": csv_text(controller_of(policy, rig, args.policy), inputs).encode()}
    else:
        files = {"heli_controller.mat": mat_bytes(controller_of(policy, rig, args.policy), inputs, rig, args.policy)}
    return {**files, "README.md": readme(args, policy, rig, reference, inputs).encode()}


def load_controller(folder: Path, precision: str) -> Any:
    """Compile and load the C code in a folder: the library, and the ctypes type of its numbers.

    Raises RuntimeError with the compiler's message for any error or warning.
    """
    with tempfile.TemporaryDirectory() as build:
        library = Path(build) / "heli_controller.so"
        made = subprocess.run(
            [*COMPILE, str(folder / "heli_controller.c"), "-o", str(library), "-lm"], capture_output=True, text=True
        )
        if made.returncode:
            raise RuntimeError(f"cc: {made.stderr}")
        loaded = CDLL(str(library))
    number = c_double if precision == "double" else c_float
    loaded.heli_step.argtypes = (number, number * 6, number * 2)
    loaded.heli_step.restype = loaded.heli_reset.restype = None
    return loaded, number


def step_time(folder: Path, args: Args) -> float:
    """Time in µs of a call of `heli_step` on this machine, minus the overhead of a call from Python."""
    loaded, number = load_controller(folder, args.precision)
    y, u = (number * 6)(), (number * 2)()
    t = number(1.0)

    def duration(function: Any, *arguments: Any) -> float:
        began = time.perf_counter()
        for _ in range(TIMED_STEPS):
            function(*arguments)
        return (time.perf_counter() - began) / TIMED_STEPS

    loaded.heli_reset()
    return 1e6 * max(duration(loaded.heli_step, t, y, u) - duration(loaded.heli_reset), 0.0)


def main(args: Args | None = None) -> None:
    """Run the command `heli-export`."""
    with command(PROGRAM):
        args = args or parse(Args, PROGRAM)
        console = Console()
        check_folder("out", args.out)
        files = export_files(args)
        announce_replaced(PROGRAM, *(args.out / name for name in files))
        for name, data in files.items():
            with atomic_write(args.out / name) as file:
                file.write(data)
        console.print(f"{args.policy}: {', '.join(files)} in {args.out}")
        if args.format == "c":
            if shutil.which("cc") is None:
                console.print("time per step: not measured, for there is no cc")
            else:
                console.print(f"time per step: {step_time(args.out, args):.2f} µs on this machine")


if __name__ == "__main__":
    main()
