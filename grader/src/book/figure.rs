//! `{{figure roots | alternative text}}`: a figure, with the caption that the run which drew it gave it.
//!
//! The tour writes its captions beside the pictures, so that gallery and book have one caption, and a caption may tell what the run
//! has measured.

use maud::html;
use raybook::store::{self, StoreError};
use raybook_chapters::kit::stage::Output;
use serde_json::{Map, Value};
use std::path::Path;

/// The file in a chapter's folder of pictures that holds their captions, by the figures' names.
pub const FIGURES: &str = "figures.json";

/// Writes the captions of a chapter's pictures into its folder.
///
/// # Errors
/// If the file cannot be written.
pub fn write_captions(folder: &Path, outputs: &[Output]) -> Result<(), StoreError> {
    let captions: Map<_, _> = outputs
        .iter()
        .filter_map(|output| {
            let name = output.png.file_stem()?.to_str()?.to_owned();
            Some((name, Value::from(output.caption.clone())))
        })
        .collect();
    let text = format!("{:#}\n", Value::from(captions));
    store::write(&folder.join(FIGURES), text.as_bytes())
}

/// The figure `name` of the page's chapter; of another chapter it is `ch03_sphere/roots`.
///
/// # Errors
/// If it has no alternative text, or the pictures were drawn and it is not among them.
pub(super) fn expand(page: &str, name: &str, alt: &str, pictures: &Path) -> Result<String, String> {
    if alt.is_empty() {
        return Err(format!(
            "say what {name} shows for those who cannot see it: {{{{figure {name} | …}}}}"
        ));
    }
    let here = page.strip_suffix(".md").unwrap_or(page);
    let (chapter, name) = name.split_once('/').unwrap_or((here, name));
    let caption = caption(&pictures.join(chapter), name)?;
    let file = format!("pictures/{chapter}/{name}.png");
    let figure = html! {
        figure id={ "figure-" (name) } {
            a href=(file) { img src=(file) alt=(alt) loading="lazy"; }
            figcaption { (caption) }
        }
    };
    Ok(figure.into_string())
}

/// The caption of a figure; while no pictures are drawn, a word in its place.
fn caption(folder: &Path, name: &str) -> Result<String, String> {
    let path = folder.join(FIGURES);
    let Ok(text) = store::read_text(&path) else {
        return Ok("This picture and its caption come with the full build.".to_owned());
    };
    let captions: Value =
        serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))?;
    let caption = captions[name].as_str().ok_or_else(|| {
        format!(
            "{} has no figure `{name}`: its chapter draws no such picture, or the pictures are older than the page and `book/build` draws them again",
            path.display()
        )
    })?;
    Ok(caption.to_owned())
}
