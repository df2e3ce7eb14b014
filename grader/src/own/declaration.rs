//! What an exercise asks and what it is answered, as its file says it.

use super::draw::Range;
use raybook_scenes::fields::Fields;
use raybook_scenes::wrong::{Source, TextError};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Field, Kind, Parts, Record, VECTOR};
use std::path::Path;

/// An exercise as its file declares it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Declaration {
    /// Its question and its answer. It lives as long as the command, as those do that are compiled in.
    pub asked: &'static Asked,
    /// The range of the numbers of each field of a question.
    pub ranges: &'static [Range],
    /// A number may differ by this share of its size, or of 1 if it is smaller.
    pub tolerance: f32,
    /// Whether the program judges the answers of hand-ins.
    pub judges: bool,
}

/// What is said of a kind that does not exist.
const KINDS: &str = "`kind` must be \"number\", \"whole\", \"vector\", \"direction\" or \"colour\", or one of them after \"optional \" or \"list of \"";

/// The colour of a pixel, or a radiance.
const COLOUR: &Parts = &Parts {
    name: "Rgb",
    parts: &["r", "g", "b"],
};

impl Declaration {
    /// The exercise that a file declares; its name is the file's.
    ///
    /// # Errors
    /// What is wrong in the file, with its line and column.
    pub fn read(file: &Path, text: &str) -> Result<Self, String> {
        let source = Source { path: file, text };
        of(source).map_err(|error| error.to_string())
    }
}

fn of(source: Source<'_>) -> Result<Declaration, TextError> {
    let stem = source.path.file_stem().and_then(|stem| stem.to_str());
    let is_name = |stem: &&str| {
        let mut letters = stem.bytes();
        letters
            .next()
            .is_some_and(|first| first.is_ascii_lowercase())
            && letters.all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_')
    };
    let Some(name) = stem.filter(is_name) else {
        let what = "an exercise is called like its file, in small letters, digits and underscores: lens_power.toml";
        return Err(source.wrong(0, what));
    };
    let parsed = source.parse()?;
    let top = Fields::new(source, "an exercise", 0, parsed.get_ref());
    let task = text(&top, "task")?;
    let mut fields = Vec::new();
    let mut ranges = Vec::new();
    for table in top.tables("question", "a field of the question")? {
        fields.push(field(&table)?);
        ranges.push(range(&table)?);
        table.finish()?;
    }
    if fields.is_empty() {
        let what = "what is asked? A [[question]] with `name`, `kind` and `meaning` is a field of the question";
        return Err(source.wrong(0, what));
    }
    let Some(answer) = top.table("answer", "the answer")? else {
        let what =
            "what is answered? An [answer] with `name`, `kind` and `meaning` must stand here";
        return Err(source.wrong(0, what));
    };
    let asked = Asked {
        name: keep(name),
        task,
        in_rust: "",
        question: Box::leak(Box::new(Kind::Record(Box::leak(Box::new(Record {
            name: keep(name),
            fields: fields.leak(),
        }))))),
        answer: field(&answer)?,
        // The program is asked instead.
        call: |_| Vec::new(),
    };
    answer.finish()?;
    let declaration = Declaration {
        asked: Box::leak(Box::new(asked)),
        ranges: ranges.leak(),
        tolerance: top
            .number("tolerance", 0.0..=1.0)?
            .unwrap_or(crate::judge::RELATIVE),
        judges: top.yes("judge")?.unwrap_or(false),
    };
    top.finish()?;
    Ok(declaration)
}

fn field(table: &Fields<'_>) -> Result<Field, TextError> {
    let name = text(table, "name")?;
    let meaning = text(table, "meaning")?;
    let kind = table.text("kind")?.and_then(kind);
    let kind = kind.ok_or_else(|| table.wrong("kind", KINDS))?;
    Ok(Field {
        name,
        kind: Box::leak(Box::new(kind)),
        meaning,
        range: None,
    })
}

/// A text that must be there.
fn text(table: &Fields<'_>, name: &'static str) -> Result<&'static str, TextError> {
    let found = table.text(name)?.map(keep);
    found.ok_or_else(|| table.wrong(name, format!("`{name} = \"…\"` must stand here")))
}

fn kind(words: &str) -> Option<Kind> {
    let inner = |words| -> Option<&'static Kind> { Some(Box::leak(Box::new(plain(words)?))) };
    if let Some(words) = words.strip_prefix("optional ") {
        return inner(words).map(Kind::Optional);
    }
    if let Some(words) = words.strip_prefix("list of ") {
        return inner(words).map(Kind::List);
    }
    plain(words)
}

fn plain(word: &str) -> Option<Kind> {
    Some(match word {
        "number" => Kind::Number,
        "whole" => Kind::Whole,
        "vector" => Kind::Numbers(VECTOR),
        "direction" => Kind::Direction,
        "colour" => Kind::Numbers(COLOUR),
        _ => return None,
    })
}

/// The numbers that hidden questions are drawn from: 0 to 1, if nothing is said.
fn range(table: &Fields<'_>) -> Result<Range, TextError> {
    const FINITE: std::ops::RangeInclusive<f64> = -1e9..=1e9;
    let from = table.precise("from", &FINITE)?.unwrap_or(0.0);
    let to = table.precise("to", &FINITE)?.unwrap_or(1.0);
    if from > to {
        let what = format!("the range goes from {from} to {to}: `from` must not be above `to`");
        return Err(table.wrong("from", what));
    }
    Ok(Range { from, to })
}

/// A text that is kept as long as the command runs.
fn keep(text: &str) -> &'static str {
    text.to_owned().leak()
}
