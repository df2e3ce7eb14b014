//! Questions that follow from others: the same scene moved by a metre, which nobody answers who knows the cases by heart; a structure
//! over a thousand elements, in which a wrong cost shows.

use crate::ask::{Asker, Said};
use crate::check::{Mark, Report, State, diagnose_outcomes, judge};
use crate::diagnose::flaws;
use crate::examine::{Case, Examiner, visible_rng};
use crate::layout::{Leaf, layout, parts};
use crate::shrink::domain::Domain;
use raybook_workbook::kind::{Kind, VECTOR};
use std::io;

/// The number of random cases from which questions are made.
const FROM: usize = 4;

/// The numbers of elements in the questions of an exercise that builds a structure.
const CROWDS: [usize; 2] = [100, 1000];

/// A question that follows from a case, and what is said of a wrong answer to it.
pub struct Follower {
    /// The question with its answer.
    pub case: Case,
    /// Whose place it takes, if it is wrong.
    place: usize,
    before: String,
    after: &'static str,
    /// Whether it asks for much more than any case, so that no answer in time is no fault.
    pub is_long: bool,
}

impl dyn Examiner + '_ {
    /// What follows from the named cases and some others, and from the last.
    pub fn followers(&self, cases: &[Case]) -> Vec<Follower> {
        let domain = if cases.len() > 1 {
            Domain::of_cases(self, cases)
        } else {
            Domain::of(self)
        };
        let mut followers = Vec::new();
        let mut left = FROM;
        for (place, case) in asked_first(cases) {
            if case.is_random() && left == 0 {
                continue;
            }
            let related = self.related(&domain, case).into_iter();
            if case.is_random() && related.len() > 0 {
                left -= 1;
            }
            followers.extend(related.map(|(how, case)| Follower {
                case,
                place,
                before: format!("the case itself is right, but {how} it is wrong"),
                after: if how == TURNED {
                    ". Which of your lines is for one axis only?"
                } else {
                    ". What does your function know that is not in the question?"
                },
                is_long: false,
            }));
        }
        followers.sort_by_key(|one: &Follower| one.place);
        let crowds = cases.last().map(|last| self.crowds(last));
        followers.extend(crowds.into_iter().flatten().map(|case| Follower {
            place: cases.len() - 1,
            before: format!(
                "with few elements it is right, but with {} it is wrong",
                case.name
            ),
            case,
            after: "",
            is_long: true,
        }));
        followers
    }

    /// The cases that follow from one, with what was done to its question: those whose questions the exercise could ask, and hang on no
    /// last digits. None follows from a case with several right answers, for the others' are not known.
    fn related(&self, domain: &Domain<'_>, case: &Case) -> Vec<(&'static str, Case)> {
        let Ok(question) = self.asked().read_question(&case.question) else {
            return Vec::new();
        };
        if case.answers.len() > 1 {
            return Vec::new();
        }
        let turned = turned(self.asked().question, &question);
        let turned = turned.filter(|question| domain.is_asked(question));
        let mut related = self.relations(&question);
        related.extend(turned.map(|question| (TURNED, question)));
        related.retain(|(_, question)| self.is_sound(question) && self.is_fair(question));
        let asked = related.into_iter().filter_map(|(how, question)| {
            let case = self.follower(&format!("{}, {how}", case.name), &question, case.number);
            Some((how, case?))
        });
        asked.collect()
    }

    /// Cases with a hundred elements and with a thousand, of an exercise that builds a structure. They follow from a case in that another
    /// one makes other ones: with a course's key they are new.
    fn crowds(&self, case: &Case) -> Vec<Case> {
        let rng = &mut visible_rng(&case.question);
        let of_size = |count| {
            let question = self.crowded(rng, count)?;
            self.follower(&format!("{count} elements"), &question, case.number)
        };
        CROWDS.into_iter().filter_map(of_size).collect()
    }

    /// A question with its answer, in the place of another.
    fn follower(&self, name: &str, question: &[f64], number: usize) -> Option<Case> {
        let case = self.case(name, question).ok()?;
        Some(Case { number, ..case })
    }
}

/// The named cases, and twice as many random ones as are needed, for from some no question follows: at equal steps, the last one first.
fn asked_first(cases: &[Case]) -> impl Iterator<Item = (usize, &Case)> {
    let step = |i: usize| (i * cases.len() / (2 * FROM)).saturating_sub(1);
    let mut places: Vec<_> = (1..=2 * FROM).rev().map(step).collect();
    places.dedup(); // of few cases
    let all = cases.iter().enumerate();
    let random = places
        .into_iter()
        .filter_map(|place| Some((place, cases.get(place)?)));
    all.filter(|(_, case)| !case.is_random())
        .chain(random.filter(|(_, case)| case.is_random()))
}

/// What is done to a question that is turned.
const TURNED: &str = "turned so that y becomes x, z becomes y and x becomes z";

/// The question with all its points, directions and extents turned by a third of a turn around (1, 1, 1); none if it has none. Whoever
/// forgot one of the three axes, at the end of an interval say, has remembered another.
fn turned(kind: &'static Kind, question: &[f64]) -> Option<Vec<f64>> {
    let parts = parts(kind, "question");
    let is_vector = |leaf: &&Leaf| match parts[leaf.part].kind {
        Kind::Direction => true,
        Kind::Numbers(numbers) => numbers.parts == VECTOR.parts,
        _ => false,
    };
    let mut turned = question.to_vec();
    for leaf in layout(kind, question).leaves.iter().filter(is_vector) {
        turned[leaf.range()].rotate_left(1);
    }
    (turned != question).then_some(turned)
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
    let cases: Vec<_> = report
        .cases
        .iter()
        .map(|outcome| outcome.case.clone())
        .collect();
    let followers = examiner.followers(&cases);
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
        if is_late || outcome.verdict != Mark::Right {
            continue;
        }
        if let Mark::Wrong(why) = judge(examiner, &one.case, &reply.said) {
            let Follower { before, after, .. } = one;
            // Of a flaw that is there to see no question is asked but its own.
            let flaw = flaws::of_all_together(examiner, &why, 1);
            let after = if flaw.is_some() { "" } else { after };
            outcome.verdict = Mark::Wrong(format!("{before}: {why}{after}"));
            (outcome.case, outcome.reply) = (one.case, reply);
            if one.is_long {
                report.diagnosis = diagnose_outcomes(examiner, &report.cases);
            } else if flaw.is_some() {
                report.diagnosis = flaw;
            }
        }
    }
    Ok(())
}
