//! Further questions to a program whose mistake is in doubt.

use crate::ask::{Asker, Said};
use crate::check::{Mark, Report, judge};
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
    let answer = |said: &Said| match said {
        Said::Answer(answer) => Some(answer.unescaped().to_owned()),
        _ => None,
    };
    let all = report.cases.iter();
    let mut cases: Vec<_> = all.map(|outcome| outcome.case.clone()).collect();
    let all = report.cases.iter();
    let mut answers: Vec<_> = all
        .map(|outcome| (answer(&outcome.reply.said), outcome.verdict == Mark::Right))
        .collect();
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
    for (case, reply) in trial.cases.iter().zip(replies) {
        if !matches!(reply.said, Said::Answer(_) | Said::Panicked(_)) {
            return Ok(());
        }
        let is_right = judge(examiner, case, &reply.said) == Mark::Right;
        answers.push((answer(&reply.said), is_right));
        cases.push(case.clone());
    }
    if let Some(sure) = trial.verdict(&cases, &answers) {
        report.diagnosis = Some(sure);
    }
    Ok(())
}
