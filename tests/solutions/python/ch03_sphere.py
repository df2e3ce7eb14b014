"""Chapter 3: Sphere."""

from __future__ import annotations

import math

from raybook.vec import Interval, Ray, Vec2, Vec3


def solve_quadratic(a: float, b: float, c: float) -> Vec2 | None:
    if a == 0:
        return None
    # Double precision has digits to spare for the roots of three single numbers, but not for b² ≫ 4ac.
    square = b * b - 4 * a * c
    if square < 0:
        return None
    far = -b - math.copysign(math.sqrt(square), b)
    if far == 0:
        return Vec2(0.0, 0.0)
    roots = sorted([far / (2 * a), 2 * c / far])
    return Vec2(*roots)


def sphere_hit(ray: Ray, within: Interval, center: Vec3, radius: float) -> float | None:
    """By geometry: the foot of the perpendicular from the centre, and half of the chord."""
    to_center = center - ray.origin
    foot = to_center.dot(ray.direction)
    beside = to_center - foot * ray.direction
    square = radius * radius - beside.dot(beside)
    if square < 0:
        return None
    half = math.sqrt(square)
    for t in (foot - half, foot + half):
        if within.min < t < within.max:
            return t
    return None


def sphere_normal(center: Vec3, radius: float, p: Vec3) -> Vec3:
    return (p - center).unit()
