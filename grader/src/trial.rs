//! Further questions to a program whose mistake is in doubt.

use crate::ask::{Asker, Said};
use crate::check::{Outcome, Report, answered, judge};
use crate::diagnose::trial::Trial;
use crate::examine::Examiner;
use std::io;

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
    let Some(trial) = Trial::new(examiner, &cases, &answers, &told) else {
        return Ok(());
    };
    let question = |question: &String| format!("{} {question}", examiner.name());
    let lines: Vec<_> = trial
        .cases
        .iter()
        .map(|case| question(&case.question))
        .collect();
    let replies = asker.ask(&lines)?;
    let further = trial
        .cases
        .iter()
        .zip(replies)
        .map(|(case, reply)| Outcome {
            case: case.clone(),
            verdict: judge(examiner, case, &reply.said),
            reply,
        });
    let further: Vec<_> = further.collect();
    let came = |one: &Outcome| matches!(one.reply.said, Said::Answer(_) | Said::Panicked(_));
    if !further.iter().all(came) {
        return Ok(());
    }
    let (further, more) = answered(&further);
    cases.extend(further);
    answers.extend(more);
    if let Some(sure) = trial.verdict(&cases, &answers) {
        report.diagnosis = Some(sure);
    }
    Ok(())
}
