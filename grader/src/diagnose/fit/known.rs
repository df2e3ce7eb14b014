//! A number that is a quantity of the question.

use super::{Make, Maker, Pair, agree, sum};
use crate::diagnose::number::{is_known, named};
use crate::diagnose::scalars::{Scalars, vectors};
use crate::layout::each;

impl Maker<'_, '_> {
    /// A factor that is a quantity of the question, or a product of two.
    #[allow(clippy::too_many_lines)] // a list of ways
    pub(super) fn scaled(&mut self, known: &Scalars) {
        let mut ratios: Vec<(usize, f64)> = Vec::new();
        for pair in &self.pairs {
            let dot: f64 = pair.base.iter().zip(&pair.got).map(|(a, b)| a * b).sum();
            let square: f64 = pair.base.iter().map(|v| v * v).sum();
            let ratio = dot / square;
            let off = pair
                .base
                .iter()
                .zip(&pair.got)
                .map(|(b, g)| (g - ratio * b).abs());
            let size = pair.got.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            if square > 0.0
                && ratio.is_finite()
                && ratio != 0.0
                && off.fold(0.0, f64::max) <= 2e-3 * size
            {
                ratios.push((pair.item, ratio));
            }
        }
        if ratios.len() < 3 || 5 * ratios.len() < 3 * self.pairs.len() {
            return;
        }
        let same = |r: &(usize, f64)| (r.1 - ratios[0].1).abs() <= 2e-3 * ratios[0].1.abs();
        if ratios.iter().all(same) {
            return; // a constant
        }
        let mut found: Vec<(u32, String, Box<Make<'_>>)> = Vec::new();
        for (name, values) in &known.all {
            for (power, words) in [
                (1.0, "times {}"),
                (-1.0, "divided by {}"),
                (2.0, "times the square of {}"),
                (-2.0, "divided by the square of {}"),
                (0.5, "times the square root of {}"),
                (-0.5, "divided by the square root of {}"),
                (3.0, "times the cube of {}"),
                (-3.0, "divided by the cube of {}"),
                (4.0, "times the fourth power of {}"),
                (-4.0, "divided by the fourth power of {}"),
            ] {
                let factor = |i: usize| values[i].map(|v| v.powf(power));
                let rest = |&(i, ratio): &(usize, f64)| factor(i).map(|f| ratio / f);
                let rests: Option<Vec<_>> = ratios.iter().take(4).map(rest).collect();
                let Some(constant) = rests.and_then(|rests| agree(&rests)) else {
                    continue;
                };
                let times = if (constant - 1.0).abs() < 2e-3 {
                    String::new()
                } else {
                    format!("{} times ", named(constant))
                };
                let constant = if times.is_empty() { 1.0 } else { constant };
                let what = words.replace("{}", name);
                let rank = if times.is_empty() {
                    14
                } else if is_known(constant) {
                    16
                } else {
                    21
                } + u32::from(power.abs() != 1.0);
                let make = move |i: usize, v: &mut [f64]| {
                    if let Some(f) = values[i].map(|v| v.powf(power)) {
                        each(v, |v| *v *= constant * f);
                    }
                };
                found.push((
                    rank,
                    format!("returns {times}{} {what}", self.of),
                    Box::new(make),
                ));
            }
        }
        let few: Vec<_> = known.all.iter().take(40).collect();
        for (i, (one, ones)) in few.iter().enumerate() {
            for (other, others) in &few[i + 1..] {
                for (p, q, words) in [
                    (1, 1, "times {a} times {b}"),
                    (1, -1, "times {a} divided by {b}"),
                    (-1, 1, "times {b} divided by {a}"),
                    (-1, -1, "divided by {a} and by {b}"),
                ] {
                    let factor = |k: usize| Some(ones[k]?.powi(p) * others[k]?.powi(q));
                    let fits = |&(k, ratio): &(usize, f64)| {
                        factor(k).is_some_and(|f| (ratio - f).abs() <= 2e-3 * f.abs())
                    };
                    if !ratios.iter().take(5).all(fits) {
                        continue;
                    }
                    let what = words.replace("{a}", one).replace("{b}", other);
                    let make = move |k: usize, v: &mut [f64]| {
                        if let (Some(a), Some(b)) = (ones[k], others[k]) {
                            each(v, |v| *v *= a.powi(p) * b.powi(q));
                        }
                    };
                    found.push((18, format!("returns {} {what}", self.of), Box::new(make)));
                }
            }
        }
        for (rank, name, make) in found {
            self.try_one(rank, 1, name, "Write down the formula with units: which quantity is missing in yours, is there twice, or stands on the wrong side of the fraction line?", &*make);
        }
    }

    /// A quantity of the question that is added.
    pub(super) fn shifted(&mut self, known: &Scalars) {
        let hint = "Move everything by one metre, or double one quantity, and calculate by hand: which term is too much in yours, or missing?";
        let mut found: Vec<(String, Box<Make<'_>>)> = Vec::new();
        if self.axes().len() == 1 {
            for (name, values) in &known.all {
                let off = |pair: &Pair| Some((pair.got[0] - pair.base[0]) / values[pair.item]?);
                let offs: Option<Vec<_>> = self.pairs.iter().take(4).map(off).collect();
                let Some(factor) = offs.and_then(|offs| agree(&offs)).filter(|c| is_known(*c))
                else {
                    continue;
                };
                let make = move |i: usize, v: &mut [f64]| v[0] += factor * values[i].unwrap_or(0.0);
                found.push((sum(&self.of, factor, name), Box::new(make)));
            }
        } else {
            for (name, values) in vectors(self.evidence, self.base, self.part) {
                let off = |pair: &Pair| {
                    let v = values[pair.item]
                        .as_ref()
                        .filter(|v| v.len() == pair.base.len())?;
                    let square: f64 = v.iter().map(|v| v * v).sum();
                    let dot: f64 = v
                        .iter()
                        .zip(pair.got.iter().zip(&pair.base))
                        .map(|(v, (g, b))| v * (g - b))
                        .sum();
                    Some(dot / square)
                };
                let offs: Option<Vec<_>> = self.pairs.iter().take(4).map(off).collect();
                let Some(factor) = offs.and_then(|offs| agree(&offs)).filter(|c| is_known(*c))
                else {
                    continue;
                };
                let words = sum(&self.of, factor, &name);
                let make = move |i: usize, v: &mut [f64]| {
                    if let Some(more) = &values[i] {
                        v.iter_mut()
                            .zip(more)
                            .for_each(|(v, more)| *v += factor * more);
                    }
                };
                found.push((words, Box::new(make)));
            }
        }
        for (name, make) in found {
            self.try_one(17, 1, name, hint, &*make);
        }
    }

    /// A quantity of the question in the place of the answer.
    pub(super) fn echoed(&mut self, known: &Scalars) {
        let hint = "Is that what is asked for, or only one of its ingredients?";
        let mut found: Vec<(u32, String, Box<Make<'_>>)> = Vec::new();
        if self.axes().len() == 1 {
            for (name, values) in &known.all {
                for (power, words) in [
                    (1.0, "{}"),
                    (-1.0, "1 over {}"),
                    (2.0, "the square of {}"),
                    (0.5, "the square root of {}"),
                ] {
                    let factor = |pair: &Pair| Some(pair.got[0] / values[pair.item]?.powf(power));
                    let factors: Option<Vec<_>> = self.pairs.iter().take(4).map(factor).collect();
                    let Some(factor) = factors.and_then(|all| agree(&all)).filter(|c| is_known(*c))
                    else {
                        continue;
                    };
                    let times = if (factor - 1.0).abs() < 2e-3 {
                        String::new()
                    } else {
                        format!("{} times ", named(factor))
                    };
                    let rank = if times.is_empty() && power == 1.0 {
                        15
                    } else {
                        20
                    };
                    let make = move |i: usize, v: &mut [f64]| {
                        v[0] = factor * values[i].map_or(f64::NAN, |v| v.powf(power));
                    };
                    found.push((
                        rank,
                        format!(
                            "returns {times}{} instead of {}",
                            words.replace("{}", name),
                            self.of
                        ),
                        Box::new(make),
                    ));
                }
            }
        } else {
            for (name, values) in vectors(self.evidence, self.base, self.part) {
                for (k, axis) in self.axes().iter().enumerate() {
                    let values = values.clone();
                    let make = move |i: usize, v: &mut [f64]| {
                        if let Some(value) = values[i].as_ref().and_then(|value| value.get(k)) {
                            v[k] = *value;
                        }
                    };
                    let words = format!("returns {axis} of {name} for that of {}", self.of);
                    found.push((16, words, Box::new(make)));
                }
                for factor in [1.0, -1.0] {
                    let values = values.clone();
                    let sign = if factor < 0.0 { "−" } else { "" };
                    let make = move |i: usize, v: &mut [f64]| {
                        if let Some(value) =
                            values[i].as_ref().filter(|value| value.len() == v.len())
                        {
                            v.iter_mut()
                                .zip(value)
                                .for_each(|(v, value)| *v = factor * value);
                        }
                    };
                    found.push((
                        15,
                        if name == self.of && factor > 0.0 {
                            format!("returns {name} as it is in the question, unchanged")
                        } else {
                            format!("returns {sign}{name} instead of {}", self.of)
                        },
                        Box::new(make),
                    ));
                }
            }
        }
        for (rank, name, make) in found {
            self.try_one(rank, 0, name, hint, &*make);
        }
    }
}
