// Chapter 8: Grid.

#include "raybook/ch08_grid.hpp"

#include "raybook/ch05_box.hpp"

#include <algorithm>
#include <functional>

namespace ch08_grid {

// From all axes to fewer: the thinnest one is left out as long as it gets less than a cell.
Cell grid_resolution(const Vec3& extents, unsigned shapes, double density) {
    int axes[3] = {0, 1, 2};
    std::sort(axes, axes + 3, [&](int a, int b) { return extents[a] > extents[b]; });
    unsigned cells[3] = {1, 1, 1};
    for (int count = 3; count > 0; count--) {
        double content = 1;
        for (int i = 0; i < count; i++) {
            content *= extents[axes[i]];
        }
        const double side = std::pow(content / (density * shapes), 1.0 / count);
        if (extents[axes[count - 1]] >= side && side > 0) {
            for (int i = 0; i < count; i++) {
                cells[axes[i]] = static_cast<unsigned>(std::lround(extents[axes[i]] / side));
            }
            break;
        }
    }
    return {cells[0], cells[1], cells[2]};
}

// What of a polygon is not below a plane (Sutherland and Hodgman 1974).
static std::vector<Vec3> clipped(
    const std::vector<Vec3>& polygon, const std::function<double(const Vec3&)>& height) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); i++) {
        const Vec3& before = polygon[(i + polygon.size() - 1) % polygon.size()];
        const double a = height(before), b = height(polygon[i]);
        if ((a < 0) != (b < 0)) {
            kept.push_back(before + a / (a - b) * (polygon[i] - before));
        }
        if (b >= 0) {
            kept.push_back(polygon[i]);
        }
    }
    return kept;
}

// The triangle is cut by the six planes of each cell: is anything left?
std::vector<Cell> voxels_of_triangle(const Vec3& min, const Vec3& cell, unsigned nx, unsigned ny, unsigned nz,
    double margin, const Vec3& p0, const Vec3& p1, const Vec3& p2) {
    std::vector<Cell> found;
    for (unsigned i = 0; i < nx * ny * nz; i++) {
        const unsigned at[3] = {i % nx, i / nx % ny, i / nx / ny};
        std::vector<Vec3> polygon{p0, p1, p2};
        for (int axis = 0; axis < 3; axis++) {
            const double low = min[axis] + at[axis] * cell[axis] - margin;
            const double high = min[axis] + (at[axis] + 1) * cell[axis] + margin;
            polygon = clipped(polygon, [&](const Vec3& p) { return p[axis] - low; });
            polygon = clipped(polygon, [&](const Vec3& p) { return high - p[axis]; });
        }
        if (!polygon.empty()) {
            found.push_back({at[0], at[1], at[2]});
        }
    }
    return found;
}

// All distances at which the ray crosses a plane, sorted; the cell is that of the middle between two.
std::vector<Visit> grid_walk(const Vec3& min, const Vec3& cell, unsigned nx, unsigned ny, unsigned nz,
    const Ray& ray, const Interval& within) {
    const unsigned n[3] = {nx, ny, nz};
    const Vec3 max{min.x + nx * cell.x, min.y + ny * cell.y, min.z + nz * cell.z};
    const auto inside = ch05_box::box_clip(ray, within, min, max);
    if (!inside) {
        return {};
    }
    std::vector<double> crossed{inside->min, inside->max};
    for (int axis = 0; axis < 3; axis++) {
        for (unsigned i = 0; i <= n[axis]; i++) {
            const double t = (min[axis] + i * cell[axis] - ray.origin[axis]) / ray.direction[axis];
            if (inside->min < t && t < inside->max) {
                crossed.push_back(t);
            }
        }
    }
    std::sort(crossed.begin(), crossed.end());
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
    std::vector<Visit> visits;
    for (std::size_t i = 1; i < crossed.size(); i++) {
        const Vec3 middle = ray.origin + 0.5 * (crossed[i - 1] + crossed[i]) * ray.direction;
        unsigned at[3];
        for (int axis = 0; axis < 3; axis++) {
            const double place = std::floor((middle[axis] - min[axis]) / cell[axis]);
            at[axis] = static_cast<unsigned>(std::clamp(place, 0.0, n[axis] - 1.0));
        }
        visits.push_back({at[0], at[1], at[2], crossed[i]});
    }
    return visits;
}

}
