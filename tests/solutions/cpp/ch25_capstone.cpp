// Chapter 25: Capstone. The functions of earlier chapters, put together.

#include "raybook/ch25_capstone.hpp"

#include "raybook/ch03_sphere.hpp"
#include "raybook/ch04_plane.hpp"
#include "raybook/ch06_triangle.hpp"
#include "raybook/ch13_reflection.hpp"
#include "raybook/ch14_refraction.hpp"

#include <algorithm>
#include <limits>

namespace ch25_capstone {

static const double INF = std::numeric_limits<double>::infinity();

// Metres that a new ray starts off the surface.
static const double OFF = 1e-4;

namespace {

// The distance to a shape; infinity for a miss.
struct Distance {
    const Ray& ray;
    Interval ahead{0, INF};

    double operator()(const Sphere& form) const {
        return ch03_sphere::sphere_hit(ray, ahead, form.center, form.radius).value_or(INF);
    }
    double operator()(const Plane& form) const {
        return ch04_plane::plane_hit(ray, ahead, form.normal, form.offset).value_or(INF);
    }
    double operator()(const Corners& form) const {
        const auto hit = ch06_triangle::triangle_hit(ray, ahead, form.p0, form.p1, form.p2);
        return hit ? hit->t : INF;
    }
};

// The normal to the outside.
struct Outward {
    Vec3 p;

    Vec3 operator()(const Sphere& form) const { return unit(p - form.center); }
    Vec3 operator()(const Plane& form) const { return form.normal; }
    Vec3 operator()(const Corners& form) const {
        return ch06_triangle::triangle_normal(form.p0, form.p1, form.p2).value_or(Vec3{0, 1, 0});
    }
};

// What a material sends back along a ray that meets it.
struct Shade {
    unsigned depth;
    const Description& scene;
    Vec3 p, d, out;

    bool enters() const { return dot(out, d) < 0; }
    Vec3 n() const { return enters() ? out : -out; } // turned to the viewer
    Vec3 start() const { return p + OFF * n(); }
    Rgb mirrored() const { return trace(depth - 1, {start(), ch13_reflection::reflect(d, n())}, scene); }

    Rgb operator()(const Phong& matter) const {
        Rgb total = matter.ambient * scene.ambient;
        for (const PointLight& lamp : scene.lamps) {
            const Vec3 way = lamp.position - start();
            const double r = length(way);
            const Ray ray{start(), way / r};
            const double cosine = dot(n(), ray.direction);
            const bool hidden = std::any_of(scene.objects.begin(), scene.objects.end(),
                [&](const Object& thing) { return std::visit(Distance{ray}, thing.form) < r; });
            if (cosine <= 0 || hidden) {
                continue;
            }
            const double mirror = dot(2 * cosine * n() - ray.direction, -d);
            const double shine = std::pow(std::fmax(mirror, 0), matter.exponent);
            total = total + 1 / (r * r) * ((cosine * matter.diffuse + shine * matter.specular) * lamp.intensity);
        }
        return total;
    }

    Rgb operator()(const Mirror& matter) const { return matter.share * mirrored(); }

    Rgb operator()(const Clear& matter) const {
        const auto through = ch14_refraction::refract(d, out, 1, matter.index);
        if (!through) {
            return mirrored();
        }
        const double n1 = enters() ? 1 : matter.index, n2 = enters() ? matter.index : 1;
        const double share = ch14_refraction::fresnel(-dot(n(), d), n1, n2).r;
        return share * mirrored() + (1 - share) * trace(depth - 1, {p - OFF * n(), *through}, scene);
    }
};

}

Rgb trace(unsigned depth, const Ray& ray, const Description& scene) {
    if (depth == 0) {
        return {};
    }
    double nearest = INF;
    const Object* thing = nullptr;
    for (const Object& object : scene.objects) {
        const double t = std::visit(Distance{ray}, object.form);
        if (t < nearest) {
            nearest = t;
            thing = &object;
        }
    }
    if (thing == nullptr) {
        const double up = 0.5 * (ray.direction.y + 1);
        return (1 - up) * scene.backdrop.below + up * scene.backdrop.above;
    }
    const Vec3 p = ray.origin + nearest * ray.direction;
    const Vec3 out = std::visit(Outward{p}, thing->form);
    return std::visit(Shade{depth, scene, p, ray.direction, out}, thing->matter);
}

}
