//! Chapter 25: `trace`.

use raybook::image::rgb::Rgb;
use raybook::math::ray::Ray;
use raybook::render::trace;
use raybook::scene::description::Description;
use crate::exercise::{Asked, Exercise};
use crate::row::row;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&Trace];

/// See [`Exercise::TASK`].
pub struct Trace;

row! {
    /// A ray, and the scene that it is sent into.
    pub struct TraceQuestion {
        /// So many surfaces in a row may be met; beyond them all is black.
        pub depth: u32,
        /// The ray.
        pub ray: Ray,
        /// The scene.
        pub scene: Description,
    }
}

impl Exercise for Trace {
    type Question = TraceQuestion;
    type Answer = Rgb;
    const NAME: &'static str = "trace";
    const ANSWER: &'static str = "radiance";
    const TASK: &'static str = "Return the radiance that comes along a ray through a scene of spheres, planes and triangles, of Phong's material, mirrors and glass, in the light of point lamps with their shadows; after `depth` surfaces in a row all is black (the book's last chapter has every rule).";

    fn answer(q: &Self::Question) -> Self::Answer {
        trace::trace(&q.scene, &q.ray, q.depth)
    }
}
