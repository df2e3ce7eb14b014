//! All cases of an exercise as numbers, and how well an explanation agrees with them: it must give the wrong answers, and must not
//! contradict the right ones.

mod agreement;
mod form;

pub use agreement::{Score, stretches};

use crate::attempt::attempt;
use crate::diagnose::slips::Tried;
use crate::examine::{Case, Examiner};
use crate::layout::{Layout, Part, layout, parts};
use crate::mutex::lock;
use raybook_workbook::kind::Kind;
use std::collections::HashMap;
use std::sync::{Arc, Mutex};

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
    /// Its place among all cases.
    pub case: usize,
    /// Whether it was made by chance.
    is_random: bool,
    /// The question.
    pub question: Vec<f64>,
    /// The right answers.
    pub answers: Vec<Vec<f64>>,
    /// The student's answer, as far as it is looked at.
    pub got: Vec<f64>,
    /// The student's answer as it came.
    pub raw: Vec<f64>,
    /// The student's answer in words.
    pub text: String,
    /// The right answer to the case before.
    pub previous: Option<Vec<f64>>,
    /// Whether it is right, as far as it is looked at.
    pub right: bool,
    /// Whether it is right in all its parts.
    entire: bool,
    layout: Layout,
    tells: f64,
}

impl Item {
    /// The golden answer.
    pub fn golden(&self) -> &[f64] {
        &self.answers[0]
    }
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// What the exercise's own mistakes answer, by their numbers and the case.
type Mistaken = HashMap<(usize, usize), Option<Vec<f64>>>;

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
    /// Of each part, whether it is a direction that the student normalises.
    unit: Vec<bool>,
    free: bool,
    judged: bool,
    /// What slips answer, which is the same for all parts of an answer.
    pub slips: Arc<Mutex<Tried>>,
    mistaken: Arc<Mutex<Mistaken>>,
}

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
                case: i,
                is_random: case.is_random(),
                question,
                answers,
                raw: got.clone(),
                got,
                text: text.clone(),
                previous: i.checked_sub(1).and_then(|before| goldens[before].clone()),
                right: *right,
                entire: *right,
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
            unit: Vec::new(),
            free: false,
            judged: false,
            slips: Arc::default(),
            mistaken: Arc::default(),
        };
        evidence.judged = evidence.judge_compares();
        evidence.free = evidence.order_is_free();
        evidence.scales = evidence.scales();
        evidence.unit = evidence.unit();
        evidence.settle();
        evidence
    }

    /// The evidence of the same answers and further ones behind them. What is known of mistakes stays known.
    pub fn and_further(&self, cases: &[Case], answers: &[(Option<String>, bool)]) -> Self {
        Self {
            slips: Arc::clone(&self.slips),
            mistaken: Arc::clone(&self.mistaken),
            ..Self::new(self.examiner, cases, answers)
        }
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

    /// Whether each part is a vector of length 1 in all answers, in right ones and the student's.
    fn unit(&self) -> Vec<bool> {
        let all = self
            .items
            .iter()
            .flat_map(|item| [item.golden(), &item.got]);
        let mut unit = vec![true; self.parts.len()];
        for answer in all {
            for leaf in layout(self.kind(), answer).leaves {
                let is_unit = leaf.len == 3 && (length(&answer[leaf.range()]) - 1.0).abs() < 1e-3;
                unit[leaf.part] &= is_unit;
            }
        }
        unit
    }

    /// What a slip makes, where the student normalises the direction that comes of it.
    pub fn normalised(&self, mut prediction: Vec<f64>) -> Vec<f64> {
        if self.unit.contains(&true) {
            for leaf in layout(self.kind(), &prediction).leaves {
                let vector = &mut prediction[leaf.range()];
                let length = length(vector);
                if self.unit[leaf.part] && length > 0.0 && length.is_finite() {
                    for v in vector {
                        *v /= length;
                    }
                }
            }
        }
        prediction
    }

    /// What an own mistake answers to an item's question, of which it is known once it was asked; none if it stops with an error.
    pub fn mistaken(&self, mistake: usize, item: usize) -> Option<Vec<f64>> {
        let item = &self.items[item];
        let of = (mistake, item.case);
        let known = lock(&self.mistaken).get(&of).cloned();
        known.unwrap_or_else(|| {
            // Nobody waits while a mistake is made; of two who make the same one, both know it.
            let answer = attempt(|| self.examiner.mistake_answers(mistake, &item.question));
            let answer = answer.flatten();
            lock(&self.mistaken).insert(of, answer.clone());
            answer
        })
    }

    /// Of two own mistakes, first the one that explains more wrong answers alone, or that shows in more.
    pub fn in_order(&self, [one, other]: [usize; 2]) -> [usize; 2] {
        let alone = |mistake: usize| {
            let answers = (0..self.wrong).filter_map(|k| Some((k, self.mistaken(mistake, k)?)));
            answers.fold((0, 0), |(explained, shown), (k, answer)| {
                let shows = !self.is_right(&self.items[k], &answer);
                let explains = self.explains(k, &answer);
                (
                    explained + usize::from(explains),
                    shown + usize::from(shows),
                )
            })
        };
        if alone(one) > alone(other) {
            [one, other]
        } else {
            [other, one]
        }
    }

    /// Whether answers are compared with the golden ones; those of others are judged by their traits.
    pub fn is_judged(&self) -> bool {
        self.judged
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
        let mut of = self.keeping(items)?;
        of.scope = scope;
        of.settle();
        Some(of)
    }

    /// The same evidence of these items, the wrong ones first; none if nothing is wrong.
    fn keeping(&self, items: Vec<Item>) -> Option<Self> {
        let wrong = items.iter().filter(|item| !item.right).count();
        (wrong > 0).then(|| Self {
            items,
            wrong,
            examiner: self.examiner,
            parts: self.parts.clone(),
            scope: self.scope,
            scales: self.scales.clone(),
            unit: self.unit.clone(),
            free: self.free,
            judged: self.judged,
            slips: Arc::clone(&self.slips),
            mistaken: Arc::clone(&self.mistaken),
        })
    }

    /// The same evidence of some of the wrong answers, by their numbers; none if there are none.
    pub fn only(&self, some: &[usize]) -> Option<Self> {
        let items = self.items.iter().enumerate();
        let kept = items.filter(|(i, item)| item.right || some.contains(i));
        self.keeping(kept.map(|(_, item)| item.clone()).collect())
    }

    /// The same evidence without the wrong answers that an explanation gives; none if it gives all.
    pub fn without(&self, explained: &[Option<Vec<f64>>]) -> Option<Self> {
        let is_left = |(i, item): &(usize, &Item)| {
            let gives = |answer: &Vec<f64>| self.explains(*i, answer);
            item.right || !explained[*i].as_ref().is_some_and(gives)
        };
        let items = self.items.iter().enumerate().filter(is_left);
        self.keeping(items.map(|(_, item)| item.clone()).collect())
    }

    /// The same evidence of questions that are soon gone through, step by step; none if no wrong answer is among them.
    pub fn of_short(&self) -> Option<Self> {
        /// Numbers of a question.
        const SHORT: usize = 400;
        let is_short = |item: &&Item| item.question.len() <= SHORT;
        self.keeping(self.items.iter().filter(is_short).cloned().collect())
    }

    /// Whether right answers are the reference's own, as those of a method that goes the same way: then wrong ones are those of a
    /// mistake to the last digits, or not its own at all.
    pub fn goes_the_same_way(&self) -> bool {
        self.goes_as(|item| Some(item.golden().to_vec()))
    }

    /// Whether any right answer tells more than yes or no: an empty list is empty by whatever method.
    pub fn right_ones_tell(&self) -> bool {
        let mut right = self.items[self.wrong..].iter();
        right.any(|item| item.tells >= 1.0)
    }

    /// Whether any wrong answer is wrong by itself, and not beside the others only.
    pub fn are_wrong_by_themselves(&self) -> bool {
        let mut wrong = self.items[..self.wrong].iter();
        wrong.any(|item| !self.is_right(item, &item.got))
    }

    /// Whether most right answers are the same as these. Where some tell more than yes or no, only those count: an empty list is
    /// empty by whatever method.
    pub fn goes_as(&self, answer: impl Fn(&Item) -> Option<Vec<f64>>) -> bool {
        let right = || self.items[self.wrong..].iter();
        let any_tells = self.right_ones_tell();
        let counted = || right().filter(|item| !any_tells || item.tells >= 1.0);
        let is_same = |item: &&Item| {
            let answer = answer(item);
            answer.is_some_and(|one| self.alike(item, &self.canonical(&item.question, &one)))
        };
        2 * counted().filter(is_same).count() > counted().count()
    }

    /// The wrong items that tell most, of those that tell as much random ones first; none if nothing is wrong. Cases with names have small
    /// and round numbers, which tell little, and which rounding decides.
    pub fn probe(&self, most: usize) -> Option<Self> {
        let mut wrong = self.items[..self.wrong].to_vec();
        wrong.sort_by(|a, b| {
            b.tells
                .total_cmp(&a.tells)
                .then(b.is_random.cmp(&a.is_random))
        });
        wrong.truncate(most);
        self.keeping(wrong)
    }

    /// Whether all wrong answers are the same, and tell nothing more than yes or no.
    pub fn is_one_answer(&self) -> bool {
        let wrong = &self.items[..self.wrong];
        let is_first = |item: &Item| item.got == wrong[0].got && item.tells < 1.0;
        wrong.iter().all(is_first)
    }

    /// How much the wrong answers tell together.
    pub fn tells_in_all(&self) -> f64 {
        self.items[..self.wrong].iter().map(|item| item.tells).sum()
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
}
