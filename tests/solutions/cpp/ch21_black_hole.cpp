// Chapter 21: Black hole.

#include "raybook/ch21_black_hole.hpp"

namespace ch21_black_hole {

// By velocity Verlet, for h² stays the same.
GeodesicStepAnswer geodesic_step(const Vec3& position, const Vec3& velocity, double step) {
    const Vec3 moment = cross(position, velocity);
    const auto pull = [&](const Vec3& x) { return -1.5 * dot(moment, moment) / std::pow(length(x), 5) * x; };
    const Vec3 half = velocity + 0.5 * step * pull(position);
    const Vec3 after = position + step * half;
    return {after, half + 0.5 * step * pull(after)};
}

// The integral over the radius, by the midpoint rule, with u = 1/r = sin θ/r₀, where it has no infinity.
std::optional<double> deflection_angle(double impact_parameter) {
    const double b = impact_parameter, pi = std::acos(-1.0);
    if (b < 1.5 * std::sqrt(3.0)) {
        return std::nullopt;
    }
    // The closest approach r₀, where r³ = b²(r − 1), by halving.
    double low = 1.5, high = b;
    for (int i = 0; i < 100; i++) {
        const double middle = 0.5 * (low + high);
        (middle * middle * middle < b * b * (middle - 1) ? low : high) = middle;
    }
    const int count = 20000;
    const double width = 0.5 * pi / count;
    double sum = 0;
    for (int i = 0; i < count; i++) {
        const double u = std::sin((i + 0.5) * width) / high;
        const double below = 1 / (b * b) - u * u + u * u * u;
        sum += std::cos((i + 0.5) * width) / high / std::sqrt(std::fmax(below, 1e-300));
    }
    return 2 * width * sum - pi;
}

}
