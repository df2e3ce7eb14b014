//! A ray meets a sphere where a quadratic equation has its roots; the nearer root ahead of the ray is what the eye sees.
//!
//! New: math/interval.rs math/aabb.rs math/quadratic.rs shape/mod.rs shape/sphere.rs

mod cancellation;
mod letters;

use crate::kit::stage::{Drawn, Stage};
use crate::kit::{
    chapter, palette,
    sheet::{Sheet, sheet},
};
use crate::shared::outdoors::checker;
use clap::Args;
use glam::{Vec3, vec2, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::{Shape, Surface, sphere::Sphere};
use std::iter::successors;
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Radius of each sphere of the flower, as a share of its distance from the middle
    #[arg(long, value_name = "0.02..0.8 ×", default_value = "0.27")]
    radius: f32,
    /// Distance of the eye from the flower, in multiples of 15 m
    #[arg(long, value_name = "0.2..20 ×", default_value = "1")]
    distance: f32,
    /// Radius of the sphere in the telescope, in `cancellation`
    #[arg(long, value_name = "0.001..100 m", default_value = "0.1")]
    sphere: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let (from, to) = (vec3(-2.5, 9.5, 11.5), vec3(0.0, 0.0, 0.3));
    let eye = from + (knobs.distance - 1.0) * (from - to);
    let camera = Pinhole::look_at(eye, to, Vec3::Y, 0.042, film.aspect())?;
    let flower: Vec<_> = (0..110).map(|i| petal(i, knobs.radius)).collect();
    if stage.wants("picture") {
        let picture = film.refine(|place, _| {
            let normal = nearest(&flower, &camera.central_ray(place));
            normal.map_or(palette::backdrop(place.y), |n| palette::direction(*n))
        });
        let caption = "The normal at each ray's nearest hit, as a colour: red is to the right, green up, blue to the front.";
        stage.picture("picture", caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("roots") {
        let caption = "One sphere, three answers. The near root is the front of the sphere. The far root is the back: its normals \
            point away from the eye. From inside, the near root is behind the eye, and the eye sees the far root.";
        stage.figure("roots", caption, &roots(stage.tile(3, 1.0))?)?;
    }

    if !stage.wants("cancellation") {
        return Ok(());
    }
    let caption = format!(
        "A sphere with a radius of {} m through a telescope. Top: by the schoolbook formula, the shape of the sphere is lost as the \
        sphere moves away. Middle: with distances counted from the point of the ray that is closest to the centre, nothing is lost. Bottom: \
        along a slanting direction, the numbers of the ray itself are rounded.",
        knobs.sphere
    );
    let figure = cancellation::figure(stage.tile(5, 1.0), knobs.sphere)?;
    stage.figure("cancellation", &caption, &figure)
}

/// The i-th sphere of a flower: each turns by the golden angle, and is smaller and farther in by the same factor.
fn petal(i: i32, radius: f32) -> Sphere {
    let (r, angle) = (4.0 * 1.038_f32.powi(-i), 2.399_963 * i as f32);
    Sphere::new(r * vec3(angle.cos(), angle.sin(), 0.2), radius * r)
}

/// The normal where the ray first meets a sphere: each hit shortens the interval for the spheres after it.
fn nearest(spheres: &[Sphere], ray: &Ray) -> Option<Dir3> {
    let (mut within, mut normal) = (Interval::AHEAD, None);
    for sphere in spheres {
        if let Some(hit) = sphere.hit(ray, within) {
            within = within.before(hit.t);
            normal = Some(sphere.normal_at(ray.at(hit.t)));
        }
    }
    normal
}

/// The near root, the far root, and the only root ahead of an eye inside the sphere.
fn roots(film: Film) -> Sheet {
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    let outside = Pinhole::look_at(vec3(0.0, 1.6, 3.6), Vec3::ZERO, Vec3::Y, 0.035, 1.0)?;
    let inside = Pinhole::look_at(vec3(0.0, 0.4, 0.9), Vec3::ZERO, Vec3::Y, 0.012, 1.0)?;
    let tile = |camera: Pinhole, root: usize| {
        film.refine(|place, _| {
            let ray = camera.central_ray(place);
            let beyond = |t| sphere.hit(&ray, Interval::new(t, f32::INFINITY));
            let hit = successors(beyond(0.0), |hit| beyond(hit.t)).nth(root);
            hit.map_or(palette::backdrop(place.y), |hit| {
                globe(&sphere.surface(&ray, &hit))
            })
        })
    };
    let front = ("near root: the front", tile(outside, 0));
    let back = ("far root: the back", tile(outside, 1));
    sheet(
        3,
        &[front, back, ("from inside: the far root", tile(inside, 0))],
    )
}

/// The normal as a colour, darker on every other field of 15° of longitude and latitude.
fn globe(at: &Surface) -> Rgb {
    palette::direction(*at.normal) * checker(at.texture * vec2(24.0, 12.0), 1.0, 0.65)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch03_sphere")
}
