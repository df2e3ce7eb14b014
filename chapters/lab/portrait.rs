//! A portrait of a pattern: its spectrum, its pair correlation and its projections.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::{CENTRE, Canvas, LEFT, RIGHT, text, write};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use crate::lab::pair_correlation::pair_correlation;
use crate::lab::plot::Plot;
use crate::lab::projection::{Onto, histogram};
use crate::lab::raster::Raster;
use crate::lab::spectrum::{Known, Spectrum};
use crate::lab::subject::Subject;
use plotters::prelude::{Color, PathElement, RGBColor};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use std::fmt::Write;

/// The picture of the spectrum: its side, its left and its top, in pixels of the canvas.
const SIDE: i32 = 420;
const LEFT_OF_IT: i32 = 110;
const ABOVE_IT: i32 = 80;

/// Colour bar: how far to the right of the picture, and how wide.
const BAR: (i32, i32) = (26, 30);

/// The power that is white, where random points have 1.
const WHITE_POWER: f64 = 2.0;

/// The colours of the bars of x and of y.
const BARS: [RGBColor; 2] = [BLUE, ORANGE];

/// More points than this in one interval are counted as this number.
const CROWDED: usize = 5;

/// What is measured of one pattern.
#[derive(Debug)]
pub struct Portrait {
    title: String,
    n: usize,
    /// The power spectrum.
    pub spectrum: Spectrum,
    /// The pair correlation, by distance in units of 1/√n.
    pairs: Vec<(f64, f64)>,
    /// Of the intervals of x and of y, the shares that hold 0, 1, 2 … points.
    intervals: [Vec<f64>; 2],
}

impl Portrait {
    /// Measures n points of a pattern.
    pub fn measure(subject: &Subject, n: usize, realisations: u64) -> Self {
        let limit = (2.0 * (n as f64).sqrt()) as usize;
        let shares = |onto: Onto| {
            let count = subject.realisations(n, realisations).max(1);
            let mut shares = vec![0.0; CROWDED + 1];
            for k in 0..count {
                for points in histogram(&subject.points(n, k), onto) {
                    shares[points.min(CROWDED)] += 1.0 / (count as f64 * n as f64);
                }
            }
            shares
        };
        Self {
            title: subject.title.clone(),
            n,
            spectrum: Spectrum::of(subject, n, limit.clamp(4, 40), realisations),
            pairs: pair_correlation(subject, n, realisations),
            intervals: [Onto::X, Onto::Y].map(shares),
        }
    }

    /// A chart over the frequency.
    fn over_frequency(&self, title: &str, values: &str, [low, high]: [f64; 2]) -> Chart {
        let right = self.spectrum.limit as f64;
        let whole = |v: f64| format!("{v:.0}").replace('-', "−");
        let frequencies = Axis::linear(0.0..right)
            .named("frequency, waves across the square")
            .labels(6)
            .format(whole);
        let values = Axis::linear(low..high)
            .named(values)
            .labels(6)
            .format(whole);
        let mut chart = Chart::new(frequencies, values).titled(title).text(30);
        let root = (self.n as f64).sqrt();
        if root < right {
            chart.dashes([(root, low), (root, high)], FAINT.stroke_width(4));
        }
        chart
    }

    fn radial(&self) -> Chart {
        const MOST: f64 = 3.0;
        let mut chart = self.over_frequency("mean power by frequency", "power", [0.0, MOST]);
        let radial = self.spectrum.radial();
        let ends = |sign: f64| {
            move |k: &Known| (k.frequency, (k.value + sign * k.within).clamp(0.0, MOST))
        };
        let band = radial
            .iter()
            .map(ends(1.0))
            .chain(radial.iter().rev().map(ends(-1.0)));
        chart
            .area(band, BLUE.mix(0.3))
            .line(
                [(0.0, 1.0), (self.spectrum.limit as f64, 1.0)],
                FAINT.stroke_width(4),
            )
            .line(radial.iter().map(ends(0.0)), BLUE.stroke_width(5));
        chart
    }

