//! Chapter 21: `geodesic_step`, `deflection_angle`.

use raybook::render::curved::deflection;
use raybook::render::curved::{Photon, geodesic};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::Vec3;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&GeodesicStep, &DeflectionAngle];

/// See [`Exercise::TASK`].
pub struct GeodesicStep;

row! {
    /// A photon, and how far it is to be moved.
    pub struct GeodesicStepQuestion {
        /// Where it is, in radii of the hole, which is at the origin.
        pub position: Vec3,
        /// dx/dλ.
        pub velocity: Vec3,
        /// The step dλ.
        pub step: f32,
    }
}

row! {
    /// The photon after the step.
    pub struct GeodesicStepAnswer {
        /// Where it is.
        pub position: Vec3,
        /// dx/dλ.
        pub velocity: Vec3,
    }
}

impl Exercise for GeodesicStep {
    type Question = GeodesicStepQuestion;
    type Answer = GeodesicStepAnswer;
    const NAME: &'static str = "geodesic_step";
    const TASK: &'static str = "Return the position and the velocity of a photon after a step along its ray around a black hole of radius 1 at the origin, where dx/dt = v and dv/dt = -(3/2) h^2 x/|x|^5 with h = |x cross v|; the bend of the ray may be wrong by 10 %.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let photon = Photon {
            x: q.position.as_dvec3(),
            v: q.velocity.as_dvec3(),
        };
        let (after, _) = geodesic::geodesic_step(photon, f64::from(q.step));
        GeodesicStepAnswer {
            position: after.x.as_vec3(),
            velocity: after.v.as_vec3(),
        }
    }
}

/// See [`Exercise::TASK`].
pub struct DeflectionAngle;

row! {
    /// A ray from far away.
    pub struct DeflectionAngleQuestion {
        /// b: how far from the hole's middle it would pass if it were straight, in radii of the hole.
        pub impact_parameter: f32,
    }
}

impl Exercise for DeflectionAngle {
    type Question = DeflectionAngleQuestion;
    type Answer = Option<f32>;
    const NAME: &'static str = "deflection_angle";
    const ANSWER: &'static str = "angle";
    const TASK: &'static str = "Return the angle in radians by which a black hole of radius 1 turns a ray that comes from far away with this impact parameter, to 1 part in 1000; or None if the ray falls in.";

    fn answer(q: &Self::Question) -> Self::Answer {
        deflection::deflection_angle(f64::from(q.impact_parameter)).map(|angle| angle as f32)
    }
}
