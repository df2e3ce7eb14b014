//! A change is named where many answers are right, and the student's are not those of the reference: without the change they are right.

use super::function::diagnosed;
use glam::{DVec2, DVec3};
use raybook_grader::cases;
use raybook_grader::diagnose::diagnose;
use raybook_grader::examine::visible_rng;
use raybook_workbook::row;
use std::f64::consts::TAU;

/// The way to a light by a step of another length than the reference's.
fn shadow_ray(q: &[f64]) -> [f64; 8] {
    let [position, normal, toward] = [0, 4, 7].map(|from| DVec3::from_slice(&q[from..]));
    let (error, distance) = (q[3], q[10]);
    let origin = position + (2.0 * error).copysign(normal.dot(toward)) * normal;
    let [o, d] = [origin.to_array(), toward.to_array()];
    let end = distance - 3.0 * error;
    [o[0], o[1], o[2], d[0], d[1], d[2], 0.0, end]
}

/// Points of the disc by rings, of the lattice moved by `shift`.
fn rings(q: &[f64], shift: DVec2) -> Vec<DVec2> {
    let point = |i: u32| {
        let i = f64::from(i) + 0.5;
        let u = (shift + DVec2::new(i / q[0], 0.618_034 * i)).map(|u| u.rem_euclid(1.0));
        u.x.sqrt() * DVec2::from_angle(TAU * u.y)
    };
    (0..q[0] as u32).map(point).collect()
}

/// A list as the numbers of an answer.
fn listed(points: &[DVec2]) -> Vec<f64> {
    let numbers = points.iter().flat_map(DVec2::to_array);
    std::iter::once(points.len() as f64)
        .chain(numbers)
        .collect()
}

#[test]
fn the_ends_of_an_interval_that_are_exchanged_are_named() {
    let found = diagnosed("shadow_ray", |q| {
        let mut way = shadow_ray(q);
        way.swap(6, 7);
        Some(way.to_vec())
    });
    let told = "exchanges min and max of within";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn a_factor_of_points_that_are_as_right_elsewhere_is_named() {
    let found = diagnosed("concentric_disk", |q| {
        let points = rings(q, DVec2::from_slice(&q[1..]));
        let half: Vec<_> = points.iter().map(|p| 0.5 * p).collect();
        Some(listed(&half))
    });
    let told = "returns 0.5 (a half) times the answer";
    assert_eq!((&*found.name, found.certain), (told, true));
}

#[test]
fn what_is_wrong_beside_the_others_only_is_no_slip_in_each() {
    let examiner = cases::find("concentric_disk").expect("the exercise exists");
    let asked = examiner.asked();
    let cases = examiner.cases(&mut visible_rng(asked.name)).cases;
    let answers = cases.iter().map(|case| {
        let q = asked.read_question(&case.question).expect("a question");
        let points = rings(&q, DVec2::splat(q[1]));
        (
            Some(row::format(asked.answer.kind, &listed(&points))),
            false,
        )
    });
    let answers: Vec<_> = answers.collect();
    let found = diagnose(examiner, &cases, &answers).expect("it has a name");
    let told = "ignores the shift, or one of its coordinates";
    let names: Vec<_> = std::iter::once(&found)
        .chain(&found.also)
        .map(|one| &*one.name)
        .collect();
    assert!(names.contains(&told), "{names:?}");
    assert!(
        names
            .iter()
            .all(|name| !name.contains("goes wrong at the step")),
        "{names:?}"
    );
}
