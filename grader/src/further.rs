//! Further questions to programs whose answers are right one by one and together: a bias of 1 % shows in 100,000 numbers, not in 10,000.
//! All are asked a few; more are asked, up to eight times as many, as long as something is off by more than 2.5 standard deviations.

use crate::Verdict;
use crate::ask::{Asker, Said};
use crate::check::{Mark, Report, State, diagnose_outcomes, judge};
use crate::diagnose::flaws;
use crate::examine::{Case, Examiner, visible_rng};
use crate::together::Bounds;
use std::io;

/// Eighths of the questions that are asked before the first verdict.
pub const FIRST_EIGHTHS: usize = 1;

/// The same before each verdict.
const ROUNDS: [usize; 4] = [FIRST_EIGHTHS, 2, 4, 8];

/// A question with an answer, in numbers.
pub type Row = (Vec<f64>, Vec<f64>);

impl dyn Examiner + '_ {
    /// Further questions to who answers these cases rightly. They follow from the last: with a course's key they are new.
    pub fn further_questions(&self, cases: &[Case]) -> Vec<Vec<f64>> {
        let last = cases.last().map_or("", |case| &case.question);
        self.further(&mut visible_rng(last))
    }
}

/// What is said of all answers together: of the `rows` of the cases, and of those to further questions as long as there is doubt. `ask` makes rows of
/// questions, or says that no more are asked.
///
/// # Errors
/// Those of `ask`.
pub fn judge_further<E>(
    examiner: &dyn Examiner,
    questions: &[Vec<f64>],
    mut rows: Vec<Row>,
    mut ask: impl FnMut(&[Vec<f64>]) -> Result<Option<Vec<Row>>, E>,
) -> Result<Verdict, E> {
    let mut asked = 0;
    for eighths in ROUNDS {
        let all = questions.len() * eighths / 8;
        let Some(more) = ask(&questions[asked..all])? else {
            break;
        };
        asked = all;
        rows.extend(more);
        // What is within the narrower bounds is within the wider ones.
        if examiner.compare_together(&rows, Bounds::DOUBT).is_ok() {
            break;
        }
        let verdict = examiner.compare_together(&rows, Bounds::CHANCE);
        if verdict.is_err() {
            return Ok(
                verdict.map_err(|why| format!("and in those to {all} further questions, {why}"))
            );
        }
    }
    Ok(Ok(()))
}

/// Asks further questions, if all cases of a report are right. What is wrong in all answers together is in each; a wrong answer's case
/// stands in the place of the last.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_further(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    report: &mut Report,
) -> io::Result<()> {
    // One case alone is asked to look at it.
    if report.state() != State::Right || report.cases.len() < 2 {
        return Ok(());
    }
    let cases: Vec<_> = report.cases.iter().map(|one| one.case.clone()).collect();
    let questions = examiner.further_questions(&cases);
    if questions.is_empty() {
        return Ok(());
    }
    let answers = report.cases.iter().filter_map(|one| match &one.reply.said {
        Said::Answer(answer) => Some((one.case.question.as_str(), answer.unescaped())),
        _ => None,
    });
    let rows = examiner.rows(answers);
    // One answer alone that is not as chance makes it may be chance; two are not.
    let (mut wrong, mut certain) = (None, false);
    let verdict = judge_further(examiner, &questions, rows, |questions| {
        let line = |question: &Vec<f64>| examiner.line(question);
        let replies = asker.ask(&questions.iter().map(line).collect::<Vec<_>>())?;
        let mut rows = Vec::new();
        for (question, reply) in questions.iter().zip(replies) {
            match &reply.said {
                Said::Answer(got) => {
                    let read = examiner.asked().read_answer(got.unescaped()).ok();
                    let row = read.map(|got| (question.clone(), got));
                    let is_right = |(question, got): &Row| examiner.is_right(question, got);
                    let right = row.as_ref().is_some_and(is_right);
                    rows.extend(row);
                    if right {
                        continue;
                    }
                }
                // Who has used up the time has answered everything rightly before.
                Said::Over(_) => return Ok(None),
                _ => {}
            }
            let Ok(case) = examiner.case("a further question", question) else {
                continue;
            };
            if let Mark::Wrong(why) = judge(examiner, &case, &reply.said) {
                let is_certain = !reply.said.is_line() || wrong.is_some();
                wrong.get_or_insert((case, reply, why));
                if is_certain {
                    certain = true;
                    return Ok(None);
                }
            }
        }
        io::Result::Ok(Some(rows))
    })?;
    if let (Some((case, reply, why)), Some(last)) =
        (wrong.filter(|_| certain), report.cases.last_mut())
    {
        let number = last.case.number;
        last.case = Case { number, ..case };
        last.reply = reply;
        last.verdict = Mark::Wrong(format!(
            "the cases are right, but of further questions this one is not: {why}"
        ));
        report.diagnosis = diagnose_outcomes(examiner, &report.cases);
    }
    if let Err(why) = verdict {
        for outcome in &mut report.cases {
            outcome.verdict = Mark::Wrong(format!("in all answers together, {why}"));
        }
        report.diagnosis = flaws::of_all_together(examiner, &why, report.cases.len());
    }
    Ok(())
}
