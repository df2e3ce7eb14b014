//! What observers see of a black hole from nearer and nearer.

use crate::kit::palette::{BLUE, SKY, VERMILION, linear};
use crate::kit::sheet::sheet;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::math::dir3::Dir3;
use raybook::render::curved::black_hole::BlackHole;
use raybook::render::curved::fan::Fan;
use raybook::render::curved::observer::shadow_half_angle;
use raybook::render::film::Film;
use std::error::Error;
use std::f32::consts::{FRAC_PI_2, PI};

/// Distances of the observers from the middle of the hole, in radii of the hole.
const RADII: [f32; 4] = [10.0, 3.0, 2.0, 1.5];

/// Half of the sky as each observer sees it, looking at the hole: the distance from the middle of a tile is the angle.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn draw(film: &Film) -> Result<Image, Box<dyn Error>> {
    let tiles = RADII.map(|r| {
        let edge = shadow_half_angle(f64::from(r));
        let name = format!("r = {r}: {:.1}°", edge.to_degrees());
        let pixel = std::f64::consts::PI / film.width as f64;
        let fan = Fan::new(r * Vec3::Z, FRAC_PI_2.into(), 0.25 * pixel);
        (name, film.refine(|place, _| seen(&fan, edge as f32, place)))
    });
    sheet(4, &tiles)
}

fn seen(fan: &Fan, edge: f32, place: Vec2) -> Rgb {
    let p = vec2(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y);
    let (radius, turn) = (p.length(), p.y.atan2(p.x));
    if radius > 1.0 {
        return Rgb::WHITE;
    }
    let angle = radius * FRAC_PI_2;
    let dashed = (turn * 24.0 / PI).rem_euclid(2.0) < 1.0;
    if dashed && (angle - edge).abs() < 0.012 {
        return linear(VERMILION);
    }
    let (sine, cosine) = angle.sin_cos();
    let toward = vec3(sine * turn.cos(), sine * turn.sin(), -cosine);
    let hole = BlackHole {
        disc: None,
        sky: &ruled,
    };
    hole.radiance_by(fan, Dir3::new_or(toward, Dir3::Z))
}

/// A sky in squares of 15°, lighter before the observer than behind.
fn ruled(d: Dir3) -> Rgb {
    let square = |angle: f32| (angle / (PI / 12.0)).floor() as i32;
    let (longitude, latitude) = (d.x.atan2(-d.z), d.y.asin());
    let even = (square(longitude) + square(latitude)).rem_euclid(2) == 0;
    let colour = if d.z < 0.0 { SKY } else { BLUE };
    if even {
        linear(colour)
    } else {
        Rgb::WHITE * 0.9
    }
}
