//! Chapter 17: `cosine_hemisphere`, `brdf_phong`, `reflected_radiance`.

mod brdf_phong;
mod cosine_hemisphere;
mod reflected_radiance;

use crate::examine::Examiner;
use crate::sample;
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_workbook::exercises::ch17_rendering_equation::{
    BrdfPhong, CosineHemisphere, ReflectedRadiance,
};
use glam::{Vec3, vec3};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&CosineHemisphere, &BrdfPhong, &ReflectedRadiance];

fn toward(x: f32, y: f32, z: f32) -> Dir3 {
    Dir3::new_or(vec3(x, y, z), Dir3::Z)
}

/// The direction at a height over the horizon, and an angle around the normal.
fn at_height(z: f32, phi: f32) -> Vec3 {
    let r = (1.0 - z * z).max(0.0).sqrt();
    vec3(r * phi.cos(), r * phi.sin(), z)
}

fn colour(rng: &mut Pcg, min: f32, max: f32) -> Rgb {
    Rgb::new(
        sample::number(rng, min, max),
        sample::number(rng, min, max),
        sample::number(rng, min, max),
    )
}
