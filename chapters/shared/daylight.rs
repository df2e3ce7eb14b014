//! Sun and sky, before there are lights: enough to see shapes and their shadows.

use glam::vec3;
use raybook::accel::Accel;
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::Surface;
use raybook::shape::mesh::Facet;

/// How a triangle looks.
#[derive(Clone, Copy, Debug)]
pub struct Paint {
    /// Its colour.
    pub colour: Rgb,
    /// Whether its normals are interpolated.
    pub round: bool,
}

/// What a ray sees of a surface by daylight, with the sun's shadows.
pub fn shade(at: &Surface, paint: Paint, seen: &Ray, accel: &impl Accel<Facet>) -> Rgb {
    let Paint { colour, round } = paint;
    let (normal, toward_sun) = if round {
        (at.shading_normal, at.leave_smooth(sun()))
    } else {
        (at.normal, at.leave(sun()))
    };
    let in_sun = || !accel.any(&toward_sun, Interval::AHEAD);
    colour * light(at, normal, seen, in_sun)
}

/// The direction of the sun.
fn sun() -> Dir3 {
    Dir3::new_or(vec3(-0.62, 0.75, 0.42), Dir3::Y)
}

/// The light on a surface: the sun's, where nothing is in its way, and the sky's.
///
/// `normal` is the normal for shading; it is turned to the side that is seen.
fn light(at: &Surface, normal: Dir3, seen: &Ray, in_sun: impl Fn() -> bool) -> Rgb {
    let away = at.normal.dot(*seen.direction) > 0.0;
    let normal = if away { -normal } else { normal };
    let toward = normal.dot(*sun());
    let sunlight = if toward > 0.0 && in_sun() {
        toward
    } else {
        0.0
    };
    let skylight = 0.5 + 0.5 * normal.y;
    Rgb::new(1.0, 0.93, 0.80) * (0.95 * sunlight) + Rgb::new(0.62, 0.74, 0.95) * (0.38 * skylight)
}
