//! The questions of `voxels_of_triangle`.

use crate::{Edge, sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch08_grid::{VoxelsOfTriangle, VoxelsOfTriangleQuestion};
use glam::{Vec3, uvec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<VoxelsOfTriangle>> {
    let edge = |name, [p0, p1, p2]: [Vec3; 3], margin| {
        Edge::new(
            name,
            VoxelsOfTriangleQuestion {
                min: vec3(-2.0, 0.0, 1.0),
                cell: vec3(1.0, 1.0, 1.0),
                nx: 4,
                ny: 4,
                nz: 3,
                margin,
                p0,
                p1,
                p2,
            },
        )
    };
    let slanting = [
        vec3(-1.8, 0.2, 1.2),
        vec3(1.8, 0.4, 3.8),
        vec3(-0.3, 3.7, 2.4),
    ];
    let small = [
        vec3(0.2, 1.3, 2.4),
        vec3(0.6, 1.4, 2.5),
        vec3(0.3, 1.7, 2.6),
    ];
    let moved = |triangle: [Vec3; 3], by| triangle.map(|p: Vec3| p + by);
    vec![
        edge("in one cell", small, 0.0),
        edge("slanting through many", slanting, 0.0),
        edge(
            "flat in the middle of a layer",
            [
                vec3(-1.7, 1.5, 1.3),
                vec3(1.6, 1.5, 1.4),
                vec3(-1.6, 1.5, 3.7),
            ],
            0.01,
        ),
        edge(
            "a needle",
            [
                vec3(-1.9, 0.3, 1.4),
                vec3(1.9, 3.6, 3.7),
                vec3(1.9, 3.61, 3.7),
            ],
            0.0,
        ),
        edge(
            "a triangle without area",
            [
                vec3(-1.5, 0.4, 1.6),
                vec3(0.4, 2.3, 1.7),
                vec3(1.35, 3.25, 1.75),
            ],
            0.0,
        ),
        edge("a point", [vec3(0.3, 2.6, 1.4); 3], 0.0),
        edge(
            "just before a plane, with a margin",
            moved(small, vec3(0.35, 0.0, 0.0)),
            0.1,
        ),
        edge(
            "just before a corner, with a margin",
            moved(small, vec3(0.37, 0.26, 0.36)),
            0.1,
        ),
        edge("half outside", moved(slanting, vec3(2.0, 1.5, 0.0)), 0.0),
        edge("all outside", moved(slanting, vec3(0.0, 6.0, 0.0)), 0.0),
        edge(
            "past the corner of a cell of its bounding box",
            [
                vec3(-0.9, 0.1, 1.5),
                vec3(0.9, 1.9, 1.5),
                vec3(0.9, 1.9, 1.6),
            ],
            0.0,
        ),
        edge(
            "larger than the lattice",
            slanting.map(|p| 4.0 * p - vec3(0.0, 3.0, 6.0)),
            0.0,
        ),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> VoxelsOfTriangleQuestion {
    let cell = vec3(1.0, 0.8, 1.1) * sample::number(rng, 0.5, 1.5);
    let min = sample::point(rng, 3.0);
    let n = uvec3(
        rng.random_range(2..6),
        rng.random_range(2..6),
        rng.random_range(2..5),
    );
    let extents = n.as_vec3() * cell;
    let center = min + 0.5 * extents;
    let half = 0.5 * sample::number(rng, 0.5, 1.1) * extents;
    let mut corner = || center + sample::point(rng, 1.0) * half;
    let (p0, p1, p2) = (corner(), corner(), corner());
    VoxelsOfTriangleQuestion {
        min,
        cell,
        nx: n.x,
        ny: n.y,
        nz: n.z,
        margin: sample::number(rng, 0.0, 0.15),
        p0,
        p1,
        p2,
    }
}
