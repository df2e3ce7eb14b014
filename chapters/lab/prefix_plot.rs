//! How good the first k of n points are, as curves.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::Canvas;
use crate::kit::palette::INK;
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;
use crate::lab::legend;
use crate::lab::legend::power_of_ten;
use crate::lab::pens::pens;
use crate::lab::plot::Plot;
use crate::lab::prefixes::discrepancy;
use crate::lab::subject::Subject;
use plotters::prelude::Color;
use std::fmt::Write;

/// Width of the plot, in pixels of the canvas.
const PLOT: i32 = 850;

/// A curve for each pattern.
#[derive(Debug)]
pub struct PrefixPlot {
    n: usize,
    curves: Vec<Curve>,
}

/// A pattern's word, its name, its pen, and the discrepancy by the number of points.
type Curve = (String, String, Pen, Vec<(usize, f64)>);

impl PrefixPlot {
    /// Measures the patterns of n points.
    pub fn measure(subjects: &[Subject], n: usize, realisations: u64) -> Self {
        let curve = |(subject, pen): (&Subject, Pen)| {
            let by_count = discrepancy(subject, n, realisations);
            (subject.key.clone(), subject.title.clone(), pen, by_count)
        };
        let curves = subjects.iter().zip(pens(subjects)).map(curve).collect();
        Self { n, curves }
    }
}

/// The discrepancy of k independent random points.
fn by_chance(k: f64) -> f64 {
    (5.0 / (36.0 * k)).sqrt()
}

impl Plot for PrefixPlot {
    fn size(&self) -> (u32, u32) {
        (670, 490)
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        let all = || self.curves.iter().flat_map(|curve| &curve.3);
        let least = all().map(|p| p.1).fold(f64::INFINITY, f64::min).max(1e-6);
        let most = all().map(|p| p.1).fold(least, f64::max);
        let right = self.n.max(4) as f64;
        let samples = Axis::log2(2.0..right).named("the first k points").labels(7);
        let values = Axis::log((0.7 * least)..(1.3 * most))
            .named("L₂ star discrepancy")
            .format(power_of_ten);
        let title = format!("The first k of {} points", self.n);
        let mut chart = Chart::new(samples, values).titled(&title).text(30);
        let chance = Pen::plain(INK.mix(0.4).stroke_width(12));
        chart.curve([2.0, right].map(|k| (k, by_chance(k))), chance);
        for (_, _, pen, by_count) in &self.curves {
            chart.curve(by_count.iter().map(|(k, v)| (*k as f64, *v)), *pen);
        }
        let (plot, beside) = canvas.split_horizontally(PLOT);
        chart.draw(&plot)?;
        let entry = |curve: &Curve| (curve.2, curve.1.clone(), Vec::new());
        let mut entries: Vec<_> = self.curves.iter().map(entry).collect();
        entries.push((chance, "√(5/(36k)), random".to_owned(), Vec::new()));
        legend::draw(&beside, (10, 60), &[], &[], &entries)
    }

    fn csv(&self) -> String {
        let mut csv = "pattern,first_points,l2_star_discrepancy\n".to_owned();
        for (key, _, _, by_count) in &self.curves {
            for (k, v) in by_count {
                let _ = writeln!(csv, "{key},{k},{v}");
            }
        }
        csv
    }
}
