//! Questions that follow from others, such as the same scene moved by a metre: who answers these knows more than the cases.

use crate::ask::{Asker, Said};
use crate::check::{Report, State, Verdict, judge};
use crate::examine::{Case, Examiner, visible_rng};
use crate::stable::is_stable;
use std::io;

/// The cases from which questions are made: at equal steps, the last one included.
const FROM: usize = 4;

impl dyn Examiner + '_ {
    /// The cases that follow from one, with what was done to its question: those whose questions are sound, and hang on no last digits.
    /// None follows from a case with several right answers, for the others' are not known.
    pub fn related(&self, case: &Case) -> Vec<(&'static str, Case)> {
        let Ok(question) = self.asked().read_question(&case.question) else {
            return Vec::new();
        };
        if case.answers.len() > 1 {
            return Vec::new();
        }
        let rng = &mut visible_rng(self.name());
        let fair = |(_, question): &(_, Vec<f64>)| {
            self.is_sound(question) && is_stable(self, question, rng)
        };
        let related = self.relations(&question).into_iter().filter(fair);
        let asked = related.filter_map(|(how, question)| {
            let name = format!("{}, {how}", case.name);
            let related = self.case(&name, &question).ok()?;
            let number = case.number;
            Some((how, Case { number, ..related }))
        });
        asked.collect()
    }
}

/// Asks what follows from some cases of a report, if all of them are right. A wrong answer's case stands in the place of the one from
/// which it follows.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_related(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    report: &mut Report,
) -> io::Result<()> {
    if report.state() != State::Right {
        return Ok(());
    }
    let count = report.cases.len();
    let from = (1..=FROM).filter_map(|i| (i * count / FROM).checked_sub(1));
    let mut related = Vec::new();
    for i in from {
        let cases = examiner.related(&report.cases[i].case);
        related.extend(cases.into_iter().map(|(how, case)| (i, how, case)));
    }
    let question = |case: &Case| format!("{} {}", examiner.name(), case.question);
    let questions: Vec<_> = related.iter().map(|(_, _, case)| question(case)).collect();
    let replies = asker.ask(&questions)?;
    for ((i, how, case), reply) in related.into_iter().zip(replies) {
        // Who has used up the time has answered everything rightly before.
        if matches!(reply.said, Said::Over(_)) {
            continue;
        }
        if let Verdict::Wrong(why) = judge(examiner, &case, &reply.said) {
            let outcome = &mut report.cases[i];
            outcome.verdict = Verdict::Wrong(format!(
                "the case itself is right, but {how} it is wrong: {why}. What does your function know that is not in the question?"
            ));
            (outcome.case, outcome.reply) = (case, reply);
        }
    }
    Ok(())
}
