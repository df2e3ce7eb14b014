"""Chapter 6: Triangle."""

from __future__ import annotations

from raybook.ch06_types import TriangleHitAnswer
from raybook.vec import Interval, Ray, Vec3


def triangle_hit(
    ray: Ray, within: Interval, p0: Vec3, p1: Vec3, p2: Vec3
) -> TriangleHitAnswer | None:
    """By the volumes of three tetrahedra (Plücker's test): on the same side of all three edges, or not."""
    a, b, c = p0 - ray.origin, p1 - ray.origin, p2 - ray.origin
    d = ray.direction
    opposite0, opposite1, opposite2 = d.dot(c.cross(b)), d.dot(a.cross(c)), d.dot(b.cross(a))
    whole = opposite0 + opposite1 + opposite2
    if whole == 0:
        return None
    b0, b1, b2 = opposite0 / whole, opposite1 / whole, opposite2 / whole
    if b0 < 0 or b1 < 0 or b2 < 0:
        return None
    t = (b0 * a + b1 * b + b2 * c).dot(d)
    return TriangleHitAnswer(t, b1, b2) if within.min < t < within.max else None


def triangle_normal(p0: Vec3, p1: Vec3, p2: Vec3) -> Vec3 | None:
    area = (p2 - p1).cross(p0 - p1)
    return area.unit() if area.length() > 0 else None
