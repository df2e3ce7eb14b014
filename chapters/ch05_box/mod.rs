//! A box is three slabs: each holds the ray for an interval of t, and the ray is in the box where all three overlap.
//!
//! New: math/slab.rs shape/cuboid.rs

mod letters;
mod oriented;
mod slabs;

use crate::kit::stage::{Drawn, Stage};
use crate::kit::{
    chapter, palette,
    sheet::{Sheet, sheet},
};
use clap::Args;
use glam::{Mat3, Vec3, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::{Image, rgb::Rgb};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};
use raybook::render::film::Film;
use raybook::shape::{Shape, cuboid::Cuboid};
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Width of each box; they stand 1 m from each other
    #[arg(long, value_name = "0.05..1 m", default_value = "0.86")]
    side: f32,
    /// Angle by which the viewer walks around the boxes
    #[arg(long, value_name = "-180..180 °", default_value = "0")]
    turn: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let rows: Vec<_> = (-8..=8).map(|z| Row::new(z, knobs.side)).collect();
    let (from, to) = (vec3(12.0, 13.0, 17.0), vec3(0.0, -2.3, 0.0));
    let walk = Mat3::from_rotation_y(knobs.turn.to_radians());
    let film = stage.film(16.0 / 9.0);
    let camera = Pinhole::look_at(walk * from, to, Vec3::Y, 0.042, film.aspect())?;
    if stage.wants("picture") {
        let picture = view(&film, &camera, |ray| nearest(&rows, ray));
        let caption = "More than two hundred boxes. The colour shows the height of the box, and the brightness shows which face was \
            hit.";
        stage.picture("picture", caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    stage.drawing("oriented", oriented::CAPTION, oriented::draw)?;
    if stage.wants("inside") {
        let caption = "One box. Each ray is inside the box from t_near to t_far; yellow is farther. The way inside is longest where \
            the ray crosses from a face to the opposite face, and shrinks to 0 at the silhouette.";
        stage.figure("inside", caption, &inside(&stage.tile(2, 1.5), walk)?)?;
    }

    if !stage.wants("slabs") {
        return Ok(());
    }
    let caption = "In the plane a box is two slabs. Each slab holds the part of the ray between two distances t. The ray hits the box if these intervals overlap.";
    stage.diagram("slabs", caption, &slabs::diagram()?)
}

/// Boxes side by side, and the box around all of them: a ray that misses the box around them misses each of them.
struct Row {
    boxes: Vec<Cuboid>,
    bounds: Aabb,
}

impl Row {
    fn new(z: i32, side: f32) -> Self {
        let boxes: Vec<_> = (-8..=8).filter_map(|x| column(x, z, side)).collect();
        let corners = boxes.iter().flat_map(|b| [b.bounds.min, b.bounds.max]);
        let bounds = Aabb::of(corners);
        Self { boxes, bounds }
    }
}

/// A column of a round field, with waves that die away outwards; `None` beyond the rim.
fn column(x: i32, z: i32, side: f32) -> Option<Cuboid> {
    let (x, z) = (x as f32, z as f32);
    let r = x.hypot(z);
    let top = 1.9 * (0.95 * r).cos() * (-0.13 * r).exp();
    let half = vec3(0.5 * side, 0.0, 0.5 * side);
    (r < 8.3).then(|| Cuboid::between(vec3(x, -2.3, z) - half, vec3(x, top, z) + half))
}

/// What the rays of a camera see.
fn view(film: &Film, camera: &Pinhole, see: impl Fn(&Ray) -> Option<Rgb> + Sync) -> Image {
    film.refine(|place, _| {
        let seen = see(&camera.central_ray(place));
        seen.unwrap_or(palette::backdrop(place.y))
    })
}

/// The nearest box: its height as a colour, by the face brighter or darker, and mist below.
fn nearest(rows: &[Row], ray: &Ray) -> Option<Rgb> {
    let met = |row: &&Row| slab::clip(&row.bounds, ray, Interval::AHEAD).is_some();
    let hits = rows
        .iter()
        .filter(met)
        .flat_map(|row| &row.boxes)
        .filter_map(|cuboid| Some((cuboid.hit(ray, Interval::AHEAD)?, cuboid)));
    let (hit, cuboid) = hits.min_by(|(a, _), (b, _)| a.t.total_cmp(&b.t))?;
    let at = cuboid.surface(ray, &hit);
    let face = at.normal.abs().dot(vec3(0.3, 1.0, 0.55));
    let own = palette::viridis((cuboid.bounds.max.y + 1.3) / 3.2) * face;
    let clear = ((at.position.y + 2.5) / 3.0).min(1.0);
    Some(Rgb::new(0.42, 0.47, 0.62).lerp(own, clear))
}

/// One box: the face that is hit, where the ray enters and leaves the box, and the length of its way inside.
fn inside(film: &Film, walk: Mat3) -> Sheet {
    let from = walk * vec3(2.6, 2.2, 4.0);
    let camera = Pinhole::look_at(from, Vec3::ZERO, Vec3::Y, 0.037, film.aspect())?;
    let cuboid = Cuboid::between(vec3(-1.2, -0.8, -0.9), vec3(1.2, 0.8, 0.9));
    let faces = view(film, &camera, |ray| {
        let hit = cuboid.hit(ray, Interval::AHEAD)?;
        Some(palette::direction(*cuboid.surface(ray, &hit).normal))
    });
    let tile = |from: f32, to: f32, number: fn(Interval) -> f32| {
        view(film, &camera, |ray| {
            let inside = slab::clip(&cuboid.bounds, ray, Interval::AHEAD)?;
            Some(palette::viridis((number(inside) - from) / (to - from)))
        })
    };
    let near = ("t_near: blue 3.5 m, yellow 7 m", tile(3.5, 7.0, |t| t.min));
    let far = ("t_far: blue 3.5 m, yellow 7 m", tile(3.5, 7.0, |t| t.max));
    let way = tile(0.0, 3.0, |t| t.max - t.min);
    let way = ("t_far − t_near: blue 0 m, yellow 3 m", way);
    sheet(2, &[("normal of the face", faces), near, far, way])
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch05_box")
}
