//! Names in back quotes: an exercise, a command, a file or an item of the library leads to the page that tells of it.

use super::Page;
use super::commands;
use super::items::{self, Item, LIBRARY, Section};
use clap::Command;
use std::collections::HashMap;

/// The places in the book to which names lead.
pub(super) struct Names(HashMap<String, String>);

impl Names {
    /// The exercises on these pages, the commands, and the library's files and items. A name that means two items leads nowhere.
    pub(super) fn of(pages: &[Page], command: &Command) -> Self {
        let mut places = HashMap::new();
        for Section { file, items, .. } in LIBRARY.iter() {
            places.insert(file.clone(), format!("{}#{file}", items::PAGE));
            for Item { name, .. } in items {
                let place = format!("{}#{}", items::PAGE, items::place(name));
                let before = places.insert(name.clone(), place);
                if before.is_some() {
                    places.insert(name.clone(), String::new());
                }
            }
        }
        places.retain(|_, place| !place.is_empty());
        for page in pages {
            for exercise in page
                .text
                .lines()
                .filter_map(|line| line.strip_prefix("{{turn ")?.strip_suffix("}}"))
            {
                places.insert(
                    exercise.to_owned(),
                    format!("{}#turn-{exercise}", page.name),
                );
            }
        }
        for name in commands::shown(command).map(Command::get_name) {
            places.insert(
                format!("raybook {name}"),
                format!("{}#{name}", commands::PAGE),
            );
        }
        Self(places)
    }

    /// The place to which a text between back quotes leads, if it is a name. A function may have its parentheses, and a command its words.
    pub(super) fn place(&self, code: &str) -> Option<&str> {
        let name = code.split('(').next().unwrap_or(code);
        let command = || {
            let end = code
                .match_indices(' ')
                .nth(1)
                .map_or(code.len(), |(at, _)| at);
            self.0.get(&code[..end])
        };
        self.0.get(name).or_else(command).map(String::as_str)
    }
}
