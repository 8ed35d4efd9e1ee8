"""Figs. 2 to 9 of the paper, and the numbers in its text."""

from typing import Any

import numpy as np

from heli_gym.baselines.evaluation import figures
from heli_gym.baselines.paper.normal_form import v2_bounds
from heli_gym.baselines.paper.tvlqr import riccati_gains
from heli_gym.trajectory import Maneuver, Trajectory


def paper_numbers(unconstrained: Trajectory, constrained: Trajectory, maneuver: Maneuver) -> list[dict[str, Any]]:
    """Numbers in the paper's text on the maneuver, with the values that this code computes."""
    p, limits = maneuver.parameters, maneuver.limits
    f = maneuver.rig.thrust_bounds(limits.u)
    window = f"{limits.u_min:g} to {limits.u_max:g} V"
    pitch_window = f"within ±{np.degrees(limits.pitch_max):g}°"

    def pitch(trajectory):
        return f"{np.degrees(trajectory.x[4].min()):.2f}° to {np.degrees(trajectory.x[4].max()):.2f}°"

    def voltages(trajectory):
        return f"{trajectory.u.min():.2f} to {trajectory.u.max():.2f} V"

    statements = [
        ("v2± of (18), Section III-D", f"±{figures.PAPER_V2} N", f"±{v2_bounds(f)[1]:.4f} N"),
        ("|a3|/b3 of (43)", f"{figures.PAPER_LEAST_V2} N", f"{abs(p.a3) / p.b3:.4f} N"),
        ("duration T of (8)", f"{maneuver.duration:g} s", f"{constrained.duration:g} s"),
        ("pitch without constraints, Fig. 4", f"leaves ±{np.degrees(limits.pitch_max):g}°", pitch(unconstrained)),
        ("voltages without constraints, Fig. 4", f"both exceed {limits.u_max:g} V", voltages(unconstrained)),
        ("pitch with constraints, Fig. 8", pitch_window, pitch(constrained)),
        ("voltages with constraints, Fig. 8", f"within {window}", voltages(constrained)),
    ]
    return [{"what": what, "paper": paper, "here": here} for what, paper, here in statements]


def paper_figures(unconstrained: Trajectory, constrained: Trajectory) -> dict[str, Any]:
    """Figs. 2 to 9, of the paper's rig and maneuver, by name."""
    parameters, limits = Maneuver().parameters, Maneuver().limits
    return {
        "fig02-thrust-map": figures.thrust_map(parameters),
        "fig04-unconstrained": figures.feedforward(unconstrained, parameters, "Fig. 4: without constraints"),
        "fig05-input-constraints": figures.input_constraints(limits, parameters),
        "fig06-smooth-saturation": figures.smooth_saturation(limits.pitch),
        "fig07-ramp-saturation": figures.ramp_saturation(),
        "fig08-constrained": figures.feedforward(constrained, parameters, "Fig. 8: with constraints"),
        "fig09-gains": figures.gains(riccati_gains(constrained)),
    }
