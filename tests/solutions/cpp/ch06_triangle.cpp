// Chapter 6: Triangle.

#include "raybook/ch06_triangle.hpp"

namespace ch06_triangle {

// By the volumes of three tetrahedra (Plücker's test): on the same side of all three edges, or not.
std::optional<TriangleHitAnswer> triangle_hit(
    const Ray& ray, const Interval& within, const Vec3& p0, const Vec3& p1, const Vec3& p2) {
    const Vec3 a = p0 - ray.origin, b = p1 - ray.origin, c = p2 - ray.origin;
    const Vec3 d = ray.direction;
    const double v0 = dot(d, cross(c, b)), v1 = dot(d, cross(a, c)), v2 = dot(d, cross(b, a));
    const double whole = v0 + v1 + v2;
    if (whole == 0) {
        return std::nullopt;
    }
    const double b0 = v0 / whole, b1 = v1 / whole, b2 = v2 / whole;
    const double t = dot(b0 * a + b1 * b + b2 * c, d);
    if (b0 < 0 || b1 < 0 || b2 < 0 || !(within.min < t && t < within.max)) {
        return std::nullopt;
    }
    return TriangleHitAnswer{t, b1, b2};
}

std::optional<Vec3> triangle_normal(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
    const Vec3 area = cross(p2 - p1, p0 - p1);
    if (length(area) > 0) {
        return unit(area);
    }
    return std::nullopt;
}

}
