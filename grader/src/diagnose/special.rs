//! Answers as a whole: none at all, lists in another order, fields exchanged, the answer to another question.

use super::evidence::{Evidence, Scope};
use super::fit::{Answers, Explanation};
use super::number::short;
use crate::attempt::attempt;
use crate::explain::find;
use crate::explain::way::Way;
use crate::layout::{Part, layout};
use raybook_workbook::kind::Kind;

/// The rank of what is there to see in the answers, and needs no guess.
pub const SEEN: u32 = 4;

/// The explanations that look at an answer as a whole, or at its shape.
#[allow(clippy::too_many_lines, clippy::type_complexity)] // a list of explanations, each with its closure
pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    let kind = evidence.examiner.asked().answer.kind;
    let name = evidence.examiner.asked().answer.name;
    let mut add = |rank, fitted, name: String, hint: &str, answers: Answers| {
        let hint = hint.to_owned();
        all.push(Explanation {
            name,
            hint,
            rank,
            fitted,
            answers,
        });
    };
    if matches!(evidence.scope, Scope::Part(_)) {
        return all;
    }
    let each = |f: &dyn Fn(usize, &[f64]) -> Option<Vec<f64>>| -> Answers {
        let base = base.iter().enumerate();
        base.map(|(i, base)| f(i, base.as_ref()?)).collect()
    };
    let before = each(&|i, _| evidence.items[i].previous.clone());
    add(
        9,
        0,
        "gives the answer to the question before".to_owned(),
        "Is every answer written as soon as its question is read, or one too late? Does anything stay in a variable from the last call?",
        before,
    );
    let same = evidence
        .items
        .windows(2)
        .all(|two| two[0].got == two[1].got);
    if let (true, [first, _, _, ..]) = (same, &evidence.items[..]) {
        let one = first.got.clone();
        let none = matches!(kind, Kind::Optional(_)) && one == [0.0];
        let hint = Some(evidence).filter(|_| none).and_then(ways_to_none);
        let hint = hint.unwrap_or_else(|| {
            "Which of its arguments does your function use? Does it return what it calculates?"
                .to_owned()
        });
        let name = match in_words(kind, &one) {
            Some(words) => format!("answers every question with {words}"),
            None => "gives the same answer to every question".to_owned(),
        };
        add(SEEN, 0, name, &hint, each(&|_, _| Some(one.clone())));
    }
    if let Kind::Optional(_) = kind {
        add(
            9,
            0,
            "always returns none".to_owned(),
            "Which of your conditions is never true? Print its ingredients for the first wrong case.",
            each(&|_, _| Some(vec![0.0])),
        );
        let got = evidence
            .items
            .iter()
            .take(evidence.wrong)
            .filter(|item| item.golden() == [0.0]);
        let got: Vec<_> = got.map(|item| item.got.clone()).collect();
        if let Some(one) = got
            .first()
            .filter(|one| one.len() > 1 && got.iter().all(|got| got == *one))
        {
            let words: Vec<_> = one[1..]
                .iter()
                .map(|v| {
                    if v.is_finite() {
                        short(*v)
                    } else {
                        v.to_string()
                    }
                })
                .collect();
            let words = words.join(" ");
            let answers = each(&|_, base| {
                Some(if base == [0.0] {
                    one.clone()
                } else {
                    base.to_vec()
                })
            });
            add(
                9,
                0,
                format!("returns {words} where there is nothing to return"),
                "How does an answer say that there is none? Write the word `none`.",
                answers,
            );
        }
    }
    let fields = layout(
        kind,
        base.iter()
            .flatten()
            .find(|row| row.len() > 1)
            .map_or(&[][..], |row| row),
    );
    let lists = fields.lists.iter().map(|span| span.list).max();
    for list in 0..lists.map_or(0, |last| last + 1) {
        let changes: &[(u32, &str, &str, fn(usize) -> Vec<usize>)] = &[
            (
                11,
                "returns the list backwards",
                "In which order is the list wanted, and in which do you make it?",
                |n| (0..n).rev().collect(),
            ),
            (
                11,
                "leaves out the first of the list",
                "Where does your loop begin?",
                |n| (1..n).collect(),
            ),
            (
                11,
                "leaves out the last of the list",
                "Where does your loop end?",
                |n| (0..n.saturating_sub(1)).collect(),
            ),
            (
                12,
                "returns the first of the list only",
                "What makes your loop end?",
                |n| (0..n.min(1)).collect(),
            ),
            (
                12,
                "returns the last of the list only",
                "Is the list overwritten in every round?",
                |n| (n.saturating_sub(1)..n).collect(),
            ),
            (
                12,
                "returns the first half of the list only",
                "What makes your loop end?",
                |n| (0..n / 2).collect(),
            ),
            (
                12,
                "returns every second of the list only",
                "By how much does your counter grow in a round?",
                |n| (0..n).step_by(2).collect(),
            ),
            (
                12,
                "returns an empty list",
                "Is anything ever appended to your list?",
                |_| Vec::new(),
            ),
            (
                12,
                "returns the last of the list twice",
                "Where does your loop end?",
                |n| (0..n).chain(n.checked_sub(1)).collect(),
            ),
            (
                12,
                "returns the first of the list twice",
                "Is the first appended before the loop and in it?",
                |n| (0..n.min(1)).chain(0..n).collect(),
            ),
            (
                12,
                "returns everything in the list twice",
                "How often is each appended?",
                |n| (0..n).chain(0..n).collect(),
            ),
            (
                13,
                "begins the list with its second element, and ends it with the first",
                "Where does your loop begin?",
                |n| (1..n).chain(0..n.min(1)).collect(),
            ),
            (
                13,
                "begins the list with its last element",
                "Where does your loop begin?",
                |n| {
                    (n.saturating_sub(1)..n)
                        .chain(0..n.saturating_sub(1))
                        .collect()
                },
            ),
        ];
        for (rank, what, hint, which) in changes {
            let answers = each(&|_, base| Some(layout(kind, base).rearranged(base, list, &which)));
            add(*rank, 0, (*what).to_owned(), hint, answers);
        }
        let sorted = each(&|_, base| {
            let fields = layout(kind, base);
            let keys = |n: usize| {
                let mut order: Vec<_> = (0..n).collect();
                if let Some(span) = fields.lists.iter().find(|span| span.list == list) {
                    order.sort_by(|a, b| {
                        let [a, b] = [a, b].map(|i| &base[span.elements[*i].clone()]);
                        let first = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
                        first.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
                    });
                }
                order
            };
            let alone = fields.lists.iter().filter(|span| span.list == list).count() == 1;
            alone.then(|| fields.rearranged(base, list, &keys))
        });
        add(
            13,
            0,
            "sorts the list".to_owned(),
            "In which order is the list wanted?",
            sorted,
        );
    }
    for (i, one) in evidence.parts.iter().enumerate() {
        for (j, other) in evidence.parts.iter().enumerate() {
            if i == j
                || one.kind != other.kind
                || one.list != other.list
                || evidence.scope != Scope::Whole
            {
                continue;
            }
            let both = |from: &dyn Fn(&mut [f64], &mut [f64])| {
                each(&|_, base| {
                    let fields = layout(kind, base);
                    let mut made = base.to_vec();
                    let places = fields.of_part(i).zip(fields.of_part(j));
                    for (a, b) in places {
                        let (mut x, mut y) = (base[a.range()].to_vec(), base[b.range()].to_vec());
                        from(&mut x, &mut y);
                        made[a.range()].copy_from_slice(&x);
                        made[b.range()].copy_from_slice(&y);
                    }
                    Some(made)
                })
            };
            let (a, b) = (&one.name, &other.name);
            if i < j {
                add(
                    10,
                    0,
                    format!("exchanges {a} and {b} in its answer"),
                    "In which order are the parts of the answer written?",
                    both(&|x, y| x.swap_with_slice(y)),
                );
            }
            add(
                12,
                0,
                format!("returns {a} for {b} too"),
                "Each part of the answer has a meaning of its own: which?",
                both(&|x, y| y.copy_from_slice(x)),
            );
        }
    }
    if evidence.scope == Scope::Whole {
        for [i, j, k] in alike_triples(&evidence.parts) {
            for [from_i, from_j, from_k] in [[j, k, i], [k, i, j]] {
                let answers = each(&|_, base| {
                    let fields = layout(kind, base);
                    let mut made = base.to_vec();
                    for (to, from) in [(i, from_i), (j, from_j), (k, from_k)] {
                        for (to, from) in fields.of_part(to).zip(fields.of_part(from)) {
                            made[to.range()].copy_from_slice(&base[from.range()]);
                        }
                    }
                    Some(made)
                });
                let name = |part: usize| evidence.parts[part].name.as_str();
                let names = |parts: [usize; 3]| parts.map(name).join(", ");
                let (written, wanted) = (names([from_i, from_j, from_k]), names([i, j, k]));
                add(
                    11,
                    0,
                    format!("writes {written} where its answer has {wanted}"),
                    "In which order are the parts of the answer written?",
                    answers,
                );
            }
        }
    }
    let (yes, no) = (vec![1.0], vec![0.0]);
    let is_yes_or_no =
        |row: &Option<Vec<f64>>| row.as_ref().is_none_or(|row| *row == yes || *row == no);
    if matches!(kind, Kind::Whole) && base.iter().all(is_yes_or_no) {
        add(
            9,
            0,
            format!("answers the other way round: 1 for 0 in {name}, and 0 for 1"),
            "What does a 1 mean, and what a 0?",
            each(&|_, base| Some(vec![1.0 - base[0]])),
        );
    }
    all
}

