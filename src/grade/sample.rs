//! Random questions' ingredients.

use crate::math::{dir3::Dir3, pcg::Pcg};
use glam::{Vec3, vec3};
use rand::RngExt;

/// A number between two others.
pub fn number(rng: &mut Pcg, min: f32, max: f32) -> f32 {
    rng.random_range(min..max)
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
