"""Chapter 24: Wide BVH."""

from __future__ import annotations

import heapq
from typing import List, Tuple

from ch05_box import box_clip
from ch06_triangle import triangle_hit
from ch11_bvh import area
from raybook.ch24_types import (
    Corners,
    FamilyRow,
    MeshHitAnswer,
    NodeRow,
    WideClosestAnswer,
    WideLeaf,
    WideNode,
)
from raybook.vec import Interval, Ray, Vec3


def collapse(nodes: list[NodeRow]) -> list[FamilyRow]:
    """A heap of branches by area, the largest first, and a list of leaves."""
    families: List[FamilyRow] = []
    waiting = [0] if nodes else []
    while waiting:
        branch = waiting.pop()
        if nodes[branch].count > 0:
            continue
        largest: List[Tuple[float, int]] = []
        leaves: List[int] = []

        def add(number: int) -> None:
            if nodes[number].count > 0:
                leaves.append(number)
            else:
                heapq.heappush(largest, (-area(nodes[number].min, nodes[number].max), number))

        add(nodes[branch].first)
        add(nodes[branch].first + 1)
        while largest and len(largest) + len(leaves) < 8:
            _, opened = heapq.heappop(largest)
            add(nodes[opened].first)
            add(nodes[opened].first + 1)
        children = [number for _, number in largest]
        families.append(FamilyRow(branch, leaves + children))
        waiting.extend(children)
    return families


def wide_closest(
    ray: Ray,
    within: Interval,
    nodes: list[WideNode],
    leaves: list[WideLeaf],
    triangles: list[Corners],
) -> WideClosestAnswer:
    """The nearest box of all that wait, wherever it is."""
    opened = tests = 0
    nearest = (within.max, -1)
    waiting = [(within.min, 0, 0)] if nodes else []
    grown = Vec3(1e-6, 1e-6, 1e-6)
    while waiting:
        enter, leaf, index = heapq.heappop(waiting)
        if enter > nearest[0]:
            break
        if leaf:
            for i in leaves[index].triangles:
                tests += 1
                hit = triangle_hit(
                    ray, within, triangles[i].p0, triangles[i].p1, triangles[i].p2
                )
                if hit is not None and hit.t < nearest[0]:
                    nearest = (hit.t, i)
        else:
            opened += 1
            for child in nodes[index].children:
                inside = box_clip(ray, within, child.min - grown, child.max + grown)
                if inside is not None:
                    heapq.heappush(waiting, (inside.min, child.leaf, child.index))
    hit_ = MeshHitAnswer(*nearest) if nearest[1] >= 0 else None
    return WideClosestAnswer(opened, tests, hit_)
