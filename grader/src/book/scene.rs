//! `{{scene ch12_phong | alternative text}}`: the scene that grows, as the course's functions up to this chapter draw it.

use super::kept;
use crate::capstone::{Functions, PARTS, draw};
use maud::html;
use raybook::image::{Image, file, mip::MipMap};
use raybook_workbook::curriculum::{self, Chapter};
use std::path::Path;

/// Width and height, in pixels.
const SIZE: [u32; 2] = [480, 270];

/// The scene of the chapter `name`, as a figure; its picture is written into the folder `scene` of `pictures`, and kept like a gallery.
///
/// # Errors
/// If there is no such chapter or no alternative text, or the picture cannot be written.
pub(super) fn expand(name: &str, alt: &str, pictures: &Path) -> Result<String, String> {
    if alt.is_empty() {
        return Err(format!(
            "say what the scene shows for those who cannot see it: {{{{scene {name} | …}}}}"
        ));
    }
    let chapter = curriculum::find(name).ok_or_else(|| format!("there is no chapter `{name}`"))?;
    let text = pictures.join(format!("scene/{}.md", chapter.name));
    kept::or_make(&text, || drawn(chapter, alt, pictures))
}

/// The figure, drawn.
fn drawn(chapter: &Chapter, alt: &str, pictures: &Path) -> Result<String, String> {
    let path = format!("scene/{}.png", chapter.name);
    let mut picture = Image::from_fn(0, 0, |_, _| unreachable!("an empty picture has no pixel"));
    let mut functions = Functions::of_course(chapter.number());
    // Twice as large, and each pixel is the mean of four: edges are smooth.
    let drawn = draw(&mut functions, SIZE.map(|n| 2 * n), &mut |large, _| {
        picture = large.clone();
        Ok(())
    });
    drawn.map_err(|error| error.to_string())?;
    let map = MipMap::new(&picture);
    file::save(&pictures.join(&path), &map.levels()[1]).map_err(|error| error.to_string())?;
    let is_new = |exercise| {
        chapter
            .exercises()
            .iter()
            .any(|asked| asked.name == exercise)
    };
    let new: Vec<_> = PARTS.iter().filter(|part| is_new(part.exercise)).collect();
    let new: Vec<_> = new.iter().map(|part| part.adds).collect();
    let figure = html! {
        figure id="figure-scene" {
            img src={ "pictures/" (path) } alt=(alt) width=(SIZE[0]) height=(SIZE[1]) loading="lazy";
            figcaption {
                "The scene that grows, with the functions of chapters 1 to " (chapter.number()) ". New here: " (new.join(", ")) "."
            }
        }
    };
    Ok(figure.into_string())
}
