"""Do the parameters of simulated rigs come back within their standard errors?

    python benchmarks/recovery.py rigs --logs 100
    python benchmarks/recovery.py lab --logs 100 --duration 30
    python benchmarks/recovery.py rigid --logs 100 --duration 30 [--drag-ratio 0]

Each log is a flight of a draw by the simulation of the environments, with encoders of 8192, 4096 and 4096 counts:
of `lab`, of `rigid`, or of random rigs within the range of the identified ones, with every effect of the model. All of
it is fitted. Prints for each parameter the true mean, the bias (mean error), the errors relative to the standard
errors, and the share of 95 % intervals that hold. For `rigid`, the truth is its linearisation about hover, and the
model does not contain the plant: it lacks the drag torque of the rotors and most products of inertia. For them, the
accelerations that it lacks are printed too.
"""

import argparse
import math
import sys
from dataclasses import replace

import numpy as np
from scipy.signal import lfilter

from heli_gym import PLANTS, Coupling, HelicopterParameters, Plant, PowerCurve, Push, Rig, Sensors, ThrustMap, find_rig
from heli_gym.baselines.identification.estimation import Identification, identify
from heli_gym.baselines.identification.flight_log import ANGLES, FlightLog
from heli_gym.baselines.identification.measured_model import MeasuredParameters
from heli_gym.baselines.identification.simulated import hover_of, random_rig, simulate_plant, square_waves
from heli_gym.model import dynamics, hover_input
from heli_gym.plant import Rotors, with_coupling
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.thrust_map import ThrustCurve

FIRST_SEED = 1000
UNIT = 0.3  # N, thrust of one rotor in hover of the random rigs


def paper_draw(name: str, seed: int, drag_ratio: float | None = None) -> tuple[Plant, Rig, MeasuredParameters, float]:
    """Draw of `lab` or `rigid`, the rig whose hover its controller knows, and true parameters at 1 V.

    `drag_ratio` in m replaces the drawn ratio of drag torque to thrust of a rigid body.
    """
    plant, rig = PLANTS[name].draw(np.random.default_rng(seed)), find_rig("paper")
    if plant.rig is not None and drag_ratio is not None:
        plant = replace(plant, rig=plant.rig._replace(kappa=drag_ratio))
    moments = dict.fromkeys(("centrifugal", "centre", "pitch_spin"), 0.0)
    p, share = rig.parameters, 1.0 - plant.rotors.thrust_loss
    c1, c2, c3 = plant.friction.viscous
    unit = share * p.k_plus  # N at 1 V
    if plant.rig is not None:
        found = about_hover(plant.rig, hover_input(0.0, p))
        p, moments = p._replace(**{key: found[key] for key in ("a3", "b1", "b3")}), {key: found[key] for key in moments}
    true = MeasuredParameters(
        p.a1, p.a2, p.a3, p.b1 * unit, p.b2 * unit, p.b3 * unit, c1, c2, c3, exponent=2.0, lag=plant.rotors.lag,
        delay=plant.rotors.delay, **moments,
    )  # fmt: skip
    return plant, rig, true, 1.0


def about_hover(body: RigidBodyParameters, hover: np.ndarray) -> dict[str, float]:
    """Parameters of the model by name that a rigid body has about level hover with the inputs (2,).

    The product of inertia between travel and pitch makes a3, b1 and b3 differ from the coefficients by axes. No
    parameter of the model stands for the rest (`lacking`): the drag torque of the rotors on travel,
    kappa / l_h b1 v2 cos q2 cos q3, and the products of inertia of a body with its mass at the rotors away from level.
    Travel accelerates pitch by about sin q2 dw1/dt, since a pitch axis that is not level turns with the arm,
    and elevation by D33 / D22 sin q3 cos q3 cos q2 dw1/dt; the rate of pitch acts on travel by
    2 D33 / D11 w3 (w2 cos² q3 cos q2 + w1 sin q3 cos q3 cos² q2).
    """

    def accelerations(w1: float = 0.0, q2: float = 0.0, q3: float = 0.0, v2: float = 0.0) -> np.ndarray:
        dx = rigid_dynamics((0.0, w1, q2, 0.0, q3, 0.0), (hover[0], v2), body)
        return np.array(dx[1::2], dtype=float)

    step = 1e-4
    by_pitch = (accelerations(q3=step) - accelerations(q3=-step)) / (2.0 * step)
    by_input = (accelerations(v2=step) - accelerations(v2=-step)) / (2.0 * step)
    q2 = np.linspace(-0.2, 0.2, 9)
    lift = np.array([accelerations(w1=1.0, q2=q)[1] - accelerations(q2=q)[1] for q in q2])
    # -k sin(q2 - z) cos(q2 - z) is linear in k cos(2 z) and k sin(2 z)
    A = 0.5 * np.column_stack((-np.sin(2.0 * q2), np.cos(2.0 * q2)))
    along, across = np.linalg.lstsq(A, lift, rcond=None)[0]
    spin = accelerations(w1=1.0, q3=0.1) - accelerations(q3=0.1)
    return {
        "a3": by_pitch[2], "b1": by_pitch[0] / hover[0], "b3": by_input[2], "centrifugal": math.hypot(along, across),
        "centre": 0.5 * math.atan2(across, along), "pitch_spin": -spin[2] / (math.sin(0.1) * math.cos(0.1)),
    }  # fmt: skip


