//! All cases of an exercise as numbers, and how well an explanation agrees with them: it must give the wrong answers, and must not
//! contradict the right ones.

use crate::examine::{Case, Examiner};
use crate::layout::{Layout, Part, layout, parts};
use raybook_workbook::kind::Kind;
use std::cmp::Ordering;

/// What of the answers is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Everything.
    Whole,
    /// One part, all others taken to be right.
    Part(usize),
    /// Whether there is an answer, and how long its lists are.
    Shape,
}

/// A case whose answer could be read.
#[derive(Clone)]
pub struct Item {
    /// The question.
    pub question: Vec<f64>,
    /// The right answers.
    pub answers: Vec<Vec<f64>>,
    /// The student's answer, as far as it is looked at.
    pub got: Vec<f64>,
    /// The student's answer in words.
    pub text: String,
    /// The right answer to the case before.
    pub previous: Option<Vec<f64>>,
    /// Whether it is right.
    pub right: bool,
    layout: Layout,
    tells: f64,
}

impl Item {
    /// The golden answer.
    pub fn golden(&self) -> &[f64] {
        &self.answers[0]
    }
}

/// How well an explanation agrees with the answers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Score {
    /// Wrong answers that are as it says.
    pub explained: usize,
    /// Wrong answers that are not.
    pub missed: usize,
    /// So many answers are right although it says otherwise.
    pub contradicted: usize,
    /// So many of all answers are as it says to the last digits.
    pub close: usize,
    /// How much the wrong answers that it explains tell: 1 for one with numbers, less for a yes or no.
    pub tells: f64,
}

/// All that is known.
#[derive(Clone)]
pub struct Evidence<'a> {
    /// The exercise.
    pub examiner: &'a dyn Examiner,
    /// The answers that could be read: the wrong ones first.
    pub items: Vec<Item>,
    /// The parts of an answer.
    pub parts: Vec<Part>,
    /// What is looked at.
    pub scope: Scope,
    /// How many of the items are wrong.
    pub wrong: usize,
    scales: Vec<f64>,
    free: bool,
    judged: bool,
}

/// Two numbers this close are the same, of the size that answers have, beside [`crate::Graded::ALIKE`] of their own size.
const CLOSE: f64 = 1e-5;

/// What an answer tells that holds nothing but yes, no, or a small whole number.
const HARDLY: f64 = 0.25;

impl<'a> Evidence<'a> {
    /// The evidence of answers, each with whether it is right.
    pub fn new(
        examiner: &'a dyn Examiner,
        cases: &[Case],
        answers: &[(Option<String>, bool)],
    ) -> Self {
        let asked = examiner.asked();
        let goldens: Vec<_> = cases
            .iter()
            .map(|case| asked.read_answer(case.answers.first()?).ok())
            .collect();
        let mut items = Vec::new();
        for (i, (case, (text, right))) in cases.iter().zip(answers).enumerate() {
            let Some(text) = text else { continue };
            let (Ok(question), Ok(got)) =
                (asked.read_question(&case.question), asked.read_answer(text))
            else {
                continue;
            };
            let read = case.answers.iter().map(|answer| asked.read_answer(answer));
            let answers: Vec<_> = read.flatten().collect();
            if answers.is_empty() {
                continue;
            }
            items.push(Item {
                question,
                answers,
                got,
                text: text.clone(),
                previous: i.checked_sub(1).and_then(|before| goldens[before].clone()),
                right: *right,
                layout: Layout::default(),
                tells: 0.0,
            });
        }
        items.sort_by_key(|item| item.right);
        let kind = asked.answer.kind;
        let mut evidence = Self {
            examiner,
            wrong: items.iter().filter(|item| !item.right).count(),
            items,
            parts: parts(kind, asked.answer.name),
            scope: Scope::Whole,
            scales: Vec::new(),
            free: false,
            judged: false,
        };
        evidence.judged = evidence.judge_compares();
        evidence.free = evidence.order_is_free();
        evidence.scales = evidence.scales();
        evidence.settle();
        evidence
    }

