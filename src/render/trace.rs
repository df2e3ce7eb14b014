//! A complete ray tracer: the radiance along a ray through a described scene.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::trace::trace;
//! use raybook::scene::description::{Backdrop, Description, Matter, Object};
//!
//! let scene = Description {
//!     ambient: Rgb::BLACK,
//!     backdrop: Backdrop { below: Rgb::BLACK, above: Rgb::WHITE },
//!     lamps: vec![],
//!     objects: vec![Object::plane(Dir3::Y, 0.0, Matter::mirror(Rgb::gray(0.9)))],
//! };
//! let down = Ray::new(Vec3::Y, -Dir3::Y);
//! assert_eq!(trace(&scene, &down, 2), Rgb::gray(0.9)); // the sky in the mirror
//! assert_eq!(trace(&scene, &down, 1), Rgb::BLACK); // the mirror is the last surface
//! ```

use crate::image::rgb::Rgb;
use crate::light::Light;
use crate::material::glass::{Glass, Medium};
use crate::material::{Material, Sight, beyond};
use crate::math::ray::Ray;
use crate::render::shadow::shadow_ray;
use crate::scene::description::{Description, Matter};
use crate::shape::Shape;
use glam::Vec2;

// ANCHOR: trace
/// The radiance that comes along a ray: that of the nearest surface, or of the backdrop if there is none; black if `depth` is 0.
///
/// A Phong surface shows k_a i_a + Σ (k_d (L·N) + k_s (R·V)^α) I/r², summed over the lamps that nothing hides. A mirror shows its
/// share of what the mirrored ray sees. Glass shows R·(what the mirrored ray sees) + (1 − R)·(what the refracted ray sees).
/// Mirror and glass call this function again, with `depth` − 1 (Whitted 1980).
pub fn trace(scene: &Description, ray: &Ray, depth: u32) -> Rgb {
    if depth == 0 {
        return Rgb::BLACK;
    }
    let Some((object, hit)) = scene.nearest(ray) else {
        return scene.backdrop.seen(ray.direction);
    };
    let at = object.form.surface(ray, &hit);
    let view = -ray.direction;
    let mut see = |ray: &Ray, _share: f32| Sight {
        radiance: trace(scene, ray, depth - 1),
        distance: f32::INFINITY, // nothing here absorbs light on its way
    };
    match &object.matter {
        Matter::Phong(phong) => {
            let lights = scene
                .lamps
                .iter()
                .filter_map(|lamp| lamp.sample(at.position, Vec2::ZERO));
            let arriving = lights.filter(|light| {
                let (ray, way) = shadow_ray(&at, light);
                !scene
                    .objects
                    .iter()
                    .any(|object| object.form.blocks(&ray, way))
            });
            let lit: Rgb = arriving.map(|light| phong.lit(&at, view, &light)).sum();
            phong.ambient(&at) * scene.ambient + lit
        }
        Matter::Mirror(mirror) => beyond(mirror, &at, view, &mut see),
        Matter::Glass(clear) => {
            let glass = Glass::of(Medium::clear(clear.index));
            beyond(&glass, &at, view, &mut see)
        }
    }
}
// ANCHOR_END: trace
