//! Rough metal: a surface of mirrors that are too small to be seen (microfacets).
//!
//! ```
//! use raybook::prelude::*;
//!
//! let steel = |alpha| Ggx { metal: Metal::ALUMINIUM, alpha };
//! // The rougher the metal, the lower the peak of its normals: 1/(π α²).
//! assert!((steel(0.1).normals(1.0) / steel(0.2).normals(1.0) - 4.0).abs() < 1e-3);
//! assert!(steel(0.2).hidden(0.1) > steel(0.1).hidden(0.1)); // and the more facets are hidden
//! ```

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::material::conductor::Metal;
use crate::material::mirror::reflect;
use crate::math::{basis::Basis, dir3::Dir3};
use crate::shape::Surface;
use glam::{Vec2, Vec3, vec3};
use std::f32::consts::{PI, TAU};

/// A metal whose surface consists of microfacets, with normals distributed by GGX (Walter et al., "Microfacet models for
/// refraction through rough surfaces", 2007; the same as Trowbridge and Reitz 1975).
///
/// The model follows only one reflection, so the light that one facet sends to another is lost: of light from straight above, 1 %
/// for α = 0.1, 31 % for 0.5, and ln 2 = 69 % for 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ggx {
    /// The metal of the facets.
    pub metal: Metal,
    /// α: the roughness, from [`Ggx::SMOOTHEST`] to 1.
    pub alpha: f32,
}

impl Ggx {
    /// The smallest roughness. Below it, single precision cannot represent the peak: use
    /// [`crate::material::conductor::Conductor`].
    pub const SMOOTHEST: f32 = 1e-3;

    // ANCHOR: ggx
    /// D(h) = α²/(π ((n·h)² (α² − 1) + 1)²): the distribution of the facets' normals h, in 1/sr; ∫ D (n·h) dω = 1. `cosine` is
    /// n·h.
    pub fn normals(&self, cosine: f32) -> f32 {
        let squared = self.alpha * self.alpha;
        // 1 − (1 − α²) cos² without cancellation where cos is nearly 1
        let spread = (1.0 - cosine * cosine).max(0.0) + squared * cosine * cosine;
        squared / (PI * spread * spread)
    }

    /// Λ = (√(1 + α² tan²θ) − 1)/2: the area of hidden facets per area of visible facets, as seen at the angle θ to the normal
    /// (Smith 1967). `cosine` is cos θ.
    pub fn hidden(&self, cosine: f32) -> f32 {
        let squared = cosine * cosine;
        let tangent = (1.0 - squared).max(0.0) / squared;
        0.5 * ((1.0 + self.alpha * self.alpha * tangent).sqrt() - 1.0)
    }
    // ANCHOR_END: ggx
}

impl Ggx {
    /// The cosines n·v, n·l, n·h and v·h, where h is the facet's normal; `None` if viewer or light is behind the surface.
    fn cosines(at: &Surface, view: Dir3, toward: Dir3) -> Option<[f32; 4]> {
        let normal = at.facing(view);
        let (out, into) = (normal.dot(*view), normal.dot(*toward));
        let half = Dir3::new(*view + *toward)?;
        (out > 0.0 && into > 0.0).then(|| [out, into, normal.dot(*half), view.dot(*half)])
    }
}

impl Material for Ggx {
    /// f = F(v·h) D(h) G/(4 (n·l)(n·v)) with G = 1/(1 + Λ(v) + Λ(l)): the facets that mirror l to v, times the share G of them
    /// that both viewer and light see.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        let Some([out, into, half, facet]) = Self::cosines(at, view, toward) else {
            return Rgb::BLACK;
        };
        let seen = 1.0 / (1.0 + self.hidden(out) + self.hidden(into));
        self.metal.reflectance(facet) * (self.normals(half) * seen / (4.0 * out * into))
    }

    // ANCHOR: visible_normals
    /// The mirror direction of one of the facets that the viewer sees, chosen with a probability proportional to the facet's
    /// visible area (Heitz, "Sampling the GGX distribution of visible normals", 2018).
    ///
    /// Scaled by 1/α in height, the facets have the normals of a hemisphere. The viewer sees the hemisphere as a disc, of which a
    /// point is chosen uniformly: it is a facet. Its normal is scaled back.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        let normal = at.facing(view);
        let basis = Basis::around(normal);
        let local = vec3(basis.x.dot(*view), basis.y.dot(*view), normal.dot(*view));
        if local.z <= 0.0 {
            return None;
        }
        let squeeze = vec3(self.alpha, self.alpha, 1.0);
        let seen_from = Dir3::new(squeeze * local)?;
        let across = Dir3::new(Vec3::Z.cross(*seen_from)).unwrap_or(Dir3::X);
        let up = seen_from.cross(*across);
        let (r, phi) = (u.x.sqrt(), TAU * u.y);
        let x = r * phi.cos();
        // The half of the disc beyond its middle is foreshortened: y in ±√(1 − x²) is mapped to the part that is seen.
        let share = 0.5 * (1.0 + seen_from.z);
        let y = (1.0 - share) * (1.0 - x * x).max(0.0).sqrt() + share * r * phi.sin();
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        let facet = x * *across + y * up + z * *seen_from;
        let facet = Dir3::new(vec3(
            self.alpha * facet.x,
            self.alpha * facet.y,
            facet.z.max(0.0),
        ))?;
        let facet = Dir3::new_or(basis.to_world(*facet), normal);
        let toward = reflect(-view, facet);
        (toward.dot(*normal) > 0.0).then_some(toward)
    }
    // ANCHOR_END: visible_normals

    /// p = D(h)/(4 (n·v)(1 + Λ(v))), in 1/sr: the density of visible normals, D(h) (v·h)/((n·v)(1 + Λ(v))), over the factor 4
    /// (v·h) between solid angles of h and of the mirror direction.
    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        Self::cosines(at, view, toward).map_or(0.0, |[out, _, half, _]| {
            self.normals(half) / (4.0 * out * (1.0 + self.hidden(out)))
        })
    }
}
