//! The questions of `octree_walk`.

use crate::{Edge, sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch10_octree::{OctreeWalk, OctreeWalkQuestion};
use raybook_workbook::octree_rows::NodeRow;
use glam::{Vec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<OctreeWalk>> {
    let q = |origin: Vec3, toward: Vec3, within| OctreeWalkQuestion {
        ray: Ray::new(origin, Dir3::new_or(toward, Dir3::X)),
        within,
        min: Vec3::ZERO,
        max: Vec3::splat(8.0),
        nodes: full_tree(),
    };
    let ahead = Interval::AHEAD;
    vec![
        Edge::new(
            "upwards through the lower row",
            q(vec3(-2.0, 1.0, 3.0), Vec3::X, ahead),
        ),
        Edge::new(
            "downwards along x",
            q(vec3(11.0, 1.0, 3.0), -Vec3::X, ahead),
        ),
        Edge::new(
            "along −z with −0.0 in x and y",
            q(vec3(5.0, 5.0, 20.0), vec3(-0.0, -0.0, -1.0), ahead),
        ),
        Edge::new("in a middle plane", q(vec3(4.0, 1.0, -1.0), Vec3::Z, ahead)),
        Edge::new(
            "in two middle planes, with −0.0",
            q(vec3(4.0, 4.0, 9.0), vec3(-0.0, 0.0, -1.0), ahead),
        ),
        Edge::new(
            "in a face of the root",
            q(vec3(0.0, 3.0, -1.0), Vec3::Z, ahead),
        ),
        Edge::new(
            "through the centre",
            q(vec3(-1.0, -1.0, -1.0), Vec3::ONE, ahead),
        ),
        Edge::new(
            "from inside",
            q(vec3(5.0, 5.0, 5.0), vec3(-1.0, -0.6, -0.4), ahead),
        ),
        Edge::new(
            "from inside, away from most leaves",
            q(vec3(5.0, 1.5, 1.0), vec3(1.0, 0.1, 0.05), ahead),
        ),
        Edge::new(
            "ends in the first half",
            q(
                vec3(-2.0, 1.2, 3.0),
                vec3(1.0, 0.3, 0.1),
                Interval::new(0.0, 5.0),
            ),
        ),
        Edge::new(
            "begins in the second half",
            q(
                vec3(-2.0, 1.2, 3.0),
                vec3(1.0, 0.3, 0.1),
                Interval::new(7.0, 30.0),
            ),
        ),
        Edge::new(
            "passes the root by",
            q(vec3(-2.0, 9.0, 3.0), vec3(1.0, 0.1, 0.1), ahead),
        ),
        Edge::new(
            "the root is a leaf",
            OctreeWalkQuestion {
                nodes: vec![leaf(0, 3)],
                ..q(vec3(-1.0, 2.0, 2.0), vec3(1.0, 0.1, 0.2), ahead)
            },
        ),
        Edge::new(
            "the root is an empty leaf",
            OctreeWalkQuestion {
                nodes: vec![leaf(0, 0)],
                ..q(vec3(-1.0, 2.0, 2.0), vec3(1.0, 0.1, 0.2), ahead)
            },
        ),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> OctreeWalkQuestion {
    let (min, size) = (sample::point(rng, 3.0), sample::number(rng, 1.0, 6.0));
    let mut nodes = vec![inner(1)];
    let mut names = 0;
    let mut add_leaf = |rng: &mut Pcg| {
        let count = if rng.random_bool(0.25) {
            0
        } else {
            rng.random_range(1..4)
        };
        names += count;
        leaf(names - count, count)
    };
    for _ in 0..8 {
        nodes.push(add_leaf(rng));
    }
    for child in 1..9 {
        if rng.random_bool(0.35) {
            nodes[child] = inner(nodes.len() as u32);
            for _ in 0..8 {
                nodes.push(add_leaf(rng));
            }
        }
    }
    let inside = min + size * (sample::point(rng, 0.35) + 0.5);
    let origin = if rng.random_bool(0.3) {
        min + size * (sample::point(rng, 0.5) + 0.5)
    } else {
        inside + size * 1.5 * *sample::direction(rng)
    };
    let end = if rng.random_bool(0.3) {
        size
    } else {
        f32::INFINITY
    };
    OctreeWalkQuestion {
        ray: Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X)),
        within: Interval::new(0.0, end),
        min,
        max: min + size,
        nodes,
    }
}

pub(super) fn leaf(first: u32, count: u32) -> NodeRow {
    NodeRow {
        inner: 0,
        first,
        count,
    }
}

fn inner(first: u32) -> NodeRow {
    NodeRow {
        inner: 1,
        first,
        count: 0,
    }
}

/// A root whose children 0 and 5 are cut once more; every leaf holds one shape.
fn full_tree() -> Vec<NodeRow> {
    let mut nodes = vec![inner(1)];
    nodes.extend((1..25).map(|i| leaf(i - 1, 1)));
    nodes[1] = inner(9);
    nodes[6] = inner(17);
    nodes
}
