//! Parts of an answer that stand for something else: a length for an end, a number that is 0 for nothing, each number in a unit of its own.

use super::function::{diagnosed, right};
use glam::DVec3;
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
        assert_eq!(found.name, "answers none where id is 0", "{found:?}");
    }
}

#[test]
fn angles_in_the_place_of_shares_are_named() {
    let found = diagnosed("direction_to_latlong", |q| {
        let place = right("direction_to_latlong", q);
        Some(vec![TAU * place[0], PI * place[1]])
    });
    let told = "returns the angles, not their shares of the way round and of the way down";
    assert_eq!((&*found.name, found.certain), (told, true), "{found:?}");
}

#[test]
fn a_cosine_that_shines_from_below_by_a_vector_that_is_not_normalised_is_both() {
    let found = diagnosed("blinn_phong", |q| {
        let [n, v, l] = [0, 3, 6].map(|from| DVec3::from_slice(&q[from..]));
        let highlight = n.dot(l + v).max(0.0).powf(q[18]);
        let channel = |i: usize| (q[12 + i] * n.dot(l).max(0.0) + q[15 + i] * highlight) * q[9 + i];
        Some((0..3).map(channel).collect())
    });
    assert_eq!(found.name, "forgets to normalise H", "{found:?}");
    assert_eq!(found.also.len(), 1, "{found:?}");
}
