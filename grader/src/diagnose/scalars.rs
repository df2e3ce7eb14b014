//! The quantities of a question from which formulas are made: its numbers, lengths, distances, cosines, areas.

use super::evidence::Evidence;
use super::fit::Answers;
use crate::layout::{Layout, Part, layout, parts};
use raybook_workbook::kind::Kind;

/// A quantity by name, for each item.
type Scalar = (String, Vec<Option<f64>>);

/// Quantities by name.
pub struct Scalars {
    /// All of them.
    pub all: Vec<Scalar>,
}

/// A vector by name, for each item.
pub type Vector = (String, Vec<Option<Vec<f64>>>);

/// The components of a vector in space or on a plane; none for colours and intervals.
fn is_vector(kind: &Kind) -> bool {
    match kind {
        Kind::Direction => true,
        Kind::Numbers(numbers) => numbers.name.starts_with("Vec"),
        _ => false,
    }
}

/// The value of a part that stands in no list.
fn value(layout: &Layout, numbers: &[f64], part: usize) -> Option<Vec<f64>> {
    let leaf = layout.of_part(part).next()?;
    Some(numbers[leaf.range()].to_vec())
}

/// All values of the parts that stand in no list, by name.
fn values(
    kind: &'static Kind,
    name: &str,
    rows: &[Option<&[f64]>],
) -> Vec<(Part, Vec<Option<Vec<f64>>>)> {
    let layouts: Vec<_> = rows
        .iter()
        .map(|row| row.map(|row| layout(kind, row)))
        .collect();
    let parts = parts(kind, name).into_iter().enumerate();
    let single = parts.filter(|(_, part)| part.list.is_none());
    let of = |(i, part): (usize, Part)| {
        let each = rows.iter().zip(&layouts);
        let values = each
            .map(|(row, layout)| value(layout.as_ref()?, (*row)?, i))
            .collect();
        (part, values)
    };
    single.map(of).collect()
}

/// The values of the question, and of the other parts of the answer.
fn all_values(
    evidence: &Evidence<'_>,
    base: &Answers,
    part: usize,
) -> Vec<(Part, Vec<Option<Vec<f64>>>)> {
    let asked = evidence.examiner.asked();
    let questions: Vec<_> = evidence
        .items
        .iter()
        .map(|item| Some(item.question.as_slice()))
        .collect();
    let answers: Vec<_> = base.iter().map(Option::as_deref).collect();
    let mut all = values(asked.question, "question", &questions);
    for (i, (other, values)) in values(asked.answer.kind, asked.answer.name, &answers)
        .into_iter()
        .enumerate()
    {
        if i != part && evidence.parts.len() > 1 {
            let name = format!("the right {}", other.name);
            all.push((Part { name, ..other }, values));
        }
    }
    all
}

/// The vectors of the questions.
pub fn vectors(evidence: &Evidence<'_>, base: &Answers, part: usize) -> Vec<Vector> {
    let all = all_values(evidence, base, part).into_iter();
    let many = all.filter(|(part, _)| !matches!(part.kind, Kind::Number | Kind::Whole));
    let mut named: Vec<Vector> = many.map(|(part, values)| (part.name, values)).collect();
    let differences: Vec<_> = named
        .iter()
        .enumerate()
        .flat_map(|(i, one)| named[i + 1..].iter().map(move |other| (one, other)))
        .flat_map(|(one, other)| [(one, other, -1.0), (one, other, 1.0)])
        .map(|(one, other, sign)| {
            let both = |(a, b): (&Option<Vec<f64>>, &Option<Vec<f64>>)| {
                let (a, b) = (a.as_ref()?, b.as_ref()?);
                (a.len() == b.len()).then(|| a.iter().zip(b).map(|(a, b)| a + sign * b).collect())
            };
            let operator = if sign < 0.0 { "−" } else { "+" };
            let name = format!("{} {operator} {}", one.0, other.0);
            (name, one.1.iter().zip(&other.1).map(both).collect())
        })
        .collect();
    named.extend(differences);
    named
}

