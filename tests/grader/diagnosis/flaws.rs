//! Flaws are complaints of judges: each must be a judge's words, and of one meaning.

use raybook_grader::cases;
use raybook_grader::examine::{Examiner, visible_rng};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// A line with one of its words altered, in several ways.
fn altered(line: &str) -> Vec<String> {
    let words: Vec<_> = line.split_whitespace().collect();
    let mut lines = Vec::new();
    for i in (0..words.len()).step_by(words.len().div_ceil(8).max(1)) {
        for new in ["0", "1", "7", "1e9", "-0.9", "0.999", "4294967295", "inf"] {
            let with = [&words[..i], &[new], &words[i + 1..]].concat();
            lines.push(with.join(" "));
        }
    }
    lines
}

/// All that the judge of an exercise complains of, in the answers of its mistakes and in altered right ones.
fn complaints(examiner: &dyn Examiner) -> BTreeSet<String> {
    let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    let mut complaints = BTreeSet::new();
    for case in cases.iter().step_by(3) {
        let mistaken =
            (0..examiner.mistakes().len()).filter_map(|i| examiner.mistaken(i, &case.question));
        for answer in mistaken.chain(altered(&case.answers[0])) {
            let verdict = examiner.judge(&case.question, &case.answers, &answer);
            complaints.extend(verdict.err());
        }
    }
    complaints
}

#[test]
fn a_flaw_is_one_complaint_of_the_judge() {
    let found: Vec<_> = cases::all()
        .into_par_iter()
        .filter(|examiner| !examiner.flaws().is_empty())
        .map(|examiner| (examiner, complaints(examiner)))
        .collect();
    let (mut all, mut seen, mut unseen) = (0, 0, Vec::new());
    let mut unclear = BTreeSet::new();
    for (examiner, complaints) in &found {
        let flaws = examiner.flaws();
        for why in complaints {
            let which = flaws.iter().filter(|flaw| why.contains(flaw.complaint));
            let names: Vec<_> = which.map(|flaw| flaw.name).collect();
            if names.len() > 1 {
                unclear.insert(format!("{}: {names:?}", examiner.name()));
            }
        }
        for flaw in flaws {
            all += 1;
            if complaints.iter().any(|why| why.contains(flaw.complaint)) {
                seen += 1;
            } else {
                unseen.push(format!("{}: {}", examiner.name(), flaw.complaint));
            }
            assert!(
                flaw.hint.ends_with(['?', '.']),
                "a hint is a sentence: {}",
                flaw.hint
            );
        }
    }
    assert!(unclear.is_empty(), "a complaint has one name: {unclear:#?}");
    // Some are complaints of all answers together, or of what takes a program to make.
    println!("{seen} of {all} are seen, but for\n{}", unseen.join("\n"));
    assert!(
        4 * seen >= 3 * all,
        "{seen} of {all} are seen, but for\n{}",
        unseen.join("\n")
    );
}
