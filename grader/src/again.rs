//! The same question twice: a right program answers both times, whatever it was asked in between. One that keeps something, such as a list
//! that grows, does not. Two answers may differ, as long as both are right: any generator of random numbers will do.

use crate::ask::{Asker, Said};
use crate::check::{Mark, Report, State, judge};
use crate::examine::Examiner;
use std::io;

/// How many cases are asked again: the first, the last, and those at equal steps between them.
const AGAIN: usize = 4;

/// What is asked of who answers a question in two ways.
const KEEPS: &str = "Does your function keep something from one question to the next?";

/// Asks some cases of a report once more, if all of them are right, and marks those as wrong that are now.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_again(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    report: &mut Report,
) -> io::Result<()> {
    let count = report.cases.len();
    if report.state() != State::Right || count < 2 {
        return Ok(());
    }
    let mut again: Vec<_> = (0..AGAIN).map(|i| i * (count - 1) / (AGAIN - 1)).collect();
    again.dedup();
    let question = |i: &usize| format!("{} {}", examiner.name(), report.cases[*i].case.question);
    let questions: Vec<_> = again.iter().map(question).collect();
    let replies = asker.ask(&questions)?;
    for (i, reply) in again.into_iter().zip(replies) {
        let outcome = &mut report.cases[i];
        // Who has used up the time has answered everything rightly before.
        if matches!(reply.said, Said::Over(_)) {
            continue;
        }
        if let Mark::Wrong(why) = judge(examiner, &outcome.case, &reply.said) {
            outcome.verdict = Mark::Wrong(format!(
                "right at first, but when the same is asked again: {why}. {KEEPS}"
            ));
            outcome.reply = reply;
        }
    }
    Ok(())
}

/// Asks a report's wrong case at this place alone, in a process of its own, and adds to its verdict if it is right there: then no mistake that is made in each
/// answer is told. Returns whether it is right alone. Whoever throws dice has another answer in each process, and may just be lucky.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_alone(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    report: &mut Report,
    place: usize,
) -> io::Result<bool> {
    let outcome = &mut report.cases[place];
    let (Mark::Wrong(why), Said::Answer(_)) = (&outcome.verdict, &outcome.reply.said) else {
        return Ok(false);
    };
    let is_right = |said: &Said| judge(examiner, &outcome.case, said) == Mark::Right;
    // Its answer is right, and wrong beside all others only.
    if is_right(&outcome.reply.said) {
        return Ok(true);
    }
    let question = [format!("{} {}", examiner.name(), outcome.case.question)];
    let mut replies = Vec::new();
    asker.ask_apart(&question, &mut replies)?;
    if !replies.iter().any(|reply| is_right(&reply.said)) {
        return Ok(false);
    }
    asker.ask_apart(&question, &mut replies)?;
    let is_same = replies.windows(2).all(|both| both[0].said == both[1].said);
    if is_same {
        outcome.verdict = Mark::Wrong(format!(
            "{why}. In a program that is asked nothing else, this case is right. {KEEPS}"
        ));
        report.diagnosis = None;
    }
    Ok(is_same)
}
