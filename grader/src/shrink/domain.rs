//! The questions that an exercise asks: numbers in the ranges of its cases, unit vectors where all are, and answers that do not hang on
//! the last digits.

use super::simpler::{Site, rounder, shorter};
use crate::diagnose::search::called;
use crate::examine::{Case, Examiner, visible_rng};
use crate::layout::{Part, layout, lists, parts};
use rand::RngExt;
use raybook_workbook::kind::Kind;

/// How far each number is moved in a question whose answer must stay right, as a part of its size, or of 1 if that is larger.
const MOVED: f64 = 2e-6;

/// How often.
const TRIES: usize = 8;

/// What occurs of a number.
#[derive(Clone, Copy)]
struct Range {
    least: f64,
    most: f64,
    infinite: bool,
}

impl Range {
    const NOTHING: Self = Self {
        least: f64::INFINITY,
        most: f64::NEG_INFINITY,
        infinite: false,
    };

    fn see(&mut self, v: f64) {
        if v.is_finite() {
            self.least = self.least.min(v);
            self.most = self.most.max(v);
        } else {
            self.infinite |= v == f64::INFINITY;
        }
    }

    fn holds(&self, v: f64) -> bool {
        (self.least..=self.most).contains(&v) || (self.infinite && v == f64::INFINITY)
    }
}

/// What occurs in the visible cases of an exercise.
pub struct Domain<'a> {
    examiner: &'a dyn Examiner,
    parts: Vec<Part>,
    /// Of each part, the ranges of its numbers, and whether they are always a unit vector.
    ranges: Vec<(Vec<Range>, bool)>,
    /// Of each list, the range of its length.
    lengths: Vec<Range>,
}

impl<'a> Domain<'a> {
    /// The domain of an exercise.
    pub fn of(examiner: &'a dyn Examiner) -> Self {
        let visible = examiner.cases(&mut visible_rng(examiner.name())).cases;
        Self::of_cases(examiner, &visible)
    }

    /// What occurs in these cases of an exercise.
    pub fn of_cases(examiner: &'a dyn Examiner, cases: &[Case]) -> Self {
        let asked = examiner.asked();
        let parts = parts(asked.question, "question");
        let mut ranges = vec![(Vec::new(), true); parts.len()];
        let mut lengths = vec![Range::NOTHING; lists(asked.question, "question").len()];
        for case in cases {
            let Ok(question) = asked.read_question(&case.question) else {
                continue;
            };
            let layout = layout(asked.question, &question);
            for leaf in &layout.leaves {
                let (ranges, unit): &mut (Vec<Range>, bool) = &mut ranges[leaf.part];
                ranges.resize(leaf.len, Range::NOTHING);
                let values = &question[leaf.range()];
                ranges
                    .iter_mut()
                    .zip(values)
                    .for_each(|(range, v)| range.see(*v));
                *unit &= leaf.len == 3 && is_unit(values);
            }
            for span in &layout.lists {
                lengths[span.list].see(span.elements.len() as f64);
            }
        }
        Self {
            examiner,
            parts,
            ranges,
            lengths,
        }
    }

    /// Questions that are simpler at a place, simplest first.
    pub fn simpler(&self, site: &Site, question: &[f64]) -> Vec<Vec<f64>> {
        match *site {
            Site::List(list, length) => {
                let layout = layout(self.examiner.asked().question, question);
                let with =
                    |which: Vec<usize>| layout.rearranged(question, list, &|_| which.clone());
                shorter(length).into_iter().map(with).collect()
            }
            Site::Value(part, start, end) => {
                let (kind, unit) = (self.parts[part].kind, self.ranges[part].1);
                let with =
                    |value: Vec<f64>| [&question[..start], &value, &question[end..]].concat();
                let rounder = rounder(kind, unit, &question[start..end]);
                rounder.into_iter().map(with).collect()
            }
        }
    }

    /// Whether values that differ in a question differ in another, too: a triangle keeps three corners, and a list its elements.
    pub fn keeps_apart(&self, question: &[f64], other: &[f64]) -> bool {
        let kind = self.examiner.asked().question;
        let of = |question: &[f64]| {
            let leaves = layout(kind, question).leaves.into_iter();
            let vectors = leaves.filter(|leaf| leaf.len == 3);
            let values = vectors.map(|leaf| question[leaf.range()].to_vec());
            values.collect::<Vec<_>>()
        };
        let (before, after) = (of(question), of(other));
        let pairs = (0..before.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        before.len() != after.len()
            || pairs
                .into_iter()
                .all(|(i, j)| before[i] == before[j] || after[i] != after[j])
    }

    /// Whether a question is one of those that the exercise asks, and its answer hangs on no last digits.
    pub fn holds(&self, question: &[f64]) -> bool {
        self.is_asked(question) && self.is_stable(question)
    }

    /// Whether a question is one of those that the exercise asks.
    pub fn is_asked(&self, question: &[f64]) -> bool {
        let layout = layout(self.examiner.asked().question, question);
        let in_range = layout.leaves.iter().all(|leaf| {
            let (ranges, unit) = &self.ranges[leaf.part];
            let values = &question[leaf.range()];
            let held = ranges.iter().zip(values).all(|(range, v)| range.holds(*v));
            held && (!unit || is_unit(values))
        });
        let long_enough = layout.lists.iter().all(|span| {
            let length = span.elements.len() as f64;
            self.lengths[span.list].holds(length)
        });
        in_range && long_enough && self.examiner.is_sound(question)
    }

    /// Whether the answer stays right when all numbers move a little, round ones too: a ray through the edge of a triangle whose corners
    /// are round numbers is nobody's fault.
    fn is_stable(&self, question: &[f64]) -> bool {
        let asked = self.examiner.asked();
        let Some(golden) = called(asked, question) else {
            return false;
        };
        let rng = &mut visible_rng(asked.name);
        (0..TRIES).all(|_| {
            let mut moved = question.to_vec();
            for leaf in layout(asked.question, question).leaves {
                let part = &self.parts[leaf.part];
                if *part.kind == Kind::Whole {
                    continue;
                }
                let ranges = &self.ranges[leaf.part].0;
                for (v, range) in moved[leaf.range()].iter_mut().zip(ranges) {
                    if v.is_finite() {
                        let by = MOVED * v.abs().max(1.0) * rng.random_range(-1.0..1.0);
                        *v = (*v + by).clamp(range.least, range.most);
                    }
                }
            }
            let answer = called(asked, &moved);
            answer.is_some_and(|answer| {
                let verdict = self.examiner.compare(question, &golden, &answer);
                verdict.is_ok()
            })
        })
    }
}

fn is_unit(v: &[f64]) -> bool {
    (v.iter().map(|v| v * v).sum::<f64>().sqrt() - 1.0).abs() < 1e-4
}
