//! Plastic, lacquer, glazed china: a matte ground under a smooth clear coat.

use crate::image::rgb::Rgb;
use crate::material::fresnel::fresnel;
use crate::material::{Delta, Material, mirror::Mirror};
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{cosine_hemisphere, cosine_pdf};
use crate::shape::Surface;
use glam::Vec2;
use std::f32::consts::FRAC_1_PI;

/// A coat that mirrors a share R of the light, by Fresnel's equations, over a ground that scatters the rest.
///
/// Light that the ground sends up is in part mirrored back to it by the coat, again and again: all of that is in f. A white
/// one sends out all that it gets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic {
    /// ρ: the ground's share, from 0 to 1.
    pub albedo: Rgb,
    /// n: the coat's index of refraction.
    index: f32,
    /// R̄: the share of the ground's light that the coat mirrors back.
    inner: f32,
}

impl Plastic {
    /// A ground under a coat of an index of refraction from 1; 1.5 is that of most plastics.
    pub fn new(albedo: Rgb, index: f32) -> Self {
        let index = index.max(1.0);
        Self {
            albedo,
            index,
            inner: mirrored_back(index),
        }
    }

    /// The same coat over another ground.
    #[must_use]
    pub const fn of(self, albedo: Rgb) -> Self {
        Self { albedo, ..self }
    }

    /// R of light that comes at an angle of this cosine from outside.
    fn mirrored(&self, cosine: f32) -> f32 {
        fresnel(cosine, 1.0, self.index).unpolarised
    }
}

/// R̄ = 2 ∫ R cos θ d(cos θ): of light that comes from below the coat, equally bright from everywhere; 0.596 for n = 1.5.
fn mirrored_back(index: f32) -> f32 {
    /// With this number of steps the sum is right to 1e-5.
    const STEPS: u16 = 2000;
    let middle = |i: u16| (f32::from(i) + 0.5) / f32::from(STEPS);
    let part = |cosine: f32| f64::from(2.0 * cosine * fresnel(cosine, index, 1.0).unpolarised);
    let sum: f64 = (0..STEPS).map(middle).map(part).sum();
    (sum / f64::from(STEPS)) as f32
}

impl Material for Plastic {
    // ANCHOR: plastic
    /// f = (1 − R(l)) (1 − R(v)) ρ/(π n² (1 − ρ R̄)): through the coat, to and fro below it, and out again.
    ///
    /// n² is how much wider the cone of light becomes when it leaves.
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

    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        Some(cosine_hemisphere(at.facing(view), u))
    }

    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        cosine_pdf(at.facing(view).dot(*toward))
    }

    fn ambient(&self, _at: &Surface) -> Rgb {
        self.albedo
    }

    fn deltas(&self, at: &Surface, view: Dir3, tell: &mut dyn FnMut(Delta)) {
        let share = Rgb::gray(self.mirrored(at.facing(view).dot(*view)));
        Mirror { share }.deltas(at, view, tell);
    }
}
