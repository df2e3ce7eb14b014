//! Chapter 15: `shadow_ray`, `lit`.

use raybook::image::rgb::Rgb;
use raybook::light::LightSample;
use raybook::material::{Material, mirror::Mirror};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::shadow;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, sphere::Sphere};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, Vec3};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&ShadowRay, &Lit];

/// A surface, as far as a shadow needs to know it.
fn surface(position: Vec3, error: f32, normal: Dir3) -> Surface {
    Surface {
        position,
        error,
        normal,
        shading_normal: normal,
        texture: Vec2::ZERO,
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

/// See [`Exercise::TASK`].
pub struct ShadowRay;

row! {
    /// A surface, and where a light is.
    pub struct ShadowRayQuestion {
        /// The point.
        pub position: Vec3,
        /// How far the true surface may be from it along each axis, in metres.
        pub error: f32,
        /// The direction square to the surface.
        pub normal: Dir3,
        /// To the light.
        pub toward: Dir3,
        /// How far the light is; inf for a directional one.
        pub distance: f32,
    }
}

row! {
    /// A ray, and the stretch of it that counts.
    pub struct Way {
        /// Where it starts.
        pub origin: Vec3,
        /// Where it goes.
        pub direction: Vec3,
        /// Only hits at min < t < max are in the way.
        pub within: Interval,
    }
}

impl Exercise for ShadowRay {
    type Question = ShadowRayQuestion;
    type Answer = Way;
    const NAME: &'static str = "shadow_ray";
    const TASK: &'static str = "Return the ray from a surface to a light, and the interval of it on which a hit is in the way: it must not find the surface again that it leaves, which `error` bounds, and must end just before the light.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let at = surface(q.position, q.error, q.normal);
        let (Ray { origin, direction }, within) =
            shadow::shadow_ray(&at, &light(q.toward, q.distance));
        Way {
            origin,
            direction: *direction,
            within,
        }
    }
}

/// See [`Exercise::TASK`].
pub struct Lit;

row! {
    /// A sphere.
    pub struct Ball {
        /// Its centre.
        pub center: Vec3,
        /// Its radius.
        pub radius: f32,
    }
}

row! {
    /// A surface, where a light is, and what may be in the way.
    pub struct LitQuestion {
        /// The point.
        pub position: Vec3,
        /// How far the true surface may be from it along each axis, in metres.
        pub error: f32,
        /// The direction square to the surface.
        pub normal: Dir3,
        /// To the light.
        pub toward: Dir3,
        /// How far the light is; inf for a directional one.
        pub distance: f32,
        /// The spheres of the scene; the point may lie on one of them.
        pub spheres: Vec<Ball>,
    }
}

impl Exercise for Lit {
    type Question = LitQuestion;
    type Answer = u32;
    const NAME: &'static str = "lit";
    const ANSWER: &'static str = "lit";
    const TASK: &'static str = "Return whether a light reaches a surface: true (a 1 in the answer) if nothing is in the way, false (a 0) if anything is.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let share = Rgb::BLACK;
        let things = q.spheres.iter().map(|ball| -> Thing<dyn Material> {
            let sphere = Sphere::new(ball.center, ball.radius);
            Thing::new(sphere, Box::new(Mirror { share }))
        });
        let scene = Scene::new(things.collect(), Vec::new());
        let at = surface(q.position, q.error, q.normal);
        u32::from(shadow::lit(&scene, &at, &light(q.toward, q.distance)))
    }
}
