// Chapter 1: Rays.

#include "raybook/ch01_rays.hpp"

namespace ch01_rays {

Vec3 ray_at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

CameraRayAnswer camera_ray(const Vec3& focal_point, const Vec3& forward, const Vec3& right, const Vec3& up,
    double focal_length, const Vec2& plane, const Vec2& film) {
    // From the picture's top left corner, across and down.
    const Vec3 corner = focal_length * forward - 0.5 * plane.x * right + 0.5 * plane.y * up;
    return {focal_point, unit(corner + film.x * plane.x * right - film.y * plane.y * up)};
}

}