    fn anisotropy(&self) -> Chart {
        let decibels = |a: f64| (10.0 * a.max(1e-3).log10()).clamp(-30.0, 20.0);
        let mut chart = self.over_frequency("anisotropy", "dB", [-30.0, 20.0]);
        let known = self.spectrum.anisotropy();
        let ends = |sign: f64| move |k: &Known| (k.frequency, decibels(k.value + sign * k.within));
        let band = known
            .iter()
            .map(ends(1.0))
            .chain(known.iter().rev().map(ends(-1.0)));
        chart
            .area(band, BLUE.mix(0.3))
            .line(
                [(0.0, 0.0), (self.spectrum.limit as f64, 0.0)],
                FAINT.stroke_width(4),
            )
            .line(known.iter().map(ends(0.0)), BLUE.stroke_width(5));
        chart
    }

    fn pair_correlation(&self) -> Chart {
        const MOST: f64 = 3.0;
        let right = self.pairs.last().map_or(1.0, |p| p.0);
        let distances = Axis::linear(0.0..right)
            .named("distance, in units of 1/√n")
            .labels(6);
        let values = Axis::linear(0.0..MOST)
            .named("pairs, of those at random")
            .labels(6);
        let mut chart = Chart::new(distances, values)
            .titled("pair correlation")
            .text(30);
        let cut = self.pairs.iter().map(|(r, g)| (*r, g.min(MOST)));
        chart
            .line([(0.0, 1.0), (right, 1.0)], FAINT.stroke_width(4))
            .line(cut, BLUE.stroke_width(5));
        chart
    }

    /// The power of the points' projections on the axes: the spectrum along its own axes.
    fn projected(&self) -> Chart {
        const MOST: f64 = 3.0;
        let mut chart = self.over_frequency("power on x ——, on y – – –", "power", [0.0, MOST]);
        let along = |of: &dyn Fn(i32) -> f64| -> Vec<_> {
            let frequencies = 1..=self.spectrum.limit as i32;
            frequencies
                .map(|f| (f64::from(f), of(f).min(MOST)))
                .collect()
        };
        let dashed = Pen {
            dash: &[16.0, 12.0],
            ..Pen::plain(VERMILION.stroke_width(5))
        };
        chart
            .line(
                [(0.0, 1.0), (self.spectrum.limit as f64, 1.0)],
                FAINT.stroke_width(4),
            )
            .line(along(&|f| self.spectrum.at(f, 0)), BLUE.stroke_width(5))
            .curve(along(&|f| self.spectrum.at(0, f)), dashed);
        chart
    }

