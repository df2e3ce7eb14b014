//! The boxes of a tree, level by level.

use crate::kit::{
    palette::viridis,
    sheet::{Sheet, sheet},
};
use crate::shared::showroom::Showroom;
use glam::vec3;
use raybook::accel::Accel;
use raybook::accel::bvh::Bvh;
use raybook::image::{Image, rgb::Rgb};
use raybook::inside::bvh::{self, Node, Pair};
use raybook::math::{aabb::Aabb, interval::Interval};
use raybook::render::film::Film;
use raybook::shape::{Shape, cuboid::Cuboid};

/// The boxes of each of these levels as solid blocks, in a tree of their own.
///
/// # Errors
/// If the labels cannot be drawn.
pub(super) fn figure<S: Shape>(
    film: &Film,
    room: &Showroom,
    tree: &Bvh<S>,
    levels: &[u32],
) -> Sheet {
    let tiles = levels.iter().map(|&depth| {
        let boxes = level(tree, depth);
        let label = format!("level {depth}: {} boxes", boxes.len());
        (label, blocks(film, room, &boxes))
    });
    let tiles: Vec<_> = tiles.collect();
    sheet(2, &tiles)
}

/// Blocks, each in a colour of its own, the top lighter than the sides.
fn blocks(film: &Film, room: &Showroom, boxes: &[Aabb]) -> Image {
    let cuboid = |bounds: &Aabb| Cuboid::between(bounds.min, bounds.max);
    let tree = Bvh::new(boxes.iter().map(cuboid).collect());
    film.refine(|place, _| {
        let ray = room.ray(place);
        let Some((cuboid, hit)) = tree.closest(&ray, Interval::AHEAD) else {
            return room.backdrop(place, &ray);
        };
        let normal = cuboid.surface(&ray, &hit).normal;
        colour(&cuboid.bounds()) * (0.62 + 0.38 * normal.dot(vec3(-0.35, 0.9, 0.5)))
    })
}

/// A colour that differs from those of the neighbours.
fn colour(bounds: &Aabb) -> Rgb {
    let chance = bounds.center().dot(vec3(12.99, 78.23, 37.72)).sin() * 4375.85;
    viridis(0.1 + 0.9 * chance.fract().abs())
}

/// The boxes of all nodes that have `level` branches above them, and of leaves that have fewer: together these boxes hold all
/// shapes.
pub(super) fn level<S: Shape>(tree: &Bvh<S>, level: u32) -> Vec<Aabb> {
    let (root, pairs) = bvh::nodes(tree);
    let mut boxes = Vec::new();
    if let Some(root) = root {
        collect(root, pairs, level, &mut boxes);
    }
    boxes
}

fn collect(node: &Node, pairs: &[Pair], level: u32, boxes: &mut Vec<Aabb>) {
    if level == 0 || node.link.count > 0 {
        boxes.push(node.bounds);
    } else {
        for child in pairs[node.link.first as usize].nodes() {
            collect(&child, pairs, level - 1, boxes);
        }
    }
}
