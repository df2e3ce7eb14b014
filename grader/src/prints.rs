//! What a student's program printed on the way to an answer.

use crate::ask::Said;
use crate::check::Outcome;
use raybook_chapters::kit::untrusted::Untrusted;

/// The student's own prints, and what may be meant as an answer among them.
pub fn printed(outcome: &Outcome) -> Vec<String> {
    let printed = &outcome.reply.printed;
    let mut lines = told("Printed on the way", &printed.stdout);
    lines.extend(told("On standard error", &printed.stderr));
    let meant = full(&printed.stdout).any(|line| seems_an_answer(line.unescaped()));
    if meant && !matches!(outcome.reply.said, Said::Answer(_)) {
        lines.push("  An answer must begin its line with `= `. Is one of these meant to be one? Write that before it, and end what is printed before with a newline.".to_owned());
    }
    lines
}

/// Words from outside, cut where nobody reads on.
pub fn short(text: &Untrusted) -> String {
    const LONGEST: usize = 2000;
    let text = text.to_string();
    match text.char_indices().nth(LONGEST) {
        None => text,
        Some((cut, _)) => format!("{}… ({} bytes)", &text[..cut], text.len()),
    }
}

/// The words of a long list, cut to some elements from this one on; what is short stays whole.
pub fn abbreviated(words: &str, from: usize) -> String {
    /// Letters that a person reads.
    const WIDE: usize = 160;
    /// Words that are shown of a longer list.
    const SHOWN: usize = 12;
    let all: Vec<_> = words.split_whitespace().collect();
    if words.len() <= WIDE {
        return words.to_owned();
    }
    let Some((count, size)) = elements(&all) else {
        return short(&words.into());
    };
    let first = from.min(count - 1);
    let shown = (SHOWN / size).max(1).min(count - first);
    let text: Vec<_> = all[1..][first * size..][..shown * size]
        .chunks(size)
        .map(|element| element.join(" "))
        .collect();
    let (before, after) = (
        if first > 0 { "… " } else { "" },
        if first + shown < count { " …" } else { "" },
    );
    format!(
        "{before}{}{after}   ({count} in all, these from {first} on)",
        text.join("  ")
    )
}

/// Where two lists begin to differ by more than the last digits; 0 if they do not, or are no lists.
pub fn first_difference(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|words| words.split_whitespace().collect::<Vec<_>>());
    let (Some((count, size)), Some((_, other))) = (elements(&a), elements(&b)) else {
        return 0;
    };
    let alike = |a: &str, b: &str| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => a == b || (a - b).abs() <= 1e-3 * a.abs().max(b.abs()).max(1e-3),
        _ => a == b,
    };
    let differ = |i: &usize| {
        let [a, b] = [&a, &b].map(|words| words.get(1 + i * size..1 + (i + 1) * size));
        match (a, b) {
            (Some(a), Some(b)) => !a.iter().zip(b).all(|(a, b)| alike(a, b)),
            _ => true,
        }
    };
    if size != other {
        return 0;
    }
    (0..count).find(differ).unwrap_or(0)
}

/// The length of a list, and the words of an element; none if the words are no list of elements of one size.
fn elements(words: &[&str]) -> Option<(usize, usize)> {
    let count: usize = words.first()?.parse().ok().filter(|&count| count > 0)?;
    let rest = words.len() - 1;
    (rest >= count && rest.is_multiple_of(count)).then_some((count, rest / count))
}

/// The first and the last lines of an output, under a heading; none if nothing was printed there. What went wrong stands in the last
/// lines where Python tells it, and in the first where others do.
fn told(heading: &str, output: &Untrusted) -> Vec<String> {
    /// More lines nobody reads here.
    const FIRST: usize = 8;
    const LAST: usize = 4;
    let count = full(output).count();
    if count == 0 {
        return Vec::new();
    }
    let line = |line: Untrusted| format!("    | {}", ends(&line.to_string()));
    let mut lines = vec![format!("  {heading}:")];
    if count > FIRST + LAST + 1 {
        lines.extend(full(output).take(FIRST).map(line));
        lines.push(format!("    | … {} lines …", count - FIRST - LAST));
        lines.extend(full(output).skip(count - LAST).map(line));
    } else {
        lines.extend(full(output).map(line));
    }
    lines
}

/// A line without its middle if it is long: an error begins with the place, and ends with what is wrong.
fn ends(line: &str) -> String {
    const BEGIN: usize = 80;
    const END: usize = 79;
    let letters: Vec<char> = line.chars().collect();
    if letters.len() <= BEGIN + END + 1 {
        return line.to_owned();
    }
    let (begin, end) = (&letters[..BEGIN], &letters[letters.len() - END..]);
    begin.iter().chain(&['…']).chain(end).collect()
}

/// The lines that are not empty.
fn full(output: &Untrusted) -> impl Iterator<Item = Untrusted> {
    output
        .lines()
        .filter(|line| !line.unescaped().trim().is_empty())
}

/// Whether a line would be an answer if it began as one: `=` stands somewhere, or there are only numbers.
fn seems_an_answer(line: &str) -> bool {
    line.contains("= ")
        || line
            .split_whitespace()
            .all(|word| word.trim_start_matches('=').parse::<f64>().is_ok())
}
