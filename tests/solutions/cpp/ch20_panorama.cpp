// Chapter 20: Panorama.

#include "raybook/ch20_panorama.hpp"

namespace ch20_panorama {

// By longitude and latitude.
CameraRayAnswer panorama_ray(
    const Vec3& position, const Vec3& forward, const Vec3& right, const Vec3& up, const Vec2& film) {
    const double pi = std::acos(-1.0);
    const double longitude = 2 * pi * film.x - pi, latitude = pi / 2 - pi * film.y;
    const Vec3 level = std::cos(longitude) * forward + std::sin(longitude) * right;
    return {position, std::cos(latitude) * level + std::sin(latitude) * up};
}

}
