//! Chapter 14: `refract`, `fresnel`.

use raybook::material::fresnel;
use raybook::material::refract;
use raybook::math::dir3::Dir3;
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::Vec3;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&Refract, &Fresnel];

/// See [`Exercise::TASK`].
pub struct Refract;

row! {
    /// A ray's direction and a surface between two media.
    pub struct RefractQuestion {
        /// Where the ray goes.
        pub direction: Dir3,
        /// Where the surface's outside is; the ray may come from either side.
        pub normal: Dir3,
        /// The index of refraction on the outside.
        pub outside: f32,
        /// The index of refraction on the inside.
        pub inside: f32,
    }
}

impl Exercise for Refract {
    type Question = RefractQuestion;
    type Answer = Option<Vec3>;
    const NAME: &'static str = "refract";
    const ANSWER: &'static str = "refracted";
    const TASK: &'static str = "Return the unit direction in which a ray goes on behind a surface, from its direction, the outward normal, and the indices of refraction outside and inside; or None if it is totally reflected.";

    fn answer(q: &Self::Question) -> Self::Answer {
        refract::refract(q.direction, q.normal, q.outside, q.inside).map(|t| *t)
    }
}

/// See [`Exercise::TASK`].
pub struct Fresnel;

row! {
    /// An angle, by its cosine, and two media.
    pub struct FresnelQuestion {
        /// cos θ₁: of the angle between the light and the normal, on the side from which the light comes.
        pub cos1: f32,
        /// The index of refraction on that side.
        pub n1: f32,
        /// The index of refraction on the other side.
        pub n2: f32,
    }
}

row! {
    /// The shares of the light that are reflected.
    pub struct FresnelAnswer {
        /// Of s-polarised light.
        pub rs: f32,
        /// Of p-polarised light.
        pub rp: f32,
        /// Of unpolarised light.
        pub r: f32,
    }
}

impl Exercise for Fresnel {
    type Question = FresnelQuestion;
    type Answer = FresnelAnswer;
    const NAME: &'static str = "fresnel";
    const TASK: &'static str = "Return the shares Rs, Rp and R of s-polarised, p-polarised and unpolarised light that a surface reflects, from the cosine of the angle at which the light arrives through n1, and the index n2 behind the surface.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let share = fresnel::fresnel(q.cos1, q.n1, q.n2);
        FresnelAnswer {
            rs: share.s,
            rp: share.p,
            r: share.unpolarised,
        }
    }
}
