//! Kinds: what a row is made of, as data. Whatever is said of rows to people, and in other languages, follows from here.

use std::ops::{Bound, RangeBounds};

/// The kind of a value in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number, which may be `inf`, `-inf` or `nan`.
    Number,
    /// A whole number from 0 up.
    Whole,
    /// Numbers that belong together.
    Numbers(&'static Parts),
    /// A vector whose length does not matter.
    Direction,
    /// A value, or the word `none`.
    Optional(&'static Kind),
    /// A length, and as many values.
    List(&'static Kind),
    /// Fields, one after the other.
    Record(&'static Record),
    /// A word that says which, and the value that belongs to it.
    Choice(&'static [(&'static str, &'static Kind)]),
}

/// Numbers that belong together, such as a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// The name of their type.
    pub name: &'static str,
    /// Their names, in order.
    pub parts: &'static [&'static str],
}

/// Fields that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Record {
    /// The name of its type.
    pub name: &'static str,
    /// Its fields, in order.
    pub fields: &'static [Field],
}

/// A value by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name.
    pub name: &'static str,
    /// Its kind.
    pub kind: &'static Kind,
    /// What it means, and in which unit; the words of its range are the end of the sentence.
    pub meaning: &'static str,
    /// Which numbers it may be, if its declaration says so.
    pub range: Option<Range>,
}

/// Which numbers a field may be; of a vector or a list, each of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// As the declaration has it: "above 0".
    pub words: &'static str,
    /// The smallest and the largest number.
    pub ends: [Bound<i32>; 2],
}

impl Range {
    /// Whether a number is in it.
    pub fn holds(&self, v: f64) -> bool {
        let [least, most] = self.ends.map(|end| end.map(f64::from));
        (least, most).contains(&v)
    }
}

/// A vector of three numbers.
pub const VECTOR: &Parts = &Parts {
    name: "Vec3",
    parts: &["x", "y", "z"],
};

impl Kind {
    /// The names of the words of a value of this name, in order.
    pub fn names(&self, name: &str) -> Vec<String> {
        let of_parts = |parts: &Parts| {
            let parts = parts.parts.iter();
            parts.map(|part| format!("{name}.{part}")).collect()
        };
        match self {
            Self::Number | Self::Whole => vec![name.to_owned()],
            Self::Numbers(parts) => of_parts(parts),
            Self::Direction => of_parts(VECTOR),
            Self::Optional(kind) => vec![format!("none | {}", kind.names(name).join(" "))],
            Self::List(kind) => vec![
                format!("{name}.count"),
                format!("[{}]…", kind.names(name).join(" ")),
            ],
            Self::Record(record) => {
                let fields = record.fields.iter();
                fields
                    .flat_map(|field| field.kind.names(field.name))
                    .collect()
            }
            Self::Choice(choices) => {
                let choice =
                    |(word, kind): &(&str, &Kind)| format!("{word} {}", kind.names(word).join(" "));
                let choices: Vec<_> = choices.iter().map(choice).collect();
                vec![format!("({})", choices.join(" | "))]
            }
        }
    }

    /// Whether there is a choice in it: then values differ in length, and people are shown each on a line of its own.
    pub fn has_a_choice(&self) -> bool {
        match self {
            Self::Number | Self::Whole | Self::Numbers(_) | Self::Direction => false,
            Self::Optional(kind) | Self::List(kind) => kind.has_a_choice(),
            Self::Record(record) => record.fields.iter().any(|field| field.kind.has_a_choice()),
            Self::Choice(_) => true,
        }
    }
}
