//! The questions of `octree_walk`.

use crate::{sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch10_octree::OctreeWalk;
use raybook_workbook::octree_rows::NodeRow;
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> OctreeWalk {
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
    OctreeWalk {
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