    fn kind(&self) -> &'static Kind {
        self.examiner.asked().answer.kind
    }

    /// Brings lists whose order is free into one order, and weighs what each answer tells.
    fn settle(&mut self) {
        for i in 0..self.items.len() {
            let item = &self.items[i];
            let got = self.canonical(&item.question, &item.got);
            let answers = item.answers.iter();
            let answers = answers
                .map(|answer| self.canonical(&item.question, answer))
                .collect();
            let layout = layout(self.kind(), &got);
            let tells = self.tells(&layout, &got);
            let item = &mut self.items[i];
            (item.got, item.answers, item.layout, item.tells) = (got, answers, layout, tells);
        }
    }

    fn tells(&self, layout: &Layout, got: &[f64]) -> f64 {
        let looked_at = |part: usize| self.scope == Scope::Whole || self.scope == Scope::Part(part);
        let special = |v: &f64| [0.0, 1.0, -1.0].contains(v) || !v.is_finite();
        let (mut numbers, mut wholes) = (0, 0);
        for leaf in layout.leaves.iter().filter(|leaf| looked_at(leaf.part)) {
            if matches!(self.parts[leaf.part].kind, Kind::Whole) {
                wholes += 1;
            } else {
                numbers += got[leaf.range()].iter().filter(|v| !special(v)).count();
            }
        }
        if numbers > 0 || wholes > 5 {
            1.0
        } else {
            HARDLY
        }
    }

    /// The size that the numbers of each part have.
    fn scales(&self) -> Vec<f64> {
        let mut sizes = vec![Vec::new(); self.parts.len()];
        for item in &self.items {
            for leaf in layout(self.kind(), item.golden()).leaves {
                let values = item.golden()[leaf.range()].iter().map(|v| v.abs());
                sizes[leaf.part].extend(values.filter(|v| v.is_finite() && *v > 0.0));
            }
        }
        let middle = |sizes: &mut Vec<f64>| {
            sizes.sort_by(f64::total_cmp);
            sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
        };
        sizes
            .iter_mut()
            .map(middle)
            .map(|size| size.min(1.0))
            .collect()
    }

    /// Whether the judge compares with the golden answer: then it can say whether an answer is a mistake's.
    fn judge_compares(&self) -> bool {
        let first = self.items.iter().find(|item| !item.golden().is_empty());
        first.is_some_and(|item| {
            self.examiner
                .traits(&item.question, item.golden())
                .is_empty()
        })
    }

    /// Whether the judge takes lists in any order.
    fn order_is_free(&self) -> bool {
        let mut tried = 0;
        for item in &self.items {
            let layout = layout(self.kind(), item.golden());
            let mut turned = item.golden().to_vec();
            // Nested lists may differ in length: one list is enough to know.
            if let Some(span) = layout.lists.first() {
                turned = layout.rearranged(&turned, span.list, &|n| (0..n).rev().collect());
            }
            if turned == item.golden() {
                continue;
            }
            tried += 1;
            if self
                .examiner
                .compare(&item.question, item.golden(), &turned)
                .is_err()
            {
                return false;
            }
            if tried == 5 {
                break;
            }
        }
        tried > 0
    }

    /// An answer whose lists are in one order, if their order is free.
    fn canonical(&self, question: &[f64], answer: &[f64]) -> Vec<f64> {
        let mut answer = self.examiner.canonical(question, answer);
        if !self.free {
            return answer;
        }
        // The innermost lists come first.
        let lists = layout(self.kind(), &answer).lists;
        let last = lists.iter().map(|span| span.list).max();
        for list in (0..last.map_or(0, |last| last + 1)).rev() {
            let layout = layout(self.kind(), &answer);
            for span in layout.lists.iter().filter(|span| span.list == list) {
                let mut elements: Vec<_> = span
                    .elements
                    .iter()
                    .map(|place| answer[place.clone()].to_vec())
                    .collect();
                let by_numbers = |a: &Vec<f64>, b: &Vec<f64>| {
                    let first = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
                    first.fold(a.len().cmp(&b.len()), Ordering::then)
                };
                elements.sort_by(by_numbers);
                let start = span.count + 1;
                let flat = elements.concat();
                answer[start..start + flat.len()].copy_from_slice(&flat);
            }
        }
        answer
    }

    /// The same evidence of one part, or of the shape; none if nothing is wrong with it.
    pub fn of(&self, scope: Scope) -> Option<Self> {
        let mut items = Vec::new();
        for item in &self.items {
            let mut item = item.clone();
            match scope {
                Scope::Whole => {}
                Scope::Shape => {
                    item.right = item.right || self.same_shape(item.golden(), &item.got);
                }
                Scope::Part(part) => {
                    if !item.right {
                        let Some(got) = self.projected(part, item.golden(), &item.got) else {
                            continue;
                        };
                        let verdict = self.examiner.compare(&item.question, item.golden(), &got);
                        (item.got, item.right) = (got, verdict.is_ok());
                    }
                }
            }
            items.push(item);
        }
        items.sort_by_key(|item| item.right);
        let wrong = items.iter().filter(|item| !item.right).count();
        let mut of = Self {
            items,
            scope,
            wrong,
            ..self.clone()
        };
        of.settle();
        (wrong > 0).then_some(of)
    }

    fn same_shape(&self, one: &[f64], other: &[f64]) -> bool {
        let shape = |numbers: &[f64]| layout(self.kind(), numbers).shape(numbers);
        shape(one) == shape(other)
    }

    /// The golden answer with a part of another answer of the same shape.
    fn projected(&self, part: usize, golden: &[f64], other: &[f64]) -> Option<Vec<f64>> {
        let here = layout(self.kind(), golden);
        let there = layout(self.kind(), other);
        if here.shape(golden) != there.shape(other) || here != there {
            return None;
        }
        let mut projected = golden.to_vec();
        for leaf in here.of_part(part) {
            projected[leaf.range()].copy_from_slice(&other[leaf.range()]);
        }
        Some(projected)
    }

    /// A prediction, as far as it is looked at; none if it says nothing.
    fn seen(&self, item: &Item, prediction: &[f64]) -> Option<Vec<f64>> {
        let prediction = self.canonical(&item.question, prediction);
        match self.scope {
            Scope::Part(part) => self.projected(part, item.golden(), &prediction),
            _ => Some(prediction),
        }
    }

    /// Whether an answer is the one that is predicted; and whether it is so to the last digits.
    fn agrees(&self, item: &Item, prediction: &[f64]) -> (bool, bool) {
        if self.scope == Scope::Shape {
            let same = self.same_shape(prediction, &item.got);
            return (same, same);
        }
        if self.alike(item, prediction) {
            return (true, true);
        }
        let judged = || {
            let compare = |one, other| self.examiner.compare(&item.question, one, other).is_ok();
            compare(prediction, &item.got) && compare(&item.got, prediction)
        };
        (
            self.judged && prediction.iter().all(|v| !v.is_nan()) && judged(),
            false,
        )
    }

    /// The same numbers, up to rounding.
    fn alike(&self, item: &Item, prediction: &[f64]) -> bool {
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
    fn is_right(&self, item: &Item, prediction: &[f64]) -> bool {
        if self.scope == Scope::Shape {
            return self.same_shape(item.golden(), prediction);
        }
        let compare = |answer: &Vec<f64>| self.examiner.compare(&item.question, answer, prediction);
        item.answers.iter().any(|answer| compare(answer).is_ok())
    }

    /// Whether an answer gives that of an item.
    pub fn explains(&self, item: usize, answer: &[f64]) -> bool {
        let item = &self.items[item];
        self.seen(item, answer)
            .is_some_and(|seen| self.agrees(item, &seen).0)
    }

    /// The first wrong items.
    pub fn probe(&self, most: usize) -> Self {
        let wrong = self.wrong.min(most);
        let items = self.items[..wrong].to_vec();
        Self {
            items,
            wrong,
            ..self.clone()
        }
    }

    /// Whether the wrong answers tell more than yes or no.
    pub fn tells_much(&self) -> bool {
        self.items
            .iter()
            .take(self.wrong)
            .filter(|item| item.tells >= 1.0)
            .count()
            >= 3
    }

    /// How well predictions, one per item, agree with all answers; none if they explain less than this share of the wrong ones.
    pub fn score(
        &self,
        share: f64,
        mut predict: impl FnMut(usize) -> Option<Vec<f64>>,
    ) -> Option<Score> {
        let needed = (share * self.wrong as f64).ceil().max(1.0) as usize;
        let mut score = Score::default();
        for (i, item) in self.items.iter().enumerate() {
            let prediction = predict(i).and_then(|prediction| self.seen(item, &prediction));
            if item.right {
                let Some(prediction) = prediction else {
                    continue;
                };
                let (agrees, close) = self.agrees(item, &prediction);
                score.close += usize::from(close);
                if !agrees && !self.is_right(item, &prediction) {
                    score.contradicted += 1;
                }
                continue;
            }
            let (agrees, close) = prediction.map_or((false, false), |p| self.agrees(item, &p));
            if agrees {
                score.explained += 1;
                score.close += usize::from(close);
                score.tells += item.tells;
            } else {
                score.missed += 1;
                if self.wrong - score.missed < needed {
                    return None;
                }
            }
        }
        Some(score)
    }
}
