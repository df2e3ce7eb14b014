//! What adaptive supersampling saves: the error against the rays that were spent.

use crate::kit::palette::viridis;
use crate::lab::error_plot::{Curve, ErrorPlot};
use crate::lab::errors::Error;
use crate::lab::pens::pen;
use raybook::image::Image;
use raybook::render::adaptive::{Adaptive, Limits, adaptive, by_budget};
use raybook::render::film::Film;
use raybook::render::followed::Followed;
use raybook::render::needs_more::Enough;
use raybook::render::supersample::{Radiance, supersample};
use raybook::sample::pattern::Pattern;

/// The map of samples spent: dark blue for the least, yellow for the most, each doubling a step.
pub fn map(spent: &Image, limits: Limits) -> Image {
    let [first, most] = [limits.first, limits.most].map(|n| (n.max(1) as f32).log2());
    spent.map(|p| viridis((p.r.log2() - first) / (most - first).max(1.0)))
}

/// The root of the mean squared difference of two pictures' luminance.
pub fn rms(one: &Image, other: &Image) -> f64 {
    let pairs = one.pixels().iter().zip(other.pixels());
    let squares = pairs.map(|(p, q)| f64::from(p.luminance() - q.luminance()).powi(2));
    (squares.sum::<f64>() / one.pixels().len() as f64).sqrt()
}

/// Error against rays: the same number for every pixel, by a budget, and by contrast.
///
/// `see` is asked for every ray; the reference has `reference` samples a pixel.
pub fn measure(
    film: &Film,
    pattern: &Pattern,
    reference: usize,
    see: &impl Radiance<Followed>,
) -> ErrorPlot {
    let exact = Film {
        samples: reference,
        seed: film.seed + 1,
        ..*film
    };
    let exact = supersample(&exact, pattern, see);
    let error =
        |mean: f64, picture: &Image| Error::exactly(mean.round() as usize, rms(picture, &exact));
    let same = [4, 8, 16, 32].map(|samples| {
        let film = Film { samples, ..*film };
        error(samples as f64, &supersample(&film, pattern, see))
    });
    let of = |done: Adaptive| error(done.mean(), &done.picture);
    let budget = [6, 8, 16, 32].map(|mean| of(by_budget(film, 4, mean, see)));
    let contrast = [16, 32, 64, 128].map(|most| {
        let limits = Limits { first: 4, most };
        of(adaptive(film, limits, &Enough::BY_CONTRAST, see))
    });
    let curve = |i, key: &str, title: &str, errors: &[Error]| Curve {
        key: key.to_owned(),
        title: title.to_owned(),
        pen: pen(i),
        errors: errors.to_vec(),
    };
    ErrorPlot {
        title: "error against rays per pixel".to_owned(),
        curves: vec![
            curve(0, "same", "the same everywhere", &same),
            curve(1, "budget", "by a budget", &budget),
            curve(2, "contrast", "by contrast", &contrast),
        ],
    }
}

/// The rays that a pixel got, as text for a caption: "7.3 rays per pixel".
pub fn spent(done: &Adaptive) -> String {
    format!("{:.1} rays per pixel", done.mean())
}
