"""Chapter 20: Panorama."""

from __future__ import annotations

import math

from raybook.ch20_types import CameraRayAnswer
from raybook.vec import Vec2, Vec3


def panorama_ray(
    position: Vec3, forward: Vec3, right: Vec3, up: Vec3, film: Vec2
) -> CameraRayAnswer:
    """By longitude and latitude."""
    longitude, latitude = math.tau * film.x - math.pi, math.pi / 2 - math.pi * film.y
    level = math.cos(longitude) * forward + math.sin(longitude) * right
    return CameraRayAnswer(position, math.cos(latitude) * level + math.sin(latitude) * up)
