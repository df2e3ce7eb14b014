"""Chapter 10: Octree."""

from __future__ import annotations

import math
from typing import List, Tuple

from ch05_box import box_clip
from raybook.ch10_types import Corners, NodeRow, TreeRow
from raybook.vec import Interval, Ray, Vec3


def octree_child(min_: Vec3, max_: Vec3, p: Vec3) -> int:
    """By the fraction of the cell, rounded down to a half."""
    halves = [2 * (x - low) / (high - low) for x, low, high in zip(p, min_, max_)]
    return sum(1 << axis for axis, half in enumerate(halves) if math.floor(half) >= 1)


def child(low: Vec3, high: Vec3, i: int) -> Tuple[Vec3, Vec3]:
    """The cell of a child."""
    middle = 0.5 * (low + high)
    upper = [bool(i >> axis & 1) for axis in range(3)]
    return (
        Vec3(*(m if up else a for a, m, up in zip(low, middle, upper))),
        Vec3(*(b if up else m for b, m, up in zip(high, middle, upper))),
    )


def octree_build(
    min_: Vec3, max_: Vec3, opening: float, copies: float, depth: int, shapes: list[Corners]
) -> TreeRow:
    """By recursion; the eight children get their numbers before any of them is built."""
    nodes = [NodeRow(0, 0, 0)]
    names: List[int] = []

    def fill(node: int, low: Vec3, high: Vec3, inside: list[int], copies: float, depth: int) -> None:
        cells = [child(low, high, i) for i in range(8)]
        parts = [
            [
                number
                for number in inside
                if all(
                    shapes[number].min[a] <= h[a] and l[a] <= shapes[number].max[a] for a in range(3)
                )
            ]
            for l, h in cells
        ]
        after = sum(map(len, parts))
        pays = opening + 0.25 * after < len(inside)
        if not pays or depth == 0 or after > copies * len(inside):
            nodes[node] = NodeRow(0, len(names), len(inside))
            names.extend(inside)
            return
        first = len(nodes)
        nodes[node] = NodeRow(1, first, 0)
        nodes.extend(NodeRow(0, 0, 0) for _ in range(8))
        left = copies / max(after / len(inside), 1)
        for i, (part, (l, h)) in enumerate(zip(parts, cells)):
            fill(first + i, l, h, part, left, depth - 1)

    fill(0, min_, max_, list(range(len(shapes))), copies, depth)
    return TreeRow(nodes, names)


def octree_walk(
    ray: Ray, within: Interval, min_: Vec3, max_: Vec3, nodes: list[NodeRow]
) -> list[int]:
    """All leaves in which the ray stays for a while, sorted by the middle of the stay."""
    stays = []
    to_do = [(0, min_, max_)]
    while to_do:
        number, low, high = to_do.pop()
        inside = box_clip(ray, within, low, high)
        if inside is None or inside.max - inside.min <= 1e-9:
            continue
        node = nodes[number]
        if node.inner:
            to_do.extend((node.first + i, *child(low, high, i)) for i in range(8))
        elif node.count > 0:
            stays.append((inside.min + inside.max, number))
    return [number for _, number in sorted(stays)]
