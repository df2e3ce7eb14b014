// Chapter 18: Environment.

#include "raybook/ch18_environment.hpp"

#include <algorithm>
#include <numeric>

namespace ch18_environment {

static const double PI = std::acos(-1.0);

CubePlace direction_to_cube(const Vec3& direction) {
    // Of each face: where it lies, and what is up on it.
    static const Vec3 faces[6][2] = {{{1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 1}},
        {{0, -1, 0}, {0, 0, -1}}, {{0, 0, 1}, {0, 1, 0}}, {{0, 0, -1}, {0, 1, 0}}};
    unsigned best = 0;
    for (unsigned face = 1; face < 6; face++) {
        if (dot(direction, faces[face][0]) > dot(direction, faces[best][0])) {
            best = face;
        }
    }
    const auto& [forward, up] = faces[best];
    const Vec3 p = direction / dot(direction, forward);
    return {best, 0.5 + 0.5 * dot(p, cross(forward, up)), 0.5 - 0.5 * dot(p, up)};
}

Vec2 direction_to_latlong(const Vec3& direction) {
    const double across = std::hypot(direction.x, direction.z);
    const double phi = across > 0 ? std::acos(std::clamp(-direction.z / across, -1.0, 1.0)) : 0;
    return {0.5 + 0.5 * std::copysign(phi, direction.x) / PI, std::atan2(across, direction.y) / PI};
}

// The cosine of the angle from the top at the upper edge of a row.
static double edge(double y, unsigned height) { return std::cos(PI * y / height); }

// The radiance of each texel times its solid angle.
static std::vector<double> light(unsigned width, unsigned height, const std::vector<double>& texels) {
    std::vector<double> lights;
    for (unsigned i = 0; i < texels.size(); i++) {
        const unsigned y = i / width;
        lights.push_back(texels[i] * 2 * PI * (edge(y, height) - edge(y + 1, height)) / width);
    }
    return lights;
}

// All texels in one list, each as long as its light.
std::vector<Vec3> sample_environment(unsigned width, unsigned height, const std::vector<double>& texels) {
    const auto lights = light(width, height, texels);
    std::vector<double> sums(lights.size());
    std::partial_sum(lights.begin(), lights.end(), sums.begin());
    std::vector<Vec3> directions;
    for (int i = 0; i < 256 && !sums.empty() && sums.back() > 0; i++) {
        const double u = (i + 0.5) / 256 * sums.back(), v = std::fmod(0.618034 * (i + 0.5), 1);
        const auto texel = static_cast<unsigned>(std::upper_bound(sums.begin(), sums.end(), u) - sums.begin());
        const double turn = 1 - (sums[texel] - u) / lights[texel];
        const double phi = 2 * PI * ((texel % width + turn) / width - 0.5);
        const double top = edge(texel / width, height), bottom = edge(texel / width + 1, height);
        const double cosine = top + v * (bottom - top);
        const double sine = std::sqrt(std::fmax(1 - cosine * cosine, 0));
        directions.push_back({sine * std::sin(phi), cosine, -sine * std::cos(phi)});
    }
    return directions;
}

// The radiance over the integral of the map: the solid angle cancels.
double environment_pdf(
    const Vec3& direction, unsigned width, unsigned height, const std::vector<double>& texels) {
    const auto lights = light(width, height, texels);
    const double integral = std::accumulate(lights.begin(), lights.end(), 0.0);
    const Vec2 place = direction_to_latlong(direction);
    const unsigned x = std::min(static_cast<unsigned>(place.x * width), width - 1);
    const unsigned y = std::min(static_cast<unsigned>(place.y * height), height - 1);
    return integral > 0 ? texels[y * width + x] / integral : 0;
}

}
