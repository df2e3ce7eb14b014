//! The line protocol: rows there and back, errors that say the word, the answer loop, and fair questions.

use glam::{Vec2, Vec3, vec3};
use proptest::prelude::{any, proptest};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_grader::cases::find;
use raybook_grader::examine::visible_rng;
use raybook_grader::stable::is_stable;
use raybook_workbook::answer::answer;
use raybook_workbook::exercises::ch03_sphere::SphereHit;
use raybook_workbook::exercises::ch07_mesh::{Indices, VertexNormals};
use raybook_workbook::row::{Row, read, to_numbers};
use std::fmt::Debug;

/// The value, written and read again.
fn there_and_back<R: Row + PartialEq + Debug>(value: &R, words: &str) {
    assert_eq!(value.write(), words, "as people write it");
    assert_eq!(read::<R>(words, "value").as_ref(), Ok(value), "and back");
}

#[test]
fn rows_go_there_and_back() {
    there_and_back(&2.0_f32, "2");
    there_and_back(&-0.5_f32, "-0.5");
    there_and_back(&1e-7_f32, "1e-7");
    there_and_back(&f32::INFINITY, "inf");
    there_and_back(&Interval::AHEAD, "0 inf");
    there_and_back(&vec3(1.0, -2.0, 0.25), "1 -2 0.25");
    there_and_back(&Ray::new(Vec3::ZERO, -Dir3::Z), "0 0 0  -0 -0 -1");
    there_and_back(&Rgb::new(0.1, 2.0, 3.0), "0.1 2 3");
    there_and_back(&None::<f32>, "none");
    assert_eq!(
        read::<Option<f32>>("None", "t"),
        Ok(None),
        "as Python prints it"
    );
    there_and_back(&Some(Vec2::ONE), "1 1");
    there_and_back(&vec![1_u32, 7], "2  1  7");
    let mesh = VertexNormals {
        positions: vec![Vec3::X],
        triangles: vec![Indices { a: 0, b: 0, c: 0 }],
    };
    there_and_back(&mesh, "1  1 0 0  1  0  0  0");
    assert_eq!((-0.0_f32).write(), "-0", "zero keeps its sign");
}

proptest! {
    #[test]
    fn every_number_goes_there_and_back(bits in any::<u32>()) {
        let number = f32::from_bits(bits);
        let again = read::<f32>(&number.write(), "number").expect("it was written by us");
        assert!(again.to_bits() == bits || (again.is_nan() && number.is_nan()), "{number:?} came back as {again:?}");
    }

    #[test]
    fn no_line_makes_the_answer_loop_panic(line in "\\PC*") {
        let said = answer(&line);
        assert!(said.starts_with("error"), "{line:?} is no question, but was answered: {said}");
    }
}

#[test]
fn errors_say_the_word() {
    let error = |line: &str| {
        read::<SphereHit>(line, "question")
            .expect_err("it is wrong")
            .to_string()
    };
    assert_eq!(
        error("0 0 -3 0 0 1 0 inf 0 0 0"),
        "word 12, `radius`, is missing"
    );
    assert_eq!(
        error("0 0 -3 0 0 1 0 inf 0 0 zero 1"),
        "word 11 should be `center.z`, a number, but is `zero`"
    );
    assert_eq!(
        error("0 0 -3 0 0 1 0 inf 0 0 0 1 5"),
        "word 13, `5`, is one too many"
    );
    assert_eq!(
        error("0 0 -3 0 0 0 0 inf 0 0 0 1"),
        "word 4 should be `direction`, a direction, but is `0 0 0`"
    );
    let huge = read::<Vec<Vec3>>("4000000000 1 2 3", "points").expect_err("it is too short");
    assert_eq!(
        huge.to_string(),
        "word 5, `points[1].x`, is missing",
        "no memory is asked for in advance"
    );
}

#[test]
fn the_answer_loop_answers_by_hand() {
    let ask = answer;
    assert_eq!(ask("ray_at 0 0 0  1 0 0  2.5"), "2.5 0 0");
    assert_eq!(ask("  sphere_hit 0 0 -3  0 0 1  0 inf  0 0 0  1\r"), "2");
    assert_eq!(
        ask("sphere_hat 1"),
        "error there is no exercise `sphere_hat`"
    );
    assert_eq!(ask(""), "error there is no exercise ``");
    assert!(
        ask("vertex_normals 1 0 0 0 1 5 6 7").starts_with("panic index out of bounds"),
        "a panic counts for its case alone"
    );
}

#[test]
fn a_question_that_its_last_digits_decide_is_thrown_away() {
    let question = |height: f32| SphereHit {
        ray: Ray::new(vec3(-3.3, height, 0.1), Dir3::X),
        within: Interval::AHEAD,
        center: vec3(0.2, 0.1, 0.1),
        radius: 1.7,
    };
    let sphere_hit = find("sphere_hit").expect("an exercise");
    let stable = |height| {
        let numbers = to_numbers(&question(height));
        is_stable(sphere_hit, &numbers, &mut visible_rng("a test"))
    };
    assert!(stable(0.3), "through the middle");
    assert!(!stable(1.8 - 1e-7), "along the silhouette");
    assert!(stable(1.9), "past it");
}
