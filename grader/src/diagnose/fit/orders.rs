//! The same components in another order, with other signs, with another length, or one of them alone changed.

use super::{Maker, Pair, line};
use crate::diagnose::function::FUNCTIONS;
use crate::diagnose::number::named;
use crate::layout::{each, layout};
use std::collections::HashMap;
use std::ops::Range;

/// What leads on from components in another order.
pub(super) const ALONG_AN_AXIS: &str = "Take a case that lies along one axis only: along which axis, and to which side, does your answer point?";

/// The sign of a component, of signs as bits.
pub(super) fn sign(signs: u32, component: usize) -> f64 {
    if signs >> component & 1 == 1 {
        -1.0
    } else {
        1.0
    }
}

/// Which components people take for n of them, each by its place: all of them in another order, or one of them twice.
pub(super) fn orders_of(n: usize) -> &'static [&'static [usize]] {
    match n {
        2 => &[&[0, 1], &[1, 0], &[0, 0], &[1, 1]],
        3 => &[
            &[0, 1, 2],
            &[1, 0, 2],
            &[2, 1, 0],
            &[0, 2, 1],
            &[1, 2, 0],
            &[2, 0, 1],
            &[0, 0, 0],
            &[1, 1, 1],
            &[2, 2, 2],
            &[0, 0, 2],
            &[0, 1, 0],
            &[0, 1, 1],
            &[1, 1, 2],
            &[2, 1, 2],
            &[0, 2, 2],
        ],
        _ => &[],
    }
}

impl Maker<'_, '_> {
    /// The right components in an order that is not the same in all cases, as of roots that are not sorted.
    fn reordered(&mut self) {
        let of = self.pairs.iter().map(|pair| (pair.item, pair.got.clone()));
        let got: HashMap<_, _> = of.collect();
        let sorted = |v: &[f64]| {
            let mut v = v.to_vec();
            v.sort_by(f64::total_cmp);
            v
        };
        let near = |(a, b): (&f64, &f64)| {
            a == b || (a - b).is_finite() && (a - b).abs() <= 1e-5 + 1e-3 * a.abs().max(b.abs())
        };
        let is_near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(near);
        let is_turned = |a: &[f64], b: &[f64]| !is_near(a, b) && is_near(&sorted(a), &sorted(b));
        let make = |item: usize, v: &mut [f64]| {
            if let Some(got) = got.get(&item).filter(|got| is_turned(got, v)) {
                v.copy_from_slice(got);
            }
        };
        if got.len() < 3 || self.evidence.parts[self.part].list.is_some() {
            return;
        }
        let name = format!(
            "returns the right numbers of {}, but in some cases in another order",
            self.of
        );
        self.try_one(
            18,
            0,
            name,
            "What decides which of them comes first?",
            &make,
        );
    }

    /// The signs that components may have wrong, as bits: only those of vectors have any.
    pub(super) fn signs(&self) -> Range<u32> {
        let n = self.axes().len();
        0..if self.is_vector() { 1 << n } else { 1 }
    }

    /// What an order of components with these signs is called, and its rank; none of the right one.
    pub(super) fn order_called(&self, order: &[usize], signs: u32) -> Option<(String, u32)> {
        let (axes, n) = (self.axes(), order.len());
        let moved: Vec<_> = (0..n).filter(|k| order[*k] != *k).collect();
        let turned: Vec<_> = (0..n).filter(|k| sign(signs, *k) < 0.0).collect();
        let components = |which: &[usize]| {
            let all: Vec<_> = which.iter().map(|k| axes[*k]).collect();
            all.join(" and ")
        };
        let name = match (moved.len(), turned.len()) {
            (0, 0) => return None,
            (0, t) if t == n => format!(
                "returns {} with the opposite sign, the other way round",
                self.of
            ),
            (0, _) => format!(
                "has the sign of {} of {} wrong",
                components(&turned),
                self.of
            ),
            (1, 0) => format!(
                "returns {} of {} for {} too",
                axes[order[moved[0]]],
                self.of,
                components(&moved)
            ),
            (2, 0) if order[moved[0]] == moved[1] => {
                format!("exchanges {} of {}", components(&moved), self.of)
            }
            _ => {
                let minus = |k: usize| if sign(signs, k) < 0.0 { "−" } else { "" };
                let words = (0..n).map(|k| format!("{}{}", minus(k), axes[order[k]]));
                let words: Vec<_> = words.collect();
                format!(
                    "returns ({}) for ({}) of {}",
                    words.join(", "),
                    axes.join(", "),
                    self.of
                )
            }
        };
        Some((name, 10 + (moved.len() + turned.len()) as u32))
    }

