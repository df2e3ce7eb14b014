"""Chapter 8: Grid."""

from __future__ import annotations

import math
from itertools import product
from typing import Callable

from ch05_box import box_clip
from raybook.ch08_types import Cell, Visit
from raybook.vec import Interval, Ray, Vec3


def grid_resolution(extents: Vec3, shapes: int, density: float) -> Cell:
    """From all axes to fewer: the thinnest one is left out as long as it gets less than a cell."""
    axes = sorted(range(3), key=lambda axis: extents[axis], reverse=True)
    cells = [1, 1, 1]
    for count in (3, 2, 1):
        thick = axes[:count]
        content = math.prod(extents[axis] for axis in thick)
        if content == 0 or density * shapes == 0:
            continue
        side = (content / (density * shapes)) ** (1 / count)
        if extents[thick[-1]] >= side:
            for axis in thick:
                cells[axis] = int(extents[axis] / side + 0.5)
            break
    return Cell(*cells)


def voxels_of_triangle(
    min_: Vec3,
    cell: Vec3,
    nx: int,
    ny: int,
    nz: int,
    margin: float,
    p0: Vec3,
    p1: Vec3,
    p2: Vec3,
) -> list[Cell]:
    """The triangle is cut by the six planes of each cell (Sutherland and Hodgman 1974): is anything left?"""
    found = []
    for x, y, z in product(range(nx), range(ny), range(nz)):
        polygon = [p0, p1, p2]
        for axis, i in enumerate((x, y, z)):
            low = min_[axis] + i * cell[axis] - margin
            high = min_[axis] + (i + 1) * cell[axis] + margin
            polygon = clipped(polygon, lambda p: p[axis] - low)
            polygon = clipped(polygon, lambda p: high - p[axis])
        if polygon:
            found.append(Cell(x, y, z))
    return found


def clipped(polygon: list[Vec3], height: Callable[[Vec3], float]) -> list[Vec3]:
    """What of a polygon is not below a plane."""
    kept = []
    for i, p in enumerate(polygon):
        before = polygon[i - 1]
        a, b = height(before), height(p)
        if (a < 0) != (b < 0):
            kept.append(before + a / (a - b) * (p - before))
        if b >= 0:
            kept.append(p)
    return kept


def grid_walk(
    min_: Vec3, cell: Vec3, nx: int, ny: int, nz: int, ray: Ray, within: Interval
) -> list[Visit]:
    """All distances at which the ray crosses a plane, sorted; the cell is that of the middle between two."""
    n = (nx, ny, nz)
    high = Vec3(*(low + count * size for low, count, size in zip(min_, n, cell)))
    inside = box_clip(ray, within, min_, high)
    if inside is None:
        return []
    crossed = {inside.min, inside.max}
    for axis in range(3):
        if ray.direction[axis] != 0:
            for i in range(n[axis] + 1):
                t = (min_[axis] + i * cell[axis] - ray.origin[axis]) / ray.direction[axis]
                if inside.min < t < inside.max:
                    crossed.add(t)
    order = sorted(crossed)
    visits = []
    for enter, leave in zip(order, order[1:]):
        middle = ray.origin + 0.5 * (enter + leave) * ray.direction
        at = [
            min(max(math.floor((middle[axis] - min_[axis]) / cell[axis]), 0), n[axis] - 1)
            for axis in range(3)
        ]
        visits.append(Visit(at[0], at[1], at[2], leave))
    return visits
