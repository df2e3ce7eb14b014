//! Supersampling: several rays per pixel, placed by a pattern and averaged by a filter.

use crate::image::Image;
use crate::math::pcg::Pcg;
use crate::render::film::{Done, Film, SILENT};
use crate::render::followed::Followed;
use crate::sample::filter::{Filter, Sample, pixel_average};
use crate::sample::pattern::Pattern;
use glam::{Vec2, vec2};

/// A function that returns what a ray through a place on the film, in [0, 1]² from the top left, sees.
pub trait Radiance<S>: Fn(Vec2, &mut Pcg) -> S + Sync {}

impl<S, F: Fn(Vec2, &mut Pcg) -> S + Sync> Radiance<S> for F {}

// ANCHOR: supersample
/// The picture whose pixels are the mean of `film.samples` samples each, placed by a pattern: a box filter.
///
/// Every pixel has its own random numbers, and so its own points if the pattern is random.
pub fn supersample<S: Into<Followed>>(
    film: &Film,
    pattern: &Pattern,
    radiance: impl Radiance<S>,
) -> Image {
    let size = vec2(film.width as f32, film.height as f32);
    film.render_pixels(|x, y, rng| {
        let points = (pattern.points)(film.samples, rng);
        let corner = vec2(x as f32, y as f32);
        let seen = points
            .iter()
            .map(|p| radiance((corner + *p) / size, rng).into());
        seen.sum::<Followed>().mean_of(film.samples)
    })
}
// ANCHOR_END: supersample

/// As [`supersample`], but each sample counts for all pixels within the filter's radius, with the filter's weight.
///
/// A pixel near the picture's edge has fewer samples; their weights are divided by their sum there too.
///
/// # Panics
/// If `pattern.points` returns fewer than `film.samples` points.
pub fn filtered<S: Into<Followed>>(
    film: &Film,
    pattern: &Pattern,
    filter: &Filter,
    radiance: impl Radiance<S>,
) -> Image {
    let (n, size) = (film.samples, vec2(film.width as f32, film.height as f32));
    let silent = Film {
        progress: SILENT,
        ..*film
    };
    let points = silent.each_pixel(&|_, _, rng| ((pattern.points)(n, rng), 0));
    let points = |x: usize, y: usize| &points[y * film.width + x];
    // First, a wide picture of what each ray sees, the samples of a pixel side by side.
    let wide = Film {
        width: film.width * n,
        progress: &|Done { pixels, rays }| {
            let pixels = pixels / n.max(1);
            (film.progress)(Done { pixels, rays })
        },
        ..*film
    };
    let seen = wide.render_pixels(|column, y, rng| {
        let (x, i) = (column / n, column % n);
        let p = points(x, y)[i];
        radiance((vec2(x as f32, y as f32) + p) / size, rng)
    });
    let reach = (filter.radius + 0.5).floor() as usize;
    let near = |v: usize, end: usize| v.saturating_sub(reach)..(v + reach + 1).min(end);
    silent.render_pixels(|x, y, _| {
        let mut samples = Vec::new();
        for (i, j) in near(y, film.height).flat_map(|j| near(x, film.width).map(move |i| (i, j))) {
            let corner = vec2(i as f32 - x as f32, j as f32 - y as f32) - 0.5;
            for (p, sample) in points(i, j).iter().zip(0..) {
                samples.push(Sample {
                    offset: corner + *p,
                    radiance: seen.at(i * n + sample, j),
                });
            }
        }
        pixel_average(filter, &samples)
    })
}
