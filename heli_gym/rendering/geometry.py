"""Geometry of the drawn rig: camera, kinematics, and meshes of its parts.

World coordinates, in m, have the arm's pivot at the origin and z up.
"""

import math
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from heli_gym.rigid_body import RigidBodyParameters, solve_rigid_body

RIG = solve_rigid_body("A")
FLOOR = -0.7  # m, below the pivot, as in `rigid_body.mjcf`
ROTOR = 0.115  # m, radius
ROTOR_HEIGHT = 0.035  # m, above the bar that carries the motors

Colour = tuple[int, int, int]
STEEL, DARK, BRASS = (158, 168, 179), (78, 89, 101), (201, 164, 92)
FRONT, BACK = (0, 114, 178), (230, 159, 0)  # of the palette of Okabe and Ito, distinguishable by colour-blind readers


class Camera(NamedTuple):
    """Pinhole camera: position and target in m, focal length and image centre in pixels."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    focal: float
    centre: tuple[float, float]


def project(points: ArrayLike, camera: Camera) -> tuple[np.ndarray, np.ndarray]:
    """Project points (3, ...) in m to pixels (2, ...), x right and y down, and depths (...) in m; no camera roll."""
    points = np.asarray(points, dtype=float)
    eye = np.asarray(camera.eye, dtype=float)
    ahead = camera.target - eye
    ahead /= np.linalg.norm(ahead)
    right = np.cross(ahead, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    axes = np.stack((right, np.cross(ahead, right), ahead))
    x, y, depth = np.tensordot(axes, points - eye.reshape(3, *[1] * (points.ndim - 1)), axes=1)
    return np.stack((camera.centre[0] + camera.focal * x / depth, camera.centre[1] + camera.focal * y / depth)), depth


class Pose(NamedTuple):
    """Rotations (3, 3) from the frames of the rig's parts to the world, and the pitch hinge (3,) in m."""

    yoke: np.ndarray  # turns with the travel only
    arm: np.ndarray
    body: np.ndarray
    hinge: np.ndarray


def pose(state: Sequence[float], rig: RigidBodyParameters = RIG) -> Pose:
    """Forward kinematics of a state (6,): travel about z, then elevation about y, then pitch about x."""
    (c1, c2, c3), (s1, s2, s3) = np.cos(state[0::2]), np.sin(state[0::2])
    yoke = np.array([[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]])
    arm = yoke @ np.array([[c2, 0.0, s2], [0.0, 1.0, 0.0], [-s2, 0.0, c2]])
    body = arm @ np.array([[1.0, 0.0, 0.0], [0.0, c3, -s3], [0.0, s3, c3]])
    return Pose(yoke, arm, body, arm @ (rig.l_h, 0.0, rig.e_h))


def rotors(at: Pose, rig: RigidBodyParameters = RIG) -> np.ndarray:
    """Positions (3, 2) in m of the (front, back) rotors, where their thrusts act."""
    return at.hinge[:, None] + np.outer(at.body[:, 1], (rig.l_p, -rig.l_p))


class Mesh(NamedTuple):
    """Quadrilaterals: vertices (3, V) in m, corners (F, 4), counter-clockwise from outside, and colours (F, 3)."""

    vertices: np.ndarray
    faces: np.ndarray
    colours: np.ndarray


def join(*meshes: Mesh) -> Mesh:
    """Join several meshes into one."""
    offsets = np.cumsum([0, *(mesh.vertices.shape[1] for mesh in meshes)])
    return Mesh(
        np.concatenate([mesh.vertices for mesh in meshes], axis=1),
        np.concatenate([mesh.faces + offset for mesh, offset in zip(meshes, offsets)]),
        np.concatenate([mesh.colours for mesh in meshes]),
    )


def transform(mesh: Mesh, rotation: np.ndarray, to: ArrayLike = (0.0, 0.0, 0.0)) -> Mesh:
    """Rotate a mesh about the origin, then shift it."""
    return mesh._replace(vertices=rotation @ mesh.vertices + np.reshape(to, (3, 1)))


def normals(mesh: Mesh) -> np.ndarray:
    """Unit normals (3, F) of the faces."""
    a, b, c, d = np.moveaxis(mesh.vertices[:, mesh.faces], 2, 0)
    normal = np.cross(c - a, d - b, axis=0)
    return normal / np.linalg.norm(normal, axis=0)


def convex(vertices: np.ndarray, faces: np.ndarray, colour: Colour) -> Mesh:
    """Convex solid in one colour, with its faces oriented outwards."""
    mesh = Mesh(vertices, faces, np.tile(colour, (len(faces), 1)))
    outwards = vertices[:, faces].mean(axis=2) - vertices.mean(axis=1, keepdims=True)
    inside_out = (normals(mesh) * outwards).sum(axis=0) < 0.0
    return mesh._replace(faces=np.where(inside_out[:, None], faces[:, ::-1], faces))


def box(low: Sequence[float], high: Sequence[float], colour: Colour) -> Mesh:
    """Box between two corners."""
    corners = np.array([[(low, high)[k >> axis & 1][axis] for k in range(8)] for axis in range(3)])
    faces = np.array([[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]])
    return convex(corners, faces, colour)


