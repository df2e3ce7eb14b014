"""Chapter 9: Two-level grid."""

from __future__ import annotations

from itertools import product
from typing import Iterator, Tuple

from ch05_box import box_clip
from ch08_grid import grid_resolution
from raybook.ch09_types import Corners, Entry, RefineCellAnswer, Resolution
from raybook.vec import Interval, Ray, Vec3


def cells_of(low: Vec3, high: Vec3, n: Resolution) -> Iterator[Tuple[Vec3, Vec3]]:
    """The boxes of all cells, those along x first."""
    size = Vec3(
        (high.x - low.x) / max(n.nx, 1), (high.y - low.y) / max(n.ny, 1), (high.z - low.z) / max(n.nz, 1)
    )
    for z, y, x in product(range(n.nz), range(n.ny), range(n.nx)):
        corner = Vec3(low.x + x * size.x, low.y + y * size.y, low.z + z * size.z)
        yield corner, corner + size


def slab(start: float, size: float, i: int, axis: int, shapes: list[Corners]) -> set[int]:
    """The shapes that overlap cell i along an axis."""
    low = start + i * size
    return {k for k, shape in enumerate(shapes) if shape.min[axis] <= low + size and low <= shape.max[axis]}


def refine_cell(min_: Vec3, max_: Vec3, density: float, shapes: list[Corners]) -> RefineCellAnswer:
    """Cell by cell: which shapes overlap it? They do if they do along each axis."""
    if not shapes:
        return RefineCellAnswer(0, 0, 0, [])
    along = grid_resolution(max_ - min_, len(shapes), density)
    n = Resolution(*(min(count, 255) for count in (along.x, along.y, along.z)))
    along_x, along_y, along_z = (
        [slab(min_[a], (max_[a] - min_[a]) / count, i, a, shapes) for i in range(count)]
        for a, count in enumerate((n.nx, n.ny, n.nz))
    )
    entries = [
        Entry(x, y, z, number)
        for z, y, x in product(range(n.nz), range(n.ny), range(n.nx))
        for number in sorted(along_x[x] & along_y[y] & along_z[z])
    ]
    return RefineCellAnswer(n.nx, n.ny, n.nz, entries)


def two_level_walk(
    ray: Ray, within: Interval, min_: Vec3, max_: Vec3, coarse: Resolution, fine: list[Resolution]
) -> list[int]:
    """All fine cells in which the ray stays for a while, sorted by the middle of the stay."""
    stays = []
    place = 0
    for (low, high), n in zip(cells_of(min_, max_, coarse), fine):
        for fine_low, fine_high in cells_of(low, high, n):
            inside = box_clip(ray, within, fine_low, fine_high)
            if inside is not None and inside.max - inside.min > 1e-9:
                stays.append((inside.min + inside.max, place))
            place += 1
    return [place for _, place in sorted(stays)]
