//! Chapter 2: `expose`, `tone_map`, `encode_srgb`.

use crate::exercise::exercises;
use raybook::image::{rgb::Rgb, tone};

exercises! { ($) ch02_hdr
    /// Return the radiance after an exposure of `stops` stops: one stop more is twice the light.
    Expose: expose(
        /// The radiance, in W·m⁻²·sr⁻¹.
        radiance: Rgb,
        /// The number of stops, any number; negative for less light.
        stops: f32,
    ) -> (
        /// The radiance after the exposure, in W·m⁻²·sr⁻¹.
        exposed: Rgb,
    ) {
        tone::expose(radiance, stops)
    }

    /// Return Reinhard's tone mapping: scale the colour so that its luminance L becomes L/(1 + L).
    ToneMap: tone_map(
        /// The radiance, where 1 is as bright as a display can be.
        radiance: Rgb,
    ) -> (
        /// The mapped colour, where 1 is as bright as a display can be.
        mapped: Rgb,
    ) {
        tone::reinhard(radiance)
    }

    /// Return the sRGB code value, from 0 to 1, of a linear value: 12.92 v up to 0.0031308, then 1.055 v^(1/2.4) −
    /// 0.055; values outside 0 to 1 are clamped.
    EncodeSrgb: encode_srgb(
        /// The linear value, without a unit; a display shows values from 0 to 1.
        v: f32,
    ) -> (
        /// The code value,
        code: f32 [from 0 to 1],
    ) {
        tone::encode_srgb(v)
    }
}
