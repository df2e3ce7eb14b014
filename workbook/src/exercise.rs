//! An exercise: one function of the library, asked many times.

use crate::row::{self, Row, RowError};

/// One function that a student writes.
pub trait Exercise: Sync {
    /// What it is given.
    type Question: Row;
    /// What it returns.
    type Answer: Row;
    /// Its name: the grade key, and the anchor around the function in the library.
    const NAME: &'static str;
    /// What to do, in a sentence; also the comment above the student's stub.
    const TASK: &'static str;
    /// What an answer that is a single value is called.
    const ANSWER: &'static str = "answer";

    /// Calls the library's function; in a student's copy of the library, the student's.
    fn answer(question: &Self::Question) -> Self::Answer;
}

/// An exercise whose types are forgotten: questions and answers are lines.
pub trait Asked: Sync {
    /// Its name.
    fn name(&self) -> &'static str;

    /// What to do.
    fn task(&self) -> &'static str;

    /// The names of a question's words.
    fn question_names(&self) -> Vec<String>;

    /// The names of an answer's words.
    fn answer_names(&self) -> Vec<String>;

    /// Answers a question.
    ///
    /// # Errors
    /// If the line is not a question of this exercise.
    fn answer_line(&self, question: &str) -> Result<String, RowError>;
}

impl<E: Exercise> Asked for E {
    fn name(&self) -> &'static str {
        E::NAME
    }

    fn task(&self) -> &'static str {
        E::TASK
    }

    fn question_names(&self) -> Vec<String> {
        E::Question::names("question")
    }

    fn answer_names(&self) -> Vec<String> {
        E::Answer::names(E::ANSWER)
    }

    fn answer_line(&self, question: &str) -> Result<String, RowError> {
        Ok(E::answer(&row::read(question, "question")?).write())
    }
}
