//! Rounding down to a whole number.
//!
//! ```
//! use raybook::math::whole::below;
//!
//! assert_eq!([2.5, -0.5, -3.0].map(below), [2, -1, -3]);
//! ```

/// The largest whole number that is not above v. It is faster than `f32::floor`, which is a function call.
#[inline]
pub fn below(v: f32) -> i32 {
    let toward_zero = v as i32;
    toward_zero.wrapping_sub(i32::from(v < toward_zero as f32))
}
