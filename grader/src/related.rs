//! Questions that follow from others: the same scene moved by a metre, which nobody answers who knows the cases by heart; a structure
//! over a thousand elements, in which a wrong cost shows.

use crate::ask::{Asker, Said};
use crate::check::{Report, State, Verdict, diagnose_outcomes, judge};
use crate::examine::{Case, Examiner, visible_rng};
use std::io;

/// The cases from which questions are made: at equal steps, the last one included.
const FROM: usize = 4;

/// The numbers of elements in the questions of an exercise that builds a structure.
const CROWDS: [usize; 2] = [100, 1000];

/// Of as many questions with many elements as this, one hangs on no last digits.
const TRIES: usize = 8;

/// A question that follows from a case, and what is said of a wrong answer to it.
struct Follower {
    /// Whose place it takes, if it is wrong.
    place: usize,
    case: Case,
    before: String,
    after: &'static str,
    /// Whether it asks for much more than any case, so that no answer in time is no fault.
    is_long: bool,
}

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
        let related = self.relations(&question).into_iter();
        let fair =
            related.filter(|(_, question)| self.is_sound(question) && self.is_fair(question));
        let asked = fair.filter_map(|(how, question)| {
            let name = format!("{}, {how}", case.name);
            let related = self.case(&name, &question).ok()?;
            let number = case.number;
            Some((how, Case { number, ..related }))
        });
        asked.collect()
    }

    /// Cases with a hundred elements and with a thousand, of an exercise that builds a structure. They follow from a case in that another
    /// one makes other ones: with a course's key they are new.
    pub fn crowds(&self, case: &Case) -> Vec<Case> {
        let rng = &mut visible_rng(&case.question);
        let of_size = |count| {
            let question = (0..TRIES).find_map(|_| {
                let question = self.crowded(rng, count)?;
                (self.is_sound(&question) && self.is_fair(&question)).then_some(question)
            })?;
            let crowd = self.case(&format!("{count} elements"), &question).ok()?;
            let number = case.number;
            Some(Case { number, ..crowd })
        };
        CROWDS.into_iter().filter_map(of_size).collect()
    }
}

/// What follows from some cases, and from the last.
fn followers(examiner: &dyn Examiner, report: &Report) -> Vec<Follower> {
    let count = report.cases.len();
    let mut followers = Vec::new();
    for place in (1..=FROM).filter_map(|i| (i * count / FROM).checked_sub(1)) {
        let related = examiner.related(&report.cases[place].case).into_iter();
        followers.extend(related.map(|(how, case)| Follower {
            place,
            case,
            before: format!("the case itself is right, but {how} it is wrong"),
            after: ". What does your function know that is not in the question?",
            is_long: false,
        }));
    }
    if let Some(last) = report.cases.last() {
        let crowds = examiner.crowds(&last.case).into_iter();
        followers.extend(crowds.map(|case| Follower {
            place: count - 1,
            before: format!(
                "with few elements it is right, but with {} it is wrong",
                case.name
            ),
            case,
            after: "",
            is_long: true,
        }));
    }
    followers
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
    let followers = followers(examiner, report);
    let question = |case: &Case| format!("{} {}", examiner.name(), case.question);
    let questions: Vec<_> = followers.iter().map(|one| question(&one.case)).collect();
    let replies = asker.ask(&questions)?;
    for (one, reply) in followers.into_iter().zip(replies) {
        let outcome = &mut report.cases[one.place];
        // Who has used up the time has answered everything rightly before; and of several wrong ones the first is told.
        let is_late = match reply.said {
            Said::Over(_) => true,
            Said::TimedOut(_) | Said::NotAsked(_) => one.is_long,
            _ => false,
        };
        if is_late || outcome.verdict != Verdict::Right {
            continue;
        }
        if let Verdict::Wrong(why) = judge(examiner, &one.case, &reply.said) {
            let Follower { before, after, .. } = one;
            outcome.verdict = Verdict::Wrong(format!("{before}: {why}{after}"));
            (outcome.case, outcome.reply) = (one.case, reply);
            if one.is_long {
                report.diagnosis = diagnose_outcomes(examiner, &report.cases);
            }
        }
    }
    Ok(())
}
