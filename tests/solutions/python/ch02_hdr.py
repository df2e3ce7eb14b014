"""Chapter 2: High dynamic range."""

from __future__ import annotations

import math

from raybook.vec import Rgb


def expose(radiance: Rgb, stops: float) -> Rgb:
    return radiance * math.exp(stops * math.log(2))


def tone_map(radiance: Rgb) -> Rgb:
    luminance = radiance.luminance()
    return Rgb(*(channel / (1 + luminance) for channel in radiance))


def encode_srgb(v: float) -> float:
    if not v > 0:
        return 0.0
    if v >= 1:
        return 1.0
    return 12.92 * v if v <= 0.0031308 else 1.055 * math.exp(math.log(v) / 2.4) - 0.055