    /// How many intervals of each axis hold 0, 1, 2 … points.
    fn strata(&self) -> Chart {
        let title = format!("points per interval, of {}", self.n);
        let counts = Axis::linear(-0.5..(CROWDED as f64 + 0.5))
            .named("points in an interval of x (dark) or y (light)")
            .format(|v| {
                let more = if v as usize == CROWDED { " +" } else { "" };
                format!("{v:.0}{more}")
            })
            .marks(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
        let shares = Axis::linear(0.0..1.0)
            .named("share of the intervals")
            .labels(6)
            .format(|share| format!("{:.0} %", 100.0 * share));
        let mut chart = Chart::new(counts, shares).titled(&title).text(30);
        // Dark and light: in grey print, too.
        let bars = [(BARS[0].filled(), -0.36), (BARS[1].filled(), 0.02)];
        for (shares, (style, left)) in self.intervals.iter().zip(bars) {
            for (count, share) in shares.iter().enumerate() {
                let left = count as f64 + left;
                chart.bar([(left, 0.0), (left + 0.34, *share)], style);
            }
        }
        chart
    }

    /// The axes of the picture, and the colour bar's numbers.
    fn frame(&self, canvas: &Canvas) -> Drawn {
        let title = format!("{}: power of {} points", self.title, self.n);
        write(
            canvas,
            &title,
            (LEFT_OF_IT + SIDE / 2, 44),
            text(32).pos(CENTRE),
        )?;
        let limit = self.spectrum.limit as f64;
        let root = (self.n as f64).sqrt().round();
        // For many points, only the lower frequencies are drawn.
        let shown = root.min(limit);
        for f in [-shown, 0.0, shown] {
            let along = (f64::from(SIDE) * (0.5 + f / (2.0 * limit + 1.0))) as i32;
            let name = format!("{f:.0}").replace('-', "−");
            let (x, below) = (LEFT_OF_IT + along, ABOVE_IT + SIDE);
            let y = ABOVE_IT + SIDE - along;
            for tick in [
                [(x, below), (x, below + 10)],
                [(LEFT_OF_IT - 10, y), (LEFT_OF_IT, y)],
            ] {
                canvas.draw(&PathElement::new(tick, INK.stroke_width(3)))?;
            }
            write(canvas, &name, (x, below + 30), text(30).pos(CENTRE))?;
            write(canvas, &name, (LEFT_OF_IT - 16, y), text(30).pos(RIGHT))?;
        }
        let under = (LEFT_OF_IT + SIDE / 2, ABOVE_IT + SIDE + 68);
        write(
            canvas,
            "waves across the square",
            under,
            text(30).pos(CENTRE),
        )?;
        let right = LEFT_OF_IT + SIDE + BAR.0 + BAR.1 + 10;
        for (power, name) in [(0.0, "0"), (0.5, "1"), (1.0, "≥ 2")] {
            let y = ABOVE_IT + (f64::from(SIDE) * (1.0 - power)) as i32;
            write(canvas, name, (right, y), text(30).pos(LEFT))?;
        }
        Ok(())
    }
}

/// The grey of a power: black for none, white for twice that of random points and more.
fn grey(power: f64) -> Rgb {
    Rgb::gray((power / WHITE_POWER).clamp(0.0, 1.0) as f32)
}

/// The spectrum as a picture, a pixel for each frequency; 0 is black, because its power, always n, says nothing.
pub fn picture(spectrum: &Spectrum) -> Image {
    let (limit, side) = (spectrum.limit as i32, 2 * spectrum.limit + 1);
    Image::from_fn(side, side, |x, y| {
        match (x as i32 - limit, limit - y as i32) {
            (0, 0) => Rgb::gray(0.0),
            (x, y) => grey(spectrum.at(x, y)),
        }
    })
}

impl Plot for Portrait {
    fn size(&self) -> (u32, u32) {
        (1160, 600)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        self.frame(canvas)?;
        let panels = canvas.split_evenly((2, 3));
        let charts = [
            (1, self.radial()),
            (2, self.anisotropy()),
            (3, self.pair_correlation()),
            (4, self.projected()),
            (5, self.strata()),
        ];
        for (panel, chart) in charts {
            chart.draw(&panels[panel])?;
        }
        Ok(())
    }

    fn rasters(&self) -> Vec<Raster> {
        let bar = Image::from_fn(1, 64, |_, y| grey(WHITE_POWER * (63 - y) as f64 / 63.0));
        vec![
            Raster {
                picture: picture(&self.spectrum),
                at: (LEFT_OF_IT, ABOVE_IT),
                size: (SIDE, SIDE),
            },
            Raster {
                picture: bar,
                at: (LEFT_OF_IT + SIDE + BAR.0, ABOVE_IT),
                size: (BAR.1, SIDE),
            },
        ]
    }

    fn csv(&self) -> String {
        let mut csv = "curve,x,value,within_95\n".to_owned();
        let curves = [
            ("mean_power", self.spectrum.radial()),
            ("anisotropy", self.spectrum.anisotropy()),
        ];
        for (name, curve) in curves {
            for Known {
                frequency,
                value,
                within,
            } in curve
            {
                let _ = writeln!(csv, "{name},{frequency},{value},{within}");
            }
        }
        for (r, g) in &self.pairs {
            let _ = writeln!(csv, "pair_correlation,{r},{g},");
        }
        for f in 1..=self.spectrum.limit as i32 {
            let _ = writeln!(csv, "power_on_x,{f},{},", self.spectrum.at(f, 0));
            let _ = writeln!(csv, "power_on_y,{f},{},", self.spectrum.at(0, f));
        }
        for (name, shares) in ["x", "y"].iter().zip(&self.intervals) {
            for (count, share) in shares.iter().enumerate() {
                let _ = writeln!(csv, "intervals_of_{name}_with_points,{count},{share},");
            }
        }
        csv
    }
}
