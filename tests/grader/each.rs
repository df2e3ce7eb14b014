//! The same for each of many, on all cores.

use raybook_grader::inside::each;
use rayon::prelude::*;
use std::thread;
use std::time::Duration;

#[test]
fn what_is_made_of_each_stands_in_their_order() {
    let numbers: Vec<_> = (0..1000).collect();
    let squares = each(&numbers, |n| n * n);
    assert!(
        squares
            .iter()
            .zip(&numbers)
            .all(|(square, n)| *square == n * n)
    );
    assert_eq!(squares.len(), numbers.len());
    assert!(each(&[], |n: &i32| *n).is_empty());
}

#[test]
fn work_that_needs_rayon_is_done_on_its_threads_too() {
    // A helper of each of rayon's threads asks rayon for work, and nobody is left if all of these wait for their helpers.
    let sums = (0..20).into_par_iter().map(|_| {
        let made = each(&[1, 2, 3, 4], |n| {
            thread::sleep(Duration::from_millis(2)); // so that helpers have their share
            rayon::join(|| n + 1, || n * 2)
        });
        made.into_iter()
            .map(|(one, other)| one + other)
            .sum::<i32>()
    });
    assert_eq!(sums.sum::<i32>(), 20 * (14 + 20));
}

#[test]
#[should_panic(expected = "the third")]
fn a_panic_is_not_lost() {
    each(&[1, 2, 3], |n| assert!(*n != 3, "the third"));
}
