//! The library's public items, with their comments: what the page "The library" lists, and where a name in a text leads.
//!
//! The text is read line by line, for rustfmt has one way to write each declaration.

use super::text::{self, Links};
use crate::library;
use maud::html;
use std::fmt::Write;
use std::sync::LazyLock;

/// The page that lists the items.
pub(super) const PAGE: &str = "library.md";

/// A file of the library.
#[derive(Debug)]
pub struct Section {
    /// `src/shape/sphere.rs`.
    pub file: String,
    /// The first paragraph of its comment.
    pub says: String,
    /// In the order of the file.
    pub items: Vec<Item>,
}

/// A public item: a type, a trait, a function, a method or a constant.
#[derive(Debug, PartialEq, Eq)]
pub struct Item {
    /// `Sphere`, `Sphere::new`, and with the name of its file, `sphere::hit`.
    pub name: String,
    /// Its declaration, on one line; a method's with the name of its type.
    pub declaration: String,
    /// The first paragraph of its comment.
    pub says: String,
}

/// The library's files that hold public items or a comment, by their paths.
pub(super) static LIBRARY: LazyLock<Vec<Section>> = LazyLock::new(|| {
    let mut sections: Vec<_> = library::source()
        .into_iter()
        .filter_map(|file| {
            let path = format!("src/{}", library::slashes(file));
            Some(section(path, file.contents_utf8()?))
        })
        .filter(|section| !section.says.is_empty())
        .collect();
    sections.sort_by(|a, b| a.file.cmp(&b.file));
    sections
});

/// The place on the page to which a name or a file leads. A colon would look like the beginning of an address.
pub(super) fn place(name: &str) -> String {
    name.replace("::", ".")
}

/// What a file holds.
pub fn section(file: String, text: &str) -> Section {
    let comment = text.lines().map_while(|line| line.strip_prefix("//!"));
    let says = first_paragraph(comment);
    let (mut items, mut comment, mut within) = (Vec::new(), Vec::new(), None);
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let bare = line.trim_start();
        if let Some(words) = bare.strip_prefix("///") {
            comment.push(words);
        } else if let Some(declared) = declared(line, within.as_ref()) {
            let mut declaration = declaration(bare, &mut lines);
            let name = match &within {
                Some(Within { name, .. }) if line.starts_with(' ') => {
                    let name = format!("{name}::{declared}");
                    declaration = declaration.replacen(&declared, &name, 1);
                    name
                }
                _ if declared.starts_with(char::is_lowercase) => {
                    format!("{}::{declared}", stem(&file))
                }
                _ => declared,
            };
            items.push(Item {
                name,
                declaration,
                says: first_paragraph(comment.drain(..)),
            });
        } else if !bare.starts_with(['#', '/']) {
            comment.clear();
        }
        within = match line {
            "}" => None,
            _ => Within::read(line).or(within),
        };
    }
    Section { file, says, items }
}

/// The type whose functions stand in the lines that follow.
struct Within {
    name: String,
    /// Whether all functions are public without a word: those of a public trait are.
    is_trait: bool,
}

impl Within {
    /// What begins on a line, if anything does.
    fn read(line: &str) -> Option<Self> {
        let is_trait = line.starts_with("pub trait ");
        let rest = line.strip_prefix("pub trait ").or_else(|| {
            let rest = line.strip_prefix("impl")?;
            let rest = without_parameters(rest)?;
            (!rest.contains(" for ")).then_some(rest)
        })?;
        Some(Self {
            name: word(rest),
            is_trait,
        })
    }
}

/// What stands behind the parameters of an `impl`, if it has any: `<F: Fn(f32) -> bool> Filter<F> {`.
fn without_parameters(text: &str) -> Option<&str> {
    let mut depth = 0_u32;
    for (at, c) in text.char_indices() {
        match c {
            '<' => depth += 1,
            '>' if !text[..at].ends_with('-') => depth = depth.checked_sub(1)?,
            ' ' if depth == 0 => return Some(&text[at + 1..]),
            _ => {}
        }
    }
    None
}

