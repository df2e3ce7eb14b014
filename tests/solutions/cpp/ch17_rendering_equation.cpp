// Chapter 17: Rendering equation.

#include "raybook/ch17_rendering_equation.hpp"

#include <random>

namespace ch17_rendering_equation {

static const double PI = std::acos(-1.0);

// A direction by its height above a plane and its angle around the plane's normal.
static Vec3 around(const Vec3& normal, double z, double phi) {
    const Vec3 x = unit(cross(normal, std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const double r = std::sqrt(std::fmax(1 - z * z, 0));
    return r * std::cos(phi) * x + r * std::sin(phi) * cross(normal, x) + z * normal;
}

// A point of the unit sphere added to the normal: its direction has the density cos θ/π.
static Vec3 by_cosine(const Vec3& normal, double u, double v) {
    return unit(around(normal, 1 - 2 * u, 2 * PI * v) + normal);
}

std::vector<Vec3> cosine_hemisphere(const Vec3& normal, unsigned n) {
    std::vector<Vec3> directions;
    for (unsigned i = 0; i < n; i++) {
        const double v = 0.618034 * (i + 0.5);
        directions.push_back(by_cosine(normal, (i + 0.5) / n, v - std::floor(v)));
    }
    return directions;
}

Rgb brdf_phong(const Vec3& normal, const Vec3& view, const Vec3& toward, const Rgb& diffuse, const Rgb& specular,
    double exponent) {
    const double light = dot(normal, toward), seen = dot(normal, view);
    if (light <= 0 || seen <= 0) {
        return {};
    }
    const double cosine = 2 * light * seen - dot(toward, view); // R·V without R
    const double shine = cosine > 0 ? (exponent + 2) / (2 * PI) * std::pow(cosine, exponent) : 0;
    return 1 / PI * diffuse + shine * specular;
}

// Half of the directions by the cosine, half around the mirrored viewer, each weighted by both densities.
Rgb reflected_radiance(const Vec3& normal, const Vec3& view, const Rgb& diffuse, const Rgb& specular,
    double exponent, const Vec3& zenith, const Rgb& radiance, unsigned samples) {
    std::mt19937 rng(samples);
    std::uniform_real_distribution<double> random;
    const Vec3 mirrored = 2 * dot(normal, view) * normal - view;
    Rgb total;
    for (unsigned i = 0; i < samples; i++) {
        const double u = random(rng), v = random(rng);
        const Vec3 toward = i % 2 == 0 ? by_cosine(normal, u, v)
                                       : around(mirrored, std::pow(u, 1 / (exponent + 1)), 2 * PI * v);
        const double cosine = dot(normal, toward);
        if (cosine <= 0) {
            continue;
        }
        const double lobe
            = (exponent + 1) / (2 * PI) * std::pow(std::fmax(dot(mirrored, toward), 0), exponent);
        const double density = 0.5 * cosine / PI + 0.5 * lobe;
        const Rgb sky = (0.5 + 0.5 * dot(toward, zenith)) * radiance;
        total = total + cosine / density / samples * (brdf_phong(normal, view, toward, diffuse, specular, exponent) * sky);
    }
    return total;
}

}
