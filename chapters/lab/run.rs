//! The sampling lab from the first plot to the page.

use crate::kit::stage::Drawn;
use crate::lab::error_plot::{Curve, ErrorPlot, OneByOne};
use crate::lab::errors::{EACH, errors};
use crate::lab::integrands::{CLASSES, Integrand};
use crate::lab::page::{Page, Tiles};
use crate::lab::pens::pens;
use crate::lab::point_sets::PointSets;
use crate::lab::polar::Polar;
use crate::lab::portrait::Portrait;
use crate::lab::prefix_plot::PrefixPlot;
use crate::lab::settings::{FEW, Settings};
use crate::lab::sheets;
use crate::lab::steps::Steps;
use crate::lab::table::Row;
use crate::lab::targets::TARGETS;
use maud::html;
use raybook::math::pcg;
use raybook::render::film::Film;
use std::error::Error;
use std::path::PathBuf;

/// Number of realisations for what takes long and is known well from few: discrepancies and the table.
const FEW_TIMES: u64 = 20;

/// Maximum number of curves that are told apart in one plot.
const TOGETHER: usize = 8;

/// Number of pairs of pixels whose errors are compared.
const PAIRS: usize = 500;

/// Maximum number of points in all realisations of n samples: for large n there are fewer realisations.
const EFFORT: usize = 100 * 1024;

/// Minimum number of realisations: fewer say nothing about a median.
const FEWEST: usize = 25;

/// Measures and draws everything, and returns the page's path.
///
/// # Errors
/// If a figure cannot be drawn or written.
pub fn run(settings: &Settings) -> Result<PathBuf, Box<dyn Error>> {
    let steps = 4 * settings.subjects.len() + settings.samples.len() + 1;
    let mut lab = Lab {
        settings,
        page: Page::new(settings),
        steps: Steps::new(steps as u64),
        portraits: Vec::new(),
    };
    lab.point_sets()?;
    lab.errors()?;
    lab.errors_by_angle()?;
    lab.portraits()?;
    lab.prefixes()?;
    lab.pictures()?;
    lab.table()?;
    lab.steps.finish();
    lab.page.finish()
}

/// A run of the lab.
struct Lab<'a> {
    settings: &'a Settings,
    page: Page,
    steps: Steps,
    portraits: Vec<Portrait>,
}

