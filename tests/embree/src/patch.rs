//! Where to aim: a part of a target, drawn by chance.

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::math::{basis::Basis, dir3::Dir3, pcg::Pcg};
use raybook_common::oracle::target::{Solid, Target, corners};

/// The part of a plane's stand-in that rays are aimed at: 2 m of its 16.
const PLANE_PART: f32 = 0.125;

/// A parallelogram that covers a triangle and a margin around it, or a sphere seen from a side.
pub struct Patch {
    /// The first corner.
    pub corner: Vec3,
    /// The two sides from there.
    pub along: [Vec3; 2],
    /// Square to both.
    pub normal: Dir3,
    /// A point of the shape itself.
    pub inside: Vec3,
}

impl Patch {
    /// A patch drawn by chance.
    ///
    /// # Panics
    /// If the target is a mesh without triangles.
    pub fn of(target: &Target, rng: &mut Pcg) -> Self {
        match &target.solid {
            // A plane: a part of it, for its rays may not look at the edges of its stand-in.
            Solid::Triangles(mesh) if target.far.is_finite() => {
                let &[a, b, _, d] = mesh.positions() else {
                    unreachable!("a plane's stand-in has four corners")
                };
                let along = [b - a, d - a].map(|side| PLANE_PART * side);
                let corner = mesh.bounds().center() - 0.5 * (along[0] + along[1]);
                Self {
                    corner,
                    along,
                    normal: Dir3::new_or(along[0].cross(along[1]), Dir3::Y),
                    inside: corner
                        + rng.random::<f32>() * along[0]
                        + rng.random::<f32>() * along[1],
                }
            }
            Solid::Triangles(mesh) => {
                let id = rng.random_range(0..mesh.triangles().len() as u32);
                let [p0, p1, p2] =
                    corners(mesh, id).expect("the number was drawn below the length");
                let (e1, e2) = (p1 - p0, p2 - p0);
                let (mut b1, mut b2) = (rng.random::<f32>(), rng.random::<f32>());
                if b1 + b2 > 1.0 {
                    (b1, b2) = (1.0 - b1, 1.0 - b2);
                }
                Self {
                    corner: p0 - 0.1 * (e1 + e2),
                    along: [1.2 * e1, 1.2 * e2],
                    normal: Dir3::new_or(e1.cross(e2), Dir3::Y),
                    inside: p0 + b1 * e1 + b2 * e2,
                }
            }
            Solid::Sphere(sphere) => {
                let Basis { x, y, z } = Basis::around(direction(rng));
                Self {
                    corner: sphere.center - 1.2 * sphere.radius * (*x + *y),
                    along: [2.4 * sphere.radius * *x, 2.4 * sphere.radius * *y],
                    normal: z,
                    inside: sphere.center + sphere.radius * *z,
                }
            }
        }
    }

    /// The point (i, j) of the patch, both from 0 to 1.
    pub fn at(&self, i: f32, j: f32) -> Vec3 {
        self.corner + i * self.along[0] + j * self.along[1]
    }
}

/// How large the target is, in metres.
pub fn size_of(target: &Target) -> f32 {
    let size = target.shape.bounds().size().length();
    if size.is_finite() { size } else { 1.0 }
}

/// A direction, each as likely as any other.
pub fn direction(rng: &mut Pcg) -> Dir3 {
    loop {
        let v = vec3(rng.random(), rng.random(), rng.random()) * 2.0 - 1.0;
        if let (true, Some(direction)) = (v.length_squared() <= 1.0, Dir3::new(v)) {
            return direction;
        }
    }
}
