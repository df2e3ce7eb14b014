//! A mesh as the blocks that an octree makes of it.

use crate::shared::{showroom::SMOOTH, showroom::Showroom};
use glam::Vec3;
use raybook::accel::Accel;
use raybook::accel::octree::Octree;
use raybook::image::Image;
use raybook::inside::octree::{self, Kind, Place};
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::{Shape, Surface, cuboid::Cuboid};

/// The cells that are not empty, as blocks: after so many cuts as `depth` says for a cell's place, or leaves before.
pub fn cells(octree: &Octree<Facet>, depth: impl Fn(Vec3) -> u32) -> Vec<Cuboid> {
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

/// A picture of blocks, and of those facets of the mesh that are kept, all of clay.
pub fn picture(film: &Film, mesh: &Mesh, blocks: Vec<Cuboid>, kept: Vec<Facet>) -> Image {
    let room = Showroom::around(mesh, film.aspect());
    let (blocks, kept) = (Octree::new(blocks), Octree::of_facets(kept));
    film.render(|place, _| {
        let ray = room.ray(place);
        let facet = kept.closest(&ray, Interval::AHEAD);
        let before = facet.map_or(Interval::AHEAD, |(_, hit)| Interval::AHEAD.before(hit.t));
        if let Some((block, hit)) = blocks.closest(&ray, before) {
            let at = block.surface(&ray, &hit);
            let to_edge = (at.position - block.bounds.center()).abs() / block.bounds.size();
            let near_two_faces = to_edge.cmpgt(Vec3::splat(0.46)).bitmask().count_ones() > 1;
            let smooth = Surface {
                shading_normal: at.normal,
                ..at
            };
            return SMOOTH(&ray, &hit, &smooth) * if near_two_faces { 0.6 } else { 1.0 };
        }
        facet.map_or_else(
            || room.backdrop(place, &ray),
            |(_, hit)| SMOOTH(&ray, &hit, &mesh.surface(&ray, &hit)),
        )
    })
}

/// The mesh turning into blocks from left to right: as it is, then after 7, 6, 5 and 4 cuts.
pub fn dissolving(film: &Film, mesh: &Mesh, octree: &Octree<Facet>) -> Image {
    /// The first of 16 columns in which there are so many cuts.
    const COLUMNS: [(f32, u32); 4] = [(14.0, 4), (12.0, 5), (10.0, 6), (7.0, 7)];
    let root = octree::tree(octree).bounds;
    let column = |p: Vec3| 16.0 * (p.x - root.min.x) / root.size().x;
    let depth = |p: Vec3| {
        let found = COLUMNS.iter().find(|(from, _)| column(p) >= *from);
        found.map_or(0, |&(_, depth)| depth)
    };
    let is_kept = |facet: &Facet| depth(facet.corners.iter().sum::<Vec3>() / 3.0) == 0;
    let kept = mesh.facets().into_iter().filter(is_kept).collect();
    picture(film, mesh, cells(octree, depth), kept)
}
