//! What a function dies of where it has no guard: languages say it in their own words.

use super::{Beside, Diagnosis, MOST};
use crate::ask::Said;
use crate::check::Outcome;
use raybook_chapters::kit::untrusted::Untrusted;

/// A way to end without an answer.
struct Death {
    /// Words of a message of a language or its library: CPython's, Rust's, or those of the standard library of C++.
    words: &'static [&'static str],
    name: &'static str,
    hint: &'static str,
}

const DEATHS: &[Death] = &[
    Death {
        words: &["SyntaxError", "IndentationError", "TabError"],
        name: "is in a file that Python cannot read",
        hint: "Python reads all of a file before it calls a function of it: look at the line that the message shows, and at the one before it, for a bracket, a colon or an indentation that is missing.",
    },
    Death {
        words: &["ModuleNotFoundError", "ImportError"],
        name: "imports what is not there",
        hint: "Is the module that the message names installed for the Python that runs your program? If it is a file of this folder: is it there, under this name? `raybook new` makes another folder with all of them, from which you can copy it.",
    },
    Death {
        words: &["NameError"],
        name: "uses a name that means nothing there",
        hint: "Is the name in the message spelt as where it is given a value, and does every way to that line pass the place where it is? Is what it stands for imported?",
    },
    Death {
        words: &["AttributeError"],
        name: "asks for a member that is not there",
        hint: "The comment of the function names the members of all that it is given: which of them is meant?",
    },
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

/// What is said of an error that no language is known for.
const ANY: Death = Death {
    words: &[""],
    name: "stops with an error",
    hint: "Read the message of that case, and print what stands in the line that it names.",
};

/// A mistake that explains this many answers, and all that came, is told before the error.
const CAME: usize = 3;

/// What was found in the answers, and what the errors with which the function stops have in common, with the first case that does:
/// first what explains more of the wrong cases.
pub fn with_panics(
    found: Option<Diagnosis>,
    outcomes: &[Outcome],
    wrong: usize,
) -> Option<Diagnosis> {
    let Some(mut died) = common(outcomes, wrong) else {
        return found;
    };
    let Some(found) = found else {
        return Some(died);
    };
    // Of a function that stops in all wrong cases there is nothing to see but in which.
    if outcomes.iter().filter(|one| message(one).is_some()).count() == wrong {
        died.also.push(Diagnosis {
            beside: Beside::Shown,
            ..found
        });
        return Some(died);
    }
    // What explains every answer that came goes wrong in the others, too.
    let is_cause = found.explained >= CAME && found.explained + died.explained >= wrong;
    let (mut first, second) = if is_cause || found.explained > died.explained {
        (found, died)
    } else {
        (died, found)
    };
    first.also.insert(0, second);
    Some(first)
}

/// What most of the errors have in common.
fn common(outcomes: &[Outcome], wrong: usize) -> Option<Diagnosis> {
    let stopped: Vec<_> = outcomes
        .iter()
        .filter(|one| message(one).is_some())
        .collect();
    let is_of = |death: &Death, one: &Outcome| {
        let says = |message: &str| death.words.iter().any(|words| message.contains(words));
        message(one).is_some_and(says)
    };
    let count = |death: &Death| stopped.iter().filter(|one| is_of(death, one)).count();
    let most = DEATHS.iter().max_by_key(|death| count(death))?;
    let has_most = count(most) as f64 >= MOST * stopped.len() as f64;
    let death = if has_most { most } else { &ANY };
    let first = stopped.iter().find(|one| is_of(death, one))?;
    let explained = count(death);
    Some(Diagnosis {
        name: death.name.to_owned(),
        hint: format!("{} {}", death.hint, told(first)),
        part: None,
        // An error's message is no guess.
        certain: true,
        explained,
        wrong,
        further: 0,
        shown: outcomes.iter().position(|one| is_of(death, one)),
        beside: Beside::Apart,
        also: Vec::new(),
    })
}

/// The message of a function that stopped with an error.
fn message(outcome: &Outcome) -> Option<&str> {
    match &outcome.reply.said {
        Said::Panicked(message) => Some(message.unescaped()),
        _ => None,
    }
}

/// Which case stops with an error, and in which line, if the program printed that.
fn told(outcome: &Outcome) -> String {
    let printed = &outcome.reply.printed;
    let outputs = [&printed.stderr, &printed.stdout];
    let place = outputs
        .into_iter()
        .find_map(|output| place(output.unescaped()));
    let place = place.map_or(String::new(), |place| {
        format!(", in {}", Untrusted::from(place))
    });
    let case = &outcome.case;
    format!("It is case {}, \"{}\"{place}.", case.number, case.name)
}

/// The innermost place that an error's report names, as `file:line`: in the words of Python, or of Rust.
fn place(report: &str) -> Option<String> {
    let of_python = |line: &str| {
        let (path, rest) = line
            .trim()
            .strip_prefix("File \"")?
            .split_once("\", line ")?;
        let file = path.rsplit(['/', '\\']).next()?;
        let line: u32 = rest.split(',').next()?.parse().ok()?;
        Some(format!("{file}:{line}"))
    };
    let of_rust = |line: &str| {
        let place = line.trim().strip_prefix("panicked at ")?;
        Some(place.trim_end_matches(':').to_owned())
    };
    let place = |line| of_python(line).or_else(|| of_rust(line));
    report.lines().rev().find_map(place)
}
