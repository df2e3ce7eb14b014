//! Test pictures that alias, as functions of a place on the film.

use glam::{Vec2, vec2};
use raybook::image::rgb::Rgb;
use raybook::material::checkered::is_odd;
use std::f32::consts::PI;

/// The colour at a place on the film, in [0, 1]² from the top left, with `pixels` pixels along each side.
pub type Target = fn(place: Vec2, pixels: f32) -> Rgb;

/// All targets, by name.
pub const TARGETS: [(&str, Target); 3] = [
    ("zone plate", zone_plate),
    ("checkered plane", checkered_plane),
    ("slanted edge", slanted_edge),
];

/// Rings around the top left. Their frequency grows with the distance, to one wave per pixel at a distance of one side: half way
/// there, the rings are as fine as pixels can show.
pub fn zone_plate(place: Vec2, pixels: f32) -> Rgb {
    Rgb::gray(0.5 + 0.5 * (PI * pixels * place.length_squared()).cos())
}

/// A chess board from the feet to the horizon.
pub fn checkered_plane(place: Vec2, _pixels: f32) -> Rgb {
    const HORIZON: f32 = 0.22;
    let below = place.y - HORIZON;
    if below <= 0.0 {
        return Rgb::new(0.62, 0.78, 0.92);
    }
    let on_plane = vec2((place.x - 0.5) / below, 1.0 / below) * 2.4;
    if is_odd(on_plane) {
        Rgb::new(0.07, 0.09, 0.14)
    } else {
        Rgb::new(0.86, 0.84, 0.78)
    }
}

/// A fan of nine sectors around the bottom left: edges from nearly horizontal to nearly vertical.
pub fn slanted_edge(place: Vec2, _pixels: f32) -> Rgb {
    let angle = (1.0 - place.y + 0.03).atan2(place.x + 0.03);
    if (angle / (0.5 * PI) * 9.0).floor() % 2.0 == 0.0 {
        Rgb::new(0.90, 0.88, 0.84)
    } else {
        Rgb::new(0.05, 0.13, 0.25)
    }
}
