// Chapter 15: Shadows.

#include "raybook/ch15_shadows.hpp"

#include <algorithm>

namespace ch15_shadows {

// A point that is clear of the surface, on the side of the light.
static Vec3 leave(const Vec3& position, double error, const Vec3& normal, const Vec3& toward) {
    return position + std::copysign(2 * error, dot(normal, toward)) * normal;
}

Way shadow_ray(const Vec3& position, double error, const Vec3& normal, const Vec3& toward, double distance) {
    return {leave(position, error, normal, toward), toward, {0, distance - 3 * error}};
}

// How near does the way to the light come to each centre?
unsigned lit(const Vec3& position, double error, const Vec3& normal, const Vec3& toward, double distance,
    const std::vector<Ball>& spheres) {
    const Vec3 start = leave(position, error, normal, toward);
    return std::none_of(spheres.begin(), spheres.end(), [&](const Ball& ball) {
        const double along = std::clamp(dot(ball.center - start, toward), 0.0, distance - error);
        return length(start + along * toward - ball.center) < ball.radius;
    });
}

}
