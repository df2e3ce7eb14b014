//! `{{turn sphere_hit}}`: what a student needs to write a function, in four languages.

use super::code;
use super::fit::fit;
use super::text::{self, Links};
use crate::converse::Limits;
use crate::describe::words;
use crate::examine::{Examiner, visible_rng};
use crate::language::Language;
use crate::library;
use crate::limits::limits;
use crate::starter::{cpp, place, python};
use maud::{Markup, html};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Field, Kind};
use std::fmt::Write;
use std::iter;

/// The task, the signature in tabs, the table of parameters, the commands and the limits.
///
/// # Errors
/// If the library has no function of this name.
pub(super) fn expand(page: &str, examiner: &dyn Examiner, links: &Links) -> Result<String, String> {
    let (asked, name) = (examiner.asked(), examiner.name());
    let function = library::function(name)
        .ok_or_else(|| format!("the library has no function between anchors `{name}`"))?;
    let in_rust = format!(
        "{} {{\n    todo!(\"{name}\")\n}}\n",
        dedented(function.signature)
    );
    let languages = [
        ("Rust", "rust", in_rust),
        (
            "C++",
            "cpp",
            format!("{} {{\n    // write it here\n}}\n", cpp::signature(asked)),
        ),
        (
            "Python",
            "python",
            format!("{}\n    ...  # write it here\n", python::signature(asked)),
        ),
        ("Pseudocode", "text", pseudocode(asked)),
    ];
    let cases = examiner.try_cases(&mut visible_rng(name));
    let cases = cases.map_err(|error| error.to_string())?.cases;
    let limit = Limits::default().time.as_secs_f32();
    let [rust, cpp, python] = [Language::Rust, Language::Cpp, Language::Python]
        .map(|language| place(language, name).unwrap_or_default());
    let title = html! { h3 id={ "turn-" (name) } { code { (name) } } };
    let task = text::linked(page, asked.task, links);
    let mut text = format!("{}\n\n{task}\n\n", title.into_string());
    text.push_str(&tabs(name, &languages, links));
    text.push_str(&parameters(asked));
    let place = format!(
        "Write it in `{rust}` of a workbook in Rust, `{cpp}` in C++, `{python}` in Python (`raybook new my-rays --language cpp`)."
    );
    let _ = write!(
        text,
        "\n\n{}\n\n```sh\nraybook check {name}                        # in your workbook\n\
         raybook check {name} --program ./answer     # a program in any language\n\
         raybook hint {name}\n```\n\n\
         <details class=\"limits\"><summary>Limits</summary>\n\n",
        text::linked(page, &place, links)
    );
    for sentence in limits(examiner, &cases) {
        let _ = writeln!(text, "- {sentence}");
    }
    let _ = write!(
        text,
        "- {limit} s of processor time for each answer.\n\n</details>\n"
    );
    Ok(text)
}

/// The languages side by side. The tabs are radio buttons and style, so that they work without a script; in print all are shown.
fn tabs(name: &str, languages: &[(&str, &str, String)], links: &Links) -> String {
    let file = library::place(name).unwrap_or_default();
    let mut text = "<div class=\"tabs\">\n".to_owned();
    for (i, (language, _, _)) in languages.iter().enumerate() {
        let id = format!("tab-{name}-{i}");
        let group = format!("tabs-{name}");
        let tab = html! {
            input type="radio" name=(group) id=(id) checked[i == 0];
            label for=(id) { (language) }
        };
        text.push_str(&tab.into_string());
    }
    for (language, highlight, listing) in languages {
        let listing = fit(listing);
        let listing = match *highlight {
            "rust" => code::html(&listing, &file, &links.names),
            _ => format!("```{highlight}\n{listing}```\n"),
        };
        let _ = write!(
            text,
            "\n<div class=\"tab\" title=\"{language}\">\n\n{listing}\n</div>\n"
        );
    }
    text.push_str("</div>\n\n");
    text
}

/// The function as mathematics would have it.
fn pseudocode(asked: &Asked) -> String {
    let fields = asked.parameters();
    let parameters: Vec<_> = fields
        .iter()
        .map(|field| format!("    {}: {}", field.name, words(field.kind)))
        .collect();
    format!(
        "function {}(\n{}\n) returns {}: {}\n",
        asked.name,
        parameters.join(",\n"),
        asked.answer.name,
        words(asked.answer.kind)
    )
}

/// A row for each parameter, one for the answer, and one for each of its fields where it has some.
fn parameters(asked: &'static Asked) -> String {
    let row = |field: &Field| {
        html! { tr { td { code { (field.name) } } td { (words(field.kind)) } td { (coded(field.meaning)) } } }
    };
    let table = html! {
        table class="parameters" {
            thead { tr { th { "parameter" } th { "kind" } th { "meaning and unit" } } }
            tbody { @for field in asked.parameters() { (row(field)) } }
            thead { tr { th { "returns" } th { "kind" } th { "meaning and unit" } } }
            tbody { @for field in returned(&asked.answer) { (row(field)) } }
        }
    };
    table.into_string()
}

/// The answer, and its fields.
fn returned(answer: &'static Field) -> Vec<&'static Field> {
    let mut kind = answer.kind;
    while let Kind::Optional(inner) | Kind::List(inner) = kind {
        kind = inner;
    }
    let fields: &[Field] = match kind {
        Kind::Record(record) => record.fields,
        _ => &[],
    };
    iter::once(answer).chain(fields).collect()
}

/// A text whose names in back quotes are code.
fn coded(text: &str) -> Markup {
    html! {
        @for (i, part) in text.split('`').enumerate() {
            @if i % 2 == 1 { code { (part) } } @else { (part) }
        }
    }
}

/// A signature that begins at the left margin.
fn dedented(signature: &str) -> String {
    let indent = signature.len() - signature.trim_start().len();
    let lines = signature.lines();
    let lines: Vec<_> = lines.map(|line| line.get(indent..).unwrap_or("")).collect();
    lines.join("\n")
}
