"""Chapter 12: Phong."""

from __future__ import annotations

from raybook.ch12_types import Arriving, Highlight
from raybook.vec import Rgb, Vec3


def lit(at: Highlight, cosine: float) -> Rgb:
    """Diffuse and specular light, the latter by this cosine."""
    along = at.normal.dot(at.toward)
    if along <= 0:
        return Rgb(0.0, 0.0, 0.0)
    shine = max(cosine, 0.0) ** at.exponent
    return Rgb(
        *(
            (d * along + s * shine) * i
            for d, s, i in zip(at.diffuse, at.specular, at.arriving)
        )
    )


def phong(at: Highlight) -> Rgb:
    # The viewer is mirrored, not the light: the angle is the same.
    mirrored = 2 * at.normal.dot(at.view) * at.normal - at.view
    return lit(at, mirrored.dot(at.toward))


def blinn_phong(at: Highlight) -> Rgb:
    half = at.toward + at.view
    return lit(at, at.normal.dot(half) / half.length() if half.length() > 0 else 0.0)


def point_light(position: Vec3, intensity: Rgb, at: Vec3) -> Arriving | None:
    way = position - at
    square = way.dot(way)
    if square == 0:
        return None
    distance = way.length()
    return Arriving(way / distance, distance, intensity * (1 / square))
