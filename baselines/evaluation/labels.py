"""Name, colour and prerequisites of each policy, common to all tables, figures and pages."""

from typing import NamedTuple

from heli_gym.baselines.control.policies import SAFE

# Palette of Okabe and Ito and three more tones, distinct for colour-blind readers. One colour per family.
BLUE, GREEN, PINK, ORANGE, SKY, RED = "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#D55E00"
VIOLET, BROWN, GREY = "#7A5195", "#8C6D31", "#6B7280"
SPARE = ("#5B3A29", "#1B6F8A", "#9C2C5A", "#4F7F1F", "#7F5F00", "#34508F", "#8F3F8F", "#006D5B")


class Label(NamedTuple):
    """Text and colour of a policy, and its required knowledge apart from the plan."""

    text: str
    colour: str
    needs: str


LABELS = {
    "feedforward+tvlqr": Label("paper's controller", BLUE, "Table I, rates"),
    "open-loop": Label("open loop", GREEN, "Table I"),
    "residual": Label("residual policy", PINK, "as its base; a network trained on draws of lab"),
    "residual-any": Label(
        "residual policy (any maneuver)", PINK, "as its base; a network trained on draws of lab and maneuvers"
    ),
    "residual-rigid": Label("residual policy (rigid)", PINK, "as its base; a network trained on draws of rigid"),
    "kalman-lqr": Label("Kalman LQR", ORANGE, "Table I, middle lag and delay; angles only"),
    "hover-lqr": Label("hover LQR", SKY, "Table I, rates"),
    "lqi": Label("LQR with integral", VIOLET, "Table I, rates"),
    "lag-lqr": Label("lag LQR", BROWN, "Table I, middle lag and delay, rates"),
    "lag-lqi": Label("lag LQR with integral", "#2F4B7C", "Table I, middle lag and delay, rates"),
    "adaptive-mpc": Label("adaptive MPC", RED, "Table I, delay, ranges of the draws; angles only"),
    "adaptive-lqr": Label("adaptive LQR", "#A05195", "Table I, delay, ranges of the draws; angles only"),
    "nmpc": Label("nonlinear MPC", "#3A7D44", "Table I, delay, middles of the draws' ranges; angles only"),
    "linear-mpc": Label("linear MPC", "#2A7F9E", "Table I, delay, middles of the draws' ranges; angles only"),
    "l1-adaptive": Label("L1 adaptive", "#8A8A00", "Table I, middle lag and delay, rates"),
    "gain-scheduled": Label("gain-scheduled LQR", "#665191", "Table I, rates"),
    "flatness": Label("flatness-based", "#B2456E", "Table I, rates"),
    "pd-cascade": Label("PD cascade", "#4D6A6D", "Table I about hover, rates"),
    "oracle": Label("oracle", "#1d242d", "the draw itself"),
    "middle-voltage": Label("middle voltage", GREY, "nothing"),
    "yours": Label("your weights", "#9B6BD6", "Table I, rates; on the live page only"),
    "zero": Label("zero voltage", GREY, "nothing"),
}


def label_of(name: str) -> Label:
    """Label of a policy by its name; the text mentions tuned weights, and an unknown name is its own text.

    An unknown name always has the same one of the spare colours.
    """
    kind, _, plant = name.removesuffix(SAFE).partition("@")
    if kind in LABELS:
        label = LABELS[kind]
        text = f"{label.text}, tuned for {plant}" if plant else label.text
        if not name.endswith(SAFE):
            return label._replace(text=text)
        needs = label.needs if "delay" in label.needs else f"{label.needs}, middle lag and delay"
        return label._replace(text=f"{text}, safety filter", needs=needs)
    return Label(name, SPARE[sum(map(ord, name)) % len(SPARE)], "what its author says")


def colours_of(names: tuple[str, ...] | list[str]) -> list[str]:
    """Distinct colours of policies in one figure: their own, or a spare one if two would be equal."""
    colours: list[str] = []
    for name in names:
        own = label_of(name).colour
        colours.append(own if own not in colours else next((c for c in SPARE if c not in colours), own))
    return colours