def tube(start: ArrayLike, end: ArrayLike, radius: float, colour: Colour, sides: int = 10, pieces: int = 1) -> Mesh:
    """Cylinder, in pieces along its axis, so that sorting by depth is right where it crosses other parts."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    axis = (end - start) / np.linalg.norm(end - start)
    aside = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    aside /= np.linalg.norm(aside)
    angle = 2.0 * np.pi * np.arange(sides) / sides
    rim = radius * (np.outer(aside, np.cos(angle)) + np.outer(np.cross(axis, aside), np.sin(angle)))
    k = np.arange(sides)
    walls = np.stack((k, (k + 1) % sides, (k + 1) % sides + sides, k + sides), axis=1)
    fan = np.array([[0, i, i + 1, i + 2] for i in range(1, sides - 2, 2)])
    rings = []
    for n in range(pieces):
        ends = [start + (end - start) * (n + side) / pieces for side in (0, 1)]
        faces = np.concatenate((walls, *([fan] if n == 0 else []), *([fan + sides] if n == pieces - 1 else [])))
        rings.append(convex(np.concatenate([at[:, None] + rim for at in ends], axis=1), faces, colour))
    return join(*rings)


def hoop(centre: Sequence[float], radius: float, height: float, colour: Colour, sides: int = 28) -> Mesh:
    """Upright band around a centre, visible from inside and from outside."""
    x, y, z = centre
    band = tube((x, y, z - 0.5 * height), (x, y, z + 0.5 * height), radius, colour, sides)
    walls = band._replace(faces=band.faces[:sides], colours=band.colours[:sides])
    return join(walls, walls._replace(faces=walls.faces[:, ::-1]))


@cache
def parts() -> dict[str, Mesh]:
    """Meshes of the rig, each part in its own frame; the body's origin is the pitch hinge."""
    l_h, l_p, l_c, d_c, e_h = RIG.l_h, RIG.l_p, RIG.l_c, RIG.d_c, RIG.e_h
    body = [box((-0.035, -0.04, -0.025), (0.035, 0.04, 0.014), DARK)]
    for y, colour in ((l_p, FRONT), (-l_p, BACK)):
        inner = math.copysign(0.04, y)
        body += [
            box((-0.02, min(inner, y), -0.008), (0.02, max(inner, y), 0.008), STEEL),
            tube((0, y, -0.02), (0, y, 0.03), 0.02, DARK),
            hoop((0, y, ROTOR_HEIGHT), ROTOR, 0.018, colour),
        ]
    return {
        "post": tube((0, 0, FLOOR), (0, 0, -0.06), 0.022, STEEL, 12),
        "yoke": join(
            tube((0, 0, -0.075), (0, 0, -0.035), 0.034, DARK, 14),
            box((-0.024, -0.03, -0.035), (0.024, -0.018, 0.022), DARK),
            box((-0.024, 0.018, -0.035), (0.024, 0.03, 0.022), DARK),
        ),
        "arm": join(
            tube((-l_c - 0.05, 0, 0), (l_h - 0.02, 0, 0), 0.0125, STEEL, 10, 14),
            box((l_h - 0.045, -0.014, -0.014), (l_h - 0.03, 0.014, e_h + 0.014), DARK),
            box((-l_c - 0.008, -0.008, -d_c), (-l_c + 0.008, 0.008, 0.012), DARK),
            tube((-l_c - 0.05, 0, -d_c), (-l_c + 0.05, 0, -d_c), 0.058, BRASS, 18),
        ),
        "body": join(*body),
    }


def helicopter(at: Pose) -> Mesh:
    """Mesh of the moving parts in world coordinates."""
    mesh = parts()
    return join(
        transform(mesh["yoke"], at.yoke), transform(mesh["arm"], at.arm), transform(mesh["body"], at.body, at.hinge)
    )


def circle(radius: float, points: int = 64, start: float = 0.0, end: float = 2.0 * math.pi) -> np.ndarray:
    """Points (2, N) of an arc about the origin."""
    angle = np.linspace(start, end, points)
    return radius * np.stack((np.cos(angle), np.sin(angle)))


def disc(at: Pose, hub: np.ndarray, radius: float) -> np.ndarray:
    """Rim (3, N) of a rotor about its hub (3,)."""
    return hub[:, None] + at.body[:, :2] @ circle(radius, 37)


def stripe(start: ArrayLike, end: ArrayLike, width: float) -> np.ndarray:
    """Corners (2, 4) of a line with a width, in the plane."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    along = end - start
    side = 0.5 * width * np.array((-along[1], along[0])) / max(float(np.hypot(*along)), 1e-9)
    return np.stack((start + side, end + side, end - side, start - side), axis=1)


def sector(inner: float, outer: float, start: float, end: float, points: int = 40) -> np.ndarray:
    """Corners (2, N) of an arc with a width, about the origin."""
    return np.concatenate((circle(outer, points, start, end), circle(inner, points, end, start)), axis=1)


def shadows(at: Pose) -> list[np.ndarray]:
    """Corners (2, N) in m of the rig's shadows on the floor, projected vertically."""
    hubs = rotors(at)
    counterweight = at.arm @ (-RIG.l_c, 0.0, -RIG.d_c)
    along = at.arm[:2, 0] * 0.05
    tail = at.arm[:2, 0] * (-RIG.l_c - 0.05)
    return [
        stripe(tail, at.hinge[:2], 0.025),
        stripe(counterweight[:2] - along, counterweight[:2] + along, 0.116),
        stripe(hubs[:2, 0], hubs[:2, 1], 0.04),
        *(disc(at, hub, ROTOR)[:2] for hub in hubs.T),
    ]


def arrow(foot: np.ndarray, way: np.ndarray, eye: ArrayLike) -> np.ndarray:
    """Corners (3, 7) of a flat arrow from a point (3,) along a vector (3,) in m, facing the eye."""
    length = float(np.linalg.norm(way))
    side = np.cross(way, foot - np.asarray(eye))
    side /= np.linalg.norm(side)
    neck = way * max(1.0 - 0.05 / length, 0.4)
    corners = (0.007, 0.0 * way), (0.007, neck), (0.024, neck), (0.0, way)
    right = [foot + along + width * side for width, along in corners]
    left = [foot + along - width * side for width, along in corners[2::-1]]
    return np.stack(right + left, axis=1)
