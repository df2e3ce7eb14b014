"""Chapter 15: Shadows."""

from __future__ import annotations

import math

from raybook.ch15_types import Ball, Way
from raybook.vec import Interval, Vec3


def leave(position: Vec3, error: float, normal: Vec3, toward: Vec3) -> Vec3:
    """A point that is clear of the surface, on the side of the light."""
    return position + math.copysign(2 * error, normal.dot(toward)) * normal


def shadow_ray(position: Vec3, error: float, normal: Vec3, toward: Vec3, distance: float) -> Way:
    origin = leave(position, error, normal, toward)
    return Way(origin, toward, Interval(0.0, distance - 3 * error))


def lit(
    position: Vec3,
    error: float,
    normal: Vec3,
    toward: Vec3,
    distance: float,
    spheres: list[Ball],
) -> int:
    """How near does the way to the light come to each centre?"""
    start = leave(position, error, normal, toward)
    for ball in spheres:
        along = min(max((ball.center - start).dot(toward), 0.0), distance - error)
        if (start + along * toward - ball.center).length() < ball.radius:
            return 0
    return 1
