//! An environment that is sampled uniformly, to show what sampling by light is good for.

use glam::{Vec2, Vec3};
use raybook::light::environment::Environment;
use raybook::light::extent::shine;
use raybook::light::{Light, LightHit, LightSample};
use raybook::math::dir3::Dir3;
use raybook::math::ray::Ray;
use std::f32::consts::PI;

/// An environment whose directions are chosen uniformly: each is as likely as any other.
#[derive(Debug)]
pub struct UniformEnvironment(pub Environment);

/// One over the solid angle of all directions, per steradian.
const PDF: f32 = 0.25 / PI;

impl Light for UniformEnvironment {
    fn sample(&self, _at: Vec3, u: Vec2) -> Option<LightSample> {
        let (cosine, (sin, cos)) = (1.0 - 2.0 * u.y, (2.0 * PI * u.x).sin_cos());
        let sine = (1.0 - cosine * cosine).sqrt();
        let toward = Dir3::new(Vec3::new(sine * cos, cosine, sine * sin))?;
        shine(toward, f32::INFINITY, self.0.radiance(toward), PDF)
    }

    fn seen(&self, ray: &Ray, farthest: f32) -> Option<LightHit> {
        let hit = self.0.seen(ray, farthest)?;
        Some(LightHit { pdf: PDF, ..hit })
    }
}
