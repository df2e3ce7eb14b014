//! The questions of `collapse`.

use raybook::accel::bvh::COST;
use raybook::accel::bvh::build::{Method, build, cost::Cost};
use crate::{sample};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch24_wide_bvh::Collapse;
use raybook_workbook::tree_rows::to_rows;
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> Collapse {
    let boxes: Vec<_> = (0..rng.random_range(14..40))
        .map(|_| {
            let (at, size) = (sample::point(rng, 4.0), sample::number(rng, 0.05, 2.0));
            Aabb {
                min: at,
                max: at + size * (sample::point(rng, 0.4) + 0.5),
            }
        })
        .collect();
    binary_tree(&boxes)
}

/// A binary tree over boxes, one in each leaf.
fn binary_tree(boxes: &[Aabb]) -> Collapse {
    let cost = Cost { most: 1, ..COST };
    Collapse {
        nodes: to_rows(&build(boxes, Method::Binned, &cost)),
    }
}
