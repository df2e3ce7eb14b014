//! The ways: what can be misread of a number, an interval, a vector, of two fields, and of a list.

use super::{Change, How, Misreading};
use crate::layout::{Part, each};
use raybook_workbook::kind::{Kind, VECTOR};
use std::f64::consts::PI;

pub(super) fn of_part(i: usize, part: &Part, all: &mut Vec<Misreading>) {
    let name = &part.name;
    let mut each = |what: String, rank, hint: &str, f| {
        all.push(Misreading::new(
            what,
            hint.replace("{}", name),
            rank,
            How::Each(i, f),
        ));
    };
    match part.kind {
        Kind::Number => {
            numbers(name, &mut each);
        }
        Kind::Whole => {
            let counted = "Count by hand for the smallest case: does `{}` begin at 0 or at 1, and is its last value counted?";
            each(format!("takes one more than {name}"), 24, counted, |v| {
                v + 1.0
            });
            each(format!("takes one less than {name}"), 24, counted, |v| {
                (v - 1.0).max(1.0)
            });
            each(
                format!("takes twice {name}"),
                26,
                "What does `{}` count?",
                |v| 2.0 * v,
            );
            each(
                format!("takes half of {name}"),
                26,
                "What does `{}` count?",
                |v| (0.5 * v).floor().max(1.0),
            );
            each(
                format!("takes 1 for {name}"),
                25,
                "Change `{}` alone: does your answer change as it should?",
                |_| 1.0,
            );
        }
        Kind::Numbers(numbers) if numbers.name == "Interval" => interval(i, name, all),
        Kind::Numbers(numbers) => vector(i, name, numbers.parts, false, all),
        Kind::Direction => vector(i, name, VECTOR.parts, true, all),
        _ => {}
    }
}

#[allow(clippy::too_many_lines)] // a list of ways
fn numbers(name: &str, each: &mut impl FnMut(String, u32, &str, fn(f64) -> f64)) {
    let ignored = "Change `{}` alone: does your answer change as it should?";
    let power = "Write down the formula with units: to which power does `{}` stand in it?";
    let factor = "Write down the formula: by which number is `{}` multiplied or divided?";
    each(
        format!("has the sign of {name} wrong"),
        11,
        "Turn the sign of `{}` round by hand: which way should your answer move?",
        |v| -v,
    );
    each(
        format!("takes 0 for {name}, as if it were ignored"),
        12,
        ignored,
        |_| 0.0,
    );
    each(
        format!("takes 1 for {name}, as if it were ignored"),
        12,
        ignored,
        |_| 1.0,
    );
    each(
        format!("takes {name} in degrees for radians, or forgets to convert it"),
        13,
        "Is the angle `{}` in degrees or in radians, and which does your sine or cosine want?",
        |v| v * 180.0 / PI,
    );
    each(
        format!("converts {name} from degrees although it is in radians"),
        13,
        "Is `{}` an angle in degrees at all?",
        |v| v * PI / 180.0,
    );
    each(
        format!("takes the square of {name} for {name}"),
        15,
        power,
        |v| v * v,
    );
    each(
        format!("takes the square root of {name} for {name}"),
        15,
        power,
        |v| v.max(0.0).sqrt(),
    );
    each(
        format!("takes the reciprocal of {name}, 1/{name}"),
        14,
        "Is `{}` above or below the fraction line?",
        |v| 1.0 / v,
    );
    each(
        format!("takes twice {name}, as a diameter for a radius, or a whole for a half"),
        15,
        factor,
        |v| 2.0 * v,
    );
    each(
        format!("takes half of {name}, as a radius for a diameter, or a half for a whole"),
        15,
        factor,
        |v| 0.5 * v,
    );
    each(
        format!("takes the size of {name} without its sign, |{name}|"),
        16,
        "What if `{}` is negative?",
        f64::abs,
    );
    each(
        format!("takes 1 − {name} for {name}"),
        16,
        "From which end is `{}` counted?",
        |v| 1.0 - v,
    );
    each(format!("adds 1 to {name}"), 17, factor, |v| v + 1.0);
    each(format!("takes 1 from {name}"), 17, factor, |v| v - 1.0);
    each(format!("adds 2 to {name}"), 18, factor, |v| v + 2.0);
    each(
        format!("clamps {name} to the range from 0 to 1"),
        17,
        "Which values may `{}` have?",
        |v| v.clamp(0.0, 1.0),
    );
    each(
        format!("clamps {name} at 0"),
        17,
        "May `{}` be negative, and what does that mean?",
        |v| v.max(0.0),
    );
    each(
        format!("rounds {name} down to a whole number"),
        17,
        "Is `{}` a whole number? Look for a division of integers, or for the wrong type.",
        f64::floor,
    );
    each(
        format!("rounds {name} to a whole number"),
        17,
        "Is `{}` a whole number? Look for the wrong type.",
        f64::round,
    );
    each(format!("takes a quarter of {name}"), 19, factor, |v| {
        0.25 * v
    });
    each(format!("takes four times {name}"), 19, factor, |v| 4.0 * v);
    let scales: [(&str, fn(f64) -> f64); 8] = [
        ("three times {}", |v| 3.0 * v),
        ("a third of {}", |v| v / 3.0),
        ("ten times {}", |v| 10.0 * v),
        ("a tenth of {}", |v| 0.1 * v),
        ("π times {}", |v| PI * v),
        ("{} divided by π", |v| v / PI),
        ("2.2 times {}", |v| 2.2 * v),
        ("{} divided by 2.2", |v| v / 2.2),
    ];
    for (words, scaled) in scales {
        let words = words.replace("{}", name);
        each(format!("takes {words}"), 20, factor, scaled);
    }
    each(
        format!("takes {name} in millimetres for metres"),
        19,
        "In which unit is `{}`?",
        |v| 1e-3 * v,
    );
    each(
        format!("takes a thousand times {name}, as metres for millimetres"),
        19,
        "In which unit is `{}`?",
        |v| 1e3 * v,
    );
    each(
        format!("has the sign of {name} turned and takes its reciprocal"),
        29,
        factor,
        |v| -1.0 / v,
    );
}

