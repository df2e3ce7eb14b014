//! Metals: no light comes through, and the reflected light has the metal's colour.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let gold = Metal::GOLD.reflectance(1.0); // from straight above
//! assert!(gold.r > 0.9 && gold.b < 0.5); // yellow
//! assert!(Metal::GOLD.reflectance(0.01).b > 0.95); // at a grazing angle every metal is white
//! ```

use crate::image::rgb::Rgb;
use crate::material::{Delta, Material, mirror::Mirror};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// The complex index of refraction n + ik of a metal, for the red, green and blue of sRGB.
///
/// The constants are means of measured spectra, weighted by the eye's colour-matching functions: gold, silver and copper from
/// Johnson and Christy, "Optical constants of the noble metals" (1972), aluminium from Rakić et al., "Optical properties of
/// metallic films for vertical-cavity optoelectronic devices" (1998).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metal {
    /// n: the index of refraction.
    pub n: Rgb,
    /// k: the extinction coefficient. After x metres in the metal, e^(−4πkx/λ) of the light is left: 1/e after 10 to 20 nm.
    pub k: Rgb,
}

impl Metal {
    /// Gold.
    pub const GOLD: Self = Self {
        n: Rgb::new(0.143, 0.375, 1.442),
        k: Rgb::new(3.983, 2.386, 1.603),
    };
    /// Silver.
    pub const SILVER: Self = Self {
        n: Rgb::new(0.155, 0.117, 0.138),
        k: Rgb::new(4.828, 3.122, 2.147),
    };
    /// Copper.
    pub const COPPER: Self = Self {
        n: Rgb::new(0.200, 0.924, 1.102),
        k: Rgb::new(3.913, 2.453, 2.142),
    };
    /// Aluminium.
    pub const ALUMINIUM: Self = Self {
        n: Rgb::new(1.657, 0.880, 0.521),
        k: Rgb::new(9.224, 6.270, 4.837),
    };

    /// The reflectance R for unpolarised light, per channel; `cosine` is that of the angle between the light and the normal.
    pub fn reflectance(&self, cosine: f32) -> Rgb {
        let of = |n: f32, k: f32| fresnel_conductor(cosine, n, k);
        Rgb::new(
            of(self.n.r, self.k.r),
            of(self.n.g, self.k.g),
            of(self.n.b, self.k.b),
        )
    }
}

// ANCHOR: fresnel_conductor
/// The reflectance R = (Rs + Rp)/2 of a metal with the index n + ik in air: Fresnel's equations with a complex index.
///
/// With s = sin²θ, p² = ½(√((n² − k² − s)² + 4n²k²) + n² − k² − s) and q² = p² − (n² − k² − s):
/// Rs = ((p − cos θ)² + q²)/((p + cos θ)² + q²) and Rp = Rs·((p − sin θ tan θ)² + q²)/((p + sin θ tan θ)² + q²)
/// (Born and Wolf, *Principles of Optics*, 1999).
pub fn fresnel_conductor(cosine: f32, n: f32, k: f32) -> f32 {
    let cosine = cosine.clamp(0.0, 1.0);
    let s = 1.0 - cosine * cosine;
    let real = n * n - k * k - s;
    let length = real.hypot(2.0 * n * k);
    let p = (0.5 * (length + real)).max(0.0).sqrt();
    // p² + q² = length. Both sides of Rp's fraction are multiplied by cos²θ, so that there is no tangent at the horizon.
    let share = |a: f32, b: f32| (a - b) / (a + b);
    let rs = share(length + cosine * cosine, 2.0 * p * cosine);
    let rp = rs * share(length * cosine * cosine + s * s, 2.0 * p * cosine * s);
    0.5 * (rs + rp)
}
// ANCHOR_END: fresnel_conductor

/// A smooth metal surface: a mirror whose reflectance depends on the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor(pub Metal);

impl Material for Conductor {
    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        let share = self.0.reflectance(at.facing(view).dot(*view));
        Mirror { share }.delta_lobes(at, view, visit);
    }

    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
}
