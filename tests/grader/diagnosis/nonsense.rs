//! Nonsense: a diagnosis of it comes to an end.

use raybook_grader::cases;
use raybook_grader::examine::visible_rng;
use raybook_grader::inside::diagnose::{STEPS, steps};

#[test]
fn nonsense_is_known_after_a_bounded_number_of_steps() {
    let examiner = cases::find("voxels_of_triangle").expect("it exists");
    let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    // Each answer is the right one to the next question.
    let next = cases.iter().cycle().skip(1);
    let answers = next.map(|case| (case.answers.first().cloned(), false));
    let answers: Vec<_> = answers.take(cases.len()).collect();
    let steps = steps(examiner, &cases, &answers);
    assert!(steps > 0, "slips are tried");
    assert!(steps <= STEPS + 1_000_000, "{steps} steps");
}
