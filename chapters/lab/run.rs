//! The sampling lab from the first plot to the page.

use crate::kit::sheet::sheet;
use crate::kit::stage::Drawn;
use crate::lab::error_plot::{Curve, ErrorPlot};
use crate::lab::page::Page;
use crate::lab::plot::strokes;
use crate::lab::point_sets::PointSets;
use crate::lab::polar::Polar;
use crate::lab::settings::{FEW, Settings, counts};
use crate::lab::spectrum::Spectrum;
use crate::lab::spectrum_plot::SpectrumPlot;
use crate::lab::steps::Steps;
use crate::lab::table::Row;
use crate::lab::targets::TARGETS;
use crate::lab::{integrands, sheets};
use raybook::render::film::{Film, SILENT};
use std::error::Error;
use std::path::PathBuf;
use std::thread;

/// Measures and draws everything, and returns the page's path.
///
/// # Errors
/// If a figure cannot be drawn or written.
pub fn run(settings: &Settings) -> Result<PathBuf, Box<dyn Error>> {
    let steps = 3 * settings.subjects.len() + settings.samples.len() + TARGETS.len();
    let mut lab = Lab {
        settings,
        page: Page::new(&settings.folder, settings.remarks.clone()),
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
            subjects: &self.settings.subjects,
            n,
            columns: 4,
        };
        for n in [FEW, self.settings.points] {
            let alt = format!("{n} points of each pattern.");
            self.page.plot(&format!("points_{n}"), &alt, &sets(n))?;
        }
        Ok(())
    }

    fn errors(&mut self) -> Drawn {
        self.page.section(
            "Error against samples",
            "The root of the mean squared error of the mean, with bands that hold it with a probability of 95 %; the numbers are the curves' slopes, and grey lines have the slopes written on them. Over the unit square: a disc around a corner that covers half of it; an edge at a slant; a Gaussian; a checkerboard with two and a half squares along each side.",
        );
        let functions = integrands::all();
        let mut plots = functions.map(|f| ErrorPlot {
            title: f.name.to_owned(),
            curves: Vec::new(),
        });
        let subjects = &self.settings.subjects;
        for (subject, stroke) in subjects.iter().zip(strokes(subjects)) {
            self.steps.begin(format!("error of {}", subject.title()));
            let wanted = self.settings.realisations;
            let by_count: Vec<_> = counts()
                .filter(|&n| subject.realisations(n, wanted) > 0)
                .map(|n| integrands::errors(subject, n, &functions, wanted))
                .collect();
            for (i, plot) in plots.iter_mut().enumerate() {
                plot.curves.push(Curve {
                    key: subject.key(),
                    title: subject.title(),
                    stroke,
                    errors: by_count.iter().map(|errors| errors[i]).collect(),
                });
            }
            self.steps.done();
        }
        for plot in plots {
            let name = format!("error_{}", plot.title.replace(' ', "_"));
            let alt = format!("Error against samples: {}.", plot.title);
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
            self.steps.begin(format!("edges at {n} a pixel"));
            let polar = Polar::measure(&self.settings.subjects, n, self.settings.realisations);
            let samples = if n == 1 { "sample" } else { "samples" };
            let alt = format!("The error at edges by {n} {samples} a pixel.");
            self.page.plot(&format!("edges_{n}"), &alt, &polar)?;
            self.steps.done();
        }
        Ok(())
    }

    fn spectra(&mut self) -> Drawn {
        self.page.section(
            "Power spectra",
            "Frequency 0 is in the middle; random points have the power 1 (grey) everywhere. Dark is a frequency whose waves disappear in the mean, bright one whose waves turn up as others. Beside it the mean over all directions, and how much the directions differ: 0 dB is as much as the power itself, and less the more realisations there are; what sticks out above is a preferred direction.",
        );
        let n = self.settings.points;
        for subject in &self.settings.subjects {
            self.steps.begin(format!("spectrum of {}", subject.title()));
            let limit = (2.0 * (n as f64).sqrt()) as usize;
            let plot = SpectrumPlot {
                title: format!("{}, {n} points", subject.title()),
                spectrum: Spectrum::of(subject, n, limit.clamp(4, 40), self.settings.realisations),
            };
            let alt = format!("The power spectrum of {}.", subject.title());
            self.page
                .plot(&format!("spectrum_{}", subject.key()), &alt, &plot)?;
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
            progress: SILENT,
        };
        let samples = &self.settings.samples;
        for (name, target) in TARGETS {
            self.steps.begin(format!("pictures of a {name}"));
            let (columns, tiles) =
                sheets::targets_of(&film, &self.settings.subjects, samples, target);
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
        for subject in &self.settings.subjects {
            self.steps.begin(format!("numbers of {}", subject.title()));
            rows.push(Row::measure(subject, self.settings.points, 20));
            self.steps.done();
        }
        self.page.table("numbers", &rows)
    }
}
