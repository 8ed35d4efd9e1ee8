"""Pictures of the rig in perspective, its reference as a ghost, and gauges."""

import logging
import math
from typing import Any

import numpy as np

from heli_gym.model import hover_input
from heli_gym.rendering.display import has_display, load_pygame
from heli_gym.rendering.geometry import (
    BACK,
    FLOOR,
    FRONT,
    RIG,
    ROTOR,
    ROTOR_HEIGHT,
    STEEL,
    Camera,
    Colour,
    Mesh,
    arrow,
    circle,
    disc,
    helicopter,
    join,
    normals,
    parts,
    pose,
    project,
    rotors,
    sector,
    shadows,
    stripe,
)
from heli_gym.rendering.scene import RenderState, in_space, travel_interval

SKY, PLATE, GRID, MARK, BASE = (246, 248, 250), (233, 237, 242), (221, 226, 233), (186, 195, 205), (196, 204, 213)
PAPER, INK, NOTE, TRACK = (255, 255, 255), (34, 45, 56), (104, 116, 128), (226, 231, 236)
GHOST, LIMIT = (0, 158, 115), (213, 94, 0)  # of the palette of Okabe and Ito, like FRONT and BACK
WINDOW = (201, 229, 219)  # of the plan's limits
WAY = (86, 180, 233)
SHADOW, GHOSTLY, WAY_FLOWN = (40, 55, 70, 38), (*GHOST, 120), (*WAY, 110)  # RGBA, opacity out of 255

WIDTH, HEIGHT, VIEW = 640.0, 480.0, 362.0  # layout units; VIEW is the height at which the gauges begin
OVERSAMPLING = 2  # pixels of the canvas per pixel of the picture, along each side
EYE, TARGET, FOCAL = (1.15, -2.45, 1.25), (0.0, 0.0, -0.28), 664.0  # m, m, layout units
ARROW = 0.109  # m, of the arrow of a rotor's thrust at hover
TO_LIGHT = np.array((0.35, -0.45, 0.82)) / math.hypot(0.35, 0.45, 0.82)
FLOOR_RADIUS = 0.95  # m
TRAVEL_DIAL, ELEVATION_DIAL, PITCH_DIAL = (np.array(((x,), (421.0,))) for x in (62.0, 160.0, 270.0))
DIAL = 34.0  # radius
ELEVATION_RANGE = math.radians(40.0)
BAR_LEFT, BAR_LENGTH, BAR_HEIGHT, BARS = 384.0, 186.0, 14.0, (393.0, 421.0)
MOST_FRAMES = 60.0  # per second of the flight, in a window


