//! A student's functions, called by asking the program that has them; or the course's own.

use super::PARTS;
use crate::ask::{Asker, Said};
use crate::cases;
use crate::check::{Mark, judge};
use crate::converse::{Limits, Program};
use crate::golden::Named;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use raybook_workbook::exercise::Exercise;
use raybook_workbook::row;
use std::io;

/// The functions of a program, or of the course.
pub struct Functions<'a> {
    /// Asks the program. Without one, the course answers.
    asker: Option<Asker<'a>>,
    written: Vec<&'static str>,
    /// Those that are written, and answer a named case wrongly.
    wrong: Vec<&'static str>,
    /// Those that are written, but gave no answer to the first question, and why.
    silent: Vec<(&'static str, String)>,
    /// How many questions had no answer that can be read.
    pub unanswered: usize,
}

impl<'a> Functions<'a> {
    /// Those that are written: each is asked its first named case, and answers. Then it is asked the others, for one may be wrong.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn of(program: &'a Program, limits: Limits) -> io::Result<Self> {
        let mut asker = Asker::new(program, limits);
        let (mut written, mut wrong, mut silent) = (Vec::new(), Vec::new(), Vec::new());
        for examiner in PARTS.iter().filter_map(|part| cases::find(part.exercise)) {
            let name = examiner.name();
            // A golden file that is broken is told by a check.
            let named = examiner.named().unwrap_or_default();
            let case = |named: &Named| {
                let mut case = examiner.case(&named.name, &named.question).ok()?;
                case.answers.extend(named.also_right.iter().cloned());
                Some((examiner.line(&named.question), case))
            };
            let (lines, cases): (Vec<_>, Vec<_>) = named.iter().filter_map(case).unzip();
            let (first, others) = lines.split_at(lines.len().min(1));
            let mut replies = asker.ask(first)?;
            for reply in &replies {
                match (&reply.said, reply.said.why_none()) {
                    (Said::Todo(_), _) => {}
                    (_, None) => written.push(name),
                    (said, Some(why)) => silent.push((name, why + said.help())),
                }
            }
            if written.last() == Some(&name) {
                replies.extend(asker.ask(others)?);
                let mut both = cases.iter().zip(&replies);
                if both.any(|(case, reply)| judge(examiner, case, &reply.said) != Mark::Right) {
                    wrong.push(name);
                }
            }
        }
        Ok(Self {
            asker: Some(asker),
            written,
            wrong,
            silent,
            unanswered: 0,
        })
    }

    /// The course's own: those of the chapters up to this number.
    pub fn of_course(last: u32) -> Self {
        let chapters = CHAPTERS.iter().filter(|chapter| chapter.number() <= last);
        let exercises = chapters.flat_map(Chapter::exercises);
        Self {
            asker: None,
            written: exercises.map(|asked| asked.name).collect(),
            wrong: Vec::new(),
            silent: Vec::new(),
            unanswered: 0,
        }
    }

    /// Whether an exercise of this name is written.
    pub fn are_there(&self, exercise: &str) -> bool {
        self.written.contains(&exercise)
    }

    /// Whether an exercise of this name answers a named case wrongly.
    pub fn is_wrong(&self, exercise: &str) -> bool {
        self.wrong.contains(&exercise)
    }

    /// Why an exercise of this name, which is written, gave no answer.
    pub fn why_silent(&self, exercise: &str) -> Option<&str> {
        let (_, why) = self.silent.iter().find(|(name, _)| *name == exercise)?;
        Some(why)
    }

    /// Whether an exercise is written.
    pub fn has<E: Exercise>(&self) -> bool {
        self.are_there(E::NAME)
    }

    /// The answers to questions of one exercise; none where no answer can be read.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn ask<E: Exercise>(&mut self, questions: &[E]) -> io::Result<Vec<Option<E::Answer>>> {
        let Some(asker) = &mut self.asker else {
            return Ok(questions.iter().map(|q| Some(q.answer())).collect());
        };
        let line = |question: &E| {
            let numbers = row::to_numbers(question);
            format!("{} {}", E::NAME, row::format(E::KIND, &numbers))
        };
        let lines: Vec<_> = questions.iter().map(line).collect();
        asker.next_exercise();
        let replies = asker.ask_many(&lines)?.into_iter();
        let answers = replies.map(|reply| match reply.said {
            Said::Answer(answer) => row::read(answer.unescaped(), E::ANSWER.name).ok(),
            _ => None,
        });
        let answers: Vec<_> = answers.collect();
        self.unanswered += answers.iter().filter(|answer| answer.is_none()).count();
        Ok(answers)
    }

    /// The same; the course answers what is not written, or has no answer that can be read.
    ///
    /// # Errors
    /// If the program cannot be started.
    pub fn ask_or_answer<E: Exercise>(&mut self, questions: &[E]) -> io::Result<Vec<E::Answer>> {
        let answers = if self.has::<E>() {
            self.ask(questions)?
        } else {
            questions.iter().map(|_| None).collect()
        };
        let both = answers.into_iter().zip(questions);
        Ok(both
            .map(|(answer, question)| answer.unwrap_or_else(|| question.answer()))
            .collect())
    }
}
