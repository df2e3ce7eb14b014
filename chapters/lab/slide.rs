//! Rotated grid, jittered and Poisson disk on one slide: where each wins and loses.

use crate::kit::figure::{CENTRE, LEFT, RIGHT, text, write};
use crate::kit::palette::{BLUE, FAINT, INK};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use crate::lab::errors::{EACH, errors};
use crate::lab::integrands::CLASSES;
use crate::lab::legend::number;
use crate::lab::pens::pens;
use crate::lab::pixels::correlation;
use crate::lab::plot::Plot;
use crate::lab::polar::{Curve, Polar};
use crate::lab::portrait;
use crate::lab::raster::Raster;
use crate::lab::settings::Settings;
use crate::lab::sheets;
use crate::lab::spectrum::Spectrum;
use crate::lab::subject::{Subject, known};
use crate::lab::targets;
use plotters::coord::Shift;
use plotters::prelude::{Circle, Color, DrawingArea, DrawingBackend, Rectangle};
use raybook::image::{Image, file};
use raybook::math::pcg;
use raybook::render::film::{Film, SILENT};
use raybook::store;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use std::thread;

/// What is compared.
const COMPARED: [&str; 3] = ["rotated-grid", "jittered", "poisson-disk"];

/// Points of the sets that are shown, and of the spectra.
const SHOWN: usize = 16;
const MANY: usize = 256;

/// Side of the picture of rings, and how many pixels of the canvas each of its pixels takes: one of the slide.
const CROP: usize = 350;
const TIMES: i32 = 2;

/// Columns for the patterns: the first one's left, their distance, and the sides of what is in them, in pixels of the canvas.
const FIRST: i32 = 60;
const STEP: i32 = 736;
const SMALL: i32 = 330;
const TOP: i32 = 240;
const RINGS: i32 = 660;

/// The table: its top, its lines, and the right end of its first column of numbers.
const TABLE: i32 = 1510;
const LINE: i32 = 54;
const NUMBERS: i32 = 1400;
const APART: i32 = 400;

/// The polar plots: their left, and the tops.
const POLAR: (i32, [i32; 2]) = (2250, [160, 1160]);

/// A measure that is better the smaller it is: its name, and a number for each pattern.
#[derive(Clone, Debug)]
pub struct Measure {
    /// What is measured.
    pub name: String,
    /// Digits behind the point.
    digits: usize,
    /// The patterns' numbers, in order.
    pub numbers: Vec<f64>,
}

impl Measure {
    /// The number of the pattern that is best; none if another one is about as good.
    pub fn winner(&self) -> Option<usize> {
        let [first, next, ..] = self.in_order()[..] else {
            return None;
        };
        (self.numbers[first] < ALIKE * self.numbers[next]).then_some(first)
    }

    /// The number of the pattern that is worst; none if another one is about as bad.
    pub fn loser(&self) -> Option<usize> {
        let [.., next, last] = self.in_order()[..] else {
            return None;
        };
        (self.numbers[next] < ALIKE * self.numbers[last]).then_some(last)
    }

    /// The patterns from the best to the worst.
    fn in_order(&self) -> Vec<usize> {
        let mut order: Vec<_> = (0..self.numbers.len()).collect();
        order.sort_by(|i, j| self.numbers[*i].total_cmp(&self.numbers[*j]));
        order
    }
}

/// A number that is at least this share of another is about as large.
const ALIKE: f64 = 0.97;

/// What is on the slide.
#[derive(Debug)]
pub struct Slide {
    subjects: Vec<Subject>,
    pens: Vec<Pen>,
    rings: Vec<Image>,
    spectra: Vec<Spectrum>,
    polars: [Polar; 2],
    /// The lines of the table.
    pub measures: Vec<Measure>,
    how: String,
}

/// Measures and writes the slide, and returns the path of its SVG file.
///
/// # Errors
/// If it cannot be drawn or written.
pub fn make(settings: &Settings) -> Result<PathBuf, Box<dyn Error>> {
    let slide = Slide::measure(settings);
    let name = |extension: &str| settings.folder.join("slide").with_extension(extension);
    file::save(&name("png"), &slide.large_image()?)?;
    store::write(&name("csv"), slide.csv().as_bytes())?;
    store::write(&name("svg"), slide.svg()?.as_bytes())?;
    Ok(name("svg"))
}

