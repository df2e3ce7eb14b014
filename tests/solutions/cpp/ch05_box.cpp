// Chapter 5: Box.

#include "raybook/ch05_box.hpp"

#include <algorithm>
#include <limits>

namespace ch05_box {

// Half-space by half-space: each of the six cuts something off, or nothing, or all (Cyrus and Beck 1978).
std::optional<Interval> box_clip(const Ray& ray, const Interval& within, const Vec3& min, const Vec3& max) {
    Interval inside = within;
    for (int axis = 0; axis < 3; axis++) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        // The ray is inside where outside + t · speed is at most 0.
        const double half_spaces[2][2] = {{min[axis] - o, -d}, {o - max[axis], d}};
        for (const auto& [outside, speed] : half_spaces) {
            if (speed == 0) {
                if (outside > 0) {
                    return std::nullopt;
                }
            } else if (speed < 0) {
                inside.min = std::max(inside.min, -outside / speed);
            } else {
                inside.max = std::min(inside.max, -outside / speed);
            }
        }
    }
    if (inside.min <= inside.max) {
        return inside;
    }
    return std::nullopt;
}

Corners bounds_of(const std::vector<Vec3>& points) {
    const double inf = std::numeric_limits<double>::infinity();
    Corners box{{inf, inf, inf}, {-inf, -inf, -inf}};
    for (const Vec3& p : points) {
        for (int axis = 0; axis < 3; axis++) {
            box.min[axis] = std::min(box.min[axis], p[axis]);
            box.max[axis] = std::max(box.max[axis], p[axis]);
        }
    }
    return box;
}

}
