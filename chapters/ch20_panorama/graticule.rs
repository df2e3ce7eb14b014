//! Circles of latitude and longitude, and small discs of equal size, over a picture: what its projection stretches.

use crate::kit::palette::{INK, linear};
use glam::{Vec2, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::image::{Image, tone};
use raybook::math::dir3::Dir3;

/// Angle from one line to the next, in degrees.
pub(super) const STEP: f32 = 30.0;

/// Half the width of a line, and the radius of a disc with its rim, in degrees.
const LINE: f32 = 0.25;
const DISC: f32 = 6.0;

/// Points per pixel along each axis.
const POINTS: usize = 4;

/// The picture with the lines and discs of the world (such discs stand for N. A. Tissot's indicatrix, 1859); `toward` tells which
/// direction a place of the picture shows; where there is no direction, the picture becomes white.
pub(super) fn over(picture: &Image, toward: impl Fn(Vec2) -> Option<Dir3>) -> Image {
    let size = vec2(picture.width() as f32, picture.height() as f32);
    // The corners of the pixels, row by row; four pixels share a corner.
    let columns = picture.width() + 1;
    let corners = (0..columns * (picture.height() + 1))
        .map(|i| toward(vec2((i % columns) as f32, (i / columns) as f32) / size));
    let corners: Vec<_> = corners.collect();
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        let light = tone::clamp(picture.at(x, y));
        let corner = vec2(x as f32, y as f32);
        let middle = toward((corner + 0.5) / size);
        let ends = [0, 1, columns, columns + 1].map(|to| corners[y * columns + x + to]);
        // Where no line or rim comes near the pixel, all its points are alike.
        if let (Some(middle), [Some(a), Some(b), Some(c), Some(d)]) = (middle, ends) {
            let reach = [a, b, c, d]
                .map(|end| angle(middle, end))
                .into_iter()
                .fold(0.0, f32::max);
            let mark = Mark::at(middle);
            if mark.clear > 2.0 * reach {
                return mark.on(light);
            }
        }
        let points = (0..POINTS).flat_map(|j| (0..POINTS).map(move |i| vec2(i as f32, j as f32)));
        let marked = points.map(|p| {
            let place = (corner + (p + 0.5) / POINTS as f32) / size;
            toward(place).map_or(Rgb::WHITE, |d| Mark::at(d).on(light))
        });
        marked.sum::<Rgb>() / (POINTS * POINTS) as f32
    })
}

/// What is drawn in a direction.
struct Mark {
    what: What,
    /// How far it is, in degrees, to where something else is drawn; less, if in doubt.
    clear: f32,
}

enum What {
    Nothing,
    Line,
    Disc,
    Rim,
}

impl Mark {
    fn at(d: Dir3) -> Self {
        let latitude = d.y.clamp(-1.0, 1.0).asin().to_degrees();
        let longitude = d.x.atan2(-d.z).to_degrees();
        let from_disc = angle(d, nearest_disc(latitude, longitude));
        let to_rim = DISC - 2.0 * LINE - from_disc;
        let to_line = |v: f32| (v - STEP * (v / STEP).round()).abs();
        // A degree of longitude is a shorter way near a pole.
        let off = to_line(latitude).min(to_line(longitude) * latitude.to_radians().cos());
        let (what, clear) = if to_rim > 0.0 {
            (What::Disc, to_rim)
        } else if from_disc < DISC {
            (What::Rim, 0.0)
        } else if off < LINE {
            (What::Line, 0.0)
        } else {
            (What::Nothing, (off - LINE).min(from_disc - DISC))
        };
        Self { what, clear }
    }

    /// The mark on this light.
    fn on(&self, light: Rgb) -> Rgb {
        match self.what {
            What::Nothing => light,
            What::Line => light.lerp(Rgb::WHITE, 0.7),
            What::Disc => light.lerp(Rgb::WHITE, 0.4),
            What::Rim => linear(INK),
        }
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
