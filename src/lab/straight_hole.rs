//! What a black hole and its disc would look like if light went straight on.

use crate::image::rgb::Rgb;
use crate::math::{dir3::Dir3, interval::Interval, ray::Ray};
use crate::scene::accretion_disc::AccretionDisc;
use crate::shape::{Shape, sphere::Sphere};
use glam::Vec3;

/// The radiance along a straight ray: a black ball of radius 1, the disc in the plane y = 0, the sky.
pub fn radiance(
    disc: &AccretionDisc,
    sky: &(dyn Fn(Dir3) -> Rgb + Sync),
    eye: Vec3,
    toward: Dir3,
) -> Rgb {
    let ray = Ray::new(eye, toward);
    let ball = Sphere::new(Vec3::ZERO, 1.0).hit(&ray, Interval::AHEAD);
    let behind = match ball {
        Some(_) => Rgb::BLACK,
        None => sky(toward),
    };
    let t = -eye.y / toward.y;
    let at = ray.at(t);
    let seen = t > 0.0 && ball.is_none_or(|hit| t < hit.t) && disc.holds(f64::from(at.length()));
    if !seen {
        return behind;
    }
    let (glow, opacity) = disc.glow(at, 1.0);
    behind.lerp(glow, opacity)
}
