// Chapter 4: Plane.

#include "raybook/ch04_plane.hpp"

namespace ch04_plane {

// By similar triangles: the height above the plane, and how much of it a metre of the ray takes.
std::optional<double> plane_hit(const Ray& ray, const Interval& within, const Vec3& normal, double offset) {
    const double height = dot(normal, ray.origin) - offset;
    const double sinks = -dot(normal, ray.direction);
    const double t = height / sinks; // without a number where the ray is parallel
    if (within.min < t && t < within.max && sinks != 0) {
        return t;
    }
    return std::nullopt;
}

}
