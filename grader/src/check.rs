//! Checking one exercise: asks the student's program, judges, diagnoses, and draws.

use crate::ask::{Asker, Reply, Said};
use crate::converse::{Limits, Program};
use crate::diagnose::{Diagnosis, diagnose};
use crate::examine::{Case, Examiner};
use crate::picture::ask_pixels;
use crate::triple::Triple;
use std::io;

/// What became of one exercise.
#[derive(Clone, Debug)]
pub struct Report {
    /// The exercise's name.
    pub exercise: &'static str,
    /// Its cases, in order.
    pub cases: Vec<Outcome>,
    /// The mistake that explains the wrong answers.
    pub diagnosis: Option<Diagnosis>,
    /// The pictures of the answers, where the exercise is one of pixels and they were asked for.
    pub pictures: Vec<Triple>,
    /// Why not all of their pixels have an answer, if the program did not go on to the end.
    pub stopped: Option<String>,
}

/// What became of one case.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// The verdict on the reply.
    pub verdict: Verdict,
    /// What the program said.
    pub reply: Reply,
}

/// The verdict on a reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Right.
    Right,
    /// The exercise, or one that it builds on, is not written yet.
    NotStarted,
    /// Wrong, and why.
    Wrong(String),
}

/// What became of an exercise as a whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum State {
    /// Every case is right.
    Right,
    /// Its function still says `todo!`.
    NotStarted,
    /// It calls this function, which still says `todo!`.
    WaitsFor(String),
    /// Some case is wrong.
    Wrong,
}

impl Report {
    /// The exercise as a whole.
    pub fn state(&self) -> State {
        if self
            .cases
            .iter()
            .any(|outcome| matches!(outcome.verdict, Verdict::Wrong(_)))
        {
            return State::Wrong;
        }
        let todo = self
            .cases
            .iter()
            .find_map(|outcome| match &outcome.reply.said {
                Said::Todo(name) if outcome.verdict == Verdict::NotStarted => Some(name),
                _ => None,
            });
        match todo {
            None => State::Right,
            Some(name) if name == self.exercise || name.is_empty() => State::NotStarted,
            Some(name) => State::WaitsFor(name.clone()),
        }
    }

    /// Whether the program answers every case, if not rightly: then it can be asked for a picture.
    pub fn answers(&self) -> bool {
        self.cases
            .iter()
            .all(|outcome| matches!(outcome.reply.said, Said::Answer(_) | Said::Panicked(_)))
    }

    /// How many cases are right.
    pub fn right(&self) -> usize {
        self.cases
            .iter()
            .filter(|outcome| outcome.verdict == Verdict::Right)
            .count()
    }

    /// The first wrong case, and why it is wrong.
    pub fn first_wrong(&self) -> Option<(&Outcome, &str)> {
        self.cases
            .iter()
            .find_map(|outcome| match &outcome.verdict {
                Verdict::Wrong(why) => Some((outcome, why.as_str())),
                _ => None,
            })
    }
}

/// Asks the program all the cases of an exercise, and judges its replies.
///
/// # Errors
/// If the program cannot be started.
pub fn check(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    cases: Vec<Case>,
) -> io::Result<Report> {
    let question = |case: &Case| format!("{} {}", examiner.name(), case.question);
    let questions: Vec<_> = cases.iter().map(question).collect();
    Ok(assess(examiner, cases, asker.ask(&questions)?))
}

/// Checks several exercises, and draws their pictures if these are wanted; `done` is called after each.
///
/// The program is asked everything in one process. Only if it gave an answer that nobody asked for, nobody knows which, it is
/// asked again, with a process for each exercise.
///
/// # Errors
/// If the program cannot be started.
pub fn check_all(
    program: &Program,
    exercises: &[(&dyn Examiner, Vec<Case>)],
    limits: Limits,
    pictures: bool,
    done: &dyn Fn(),
) -> io::Result<Vec<Report>> {
    let mut asker = Asker::new(program, limits);
    let mut reports = Vec::new();
    for (examiner, cases) in exercises {
        reports.push(check_and_draw(&mut asker, *examiner, cases, pictures)?);
        done();
    }
    if asker.finish() {
        for (report, (examiner, cases)) in reports.iter_mut().zip(exercises) {
            let mut asker = Asker::apart(program, limits);
            *report = check_and_draw(&mut asker, *examiner, cases, pictures)?;
        }
    }
    Ok(reports)
}

/// Checks an exercise, and draws its pictures if they are wanted and the program answers its cases.
fn check_and_draw(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    cases: &[Case],
    pictures: bool,
) -> io::Result<Report> {
    let mut report = check(asker, examiner, cases.to_vec())?;
    if pictures && report.answers() {
        (report.pictures, report.stopped) = ask_pixels(asker, examiner)?;
    } else if pictures && !examiner.pictures().is_empty() {
        let why = "not every case has an answer. Let your program answer something, all zeros say, to what you have not written";
        report.stopped = Some(why.to_owned());
    }
    Ok(report)
}

/// Judges the replies to the cases.
pub fn assess(examiner: &dyn Examiner, cases: Vec<Case>, replies: Vec<Reply>) -> Report {
    let outcomes = cases.into_iter().zip(replies).map(|(case, reply)| Outcome {
        verdict: judge(examiner, &case, &reply.said),
        case,
        reply,
    });
    let mut report = Report {
        exercise: examiner.name(),
        cases: outcomes.collect(),
        diagnosis: None,
        pictures: Vec::new(),
        stopped: None,
    };
    if report.state() == State::Wrong {
        report.diagnosis = diagnose_outcomes(examiner, &report.cases);
    }
    report
}

fn diagnose_outcomes(examiner: &dyn Examiner, outcomes: &[Outcome]) -> Option<Diagnosis> {
    let cases: Vec<_> = outcomes
        .iter()
        .map(|outcome| outcome.case.clone())
        .collect();
    let answer = |outcome: &Outcome| match &outcome.reply.said {
        Said::Answer(answer) => Some(answer.clone()),
        _ => None,
    };
    let answers: Vec<_> = outcomes
        .iter()
        .map(|outcome| (answer(outcome), outcome.verdict == Verdict::Right))
        .collect();
    diagnose(examiner, &cases, &answers)
}

fn judge(examiner: &dyn Examiner, case: &Case, said: &Said) -> Verdict {
    Verdict::Wrong(match said {
        Said::Answer(answer) => match examiner.judge(&case.question, &case.answers, answer) {
            Ok(()) => return Verdict::Right,
            Err(why) => why,
        },
        Said::Todo(_) => return Verdict::NotStarted,
        other => other.why_none().unwrap_or_default(),
    })
}
