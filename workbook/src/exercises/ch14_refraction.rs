//! Chapter 14: `refract`, `fresnel`.

use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;
use raybook::material::fresnel;
use raybook::material::refract;
use raybook::math::dir3::Dir3;

exercises! { ($) ch14_refraction
    /// Return the unit direction in which a ray goes on behind a surface, from its direction, the outward normal, and
    /// the indices of refraction outside and inside. There is no answer if the ray is totally reflected.
    Refract: refract(
        /// Where the ray goes; it may come from either side.
        direction: Dir3,
        /// The normal, to the outside.
        normal: Dir3,
        /// The index of refraction on the outside, without a unit.
        outside: f32,
        /// The index of refraction on the inside, without a unit.
        inside: f32,
    ) -> (
        /// Where the refracted ray goes, of length 1; none if it is totally reflected.
        refracted: Option<Vec3>,
    ) {
        refract::refract(direction, normal, outside, inside).map(|t| *t)
    }

    /// Return the fractions Rs, Rp and R of s-polarised, p-polarised and unpolarised light that a surface reflects,
    /// from the cosine of the angle at which the light arrives through n1, and the index n2 behind the surface.
    Fresnel: fresnel(
        /// cos θ₁ of the angle between the light and the normal, on the side from which the light comes,
        cos1: f32 [from 0 to 1],
        /// The index of refraction on that side, without a unit.
        n1: f32,
        /// The index of refraction on the other side, without a unit.
        n2: f32,
    ) -> (
        /// The shares of the light that are reflected.
        answer: FresnelAnswer,
    ) {
        let share = fresnel::fresnel(cos1, n1, n2);
        FresnelAnswer {
            rs: share.s,
            rp: share.p,
            r: share.unpolarised,
        }
    }
}

row! {
    /// The shares of the light that are reflected.
    pub struct FresnelAnswer {
        /// The share of s-polarised light,
        pub rs: f32 [from 0 to 1],
        /// The share of p-polarised light,
        pub rp: f32 [from 0 to 1],
        /// The share of unpolarised light,
        pub r: f32 [from 0 to 1],
    }
}
