//! Where the values of a row stand in its numbers, as its kind tells.

use raybook_workbook::kind::{Field, Kind, Range};
use std::ops;

/// A value by name: a number, a whole number, or numbers that belong together.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name; with that of what it is in, if two parts have the same.
    pub name: String,
    /// Its kind, which is not made of others.
    pub kind: &'static Kind,
    /// The innermost list that it is in, by number.
    pub list: Option<usize>,
    /// Which numbers it may be, if its declaration says so.
    pub range: Option<Range>,
}

/// A value in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Which part it is.
    pub part: usize,
    /// Where its numbers begin.
    pub start: usize,
    /// How many there are.
    pub len: usize,
}

impl Leaf {
    /// The place of its numbers.
    pub fn range(&self) -> ops::Range<usize> {
        self.start..self.start + self.len
    }
}

/// A list in a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// Which list it is.
    pub list: usize,
    /// Where its length stands.
    pub count: usize,
    /// The places of its elements.
    pub elements: Vec<ops::Range<usize>>,
}

/// What is in a row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// The values, in order.
    pub leaves: Vec<Leaf>,
    /// The lists, each after the lists that are in it.
    pub lists: Vec<Span>,
}

/// The parts of a kind, in order.
pub fn parts(kind: &'static Kind, name: &str) -> Vec<Part> {
    let mut found = Vec::new();
    let at = Place {
        path: vec![name],
        list: None,
        range: None,
    };
    add_parts(kind, &at, &mut 0, &mut found);
    let short = |at: &Place| at.path.last().copied().unwrap_or_default().to_owned();
    let named: Vec<_> = found.iter().map(|(at, _)| short(at)).collect();
    let part = |(at, kind): (Place<'_>, &'static Kind)| {
        let name = short(&at);
        let alone = named.iter().filter(|other| **other == name).count() == 1;
        let from = at.path.len().saturating_sub(2);
        let name = if alone {
            name
        } else {
            at.path[from..].join(".")
        };
        Part {
            name,
            kind,
            list: at.list,
            range: at.range,
        }
    };
    found.into_iter().map(part).collect()
}

/// Where a value is in a row.
#[derive(Clone)]
struct Place<'a> {
    /// The names of the fields that it is in, and its own.
    path: Vec<&'a str>,
    /// The innermost list that it is in.
    list: Option<usize>,
    /// The range of the innermost field.
    range: Option<Range>,
}

impl<'a> Place<'a> {
    /// A field of this place.
    fn below(&self, name: &'a str, range: Option<Range>) -> Self {
        let mut path = self.path.clone();
        path.push(name);
        let list = self.list;
        Self { path, list, range }
    }
}

fn add_parts<'a>(
    kind: &'static Kind,
    at: &Place<'a>,
    lists: &mut usize,
    found: &mut Vec<(Place<'a>, &'static Kind)>,
) {
    match kind {
        Kind::Number | Kind::Whole | Kind::Numbers(_) | Kind::Direction => {
            found.push((at.clone(), kind));
        }
        Kind::Optional(kind) => add_parts(kind, at, lists, found),
        Kind::List(kind) => {
            let list = Some(*lists);
            *lists += 1;
            add_parts(kind, &Place { list, ..at.clone() }, lists, found);
        }
        Kind::Record(record) => {
            for field in record.fields {
                let at = at.below(field.name, field.range);
                add_parts(field.kind, &at, lists, found);
            }
        }
        Kind::Choice(choices) => {
            for (word, kind) in *choices {
                add_parts(kind, &at.below(word, None), lists, found);
            }
        }
    }
}

/// Every field of a kind with its meaning, those inside of records too.
pub fn meanings(kind: &Kind) -> Vec<(&'static str, &'static str)> {
    match kind {
        Kind::Optional(kind) | Kind::List(kind) => meanings(kind),
        Kind::Record(record) => {
            let fields = record.fields.iter();
            let of_field = |field: &Field| {
                let mut all = vec![(field.name, field.meaning)];
                all.extend(meanings(field.kind));
                all
            };
            fields.flat_map(of_field).collect()
        }
        _ => Vec::new(),
    }
}

/// The names of a kind's lists, in order.
pub fn lists(kind: &Kind, name: &str) -> Vec<String> {
    match kind {
        Kind::Number | Kind::Whole | Kind::Numbers(_) | Kind::Direction => Vec::new(),
        Kind::Optional(kind) => lists(kind, name),
        Kind::List(kind) => {
            let mut all = vec![name.to_owned()];
            all.extend(lists(kind, name));
            all
        }
        Kind::Record(record) => {
            let fields = record.fields.iter();
            fields
                .flat_map(|field| lists(field.kind, field.name))
                .collect()
        }
        Kind::Choice(choices) => {
            let choices = choices.iter();
            choices.flat_map(|(word, kind)| lists(kind, word)).collect()
        }
    }
}

