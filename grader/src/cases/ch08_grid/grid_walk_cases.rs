//! The questions of `grid_walk`.

use crate::{Edge, sample};
use raybook::math::aabb::Aabb;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray, slab};
use raybook_workbook::exercises::ch08_grid::{GridWalk, GridWalkQuestion, Visit};
use glam::{Vec3, uvec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<GridWalk>> {
    let ahead = Interval::AHEAD;
    let edge = |name, origin, toward, within| Edge::new(name, question(origin, toward, within));
    let beside = |y: u32, from: f32| {
        (0..4)
            .map(|x| Visit {
                x,
                y,
                z: 0,
                leave: from + (x + 1) as f32,
            })
            .collect()
    };
    let mut edges = vec![
        edge("along x", vec3(-1.0, 1.5, 0.5), Vec3::X, ahead),
        edge("along −x", vec3(5.0, 1.5, 0.5), Vec3::NEG_X, ahead),
        edge(
            "along z, with negative zeros",
            vec3(2.5, 0.5, -1.0),
            vec3(-0.0, -0.0, 1.0),
            ahead,
        ),
        edge("askew", vec3(-0.7, 0.2, -0.3), vec3(3.0, 1.7, 1.1), ahead),
        edge(
            "askew and back",
            vec3(4.9, 3.1, 2.3),
            vec3(-3.0, -1.9, -1.3),
            ahead,
        ),
        edge(
            "from inside",
            vec3(1.3, 2.6, 0.4),
            vec3(2.0, -1.7, 0.3),
            ahead,
        ),
        edge("from a plane on", vec3(1.0, 1.5, 0.5), Vec3::X, ahead),
        edge(
            "from a plane back",
            vec3(2.0, 1.5, 0.5),
            vec3(-1.0, 0.2, 0.1),
            ahead,
        ),
        edge(
            "from the last face inwards",
            vec3(4.0, 1.2, 0.7),
            vec3(-1.0, 0.3, 0.1),
            ahead,
        ),
        edge(
            "through edges",
            vec3(-1.0, -1.0, 0.5),
            vec3(1.0, 1.0, 0.0),
            ahead,
        ),
        edge("through corners", vec3(-1.0, -1.0, -1.0), Vec3::ONE, ahead),
        edge(
            "in the plane between two layers",
            vec3(-1.0, 1.0, 0.5),
            Vec3::X,
            ahead,
        )
        .or(beside(0, 1.0)),
    ];
    edges.extend(edges_of_the_walk());
    edges
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> GridWalkQuestion {
    let mut count = || rng.random_range(1..7_u32);
    let n = uvec3(count(), count(), count());
    let cell = vec3(1.0, 0.7, 1.2) * sample::number(rng, 0.4, 1.5);
    let min = sample::point(rng, 3.0);
    let (center, half) = (min + 0.5 * n.as_vec3() * cell, 0.5 * n.as_vec3() * cell);
    let origin = center + sample::point(rng, 1.8) * half;
    let aim = center + sample::point(rng, 0.9) * half;
    let ray = Ray::new(origin, Dir3::new_or(aim - origin, Dir3::X));
    let bounds = Aabb {
        min,
        max: min + 2.0 * half,
    };
    // From the middle of what is inside, or up to there.
    let inside = slab::clip(&bounds, &ray, Interval::AHEAD).unwrap_or(Interval::AHEAD);
    let middle = 0.5 * (inside.min + inside.max);
    let within = match rng.random_range(0..6) {
        0 => Interval::new(0.0, middle),
        1 | 2 => Interval::new(middle, f32::INFINITY),
        _ => Interval::AHEAD,
    };
    GridWalkQuestion {
        min,
        cell,
        nx: n.x,
        ny: n.y,
        nz: n.z,
        ray,
        within,
    }
}

/// A question about 4 × 3 × 2 cells of a metre.
fn question(origin: Vec3, toward: Vec3, within: Interval) -> GridWalkQuestion {
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
fn edges_of_the_walk() -> Vec<Edge<GridWalk>> {
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
