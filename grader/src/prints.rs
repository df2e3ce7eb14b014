//! What a student's program printed on the way to an answer.

use crate::ask::Said;
use crate::check::Outcome;

/// The student's own prints, and what may be meant as an answer among them.
pub fn printed(outcome: &Outcome) -> Vec<String> {
    /// More lines, or longer ones, nobody reads here.
    const MOST: usize = 12;
    const WIDEST: usize = 160;
    let visible = |c: char| {
        if c.is_control() && c != '\t' {
            '\u{fffd}'
        } else {
            c
        }
    };
    let printed: Vec<_> = outcome
        .reply
        .printed
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    let mut lines = Vec::new();
    if !printed.is_empty() {
        lines.push("  Printed on the way:".to_owned());
    }
    lines.extend(printed.iter().take(MOST).map(|line| {
        format!(
            "    | {}",
            line.chars().map(visible).take(WIDEST).collect::<String>()
        )
    }));
    if printed.len() > MOST {
        lines.push(format!("    | … and {} more lines", printed.len() - MOST));
    }
    let meant = printed.iter().any(|line| seems_an_answer(line));
    if meant && !matches!(outcome.reply.said, Said::Answer(_)) {
        lines.push("  An answer must begin its line with `= `. Is one of these meant to be one? Write that before it, and end what is printed before with a newline.".to_owned());
    }
    lines
}

/// Whether a line would be an answer if it began as one: `=` stands somewhere, or there are only numbers.
fn seems_an_answer(line: &str) -> bool {
    line.contains("= ")
        || line
            .split_whitespace()
            .all(|word| word.trim_start_matches('=').parse::<f64>().is_ok())
}
