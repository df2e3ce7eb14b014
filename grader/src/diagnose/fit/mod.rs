//! Explanations that every exercise gets for nothing: what a mistake makes of the right answer, with the number that fits.

pub mod factor;
mod known;
mod numbers;
mod orders;
mod undone;

use super::evidence::{Evidence, Scope};
use super::function::{COMMON, FUNCTIONS};
use super::number::named;
use super::scalars::scalars;
use crate::layout::{Leaf, each, layout};
use raybook_workbook::kind::Kind;
use std::f64::consts::{PI, TAU};
use std::ops::Range;
pub use undone::undone;

/// What each item's answer would be, if it can be said.
pub type Answers = Vec<Option<Vec<f64>>>;

/// A mistake, and what it answers.
pub struct Explanation {
    /// What a function with this mistake does, as a verb.
    pub name: String,
    /// A question that leads on.
    pub hint: String,
    /// How common it is: small numbers come first.
    pub rank: u32,
    /// How many numbers were fitted to the answers.
    pub fitted: u32,
    /// Its answers.
    pub answers: Answers,
}

/// A value of a wrong answer, and of what it is compared with.
struct Pair {
    item: usize,
    base: Vec<f64>,
    got: Vec<f64>,
}

/// What is made of a value: of which item, and its numbers.
type Make<'a> = dyn Fn(usize, &mut [f64]) + 'a;

/// The rank of functions that whole numbers may be mistaken by: powers, the reciprocal, and 1 minus the number.
const OF_WHOLE: u32 = 10;

/// Makes explanations of a part.
struct Maker<'a, 'e> {
    evidence: &'a Evidence<'e>,
    base: &'a Answers,
    part: usize,
    /// How the part is called in sentences.
    of: String,
    pairs: Vec<Pair>,
    all: Vec<Explanation>,
}

/// The explanations by functions, fitted numbers and other orders of the same components; `thoroughly` with what depends on the
/// question too.
pub fn explanations(evidence: &Evidence<'_>, base: &Answers, thoroughly: bool) -> Vec<Explanation> {
    let mut all = Vec::new();
    for part in scoped(evidence) {
        let mut maker = Maker::new(evidence, base, part, called(evidence, part));
        maker.pairs = pairs(evidence, base, part);
        if maker.pairs.is_empty() {
            continue;
        }
        maker.functions();
        maker.factor();
        maker.offset();
        maker.orders();
        maker.lengths();
        if thoroughly {
            maker.power();
            maker.affine();
            maker.cut();
            maker.digits();
            maker.components();
            let known = scalars(evidence, base, part);
            maker.scaled(&known);
            maker.shifted(&known);
            maker.echoed(&known);
        }
        all.append(&mut maker.all);
    }
    all
}

/// The parts that are looked at.
fn scoped(evidence: &Evidence<'_>) -> Range<usize> {
    match evidence.scope {
        Scope::Whole => 0..evidence.parts.len(),
        Scope::Part(part) => part..part + 1,
        Scope::Shape => 0..0,
    }
}

/// How a part is called in sentences.
fn called<'a>(evidence: &'a Evidence<'_>, part: usize) -> &'a str {
    match evidence.parts.as_slice() {
        [_] => "the answer",
        parts => &parts[part].name,
    }
}

/// The explanations by functions and other orders of the same components, whatever the answers are.
pub fn functions(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    for (part, of) in evidence.parts.iter().enumerate() {
        let mut maker = Maker::new(evidence, base, part, &of.name);
        maker.functions();
        maker.orders();
        all.append(&mut maker.all);
    }
    all
}

/// What leads on from a constant factor.
const CONSTANT: &str = "Write down the formula with units: which constant factor is missing, is there twice, or stands on the wrong side of the fraction line?";

/// Numbers by which answers are often too large, or 1 over them.
const FACTORS: [f64; 5] = [2.0, 4.0, PI, TAU, 4.0 * PI];

/// The factor by which estimates are too large, from those that are wrong: its middle value; none if it is nearly 1, or makes little or
/// much of everything.
fn rough_factor(pairs: &[Pair]) -> Option<f64> {
    /// Less is chance.
    const LEAST: f64 = 1.1;
    /// More is no wrong constant.
    const MOST: f64 = 100.0;
    let ratio = |pair: &Pair| pair.got.iter().sum::<f64>() / pair.base.iter().sum::<f64>();
    let mut ratios: Vec<_> = pairs.iter().map(ratio).collect();
    ratios.retain(|ratio| ratio.is_finite() && *ratio > 0.0);
    ratios.sort_by(f64::total_cmp);
    // Rounded to what can be known of it: two digits.
    let middle = *ratios.get(ratios.len() / 2)?;
    let digit = 10_f64.powf(middle.log10().floor() - 1.0);
    let middle = (middle / digit).round() * digit;
    let size = middle.max(1.0 / middle);
    (LEAST..MOST).contains(&size).then_some(middle)
}

