"""Chapter 16: Soft shadows."""

from __future__ import annotations

import math
import random

from raybook.ch16_types import Ball, Chosen
from raybook.vec import Vec3


def axes(z: Vec3) -> tuple[Vec3, Vec3]:
    """Two directions perpendicular to z and to each other."""
    thin = min(range(3), key=lambda axis: abs(z[axis]))
    x = z.cross(Vec3(*(float(axis == thin) for axis in range(3)))).unit()
    return x, z.cross(x)


def sample_rect(
    at: Vec3, corner: Vec3, a: Vec3, b: Vec3, radiance: float, n: int
) -> list[Chosen] | None:
    area = a.cross(b)
    if (at - corner).dot(area) <= 0:
        return None
    samples = []
    for k in range(n * n):
        u, v = (k % n + 0.5) / n, (k // n + 0.5) / n
        way = corner + u * a + v * b - at
        # dω = dA cos θ/r², and the area's vector holds dA and the cosine.
        solid = -way.dot(area) / way.length() ** 3
        samples.append(Chosen(way.unit(), way.length(), 1 / solid, radiance * solid))
    return samples


def sample_sphere_light(
    at: Vec3, center: Vec3, radius: float, radiance: float, n: int
) -> list[Chosen]:
    way = center - at
    far = way.length()
    outside = far > radius
    least = math.sqrt(1 - (radius / far) ** 2) if outside else -1.0
    z = way.unit() if far > 0 else Vec3(1.0, 0.0, 0.0)
    x, y = axes(z)
    solid = math.tau * (1 - least)
    samples = []
    for k in range(n * n):
        u, v = (k % n + 0.5) / n, (k // n + 0.5) / n
        cosine = 1 - u * (1 - least)
        sine, phi = math.sqrt(max(1 - cosine * cosine, 0.0)), math.tau * v
        toward = sine * math.cos(phi) * x + sine * math.sin(phi) * y + cosine * z
        foot = way.dot(toward)
        half = math.sqrt(max(radius * radius - far * far + foot * foot, 0.0))
        distance = foot - half if outside else foot + half
        samples.append(Chosen(toward, distance, 1 / solid, radiance * solid))
    return samples


def visible_fraction(
    corner: Vec3, a: Vec3, b: Vec3, points: list[Vec3], balls: list[Ball], samples: int
) -> list[float]:
    rng = random.Random(16)
    area = a.cross(b)

    def free(to: Vec3, way: Vec3, radius: float) -> bool:
        """The ball's centre lies `to` away from where the way begins."""
        along = min(max(to.dot(way) / way.dot(way), 0.0), 1.0)
        return (along * way - to).length() > radius

    fractions = []
    for p in points:
        seen = 0
        to_corner = corner - p
        spheres = [(ball.center - p, ball.radius) for ball in balls]
        for _ in range(samples):
            way = to_corner + rng.random() * a + rng.random() * b
            seen += way.dot(area) < 0 and all(free(to, way, radius) for to, radius in spheres)
        fractions.append(seen / samples)
    return fractions
