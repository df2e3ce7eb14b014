//! What can be misread of an interval.

use super::{How, Misreading};
use crate::layout::each;

/// The ways to misread an interval.
pub(super) fn interval(i: usize, name: &str, all: &mut Vec<Misreading>) {
    let mut value = |what: String, rank, hint: &str, f: fn(&mut [f64])| {
        all.push(Misreading::new(
            what,
            hint.replace("{}", name),
            rank,
            How::Value(i, Box::new(f)),
        ));
    };
    let is_inside = "Is every distance in your answer between the ends of `{}`?";
    let is_excluded = "Both ends of `{}` are excluded: what do your comparisons do with a distance that is just there?";
    value(
        format!("takes {name}.max itself to be inside the interval"),
        9,
        is_excluded,
        |v| v[1] = after(v[1]),
    );
    value(
        format!("takes {name}.min itself to be inside the interval"),
        9,
        is_excluded,
        |v| v[0] = before(v[0]),
    );
    value(
        format!("takes both ends of {name} to be inside the interval"),
        9,
        is_excluded,
        |v| {
            v[0] = before(v[0]);
            v[1] = after(v[1]);
        },
    );
    value(
        format!("ignores {name}.max"),
        10,
        "Something nearer may already have been hit: what is the end of `{}` for?",
        |v| v[1] = f64::INFINITY,
    );
    value(
        format!("ignores {name}.min"),
        10,
        "Where does `{}` begin, and what lies before that?",
        |v| v[0] = f64::NEG_INFINITY,
    );
    value(
        format!("takes 0 for {name}.min"),
        11,
        "Where does `{}` begin, and what lies before that?",
        |v| v[0] = 0.0,
    );
    value(format!("ignores {name}"), 11, is_inside, |v| {
        v[0] = f64::NEG_INFINITY;
        v[1] = f64::INFINITY;
    });
    value(
        format!("ignores {name} and takes all that lies ahead"),
        12,
        is_inside,
        |v| {
            v[0] = 0.0;
            v[1] = f64::INFINITY;
        },
    );
    value(
        format!("never takes less than a millimetre for {name}.min"),
        13,
        "The interval says already where hits begin to count: is there a small number of your own in your program?",
        |v| v[0] = v[0].max(1e-3),
    );
    value(
        format!("never takes less than 0.0001 for {name}.min"),
        14,
        "The interval says already where hits begin to count: is there a small number of your own in your program?",
        |v| v[0] = v[0].max(1e-4),
    );
    value(
        format!("never takes less than 0 for {name}.min"),
        12,
        "`{}` may begin behind the origin: what is there?",
        |v| v[0] = v[0].max(0.0),
    );
    value(
        format!("exchanges the ends of {name}"),
        13,
        "Which end of `{}` comes first?",
        |v| v.swap(0, 1),
    );
    value(
        format!("mirrors {name} at 0: from −max to −min"),
        16,
        "Which end of `{}` comes first, and with which sign?",
        |v| {
            v.swap(0, 1);
            each(v, |v| *v = -*v);
        },
    );
}

/// The number of the library's precision that comes next.
fn after(v: f64) -> f64 {
    (v as f32).next_up().into()
}

/// The number of the library's precision that comes before.
fn before(v: f64) -> f64 {
    (v as f32).next_down().into()
}
