//! What the stubs of all languages say, taken from the declaration of an exercise.

use super::StarterFile;
use crate::reader::{Type, safe, types, types_of};
use raybook_workbook::curriculum::Chapter;
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Field, Kind, VECTOR};
use std::path::PathBuf;

/// The width of a comment, in letters.
const WIDTH: usize = 100;

/// The types that all chapters share: `vec.hpp` and `vec.py` define them.
pub const SHARED: [&str; 5] = ["Interval", "Ray", "Rgb", "Vec2", "Vec3"];

/// A file of a starter.
pub fn file(path: &str, text: &str) -> StarterFile {
    (PathBuf::from(path), text.as_bytes().to_vec())
}

/// The types of a chapter but for those that all chapters share and the questions themselves, whose fields are parameters.
pub fn own_types(chapter: &Chapter) -> Vec<Type> {
    let mut own: Vec<Type> = Vec::new();
    for asked in chapter.exercises() {
        for found in types_of(asked) {
            let is_question =
                matches!((found, asked.question), (Type::Record(a), Kind::Record(b)) if a == *b);
            if !is_question && !SHARED.contains(&found.name()) && !own.contains(&found) {
                own.push(found);
            }
        }
    }
    own
}

/// The comment of a stub: the task, a line for each parameter, and the answer. Each line begins with `prefix`.
pub fn comment(asked: &Asked, prefix: &str, name: impl Fn(&str) -> String) -> String {
    let mut text = wrapped(asked.task, prefix, prefix);
    text.push_str(prefix.trim_end());
    text.push('\n');
    let hanging = format!("{prefix}    ");
    for field in asked.parameters() {
        let meaning = meaning(field);
        text.push_str(&wrapped(
            &format!("{}: {meaning}", name(field.name)),
            prefix,
            &hanging,
        ));
    }
    let returns = format!("Returns {}: {}", asked.answer.name, asked.answer.meaning);
    text.push_str(&wrapped(&returns, prefix, &hanging));
    text
}

/// The members of the types that are given and returned, which would have to be looked up; `None` if there are none but vectors.
pub fn members(asked: &Asked) -> Option<String> {
    let names = |found: &Type| match found {
        Type::Numbers(_, parts) => parts.join(", "),
        Type::Record(record) => {
            let names = record.fields.iter().map(|field| safe(field.name));
            names.collect::<Vec<_>>().join(", ")
        }
    };
    let mut all = Vec::new();
    for field in asked.parameters().iter().chain([&asked.answer]) {
        types(field.kind, &mut all);
    }
    let told = all
        .iter()
        .filter(|found| found.name() != VECTOR.name)
        .map(|found| format!("{} {{ {} }}", found.name(), names(found)));
    let told: Vec<_> = told.collect();
    (!told.is_empty()).then(|| format!("Members: {}.", told.join(", ")))
}

/// What a field means; a direction has length 1 when it arrives.
pub fn meaning(field: &Field) -> String {
    match field.kind {
        Kind::Direction => {
            let meaning = field.meaning.trim_end_matches('.');
            format!("{meaning}; of length 1.")
        }
        _ => field.meaning.to_owned(),
    }
}

/// A text in lines: the first begins with `first`, the others with `rest`.
pub fn wrapped(text: &str, first: &str, rest: &str) -> String {
    let mut lines = String::new();
    let mut line = first.to_owned();
    let mut is_empty = true;
    for word in text.split_whitespace() {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push_str(&line);
            lines.push('\n');
            rest.clone_into(&mut line);
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line.push_str(word);
        is_empty = false;
    }
    lines + &line + "\n"
}
