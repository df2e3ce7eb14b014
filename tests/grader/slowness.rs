//! How slow a machine is.

use raybook_grader::inside::slowness::{SLOWEST, USUAL, measured, of};

#[test]
fn only_a_machine_that_is_slower_than_usual_gets_more_time() {
    assert_eq!(of(0.3 * USUAL), 1.0);
    assert_eq!(of(USUAL), 1.0);
    assert_eq!(of(2.5 * USUAL), 2.5);
    assert_eq!(of(1000.0), SLOWEST);
}

#[test]
fn the_loop_takes_some_processor_time() {
    assert!(
        measured().is_some_and(|seconds| seconds > 0.0),
        "these tests need python3"
    );
}
