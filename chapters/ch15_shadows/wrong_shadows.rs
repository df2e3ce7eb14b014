//! Wrong shadow rays.

use raybook::light::LightSample;
use raybook::math::interval::Interval;
use raybook::math::ray::Ray;
use raybook::render::shadow;
use raybook::scene::world::Scene;
use raybook::shape::Surface;

/// A way to decide whether light arrives: a function, or a closure with parameters of its own.
pub(super) type Way<'a> = &'a (dyn Fn(&Scene, &Surface, &LightSample) -> bool + Sync);

/// A roof over the marbles, in the words of their file.
pub(super) const ROOF: &str = r#"
[[shapes]]
kind = "plane"
point_m = [0.0, 7.0, 0.0]
normal = [0, -1, 0]
material = { kind = "phong", colour = [0.80, 0.78, 0.72] }
"#;

/// Whether light arrives by a shadow ray without an end, which a wall behind the lamp stops.
pub(super) fn without_end(scene: &Scene, at: &Surface, light: &LightSample) -> bool {
    let (ray, _) = shadow::shadow_ray(at, light);
    !scene.blocks(&ray, Interval::AHEAD)
}

/// Whether light arrives by a shadow ray from the computed point, which lies a little above or below the surface; its first
/// `offset` metres do not count.
pub(super) fn starts_off(offset: f32) -> impl Fn(&Scene, &Surface, &LightSample) -> bool + Sync {
    move |scene, at, light| {
        let ray = Ray::new(at.position, light.toward);
        !scene.blocks(&ray, Interval::new(offset, light.distance))
    }
}

/// A length in the unit that people would say: `30 cm`.
pub(super) fn length(metres: f32) -> String {
    let (factor, unit) = match metres {
        m if m < 0.01 => (1000.0, "mm"),
        m if m < 1.0 => (100.0, "cm"),
        _ => (1.0, "m"),
    };
    format!("{} {unit}", (100.0 * factor * metres).round() / 100.0)
}
