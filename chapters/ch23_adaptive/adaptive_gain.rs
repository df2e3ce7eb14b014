//! What adaptive supersampling saves: the error against the number of rays.

use crate::kit::palette::viridis;
use crate::lab::error_plot::{Curve, ErrorPlot};
use crate::lab::errors::Error;
use crate::lab::pens::pen;
use raybook::image::Image;
use raybook::render::adaptive::{Adaptive, Limits, adaptive, by_budget};
use raybook::render::film::Film;
use raybook::render::followed::Followed;
use raybook::render::needs_more::StoppingRule;
use raybook::render::supersample::{Radiance, supersample};
use raybook::sample::pattern::Pattern;

/// The map of samples spent, on a logarithmic scale: dark blue for the fewest, yellow for the most.
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
/// `see` follows each ray; the reference picture has `reference` samples per pixel.
pub fn measure(
    film: &Film,
    pattern: &Pattern,
    reference: usize,
    see: &impl Radiance<Followed>,
) -> ErrorPlot {
    let exact = Film {
        samples: reference,
        seed: film.seed.wrapping_add(1),
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
        of(adaptive(film, limits, &StoppingRule::BY_CONTRAST, see))
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

/// What the curves of [`measure`] say, in words: which share of the rays a budget needs for the error of 16 rays everywhere, and
/// the number of rays from which on the contrast rule is worse than the same number everywhere.
pub fn outcome(plot: &ErrorPlot) -> String {
    let [same, budget, contrast] = [0, 1, 2].map(|i| &plot.curves[i].errors[..]);
    let with_16 = error_at(same, 16.0);
    // The rays of a curve at this error; the curve falls.
    let rays = (32..=160).map(|tenths| 0.125 * f64::from(tenths));
    let enough = rays.clone().find(|&n| error_at(budget, n) <= with_16);
    let worse = rays
        .clone()
        .find(|&n| error_at(contrast, n) > error_at(same, n));
    let share = enough.map(|n| {
        let percent = 100.0 * n / 16.0;
        format!("With a budget, {percent:.0} % of the rays give the error of 16 rays everywhere.")
    });
    let worse = worse.map(|n| {
        format!("From {n:.0} rays on, the rule by contrast has a larger error than the same number of rays everywhere.")
    });
    share.into_iter().chain(worse).collect::<Vec<_>>().join(" ")
}

/// The error of a curve at `n` rays, on the straight lines between its points on logarithmic axes; beyond an end, the error of
/// that end.
fn error_at(errors: &[Error], n: f64) -> f64 {
    let between = errors.windows(2).find(|pair| n <= pair[1].n as f64);
    let Some([left, right]) = between else {
        return errors.last().map_or(f64::INFINITY, |last| last.rms);
    };
    let along = (n / left.n as f64).ln() / (right.n as f64 / left.n as f64).ln();
    left.rms * (right.rms / left.rms).powf(along.clamp(0.0, 1.0))
}

/// The mean number of rays per pixel, as text for a caption: "7.3 rays per pixel".
pub fn spent(done: &Adaptive) -> String {
    format!("{:.1} rays per pixel", done.mean())
}