fn interval(i: usize, name: &str, all: &mut Vec<Misreading>) {
    let mut value = |what: String, rank, hint: &str, f: fn(&mut [f64])| {
        all.push(Misreading::new(
            what,
            hint.replace("{}", name),
            rank,
            How::Value(i, Box::new(f)),
        ));
    };
    let is_inside = "Is every distance in your answer between the ends of `{}`?";
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
        format!("turns {name} round"),
        16,
        "Which end of `{}` comes first, and with which sign?",
        |v| {
            v.swap(0, 1);
            each(v, |v| *v = -*v);
        },
    );
}

#[allow(clippy::too_many_lines)] // a list of ways
fn vector(
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
    value(
        format!("turns {name} round, the sign of all its components"),
        11,
        "From where to where does `{}` point?",
        Box::new(|v| each(v, |v| *v = -*v)),
    );
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
            format!("takes 1 for all of {name}, as if it were ignored"),
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
            format!("takes the size of each component of {name}, without its sign"),
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

pub(super) fn of_pair(
    (i, one): (usize, &Part),
    (j, other): (usize, &Part),
    all: &mut Vec<Misreading>,
) {
    let (a, b) = (&one.name, &other.name);
    let mut pair = |what: String, rank, hint: String, f| {
        let how = How::Pair(i, j, f);
        all.push(Misreading::new(what, hint, rank, how));
    };
    pair(
        format!("exchanges {a} and {b}"),
        11,
        format!(
            "Which of your arguments is `{a}`, and which is `{b}`? Let one of them be 1 and the other 2, and calculate by hand."
        ),
        <[f64]>::swap_with_slice,
    );
    let twice = format!(
        "Change `{a}` alone, then `{b}` alone: does your answer change both times as it should?"
    );
    pair(
        format!("takes {a} for {b} too"),
        14,
        twice.clone(),
        |a, b| b.copy_from_slice(a),
    );
    pair(format!("takes {b} for {a} too"), 14, twice, |a, b| {
        a.copy_from_slice(b);
    });
    if matches!(one.kind, Kind::Direction | Kind::Whole) {
        return;
    }
    let relative = format!("Is `{a}` measured from `{b}` or from somewhere else? Draw both.");
    pair(
        format!("takes {a} − {b} for {a}"),
        17,
        relative.clone(),
        |a, b| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a -= *b);
        },
    );
    pair(
        format!("takes {b} − {a} for {b}"),
        17,
        relative.clone(),
        |a, b| {
            b.iter_mut().zip(a).for_each(|(b, a)| *b -= *a);
        },
    );
    pair(
        format!("takes {a} + {b} for {a}"),
        18,
        relative.clone(),
        |a, b| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a += *b);
        },
    );
    pair(format!("takes {a} + {b} for {b}"), 18, relative, |a, b| {
        b.iter_mut().zip(a).for_each(|(b, a)| *b += *a);
    });
}

pub(super) fn of_list(list: usize, name: &str, all: &mut Vec<Misreading>) {
    let mut push = |what: String, rank, hint: &str, which| {
        let how = How::List(list, which);
        let hint = hint.to_owned();
        all.push(Misreading::new(what, hint, rank, how));
    };
    let loops = "Where does your loop begin, and where does it end?";
    push(
        format!("leaves out the first of the list ({name})"),
        12,
        loops,
        |n| (1..n).collect(),
    );
    push(
        format!("leaves out the last of the list ({name})"),
        12,
        loops,
        |n| (0..n.saturating_sub(1)).collect(),
    );
    push(
        format!("looks at the first of the list only ({name})"),
        13,
        "What about the others in the list?",
        |n| (0..n.min(1)).collect(),
    );
    push(
        format!("looks at the last of the list only ({name})"),
        13,
        "What about the others in the list? Is a result overwritten in every round?",
        |n| (n.saturating_sub(1)..n).collect(),
    );
    push(
        format!("goes through the list backwards ({name})"),
        14,
        "In which order do you go through the list?",
        |n| (0..n).rev().collect(),
    );
    push(
        format!("ignores the list ({name})"),
        14,
        "What would your answer be if the list were empty?",
        |_| Vec::new(),
    );
    push(
        format!("looks at every second of the list only ({name})"),
        18,
        loops,
        |n| (0..n).step_by(2).collect(),
    );
}
