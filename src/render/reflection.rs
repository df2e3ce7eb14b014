//! The reflection integral: from the light that arrives from the hemisphere to the light that leaves towards the viewer.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//! use raybook::render::reflection::reflected_radiance;
//!
//! // Under a white sky, a matte surface shows its albedo, with every sample: its density is exactly proportional to f cos θ.
//! let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! let paper = Lambert { albedo: Rgb::gray(0.8) };
//! let seen = reflected_radiance(&paper, &at, Dir3::Y, &|_| Rgb::WHITE, 4, &mut pcg::stream(0, 0));
//! assert!((seen.g - 0.8).abs() < 1e-5);
//! ```

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::math::{dir3::Dir3, pcg::Pcg};
use crate::shape::Surface;
use glam::vec2;
use rand::RngExt;

// ANCHOR: reflected_radiance
/// L_o = ∫ f L_i cos θ dω over the hemisphere, estimated by (1/N) Σ f L_i cos θ/p over N = `samples` directions of density p.
///
/// `incoming` is L_i: the radiance that arrives from a direction, in W·m⁻²·sr⁻¹. The estimate is unbiased for any density p that
/// is positive wherever f L_i cos θ is. The more similar the shapes of p and f L_i cos θ, the less noise (importance sampling).
/// Here p is the density of [`Material::sample`]. `samples` is at least 1.
pub fn reflected_radiance(
    brdf: &dyn Material,
    at: &Surface,
    view: Dir3,
    incoming: &dyn Fn(Dir3) -> Rgb,
    samples: u32,
    rng: &mut Pcg,
) -> Rgb {
    let normal = at.facing(view);
    let mut sum = Rgb::BLACK;
    for _ in 0..samples {
        let u = vec2(rng.random(), rng.random());
        if let Some(toward) = brdf.sample(at, view, u) {
            let weight = normal.dot(*toward) / brdf.pdf(at, view, toward);
            sum += brdf.eval(at, view, toward) * incoming(toward) * weight;
        }
    }
    sum / samples as f32
}
// ANCHOR_END: reflected_radiance
