// Chapter 22: Antialiasing.

#include "raybook/ch22_antialiasing.hpp"

#include <algorithm>
#include <random>

namespace ch22_antialiasing {

namespace {

struct Random {
    std::mt19937 generator;

    double operator()() { return std::uniform_real_distribution<double>()(generator); }
};

}

std::vector<Vec2> regular_grid(unsigned x, unsigned y, unsigned columns, unsigned rows) {
    std::vector<Vec2> points;
    for (unsigned i = 0; i < columns * rows; i++) {
        points.push_back({x + (i % columns + 0.5) / columns, y + (i / columns + 0.5) / rows});
    }
    return points;
}

// Clockwise.
std::vector<Vec2> rotated_grid(double spacing, const Vec2& offset) {
    const double cosine = std::cos(std::atan(0.5)), sine = -std::sin(std::atan(0.5));
    const int reach = static_cast<int>(std::ceil(1 / spacing) + std::ceil(std::abs(offset.x) + std::abs(offset.y))) + 1;
    std::vector<Vec2> points;
    for (int i = -reach; i <= reach; i++) {
        for (int j = -reach; j <= reach; j++) {
            const double a = i + offset.x, b = j + offset.y;
            const Vec2 p{0.5 + spacing * (cosine * a - sine * b), 0.5 + spacing * (sine * a + cosine * b)};
            if (p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) {
                points.push_back(p);
            }
        }
    }
    return points;
}

std::vector<Vec2> random_pattern(unsigned n, unsigned seed) {
    Random random{std::mt19937(seed)};
    std::vector<Vec2> points(n);
    for (Vec2& p : points) {
        p.x = random();
        p.y = random();
    }
    return points;
}

std::vector<Vec2> jittered(unsigned columns, unsigned rows, unsigned seed) {
    Random random{std::mt19937(seed)};
    std::vector<Vec2> points;
    for (unsigned i = 0; i < columns * rows; i++) {
        const double x = random(), y = random();
        points.push_back({(i % columns + x) / columns, (i / columns + y) / rows});
    }
    return points;
}

// Darts, until three thousand in a row are too near to another.
std::vector<Vec2> poisson_disk(double distance, unsigned seed) {
    Random random{std::mt19937(seed)};
    std::vector<Vec2> points;
    for (int missed = 0; missed < 3000; missed++) {
        const double x = random(), y = random();
        if (std::all_of(points.begin(), points.end(),
                [&](const Vec2& p) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y) >= distance * distance; })) {
            points.push_back({x, y});
            missed = 0;
        }
    }
    return points;
}

Rgb pixel_average(double radius, const std::vector<Seen>& samples) {
    const auto tent = [&](double x) { return std::fmax((radius - std::abs(x)) / radius, 0); };
    double total = 0;
    Rgb sum;
    for (const Seen& sample : samples) {
        const double weight = tent(sample.offset.x) * tent(sample.offset.y);
        total += weight;
        sum = sum + weight * sample.radiance;
    }
    return total > 0 ? 1 / total * sum : Rgb{};
}

}
