//! From radiance, which has no upper limit, to a display, which shows at most 1.
//!
//! ```
//! use raybook::prelude::*;
//!
//! assert_eq!(tone::expose(Rgb::gray(3.0), -1.0), Rgb::gray(1.5));
//! assert!((tone::reinhard(Rgb::gray(3.0)).g - 0.75).abs() < 1e-6); // L/(1 + L)
//! assert_eq!(tone::to_byte(0.5), 188); // half of the light is far above the middle of the bytes
//! ```

use crate::image::{Image, rgb::Rgb};
use std::sync::LazyLock;

// ANCHOR: expose
/// The radiance L after an exposure: L·2^`stops`. One stop more is twice the light.
pub fn expose(radiance: Rgb, stops: f32) -> Rgb {
    radiance * stops.exp2()
}
// ANCHOR_END: expose

/// Each channel clamped to [0, 1], as in a sensor with too much light. The hue changes where only some channels are clamped.
pub fn clamp(radiance: Rgb) -> Rgb {
    radiance.map(|v| v.clamp(0.0, 1.0))
}

// ANCHOR: tone_map
/// Reinhard's curve on the luminance L, L′ = L/(1 + L), which maps [0, ∞) to [0, 1)
/// (Reinhard et al., "Photographic tone reproduction for digital images", 2002).
///
/// Every channel is scaled by L′/L = 1/(1 + L), which keeps the hue. A channel of a saturated colour may still exceed 1.
pub fn reinhard(radiance: Rgb) -> Rgb {
    radiance / (1.0 + radiance.luminance())
}
// ANCHOR_END: tone_map

// ANCHOR: film_like
/// A film-like curve per channel, (x(2.51x + 0.03)) / (x(2.43x + 0.59) + 0.14), clamped to [0, 1]:
/// dark in the shadows, steep in the middle, and bright colours fade to white
/// (Narkowicz, "ACES filmic tone mapping curve", 2016, a fit to the Academy's reference transform).
pub fn aces(radiance: Rgb) -> Rgb {
    radiance.map(|x| {
        let x = x.clamp(0.0, 1e6); // beyond it the squares overflow, and the curve has long reached 1
        (x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)).clamp(0.0, 1.0)
    })
}
// ANCHOR_END: film_like

// ANCHOR: encode_srgb
/// The sRGB code value of a linear value, both in [0, 1]: 12.92 v up to 0.0031308, then 1.055 v^(1/2.4) − 0.055
/// (IEC 61966-2-1). Values outside are clamped; NaN is encoded as 0.
pub fn encode_srgb(v: f32) -> f32 {
    let v = if v > 0.0 { v.min(1.0) } else { 0.0 };
    if v <= 0.003_130_8 {
        12.92 * v
    } else {
        let root = v.powf(1.0 / 2.4);
        root + 0.055 * (root - 1.0) // exactly 1 at 1, where 1.055 - 0.055 is 0.99999994 in f32
    }
}
// ANCHOR_END: encode_srgb

/// The linear value of an sRGB code value: the inverse of [`encode_srgb`].
pub fn decode_srgb(code: f32) -> f32 {
    if code <= 0.040_45 {
        code / 12.92
    } else {
        ((code + 0.055) / 1.055).powf(2.4)
    }
}

/// The byte that a PNG stores for a linear value v: round(255 · [`encode_srgb`]), found by a binary search for v among the 255
/// values at which the byte changes. NaN is stored as 0.
pub fn to_byte(v: f32) -> u8 {
    static CHANGES: LazyLock<[f32; 255]> =
        LazyLock::new(|| std::array::from_fn(|byte| decode_srgb((byte as f32 + 0.5) / 255.0)));
    CHANGES.partition_point(|&change| change <= v) as u8
}

/// The picture as a display shows it: clamped, encoded as sRGB, three bytes a pixel, row by row from the top left.
pub fn to_bytes(picture: &Image) -> Vec<u8> {
    // Figures have long runs of equal pixels, so the bytes of the last pixel are kept.
    let mut last = (Rgb::BLACK, [0; 3]);
    let code = |&p: &Rgb| {
        if p != last.0 {
            last = (p, p.channels().map(to_byte));
        }
        last.1
    };
    picture.pixels().iter().flat_map(code).collect()
}
