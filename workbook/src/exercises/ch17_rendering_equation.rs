//! Chapter 17: `cosine_hemisphere`, `brdf_phong`, `reflected_radiance`.

use raybook::image::rgb::Rgb;
use raybook::material::modified_phong::ModifiedPhong;
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::reflection;
use raybook::sample::hemisphere;
use raybook::shape::Surface;
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, Vec3, vec2};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&CosineHemisphere, &BrdfPhong, &ReflectedRadiance];

/// See [`Exercise::TASK`].
pub struct CosineHemisphere;

row! {
    /// A normal, and how many points are asked.
    pub struct CosineHemisphereQuestion {
        /// The normal.
        pub normal: Dir3,
        /// How many points of the unit square are asked.
        pub n: u32,
    }
}

/// n points of the unit square, evenly spread: ((i + ½)/n, the fraction of 0.618034 (i + ½)), for i from 0 to n − 1.
pub fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n).map(move |i| {
        let i = f64::from(i) + 0.5;
        vec2((i / f64::from(n)) as f32, (0.618_034 * i).fract() as f32)
    })
}

impl Exercise for CosineHemisphere {
    type Question = CosineHemisphereQuestion;
    type Answer = Vec<Vec3>;
    const NAME: &'static str = "cosine_hemisphere";
    const ANSWER: &'static str = "direction";
    const TASK: &'static str = "Return a direction of the hemisphere around the normal for a point u of the unit square, such that evenly spread points become directions with the density cos θ/π per steradian; the answer is the list of the n directions for u = ((i + ½)/n, the fraction of 0.618034 · (i + ½)) with i from 0 to n − 1.";

    fn answer(q: &Self::Question) -> Self::Answer {
        lattice(q.n)
            .map(|u| *hemisphere::cosine_hemisphere(q.normal, u))
            .collect()
    }
}

/// See [`Exercise::TASK`].
pub struct BrdfPhong;

row! {
    /// A surface of Phong's modified model, and two directions.
    pub struct BrdfPhongQuestion {
        /// The normal.
        pub normal: Dir3,
        /// From the surface to the viewer.
        pub view: Dir3,
        /// From the surface to the light.
        pub toward: Dir3,
        /// The albedo of the matt part.
        pub diffuse: Rgb,
        /// The albedo of the highlight.
        pub specular: Rgb,
        /// The highlight's exponent.
        pub exponent: f32,
    }
}

impl Exercise for BrdfPhong {
    type Question = BrdfPhongQuestion;
    type Answer = Rgb;
    const NAME: &'static str = "brdf_phong";
    const ANSWER: &'static str = "f";
    const TASK: &'static str = "Return the BRDF of the modified Phong model, in 1/sr: diffuse/π + specular · (n + 2)/2π · cosⁿ of the angle between the viewer and the mirror direction of the light; no highlight beyond 90°, and nothing at all if the light or the viewer is not above the surface.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let brdf = ModifiedPhong {
            diffuse: q.diffuse,
            specular: q.specular,
            exponent: q.exponent,
        };
        brdf.value(q.normal, q.view, q.toward)
    }
}

/// See [`Exercise::TASK`].
pub struct ReflectedRadiance;

row! {
    /// A surface, a viewer, a sky, and a number of samples.
    pub struct ReflectedRadianceQuestion {
        /// The normal.
        pub normal: Dir3,
        /// From the surface to the viewer, who is above it.
        pub view: Dir3,
        /// The albedo of the matt part.
        pub diffuse: Rgb,
        /// The albedo of the highlight.
        pub specular: Rgb,
        /// The highlight's exponent.
        pub exponent: f32,
        /// Where the sky is brightest.
        pub zenith: Dir3,
        /// How bright it is there; opposite it is black, and in between radiance · (1 + cos γ)/2 at an angle γ to the zenith.
        pub radiance: Rgb,
        /// How many samples to take.
        pub samples: u32,
    }
}

impl ReflectedRadianceQuestion {
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

impl Exercise for ReflectedRadiance {
    type Question = ReflectedRadianceQuestion;
    type Answer = Rgb;
    const NAME: &'static str = "reflected_radiance";
    const ANSWER: &'static str = "radiance";
    const TASK: &'static str = "Return an estimate of the radiance that a surface reflects towards the viewer, by the mean of f · incoming · cos θ/p over so many random directions of density p above the surface; here the surface is that of brdf_phong, and the light comes from a sky of radiance · (1 + cos γ)/2 at an angle γ to its zenith, however the surface is turned.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let at = Surface {
            position: Vec3::ZERO,
            error: 0.0,
            normal: q.normal,
            shading_normal: q.normal,
            texture: Vec2::ZERO,
        };
        let rng = &mut pcg::stream(17, u64::from(q.samples));
        let sky = |toward| q.sky(toward);
        reflection::reflected_radiance(&q.brdf(), &at, q.view, &sky, q.samples, rng)
    }
}