impl Slide {
    /// Measures everything.
    pub fn measure(settings: &Settings) -> Self {
        let found = COMPARED
            .iter()
            .filter_map(|name| known().find(|p| p.name == *name));
        let subjects: Vec<_> = found
            .map(|p| Subject::of(p).by_seed(settings.seed, false))
            .collect();
        let realisations = settings.realisations;
        let film = Film {
            width: CROP,
            height: CROP,
            samples: 4,
            seed: settings.seed,
            threads: thread::available_parallelism().map_or(1, std::num::NonZeroUsize::get),
            progress: SILENT,
        };
        let rings = subjects
            .iter()
            .map(|s| sheets::view(&film, s, targets::zone_plate));
        let limit = 2 * MANY.isqrt();
        let spectra = subjects
            .iter()
            .map(|s| Spectrum::of(s, MANY, limit, realisations));
        let spectra: Vec<_> = spectra.collect();
        let polars = [4, 16].map(|n| Polar::measure(&subjects, n, realisations));
        let measures = measures(&subjects, &polars, &spectra, settings);
        Self {
            pens: pens(&subjects),
            rings: rings.collect(),
            spectra,
            polars,
            measures,
            how: format!(
                "{realisations} realisations, {} functions of each class, seed {}. {}",
                EACH as u64 * realisations,
                settings.seed,
                settings.command
            ),
            subjects,
        }
    }

    /// How often a pattern is the best in the table, and how often the worst.
    fn wins(&self, pattern: usize) -> String {
        let won = self.measures.iter().filter(|m| m.winner() == Some(pattern));
        let lost = self.measures.iter().filter(|m| m.loser() == Some(pattern));
        format!("{} / {}", won.count(), lost.count())
    }

    fn table<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let column = |i: usize| NUMBERS + APART * i as i32;
        let size = 38;
        for (i, subject) in self.subjects.iter().enumerate() {
            write(
                canvas,
                &subject.title,
                (column(i), TABLE),
                text(size).pos(RIGHT),
            )?;
        }
        write(
            canvas,
            "smaller is better; the best is marked",
            (FIRST, TABLE),
            text(size).pos(LEFT),
        )?;
        for (line, measure) in (1..).zip(&self.measures) {
            let y = TABLE + line * LINE;
            write(canvas, &measure.name, (FIRST, y), text(size).pos(LEFT))?;
            for (i, v) in measure.numbers.iter().enumerate() {
                if measure.winner() == Some(i) {
                    let corners = [(column(i) - 200, y - 25), (column(i) + 16, y + 27)];
                    canvas.draw(&Rectangle::new(corners, BLUE.mix(0.2).filled()))?;
                    write(canvas, "●", (column(i) - 180, y), text(28).pos(LEFT))?;
                }
                let v = number(*v, measure.digits);
                write(canvas, &v, (column(i), y), text(size).pos(RIGHT))?;
            }
        }
        let last = TABLE + LINE * (self.measures.len() as i32 + 1);
        let name = "how often the best / the worst";
        write(canvas, name, (FIRST, last), text(size).pos(LEFT))?;
        for i in 0..self.subjects.len() {
            let at = (column(i), last);
            write(canvas, &self.wins(i), at, text(size).pos(RIGHT))?;
        }
        write(canvas, &self.how, (FIRST, 2125), text(28).pos(LEFT))
    }
}

/// The lines of the table.
fn measures(
    subjects: &[Subject],
    [four, sixteen]: &[Polar; 2],
    spectra: &[Spectrum],
    settings: &Settings,
) -> Vec<Measure> {
    let draws = settings.realisations as usize;
    let class =
        |i: usize| CLASSES[i].members(EACH * draws, &mut pcg::stream(settings.seed, i as u64));
    let [disc, edge, smooth] = [0, 1, 2].map(class);
    let medians = |n, functions: &Vec<_>| {
        let classes = std::slice::from_ref(functions);
        let median = |s: &Subject| 1e3 * errors(s, n, classes, draws)[0].median;
        subjects.iter().map(median).collect()
    };
    let polar = |polar: &Polar, of: fn(&Curve) -> f64| {
        polar.curves.iter().map(|curve| 1e3 * of(curve)).collect()
    };
    let line = |name: &str, digits, numbers| Measure {
        name: name.to_owned(),
        digits,
        numbers,
    };
    vec![
        line(
            "edges, 4 samples, all angles: error in ‰",
            0,
            polar(four, Curve::mean),
        ),
        line(
            "edges, 4 samples, along the axes: ‰",
            0,
            polar(four, Curve::along_axes),
        ),
        line(
            "edges, 16 samples, all angles: ‰",
            1,
            polar(sixteen, Curve::mean),
        ),
        line(
            "edges, 16 samples, worst angle: ‰",
            1,
            polar(sixteen, Curve::worst),
        ),
        line(
            "discs, 256 samples: median error in ‰",
            2,
            medians(MANY, &disc),
        ),
        line(
            "smooth functions, 256 samples: ‰",
            3,
            medians(MANY, &smooth),
        ),
        line(
            "coarse noise: mean power below the Nyquist frequency",
            2,
            spectra.iter().map(coarse).collect(),
        ),
        line(
            "highest alias: power of one frequency",
            1,
            spectra.iter().map(highest).collect(),
        ),
        line(
            "same error in neighbouring pixels: ρ, 16 samples",
            2,
            subjects
                .iter()
                .map(|s| correlation(s, 16, &edge).abs())
                .collect(),
        ),
    ]
}