/// How many parts and lists a kind has.
fn count(kind: &Kind) -> (usize, usize) {
    let sum = |kinds: &mut dyn Iterator<Item = &'static Kind>| {
        kinds.map(count).fold((0, 0), |a, b| (a.0 + b.0, a.1 + b.1))
    };
    match kind {
        Kind::Number | Kind::Whole | Kind::Numbers(_) | Kind::Direction => (1, 0),
        Kind::Optional(kind) => count(kind),
        Kind::List(kind) => {
            let (parts, lists) = count(kind);
            (parts, lists + 1)
        }
        Kind::Record(record) => sum(&mut record.fields.iter().map(|field| field.kind)),
        Kind::Choice(choices) => sum(&mut choices.iter().map(|(_, kind)| *kind)),
    }
}

/// What is in a row of a kind.
pub fn layout(kind: &Kind, numbers: &[f64]) -> Layout {
    let mut layout = Layout::default();
    lay(kind, numbers, &mut 0, (0, 0), &mut layout);
    layout
}

fn lay(kind: &Kind, numbers: &[f64], at: &mut usize, ids: (usize, usize), layout: &mut Layout) {
    let next = |at: &mut usize| {
        *at += 1;
        numbers.get(*at - 1).copied().unwrap_or(0.0)
    };
    let mut leaf = |at: &mut usize, len| {
        if *at + len <= numbers.len() {
            let (part, start) = (ids.0, *at);
            layout.leaves.push(Leaf { part, start, len });
        }
        *at += len;
    };
    match kind {
        Kind::Number | Kind::Whole => leaf(at, 1),
        Kind::Numbers(parts) => leaf(at, parts.parts.len()),
        Kind::Direction => leaf(at, 3),
        Kind::Optional(kind) => {
            if next(at) != 0.0 {
                lay(kind, numbers, at, ids, layout);
            }
        }
        Kind::List(kind) => {
            let count = *at;
            let mut elements = Vec::new();
            for _ in 0..next(at) as u32 {
                let start = *at;
                lay(kind, numbers, at, (ids.0, ids.1 + 1), layout);
                elements.push(start..*at);
            }
            let list = ids.1;
            layout.lists.push(Span {
                list,
                count,
                elements,
            });
        }
        Kind::Record(record) => {
            let mut ids = ids;
            for field in record.fields {
                lay(field.kind, numbers, at, ids, layout);
                let (parts, lists) = count(field.kind);
                ids = (ids.0 + parts, ids.1 + lists);
            }
        }
        Kind::Choice(choices) => {
            let chosen = next(at) as usize;
            let mut ids = ids;
            for (i, (_, kind)) in choices.iter().enumerate() {
                if i == chosen {
                    lay(kind, numbers, at, ids, layout);
                }
                let (parts, lists) = count(kind);
                ids = (ids.0 + parts, ids.1 + lists);
            }
        }
    }
}

impl Layout {
    /// The numbers that are no values: which are there, how long lists are, what was chosen.
    pub fn shape(&self, numbers: &[f64]) -> Vec<f64> {
        let mut inside = vec![false; numbers.len()];
        for leaf in &self.leaves {
            inside[leaf.range()].fill(true);
        }
        let shape = numbers.iter().zip(inside).filter(|(_, inside)| !inside);
        shape.map(|(v, _)| *v).collect()
    }

    /// The values of a part.
    pub fn of_part(&self, part: usize) -> impl Iterator<Item = &Leaf> {
        self.leaves.iter().filter(move |leaf| leaf.part == part)
    }

    /// The row with other elements in every list of this number: `which` is given their number, and says which of them, in which order.
    pub fn rearranged(
        &self,
        numbers: &[f64],
        list: usize,
        which: &dyn Fn(usize) -> Vec<usize>,
    ) -> Vec<f64> {
        // From the back, so that the places ahead stay.
        let mut spans: Vec<_> = self.lists.iter().filter(|span| span.list == list).collect();
        spans.sort_by_key(|span| std::cmp::Reverse(span.count));
        let mut row = numbers.to_vec();
        for span in spans {
            let chosen = which(span.elements.len());
            let end = span.elements.last().map_or(span.count + 1, |last| last.end);
            let mut new = vec![chosen.len() as f64];
            for i in chosen {
                new.extend_from_slice(&numbers[span.elements[i].clone()]);
            }
            row.splice(span.count..end, new);
        }
        row
    }
}

/// Changes each of some values.
pub fn each(values: &mut [f64], change: impl FnMut(&mut f64)) {
    values.iter_mut().for_each(change);
}
