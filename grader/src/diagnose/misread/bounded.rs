//! A number of the question that is kept within bounds which nobody asked for, such as a film that never comes to its edge: round numbers, which
//! people write into their programs.

use super::{How, Misreading, RARE};
use crate::layout::parts;
use raybook_workbook::kind::Kind;

/// What leads on from a bound.
const BOUND: &str = "Where do you cut this number off, and does the task say that you may?";

/// The first digits of round numbers.
const DIGITS: [f64; 5] = [1.0, 2.0, 4.0, 5.0, 8.0];

/// The powers of ten of round numbers.
const POWERS: std::ops::RangeInclusive<i32> = -3..=3;

/// Each number of a question that is there once, and each component of a vector, kept within round bounds.
pub fn bounded(kind: &'static Kind) -> Vec<Misreading> {
    let mut all = Vec::new();
    for (i, part) in parts(kind, "question").iter().enumerate() {
        if part.list.is_some() {
            continue;
        }
        let name = &part.name;
        match part.kind {
            Kind::Number => add(i, name, None, &mut all),
            Kind::Numbers(of) => {
                add(i, name, None, &mut all);
                for (k, axis) in of.parts.iter().enumerate() {
                    add(i, &format!("{name}.{axis}"), Some(k), &mut all);
                }
            }
            _ => {}
        }
    }
    all
}

/// One number, or all of a part.
fn add(part: usize, name: &str, only: Option<usize>, all: &mut Vec<Misreading>) {
    let rounds = POWERS.flat_map(|power| DIGITS.map(|digit| digit * 10_f64.powi(power)));
    let infinity = f64::INFINITY;
    for bound in rounds {
        let at_most = format!("takes at most {bound} for {name}");
        let at_least = format!("takes at least {bound} for {name}");
        let around_0 = format!("keeps {name} between −{bound} and {bound}");
        let mut ways = vec![
            (at_most, -infinity, bound),
            (at_least, bound, infinity),
            (around_0, -bound, bound),
        ];
        if bound < 0.5 {
            let most = 1.0 - bound;
            let inside = format!("keeps {name} between {bound} and {most}");
            ways.push((inside, bound, most));
        }
        for (what, least, most) in ways {
            let keep = move |v: &mut [f64]| {
                for (k, v) in v.iter_mut().enumerate() {
                    if only.is_none_or(|only| only == k) {
                        *v = v.clamp(least, most);
                    }
                }
            };
            let how = How::Value(part, Box::new(keep));
            all.push(Misreading::new(what, BOUND.to_owned(), RARE, how));
        }
    }
}
