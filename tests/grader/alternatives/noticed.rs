//! Programs that are a little wrong, or always say the same, are noticed.

use crate::alternatives::CASES;
use crate::alternatives::student::{STYLES, line};
use crate::alternatives::wrong::{OFF, wrongs};
use raybook_common::check_all;
use raybook_grader::examine::{Case, Examiner};

/// The share of spoilt answers that must be noticed, in percent: 1 % of a very small number may be right.
const NOTICED: usize = 90;

/// How many cases of an exercise tell it.
const CASES_ENOUGH: usize = 700;

#[test]
fn programs_that_are_a_little_wrong_fail_nearly_everywhere() {
    check_all(&*CASES, |(examiner, cases)| {
        let cases = &cases[..cases.len().min(CASES_ENOUGH)];
        let name = examiner.name();
        let mut wrongs: Vec<_> = wrongs().filter(|w| w.0.contains(&name)).collect();
        if wrongs.is_empty() {
            wrongs.push(&OFF);
        }
        for (_, what, spoil) in wrongs {
            let spoilt = |case: &Case| {
                let numbers = case.answers[0].split_whitespace().map(str::parse);
                let right = numbers.collect::<Result<Vec<_>, _>>().ok()?;
                let mut numbers = right.clone();
                spoil(&mut numbers);
                // 1 % of 0 is 0, and black is black whichever channels are exchanged: that is right.
                (numbers != right).then(|| line(&Some(numbers), STYLES[0].1))
            };
            let (noticed, all) = count(*examiner, cases, spoilt);
            println!("{name:20} {what:26} {noticed} of {all}");
            assert!(
                all >= 100 && 100 * noticed >= NOTICED * all,
                "{name}, {what}: only {noticed} of {all} are called wrong"
            );
        }
    });
}

#[test]
fn a_program_that_says_the_same_to_everything_fails_nearly_everywhere() {
    check_all(&*CASES, |(examiner, cases)| {
        let cases = &cases[..cases.len().min(CASES_ENOUGH)];
        for same in ["none", cases[0].answers[0].as_str()] {
            let (noticed, all) = count(*examiner, cases, |case| {
                (case.answers[0] != same).then(|| same.to_owned())
            });
            let name = examiner.name();
            println!("{name:20} always {same:26} {noticed} of {all}");
            // Not all: 0.24999999 is another answer than 0.25, and as right.
            assert!(
                100 * noticed >= 97 * all,
                "{name}: `{same}` is called right for {} other answers",
                all - noticed
            );
            assert!(
                4 * all >= cases.len(),
                "{name}: {} of {} answers are `{same}`",
                cases.len() - all,
                cases.len()
            );
        }
    });
}

/// How many of the answers are called wrong, and how many there are.
fn count(
    examiner: &dyn Examiner,
    cases: &[Case],
    answer: impl Fn(&Case) -> Option<String>,
) -> (usize, usize) {
    let verdicts = cases
        .iter()
        .filter_map(|case| Some(examiner.judge(&case.question, &case.answers, &answer(case)?)));
    let (wrong, right): (Vec<_>, Vec<_>) = verdicts.partition(Result::is_err);
    (wrong.len(), wrong.len() + right.len())
}
