//! The score: right programs pass all four scenes, and each mistake fails where it matters.

use raybook::image::{Image, rgb::Rgb, rms::rms};
use raybook_grader::cases;
use raybook_grader::examine::{Examiner, RANDOM_CASES, visible_rng};
use raybook_grader::picture::ask::{pixel_questions, triples};
use raybook_grader::picture::score::{Score, table};
use raybook_grader::picture::triple::Triple;
use raybook_workbook::exercises::ch25_capstone::Trace;
use raybook_workbook::row::{Row, read};
use rayon::prelude::*;

fn examiner() -> &'static dyn Examiner {
    cases::find("trace").expect("it is an exercise")
}

/// The pictures of a program that answers so.
fn pictures(answer: impl Fn(&str) -> Option<String> + Sync) -> Vec<Triple> {
    let questions = pixel_questions(examiner());
    let answers: Vec<_> = questions.par_iter().map(|q| answer(q)).collect();
    triples(examiner(), &answers)
}

fn mistaken(mistake: &str) -> Vec<Triple> {
    let mistakes = examiner().mistakes();
    let i = mistakes.iter().position(|(name, _)| *name == mistake);
    let i = i.unwrap_or_else(|| panic!("there is no mistake `{mistake}`"));
    pictures(|question| examiner().mistaken(i, question))
}

#[test]
fn the_reference_has_full_marks() {
    let pictures = pictures(|question| examiner().answer_line(question).ok());
    assert_eq!(pictures.len(), 4, "there are four scenes");
    for picture in pictures {
        let full = Score {
            right: 72 * 48,
            of: 72 * 48,
            undecided: 0,
            error: 0.0,
        };
        assert_eq!(picture.score, full, "{}", picture.name);
        assert!(picture.score.passed(), "{}", picture.name);
    }
}

/// Which of the four scenes a ray tracer with one mistake still passes.
#[test]
fn each_mistake_fails_the_scenes_in_which_it_is_seen() {
    for (mistake, passed) in [
        ("throws no shadows", [false, false, false, false]),
        ("only asks the first lamp", [true, false, true, false]),
        ("forgets the colour of mirrors", [true, true, false, false]),
        (
            "turns the index of refraction round",
            [true, true, true, false],
        ),
    ] {
        let pictures = mistaken(mistake);
        println!("{mistake}\n{}", table(&pictures).join("\n"));
        let found: Vec<_> = pictures.iter().map(|p| p.score.passed()).collect();
        assert_eq!(found, passed, "who {mistake}");
    }
}

#[test]
fn silence_is_no_right_answer_and_black_is_none_either() {
    for pictures in [pictures(|_| None), pictures(|_| Some("0 0 0".into()))] {
        for picture in pictures {
            let Score { right, of, .. } = picture.score;
            assert!(right == 0 && of > 3200, "{}: {right} of {of}", picture.name);
            assert!(picture.first_bad.is_some(), "the first pixel is told");
        }
    }
}

#[test]
fn the_table_has_a_line_per_picture() {
    let table = table(&mistaken("forgets the colour of mirrors"));
    assert_eq!(table.len(), 5, "a heading and four scenes: {table:?}");
    assert!(
        table[0].starts_with("picture") && table[0].contains("image error"),
        "{table:?}"
    );
    assert!(
        table[1].starts_with("spheres")
            && table[1].ends_with("3456 of 3456        0.0000   passed"),
        "{table:?}"
    );
    assert!(table[3].ends_with("not passed"), "{table:?}");
}

#[test]
fn a_case_that_a_mistake_does_not_concern_is_right_all_the_same() {
    let cases = examiner().cases(&mut visible_rng("trace")).cases;
    for (i, (name, _)) in examiner().mistakes().into_iter().enumerate() {
        let right = |case: &&raybook_grader::examine::Case| {
            let answer = examiner().mistaken(i, &case.question);
            answer.is_some_and(|a| examiner().judge(&case.question, &case.answers, &a).is_ok())
        };
        let right = cases.iter().filter(right).count();
        assert!(
            right > 0,
            "who {name} has one slip, not a ray tracer that never works"
        );
    }
}

#[test]
fn the_image_error_is_a_fraction_of_a_display() {
    let gray = |v: f32| Image::from_fn(4, 2, |_, _| Rgb::gray(v));
    let all = |_, _| true;
    assert_eq!(rms(&gray(0.3), &gray(0.3), all), 0.0, "equal pictures");
    assert_eq!(rms(&gray(0.0), &gray(1.0), all), 1.0, "black and white");
    assert_eq!(
        rms(&gray(1.0), &gray(9.0), all),
        0.0,
        "a display shows no more than 1"
    );
    assert_eq!(rms(&gray(0.0), &gray(f32::NAN), all), 0.0, "NaN is black");
    let half = Image::from_fn(4, 2, |x, _| Rgb::gray(if x < 2 { 1.0 } else { 0.0 }));
    assert_eq!(
        rms(&gray(0.0), &half, all),
        0.5_f32.sqrt(),
        "half of the pixels by 1"
    );
    assert_eq!(
        rms(&gray(0.0), &half, |x, _| x >= 2),
        0.0,
        "but for those that do not count"
    );
    assert_eq!(rms(&gray(0.0), &half, |_, _| false), 0.0, "none counts");
}

#[test]
fn no_named_case_hangs_on_a_millimetre() {
    let cases = examiner().cases(&mut visible_rng("trace")).cases;
    let named = &cases[..cases.len() - RANDOM_CASES];
    assert!(named.len() >= 30, "there are {} of them", named.len());
    for case in named {
        let question = examiner().asked().read_question(&case.question);
        assert!(
            examiner().is_fair(&question.expect("a question of `trace`")),
            "{}: its answer changes",
            case.name
        );
    }
}

#[test]
fn who_sees_only_the_backdrop_is_right_only_where_nothing_is_hit() {
    for case in examiner().cases(&mut visible_rng("trace")).cases {
        let q: Trace = read(&case.question, "question").expect("a case is a question");
        let backdrop = q.scene.backdrop.seen(q.ray.direction);
        let verdict = examiner().judge(&case.question, &case.answers, &backdrop.write());
        assert!(
            verdict.is_err() || q.scene.nearest(&q.ray).is_none(),
            "{}: the surface that is hit does not matter",
            case.name
        );
    }
}
