// Chapter 2: High dynamic range.

#include "raybook/ch02_hdr.hpp"

namespace ch02_hdr {

Rgb expose(const Rgb& radiance, double stops) { return std::exp2(stops) * radiance; }

Rgb tone_map(const Rgb& radiance) { return radiance * (1 / (1 + luminance(radiance))); }

double encode_srgb(double v) {
    if (!(v > 0)) {
        return 0;
    }
    if (v >= 1) {
        return 1;
    }
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

}
