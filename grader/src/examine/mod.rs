//! What can be asked of a graded exercise: its questions, its judge, its mistakes and its pictures.

mod cases;
mod examination;
mod lines;

use crate::diagnose::misread::Limits;
use crate::picture::triple::PictureSize;
use crate::together::Bounds;
use crate::{Flaw, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Asked;

pub use cases::{Case, Cases, CasesError, RANDOM_CASES, visible_rng};
pub(crate) use examination::Examination;

/// A graded exercise whose types are forgotten: questions and answers are rows of numbers. What can be said of lines is a method
/// of `dyn Examiner`.
pub trait Examiner: Sync {
    /// The exercise.
    fn asked(&self) -> &'static Asked;

    /// The text of its golden file.
    fn golden(&self) -> &str;

    /// The same exercise with the text of another golden file.
    fn with_golden(&self, text: String) -> Box<dyn Examiner>;

    /// An ordinary question.
    fn random(&self, rng: &mut Pcg) -> Vec<f64>;

    /// The right answer to a question.
    ///
    /// # Errors
    /// Why there is none. What is compiled in always answers.
    fn reference(&self, question: &[f64]) -> Result<Vec<f64>, String> {
        Ok((self.asked().call)(question))
    }

    /// See [`right`](crate::Graded::right).
    fn right(&self, question: &[f64]) -> Vec<f64> {
        (self.asked().call)(question)
    }

    /// Compares an answer with the golden one.
    ///
    /// # Errors
    /// Why it is wrong.
    fn compare(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict;

    /// See [`complaint`](crate::Graded::complaint).
    fn complaint(&self, _question: &[f64], _golden: &[f64], _got: &[f64], why: String) -> String {
        why
    }

    /// What kept the judge from a verdict on this thread, and is no fault of an answer; told once.
    fn trouble(&self) -> Option<String> {
        None
    }

    /// See [`together`](crate::Graded::together); each question with its answer.
    ///
    /// # Errors
    /// What is wrong with them.
    fn compare_together(&self, answers: &[(Vec<f64>, Vec<f64>)], bounds: Bounds) -> Verdict;

    /// See [`further`](crate::Graded::further).
    fn further(&self, _rng: &mut Pcg) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// What is done to a question by each of the [`RELATIONS`](crate::Graded::RELATIONS), and the question that it makes.
    fn relations(&self, _question: &[f64]) -> Vec<(&'static str, Vec<f64>)> {
        Vec::new()
    }

    /// See [`crowded`](crate::Graded::crowded).
    fn crowded(&self, _rng: &mut Pcg, _count: usize) -> Option<Vec<f64>> {
        None
    }

    /// The name and the hint of mistake number i.
    fn mistake(&self, i: usize) -> Option<(&'static str, &'static str)>;

    /// What mistake number i answers.
    fn mistake_answers(&self, i: usize, question: &[f64]) -> Option<Vec<f64>>;

    /// What is answered by one who makes mistake number `first` upon mistake number `second`, and whether the first is made of anything that
    /// the second changes.
    fn mistakes_answer(
        &self,
        _first: usize,
        _second: usize,
        _question: &[f64],
    ) -> Option<(Vec<f64>, bool)> {
        None
    }

    /// See [`canonical`](crate::Graded::canonical).
    fn canonical(&self, question: &[f64], answer: &[f64]) -> Vec<f64>;

    /// See [`ALLOWS`](crate::Graded::ALLOWS).
    fn allows(&self) -> &'static str {
        ""
    }

    /// See [`FLAWS`](crate::Graded::FLAWS).
    fn flaws(&self) -> &'static [Flaw];

    /// See [`ULPS`](crate::Graded::ULPS).
    fn ulps(&self) -> i32;

    /// See [`ALIKE`](crate::Graded::ALIKE).
    fn alike(&self) -> f32;

    /// See [`traits`](crate::Graded::traits).
    fn traits(&self, question: &[f64], answer: &[f64]) -> Vec<f64>;

    /// See [`POSITIVE`](crate::Graded::POSITIVE), [`FIXED`](crate::Graded::FIXED) and [`EFFORT`](crate::Graded::EFFORT).
    fn limits(&self) -> Limits;

    /// See [`is_sound`](crate::Graded::is_sound).
    fn is_sound(&self, question: &[f64]) -> bool;

    /// Picture number i that answers make.
    fn picture(&self, i: usize) -> Option<PictureSize>;

    /// The question of a pixel of picture number i.
    fn pixel(&self, i: usize, x: u32, y: u32) -> Option<Vec<f64>>;

    /// The colour of a pixel's answer in picture number i.
    fn colour(&self, i: usize, question: &[f64], answer: &[f64]) -> Option<Rgb>;
}
