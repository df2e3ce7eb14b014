"""Chapter 25: Capstone. The functions of earlier chapters, put together."""

from __future__ import annotations

import math

from ch03_sphere import sphere_hit
from ch04_plane import plane_hit
from ch06_triangle import triangle_hit, triangle_normal
from ch13_reflection import reflect
from ch14_refraction import fresnel, refract
from raybook.ch25_types import Clear, Corners, Description, Mirror, Object, Phong, Plane, Sphere
from raybook.vec import Interval, Ray, Rgb, Vec3

OFF = 1e-4  # metres that a new ray starts off the surface
BLACK = Rgb(0.0, 0.0, 0.0)


def distance(ray: Ray, thing: Object) -> float:
    """The distance to a thing; infinity for a miss."""
    form, ahead = thing.form, Interval(0.0, math.inf)
    t = None
    if isinstance(form, Sphere):
        t = sphere_hit(ray, ahead, form.center, form.radius)
    elif isinstance(form, Plane):
        t = plane_hit(ray, ahead, form.normal, form.offset)
    else:
        hit = triangle_hit(ray, ahead, form.p0, form.p1, form.p2)
        t = hit.t if hit is not None else None
    return math.inf if t is None else t


def outward(thing: Object, p: Vec3) -> Vec3:
    form = thing.form
    if isinstance(form, Sphere):
        return (p - form.center).unit()
    if isinstance(form, Plane):
        return form.normal
    assert isinstance(form, Corners)
    return triangle_normal(form.p0, form.p1, form.p2) or Vec3(0.0, 1.0, 0.0)


def trace(depth: int, ray: Ray, scene: Description) -> Rgb:
    if depth == 0:
        return BLACK
    t, thing = min(((distance(ray, o), o) for o in scene.objects), key=lambda x: x[0], default=(math.inf, None))
    d = ray.direction
    if thing is None or t == math.inf:
        up = 0.5 * (d.y + 1)
        return (1 - up) * scene.backdrop.below + up * scene.backdrop.above
    p = ray.origin + t * d
    out = outward(thing, p)
    enters = out.dot(d) < 0
    n = out if enters else -out  # turned to the viewer
    start = p + OFF * n
    matter = thing.matter
    if isinstance(matter, Phong):
        return shaded(scene, start, n, d, matter)
    above = trace(depth - 1, Ray(start, reflect(d, n)), scene)
    if isinstance(matter, Mirror):
        return matter.share * above
    assert isinstance(matter, Clear)
    through = refract(d, out, 1.0, matter.index)
    if through is None:
        return above
    n1, n2 = (1.0, matter.index) if enters else (matter.index, 1.0)
    share = fresnel(-n.dot(d), n1, n2).r
    below = trace(depth - 1, Ray(p - OFF * n, through), scene)
    return share * above + (1 - share) * below


def shaded(scene: Description, start: Vec3, n: Vec3, d: Vec3, matter: Phong) -> Rgb:
    total = matter.ambient * scene.ambient
    for lamp in scene.lamps:
        way = lamp.position - start
        r = way.length()
        toward = way / r
        cosine = n.dot(toward)
        if cosine <= 0 or any(distance(Ray(start, toward), thing) < r for thing in scene.objects):
            continue
        shine = max((2 * cosine * n - toward).dot(-d), 0.0) ** matter.exponent
        total = total + (1 / (r * r)) * ((cosine * matter.diffuse + shine * matter.specular) * lamp.intensity)
    return total
