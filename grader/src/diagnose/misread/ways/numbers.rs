//! What can be misread of a number.

use std::f64::consts::PI;

/// What is made of a number.
type Made = fn(f64) -> f64;

/// What is taken for `{}`, and how it is made.
type Scale = (&'static str, Made);

/// For each number of steps from 0 to 1: the number, and what is made of `v` if it is rounded down to a step, and to the nearest one.
macro_rules! in_steps {
    ($($steps:literal)+) => {
        [$((
            $steps,
            (|v| (f64::from($steps) * v).floor() / f64::from($steps)) as Made,
            (|v| (f64::from($steps) * v).round() / f64::from($steps)) as Made,
        )),+]
    };
}

/// The ways to misread a number.
#[allow(clippy::too_many_lines)] // a list of ways
pub(super) fn numbers(name: &str, each: &mut impl FnMut(String, u32, &str, Made)) {
    let ignored = "Change `{}` alone: does your answer change as it should?";
    let square = "Write down the formula with units: to which power does `{}` stand in it? If it is compared with something, are both sides squared, or neither?";
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
        square,
        |v| v * v,
    );
    each(
        format!(
            "takes the square root of {name} for {name}, as if {name} were compared with a square"
        ),
        15,
        square,
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
        format!("takes the absolute value |{name}| for {name}"),
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
    each(format!("subtracts 1 from {name}"), 17, factor, |v| v - 1.0);
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
    let most: [(u32, Made); 4] = [
        (10, |v| v.min(10.0)),
        (100, |v| v.min(100.0)),
        (1000, |v| v.min(1000.0)),
        (10_000, |v| v.min(10_000.0)),
    ];
    for (limit, cut) in most {
        each(
            format!("never takes more than {limit} for {name}"),
            15,
            "How large may `{}` be?",
            cut,
        );
    }
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
    let steps = in_steps!(10 100 255 256 511 512 1000 1023 1024 4096);
    let exact = "How exactly is `{}` known where you use it? Look for a table, for a conversion to bytes, for `round`.";
    for (steps, down, near) in steps {
        let of = format!("takes {name} in steps of 1/{steps}");
        each(
            format!("{of}, rounded down, as from a table or a byte"),
            21,
            exact,
            down,
        );
        each(format!("{of}, as from a table or a byte"), 21, exact, near);
    }
    each(format!("takes a quarter of {name}"), 19, factor, |v| {
        0.25 * v
    });
    each(format!("takes four times {name}"), 19, factor, |v| 4.0 * v);
    let scales: [Scale; 8] = [
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

/// The ways to misread a whole number.
pub(super) fn wholes(name: &str, each: &mut impl FnMut(String, u32, &str, Made)) {
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
