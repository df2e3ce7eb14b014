"""Chapter 11: Bounding volume hierarchy."""

from __future__ import annotations

from collections import deque
from typing import Deque, List, Optional, Tuple

from ch05_box import box_clip
from ch06_triangle import triangle_hit
from raybook.ch11_types import (
    BoxRow,
    BvhBuildAnswer,
    BvhClosestAnswer,
    Corners,
    MeshHitAnswer,
    NodeRow,
)
from raybook.vec import Interval, Ray, Vec3


def area(low: Vec3, high: Vec3) -> float:
    size = high - low
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x)


def sah_cost(branch: float, shape: float, nodes: list[NodeRow]) -> float:
    """From the leaves up: a node's price is its own and that of its children."""

    def price(number: int) -> float:
        node = nodes[number]
        own = area(node.min, node.max)
        if node.count > 0:
            return own * shape * node.count
        return own * branch + price(node.first) + price(node.first + 1)

    return price(0) / area(nodes[0].min, nodes[0].max) if nodes else 0.0


def around(boxes: list[BoxRow], which: list[int]) -> Tuple[Vec3, Vec3]:
    return (
        Vec3(*(min(boxes[i].min[a] for i in which) for a in range(3))),
        Vec3(*(max(boxes[i].max[a] for i in which) for a in range(3))),
    )


def best_cut(boxes: list[BoxRow], which: list[int]) -> Tuple[float, List[int], List[int]]:
    """All cuts along all axes, by their boxes; the areas of the right sides come first."""
    best: Tuple[float, List[int], List[int]] = (float("inf"), [], [])
    for axis in range(3):
        order = sorted(which, key=lambda i: boxes[i].min[axis] + boxes[i].max[axis])
        right = growing(boxes, order[::-1])[::-1]
        left = growing(boxes, order)
        for at in range(1, len(order)):
            cost = left[at - 1] * at + right[at] * (len(order) - at)
            if cost < best[0]:
                best = (cost, order[:at], order[at:])
    return best


def growing(boxes: list[BoxRow], order: list[int]) -> list[float]:
    """The area around the first box, the first two, and so on."""
    areas = []
    low, high = boxes[order[0]].min, boxes[order[0]].max
    for i in order:
        low = Vec3(*map(min, low, boxes[i].min))
        high = Vec3(*map(max, high, boxes[i].max))
        areas.append(area(low, high))
    return areas


def sah_split(boxes: list[BoxRow]) -> list[int]:
    return best_cut(boxes, list(range(len(boxes))))[1]


def bvh_build(most: int, boxes: list[BoxRow]) -> BvhBuildAnswer:
    """Breadth first: pairs of children are side by side by themselves."""
    nodes: List[NodeRow] = []
    order: List[int] = []
    if not boxes:
        return BvhBuildAnswer(nodes, order)
    waiting: Deque[List[int]] = deque([list(range(len(boxes)))])
    made = 1
    while waiting:
        which = waiting.popleft()
        low, high = around(boxes, which)
        cost, left, right = best_cut(boxes, which)
        own = area(low, high)
        if len(which) > 1 and (len(which) > most or own + cost < own * len(which)):
            nodes.append(NodeRow(low, high, made, 0))
            waiting.extend([left, right])
            made += 2
        else:
            nodes.append(NodeRow(low, high, len(order), len(which)))
            order.extend(which)
    return BvhBuildAnswer(nodes, order)


def bvh_closest(
    ray: Ray, within: Interval, nodes: list[NodeRow], triangles: list[Corners]
) -> BvhClosestAnswer:
    """By recursion, the nearer child first."""
    boxes = tests = 0
    nearest: Optional[MeshHitAnswer] = None

    def search(number: int) -> None:
        nonlocal boxes, tests, nearest
        node = nodes[number]
        for i in range(node.first, node.first + node.count):
            tests += 1
            end = within.max if nearest is None else nearest.t
            corners = triangles[i]
            hit = triangle_hit(ray, Interval(within.min, end), corners.p0, corners.p1, corners.p2)
            if hit is not None:
                nearest = MeshHitAnswer(hit.t, i)
        if node.count > 0:
            return
        met = []
        for below in (node.first, node.first + 1):
            boxes += 1
            end = within.max if nearest is None else nearest.t
            inside = box_clip(ray, Interval(within.min, end), nodes[below].min, nodes[below].max)
            if inside is not None:
                met.append((inside.min, below))
        for enter, below in sorted(met):
            if nearest is None or enter < nearest.t:
                search(below)

    if nodes:
        search(0)
    return BvhClosestAnswer(boxes, tests, nearest)