/// A short answer in words; none of a long one.
fn in_words(kind: &Kind, answer: &[f64]) -> Option<String> {
    /// More numbers are not read at a glance.
    const SHORT: usize = 6;
    match (kind, answer) {
        (Kind::Optional(_), [0.0]) => Some("none".to_owned()),
        (Kind::List(_), [0.0]) => Some("an empty list".to_owned()),
        (Kind::Optional(_) | Kind::List(_), _) => None,
        (_, numbers) if numbers.len() <= SHORT => {
            let numbers: Vec<_> = numbers.iter().map(|v| short(*v)).collect();
            Some(numbers.join(" "))
        }
        _ => None,
    }
}

/// Of a function that always returns none, a question that leads on: where right ways end with nothing to return, by what they decide
/// there. Nothing if no step by step way is known.
fn ways_to_none(evidence: &Evidence<'_>) -> Option<String> {
    let explainer = find(evidence.examiner.asked().name)?;
    let mut ends: [Vec<String>; 2] = Default::default();
    for item in evidence.items.iter().filter(|item| item.golden() == [0.0]) {
        let last = attempt(|| {
            let mut way = Way::default();
            (explainer.work)(0, &item.question, &mut way);
            way.end().decisions.pop()
        });
        let Some(last) = last.flatten() else { continue };
        let (end, name) = (
            &mut ends[usize::from(last.held)],
            format!("“{}”", last.name),
        );
        if !end.contains(&name) {
            end.push(name);
        }
    }
    let [failed, held] = ends.map(|names| names.join(" or "));
    let ends = match (held.is_empty(), failed.is_empty()) {
        (true, true) => return None,
        (true, false) => format!("{failed} is false"),
        (false, true) => format!("{held} is true"),
        (false, false) => format!("{held} is true, or {failed} is false"),
    };
    Some(format!(
        "An answer is none where {ends}. Which of these is it in your program for the first wrong case? Print both sides of that comparison, and what they are made of."
    ))
}

/// All three parts of an answer that can stand in for each other.
fn alike_triples(parts: &[Part]) -> Vec<[usize; 3]> {
    let alike =
        |i: usize, j: usize| parts[i].kind == parts[j].kind && parts[i].list == parts[j].list;
    let mut triples = Vec::new();
    for i in 0..parts.len() {
        for j in (i + 1..parts.len()).filter(|j| alike(i, *j)) {
            triples.extend(
                (j + 1..parts.len())
                    .filter(|k| alike(i, *k))
                    .map(|k| [i, j, k]),
            );
        }
    }
    triples
}
