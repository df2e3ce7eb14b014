// Chapter 24: Wide BVH.

#include "raybook/ch24_wide_bvh.hpp"

#include "raybook/ch05_box.hpp"
#include "raybook/ch06_triangle.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

namespace ch24_wide_bvh {

static double area(const NodeRow& node) {
    const Vec3 size = node.max - node.min;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The children of a branch are sorted after each opening, and the largest branch among them is the next.
std::vector<FamilyRow> collapse(const std::vector<NodeRow>& nodes) {
    std::vector<FamilyRow> families;
    std::vector<unsigned> waiting(nodes.empty() ? 0 : 1);
    while (!waiting.empty()) {
        const unsigned branch = waiting.back();
        waiting.pop_back();
        if (nodes[branch].count > 0) {
            continue;
        }
        std::vector<unsigned> children{branch};
        while (children.size() < 8) {
            std::stable_sort(children.begin(), children.end(),
                [&](unsigned a, unsigned b) { return area(nodes[a]) > area(nodes[b]); });
            const auto largest = std::find_if(
                children.begin(), children.end(), [&](unsigned i) { return nodes[i].count == 0; });
            if (largest == children.end()) {
                break;
            }
            const unsigned left = nodes[*largest].first;
            *largest = left;
            children.push_back(left + 1);
        }
        families.push_back({branch, children});
        waiting.insert(waiting.end(), children.begin(), children.end());
    }
    return families;
}

// The nearest box of all that wait, wherever it is.
WideClosestAnswer wide_closest(const Ray& ray, const Interval& within, const std::vector<WideNode>& nodes,
    const std::vector<WideLeaf>& leaves, const std::vector<Corners>& triangles) {
    WideClosestAnswer answer;
    Interval left = within;
    using Waiting = std::tuple<double, unsigned, unsigned>; // where the ray enters it, whether it is a leaf, its number
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
    if (!nodes.empty()) {
        waiting.push({within.min, 0, 0});
    }
    const Vec3 grown{1e-6, 1e-6, 1e-6};
    while (!waiting.empty()) {
        const auto [enter, leaf, index] = waiting.top();
        waiting.pop();
        if (answer.hit && enter > answer.hit->t) {
            break;
        }
        if (leaf != 0) {
            for (const unsigned id : leaves[index].triangles) {
                answer.tests++;
                const Corners& t = triangles[id];
                if (const auto hit = ch06_triangle::triangle_hit(ray, left, t.p0, t.p1, t.p2)) {
                    left.max = hit->t;
                    answer.hit = MeshHitAnswer{hit->t, id};
                }
            }
            continue;
        }
        answer.nodes++;
        for (const WideChild& child : nodes[index].children) {
            if (const auto inside = ch05_box::box_clip(ray, left, child.min - grown, child.max + grown)) {
                waiting.push({inside->min, child.leaf, child.index});
            }
        }
    }
    return answer;
}

}
