"""Chapter 21: Black hole."""

from __future__ import annotations

import math

from raybook.ch21_types import GeodesicStepAnswer
from raybook.vec import Vec3


def geodesic_step(position: Vec3, velocity: Vec3, step: float) -> GeodesicStepAnswer:
    """By velocity Verlet, for h² stays the same."""
    moment = position.cross(velocity)
    h2 = moment.dot(moment)

    def pull(x: Vec3) -> Vec3:
        return -1.5 * h2 / x.length() ** 5 * x

    half = velocity + 0.5 * step * pull(position)
    after = position + step * half
    return GeodesicStepAnswer(after, half + 0.5 * step * pull(after))


def deflection_angle(impact_parameter: float) -> float | None:
    """By u = 1/r against the angle, u″ = 3/2 u² − u, from infinity until u is 0 again."""
    step = 1e-3
    u, slope, angle = 0.0, 1 / impact_parameter, 0.0
    while u < 1:
        half = slope + 0.5 * step * (1.5 * u * u - u)
        u += step * half
        slope = half + 0.5 * step * (1.5 * u * u - u)
        angle += step
        if u < 0:
            return angle - u / slope - math.pi
    return None
