//! The smallest wrong question: a wrong case is asked again with rounder numbers and shorter lists, as long as the answer stays wrong.
//!
//! Each change is kept only if the new question is one of those that the exercise asks, its right answer does not hang on the last
//! digits of its numbers, and the program answers it wrong too (delta debugging: Zeller and Hildebrandt 2002). The same program is
//! led to the same question each time.

pub mod domain;
mod simpler;

use crate::ask::{Reply, Said};
use crate::attempt::attempt;
use crate::check::{Mark, Outcome, judge};
use crate::diagnose::search::called;
use crate::examine::{Case, Examiner};
use domain::Domain;
use raybook_workbook::kind::Kind;
use raybook_workbook::row;
use simpler::{Site, sites};
use std::io;
use std::time::{Duration, Instant};

/// The maximum number of questions that are asked on the way.
const QUESTIONS: usize = 200;

/// A question with more numbers than these is one of many elements, which are all needed.
const MANY: usize = 500;

/// The maximum time on the way: it is there for slow programs, others are done long before.
const TIME: Duration = Duration::from_secs(5);

/// Asks a program questions, each with the exercise's name before it.
pub type Ask<'a> = dyn FnMut(&[String]) -> io::Result<Vec<Reply>> + 'a;

/// A wrong case, made as small as it can be while its answer stays wrong, and stays that of the mistake of this number if there is one;
/// none if it is that already, or has no answer.
///
/// # Errors
/// If the program cannot be asked.
pub fn smallest(
    ask: &mut Ask<'_>,
    examiner: &dyn Examiner,
    outcome: &Outcome,
    mistake: Option<usize>,
) -> io::Result<Option<Outcome>> {
    let Some(mut search) = Search::new(examiner, outcome, mistake) else {
        return Ok(None);
    };
    search.run(ask)?;
    let mut smallest = search.smallest;
    let found = smallest != *outcome;
    smallest.case.name += ", made simpler while it stays wrong";
    Ok(found.then_some(smallest))
}

/// The search for the smallest wrong question.
struct Search<'a> {
    examiner: &'a dyn Examiner,
    domain: Domain<'a>,
    /// The number of the mistake that explains the case.
    mistake: Option<usize>,
    /// The smallest wrong case that was found, and its question's numbers.
    smallest: Outcome,
    question: Vec<f64>,
    /// How many questions may still be asked, and until when.
    left: usize,
    until: Instant,
}

impl<'a> Search<'a> {
    /// Begins with a wrong case; none if there was no answer to it that can be read, or the question is one of many elements.
    fn new(examiner: &'a dyn Examiner, outcome: &Outcome, mistake: Option<usize>) -> Option<Self> {
        let Said::Answer(answer) = &outcome.reply.said else {
            return None;
        };
        examiner.asked().read_answer(answer.unescaped()).ok()?;
        let question = examiner
            .asked()
            .read_question(&outcome.case.question)
            .ok()
            .filter(|question| question.len() <= MANY)?;
        Some(Self {
            examiner,
            domain: Domain::of(examiner),
            mistake,
            smallest: outcome.clone(),
            question,
            left: QUESTIONS,
            until: Instant::now() + TIME,
        })
    }

    /// Makes every place of the question simpler that can be, again and again until none can.
    fn run(&mut self, ask: &mut Ask<'_>) -> io::Result<()> {
        let mut changed = true;
        while changed {
            changed = false;
            let mut i = 0;
            // What is changed may change the places behind it: they are found anew.
            while let Some(site) = self.sites().into_iter().nth(i) {
                match self.simplify(&site, ask)? {
                    // Of a list that was halved, half may go again.
                    Tried::Simpler if site.is_list() => changed = true,
                    Tried::Simpler => {
                        changed = true;
                        i += 1;
                    }
                    Tried::Same => i += 1,
                    Tried::Over => return Ok(()),
                }
            }
        }
        Ok(())
    }

    /// Whether there is an answer to another question where there is one to this, and none where there is none.
    fn is_alike(&self, question: &[f64]) -> bool {
        let asked = self.examiner.asked();
        let right = called(asked, question);
        let now = asked.read_answer(&self.smallest.case.answers[0]).ok();
        right.zip(now).is_some_and(|(right, now)| {
            !matches!(asked.answer.kind, Kind::Optional(_)) || right[0] == now[0]
        })
    }

    /// Whether an answer is that of the mistake which explains the case.
    fn is_explained(&self, question: &[f64], said: &Said) -> bool {
        let (Some(mistake), Said::Answer(answer)) = (self.mistake, said) else {
            return true;
        };
        let mistaken = attempt(|| self.examiner.mistake_answers(mistake, question)).flatten();
        let answer = self.examiner.asked().read_answer(answer.unescaped()).ok();
        let both = mistaken.zip(answer);
        both.is_some_and(|(mistaken, answer)| {
            let compared = self.examiner.compare(question, &mistaken, &answer);
            compared.is_ok()
        })
    }

    fn sites(&self) -> Vec<Site> {
        sites(self.examiner, &self.question)
    }

    /// Asks what is simpler at a place, and keeps the simplest question that is answered wrong.
    fn simplify(&mut self, site: &Site, ask: &mut Ask<'_>) -> io::Result<Tried> {
        let asked = self.examiner.asked();
        let simpler = self.domain.simpler(site, &self.question);
        let simpler = simpler
            .into_iter()
            .filter(|simpler| self.domain.keeps_apart(&self.question, simpler))
            .filter(|simpler| self.domain.holds(simpler) && self.is_alike(simpler));
        let questions: Vec<_> = simpler.take(self.left).collect();
        if questions.is_empty() {
            return Ok(Tried::Same);
        }
        let line = |question: &Vec<f64>| row::format(asked.question, question);
        let lines: Vec<_> = questions.iter().map(line).collect();
        let words = lines.iter().map(|line| format!("{} {line}", asked.name));
        let replies = ask(&words.collect::<Vec<_>>())?;
        self.left -= questions.len();
        for ((question, line), reply) in questions.into_iter().zip(lines).zip(replies) {
            if !reply.said.is_line() {
                return Ok(Tried::Over); // it hangs or has ended: asking on would take long
            }
            let Some(golden) = called(asked, &question) else {
                continue;
            };
            let case = Case {
                question: line,
                answers: vec![row::format(asked.answer.kind, &golden)],
                ..self.smallest.case.clone()
            };
            let verdict = judge(self.examiner, &case, &reply.said);
            let is_wrong = matches!(reply.said, Said::Answer(_)) && verdict != Mark::Right;
            if is_wrong && self.is_explained(&question, &reply.said) {
                self.question = question;
                self.smallest = Outcome {
                    case,
                    verdict,
                    reply,
                };
                return Ok(Tried::Simpler);
            }
        }
        let over = self.left == 0 || Instant::now() > self.until;
        Ok(if over { Tried::Over } else { Tried::Same })
    }
}

/// What became of a place.
enum Tried {
    /// It is simpler now.
    Simpler,
    /// It stays as it is.
    Same,
    /// No more is to be asked.
    Over,
}
