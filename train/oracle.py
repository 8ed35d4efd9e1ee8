"""Oracle: lower bound of the tracking error, with knowledge of each plant's draw.

For each drawn helicopter, direct multiple shooting (CasADi and IPOPT, extra `ocp`) minimises the errors of travel and
elevation over the whole maneuver, from the actual start and with the actual rotors, friction, delay and body. No
controller has this knowledge. The environment then flies the optimal voltages in open loop.
"""

from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from heli_gym.baselines.control.protocol import step_index
from heli_gym.baselines.planning.collocation import import_casadi
from heli_gym.model import dynamics, rk4_step, thrust, virtual_input
from heli_gym.plant import Plant, count_ranges, rotor_curves, with_friction_and_disturbances
from heli_gym.rigid_body import RigidBodyParameters, rigid_dynamics
from heli_gym.simulation.simulation import SUBSTEP
from heli_gym.task import control_grid
from heli_gym.thrust_map import TableCurve
from heli_gym.trajectory import Trajectory

DEGREE = np.pi / 180.0
EFFORT = 1e-3  # per V² of deviation from the nominal voltages; an error costs 1 per degree²
MARGIN = 5.0 * DEGREE  # rad, distance of the pitch from the end of a flight


class NoOptimum(RuntimeError):
    """Failure of the solver for a drawn plant."""


@dataclass(eq=False)
class OpenLoopVoltages:
    """Open-loop policy with voltages (2, K) in V."""

    u: np.ndarray
    control_period: float

    def reset(self, rng: np.random.Generator) -> None:
        """Do nothing: there is no memory to clear."""

    def __call__(self, t: float | np.ndarray, measurement: np.ndarray) -> np.ndarray:
        return self.u[:, step_index(t, self.control_period, self.u.shape[1] - 1)]


def thrust_curves(plant: Plant) -> tuple:
    """Thrust functions in N of front and back rotor over the rotor speed in V, also for CasADi's symbols.

    Raises ValueError for tables, which do not accept symbols.
    """
    curves = rotor_curves(plant.thrust_map)
    if any(isinstance(curve, TableCurve) for curve in curves):
        raise ValueError("plant: its thrust map must be power curves, not tables, for the oracle")
    return tuple(partial(thrust, parameters=plant.parameters) if curve is None else curve.thrust for curve in curves)


