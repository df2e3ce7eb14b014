//! How well an explanation agrees with the answers.

use super::{Evidence, Item, Scope};
use raybook_workbook::kind::Kind;

/// How well an explanation agrees with the answers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Score {
    /// Wrong answers that are as it says.
    pub explained: usize,
    /// Wrong answers that are not.
    pub missed: usize,
    /// Wrong answers that are as it says in the part that is looked at, and in another part neither right nor as it says.
    pub strays: usize,
    /// How many answers are right although it says otherwise.
    pub contradicted: usize,
    /// How many of all answers are as it says to the last digits.
    pub close: usize,
    /// How many of the wrong answers that it explains are so to the last digits.
    pub sharp: usize,
    /// How much the wrong answers that it explains tell: 1 for one with numbers, less for a yes or no.
    pub tells: f64,
    /// Whether the answers are estimates, which scatter.
    pub is_rough: bool,
    /// Whether something leaves it in doubt: its numbers are not the answers', though a judge who lets much pass takes them for these; or the
    /// answers are estimates, which scatter, and are few, or on the whole larger or smaller than it says, as those of a mistake that is
    /// nearly the same; or other numbers may have been compared with the same outcome.
    pub is_doubtful: bool,
}

/// What is left of answers, when what explains them is taken off: as shares of them.
#[derive(Default)]
struct Rest {
    count: f64,
    sum: f64,
    squares: f64,
    /// The squares of what is left, and of what the right answer leaves, each as a share of the largest number of that.
    left: f64,
    left_by_right: f64,
}

impl Rest {
    /// Adds the numbers of an answer.
    fn add(&mut self, got: &[f64], prediction: &[f64]) {
        for (a, b) in got.iter().zip(prediction) {
            let size = a.abs().max(b.abs());
            if size > 0.0 && size.is_finite() {
                let share = (a - b) / size;
                self.count += 1.0;
                self.sum += share;
                self.squares += share * share;
            }
        }
    }

    /// Adds how far an answer is from what explains it, and how far from the right one.
    fn compare(&mut self, got: &[f64], prediction: &[f64], right: &[f64]) {
        let size = right.iter().fold(0.0, |size: f64, v| size.max(v.abs()));
        let apart = |from: &[f64]| {
            let pairs = got.iter().zip(from);
            let squares = pairs.map(|(a, b)| ((a - b) / size).powi(2));
            squares.filter(|square| square.is_finite()).sum::<f64>()
        };
        if got.len() == right.len() && got.len() == prediction.len() {
            self.left += apart(prediction);
            self.left_by_right += apart(right);
        }
    }

    /// Whether what explains the answers is hardly nearer to them than the right ones are.
    fn is_as_far_as_right(&self) -> bool {
        /// The share of the squares that a mistake may leave.
        const MOST: f64 = 0.5;
        self.left > MOST * self.left_by_right
    }

    /// Whether what explains the answers is farther from them than a mistake that is made leaves it. Estimates scatter beside it.
    fn is_loose(&self, is_rough: bool) -> bool {
        // The share of the squares.
        let most = if is_rough { 0.05 } else { 0.01 };
        self.left > most * self.left_by_right
    }

    /// Whether their mean is no chance, and something of the distance from the right answers.
    fn leans(&self) -> bool {
        /// Numbers that belong together, such as those of a colour, are no independent ones.
        const TOGETHER: f64 = 3.0;
        /// Standard errors.
        const MOST: f64 = 3.0;
        /// The share of the squares that is nothing.
        const NOTHING: f64 = 2e-3;
        let mean = self.sum / self.count;
        let variance = self.squares / self.count - mean * mean;
        let error = (variance.max(0.0) * TOGETHER / self.count).sqrt();
        let is_something = self.left > NOTHING * self.left_by_right;
        self.count > 0.0 && is_something && mean.abs() > MOST * error + 1e-3
    }

    /// Whether it is about as large as the answers: they are small, and anything small is within a judge's tolerance of them.
    fn is_large(&self) -> bool {
        /// The root of the mean square.
        const LARGE: f64 = 0.5;
        self.squares > LARGE * LARGE * self.count
    }
}

