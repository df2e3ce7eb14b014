"""Chapter 5: Box."""

from __future__ import annotations

import math

from raybook.ch05_types import Corners
from raybook.vec import Interval, Ray, Vec3


def box_clip(ray: Ray, within: Interval, min_: Vec3, max_: Vec3) -> Interval | None:
    """Half-space by half-space: each of the six cuts something off, or nothing, or all (Cyrus and Beck 1978)."""
    enter, leave = within.min, within.max
    for o, d, low, high in zip(ray.origin, ray.direction, min_, max_):
        for outside, speed in ((low - o, -d), (o - high, d)):
            # The ray is inside where outside + t · speed is at most 0.
            if speed == 0:
                if outside > 0:
                    return None
            elif speed < 0:
                enter = max(enter, -outside / speed)
            else:
                leave = min(leave, -outside / speed)
    return Interval(enter, leave) if enter <= leave else None


def bounds_of(points: list[Vec3]) -> Corners:
    if not points:
        return Corners(Vec3(math.inf, math.inf, math.inf), Vec3(-math.inf, -math.inf, -math.inf))
    along = [sorted(p[axis] for p in points) for axis in range(3)]
    return Corners(
        Vec3(along[0][0], along[1][0], along[2][0]), Vec3(along[0][-1], along[1][-1], along[2][-1])
    )
