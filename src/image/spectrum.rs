//! The colour of light of one wavelength, as the eye sees it and in the primaries of a display.
//!
//! ```
//! use raybook::image::spectrum;
//!
//! let green = spectrum::rgb(550.0);
//! assert!(green.g > 0.5 && green.r < green.g && green.b < 0.0); // no display can show it: the blue would be negative
//! ```

use crate::image::rgb::Rgb;
use glam::{Mat3, Vec3, vec3};

/// The colour-matching functions x̄, ȳ, z̄ of the standard observer (CIE 1931) at a wavelength in nanometres; ȳ is the luminous
/// efficiency, 1 at 555 nm.
///
/// Sums of bell curves with two widths each; the error against the tables is within 1 % of the greatest value (Wyman, Sloan and
/// Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2013).
pub fn xyz(nanometres: f32) -> Vec3 {
    let bell = |height: f32, middle: f32, below: f32, above: f32| {
        let width = if nanometres < middle { below } else { above };
        height * (-0.5 * ((nanometres - middle) / width).powi(2)).exp()
    };
    vec3(
        bell(1.056, 599.8, 37.9, 31.0) + bell(0.362, 442.0, 16.0, 26.7)
            - bell(0.065, 501.1, 20.4, 26.2),
        bell(0.821, 568.8, 46.9, 40.5) + bell(0.286, 530.9, 16.3, 31.1),
        bell(1.217, 437.0, 11.8, 36.0) + bell(0.681, 459.0, 26.0, 13.8),
    )
}

/// The linear sRGB colour of light of one wavelength, in nanometres. A channel is negative where the light is more saturated than
/// the display's primaries can show.
pub fn rgb(nanometres: f32) -> Rgb {
    to_srgb(xyz(nanometres))
}

/// The linear sRGB colour of what the eye sees as X, Y and Z.
pub fn to_srgb(xyz: Vec3) -> Rgb {
    /// From XYZ to linear sRGB (IEC 61966-2-1), by columns.
    const TO_SRGB: Mat3 = Mat3::from_cols(
        vec3(3.240_6, -0.968_9, 0.055_7),
        vec3(-1.537_2, 1.875_8, -0.204),
        vec3(-0.498_6, 0.041_5, 1.057),
    );
    let Vec3 { x, y, z } = TO_SRGB * xyz;
    Rgb::new(x, y, z)
}
