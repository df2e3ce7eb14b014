"""Chapter 1: Rays."""

from __future__ import annotations

from raybook.ch01_types import CameraRayAnswer
from raybook.vec import Ray, Vec2, Vec3


def ray_at(ray: Ray, t: float) -> Vec3:
    return Vec3(*(o + t * d for o, d in zip(ray.origin, ray.direction)))


def camera_ray(
    focal_point: Vec3,
    forward: Vec3,
    right: Vec3,
    up: Vec3,
    focal_length: float,
    plane: Vec2,
    film: Vec2,
) -> CameraRayAnswer:
    # From the picture's top left corner, across and down.
    corner = focal_length * forward - 0.5 * plane.x * right + 0.5 * plane.y * up
    place = corner + film.x * plane.x * right - film.y * plane.y * up
    return CameraRayAnswer(focal_point, place.unit())
