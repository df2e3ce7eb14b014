"""Chapter 4: Plane."""

from __future__ import annotations

from raybook.vec import Interval, Ray, Vec3


def plane_hit(ray: Ray, within: Interval, normal: Vec3, offset: float) -> float | None:
    """By similar triangles: the height above the plane, and how much of it a metre of the ray takes."""
    height = normal.dot(ray.origin) - offset
    sinks = -normal.dot(ray.direction)
    if sinks == 0:
        return None
    t = height / sinks
    return t if within.min < t < within.max else None
