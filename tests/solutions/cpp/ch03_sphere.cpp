// Chapter 3: Sphere.

#include "raybook/ch03_sphere.hpp"

namespace ch03_sphere {

// The larger root has no cancellation; the other follows from the product of both, c/a.
std::optional<Vec2> solve_quadratic(double a, double b, double c) {
    const double square = b * b - 4 * a * c;
    if (a == 0 || square < 0) {
        return std::nullopt;
    }
    const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));
    const double t0 = q / a;
    const double t1 = q == 0 ? 0 : c / q;
    return Vec2{std::fmin(t0, t1), std::fmax(t0, t1)};
}

// By geometry: the foot of the perpendicular from the centre, and half of the chord.
std::optional<double> sphere_hit(const Ray& ray, const Interval& within, const Vec3& center, double radius) {
    const Vec3 to_center = center - ray.origin;
    const double foot = dot(to_center, ray.direction);
    const Vec3 beside = to_center - foot * ray.direction;
    const double square = radius * radius - dot(beside, beside);
    if (square < 0) {
        return std::nullopt;
    }
    for (const double t : {foot - std::sqrt(square), foot + std::sqrt(square)}) {
        if (within.min < t && t < within.max) {
            return t;
        }
    }
    return std::nullopt;
}

Vec3 sphere_normal(const Vec3& center, double radius, const Vec3& p) {
    return unit((p - center) / radius);
}

}
