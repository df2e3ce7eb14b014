"""Chapter 22: Antialiasing."""

from __future__ import annotations

import math
import random
from itertools import product

from raybook.ch22_types import Seen
from raybook.vec import Rgb, Vec2


def regular_grid(x: int, y: int, columns: int, rows: int) -> list[Vec2]:
    return [
        Vec2(x + (2 * i + 1) / (2 * columns), y + (2 * j + 1) / (2 * rows))
        for i in range(columns)
        for j in range(rows)
    ]


def rotated_grid(spacing: float, offset: Vec2) -> list[Vec2]:
    """Clockwise."""
    cosine, sine = math.cos(math.atan(0.5)), -math.sin(math.atan(0.5))
    reach = math.ceil(1 / spacing) + math.ceil(abs(offset.x) + abs(offset.y)) + 1
    points = []
    for i, j in product(range(-reach, reach + 1), repeat=2):
        a, b = i + offset.x, j + offset.y
        p = Vec2(0.5 + spacing * (cosine * a - sine * b), 0.5 + spacing * (sine * a + cosine * b))
        if 0 <= p.x < 1 and 0 <= p.y < 1:
            points.append(p)
    return points


def random_pattern(n: int, seed: int) -> list[Vec2]:
    rng = random.Random(seed)
    return [Vec2(rng.random(), rng.random()) for _ in range(n)]


def jittered(columns: int, rows: int, seed: int) -> list[Vec2]:
    rng = random.Random(seed)
    return [
        Vec2((i + rng.random()) / columns, (j + rng.random()) / rows)
        for i in range(columns)
        for j in range(rows)
    ]


def poisson_disk(distance: float, seed: int) -> list[Vec2]:
    """Darts into a raster of cells that hold one point each, until two thousand in a row are too near."""
    rng = random.Random(seed)
    side = distance / math.sqrt(2)
    cells: dict[tuple[int, int], Vec2] = {}
    around = sorted(product(range(-2, 3), repeat=2), key=lambda cell: cell[0] ** 2 + cell[1] ** 2)
    missed = 0
    while missed < 2000:
        p = Vec2(rng.random(), rng.random())
        i, j = int(p.x / side), int(p.y / side)
        for a, b in around:
            q = cells.get((i + a, j + b))
            if q is not None and (p.x - q.x) ** 2 + (p.y - q.y) ** 2 < distance * distance:
                missed += 1
                break
        else:
            cells[i, j] = p
            missed = 0
    return list(cells.values())


def pixel_average(radius: float, samples: list[Seen]) -> Rgb:
    def tent(x: float) -> float:
        return max((radius - abs(x)) / radius, 0.0)

    weights = [tent(sample.offset.x) * tent(sample.offset.y) for sample in samples]
    total = sum(weights)
    average = Rgb(0.0, 0.0, 0.0)
    for weight, sample in zip(weights, samples):
        if total > 0:
            average = average + weight / total * sample.radiance
    return average
