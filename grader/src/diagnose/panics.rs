//! What a function dies of where it has no guard: languages say it in their own words.

use super::{Beside, Diagnosis, MOST};

/// A way to end without an answer.
struct Death {
    /// Words of a message of a language or its library: CPython's, Rust's, or those of the standard library of C++.
    words: &'static [&'static str],
    name: &'static str,
    hint: &'static str,
}

const DEATHS: &[Death] = &[
    Death {
        words: &[
            "division by zero",
            "divide by zero",
            "divisor of zero",
            "modulo by zero",
        ],
        name: "divides by 0",
        hint: "Which denominator is 0 in the first case that stops with this error? Say what the answer is there before you divide.",
    },
    Death {
        words: &[
            "index out of range",
            "index out of bounds",
            "out of range for slice",
            "pop from empty list",
            "iterable argument is empty",
            "arg is an empty sequence",
            "_M_range_check",
        ],
        name: "takes something from a list that is not in it",
        hint: "How long is the list in the first case that stops with this error: may it be empty? Which is the last of its indices?",
    },
    Death {
        words: &[
            "'NoneType' object",
            "on a `None` value",
            "bad optional access",
            "bad_optional_access",
        ],
        name: "goes on with an answer that is none",
        hint: "Which of the functions that you call has no answer in the first case that stops with this error, and what is yours then?",
    },
    Death {
        words: &[
            "math domain error",
            "expected a nonnegative input",
            "expected a number in range from -1",
        ],
        name: "takes a root or an angle of a number that has none",
        hint: "Which number is below 0, or beyond ±1, in the first case that stops with this error? Say what the answer is there before you go on.",
    },
    Death {
        words: &["recursion depth exceeded"],
        name: "calls itself without end",
        hint: "In which case does your function return without calling itself, and does the first case that stops with this error ever come to it?",
    },
    Death {
        words: &["attempt to subtract with overflow"],
        name: "subtracts more from a whole number than there is",
        hint: "A number of an unsigned type cannot be below 0: which number is 0 in the first case that stops with this error, and what should happen then?",
    },
    Death {
        words: &[
            "add with overflow",
            "multiply with overflow",
            "cannot convert float",
            "math range error",
            "Result too large",
        ],
        name: "makes a whole number of a number that is infinite, NaN, or too large",
        hint: "Which number is it in the first case that stops with this error, and what is it allowed to be?",
    },
];

/// What was found in the answers, and what the messages of the function's panics have in common: first what explains more of the wrong cases.
pub fn with_panics(
    found: Option<Diagnosis>,
    messages: &[String],
    wrong: usize,
) -> Option<Diagnosis> {
    let Some(died) = common(messages, wrong) else {
        return found;
    };
    let Some(found) = found else {
        return Some(died);
    };
    let (mut first, second) = if found.explained > died.explained {
        (found, died)
    } else {
        (died, found)
    };
    first.also.insert(0, second);
    Some(first)
}

/// What most of the messages have in common.
fn common(messages: &[String], wrong: usize) -> Option<Diagnosis> {
    let of = |death: &&Death| {
        let said = |message: &&String| death.words.iter().any(|words| message.contains(words));
        messages.iter().filter(said).count()
    };
    let death = DEATHS.iter().max_by_key(of)?;
    let explained = of(&death);
    let most = explained > 0 && explained as f64 >= MOST * messages.len() as f64;
    most.then(|| Diagnosis {
        name: death.name.to_owned(),
        hint: death.hint.to_owned(),
        part: None,
        certain: explained == wrong,
        explained,
        wrong,
        beside: Beside::Apart,
        also: Vec::new(),
    })
}
