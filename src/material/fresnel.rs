//! Fresnel's equations: how much light a smooth surface between two media reflects.
//!
//! ```
//! use raybook::material::fresnel::fresnel;
//!
//! let glass = fresnel(1.0, 1.0, 1.5);
//! assert!((glass.unpolarised - 0.04).abs() < 1e-6); // ((1.5 − 1)/(1.5 + 1))²
//! assert_eq!(fresnel(0.5, 1.5, 1.0).unpolarised, 1.0); // from inside at 60°: total internal reflection
//! ```

/// The reflectance, the share of the light that is reflected; the rest goes through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflectance {
    /// Rs: of light polarised perpendicular to the plane of incidence (s is for German *senkrecht*).
    pub s: f32,
    /// Rp: of light polarised parallel to the plane of incidence.
    pub p: f32,
    /// R: of unpolarised light, such as that of lamps and of the sun.
    pub unpolarised: f32,
}

impl Reflectance {
    /// All light is reflected.
    pub const ALL: Self = Self::both(1.0, 1.0);
    /// No light is reflected.
    pub const NOTHING: Self = Self::both(0.0, 0.0);

    /// R = (Rs + Rp)/2: unpolarised light is half of the one and half of the other.
    const fn both(s: f32, p: f32) -> Self {
        Self {
            s,
            p,
            unpolarised: 0.5 * (s + p),
        }
    }
}

// ANCHOR: fresnel
/// Fresnel's equations: Rs = ((n₁ cos θ₁ − n₂ cos θ₂)/(n₁ cos θ₁ + n₂ cos θ₂))²,
/// Rp = ((n₁ cos θ₂ − n₂ cos θ₁)/(n₁ cos θ₂ + n₂ cos θ₁))² and R = (Rs + Rp)/2, for light that comes through a medium of the
/// index n₁ at an angle θ₁ to the normal, and goes on through n₂ at θ₂ (Fresnel's equations; Born and Wolf 1999). `cos1` is cos θ₁.
///
/// θ₂ follows from Snell's law, sin θ₂ = (n₁/n₂) sin θ₁. If this is 1 or more, all light is reflected (total internal
/// reflection). If n₁ = n₂, nothing is reflected.
pub fn fresnel(cos1: f32, n1: f32, n2: f32) -> Reflectance {
    if n1 == n2 {
        return Reflectance::NOTHING; // also at grazing incidence, where the fractions are 0/0
    }
    let cos2_squared = 1.0 - (n1 / n2).powi(2) * (1.0 - cos1 * cos1);
    if cos2_squared <= 0.0 {
        return Reflectance::ALL;
    }
    let cos2 = cos2_squared.sqrt();
    let share = |a: f32, b: f32| ((a - b) / (a + b)).powi(2);
    Reflectance::both(share(n1 * cos1, n2 * cos2), share(n1 * cos2, n2 * cos1))
}
// ANCHOR_END: fresnel

/// Schlick's approximation of R: R₀ + (1 − R₀)(1 − cos θ)⁵ with R₀ = ((n₁ − n₂)/(n₁ + n₂))². It is cheap, and for glass its error
/// is at most 0.04. θ is the angle on the side of the smaller index (Schlick, "An inexpensive BRDF model for physically-based
/// rendering", 1994).
pub fn schlick(cos1: f32, n1: f32, n2: f32) -> f32 {
    let cos2_squared = 1.0 - (n1 / n2).powi(2) * (1.0 - cos1 * cos1);
    let cosine = if n1 > n2 {
        cos2_squared.max(0.0).sqrt()
    } else {
        cos1
    };
    let r0 = ((n1 - n2) / (n1 + n2)).powi(2);
    r0 + (1.0 - r0) * (1.0 - cosine).powi(5)
}
