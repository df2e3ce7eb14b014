//! Every sentence of an exercise's task has a case that fails without it: `clauses.txt` names, sentence by sentence, wrong answers that break it.
//! A new exercise can come before its list.
//!
//! Most are mistakes of the exercise, of which `proof.rs` shows that the cases see them. Others are bent here in one clause only.

mod bent;

use bent::{BENT, Bent};
use raybook_common::project;
use raybook_grader::cases;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_workbook::row;
use std::collections::BTreeSet;
use std::fs;

/// Number of tasks that are listed, at least.
const LISTED: usize = 64;

/// What breaks a sentence.
#[derive(Debug)]
enum Breaks {
    Mistake(String),
    Bent(String),
    /// Nothing does, and why.
    Nothing(String),
}

struct Sentence {
    text: String,
    broken: Vec<Breaks>,
}

struct Task {
    exercise: String,
    sentences: Vec<Sentence>,
}

/// What `clauses.txt` says.
fn tasks() -> Vec<Task> {
    let file = project("tests/grader/clauses.txt");
    let text = fs::read_to_string(file).expect("it can be read");
    let mut tasks: Vec<Task> = Vec::new();
    for line in text.lines().skip_while(|line| !line.starts_with("## ")) {
        if let Some(exercise) = line.strip_prefix("## ") {
            let exercise = exercise.to_owned();
            let sentences = Vec::new();
            tasks.push(Task {
                exercise,
                sentences,
            });
            continue;
        }
        let sentences = &mut tasks.last_mut().expect("an exercise comes first").sentences;
        let breaks = match line.split_at_checked(2) {
            None => continue,
            Some(("- ", name)) => Breaks::Mistake(name.to_owned()),
            Some(("~ ", name)) => Breaks::Bent(name.to_owned()),
            Some(("= ", why)) => Breaks::Nothing(why.to_owned()),
            _ => {
                let (text, broken) = (line.to_owned(), Vec::new());
                sentences.push(Sentence { text, broken });
                continue;
            }
        };
        let sentence = sentences.last_mut().expect("a sentence comes first");
        sentence.broken.push(breaks);
    }
    tasks
}

/// The sentences of a text: each but the first begins with a capital letter after a full stop.
fn sentences(text: &str) -> Vec<String> {
    let mut sentences: Vec<String> = Vec::new();
    for part in text.split_inclusive(". ") {
        match sentences.last_mut() {
            Some(last) if !part.starts_with(char::is_uppercase) => last.push_str(part),
            _ => sentences.push(part.to_owned()),
        }
    }
    sentences.iter().map(|one| one.trim().to_owned()).collect()
}

#[test]
fn every_sentence_of_every_task_is_listed() {
    let tasks = tasks();
    assert!(tasks.len() >= LISTED, "{} tasks are listed", tasks.len());
    for examiner in cases::all() {
        let (name, sentences) = (examiner.name(), sentences(examiner.task()));
        let Some(task) = tasks.iter().find(|task| task.exercise == name) else {
            continue;
        };
        let listed: Vec<_> = task.sentences.iter().map(|one| one.text.clone()).collect();
        assert_eq!(listed, sentences, "tests/grader/clauses.txt, {name}");
    }
}

#[test]
fn every_sentence_is_broken_by_something_that_exists() {
    let mut used = BTreeSet::new();
    for Task {
        exercise,
        sentences,
    } in tasks()
    {
        let examiner = cases::find(&exercise).expect("an exercise");
        let mistakes = examiner.mistakes();
        for Sentence { text, broken } in sentences {
            assert!(!broken.is_empty(), "{exercise}: what breaks “{text}”?");
            for breaks in broken {
                let is_there = match &breaks {
                    Breaks::Mistake(name) => mistakes.iter().any(|(one, _)| one == name),
                    Breaks::Bent(name) => {
                        used.insert((exercise.clone(), name.clone()));
                        find(&exercise, name).is_some()
                    }
                    Breaks::Nothing(why) => why.len() > 15,
                };
                assert!(is_there, "{exercise}: {breaks:?}");
            }
        }
    }
    assert_eq!(used.len(), BENT.len(), "each bent answer breaks a sentence");
}

/// The bent answer of this name.
fn find(exercise: &str, name: &str) -> Option<&'static Bent> {
    BENT.iter()
        .find(|bent| bent.exercise == exercise && bent.name == name)
}

#[test]
fn every_bent_answer_fails_a_visible_case() {
    let mut passing = Vec::new();
    for bent in BENT {
        let examiner = cases::find(bent.exercise).expect("an exercise");
        let cases = examiner.cases(&mut visible_rng(bent.exercise)).cases;
        if !cases.iter().any(|case| fails(examiner, bent, case)) {
            passing.push(format!("{}: {}", bent.exercise, bent.name));
        }
    }
    assert!(passing.is_empty(), "nobody sees\n{}", passing.join("\n"));
}

fn fails(examiner: &dyn Examiner, bent: &Bent, case: &Case) -> bool {
    let question = examiner.asked().read_question(&case.question);
    let question = question.expect("a case is a question");
    let answer = (bent.answer)(examiner.asked().call, &question);
    let answer = row::format(examiner.asked().answer.kind, &answer);
    let verdict = examiner.judge(&case.question, &case.answers, &answer);
    verdict.is_err()
}
