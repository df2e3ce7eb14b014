//! Chapter 15: `shadow_ray`, `lit`.

use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;
use raybook::image::rgb::Rgb;
use raybook::light::LightSample;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::shadow;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, sphere::Sphere};

exercises! { ($) ch15_shadows
    /// Return the ray from a surface to a light, and the interval on it in which a hit is in the way. The ray must not
    /// find the surface that it leaves, and the interval ends before the light by at most a hundredth of the way. Aiming
    /// from the moved origin, or in the given direction, is equally right.
    ShadowRay: shadow_ray(
        /// The point of the surface, in metres; along each axis it may be wrong by up to `error`.
        position: Vec3,
        /// How far the true surface may be from the point along each axis, in metres.
        error: f32,
        /// The normal of the surface, on either side.
        normal: Dir3,
        /// From the point to the light.
        toward: Dir3,
        /// The distance to the light, in metres; inf for a directional light.
        distance: f32,
    ) -> (
        /// The ray to the light.
        answer: Way,
    ) {
        let at = Surface::flat(position, error, normal);
        let (Ray { origin, direction }, within) =
            shadow::shadow_ray(&at, &light(toward, distance));
        Way {
            origin,
            direction: *direction,
            within,
        }
    }

    /// Return whether a light reaches a surface: 1 if nothing is in the way, 0 if anything is.
    ///
    /// In Rust: true or false.
    Lit: lit(
        /// The point of the surface, in metres.
        position: Vec3,
        /// How far the true surface may be from the point along each axis, in metres.
        error: f32,
        /// The normal of the surface, on either side.
        normal: Dir3,
        /// From the point to the light.
        toward: Dir3,
        /// The distance to the light, in metres; inf for a directional light.
        distance: f32,
        /// The spheres of the scene; the point may lie on one of them.
        spheres: Vec<Ball>,
    ) -> (
        /// 1 if the light reaches the point, else 0.
        lit: u32,
    ) {
        let ball = |ball: &Ball| Sphere {
            center: ball.center,
            radius: ball.radius,
        };
        let things = spheres.iter().map(|one| Thing::new(ball(one), ()));
        let scene = Scene::new(things.collect(), Vec::new());
        let at = Surface::flat(position, error, normal);
        u32::from(shadow::lit(&scene, &at, &light(toward, distance)))
    }
}

/// Light of no particular strength.
fn light(toward: Dir3, distance: f32) -> LightSample {
    LightSample {
        toward,
        distance,
        arriving: Rgb::WHITE,
        pdf: f32::INFINITY,
    }
}

row! {
    /// A ray, and the stretch of it that counts.
    pub struct Way {
        /// Where the ray starts, in metres.
        pub origin: Vec3,
        /// Where the ray goes, of length 1.
        pub direction: Vec3,
        /// The distances of hits that are in the way, min < t < max, in metres.
        pub within: Interval,
    }
}

row! {
    /// A sphere.
    pub struct Ball {
        /// The centre, in metres.
        pub center: Vec3,
        /// The radius, in metres,
        pub radius: f32 [above 0],
    }
}
