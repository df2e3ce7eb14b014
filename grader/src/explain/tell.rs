//! The account of a case in words, for a terminal.

use super::account::{Account, Named};
use super::parting::Parting;
use super::way::{Step, words};
use crate::check::Mark;
use crate::dress::Dress;
use crate::feedback;
use crate::prints::{abbreviated, printed, short};

/// More lines of one kind than these nobody reads in a terminal.
const MOST: usize = 24;

/// The lines.
pub fn lines(account: &Account<'_>, dress: Dress) -> Vec<String> {
    let outcome = account.outcome;
    let mut lines = feedback::heading(account.report, outcome, dress);
    let mut section = |title: &str, rows: Vec<String>| {
        if !rows.is_empty() {
            lines.extend([String::new(), format!("  {}", dress.paint("1", title))]);
            lines.extend(rows);
        }
    };
    section("What is asked", named(&account.asked));
    section("Your answer", named(&account.yours));
    let (right, part, should) = match (account.many, &outcome.verdict) {
        (true, _) => (
            "A right answer, one of many",
            "Where yours differs from it",
            "there",
        ),
        (_, Mark::Right) => (
            "The right answer",
            "Where they differ, which is right too",
            "should be",
        ),
        _ => ("The right answer", "Where they part", "should be"),
    };
    section(right, named(&account.right));
    section(part, partings(&account.partings, should));
    section("The way to the right answer", steps(&account.steps));
    if matches!(outcome.verdict, Mark::Wrong(_)) {
        section(
            "What explains it",
            feedback::diagnosis(account.report, dress),
        );
    }
    lines.extend(printed(outcome));
    lines.push(String::new());
    if let Some(chapter) = account.chapter {
        let (number, title, name) = (chapter.number(), chapter.title, chapter.name);
        lines.push(format!(
            "  Chapter {number} of the book, \"{title}\" ({name}.html), derives it."
        ));
    }
    lines
}

fn named(named: &[Named]) -> Vec<String> {
    let rows = named.iter().map(
        |Named {
             name,
             words,
             meaning,
         }| {
            [
                name.clone(),
                abbreviated(&short(words), 0),
                (*meaning).to_owned(),
            ]
        },
    );
    table(&rows.collect::<Vec<_>>())
}

/// Each number of one's own with the one that `should` says.
fn partings(partings: &[Parting], should: &str) -> Vec<String> {
    let row = |parting: &Parting| {
        let off = match parting.off() {
            Some(off) if off > 0.0 => format!("{} too large", number(off)),
            Some(off) => format!("{} too small", number(-off)),
            None => String::new(),
        };
        let both = format!(
            "{}, and {should} {}",
            number(parting.yours),
            number(parting.right)
        );
        [parting.field.clone(), both, off]
    };
    let mut lines = table(&partings.iter().take(MOST).map(row).collect::<Vec<_>>());
    lines.extend(more(partings.len()));
    lines
}

/// A number with seven digits.
fn number(v: f64) -> String {
    words(&[v])
}

fn steps(steps: &[Step]) -> Vec<String> {
    /// Of a long way the end is worth reading too: there is the answer.
    const END: usize = 8;
    let row = |step: &Step| {
        let value = format!("{} {}", words(&step.value), step.unit);
        let value = if step.value.is_empty() {
            "–"
        } else {
            value.trim_end()
        };
        [
            value.to_owned(),
            step.name.clone().into_owned(),
            String::new(),
        ]
    };
    let first = if steps.len() > MOST {
        MOST - END
    } else {
        steps.len()
    };
    let last = steps.len().saturating_sub(END).max(first);
    let shown = steps[..first].iter().chain(&steps[last..]);
    let mut lines = table(&shown.map(row).collect::<Vec<_>>());
    if last > first {
        lines.insert(
            first,
            format!("    … {} more (`--json` has all)", last - first),
        );
    }
    lines
}

fn more(all: usize) -> Option<String> {
    (all > MOST).then(|| format!("    … and {} more (`--json` has all)", all - MOST))
}

/// Rows of three columns, each as wide as its widest word, if that is not very wide.
fn table(rows: &[[String; 3]]) -> Vec<String> {
    const WIDEST: usize = 44;
    let width = |column: usize| {
        let wide = rows.iter().map(|row| row[column].chars().count());
        wide.filter(|wide| *wide <= WIDEST).max().unwrap_or(0)
    };
    let [first, second] = [width(0), width(1)];
    let line = |[a, b, c]: &[String; 3]| {
        format!("    {a:<first$}   {b:<second$}   {c}")
            .trim_end()
            .to_owned()
    };
    rows.iter().map(line).collect()
}
