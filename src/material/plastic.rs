//! Plastic, lacquer, glazed china: a matte ground under a smooth clear coat.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! let ball = Plastic::new(Rgb::gray(0.5), 1.5);
//! let mut mirrored = 0.0;
//! ball.delta_lobes(&at, Dir3::Y, &mut |lobe| mirrored += lobe.share.g);
//! assert!((mirrored - 0.04).abs() < 1e-4); // the clear coat reflects 4 % from straight above
//! ```

use crate::image::rgb::Rgb;
use crate::material::fresnel::fresnel;
use crate::material::{Delta, Material, mirror::Mirror};
use crate::math::dir3::Dir3;
use crate::shape::Surface;
use std::f32::consts::FRAC_1_PI;

/// A clear coat that mirrors the share R of the light, by Fresnel's equations, over a matte ground that scatters the rest.
///
/// The coat mirrors a part of the light from the ground back to the ground, again and again. f contains the sum of all these
/// reflections (as in Saunderson, "Calculation of the color of pigmented plastics", 1942). With ρ = 1, no energy is lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic {
    /// ρ: the ground's albedo, from 0 to 1.
    pub albedo: Rgb,
    /// n: the coat's index of refraction.
    index: f32,
    /// R̄: the share of the ground's light that the coat mirrors back to the ground.
    inner: f32,
}

impl Plastic {
    /// A ground under a coat with this index of refraction, about 1.5 for most plastics; an index below 1 counts as 1.
    pub fn new(albedo: Rgb, index: f32) -> Self {
        let index = index.max(1.0);
        Self {
            albedo,
            index,
            inner: mirrored_back(index),
        }
    }

    /// The same coat over a ground of this albedo.
    #[must_use]
    pub const fn of(self, albedo: Rgb) -> Self {
        Self { albedo, ..self }
    }

    /// R for light from outside, at an angle of this cosine to the normal.
    fn mirrored(&self, cosine: f32) -> f32 {
        fresnel(cosine, 1.0, self.index).unpolarised
    }
}

/// R̄ = 2 ∫ R cos θ d(cos θ): the share that the coat reflects of light from below that is equally bright in all directions;
/// 0.596 for n = 1.5.
fn mirrored_back(index: f32) -> f32 {
    /// Steps of the sum; its error is below 1e-5.
    const STEPS: u16 = 2000;
    let middle = |i: u16| (f32::from(i) + 0.5) / f32::from(STEPS);
    let part = |cosine: f32| f64::from(2.0 * cosine * fresnel(cosine, index, 1.0).unpolarised);
    let sum: f64 = (0..STEPS).map(middle).map(part).sum();
    (sum / f64::from(STEPS)) as f32
}

impl Material for Plastic {
    // ANCHOR: plastic
    /// f = (1 − R(l)) (1 − R(v)) ρ/(π n² (1 − ρ R̄)), in 1/sr: through the coat, to and fro below it, and out again.
    ///
    /// Division by n², because the cone of light becomes wider by n² when the light leaves. 1/(1 − ρ R̄) is the sum of the series
    /// 1 + ρR̄ + (ρR̄)² + … of reflections below the coat.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        let normal = at.facing(view);
        let (out, into) = (normal.dot(*view), normal.dot(*toward));
        if out <= 0.0 || into <= 0.0 {
            return Rgb::BLACK;
        }
        let through = (1.0 - self.mirrored(into)) * (1.0 - self.mirrored(out));
        let ground = self.albedo.map(|rho| rho / (1.0 - rho * self.inner));
        ground * (through * FRAC_1_PI / (self.index * self.index))
    }
    // ANCHOR_END: plastic

    fn ambient(&self, _at: &Surface) -> Rgb {
        self.albedo
    }

    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        let share = Rgb::gray(self.mirrored(at.facing(view).dot(*view)));
        Mirror { share }.delta_lobes(at, view, visit);
    }
}
