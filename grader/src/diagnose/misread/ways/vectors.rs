//! What can be misread of a vector.

use super::{Change, How, Misreading};
use crate::layout::each;

/// The ways to misread a vector, or a direction if it is of unit length.
#[allow(clippy::too_many_lines)] // a list of ways
pub(super) fn vector(
    i: usize,
    name: &str,
    axes: &'static [&'static str],
    unit: bool,
    all: &mut Vec<Misreading>,
) {
    let mut value = |what: String, rank, hint: &str, f: Change| {
        all.push(Misreading::new(
            what,
            hint.replace("{}", name),
            rank,
            How::Value(i, f),
        ));
    };
    let ignored = "Change `{}` alone: does your answer change as it should?";
    // A direction points somewhere; other numbers may be a place or a size.
    let (what, leads_on) = if unit {
        (
            format!("turns {name} round"),
            "From where to where does `{}` point?",
        )
    } else {
        (
            format!("takes −{name} for {name}: the signs of all its components are wrong"),
            "Wherever `{}` stands in your formula: is it added or subtracted there, and should it be?",
        )
    };
    value(what, 11, leads_on, Box::new(|v| each(v, |v| *v = -*v)));
    if unit {
        for (axis, k) in axes.iter().zip(0..) {
            for (sign, s) in [("+", 1.0), ("-", -1.0)] {
                value(
                    format!("takes {sign}{axis} for {name}, whatever it is"),
                    15,
                    ignored,
                    Box::new(move |v| {
                        v.fill(0.0);
                        v[k] = s;
                    }),
                );
            }
        }
    } else {
        value(
            format!("takes 0 for {name}, as if it were ignored"),
            12,
            ignored,
            Box::new(|v| v.fill(0.0)),
        );
        value(
            format!("takes 1 for each component of {name}, as if it were ignored"),
            14,
            ignored,
            Box::new(|v| v.fill(1.0)),
        );
        value(
            format!("takes twice {name}"),
            15,
            "Write down the formula: by which number is `{}` multiplied?",
            Box::new(|v| each(v, |v| *v *= 2.0)),
        );
        value(
            format!("takes half of {name}"),
            15,
            "Write down the formula: by which number is `{}` multiplied?",
            Box::new(|v| each(v, |v| *v *= 0.5)),
        );
        value(
            format!("normalises {name}"),
            16,
            "Is `{}` a direction, or does its length matter?",
            Box::new(|v| {
                let length = v.iter().map(|v| v * v).sum::<f64>().sqrt();
                if length > 0.0 {
                    each(v, |v| *v /= length);
                }
            }),
        );
        value(
            format!("takes the mean of the components of {name} for each of them"),
            17,
            "Each component of `{}` has a meaning of its own: which?",
            Box::new(|v| {
                let mean = v.iter().sum::<f64>() / v.len() as f64;
                v.fill(mean);
            }),
        );
        value(
            format!("takes the absolute value of each component of {name}"),
            18,
            "What if a component of `{}` is negative?",
            Box::new(|v| each(v, |v| *v = v.abs())),
        );
        value(
            format!("squares {name}"),
            19,
            "To which power does `{}` stand in the formula?",
            Box::new(|v| each(v, |v| *v *= *v)),
        );
    }
    if !unit {
        value(
            format!("counts {name} from the opposite corner: 1 minus each of its components"),
            10,
            "From which corner is `{}` counted, and in which direction does each component of it grow?",
            Box::new(|v| each(v, |v| *v = 1.0 - *v)),
        );
    }
    if !unit && axes.len() == 2 {
        const DEVICE: &str = "From where to where does each component of `{}` go: from −1 to 1, or from 0 to 1? And where is its origin?";
        value(
            format!("takes {name} as from −1 to 1 in both directions, and y upwards"),
            12,
            DEVICE,
            Box::new(|v| (v[0], v[1]) = (0.5 + 0.5 * v[0], 0.5 - 0.5 * v[1])),
        );
        value(
            format!("takes {name} as from −1 to 1 in both directions"),
            12,
            DEVICE,
            Box::new(|v| each(v, |v| *v = 0.5 + 0.5 * *v)),
        );
    }
    for (axis, k) in axes.iter().zip(0..) {
        value(
            format!("has the sign of {name}.{axis} wrong"),
            13,
            "Which way does each component of `{}` point?",
            Box::new(move |v| v[k] = -v[k]),
        );
        value(
            format!("ignores {name}.{axis}"),
            14,
            ignored,
            Box::new(move |v| v[k] = 0.0),
        );
        if !unit {
            value(
                format!("takes 1 − {name}.{axis} for {name}.{axis}: from the other end"),
                14,
                "From which end is each component of `{}` counted?",
                Box::new(move |v| v[k] = 1.0 - v[k]),
            );
            value(
                format!("takes {name}.{axis} for every component of {name}"),
                15,
                "Each component of `{}` has a meaning of its own: which?",
                Box::new(move |v| {
                    let one = v[k];
                    v.fill(one);
                }),
            );
            for (much, words) in [
                (0.5, "a half"),
                (-0.5, "minus a half"),
                (1.0, "1"),
                (-1.0, "−1"),
            ] {
                value(
                    format!("adds {words} to {name}.{axis}"),
                    18,
                    "Which place does `{}` mean when it is 0?",
                    Box::new(move |v| v[k] += much),
                );
            }
        }
        for (other, l) in axes.iter().zip(0..).skip(k + 1) {
            value(
                format!("exchanges {name}.{axis} and {name}.{other}"),
                12,
                "Which component of `{}` comes first, and what does it mean?",
                Box::new(move |v| v.swap(k, l)),
            );
        }
    }
}
