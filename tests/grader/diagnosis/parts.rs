//! Parts of an answer that stand for something else: a length for an end, a number that is 0 for nothing, each number in a unit of its own.

use super::function::{diagnosed, right};
use std::f64::consts::{PI, TAU};

#[test]
fn a_length_for_an_end_is_named() {
    let found = diagnosed("box_clip", |q| {
        let mut answer = right("box_clip", q);
        if let [_, min, max] = answer[..] {
            answer[2] = max - min;
        }
        Some(answer)
    });
    let told = "returns the length of the answer for its max";
    assert_eq!((&*found.name, found.certain), (told, true), "{found:?}");
}

#[test]
fn a_number_that_is_taken_for_nothing_is_named() {
    // Of the first triangle the number is 0, which is false.
    for (exercise, before) in [("mesh_hit", 0), ("bvh_closest", 2), ("wide_closest", 2)] {
        let found = diagnosed(exercise, |q| {
            let mut answer = right(exercise, q);
            if answer.len() > before + 1 && answer[before + 2] == 0.0 {
                answer.truncate(before);
                answer.push(0.0);
            }
            Some(answer)
        });
        let told = "answers none where id is 0";
        assert_eq!((&*found.name, found.certain), (told, true), "{found:?}");
    }
}

#[test]
fn numbers_each_in_a_unit_of_its_own_are_named() {
    let found = diagnosed("direction_to_latlong", |q| {
        let place = right("direction_to_latlong", q);
        Some(vec![TAU * place[0], PI * place[1]])
    });
    let told = "returns 6.2832 (2π) times x of the answer, and returns 3.1416 (π) times y of the answer";
    assert_eq!((&*found.name, found.certain), (told, true), "{found:?}");
}