/// The explanations by a factor, whatever the answers are: estimates scatter, so that only the known ones are sharp.
pub fn factors(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    for (part, of) in evidence.parts.iter().enumerate() {
        let mut maker = Maker::new(evidence, base, part, &of.name);
        if maker.is_whole() {
            continue;
        }
        for factor in FACTORS.iter().flat_map(|factor| [*factor, 1.0 / factor]) {
            let name = format!("returns {} times {}", named(factor), of.name);
            let make = |_: usize, v: &mut [f64]| each(v, |v| *v *= factor);
            maker.add(9, 0, name, CONSTANT, &make);
        }
        if let Some(factor) = rough_factor(&pairs(evidence, base, part)) {
            let name = format!("returns about {} times {}", named(factor), of.name);
            let make = |_: usize, v: &mut [f64]| each(v, |v| *v *= factor);
            maker.add(12, 1, name, CONSTANT, &make);
        }
        all.append(&mut maker.all);
    }
    all
}

/// The values of a part in the wrong answers, beside those of the base.
fn pairs(evidence: &Evidence<'_>, base: &Answers, part: usize) -> Vec<Pair> {
    let kind = evidence.examiner.asked().answer.kind;
    let mut pairs = Vec::new();
    for (i, item) in evidence.items.iter().enumerate().take(evidence.wrong) {
        let Some(base) = &base[i] else { continue };
        let (ours, theirs) = (layout(kind, base), layout(kind, &item.got));
        if ours.leaves != theirs.leaves {
            continue;
        }
        let of = |leaf: &Leaf| Pair {
            item: i,
            base: base[leaf.range()].to_vec(),
            got: item.got[leaf.range()].to_vec(),
        };
        // A long list tells no more than its beginning.
        pairs.extend(ours.of_part(part).take(40).map(of));
    }
    pairs
}

/// The number that most of these are, up to rounding.
fn common(numbers: &[f64]) -> Option<f64> {
    let mut sorted: Vec<_> = numbers.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let middle = *sorted.get(sorted.len() / 2)?;
    let close = |v: &&f64| (**v - middle).abs() <= 3e-3 * middle.abs().max(1e-6);
    let many = sorted.iter().filter(close).count();
    (5 * many >= 3 * numbers.len()).then_some(middle)
}

impl<'a, 'e> Maker<'a, 'e> {
    /// Nothing is made yet, and there are no pairs to fit.
    fn new(evidence: &'a Evidence<'e>, base: &'a Answers, part: usize, of: &str) -> Self {
        Self {
            evidence,
            base,
            part,
            of: of.to_owned(),
            pairs: Vec::new(),
            all: Vec::new(),
        }
    }
}

impl Maker<'_, '_> {
    fn is_whole(&self) -> bool {
        matches!(self.evidence.parts[self.part].kind, Kind::Whole)
    }

    /// Whether it is a vector in space or on a plane, and not a colour or an interval.
    fn is_vector(&self) -> bool {
        match self.evidence.parts[self.part].kind {
            Kind::Direction => true,
            Kind::Numbers(parts) => parts.name.starts_with("Vec"),
            _ => false,
        }
    }

