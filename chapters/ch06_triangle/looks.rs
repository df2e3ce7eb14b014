//! What a picture may show of a surface instead of light: numbers as colours.

use crate::kit::palette::{BLUE, ORANGE, linear, viridis};
use raybook::image::rgb::Rgb;
use raybook::math::ray::Ray;
use raybook::shape::{Hit, Surface};

/// A way to colour what a ray hit.
pub(super) type Look = fn(&Ray, &Hit, &Surface) -> Rgb;

/// The distance: yellow at 5 metres, dark blue at 8.5.
pub(super) fn distance(_ray: &Ray, hit: &Hit, _at: &Surface) -> Rgb {
    viridis((8.5 - hit.t) / 3.5)
}

/// The geometric normal: x, y and z, each from −1 to 1, as red, green and blue from 0 to 1.
pub(super) fn normal(_ray: &Ray, _hit: &Hit, at: &Surface) -> Rgb {
    Rgb::new(at.normal.x, at.normal.y, at.normal.z).map(|v| 0.5 + 0.5 * v)
}

/// The side that was hit: blue where the normal points to the ray's origin, else orange.
pub(super) fn side(ray: &Ray, _hit: &Hit, at: &Surface) -> Rgb {
    let front = at.normal.dot(*ray.direction) < 0.0;
    linear(if front { BLUE } else { ORANGE })
}

/// b₀, b₁ and b₂ of a triangle, pale, with dark lines where one of them is a multiple of a quarter.
pub(super) fn barycentric_lines(_ray: &Ray, hit: &Hit, _at: &Surface) -> Rgb {
    let (b1, b2) = (hit.uv.x, hit.uv.y);
    let b = Rgb::new(1.0 - b1 - b2, b1, b2);
    let to_line = b.map(|v| (4.0 * v - (4.0 * v).round()).abs());
    if to_line.channels().iter().any(|&d| d < 0.06) {
        Rgb::gray(0.03)
    } else {
        Rgb::WHITE.lerp(b, 0.6)
    }
}
