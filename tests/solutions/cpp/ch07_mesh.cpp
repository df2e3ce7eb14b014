// Chapter 7: Mesh.

#include "raybook/ch07_mesh.hpp"

#include "raybook/ch06_triangle.hpp"

namespace ch07_mesh {

Vec3 interpolate_normal(const Vec3& n0, const Vec3& n1, const Vec3& n2, const Vec2& b) {
    return unit(n0 + b.x * (n1 - n0) + b.y * (n2 - n0));
}

Vec2 interpolate_texture(const Vec2& t0, const Vec2& t1, const Vec2& t2, const Vec2& b) {
    return t0 + b.x * (t1 - t0) + b.y * (t2 - t0);
}

// A cross product is as long as twice the area.
std::vector<Vec3> vertex_normals(const std::vector<Vec3>& positions, const std::vector<Indices>& triangles) {
    std::vector<Vec3> normals(positions.size());
    for (const Indices& t : triangles) {
        const Vec3 area = cross(positions[t.b] - positions[t.a], positions[t.c] - positions[t.a]);
        for (const unsigned vertex : {t.a, t.b, t.c}) {
            normals[vertex] = normals[vertex] + area;
        }
    }
    for (Vec3& normal : normals) {
        normal = length(normal) > 0 ? unit(normal) : Vec3{0, 1, 0};
    }
    return normals;
}

std::optional<MeshHitAnswer> mesh_hit(
    const Ray& ray, const Interval& within, const std::vector<Corners>& triangles) {
    std::optional<MeshHitAnswer> nearest;
    Interval left = within;
    for (unsigned id = 0; id < triangles.size(); id++) {
        const Corners& t = triangles[id];
        if (const auto hit = ch06_triangle::triangle_hit(ray, left, t.p0, t.p1, t.p2)) {
            left.max = hit->t;
            nearest = MeshHitAnswer{hit->t, id};
        }
    }
    return nearest;
}

}
