//! The questions of `collapse`.

use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{COST, Cost, build};
use crate::{Edge, sample};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch24_wide_bvh::{Collapse, CollapseQuestion};
use raybook_workbook::tree_rows::{NodeRow, to_rows};
use glam::{Vec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<Collapse>> {
    let row = |n: usize, size: fn(usize) -> f32| {
        let boxes: Vec<_> = (0..n)
            .map(|i| {
                let at = vec3(3.0 * i as f32, 0.0, 0.0);
                Aabb {
                    min: at,
                    max: at + Vec3::splat(size(i)),
                }
            })
            .collect();
        binary_tree(&boxes)
    };
    let one = |_: usize| 1.0;
    let square: Vec<_> = (0..16)
        .map(|i| {
            let at = 2.0 * vec3((i % 4) as f32, (i / 4) as f32, 0.0);
            Aabb {
                min: at,
                max: at + Vec3::ONE,
            }
        })
        .collect();
    vec![
        Edge::new("no boxes", row(0, one)),
        Edge::new("a single leaf", row(1, one)),
        Edge::new("two leaves", row(2, one)),
        Edge::new("seven leaves: one node with a place left", row(7, one)),
        Edge::new("eight leaves: one full node", row(8, one)),
        Edge::new("nine leaves: one too many", row(9, one)),
        Edge::new("sixty-four leaves", row(64, one)),
        Edge::new("boxes that grow", row(20, |i| 0.1 + 0.2 * i as f32)),
        Edge::new("a chain: every branch has a leaf", chain(20)),
        Edge::new("a square of sixteen", binary_tree(&square)),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> CollapseQuestion {
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
fn binary_tree(boxes: &[Aabb]) -> CollapseQuestion {
    let cost = Cost { most: 1, ..COST };
    CollapseQuestion {
        nodes: to_rows(&build(boxes, Method::Binned, &cost)),
    }
}

/// A tree in which each branch has a leaf and the rest.
fn chain(n: u32) -> CollapseQuestion {
    let node = |i: u32, first, count| NodeRow {
        min: vec3(i as f32, 0.0, 0.0),
        max: vec3(if count == 0 { n as f32 } else { i as f32 + 1.0 }, 1.0, 1.0),
        first,
        count,
    };
    let mut nodes = vec![node(0, 1, 0)];
    for i in 0..n - 1 {
        nodes.push(node(i, i, 1));
        let last = i + 2 == n;
        nodes.push(if last {
            node(i + 1, i + 1, 1)
        } else {
            node(i + 1, 2 * i + 3, 0)
        });
    }
    CollapseQuestion { nodes }
}
