//! A crowd of teapots: one mesh of many triangles, evenly spread.

use glam::{Mat3, vec2, vec3};
use raybook::shape::{mesh::Mesh, teapot};
use std::f32::consts::TAU;

/// Teapots on a square of ground.
#[derive(Clone, Debug)]
pub(super) struct Teapots {
    /// The whole scene: the teapots one after the other, then the ground.
    pub mesh: Mesh,
    /// Triangles per teapot.
    each: u32,
    /// How many teapots.
    count: u32,
}

/// The angle from one teapot to the next, in radians: 1/φ² of a circle.
const GOLDEN_ANGLE: f32 = 0.381_966 * TAU;

/// `count` teapots, each as fine as [`teapot::mesh`] of `fineness`, in the spirals of a sunflower: the k-th teapot is √k out
/// and a golden angle further than the teapot before, so that all have the same room (Vogel 1979).
pub(super) fn teapots(count: u32, fineness: usize) -> Teapots {
    let pot = teapot::mesh(fineness);
    let vertices = pot.positions().len() as u32;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for k in 0..count {
        let angle = GOLDEN_ANGLE * k as f32;
        let place = 4.4 * (k as f32 + 0.5).sqrt() * vec2(angle.cos(), angle.sin());
        let turned = Mat3::from_rotation_y(2.0 - angle);
        positions.extend(
            pot.positions()
                .iter()
                .map(|&p| turned * p + vec3(place.x, 0.0, place.y)),
        );
        triangles.extend(pot.triangles().iter().map(|t| t.map(|i| k * vertices + i)));
    }
    let half = 4.4 * (count as f32).sqrt() + 8.0;
    let corner = |x: f32, z: f32| half * vec3(x, 0.0, z);
    positions.extend([
        corner(-1.0, 1.0),
        corner(1.0, 1.0),
        corner(1.0, -1.0),
        corner(-1.0, -1.0),
    ]);
    triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| count * vertices + i)));
    Teapots {
        mesh: Mesh::new(positions, triangles, None, None)
            .unwrap_or_else(|error| unreachable!("teapots are finite: {error}")),
        each: pot.triangles().len() as u32,
        count,
    }
}

impl Teapots {
    /// Which teapot a triangle belongs to, from 0 in the middle to 1 at the rim; `None` for the ground.
    pub(super) fn teapot(&self, triangle: u32) -> Option<f32> {
        let teapot = triangle / self.each.max(1);
        (teapot < self.count).then(|| teapot as f32 / self.count as f32)
    }
}
