//! What is simpler than a question: lists with fewer elements, numbers with fewer digits.

use crate::examine::Examiner;
use crate::layout::{Part, layout, lists, parts};
use raybook_workbook::kind::Kind;

/// A place of a question that can be made simpler.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Site {
    /// The list of this number, of this length.
    List(usize, usize),
    /// A value: its part, and where its numbers begin and end.
    Value(usize, usize, usize),
}

impl Site {
    /// Whether it is a list.
    pub fn is_list(&self) -> bool {
        matches!(self, Self::List(..))
    }
}

/// The places of a question that can be made simpler: lists first, since they make it short.
pub fn sites(examiner: &dyn Examiner, question: &[f64]) -> Vec<Site> {
    let kind = examiner.asked().question;
    let (layout, parts) = (layout(kind, question), parts(kind, "question"));
    let fixed = examiner.limits().fixed;
    // Whole numbers in a list are places in another list, or a tree: nothing would fit together any more.
    let is_linked = |part: &Part| part.list.is_some() && *part.kind == Kind::Whole;
    let linked = parts.iter().any(is_linked);
    let names = lists(kind, "question");
    let of_list = |list: usize| parts.iter().filter(move |part| part.list == Some(list));
    let free = |list: &usize| {
        !linked
            && !fixed.contains(&names[*list].as_str())
            && of_list(*list).all(|part| !fixed.contains(&part.name.as_str()))
    };
    let mut sites = Vec::new();
    for list in (0..names.len()).filter(free) {
        let spans = layout.lists.iter().filter(|span| span.list == list);
        sites.extend(spans.map(|span| Site::List(list, span.elements.len())));
    }
    for leaf in &layout.leaves {
        let part = &parts[leaf.part];
        let belongs = part.list.is_some() && linked;
        if !belongs && !fixed.contains(&part.name.as_str()) {
            sites.push(Site::Value(leaf.part, leaf.start, leaf.start + leaf.len));
        }
    }
    sites
}

/// Which elements stay of a list of this length, shortest first: a half, or all but one. Not all go: nothing is another question.
pub fn shorter(length: usize) -> Vec<Vec<usize>> {
    /// Of longer lists, single elements are not taken away.
    const SHORT: usize = 8;
    let half = length / 2;
    let mut all: Vec<Vec<usize>> = Vec::new();
    if length > 1 {
        all.extend([(0..half).collect(), (half..length).collect()]);
    }
    if (2..=SHORT).contains(&length) {
        let without = |out: usize| (0..length).filter(move |i| *i != out).collect();
        all.extend((0..length).map(without));
    }
    all.dedup();
    all
}

/// Simpler values than this one, simplest first; none if all its numbers have two digits or fewer. No number becomes 0 that stands
/// alone: a radius or an exponent of 0 would be another question.
pub fn rounder(kind: &Kind, unit: bool, value: &[f64]) -> Vec<Vec<f64>> {
    if value.iter().all(|v| is_round(*v)) {
        return Vec::new();
    }
    // Adding 0 makes a 0 of -0.
    let each =
        |round: &dyn Fn(f64) -> f64| value.iter().map(|v| round(*v) + 0.0).collect::<Vec<_>>();
    let of = |name: &str| matches!(kind, Kind::Numbers(parts) if parts.name == name);
    let mut all = Vec::new();
    match kind {
        Kind::Whole => {
            all.extend([1.0, 2.0, 5.0, 10.0, 20.0, 50.0].map(|v| vec![v]));
            all.retain(|v| v[0] < value[0]);
        }
        _ if unit => all.extend(unit_vectors(value)),
        _ => {
            if of("Interval") {
                all.push(vec![0.0, f64::INFINITY]);
            }
            if of("Vec3") {
                all.push(each(&|_| 0.0));
            }
            let whole = each(&f64::round);
            if of("Vec3") || !whole.contains(&0.0) {
                all.push(whole);
            }
            all.extend([1, 2].map(|digits| each(&|v| significant(v, digits))));
        }
    }
    all.retain(|simpler| digits(simpler) < digits(value));
    all.dedup();
    all
}

/// Whether a number has two digits or fewer, such as 12, 0.5 or -3.
fn is_round(v: f64) -> bool {
    digits(&[v]) <= 2
}

/// How many digits numbers have, as they are written.
fn digits(values: &[f64]) -> usize {
    let of = |v: &f64| {
        let text = (*v as f32).to_string();
        text.chars().filter(char::is_ascii_digit).count()
    };
    values.iter().map(of).sum()
}

/// A number rounded to digits that count.
fn significant(v: f64, digits: i32) -> f64 {
    if v == 0.0 || !v.is_finite() {
        return v;
    }
    let last = v.abs().log10().floor() as i32 + 1 - digits;
    // Powers with a positive exponent are exact: 0.3 is 3/10, and no other number.
    if last > 0 {
        (v / 10_f64.powi(last)).round() * 10_f64.powi(last)
    } else {
        (v * 10_f64.powi(-last)).round() / 10_f64.powi(-last)
    }
}

/// The unit vectors nearest to a direction of those that have short numbers: along an axis; in a plane of two axes, since 0.6² + 0.8² = 1;
/// and in space, since 0.48² + 0.64² + 0.6² = 1.
fn unit_vectors(v: &[f64]) -> Vec<Vec<f64>> {
    const SIDES: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [0.48, 0.6, 0.64]];
    const ORDERS: [[usize; 3]; 6] = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    let nearest = |sides: [f64; 3]| {
        // The signs are the direction's own.
        let turned = ORDERS.map(|order| {
            let side = |axis: usize| sides[order[axis]].copysign(v[axis]) + 0.0;
            [0, 1, 2].map(side)
        });
        let dot = |unit: &[f64; 3]| unit.iter().zip(v).map(|(a, b)| a * b).sum::<f64>();
        let nearest = turned.into_iter().max_by(|a, b| dot(a).total_cmp(&dot(b)));
        nearest.map(Vec::from)
    };
    SIDES.into_iter().filter_map(nearest).collect()
}
