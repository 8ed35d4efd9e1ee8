"""`heli-film`: flights of several policies side by side, as a GIF."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import gymnasium as gym
import numpy as np

from heli_gym.baselines.control.policies import make_policy
from heli_gym.baselines.evaluation.conditions import nominal_rig
from heli_gym.baselines.evaluation.rollout import fly
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.env import Heli3DOFEnv, reference_for
from heli_gym.plant import HELD_OUT_SEED
from heli_gym.rendering import Renderer, RenderState
from heli_gym.rig import PAPER, same_dynamics
from heli_gym.storage import atomic_write, check_folder
from heli_gym.trajectory import Trajectory

COLOURS = 96  # in the palette of the GIF; most are shades of grey
LAST = 2.0  # s, duration of the last picture


@dataclass
class Args:
    """Film policies side by side: flights along a reference from its exact start, on the same draw of a plant."""

    policies: tuple[str, ...] = ("feedforward+tvlqr", "residual")
    """policies, from left to right; on another rig than the paper's, kalman-lqr replaces residual by default"""
    plant: str = "lab"  # plant to fly: nominal, lab, rigid or fleet
    reference: str = "travel-360"  # a packaged reference, or an .npz file of heli-plan
    rig: str | None = None  # rig, a name or a .toml file; by default the plant's
    force: bool = False  # fly a plan even if it is for another rig
    seed: int = HELD_OUT_SEED  # seed of the episode
    width: int = 440  # width of each picture in pixels, a multiple of 8
    frame_time: float = 0.06  # s between pictures, a multiple of 0.01
    out: Path = Path("out/flight.gif")  # the film, a .gif file


def film(flights: Mapping[str, Trajectory], env: Heli3DOFEnv, width: int, frame_time: float) -> list[np.ndarray]:
    """Pictures (H, W, 3), uint8, of flights side by side, every `frame_time` seconds; the last one shows their ends.

    Raises ValueError for an invalid width of `Renderer`, gymnasium.error.DependencyNotInstalled without pygame.
    """
    renderer = Renderer(width)
    end = max(flight.duration for flight in flights.values())
    times = np.minimum(frame_time * np.arange(math.ceil(end / frame_time - 1e-9) + 1), end)
    return [
        np.concatenate(
            [renderer.frame(render_state_at(flight, env, t, title)) for title, flight in flights.items()], axis=1
        )
        for t in times.tolist()
    ]


def render_state_at(flight: Trajectory, env: Heli3DOFEnv, t: float, title: str) -> RenderState:
    """Render state of a flight in an environment at the time t in s, at most its end."""
    reference = env.reference
    over = t > flight.duration
    t = min(t, flight.duration)
    held = max(int(np.searchsorted(flight.t, t, side="right")) - 1, 0)
    state, nominal = flight(t)[0], reference(t)
    return RenderState(
        state=state.tolist(),
        voltage=flight.u[:, held].tolist(),
        reference=nominal[0].tolist(),
        nominal_voltage=nominal[1].tolist(),
        time=t,
        duration=reference.duration,
        travel_start=float(reference.x[0, 0]),
        limits=reference.limits,
        voltage_limits=env.voltage_limits,
        pitch_limit=env.pitch_limit,
        rig=env.rig,
        title=title,
        note=f"ended: pitch beyond {math.degrees(env.pitch_limit):.0f}°" if over else "",
    )


def write_gif(pictures: Sequence[np.ndarray], frame_time: float, path: Path) -> None:
    """Write pictures (H, W, 3), uint8, as an endless GIF with one palette.

    Raises ValueError for an invalid frame time, gymnasium.error.DependencyNotInstalled without Pillow.
    """
    milliseconds = delay(frame_time)
    try:
        from PIL import Image
    except ImportError as error:
        raise gym.error.DependencyNotInstalled(
            'Pillow is not installed: `pip install "heli-gym[eval]"` brings it'
        ) from error
    samples = np.concatenate([picture[::2, ::2] for picture in pictures[:: max(len(pictures) // 12, 1)]])
    palette = Image.fromarray(samples).quantize(COLOURS)
    images = [Image.fromarray(picture).quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    durations = [milliseconds] * (len(images) - 1) + [round(1000.0 * LAST)]  # ms
    with atomic_write(path) as file:
        images[0].save(file, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0, optimize=True)


def delay(frame_time: float) -> int:
    """Frame time in ms from a time in s. Raises ValueError unless a GIF can represent it."""
    hundredths = round(100.0 * frame_time) if math.isfinite(frame_time) else 0
    if not 2 <= hundredths < 2**16 or abs(100.0 * frame_time - hundredths) > 1e-6:
        raise ValueError(f"frame_time = {frame_time!r}: must be a multiple of 0.01 s, 0.02 to 655.35 s")
    return 10 * hundredths


def main(args: Args | None = None) -> None:
    """Run the command `heli-film`."""
    with command("heli-film"):
        run(args or parse(Args, "heli-film"))


def run(args: Args) -> None:
    """Fly, film and write the GIF."""
    if not args.policies or len(set(args.policies)) < len(args.policies):
        raise ValueError(f"policies = {args.policies}: must name at least one, and none twice")
    if args.seed < 0:
        raise ValueError(f"seed = {args.seed}: must be at least 0")
    if args.out.suffix != ".gif" or args.out.is_dir():
        raise ValueError(f"out = {str(args.out)!r}: must end in .gif")
    delay(args.frame_time)
    check_folder("out", args.out.parent)
    Renderer(args.width)
    rig = nominal_rig(args.plant, args.rig)
    env = Heli3DOFEnv(args.plant, reference_for(args.reference, rig, args.force), rig=rig)
    names = args.policies
    if names == Args.policies and not same_dynamics(env.rig, PAPER):  # which the network was not trained for
        names = ("feedforward+tvlqr", "kalman-lqr")
    policies = {
        name: make_policy(name, env.reference, env.control_period, voltage_limits=env.voltage_limits) for name in names
    }
    announce_replaced("heli-film", args.out)
    flights = {name: fly(env, policy, seed=args.seed) for name, policy in policies.items()}
    write_gif(film(flights, env, args.width, args.frame_time), args.frame_time, args.out)
    print(f"{args.out}: {args.out.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
