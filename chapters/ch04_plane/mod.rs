//! A plane has no end: every ray that points the least bit towards it hits it, and a floor reaches to the horizon.
//!
//! New: math/basis.rs shape/plane.rs

mod letters;

use crate::kit::stage::{Drawn, Stage};
use crate::kit::{
    chapter, palette,
    sheet::{Sheet, sheet},
};
use crate::shared::outdoors::{checker, haze, open_sky, sky};
use clap::Args;
use glam::{Vec3, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::{Shape, Surface, plane::Plane, sphere::Sphere};
use std::process::ExitCode;

/// A colour that depends on the point of the surface and on how far away it is.
type Paint<'a> = &'a (dyn Fn(&Surface, f32) -> Rgb + Sync);

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Angle of the floor's normal from straight up, to the right
    #[arg(long, value_name = "-60..60 °", default_value = "0")]
    tilt: f32,
    /// Offset of the floor along its normal
    #[arg(long, value_name = "-3..1.5 m", default_value = "0")]
    offset: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let (from, to) = (vec3(-1.5, 1.7, 6.2), vec3(-0.2, 1.15, 0.0));
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.03, film.aspect())?;
    let balls = [(-2.6, -0.8, 1.0), (0.3, 1.2, 0.5), (2.6, -3.2, 1.6)];
    let balls = balls.map(|(x, z, r)| Sphere::new(vec3(x, r, z), r));
    let (sine, cosine) = knobs.tilt.to_radians().sin_cos();
    let up = Dir3::new_or(vec3(sine, cosine, 0.0), Dir3::Y);
    let floor = Plane::through(knobs.offset * *up, up);
    let (light, dark) = (Rgb::new(0.85, 0.83, 0.78), Rgb::new(0.03, 0.2, 0.28));
    let stone = |at: &Surface, t: f32| {
        let colour = checker(at.texture, light, dark);
        haze(colour * open_sky(&balls, at.position), t)
    };
    let normal = |at: &Surface, t: f32| haze(palette::direction(*at.normal), t);
    let mut things: Vec<(&dyn Shape, Paint)> = vec![(&floor, &stone)];
    things.extend(balls.iter().map(|ball| (ball as _, &normal as _)));
    if stage.wants("picture") {
        let picture = film.refine(|place, _| see(&camera.central_ray(place), &things));
        let caption = "Tiles of one metre, out to the horizon. Haze hides the tiles that are smaller than a pixel. Each ray shows the nearest of its hits, on the floor or on a ball.";
        stage.picture("picture", caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if !stage.wants("planes") {
        return Ok(());
    }
    let caption = "Left: the distance t along each ray; every step of colour is a doubling, from 2 m to over 1 km. Middle and \
        right: several planes; the colour shows the normal. Only the nearest hit is seen, so planes cut each other where they \
        cross.";
    stage.figure("planes", caption, &planes(stage.tile(3, 4.0 / 3.0))?)
}

/// The colour of the nearest thing, or the sky: each hit shortens the interval for the things after it.
fn see(ray: &Ray, things: &[(&dyn Shape, Paint)]) -> Rgb {
    let (mut within, mut seen) = (Interval::AHEAD, sky(ray.direction));
    for (shape, paint) in things {
        if let Some(hit) = shape.hit(ray, within) {
            within = within.before(hit.t);
            seen = paint(&shape.surface(ray, &hit), hit.t);
        }
    }
    seen
}

/// Planes through the world's origin, from 1.7 m above the floor.
fn planes(film: Film) -> Sheet {
    let (from, to) = (vec3(4.0, 1.7, 6.0), vec3(0.0, 1.5, 0.0));
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.02, film.aspect())?;
    let tile = |normals: &[Vec3], paint: Paint| {
        let perpendicular_to = |&n: &Vec3| Plane::through(Vec3::ZERO, Dir3::new_or(n, Dir3::Y));
        let planes: Vec<_> = normals.iter().map(perpendicular_to).collect();
        let things: Vec<_> = planes.iter().map(|plane| (plane as _, paint)).collect();
        film.refine(|place, _| see(&camera.central_ray(place), &things))
    };
    let doubling = |_: &Surface, t: f32| palette::viridis(t.log2().floor() / 10.0);
    let normal = |at: &Surface, t: f32| {
        let colour = palette::direction(*at.normal);
        haze(colour * checker(at.texture, 1.0, 0.65), t)
    };
    let floor = ("distance: doubling", tile(&[Vec3::Y], &doubling));
    let corner = ("three at right angles", tile(&Vec3::AXES, &normal));
    let slope = tile(&[Vec3::Y, vec3(1.3, 1.0, -0.3)], &normal);
    sheet(3, &[floor, corner, ("two that cross", slope)])
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch04_plane")
}
