//! Rotated grid, jittered and Poisson disk on one slide: where each wins and loses.

pub mod measure;
mod table;

use crate::kit::figure::{CENTRE, Canvas, Diagram, LEFT, text, write};
use crate::kit::palette::{FAINT, INK};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use crate::lab::errors::EACH;
use crate::lab::pens::pens;
use crate::lab::plot::Plot;
use crate::lab::polar::{Dial, Polar};
use crate::lab::portrait;
use crate::lab::raster::Raster;
use crate::lab::settings::Settings;
use crate::lab::sheets;
use crate::lab::spectrum::Spectrum;
use crate::lab::subject::{Subject, known};
use crate::lab::targets;
use measure::{Measure, measures};
use plotters::prelude::{Circle, Color, Rectangle};
use raybook::image::{Image, file};
use raybook::render::film::Film;
use raybook::store;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

/// What is compared.
const COMPARED: [&str; 3] = ["rotated-grid", "jittered", "poisson-disk"];

/// Points of the sets that are shown, and of the spectra.
const SHOWN: usize = 16;
const MANY: usize = 256;

/// Side of the picture of rings, in pixels, and pixels of the canvas per pixel of the picture, which make one pixel of the slide.
const CROP: usize = 350;
const TIMES: i32 = 2;

/// Columns for the patterns: the left of the first column, the distance of the columns, and places and sizes in a column, in
/// pixels of the canvas.
const FIRST: i32 = 60;
const STEP: i32 = 736;
const SMALL: i32 = 330;
const TOP: i32 = 240;
const RINGS: i32 = 660;

/// Size of the smallest letters, in pixels of the canvas: 12 pixels high on a projector of 720 lines.
const LETTERS: i32 = 45;

/// Samples per pixel of the polar plots, and where they are: one above the other, on the right.
const EDGES: [usize; 2] = [4, 16];
const DIALS: [Dial; 2] = [dial(660), dial(1650)];

const fn dial(middle: i32) -> Dial {
    Dial {
        centre: (3060, middle),
        radius: 380.0,
    }
}

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
    let Diagram { pixels, svg } = slide.large()?;
    file::save(&name("png"), &pixels)?;
    // As large as the projector's screen: the view box keeps its shape.
    let (width, height) = slide.size();
    let own = format!("width=\"{width}\" height=\"{height}\"");
    let svg = svg.replacen(&own, "width=\"100%\" height=\"100%\"", 1);
    store::write(&name("svg"), svg.as_bytes())?;
    store::write(&name("csv"), slide.csv().as_bytes())?;
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
            seed: settings.seed,
            ..Film::new(CROP, CROP, 4)
        };
        let rings = subjects
            .iter()
            .map(|s| sheets::view(&film, s, targets::zone_plate));
        let limit = 2 * MANY.isqrt();
        let spectra = subjects
            .iter()
            .map(|s| Spectrum::of(s, MANY, limit, realisations));
        let spectra: Vec<_> = spectra.collect();
        let polars = EDGES.map(|n| Polar::measure(&subjects, n, realisations));
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
}

impl Plot for Slide {
    fn size(&self) -> (u32, u32) {
        (1920, 1080)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
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
            let under_rings = RINGS + TIMES * CROP as i32 + 36;
            for (words, at) in [
                ("16 points", (left + SMALL / 2, below)),
                (
                    "power of 256 points",
                    (left + SMALL + 40 + SMALL / 2, below),
                ),
                ("rings, 4 samples a pixel", (left + 350, under_rings)),
            ] {
                write(canvas, words, at, text(LETTERS).pos(CENTRE))?;
            }
        }
        for ((polar, n), dial) in self.polars.iter().zip(EDGES).zip(DIALS) {
            let words = format!(
                "RMS error by the edge's angle, {n} samples, {}",
                polar.per_ring()
            );
            let above = dial.centre.1 - dial.radius as i32 - 106;
            let style = text(LETTERS).pos(CENTRE);
            write(canvas, &words, (dial.centre.0, above), style)?;
            polar.draw_on(canvas, dial)?;
        }
        let titles: Vec<_> = self.subjects.iter().map(|s| s.title.as_str()).collect();
        table::draw(canvas, &titles, &self.measures)?;
        write(canvas, &self.how, (FIRST, 2120), text(LETTERS).pos(LEFT))
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
