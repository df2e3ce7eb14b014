//! A summer day: sky, hills along the horizon, and a sun that is seen as bright as it shines.

use glam::{vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::directional::DirectionalLight;
use raybook::math::dir3::Dir3;
use raybook::math::ray::Ray;
use raybook::scene::noise::{layers, rise};
use std::f32::consts::PI;

/// Irradiance by the sun on a surface that faces it, in W/m².
pub const SUNLIGHT: Rgb = Rgb::new(2.9, 2.65, 2.25);

/// The sun's radius in radians: 2.5°, nearly ten times the true one, so that pixels of a third of a degree show a disc.
pub const SUN_RADIUS: f32 = 2.5 * PI / 180.0;

/// Where the sun stands.
pub fn toward_sun() -> Dir3 {
    Dir3::new_or(vec3(-0.80, 0.92, 0.52), Dir3::Y)
}

/// The sun as a light for surfaces.
pub fn sun() -> DirectionalLight {
    DirectionalLight {
        toward: toward_sun(),
        irradiance: SUNLIGHT,
    }
}

/// The sky with its clouds, a glow around the sun, and hills along the horizon; and the sun's disc, whose radiance
/// gives the irradiance [`SUNLIGHT`].
pub fn outdoors(ray: &Ray) -> Rgb {
    let d = ray.direction;
    let sky = Rgb::new(0.80, 0.86, 0.90).lerp(Rgb::new(0.20, 0.40, 0.74), d.y.max(0.0).powf(0.6));
    let above = vec2(d.x, d.z) / (d.y.abs() + 0.15);
    let cloud = rise(0.50, 0.80, layers(1.1 * above + 31.0, 5)) * rise(0.02, 0.25, d.y);
    let glow = Rgb::new(0.5, 0.45, 0.35) * (-d.distance(*toward_sun()) / 0.12).exp();
    let behind = sky.lerp(Rgb::gray(0.98), cloud) + glow + disc(d);
    let azimuth = d.x.atan2(-d.z);
    let around = vec2(azimuth.cos(), azimuth.sin());
    let ridge = 0.04 + 0.15 * layers(2.6 * around + 7.0, 5);
    let hills = Rgb::new(0.30, 0.40, 0.42).lerp(sky, 0.35);
    hills.lerp(behind, rise(-0.002, 0.002, d.y - ridge))
}

/// The sun's disc, darker towards its rim: L·√(1 − (θ/R)²), of which ⅔·πR²·L arrives.
fn disc(d: Dir3) -> Rgb {
    let off = d.distance(*toward_sun()) / SUN_RADIUS;
    let brightest = SUNLIGHT / (2.0 / 3.0 * PI * SUN_RADIUS * SUN_RADIUS);
    brightest * (1.0 - off * off).max(0.0).sqrt()
}
