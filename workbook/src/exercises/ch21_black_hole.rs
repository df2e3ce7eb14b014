//! Chapter 21: `geodesic_step`, `deflection_angle`.

use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;
use raybook::render::curved::deflection;
use raybook::render::curved::{Photon, geodesic};

exercises! { ($) ch21_black_hole
    /// Return the position and the velocity of a photon after a step along its ray around a black hole of radius 1 at
    /// the origin: dx/dλ = v and dv/dλ = -(3/2) h² x/|x|⁵ with h = |x × v|. The bend of the ray may be wrong by 10 %.
    GeodesicStep: geodesic_step(
        /// The photon's position, in radii of the hole, which is at the origin.
        position: Vec3,
        /// The photon's velocity dx/dλ, in radii of the hole per unit of λ.
        velocity: Vec3,
        /// The step of λ, the parameter of the ray's path: not time.
        step: f32,
    ) -> (
        /// The photon after the step.
        answer: GeodesicStepAnswer,
    ) {
        let photon = Photon {
            x: position.as_dvec3(),
            v: velocity.as_dvec3(),
        };
        let (after, _) = geodesic::geodesic_step(photon, f64::from(step));
        GeodesicStepAnswer {
            position: after.x.as_vec3(),
            velocity: after.v.as_vec3(),
        }
    }

    /// Return the angle, in radians, by which a black hole of radius 1 turns a ray that comes from far away with this
    /// impact parameter, to 1 part in 1000. There is no answer if the ray falls in.
    DeflectionAngle: deflection_angle(
        /// b: how far from the hole's middle the ray would pass if it were straight, in radii of the hole,
        impact_parameter: f32 [above 0],
    ) -> (
        /// The angle by which the ray is turned, in radians; none if it falls in.
        angle: Option<f32>,
    ) {
        deflection::deflection_angle(f64::from(impact_parameter)).map(|angle| angle as f32)
    }
}

row! {
    /// The photon after the step.
    pub struct GeodesicStepAnswer {
        /// The photon's position, in radii of the hole.
        pub position: Vec3,
        /// The photon's velocity, in radii of the hole per unit of λ.
        pub velocity: Vec3,
    }
}
