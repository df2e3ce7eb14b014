//! A mesh as the blocks that an octree makes of it.

use crate::shared::showroom::SMOOTH;
use glam::Vec3;
use raybook::accel::octree::Octree;
use raybook::image::rgb::Rgb;
use raybook::inside::octree::{self, Kind, Place};
use raybook::math::ray::Ray;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::{Hit, Shape, Surface, cuboid::Cuboid};

/// The cells that are not empty, as blocks: cells after `depth(place)` cuts, or leaves that come before.
pub(super) fn cells(octree: &Octree<Facet>, depth: impl Fn(Vec3) -> u32) -> Vec<Cuboid> {
    let tree = octree::tree(octree);
    let is_shown = |place: &Place| {
        let depth = depth(place.cell.center());
        match tree.nodes[place.node as usize].kind() {
            Kind::Inner { .. } => place.depth == depth,
            Kind::Leaf { count, .. } => place.depth <= depth && count > 0,
        }
    };
    let shown = tree.places().into_iter().filter(is_shown);
    shown.map(|place| Cuboid { bounds: place.cell }).collect()
}

/// The colour of a block where a ray hits it: clay, with darker edges.
pub(super) fn shade(block: &Cuboid, ray: &Ray, hit: &Hit) -> Rgb {
    let at = block.surface(ray, hit);
    let to_edge = (at.position - block.bounds.center()).abs() / block.bounds.size();
    let near_two_faces = to_edge.cmpgt(Vec3::splat(0.46)).bitmask().count_ones() > 1;
    let smooth = Surface {
        shading_normal: at.normal,
        ..at
    };
    SMOOTH(ray, hit, &smooth) * if near_two_faces { 0.6 } else { 1.0 }
}

/// The number of cuts of the blocks of [`dissolving`], from left to right.
pub(super) const CUTS: [u32; 4] = [7, 6, 5, 4];

/// The mesh turning into blocks from left to right, after [`CUTS`] cuts: the blocks, and the facets that are kept.
pub(super) fn dissolving(mesh: &Mesh, octree: &Octree<Facet>) -> (Vec<Cuboid>, Vec<Facet>) {
    /// The first of 16 columns for each number of cuts.
    const FROM: [f32; 4] = [7.0, 10.0, 12.0, 14.0];
    let root = octree::tree(octree).bounds;
    let column = |p: Vec3| 16.0 * (p.x - root.min.x) / root.size().x;
    let depth = |p: Vec3| {
        let found = FROM.iter().rposition(|from| column(p) >= *from);
        found.map_or(0, |i| CUTS[i])
    };
    let is_kept = |facet: &Facet| depth(facet.corners.iter().sum::<Vec3>() / 3.0) == 0;
    let kept = mesh.facets().into_iter().filter(is_kept).collect();
    (cells(octree, depth), kept)
}
