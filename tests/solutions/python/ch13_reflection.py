"""Chapter 13: Reflection."""

from __future__ import annotations

from raybook.vec import Vec3


def reflect(incoming: Vec3, normal: Vec3) -> Vec3:
    """What is along the surface stays, what is across it turns."""
    across = incoming.dot(normal) * normal
    along = incoming - across
    return (along - across).unit()
