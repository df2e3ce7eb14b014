//! What a picture needs before there is light: a sky, the air in front of it, and tiles to walk on.

use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::math::dir3::Dir3;
use raybook::shape::sphere::Sphere;

/// The colour of much air: the sky at the horizon.
const AIR: Rgb = Rgb::new(0.86, 0.87, 0.88);

/// Metres of air after which 1/e of a colour is left.
const RANGE: f32 = 60.0;

/// The sky in a direction: air at the horizon and below, blue above.
pub fn sky(direction: Dir3) -> Rgb {
    sky_above(0.0, direction)
}

/// The same, where the air ends at another height than the horizon's: at this y of a direction.
pub fn sky_above(end: f32, direction: Dir3) -> Rgb {
    let height = (direction.y - end).max(0.0);
    AIR.lerp(Rgb::new(0.12, 0.32, 0.68), height.sqrt())
}

/// A colour behind t metres of air: e^(−t/60 m) of it is left, and the rest is air.
pub fn haze(colour: Rgb, t: f32) -> Rgb {
    AIR.lerp(colour, (-t / RANGE).exp())
}

/// The share of a white sky's light that balls leave to a point of the floor they lie on.
///
/// A ball takes the share (r/|c − p|)²·cos θ, where θ is the angle from the zenith to its centre:
/// the sphere's view factor. Balls in the same part of the sky hide each other, so the product is an estimate.
pub fn open_sky(balls: &[Sphere], p: Vec3) -> f32 {
    let left = |ball: &Sphere| {
        let toward = ball.center - p;
        1.0 - ball.radius * ball.radius * toward.y / toward.length().powi(3)
    };
    balls.iter().map(left).product()
}

/// One of two values, as on a chess board whose squares have a side of length 1.
pub fn checker<T>(place: Vec2, even: T, odd: T) -> T {
    if place.floor().element_sum() % 2.0 == 0.0 {
        even
    } else {
        odd
    }
}
