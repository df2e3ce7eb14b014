//! A panorama as a map: labelled, with lines of latitude and longitude; and with straight lines of the world on it.

use super::graticule;
use super::graticule::STEP;
use crate::kit::figure::{CENTRE, Canvas, RIGHT, SCALE, figure, text, write};
use crate::kit::palette::{BLUE, GREEN, INK, ORANGE, VERMILION};
use crate::kit::sketch::label;
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use plotters::prelude::{Circle, Color, PathElement, RGBColor};
use raybook::image::rgb::Rgb;
use raybook::image::{Image, tone};
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use std::error::Error;

/// The pixel of the canvas at a place of the map.
type Pixel<'a> = &'a dyn Fn(Vec2) -> Vec2;

/// Width and height of the map, in pixels of the figure.
const MAP: (usize, usize) = (880, 440);

/// Free space around the map, and for labels at its left and below it, in pixels of the figure.
const RIM: usize = 16;
const LABELS: usize = 64;

/// Height of the letters, in pixels of the canvas.
const TEXT: i32 = 30;

/// The panorama with labelled lines of latitude and longitude.
///
/// # Errors
/// What plotters reports.
pub(super) fn labelled(panorama: &Image) -> Result<Image, Box<dyn Error>> {
    let map = graticule::over(&panorama.resized(MAP.0, MAP.1), |place| {
        Some(latlong::direction(place))
    });
    on_canvas(&map, LABELS, |canvas, pixel| {
        for i in -3..=3 {
            let latitude = STEP * i as f32;
            let place = pixel(vec2(0.0, 0.5 - latitude / 180.0)) - vec2(12.0, 0.0);
            write(
                canvas,
                &degrees(latitude),
                whole(place),
                text(TEXT).pos(RIGHT),
            )?;
        }
        for i in -6..=6 {
            let longitude = STEP * i as f32;
            let place = pixel(vec2(0.5 + longitude / 360.0, 1.0)) + vec2(0.0, 28.0);
            write(
                canvas,
                &degrees(longitude),
                whole(place),
                text(TEXT).pos(CENTRE),
            )?;
        }
        for (longitude, name) in [(-90.0, "left"), (0.0, "ahead"), (90.0, "right")] {
            let place = pixel(vec2(0.5 + longitude / 360.0, 1.0)) + vec2(0.0, 72.0);
            label(canvas, place, name, INK)?;
        }
        for (turn, aside) in [(0.0, 40.0), (1.0, -40.0)] {
            label(
                canvas,
                pixel(vec2(turn, 1.0)) + vec2(aside, 72.0),
                "behind",
                INK,
            )?;
        }
        Ok(())
    })
}

/// The panorama, pale, with lines as they are seen from a point; each line has a name and the two ends of the part that exists in
/// the scene. Beyond its ends a line goes on in dashes to its two vanishing points, which are named for the first line.
///
/// # Errors
/// What plotters reports.
pub(super) fn with_lines(
    panorama: &Image,
    eye: Vec3,
    lines: &[(&str, [Vec3; 2])],
) -> Result<Image, Box<dyn Error>> {
    let fitted = panorama.resized(MAP.0, MAP.1);
    let pale = |x, y| tone::clamp(fitted.at(x, y)).lerp(Rgb::WHITE, 0.45);
    on_canvas(&Image::from_fn(MAP.0, MAP.1, pale), RIM, |canvas, pixel| {
        let horizon = [0.0, 1.0].map(|turn| whole(pixel(vec2(turn, 0.5))));
        canvas.draw(&PathElement::new(horizon, INK.stroke_width(2)))?;
        for ((name, ends), colour) in lines.iter().zip([BLUE, VERMILION, GREEN, ORANGE]) {
            line(canvas, pixel, eye, *ends, colour)?;
            let [a, b] = ends.map(|end| end - eye);
            let middle = latlong::place(Dir3::new_or(0.5 * (a + b), Dir3::Y));
            let inside = middle.clamp(vec2(0.075, 0.0), vec2(0.925, 1.0));
            label(canvas, pixel(inside) - vec2(0.0, 34.0), name, colour)?;
        }
        for (i, (_, [a, b])) in lines.iter().enumerate() {
            for toward in [*b - *a, *a - *b] {
                let place = pixel(latlong::place(Dir3::new_or(toward, Dir3::X)));
                canvas.draw(&Circle::new(whole(place), 10, INK.filled()))?;
                if i == 0 {
                    label(canvas, place + vec2(0.0, 40.0), "vanishing point", INK)?;
                }
            }
        }
        Ok(())
    })
}

/// A line of the world, drawn in steps of the angle at which its points are seen, so that both ends reach the horizon.
fn line(canvas: &Canvas, pixel: Pixel, eye: Vec3, [a, b]: [Vec3; 2], colour: RGBColor) -> Drawn {
    /// Points along half of a circle around the viewer.
    const POINTS: i32 = 360;
    let along = (b - a).normalize_or_zero();
    let foot = a + (eye - a).dot(along) * along;
    let (nearest, away) = ((foot - eye).normalize_or_zero(), foot.distance(eye));
    let place = |i: i32| {
        let angle = i as f32 * std::f32::consts::PI / POINTS as f32;
        let (sin, cos) = angle.sin_cos();
        let t = (foot - a).dot(along) + away * angle.tan();
        let there = (0.0..=a.distance(b)).contains(&t);
        let toward = Dir3::new_or(cos * nearest + sin * along, Dir3::Y);
        (latlong::place(toward), there)
    };
    let half = POINTS / 2 - 1;
    for i in -half..half {
        let ((from, there), (to, _)) = (place(i), place(i + 1));
        let over_seam = (from.x - to.x).abs() > 0.5;
        let dash = i.rem_euclid(6) < 3;
        if !over_seam && (there || dash) {
            let ends = [from, to].map(|p| whole(pixel(p)));
            let style = colour.stroke_width(if there { 9 } else { 5 });
            canvas.draw(&PathElement::new(ends, style))?;
        }
    }
    Ok(())
}

/// A figure of the map with space at its left and below it, on which more is drawn.
fn on_canvas(
    map: &Image,
    space: usize,
    draw: impl Fn(&Canvas, Pixel) -> Drawn,
) -> Result<Image, Box<dyn Error>> {
    let (width, height) = (space + MAP.0 + RIM, RIM + MAP.1 + space);
    let corner = vec2(space as f32, RIM as f32);
    let size = vec2(MAP.0 as f32, MAP.1 as f32);
    let pixel = |place| SCALE as f32 * (corner + place * size);
    let figure = figure(width as u32, height as u32, |canvas| {
        let scale = SCALE as usize;
        for (x, y) in (0..scale * MAP.1).flat_map(|y| (0..scale * MAP.0).map(move |x| (x, y))) {
            let [r, g, b] = map.at(x / scale, y / scale).channels().map(tone::to_byte);
            let place = ((scale * space + x) as i32, (scale * RIM + y) as i32);
            canvas.draw_pixel(place, &RGBColor(r, g, b))?;
        }
        draw(canvas, &pixel)
    })?;
    Ok(figure.pixels)
}

fn whole(pixel: Vec2) -> (i32, i32) {
    (pixel.x.round() as i32, pixel.y.round() as i32)
}

fn degrees(v: f32) -> String {
    format!("{v:.0}°").replace('-', "−")
}