/// What explains answers is sharp if it gives this many to the last digits for each one that it does not.
const NEARLY_ALL: usize = 8;

/// Answers that may differ by more than this share are estimates.
const ROUGH: f32 = 0.01;

/// An answer with this many numbers more than twice those of another is another answer.
const MUCH: usize = 100;

/// Fewer estimates than these are few.
const MANY: usize = 20;

/// An explanation of most answers that is given up at a glance is so by chance once in this many times, at most.
const SELDOM: f64 = 100.0;

/// Two numbers this close are the same, of the size that answers have, beside [`crate::Graded::ALIKE`] of their own size.
const CLOSE: f64 = 1e-5;

/// Numbers that differ by less than this share of them are one number, calculated in single or in double precision.
const SAME: f64 = 1e-6;

/// What is predicted to the last digits is at most this share as far from an answer as the right one is.
const NEAR: f64 = 0.02;

/// Of a row's things, cut into stretches of the same length, the places of those with the least cost: in a tie nearest to the middle.
pub fn stretches<C: Ord>(row: usize, count: usize, cost: impl Fn(usize) -> C) -> Vec<usize> {
    let count = count.min(row);
    let least = |k: usize| {
        let middle = (2 * k + 1) * row / (2 * count);
        let of = k * row / count..(k + 1) * row / count;
        of.min_by_key(|i| (cost(*i), i.abs_diff(middle)))
    };
    (0..count).filter_map(least).collect()
}

/// How far two answers are apart: the sum of what their numbers differ by, as shares of these.
fn distance(one: &[f64], other: &[f64]) -> f64 {
    if one.len() != other.len() {
        return f64::INFINITY;
    }
    let apart = |(a, b): (&f64, &f64)| {
        if a == b || a.is_nan() && b.is_nan() {
            0.0
        } else if (a - b).is_finite() {
            (a - b).abs() / a.abs().max(b.abs()).max(CLOSE)
        } else {
            f64::INFINITY
        }
    };
    one.iter().zip(other).map(apart).sum()
}