    /// The same components in another order, or with other signs.
    pub(super) fn orders(&mut self) {
        let axes = self.axes();
        let n = axes.len();
        for order in orders_of(n) {
            for signs in self.signs() {
                let Some((name, rank)) = self.order_called(order, signs) else {
                    continue;
                };
                let make = |_: usize, v: &mut [f64]| {
                    let old = v.to_vec();
                    for (k, from) in order.iter().enumerate() {
                        v[k] = sign(signs, k) * old[*from];
                    }
                };
                self.try_one(rank, 0, name, ALONG_AN_AXIS, &make);
            }
        }
        self.reordered();
        if axes == ["min", "max"] {
            let make = |_: usize, v: &mut [f64]| v[1] -= v[0];
            self.try_one(
                12,
                0,
                format!("returns the length of {} for its max", self.of),
                "Which two numbers are asked for: both ends, or where it begins and how long it is?",
                &make,
            );
        }
        if n == 2 {
            for (k, axis) in axes.iter().enumerate() {
                for also in [false, true] {
                    let make = |_: usize, v: &mut [f64]| {
                        if also {
                            v.swap(0, 1);
                        }
                        v[k] = 1.0 - v[k];
                    };
                    let swapped = if also { " and exchanges both" } else { "" };
                    let name = format!(
                        "counts {axis} of {} from the other end: 1 − {axis}{swapped}",
                        self.of
                    );
                    self.try_one(
                        11,
                        0,
                        name,
                        "Where is (0, 0), and in which direction do both numbers grow?",
                        &make,
                    );
                }
            }
            let make = |_: usize, v: &mut [f64]| each(v, |v| *v = 1.0 - *v);
            self.try_one(
                12,
                0,
                format!("counts both numbers of {} from the other end", self.of),
                "Where is (0, 0), and in which direction do both numbers grow?",
                &make,
            );
        }
    }

    /// The right direction with a wrong length, or the right line with a wrong sign.
    pub(super) fn lengths(&mut self) {
        if !self.is_vector() {
            return;
        }
        let length = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let normalised = |_: usize, v: &mut [f64]| {
            let l = length(v);
            if l > 0.0 {
                each(v, |v| *v /= l);
            }
        };
        self.try_one(
            10,
            0,
            format!("normalises {}", self.of),
            "Does the length of the answer matter?",
            &normalised,
        );
        let parallel = |pair: &Pair| {
            let (a, b) = (length(&pair.base), length(&pair.got));
            let dot: f64 = pair.base.iter().zip(&pair.got).map(|(a, b)| a * b).sum();
            (a > 0.0 && b > 1e-6 && (dot.abs() - a * b).abs() <= 2e-6 * a * b)
                .then_some((dot.signum(), b / a))
        };
        let found: Vec<_> = self.pairs.iter().filter_map(parallel).collect();
        if 5 * found.len() < 4 * self.pairs.len() || found.len() < 2 {
            return;
        }
        let got: Vec<Vec<f64>> = self
            .evidence
            .items
            .iter()
            .map(|item| item.got.clone())
            .collect();
        let kind = self.evidence.examiner.asked().answer.kind;
        // One value per item is known by its item.
        let part = self.part;
        let value = |i: usize| {
            layout(kind, &got[i])
                .of_part(part)
                .next()
                .map(|leaf| got[i][leaf.range()].to_vec())
        };
        let unit = self
            .pairs
            .iter()
            .all(|pair| (length(&pair.base) - 1.0).abs() < 1e-4);
        let varied = found.iter().any(|(_, l)| (l - found[0].1).abs() > 1e-3);
        if unit && varied && found.iter().all(|(sign, _)| *sign > 0.0) {
            let make = |i: usize, v: &mut [f64]| {
                if let Some(value) = value(i) {
                    let l = length(&value);
                    each(v, |v| *v *= l);
                }
            };
            self.add(
                13,
                0,
                format!(
                    "forgets to normalise {}, or divides by another length than its own: the direction is right, its length is not 1",
                    self.of
                ),
                "How long is a direction, and how long is the vector by whose length you divide?",
                &make,
            );
        }
        if !varied && found.iter().any(|(sign, _)| *sign > 0.0)
            || found.iter().all(|(sign, _)| *sign < 0.0)
        {
            let make = |i: usize, v: &mut [f64]| {
                if let Some(value) = value(i) {
                    let dot: f64 = v.iter().zip(&value).map(|(a, b)| a * b).sum();
                    let sign = if dot < 0.0 { -1.0 } else { 1.0 };
                    each(v, |v| *v *= sign);
                }
            };
            self.add(
                19,
                1,
                format!(
                    "returns {} along the right line, but sometimes to the wrong side",
                    self.of
                ),
                "What decides to which of the two sides your answer points?",
                &make,
            );
        }
    }

