//! Shadow rays as they should not be.

use raybook::math::interval::Interval;
use raybook::math::ray::Ray;
use raybook::render::local::Arrives;
use raybook::render::shadow;

/// The right shadow ray, and three wrong ones.
pub(super) const WAYS: [(&str, Arrives); 4] = [
    ("right", shadow::lit),
    ("starts on the surface: acne", |scene, at, light| {
        // The computed point lies a little above or below the surface.
        let ray = Ray::new(at.position, light.toward);
        !scene.blocks(&ray, Interval::new(0.0, light.distance))
    }),
    ("starts a metre off: loose shadows", |scene, at, light| {
        let ray = Ray::new(at.position, light.toward);
        !scene.blocks(&ray, Interval::new(1.0, light.distance))
    }),
    ("does not end at the lamp", |scene, at, light| {
        let (ray, _) = shadow::shadow_ray(at, light);
        !scene.blocks(&ray, Interval::AHEAD)
    }),
];
