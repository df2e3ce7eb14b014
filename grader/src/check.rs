//! Checking one exercise: asks the student's program, judges, diagnoses, and draws.

use crate::again::ask_again;
use crate::ask::{Asker, Reply, Said};
use crate::converse::{Limits, Program};
use crate::diagnose::{Diagnosis, diagnose, with_panics};
use crate::each::each;
use crate::examine::{Case, Examiner};
use crate::further::ask_further;
use crate::pairing::put_right;
use crate::picture::ask::{Pixels, ask_pixels, ask_to_first_wrong, some_are_right};
use crate::picture::triple::Triple;
use crate::prints::short;
use crate::rare::{Depth, ask_rare};
use crate::related::ask_related;
use crate::trial::ask_trial;
use raybook_chapters::kit::untrusted::Untrusted;
use std::io;

/// What became of one exercise.
#[derive(Clone, Debug)]
pub struct Report {
    /// The exercise's name.
    pub exercise: &'static str,
    /// Its cases, in order.
    pub cases: Vec<Outcome>,
    /// The first wrong case with a rounder and shorter question to which the answer is wrong too, if that was looked for.
    pub smallest: Option<Outcome>,
    /// The mistake that explains the wrong answers.
    pub diagnosis: Option<Diagnosis>,
    /// The pictures of the answers, where the exercise is one of pixels and all of these were asked. They count like cases.
    pub pictures: Vec<Triple>,
    /// Why not all of their pixels have an answer, if the program did not go on to the end.
    pub stopped: Option<String>,
}

/// What became of one case.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// The verdict on the reply.
    pub verdict: Mark,
    /// What the program said.
    pub reply: Reply,
}

impl Outcome {
    /// Whether the program says that this exercise is still to be written.
    pub fn is_to_do(&self, exercise: &str) -> bool {
        matches!(&self.reply.said, Said::Todo(name) if ["", exercise].contains(&name.unescaped()))
    }

    /// Whether the program ended without an answer.
    pub fn ended(&self) -> bool {
        matches!(self.reply.said, Said::Ended(_))
    }
}

/// The verdict on a reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mark {
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
    /// Every case is right, and every picture is passed.
    Right,
    /// Its function still says `todo!`.
    NotStarted,
    /// It calls this function, which still says `todo!`.
    WaitsFor(String),
    /// Some case is wrong, or some picture is not passed.
    Wrong,
}