impl Lab<'_> {
    /// Members of every class of functions, always the same for the same seed.
    fn classes(&self, count: usize) -> Vec<Vec<Integrand>> {
        let class = |(i, class): (u64, &crate::lab::integrands::Class)| {
            class.members(count, &mut pcg::stream(self.settings.seed, i))
        };
        (0..).zip(&CLASSES).map(class).collect()
    }

    /// "n = 256, 100 realisations, seed 1": how something was measured.
    fn how(&self, points: &str, realisations: u64) -> String {
        let times = if realisations == 1 {
            "realisation"
        } else {
            "realisations"
        };
        format!(
            "{points}, {realisations} {times}, seed {}",
            self.settings.seeds
        )
    }

    fn point_sets(&mut self) -> Drawn {
        let text = html! { p { "A square for each pattern, with its points. Thin lines are the cells, or the rows and columns, \
        that hold one point each." } };
        self.page.section("Points", text);
        for n in [FEW, self.settings.points] {
            let alt = format!("{n} points of each pattern, in a square for each pattern.");
            let how = self.how(&format!("n = {n}"), 1);
            let sets = PointSets {
                subjects: &self.settings.subjects,
                n,
                columns: self.settings.subjects.len().div_ceil(3).max(4),
            };
            self.page.plot(&format!("points_{n}"), &alt, &how, &sets)?;
        }
        Ok(())
    }

    fn errors(&mut self) -> Drawn {
        let text = html! {
            p { "The error is |mean over the samples − exact mean|. A curve shows the median error: half of all draws have a \
                smaller error. A bar on the right shows the middle 80 % of the draws at the largest number of samples; with \
                three curves or fewer, bands show the middle 80 % everywhere. A draw is one function of the class with one \
                realisation of the pattern; each realisation sees eight functions, and all patterns see the same functions. "
                "The slope is fitted to the medians from 64 samples on, and ± is its 95 % confidence interval. Dashed lines have \
                the slopes −½ (random samples), −¾ (a cell for each sample, at edges), −1 (a cell for each sample, smooth \
                functions) and −3/2 (scrambled Sobol points, smooth functions)." }
        };
        self.page.section("Error against samples", text);
        let wanted = self.settings.realisations as usize;
        let classes = self.classes(EACH * wanted);
        let mut plots = CLASSES.map(|class| ErrorPlot {
            title: class.name.to_owned(),
            curves: Vec::new(),
        });
        let subjects = &self.settings.subjects;
        for (subject, pen) in subjects.iter().zip(pens(subjects)) {
            self.steps.begin(format!("error of {}", subject.title));
            let counts = self.settings.counts.iter().copied();
            let by_count: Vec<_> = counts
                .filter(|&n| subject.realisations(n, 1) > 0)
                .map(|n| errors(subject, n, &classes, wanted.min((EFFORT / n).max(FEWEST))))
                .collect();
            for (i, plot) in plots.iter_mut().enumerate() {
                plot.curves.push(Curve {
                    key: subject.key.clone(),
                    title: subject.title.clone(),
                    pen,
                    errors: by_count.iter().map(|errors| errors[i]).collect(),
                });
            }
            self.steps.done();
        }
        let (least, most) = (self.settings.counts.first(), self.settings.counts.last());
        let range = format!("n = {} to {}", least.unwrap_or(&1), most.unwrap_or(&1));
        for (plot, class) in plots.iter().zip(CLASSES) {
            let name = format!("error_{}", plot.title.replace(' ', "_"));
            let alt = format!(
                "Error against samples, a curve for each pattern. {}.",
                class.text
            );
            let draws = format!("{range}, {} functions", EACH * wanted);
            let how = self.how(&draws, wanted as u64) + ", fewer for large n";
            self.page.plot(&name, &alt, &how, plot)?;
            if plot.curves.len() > TOGETHER {
                let alt = "The same curves, one in each panel, before the others.";
                let name = format!("{name}_one_by_one");
                self.page.plot(&name, alt, &how, &OneByOne(plot))?;
            }
        }
        Ok(())
    }

    fn errors_by_angle(&mut self) -> Drawn {
        let text = html! {
            p { "How to read the plot: the direction from the centre is the direction in which a straight edge faces; the small \
                squares around the plot show a pixel with an edge at that angle. The edge is moved through the pixel from one \
                side to the other. At every position, the share of samples that the edge covers is compared with the share of \
                area that it covers. "
                "The distance of the curve from the centre is the root of the mean squared difference (RMS error): far out is \
                bad." }
            p { "A circle means that the error does not depend on the angle. A regular grid is worst along the axes: there, \
                whole rows of samples are covered at once, and pictures have most of their edges at these angles: walls, \
                windows, horizons. The rotated grid is not better on average, but its bad angles are elsewhere. Random samples \
                have no bad angle, but a larger error at every angle." }
        };
        self.page.section("Error by the edge's angle", text);
        for &n in &self.settings.samples {
            self.steps.begin(format!("edges at {n} a pixel"));
            let realisations = self.settings.realisations;
            let polar = Polar::measure(&self.settings.subjects, n, realisations);
            let samples = if n == 1 { "sample" } else { "samples" };
            let alt = format!(
                "RMS error of the share that an edge covers, by {n} {samples} per pixel: a curve for each pattern, 180 angles, \
                256 positions of the edge at each."
            );
            let how = self.how(&format!("n = {n}"), realisations);
            self.page.plot(&format!("edges_{n}"), &alt, &how, &polar)?;
            self.steps.done();
        }
        Ok(())
    }

    fn portraits(&mut self) -> Drawn {
        let text = html! {
            p { "The power spectrum shows what becomes of a wave of each frequency; frequency 0 is in the middle. Dark: waves of \
                this frequency disappear in the mean over the samples, as they should. Bright: they come out as waves of other \
                frequencies (aliases). Random points have the power 1 (grey) everywhere. Bands are 95 % confidence intervals by \
                the jackknife. The dashed line is at √n, the frequency of a regular grid." }
            p { "Anisotropy is the variance of the power over all directions, divided by the squared mean power: at 0 dB, the \
                power varies as much as its mean. With m realisations, chance alone gives 1/m: −20 dB for 100. A peak above this \
                level is a preferred direction. The pair correlation is the number of pairs of points at a distance, divided by \
                that of random points: at 0, this distance never occurs. "
                "Projections on an axis are what an edge along the other axis sees: the best patterns have one point in each of \
                n intervals, and hardly any power at frequencies far below n." }
        };
        self.page
            .section("Spectra, distances and projections", text);
        let n = self.settings.points;
        for subject in &self.settings.subjects {
            self.steps.begin(format!("spectrum of {}", subject.title));
            let realisations = self.settings.realisations;
            let portrait = Portrait::measure(subject, n, realisations);
            let alt = format!(
                "Power spectrum, pair correlation and projections: {}.",
                subject.title
            );
            let how = self.how(&format!("n = {n}"), subject.realisations(n, realisations));
            let name = format!("spectrum_{}", subject.key);
            self.page.plot(&name, &alt, &how, &portrait)?;
            self.portraits.push(portrait);
            self.steps.done();
        }
        Ok(())
    }

    fn prefixes(&mut self) -> Drawn {
        let text = html! { p { "A renderer that stops early has only the first k samples of a pattern. Where a curve is below \
        the grey line, these are more even than random samples. A grid or a jittered pattern in rows is far above the line, \
        because its first samples are all at the top." } };
        self.page.section("The first samples", text);
        let n = self.settings.points;
        let plot = PrefixPlot::measure(&self.settings.subjects, n, FEW_TIMES);
        let alt = format!(
            "L₂ star discrepancy of the first k of {n} points, a curve for each pattern; grey: random points."
        );
        let how = self.how(&format!("n = {n}"), FEW_TIMES);
        self.page.plot("prefixes", &alt, &how, &plot)
    }

    fn pictures(&mut self) -> Drawn {
        let text = html! { p { "Pictures that alias: rings that become as fine as the pixels, a checkered plane that reaches to \
        the horizon, and edges at many angles. One pixel of the screen is one pixel of the picture, because scaling would \
        alias once more." } };
        self.page.section("Pictures", text);
        let film = Film {
            seed: 1,
            ..Film::new(self.settings.width, self.settings.width, 1)
        };
        let targets = TARGETS.map(|(name, target)| (name.replace(' ', "-"), name, target));
        for subject in &self.settings.subjects {
            self.steps.begin(format!("pictures of {}", subject.title));
            for &samples in &self.settings.samples {
                let film = Film { samples, ..film };
                let views = sheets::views(&film, subject, &TARGETS.map(|target| target.1));
                for ((key, ..), view) in targets.iter().zip(views) {
                    let name = format!("{key}_{}_{samples}", subject.key);
                    self.page.save(&name, view)?;
                }
            }
            self.steps.done();
        }
        let named = |s: &crate::lab::subject::Subject| (s.key.clone(), s.title.clone());
        let patterns: Vec<_> = self.settings.subjects.iter().map(named).collect();
        let tiles = |target| Tiles {
            target,
            patterns: &patterns,
            samples: &self.settings.samples,
            width: self.settings.width,
        };
        for (key, name, _) in &targets {
            let alt = format!("The {name}");
            let size = format!("{0} × {0} pixels", self.settings.width);
            let how = format!(
                "{size}, one of 256 realisations in each pixel, seed {}",
                self.settings.seeds
            );
            self.page.tiles(&alt, &how, &tiles(key));
        }
        let choices: Vec<_> = targets
            .iter()
            .map(|(key, name, _)| (key.as_str(), *name))
            .collect();
        self.page.flip(&choices, &tiles(&targets[0].0));
        Ok(())
    }

    fn table(&mut self) -> Drawn {
        let text = html! { p { "Each column sums up a pattern in one number." } };
        self.page.section("Numbers", text);
        let edges = &self.classes(PAIRS)[1];
        let samples = self.settings.samples.last().map_or(1, |n| *n);
        let n = self.settings.points;
        let mut rows = Vec::new();
        for (subject, portrait) in self.settings.subjects.iter().zip(&self.portraits) {
            self.steps.begin(format!("numbers of {}", subject.title));
            let pixels = (samples, &edges[..]);
            rows.push(Row::measure(
                subject,
                n,
                FEW_TIMES,
                &portrait.spectrum,
                pixels,
            ));
            self.steps.done();
        }
        let how = self.how(&format!("n = {n}"), FEW_TIMES);
        let how = format!(
            "{how}; spectra by {} realisations, pixel to pixel by {PAIRS} pairs at {samples} samples",
            self.settings.realisations
        );
        self.page.table("numbers", &how, &rows)
    }
}
