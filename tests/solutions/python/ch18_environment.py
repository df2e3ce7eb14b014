"""Chapter 18: Environment."""

from __future__ import annotations

import math

from raybook.ch18_types import CubePlace
from raybook.vec import Vec2, Vec3

# Of each face: where it lies, and what is up on it.
FACES = [
    (Vec3(1, 0, 0), Vec3(0, 1, 0)),
    (Vec3(-1, 0, 0), Vec3(0, 1, 0)),
    (Vec3(0, 1, 0), Vec3(0, 0, 1)),
    (Vec3(0, -1, 0), Vec3(0, 0, -1)),
    (Vec3(0, 0, 1), Vec3(0, 1, 0)),
    (Vec3(0, 0, -1), Vec3(0, 1, 0)),
]


def direction_to_cube(direction: Vec3) -> CubePlace:
    face = max(range(6), key=lambda i: direction.dot(FACES[i][0]))
    forward, up = FACES[face]
    p = direction / direction.dot(forward)
    return CubePlace(face, 0.5 + 0.5 * p.dot(forward.cross(up)), 0.5 - 0.5 * p.dot(up))


def direction_to_latlong(direction: Vec3) -> Vec2:
    across = math.hypot(direction.x, direction.z)
    phi = math.acos(min(max(-direction.z / across, -1), 1)) if across > 0 else 0.0
    theta = math.atan2(across, direction.y)
    return Vec2(0.5 + 0.5 * math.copysign(phi, direction.x) / math.pi, theta / math.pi)


def edge(y: float, height: int) -> float:
    """The cosine of the angle from the top at the upper edge of a row."""
    return math.cos(math.pi * y / height)


def light(width: int, height: int, texels: list[float]) -> list[float]:
    """The radiance of each texel times its solid angle."""
    zones = [edge(y, height) - edge(y + 1, height) for y in range(height)]
    return [texel * math.tau * zones[i // width] / width for i, texel in enumerate(texels)]


def sample_environment(width: int, height: int, texels: list[float]) -> list[Vec3]:
    """All texels in one list, each as long as its light."""
    lights = light(width, height, texels)
    total = sum(lights)
    if total == 0:
        return []
    directions = []
    for i in range(256):
        u, v = (i + 0.5) / 256, 0.618034 * (i + 0.5) % 1
        left = u * total
        texel = 0
        while left > lights[texel] or lights[texel] == 0:
            left -= lights[texel]
            texel += 1
        x, y = texel % width + left / lights[texel], texel // width
        phi = math.tau * (x / width - 0.5)
        cosine = edge(y, height) + v * (edge(y + 1, height) - edge(y, height))
        sine = math.sqrt(max(1 - cosine * cosine, 0.0))
        directions.append(Vec3(sine * math.sin(phi), cosine, -sine * math.cos(phi)))
    return directions


def environment_pdf(direction: Vec3, width: int, height: int, texels: list[float]) -> float:
    """The radiance over the integral of the map: the solid angle cancels."""
    integral = sum(light(width, height, texels))
    if integral == 0:
        return 0.0
    place = direction_to_latlong(direction)
    x, y = min(int(place.x * width), width - 1), min(int(place.y * height), height - 1)
    return texels[y * width + x] / integral
