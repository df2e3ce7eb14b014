//! Further questions to a program whose mistake is in doubt.

use crate::ask::{Asker, Said};
use crate::check::{Answered, Outcome, Report, answered, judge};
use crate::diagnose::trial::Trial;
use crate::examine::{Case, Examiner};
use std::io;

/// Trials of one mistake, where answers are estimates: the more of them are known, the smaller the mistakes that are told apart.
const TRIALS: usize = 3;

/// Asks what tells the mistake of a report from others, if it is in doubt, and tells it for certain if the answers are as it says.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_trial(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    report: &mut Report,
) -> io::Result<()> {
    // One case alone is asked to look at it.
    if report.cases.len() < 2 || !report.answers() {
        return Ok(());
    }
    let Some(told) = report.diagnosis.clone() else {
        return Ok(());
    };
    let (mut cases, mut answers) = answered(&report.cases);
    for _ in 0..TRIALS {
        let Some(trial) = Trial::new(examiner, &cases, &answers, &told) else {
            return Ok(());
        };
        let Some((further, more)) = ask(asker, examiner, &trial.cases)? else {
            return Ok(());
        };
        cases.extend(further);
        answers.extend(more);
        if let Some(sure) = trial.verdict(&cases, &answers) {
            report.diagnosis = Some(sure);
            return Ok(());
        }
        if !trial.is_open() {
            return Ok(());
        }
    }
    Ok(())
}

/// The further cases, and what the program answers to them; none if it does not answer all.
fn ask(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    cases: &[Case],
) -> io::Result<Option<Answered>> {
    let line = |case: &Case| format!("{} {}", examiner.name(), case.question);
    let lines: Vec<_> = cases.iter().map(line).collect();
    let replies = asker.ask(&lines)?;
    let outcomes = cases.iter().zip(replies).map(|(case, reply)| Outcome {
        case: case.clone(),
        verdict: judge(examiner, case, &reply.said),
        reply,
    });
    let outcomes: Vec<_> = outcomes.collect();
    let came = |one: &Outcome| matches!(one.reply.said, Said::Answer(_) | Said::Panicked(_));
    Ok(outcomes.iter().all(came).then(|| answered(&outcomes)))
}
