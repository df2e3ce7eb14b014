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

/// The first lines of an output, under a heading; none if nothing was printed there.
fn told(heading: &str, output: &Untrusted) -> Vec<String> {
    /// More lines, or longer ones, nobody reads here.
    const MOST: usize = 12;
    const WIDEST: usize = 160;
    let count = full(output).count();
    if count == 0 {
        return Vec::new();
    }
    let mut lines = vec![format!("  {heading}:")];
    lines.extend(full(output).take(MOST).map(|line| {
        let line: String = line.to_string().chars().take(WIDEST).collect();
        format!("    | {line}")
    }));
    if count > MOST {
        lines.push(format!("    | … and {} more lines", count - MOST));
    }
    lines
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
