//! `{{figure roots | alternative text}}`: a figure, with the caption that the run which drew it gave it.

use super::text;
use maud::{PreEscaped, html};
use raybook::store;
use raybook_chapters::kit::captions;
use raybook_chapters::lesson;
use std::path::Path;

/// The size of letters that can be read, in pixels of the page.
const READABLE: f64 = 11.0;

/// The name of a lesson's main picture, which has no letters.
const PICTURE: &str = "picture";

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
    let caption = text::linked_html(page, &html! { (caption) }.into_string());
    let file = |form| pictures.join(chapter).join(format!("{name}.{form}"));
    let drawing = store::read_text(&file("svg")).ok();
    let drawing = drawing.as_deref().and_then(narrowest);
    let sheet = store::read(&file("png")).ok().filter(|_| name != PICTURE);
    let sheet = sheet.as_deref().and_then(narrowest_sheet);
    let form = if drawing.is_some() { "svg" } else { "png" };
    let file = format!("pictures/{chapter}/{name}.{form}");
    let is_unscaled = lesson::find(chapter).is_some_and(|one| one.unscaled().contains(&name));
    let class = match (drawing, sheet) {
        (Some(_), _) => Some("drawing"),
        (_, Some(_)) if is_unscaled => Some("sheet unscaled"),
        (_, Some(_)) => Some("sheet"),
        (None, None) => None,
    };
    let style = drawing
        .or(sheet)
        .map(|pixels| format!("--narrowest: {pixels}px"));
    let figure = html! {
        figure id={ "figure-" (name) } class=[class] style=[style] {
            a href=(file) { img src=(file) alt=(alt) loading="lazy"; }
            figcaption { (PreEscaped(caption)) }
        }
    };
    Ok(figure.into_string())
}

/// The least width at which a drawing is shown, in pixels of the page, so that its smallest words can be read: on a narrower page, it is scrolled.
fn narrowest(svg: &str) -> Option<u32> {
    let [_, _, width, _] = *numbers(svg, "viewBox=\"")?.as_slice() else {
        return None;
    };
    let letters = svg.split("font-size=\"").skip(1);
    let letters = letters.filter_map(|rest| rest.split('"').next()?.parse::<f64>().ok());
    let smallest = letters.fold(f64::INFINITY, f64::min);
    Some((READABLE * width / smallest).ceil() as u32)
}

/// The least width at which pictures side by side are shown: their letters are a 54th of it ([`sheet`](raybook_chapters::kit::sheet::sheet)).
/// No picture is made larger than it is.
fn narrowest_sheet(png: &[u8]) -> Option<u32> {
    let width = png.get(16..20)?.try_into().ok()?;
    Some(u32::from_be_bytes(width).min(54 * READABLE as u32))
}

/// The numbers of an attribute.
fn numbers(svg: &str, attribute: &str) -> Option<Vec<f64>> {
    let (_, rest) = svg.split_once(attribute)?;
    let words = rest.split('"').next()?.split_whitespace();
    words.map(|word| word.parse().ok()).collect()
}

/// The caption of a figure; while no pictures are drawn, a word in its place.
fn caption(folder: &Path, name: &str) -> Result<String, String> {
    let path = captions::file_in(folder);
    let Ok(text) = store::read_text(&path) else {
        return Ok("This picture and its caption come with the full build.".to_owned());
    };
    let caption = captions::find(&text, name).ok_or_else(|| {
        format!(
            "{} has no figure `{name}`: its chapter draws no such picture, or the pictures are older than the page and `book/build` draws them again",
            path.display()
        )
    })?;
    Ok(caption.to_owned())
}