/// The quantities of the questions.
#[allow(clippy::too_many_lines, clippy::type_complexity)] // a list of quantities, each with its closure
pub fn scalars(evidence: &Evidence<'_>, base: &Answers, part: usize) -> Scalars {
    let all = all_values(evidence, base, part);
    let mut scalars: Vec<Scalar> = Vec::new();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut add = |name: String, values: Vec<Option<f64>>| {
        let fit = values
            .iter()
            .flatten()
            .filter(|v| v.is_finite() && **v != 0.0)
            .count();
        if 2 * fit > values.len() {
            scalars.push((name, values));
        }
    };
    for (part, values) in &all {
        match part.kind {
            Kind::Number | Kind::Whole => {
                add(
                    part.name.clone(),
                    values.iter().map(|v| v.as_ref().map(|v| v[0])).collect(),
                );
                let one_less = values
                    .iter()
                    .map(|v| v.as_ref().map(|v| 1.0 - v[0]))
                    .collect();
                add(format!("(1 − {})", part.name), one_less);
            }
            Kind::Numbers(numbers) => {
                for (k, axis) in numbers.parts.iter().enumerate() {
                    let component = values.iter().map(|v| v.as_ref().map(|v| v[k])).collect();
                    add(format!("{}.{axis}", part.name), component);
                }
                let product = values
                    .iter()
                    .map(|v| v.as_ref().map(|v| v.iter().product()))
                    .collect();
                add(
                    format!("the product of the components of {}", part.name),
                    product,
                );
            }
            _ => {}
        }
        if is_vector(part.kind) && !matches!(part.kind, Kind::Direction) {
            let lengths = values
                .iter()
                .map(|v| v.as_ref().map(|v| dot(v, v).sqrt()))
                .collect();
            add(format!("the length of {}", part.name), lengths);
        }
    }
    let spatial: Vec<_> = all
        .iter()
        .filter(|(part, _)| is_vector(part.kind))
        .collect();
    for (i, (one, ones)) in spatial.iter().enumerate() {
        for (other, others) in &spatial[i + 1..] {
            let (a, b) = (&one.name, &other.name);
            let both = |f: &dyn Fn(&[f64], &[f64]) -> f64| -> Vec<Option<f64>> {
                let each = ones.iter().zip(others);
                let of = |(a, b): (&Option<Vec<f64>>, &Option<Vec<f64>>)| match (a, b) {
                    (Some(a), Some(b)) if a.len() == b.len() => Some(f(a, b)),
                    _ => None,
                };
                each.map(of).collect()
            };
            let unit = matches!(one.kind, Kind::Direction) && matches!(other.kind, Kind::Direction);
            add(format!("{a}·{b}"), both(&dot));
            add(format!("|{a}·{b}|"), both(&|a, b| dot(a, b).abs()));
            if unit {
                add(
                    format!("the sine between {a} and {b}"),
                    both(&|a, b| (1.0 - dot(a, b).powi(2)).max(0.0).sqrt()),
                );
            } else {
                let apart = |a: &[f64], b: &[f64]| {
                    a.iter()
                        .zip(b)
                        .map(|(a, b)| (a - b).powi(2))
                        .sum::<f64>()
                        .sqrt()
                };
                add(format!("the distance between {a} and {b}"), both(&apart));
                let area = |a: &[f64], b: &[f64]| {
                    (dot(a, a) * dot(b, b) - dot(a, b).powi(2)).max(0.0).sqrt()
                };
                add(format!("the area |{a} × {b}|"), both(&area));
            }
        }
    }
    let triples = spatial
        .iter()
        .filter(|(part, _)| ["p0", "p1", "p2"].contains(&part.name.as_str()));
    if let [(_, a), (_, b), (_, c)] = triples.collect::<Vec<_>>()[..] {
        let area = |((a, b), c): ((&Option<Vec<f64>>, &Option<Vec<f64>>), &Option<Vec<f64>>)| {
            let (a, b, c) = (a.as_ref()?, b.as_ref()?, c.as_ref()?);
            let minus =
                |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>();
            let (u, v) = (minus(b, a), minus(c, a));
            Some(
                (dot(&u, &u) * dot(&v, &v) - dot(&u, &v).powi(2))
                    .max(0.0)
                    .sqrt(),
            )
        };
        add(
            "twice the triangle's area".to_owned(),
            a.iter().zip(b).zip(c).map(area).collect(),
        );
    }
    Scalars { all: scalars }
}
