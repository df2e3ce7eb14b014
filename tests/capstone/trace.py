#!/usr/bin/env python3
"""A whole ray tracer in Python's standard library:  raybook check trace --program tests/capstone/trace.py --pictures out"""

import sys
from math import inf, sqrt

OFF = 1e-4  # metres that a new ray starts off the surface


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(s, a):
    return (s * a[0], s * a[1], s * a[2])


def times(a, b):
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(1 / sqrt(dot(a, a)), a)


class Sphere:
    def __init__(self, words):
        self.center, self.radius = words.vector(), words.number()

    def hit(self, o, d):  # the nearest distance ahead, or infinity
        oc = sub(self.center, o)
        middle = dot(oc, d)
        square = self.radius**2 - dot(oc, oc) + middle * middle
        if square < 0:
            return inf
        half = sqrt(square)
        near, far = middle - half, middle + half
        return near if near > 0 else far if far > 0 else inf

    def normal(self, p):
        return unit(sub(p, self.center))


class Plane:
    def __init__(self, words):
        self.n, self.offset = words.vector(), words.number()

    def hit(self, o, d):
        along = dot(self.n, d)
        t = (self.offset - dot(self.n, o)) / along if along != 0 else inf
        return t if t > 0 else inf

    def normal(self, p):
        return self.n


class Triangle:
    def __init__(self, words):
        self.p0, p1, p2 = words.vector(), words.vector(), words.vector()
        self.e1, self.e2 = sub(p1, self.p0), sub(p2, self.p0)
        self.n = unit(cross(self.e1, self.e2))

    def hit(self, o, d):
        s1 = cross(d, self.e2)
        determinant = dot(s1, self.e1)
        if determinant == 0:
            return inf
        s = sub(o, self.p0)
        b1 = dot(s1, s) / determinant
        if not 0 <= b1 <= 1:
            return inf
        s2 = cross(s, self.e1)
        b2 = dot(s2, d) / determinant
        t = dot(s2, self.e2) / determinant
        return t if b2 >= 0 and b1 + b2 <= 1 and t > 0 else inf

    def normal(self, p):
        return self.n


class Phong:
    def __init__(self, words):
        self.ambient, self.diffuse, self.specular = (words.vector() for _ in range(3))
        self.exponent = words.number()

    def shade(self, scene, p, n, entering, d, depth):
        start = add(p, scale(OFF, n))
        sum_ = times(self.ambient, scene.ambient)
        for position, intensity in scene.lamps:
            way = sub(position, start)
            r = sqrt(dot(way, way))
            l = scale(1 / r, way)
            cosine = dot(n, l)
            if cosine <= 0 or scene.blocks(start, l, r):
                continue
            shine = max(-dot(sub(scale(2 * cosine, n), l), d), 0) ** self.exponent
            brdf = add(scale(cosine, self.diffuse), scale(shine, self.specular))
            sum_ = add(sum_, scale(1 / (r * r), times(brdf, intensity)))
        return sum_


class Mirror:
    def __init__(self, words):
        self.share = words.vector()

    def shade(self, scene, p, n, entering, d, depth):
        return times(self.share, mirrored(scene, p, n, d, depth))


class Glass:
    def __init__(self, words):
        self.index = words.number()

    def shade(self, scene, p, n, entering, d, depth):
        n1, n2 = (1, self.index) if entering else (self.index, 1)
        cos1 = -dot(n, d)
        square = 1 - (n1 / n2) ** 2 * (1 - cos1 * cos1)
        above = mirrored(scene, p, n, d, depth)
        if square <= 0:
            return above  # total reflection
        cos2 = sqrt(square)
        rs = ((n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2)) ** 2
        rp = ((n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1)) ** 2
        share = (rs + rp) / 2
        through = add(scale(n1 / n2, d), scale(n1 / n2 * cos1 - cos2, n))
        below = scene.trace(sub(p, scale(OFF, n)), unit(through), depth - 1)
        return add(scale(share, above), scale(1 - share, below))


def mirrored(scene, p, n, d, depth):
    """What the mirrored ray sees."""
    return scene.trace(add(p, scale(OFF, n)), sub(d, scale(2 * dot(d, n), n)), depth - 1)


class Scene:
    def __init__(self, words):
        self.ambient, self.below, self.above = (words.vector() for _ in range(3))
        self.lamps = [(words.vector(), words.vector()) for _ in range(int(words.word()))]
        self.objects = [
            (KINDS[words.word()](words), KINDS[words.word()](words)) for _ in range(int(words.word()))
        ]

    def blocks(self, o, d, far):
        return any(form.hit(o, d) < far for form, _ in self.objects)

    def trace(self, o, d, depth):
        """The radiance that comes along a ray."""
        if depth == 0:
            return (0, 0, 0)
        nearest = inf
        for form, matter in self.objects:
            t = form.hit(o, d)
            if t < nearest:
                nearest, of = t, (form, matter)
        if nearest == inf:
            up = (d[1] + 1) / 2
            return add(scale(1 - up, self.below), scale(up, self.above))
        form, matter = of
        p = add(o, scale(nearest, d))
        outward = form.normal(p)
        entering = dot(outward, d) < 0
        n = outward if entering else scale(-1, outward)  # turned to the viewer
        return matter.shade(self, p, n, entering, d, depth)


KINDS = {kind.__name__.lower(): kind for kind in (Sphere, Plane, Triangle, Phong, Mirror, Glass)}


class Words:
    """A question's words, one after the other."""

    def __init__(self, line):
        self.word = iter(line.split()).__next__

    def number(self):
        return float(self.word())

    def vector(self):
        return (self.number(), self.number(), self.number())


for line in sys.stdin:
    words = Words(line)
    words.word()  # the exercise's name
    depth, o, d = int(words.word()), words.vector(), words.vector()
    print("=", *Scene(words).trace(o, unit(d), depth), flush=True)
