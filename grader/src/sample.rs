//! What questions are made of.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};

/// All of a line, ahead and behind.
pub const LINE: Interval = Interval::new(f32::NEG_INFINITY, f32::INFINITY);

/// The ray from a point in the direction of a vector of any length but 0.
pub fn ray(origin: Vec3, toward: Vec3) -> Ray {
    Ray::new(origin, Dir3::new_or(toward, Dir3::Z))
}

/// Where pixel (x, y) of a picture of 96 × 54 lies, seen along −z from 1 m away; the picture is 1 m high.
pub fn pixel(x: u32, y: u32) -> Vec3 {
    vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0)
}

/// A number between two others.
pub fn number(rng: &mut Pcg, min: f32, max: f32) -> f32 {
    rng.random_range(min..max)
}

/// Where an interval ends: between two numbers, or nowhere.
pub fn end(rng: &mut Pcg, chance: f64, min: f32, max: f32) -> f32 {
    if rng.random_bool(chance) {
        number(rng, min, max)
    } else {
        f32::INFINITY
    }
}

/// A point of the cube [−half, half]³.
pub fn point(rng: &mut Pcg, half: f32) -> Vec3 {
    vec3(
        number(rng, -half, half),
        number(rng, -half, half),
        number(rng, -half, half),
    )
}

/// A direction, all equally likely: a point of the cube, thrown again until it is inside the sphere.
pub fn direction(rng: &mut Pcg) -> Dir3 {
    loop {
        let p = point(rng, 1.0);
        if p.length_squared() <= 1.0
            && let Some(direction) = Dir3::new(p)
        {
            return direction;
        }
    }
}
