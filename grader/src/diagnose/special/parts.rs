//! Parts of an answer that stand where others belong.

use super::{explanation, made};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::{Answers, Explanation};
use crate::layout::{Part, layout};
use raybook_workbook::kind::Kind;

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = of_two(evidence, base);
    all.extend(of_three(evidence, base));
    all.extend(from_one(evidence, base));
    all
}

/// Whether two parts can stand in for each other.
fn alike(one: &Part, other: &Part) -> bool {
    one.kind == other.kind && one.list == other.list
}

/// The answers in which each of `places` is given what is at the place beside it.
fn moved(evidence: &Evidence<'_>, base: &Answers, places: &[(usize, usize)]) -> Answers {
    let kind = evidence.examiner.asked().answer.kind;
    made(base, |_, base| {
        let fields = layout(kind, base);
        let mut made = base.to_vec();
        for (to, from) in places {
            for (to, from) in fields.of_part(*to).zip(fields.of_part(*from)) {
                made[to.range()].copy_from_slice(&base[from.range()]);
            }
        }
        Some(made)
    })
}

/// Two parts exchanged, or one of them given twice.
fn of_two(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    for (i, one) in evidence.parts.iter().enumerate() {
        for (j, other) in evidence.parts.iter().enumerate() {
            if i == j || !alike(one, other) {
                continue;
            }
            let (a, b) = (&one.name, &other.name);
            if i < j {
                all.push(explanation(
                    10,
                    format!("exchanges {a} and {b} in its answer"),
                    ORDER,
                    moved(evidence, base, &[(i, j), (j, i)]),
                ));
            }
            all.push(explanation(
                12,
                format!("returns {a} for {b} too"),
                "Each part of the answer has a meaning of its own: which?",
                moved(evidence, base, &[(j, i)]),
            ));
        }
    }
    all
}

const ORDER: &str = "In which order are the parts of the answer written?";

/// Three parts moved round.
fn of_three(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    for wanted @ [i, j, k] in alike_triples(&evidence.parts) {
        for written in [[j, k, i], [k, i, j]] {
            let places: Vec<_> = wanted.into_iter().zip(written).collect();
            let names =
                |parts: [usize; 3]| parts.map(|part| &*evidence.parts[part].name).join(", ");
            let (written, wanted) = (names(written), names(wanted));
            all.push(explanation(
                11,
                format!("writes {written} where its answer has {wanted}"),
                ORDER,
                moved(evidence, base, &places),
            ));
        }
    }
    all
}

/// Several whole numbers that stand side by side, all counted from 1.
fn from_one(evidence: &Evidence<'_>, base: &Answers) -> Option<Explanation> {
    let is_whole = |part: &&(usize, &Part)| matches!(part.1.kind, Kind::Whole);
    let all = evidence.parts.iter().enumerate();
    let mut groups: Vec<Vec<(usize, &Part)>> = Vec::new();
    for part in all.filter(|part| is_whole(&part)) {
        match groups.last_mut().filter(|group| alike(group[0].1, part.1)) {
            Some(group) => group.push(part),
            None => groups.push(vec![part]),
        }
    }
    let group = groups.into_iter().find(|group| group.len() > 1)?;
    let names: Vec<_> = group.iter().map(|(_, part)| &*part.name).collect();
    let kind = evidence.examiner.asked().answer.kind;
    let answers = made(base, |_, base| {
        let fields = layout(kind, base);
        let mut made = base.to_vec();
        for (part, _) in &group {
            for leaf in fields.of_part(*part) {
                made[leaf.range()].iter_mut().for_each(|v| *v += 1.0);
            }
        }
        Some(made)
    });
    Some(explanation(
        11,
        format!("counts {} from 1 instead of 0", names.join(", ")),
        "What is the number of the first?",
        answers,
    ))
}

/// All three parts of an answer that can stand in for each other.
fn alike_triples(parts: &[Part]) -> Vec<[usize; 3]> {
    let alike = |i: usize, j: usize| alike(&parts[i], &parts[j]);
    let mut triples = Vec::new();
    for i in 0..parts.len() {
        for j in (i + 1..parts.len()).filter(|j| alike(i, *j)) {
            let thirds = (j + 1..parts.len()).filter(|k| alike(i, *k));
            triples.extend(thirds.map(|k| [i, j, k]));
        }
    }
    triples
}
