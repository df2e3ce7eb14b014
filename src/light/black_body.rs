//! The light of hot bodies: from red to blue-white.

use crate::image::rgb::Rgb;
use glam::{Mat3, Vec3, vec3};

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
    // From XYZ to linear sRGB (IEC 61966-2-1), column by column.
    let to_srgb = Mat3::from_cols(
        vec3(3.2406, -0.9689, 0.0557),
        vec3(-1.5372, 1.8758, -0.2040),
        vec3(-0.4986, 0.0415, 1.0570),
    );
    let rgb = (to_srgb * (eye(kelvin) / white)).max(Vec3::ZERO);
    Rgb::new(rgb.x, rgb.y, rgb.z)
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
            planck * sensitivity(wavelength)
        })
        .sum()
}

/// The colour-matching functions of the CIE 1931 observer at a wavelength in nanometres (fit of Wyman, Sloan and Shirley 2013).
fn sensitivity(wavelength: f32) -> Vec3 {
    let bell = |middle: f32, below: f32, above: f32| {
        let width = if wavelength < middle { below } else { above };
        (-0.5 * ((wavelength - middle) / width).powi(2)).exp()
    };
    vec3(
        1.056 * bell(599.8, 37.9, 31.0) + 0.362 * bell(442.0, 16.0, 26.7)
            - 0.065 * bell(501.1, 20.4, 26.2),
        0.821 * bell(568.8, 46.9, 40.5) + 0.286 * bell(530.9, 16.3, 31.1),
        1.217 * bell(437.0, 11.8, 36.0) + 0.681 * bell(459.0, 26.0, 13.8),
    )
}
