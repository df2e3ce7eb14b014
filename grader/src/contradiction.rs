//! Whether a question contradicts what its exercise says of questions: the range of a field, or the *Limits* that `raybook exercise` prints.

use crate::examine::{Examiner, RANDOM_CASES, visible_rng};
use crate::layout::{Part, layout, lists, parts};
use raybook_workbook::kind::Kind;

/// The questions of the random cases and of the named ones that the course has.
pub(crate) struct Questions<'a> {
    examiner: &'a dyn Examiner,
    parts: Vec<Part>,
    /// Whether a part is of length 1 in all of them, and whether it is infinite in one.
    seen: Vec<(bool, bool)>,
    /// Whether a list is empty in one.
    empty: Vec<bool>,
    /// Whether all of them are sound: there are exercises that ask of a triangle without an area on purpose.
    sound: bool,
}

impl<'a> Questions<'a> {
    /// Those of an exercise.
    pub fn of(examiner: &'a dyn Examiner) -> Self {
        let kind = examiner.asked().question;
        let rng = &mut visible_rng(examiner.name());
        let named = examiner.named().unwrap_or_default();
        let named = named.into_iter().map(|named| named.question);
        let random = (0..RANDOM_CASES).map(|_| examiner.random(rng));
        let parts = parts(kind, "question");
        let mut seen = vec![(true, false); parts.len()];
        let mut empty = vec![false; lists(kind, "question").len()];
        let mut sound = true;
        for question in named.chain(random) {
            sound &= examiner.is_sound(&question);
            let layout = layout(kind, &question);
            for leaf in &layout.leaves {
                let values = &question[leaf.range()];
                seen[leaf.part].0 &= is_unit(values);
                seen[leaf.part].1 |= values.iter().any(|v| v.is_infinite());
            }
            for span in &layout.lists {
                empty[span.list] |= span.elements.is_empty();
            }
        }
        Self {
            examiner,
            parts,
            seen,
            empty,
            sound,
        }
    }

    /// That a question is like them.
    ///
    /// # Errors
    /// The place of the word that is not, from 1, and what was expected of it. (A question has a word for each number: no part of one is optional.)
    pub fn admit(&self, question: &[f64]) -> Result<(), (usize, String)> {
        let kind = self.examiner.asked().question;
        let layout = layout(kind, question);
        for leaf in &layout.leaves {
            let Part {
                name, kind, range, ..
            } = &self.parts[leaf.part];
            let values = &question[leaf.range()];
            let (unit, infinite) = self.seen[leaf.part];
            for (&v, word) in values.iter().zip(leaf.start + 1..) {
                if v.is_nan() || (v.is_infinite() && !infinite) {
                    let what = format!("`{name}` is {v}, and should be a finite number");
                    return Err((word, what));
                }
                if let Some(range) = range.filter(|range| !range.holds(v)) {
                    let what = format!("`{name}` is {v}, and should be {}", range.words);
                    return Err((word, what));
                }
            }
            if (unit || matches!(kind, Kind::Direction)) && !is_unit(values) {
                let length = values.iter().map(|v| v * v).sum::<f64>().sqrt();
                let what = format!("`{name}` has length {length:.4}, and should have length 1");
                return Err((leaf.start + 1, what));
            }
        }
        for span in &layout.lists {
            if span.elements.is_empty() && !self.empty[span.list] {
                let names = lists(kind, "question");
                let what = format!("`{}` is empty, and never should be", names[span.list]);
                return Err((span.count + 1, what));
            }
        }
        if self.sound && !self.examiner.is_sound(question) {
            let what = format!(
                "the fields do not fit together: `raybook exercise {}` says what they owe each other, such as axes that are perpendicular, or a smaller bound that is the smaller one",
                self.examiner.name()
            );
            return Err((1, what));
        }
        Ok(())
    }
}

fn is_unit(v: &[f64]) -> bool {
    v.len() == 3 && (v.iter().map(|v| v * v).sum::<f64>().sqrt() - 1.0).abs() < 1e-4
}
