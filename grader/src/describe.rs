//! What an exercise asks: task, place, every field with its kind, its range, its meaning and unit, an example, the number of cases.

use crate::examine::{Case, Examiner, visible_rng};
use crate::library;
use crate::limits::limits;
use crate::rare::Depth;
use crate::seen::Seen;
use raybook_workbook::kind::{Field, Kind, Record};
use serde_json::{Value, json};

/// An exercise, its visible cases, and what occurs in these and in what is asked of who answers them rightly.
struct Described {
    cases: Vec<Case>,
    asked: Seen,
    answered: Seen,
}

impl Described {
    fn new(examiner: &dyn Examiner) -> Self {
        let asked = examiner.asked();
        let cases = examiner.cases(&mut visible_rng(asked.name)).cases;
        let followers = examiner.followers(&cases);
        let all = || cases.iter().chain(followers.iter().map(|one| &one.case));
        let questions = all().flat_map(|case| asked.read_question(&case.question));
        let questions: Vec<_> = questions
            .chain(examiner.further_questions(&cases))
            .chain(examiner.rare_questions(&cases, Depth::Grade))
            .chain(pixels(examiner))
            .collect();
        let answers = all().flat_map(|case| &case.answers);
        let answers: Vec<_> = answers.flat_map(|row| asked.read_answer(row)).collect();
        Self {
            asked: Seen::in_rows(asked.question, questions.iter().map(Vec::as_slice)),
            answered: Seen::in_rows(asked.answer.kind, answers.iter().map(Vec::as_slice)),
            cases,
        }
    }
}

/// The questions of the pictures' pixels.
fn pixels(examiner: &dyn Examiner) -> Vec<Vec<f64>> {
    let pictures = (0..).map_while(|i| Some((i, examiner.picture(i)?)));
    let each = pictures.flat_map(|(i, size)| {
        let rows = move |y| (0..size.width).map(move |x| (i, x, y));
        (0..size.height).flat_map(rows)
    });
    each.filter_map(|(i, x, y)| examiner.pixel(i, x, y))
        .collect()
}

/// The description of an exercise for people who write it in this file, if that is known. Who writes a whole `program`, and no
/// function of a workbook that reads the questions, is told how.
pub fn describe(examiner: &dyn Examiner, place: Option<&str>, program: bool) -> String {
    let described = Described::new(examiner);
    let asked = examiner.asked();
    let name = asked.name;
    let mut lines = vec![name.to_owned(), format!("  {}", asked.task)];
    lines.extend(place.map(|file| format!("  Write it in {file}.")));
    lines.extend([
        String::new(),
        "  A question is the name and these words, on one line:".to_owned(),
        format!("    {name} {}", asked.question_names().join(" ")),
        String::new(),
    ]);
    let mut rows = Vec::new();
    of_parts(asked.question, &described.asked, 0, &mut rows);
    lines.extend(table("asked", &rows));
    let answer = asked.answer_names().join(" ");
    lines.extend([
        String::new(),
        match answer.strip_prefix("none | ") {
            Some(_) => "  An answer is `= none`, or `=` and these words:".to_owned(),
            None => "  An answer is `=` and these words:".to_owned(),
        },
        format!(
            "    = {}",
            answer.strip_prefix("none | ").unwrap_or(&answer)
        ),
        String::new(),
    ]);
    let mut rows = Vec::new();
    of_field(&asked.answer, &described.answered, 0, &mut rows);
    lines.extend(table("answered", &rows));
    lines.push(String::new());
    lines.push("  Limits, found out from the visible cases and the judge:".to_owned());
    let limits = limits(examiner, &described.cases);
    lines.extend(limits.iter().map(|limit| format!("  - {limit}")));
    lines.push(String::new());
    if program && described.asked.has_infinity() {
        lines.push("  Numbers may be `inf` or `-inf`: in C++ read a word and call `std::strtod`; `std::cin >> x` does not read them.".to_owned());
    }
    if let Some(case) = described.cases.first() {
        lines.extend([
            format!("  For example ({}):", case.name),
            format!("    {name} {}", cut(&case.question)),
            format!("    = {}", cut(&case.answers[0])),
        ]);
    }
    lines.extend([
        String::new(),
        format!(
            "  {} cases are visible; `raybook check {name}` asks them.",
            described.cases.len()
        ),
    ]);
    if program {
        lines.push(format!(
            "  `raybook exercise {name} --reader python` (or cpp) prints a program that reads them."
        ));
    }
    lines.push(String::new());
    lines.join("\n")
}

