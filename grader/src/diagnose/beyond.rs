//! Where answers are wrong: beyond a limit of a number of the question, of a distance, or of the angle between two directions. So a branch that is wrong, or
//! missing, shows which one it is.

use super::evidence::{Evidence, Item};
use crate::layout::{Part, layout, parts};
use raybook_workbook::kind::{Kind, VECTOR};

/// The limit is told if it is chance with this probability at most.
const CHANCE: f64 = 0.01;

/// The limit beyond which the questions of these items are, and no others, in words: “`cosine` is below 0.1”.
pub fn search(evidence: &Evidence<'_>, inside: &[bool]) -> Option<String> {
    let quantities = quantities(evidence.examiner.asked().question);
    let count = inside.iter().filter(|inside| **inside).count();
    // Numbers in any order have these ones at an end with 1 over the number of ways to choose as many.
    let each = 2.0 / ways(count, inside.len());
    if each * quantities.len() as f64 > CHANCE {
        return None;
    }
    quantities.iter().find_map(|quantity| {
        let values = evidence.items.iter().map(|item| (quantity.of)(item));
        let values = values.collect::<Option<Vec<f64>>>()?;
        let ends = |wanted: bool| {
            let of = values
                .iter()
                .zip(inside)
                .filter(|(_, inside)| **inside == wanted);
            of.fold(
                [f64::INFINITY, f64::NEG_INFINITY],
                |[least, most], (v, _)| [least.min(*v), most.max(*v)],
            )
        };
        let ([least, most], [least_other, most_other]) = (ends(true), ends(false));
        let (is, limit) = if most_other < least {
            ("above", roundest(most_other, least))
        } else if most < least_other {
            ("below", roundest(most, least_other))
        } else {
            return None;
        };
        Some(format!("{} is {is} {limit}", quantity.words))
    })
}

/// In how many ways some of n things can be chosen.
fn ways(some: usize, n: usize) -> f64 {
    let some = some.min(n - some);
    (0..some).map(|i| (n - i) as f64 / (i + 1) as f64).product()
}

/// The number between two with the fewest digits.
fn roundest(low: f64, high: f64) -> f64 {
    let middle = 0.5 * (low + high);
    let rounded = (-9..=9).map(|digits| {
        // Powers with a positive exponent are exact: 0.3 is 3/10, and no other number.
        let scale = 10_f64.powi(i32::abs(digits));
        if digits < 0 {
            (middle / scale).round() * scale
        } else {
            (middle * scale).round() / scale
        }
    });
    let mut rounded = rounded.filter(|v| low < *v && *v < high);
    rounded.next().unwrap_or(middle)
}

/// The value of a quantity, if a question has it.
type Measure = Box<dyn Fn(&Item) -> Option<f64>>;

/// What can be measured of a question.
struct Quantity {
    words: String,
    /// Its value, if the question has it.
    of: Measure,
}

/// All that can be measured of a question, but what is in lists.
fn quantities(kind: &'static Kind) -> Vec<Quantity> {
    let parts = parts(kind, "question");
    let alone: Vec<_> = parts
        .iter()
        .enumerate()
        .filter(|(_, part)| part.list.is_none())
        .collect();
    let mut all = Vec::new();
    let mut add = |words: String, of: Measure| all.push(Quantity { words, of });
    for (i, part) in &alone {
        let i = *i;
        for (k, name) in part.kind.names(&part.name).into_iter().enumerate() {
            let of = move |item: &Item| value(kind, i, item)?.get(k).copied();
            add(format!("`{name}`"), Box::new(of));
        }
    }
    let is_point =
        |part: &Part| matches!(part.kind, Kind::Numbers(numbers) if numbers.name == VECTOR.name);
    let is_direction = |part: &Part| matches!(part.kind, Kind::Direction);
    for (k, (i, one)) in alone.iter().enumerate() {
        for (j, other) in &alone[k + 1..] {
            let (i, j) = (*i, *j);
            let both = move |item: &Item| value(kind, i, item).zip(value(kind, j, item));
            let names = format!("`{}` and `{}`", one.name, other.name);
            if is_point(one) && is_point(other) {
                let between = move |(a, b): (Vec<f64>, Vec<f64>)| {
                    a.iter()
                        .zip(b)
                        .map(|(a, b)| (b - a).powi(2))
                        .sum::<f64>()
                        .sqrt()
                };
                add(
                    format!("the distance between {names}"),
                    Box::new(move |item| both(item).map(between)),
                );
            } else if is_direction(one) && is_direction(other) {
                let cosine = move |(a, b): (Vec<f64>, Vec<f64>)| {
                    a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>()
                };
                add(
                    format!("the cosine between {names}"),
                    Box::new(move |item| both(item).map(cosine)),
                );
            }
        }
    }
    all
}

/// The numbers of a part that is in no list, if it is there.
pub fn value(kind: &Kind, part: usize, item: &Item) -> Option<Vec<f64>> {
    let fields = layout(kind, &item.question);
    let leaf = fields.of_part(part).next()?;
    Some(item.question[leaf.range()].to_vec())
}
