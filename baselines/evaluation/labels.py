"""One name, one colour and one line of prerequisites for each policy, the same in every table, picture and page."""

from typing import NamedTuple

# The palette of Okabe and Ito and three tones more: colour-blind readers can tell them apart. One colour per family.
BLUE, GREEN, PINK, ORANGE, SKY, RED = "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#D55E00"
VIOLET, BROWN, GREY = "#7A5195", "#8C6D31", "#6B7280"
SPARE = ("#5B3A29", "#1B6F8A", "#9C2C5A", "#4F7F1F", "#7F5F00", "#34508F", "#8F3F8F", "#006D5B")


class Label(NamedTuple):
    """How a policy is shown, and what it must know apart from the plan."""

    text: str
    colour: str
    needs: str


LABELS = {
    "feedforward+tvlqr": Label("paper's controller", BLUE, "Table I, rates"),
    "open-loop": Label("open loop", GREEN, "Table I"),
    "residual": Label("residual policy", PINK, "as its base; a network trained on draws of lab"),
    "residual-rigid": Label("residual policy (rigid)", PINK, "as its base; a network trained on draws of rigid"),
    "kalman-lqr": Label("Kalman LQR", ORANGE, "Table I, middle lag, delay, friction; angles only"),
    "hover-lqr": Label("hover LQR", SKY, "Table I, rates"),
    "lqi": Label("LQR with integral", VIOLET, "Table I, rates"),
    "lag-lqr": Label("lag LQR", BROWN, "Table I, middle lag and delay, rates"),
    "lag-lqi": Label("lag LQR with integral", "#2F4B7C", "Table I, middle lag and delay, rates"),
    "adaptive-mpc": Label("adaptive MPC", RED, "Table I, ranges of the draws; angles only"),
    "adaptive-lqr": Label("adaptive LQR", "#A05195", "Table I, ranges of the draws; angles only"),
    "nmpc": Label("nonlinear MPC", "#3A7D44", "Table I, middle lag, delay, friction; angles only"),
    "l1-adaptive": Label("L1 adaptive", "#8A8A00", "Table I, rates"),
    "gain-scheduled": Label("gain-scheduled LQR", "#665191", "Table I, rates"),
    "flatness": Label("flatness-based", "#B2456E", "Table I, rates"),
    "pd-cascade": Label("PD cascade", "#4D6A6D", "the rig's hover voltage, rates"),
    "oracle": Label("oracle", "#1d242d", "the draw itself"),
    "middle-voltage": Label("middle voltage", GREY, "nothing"),
    "zero": Label("zero voltage", GREY, "nothing"),
}


def label_of(name: str) -> Label:
    """The label of a policy by its name; tuned weights are added in words, other names stand for themselves.

    A name that is not in the table has one of the spare colours, always the same.
    """
    kind, _, plant = name.partition("@")
    if kind in LABELS:
        label = LABELS[kind]
        return label._replace(text=f"{label.text}, tuned for {plant}") if plant else label
    return Label(name, SPARE[sum(map(ord, name)) % len(SPARE)], "what its author says")


def colours_of(names: tuple[str, ...] | list[str]) -> list[str]:
    """The colours of policies that are shown together: their own, or where two would be alike, a spare one."""
    colours: list[str] = []
    for name in names:
        own = label_of(name).colour
        colours.append(own if own not in colours else next((c for c in SPARE if c not in colours), own))
    return colours
