// Chapter 9: Two-level grid.

#include "raybook/ch09_two_level_grid.hpp"

#include "raybook/ch05_box.hpp"
#include "raybook/ch08_grid.hpp"

#include <algorithm>
#include <utility>

namespace ch09_two_level_grid {

// The boxes of all cells, those along x first.
static std::vector<Corners> cells_of(const Vec3& low, const Vec3& high, const Resolution& n) {
    const Vec3 size{(high.x - low.x) / n.nx, (high.y - low.y) / n.ny, (high.z - low.z) / n.nz};
    std::vector<Corners> cells;
    for (unsigned i = 0; i < n.nx * n.ny * n.nz; i++) {
        const unsigned x = i % n.nx, y = i / n.nx % n.ny, z = i / n.nx / n.ny;
        const Vec3 corner{low.x + x * size.x, low.y + y * size.y, low.z + z * size.z};
        cells.push_back({corner, corner + size});
    }
    return cells;
}

// Cell by cell: which shapes overlap it?
RefineCellAnswer refine_cell(
    const Vec3& min, const Vec3& max, double density, const std::vector<Corners>& shapes) {
    if (shapes.empty()) {
        return {};
    }
    const auto along = ch08_grid::grid_resolution(max - min, static_cast<unsigned>(shapes.size()), density);
    const Resolution n{std::min(along.x, 255U), std::min(along.y, 255U), std::min(along.z, 255U)};
    RefineCellAnswer answer{n.nx, n.ny, n.nz, {}};
    const auto cells = cells_of(min, max, n);
    for (unsigned i = 0; i < cells.size(); i++) {
        for (unsigned shape = 0; shape < shapes.size(); shape++) {
            bool overlap = true;
            for (int axis = 0; axis < 3; axis++) {
                overlap = overlap && shapes[shape].min[axis] <= cells[i].max[axis]
                    && cells[i].min[axis] <= shapes[shape].max[axis];
            }
            if (overlap) {
                answer.entries.push_back({i % n.nx, i / n.nx % n.ny, i / n.nx / n.ny, shape});
            }
        }
    }
    return answer;
}

// All fine cells in which the ray stays for a while, sorted by the middle of the stay.
std::vector<unsigned> two_level_walk(const Ray& ray, const Interval& within, const Vec3& min, const Vec3& max,
    const Resolution& coarse, const std::vector<Resolution>& fine) {
    std::vector<std::pair<double, unsigned>> stays;
    unsigned place = 0;
    const auto cells = cells_of(min, max, coarse);
    for (std::size_t i = 0; i < cells.size() && i < fine.size(); i++) {
        for (const Corners& cell : cells_of(cells[i].min, cells[i].max, fine[i])) {
            const auto inside = ch05_box::box_clip(ray, within, cell.min, cell.max);
            if (inside && inside->max - inside->min > 1e-9) {
                stays.push_back({inside->min + inside->max, place});
            }
            place++;
        }
    }
    std::sort(stays.begin(), stays.end());
    std::vector<unsigned> places;
    for (const auto& stay : stays) {
        places.push_back(stay.second);
    }
    return places;
}

}