/// The name of the item that is declared on a line, if it is public.
fn declared(line: &str, within: Option<&Within>) -> Option<String> {
    let indent = line.len() - line.trim_start().len();
    let bare = line.trim_start();
    let of_a_trait = within.is_some_and(|within| within.is_trait) && bare.starts_with("fn ");
    let rest = match indent {
        0 => bare.strip_prefix("pub ")?,
        4 if of_a_trait => bare,
        4 if within.is_some() => bare.strip_prefix("pub ")?,
        _ => return None,
    };
    let rest = rest
        .strip_prefix("const fn ")
        .or(rest.strip_prefix("unsafe fn "))
        .unwrap_or(rest);
    let kinds = ["fn ", "struct ", "enum ", "trait ", "const ", "type "];
    let rest = kinds
        .iter()
        .find_map(|kind| rest.strip_prefix(kind))
        .unwrap_or(rest);
    let name = word(rest);
    (!["mod", "use", "static"].contains(&name.as_str())).then_some(name)
}

/// The letters with which a text begins.
fn word(text: &str) -> String {
    text.chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect()
}

/// A declaration up to its body or its value; it goes on in the lines that follow.
fn declaration<'a>(first: &str, rest: &mut impl Iterator<Item = &'a str>) -> String {
    let mut text = first.to_owned();
    while !text.ends_with(['{', ';', '}']) {
        let Some(next) = rest.next() else { break };
        let next = next.trim();
        let gap = if text.ends_with('(') || next.starts_with(')') {
            ""
        } else {
            " "
        };
        text = format!("{text}{gap}{next}");
    }
    let end = text
        .find(" = ")
        .or_else(|| text.find(" {"))
        .unwrap_or(text.len());
    text[..end].trim_end_matches(';').replace(",)", ")")
}

/// A comment up to its first empty line, as Markdown that needs no documentation tool: its links to items are names in back quotes.
fn first_paragraph<'a>(lines: impl IntoIterator<Item = &'a str>) -> String {
    let lines = lines.into_iter().map(str::trim);
    let lines: Vec<_> = lines.take_while(|line| !line.is_empty()).collect();
    let text = lines.join(" ");
    let (mut plain, mut rest) = (String::with_capacity(text.len()), &*text);
    while let Some((before, after)) = rest.split_once('[') {
        plain.push_str(before);
        let is_link = after
            .find(']')
            .filter(|end| after.starts_with('`') || after[end + 1..].starts_with('('));
        rest = match is_link {
            Some(end) if after[end + 1..].starts_with("(http") => {
                plain.push('[');
                after
            }
            Some(end) => {
                plain.push_str(&after[..end]);
                let behind = &after[end + 1..];
                match behind
                    .strip_prefix('(')
                    .and_then(|target| target.split_once(')'))
                {
                    Some((_, behind)) => behind,
                    None => behind,
                }
            }
            None => {
                plain.push('[');
                after
            }
        };
    }
    plain + rest
}

/// The name of a file's module.
fn stem(file: &str) -> &str {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
    path.rsplit('/').next().unwrap_or(path)
}

/// `{{library src}}`: the list of the files in this folder, each with its items.
///
/// # Errors
/// If the library has no such folder.
pub(super) fn expand(page: &str, folder: &str, links: &Links) -> Result<String, String> {
    let of_folder = |section: &&Section| section.file.starts_with(&format!("{folder}/"));
    let sections: Vec<_> = LIBRARY.iter().filter(of_folder).collect();
    if sections.is_empty() {
        return Err(format!("the library has no files in `{folder}`"));
    }
    let mut text = String::new();
    for Section { file, says, items } in sections {
        let says = text::linked(page, says, links);
        let _ = write!(
            text,
            "<h2 class=\"source\" id=\"{file}\"><code>{file}</code></h2>\n\n{says}\n"
        );
        for Item {
            name,
            declaration,
            says,
        } in items
        {
            let (place, says) = (place(name), text::linked(page, says, links));
            let _ = write!(
                text,
                "\n- <code id=\"{place}\">{}</code>  \n  {says}\n",
                html! { (declaration) }.into_string()
            );
        }
        text.push('\n');
    }
    Ok(text)
}