class Oracle:
    """Optimal voltages for draws of a plant with rotor lag and viscous friction, by (3) or as a rigid body.

    Args:
        plant: plant of the draws, which may differ in lag, thrust loss, friction and rig, but not in delay.
        reference: trajectory to track.
        control_period: s, hold of the voltages.
        voltage_limits: (min, max) in V.
        pitch_limit: rad, end of a flight.

    Raises:
        ValueError: for a plant without rotor lag, or with Coulomb friction, a slew limit or disturbances.
        ImportError: if CasADi is missing.
    """

    def __init__(
        self,
        plant: Plant,
        reference: Trajectory,
        control_period: float,
        voltage_limits: tuple[float, float],
        pitch_limit: float,
    ) -> None:
        ca = import_casadi()
        example = plant.at(np.zeros(plant.uniforms)) if plant.uniforms else plant
        if any(example.friction.coulomb) or np.isfinite(example.rotors.slew) or example.disturbances:
            raise ValueError(f"plant = {plant}: must have no Coulomb friction, slew limit or disturbances")
        if not example.rotors.lag > 0.0:
            raise ValueError(f"plant: the lag of its rotors is {example.rotors.lag:g} s; must be more than 0 s")
        if count_ranges(example.parameters) or count_ranges(example.thrust_map):
            raise ValueError(f"plant = {plant}: must have coefficients and a thrust map that are not drawn")
        self.parameters, self.curves = example.parameters, thrust_curves(example)
        self.delay, self.is_rigid = round(example.rotors.delay / control_period), example.rig is not None
        if (
            abs(example.rotors.delay - self.delay * control_period) > 1e-9
            or replace(example, thrust_map=None).is_general
        ):
            raise ValueError(
                f"plant = {plant}: must have a delay of whole control periods, and no effect beyond friction"
            )
        x_ref, u_ref = control_grid(reference, control_period)
        self.x_ref, self.u_ref = x_ref, u_ref[:, :-1]
        steps = self.u_ref.shape[1]
        substeps = int(np.ceil(control_period / SUBSTEP - 1e-9))

        numbers = ca.SX.sym("numbers", len(self.numbers(example)))
        z, u = ca.SX.sym("z", 8), ca.SX.sym("u", 2)
        x, w = tuple(ca.vertsplit(z[:6])), tuple(ca.vertsplit(z[6:]))
        for _ in range(substeps):
            x, w = self.predicted(x, w, tuple(ca.vertsplit(u)), control_period / substeps, ca.vertsplit(numbers), ca)
        step = ca.Function("step", [z, u, numbers], [ca.vertcat(*x, *w)])

        Z, U = ca.MX.sym("Z", 8, steps + 1), ca.MX.sym("U", 2, steps)
        start, before, p = ca.MX.sym("start", 8), ca.MX.sym("before", 2), ca.MX.sym("p", numbers.shape[0])
        arriving = ca.horzcat(*[before] * self.delay, U[:, : steps - self.delay])
        gaps = step.map(steps)(Z[:, :-1], arriving, ca.repmat(p, 1, steps)) - Z[:, 1:]
        error = (Z[[0, 2], 1:] - x_ref[[0, 2], 1:]) / DEGREE
        cost = ca.sumsqr(error) + EFFORT * ca.sumsqr(U - self.u_ref)
        self.solver = ca.nlpsol(
            "oracle",
            "ipopt",
            {
                "x": ca.vertcat(ca.vec(Z), ca.vec(U)),
                "p": ca.vertcat(start, before, p),
                "f": cost,
                "g": ca.vertcat(Z[:, 0] - start, ca.vec(gaps)),
            },
            {"ipopt": {"print_level": 0, "sb": "yes", "max_iter": 500}, "print_time": False},
        )
        most = np.full((8, steps + 1), np.inf)
        most[4] = pitch_limit - MARGIN
        low, high = voltage_limits
        self.lower = np.concatenate((-most.ravel("F"), np.full(2 * steps, low)))
        self.upper = np.concatenate((most.ravel("F"), np.full(2 * steps, high)))
        self.steps = steps

    def numbers(self, plant: Plant) -> list[float]:
        """Parameters of a draw for the solver."""
        rig = list(plant.rig) if self.is_rigid else []
        return [plant.rotors.lag, plant.rotors.thrust_loss, *plant.friction.viscous, *rig]

    def predicted(self, x: tuple, w: tuple, u: tuple, h: float, numbers: list, ca: Any) -> tuple[tuple, tuple]:
        """State and rotor speeds after h seconds: the environment's step, in CasADi's symbols."""
        lag, loss, *rest = numbers
        parameters = self.parameters

        def derivative(x: tuple, v: tuple) -> tuple:
            if self.is_rigid:
                dx = rigid_dynamics(x, v, RigidBodyParameters(*rest[3:]), ca.sin, ca.cos)
            else:
                dx = dynamics(x, v, parameters, ca.sin, ca.cos)
            return with_friction_and_disturbances(x, dx, rest[:3], (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0), ca.cos)

        def turned_to(time: float) -> tuple:
            return tuple(asked + (speed - asked) * ca.exp(-time / lag) for asked, speed in zip(u, w))

        inputs = tuple(
            virtual_input(tuple((1.0 - loss) * curve(speed) for curve, speed in zip(self.curves, turned_to(share * h))))
            for share in (0.0, 0.5, 1.0)
        )
        return rk4_step(derivative, x, inputs, h), turned_to(h)

    def policy(self, plant: Plant, x: np.ndarray, u: np.ndarray, control_period: float) -> OpenLoopVoltages:
        """Policy with the optimal voltages for a drawn plant, from a state x (6,) with rotors at u (2,) in V.

        Raises NoOptimum if the solver fails.
        """
        guess = np.concatenate(
            (np.vstack((self.x_ref, self.u_ref[:, [*range(self.steps), -1]])).ravel("F"), self.u_ref.ravel("F"))
        )
        given = np.concatenate((x, u, u, self.numbers(plant)))
        found = self.found = self.solver(x0=guess, p=given, lbx=self.lower, ubx=self.upper, lbg=0.0, ubg=0.0)
        if not self.solver.stats()["success"]:
            raise NoOptimum(f"no optimal voltages for {plant}: {self.solver.stats()['return_status']}")
        u = np.array(found["x"])[8 * (self.steps + 1) :].reshape(2, self.steps, order="F")
        return OpenLoopVoltages(u, control_period)
