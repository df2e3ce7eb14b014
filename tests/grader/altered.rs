//! Evidence counts: no answer is right any more when a word of it, a column or all of it are altered, and none is that was not
//! made from its question.

mod exceptions;

use exceptions::EXCEPTIONS;
use raybook_common::check_all;
use raybook_grader::cases;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::judge::DEGREES;
use raybook_workbook::kind::Kind;
use raybook_workbook::row::Numbers;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// How many words of an answer are altered, others in the next case.
const WORDS: usize = 12;

/// What is made of a word; `None` where it is not a number.
type Alteration = (&'static str, fn(&str) -> Option<String>);

const ALTERATIONS: [Alteration; 7] = [
    ("NaN", |_| Some("nan".into())),
    ("∞", |_| Some("inf".into())),
    ("−∞", |_| Some("-inf".into())),
    ("0", |_| Some("0".into())),
    ("1e38", |_| Some("1e38".into())),
    ("10 % more", |word| match word.parse::<u32>() {
        Ok(whole) => Some((whole + (whole / 10).max(1)).to_string()),
        Err(_) => Some((1.1 * word.parse::<f64>().ok()?).to_string()),
    }),
    ("negative", |word| {
        Some((-word.parse::<f64>().ok()?).to_string())
    }),
];

/// An alteration, and how many altered answers there are; of these how many are called right, and one of them.
type Found = BTreeMap<&'static str, (usize, usize, String)>;

#[test]
fn an_answer_with_an_altered_word_is_wrong() {
    assert_only_exceptions("a word", |_, case| {
        let words: Vec<_> = case.answers[0].split_whitespace().collect();
        let count = words.len().min(WORDS);
        let mut altered = Vec::new();
        for k in 0..count {
            let i = (k * words.len() / count + case.number) % words.len();
            let with = |new: &[&str]| [&words[..i], new, &words[i + 1..]].concat().join(" ");
            for (name, alter) in ALTERATIONS {
                altered.extend(alter(words[i]).map(|word| (name, with(&[&word]))));
            }
            altered.push(("left out", with(&[])));
            altered.push(("said twice", with(&[words[i], words[i]])));
        }
        altered
    });
}

#[test]
fn an_answer_with_an_altered_column_is_wrong() {
    assert_only_exceptions("a column", |kind, case| {
        let words: Vec<_> = case.answers[0].split_whitespace().collect();
        // A list of equal parts: its length, and then so many words a part.
        let is_list = matches!(kind, Kind::List(_) | Kind::Optional(Kind::List(_)));
        let count = words[0].parse::<usize>().unwrap_or(0);
        if !is_list || count < 2 || (words.len() - 1) % count != 0 {
            return Vec::new();
        }
        let width = (words.len() - 1) / count;
        let mut altered = Vec::new();
        for column in 0..width {
            for (name, alter) in ALTERATIONS {
                let word = |(i, word): (usize, &&str)| {
                    let chosen = i > 0 && (i - 1) % width == column;
                    chosen
                        .then(|| alter(word))
                        .flatten()
                        .unwrap_or_else(|| (*word).to_owned())
                };
                let row: Vec<_> = words.iter().enumerate().map(word).collect();
                altered.push((name, row.join(" ")));
            }
        }
        altered
    });
}

#[test]
fn an_answer_with_all_numbers_altered_is_wrong() {
    assert_only_exceptions("all", |_, case| {
        let words = case.answers[0].split_whitespace();
        let altered = ALTERATIONS.map(|(name, alter)| {
            // A whole number may be a length, without which the rest is not read.
            let is_whole = |word: &str| word.parse::<u32>().is_ok();
            let word = |word: &str| Some(word).filter(|word| !is_whole(word)).and_then(alter);
            let row = words
                .clone()
                .map(|old| word(old).unwrap_or_else(|| old.to_owned()));
            (name, row.collect::<Vec<_>>().join(" "))
        });
        altered.into()
    });
}

#[test]
fn no_exception_is_for_what_is_not_a_finite_number() {
    let altered = EXCEPTIONS.iter().flat_map(|exception| exception.altered);
    for (_, alteration, _) in altered {
        let is_finite = !["NaN", "∞", "−∞"].contains(alteration);
        assert!(is_finite, "{alteration} is never right");
    }
}

/// Every altered answer that is called right must mean the same as before, or be excepted; and no exception is out of date.
fn assert_only_exceptions(
    of: &'static str,
    alter: impl Fn(&Kind, &Case) -> Vec<(&'static str, String)> + Sync,
) {
    let all = cases::all();
    let found: Vec<_> = all
        .par_iter()
        .map(|examiner| found(*examiner, &alter))
        .collect();
    let mut wrong = Vec::new();
    for (examiner, found) in all.iter().zip(found) {
        let total: usize = found.values().map(|(all, ..)| all).sum();
        assert!(
            total > 0 || of != "a word",
            "{}: nothing is altered",
            examiner.name()
        );
        for (alteration, (all, right, example)) in found {
            let name = examiner.name();
            let meant = EXCEPTIONS.iter().filter(|e| e.exercise == name);
            let mut meant =
                meant.flat_map(|e| e.altered.iter().map(move |altered| (e.why, altered)));
            let meant = meant.find(|(_, altered)| (altered.0, altered.1) == (of, alteration));
            let (why, most) = meant.map_or(("none may be", 0), |(why, altered)| (why, altered.2));
            if 100 * right > most * all {
                wrong.push(format!("{name}, {of}, {alteration}: {right} of {all} are called right ({why}), such as\n    {example}"));
            }
            if meant.is_some() && right == 0 {
                wrong.push(format!(
                    "{name}, {of}, {alteration}: this exception is not needed any more"
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn found(
    examiner: &dyn Examiner,
    alter: impl Fn(&Kind, &Case) -> Vec<(&'static str, String)>,
) -> Found {
    let asked = examiner.asked();
    let mut found = Found::new();
    for case in examiner.cases(&mut visible_rng(asked.name)).cases {
        let golden = asked
            .read_answer(&case.answers[0])
            .expect("it is an answer");
        let places = places(asked.answer.kind, &golden);
        for (alteration, got) in alter(asked.answer.kind, &case) {
            let numbers = asked.read_answer(&got);
            if numbers.is_ok_and(|numbers| means_the_same(&places, &golden, &numbers)) {
                continue;
            }
            let (all, right, example) = found.entry(alteration).or_default();
            *all += 1;
            if examiner.judge(&case.question, &case.answers, &got).is_ok() {
                *right += 1;
                *example = format!(
                    "{}: {} = {}, altered to {got}",
                    case.name, case.question, case.answers[0]
                );
            }
        }
    }
    found
}

/// Whether two answers differ by no more than the judges' tolerance of directions, relative to the size of the vector in which
/// the number is, or to 1 if that is smaller. A whole number must be the same.
fn means_the_same(places: &[Place], golden: &[f64], got: &[f64]) -> bool {
    let tolerance = f64::from(DEGREES.to_radians());
    golden.len() == got.len()
        && (0..golden.len()).all(|i| {
            let Place { first, parts } = places[i];
            let squares = golden[first..first + parts].iter().map(|v| v * v);
            let size = squares.sum::<f64>().sqrt().max(1.0);
            let close =
                parts > 0 && size.is_finite() && (golden[i] - got[i]).abs() <= tolerance * size;
            golden[i] == got[i] || close
        })
}

/// The vector in which a number of a row is: where it begins, and how many numbers it has; none if it is whole.
#[derive(Clone, Copy)]
struct Place {
    first: usize,
    parts: usize,
}

/// The places of a row's numbers.
fn places(kind: &Kind, numbers: &[f64]) -> Vec<Place> {
    let mut places = Vec::new();
    add_places(kind, &mut Numbers::of(numbers), &mut places);
    places
}

fn add_places(kind: &Kind, numbers: &mut Numbers<'_>, places: &mut Vec<Place>) {
    let mut add = |parts: usize, numbers: &mut Numbers<'_>| {
        let first = places.len();
        places.extend(vec![Place { first, parts }; parts.max(1)]);
        (0..parts.max(1)).map(|_| numbers.number()).sum::<f64>()
    };
    match kind {
        Kind::Number => drop(add(1, numbers)),
        Kind::Whole => drop(add(0, numbers)),
        Kind::Numbers(parts) => drop(add(parts.parts.len(), numbers)),
        Kind::Direction => drop(add(3, numbers)),
        Kind::Optional(kind) => {
            if add(0, numbers) != 0.0 {
                add_places(kind, numbers, places);
            }
        }
        Kind::List(kind) => {
            for _ in 0..add(0, numbers) as usize {
                add_places(kind, numbers, places);
            }
        }
        Kind::Record(record) => {
            for field in record.fields {
                add_places(field.kind, numbers, places);
            }
        }
        Kind::Choice(choices) => {
            let chosen = add(0, numbers) as usize;
            add_places(choices[chosen].1, numbers, places);
        }
    }
}

#[test]
fn answers_that_were_not_made_from_their_questions_are_wrong() {
    check_all(cases::all(), |examiner| {
        let name = examiner.name();
        let cases = examiner.cases(&mut visible_rng(name)).cases;
        let words = |line: &str| {
            line.split_whitespace()
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        let zeros = words(&cases[0].answers[0])
            .iter()
            .map(|_| "0")
            .collect::<Vec<_>>()
            .join(" ");
        let constants = cases.iter().map(|case| case.answers[0].clone());
        let constants = constants.chain([zeros, "0".into(), "1".into(), "none".into()]);
        for same in constants {
            assert_wrong(examiner, &cases, &format!("always {same:.80}"), |_| {
                same.clone()
            });
        }
        assert_wrong(examiner, &cases, "the answer before", |i| {
            cases[i.saturating_sub(1)].answers[0].clone()
        });
        assert_wrong(examiner, &cases, "the question", |i| {
            cases[i].question.clone()
        });
        let count = |i: usize| words(&cases[i].answers[0]).len();
        assert_wrong(examiner, &cases, "the first words of the question", |i| {
            let words = words(&cases[i].question);
            words[..count(i).min(words.len())].join(" ")
        });
        assert_wrong(examiner, &cases, "the last words of the question", |i| {
            let words = words(&cases[i].question);
            words[words.len().saturating_sub(count(i))..].join(" ")
        });
    });
}

/// Of the cases with other answers, at least three in five must be wrong, and of all cases at least one in four: where the answer is
/// yes or no, or a miss, as many as have the other one.
fn assert_wrong(
    examiner: &dyn Examiner,
    cases: &[Case],
    what: &str,
    answer: impl Fn(usize) -> String,
) {
    let (mut others, mut right, mut right_others) = (0, 0, 0);
    for (i, case) in cases.iter().enumerate() {
        let got = answer(i);
        let is_other = !case.answers.contains(&got);
        let is_right = examiner.judge(&case.question, &case.answers, &got).is_ok();
        others += usize::from(is_other);
        right += usize::from(is_right);
        right_others += usize::from(is_right && is_other);
    }
    let name = examiner.name();
    let all = cases.len();
    assert!(
        5 * right_others <= 2 * others,
        "{name}, {what}: {right_others} of {others} other answers are called right"
    );
    assert!(
        4 * right <= 3 * all,
        "{name}, {what}: {right} of {all} cases are called right"
    );
}
