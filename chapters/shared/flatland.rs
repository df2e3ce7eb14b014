//! Discs in the plane, most of them in two crowds, cells around them, and a ray that passes through: for grids and octrees.
//! (Trees of boxes in the plane are in `flat_boxes.rs`.)

use crate::kit::figure::{Canvas, Figure, SCALE, figure, text, write};
use crate::kit::palette::{BLUE, INK, ORANGE};
use crate::kit::stage::Drawn;
use glam::{Vec3, vec3};
use plotters::prelude::{Circle, Color, PathElement, Polygon, RGBColor, Rectangle};
use rand::RngExt;
use raybook::math::pcg;
use raybook::math::{aabb::Aabb, dir3::Dir3, ray::Ray};
use std::fmt;

/// Side of the square scene, from 0 to `SIDE` along x and y, in metres, at z = 0.
pub const SIDE: f32 = 16.0;

/// Radius of a disc, in metres.
const RADIUS: f32 = 0.07;

/// The discs' boxes: crowds at two places, and a few discs anywhere. No disc is on the ray's way. They are as thick as a
/// sheet of paper.
pub fn discs() -> Vec<Aabb> {
    let mut rng = pcg::stream(5, 1);
    let mut disc = |center: Vec3, spread: f32| {
        // The sum of three uniform numbers has nearly a normal distribution.
        let mut wide = || (0..3).map(|_| rng.random::<f32>() - 0.5).sum::<f32>() * spread;
        let p = center + vec3(wide(), wide(), 0.0);
        let half = vec3(RADIUS, RADIUS, 0.0);
        Aabb {
            min: p - half,
            max: p + half + 1e-4 * Vec3::Z,
        }
    };
    let mut discs: Vec<_> = (0..70).map(|_| disc(vec3(11.6, 9.8, 0.0), 2.2)).collect();
    discs.extend((0..22).map(|_| disc(vec3(3.4, 3.6, 0.0), 3.2)));
    discs.extend((0..16).map(|_| disc(vec3(8.0, 8.0, 0.0), 10.0)));
    let square = Aabb::of([Vec3::ZERO, vec3(SIDE, SIDE, 1.0)]);
    discs.retain(|disc| {
        let p = disc.center() - ray().origin;
        let off = p.cross(*ray().direction).length();
        square.contains(disc.min) && square.contains(disc.max) && off > 1.5 * RADIUS
    });
    discs
}

/// The ray: from the lower left to the upper right, through the edge of both crowds.
pub fn ray() -> Ray {
    let from = vec3(-0.6, 2.05, 5e-5);
    Ray::new(from, Dir3::new_or(vec3(1.0, 0.53, 0.0), Dir3::X))
}

/// The plane, to draw on.
pub struct Plane<'a, 'b>(&'a Canvas<'b>);

impl fmt::Debug for Plane<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Plane").finish_non_exhaustive()
    }
}

/// Pixels of the canvas to a metre.
const ZOOM: f32 = 54.0 * SCALE as f32;

/// A picture of the plane: what `cells` draws, and above it the discs and the ray.
///
/// # Errors
/// What plotters reports.
pub fn plane(cells: impl Fn(&Plane) -> Drawn) -> Figure {
    let size = ((SIDE + 2.0) * ZOOM) as u32 / SCALE;
    figure(size, size, |canvas| {
        let plane = Plane(canvas);
        cells(&plane)?;
        plane.arrow(ray().origin, ray().at(19.6))?;
        for disc in discs() {
            let dot = Circle::new(pixel(disc.center()), (RADIUS * ZOOM) as i32, INK.filled());
            canvas.draw(&dot)?;
        }
        Ok(())
    })
}

/// Where a point is on the canvas, with a metre of air around the square.
fn pixel(p: Vec3) -> (i32, i32) {
    let (x, y) = (p.x + 1.0, SIDE + 1.0 - p.y);
    ((ZOOM * x) as i32, (ZOOM * y) as i32)
}

/// Height of a number, in pixels of the canvas: on a projector with 720 lines, `raybook present` shows it 12 pixels high.
const NUMBER: f32 = 58.0;

/// A number fits into a cell if it takes at most this share of the cell's side.
const FITS: f32 = 0.82;

/// Width of a digit, as a multiple of its height.
const DIGIT: f32 = 0.6;

/// Where a number of some digits, `height` metres high, begins in a cell: at the upper left, or at the lower right if the ray or a
/// disc would cover it there.
fn place_of_number(cell: &Aabb, digits: usize, height: f32) -> Vec3 {
    let inset = 0.09 * cell.size().x.min(1.0);
    let to_middle = 0.5 * height * vec3(DIGIT * digits as f32, -1.0, 0.0);
    let left = vec3(cell.min.x + inset, cell.max.y - inset, 0.0);
    let right = vec3(cell.max.x - inset, cell.min.y + inset, 0.0) - 2.0 * to_middle;
    let (ray, discs) = (ray(), discs());
    let room = |corner: Vec3| {
        let middle = corner + to_middle;
        let to_ray = (middle - ray.origin).cross(*ray.direction).length();
        let to_discs = discs.iter().map(|disc| disc.center().distance(middle));
        to_discs.fold(to_ray, f32::min)
    };
    if room(left) < height && room(right) > room(left) {
        right
    } else {
        left
    }
}

impl Plane<'_, '_> {
    /// A cell, filled if a colour is given, with an outline of this width in pixels.
    ///
    /// # Errors
    /// If plotters cannot draw; likewise below.
    pub fn cell(&self, cell: &Aabb, fill: Option<(RGBColor, f64)>, line: u32) -> Drawn {
        let corners = [cell.min, cell.max].map(pixel);
        if let Some((colour, opacity)) = fill {
            let area = Rectangle::new(corners, colour.mix(opacity).filled());
            self.0.draw(&area)?;
        }
        let outline = Rectangle::new(corners, BLUE.mix(0.75).stroke_width(line));
        self.0.draw(&outline)?;
        Ok(())
    }

    /// A visited cell: filled, with its number in a corner if the cell has room for it.
    ///
    /// # Errors
    /// As for [`Plane::cell`].
    pub fn visited(&self, cell: &Aabb, number: usize, line: u32) -> Drawn {
        self.cell(cell, Some((ORANGE, 0.45)), line)?;
        let (words, side) = (number.to_string(), ZOOM * cell.size().x);
        if NUMBER.max(NUMBER * DIGIT * words.len() as f32) > FITS * side {
            return Ok(());
        }
        let corner = place_of_number(cell, words.len(), NUMBER / ZOOM);
        write(self.0, &words, pixel(corner), text(NUMBER))
    }

    fn arrow(&self, from: Vec3, to: Vec3) -> Drawn {
        let along = (to - from).normalize();
        let (back, side) = (to - 0.42 * along, 0.16 * vec3(-along.y, along.x, 0.0));
        let shaft = [from, back].map(pixel);
        let head = [to, back + side, back - side].map(pixel);
        self.0.draw(&PathElement::new(shaft, INK.stroke_width(5)))?;
        self.0.draw(&Polygon::new(head, INK.filled()))?;
        Ok(())
    }
}
