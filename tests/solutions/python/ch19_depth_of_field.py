"""Chapter 19: Depth of field."""

from __future__ import annotations

import math

from raybook.ch19_types import CameraRayAnswer
from raybook.vec import Vec2, Vec3


def concentric_disk(n: int, shift: Vec2) -> list[Vec2]:
    """By polar coordinates: the radius is the root of u.x, the angle is u.y."""
    points = []
    for i in range(n):
        u, v = (shift.x + (i + 0.5) / n) % 1, (shift.y + 0.618034 * (i + 0.5)) % 1
        r, phi = math.sqrt(u), math.tau * v
        points.append(Vec2(r * math.cos(phi), r * math.sin(phi)))
    return points


def thin_lens_ray(
    lens_middle: Vec3,
    forward: Vec3,
    right: Vec3,
    up: Vec3,
    focal_length: float,
    f_number: float,
    focus: float,
    plane: Vec2,
    film: Vec2,
    on_lens: Vec2,
) -> CameraRayAnswer:
    """What is sharp is the film, larger by focus over the film's distance."""
    distance = focal_length * focus / (focus - focal_length)
    larger = focus / distance
    x, y = (film.x - 0.5) * plane.x * larger, (0.5 - film.y) * plane.y * larger
    sharp = lens_middle + x * right + y * up + focus * forward
    radius = 0.5 * focal_length / f_number
    origin = lens_middle + radius * on_lens.x * right + radius * on_lens.y * up
    return CameraRayAnswer(origin, (sharp - origin).unit())


def circle_of_confusion(
    focal_length: float, f_number: float, focus: float, distance: float
) -> float:
    """By similar triangles, from where the point would be sharp."""
    film = 1 / (1 / focal_length - 1 / focus)
    sharp = 1 / focal_length - 1 / distance  # of the image, per metre
    return focal_length / f_number * abs(1 - film * sharp)
