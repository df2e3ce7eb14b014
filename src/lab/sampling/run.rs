//! The sampling lab from the first plot to the page.

use crate::lab::sampling::error_plot::{Curve, ErrorPlot};
use crate::lab::sampling::page::Page;
use crate::lab::sampling::plot::Drawn;
use crate::lab::sampling::point_sets::PointSets;
use crate::lab::sampling::polar::Polar;
use crate::lab::sampling::spectrum::Spectrum;
use crate::lab::sampling::spectrum_plot::SpectrumPlot;
use crate::lab::sampling::steps::Steps;
use crate::lab::sampling::table::Row;
use crate::lab::sampling::targets::TARGETS;
use crate::lab::sampling::{integrands, sheets, title};
use crate::lab::sheet::sheet;
use crate::render::film::Film;
use crate::sample::pattern::Pattern;
use std::error::Error;
use std::path::PathBuf;
use std::thread;

/// What is to be measured, and where the page goes.
pub struct Settings {
    /// The patterns to compare.
    pub patterns: Vec<Pattern>,
    /// Points in the point sets, the spectra and the table.
    pub points: usize,
    /// Samples per pixel of the pictures and of the polar plots.
    pub samples: Vec<usize>,
    /// How often each random pattern is drawn.
    pub realisations: u64,
    /// Width of each of the pictures in pixels.
    pub width: usize,
    /// The folder for the page and its figures.
    pub folder: PathBuf,
}

/// Measures and draws everything, and returns the page's path.
///
/// # Errors
/// If a figure cannot be drawn or written.
pub fn run(settings: &Settings) -> Result<PathBuf, Box<dyn Error>> {
    let steps = 3 * settings.patterns.len() + settings.samples.len() + TARGETS.len();
    let mut lab = Lab {
        settings,
        page: Page::new(&settings.folder),
        steps: Steps::new(steps as u64),
    };
    lab.point_sets()?;
    lab.errors()?;
    lab.errors_by_angle()?;
    lab.spectra()?;
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
}

impl Lab<'_> {
    fn point_sets(&mut self) -> Drawn {
        self.page.section(
            "Points",
            "What each pattern looks like; thin lines are the cells that have a point each.",
        );
        let sets = |n| PointSets {
            patterns: self.settings.patterns.clone(),
            n,
            columns: 4,
        };
        for n in [16, self.settings.points] {
            let alt = format!("{n} points of each pattern.");
            self.page.plot(&format!("points_{n}"), &alt, &sets(n))?;
        }
        Ok(())
    }

    fn errors(&mut self) -> Drawn {
        self.page.section(
            "Error against samples",
            "The root of the mean squared error of the mean, with bands that hold it with a probability of 95 %; the numbers are the curves' slopes, and grey lines have the slopes written on them.",
        );
        let (functions, powers) = (integrands::all(), 1..=12);
        let mut plots = functions.map(|f| ErrorPlot {
            title: f.name.to_owned(),
            curves: Vec::new(),
        });
        for pattern in &self.settings.patterns {
            self.steps.begin(format!("error of {}", title(pattern)));
            let by_count: Vec<_> = powers
                .clone()
                .map(|p| {
                    integrands::errors(pattern, 1 << p, &functions, self.settings.realisations)
                })
                .collect();
            for (i, plot) in plots.iter_mut().enumerate() {
                plot.curves.push(Curve {
                    key: pattern.name,
                    title: title(pattern),
                    errors: by_count.iter().map(|errors| errors[i]).collect(),
                });
            }
            self.steps.done();
        }
        for plot in plots {
            let name = format!("error_{}", plot.title.replace(' ', "_"));
            let alt = format!("The error of the {}.", plot.title);
            self.page.plot(&name, &alt, &plot)?;
        }
        Ok(())
    }

    fn errors_by_angle(&mut self) -> Drawn {
        self.page.section(
            "Error by the edge's angle",
            "How far the covered area of a pixel is off, for all edges at an angle that pass through it. The regular grid is worst along the axes, where pictures have most of their edges; the rotated grid elsewhere.",
        );
        for &n in &self.settings.samples {
            self.steps.begin(format!("edges by {n} samples"));
            let polar = Polar::measure(&self.settings.patterns, n, self.settings.realisations);
            let alt = format!("The error at edges by {n} samples a pixel.");
            self.page.plot(&format!("edges_{n}"), &alt, &polar)?;
            self.steps.done();
        }
        Ok(())
    }

    fn spectra(&mut self) -> Drawn {
        self.page.section(
            "Power spectra",
            "Frequency 0 is in the middle; random points have the power 1 (grey) everywhere. Dark is a frequency whose waves disappear in the mean, bright one whose waves turn up as others. Beside it the mean over all directions, and how much the directions differ.",
        );
        let n = self.settings.points;
        for pattern in &self.settings.patterns {
            self.steps.begin(format!("spectrum of {}", title(pattern)));
            let limit = (2.0 * (n as f64).sqrt()) as usize;
            let plot = SpectrumPlot {
                title: format!("{}, {n} points", title(pattern)),
                spectrum: Spectrum::of(pattern, n, limit.clamp(4, 40), self.settings.realisations),
            };
            let alt = format!("The power spectrum of {}.", title(pattern));
            self.page
                .plot(&format!("spectrum_{}", pattern.name), &alt, &plot)?;
            self.steps.done();
        }
        Ok(())
    }

    fn pictures(&mut self) -> Drawn {
        self.page.section(
            "Pictures",
            "Pictures that alias: rings that become as fine as the pixels, a plane to the horizon, and edges at many angles.",
        );
        let film = Film {
            width: self.settings.width,
            height: self.settings.width,
            samples: 1,
            seed: 1,
            threads: thread::available_parallelism().map_or(1, std::num::NonZeroUsize::get),
            progress: &|_| {},
        };
        let samples = &self.settings.samples;
        for (name, target) in TARGETS {
            self.steps.begin(format!("pictures of a {name}"));
            let (columns, tiles) =
                sheets::targets_of(&film, &self.settings.patterns, samples, target);
            let alt = format!(
                "The {name}, a column for each pattern and a row for each number of samples."
            );
            let whole = sheet(columns, &sheets::named(&tiles))?;
            self.page.picture(&name.replace(' ', "_"), &alt, &whole)?;
            self.steps.done();
        }
        Ok(())
    }

    fn table(&mut self) -> Drawn {
        self.page.section("Numbers", "Discrepancies are the smaller, the more evenly the points fill boxes from the corner. Times are of this machine, while this page was made.");
        let mut rows = Vec::new();
        for pattern in &self.settings.patterns {
            self.steps.begin(format!("numbers of {}", title(pattern)));
            rows.push(Row::measure(pattern, self.settings.points, 20));
            self.steps.done();
        }
        self.page.table("numbers", &rows)
    }
}
