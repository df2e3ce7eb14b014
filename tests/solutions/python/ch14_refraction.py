"""Chapter 14: Refraction."""

from __future__ import annotations

import math

from raybook.ch14_types import FresnelAnswer
from raybook.vec import Vec3


def refract(direction: Vec3, normal: Vec3, outside: float, inside: float) -> Vec3 | None:
    """By angles: the sine along the surface, the cosine across it."""
    if direction.dot(normal) > 0:
        normal, outside, inside = -normal, inside, outside
    along = direction - direction.dot(normal) * normal
    sine = along.length() * outside / inside
    if sine > 1:
        return None
    forward = along.unit() if along.length() > 0 else along
    return sine * forward - math.cos(math.asin(sine)) * normal


def fresnel(cos1: float, n1: float, n2: float) -> FresnelAnswer:
    """From both cosines."""
    sine2 = n1 / n2 * math.sqrt(max(1 - cos1 * cos1, 0.0))
    if sine2 >= 1:
        return FresnelAnswer(1.0, 1.0, 1.0)
    cos2 = math.sqrt(1 - sine2 * sine2)
    rs = ((n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2)) ** 2
    rp = ((n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1)) ** 2
    return FresnelAnswer(rs, rp, 0.5 * (rs + rp))
