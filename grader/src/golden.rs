//! Golden files: the named cases of an exercise, which people write, and the random ones, which `raybook bless` appends.
//!
//! `golden/<chapter>/<exercise>.txt` has a line per case: `name | question = answer = another that is right too`. A named case
//! may be written without an answer: the answer is the reference's, the others are the file's.

use crate::contradiction::Questions;
use crate::examine::{Cases, CasesError, Examiner, visible_rng};
use raybook_workbook::curriculum;
use raybook_workbook::exercise::Asked;
use raybook_workbook::row::{self, RowError};
use std::collections::BTreeSet;
use std::fmt::Write;

/// What stands between the name of a case and its question.
const BAR: &str = " | ";

/// How the name of a random case begins.
pub const RANDOM: &str = "random ";

/// A case that a person has written.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// What is special about it.
    pub name: String,
    /// The numbers of the question.
    pub question: Vec<f64>,
    /// Answers that are as right as the reference's.
    pub also_right: Vec<String>,
}

/// What is wrong with a golden file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}, column {column}: {what}")]
pub struct GoldenError {
    /// The line, from 1.
    pub line: usize,
    /// The character in it, from 1.
    pub column: usize,
    /// What is wrong, what was expected, and what to do.
    pub what: String,
}

/// The named cases of a golden file; its random ones are left out.
///
/// # Errors
/// If a line is not a name and a question of this exercise, with answers to it.
pub fn named(asked: &Asked, text: &str) -> Result<Vec<Named>, GoldenError> {
    named_of(asked, text, &|_| Ok(()))
}

/// The exercise with another golden file.
///
/// # Errors
/// If a named case cannot be read, or contradicts what the exercise says of its questions.
pub fn replaced(examiner: &dyn Examiner, text: String) -> Result<Box<dyn Examiner>, GoldenError> {
    admitted(examiner, &text)?;
    Ok(examiner.with_golden(text))
}

/// The named cases of a golden file of the exercise, which contradict nothing that it says of its questions.
///
/// # Errors
/// If one cannot be read, or does.
pub fn admitted(examiner: &dyn Examiner, text: &str) -> Result<Vec<Named>, GoldenError> {
    let questions = Questions::of(examiner);
    named_of(examiner.asked(), text, &|question| {
        questions.admit(question)
    })
}

/// Whether a question is admitted; if not, the word that is wrong, from 1, and why.
type Admit<'a> = &'a dyn Fn(&[f64]) -> Result<(), (usize, String)>;

fn named_of(asked: &Asked, text: &str, admit: Admit<'_>) -> Result<Vec<Named>, GoldenError> {
    let mut named = Vec::new();
    let mut names = BTreeSet::new();
    for (line, number) in text.lines().zip(1..) {
        if line.trim().is_empty() || line.starts_with('#') || is_random(line) {
            continue;
        }
        let case = case(asked, line, admit).map_err(|(at, what)| GoldenError {
            line: number,
            column: 1 + line[..at].chars().count(),
            what,
        })?;
        if !names.insert(case.name.clone()) {
            return Err(GoldenError {
                line: number,
                column: 1,
                what: format!(
                    "there is a case {:?} above; give this one another name",
                    case.name
                ),
            });
        }
        named.push(case);
    }
    Ok(named)
}

/// Whether a line is a random case: `random 7 | …`.
fn is_random(line: &str) -> bool {
    let number = line
        .split_once(BAR)
        .and_then(|(name, _)| name.strip_prefix(RANDOM));
    number.is_some_and(|number| number.trim().parse::<u32>().is_ok())
}

/// The case of a line, or the place in the line where it is wrong, and what is wrong.
fn case(asked: &Asked, line: &str, admit: Admit<'_>) -> Result<Named, (usize, String)> {
    let Some((name, rest)) = line.split_once(BAR) else {
        let what =
            "there is no ` | `; a case is written `name | question`, or `name | question = answer`";
        return Err((0, what.to_owned()));
    };
    let from = name.len() + BAR.len();
    let name = name.trim();
    if name.is_empty() || name.starts_with(RANDOM) {
        let what = format!(
            "a case cannot be called {name:?}: names that begin with `random ` are those of the cases that `raybook bless` makes; say what is special about this one"
        );
        return Err((0, what));
    }
    let mut places = vec![];
    let mut at = from;
    for part in rest.split(" = ") {
        places.push((at, part));
        at += part.len() + " = ".len();
    }
    let (at, words) = places[0];
    let names = |names: Vec<String>| names.join(" ");
    let question = asked.read_question(words).map_err(|e| {
        let expected = names(asked.question_names());
        wrong(at, words, "question", &e, &expected)
    })?;
    admit(&question).map_err(|(word, what)| {
        let what = format!("in the question, {what}");
        (at + column(words, word), what)
    })?;
    let mut answers = Vec::new();
    for &(at, answer) in &places[1..] {
        let numbers = asked.read_answer(answer).map_err(|e| {
            let expected = names(asked.answer_names());
            wrong(at, answer, "answer", &e, &expected)
        })?;
        answers.push(row::format(asked.answer.kind, &numbers));
    }
    Ok(Named {
        name: name.to_owned(),
        question,
        also_right: answers.split_off(answers.len().min(1)),
    })
}

/// What is wrong with a row at a place of a line, and where in the line.
fn wrong(at: usize, row: &str, what: &str, error: &RowError, expected: &str) -> (usize, String) {
    let what = format!("in the {what}, {error}; the words of {what}s are: {expected}");
    (at + column(row, error.place()), what)
}

/// Where a word of a row begins, or the row ends.
fn column(row: &str, word: usize) -> usize {
    let word = row.split_whitespace().nth(word - 1);
    word.map_or(row.trim_end().len(), |word| {
        word.as_ptr() as usize - row.as_ptr() as usize
    })
}

/// An exercise's file below `golden/`.
pub fn path(exercise: &str) -> String {
    let chapter = curriculum::of_exercise(exercise);
    let file = format!("{exercise}.txt");
    chapter.map_or(file.clone(), |chapter| format!("{}/{file}", chapter.name))
}

/// The text of an exercise's golden file, and the cases in it.
///
/// # Errors
/// If a named case cannot be read, or the reference has no answer.
pub fn page(examiner: &dyn Examiner) -> Result<(String, Cases), CasesError> {
    let asked = examiner.asked();
    let cases = examiner.try_cases(&mut visible_rng(asked.name))?;
    let lengths = cases.cases.iter().map(|case| case.name.chars().count());
    let widest = lengths.max().unwrap_or(0);
    let mut text = format!("# {}: {}\n", asked.name, asked.task);
    let _ = writeln!(text, "# asked:    {}", asked.question_names().join(" "));
    let _ = writeln!(text, "# answered: {}", asked.answer_names().join(" "));
    let _ = writeln!(
        text,
        "# Each line: name | question = answer (= another that is right too). People write the named cases, of which `name | question` is enough; `raybook bless` writes the rest."
    );
    for case in &cases.cases {
        let answers = case.answers.join(" = ");
        let _ = writeln!(
            text,
            "{:widest$} | {} = {answers}",
            case.name, case.question
        );
    }
    Ok((text, cases))
}
