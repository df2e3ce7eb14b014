//! Sets of points that programs answer.

use super::scripts::{CLUMPED, RIGHT, darts};
use super::{got, own, wanted};
use glam::Vec2;
use raybook::math::pcg;
use raybook::sample::pattern::find;
use raybook_chapters::lab::discrepancy::l2_star_squared;
use raybook_chapters::lab::errors::{EACH, errors};
use raybook_chapters::lab::integrands::CLASSES;
use raybook_chapters::lab::{subject::Realisations, subject::Subject};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use raybook_workbook::row;

/// What the library answers to a question of chapter 22.
fn answer(question: &str) -> Vec<Vec2> {
    let (name, question) = question.split_once(' ').expect("a name and a question");
    let mut exercises = CHAPTERS.iter().flat_map(Chapter::exercises);
    let exercise = exercises.find(|exercise| exercise.name == name);
    let exercise = exercise.expect("questions are asked of exercises");
    let line = exercise
        .answer_line(question)
        .expect("a question it can read");
    row::read(&line, "point").expect("it answers with points")
}

#[test]
fn the_librarys_functions_make_the_librarys_grids() {
    for name in ["regular-grid", "rotated-grid"] {
        for n in (1..=70).chain([169, 255, 256]) {
            let made = (own(name).points)(n, 0, &mut |question| answer(&question));
            let pattern = find(name).expect("it is in the library");
            let expected = (pattern.points)(n, &mut pcg::stream(0, 0));
            assert_eq!(made, expected, "{name} of {n}");
        }
    }
}

#[test]
fn every_pattern_makes_any_number_of_points() {
    for name in [
        "regular-grid",
        "rotated-grid",
        "random",
        "jittered",
        "poisson-disk",
    ] {
        for n in [1, 2, 3, 4, 5, 16, 25, 64, 200, 1000] {
            let set = |seed| (own(name).points)(n, seed, &mut |question| answer(&question));
            assert_eq!(set(3).len(), n, "{name} of {n}");
            assert_eq!(set(3), set(3), "{name} of {n}: the seed decides");
            assert_eq!(
                set(3) != set(4),
                own(name).random,
                "{name} of {n}: another seed"
            );
        }
    }
}

#[test]
fn jittered_points_of_any_number_have_a_cell_each() {
    // As in the library, 5 are rows of 2 and 3, so the areas above and left of the cells' edges have their share.
    let questions = |n| {
        let mut asked = Vec::new();
        (own("jittered").points)(n, 7, &mut |question| {
            asked.push(question);
            Vec::new()
        });
        asked
    };
    assert_eq!(
        questions(16),
        ["jittered 4  4  7"],
        "a square is one question"
    );
    let of_five = questions(5);
    assert_eq!(of_five.len(), 2, "five are two grids: {of_five:?}");
    assert_ne!(
        of_five[0].rsplit(' ').next(),
        of_five[1].rsplit(' ').next(),
        "each with a seed of its own: {of_five:?}"
    );
}

#[test]
fn a_right_program_is_as_good_as_the_library() {
    let mut wanted = wanted();
    wanted.realisations = 100;
    for name in ["regular-grid", "random", "jittered"] {
        let got = got(name, RIGHT, &wanted);
        assert_eq!(got.wrong, None, "{name}");
        assert!(got.remarks.is_empty(), "{name}: {:?}", got.remarks);
        let pattern = find(name).expect("it is in the library");
        let [own, librarys] = [Subject::own(pattern, got.points), Subject::of(pattern)];
        for n in [16, 200] {
            let functions = CLASSES.map(|class| class.members(100 * EACH, &mut pcg::stream(1, 1)));
            let of = |subject| errors(subject, n, &functions, 100);
            for (mine, theirs) in of(&own).iter().zip(of(&librarys)) {
                let apart = (mine.rms - theirs.rms).abs();
                assert!(
                    apart <= 0.35 * theirs.rms,
                    "{name}, {n}: {mine:?}, {theirs:?}"
                );
            }
        }
    }
}

#[test]
fn clumped_points_are_shown_as_they_are() {
    let right = got("jittered", RIGHT, &wanted());
    let clumped = got("jittered", CLUMPED, &wanted());
    assert_eq!(clumped.wrong, None, "a wrong pattern is one to look at");
    let l2 = |points: &Realisations| l2_star_squared(&points[&200][0]);
    let (right, clumped) = (l2(&right.points), l2(&clumped.points));
    assert!(clumped > 20.0 * right, "far less even: {clumped}, {right}");
}

#[test]
fn a_poisson_disk_has_the_number_of_points_that_is_asked_and_keeps_its_distance() {
    let disk = got("poisson-disk", &darts(400, 1.0), &wanted());
    assert_eq!(disk.wrong, None, "{:?}", disk.remarks);
    for n in [16, 200] {
        assert_eq!(disk.points[&n].len(), 8, "all realisations of {n}");
        for set in &disk.points[&n] {
            assert_eq!(set.len(), n, "exactly as many as the library's");
        }
    }
    // In the plane: the exercise does not look over the edges.
    let least = |set: &Vec<Vec2>| {
        let apart =
            |(i, p): (usize, &Vec2)| set[..i].iter().map(|q| p.distance(*q)).fold(1.0, f32::min);
        set.iter().enumerate().map(apart).fold(1.0, f32::min)
    };
    let mean = |sets: &[Vec<Vec2>]| sets.iter().map(least).sum::<f32>() / 8.0;
    let random = got("random", RIGHT, &wanted());
    let (disk, random) = (mean(&disk.points[&200]), mean(&random.points[&200]));
    assert!(disk > 4.0 * random, "{disk} apart, at random {random}");
}
