//! `grid_walk_edges`: its cases, judge and mistakes.

use crate::grade::{Edge, sample};
use crate::math::interval::Interval;
use crate::workbook::exercises::ch08_grid::{GridWalk, GridWalkQuestion};
use glam::{Vec3, vec3};

/// A question about 4 × 3 × 2 cells of a metre.
pub(super) fn question(origin: Vec3, toward: Vec3, within: Interval) -> GridWalkQuestion {
    GridWalkQuestion {
        min: Vec3::ZERO,
        cell: Vec3::ONE,
        nx: 4,
        ny: 3,
        nz: 2,
        ray: sample::ray(origin, toward),
        within,
    }
}

/// Where it begins and ends, and whether there is one.
pub(super) fn edges_of_the_walk() -> Vec<Edge<GridWalk>> {
    let ahead = Interval::AHEAD;
    let edge = |name, origin, toward, within| Edge::new(name, question(origin, toward, within));
    let one = |q: GridWalkQuestion| GridWalkQuestion {
        nx: 1,
        ny: 1,
        nz: 1,
        ..q
    };
    vec![
        edge(
            "the interval ends inside",
            vec3(-1.0, 1.5, 0.5),
            vec3(1.0, 0.1, 0.0),
            Interval::new(0.0, 3.3),
        ),
        edge(
            "the interval begins inside",
            vec3(-1.0, 1.5, 0.5),
            vec3(1.0, 0.1, 0.0),
            Interval::new(2.7, f32::INFINITY),
        ),
        edge(
            "the interval ends before it",
            vec3(-1.0, 1.5, 0.5),
            Vec3::X,
            Interval::new(0.0, 0.5),
        ),
        edge("it is behind", vec3(-1.0, 1.5, 0.5), Vec3::NEG_X, ahead),
        edge("beside it, parallel", vec3(-1.0, 3.5, 0.5), Vec3::X, ahead),
        Edge::new(
            "a single cell",
            one(question(vec3(-1.0, 0.2, 0.3), vec3(1.0, 0.3, 0.1), ahead)),
        ),
        edge(
            "from far away",
            vec3(-300.0, 200.0, 100.0),
            vec3(302.1, -198.4, -99.1),
            ahead,
        ),
    ]
}