class Renderer:
    """Draw scenes as pictures or in a window.

    Args:
        width: of the picture in pixels, a multiple of 8; the height is three quarters of it.

    Raises:
        ValueError: for any other width.
        gymnasium.error.DependencyNotInstalled: without pygame.
    """

    def __init__(self, width: int = 960) -> None:
        if not isinstance(width, int) or width % 8 or not 160 <= width <= 3840:
            raise ValueError(f"width = {width!r}: must be a multiple of 8 from 160 to 3840")
        self.pygame = pygame = load_pygame()
        self.size = (width, width * 3 // 4)
        self.scale = OVERSAMPLING * width / WIDTH  # pixels of the canvas per unit of the layout
        large = [OVERSAMPLING * side for side in self.size]
        self.canvas = pygame.Surface(large, depth=32)
        self.overlay = pygame.Surface(large, pygame.SRCALPHA, depth=32)
        self.touched = self.overlay.get_rect()  # area of the overlay to clear
        self.camera = Camera(EYE, TARGET, FOCAL * self.scale, (0.5 * WIDTH * self.scale, 0.455 * VIEW * self.scale))
        self.still: tuple | None = None  # scene values drawn in the cached background
        self.background: Any = None
        self.fonts: dict[float, Any] = {}
        self.window: Any = None
        self.clock: Any = None
        self.shown = math.inf

    def frame(self, scene: RenderState) -> np.ndarray:
        """Draw a picture (H, W, 3), uint8; equal scenes give equal pictures."""
        width, height = self.size
        pixels = self.pygame.image.tobytes(self._picture(scene), "RGB")
        return np.frombuffer(pixels, dtype=np.uint8).reshape(height, width, 3).copy()

    def show(self, scene: RenderState) -> None:
        """Draw in a window, which opens at the first call, and wait for the scene's time.

        Scenes beyond MOST_FRAMES per second are skipped.
        """
        pygame = self.pygame
        if self.window is None:
            if not has_display(pygame):  # the checkers of environments open windows on machines without a screen
                logging.getLogger("heli_gym").warning(
                    "heli_gym: render_mode='human' finds no display: nothing is seen; 'rgb_array' gives pictures"
                )
            pygame.display.set_caption("heli_gym")
            self.window = pygame.display.set_mode(self.size)
            self.clock = pygame.time.Clock()
        passed = scene.time - self.shown
        if 0.0 < passed < (1.0 - 1e-9) / MOST_FRAMES:
            return
        self.window.blit(self._picture(scene), (0, 0))
        pygame.event.pump()
        pygame.display.flip()
        if passed > 0.0:  # otherwise a new flight begins
            self.clock.tick(1.0 / passed)
        self.shown = scene.time

    def close(self) -> None:
        """Close the window, if there is one."""
        if self.window is not None:
            self.window = None
            self.pygame.display.quit()

    def _picture(self, scene: RenderState) -> Any:
        shown, scene = scene, in_space(scene)
        still = scene.limits, scene.voltage_limits, scene.pitch_limit
        if self.still != still:
            self.background, self.still = self._background(scene), still
        self.canvas.blit(self.background, (0, 0))
        self.canvas.set_clip((0, 0, self.canvas.get_width(), round(VIEW * self.scale)))
        self._behind(scene)
        self._rig(scene)
        self.canvas.set_clip(None)
        self._needles(scene)
        self._bars(scene)
        self._words(shown)
        return self.pygame.transform.smoothscale(self.canvas, self.size)

    def _background(self, scene: RenderState) -> Any:
        """Draw the floor and the gauge faces."""
        canvas = self.canvas.copy()
        canvas.fill(SKY)
        self._floor(canvas, circle(FLOOR_RADIUS, 120), PLATE)
        for offset in 0.25 * np.arange(-3, 4):
            reach = math.sqrt(FLOOR_RADIUS**2 - offset**2)
            self._floor(canvas, stripe((-reach, offset), (reach, offset), 0.006), GRID)
            self._floor(canvas, stripe((offset, -reach), (offset, reach), 0.006), GRID)
        for degrees in range(0, 360, 10):
            along, length = circle(1.0, 1, math.radians(degrees))[:, 0], 0.025 if degrees % 30 else 0.05
            self._floor(canvas, stripe(along * (FLOOR_RADIUS - length), along * FLOOR_RADIUS, 0.008), MARK)
        self._floor(canvas, circle(0.17), STEEL)
        self._floor(canvas, circle(0.16), BASE)

        self._shape(canvas, rectangle(0.0, WIDTH, VIEW, HEIGHT), PAPER)
        self._shape(canvas, rectangle(0.0, WIDTH, VIEW, VIEW + 3.0), TRACK)
        self._shape(canvas, TRAVEL_DIAL + sector(DIAL - 4.0, DIAL, 0.0, 2.0 * math.pi, 90), TRACK)
        self._shape(canvas, ELEVATION_DIAL + sector(DIAL - 4.0, DIAL, -ELEVATION_RANGE, ELEVATION_RANGE), TRACK)
        for side in (0.0, math.pi):
            stop, crash = side + scene.pitch_limit, side + math.pi - scene.pitch_limit
            planned = side + scene.limits.pitch_min, side + scene.limits.pitch_max
            self._shape(canvas, PITCH_DIAL + sector(DIAL - 4.0, DIAL, side - scene.pitch_limit, stop), TRACK)
            self._shape(canvas, PITCH_DIAL + sector(DIAL - 4.0, DIAL, *planned), WINDOW)
            self._shape(canvas, PITCH_DIAL + sector(DIAL - 4.0, DIAL, stop, max(crash, stop + 0.05)), LIMIT)
        for top in BARS:
            self._bar(canvas, top, BAR_HEIGHT, scene.voltage_limits, scene, TRACK)
            self._bar(canvas, top, BAR_HEIGHT, scene.limits.u, scene, WINDOW)
        return canvas

    def _behind(self, scene: RenderState) -> None:
        """Draw path, shadow and ghost, translucent and behind the rig, so that the rig stays clear."""
        self.overlay.fill((0, 0, 0, 0), self.touched)
        areas = [
            self._floor(self.overlay, sector(RIG.l_h - 0.02, RIG.l_h + 0.02, *travel_interval(scene), 90), WAY_FLOWN)
        ]
        areas += [self._floor(self.overlay, shadow, SHADOW) for shadow in shadows(pose(scene.state))]
        areas += self._solids(self.overlay, helicopter(pose(scene.reference)), [], GHOSTLY)
        self.touched = areas[0].unionall(areas[1:])
        self.canvas.blit(self.overlay, self.touched, self.touched)

    def _rig(self, scene: RenderState) -> None:
        """Draw the rig, the blur of its rotors in proportion to their voltages, and their thrusts as arrows."""
        at = pose(scene.state)
        flats: list[tuple[np.ndarray, tuple]] = []
        lift = float(hover_input(0.0, scene.rig.parameters)[0])
        shares = scene.rig.thrust(np.array(scene.voltage, dtype=float)) / (0.5 * lift)
        for rotor, u, thrust, colour in zip(rotors(at).T, scene.voltage, shares.tolist(), (FRONT, BACK)):
            up = at.body[:, 2]
            hub = rotor + ROTOR_HEIGHT * up
            opacity = 30 + round(120 * share(u, scene.voltage_limits))
            flats.append((disc(at, hub, ROTOR - 0.004), (*colour, opacity)))
            length = ARROW * thrust
            if abs(length) > 0.01:
                flats.append((arrow(hub, length * up, EYE), colour))
        self._solids(self.canvas, join(parts()["post"], helicopter(at)), flats)

    def _solids(
        self, surface: Any, mesh: Mesh, flats: list[tuple[np.ndarray, tuple]], tint: tuple | None = None
    ) -> list[Any]:
        """Paint visible faces and flat shapes (3, N) from back to front, all in the tint if one is given."""
        normal, centres = normals(mesh), mesh.vertices[:, mesh.faces].mean(axis=2)
        to_eye = np.reshape(EYE, (3, 1)) - centres
        seen = (normal * to_eye).sum(axis=0) > 0.0
        light = 0.66 + 0.34 * np.clip(TO_LIGHT @ normal[:, seen], 0.0, 1.0)
        colours = mesh.colours[seen] if tint is None else np.array(tint[:3])
        shades = (colours * light[:, None]).astype(int).tolist()
        outlines = np.moveaxis(project(mesh.vertices, self.camera)[0][:, mesh.faces[seen]], 0, -1).tolist()
        items = list(zip(np.linalg.norm(to_eye[:, seen], axis=0).tolist(), outlines, shades))
        for points, colour in flats:
            away = float(np.linalg.norm(points.mean(axis=1) - EYE))
            items.append((away, project(points, self.camera)[0].T.tolist(), list(colour)))
        opacity = [] if tint is None else [tint[3]]
        painted = []
        for _, outline, colour in sorted(items, reverse=True):
            if len(colour) == 4:  # pygame.draw overwrites the background instead of blending
                self.pygame.gfxdraw.filled_polygon(surface, outline, colour)
            else:
                painted.append(self.pygame.draw.polygon(surface, colour + opacity, outline))
        return painted

    def _needles(self, scene: RenderState) -> None:
        """Draw the dials of travel (from above), elevation (from the side) and pitch (from the pivot outwards)."""
        ring = sector(DIAL - 4.0, DIAL, *travel_interval(scene), 90)
        self._shape(self.canvas, TRAVEL_DIAL + ring * [[1.0], [-1.0]], WAY)
        inner = DIAL - 7.0
        for values, colour in ((scene.reference, GHOST), (scene.state, INK)):
            tilt = min(max(values[2], -ELEVATION_RANGE), ELEVATION_RANGE)
            for dial, tail, angle in (
                (TRAVEL_DIAL, 0.0, -values[0]),
                (ELEVATION_DIAL, -0.7 * inner, tilt),
                (PITCH_DIAL, -inner, values[4]),
            ):
                along = circle(1.0, 1, angle)[:, 0]
                self._shape(self.canvas, dial + stripe(tail * along, inner * along, 3.0), colour)
        for side, colour in ((-1.0, FRONT), (1.0, BACK)):
            tip = PITCH_DIAL + side * circle(inner - 1.0, 1, scene.state[4])
            self._shape(self.canvas, tip + circle(5.0, 24), colour)
        for dial in (TRAVEL_DIAL, ELEVATION_DIAL):
            self._shape(self.canvas, dial + circle(3.5, 24), INK)

    def _bars(self, scene: RenderState) -> None:
        """Draw the time and the voltages, red outside the plan's limits, with marks at the nominal ones."""
        low = scene.voltage_limits[0]
        for top, u, nominal, colour in zip(BARS, scene.voltage, scene.nominal_voltage, (FRONT, BACK)):
            planned = scene.limits.u_min <= u <= scene.limits.u_max
            self._bar(self.canvas, top + 3.0, BAR_HEIGHT - 6.0, (low, u), scene, colour if planned else LIMIT)
            x = BAR_LEFT + BAR_LENGTH * share(nominal, scene.voltage_limits)
            self._shape(self.canvas, rectangle(x - 1.5, x + 1.5, top - 3.0, top + BAR_HEIGHT + 3.0), GHOST)
        done = WIDTH * share(scene.time, (0.0, scene.duration))
        self._shape(self.canvas, rectangle(0.0, done, VIEW, VIEW + 3.0), INK)

    def _words(self, scene: RenderState) -> None:
        angles = (scene.state[0], scene.state[2], scene.state[4])
        for dial, name, angle in zip(
            (TRAVEL_DIAL, ELEVATION_DIAL, PITCH_DIAL), ("travel", "elevation", "pitch"), angles
        ):
            x = float(dial[0, 0])
            self._write(name, (x, VIEW + 7.0), 14, NOTE)
            self._write(f"{round(math.degrees(angle))}°", (x, HEIGHT - 21.0), 17, INK)
        for top, name, u in zip(BARS, ("front", "back"), scene.voltage):
            self._write(name, (BAR_LEFT - 8.0, top - 1.0), 14, NOTE, 1.0)
            self._write(f"{u:.1f} V", (WIDTH - 14.0, top - 3.0), 17, INK, 1.0)
        for limits, y in ((scene.limits.u, BARS[0] - 19.0), (scene.voltage_limits, BARS[1] + BAR_HEIGHT + 6.0)):
            for u in limits:
                self._write(f"{u:g}", (BAR_LEFT + BAR_LENGTH * share(u, scene.voltage_limits), y), 13, NOTE)
        self._write(scene.title, (14.0, 11.0), 20, INK, 0.0)
        self._write(scene.note, (14.0, 36.0), 16, LIMIT, 0.0)
        self._write(f"{scene.time:.1f} s", (WIDTH - 14.0, 11.0), 20, INK, 1.0)
        self._write(f"of {scene.duration:g} s", (WIDTH - 14.0, 36.0), 14, NOTE, 1.0)
        self._write("reference", (WIDTH - 14.0, HEIGHT - 21.0), 14, GHOST, 1.0)

    def _write(self, text: str, at: tuple[float, float], size: float, colour: Colour, anchor: float = 0.5) -> None:
        """Write text below a point in layout units; the anchor is the share of its width left of the point."""
        font = self.pygame.font
        if not font.get_init():  # at the first call, and after a pygame.quit elsewhere
            font.init()
            self.fonts.clear()
        if size not in self.fonts:
            # pygame's own font, so that pictures do not depend on the machine
            self.fonts[size] = font.Font(None, round(1.25 * size * self.scale))
        words = self.fonts[size].render(text, True, colour)
        self.canvas.blit(words, (round(at[0] * self.scale - anchor * words.get_width()), round(at[1] * self.scale)))

    def _bar(
        self, canvas: Any, top: float, height: float, window: tuple[float, float], scene: RenderState, colour: Colour
    ) -> None:
        left, right = (BAR_LEFT + BAR_LENGTH * share(u, scene.voltage_limits) for u in window)
        self._shape(canvas, rectangle(left, right, top, top + height), colour)

    def _shape(self, surface: Any, points: np.ndarray, colour: tuple) -> Any:
        """Fill a polygon (2, N) in layout units, and return its bounding rectangle."""
        return self.pygame.draw.polygon(surface, colour, (self.scale * points).T.tolist())

    def _floor(self, surface: Any, points: np.ndarray, colour: tuple) -> Any:
        """Fill a polygon (2, N) on the floor, in m, and return its bounding rectangle."""
        raised = np.concatenate((points, np.full((1, points.shape[1]), FLOOR)))
        return self.pygame.draw.polygon(surface, colour, project(raised, self.camera)[0].T.tolist())


def rectangle(left: float, right: float, top: float, bottom: float) -> np.ndarray:
    """Corners (2, 4) of a rectangle."""
    return np.array(((left, right, right, left), (top, top, bottom, bottom)))


def share(value: float, bounds: tuple[float, float]) -> float:
    """Position of a value between two bounds, clipped: 0 at the lower, 1 at the upper."""
    return min(max((value - bounds[0]) / (bounds[1] - bounds[0]), 0.0), 1.0)