impl Report {
    /// The exercise as a whole.
    pub fn state(&self) -> State {
        if self
            .cases
            .iter()
            .any(|outcome| matches!(outcome.verdict, Mark::Wrong(_)))
        {
            return State::Wrong;
        }
        let todo = self
            .cases
            .iter()
            .find_map(|outcome| match &outcome.reply.said {
                Said::Todo(name) if outcome.verdict == Mark::NotStarted => Some(name),
                _ => None,
            });
        match todo {
            None if self.first_failed().is_some() => State::Wrong,
            None => State::Right,
            Some(name) if ["", self.exercise].contains(&name.unescaped()) => State::NotStarted,
            Some(name) => State::WaitsFor(name.to_string()),
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
            .filter(|outcome| outcome.verdict == Mark::Right)
            .count()
    }

    /// The first picture that is not passed.
    pub fn first_failed(&self) -> Option<&Triple> {
        self.pictures.iter().find(|picture| !picture.score.passed())
    }

    /// The wrong case that is told in full: the first that the mistake explains, or else the first.
    pub fn shown_wrong(&self) -> Option<(&Outcome, &str)> {
        let outcome = &self.cases[self.place_shown()?];
        match &outcome.verdict {
            Mark::Wrong(why) => Some((outcome, why)),
            _ => None,
        }
    }

    /// The place of that case among all.
    pub fn place_shown(&self) -> Option<usize> {
        let is_wrong = |place: &usize| {
            let outcome = self.cases.get(*place);
            outcome.is_some_and(|outcome| matches!(outcome.verdict, Mark::Wrong(_)))
        };
        let explained = self.diagnosis.as_ref().and_then(|found| found.shown);
        let first = || (0..self.cases.len()).find(is_wrong);
        explained.filter(is_wrong).or_else(first)
    }

    /// The number of the exercise's own mistake that is told of some of the wrong answers, and not of all of them.
    pub fn mistake_of_some(&self, examiner: &dyn Examiner) -> Option<usize> {
        let found = self.diagnosis.as_ref()?;
        let number = examiner.mistake_called(&found.name)?;
        (found.explained < found.wrong).then_some(number)
    }

    /// The first wrong case, and why it is wrong.
    pub fn first_wrong(&self) -> Option<(&Outcome, &str)> {
        self.cases
            .iter()
            .find_map(|outcome| match &outcome.verdict {
                Mark::Wrong(why) => Some((outcome, why.as_str())),
                _ => None,
            })
    }
}

/// Asks the program all the cases of an exercise, and judges its replies. Where answers are wrong because they stand beside
/// other questions than their own, they are put right first.
///
/// # Errors
/// If the program cannot be started.
pub fn check(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    cases: Vec<Case>,
) -> io::Result<Report> {
    asker.next_exercise();
    let question = |case: &Case| format!("{} {}", examiner.name(), case.question);
    let questions: Vec<_> = cases.iter().map(question).collect();
    let replies = asker.ask(&questions)?;
    let report = assess(examiner, cases, replies.clone());
    let doubtful = |(i, outcome): (usize, &Outcome)| {
        (outcome.verdict != Mark::Right && outcome.reply.said.is_line()).then_some(i)
    };
    let doubtful: Vec<_> = report
        .cases
        .iter()
        .enumerate()
        .filter_map(doubtful)
        .collect();
    let right = put_right(asker, &questions, &replies, &doubtful)?;
    let Some(replies) = right.filter(|_| report.state() == State::Wrong) else {
        return Ok(report);
    };
    let cases = report.cases.into_iter().map(|outcome| outcome.case);
    Ok(assess(examiner, cases.collect(), replies))
}

/// Exercises for which one more process is worth its start.
const WORTH_A_PROCESS: usize = 8;

/// Checks several exercises, their cases and their pictures, each with `pixels` of its own; `done` is called after each. Many are asked of
/// as many processes as there are processors, each of the same exercises every time: what a program keeps from one to the next does not
/// hang on who is first.
///
/// # Errors
/// If the program cannot be started.
pub fn check_all(
    program: &Program,
    exercises: &[(&dyn Examiner, Vec<Case>)],
    limits: Limits,
    pixels: &(dyn Fn(&dyn Examiner) -> Pixels + Sync),
    depth: Depth,
    done: &(dyn Fn() + Sync),
) -> io::Result<Vec<Report>> {
    let most = rayon::current_num_threads();
    let processes = (exercises.len() / WORTH_A_PROCESS).clamp(1, most);
    let first: Vec<_> = (0..processes).collect();
    let lanes = each(&first, |first| {
        let own = exercises.iter().skip(*first).step_by(processes);
        let mut reports = Vec::new();
        let asked = check_each(program, own, limits, pixels, depth, &mut |report| {
            reports.push(report);
            done();
            true
        });
        asked.map(|()| reports.into_iter())
    });
    let mut lanes = lanes.into_iter().collect::<io::Result<Vec<_>>>()?;
    let report = |i: usize| lanes[i % processes].next();
    Ok((0..exercises.len()).filter_map(report).collect())
}

/// Checks these exercises one after the other, and gives away each report when it is there. It goes on as long as it is told to.
///
/// The program is asked everything in one process, if it allows that.
///
/// # Errors
/// If the program cannot be started.
pub fn check_each<'e>(
    program: &Program,
    exercises: impl IntoIterator<Item = &'e (&'e dyn Examiner, Vec<Case>)>,
    limits: Limits,
    pixels: &dyn Fn(&dyn Examiner) -> Pixels,
    depth: Depth,
    each: &mut dyn FnMut(Report) -> bool,
) -> io::Result<()> {
    let mut asker = Asker::new(program, limits);
    for (examiner, cases) in exercises {
        let pixels = pixels(*examiner);
        if !each(check_and_draw(&mut asker, *examiner, cases, pixels, depth)?) {
            break;
        }
    }
    Ok(())
}

