// Chapter 10: Octree.

#include "raybook/ch10_octree.hpp"

#include "raybook/ch05_box.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ch10_octree {

unsigned octree_child(const Vec3& min, const Vec3& max, const Vec3& p) {
    const Vec3 middle = 0.5 * (min + max);
    return (p.x >= middle.x) + 2U * (p.y >= middle.y) + 4U * (p.z >= middle.z);
}

// The cell of a child.
static Corners child(const Corners& cell, unsigned i) {
    const Vec3 middle = 0.5 * (cell.min + cell.max);
    Corners half = cell;
    for (int axis = 0; axis < 3; axis++) {
        (i >> axis & 1 ? half.min : half.max)[axis] = middle[axis];
    }
    return half;
}

static bool overlap(const Corners& a, const Corners& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y
        && a.min.z <= b.max.z && b.min.z <= a.max.z;
}

namespace {

// By recursion; the eight children get their numbers before any of them is built.
struct Builder {
    const std::vector<Corners>& shapes;
    double opening;
    TreeRow tree{};

    void fill(unsigned node, const Corners& cell, const std::vector<unsigned>& inside, double copies,
        unsigned depth) {
        std::vector<unsigned> parts[8];
        std::size_t after = 0;
        for (unsigned i = 0; i < 8; i++) {
            for (const unsigned shape : inside) {
                if (overlap(shapes[shape], child(cell, i))) {
                    parts[i].push_back(shape);
                }
            }
            after += parts[i].size();
        }
        const double before = static_cast<double>(inside.size());
        const double growth = static_cast<double>(after) / before;
        const bool pays = opening + 0.25 * static_cast<double>(after) < before;
        if (!pays || depth == 0 || growth > copies) {
            const auto first = static_cast<unsigned>(tree.names.size());
            tree.nodes[node] = {0, first, static_cast<unsigned>(inside.size())};
            tree.names.insert(tree.names.end(), inside.begin(), inside.end());
            return;
        }
        const auto first = static_cast<unsigned>(tree.nodes.size());
        tree.nodes[node] = {1, first, 0};
        tree.nodes.resize(first + 8);
        for (unsigned i = 0; i < 8; i++) {
            fill(first + i, child(cell, i), parts[i], copies / std::max(growth, 1.0), depth - 1);
        }
    }
};

}

TreeRow octree_build(const Vec3& min, const Vec3& max, double opening, double copies, unsigned depth,
    const std::vector<Corners>& shapes) {
    std::vector<unsigned> all(shapes.size());
    std::iota(all.begin(), all.end(), 0U);
    Builder builder{shapes, opening};
    builder.tree.nodes.resize(1);
    builder.fill(0, {min, max}, all, copies, depth);
    return builder.tree;
}

// All leaves in which the ray stays for a while, sorted by the middle of the stay.
std::vector<unsigned> octree_walk(const Ray& ray, const Interval& within, const Vec3& min, const Vec3& max,
    const std::vector<NodeRow>& nodes) {
    std::vector<std::pair<double, unsigned>> stays;
    std::vector<std::pair<unsigned, Corners>> to_do{{0U, {min, max}}};
    while (!to_do.empty()) {
        const auto [number, cell] = to_do.back();
        to_do.pop_back();
        const auto inside = ch05_box::box_clip(ray, within, cell.min, cell.max);
        if (!inside || inside->max - inside->min <= 1e-9) {
            continue;
        }
        const NodeRow& node = nodes[number];
        if (node.inner != 0) {
            for (unsigned i = 0; i < 8; i++) {
                to_do.push_back({node.first + i, child(cell, i)});
            }
        } else if (node.count > 0) {
            stays.push_back({inside->min + inside->max, number});
        }
    }
    std::sort(stays.begin(), stays.end());
    std::vector<unsigned> leaves;
    for (const auto& stay : stays) {
        leaves.push_back(stay.second);
    }
    return leaves;
}

}
