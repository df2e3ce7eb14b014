//! Evidence counts: pictures like cases, few points like many.

use crate::common::command::raybook;
use crate::common::executable::script;
use raybook_common::check_all;
use raybook_grader::ask::{Reply, Said};
use raybook_grader::cases;
use raybook_grader::check::{Report, State, assess};
use raybook_grader::converse::Prints;
use raybook_grader::dress::Dress;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::feedback::{self, Commands};
use raybook_grader::picture::ask::{pixel_questions, some_questions, triples};
use raybook_grader::rare::Depth;
use raybook_workbook::row;
use std::fs;
use std::path::Path;

/// Every exercise with a picture, and its visible cases.
fn pictured() -> Vec<(&'static dyn Examiner, Vec<Case>)> {
    let mut all = cases::all();
    all.retain(|examiner| !examiner.pictures().is_empty());
    let cases = |examiner: &dyn Examiner| examiner.cases(&mut visible_rng(examiner.name())).cases;
    all.into_iter()
        .map(|examiner| (examiner, cases(examiner)))
        .collect()
}

fn golden(examiner: &dyn Examiner, question: &str) -> String {
    examiner.answer_line(question).expect("it is a question")
}

/// The report on who answers every case rightly, and every pixel so.
fn report(
    examiner: &dyn Examiner,
    cases: Vec<Case>,
    pixel: impl Fn(&str) -> Option<String>,
) -> Report {
    let right = |case: &Case| Reply {
        said: Said::Answer(case.answers[0].clone().into()),
        printed: Prints::default(),
    };
    let replies = cases.iter().map(right).collect();
    let mut report = assess(examiner, cases, replies);
    let questions = pixel_questions(examiner);
    let pixels: Vec<_> = questions.iter().map(|question| pixel(question)).collect();
    report.pictures = triples(examiner, &pixels);
    report
}

#[test]
fn right_cases_and_wrong_pictures_are_wrong_in_every_exercise_with_a_picture() {
    let pictured = pictured();
    assert!(pictured.len() >= 20, "exercises with a picture");
    check_all(pictured, |(examiner, cases)| {
        let name = examiner.name();
        let right = report(examiner, cases.clone(), |question| {
            Some(golden(examiner, question))
        });
        assert_eq!(right.state(), State::Right, "{name}: all is right");
        let wrong = report(examiner, cases, |_| None);
        assert_eq!(
            wrong.right(),
            wrong.cases.len(),
            "{name}: the cases are right"
        );
        assert_eq!(wrong.state(), State::Wrong, "{name}: the picture is not");
        let dress = Dress {
            colour: false,
            symbols: false,
        };
        let commands = Commands {
            again: "raybook check",
            explain: None,
        };
        let said = feedback::explain(&wrong, examiner, None, commands, dress);
        assert!(
            said.contains(": the cases are right, the picture"),
            "{name}: {said}"
        );
        let line = feedback::line(&wrong, dress);
        assert!(line.contains("cases right, the picture"), "{name}: {line}");
    });
}

/// A program that knows these answers by heart, and has another for what it does not know.
#[cfg(unix)]
fn write_parrot(folder: &Path, known: &[(String, String)], unknown: &str) {
    let lines = known
        .iter()
        .map(|(question, answer)| format!("{question}\t{answer}\n"));
    fs::write(folder.join("known"), lines.collect::<String>()).expect("a file");
    let text = format!(
        "#!/bin/sh\nexec awk -F'\\t' 'NR == FNR {{ known[$1] = $2; next }} {{ print \"= \" (($0 in known) ? known[$0] : \"{unknown}\"); fflush() }}' known -\n"
    );
    script(&folder.join("parrot"), &text);
}

