//! Circles of latitude and longitude, and small discs of equal size, over a picture: what its projection stretches.

use crate::kit::palette::{INK, linear};
use glam::{Vec2, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::image::{Image, tone};
use raybook::math::dir3::Dir3;

/// From one line to the next, in degrees.
pub const STEP: f32 = 30.0;

/// Half the width of a line, and the radius of a disc with its rim, in degrees.
const LINE: f32 = 0.25;
const DISC: f32 = 6.0;

/// So many points a pixel, in each direction, are looked at.
const POINTS: usize = 4;

/// The picture with the lines and discs of the world (such discs stand for N. A. Tissot's indicatrix, 1859); `toward` tells which
/// direction a place of the picture shows, and where there is none, the picture becomes white.
pub fn over(picture: &Image, toward: impl Fn(Vec2) -> Option<Dir3>) -> Image {
    let size = vec2(picture.width() as f32, picture.height() as f32);
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        let light = tone::clamp(picture.at(x, y));
        let points = (0..POINTS).flat_map(|j| (0..POINTS).map(move |i| vec2(i as f32, j as f32)));
        let marked = points.map(|p| {
            let place = vec2(x as f32, y as f32) + (p + 0.5) / POINTS as f32;
            toward(place / size).map_or(Rgb::WHITE, |d| marked(light, d))
        });
        marked.sum::<Rgb>() / (POINTS * POINTS) as f32
    })
}

/// What is drawn in a direction on this light.
fn marked(light: Rgb, d: Dir3) -> Rgb {
    let latitude = d.y.clamp(-1.0, 1.0).asin().to_degrees();
    let longitude = d.x.atan2(-d.z).to_degrees();
    let from_disc = angle(d, nearest_disc(latitude, longitude));
    if from_disc < DISC {
        let rim = from_disc > DISC - 2.0 * LINE;
        return if rim {
            linear(INK)
        } else {
            light.lerp(Rgb::WHITE, 0.4)
        };
    }
    let to_line = |v: f32| (v - STEP * (v / STEP).round()).abs();
    // A degree of longitude is a shorter way near a pole.
    let off = to_line(latitude).min(to_line(longitude) * latitude.to_radians().cos());
    if off < LINE {
        light.lerp(Rgb::WHITE, 0.7)
    } else {
        light
    }
}

/// The middle of the disc next to a direction: at every crossing of lines up to a latitude of 30°, at every second one of
/// 60°, and at the poles.
fn nearest_disc(latitude: f32, longitude: f32) -> Dir3 {
    let nearest = |v: f32, step: f32| step * (v / step).round();
    let at = nearest(latitude, STEP);
    let apart = match at.abs() as i32 {
        90 => 360.0,
        60 => 2.0 * STEP,
        _ => STEP,
    };
    toward(at, nearest(longitude, apart))
}

/// The direction at a latitude and a longitude in degrees.
fn toward(latitude: f32, longitude: f32) -> Dir3 {
    let (up, level) = latitude.to_radians().sin_cos();
    let (sin, cos) = longitude.to_radians().sin_cos();
    Dir3::new_or(vec3(level * sin, up, -level * cos), Dir3::Y)
}

/// The angle between two directions in degrees, by the chord: near 0 the cosine has lost its digits.
fn angle(a: Dir3, b: Dir3) -> f32 {
    2.0 * (0.5 * a.distance(*b)).min(1.0).asin().to_degrees()
}
