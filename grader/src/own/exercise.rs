//! An own exercise, examined like those of the course.

use super::declaration::Declaration;
use super::draw::draw;
use super::judge::compare;
use super::reference::Reference;
use crate::diagnose::misread::Limits;
use crate::examine::Examiner;
use crate::picture::triple::PictureSize;
use crate::together::Bounds;
use crate::{Flaw, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::Kind;
use raybook_workbook::row::{Numbers, format};

/// An exercise of an instructor's own.
pub(super) struct OwnExercise {
    /// What it asks.
    pub declaration: Declaration,
    /// The text of its cases.
    pub cases: String,
    /// The program that knows the answers.
    pub reference: &'static Reference,
}

impl Examiner for OwnExercise {
    fn asked(&self) -> &'static Asked {
        self.declaration.asked
    }

    fn golden(&self) -> &str {
        &self.cases
    }

    fn with_golden(&self, text: String) -> Box<dyn Examiner> {
        Box::new(Self {
            declaration: self.declaration,
            cases: text,
            reference: self.reference,
        })
    }

    fn random(&self, rng: &mut Pcg) -> Vec<f64> {
        let mut numbers = Vec::new();
        if let Kind::Record(record) = self.asked().question {
            for (field, range) in record.fields.iter().zip(self.declaration.ranges) {
                draw(field.kind, *range, rng, &mut numbers);
            }
        }
        numbers
    }

    fn reference(&self, question: &[f64]) -> Result<Vec<f64>, String> {
        let asked = self.asked();
        let question = format(asked.question, question);
        let answer = self.reference.answer(asked.name, &question)?;
        let read = asked.read_answer(&answer);
        read.map_err(|error| {
            format!(
                "{}: the reference's answer to `{question}` cannot be read: {error}",
                asked.name
            )
        })
    }

    fn compare(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict {
        let asked = self.asked();
        let answer = &asked.answer;
        if self.declaration.judges {
            let question = format(asked.question, question);
            let [golden, got] = [golden, got].map(|numbers| format(answer.kind, numbers));
            return self.reference.judge(asked.name, [&question, &golden, &got]);
        }
        let [mut golden, mut got] = [golden, got].map(Numbers::of);
        let tolerance = self.declaration.tolerance;
        compare(answer.kind, answer.name, tolerance, &mut golden, &mut got)
    }

    fn trouble(&self) -> Option<String> {
        self.reference.trouble()
    }

    fn compare_together(&self, _: &[(Vec<f64>, Vec<f64>)], _: Bounds) -> Verdict {
        Ok(())
    }

    fn mistake(&self, _: usize) -> Option<(&'static str, &'static str)> {
        None
    }

    fn mistake_answers(&self, _: usize, _: &[f64]) -> Option<Vec<f64>> {
        None
    }

    fn canonical(&self, _: &[f64], answer: &[f64]) -> Vec<f64> {
        answer.to_vec()
    }

    fn flaws(&self) -> &'static [Flaw] {
        &[]
    }

    /// Questions are not moved: what a jump of the answer is, only the instructor knows.
    fn ulps(&self) -> i32 {
        0
    }

    fn alike(&self) -> f32 {
        self.declaration.tolerance
    }

    fn traits(&self, _: &[f64], _: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    fn limits(&self) -> Limits {
        Limits {
            positive: &[],
            fixed: &[],
            effort: usize::MAX, // nobody knows
        }
    }

    /// What the fields of a question owe each other, only the instructor knows: so no question is made simpler.
    fn is_sound(&self, _: &[f64]) -> bool {
        false
    }

    fn picture(&self, _: usize) -> Option<PictureSize> {
        None
    }

    fn pixel(&self, _: usize, _: u32, _: u32) -> Option<Vec<f64>> {
        None
    }

    fn colour(&self, _: usize, _: &[f64], _: &[f64]) -> Option<Rgb> {
        None
    }
}
