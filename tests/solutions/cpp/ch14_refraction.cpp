// Chapter 14: Refraction.

#include "raybook/ch14_refraction.hpp"

namespace ch14_refraction {

// By angles: the sine along the surface, the cosine across it.
std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double outside, double inside) {
    const bool leaves = dot(direction, normal) > 0;
    const Vec3 n = leaves ? -normal : normal;
    const Vec3 along = direction - dot(direction, n) * n;
    const double sine = length(along) * (leaves ? inside / outside : outside / inside);
    if (sine > 1) {
        return std::nullopt;
    }
    const Vec3 forward = length(along) > 0 ? unit(along) : Vec3{};
    return sine * forward - std::cos(std::asin(sine)) * n;
}

FresnelAnswer fresnel(double cos1, double n1, double n2) {
    const double sine2 = n1 / n2 * std::sqrt(std::fmax(1 - cos1 * cos1, 0));
    if (sine2 >= 1) {
        return {1, 1, 1};
    }
    const double cos2 = std::sqrt(1 - sine2 * sine2);
    const double s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
    const double p = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
    return {s * s, p * p, 0.5 * (s * s + p * p)};
}

}
