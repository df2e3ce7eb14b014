//! Programs in other languages that read the questions of an exercise and write its answers, made from its kinds.
//!
//! Each is complete but for the function that the student writes: record types, their readers and writers, the loop over the
//! lines. To what is not written yet, and to other exercises, they answer `= todo`.

pub mod cpp;
pub mod python;

use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Kind, Record};

/// A kind that has a type of its own in a program.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Type {
    /// Numbers that belong together: name and parts.
    Numbers(&'static str, &'static [&'static str]),
    /// Fields that belong together.
    Record(&'static Record),
}

impl Type {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Numbers(name, _) => name,
            Self::Record(record) => record.name,
        }
    }
}

/// The types of an exercise's question and answer, each after those that it is made of; none twice.
pub(crate) fn types_of(asked: &Asked) -> Vec<Type> {
    let mut all = Vec::new();
    types(asked.question, &mut all);
    types(asked.answer.kind, &mut all);
    all
}

/// The types of a kind, each after those that it is made of; none twice.
pub(crate) fn types(kind: &Kind, types: &mut Vec<Type>) {
    let found = match kind {
        Kind::Number | Kind::Whole => return,
        Kind::Numbers(parts) => Type::Numbers(parts.name, parts.parts),
        Kind::Direction => {
            return self::types(&Kind::Numbers(raybook_workbook::kind::VECTOR), types);
        }
        Kind::Optional(kind) | Kind::List(kind) => return self::types(kind, types),
        Kind::Record(record) => {
            for field in record.fields {
                self::types(field.kind, types);
            }
            Type::Record(record)
        }
        Kind::Choice(choices) => {
            return choices
                .iter()
                .for_each(|(_, kind)| self::types(kind, types));
        }
    };
    if !types.contains(&found) {
        types.push(found);
    }
}

/// A name that is no keyword of the languages.
pub(crate) fn safe(name: &str) -> String {
    const KEYWORDS: [&str; 14] = [
        "and", "class", "default", "double", "float", "for", "from", "in", "int", "is", "not",
        "or", "register", "with",
    ];
    if KEYWORDS.contains(&name) {
        format!("{name}_")
    } else {
        name.to_owned()
    }
}