/// The description of an exercise as data.
///
/// A field has `name`, `meaning` and the keys of its kind: `kind` is `number`, `whole`, `numbers` (with `parts`), `direction`,
/// `optional` and `list` (with `of`), `record` (with its name, `record`, and its `fields`) or `choice` (with `choices`, each of a
/// `word` and its kind). Of all that is asked, `least` and `most` are the smallest and the largest finite number of it, or the
/// shortest and the longest length of a list; `infinite`, `minus_infinite` and `none` say that those occur. `limits` are sentences.
pub fn schema(examiner: &dyn Examiner) -> Value {
    let described = Described::new(examiner);
    let asked = examiner.asked();
    let example = described.cases.first().map(
        |case| json!({ "name": case.name, "question": case.question, "answer": case.answers[0] }),
    );
    json!({
        "name": asked.name,
        "task": asked.task,
        "file": library::place(asked.name),
        "question": of_kind(asked.question, &described.asked),
        "answer": named(&asked.answer, &described.answered),
        "example": example,
        "cases": described.cases.len(),
        "limits": limits(examiner, &described.cases),
    })
}

fn named(field: &Field, seen: &Seen) -> Value {
    let mut value = of_kind(field.kind, seen);
    value["name"] = field.name.into();
    value["meaning"] = field.meaning.into();
    value
}

fn of_kind(kind: &Kind, seen: &Seen) -> Value {
    let below = |kind: &Kind| of_kind(kind, &seen.of[0]);
    let mut value = match kind {
        Kind::Number => json!({ "kind": "number" }),
        Kind::Whole => json!({ "kind": "whole" }),
        Kind::Numbers(parts) => json!({ "kind": "numbers", "parts": parts.parts }),
        Kind::Direction => json!({ "kind": "direction" }),
        Kind::Optional(kind) => json!({ "kind": "optional", "of": below(kind) }),
        Kind::List(kind) => json!({ "kind": "list", "of": below(kind) }),
        Kind::Record(Record { name, fields }) => {
            let fields = fields.iter().zip(&seen.of);
            let fields: Vec<_> = fields.map(|(field, seen)| named(field, seen)).collect();
            json!({ "kind": "record", "record": name, "fields": fields })
        }
        Kind::Choice(choices) => {
            let choices = choices.iter().zip(&seen.of);
            let choices: Vec<_> = choices
                .map(|((word, kind), seen)| {
                    let mut value = of_kind(kind, seen);
                    value["word"] = (*word).into();
                    value
                })
                .collect();
            json!({ "kind": "choice", "choices": choices })
        }
    };
    if let Some([least, most]) = seen.range {
        value["least"] = least.into();
        value["most"] = most.into();
    }
    for (name, occurs) in [
        ("infinite", seen.infinite),
        ("minus_infinite", seen.minus_infinite),
        ("none", seen.none),
    ] {
        if occurs {
            value[name] = true.into();
        }
    }
    value
}

/// A row of the table: name, kind, what occurs, meaning.
type Row = [String; 4];

/// The rows of a field, and of what is in it.
fn of_field(field: &Field, seen: &Seen, depth: usize, rows: &mut Vec<Row>) {
    rows.push([
        format!("{:1$}{2}", "", 2 * depth, field.name),
        words(field.kind),
        occurring(field.kind, seen),
        field.meaning.to_owned(),
    ]);
    of_parts(field.kind, seen, depth + 1, rows);
}