#[cfg(unix)]
#[test]
fn a_program_that_knows_the_cases_by_heart_is_wrong_without_any_wish_for_pictures() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let check = |(name, other): (&str, &str), pixels: bool, more: &[&str]| {
        let examiner = cases::find(name).expect("it is an exercise");
        let cases = examiner.cases(&mut visible_rng(name)).cases;
        let of_cases = cases.iter().map(|case| case.question.clone());
        let of_pixels = some_questions(examiner, &cases, 0).into_iter();
        // Further random questions are known too: what is told here is what pictures find.
        let further = examiner.rare_questions(&cases, Depth::Check).into_iter();
        let others = further.chain(of_pixels.filter(|_| pixels));
        let of_others = others.map(|numbers| row::format(examiner.asked().question, &numbers));
        let known = of_cases.chain(of_others).map(|question| {
            let answer = golden(examiner, &question);
            (format!("{name} {question}"), answer)
        });
        write_parrot(home.path(), &known.collect::<Vec<_>>(), other);
        raybook(
            home.path(),
            &[&["check", name, "--program", "./parrot"], more].concat(),
        )
    };
    let (trace, tone_map) = (("trace", "0.5 0.5 0.5"), ("tone_map", "0.2 0.6 0.8"));
    for asked in [trace, tone_map] {
        let (code, said) = check(asked, true, &[]);
        assert!(code == 0, "the pixels that are asked are known too: {said}");
        let (code, said) = check(asked, false, &[]);
        let why = "the cases are right, the picture";
        assert!(code == 1 && said.contains(why), "{code} {said}");
        assert!(said.contains("--pictures FOLDER"), "how to see it: {said}");
    }
    let (code, said) = check(tone_map, false, &["--json"]);
    assert_eq!(code, 1, "the exit code is the same");
    let results: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    let exercise = &results["exercises"][0];
    assert_eq!(exercise["state"], "wrong", "{said:.300}");
    assert_eq!(exercise["pictures"][0]["passed"], false, "{said:.300}");
    // A case is a case, whatever the picture is.
    let (code, said) = check(tone_map, false, &["--case", "1"]);
    assert_eq!(code, 0, "{said}");
}

/// The points as an answer.
fn line(points: &[[f32; 2]]) -> String {
    let points = points.iter().map(|[x, y]| format!("  {x} {y}"));
    format!("{}{}", points.len(), points.collect::<String>())
}

#[test]
fn points_that_nobody_chose_are_wrong_however_few() {
    let mut tried = 0;
    for (exercise, question, n, places) in [
        ("jittered", "2 2 1", 4, [2, 2]),
        ("jittered", "3 1 1", 3, [3, 1]),
        ("jittered", "1 5 1", 5, [1, 5]),
        ("jittered", "4 3 1", 12, [4, 3]),
        ("jittered", "7 7 1", 49, [7, 7]),
        ("random_pattern", "2 1", 2, [1, 1]),
        ("random_pattern", "5 1", 5, [1, 1]),
        ("random_pattern", "20 1", 20, [1, 1]),
        ("random_pattern", "99 1", 99, [1, 1]),
        ("concentric_disk", "2 0.1 0.2", 2, [1, 1]),
        ("concentric_disk", "5 0.1 0.2", 5, [1, 1]),
        ("concentric_disk", "30 0.1 0.2", 30, [1, 1]),
        ("concentric_disk", "199 0.1 0.2", 199, [1, 1]),
    ] {
        let examiner = cases::find(exercise).expect("it is an exercise");
        let right = [golden(examiner, question)];
        assert_eq!(
            examiner.judge(question, &right, &right[0]),
            Ok(()),
            "{exercise} {question}"
        );
        let numbers = examiner
            .asked()
            .read_answer(&right[0])
            .expect("it is an answer");
        let right_points: Vec<_> = numbers[1..]
            .chunks(2)
            .map(|p| [p[0] as f32, p[1] as f32])
            .collect();
        // In the same place of each cell, where there are cells.
        let [columns, rows] = places;
        let in_cells = |at: [f32; 2]| -> Vec<_> {
            let cell = |i: usize| [(i % columns) as f32, (i / columns % rows) as f32];
            let size = [1.0 / columns as f32, 1.0 / rows as f32];
            let place = |i: usize| [0, 1].map(|axis| (cell(i)[axis] + at[axis]) * size[axis]);
            (0..n).map(place).collect()
        };
        let half = n.div_ceil(2);
        let again = [&right_points[..half], &right_points[..n - half]].concat();
        for (what, points) in [
            ("all at 0", vec![[0.0, 0.0]; n]),
            ("all in one place", vec![[0.3, 0.4]; n]),
            ("the corners of the cells", in_cells([0.0, 0.0])),
            ("the middles of the cells", in_cells([0.5, 0.5])),
            ("the first half, twice", again),
        ] {
            let verdict = examiner.judge(question, &right, &line(&points));
            assert!(verdict.is_err(), "{exercise} {question}: {what}");
            tried += 1;
        }
    }
    assert_eq!(tried, 65, "sets of points");
}
