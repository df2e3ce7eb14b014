//! One ray per pixel turns edges into stairs, and stripes that are finer than a pixel into broad ones. Several rays and a
//! weighted average help; how much depends on where in the pixel they are.
//!
//! New: sample/filter.rs sample/pattern/mod.rs sample/pattern/rows.rs sample/pattern/regular_grid.rs
//! New: sample/pattern/rotated_grid.rs sample/pattern/random_pattern.rs sample/pattern/jittered.rs
//! New: sample/pattern/neighbours.rs sample/pattern/dart_throwing.rs sample/pattern/poisson_disk.rs
//! New: sample/pattern/n_rooks.rs sample/pattern/multi_jittered.rs sample/pattern/halton.rs sample/pattern/r2.rs
//! New: sample/pattern/owen.rs sample/pattern/best_candidate.rs
//! New: sample/padded.rs render/supersample.rs
//! Unscaled: zone_plates

mod drawings;

use crate::kit::chapter;
use crate::kit::knobs;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::lab::plot::Plot;
use crate::lab::point_sets::PointSets;
use crate::lab::polar::Polar;
use crate::lab::sheets;
use crate::lab::subject::Subject;
use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use raybook::math::pcg::Pcg;
use raybook::render::film::Film;
use raybook::render::local::Local;
use raybook::render::sampler::Sampler;
use raybook::render::shadow;
use raybook::render::whitted::Whitted;
use raybook::sample::filter::Filter;
use raybook::sample::pattern::{PATTERNS, find};
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

/// A reconstruction filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum By {
    /// The pixel's own samples, all with the same weight
    Box,
    /// The weight falls linearly with the distance
    Tent,
    /// The weight is a bell curve
    Gaussian,
    /// Mitchell and Netravali's cubic, which goes below 0
    Mitchell,
}

/// The names of the patterns.
fn patterns() -> impl Iterator<Item = &'static str> {
    PATTERNS.iter().map(|pattern| pattern.name)
}

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    /// Sampling pattern of the main picture
    #[arg(long, default_value = "jittered", value_parser = PossibleValuesParser::new(patterns()))]
    pattern: String,
    /// Reconstruction filter of the main picture
    #[arg(long, value_enum, default_value = "box")]
    filter: By,
    /// Points of each pattern, in `patterns`
    #[arg(long, value_name = "1..4096 points", default_value = "64")]
    count: usize,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let Shot { scene, camera, .. } = gallery::HORIZON.shot(film.width)?;
    let grid = find("regular-grid").ok_or("there is a grid")?;
    let jittered = find("jittered").ok_or("there is a jittered pattern")?;
    if stage.wants("picture") {
        let most = film.samples;
        let chosen = find(&knobs.pattern).ok_or("the knob has a pattern's name")?;
        let ways = [(1, grid), (most.isqrt(), chosen), (most, chosen)];
        let points = |x: usize, _: usize, rng: &mut Pcg| {
            let (samples, pattern) = ways[sheets::band(x, ways.len(), film.width)];
            (pattern.points)(samples, rng)
        };
        let film = Film {
            filter: match knobs.filter {
                By::Box => Filter::BOX,
                By::Tent => Filter::TENT,
                By::Gaussian => Filter::GAUSSIAN,
                By::Mitchell => Filter::MITCHELL,
            },
            ..film
        };
        let view = film.render(&*camera, &Sampler::Pattern(&points), &DIRECT, &scene);
        let caption = format!(
            "One picture in three bands: left, one ray through the middle of each pixel; middle and right, {} and {most} rays \
            per pixel by the pattern “{}”, averaged by the filter “{}”. With one ray, the far squares make a pattern that does not exist, and the edges are \
            stairs. With more rays, the far squares melt into grey, as they should.",
            most.isqrt(),
            chosen.title,
            knobs::word(&knobs.filter)
        );
        stage.picture("picture", &caption, &sheets::ruled(&view, ways.len()))?;
    }

    stage.drawing("letters", drawings::LETTERS, drawings::letters)?;
    stage.drawing("mean", drawings::MEAN, drawings::mean)?;
    stage.drawing("turned", drawings::TURNED, drawings::turned)?;

    let subjects: Vec<_> = PATTERNS.iter().map(Subject::of).collect();
    let all = PointSets {
        subjects: &subjects,
        n: knobs.count,
        columns: 6,
    };
    if stage.wants("patterns") {
        let caption = format!(
            "{} points in a pixel, placed in different ways: one realisation of each pattern, seed 1. Random points crowd and leave \
            gaps. Every other pattern limits this in its own way, for example by cells, by rows and columns, or by the distance \
            between points.",
            knobs.count
        );
        stage.diagram("patterns", &caption, &all.figure()?)?;
    }

    let named = "regular-grid rotated-grid random jittered poisson-disk sobol-owen".split(' ');
    let named: Vec<_> = named.filter_map(find).map(Subject::of).collect();
    if stage.wants("zone_plates") {
        let tile = stage.tile(named.len() as u32, 1.0);
        let (columns, tiles) = sheets::zone_plates(&tile, &named, &[1, 4, 16]);
        let caption = "Rings that become finer to the right and downwards, with 1, 4 and 16 samples per pixel. Regular patterns \
            show rings that do not exist; with the regular grid they are as bright as the true rings. Randomness turns the false \
            rings into noise, and the better patterns leave little of both.";
        let figure = sheet(columns, &tiles)?;
        stage.figure("zone_plates", caption, &figure)?;
    }

    if stage.wants("edges") {
        let caption = "The RMS error of four samples when an edge at this angle passes through the pixel (256 positions of the \
            edge, 100 realisations, seed 1). On average, the rotated grid is not better than the regular grid. But its worst \
            angles are far from the axes, and most edges in pictures are close to the axes.";
        let figure = Polar::measure(&named[..5], 4, 100).figure()?;
        stage.diagram("edges", caption, &figure)?;
    }

    if !stage.wants("filters") {
        return Ok(());
    }
    let caption = "The same sixteen samples per pixel, averaged by four filters. The wider filters also use samples of the \
        neighbouring pixels. Below are the weights of each filter along a line; the grey lines are centres of pixels. Mitchell's \
        filter goes below 0, which makes edges crisp.";
    let figure = sheets::filters(&stage.tile(4, 1.0), jittered)?;
    stage.figure("filters", caption, &figure)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch22_antialiasing")
}
