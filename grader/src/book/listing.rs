//! `{{reference sphere_hit}}` and `{{listing src/shape/mod.rs:shape}}`: anchors of the library, whole, with links to what they name.

use super::code;
use super::fit::fit;
use super::text::Links;
use crate::library;
use maud::html;
use raybook_workbook::anchor;

/// A reference, folded: nobody sees a solution before they want to.
///
/// # Errors
/// If there is no such exercise or anchor.
pub(super) fn reference(name: &str, links: &Links) -> Result<String, String> {
    let (file, text) = find(name)?;
    let what = name.rsplit(':').next().unwrap_or(name);
    let summary = html! { "The reference of " code { (what) } };
    Ok(format!(
        "<details class=\"reference\"><summary>{}</summary>\n\n{}\n{}\n</details>",
        summary.into_string(),
        code::html(&fitted(text), &file, &links.names),
        stands_in(&file, links)
    ))
}

/// A listing that gives no exercise away.
///
/// # Errors
/// If there is no such anchor.
pub(super) fn open(name: &str, links: &Links) -> Result<String, String> {
    let (file, text) = find(name)?;
    let listing = code::html(&fitted(text), &file, &links.names);
    Ok(format!("{listing}\n{}", stands_in(&file, links)))
}

/// The file and the text of an exercise's reference, or of `src/file.rs:anchor`.
fn find(name: &str) -> Result<(String, &'static str), String> {
    let Some((file, wanted)) = name.split_once(':') else {
        let found = library::place(name).zip(library::reference(name));
        return found.ok_or_else(|| {
            format!("`{name}` is no exercise; another anchor is written src/file.rs:anchor")
        });
    };
    let text = library::source()
        .into_iter()
        .find(|source| format!("src/{}", library::slashes(source)) == file)
        .and_then(|source| source.contents_utf8())
        .ok_or_else(|| format!("the library has no file {file}"))?;
    let regions = anchor::regions(text).map_err(|error| format!("{file}: {error}"))?;
    let region = regions.into_iter().find(|(name, _)| *name == wanted);
    let (_, text) = region.ok_or_else(|| format!("{file} has no `// ANCHOR: {wanted}`"))?;
    Ok((file.to_owned(), text))
}

/// The lines of a listing, as wide as a page.
///
/// # Errors
/// If there is no such anchor.
pub fn listing(name: &str) -> Result<String, String> {
    Ok(fitted(find(name)?.1))
}

fn fitted(text: &str) -> String {
    let text = fit(&library::without_anchors(text));
    format!("{}\n", text.trim_end())
}

/// Where a listing stands.
fn stands_in(file: &str, links: &Links) -> String {
    match links.names.place(file) {
        Some(place) => format!("In [`{file}`]({place}).\n"),
        None => format!("In `{file}`.\n"),
    }
}
