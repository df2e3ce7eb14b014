"""Chapter 7: Mesh."""

from __future__ import annotations

from ch06_triangle import triangle_hit
from raybook.ch07_types import Corners, Indices, MeshHitAnswer
from raybook.vec import Interval, Ray, Vec2, Vec3


def interpolate_normal(n0: Vec3, n1: Vec3, n2: Vec3, b: Vec2) -> Vec3:
    return (n0 + b.x * (n1 - n0) + b.y * (n2 - n0)).unit()


def interpolate_texture(t0: Vec2, t1: Vec2, t2: Vec2, b: Vec2) -> Vec2:
    return t0 + b.x * (t1 - t0) + b.y * (t2 - t0)


def vertex_normals(positions: list[Vec3], triangles: list[Indices]) -> list[Vec3]:
    """Each vertex asks all triangles. A cross product is as long as twice the area."""

    def normal(vertex: int) -> Vec3:
        total = Vec3(0.0, 0.0, 0.0)
        for t in triangles:
            if vertex in (t.a, t.b, t.c):
                p0, p1, p2 = positions[t.a], positions[t.b], positions[t.c]
                total = total + (p1 - p0).cross(p2 - p0)
        return total.unit() if total.length() > 0 else Vec3(0.0, 1.0, 0.0)

    return [normal(vertex) for vertex in range(len(positions))]


def mesh_hit(ray: Ray, within: Interval, triangles: list[Corners]) -> MeshHitAnswer | None:
    hits = []
    for i, corners in enumerate(triangles):
        hit = triangle_hit(ray, within, corners.p0, corners.p1, corners.p2)
        if hit is not None:
            hits.append((hit.t, i))
    return MeshHitAnswer(*min(hits)) if hits else None
