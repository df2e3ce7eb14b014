//! Further random questions to programs whose cases are right: a mistake on one question in a thousand is met by three thousand questions, seldom by 34.
//!
//! They are drawn like the random cases, and follow from the last case: with a course's key they are new. Their number follows from counts, so that it
//! is the same on every machine.

use crate::ask::{Asker, Reply, Said};
use crate::check::{Mark, Report, State, diagnose_outcomes, judge};
use crate::examine::{Case, Examiner, RANDOM_CASES, visible_rng};
use crate::stable::is_stable_within;
use std::io;

/// Who asks, and so how many questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Somebody waits for the verdict.
    Check,
    /// A class is graded.
    Grade,
}

/// Questions of which one at least is in a region of a thousandth of all, with 95 %: ln 20/10⁻³.
const MEET: usize = 3000;

/// Numbers in these questions and their answers: reading and writing them is most of what a program does. Above 60 a question, fewer are asked.
const NUMBERS: usize = 180_000;

/// Of who checks their own program, this part is asked.
const CHECK: usize = 10;

/// A question whose answer jumps within this number of times the last digits of a fair one is nobody's fault: of thousands of questions, some are
/// nearer to a jump than all cases are.
const MARGIN: i32 = 4;

/// Tries of moving a question to which an answer is wrong.
const JIGGLES: usize = 64;

impl dyn Examiner + '_ {
    /// How many further random questions are asked of who is right in these cases. None of an instructor's own exercise, of which nothing is known
    /// but right answers, nor of one that has hundreds of further questions of its own.
    pub fn rare_count(&self, cases: &[Case], depth: Depth) -> usize {
        /// Further questions of its own that are enough.
        const ENOUGH: usize = 100;
        if self.mistake(0).is_none() || self.further(&mut visible_rng("")).len() > ENOUGH {
            return 0;
        }
        let random = cases.iter().filter(|case| case.is_random());
        let words = |text: &str| text.split_whitespace().count();
        let numbers = random.map(|case| words(&case.question) + words(&case.answers[0]));
        let numbers: usize = numbers.sum();
        let all = MEET.min(NUMBERS * RANDOM_CASES / numbers.max(1) / self.limits().effort);
        match depth {
            Depth::Check => all / CHECK,
            Depth::Grade => all,
        }
    }

    /// The questions.
    pub fn rare_questions(&self, cases: &[Case], depth: Depth) -> Vec<Vec<f64>> {
        let last = cases.last().map_or("", |case| &case.question);
        let rng = &mut visible_rng(last);
        let count = self.rare_count(cases, depth);
        (0..count).map(|_| self.random(rng)).collect()
    }

    /// Whether a wrong answer to a further question is a fault: not where last digits decide. It is asked of wrong answers only, so it may take long.
    pub fn is_fault(&self, question: &[f64]) -> bool {
        let rng = &mut visible_rng(self.name());
        is_stable_within(self, question, MARGIN * self.ulps(), JIGGLES, rng)
    }
}

/// The share of all questions that a mistake has to spoil to be met by one of `count` with 95 %.
pub fn smallest_region(count: usize) -> f64 {
    1.0 - 0.05_f64.powf(1.0 / count as f64)
}

/// Asks further random questions, if all cases of a report are right. The case of the first wrong answer stands in the place of the last.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_rare(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    report: &mut Report,
    depth: Depth,
) -> io::Result<()> {
    // One case alone is asked to look at it.
    if report.state() != State::Right || report.cases.len() < 2 {
        return Ok(());
    }
    let cases: Vec<_> = report.cases.iter().map(|one| one.case.clone()).collect();
    let questions = examiner.rare_questions(&cases, depth);
    let lines: Vec<_> = questions.iter().map(|one| examiner.line(one)).collect();
    let mut replies = asker.ask_many(&lines)?;
    // Of thousands of answers one may be late because the machine is busy: whoever hangs, hangs again.
    let is_late = |reply: &Reply| matches!(reply.said, Said::TimedOut(_));
    if let Some(late) = replies.iter().position(is_late) {
        let again = asker.ask(&lines[late..=late])?;
        replies.splice(late..=late, again);
    }
    let mut wrong = questions.iter().zip(replies);
    let wrong = wrong.find_map(|(question, reply)| fault(examiner, question, reply));
    if let (Some((case, reply, why)), Some(last)) = (wrong, report.cases.last_mut()) {
        let number = last.case.number;
        last.case = Case { number, ..case };
        last.reply = reply;
        last.verdict = Mark::Wrong(format!(
            "the cases are right, but of {} further random questions this one is not: {why}",
            questions.len()
        ));
        report.diagnosis = diagnose_outcomes(examiner, &report.cases);
    }
    Ok(())
}

/// A reply that is a fault, and why.
fn fault(examiner: &dyn Examiner, question: &[f64], reply: Reply) -> Option<(Case, Reply, String)> {
    match &reply.said {
        // Who has used up the time has answered everything rightly before.
        Said::Over(_) => return None,
        Said::Answer(got) if examiner.is_right_line(question, got.unescaped()) => return None,
        _ => {}
    }
    let case = examiner.case("a further question", question).ok()?;
    match judge(examiner, &case, &reply.said) {
        Mark::Wrong(why) if examiner.is_fault(question) => Some((case, reply, why)),
        _ => None,
    }
}
