//! Contact sheets of patterns and filters at work.

use crate::kit::figure::figure;
use crate::kit::of_each::of_each;
use crate::kit::palette::{BLUE, FAINT};
use crate::kit::sheet::sheet;
use crate::lab::subject::Subject;
use crate::lab::targets;
use crate::lab::targets::Target;
use glam::{Vec2, vec2};
use plotters::prelude::{Color, PathElement};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::math::pcg;
use raybook::render::film::Film;
use raybook::render::supersample::supersample;
use raybook::sample::filter::Filter;
use raybook::sample::pattern::Pattern;
use std::error::Error;

/// The band of n bands, side by side, that a column of a picture of this width is in.
pub fn band(column: usize, n: usize, width: usize) -> usize {
    column * n / width
}

/// The same picture, with white lines between its n bands.
pub fn ruled(picture: &Image, n: usize) -> Image {
    let width = picture.width();
    let line = width.div_ceil(480);
    Image::from_fn(width, picture.height(), |x, y| {
        let is_line = x >= line && band(x, n, width) != band(x - line, n, width);
        if is_line {
            Rgb::WHITE
        } else {
            picture.at(x, y)
        }
    })
}

/// Number of realisations. Each pixel has one, chosen by the pixel's number: the eye sees no repetition.
const POOL: u64 = 256;

/// A target as a film sees it with a pattern: each pixel has one of many realisations.
pub fn view(film: &Film, subject: &Subject, target: Target) -> Image {
    views(film, subject, &[target]).remove(0)
}

/// Several targets, all seen by the same realisations.
pub fn views(film: &Film, subject: &Subject, targets: &[Target]) -> Vec<Image> {
    let pixels = film.width as f32;
    let drawn = of_each(POOL as usize, |k| subject.points(film.samples, k as u64));
    let view = |target: &Target| {
        film.render_pixels(|x, y, _| {
            let number = pcg::mix((y * film.width + x) as u64) % POOL;
            let corner = vec2(x as f32, y as f32);
            let seen = drawn[number as usize]
                .iter()
                .map(|p| target((corner + *p) / pixels, pixels));
            seen.sum::<Rgb>() / film.samples as f32
        })
    };
    targets.iter().map(view).collect()
}

/// The zone plate by each pattern, a row for each number of samples: how many tiles are in a row, and the tiles.
pub fn zone_plates(
    film: &Film,
    subjects: &[Subject],
    samples: &[usize],
) -> (usize, Vec<(String, Image)>) {
    let tiles = samples.iter().flat_map(|&samples| {
        let film = Film { samples, ..*film };
        subjects.iter().map(move |subject| {
            let name = format!("{}, {samples}", subject.title);
            (name, view(&film, subject, targets::zone_plate))
        })
    });
    (subjects.len(), tiles.collect())
}

/// Each filter's picture of edges, enlarged, and below it the filter.
///
/// # Errors
/// What plotters reports.
pub fn filters(film: &Film, pattern: &Pattern) -> Result<Image, Box<dyn Error>> {
    const TIMES: usize = 5;
    let small = Film {
        width: film.width.div_ceil(TIMES),
        height: film.height.div_ceil(TIMES),
        samples: 16,
        ..*film
    };
    let pixels = small.width as f32;
    let side = small.width * TIMES;
    let mut tiles = Vec::new();
    for filter in Filter::ALL {
        let film = Film { filter, ..small };
        let seen = supersample(&film, pattern, |place, _| {
            targets::slanted_edge(place, pixels)
        });
        tiles.push((filter.name, seen.enlarged(TIMES)));
    }
    for filter in Filter::ALL {
        tiles.push(("", profile(&filter, side as u32)?));
    }
    sheet(Filter::ALL.len(), &tiles)
}

/// The filter's weight along x, between the centres of the pixels two to the left and two to the right.
fn profile(filter: &Filter, side: u32) -> Result<Image, Box<dyn Error>> {
    let profile = figure(side, side, |canvas| {
        let side = (2 * side) as f32;
        let place = |x: f32, weight: f32| {
            let on_canvas = vec2(0.5 + 0.22 * x, 0.85 - 0.72 * weight) * side;
            (on_canvas.x as i32, on_canvas.y as i32)
        };
        let stroke = (side / 200.0).ceil() as u32;
        for pixel in -2..=2 {
            let x = pixel as f32;
            let tick = vec![place(x, -0.03), place(x, 1.1)];
            canvas.draw(&PathElement::new(tick, FAINT.stroke_width(stroke)))?;
        }
        let axis = vec![place(-2.2, 0.0), place(2.2, 0.0)];
        canvas.draw(&PathElement::new(axis, FAINT.stroke_width(2 * stroke)))?;
        let top = filter.weight(Vec2::ZERO);
        let curve = (-220..=220).map(|i| {
            let x = i as f32 / 100.0;
            place(x, filter.weight(vec2(x, 0.0)) / top)
        });
        let curve = PathElement::new(curve.collect::<Vec<_>>(), BLUE.stroke_width(3 * stroke));
        canvas.draw(&curve)?;
        Ok(())
    })?;
    Ok(profile.pixels)
}
