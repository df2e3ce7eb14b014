//! A grid that is too coarse, one that is about right and one that is too fine: the same ray among the same discs.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec3, uvec3, vec2, vec3};
use raybook::inside::grid::{Lattice, walk};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use std::ops::ControlFlow;

/// What is said of each grid, and its cells along each side.
const GRIDS: [(&str, u32); 3] = [("too coarse", 2), ("about right", 5), ("too fine", 14)];

/// Discs of a crowd, which lie on a spiral, and then two alone.
const CROWD: u32 = 14;
const ALONE: [Vec3; 2] = [xy(0.75, 0.75), xy(0.82, 0.3)];

/// The middle of the crowd.
const MIDDLE: Vec3 = xy(0.28, 0.3);

/// Radius of a disc.
const RADIUS: f32 = 0.02;

/// The distance from a grid to the next.
const NEXT: f32 = 1.17;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The same 16 discs in three grids. Too coarse: the ray tests every disc. Too fine: it walks through many \
    empty cells.";

/// Draws the three grids side by side.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((840, 370), xy(0.5 + NEXT, 0.43), 1.55, |sketch| {
        for (i, (name, side)) in GRIDS.into_iter().enumerate() {
            grid(sketch, i as f32 * NEXT * Vec3::X, name, side)?;
        }
        Ok(())
    })
}

/// The middles of all discs in the unit square: each of the crowd turns by the golden angle.
fn discs() -> impl Iterator<Item = Vec3> {
    let crowd = (0..CROWD).map(|i| {
        let angle = 2.399_963 * i as f32;
        MIDDLE + 0.045 * (i as f32).sqrt() * xy(angle.cos(), angle.sin())
    });
    crowd.chain(ALONE)
}

/// A grid whose lower left corner is here, the cells that the ray visits, and what it costs.
fn grid(sketch: &Sketch, corner: Vec3, name: &str, side: u32) -> Drawn {
    let bounds = Aabb {
        min: Vec3::ZERO,
        max: Vec3::ONE,
    };
    let lattice = Lattice::new(&bounds, uvec3(side, side, 1));
    let ray = Ray::new(
        vec3(0.0, 0.08, 0.5),
        Dir3::new_or(vec3(1.0, 0.62, 0.0), Dir3::X),
    );
    let size = 1.0 / side as f32;
    let mut visited = Vec::new();
    let within = Interval::new(-1.0, 10.0);
    walk(&lattice, &ray, within, |cell, _| {
        visited.push(cell);
        ControlFlow::Continue(())
    });
    let square = |min: Vec3, size: f32| {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| min + size * xy(x, y))
    };
    for cell in &visited {
        let min = size * cell.as_vec3().with_z(0.0);
        sketch.area(&square(corner + min, size), ORANGE, 0.4)?;
    }
    for i in 1..side {
        let at = size * i as f32;
        sketch.line(&[corner + xy(at, 0.0), corner + xy(at, 1.0)], FAINT, 2)?;
        sketch.line(&[corner + xy(0.0, at), corner + xy(1.0, at)], FAINT, 2)?;
    }
    let [a, b, c, d] = square(corner, 1.0);
    sketch.line(&[a, b, c, d, a], INK, 4)?;
    let mut tested = 0;
    for disc in discs() {
        let near = |cell: &&glam::UVec3| {
            let min = size * cell.as_vec3().truncate();
            let nearest = disc.truncate().clamp(min, min + size);
            nearest.distance(disc.truncate()) <= RADIUS
        };
        let is_tested = visited.iter().find(near).is_some();
        tested += usize::from(is_tested);
        let colour = if is_tested { VERMILION } else { BLUE };
        sketch.disc(corner + disc, RADIUS, colour, 1.0)?;
    }
    let on_page = |p: Vec3| corner + p.with_z(0.0);
    let leaves = (1.0 - ray.origin.x) / ray.direction.x;
    sketch.arrow(on_page(ray.origin), on_page(ray.at(leaves)), INK, 4)?;
    sketch.label(corner + xy(0.5, 1.0), vec2(0.0, -34.0), name, INK)?;
    let (visits, all) = (visited.len(), discs().count());
    let below = corner + xy(0.5, 0.0);
    sketch.label(
        below,
        vec2(0.0, 36.0),
        &format!("{visits} cells visited"),
        INK,
    )?;
    let words = format!("{tested} of {all} discs tested");
    sketch.label(below, vec2(0.0, 84.0), &words, INK)
}
