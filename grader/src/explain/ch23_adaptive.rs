//! Chapter 23: whether a pixel needs more samples, and how a budget is shared out.

use super::Explained;
use super::ch12_phong::parts;
use super::diagram::{Diagram, Ink};
use super::way::Way;
use glam::{DVec3, dvec2, dvec3};
use raybook_workbook::exercises::ch23_adaptive::{NeedsMore, SpendBudget};

impl Explained for NeedsMore {
    fn work(&self, way: &mut Way) -> u32 {
        let n = self.samples.len() as f64;
        if way.is_less("there are fewer than two samples", n, 2.0) {
            way.remark("There are fewer than two samples: one knows nothing of the others.");
            return way.number("more", "", 1.0) as u32;
        }
        let samples: Vec<DVec3> = self.samples.iter().map(|sample| parts(*sample)).collect();
        let asked = way.rounds("the samples, for the contrast", samples.len());
        let asked = || samples[asked.clone()].iter().copied();
        let min = asked().fold(DVec3::INFINITY, DVec3::min);
        let max = asked().fold(DVec3::ZERO, DVec3::max);
        let min = way.colour("min, of each channel", "W·m⁻²·sr⁻¹", min);
        let max = way.colour("max, of each channel", "W·m⁻²·sr⁻¹", max);
        let range = way.colour_part("max − min", max - min);
        let sum = way.colour_part("max + min", max + min);
        let contrast = range / sum;
        let contrast = DVec3::select(max.cmpgt(DVec3::ZERO), contrast, DVec3::ZERO);
        let contrast = way.colour("(max − min)/(max + min)", "", contrast);
        let limit = way.colour("its limit", "", parts(self.contrast));
        let weights = way.colour_part("the weights of R, G and B", dvec3(0.2126, 0.7152, 0.0722));
        let luminance = |sample: &DVec3| sample.dot(weights);
        let of_mean = way.rounds("the samples, for the mean of Y", samples.len());
        let mean = samples[of_mean].iter().map(luminance).sum::<f64>() / n;
        let mean = way.number("the mean of Y", "W·m⁻²·sr⁻¹", mean);
        let of_squares = way.rounds("the samples, for the squares", samples.len());
        let squares = samples[of_squares]
            .iter()
            .map(|sample| (luminance(sample) - mean).powi(2));
        let squares = way.part("Σ (Y − mean)²", squares.sum::<f64>());
        let less = way.part("n − 1", n - 1.0);
        let variance = squares / less;
        let variance = way.number("s² = Σ (Y − mean)²/(n − 1)", "(W·m⁻²·sr⁻¹)²", variance);
        let of_mean = way.part("s²/n", variance / n);
        let error = way.number(
            "s/√n, the standard error of the mean",
            "W·m⁻²·sr⁻¹",
            of_mean.sqrt(),
        );
        let above = contrast.cmpgt(limit);
        let above: [bool; 3] = above.into();
        let by_contrast = way.any("the contrast of a channel is above its limit", &above);
        let most = way.part("the error's limit", f64::from(self.error));
        let by_error = way.is_less("the error is above its limit", most, error);
        way.remark(match (by_contrast, by_error) {
            (true, _) => "The contrast of a channel is above its limit.",
            (false, true) => "No contrast is above its limit, but the error is above its own.",
            (false, false) => "Neither a contrast nor the error is above its limit.",
        });
        let more = way.any("one of the two is", &[by_contrast, by_error]);
        way.number("more", "", f64::from(u32::from(more))) as u32
    }
}

impl Explained for SpendBudget {
    fn work(&self, way: &mut Way) -> Vec<u32> {
        let least = way.part(
            "the least for each, 1 or more",
            f64::from(self.least.max(1)),
        );
        let least = least.max(0.0) as u32;
        let budget = way.part("the budget", f64::from(self.budget)).max(0.0) as u64;
        let sum: f64 = self.deviations.iter().map(|d| f64::from(*d)).sum();
        way.number("Σ σ", "", sum);
        way.remark("Without the least and without rounding, each pixel gets its share σ/Σ σ of the budget (Neyman 1934).");
        let mut counts = vec![least; self.deviations.len()];
        let spent = u64::from(least) * counts.len() as u64;
        let left = budget.saturating_sub(spent);
        let left = way.number("what is left after the least for each", "", left as f64);
        let left = left.clamp(0.0, f64::from(self.budget)) as u64;
        way.remark("Each of these samples goes where it takes off most of σ²/n, which is σ²/n − σ²/(n + 1) = σ²/(n (n + 1)).");
        let gain = |way: &mut Way, pixel: usize, n: u32| {
            way.silently(|way| {
                let deviation = way.part("σ", f64::from(self.deviations[pixel]));
                let square = way.part("σ²", deviation * deviation);
                let n = f64::from(n);
                let price = way.part("n (n + 1)", n * (n + 1.0));
                way.part("what a sample takes off", square / price)
            })
        };
        for _ in 0..left {
            let gains = counts.iter().enumerate().map(|(i, n)| gain(way, i, *n));
            let losses: Vec<_> = gains.map(|gain| -gain).collect();
            if losses.is_empty() {
                break;
            }
            counts[way.least("the pixel that gains most", &losses)] += 1;
        }
        for (i, (count, deviation)) in counts.iter().zip(&self.deviations).enumerate() {
            way.pair(
                format!("pixel {i}: its share of the budget, and its number of samples"),
                "",
                dvec2(
                    f64::from(*deviation) / sum.max(f64::MIN_POSITIVE) * f64::from(self.budget),
                    f64::from(*count),
                ),
            );
        }
        counts
    }

    fn draw(&self, right: &Vec<u32>, yours: Option<&Vec<u32>>) -> Option<Diagram> {
        let mut drawing = Diagram::new(
            "The pixels from left to right, and upwards the number of samples of each; the dashed line is the least",
        );
        drawing.stretched = true;
        let end = right.len() as f64;
        drawing.line(&[dvec2(-0.5, 0.0), dvec2(end - 0.5, 0.0)], Ink::Shape);
        let least = f64::from(self.least);
        drawing.line(&[dvec2(-0.5, least), dvec2(end - 0.5, least)], Ink::Guide);
        let highest = right.iter().copied().max().unwrap_or(1);
        for (i, count) in right.iter().enumerate() {
            let at = dvec2(i as f64, f64::from(*count));
            drawing.line(&[dvec2(at.x, 0.0), at], Ink::Right);
            drawing.point(at, Ink::Right);
            if right.len() <= 16 {
                drawing.label(at, dvec2(0.0, 0.9), format!("{count}"), Ink::Right);
                drawing.label(
                    dvec2(at.x, 0.0),
                    dvec2(0.0, -1.0),
                    format!("{i}"),
                    Ink::Shape,
                );
            }
        }
        for (i, count) in yours.into_iter().flatten().enumerate().take(right.len()) {
            // What is far too many would make all the rest a line.
            if *count <= highest.saturating_mul(3) {
                drawing.point(dvec2(i as f64, f64::from(*count)), Ink::Yours);
            }
        }
        Some(drawing)
    }
}
