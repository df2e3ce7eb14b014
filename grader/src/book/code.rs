//! A listing of Rust in which the names of the library are links to where they are documented.
//!
//! The listing is written as HTML. The highlighter of the book's pages keeps the links, and colours what lies between them.

use super::names::Names;
use crate::library;
use maud::html;

/// The listing, as mdBook would write it. `file` is where it stands in the library: a name means what it means there.
pub fn html(listing: &str, file: &str, names: &Names) -> String {
    let source = library::reference_file(file).unwrap_or_default();
    let imported = imported(&source);
    let place = |name: &str, is_called: bool| {
        let is_function = name.starts_with(char::is_lowercase) && !name.contains("::");
        let place = names.item(name, file, |name| imported.contains(&name))?;
        (is_called || !is_function).then_some(place)
    };
    let mut text = String::with_capacity(2 * listing.len());
    for piece in pieces(listing) {
        match piece {
            Piece::Path(path, is_called) => match linked(path, is_called, place) {
                Some((before, name, place, after)) => {
                    text.extend([before, &link(name, place), after]);
                }
                None => text.push_str(path),
            },
            Piece::Method(name) => {
                match names.method(name, file, |name| imported.contains(&name)) {
                    Some(place) => text.push_str(&link(name, place)),
                    None => text.push_str(name),
                }
            }
            // A dollar sign would begin a formula.
            Piece::Other(other) => {
                text.push_str(&html! { (other) }.into_string().replace('$', "&#36;"));
            }
        }
    }
    format!("<pre><code class=\"language-rust noplayground\">{text}</code></pre>\n")
}

/// A name that leads to a place in the book.
fn link(name: &str, place: &str) -> String {
    let place = place.replacen(".md", ".html", 1);
    html! { a href=(place) { (name) } }.into_string()
}

/// The names that a file imports.
fn imported(source: &str) -> Vec<&str> {
    let uses = source.split("\nuse ").skip(1);
    let uses = uses.filter_map(|text| text.split(';').next());
    uses.flat_map(|text| text.split(|c: char| !is_letter(c)))
        .collect()
}

/// Whether a name may have this character.
fn is_letter(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// A piece of a listing.
enum Piece<'a> {
    /// A name, or several that are joined by `::`, and whether a function of this name is called.
    Path(&'a str, bool),
    /// A method that is called.
    Method(&'a str),
    /// What lies between; comments, strings, and the names of fields and of what is declared.
    Other(&'a str),
}

/// Cuts a listing into names and the rest.
fn pieces(listing: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let (mut rest, mut declares) = (listing, false);
    while let Some(first) = rest.chars().next() {
        let end = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if first == '"' {
            string(rest)
        } else if first.is_alphabetic() || first == '_' {
            path(rest)
        } else if first.is_ascii_digit() {
            rest.find(|c| !is_letter(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (piece, behind) = rest.split_at(end);
        let is_called = behind.starts_with('(');
        let is_path = first.is_alphabetic() || first == '_';
        let before = &listing[..listing.len() - rest.len()];
        let of_a_value = before.ends_with('.') && !before.ends_with("..");
        if is_path && !declares && !of_a_value {
            pieces.push(Piece::Path(piece, is_called));
        } else if is_path && of_a_value && is_called {
            pieces.push(Piece::Method(piece));
        } else {
            pieces.push(Piece::Other(piece));
        }
        if !piece.trim().is_empty() {
            declares = ["fn", "struct", "enum", "trait"].contains(&piece);
        }
        rest = behind;
    }
    pieces
}

/// The length of the string with which a text begins.
fn string(text: &str) -> usize {
    let mut escaped = false;
    let end = text.char_indices().skip(1).find(|&(_, c)| {
        let ends = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        ends
    });
    end.map_or(text.len(), |(at, _)| at + 1)
}

/// The length of the path with which a text begins.
fn path(text: &str) -> usize {
    let mut end = 0;
    loop {
        let name = &text[end..];
        end += name.find(|c| !is_letter(c)).unwrap_or(name.len());
        let Some(next) = text[end..].strip_prefix("::") else {
            return end;
        };
        if !next.starts_with(is_letter) {
            return end; // `Vec::<u32>`
        }
        end += 2;
    }
}

/// What stands before the longest part of a path that has a place, this part, its place, and what stands behind: of `crate::math::Ray::at`
/// the part is `Ray::at`, and of `Ray::default` it is `Ray`.
fn linked<'a>(
    path: &'a str,
    is_called: bool,
    place: impl Fn(&str, bool) -> Option<&'a str>,
) -> Option<(&'a str, &'a str, &'a str, &'a str)> {
    let starts = || {
        let behind = path.match_indices("::").map(|(at, _)| at + 2);
        std::iter::once(0).chain(behind)
    };
    let ends = path.rmatch_indices("::").map(|(at, _)| at);
    let ends = std::iter::once(path.len()).chain(ends);
    for end in ends {
        for start in starts().take_while(|start| *start < end) {
            let name = &path[start..end];
            if let Some(place) = place(name, is_called && end == path.len()) {
                return Some((&path[..start], name, place, &path[end..]));
            }
        }
    }
    None
}
