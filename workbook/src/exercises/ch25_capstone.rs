//! Chapter 25: `trace`.

use crate::exercise::exercises;
use raybook::image::rgb::Rgb;
use raybook::math::ray::Ray;
use raybook::render::trace;
use raybook::scene::description::Description;

exercises! { ($) ch25_capstone
    /// Return the radiance that comes along a ray through a scene of spheres, planes and triangles, of Phong's
    /// materials, mirrors and glass, in the light of point lamps with their shadows. After `depth` surfaces in a row all
    /// is black. The lesson of the capstone has every rule.
    Trace: trace(
        /// The maximum number of surfaces in a row; beyond them all is black.
        depth: u32,
        /// The ray.
        ray: Ray,
        /// The scene.
        scene: Description,
    ) -> (
        /// The radiance that comes along the ray, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
    ) {
        trace::trace(&scene, &ray, depth)
    }
}
