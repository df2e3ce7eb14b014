//! Chapter 13: `reflect`.

use raybook::material::mirror;
use raybook::math::dir3::Dir3;
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::Vec3;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&Reflect];

/// See [`Exercise::TASK`].
pub struct Reflect;

row! {
    /// A ray's direction, and the surface that it meets.
    pub struct ReflectQuestion {
        /// i: where the ray goes, to the surface.
        pub incoming: Dir3,
        /// n, on either side.
        pub normal: Dir3,
    }
}

impl Exercise for Reflect {
    type Question = ReflectQuestion;
    type Answer = Vec3;
    const NAME: &'static str = "reflect";
    const ANSWER: &'static str = "reflected";
    const TASK: &'static str = "Return the unit direction in which a mirror with this normal sends a ray on, from the direction in which the ray arrives; the normal may point to either side.";

    fn answer(q: &Self::Question) -> Self::Answer {
        *mirror::reflect(q.incoming, q.normal)
    }
}