    fn axes(&self) -> &'static [&'static str] {
        match self.evidence.parts[self.part].kind {
            Kind::Numbers(parts) => parts.parts,
            Kind::Direction => &["x", "y", "z"],
            _ => &[""],
        }
    }

    fn add(&mut self, rank: u32, fitted: u32, name: String, hint: &str, make: &Make<'_>) {
        let kind = self.evidence.examiner.asked().answer.kind;
        let of = |(item, base): (usize, &Option<Vec<f64>>)| {
            let base = base.as_ref()?;
            let mut made = base.clone();
            for leaf in layout(kind, base).of_part(self.part) {
                make(item, &mut made[leaf.range()]);
            }
            if self.is_whole() {
                for leaf in layout(kind, base).of_part(self.part) {
                    made[leaf.range()].iter_mut().for_each(|v| *v = v.max(0.0));
                }
            }
            Some(made)
        };
        let answers = self.base.iter().enumerate().map(of).collect();
        let (hint, name) = (hint.to_owned(), name);
        self.all.push(Explanation {
            name,
            hint,
            rank,
            fitted,
            answers,
        });
    }

    /// Whether a function of the base gives most of the first wrong values: only then all are tried.
    fn promises(&self, make: &Make<'_>) -> bool {
        let tried = self.pairs.iter().take(5);
        let (mut right, mut all) = (0, 0);
        for pair in tried {
            let mut made = pair.base.clone();
            make(pair.item, &mut made);
            let near = |(a, b): (&f64, &f64)| {
                a == b
                    || (a - b).is_finite() && (a - b).abs() <= 1e-5 + 5e-3 * a.abs().max(b.abs())
                    || a.is_nan() && b.is_nan()
            };
            right += usize::from(made.iter().zip(&pair.got).all(near));
            all += 1;
        }
        2 * right >= all
    }

    /// How many different numbers the right values hold, without those that many functions leave as they are or exchange; of whole
    /// numbers, these too.
    fn different(&self) -> usize {
        self.different_of(|v| v)
    }

    /// How many different numbers a function makes of them.
    fn different_of(&self, of: fn(f64) -> f64) -> usize {
        let numbers = self.pairs.iter().flat_map(|pair| &pair.base);
        let tells = |v: &&f64| self.is_whole() || ![0.0, 1.0, -1.0].contains(*v);
        let mut numbers: Vec<_> = numbers.filter(tells).map(|v| of(*v)).collect();
        numbers.sort_by(f64::total_cmp);
        numbers.dedup();
        numbers.len()
    }

    fn try_one(&mut self, rank: u32, fitted: u32, name: String, hint: &str, make: &Make<'_>) {
        if self.promises(make) {
            self.add(rank, fitted, name, hint, make);
        }
    }

    /// The functions that may explain the answers. A rare function is only tried if the answers differ much, and on whole numbers if
    /// they differ still more: else it may hit them by chance.
    fn functions(&mut self) {
        let different = self.different();
        // Of NaN nobody can tell which function made it.
        let mut got = self.pairs.iter().flat_map(|pair| &pair.got);
        if !self.pairs.is_empty() && got.all(|v| v.is_nan()) {
            return;
        }
        for function in FUNCTIONS {
            let is_constant = function.is_constant();
            if self.is_whole() && !is_constant && function.rank != OF_WHOLE {
                continue;
            }
            let needed = match (is_constant, self.is_whole()) {
                (true, _) => 1,
                (_, true) => 3,
                _ => 1 + usize::from(function.rank > COMMON),
            };
            // There are no pairs of estimates, which scatter.
            if !self.pairs.is_empty() && different < needed {
                continue;
            }
            // One number for all of them is no rare function of theirs: the sign of distances is 1.
            let is_rare = function.rank > COMMON && !is_constant;
            if is_rare && different > 1 && self.different_of(function.of) < 2 {
                continue;
            }
            let name = function.name.replace("the answer", &self.of);
            let make = |_: usize, v: &mut [f64]| each(v, |v| *v = (function.of)(*v));
            self.try_one(function.rank, 0, name, function.hint, &make);
        }
    }
}

fn sum(of: &str, factor: f64, name: &str) -> String {
    let times = if (factor.abs() - 1.0).abs() < 2e-3 {
        String::new()
    } else {
        format!("{} times ", named(factor.abs()))
    };
    let sign = if factor < 0.0 { "minus" } else { "plus" };
    format!("returns {of} {sign} {times}{name}")
}

/// The number that all of these are, up to rounding.
fn agree(numbers: &[f64]) -> Option<f64> {
    let first = *numbers.first()?;
    let close = |v: &f64| (v - first).abs() <= 3e-3 * first.abs();
    (first.is_finite() && first != 0.0 && numbers.len() > 2 && numbers.iter().all(close))
        .then_some(first)
}

/// The line through points: its slope, and where it begins. Most points must be on it, and they must not all be in one place. Points that
/// are elsewhere, such as those at an edge where two answers are right, do not turn it.
fn line(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let mut by_x = points.to_vec();
    by_x.sort_by(|a, b| a.0.total_cmp(&b.0));
    let far = by_x.iter().zip(&by_x[points.len() / 2..]);
    let apart = far.filter(|(a, b)| b.0 - a.0 > 1e-6);
    let slope = middle(apart.map(|(a, b)| (b.1 - a.1) / (b.0 - a.0)).collect())?;
    let shift = middle(points.iter().map(|p| p.1 - slope * p.0).collect())?;
    let on = |p: &&(f64, f64)| (slope * p.0 + shift - p.1).abs() <= 5e-3 * p.1.abs().max(0.1);
    let on: Vec<_> = points.iter().filter(on).copied().collect();
    if on.len() < 3 || 5 * on.len() < 4 * points.len() {
        return None;
    }
    fitted(&on)
}

/// The middle one of some numbers.
fn middle(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied()
}

/// The line that has the least squares of deviations from points.
fn fitted(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let n = points.len() as f64;
    let (x, y) = points
        .iter()
        .fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / n, sum.1 + p.1 / n));
    let (xx, xy) = points.iter().fold((0.0, 0.0), |sum, p| {
        (sum.0 + (p.0 - x).powi(2), sum.1 + (p.0 - x) * (p.1 - y))
    });
    if xx < 1e-9 {
        return None;
    }
    let slope = xy / xx;
    // A constant is told as one.
    (slope.abs() >= 1e-6).then_some((slope, y - slope * x))
}
