//! What can be said of questions and answers as lines.

use super::{Examiner, visible_rng};
use crate::finite::finite;
use crate::picture::triple::PictureSize;
use crate::together::Bounds;
use crate::{Verdict, stable};
use raybook_workbook::row::{self, RowError};

impl dyn Examiner + '_ {
    /// The exercise's name.
    pub fn name(&self) -> &'static str {
        self.asked().name
    }

    /// What to do.
    pub fn task(&self) -> &'static str {
        self.asked().task
    }

    /// The reference's answer to a question.
    ///
    /// # Errors
    /// If the line is not a question of this exercise.
    pub fn answer_line(&self, question: &str) -> Result<String, RowError> {
        self.asked().answer_line(question)
    }

    /// Judges an answer against the right ones; being any of them is enough.
    ///
    /// # Errors
    /// Why it is wrong, or that it cannot be read.
    pub fn judge(&self, question: &str, answers: &[String], got: &str) -> Verdict {
        let read = |answer: &str| {
            let numbers = self.asked().read_answer(answer);
            numbers.map_err(|e| match answer.trim() {
                "none" => "there is always an answer here, but yours is none: does the function end without `return`?".to_owned(),
                _ => format!(
                    "the answer cannot be read: {e}; an answer here is {}, in this order",
                    self.asked().answer_names().join(" ")
                ),
            })
        };
        let question = self.asked().read_question(question);
        let question = question.map_err(|e| e.to_string())?;
        let got = read(got)?;
        let none = "there is no right answer to compare with".to_owned();
        let mut verdict = Err((none, None));
        for golden in answers.iter().rev() {
            let golden = read(golden)?;
            verdict = self
                .verdict(&question, &golden, &got)
                .map_err(|why| (why, Some(golden)));
            if verdict.is_ok() {
                break;
            }
        }
        verdict.map_err(|(why, golden)| match golden {
            Some(golden) => self.complaint(&question, &golden, &got, why),
            None => why,
        })
    }

    /// A question as the line that a program is asked.
    pub(crate) fn line(&self, question: &[f64]) -> String {
        let asked = self.asked();
        format!("{} {}", asked.name, row::format(asked.question, question))
    }

    /// Whether an answer is right: the verdict of [`Self::judge`], with nothing in words.
    pub(crate) fn is_right(&self, question: &[f64], got: &[f64]) -> bool {
        let golden = self.reference(question);
        golden.is_ok_and(|golden| self.verdict(question, &golden, got).is_ok())
    }

    /// The same of an answer in words.
    pub(crate) fn is_right_line(&self, question: &[f64], got: &str) -> bool {
        let got = self.asked().read_answer(got);
        got.is_ok_and(|got| self.is_right(question, &got))
    }

    /// Judges an answer against a right one.
    ///
    /// # Errors
    /// Why it is wrong.
    pub fn verdict(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict {
        self.compare(question, golden, got)?;
        finite(&self.asked().answer, golden, got)
    }

    /// Judges all answers together that are right one by one.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn judge_together<'a>(&self, answers: impl Iterator<Item = (&'a str, &'a str)>) -> Verdict {
        self.compare_together(&self.rows(answers), Bounds::CHANCE)
    }

    /// Questions and answers as numbers, of those that can be read.
    pub(crate) fn rows<'a>(
        &self,
        answers: impl Iterator<Item = (&'a str, &'a str)>,
    ) -> Vec<(Vec<f64>, Vec<f64>)> {
        let asked = self.asked();
        let read = |(question, answer)| {
            Some((
                asked.read_question(question).ok()?,
                asked.read_answer(answer).ok()?,
            ))
        };
        answers.filter_map(read).collect()
    }

    /// The mistakes' names and hints.
    pub fn mistakes(&self) -> Vec<(&'static str, &'static str)> {
        (0..).map_while(|i| self.mistake(i)).collect()
    }

    /// The number of the mistake that is called so.
    pub fn mistake_called(&self, name: &str) -> Option<usize> {
        let mut all = self.mistakes().into_iter();
        all.position(|(own, _)| own == name)
    }

    /// What mistake number i answers; `None` if the question cannot be read.
    pub fn mistaken(&self, i: usize, question: &str) -> Option<String> {
        let question = self.asked().read_question(question).ok()?;
        let answer = self.mistake_answers(i, &question)?;
        Some(row::format(self.asked().answer.kind, &answer))
    }

    /// The parts of a question, by name.
    pub fn question_parts(&self, question: &str) -> Vec<(String, String)> {
        let asked = self.asked();
        let numbers = asked.read_question(question);
        numbers.map_or_else(
            |_| Vec::new(),
            |numbers| row::parts(asked.question, "question", &numbers),
        )
    }

    /// The parts of an answer, by name; the words themselves if it cannot be read.
    pub fn answer_parts(&self, answer: &str) -> Vec<(String, String)> {
        let asked = self.asked();
        let name = asked.answer.name;
        let numbers = asked.read_answer(answer);
        numbers.map_or_else(
            |_| vec![(name.to_owned(), answer.to_owned())],
            |numbers| row::parts(asked.answer.kind, name, &numbers),
        )
    }

    /// Whether the answer stays right when the question's numbers move in their last digits.
    pub fn is_fair(&self, question: &[f64]) -> bool {
        stable::is_stable(self, question, &mut visible_rng(self.name()))
    }

    /// The pictures that answers make, if any.
    pub fn pictures(&self) -> Vec<PictureSize> {
        (0..).map_while(|i| self.picture(i)).collect()
    }

    /// The question of a pixel of picture number i, in numbers.
    pub fn pixel_numbers(&self, i: usize, x: u32, y: u32) -> Vec<f64> {
        // A zero without a sign: people read it, and no picture depends on it.
        let question = self.pixel(i, x, y).unwrap_or_default();
        question.into_iter().map(|v| v + 0.0).collect()
    }

    /// The question of a pixel of picture number i, as a line.
    pub fn pixel_question(&self, i: usize, x: u32, y: u32) -> String {
        row::format(self.asked().question, &self.pixel_numbers(i, x, y))
    }
}
