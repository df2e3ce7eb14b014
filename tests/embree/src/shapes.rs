//! Shapes to shoot at: many small scenes, at scales from centimetres to a hundred metres.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::{aabb::Aabb, dir3::Dir3, pcg::Pcg};
use raybook::shape::mesh::MeshError;
use raybook::shape::sphere::Sphere;
use raybook_common::oracle::target::Target;

/// How large the shapes are, in metres.
const SCALES: [f32; 5] = [0.01, 0.1, 1.0, 10.0, 100.0];

/// The triangle number i: at any place within four times its size; every fourth is thin.
///
/// # Errors
/// If a coordinate is not finite.
pub fn triangle(i: usize, rng: &mut Pcg) -> Result<Target, MeshError> {
    let (scale, center) = place(i, rng);
    let [p0, p1] = [(); 2].map(|()| center + scale * in_cube(rng));
    let p2 = if i.is_multiple_of(4) {
        p1 + 0.02 * scale * in_cube(rng)
    } else {
        center + scale * in_cube(rng)
    };
    Target::triangle([p0, p1, p2])
}

/// The sphere number i.
pub fn sphere(i: usize, rng: &mut Pcg) -> Target {
    let (scale, center) = place(i, rng);
    Target::sphere(Sphere::new(center, scale * rng.random_range(0.2..1.0)))
}

/// A plane that passes the world's origin within a metre.
///
/// # Errors
/// If a coordinate is not finite.
pub fn plane(rng: &mut Pcg) -> Result<Target, MeshError> {
    let normal = Dir3::new_or(in_cube(rng), Dir3::Y);
    Target::plane(rng.random_range(-1.0..1.0_f32) * *normal, normal)
}

/// The box number i.
///
/// # Errors
/// If a coordinate is not finite.
pub fn cuboid(i: usize, rng: &mut Pcg) -> Result<Target, MeshError> {
    let (scale, center) = place(i, rng);
    Target::cuboid(Aabb::of([(); 2].map(|()| center + scale * in_cube(rng))))
}

/// A scale, and a place within four times as much of the world's origin.
fn place(i: usize, rng: &mut Pcg) -> (f32, Vec3) {
    let scale = SCALES[i % SCALES.len()];
    (scale, 4.0 * scale * rng.random::<f32>() * in_cube(rng))
}

/// A point of the cube from −1 to 1.
fn in_cube(rng: &mut Pcg) -> Vec3 {
    vec3(rng.random(), rng.random(), rng.random()) * 2.0 - 1.0
}
