//! Meshes of long thin triangles, whose boxes are mostly empty: what trees of boxes like least. Each follows from its seed.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::shape::mesh::{Mesh, MeshError};
use std::f32::consts::TAU;

/// Corners, three for each triangle.
pub(crate) type Soup = Vec<Vec3>;

/// A hall of 24 m by 12 m, 6 m high, open at its ends: planks, columns, blinds, railings, beams, and ropes across all of it.
/// About 100,000 triangles, most of them fifty to five hundred times as long as wide.
///
/// # Errors
/// None, for the numbers are within the domain.
pub(crate) fn interior(seed: u64) -> Result<Mesh, MeshError> {
    let mut rng = pcg::stream(seed, 0);
    let mut all = Soup::new();
    for i in 0..120 {
        // Planks of the floor and of the ceiling, each of three lengths with gaps at other places.
        let z = 0.1 * i as f32 + 0.05;
        for y in [0.0, 6.0] {
            let cuts = [
                0.0,
                4.0 + 8.0 * rng.random::<f32>(),
                13.0 + 8.0 * rng.random::<f32>(),
                24.0,
            ];
            for ends in cuts.windows(2) {
                bar(
                    &mut all,
                    vec3(ends[0], y, z),
                    vec3(ends[1] - 0.004, y, z),
                    0.096,
                );
            }
        }
    }
    for i in 0..11 {
        for z in [2.0, 10.0] {
            column(&mut all, vec3(2.0 + 2.0 * i as f32, 0.0, z), 0.2, 5.9, 48);
        }
    }
    for wall in [0.0, 12.0] {
        for window in 0..12 {
            for slat in 0..90 {
                let from = vec3(2.0 * window as f32 + 0.1, 0.5 + 0.06 * slat as f32, wall);
                bar(&mut all, from, from + 1.8 * Vec3::X, 0.012);
            }
        }
    }
    for z in [3.0, 9.0] {
        for i in 0..480 {
            let foot = vec3(0.05 * i as f32, 0.0, z);
            bar(&mut all, foot, foot + 1.1 * Vec3::Y, 0.012);
        }
        bar(&mut all, vec3(0.0, 1.1, z), vec3(24.0, 1.1, z), 0.05);
    }
    for i in 0..96 {
        let x = 0.25 * i as f32;
        bar(&mut all, vec3(x, 5.9, 0.0), vec3(x, 5.0, 6.0), 0.04);
        bar(&mut all, vec3(x, 5.9, 12.0), vec3(x, 5.0, 6.0), 0.04);
    }
    for _ in 0..3000 {
        let mut at = |y: f32| {
            vec3(
                24.0 * rng.random::<f32>(),
                y + 2.0 * rng.random::<f32>(),
                12.0 * rng.random::<f32>(),
            )
        };
        let (from, to) = (at(3.5), at(3.5));
        bar(&mut all, from, to, 0.008);
    }
    mesh(all)
}

/// A ball of hair: a million segments of two triangles, in 20,000 curls from its middle to its skin.
///
/// # Errors
/// None, for the numbers are within the domain.
pub(crate) fn hair_ball(seed: u64) -> Result<Mesh, MeshError> {
    const CURLS: usize = 20_000;
    const STEPS: usize = 50;
    const WIDTH: f32 = 0.002;
    let mut rng = pcg::stream(seed, 0);
    let mut all = Soup::with_capacity(6 * CURLS * STEPS);
    for _ in 0..CURLS {
        let (mut toward, mut turn) = (direction(&mut rng), 0.4 * direction(&mut rng));
        let mut at = 0.1 * toward;
        let mut side = WIDTH * toward.any_orthonormal_vector();
        for _ in 0..STEPS {
            turn = 0.9 * turn + 0.1 * direction(&mut rng);
            toward = (toward + 0.3 * toward.cross(turn) + 0.05 * at).normalize();
            let (next, after) = (
                at + toward / STEPS as f32,
                WIDTH * toward.any_orthonormal_vector(),
            );
            all.extend([
                at - side,
                at + side,
                next - after,
                at + side,
                next + after,
                next - after,
            ]);
            (at, side) = (next, after);
        }
    }
    mesh(all)
}

/// A bar with a square section, from one point to another: twelve triangles.
pub(crate) fn bar(all: &mut Soup, from: Vec3, to: Vec3, width: f32) {
    let along = (to - from).normalize_or(Vec3::X);
    let (u, v) = along.any_orthonormal_pair();
    let ring = [u + v, u - v, -u - v, v - u].map(|p| 0.5 * width * p);
    tube(all, from, to, &ring);
    for end in [from, to] {
        let [a, b, c, d] = ring.map(|p| end + p);
        all.extend([a, b, c, a, c, d]);
    }
}

/// An upright column with `sides` sides, without ends.
fn column(all: &mut Soup, foot: Vec3, radius: f32, height: f32, sides: u32) {
    let ring: Vec<Vec3> = (0..sides)
        .map(|i| TAU * i as f32 / sides as f32)
        .map(|angle| radius * vec3(angle.cos(), 0.0, angle.sin()))
        .collect();
    tube(all, foot, foot + height * Vec3::Y, &ring);
}

/// The sides between two rings.
fn tube(all: &mut Soup, from: Vec3, to: Vec3, ring: &[Vec3]) {
    for (i, &p) in ring.iter().enumerate() {
        let q = ring[(i + 1) % ring.len()];
        all.extend([from + p, from + q, to + p, from + q, to + q, to + p]);
    }
}

/// A direction, roughly evenly.
pub(crate) fn direction(rng: &mut Pcg) -> Vec3 {
    let mut one = || 2.0 * rng.random::<f32>() - 1.0;
    vec3(one(), one(), one()).normalize_or(Vec3::X)
}

/// The mesh of these corners.
///
/// # Errors
/// If a number is outside the domain.
pub(crate) fn mesh(corners: Soup) -> Result<Mesh, MeshError> {
    let triangles = (0..corners.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let triangles = triangles.collect();
    Mesh::new(corners, triangles, None, None)
}
