"""Chapter 17: Rendering equation."""

from __future__ import annotations

import math
import random

from ch16_soft_shadows import axes
from raybook.vec import Rgb, Vec3


def lattice(n: int) -> list[tuple[float, float]]:
    return [((i + 0.5) / n, 0.618034 * (i + 0.5) % 1) for i in range(n)]


def by_cosine(normal: Vec3, u: float, v: float) -> Vec3:
    """A point of the unit sphere added to the normal: its direction has the density cos θ/π."""
    x, y = axes(normal)
    z = 1 - 2 * u
    r = math.sqrt(max(1 - z * z, 0.0))
    sum_ = r * math.cos(math.tau * v) * x + r * math.sin(math.tau * v) * y + (z + 1) * normal
    return sum_.unit()


def cosine_hemisphere(normal: Vec3, n: int) -> list[Vec3]:
    return [by_cosine(normal, u, v) for u, v in lattice(n)]


def brdf_phong(
    normal: Vec3, view: Vec3, toward: Vec3, diffuse: Rgb, specular: Rgb, exponent: float
) -> Rgb:
    light, seen = normal.dot(toward), normal.dot(view)
    if light <= 0 or seen <= 0:
        return Rgb(0.0, 0.0, 0.0)
    # R·V without R.
    cosine = 2 * light * seen - toward.dot(view)
    shine = (exponent + 2) / math.tau * cosine**exponent if cosine > 0 else 0.0
    return (1 / math.pi) * diffuse + shine * specular


def reflected_radiance(
    normal: Vec3,
    view: Vec3,
    diffuse: Rgb,
    specular: Rgb,
    exponent: float,
    zenith: Vec3,
    radiance: Rgb,
    samples: int,
) -> Rgb:
    """Half of the directions by the cosine, half around the mirrored viewer, each weighted by both densities. Of a direction only
    its cosines with the normal, the mirrored viewer and the zenith count."""
    rng = random.Random(samples)
    mirrored = 2 * normal.dot(view) * normal - view
    lobes = [
        (power, [axis.dot(to) for to in (normal, mirrored, zenith) for axis in (*axes(pole), pole)])
        for power, pole in ((1, normal), (exponent, mirrored))
    ]
    matte = shine = 0.0
    for i in range(samples):
        power, (nx, ny, nz, mx, my, mz, zx, zy, zz) = lobes[i % 2]
        z = rng.random() ** (1 / (power + 1))
        r, phi = math.sqrt(1 - z * z), math.tau * rng.random()
        x, y = r * math.cos(phi), r * math.sin(phi)
        cosine = nx * x + ny * y + nz * z
        if cosine <= 0:
            continue
        gleam, up = mx * x + my * y + mz * z, zx * x + zy * y + zz * z
        highlight = gleam**exponent if gleam > 0 else 0.0
        density = 0.5 * cosine / math.pi + 0.5 * (exponent + 1) / math.tau * highlight
        light = (0.5 + 0.5 * up) * cosine / density / samples
        matte += light
        shine += light * highlight
    return radiance * (matte / math.pi * diffuse + shine * (exponent + 2) / math.tau * specular)
