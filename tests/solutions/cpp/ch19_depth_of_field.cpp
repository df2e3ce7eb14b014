// Chapter 19: Depth of field.

#include "raybook/ch19_depth_of_field.hpp"

namespace ch19_depth_of_field {

static double fraction(double v) { return v - std::floor(v); }

// By polar coordinates: the radius is the root of u.x, the angle is u.y.
std::vector<Vec2> concentric_disk(unsigned n, const Vec2& shift) {
    const double tau = 2 * std::acos(-1.0);
    std::vector<Vec2> points;
    for (unsigned i = 0; i < n; i++) {
        const double u = fraction(shift.x + (i + 0.5) / n), v = fraction(shift.y + 0.618034 * (i + 0.5));
        points.push_back(std::sqrt(u) * Vec2{std::cos(tau * v), std::sin(tau * v)});
    }
    return points;
}

// What is sharp is the film, larger by focus over the film's distance.
CameraRayAnswer thin_lens_ray(const Vec3& lens_middle, const Vec3& forward, const Vec3& right, const Vec3& up,
    double focal_length, double f_number, double focus, const Vec2& plane, const Vec2& film, const Vec2& on_lens) {
    const double distance = focal_length * focus / (focus - focal_length);
    const double larger = focus / distance;
    const double x = (film.x - 0.5) * plane.x * larger, y = (0.5 - film.y) * plane.y * larger;
    const Vec3 sharp = lens_middle + x * right + y * up + focus * forward;
    const Vec2 on = 0.5 * focal_length / f_number * on_lens;
    const Vec3 origin = lens_middle + on.x * right + on.y * up;
    return {origin, unit(sharp - origin)};
}

// By similar triangles, from where the point would be sharp.
double circle_of_confusion(double focal_length, double f_number, double focus, double distance) {
    const double film = 1 / (1 / focal_length - 1 / focus);
    return focal_length / f_number * std::abs(1 - film * (1 / focal_length - 1 / distance));
}

}
