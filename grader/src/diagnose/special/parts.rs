//! Parts of an answer that stand where others belong.

use super::{explanation, made};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::{Answers, Explanation};
use crate::layout::{Part, layout};

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = of_two(evidence, base);
    all.extend(of_three(evidence, base));
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
