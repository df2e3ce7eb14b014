//! Chapter 17: `cosine_hemisphere`, `brdf_phong`, `reflected_radiance`.

use crate::exercise::exercises;
use glam::{Vec2, Vec3, vec2};
use raybook::image::rgb::Rgb;
use raybook::material::modified_phong::ModifiedPhong;
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::reflection;
use raybook::sample::hemisphere;
use raybook::shape::Surface;

exercises! { ($) ch17_rendering_equation
    /// Return directions of the hemisphere around the normal with the probability density cos θ/π per steradian. Each
    /// belongs to a point of the unit square, u = ((i + ½)/n, the fractional part of 0.618034 · (i + ½)) with i from 0
    /// to n − 1.
    CosineHemisphere: cosine_hemisphere(
        /// The normal.
        normal: Dir3,
        /// The number of points of the unit square.
        n: u32,
    ) -> (
        /// The n directions of length 1, one for each point.
        direction: Vec<Vec3>,
    ) {
        lattice(n)
            .map(|u| *hemisphere::cosine_hemisphere(normal, u))
            .collect()
    }

    /// Return the BRDF of the modified Phong model, in 1/sr: diffuse/π + specular · (n + 2)/2π · cosⁿ α, where α is the
    /// angle between the viewer and the mirror direction of the light. There is no highlight where α is above 90°. The
    /// BRDF is 0 if the light or the viewer is not above the surface.
    BrdfPhong: brdf_phong(
        /// The normal.
        normal: Dir3,
        /// From the surface to the viewer.
        view: Dir3,
        /// From the surface to the light.
        toward: Dir3,
        /// The albedo of the matte part,
        diffuse: Rgb [from 0 to 1],
        /// The albedo of the highlight,
        specular: Rgb [from 0 to 1],
        /// n: the highlight's exponent, without a unit.
        exponent: f32,
    ) -> (
        /// The BRDF, per steradian.
        f: Rgb,
    ) {
        let brdf = ModifiedPhong {
            diffuse,
            specular,
            exponent,
        };
        brdf.value(normal, view, toward)
    }

    /// Estimate the radiance that a surface like that of brdf_phong reflects towards the viewer: the average of f ·
    /// incoming · cos θ/p over random directions of density p above the surface. The light comes from a sky of
    /// radiance · (1 + cos γ)/2 at the angle γ from its zenith.
    ReflectedRadiance: reflected_radiance(
        /// The normal.
        normal: Dir3,
        /// The direction to the viewer, which is above the surface.
        view: Dir3,
        /// The albedo of the matte part,
        diffuse: Rgb [from 0 to 1],
        /// The albedo of the highlight,
        specular: Rgb [from 0 to 1],
        /// The highlight's exponent, without a unit.
        exponent: f32,
        /// Where the sky is brightest; it does not turn with the surface.
        zenith: Dir3,
        /// The sky's radiance at the zenith, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
        /// The number of samples,
        samples: u32 [1 or more],
    ) -> (
        /// An estimate of the radiance to the viewer, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
    ) |q| {
        let at = Surface::flat(Vec3::ZERO, 0.0, q.normal);
        let rng = &mut pcg::stream(17, u64::from(q.samples));
        let sky = |toward| q.sky(toward);
        reflection::reflected_radiance(&q.brdf(), &at, q.view, &sky, q.samples, rng)
    }
}

/// n points of the unit square, evenly spread: ((i + ½)/n, the fraction of 0.618034 (i + ½)), for i from 0 to n − 1.
pub fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n).map(move |i| {
        let i = f64::from(i) + 0.5;
        vec2((i / f64::from(n)) as f32, (0.618_034 * i).fract() as f32)
    })
}

impl ReflectedRadiance {
    /// The sky's radiance.
    pub fn sky(&self, toward: Dir3) -> Rgb {
        self.radiance * (0.5 + 0.5 * toward.dot(*self.zenith))
    }

    /// The surface's BRDF.
    pub fn brdf(&self) -> ModifiedPhong {
        ModifiedPhong {
            diffuse: self.diffuse,
            specular: self.specular,
            exponent: self.exponent,
        }
    }
}