/// Checks an exercise, and draws its pictures: if they are wanted, and the program answers its cases; else if the cases are
/// right, and some pixels are not. `FirstWrong` and `Renewed` draw what wrong answers make, too.
fn check_and_draw(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    cases: &[Case],
    pixels: Pixels,
    depth: Depth,
) -> io::Result<Report> {
    let mut report = check(asker, examiner, cases.to_vec())?;
    ask_again(asker, examiner, &mut report)?;
    ask_related(asker, examiner, &mut report)?;
    ask_further(asker, examiner, &mut report)?;
    ask_rare(asker, examiner, &mut report, depth)?;
    ask_trial(asker, examiner, &mut report)?;
    let state = report.state();
    let drawn = match pixels {
        Pixels::None => false,
        Pixels::FirstWrong if state == State::Wrong => report.answers(),
        Pixels::Renewed(_) if state != State::Right => report.answers(),
        Pixels::Some | Pixels::FirstWrong => {
            state == State::Right && !some_are_right(asker, examiner, cases, 0)?
        }
        Pixels::Renewed(round) => {
            state == State::Right && !some_are_right(asker, examiner, cases, round)?
        }
        Pixels::All => report.answers(),
    };
    let wanted = matches!(pixels, Pixels::All | Pixels::Renewed(_));
    if drawn {
        let draw = if pixels == Pixels::FirstWrong {
            ask_to_first_wrong
        } else {
            ask_pixels
        };
        (report.pictures, report.stopped) = draw(asker, examiner)?;
    } else if wanted && state != State::Right && !examiner.pictures().is_empty() {
        let is_to_do = |outcome: &Outcome| matches!(outcome.reply.said, Said::Todo(_));
        let why = if report.cases.iter().any(is_to_do) {
            "not every case has an answer. Let your program answer something, all zeros say, to what you have not written"
        } else {
            "not every case has an answer"
        };
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
    let mut outcomes: Vec<_> = outcomes.collect();
    count_what_is_to_do(examiner.name(), &mut outcomes);
    judge_together(examiner, &mut outcomes);
    let mut report = Report {
        exercise: examiner.name(),
        cases: outcomes,
        smallest: None,
        diagnosis: None,
        pictures: Vec::new(),
        stopped: None,
    };
    // What has no known mistakes is an instructor's own: nothing is known about it but right answers.
    if report.state() == State::Wrong && examiner.mistake(0).is_some() {
        report.diagnosis = diagnose_outcomes(examiner, &report.cases);
    }
    report
}

/// Which mistake wrong answers come from.
pub(crate) fn diagnose_outcomes(
    examiner: &dyn Examiner,
    outcomes: &[Outcome],
) -> Option<Diagnosis> {
    let (cases, answers) = answered(outcomes);
    let wrong = answers.iter().filter(|(_, right)| !right).count();
    with_panics(diagnose(examiner, &cases, &answers), outcomes, wrong)
}

/// Cases, and the answer to each, if there is one, with whether it is right.
pub(crate) type Answered = (Vec<Case>, Vec<(Option<String>, bool)>);

/// The cases of these outcomes, and their answers.
pub(crate) fn answered(outcomes: &[Outcome]) -> Answered {
    let answered = |outcome: &Outcome| {
        let answer = match &outcome.reply.said {
            Said::Answer(answer) => Some(answer.unescaped().to_owned()),
            _ => None,
        };
        (
            outcome.case.clone(),
            (answer, outcome.verdict == Mark::Right),
        )
    };
    outcomes.iter().map(answered).unzip()
}

/// A function that answers some cases and says `todo` to others is begun: these are wrong like others.
fn count_what_is_to_do(exercise: &str, outcomes: &mut [Outcome]) {
    if outcomes
        .iter()
        .any(|outcome| outcome.verdict == Mark::Right)
    {
        for outcome in outcomes
            .iter_mut()
            .filter(|outcome| outcome.is_to_do(exercise))
        {
            outcome.verdict = Mark::Wrong("this case is still to do".to_owned());
        }
    }
}

/// Answers that are right one by one may be wrong together: then each of them comes from the same fault. The few that are wrong by
/// themselves, such as those of a small bias by chance, do not hide it.
fn judge_together(examiner: &dyn Examiner, outcomes: &mut [Outcome]) {
    const FEW: usize = 10;
    let all = outcomes.len();
    let right = outcomes.iter_mut();
    let mut right: Vec<_> = right.filter(|one| one.verdict == Mark::Right).collect();
    if FEW * (all - right.len()) > all {
        return;
    }
    let answers = right.iter().filter_map(|one| match &one.reply.said {
        Said::Answer(answer) => Some((one.case.question.as_str(), answer.unescaped())),
        _ => None,
    });
    if let Err(why) = examiner.judge_together(answers) {
        for one in &mut right {
            one.verdict = Mark::Wrong(format!("in all answers together, {why}"));
        }
    }
}

/// The verdict on what a program said to a case.
pub(crate) fn judge(examiner: &dyn Examiner, case: &Case, said: &Said) -> Mark {
    Mark::Wrong(match said {
        Said::Answer(answer) => {
            match examiner.judge(&case.question, &case.answers, answer.unescaped()) {
                Ok(()) => return Mark::Right,
                // It may quote the answer's words.
                Err(why) => short(&Untrusted::from(why)),
            }
        }
        Said::Todo(_) => return Mark::NotStarted,
        other => other.why_none().unwrap_or_default(),
    })
}