fn of_parts(kind: &Kind, seen: &Seen, depth: usize, rows: &mut Vec<Row>) {
    match kind {
        Kind::Number | Kind::Whole | Kind::Numbers(_) | Kind::Direction => {}
        Kind::Optional(kind) | Kind::List(kind) => of_parts(kind, &seen.of[0], depth, rows),
        Kind::Record(record) => {
            for (field, seen) in record.fields.iter().zip(&seen.of) {
                of_field(field, seen, depth, rows);
            }
        }
        Kind::Choice(choices) => {
            for ((word, kind), seen) in choices.iter().zip(&seen.of) {
                let field = Field {
                    name: word,
                    kind,
                    meaning: "this word, and then:",
                    range: None,
                };
                of_field(&field, seen, depth, rows);
            }
        }
    }
}

/// A kind in words.
pub fn words(kind: &Kind) -> String {
    match kind {
        Kind::Number => "number".to_owned(),
        Kind::Whole => "whole number".to_owned(),
        Kind::Numbers(parts) => parts.parts.join(" "),
        Kind::Direction => "direction x y z".to_owned(),
        Kind::Optional(kind) => format!("{} or none", words(kind)),
        Kind::List(kind) => match kind {
            Kind::Number => "list of numbers".to_owned(),
            Kind::Whole => "list of whole numbers".to_owned(),
            kind => format!("list of {}", words(kind)),
        },
        Kind::Record(record) => record.name.to_owned(),
        Kind::Choice(choices) => {
            let choices: Vec<_> = choices.iter().map(|(word, _)| *word).collect();
            choices.join(" | ")
        }
    }
}

/// What occurs of a value, but for the parts that have rows of their own.
fn occurring(kind: &Kind, seen: &Seen) -> String {
    let range = seen.range.map(|[least, most]| match kind {
        Kind::List(_) if least == most => format!("length {least}"),
        Kind::List(_) => format!("length {least} to {most}"),
        _ if least == most => short(least),
        _ => format!("{} to {}", short(least), short(most)),
    });
    let of = match kind {
        Kind::Optional(kind) | Kind::List(kind) => Some(occurring(kind, &seen.of[0])),
        _ => None,
    };
    let or = |word: &str, occurs: bool| occurs.then(|| word.to_owned());
    let all = [
        range,
        of,
        or("inf", seen.infinite),
        or("-inf", seen.minus_infinite),
        or("none", seen.none),
    ];
    let all: Vec<_> = all
        .into_iter()
        .flatten()
        .filter(|said| !said.is_empty())
        .collect();
    all.join(", ")
}

/// The words of a row that people look at.
const LOOKED_AT: usize = 24;

/// A row, and of a long one only its first words.
fn cut(row: &str) -> String {
    let words: Vec<_> = row.split_whitespace().collect();
    match words.len().checked_sub(LOOKED_AT) {
        Some(more @ 1..) => format!("{} … ({more} more words)", words[..LOOKED_AT].join(" ")),
        _ => row.to_owned(),
    }
}

/// A number with three digits that count.
fn short(v: f64) -> String {
    if v == v.trunc() && v.abs() < 1e6 {
        return format!("{v}");
    }
    let digits = 2 - v.abs().log10().floor() as i32;
    match digits {
        0..=6 => {
            let text = format!("{v:.0$}", digits as usize);
            let text = text.trim_end_matches('0').trim_end_matches('.');
            text.to_owned()
        }
        _ if (-3..0).contains(&digits) => format!("{v:.0}"),
        _ => format!("{v:.2e}"),
    }
}

/// The rows under their heading.
fn table(occurs: &str, rows: &[Row]) -> Vec<String> {
    let heading = ["name", "kind", occurs, "meaning and unit"].map(str::to_owned);
    let all = || std::iter::once(&heading).chain(rows);
    let widest = [0, 1, 2].map(|i| all().map(|row| row[i].chars().count()).max().unwrap_or(0));
    let [name, kind, range] = widest;
    all()
        .map(|[a, b, c, d]| format!("    {a:<name$}   {b:<kind$}   {c:<range$}   {d}"))
        .map(|line| line.trim_end().to_owned())
        .collect()
}

impl Seen {
    /// Whether an infinite number occurs anywhere.
    fn has_infinity(&self) -> bool {
        self.infinite || self.minus_infinite || self.of.iter().any(Self::has_infinity)
    }
}
