"""Vectors, colours, intervals and rays: what all chapters work with.

Where two things do not go together, such as a vector and a number in a sum, an operator returns NotImplemented, and Python says which
two. To numpy a vector or a colour is a row of numbers: `numpy.array(v)`. A number of numpy times a vector stays a vector, by
`__array_priority__`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Iterator

from .words import Words


@dataclass
class Vec2:
    """A point or a vector of the plane."""

    x: float
    y: float

    __array_priority__ = -1

    def __add__(self, other: Vec2) -> Vec2:
        if not isinstance(other, Vec2):
            return NotImplemented
        return Vec2(self.x + other.x, self.y + other.y)

    def __sub__(self, other: Vec2) -> Vec2:
        if not isinstance(other, Vec2):
            return NotImplemented
        return Vec2(self.x - other.x, self.y - other.y)

    def __mul__(self, k: float) -> Vec2:
        if hasattr(k, "__len__"):
            return NotImplemented
        return Vec2(self.x * k, self.y * k)

    __rmul__ = __mul__

    def __truediv__(self, k: float) -> Vec2:
        return Vec2(self.x / k, self.y / k)

    def __len__(self) -> int:
        return 2

    def __getitem__(self, axis: int) -> float:
        """x or y by the number of the axis: 0 or 1."""
        return (self.x, self.y)[axis]

    def __iter__(self) -> Iterator[float]:
        return iter((self.x, self.y))

    @staticmethod
    def read(words: Words) -> Vec2:
        return Vec2(*words.numbers(2))


@dataclass
class Vec3:
    """A point or a vector of space; the unit is metres, or none for a direction."""

    x: float
    y: float
    z: float

    __array_priority__ = -1

    def __add__(self, other: Vec3) -> Vec3:
        if not isinstance(other, Vec3):
            return NotImplemented
        return Vec3(self.x + other.x, self.y + other.y, self.z + other.z)

    def __sub__(self, other: Vec3) -> Vec3:
        if not isinstance(other, Vec3):
            return NotImplemented
        return Vec3(self.x - other.x, self.y - other.y, self.z - other.z)

    def __neg__(self) -> Vec3:
        return Vec3(-self.x, -self.y, -self.z)

    def __mul__(self, k: float) -> Vec3:
        if hasattr(k, "__len__"):
            return NotImplemented  # write a.dot(b) or a.cross(b)
        return Vec3(self.x * k, self.y * k, self.z * k)

    __rmul__ = __mul__

    def __truediv__(self, k: float) -> Vec3:
        return Vec3(self.x / k, self.y / k, self.z / k)

    def __getitem__(self, axis: int) -> float:
        """x, y or z by the number of the axis: 0, 1 or 2."""
        return (self.x, self.y, self.z)[axis]

    def __len__(self) -> int:
        return 3

    def __iter__(self) -> Iterator[float]:
        return iter((self.x, self.y, self.z))

    def dot(self, other: Vec3) -> float:
        return self.x * other.x + self.y * other.y + self.z * other.z

    def cross(self, other: Vec3) -> Vec3:
        return Vec3(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )

    def length(self) -> float:
        return math.sqrt(self.dot(self))

    def unit(self) -> Vec3:
        """The vector of length 1 in this direction; of 0 0 0 there is none."""
        return self / self.length()

    @staticmethod
    def read(words: Words) -> Vec3:
        return Vec3(*words.numbers(3))


@dataclass
class Rgb:
    """A colour: linear red, green and blue."""

    r: float
    g: float
    b: float

    __array_priority__ = -1

    def __add__(self, other: Rgb) -> Rgb:
        if not isinstance(other, Rgb):
            return NotImplemented
        return Rgb(self.r + other.r, self.g + other.g, self.b + other.b)

    def __sub__(self, other: Rgb) -> Rgb:
        if not isinstance(other, Rgb):
            return NotImplemented
        return Rgb(self.r - other.r, self.g - other.g, self.b - other.b)

    def __mul__(self, other: Rgb | float) -> Rgb:
        """By a number, or channel by channel."""
        if isinstance(other, Rgb):
            return Rgb(self.r * other.r, self.g * other.g, self.b * other.b)
        return Rgb(self.r * other, self.g * other, self.b * other)

    __rmul__ = __mul__

    def __truediv__(self, k: float) -> Rgb:
        return Rgb(self.r / k, self.g / k, self.b / k)

    def __len__(self) -> int:
        return 3

    def __getitem__(self, axis: int) -> float:
        """Red, green or blue by its number: 0, 1 or 2."""
        return (self.r, self.g, self.b)[axis]

    def __iter__(self) -> Iterator[float]:
        return iter((self.r, self.g, self.b))

    def luminance(self) -> float:
        """How bright it looks: Y of the sRGB primaries."""
        return 0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b

    @staticmethod
    def read(words: Words) -> Rgb:
        return Rgb(*words.numbers(3))


@dataclass
class Interval:
    """Distances along a ray, in metres."""

    min: float
    max: float

    @staticmethod
    def read(words: Words) -> Interval:
        return Interval(*words.numbers(2))


@dataclass
class Ray:
    """A ray: where it starts, in metres, and where it goes, of length 1."""

    origin: Vec3
    direction: Vec3

    @staticmethod
    def read(words: Words) -> Ray:
        return Ray(Vec3.read(words), words.direction(Vec3))
