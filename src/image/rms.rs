//! The difference of two pictures in one number.
//!
//! ```
//! use raybook::image::rms::rms;
//! use raybook::prelude::*;
//!
//! let of = |colour| Image::from_fn(2, 2, |_, _| colour);
//! assert_eq!(rms(&of(Rgb::BLACK), &of(Rgb::WHITE), |_, _| true), 1.0);
//! ```

use crate::image::{Image, tone};

// ANCHOR: rms
/// The root of the mean square (RMS) difference, √(mean of (a − e)²), over all channels of the pixels (x, y) for which `counts`
/// is true. a and e are sRGB code values in [0, 1], as a display shows them.
///
/// 0 for equal pictures, 1 for black and white; 1/255 is one step of a display's brightness. NaN counts as black.
///
/// # Panics
/// If a pixel of `expected` counts that `actual` does not have.
pub fn rms(expected: &Image, actual: &Image, counts: impl Fn(usize, usize) -> bool) -> f32 {
    let (mut sum, mut n) = (0.0, 0_u32);
    for y in 0..expected.height() {
        for x in (0..expected.width()).filter(|&x| counts(x, y)) {
            let [e, a] = [expected, actual].map(|picture| picture.at(x, y).map(tone::encode_srgb));
            for (e, a) in e.channels().into_iter().zip(a.channels()) {
                sum += f64::from(a - e).powi(2);
                n += 1;
            }
        }
    }
    (sum / f64::from(n.max(1))).sqrt() as f32
}
// ANCHOR_END: rms
