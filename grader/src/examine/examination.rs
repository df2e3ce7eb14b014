//! An exercise of the course, examined by what is declared with it.

use super::Examiner;
use crate::diagnose::misread::Limits;
use crate::picture::triple::PictureSize;
use crate::together::Bounds;
use crate::upon::upon;
use crate::{Flaw, Graded, Mistake, Picture, Verdict};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Asked;
use raybook_workbook::row::{from_numbers, to_numbers};
use std::borrow::Cow;
use std::marker::PhantomData;

/// The examiner of an exercise, with the text of its golden file.
pub(crate) struct Examination<E> {
    golden: Cow<'static, str>,
    exercise: PhantomData<E>,
}

impl<E> Examination<E> {
    /// The examiner with the golden file that the command carries with it.
    pub(crate) const fn new(golden: &'static str) -> Self {
        Self {
            golden: Cow::Borrowed(golden),
            exercise: PhantomData,
        }
    }
}

impl<E: Graded> Examiner for Examination<E> {
    fn asked(&self) -> &'static Asked {
        const { &Asked::of::<E>() }
    }

    fn golden(&self) -> &str {
        &self.golden
    }

    fn with_golden(&self, text: String) -> Box<dyn Examiner> {
        Box::new(Self {
            golden: Cow::Owned(text),
            exercise: PhantomData,
        })
    }

    fn random(&self, rng: &mut Pcg) -> Vec<f64> {
        to_numbers(&E::random(rng))
    }

    fn right(&self, question: &[f64]) -> Vec<f64> {
        to_numbers(&from_numbers::<E>(question).right())
    }

    fn compare(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict {
        E::judge(
            &from_numbers(question),
            &from_numbers(golden),
            &from_numbers(got),
        )
    }

    fn complaint(&self, question: &[f64], golden: &[f64], got: &[f64], why: String) -> String {
        E::complaint(
            &from_numbers(question),
            &from_numbers(golden),
            &from_numbers(got),
            why,
        )
    }

    fn compare_together(&self, answers: &[(Vec<f64>, Vec<f64>)], bounds: Bounds) -> Verdict {
        let rows = answers.iter();
        let answers: Vec<_> = rows
            .map(|(question, got)| (from_numbers(question), from_numbers(got)))
            .collect();
        E::together(&answers, bounds)
    }

    fn further(&self, rng: &mut Pcg) -> Vec<Vec<f64>> {
        E::further(rng).iter().map(to_numbers).collect()
    }

    fn relations(&self, question: &[f64]) -> Vec<(&'static str, Vec<f64>)> {
        let question = from_numbers::<E>(question);
        let relations = E::RELATIONS.iter();
        relations
            .map(|one| (one.name, to_numbers(&(one.question)(&question))))
            .collect()
    }

    fn crowded(&self, rng: &mut Pcg, count: usize) -> Option<Vec<f64>> {
        E::crowded(rng, count).map(|question| to_numbers(&question))
    }

    fn mistake(&self, i: usize) -> Option<(&'static str, &'static str)> {
        let Mistake { name, hint, .. } = E::MISTAKES.get(i)?;
        Some((name, hint))
    }

    fn mistake_answers(&self, i: usize, question: &[f64]) -> Option<Vec<f64>> {
        let answer = E::MISTAKES.get(i)?.answer;
        Some(to_numbers(&answer(&from_numbers(question))))
    }

    fn mistakes_answer(
        &self,
        first: usize,
        second: usize,
        question: &[f64],
    ) -> Option<(Vec<f64>, bool)> {
        let [first, second] = [first, second].map(|i| E::MISTAKES.get(i));
        let (answer, is_asked) = upon(first?, second?, &from_numbers(question));
        Some((to_numbers(&answer), is_asked))
    }

    fn canonical(&self, question: &[f64], answer: &[f64]) -> Vec<f64> {
        to_numbers(&E::canonical(&from_numbers(question), from_numbers(answer)))
    }

    fn allows(&self) -> &'static str {
        E::ALLOWS
    }

    fn flaws(&self) -> &'static [Flaw] {
        E::FLAWS
    }

    fn ulps(&self) -> i32 {
        E::ULPS
    }

    fn alike(&self) -> f32 {
        E::ALIKE
    }

    fn traits(&self, question: &[f64], answer: &[f64]) -> Vec<f64> {
        E::traits(&from_numbers(question), &from_numbers(answer))
    }

    fn limits(&self) -> Limits {
        Limits {
            positive: E::POSITIVE,
            fixed: E::FIXED,
            effort: E::EFFORT,
        }
    }

    fn is_sound(&self, question: &[f64]) -> bool {
        E::is_sound(&from_numbers(question))
    }

    fn picture(&self, i: usize) -> Option<PictureSize> {
        let picture: &Picture<E> = E::PICTURES.get(i)?;
        Some(PictureSize {
            name: picture.name,
            width: picture.width,
            height: picture.height,
            alt: picture.alt,
        })
    }

    fn pixel(&self, i: usize, x: u32, y: u32) -> Option<Vec<f64>> {
        Some(to_numbers(&(E::PICTURES.get(i)?.question)(x, y)))
    }

    fn colour(&self, i: usize, question: &[f64], answer: &[f64]) -> Option<Rgb> {
        let colour = E::PICTURES.get(i)?.colour;
        Some(colour(&from_numbers(question), &from_numbers(answer)))
    }
}
