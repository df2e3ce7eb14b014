//! A quad-tree: an octree in the plane.

use crate::kit::{figure::Figure, palette::SKY};
use crate::shared::flatland::{SIDE, discs, plane, ray};
use glam::Vec3;
use raybook::accel::octree::build::Limits;
use raybook::inside::octree::{Kind, Walk, build};
use raybook::math::{aabb::Aabb, interval::Interval};

/// The quad-tree of some discs, and the leaves that a ray visits, numbered in order; darker leaves are deeper.
///
/// The tree is an octree of shapes at the bottom of its cube: of each cut, only the lower four children hold shapes.
///
/// # Errors
/// What plotters reports.
pub(super) fn diagram() -> Figure {
    let cube = Aabb {
        min: Vec3::ZERO,
        max: Vec3::splat(SIDE),
    };
    let discs = discs();
    let limits = Limits {
        opening: 1.0,
        depth: 5,
        ..Limits::USUAL
    };
    let tree = build(cube, discs.len() as u32, limits, &|i, cells| {
        let Aabb { min, max } = discs[i as usize];
        let reached = |cell: &Aabb| min.cmple(cell.max).all() && cell.min.cmple(max).all();
        (0..8).fold(0, |bits, i| bits | u8::from(reached(&cells[i])) << i)
    });
    let mut walk = Walk::new(&tree, &ray(), Interval::AHEAD);
    let visited: Vec<_> = std::iter::from_fn(|| walk.next_leaf(f32::INFINITY, &mut ())).collect();
    plane(|plane| {
        let places = tree.places();
        let flat = || places.iter().filter(|place| place.cell.min.z == 0.0);
        for place in flat() {
            if let Kind::Leaf { .. } = tree.nodes[place.node as usize].kind() {
                let depth = (SKY, 0.09 * f64::from(place.depth));
                plane.cell(&place.cell, Some(depth), 3)?;
            }
        }
        for place in flat() {
            if let Some(at) = visited.iter().position(|&leaf| leaf == place.node) {
                plane.visited(&place.cell, at + 1, 3)?;
            }
        }
        Ok(())
    })
}