def lacking(plant: Plant, rig: Rig, true: MeasuredParameters, log: FlightLog) -> np.ndarray:
    """Accelerations in a log of a rigid body, RMS (3, 3) by axis in rad/s².

    Columns: of the body; of the body less those of the model with the true parameters; the same without drag torque.
    States are those of the log, with smoothed rates, and the friction, which both have, is left out.
    """
    unit, keep = (1.0 - plant.rotors.thrust_loss) * rig.parameters.k_plus, math.exp(-log.sample_time / true.lag)
    lagged = lfilter([1.0 - keep], [1.0, -keep], log.voltages, axis=1, zi=keep * log.voltages[:, :1])[0]
    v = unit * np.array([[1.0, 1.0], [1.0, -1.0]]) @ lagged**2
    x = np.stack((log.angles, log.rates()), axis=1).reshape(6, -1)
    p = HelicopterParameters(0.0, 0.0, *true[:3], *(b / unit for b in true[3:6]))
    coupling = Coupling(true.centrifugal, true.centre, true.pitch_spin)
    model = with_coupling(x, dynamics(x, v, p), np.abs(x[1]), p, coupling)
    body, without_drag = (rigid_dynamics(x, v, one) for one in (plant.rig, plant.rig._replace(kappa=0.0)))
    columns = [np.array(dx[1::2]) for dx in (body, np.subtract(body, model), np.subtract(without_drag, model))]
    return np.sqrt(np.mean(np.square(columns), axis=2)).T


def rig_draw(seed: int) -> tuple[Plant, Rig, MeasuredParameters, float]:
    """Random rig as a plant, as a rig, and its true parameters at its hover voltage."""
    rng = np.random.default_rng(seed)
    p, voltage = random_rig(rng)
    parameters = HelicopterParameters(
        0.0, 0.0, p.a1, p.a2, p.a3, p.b1 / UNIT, p.b2 / UNIT, p.b3 / UNIT, p.c1, p.c2, p.c3
    )
    k = UNIT / voltage**p.exponent
    curves: list[ThrustCurve] = [
        PowerCurve(gain * k, -p.reverse * gain * k, p.exponent) for gain in (1.0 + p.mismatch, 1.0 - p.mismatch)
    ]
    plant = Plant(
        parameters,
        thrust_map=ThrustMap(*curves),
        rotors=Rotors(lag=p.lag, delay=p.delay),
        sensors=Sensors(zeros=(*rng.uniform(0.0, 1e-3, 2), -p.pitch_zero)),
        coupling=Coupling(p.centrifugal, p.centre, p.pitch_spin, p.gyro, p.pitch_speed),
        disturbances=(Push("pitch", p.pitch_trim, 0.0, 1e6),),
    )
    rig = Rig("random", parameters, ThrustMap(*curves), voltage_limits=(-24.0, 24.0))
    assert np.isfinite(hover_of(p, voltage)).all()
    return plant, rig, p, voltage


def errors(true: MeasuredParameters, voltage: float, found: Identification) -> dict[str, tuple[float, float, float]]:
    """True value, error and standard error of each free parameter, in the unit of thrust of the identification."""
    unit = (found.hover_voltage / voltage) ** true.exponent
    scaled = true._replace(b1=true.b1 * unit, b2=true.b2 * unit, b3=true.b3 * unit)
    return {
        name: (getattr(scaled, name), getattr(found.parameters, name) - getattr(scaled, name), error)
        for name, error in found.standard_errors.items()
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plant", choices=("lab", "rigid", "rigs"))
    parser.add_argument("--logs", type=int, default=100)
    parser.add_argument("--duration", type=float, default=40.0, help="s")
    parser.add_argument("--drag-ratio", type=float, help="m, drag torque per thrust of a rotor, for rigid")
    args = parser.parse_args()
    found: dict[str, list[tuple[float, float, float]]] = {}
    lacks: list[np.ndarray] = []
    for seed in range(FIRST_SEED, FIRST_SEED + args.logs):
        plant, rig, true, voltage = (
            rig_draw(seed) if args.plant == "rigs" else paper_draw(args.plant, seed, args.drag_ratio)
        )
        log = simulate_plant(plant, rig, square_waves(), args.duration)
        for name, values in errors(true, voltage, identify([log], rig, fit_share=1.0)).items():
            found.setdefault(name, []).append(values)
        if plant.rig is not None:
            lacks.append(lacking(plant, rig, true, log))
        done = [abs(e) < 1.96 * s for values in found.values() for _, e, s in values]
        print(
            f"{seed - FIRST_SEED + 1} logs: {100.0 * np.mean(done):.1f} % of {len(done)}", file=sys.stderr, flush=True
        )
    print(
        "| parameter | logs | true, mean | bias | errors / standard errors | within 95 % |\n|---|---|---|---|---|---|"
    )
    inside = []
    for name, values in found.items():
        true_values, error, standard = np.array(values).T
        hold = np.abs(error) < 1.96 * standard
        inside += hold.tolist()
        print(
            f"| {name} | {len(values)} | {true_values.mean():.3g} | {error.mean():.2g} | "
            f"{np.sqrt(np.mean((error / standard) ** 2)):.2f} | {100.0 * hold.mean():.0f} % |"
        )
    if lacks:
        print("\n| axis | RMS acceleration, rad/s² | lacking | lacking without drag torque |\n|---|---|---|---|")
        for axis, values in zip(ANGLES, np.sqrt(np.mean(np.square(lacks), axis=0))):
            print(f"| {axis} | " + " | ".join(f"{value:.4f}" for value in values) + " |")
    print(f"\n{args.plant}: of {len(inside)} intervals of {args.logs} logs, {100.0 * np.mean(inside):.1f} % hold")


if __name__ == "__main__":
    main()
