//! # Sphere
//!
//! A ray meets a sphere where a quadratic equation has its roots; the nearer root ahead of the ray is what the eye sees.
//!
//! New: math/interval.rs math/aabb.rs math/quadratic.rs shape/mod.rs shape/sphere.rs

use glam::{Vec2, Vec3, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::rgb::Rgb;
use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use raybook::math::interval::Interval;
use raybook::shape::{Shape, sphere::Sphere};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let camera = Pinhole::look_at(
        vec3(0.0, 0.5, 4.0),
        Vec3::ZERO,
        Vec3::Y,
        0.035,
        film.aspect(),
    )?;
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    let picture = film.render(|place, _| {
        let ray = camera.ray(place, Vec2::ZERO);
        let Some(hit) = sphere.hit(&ray, Interval::AHEAD) else {
            return Rgb::gray(0.1);
        };
        let n = sphere.surface(&ray, &hit).normal;
        Rgb::new(n.x, n.y, n.z).map(|v| 0.5 + 0.5 * v)
    });
    stage.picture("picture", "Normals as colours.", &picture)
}

fn main() -> ExitCode {
    chapter::run("ch03_sphere", draw)
}