impl Evidence<'_> {
    /// A prediction, as far as it is looked at; none if it says nothing, or far more than was answered, or far less.
    fn seen(&self, item: &Item, prediction: &[f64]) -> Option<Vec<f64>> {
        let is_much_longer = |one: &[f64], other: &[f64]| one.len() > MUCH + 2 * other.len();
        // A misread density makes lists of a million cells, and so may a student.
        if is_much_longer(prediction, &item.got) || is_much_longer(&item.got, prediction) {
            return None;
        }
        let prediction = self.canonical(&item.question, prediction);
        match self.scope {
            Scope::Part(part) => self.projected(part, item.golden(), &prediction),
            _ => Some(prediction),
        }
    }

    /// Whether an answer is the one that is predicted; and whether it is so to the last digits.
    fn agrees(&self, item: &Item, prediction: &[f64]) -> (bool, bool) {
        let [is_nan, got_nan] = [prediction, &item.got].map(|v| v.iter().any(|v| v.is_nan()));
        if self.scope == Scope::Shape {
            let same = is_nan == got_nan && self.same_shape(prediction, &item.got);
            return (same, same);
        }
        if self.alike(item, prediction) {
            return (true, true);
        }
        let judged = || {
            let compare = |one, other| self.examiner.compare(&item.question, one, other).is_ok();
            compare(prediction, &item.got) && compare(&item.got, prediction)
        };
        // A judge that compares with NaN finds no difference.
        let are_numbers = !is_nan && !got_nan;
        (self.judged && are_numbers && judged(), false)
    }

    /// The same numbers, up to rounding.
    pub(super) fn alike(&self, item: &Item, prediction: &[f64]) -> bool {
        if prediction.len() != item.got.len() {
            return false;
        }
        let relative = f64::from(self.examiner.alike());
        let mut inside = vec![f64::NAN; prediction.len()];
        for leaf in &item.layout.leaves {
            let whole = matches!(self.parts[leaf.part].kind, Kind::Whole);
            inside[leaf.range()].fill(if whole {
                f64::NAN
            } else {
                CLOSE * self.scales[leaf.part]
            });
        }
        let close = |((a, b), floor): ((&f64, &f64), &f64)| {
            a == b
                || (a.is_nan() && b.is_nan())
                || (a - b).abs() <= floor + relative * a.abs().max(b.abs()) && (a - b).is_finite()
        };
        prediction.iter().zip(&item.got).zip(&inside).all(close)
    }

    /// Whether an answer, as far as it is looked at, would be judged right.
    pub fn is_right(&self, item: &Item, prediction: &[f64]) -> bool {
        if self.scope == Scope::Shape {
            return self.same_shape(item.golden(), prediction);
        }
        let compare = |answer: &Vec<f64>| self.examiner.compare(&item.question, answer, prediction);
        item.answers.iter().any(|answer| compare(answer).is_ok())
    }

    /// Whether an answer that is right in all its parts speaks against a prediction that is wrong in one of those that are not
    /// looked at: who makes a mistake makes it in the whole answer.
    fn is_contradicted_elsewhere(&self, item: &Item, prediction: &[f64]) -> bool {
        let compare = |answer: &Vec<f64>| self.examiner.compare(&item.question, answer, prediction);
        self.scope != Scope::Whole
            && item.entire
            && !item.answers.iter().any(|answer| compare(answer).is_ok())
    }

    /// Whether a prediction of one part says of another what is neither right there nor the student's.
    /// Of answers of which the shape alone is looked at, that the student's is another one of that shape.
    fn strays_elsewhere(&self, item: &Item, prediction: &[f64]) -> bool {
        let compare =
            |one: &[f64], other: &[f64]| self.examiner.compare(&item.question, one, other).is_ok();
        let part = match self.scope {
            Scope::Whole => return false,
            Scope::Shape => return !compare(prediction, &item.raw),
            Scope::Part(part) => part,
        };
        let golden = item.golden();
        let mut others = (0..self.parts.len()).filter(|other| *other != part);
        others.any(|other| {
            let said = self.projected(other, golden, prediction);
            let made = self.projected(other, golden, &item.raw);
            said.zip(made)
                .is_some_and(|(said, made)| !compare(golden, &said) && !compare(&said, &made))
        })
    }

    /// Whether a wrong answer is the one that is predicted; and whether it is so to the last digits, and much nearer to it than to the
    /// right one. It is never the right one: a
    /// mistake that does not show in a case explains nothing there.
    fn is_predicted(&self, item: &Item, prediction: &[f64]) -> (bool, bool) {
        let same = |answer: &Vec<f64>| {
            let pairs = answer.iter().zip(prediction);
            let mut near =
                pairs.map(|(a, b)| a == b || a.is_finite() && (a - b).abs() <= SAME * a.abs());
            answer.len() == prediction.len() && near.all(|near| near)
        };
        if item.answers.iter().any(same) {
            return (false, false);
        }
        let (agrees, close) = self.agrees(item, prediction);
        let mut far = item.answers.iter().map(|right| distance(right, &item.got));
        let is_near = |far: f64| distance(prediction, &item.got) <= NEAR * far;
        (agrees, close && far.all(is_near))
    }

    /// Whether answers to a question are not all the same one to its judge.
    pub fn differ(&self, item: &Item, answers: &[Option<Vec<f64>>]) -> bool {
        let Some((first, others)) = answers.split_first() else {
            return false;
        };
        others.iter().any(|other| match (first, other) {
            (Some(first), Some(other)) => {
                let compared = self.examiner.compare(&item.question, first, other);
                compared.is_err()
            }
            (first, other) => first.is_some() != other.is_some(),
        })
    }

    /// Whether an answer gives that of an item.
    pub fn explains(&self, item: usize, answer: &[f64]) -> bool {
        let item = &self.items[item];
        let gives = |seen: Vec<f64>| {
            if item.right {
                self.agrees(item, &seen).0
            } else {
                self.is_predicted(item, &seen).0
            }
        };
        self.seen(item, answer).is_some_and(gives)
    }

    /// Whether answers are estimates, which scatter.
    pub fn is_rough(&self) -> bool {
        self.examiner.alike() > ROUGH
    }

    /// The first case whose wrong answer these explain, one for each item: its place among all cases.
    pub fn first_explained(&self, answers: &[Option<Vec<f64>>]) -> Option<usize> {
        let wrong = self.items[..self.wrong].iter().zip(answers).enumerate();
        let explained = wrong.filter(|(i, (_, answer))| {
            let gives = |answer: &Vec<f64>| self.explains(*i, answer);
            answer.as_ref().is_some_and(gives)
        });
        explained.map(|(_, (item, _))| item.case).min()
    }

    /// A few wrong answers, from all over: of predictions that explain this share of all nearly always one is right there. Of each
    /// stretch of the wrong ones it is the one with the least cost, or that in the middle.
    pub fn few<C: Ord>(&self, share: f64, cost: impl Fn(usize) -> C) -> Vec<usize> {
        let few = if share < 1.0 {
            (SELDOM.ln() / -(1.0 - share).ln()).ceil() as usize
        } else {
            1
        };
        stretches(self.wrong, few, cost)
    }

    /// How well predictions, one per item, agree with all answers; none if they explain less than this share of the wrong ones.
    pub fn score(
        &self,
        share: f64,
        predict: impl FnMut(usize) -> Option<Vec<f64>>,
    ) -> Option<Score> {
        self.score_after(&self.few(share, |_| ()), share, predict)
    }

    /// The same, given up if none of a few answers is as predicted.
    pub fn score_after(
        &self,
        few: &[usize],
        share: f64,
        mut predict: impl FnMut(usize) -> Option<Vec<f64>>,
    ) -> Option<Score> {
        let mut explains = |i: &usize| predict(*i).is_some_and(|one| self.explains(*i, &one));
        if few.len() < self.wrong && !few.iter().any(&mut explains) {
            return None;
        }
        let needed = (share * self.wrong as f64).ceil().max(1.0) as usize;
        let mut score = Score::default();
        let mut rest = Rest::default();
        for (i, item) in self.items.iter().enumerate() {
            let predicted = predict(i);
            let prediction = predicted
                .as_ref()
                .and_then(|prediction| self.seen(item, prediction));
            if item.right {
                let elsewhere = |all: &Vec<f64>| self.is_contradicted_elsewhere(item, all);
                if predicted.as_ref().is_some_and(elsewhere) {
                    score.contradicted += 1;
                    continue;
                }
                let Some(prediction) = prediction else {
                    // It is silent; or it says that there is nothing where the right answer has this part.
                    let has_part = || self.seen(item, item.golden()).is_some();
                    score.contradicted += usize::from(predicted.is_some() && has_part());
                    continue;
                };
                let (agrees, close) = self.agrees(item, &prediction);
                score.close += usize::from(close);
                if !agrees && !self.is_right(item, &prediction) {
                    score.contradicted += 1;
                }
                continue;
            }
            let agree = |p: &Vec<f64>| self.is_predicted(item, p);
            let (agrees, close) = prediction.as_ref().map_or((false, false), agree);
            if agrees {
                let said = prediction.as_deref().unwrap_or(&[]);
                rest.add(&item.got, said);
                rest.compare(&item.got, said, item.golden());
                score.explained += 1;
                let strays = |all: &Vec<f64>| self.strays_elsewhere(item, all);
                score.strays += usize::from(predicted.as_ref().is_some_and(strays));
                score.close += usize::from(close);
                score.sharp += usize::from(close);
                score.tells += item.tells;
            } else {
                score.missed += 1;
                if self.wrong - score.missed < needed {
                    return None;
                }
            }
        }
        score.is_rough = self.is_rough();
        if score.is_rough && rest.is_as_far_as_right() {
            return None;
        }
        // Of nearly all answers to the last digits, some others are so, too: round a circle 0 and 1 are the same place.
        let is_exact = NEARLY_ALL * (score.explained - score.sharp) <= score.explained;
        let is_loose = rest.is_loose(score.is_rough) && (score.is_rough || !is_exact);
        score.is_doubtful = is_loose
            || score.is_rough && (score.explained < MANY || rest.leans() || rest.is_large());
        Some(score)
    }
}
