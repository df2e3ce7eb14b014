// Chapter 12: Phong.

#include "raybook/ch12_phong.hpp"

namespace ch12_phong {

// Diffuse and specular light, the latter by this cosine.
static Rgb lit(const Highlight& at, double cosine) {
    const double along = dot(at.normal, at.toward);
    if (along <= 0) {
        return {};
    }
    const double shine = std::pow(std::fmax(cosine, 0), at.exponent);
    return (along * at.diffuse + shine * at.specular) * at.arriving;
}

// R·V without R.
Rgb phong(const Highlight& at) {
    return lit(at, 2 * dot(at.normal, at.toward) * dot(at.normal, at.view) - dot(at.toward, at.view));
}

Rgb blinn_phong(const Highlight& at) {
    const Vec3 half = at.toward + at.view;
    return lit(at, length(half) > 0 ? dot(at.normal, half) / length(half) : 0);
}

std::optional<Arriving> point_light(const Vec3& position, const Rgb& intensity, const Vec3& at) {
    const Vec3 way = position - at;
    const double square = dot(way, way);
    if (square == 0) {
        return std::nullopt;
    }
    return Arriving{unit(way), std::sqrt(square), 1 / square * intensity};
}

}
