//! The exercises' promises: each in a loop over all of them.

use raybook_grader::cases;
use raybook_grader::examine::{Cases, Examiner, RANDOM_CASES, visible_rng};
use raybook_grader::hidden::Key;
use raybook_workbook::curriculum;
use std::collections::BTreeSet;

#[test]
fn every_exercise_has_enough_cases_and_mistakes_with_names() {
    let mut of_twenty = 0;
    for examiner in cases::all() {
        let (name, set) = (examiner.name(), visible(examiner));
        let edges = set.cases.len() - RANDOM_CASES;
        assert!(edges >= 6, "{name} has {edges} named cases; 6 are needed");
        let names: BTreeSet<_> = set.cases.iter().map(|case| &case.name).collect();
        assert_eq!(
            names.len(),
            set.cases.len(),
            "{name}: two cases have the same name"
        );
        let mistakes: BTreeSet<_> = examiner
            .mistakes()
            .into_iter()
            .map(|(name, _)| name)
            .collect();
        assert!(
            mistakes.len() >= 5,
            "{name} has {} mistakes; 5 are needed",
            mistakes.len()
        );
        of_twenty += usize::from(mistakes.len() >= 20);
        assert_eq!(
            mistakes.len(),
            examiner.mistakes().len(),
            "{name}: two mistakes have the same name"
        );
        assert!(
            examiner.mistakes().iter().all(|(_, hint)| hint.len() > 15),
            "{name}: every mistake has a hint"
        );
    }
    assert!(
        of_twenty >= 64,
        "the course's own exercises have twenty: {of_twenty}"
    );
}

#[test]
fn nothing_is_lost() {
    let all = cases::all();
    let sum = |count: fn(&dyn Examiner) -> usize| all.iter().map(|e| count(*e)).sum::<usize>();
    assert!(all.len() >= 64, "{} exercises", all.len());
    let named = sum(|e| e.named().expect("they can be read").len());
    assert!(named >= 742, "{named} named cases");
    let mistakes = sum(|e| e.mistakes().len());
    assert!(mistakes >= 2364, "{mistakes} mistakes");
    let names = |chapters: &[curriculum::Chapter]| -> Vec<_> {
        let asked = chapters.iter().flat_map(curriculum::Chapter::exercises);
        asked.map(|asked| asked.name).collect()
    };
    let graded: Vec<_> = all.iter().map(|e| e.name()).collect();
    assert_eq!(
        graded,
        names(curriculum::CHAPTERS),
        "every exercise is graded"
    );
}

#[test]
fn few_random_questions_are_thrown_away() {
    for examiner in cases::all() {
        let fraction = visible(examiner).thrown_away_fraction();
        assert!(
            fraction < 0.2,
            "{}: {:.0} % of the random questions are thrown away",
            examiner.name(),
            100.0 * fraction
        );
    }
}

#[test]
fn the_reference_passes_everything() {
    for examiner in cases::all() {
        for set in [visible(examiner), hidden(examiner, 0)] {
            for case in set.cases {
                let answer = examiner
                    .answer_line(&case.question)
                    .expect("a case is a question");
                let verdict = examiner.judge(&case.question, &case.answers, &answer);
                assert_eq!(
                    verdict,
                    Ok(()),
                    "{} {}: {}",
                    examiner.name(),
                    case.name,
                    case.question
                );
            }
        }
    }
}

#[test]
fn hidden_cases_follow_from_the_key_and_differ_between_students() {
    for examiner in cases::all() {
        assert_eq!(
            hidden(examiner, 3),
            hidden(examiner, 3),
            "{}: the same key, the same cases",
            examiner.name()
        );
        let random = |set: Cases| {
            set.cases
                .into_iter()
                .rev()
                .take(RANDOM_CASES)
                .map(|c| c.question)
                .collect::<Vec<_>>()
        };
        let (one, two, seen) = (
            random(hidden(examiner, 3)),
            random(hidden(examiner, 4)),
            random(visible(examiner)),
        );
        assert!(
            one.iter().all(|q| !two.contains(q) && !seen.contains(q)),
            "{}: cases are shared",
            examiner.name()
        );
    }
}

fn visible(examiner: &dyn Examiner) -> Cases {
    examiner.cases(&mut visible_rng(examiner.name()))
}

fn hidden(examiner: &dyn Examiner, student: usize) -> Cases {
    let key = Key {
        course: "a course's secret".into(),
        term: "autumn".into(),
        student: format!("student {student}"),
    };
    examiner.cases(&mut key.rng(examiner.name()))
}