/// The mean power below √n/2, the Nyquist frequency of a regular grid.
fn coarse(spectrum: &Spectrum) -> f64 {
    let radial = spectrum.radial();
    let below = &radial[..MANY.isqrt() / 2];
    let (power, area) = below.iter().fold((0.0, 0.0), |(power, area), k| {
        (power + k.frequency * k.value, area + k.frequency)
    });
    power / area
}

/// The highest power of a spectrum, but for frequency 0.
fn highest(spectrum: &Spectrum) -> f64 {
    let limit = spectrum.limit as i32;
    let all = (-limit..=limit).flat_map(|y| (-limit..=limit).map(move |x| (x, y)));
    let powers = all.filter(|f| *f != (0, 0)).map(|(x, y)| spectrum.at(x, y));
    powers.fold(0.0, f64::max)
}

impl Plot for Slide {
    fn size(&self) -> (u32, u32) {
        (1920, 1080)
    }

    fn draw<B: DrawingBackend>(&self, canvas: &DrawingArea<B, Shift>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let title =
            "Rotated grid, jittered, Poisson disk: which pattern for the samples of a pixel?";
        write(canvas, title, (1920, 76), text(66).pos(CENTRE))?;
        for (i, subject) in self.subjects.iter().enumerate() {
            let left = FIRST + STEP * i as i32;
            let pen = self.pens[i];
            pen.line(canvas, &[(left, 180), (left + 80, 180)])?;
            pen.mark(canvas, (left + 40, 180))?;
            write(
                canvas,
                &subject.title,
                (left + 100, 180),
                text(52).pos(LEFT),
            )?;
            let frame = [(left, TOP), (left + SMALL, TOP + SMALL)];
            canvas.draw(&Rectangle::new(frame, FAINT.stroke_width(3)))?;
            for p in subject.points(SHOWN, 1) {
                let on_canvas = p * SMALL as f32;
                let at = (left + on_canvas.x as i32, TOP + on_canvas.y as i32);
                canvas.draw(&Circle::new(at, 11, INK.filled()))?;
            }
            let below = TOP + SMALL + 34;
            write(
                canvas,
                "16 points",
                (left + SMALL / 2, below),
                text(34).pos(CENTRE),
            )?;
            let right = left + SMALL + 40 + SMALL / 2;
            write(
                canvas,
                "power of 256 points",
                (right, below),
                text(34).pos(CENTRE),
            )?;
            let under = (left + 350, RINGS + TIMES * CROP as i32 + 36);
            write(
                canvas,
                "rings, 4 samples a pixel",
                under,
                text(34).pos(CENTRE),
            )?;
        }
        for (polar, top) in self.polars.iter().zip(POLAR.1) {
            let (width, height) = polar.size();
            let (right, bottom) = (POLAR.0 + 2 * width as i32, top + 2 * height as i32);
            polar.draw(
                &canvas
                    .clone()
                    .shrink((POLAR.0, top), (right - POLAR.0, bottom - top)),
            )?;
        }
        self.table(canvas)
    }

    fn rasters(&self) -> Vec<Raster> {
        let column = |i: usize| FIRST + STEP * i as i32;
        let side = TIMES * CROP as i32;
        let rings = self.rings.iter().enumerate().map(|(i, picture)| Raster {
            picture: picture.clone(),
            at: (column(i), RINGS),
            size: (side, side),
        });
        let spectra = self.spectra.iter().enumerate().map(|(i, spectrum)| Raster {
            picture: portrait::picture(spectrum),
            at: (column(i) + SMALL + 40, TOP),
            size: (SMALL, SMALL),
        });
        rings.chain(spectra).collect()
    }

    fn csv(&self) -> String {
        let keys: Vec<_> = self.subjects.iter().map(|s| s.key.as_str()).collect();
        let mut csv = format!("measure,{}\n", keys.join(","));
        for Measure { name, numbers, .. } in &self.measures {
            let numbers: Vec<_> = numbers.iter().map(f64::to_string).collect();
            let _ = writeln!(csv, "\"{name}\",{}", numbers.join(","));
        }
        csv
    }
}

#[cfg(test)]
mod tests {
    use super::Measure;

    #[test]
    fn who_is_hardly_better_does_not_win() {
        let measure = |numbers: &[f64]| Measure {
            name: "error".to_owned(),
            digits: 0,
            numbers: numbers.to_vec(),
        };
        assert_eq!(measure(&[3.0, 1.0, 2.0]).winner(), Some(1), "the smallest");
        assert_eq!(measure(&[2.0, 1.99, 3.0]).winner(), None, "half a per cent");
    }
}
