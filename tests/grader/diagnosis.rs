//! How often a mistake is called by its right name: mistakes written apart from the lists, most of which know nothing of them.

mod bounds;
mod channels;
mod comparisons;
mod ends;
mod flaws;
mod formulas;
mod function;
mod functions;
mod guesses;
mod habits;
mod lists;
mod mistakes;
mod nonsense;
mod operations;
mod own_choices;
mod panics;
mod parts;
mod phong;
mod regimes;
mod several;
mod structures;
mod students;
mod ties;
mod undone;
mod unforeseen;
mod written;

use crate::trial::tried;
use function::answers;
use mistakes::{MISTAKES, Slip};
use raybook_grader::cases;
use raybook_grader::diagnose::Diagnosis;
use raybook_grader::diagnose::misread::misreadings;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use rayon::prelude::*;
use students::STUDENTS;

/// What became of a mistake.
enum Fate {
    /// No case is wrong.
    Passed,
    /// By a right name, and certain or not.
    Named,
    /// By no name.
    Unnamed,
    /// By a wrong name, if not as a certainty.
    Guessed(Diagnosis),
    /// By a wrong name, as a certainty.
    Accused(Diagnosis),
}

#[test]
fn mistakes_that_are_on_no_list_are_called_by_their_names() {
    let fates: Vec<_> = MISTAKES.par_iter().map(|slip| (slip, fate(slip))).collect();
    let mut report = Vec::new();
    let (mut named, mut caught) = (0, 0);
    for (slip, fate) in &fates {
        caught += 1;
        let said = match fate {
            Fate::Passed => {
                report.push(format!("{}: \"{}\" passes", slip.exercise, slip.what));
                continue;
            }
            Fate::Named => {
                named += 1;
                continue;
            }
            Fate::Unnamed => "nothing".to_owned(),
            Fate::Guessed(diagnosis) => format!("perhaps {}", told(diagnosis)),
            Fate::Accused(diagnosis) => format!("CERTAINLY {}", told(diagnosis)),
        };
        report.push(format!("{}: \"{}\": {said}", slip.exercise, slip.what));
    }
    let report = report.join("\n");
    println!("{named} of {caught} are named\n{report}");
    assert!(
        !report.contains("CERTAINLY") && !report.contains(" passes"),
        "a wrong name is no certainty, and each is caught:\n{report}"
    );
    assert!(
        10 * named >= 9 * caught,
        "{named} of {caught} are named:\n{report}"
    );
}

#[test]
fn what_students_write_is_called_by_its_name() {
    let fates = STUDENTS.par_iter().map(|slip| (slip, fate(slip)));
    let said = fates.filter_map(|(slip, fate)| {
        let said = match fate {
            Fate::Named => return None,
            Fate::Passed => "passes".to_owned(),
            Fate::Unnamed => "has no name".to_owned(),
            Fate::Guessed(diagnosis) | Fate::Accused(diagnosis) => told(&diagnosis),
        };
        Some(format!("{}: \"{}\": {said}", slip.exercise, slip.what))
    });
    let unnamed: Vec<_> = said.collect();
    assert!(unnamed.is_empty(), "{unnamed:#?}");
}

#[test]
fn every_question_can_be_misread() {
    let misread = |examiner: &dyn Examiner| {
        let asked = examiner.asked();
        let cases = examiner.cases(&mut visible_rng(asked.name)).cases;
        let mut changed = 0;
        for reading in misreadings(asked.question, examiner.limits()) {
            for case in &cases {
                let question = asked.read_question(&case.question).expect("a question");
                let Some(read) = reading.read(asked.question, &question) else {
                    continue;
                };
                let answer = std::panic::catch_unwind(|| (asked.call)(&read));
                assert!(
                    answer.is_ok_and(|answer| answer.len() < 50_000),
                    "{}: who {}",
                    asked.name,
                    reading.name
                );
                changed += 1;
            }
        }
        changed
    };
    let changed: usize = cases::all().into_par_iter().map(misread).sum();
    assert!(changed > 100_000, "{changed} questions were misread");
}

/// A ray may be caught in a scene that makes no sense. Who follows it for ever runs out of stack, and takes the command along.
#[test]
fn a_mistake_in_a_misread_scene_comes_to_an_end() {
    let examiner = cases::find("trace").expect("it exists");
    let asked = examiner.asked();
    let cases = examiner.cases(&mut visible_rng("trace")).cases;
    let readings = misreadings(asked.question, examiner.limits());
    let answered = readings.par_iter().map(|reading| {
        let some = cases.iter().step_by(4);
        let questions = some.map(|case| asked.read_question(&case.question).expect("a question"));
        let read = questions.filter_map(|question| reading.read(asked.question, &question));
        let answer = |question: Vec<f64>| {
            let mistakes = 0..examiner.mistakes().len();
            let answered = mistakes.filter_map(|i| examiner.mistake_answers(i, &question));
            answered.count()
        };
        read.map(answer).sum::<usize>()
    });
    let answered: usize = answered.sum();
    assert!(
        answered > 10_000,
        "{answered} misread questions are answered"
    );
}

#[test]
fn only_a_direction_is_turned_round() {
    let examiner = cases::find("camera_ray").expect("it exists");
    let readings = misreadings(examiner.asked().question, examiner.limits());
    let turned = readings.iter().filter(|one| one.name.starts_with("turns "));
    let turned: Vec<_> = turned.map(|one| one.name.as_str()).collect();
    let directions = ["forward", "right", "up"].map(|name| format!("turns {name} round"));
    assert_eq!(turned, directions);
}

/// All names.
fn told(diagnosis: &Diagnosis) -> String {
    let also = diagnosis.also.iter().map(told);
    let part = diagnosis.part.as_ref().map(|part| format!("[{part}] "));
    let own = format!("{}{}", part.unwrap_or_default(), diagnosis.name);
    std::iter::once(own)
        .chain(also)
        .collect::<Vec<_>>()
        .join("; and ")
}

fn fate(slip: &Slip) -> Fate {
    let examiner = cases::find(slip.exercise).expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(slip.exercise)).cases;
    let call = examiner.asked().call;
    let answers = |cases: &[Case]| answers(examiner, cases, |q| Some((slip.answer)(q, &call)));
    if answers(&cases).iter().all(|(_, right)| *right) {
        return Fate::Passed;
    }
    let answer = |case: &Case| answers(std::slice::from_ref(case)).remove(0);
    let Some(diagnosis) = tried(examiner, &cases, answer) else {
        return Fate::Unnamed;
    };
    let told = told(&diagnosis);
    if slip
        .names
        .iter()
        .any(|name| name.split('&').all(|word| told.contains(word)))
    {
        Fate::Named
    } else if diagnosis.certain {
        Fate::Accused(diagnosis)
    } else {
        Fate::Guessed(diagnosis)
    }
}
