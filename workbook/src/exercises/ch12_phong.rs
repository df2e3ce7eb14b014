//! Chapter 12: `phong`, `blinn_phong`, `point_light`.

use crate::exercise::exercises;
use crate::record::row;
use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, LightSample, point::PointLight};
use raybook::material::{blinn_phong::BlinnPhong, phong::Phong};
use raybook::math::dir3::Dir3;

exercises! { ($) ch12_phong
    /// Return the radiance that Phong's model sends to the viewer from one light: diffuse k_d (L·N) i plus specular k_s
    /// (R·V)^α i, without an ambient part, where R is L mirrored at N. A negative cosine counts as 0. A light that is
    /// not above the surface gives nothing at all.
    PhongExercise: phong(
        /// The surface, its viewer, and the light.
        at: Highlight,
    ) -> (
        /// The radiance to the viewer, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
    ) {
        at.phong().reflect(at.normal, at.view, &at.light())
    }

    /// Return the same as `phong` with Blinn's highlight: k_d (L·N) i plus k_s (N·H)^α i, where H is the unit vector
    /// half way between L and V. A light that is not above the surface gives nothing at all.
    BlinnPhongExercise: blinn_phong(
        /// The surface, its viewer, and the light.
        at: Highlight,
    ) -> (
        /// The radiance to the viewer, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
    ) {
        BlinnPhong(at.phong()).reflect(at.normal, at.view, &at.light())
    }

    /// Return the light that a point light of intensity I sends to a point: the direction towards the light, its
    /// distance, and the irradiance of a surface that faces it, I/d². At the light itself there is no
    /// answer.
    PointLightExercise: point_light(
        /// The light's position, in metres.
        position: Vec3,
        /// I: the radiant intensity, in W/sr.
        intensity: Rgb,
        /// The point that is lit, in metres.
        at: Vec3,
    ) -> (
        /// The light that arrives; none at the light itself.
        answer: Option<Arriving>,
    ) {
        let light = PointLight { position, intensity };
        let sample = light.sample(at, Vec2::ZERO)?;
        Some(Arriving {
            toward: *sample.toward,
            distance: sample.distance,
            arriving: sample.arriving,
        })
    }
}

row! {
    /// A point of a surface, its viewer, and a light.
    pub struct Highlight {
        /// N: the normal, on the viewer's side.
        pub normal: Dir3,
        /// V: from the surface to the viewer.
        pub view: Dir3,
        /// L: from the surface to the light.
        pub toward: Dir3,
        /// i: the irradiance of a surface that faces the light, in W/m².
        pub arriving: Rgb,
        /// k_d: the diffuse coefficient, per steradian.
        pub diffuse: Rgb,
        /// k_s: the specular coefficient, per steradian.
        pub specular: Rgb,
        /// α: the highlight's exponent, without a unit.
        pub exponent: f32,
    }
}

impl Highlight {
    /// The material; ambient light is not asked for.
    fn phong(&self) -> Phong {
        Phong {
            ambient: Rgb::BLACK,
            diffuse: self.diffuse,
            specular: self.specular,
            exponent: self.exponent,
        }
    }

    /// The light.
    fn light(&self) -> LightSample {
        LightSample {
            toward: self.toward,
            distance: f32::INFINITY,
            arriving: self.arriving,
            pdf: f32::INFINITY,
        }
    }
}

row! {
    /// What comes from a light.
    pub struct Arriving {
        /// The direction to the light, of length 1.
        pub toward: Vec3,
        /// The distance to the light, in metres.
        pub distance: f32,
        /// The irradiance of a surface that faces the light, in W/m².
        pub arriving: Rgb,
    }
}
