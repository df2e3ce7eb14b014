//! A triangle is a plane with an inside. Three equations tell where a ray meets it: at which distance, and at which
//! barycentric coordinates. Three ways to solve the equations are compared; the way of Möller and Trumbore is the cheapest.
//!
//! New: shape/triangle.rs shape/triangle_by_plane.rs shape/triangle_by_determinants.rs

mod barycentrics;
mod inside;
mod letters;
mod looks;
pub mod platonic;
mod race;
pub mod triangle_race;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use clap::{Args, ValueEnum};
use glam::{Mat3, Vec3, vec3};
use looks::Look;
use raybook::camera::Camera;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::{Image, rgb::Rgb};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::{Hit, Shape, Surface, plane::Plane, triangle::Triangle};
use std::process::ExitCode;

/// What a picture shows of a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Shown {
    /// Barycentric coordinates as red, green and blue
    Coordinates,
    /// Lines of equal barycentric coordinates
    Lines,
    /// Distance along the ray
    Distance,
    /// Geometric normal
    Normal,
    /// Front side blue, back side orange
    Side,
}

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// What the main picture shows of each hit
    #[arg(long, value_enum, default_value = "coordinates")]
    look: Shown,
    /// Angle by which the viewer walks around the solids
    #[arg(long, value_name = "-180..180 °", default_value = "0")]
    turn: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let (look, caption): (Look, _) = match knobs.look {
        Shown::Coordinates => (
            coordinates,
            "Where on its triangle each ray ends: b₀ as red, b₁ as green, b₂ as blue.",
        ),
        Shown::Lines => (
            looks::barycentric_lines,
            "Where on its triangle each ray ends: lines where b₀, b₁ or b₂ is a multiple of a quarter.",
        ),
        Shown::Distance => (
            looks::distance,
            "The distance along each ray: yellow is near, dark blue is far.",
        ),
        Shown::Normal => (
            looks::normal,
            "The geometric normal at each hit: x, y and z, from −1 to 1, as red, green and blue.",
        ),
        Shown::Side => (
            looks::side,
            "The side of its triangle that each ray hits: blue for the front, orange for the back.",
        ),
    };
    let photograph = |film: &Film, look| photograph(film, look, knobs.turn);
    if stage.wants("picture") {
        let picture = photograph(&stage.film(16.0 / 9.0), look)?;
        stage.picture("picture", caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    stage.drawing("inside", inside::CAPTION, inside::draw)?;
    if stage.wants("sheet") {
        let mut film = stage.film(16.0 / 9.0);
        (film.width, film.height) = (film.width / 2, film.height / 2);
        let tiles = [
            ("distance t", photograph(&film, looks::distance)?),
            (
                "lines of equal b₀, b₁, b₂",
                photograph(&film, looks::barycentric_lines)?,
            ),
            ("geometric normal", photograph(&film, looks::normal)?),
            (
                "front side blue, back side orange",
                photograph(&film, looks::side)?,
            ),
        ];
        let caption = "Four things that a hit tells: the distance, the place on the triangle, the normal, and the side of the triangle.";
        stage.figure("sheet", caption, &sheet(2, &tiles)?)?;
    }
    if stage.wants("barycentrics") {
        let caption = "Barycentric coordinates: b₁ grows from 0 on the side p₀p₂ to 1 at p₁, and b₂ grows from 0 on the side p₀p₁ to \
            1 at p₂.";
        stage.diagram("barycentrics", caption, &barycentrics::draw()?)?;
    }
    if !stage.wants("cost") {
        return Ok(());
    }
    let caption = format!(
        "Three ways to find the same hits, timed on the same 10 000 rays while this figure was drawn. A triangle with e₁ = e₂ \
        has no area: if the determinant were not tested, {:.1} % of the rays aimed at such triangles would count as hits.",
        100.0 * triangle_race::false_hits()
    );
    stage.diagram("cost", &caption, &triangle_race::figure()?)
}

/// b₀, b₁ and b₂ as red, green and blue: each corner has one of these colours.
fn coordinates(_ray: &Ray, hit: &Hit, _at: &Surface) -> Rgb {
    let (b1, b2) = (hit.uv.x, hit.uv.y);
    Rgb::new(1.0 - b1 - b2, b1, b2)
}

/// A picture of three solids made of triangles.
fn photograph(film: &Film, look: Look, turn: f32) -> Result<Image, LookAtError> {
    let (from, to) = (vec3(0.0, 2.7, 6.0), vec3(0.0, 0.86, 0.0));
    let walk = Mat3::from_rotation_y(turn.to_radians());
    let camera = Pinhole::look_at(walk * from, to, Vec3::Y, 0.043, film.aspect())?;
    let solids = platonic::still_life();
    let floor = Plane::through(Vec3::ZERO, Dir3::Y);
    let sun = Dir3::new_or(vec3(-1.0, 1.2, 0.45), Dir3::Y);
    Ok(film.refine(|place, _| {
        let ray = camera.central_ray(place);
        if let Some((triangle, hit)) = nearest(&solids, &ray) {
            let at = triangle.surface(&ray, &hit);
            return look(&ray, &hit, &at) * (0.7 + 0.3 * at.normal.dot(*sun).abs());
        }
        let sky = Rgb::new(0.5, 0.62, 0.78).lerp(Rgb::new(0.82, 0.86, 0.9), place.y);
        let dark = floor.hit(&ray, Interval::AHEAD).is_some_and(|hit| {
            let toward_sun = floor.surface(&ray, &hit).leave(sun);
            nearest(&solids, &toward_sun).is_some()
        });
        sky * if dark { 0.7 } else { 1.0 }
    }))
}

/// The nearest triangle that the ray hits: all triangles are tested, and each hit shortens the interval for the next ones.
fn nearest<'a>(triangles: &'a [Triangle], ray: &Ray) -> Option<(&'a Triangle, Hit)> {
    let (mut nearest, mut within) = (None, Interval::AHEAD);
    for triangle in triangles {
        if let Some(hit) = triangle.hit(ray, within) {
            nearest = Some((triangle, hit));
            within = within.before(hit.t);
        }
    }
    nearest
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch06_triangle")
}
