//! Names in back quotes: an exercise, a command, a file or an item of the library leads to the page that tells of it.

use super::Page;
use super::commands;
use super::items::{self, Item, LIBRARY, Section};
use clap::Command;
use raybook_workbook::curriculum::{self, Chapter};
use std::collections::HashMap;

/// The places in the book to which names lead.
pub struct Names {
    /// By what a text calls them.
    places: HashMap<String, String>,
    /// The library's items, as code calls them: `Sphere`, `Sphere::new`, `slab::clip` and `clip`.
    items: HashMap<&'static str, Vec<Documented>>,
    /// The methods, by their names alone.
    methods: HashMap<&'static str, Vec<Documented>>,
}

/// Methods of the standard library and of glam have these names too.
const COMMON: [&str; 7] = ["all", "any", "contains", "is_empty", "lerp", "map", "push"];

/// Where an item stands, and where it is documented.
struct Documented {
    /// The type or the module of which it is a part, if it is one.
    of: &'static str,
    file: &'static str,
    place: String,
}

impl Names {
    /// The exercises on these pages, the commands, and the library's files and items. A name that means two items leads nowhere.
    pub fn of(pages: &[Page], command: &Command) -> Self {
        let mut places = HashMap::new();
        let mut known: HashMap<&str, Vec<_>> = HashMap::new();
        let mut methods: HashMap<&str, Vec<_>> = HashMap::new();
        for Section { file, items, .. } in LIBRARY.iter() {
            places.insert(file.clone(), format!("{}#{file}", items::PAGE));
            for Item { name, .. } in items {
                let place = format!("{}#{}", items::PAGE, items::place(name));
                let before = places.insert(name.clone(), place.clone());
                if before.is_some() {
                    places.insert(name.clone(), String::new());
                }
                let (of, alone) = name.split_once("::").unwrap_or(("", name));
                let documented = || Documented {
                    of,
                    file,
                    place: place.clone(),
                };
                known.entry(&**name).or_default().push(documented());
                if is_lower(of) {
                    known.entry(alone).or_default().push(documented());
                } else if is_lower(alone) && !COMMON.contains(&alone) {
                    methods.entry(alone).or_default().push(documented());
                }
            }
        }
        places.retain(|_, place| !place.is_empty());
        for page in pages {
            let chapter = curriculum::find(page.name.trim_end_matches(".md"));
            for asked in chapter.map_or(&[][..], Chapter::exercises) {
                let place = format!("{}#turn-{}", page.name, asked.name);
                places.insert(asked.name.to_owned(), place);
            }
        }
        for name in commands::shown(command).map(Command::get_name) {
            places.insert(
                format!("raybook {name}"),
                format!("{}#{name}", commands::PAGE),
            );
        }
        Self {
            places,
            items: known,
            methods,
        }
    }

    /// The place that documents an item of the library, as the code of `file` names it. `is_seen` tells of a name without a module whether this
    /// file imports it.
    pub(super) fn item(
        &self,
        name: &str,
        file: &str,
        is_seen: impl Fn(&str) -> bool,
    ) -> Option<&str> {
        let found = self.items.get(name)?;
        let first = name.split("::").next().unwrap_or(name);
        let here = found.iter().find(|item| item.file == file);
        let elsewhere = || match &**found {
            [item] if is_seen(first) || is_lower(first) && first != name => Some(item),
            _ => None,
        };
        let item = here.or_else(elsewhere)?;
        Some(&item.place)
    }

    /// The place that documents a method, in code that sees only one type with a method of this name.
    pub(super) fn method(
        &self,
        name: &str,
        file: &str,
        is_seen: impl Fn(&str) -> bool,
    ) -> Option<&str> {
        let of_seen = |method: &&Documented| method.file == file || is_seen(method.of);
        let mut found = self.methods.get(name)?.iter().filter(of_seen);
        let method = found.next().filter(|_| found.next().is_none())?;
        Some(&method.place)
    }

    /// The place to which a text between back quotes leads, if it is a name. A function may have its parentheses, and a command its words.
    pub(super) fn place(&self, code: &str) -> Option<&str> {
        let name = code.split('(').next().unwrap_or(code);
        let command = || {
            let end = code
                .match_indices(' ')
                .nth(1)
                .map_or(code.len(), |(at, _)| at);
            self.places.get(&code[..end])
        };
        self.places.get(name).or_else(command).map(String::as_str)
    }
}

/// Whether this is the name of a module or a function.
fn is_lower(name: &str) -> bool {
    name.starts_with(char::is_lowercase)
}