    /// One component alone is changed, or each in its own way.
    pub(super) fn components(&mut self) {
        let axes = self.axes();
        if axes.len() < 2 {
            return;
        }
        let mut lines = Vec::new();
        for (k, axis) in axes.iter().enumerate() {
            let name = format!("{axis} of {}", self.of);
            for function in FUNCTIONS {
                let make = |_: usize, v: &mut [f64]| v[k] = (function.of)(v[k]);
                let words = function.name.replace("the answer", &name);
                let words = if words == function.name {
                    format!("{words} for {name}")
                } else {
                    words
                };
                self.try_one(function.rank + 4, 0, words, function.hint, &make);
            }
            let Some(line) = self.line_of(k) else {
                continue;
            };
            lines.push((k, line, in_words(&name, line)));
        }
        lines.retain(|(_, line, _)| *line != (1.0, 0.0));
        for (k, (slope, shift), words) in &lines {
            let make = |_: usize, v: &mut [f64]| v[*k] = slope * v[*k] + shift;
            self.try_one(
                17,
                1,
                words.clone(),
                "Only one component is wrong: in what does its formula differ from the others?",
                &make,
            );
        }
        if lines.len() > 1 {
            let make = |_: usize, v: &mut [f64]| {
                for (k, (slope, shift), _) in &lines {
                    v[*k] = slope * v[*k] + shift;
                }
            };
            let words: Vec<_> = lines.iter().map(|(_, _, words)| &**words).collect();
            self.try_one(
                18,
                lines.len() as u32,
                words.join(", and "),
                "In which unit is each number asked for, where does it begin, and where does it end?",
                &make,
            );
        }
    }

    /// What a component is times its right value, and plus what, where it is that everywhere.
    fn line_of(&self, component: usize) -> Option<(f64, f64)> {
        let both = |pair: &Pair| (pair.base[component], pair.got[component]);
        let points: Vec<_> = self.pairs.iter().map(both).collect();
        let (slope, shift) = line(&points)?;
        Some((
            if (slope - 1.0).abs() < 1e-3 {
                1.0
            } else {
                slope
            },
            if shift.abs() < 1e-4 { 0.0 } else { shift },
        ))
    }
}

/// A line in words.
fn in_words(name: &str, line: (f64, f64)) -> String {
    match line {
        (1.0, shift) => format!("adds {} to {name}", named(shift)),
        (slope, 0.0) => format!("returns {} times {name}", named(slope)),
        (slope, shift) => format!(
            "returns {} times {name} plus {}",
            named(slope),
            named(shift)
        ),
    }
}
