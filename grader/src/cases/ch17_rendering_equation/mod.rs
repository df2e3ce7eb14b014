//! Chapter 17: `cosine_hemisphere`, `brdf_phong`, `reflected_radiance`.

use crate::sample;
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, pcg::Pcg};

raybook_workbook::ch17_rendering_equation!(graded);

/// The direction at a height over the horizon, and an angle around the normal.
fn at_height(z: f32, phi: f32) -> Vec3 {
    let r = (1.0 - z * z).max(0.0).sqrt();
    vec3(r * phi.cos(), r * phi.sin(), z)
}

/// The world's axis that is farthest from a direction and from its opposite.
fn farthest(direction: Dir3) -> Vec3 {
    Vec3::AXES[direction.abs().min_position()]
}

fn colour(rng: &mut Pcg, min: f32, max: f32) -> Rgb {
    Rgb::new(
        sample::number(rng, min, max),
        sample::number(rng, min, max),
        sample::number(rng, min, max),
    )
}
