//! Chapter 20: the ray of a panorama.

use super::Explained;
use super::way::Way;
use raybook_workbook::exercises::ch01_rays::CameraRayAnswer;
use raybook_workbook::exercises::ch20_panorama::PanoramaRay;
use std::f64::consts::{PI, TAU};

impl Explained for PanoramaRay {
    fn work(&self, way: &mut Way) -> CameraRayAnswer {
        let [forward, right, up] = [self.forward, self.right, self.up].map(|d| d.as_dvec3());
        let film = way.part("film", self.film.as_dvec2());
        let phi = way.number(
            "φ = 2π (film.x − ½), around up",
            "rad",
            TAU * (film.x - 0.5),
        );
        let theta = way.number("θ = π film.y, down from up", "rad", PI * film.y);
        let (sin_phi, cos_phi) = phi.sin_cos();
        let (sin_theta, cos_theta) = theta.sin_cos();
        let cos_phi = way.part("cos φ", cos_phi);
        let sin_phi = way.part("sin φ", sin_phi);
        let sin_theta = way.part("sin θ", sin_theta);
        let cos_theta = way.part("cos θ", cos_theta);
        let ahead = way.part("cos φ · forward", cos_phi * forward);
        let aside = way.part("sin φ · right", sin_phi * right);
        let level = way.vector("level = cos φ · forward + sin φ · right", "", ahead + aside);
        let level = way.part("sin θ · level", sin_theta * level);
        let upward = way.part("cos θ · up", cos_theta * up);
        let direction = way.vector("direction = sin θ · level + cos θ · up", "", level + upward);
        CameraRayAnswer {
            origin: self.position,
            direction: direction.as_vec3(),
        }
    }
}
