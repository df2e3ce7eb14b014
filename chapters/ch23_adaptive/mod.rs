//! Most pixels show one surface, and a few rays are enough for them; edges and fine patterns need many. So a few rays
//! go through every pixel, and further rays where the samples differ.
//!
//! New: render/needs_more.rs render/budget.rs render/adaptive.rs

mod letters;

pub mod adaptive_gain;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::lab::plot::Plot as _;
use adaptive_gain::{map, measure, outcome, spent};
use clap::Args;
use rand::Rng;
use raybook::render::adaptive::{Limits, adaptive, by_budget};
use raybook::render::film::Film;
use raybook::render::local::Local;
use raybook::render::needs_more::StoppingRule;
use raybook::render::sampler::Sampler;
use raybook::render::shadow;
use raybook::render::whitted::Whitted;
use raybook::sample::pattern::find;
use raybook_scenes::{Shot, gallery};
use std::process::ExitCode;

/// The light that comes straight from the lamps, with shadows.
const DIRECT: Whitted = Whitted {
    local: Local {
        samples: 1,
        arrives: Some(shadow::lit),
    },
    depth: 1,
};

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Rays through each pixel before the program looks at their differences
    #[arg(long, value_name = "2..64 rays", default_value = "4")]
    first: usize,
    /// Threshold for the error of a pixel's mean: above the threshold, more rays follow, in `spent`
    #[arg(long, value_name = "0.0005..1", default_value = "0.01")]
    threshold: f32,
    /// Budget: average number of rays per pixel, for the picture by a budget, in `spent`
    #[arg(long, value_name = "2..256 rays", default_value = "12")]
    budget: usize,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let Shot { scene, camera, .. } = gallery::HORIZON.shot(film.width)?;
    let see = |place, rng: &mut dyn Rng| DIRECT.follow(&scene, &camera.central_ray(place), rng);
    let limits = Limits {
        first: knobs.first,
        most: (4 * film.samples.max(2)).max(knobs.first),
    };
    if stage.wants("picture") {
        let mean = film.samples.max(6).max(limits.first);
        let first = limits.first;
        let film = Film {
            samples: mean,
            ..film
        };
        let picture = film.render(&*camera, &Sampler::Budget { first }, &DIRECT, &scene);
        let caption = format!(
            "The scene of chapter 22 with {mean} rays per pixel on average: {first} rays at first, and further rays where these differ."
        );
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("spent") {
        let budget = knobs.budget.max(limits.first);
        let of_budget = format!("a budget of {budget}");
        let small = stage.tile(2, 16.0 / 9.0);
        let rules = [
            (
                "by contrast",
                adaptive(&small, limits, &StoppingRule::BY_CONTRAST, see),
            ),
            (
                "by variance",
                adaptive(
                    &small,
                    limits,
                    &StoppingRule::by_variance(knobs.threshold),
                    see,
                ),
            ),
            (
                of_budget.as_str(),
                by_budget(&small, limits.first, budget, see),
            ),
        ];
        let mut tiles = vec![("the picture".to_owned(), rules[2].1.picture.clone())];
        for (name, done) in &rules {
            tiles.push((format!("{name}: {}", spent(done)), map(&done.spent, limits)));
        }
        let caption = "The number of rays of each pixel, from dark blue for the fewest to yellow for the most. The contrast rule \
            sees the edges of dark squares as well as those of bright squares; the rule of variance prefers bright edges; a budget \
            spends exactly the given number of rays.";
        stage.figure("spent", caption, &sheet(2, &tiles)?)?;
    }

    if !stage.wants("error") {
        return Ok(());
    }
    let sobol = find("sobol-owen").ok_or("there is Sobol's pattern")?;
    let film = Film {
        width: 160,
        height: 90,
        ..film
    };
    let plot = measure(&film, sobol, 256, &see);
    let caption = format!(
        "The RMS error of the whole picture, compared with 256 rays per pixel, against the rays per pixel. {} Pixels whose first \
        four samples agree by chance stay wrong, no matter how many rays the other pixels get.",
        outcome(&plot)
    );
    stage.diagram("error", &caption, &plot.figure()?)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch23_adaptive")
}
