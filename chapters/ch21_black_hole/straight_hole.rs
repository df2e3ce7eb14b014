//! A black hole beside what it would look like if light went straight on.

use crate::kit::sheet::sheet;
use glam::Vec3;
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::math::interval::Interval;
use raybook::math::ray::Ray;
use raybook::render::curved::black_hole::BlackHole;
use raybook::render::curved::fan::Fan;
use raybook::render::film::Film;
use raybook::shape::Shape;
use raybook::shape::sphere::Sphere;
use std::error::Error;

/// The hole without gravity, and with it, in this exposure.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn compare(
    film: &Film,
    camera: &Pinhole,
    hole: &BlackHole,
    fan: &Fan,
    exposure: f32,
) -> Result<Image, Box<dyn Error>> {
    let tile = |radiance: &(dyn Fn(&Ray) -> Rgb + Sync)| {
        film.refine(|place, _| radiance(&camera.central_ray(place)) * exposure)
    };
    let tiles = [
        (
            "if light went straight on",
            tile(&|ray| straight(hole, ray)),
        ),
        (
            "as it is bent",
            tile(&|ray| hole.radiance_by(fan, ray.direction)),
        ),
    ];
    sheet(2, &tiles)
}

/// The radiance along a straight ray: a black ball of radius 1, the disc in the plane y = 0, the sky.
fn straight(hole: &BlackHole, ray: &Ray) -> Rgb {
    let ball = Sphere::new(Vec3::ZERO, 1.0).hit(ray, Interval::AHEAD);
    let behind = match ball {
        Some(_) => Rgb::BLACK,
        None => (hole.sky)(ray.direction),
    };
    let t = -ray.origin.y / ray.direction.y;
    let at = ray.at(t);
    let before_ball = t > 0.0 && ball.is_none_or(|hit| t < hit.t);
    match hole.disc {
        Some(disc) if before_ball && disc.holds(f64::from(at.length())) => {
            let (glow, opacity) = disc.glow(at, 1.0);
            behind.lerp(glow, opacity)
        }
        _ => behind,
    }
}
