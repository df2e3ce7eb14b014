//! The angular map: all directions in a disc, where equal angles are equal distances from the middle; pictures of mirror balls
//! are converted into it (Debevec 1998).
//!
//! ```
//! use raybook::light::environment::{angular::Angular, convert::Layout};
//! use raybook::prelude::*;
//!
//! assert_eq!(Angular.place(-Dir3::Z), vec2(0.5, 0.5)); // ahead: the middle
//! let aside = Angular.place(Dir3::X) - vec2(0.5, 0.5);
//! assert!((aside.length() - 0.25).abs() < 1e-6); // 90° aside: half of the way to the rim, which is 180°
//! ```

use crate::light::environment::convert::Layout;
use crate::math::dir3::Dir3;
use glam::{Vec2, vec2};
use std::f32::consts::PI;

/// The layout of an angular map: a disc whose middle is −z. The distance from the middle is proportional to the angle between the
/// direction and −z; the whole rim is +z.
#[derive(Clone, Copy, Debug)]
pub struct Angular;

impl Layout for Angular {
    /// The direction at a place; `None` outside the disc, in the corners of the picture.
    fn direction(&self, place: Vec2) -> Option<Dir3> {
        let p = vec2(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y);
        let radius = p.length();
        if radius > 1.0 {
            return None;
        }
        let (sin, cos) = (PI * radius).sin_cos();
        let across = p.normalize_or_zero() * sin;
        Dir3::new(across.extend(-cos))
    }

    fn place(&self, direction: Dir3) -> Vec2 {
        let across = vec2(direction.x, direction.y);
        let angle = across.length().atan2(-direction.z);
        let p = angle / PI * across.try_normalize().unwrap_or(Vec2::X);
        vec2(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.y)
    }
}
