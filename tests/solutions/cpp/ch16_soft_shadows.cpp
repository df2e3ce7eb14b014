// Chapter 16: Soft shadows.

#include "raybook/ch16_soft_shadows.hpp"

#include <algorithm>
#include <random>

namespace ch16_soft_shadows {

static const double TAU = 2 * std::acos(-1.0);

std::optional<std::vector<Chosen>> sample_rect(
    const Vec3& at, const Vec3& corner, const Vec3& a, const Vec3& b, double radiance, unsigned n) {
    const Vec3 area = cross(a, b);
    if (dot(at - corner, area) <= 0) {
        return std::nullopt;
    }
    std::vector<Chosen> samples;
    for (unsigned k = 0; k < n * n; k++) {
        const Vec3 way = corner + (k % n + 0.5) / n * a + (k / n + 0.5) / n * b - at;
        // dω = dA cos θ/r², and the area's vector holds dA and the cosine.
        const double solid = -dot(way, area) / std::pow(length(way), 3);
        samples.push_back({unit(way), length(way), 1 / solid, radiance * solid});
    }
    return samples;
}

std::vector<Chosen> sample_sphere_light(
    const Vec3& at, const Vec3& center, double radius, double radiance, unsigned n) {
    const Vec3 way = center - at;
    const double far = length(way);
    const bool outside = far > radius;
    const double least = outside ? std::sqrt(1 - radius * radius / (far * far)) : -1;
    const Vec3 z = far > 0 ? way / far : Vec3{1, 0, 0};
    const Vec3 x = unit(cross(z, std::abs(z.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 y = cross(z, x);
    const double solid = TAU * (1 - least);
    std::vector<Chosen> samples;
    for (unsigned k = 0; k < n * n; k++) {
        const double cosine = 1 - (k % n + 0.5) / n * (1 - least), phi = TAU * (k / n + 0.5) / n;
        const double sine = std::sqrt(std::fmax(1 - cosine * cosine, 0));
        const Vec3 toward = sine * std::cos(phi) * x + sine * std::sin(phi) * y + cosine * z;
        const double foot = dot(way, toward);
        const double half = std::sqrt(std::fmax(radius * radius - far * far + foot * foot, 0));
        samples.push_back({toward, outside ? foot - half : foot + half, 1 / solid, radiance * solid});
    }
    return samples;
}

std::vector<double> visible_fraction(const Vec3& corner, const Vec3& a, const Vec3& b,
    const std::vector<Vec3>& points, const std::vector<Ball>& balls, unsigned samples) {
    std::mt19937 rng(16);
    std::uniform_real_distribution<double> random;
    std::vector<double> fractions;
    for (const Vec3& p : points) {
        unsigned seen = 0;
        for (unsigned i = 0; i < samples; i++) {
            const double u = random(rng), v = random(rng);
            const Vec3 way = corner + u * a + v * b - p;
            const bool hidden = std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
                const double along = std::clamp(dot(ball.center - p, way) / dot(way, way), 0.0, 1.0);
                return length(p + along * way - ball.center) < ball.radius;
            });
            seen += dot(way, cross(a, b)) < 0 && !hidden;
        }
        fractions.push_back(static_cast<double>(seen) / samples);
    }
    return fractions;
}

}
