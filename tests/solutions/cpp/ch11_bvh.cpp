// Chapter 11: Bounding volume hierarchy.

#include "raybook/ch11_bvh.hpp"

#include "raybook/ch05_box.hpp"
#include "raybook/ch06_triangle.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <numeric>
#include <utility>

namespace ch11_bvh {

using Numbers = std::vector<unsigned>;

static double area(const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low;
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

// From the last node to the first: children come after their parents.
double sah_cost(double branch, double shape, const std::vector<NodeRow>& nodes) {
    std::vector<double> price(nodes.size());
    for (std::size_t i = nodes.size(); i-- > 0;) {
        const NodeRow& node = nodes[i];
        const double own = area(node.min, node.max);
        price[i] = node.count > 0 ? own * shape * node.count
                                  : own * branch + price[node.first] + price[node.first + 1];
    }
    return nodes.empty() ? 0 : price[0] / area(nodes[0].min, nodes[0].max);
}

static BoxRow both(const BoxRow& a, const BoxRow& b) {
    BoxRow all = a;
    for (int axis = 0; axis < 3; axis++) {
        all.min[axis] = std::min(a.min[axis], b.min[axis]);
        all.max[axis] = std::max(a.max[axis], b.max[axis]);
    }
    return all;
}

static BoxRow around(const std::vector<BoxRow>& boxes, const Numbers& which) {
    return std::accumulate(which.begin(), which.end(), boxes[which[0]],
        [&](const BoxRow& all, unsigned i) { return both(all, boxes[i]); });
}

namespace {

struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    Numbers left{}, right{};
};

}

// All cuts along all axes; the areas of the right sides come first.
static Cut best_cut(const std::vector<BoxRow>& boxes, Numbers order) {
    Cut best;
    for (int axis = 0; axis < 3; axis++) {
        std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) {
            return boxes[a].min[axis] + boxes[a].max[axis] < boxes[b].min[axis] + boxes[b].max[axis];
        });
        std::vector<double> right(order.size());
        BoxRow all = boxes[order.back()];
        for (std::size_t i = order.size(); i-- > 0;) {
            all = both(all, boxes[order[i]]);
            right[i] = area(all.min, all.max);
        }
        all = boxes[order[0]];
        for (std::size_t at = 1; at < order.size(); at++) {
            all = both(all, boxes[order[at - 1]]);
            const double left = area(all.min, all.max);
            const double cost = left * static_cast<double>(at) + right[at] * static_cast<double>(order.size() - at);
            if (cost < best.cost) {
                const auto middle = order.begin() + static_cast<std::ptrdiff_t>(at);
                best = {cost, {order.begin(), middle}, {middle, order.end()}};
            }
        }
    }
    return best;
}

static Numbers all_of(const std::vector<BoxRow>& boxes) {
    Numbers all(boxes.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

std::vector<unsigned> sah_split(const std::vector<BoxRow>& boxes) {
    return boxes.empty() ? Numbers{} : best_cut(boxes, all_of(boxes)).left;
}

// Breadth first: pairs of children are side by side by themselves.
BvhBuildAnswer bvh_build(unsigned most, const std::vector<BoxRow>& boxes) {
    BvhBuildAnswer tree;
    if (boxes.empty()) {
        return tree;
    }
    std::deque<Numbers> waiting{all_of(boxes)};
    unsigned made = 1;
    while (!waiting.empty()) {
        const Numbers which = waiting.front();
        waiting.pop_front();
        const BoxRow box = around(boxes, which);
        const Cut cut = best_cut(boxes, which);
        const double own = area(box.min, box.max);
        const auto count = static_cast<unsigned>(which.size());
        if (count > 1 && (count > most || own + cut.cost < own * count)) {
            tree.nodes.push_back({box.min, box.max, made, 0});
            waiting.push_back(cut.left);
            waiting.push_back(cut.right);
            made += 2;
        } else {
            tree.nodes.push_back({box.min, box.max, static_cast<unsigned>(tree.order.size()), count});
            tree.order.insert(tree.order.end(), which.begin(), which.end());
        }
    }
    return tree;
}

// With a stack, the nearer child on top; a box is skipped when a nearer hit was found since.
BvhClosestAnswer bvh_closest(const Ray& ray, const Interval& within, const std::vector<NodeRow>& nodes,
    const std::vector<Corners>& triangles) {
    BvhClosestAnswer answer;
    Interval left = within;
    std::vector<std::pair<double, unsigned>> stack;
    if (!nodes.empty()) {
        stack.push_back({within.min, 0});
    }
    while (!stack.empty()) {
        const auto [enter, number] = stack.back();
        stack.pop_back();
        if (answer.hit && enter >= left.max) {
            continue;
        }
        const NodeRow& node = nodes[number];
        for (unsigned id = node.first; id < node.first + node.count; id++) {
            answer.tests++;
            const Corners& t = triangles[id];
            if (const auto hit = ch06_triangle::triangle_hit(ray, left, t.p0, t.p1, t.p2)) {
                left.max = hit->t;
                answer.hit = MeshHitAnswer{hit->t, id};
            }
        }
        if (node.count > 0) {
            continue;
        }
        const std::size_t below = stack.size();
        for (const unsigned child : {node.first, node.first + 1}) {
            answer.boxes++;
            if (const auto inside = ch05_box::box_clip(ray, left, nodes[child].min, nodes[child].max)) {
                stack.push_back({inside->min, child});
            }
        }
        if (stack.size() == below + 2 && stack[below].first < stack[below + 1].first) {
            std::swap(stack[below], stack[below + 1]);
        }
    }
    return answer;
}

}
