//! The light of hot bodies: from red to blue-white.
//!
//! ```
//! use raybook::light::black_body::black_body;
//!
//! let [candle, star] = [1900.0, 10_000.0].map(black_body);
//! assert!(candle.r > candle.g && candle.g > candle.b); // reddish
//! assert!(star.b > star.r); // bluish
//! ```

use crate::image::{rgb::Rgb, spectrum};
use glam::Vec3;

/// The first and the last visible wavelength, and the step of the sum over them, in nanometres.
const FIRST: u32 = 380;
const LAST: u32 = 780;
const STEP: usize = 5;

/// The colour of a black body at a temperature in kelvin, scaled so that a black body at 6500 K has luminance 1.
///
/// Planck's law (1900) B ∝ λ⁻⁵/(exp(c₂/(λT)) − 1), c₂ = hc/k, summed with the colour-matching functions of the eye, in linear
/// sRGB. A channel that would be negative, as below 1900 K, is set to 0.
pub fn black_body(kelvin: f32) -> Rgb {
    let white = eye(6500.0).y;
    spectrum::to_srgb(eye(kelvin) / white).map(|channel| channel.max(0.0))
}

/// X, Y and Z of a black body at a temperature in kelvin, up to a common factor.
fn eye(kelvin: f32) -> Vec3 {
    /// hc/k in nm·K.
    const C2: f32 = 1.438_777e7;
    (FIRST..=LAST)
        .step_by(STEP)
        .map(|nanometres| {
            let wavelength = nanometres as f32;
            // (500/λ)⁵ is near 1, whereas λ⁻⁵ in nanometres is 1e-14: with it, the sum would vanish in `f32` for cool bodies.
            let planck = (500.0 / wavelength).powi(5) / (C2 / (wavelength * kelvin)).exp_m1();
            planck * spectrum::xyz(wavelength)
        })
        .sum()
}
